#include "sphere_patches.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <random>
#include <tuple>

#include "framework/core/base/parallel.h"

namespace relief {

PatchedSphere::PatchedSphere(SphereMapping mapping, int quads, std::function<double(const glm::dvec3&)> height)
    : mapping_(mapping), quads_(quads), height_(std::move(height)) {
    measure_errors();
    measure_highest();
}

/// Returns the errors of a level's triangles at random places, ascending. `samples` is the number of cells.
std::vector<double> PatchedSphere::sampled_errors(int level, int samples) const {
    constexpr int places = 5;
    std::vector<double> errors(size_t(samples) * places);
    parallel_pieces(size_t(samples), 64, 0, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            std::mt19937 random(unsigned(i + 1000003 * size_t(level)));
            const int across = (1 << level) * quads_, face = int(random() % unsigned(face_count(mapping_)));
            // Not as arguments of a call: compilers evaluate these in different orders.
            const double y = random() % unsigned(across), x = random() % unsigned(across);
            const glm::dvec2 cell(x, y);
            const auto ground = [&](glm::dvec2 local) {
                const glm::dvec3 r = direction_at(mapping_, face, 2.0 * (cell + local) / double(across) - 1.0);
                return (1 + height_(r)) * r;
            };
            const glm::dvec3 a = ground({0, 0}), b = ground({1, 0}), c = ground({0, 1}), d = ground({1, 1});
            const glm::dvec3 flat[places] = {(a + b) / 2.0, (a + c) / 2.0, (a + d) / 2.0, (a + b + d) / 3.0,
                                             (a + c + d) / 3.0};
            for (size_t at = 0; at < places; ++at) {
                const double radius = glm::length(flat[at]);
                errors[i * places + at] = std::abs(radius - 1 - height_(flat[at] / radius));
            }
        }
    });
    std::sort(errors.begin(), errors.end());
    return errors;
}

void PatchedSphere::measure_errors() {
    constexpr int measured_levels = 7;
    for (size_t level = 0; level <= deepest_level; ++level) {
        double &usual = usual_errors_[level], &largest = errors_[level];
        if (level < measured_levels) {
            const std::vector<double> errors = sampled_errors(int(level), 700);
            usual = errors[errors.size() * 9 / 10], largest = 1.5 * errors.back();
        } else {  // triangles are smaller than all details, so half the side means a quarter of the error
            usual = usual_errors_[level - 1] / 4, largest = errors_[level - 1] / 4;
        }
        if (level > 0) {
            usual = std::min(usual, usual_errors_[level - 1]);
            largest = std::min(largest, errors_[level - 1]);
        }
    }
}

void PatchedSphere::measure_highest() {
    std::mt19937 random(7);
    for (int i = 0; i < 6000; ++i) {
        const auto coordinate = [&] { return double(random()) / double(std::mt19937::max()) * 2 - 1; };
        const glm::dvec3 at{coordinate(), coordinate(), coordinate()};
        if (const double length = glm::length(at); length > 0.01) highest_ = std::max(highest_, height_(at / length));
    }
    highest_ = 1.15 * highest_ + 1e-6;
}

PatchBounds PatchedSphere::bounds(const SpherePatch& patch) const {
    const std::lock_guard hold(lock_);
    const auto found = bounds_.find(patch);
    return found != bounds_.end() ? found->second : bounds_.emplace(patch, enclose(patch)).first->second;
}

PatchBounds PatchedSphere::enclose(const SpherePatch& patch) const {
    const auto direction = [&](int x, int y) {
        return direction_at(mapping_, patch.face, patch.on_face(glm::dvec2(x, y) / 4.0));
    };
    PatchBounds bounds{direction(2, 2), {}, 0, 0, 0};
    double low = INFINITY, high = -INFINITY;
    for (int y = 0; y <= 4; ++y)
        for (int x = 0; x <= 4; ++x) {
            const glm::dvec3 r = direction(x, y);
            const double h = height_(r);
            low = std::min(low, h), high = std::max(high, h);
            bounds.angle = std::max(bounds.angle, 2 * std::asin(std::min(1.0, glm::length(r - bounds.direction) / 2)));
        }
    // If patches have 16 x 16 quads, the 4 x 4 segments between the places are quads of a patch two levels coarser. So
    // the error of that level bounds the ground between the places.
    const double between = patch.level < 2 ? highest_ : errors_[size_t(patch.level) - 2];
    low = 1 + std::max(0.0, low - between), bounds.highest = std::min(highest_, high + between);
    const double middle = (low + 1 + bounds.highest) / 2;
    bounds.middle = middle * bounds.direction;
    const double c = 1 - std::cos(bounds.angle);  // for the law of cosines without cancellation
    for (const double radius : {low, 1 + bounds.highest})
        bounds.radius =
            std::max(bounds.radius, std::sqrt((radius - middle) * (radius - middle) + 2 * radius * middle * c));
    return bounds;
}

