#include "framework/library/mesh/gltf_primitive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/library/mesh/frame.h"
#include "framework/library/mesh/gltf_elements.h"
#include "framework/library/mesh/tangents.h"

namespace relief {
namespace {

enum Mode { triangles = 4, strip = 5, fan = 6 };

/// Applies KHR_texture_transform: scale, then rotation, then translation. It turns counter-clockwise as a picture shows
/// uv, whose v grows downwards: as the extension's text says, and all programs do. The GLSL in that text turns the
/// other way (KhronosGroup/glTF, issue 1563).
glm::dvec2 transformed(const glm::dvec2& uv, const GltfObject& transform) {
    const std::vector<double> offset = transform.numbers("offset", 2), scale = transform.numbers("scale", 2);
    const double turn = transform.number("rotation", 0), c = std::cos(turn), s = std::sin(turn);
    const glm::dvec2 scaled = scale.empty() ? uv : uv * glm::dvec2(scale[0], scale[1]);
    const glm::dvec2 turned(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
    return offset.empty() ? turned : turned + glm::dvec2(offset[0], offset[1]);
}

glm::dvec3 normal_of_face(const Mesh& mesh, size_t first_index) {
    const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[first_index + i]].position); };
    const glm::dvec3 area = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    const double length = glm::length(area);
    return length > 0 ? area / length : glm::dvec3(0, 0, 1);
}

class PrimitiveReader {
public:
    PrimitiveReader(GltfDocument& file, const GltfObject& primitive, std::string name,
                    const std::vector<double>& weights, size_t most_corners)
        : file_(file),
          primitive_(primitive),
          attributes_(primitive.object("attributes")),
          name_(std::move(name)),
          weights_(weights),
          targets_(primitive.objects("targets")),
          most_corners_(most_corners) {}

    GltfPrimitive read() {
        const size_t mode = primitive_.whole("mode", triangles);
        if (mode > fan) refuse(fmt::format("glTF has no mode {}", mode));
        if (mode < triangles) {
            file_.notes.add(name_, "points and lines are not read");
            return {};
        }
        if (!attributes_.has("POSITION")) refuse("it has no positions");
        refuse_compressed();
        const std::vector<glm::dvec4> positions = values("POSITION", "VEC3");
        count_ = positions.size();
        const std::vector<uint32_t> corners = corners_of(mode);
        const std::vector<glm::dvec4> normals = values("NORMAL", "VEC3");
        // Without normals, glTF ignores tangents.
        const std::vector<glm::dvec4> tangents =
            normals.empty() ? std::vector<glm::dvec4>() : values("TANGENT", "VEC4", "VEC3");
        read_influences();
        const std::vector<glm::dvec2> uvs = read_uvs();
        result_.has_uvs = !uvs.empty();
        result_.mesh.indices = corners;
        result_.mesh.vertices.resize(count_);
        for (size_t i = 0; i < count_; ++i) {
            const glm::dvec3 normal = normals.empty() ? glm::dvec3(0) : glm::dvec3(normals[i]);
            const glm::dvec4 tangent = tangents.empty() ? glm::dvec4(0) : tangents[i];
            const glm::dvec2 uv = uvs.empty() ? glm::dvec2(0) : uvs[i];
            // Sums, so that each number is tested.
            const double length = glm::length(normal), along = glm::length(glm::dvec3(tangent)),
                         all = glm::dot(positions[i], glm::dvec4(1)) + length + along + tangent.w + uv.x + uv.y;
            if (!std::isfinite(float(all)) || !std::isfinite(all))
                refuse(fmt::format("vertex {} has a number that is not finite", i));
            result_.mesh.vertices[i] = {
                .position = positions[i],
                .normal = length > 0 ? normal / length : glm::dvec3(0),
                .tangent = glm::dvec4(along > 0 ? glm::dvec3(tangent) / along : glm::dvec3(0), tangent.w > 0   ? 1
                                                                                               : tangent.w < 0 ? -1
                                                                                                               : 0),
                .uv = uv};
        }
        if (normals.empty())
            separate_faces();
        else
            complete_normals();
        complete_tangents(!tangents.empty());
        return std::move(result_);
    }

private:
    [[noreturn]] void refuse(const std::string& why) const { throw Error(fmt::format("{}: {}", name_, why)); }

    /// Accessors of a compressed primitive may have no bytes, which are no zeros.
    void refuse_compressed() const {
        constexpr const char* draco = "KHR_draco_mesh_compression";
        if (!primitive_.has_extension(draco)) return;
        for (const std::string& attribute : attributes_.keys())
            if (!file_.element("accessors", attributes_.index(attribute.c_str()), "accessor").has("bufferView"))
                refuse(fmt::format("needs {}, which is not read: export without it", draco));
    }

