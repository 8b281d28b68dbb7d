#include "skin.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

namespace relief::moving_frames {
namespace {

/// Returns the square of the radius as a share of its maximum, and the derivative by v. The radius itself would have an
/// infinite slope at the tips.
glm::dvec2 squared_profile(double v) {
    const double w = 1 - v, tail = 1 - w * w * w, cap = 1 - std::pow(v, 24);
    const auto bump = [&](double height, double middle, double width) {
        const double off = (v - middle) / width, value = height * std::exp(-off * off);
        return glm::dvec2(value, -2 * off / width * value);
    };
    const glm::dvec2 body = glm::dvec2(0.5, 0) + bump(0.5, 0.45, 0.24) + bump(0.55, 0.945, 0.035);
    const double ends = tail * tail * cap, ends_slope = 6 * tail * w * w * cap - tail * tail * 24 * std::pow(v, 23);
    return {ends * body.x, ends_slope * body.x + ends * body.y};
}

/// The turn of a joint, in radians: a bend about an axis that is perpendicular to the chain, and a twist about the
/// chain. `axis` is the angle of the bend's axis around the chain, from z.
struct Turn {
    double bend, axis, twist;
};
Turn turn_of(const Body& body, const Pose& pose, int joint) {
    const double bend = glm::radians(pose.bend), twist = glm::radians(pose.twist);
    if (!body.is_serpent) return {bend, 0, twist};
    // A wave along the body, from side to side, that rises towards the head.
    const double along = double(joint) / (body.joints - 1);
    return {bend * (0.42 * std::cos(2 * glm::pi<double>() * (1.25 * along + 0.1))), 0.9 * std::sin(5 * along),
            twist / 6};
}

}  // namespace

Rest rest_at(const Body& body, glm::dvec2 uv) {
    const double angle = 2 * glm::pi<double>() * (uv.x - 0.25);
    const glm::dvec3 out(0, std::sin(angle), -std::cos(angle)), around(0, std::cos(angle), std::sin(angle));
    const glm::dvec2 squared = body.is_serpent ? squared_profile(uv.y) : glm::dvec2(1, 0);
    const double radius = body.radius * std::sqrt(std::max(squared.x, 0.0));
    const double slope = body.radius * body.radius * squared.y / (2 * body.length);  // the radius times its slope
    Rest rest;
    rest.position = glm::dvec3(body.length * (uv.y - 0.5), 0, 0) + radius * out;
    rest.normal = glm::normalize(radius * out - glm::dvec3(slope, 0, 0));
    rest.along_u = 2 * glm::pi<double>() * radius * around;
    rest.along_v = body.length * (glm::dvec3(1, 0, 0) + slope / std::max(radius, 1e-9) * out);
    return rest;
}

Influence influence_at(const Body& body, double x, double over, bool uneven) {
    const double spacing = body.spacing();
    over = std::clamp(over, 0.001 * body.radius, 3 * spacing);
    Influence result;
    const int bones = std::max(body.joints + 1, 4);
    result.first = std::clamp(int(std::floor((x - over / 2 - body.joint(0)) / spacing)) + 1, 0, bones - 4);
    double before = 1, slope_before = 0;
    for (int i = 0; i < 4; ++i) {
        double step = 0, slope = 0;
        const int joint = result.first + i;
        if (i < 3 && joint < body.joints) {
            const double t = std::clamp((x - body.joint(joint)) / over + 0.5, 0.0, 1.0);
            step = t * t * (3 - 2 * t), slope = 6 * t * (1 - t) / over;
        }
        result.weights[i] = before - step, result.slopes[i] = slope_before - slope;
        before = step, slope_before = slope;
    }
    if (!uneven) return result;
    const double wave = 4 * x / body.radius, sum = 0.8 + 0.15 * std::sin(wave),
                 change = 0.15 * 4 / body.radius * std::cos(wave);
    result.slopes = sum * result.slopes + change * result.weights;
    result.weights *= sum;
    return result;
}

std::vector<Bone> bones_of(const Body& body, const Pose& pose) {
    std::vector<Bone> bones;
    glm::dmat4 chain(1);
    glm::dvec4 real_before(0);
    const int stretched = (body.joints + 1) / 2;
    for (int i = 0; i <= body.joints; ++i) {
        const glm::dvec3 joint(i > 0 ? body.joint(i - 1) : -body.length / 2, 0, 0);
        if (i > 0) {
            const Turn turn = turn_of(body, pose, i - 1);
            chain = glm::translate(chain, joint);
            chain = glm::rotate(chain, turn.bend, glm::dvec3(0, std::sin(turn.axis), std::cos(turn.axis)));
            chain = glm::rotate(chain, turn.twist, glm::dvec3(1, 0, 0));
            chain = glm::translate(chain, -joint);
        }
        const double along = i == stretched ? pose.stretch : 1;
        Bone bone;
        bone.matrix = glm::translate(chain, joint);
        bone.matrix = glm::translate(glm::scale(bone.matrix, glm::dvec3(along, 1, 1)), -joint);
        bone.normals = glm::dmat3(chain) * glm::dmat3(1, 0, 0, 0, along, 0, 0, 0, along);
        bone.motion = dual_quaternion_of(chain);
        if (glm::dot(bone.motion.real, real_before) < 0)
            bone.motion.real = -bone.motion.real, bone.motion.dual = -bone.motion.dual;
        real_before = bone.motion.real;
        bones.push_back(bone);
        chain = glm::translate(chain, glm::dvec3((along - 1) * body.spacing(), 0, 0));
    }
    while (bones.size() < 4) bones.push_back(bones.back());
    return bones;
}

glm::dvec3 posed(const Body& body, const Pose& pose, const std::vector<Bone>& bones, glm::dvec2 uv) {
    const glm::dvec3 rest = rest_at(body, uv).position;
    const Influence influence = influence_at(body, rest.x, pose.over * body.radius, pose.uneven);
    glm::dvec3 sum(0);
    DualQuaternion motion;
    double weights = 0;
    for (int i = 0; i < 4; ++i) {
        const Bone& bone = bones[size_t(influence.first + i)];
        const double weight = influence.weights[i];
        sum += weight * glm::dvec3(bone.matrix * glm::dvec4(rest, 1)), weights += weight;
        motion.real += weight * bone.motion.real, motion.dual += weight * bone.motion.dual;
    }
    return pose.dual ? moved_by(motion, rest) : sum / weights;
}

Ball ball_of(const Body& body, const Pose& pose) {
    constexpr int rings = 48, sides = 8;
    const std::vector<Bone> bones = bones_of(body, pose);
    std::vector<glm::dvec3> places;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sides; ++j)
            places.push_back(posed(body, pose, bones, {double(j) / sides, double(i) / rings}));
    const glm::dvec3 centre = std::accumulate(places.begin(), places.end(), glm::dvec3(0)) / double(places.size());
    double radius = 0;
    for (const glm::dvec3& place : places) radius = std::max(radius, glm::distance(centre, place));
    // The margin bounds the skin between the sampled places.
    return {centre, radius + body.length / rings * std::max(1.0, pose.stretch) + 0.1 * body.radius};
}

