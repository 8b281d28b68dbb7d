#include "patches.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <map>
#include <mutex>
#include <queue>
#include <random>
#include <tuple>

#include "framework/base/parallel.h"
#include "task.h"

namespace relief::planet {

glm::dmat3 face_axes(Mapping mapping, int face) {
    if (mapping == Mapping::lat_long) return glm::dmat3({face ? -1 : 1, 0, 0}, {0, 1, 0}, {0, 0, face ? -1 : 1});
    const CubeFace& axes = cube_face(face);
    return {axes.right, axes.up, axes.normal};
}

glm::dvec3 direction_at(Mapping mapping, int face, glm::dvec2 st) {
    if (mapping == Mapping::lat_long) {
        // Multiples of a quarter turn are exact, so that both halves meet.
        const auto turn = [](double quarters) {
            const double whole = std::round(quarters), rest = glm::half_pi<double>() * (quarters - whole);
            const double c = std::cos(rest), s = std::sin(rest);
            const int at = int(whole) & 3;
            return at == 0   ? glm::dvec2(c, s)
                   : at == 1 ? glm::dvec2(-s, c)
                   : at == 2 ? glm::dvec2(-c, -s)
                             : glm::dvec2(s, -c);
        };
        const glm::dvec2 around = turn(st.x + 2 * face), up = turn(st.y);
        return {up.x * around.y, up.y, up.x * around.x};
    }
    if (mapping == Mapping::gnomonic)
        for (int i = 0; i < 2; ++i)
            if (std::abs(st[i]) != 1) st[i] = std::atan(st[i]) / glm::quarter_pi<double>();
    return cube_sphere_direction(face, st.x, st.y);
}

namespace {

/// Returns the errors of a level's triangles at random places, in radii, ascending. `samples` is the number of cells.
std::vector<double> errors_of(const Shape& shape, int level, int samples) {
    constexpr int places = 5;
    std::vector<double> errors(size_t(samples) * places);
    parallel_pieces(size_t(samples), 64, 0, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            std::mt19937 random(unsigned(i + 1000003 * size_t(level)));
            const int across = (1 << level) * shape.quads, face = int(random() % unsigned(face_count(shape.mapping)));
            const glm::dvec2 cell(random() % unsigned(across), random() % unsigned(across));
            const auto ground = [&](glm::dvec2 local) {
                const glm::dvec3 r = direction_at(shape.mapping, face, 2.0 * (cell + local) / double(across) - 1.0);
                return (1 + height(shape.ground, r)) * r;
            };
            const glm::dvec3 a = ground({0, 0}), b = ground({1, 0}), c = ground({0, 1}), d = ground({1, 1});
            const glm::dvec3 flat[places] = {(a + b) / 2.0, (a + c) / 2.0, (a + d) / 2.0, (a + b + d) / 3.0,
                                             (a + c + d) / 3.0};
            for (size_t at = 0; at < places; ++at) {
                const double radius = glm::length(flat[at]);
                errors[i * places + at] = std::abs(radius - 1 - height(shape.ground, flat[at] / radius));
            }
        }
    });
    std::sort(errors.begin(), errors.end());
    return errors;
}

Measured measure(const Shape& shape) {
    Measured result;
    constexpr int measured_levels = 7;
    for (size_t level = 0; level <= deepest_level; ++level) {
        double &usual = result.usual_errors[level], &largest = result.errors[level];
        if (level < measured_levels) {
            const std::vector<double> errors = errors_of(shape, int(level), 700);
            usual = errors[errors.size() * 9 / 10], largest = 1.5 * errors.back();
        } else {  // triangles are smaller than all details, so half the side means a quarter of the error
            usual = result.usual_errors[level - 1] / 4, largest = result.errors[level - 1] / 4;
        }
        if (level > 0) {
            usual = std::min(usual, result.usual_errors[level - 1]);
            largest = std::min(largest, result.errors[level - 1]);
        }
    }
    std::mt19937 random(7);
    for (int i = 0; i < 6000; ++i) {
        const auto coordinate = [&] { return double(random()) / double(std::mt19937::max()) * 2 - 1; };
        const glm::dvec3 at{coordinate(), coordinate(), coordinate()};
        if (const double length = glm::length(at); length > 0.01)
            result.highest = std::max(result.highest, height(shape.ground, at / length));
    }
    result.highest = 1.15 * result.highest + 1e-6;
    return result;
}

