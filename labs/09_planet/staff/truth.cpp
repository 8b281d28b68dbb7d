// The staff's part of lab 09: see ../truth.h.
#include "truth.h"

#include <glm/gtc/constants.hpp>
#include <map>
#include <mutex>
#include <random>

#include "exact.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/tiles.h"

namespace relief::planet {

Dual exact_height(const Ground& ground, const glm::dvec3& r) {
    Place<Dual> place;
    for (size_t i = 0; i < 3; ++i) place[i].value = r[int(i)], place[i].gradient[int(i)] = 1;
    Dual h = height(ground, place);
    h.gradient -= r * glm::dot(r, h.gradient);
    return h;
}

glm::dvec3 exact_normal(const Ground& ground, const glm::dvec3& r) {
    const Dual h = exact_height(ground, r);
    return glm::normalize((1 + h.value) * r - h.gradient);
}

glm::dvec3 exact_direction(SphereMapping mapping, int face, const glm::dvec2& st) {
    const double quarter = glm::quarter_pi<double>();
    const glm::dmat3 axes = face_axes(mapping, face);
    if (mapping == SphereMapping::lat_long) {
        const double lon = 2 * quarter * st.x, lat = 2 * quarter * st.y;
        return axes * glm::dvec3(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon));
    }
    const glm::dvec2 on_cube = mapping == SphereMapping::gnomonic ? st : glm::tan(quarter * st);
    return glm::normalize(axes * glm::dvec3(on_cube, 1));
}

std::pair<glm::dvec3, glm::dvec3> exact_tangents(SphereMapping mapping, int face, const glm::dvec2& st) {
    const double e = 1e-5;
    const auto along = [&](glm::dvec2 step) {
        return (exact_direction(mapping, face, st + step) - exact_direction(mapping, face, st - step)) / (2 * e);
    };
    return {along({e, 0}), along({0, e})};
}

Rules exact_rules() {
    return {[](double error, double budget, double pixels, double angle) {
                return error / budget * pixels / 2 / std::tan(angle / 2);
            },
            [](std::span<const double> errors, int level) {
                return level == 0 ? 2 * errors[0] : errors[size_t(level)] + errors[size_t(level) - 1];
            },
            [](double eye, double angle, double lowest, double highest) {
                return eye > lowest && angle - std::acos(lowest / eye) > std::acos(lowest / highest);
            }};
}

namespace {

/// Returns an estimated upper bound of the ground's slope, rise over run: the largest of 4000 samples plus a margin.
double steepest(const Ground& ground) {
    static std::mutex lock;
    static std::map<std::tuple<int, int, float>, double> known;
    const std::lock_guard hold(lock);
    const auto [found, is_new] = known.try_emplace({ground.seed, ground.detail, ground.height}, 0.0);
    if (is_new) {
        std::mt19937 random(3);
        for (int i = 0; i < 4000; ++i) {
            const auto coordinate = [&] { return double(random()) / double(std::mt19937::max()) * 2 - 1; };
            const glm::dvec3 at{coordinate(), coordinate(), coordinate()};
            if (glm::length(at) > 0.01)
                found->second = std::max(found->second, glm::length(exact_height(ground, glm::normalize(at)).gradient));
        }
        found->second = 0.2 + 1.3 * found->second;
    }
    return found->second;
}

}  // namespace

std::optional<double> exact_hit(const Shape& shape, const Ray& ray) {
    const auto gap = [&](double t) {
        const glm::dvec3 at = ray.at(t);
        const double radius = glm::length(at);
        return radius > 0 ? radius - 1 - height(shape.ground, at / radius) : -1.0;
    };
    const double top = 1 + patches_of(shape).highest(), b = glm::dot(ray.origin, ray.direction);
    const double root = b * b - (glm::dot(ray.origin, ray.origin) - top * top);
    if (root <= 0) return {};
    const double end = -b + std::sqrt(root);
    double t = std::max(0.0, -b - std::sqrt(root));
    if (end <= t) return {};
    double before = t, here = gap(t);
    if (here <= 0) return t == 0 ? std::nullopt : std::optional(t);
    const double slower = std::sqrt(1 + std::pow(steepest(shape.ground), 2));
    while (here > 0) {
        before = t;
        t += std::max(here / slower, 1e-7 * (1e-3 + t));
        if (t > end) return {};
        here = gap(t);
    }
    for (int i = 0; i < 50 && t - before > 1e-15 * t; ++i) {
        const double middle = (before + t) / 2;
        (gap(middle) > 0 ? before : t) = middle;
    }
    return t;
}