    std::vector<uint32_t> corners_of(size_t mode) {
        std::optional<GltfElements> indices;
        if (primitive_.has("indices")) {
            indices.emplace(file_, primitive_.index("indices"), "SCALAR", name_ + ", indices");
            if (!indices->is_index()) refuse("its indices are no whole numbers from 0 on");
        }
        const size_t count = indices ? indices->count() : count_;
        const size_t faces = mode == triangles ? count / 3 : count < 3 ? 0 : count - 2;
        if (mode == triangles && count % 3 != 0) refuse(fmt::format("{} corners make no whole triangles", count));
        if (faces > most_corners_ / 3 || count_ > most_corners_)
            throw Error(fmt::format("too large: more than {} corners or vertices", file_.most_elements()));
        const auto vertex = [&](size_t i) {
            const double index = indices ? indices->at(i) : double(i);
            if (index >= double(count_))
                refuse(fmt::format("there is no vertex {:.0f}, but {} of them", index, count_));
            return uint32_t(index);
        };
        std::vector<uint32_t> corners;
        corners.reserve(3 * faces);
        for (size_t i = 0; i < faces; ++i) {
            const size_t odd = i % 2;
            const std::array<size_t, 3> face = mode == triangles ? std::array{3 * i, 3 * i + 1, 3 * i + 2}
                                               : mode == strip   ? std::array{i, i + 1 + odd, i + 2 - odd}
                                                                 : std::array{i + 1, i + 2, size_t{0}};
            const std::array<uint32_t, 3> at = {vertex(face[0]), vertex(face[1]), vertex(face[2])};
            // Strips are joined by triangles whose corners coincide.
            if (mode == strip && (at[0] == at[1] || at[1] == at[2] || at[2] == at[0])) continue;
            corners.insert(corners.end(), at.begin(), at.end());
        }
        return corners;
    }

    /// Returns an attribute with the sum of its morph targets, or nothing where it is missing.
    std::vector<glm::dvec4> values(const std::string& attribute, const char* type, const char* of_targets = nullptr) {
        if (!attributes_.has(attribute.c_str())) return {};
        const auto components = [](const char* of_type) { return size_t(of_type[3] - '0'); };
        const auto elements = [&](const GltfObject& of, const char* of_type, const std::string& place) {
            GltfElements read(file_, of.index(attribute.c_str()), of_type, fmt::format("{}, {}", place, attribute));
            if (attribute != "POSITION" && read.count() != count_)
                refuse(fmt::format("{} positions, but {} of {}", count_, read.count(), attribute));
            return read;
        };
        const GltfElements base = elements(attributes_, type, name_);
        std::vector<glm::dvec4> sums(base.count(), glm::dvec4(0));
        for (size_t i = 0; i < sums.size(); ++i)
            for (size_t c = 0; c < components(type); ++c) sums[i][int(c)] = base.at(i, c);
        const char* const target_type = of_targets ? of_targets : type;
        for (size_t k = 0; k < std::min(targets_.size(), weights_.size()); ++k) {
            if (weights_[k] == 0 || !targets_[k].has(attribute.c_str())) continue;
            const GltfElements moves = elements(targets_[k], target_type, fmt::format("{}, target {}", name_, k));
            if (moves.count() != sums.size())
                refuse(fmt::format("{} of {}, but {} in target {}", sums.size(), attribute, moves.count(), k));
            for (size_t i = 0; i < sums.size(); ++i)
                for (size_t c = 0; c < components(target_type); ++c) sums[i][int(c)] += weights_[k] * moves.at(i, c);
        }
        return sums;
    }

    std::vector<glm::dvec2> read_uvs() {
        const GltfObject texture = texture_of_uv(file_, primitive_),
                         transform = texture.extension("KHR_texture_transform");
        const size_t set = transform.whole("texCoord", texture.whole("texCoord", 0));
        std::vector<glm::dvec2> uvs;
        for (const glm::dvec4& uv : values(fmt::format("TEXCOORD_{}", set), "VEC2")) {
            const glm::dvec2 moved = transformed(glm::dvec2(uv), transform);
            uvs.emplace_back(moved.x, 1 - moved.y);
        }
        return uvs;
    }

    void read_influences() {
        for (int set = 0;; ++set) {
            const std::string joints = fmt::format("JOINTS_{}", set), weights = fmt::format("WEIGHTS_{}", set);
            if (!attributes_.has(joints.c_str()) || !attributes_.has(weights.c_str())) return;
            const std::vector<glm::dvec4> joint = values(joints, "VEC4"), weight = values(weights, "VEC4");
            result_.influences.resize(count_);
            for (size_t i = 0; i < count_; ++i) {
                GltfInfluence one{{}, weight[i]};
                for (int k = 0; k < 4; ++k) {
                    if (!(joint[i][k] >= 0 && joint[i][k] <= 65535) || !std::isfinite(weight[i][k]))
                        refuse(fmt::format("vertex {} has a joint or a weight that is none", i));
                    one.joint[size_t(k)] = uint32_t(joint[i][k]);
                }
                result_.influences[i].push_back(one);
            }
        }
    }