struct Survey {
    Measured measured;
    std::map<PatchId, Bounds> bounds;
};
std::mutex survey_lock;

/// Returns the survey of a shape, cached because it takes longer than a frame. Precondition: survey_lock is held.
Survey& survey(const Shape& shape) {
    static std::map<std::tuple<int, int, float, int, int>, Survey> known;
    const auto key =
        std::tuple(shape.ground.seed, shape.ground.detail, shape.ground.height, int(shape.mapping), shape.quads);
    const auto found = known.find(key);
    return found != known.end() ? found->second : known.emplace(key, Survey{measure(shape), {}}).first->second;
}

Bounds enclose(const Shape& shape, const Measured& measured, const PatchId& id) {
    const auto direction = [&](int x, int y) {
        return direction_at(shape.mapping, id.face, id.on_face(glm::dvec2(x, y) / 4.0));
    };
    Bounds bounds{direction(2, 2), {}, 0, 0, 0};
    double low = INFINITY, high = -INFINITY;
    for (int y = 0; y <= 4; ++y)
        for (int x = 0; x <= 4; ++x) {
            const glm::dvec3 r = direction(x, y);
            const double h = height(shape.ground, r);
            low = std::min(low, h), high = std::max(high, h);
            bounds.angle = std::max(bounds.angle, 2 * std::asin(std::min(1.0, glm::length(r - bounds.direction) / 2)));
        }
    // If patches have 16 x 16 quads, the 4 x 4 segments between the places are quads of a patch two levels coarser. So
    // the error of that level bounds the ground between the places.
    const double between = id.level < 2 ? measured.highest : measured.errors[size_t(id.level) - 2];
    low = 1 + std::max(0.0, low - between), bounds.highest = std::min(measured.highest, high + between);
    const double middle = (low + 1 + bounds.highest) / 2;
    bounds.middle = middle * bounds.direction;
    const double c = 1 - std::cos(bounds.angle);  // for the law of cosines without cancellation
    for (const double radius : {low, 1 + bounds.highest})
        bounds.radius =
            std::max(bounds.radius, std::sqrt((radius - middle) * (radius - middle) + 2 * radius * middle * c));
    return bounds;
}

}  // namespace

const Measured& measured(const Shape& shape) {
    const std::lock_guard hold(survey_lock);
    return survey(shape).measured;
}

Bounds bounds_of(const Shape& shape, const PatchId& id) {
    const std::lock_guard hold(survey_lock);
    Survey& known = survey(shape);
    const auto found = known.bounds.find(id);
    return found != known.bounds.end() ? found->second
                                       : known.bounds.emplace(id, enclose(shape, known.measured, id)).first->second;
}

std::pair<int, glm::dvec2> face_place(Mapping mapping, const glm::dvec3& direction) {
    if (mapping == Mapping::lat_long) {
        const int face = direction.z < 0;
        const double side = face ? -1 : 1;
        return {face, glm::dvec2(std::atan2(side * direction.x, side * direction.z), std::asin(direction.y)) /
                          glm::half_pi<double>()};
    }
    const glm::dvec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int face = 2 * axis + (direction[axis] < 0);
    const glm::dvec3 on_face = glm::transpose(face_axes(mapping, face)) * direction;
    const glm::dvec2 on_cube = glm::dvec2(on_face) / on_face.z;
    return {face, mapping == Mapping::gnomonic ? on_cube : glm::atan(on_cube) / glm::quarter_pi<double>()};
}