namespace {

/// Returns a key that sorts leaves by face, and within a face along a Z-order curve.
std::pair<int, uint64_t> order_of(const SpherePatch& id) {
    uint64_t code = 0;
    for (int bit = id.level; bit-- > 0;) code = code << 2 | uint64_t(id.y >> bit & 1) << 1 | uint64_t(id.x >> bit & 1);
    return {id.face, code << 2 * (deepest_level - id.level)};
}

/// Returns the leaves after further splits, so that drawn neighbours differ by one level at most.
std::vector<Leaf> balanced(SphereMapping mapping, const std::vector<Leaf>& leaves) {
    std::map<SpherePatch, Leaf::State> all;
    std::vector<SpherePatch> work;  // drawn leaves whose neighbours may be too coarse
    for (const Leaf& leaf : leaves) {
        all[leaf.id] = leaf.state;
        if (leaf.state == Leaf::drawn) work.push_back(leaf.id);
    }
    const auto drawn_leaf_at = [&](const glm::dvec3& direction, int finest) {
        const auto [face, st] = face_place(mapping, direction);
        for (int level = 0; level <= finest; ++level)
            if (const auto found = all.find(patch_at(face, st, level)); found != all.end())
                return found->second == Leaf::drawn ? found : all.end();
        return all.end();
    };
    while (!work.empty()) {
        const SpherePatch leaf = work.back();
        work.pop_back();
        if (!all.contains(leaf)) continue;  // has been split: its children are in `work`
        for (const glm::dvec2 beyond : {glm::dvec2(-0.01, 0.5), {1.01, 0.5}, {0.5, -0.01}, {0.5, 1.01}}) {
            const glm::dvec3 place = direction_at(mapping, leaf.face, leaf.on_face(beyond));
            for (auto coarse = all.end(); (coarse = drawn_leaf_at(place, leaf.level - 2)) != all.end();) {
                const SpherePatch parent = coarse->first;
                all.erase(coarse);
                for (int i = 0; i < 4; ++i) all[parent.child(i)] = Leaf::drawn, work.push_back(parent.child(i));
            }
        }
    }
    std::vector<Leaf> result;
    for (const auto& [id, state] : all) result.push_back({id, state});
    std::sort(result.begin(), result.end(),
              [](const Leaf& a, const Leaf& b) { return order_of(a.id) < order_of(b.id); });
    return result;
}

/// A leaf to split. Among equal needs the coarsest leaf comes first, then the oldest.
struct Split {
    double need;
    int level;
    size_t leaf;
    bool operator<(const Split& other) const {
        return std::tuple(need, -level, other.leaf) < std::tuple(other.need, -other.level, leaf);
    }
};

/// Returns the cover with at most `most` leaves before the splits that balance it.
Cover cover_within(SphereMapping mapping, size_t most, const std::function<PatchNeed(const SpherePatch&)>& need_of) {
    std::vector<Leaf> leaves;
    std::priority_queue<Split> splits;
    const auto put = [&](size_t at, const SpherePatch& id) {
        const PatchNeed need = need_of(id);
        if (at == leaves.size()) leaves.emplace_back();
        leaves[at] = {id, need.state};
        if (need.state == Leaf::drawn && id.level < deepest_level && need.split >= 1)
            splits.push({need.split, id.level, at});
    };
    for (int face = 0; face < face_count(mapping); ++face) put(leaves.size(), SpherePatch{.face = face});
    while (!splits.empty() && leaves.size() + 3 <= most) {
        const size_t at = splits.top().leaf;
        const SpherePatch parent = leaves[at].id;
        splits.pop();
        for (int i = 0; i < 4; ++i) put(i == 0 ? at : leaves.size(), parent.child(i));
    }
    return {balanced(mapping, leaves), !splits.empty()};
}

}  // namespace

Cover cover_sphere(SphereMapping mapping, size_t most_patches,
                   const std::function<PatchNeed(const SpherePatch&)>& need_of) {
    Cover cover = cover_within(mapping, most_patches, need_of);
    // Splits that balance neighbours may exceed the limit. Then a smaller limit is tried.
    for (size_t most = most_patches; cover.leaves.size() > most_patches && most > 6;) {
        most = most * 3 / 4;
        cover = cover_within(mapping, most, need_of);
        cover.is_bounded = true;
    }
    return cover;
}

}  // namespace relief