namespace {

const glm::dvec4 nothing(std::numeric_limits<double>::infinity());

std::optional<Image> from_an_eye(glm::ivec2 size, const Probe& probe, const Sight& sight) {
    const Plan& plan = sight.plan;
    const Ground& ground = plan.shape.ground;
    std::map<SpherePatch, Leaf::State> known;
    if (probe.name == "level" || probe.name == "skirt")
        for (const Leaf& leaf : cover(plan, exact_rules()).leaves) known[leaf.id] = leaf.state;
    const PatchedSphere::ByLevel& errors = patches_of(plan.shape).errors();
    return image_of_values(size, [&](int x, int y) {
        const Ray ray = sight.seen_from.ray({(x + 0.5) / size.x * 2 - 1, 1 - (y + 0.5) / size.y * 2});
        const auto t = exact_hit(plan.shape, ray);
        if (!t) return nothing;
        const glm::dvec3 r = glm::normalize(ray.at(*t));
        if (probe.name == "seen") return glm::dvec4(1, 0, 0, 0);
        if (probe.name == "place") return glm::dvec4(*t * plan.radius * ray.direction, 0);
        if (probe.name == "normal") return glm::dvec4(exact_normal(ground, r), 0);
        const auto [face, st] = face_place(plan.shape.mapping, r);
        for (int level = 0; level <= deepest_level; ++level) {
            const auto found = known.find(patch_at(face, st, level));
            if (found == known.end()) continue;
            if (probe.name == "skirt")
                return glm::dvec4(exact_rules().skirt_depth(errors, level) * plan.radius, 0, 0, 0);
            const double value = found->second == Leaf::drawn ? level : found->second == Leaf::hidden ? -1 : -2;
            return glm::dvec4(value, 0, 0, 0);
        }
        return nothing;
    });
}

std::optional<Image> spread_out(glm::ivec2 size, const Probe& probe, const Sight& sight) {
    const Shape& shape = sight.plan.shape;
    const bool is_lat_long = shape.mapping == SphereMapping::lat_long;
    const std::vector<Tile> tiles = tile_grid(size, is_lat_long ? 2 : 3, is_lat_long ? 1 : 2);
    const double across = double(1 << sight.plan.level);
    return image_of_values(size, [&](int x, int y) {
        const glm::dvec2 pixel(x + 0.5, size.y - y - 0.5);
        int face = 0;
        while (pixel.x < tiles[size_t(face)].corner.x || pixel.y < tiles[size_t(face)].corner.y ||
               pixel.x > tiles[size_t(face)].corner.x + tiles[size_t(face)].size.x ||
               pixel.y > tiles[size_t(face)].corner.y + tiles[size_t(face)].size.y)
            ++face;
        const Tile& tile = tiles[size_t(face)];
        const glm::dvec2 share = (pixel - glm::dvec2(tile.corner)) / glm::dvec2(tile.size);
        const glm::dvec2 st = 2.0 * share - 1.0, patch = glm::floor(share * across), local = share * across - patch;
        if (probe.name == "texel") {
            const glm::dvec2 middle = (glm::floor(local * double(sight.texels + 2)) - 0.5) / double(sight.texels);
            return glm::dvec4(2.0 * (patch + middle) / across - 1.0, 0, 0);
        }
        const glm::dvec3 r = exact_direction(shape.mapping, face, st);
        if (probe.name == "direction") return glm::dvec4(r, 0);
        if (probe.name == "normal") return glm::dvec4(exact_normal(shape.ground, r), 0);
        const auto [u, v] = exact_tangents(shape.mapping, face, st);
        if (probe.name == "stretch") {
            const double mean = 4 * glm::pi<double>() / (4 * face_count(shape.mapping));
            return glm::dvec4(glm::length(glm::cross(u, v)) / mean, 0, 0, 0);
        }
        if (probe.name == "corner")
            return glm::dvec4(glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v))), 0, 0, 0);
        const glm::dvec3 gradient = exact_height(shape.ground, r).gradient;
        if (probe.name == "gradient") return glm::dvec4(gradient, 0);
        return glm::dvec4(glm::dot(gradient, u), glm::dot(gradient, v), 0, 0);
    });
}

const decltype(globe_truth)::Provided provided_globe(globe_truth, from_an_eye);
const decltype(flat_truth)::Provided provided_flat(flat_truth, spread_out);

}  // namespace
}  // namespace relief::planet
