// The staff's part of lab 18: see ../truth.h.
#include "truth.h"

#include <cmath>

#include "exact.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/mesh_rays.h"

namespace relief::moving_frames {
namespace {

/// Returns a symmetric bilinear form of two dual quaternions. polar_form(a, a, p) is the place p moved by a, times the
/// squared length of a.real, so a need not be unit.
glm::dvec3 polar_form(const DualQuaternion& a, const DualQuaternion& b, const glm::dvec3& p) {
    const glm::dvec3 v(a.real), w(b.real), d(a.dual), e(b.dual);
    const double s = a.real.w, t = b.real.w;
    const glm::dvec3 turned = p * (s * t - glm::dot(v, w)) + glm::dot(v, p) * w + glm::dot(w, p) * v +
                              s * glm::cross(w, p) + t * glm::cross(v, p);
    const glm::dvec3 moved = s * e + t * d - a.dual.w * w - b.dual.w * v + glm::cross(v, e) + glm::cross(w, d);
    return turned + moved;
}

/// Returns v normalized, or some unit vector if v is 0.
glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0, 0, 1);
}

class ExactScene {
public:
    explicit ExactScene(const Scene& scene) : scene_(scene), body_(scene.body), bones_(bones_of(body_, scene.pose)) {}

    glm::dvec4 value(const Instance& instance, glm::dvec2 uv, const std::string& probe) const {
        const Rest rest = rest_at(body_, uv);
        const glm::dmat3 placed(instance.world_from_model);
        const glm::dmat3 texture = scene_.materials[size_t(instance.material)] * instance.texture;
        if (probe == "material") return glm::dvec4(instance.material, 0, 0, 0);
        if (probe == "uv") return glm::dvec4(glm::dvec2(texture * glm::dvec3(uv, 1)), 0, 0);
        if (probe == "place")
            return instance.world_from_model * glm::dvec4(posed(body_, scene_.pose, bones_, uv), 1) *
                   glm::dvec4(1, 1, 1, 0);
        const glm::dmat3 skin = exact_jacobian(body_, scene_.pose, bones_, uv), whole = placed * skin;
        if (probe == "fold") return glm::dvec4(glm::determinant(skin), 0, 0, 0);
        if (probe == "carried") return glm::dvec4(whole[0], 0);
        const double side = glm::determinant(whole) < 0 ? -1 : 1;
        if (probe == "normal") return glm::dvec4(side * unit(cofactors(whole) * rest.normal), 0);
        // The tangent is the combination of the surface's u and v that the texture's linear part maps to (1, 0). Along
        // it the texture's u grows, and its v is constant.
        const glm::dmat2 linear(texture);
        const double turned = glm::determinant(linear) < 0 ? -1 : 1;
        const glm::dvec3 tangent = turned * (linear[1][1] * rest.along_u - linear[0][1] * rest.along_v);
        return glm::dvec4(unit(whole * unit(tangent)), side * turned);
    }

    /// Returns the triangles in the pose. A mirrored body takes the vertices of its other side, so its quads have the
    /// other diagonal.
    Mesh triangles(Fineness fineness, bool mirrored) const {
        Mesh mesh = make_skin(body_, fineness.rings, fineness.sides);
        for (Vertex& vertex : mesh.vertices) {
            if (mirrored) vertex.uv.x = 1 - vertex.uv.x;
            const double u = vertex.uv.x == 1 ? 0 : double(vertex.uv.x);
            vertex.position = posed(body_, scene_.pose, bones_, {u, vertex.uv.y});
        }
        return mesh;
    }

private:
    const Scene& scene_;
    const Body& body_;
    std::vector<Bone> bones_;
};

/// A mesh and its instances.
struct Drawn {
    Mesh mesh;
    TriangleTree tree;
    std::vector<std::pair<const Instance*, glm::dmat4>> instances;  ///< with model_from_world
};