    /// Gives a vertex whose normal has no length that of a triangle.
    void complete_normals() {
        Mesh& mesh = result_.mesh;
        for (size_t i = 0; i < mesh.indices.size(); ++i) {
            Vertex& vertex = mesh.vertices[mesh.indices[i]];
            if (vertex.normal != glm::vec3(0)) continue;
            vertex.normal = normal_of_face(mesh, i - i % 3);
            file_.notes.add(name_, "normals without length are made anew, from a triangle");
        }
        for (Vertex& vertex : mesh.vertices)
            if (vertex.normal == glm::vec3(0)) vertex.normal = {0, 0, 1};  // of no triangle
    }

    /// Gives each corner a vertex of its own, with the normal of its triangle.
    void separate_faces() {
        Mesh& mesh = result_.mesh;
        std::vector<Vertex> corners;
        std::vector<std::vector<GltfInfluence>> influences;
        for (size_t i = 0; i < mesh.indices.size(); ++i) {
            corners.push_back(mesh.vertices[mesh.indices[i]]);
            corners.back().normal = normal_of_face(mesh, i - i % 3);
            if (!result_.influences.empty()) influences.push_back(result_.influences[mesh.indices[i]]);
        }
        for (size_t i = 0; i < corners.size(); ++i) mesh.indices[i] = uint32_t(i);
        mesh.vertices = std::move(corners), result_.influences = std::move(influences);
    }

    /// Makes the tangents that the file does not have by MikkTSpace. A vertex may become several.
    void complete_tangents(bool are_in_file) {
        Mesh& mesh = result_.mesh;
        const auto is_usable = [](const Vertex& vertex) {
            return glm::vec3(vertex.tangent) != glm::vec3(0) && vertex.tangent.w != 0;
        };
        std::vector<bool> is_kept(mesh.vertices.size());
        size_t kept = 0, used = 0;
        for (const uint32_t index : mesh.indices) {
            if (!is_kept[index] && is_usable(mesh.vertices[index])) is_kept[index] = true;
            kept += is_kept[index], ++used;
        }
        result_.has_tangents = are_in_file && kept == used;
        if (result_.has_tangents) return;
        if (are_in_file) file_.notes.add(name_, "tangents of length 0, or with w = 0, are made anew, by MikkTSpace");
        if (!result_.has_uvs) {
            for (size_t i = 0; i < mesh.vertices.size(); ++i)
                if (!is_kept[i])
                    mesh.vertices[i].tangent =
                        glm::vec4(any_perpendicular(glm::normalize(glm::dvec3(mesh.vertices[i].normal))), 1);
            return;
        }
        Mesh made = with_tangents(mesh, TangentMethod::mikktspace);
        for (size_t i = 0; i < mesh.indices.size(); ++i) {
            const uint32_t vertex = mesh.indices[i];
            if (is_kept[vertex]) {
                made.indices[i] = vertex, made.vertices[vertex].tangent = mesh.vertices[vertex].tangent;
            } else if (!result_.influences.empty()) {
                result_.influences.resize(made.vertices.size());
                result_.influences[made.indices[i]] = result_.influences[vertex];
            }
        }
        if (!result_.influences.empty())
            for (size_t i = mesh.vertices.size(); i < result_.influences.size(); ++i)
                if (result_.influences[i].empty()) result_.influences[i] = result_.influences[0];  // of no triangle
        mesh = std::move(made);
    }

    GltfDocument& file_;
    const GltfObject& primitive_;
    const GltfObject attributes_;
    const std::string name_;
    const std::vector<double>& weights_;
    const std::vector<GltfObject> targets_;
    const size_t most_corners_;
    size_t count_ = 0;  ///< of positions
    GltfPrimitive result_;
};

}  // namespace

GltfObject texture_of_uv(const GltfDocument& file, const GltfObject& primitive) {
    static const nlohmann::json none = nlohmann::json::object();
    if (!primitive.has("material")) return {none, "no material"};
    const GltfObject material = file.element("materials", primitive.index("material"), "material"),
                     colors = material.object("pbrMetallicRoughness");
    for (const GltfObject& texture : {material.object("normalTexture"), colors.object("baseColorTexture"),
                                      colors.object("metallicRoughnessTexture"), material.object("occlusionTexture"),
                                      material.object("emissiveTexture")})
        if (texture.index("index") >= 0) return texture;
    return {none, "no texture"};
}

GltfPrimitive read_primitive(GltfDocument& file, const GltfObject& primitive, const std::string& name,
                             const std::vector<double>& weights, size_t most_corners) {
    return PrimitiveReader(file, primitive, name, weights, most_corners).read();
}

}  // namespace relief