Rules students_rules() { return {split_distance, skirt_depth, behind_horizon}; }

Eye Eye::of(const Camera& camera, double aspect) {
    return {camera.eye(), glm::dmat3(camera.view_from_world()), glm::radians(camera.orbit().field_of_view), aspect};
}

Eye Eye::looking(const glm::dvec3& place, const glm::dvec3& along, const glm::dvec3& up, double field_of_view_rad,
                 double aspect) {
    const glm::dvec3 right = glm::normalize(glm::cross(along, up)), above = glm::cross(right, along);
    return {place, glm::transpose(glm::dmat3(right, above, -along)), field_of_view_rad, aspect};
}

Ray Eye::ray(glm::dvec2 clip) const {
    const double tangent = std::tan(field_of_view_rad / 2);
    const glm::dvec3 seen(clip.x * tangent * aspect, clip.y * tangent, -1);
    return {place, glm::normalize(glm::transpose(view_from_world) * seen)};
}

bool is_outside(const Eye& eye, const glm::dvec3& middle, double radius) {
    const glm::dvec3 seen = eye.view_from_world * (middle - eye.place);
    const double y = std::tan(eye.field_of_view_rad / 2), x = y * eye.aspect;
    // Signed distances to the side planes of the view frustum, positive inside.
    const double sideways = (-seen.z * x - std::abs(seen.x)) / std::sqrt(1 + x * x);
    const double upwards = (-seen.z * y - std::abs(seen.y)) / std::sqrt(1 + y * y);
    return seen.z > radius || sideways < -radius || upwards < -radius;
}

namespace {

/// Splits drawn patches until drawn neighbours differ by one level at most.
void balance(const Shape& shape, std::vector<Leaf>& all) {
    std::map<PatchId, size_t> places;
    for (size_t i = 0; i < all.size(); ++i) places[all[i].id] = i;
    const auto leaf_at = [&](const glm::dvec3& direction, int finest) -> Leaf* {
        const auto [face, st] = face_place(shape.mapping, direction);
        for (int level = 0; level <= finest; ++level) {
            const glm::ivec2 at(glm::clamp((st + 1.0) / 2.0, 0.0, 1 - 1e-12) * double(1 << level));
            const auto found = places.find({face, level, at.x, at.y});
            if (found != places.end()) return &all[found->second];
        }
        return nullptr;  // the patch there is finer
    };
    for (size_t i = 0; i < all.size(); ++i) {
        const Leaf leaf = all[i];
        if (leaf.state != Leaf::drawn || leaf.id.level < 2) continue;
        for (const glm::dvec2 beyond : {glm::dvec2(-0.01, 0.5), {1.01, 0.5}, {0.5, -0.01}, {0.5, 1.01}}) {
            const glm::dvec3 r = direction_at(shape.mapping, leaf.id.face, leaf.id.on_face(beyond));
            for (Leaf* coarse; (coarse = leaf_at(r, leaf.id.level - 2)) && coarse->state == Leaf::drawn;) {
                const PatchId whole = coarse->id;
                const size_t place = places[whole];
                places.erase(whole);
                for (int child = 0; child < 4; ++child) {
                    const PatchId part{whole.face, whole.level + 1, 2 * whole.x + child % 2, 2 * whole.y + child / 2};
                    if (child == 0)
                        all[place].id = part, places[part] = place;
                    else
                        places[part] = all.size(), all.push_back({part, Leaf::drawn});
                }
                // Child 0 has its parent's place. If that was visited already, the child moves to the end.
                if (place < i)
                    places[all[place].id] = all.size(), all.push_back(all[place]), all[place].state = Leaf::gone;
            }
        }
    }
    std::erase_if(all, [](const Leaf& leaf) { return leaf.state == Leaf::gone; });
}

}  // namespace

