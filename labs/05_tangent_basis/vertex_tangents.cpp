#include "vertex_tangents.h"

#include <algorithm>
#include <cmath>

#include "framework/library/mesh/frame.h"
#include "framework/library/mesh/tangents.h"

namespace relief::basis {
namespace {

Triangle triangle_of(const Mesh& mesh, size_t first) {
    Triangle triangle;
    for (size_t i = 0; i < 3; ++i) {
        const Vertex& vertex = mesh.vertices[mesh.indices[first + i]];
        triangle.position[i] = vertex.position, triangle.uv[i] = vertex.uv;
    }
    return triangle;
}

const glm::dvec3& of_face(const FaceBasis& face, Axis axis) {
    return axis == Axis::tangent ? face.tangent : face.bitangent;
}

}  // namespace

Mesh with_faces(const Mesh& mesh, Axis axis) {
    Mesh result;
    for (size_t first = 0; first < mesh.indices.size(); first += 3) {
        const Triangle triangle = triangle_of(mesh, first);
        const FaceBasis face = solve(triangle);
        const glm::dvec3 up =
            glm::cross(triangle.position[1] - triangle.position[0], triangle.position[2] - triangle.position[0]);
        for (size_t i = 0; i < 3; ++i) {
            Vertex vertex = mesh.vertices[mesh.indices[first + i]];
            if (glm::length(up) > 0) vertex.normal = glm::normalize(up);
            // Both axes lie in the triangle, so they are perpendicular to the normal already.
            vertex.tangent = face.handedness == 0 ? glm::dvec4(any_perpendicular(vertex.normal), 1)
                                                  : glm::dvec4(of_face(face, axis), face.handedness);
            result.indices.push_back(uint32_t(result.vertices.size()));
            result.vertices.push_back(vertex);
        }
    }
    return result;
}

Mesh with_means(const Mesh& mesh, Weight weight, Axis axis) {
    struct Sums {
        glm::dvec3 sum[2] = {};
        int triangles[2] = {};
    };
    std::vector<Sums> sums(mesh.vertices.size());
    std::vector<int> sides(mesh.indices.size() / 3);
    //(sums
    for (size_t first = 0; first < mesh.indices.size(); first += 3) {
        const Triangle triangle = triangle_of(mesh, first);
        const FaceBasis face = solve(triangle);
        const int side = sides[first / 3] = face.handedness < 0;
        for (int i = 0; i < 3; ++i) {
            Sums& vertex = sums[mesh.indices[first + size_t(i)]];
            vertex.sum[side] += corner_weight(weight, triangle, i) * of_face(face, axis);
            ++vertex.triangles[side];
        }
    }
    //)
    Mesh result = mesh;
    std::vector<uint32_t> mirrored(mesh.vertices.size());  // the vertex for the mirrored triangles
    for (uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        mirrored[i] = i;
        for (const int side : {0, 1}) {
            if (sums[i].triangles[side] == 0) continue;
            Vertex vertex = mesh.vertices[i];
            vertex.tangent = vertex_tangent(sums[i].sum[side], vertex.normal, side == 1 ? -1 : 1);
            if (side == 1 && sums[i].triangles[0] > 0) {
                mirrored[i] = uint32_t(result.vertices.size());
                result.vertices.push_back(vertex);
            } else {
                result.vertices[i] = vertex;
            }
        }
    }
    for (size_t i = 0; i < result.indices.size(); ++i)
        if (sides[i / 3] == 1) result.indices[i] = mirrored[result.indices[i]];
    return result;
}

Mesh with_tangents(const Mesh& mesh, Method method, Axis axis) {
    switch (method) {
        case per_face:
            return with_faces(mesh);
        case solved_bitangent:
            return with_faces(mesh, Axis::bitangent);
        case uniform:
            return with_means(mesh, Weight::uniform);
        case area:
            return with_means(mesh, Weight::area);
        case angle:
            return with_means(mesh, Weight::angle, axis);
        case mikktspace:
            return relief::with_tangents(mesh, TangentMethod::mikktspace);
        default:
            return mesh;
    }
}

TangentDifference difference_of(const Mesh& given, const Mesh& made) {
    TangentDifference result;
    double degrees = 0;
    for (size_t i = 0; i < given.indices.size(); ++i) {
        const glm::vec4 a = given.vertices[given.indices[i]].tangent, b = made.vertices[made.indices[i]].tangent;
        degrees += glm::degrees(std::acos(std::clamp(glm::dot(glm::dvec3(a), glm::dvec3(b)), -1.0, 1.0)));
        result.mirrored += a.w * b.w < 0;
    }
    result.mean_degrees = degrees / double(given.indices.size());
    return result;
}

}  // namespace relief::basis