Mesh make_skin(const Body& body, int rings, int sides) {
    Mesh mesh;
    for (int ring = 0; ring <= rings; ++ring)
        for (int side = 0; side <= sides; ++side) {
            const glm::dvec2 uv(double(side) / sides, double(ring) / rings);
            const Rest rest = rest_at(body, {side == sides ? 0 : uv.x, uv.y});
            const glm::dvec3 around =
                glm::length(rest.along_u) > 0 ? glm::normalize(rest.along_u) : glm::dvec3(0, 0, 1);
            mesh.vertices.push_back({rest.position, rest.normal, glm::vec4(around, 1), uv});
        }
    const auto index = [&](int ring, int side) { return uint32_t(ring * (sides + 1) + side); };
    for (int ring = 0; ring < rings; ++ring)
        for (int side = 0; side < sides; ++side)
            for (const auto& [r, s] : {std::pair(0, 0), {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}})
                mesh.indices.push_back(index(ring + r, side + s));
    return mesh;
}

std::vector<Bound> bind_skin(const Body& body, const Mesh& mesh, double over, bool uneven) {
    std::vector<Bound> bound;
    bound.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) {
        // From uv, not from the rounded position, as in the fragment stage.
        const double x = body.length * (double(vertex.uv.y) - 0.5);
        const Influence influence = influence_at(body, x, over, uneven);
        Bound& last = bound.emplace_back();
        for (size_t i = 0; i < 4; ++i) last.bones[i] = uint8_t(influence.first + int(i));
        last.weights = influence.weights;
    }
    return bound;
}

std::vector<Instance> make_flock(int count) {
    std::vector<Instance> flock;
    const auto random = [](int i, int which) {  // in [0, 1), by a hash of integers
        uint32_t x = uint32_t(8 * i + which + 1) * 0x9e3779b9u;
        x = (x ^ (x >> 16)) * 0x7feb352du;
        x = (x ^ (x >> 15)) * 0x846ca68bu;
        return double(x ^ (x >> 16)) / 4294967296.0;
    };
    // Behind the first one, as seen from the initial camera.
    const glm::dmat4 behind = glm::rotate(glm::dmat4(1), glm::radians(-35.0), glm::dvec3(0, 1, 0));
    for (int i = 0; i < count; ++i) {
        // Low-discrepancy sequences spread the bodies evenly over the picture, and independently over the depth.
        const double depth = 8 + 30 * std::fmod((i + 0.5) * 0.6180339887, 1.0), size = 0.6 + 0.45 * random(i, 1);
        const double aside = std::fmod((i + 0.5) * 0.7548776662, 1.0) - 0.5 + 0.12 * (random(i, 2) - 0.5),
                     above = std::fmod((i + 0.5) * 0.5698402910, 1.0) - 0.44 + 0.12 * (random(i, 3) - 0.5);
        Instance one;
        glm::dmat4& m = one.world_from_model;
        m = glm::translate(behind,
                           glm::dvec3(aside * (7 + 1.25 * depth), above * (5 + 0.7 * depth) - 0.1 * depth, -depth));
        m = glm::rotate(m, glm::radians(10 + 60 * random(i, 4)), glm::dvec3(0, 1, 0));
        m = glm::rotate(m, glm::radians(-18 + 36 * random(i, 5)), glm::dvec3(0, 0, 1));
        m = glm::rotate(m, glm::radians(-60 + 120 * random(i, 6)), glm::dvec3(1, 0, 0));
        m = glm::scale(m, size * glm::dvec3(1, 0.85 + 0.3 * random(i, 1), i % 4 == 3 ? -1 : 1));
        one.texture =
            texture_transform(i % 3 == 0 ? 0 : 90.0 * random(i, 4), {1, 1 + i % 2}, {random(i, 0), random(i, 1)});
        one.material = i % material_count;
        flock.push_back(one);
    }
    return flock;
}

glm::dmat3 texture_transform(double turn, glm::dvec2 scale, glm::dvec2 shift) {
    const double c = std::cos(glm::radians(turn)), s = std::sin(glm::radians(turn));
    return {c * scale.x, s * scale.x, 0, -s * scale.y, c * scale.y, 0, shift.x, shift.y, 1};
}

}  // namespace relief::moving_frames