namespace {

/// Returns a key that sorts leaves by face, and within a face along a Z-order curve.
std::pair<int, uint64_t> order_of(const PatchId& id) {
    uint64_t code = 0;
    for (int bit = id.level; bit-- > 0;) code = code << 2 | uint64_t(id.y >> bit & 1) << 1 | uint64_t(id.x >> bit & 1);
    return {id.face, code << 2 * (deepest_level - id.level)};
}

}  // namespace

Cover cover(const Plan& plan, const Rules& rules) {
    const Measured& known = measured(plan.shape);
    std::array<double, deepest_level + 1> within{};
    for (int level = 0; level < deepest_level; ++level)
        within[size_t(level)] = plan.levels == Levels::uniform ? (level < plan.level ? INFINITY : -1)
                                : plan.levels == Levels::distance
                                    ? 6 / (plan.budget * (1 << level))
                                    : rules.split_distance(known.usual_errors[size_t(level)] * plan.radius, plan.budget,
                                                           plan.pixels, plan.eye.field_of_view_rad) /
                                          plan.radius;
    const double from_centre = glm::length(plan.eye.place);
    /// A leaf to split. `need` is larger for a leaf that is nearer to the eye, relative to its level.
    struct Split {
        double need;
        size_t leaf;
        int level;
        bool operator<(const Split& other) const {
            return std::tuple(need, -level, other.leaf) < std::tuple(other.need, -other.level, leaf);
        }
    };
    const auto grown_to = [&](size_t most) {
        Cover result;
        std::vector<Leaf>& all = result.leaves;
        std::priority_queue<Split> splits;
        const auto put = [&](size_t at, const PatchId& id) {
            const Bounds bounds = bounds_of(plan.shape, id);
            Leaf::State state = Leaf::drawn;
            if (plan.cull != Cull::none && is_outside(plan.eye, bounds.middle, bounds.radius)) state = Leaf::outside;
            if (plan.cull == Cull::horizon && from_centre > 0) {
                const double apart =
                    std::acos(std::clamp(glm::dot(plan.eye.place, bounds.direction) / from_centre, -1.0, 1.0));
                if (rules.behind_horizon(from_centre * plan.radius, std::max(0.0, apart - bounds.angle), plan.radius,
                                         plan.radius * (1 + bounds.highest)))
                    state = Leaf::hidden;
            }
            if (at == all.size()) all.emplace_back();
            all[at] = {id, state};
            const double away = std::max(0.0, glm::distance(plan.eye.place, bounds.middle) - bounds.radius);
            if (state != Leaf::drawn || id.level == deepest_level || away > within[size_t(id.level)]) return;
            const double need = within[size_t(id.level)] / away;
            splits.push({std::isnan(need) ? INFINITY : need, at, id.level});
        };
        for (int face = 0; face < face_count(plan.shape.mapping); ++face) put(all.size(), PatchId{.face = face});
        for (; !splits.empty() && all.size() + 3 <= most;) {
            const size_t at = splits.top().leaf;
            const PatchId id = all[at].id;
            splits.pop();
            for (int child = 0; child < 4; ++child)
                put(child == 0 ? at : all.size(),
                    PatchId{id.face, id.level + 1, 2 * id.x + child % 2, 2 * id.y + child / 2});
        }
        result.is_bounded = !splits.empty();
        std::sort(all.begin(), all.end(), [](const Leaf& a, const Leaf& b) { return order_of(a.id) < order_of(b.id); });
        balance(plan.shape, all);
        return result;
    };
    Cover result = grown_to(plan.most_patches);
    // Splits that keep neighbours within one level may exceed the limit. Then a smaller limit is tried.
    for (size_t most = plan.most_patches; result.leaves.size() > plan.most_patches && most > 6;) {
        most = most * 3 / 4;
        result = grown_to(most);
        result.is_bounded = true;
    }
    return result;
}

}  // namespace relief::planet