std::optional<Image> exact_values(const Frame& frame, const Scene& scene) {
    const ExactScene exact(scene);
    if (scene.unrolled)
        return image_of_values(frame.size, [&](int x, int y) {
            const glm::dvec2 uv((x + 0.5) / frame.size.x, 1 - (y + 0.5) / frame.size.y);
            return exact.value(scene.instances[0], uv, frame.probe.name);
        });
    std::array<Drawn, 4> drawn;  // fine, fine mirrored, coarse, coarse mirrored
    for (size_t i = 0; i < scene.instances.size(); ++i) {
        const glm::dmat4& m = scene.instances[i].world_from_model;
        const double size = glm::determinant(glm::dmat3(m));
        if (std::abs(size) < 1e-12) return {};  // degenerate: no rays in model space
        Drawn& kind = drawn[size_t(2 * (i > 0) + (size < 0))];
        if (kind.instances.empty()) {
            kind.mesh = exact.triangles(i == 0 ? scene.fine : scene.coarse, size < 0);
            kind.tree = build_tree(kind.mesh);
        }
        kind.instances.emplace_back(&scene.instances[i], glm::inverse(m));
    }
    return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        double nearest = INFINITY;
        glm::dvec2 uv(0);
        const Instance* seen = nullptr;
        for (const Drawn& kind : drawn)
            for (const auto& [instance, model_from_world] : kind.instances) {
                const Ray inside{glm::dvec3(model_from_world * glm::dvec4(ray.origin, 1)),
                                 glm::dvec3(model_from_world * glm::dvec4(ray.direction, 0))};
                const auto hit = first_hit(kind.tree, kind.mesh, inside, std::min(nearest, 1e9));
                if (!hit || hit->t >= nearest) continue;
                nearest = hit->t, seen = instance, uv = {0, 0};
                for (size_t corner = 0; corner < 3; ++corner)
                    uv += hit->weights[int(corner)] *
                          glm::dvec2(kind.mesh.vertices[kind.mesh.indices[hit->triangle * 3 + corner]].uv);
            }
        if (!seen) return {};
        return exact.value(*seen, uv, frame.probe.name);
    });
}

const decltype(truth)::Provided provided(truth, exact_values);

}  // namespace

glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

glm::dmat3 exact_jacobian(const Body& body, const Pose& pose, const std::vector<Bone>& bones, glm::dvec2 uv) {
    const glm::dvec3 rest = rest_at(body, uv).position;
    const Influence influence = influence_at(body, rest.x, pose.over * body.radius, pose.uneven);
    glm::dmat3 jacobian(0);
    if (!pose.dual) {
        const glm::dvec3 middle = posed(body, pose, bones, uv);
        double sum = 0;
        for (int i = 0; i < 4; ++i) {
            const glm::dmat4& bone = bones[size_t(influence.first + i)].matrix;
            jacobian += influence.weights[i] * glm::dmat3(bone);
            jacobian[0] += influence.slopes[i] * (glm::dvec3(bone * glm::dvec4(rest, 1)) - middle);
            sum += influence.weights[i];
        }
        return jacobian / sum;
    }
    DualQuaternion blend, change;
    for (int i = 0; i < 4; ++i) {
        const DualQuaternion& motion = bones[size_t(influence.first + i)].motion;
        blend.real += influence.weights[i] * motion.real, blend.dual += influence.weights[i] * motion.dual;
        change.real += influence.slopes[i] * motion.real, change.dual += influence.slopes[i] * motion.dual;
    }
    const double square = glm::dot(blend.real, blend.real);
    const glm::dvec3 at_origin = polar_form(blend, blend, glm::dvec3(0)), moved = polar_form(blend, blend, rest);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 along(0);
        along[axis] = 1;
        jacobian[axis] = (polar_form(blend, blend, along) - at_origin) / square;
    }
    // The quotient rule. Numerator and denominator are quadratic forms of the blend.
    jacobian[0] +=
        2.0 * (polar_form(blend, change, rest) - moved / square * glm::dot(blend.real, change.real)) / square;
    return jacobian;
}

}  // namespace relief::moving_frames
