// A sphere of radius 1 with heights, as patches of triangles: their errors, their bounds, and which of them to draw.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

#include "sphere_grid.h"

namespace relief {

constexpr int deepest_level = 12;  ///< of a patch

/// Bounds of the ground of a patch, in radii of the sphere. `direction` is the unit direction of the patch's middle,
/// and `angle` the largest angle in radians between it and the direction of a place on the patch. `middle` and `radius`
/// are a bounding sphere. `highest` is an upper bound of the heights.
struct PatchBounds {
    glm::dvec3 direction, middle;
    double angle, radius, highest;
};

/// Patches of quads x quads quads whose vertices lie on the ground. Thread-safe.
class PatchedSphere {
public:
    /// `height` returns the height of the ground at a unit direction, in radii, at least 0. It must be thread-safe.
    /// Measures the errors from some thousand samples, which takes longer than a frame.
    PatchedSphere(SphereMapping mapping, int quads, std::function<double(const glm::dvec3&)> height);

    using ByLevel = std::array<double, deepest_level + 1>;
    /// Returns the largest vertical errors of the triangles of each level, estimated with a margin. Non-increasing.
    const ByLevel& errors() const { return errors_; }
    /// Returns upper bounds of the errors at nine of ten places. Non-increasing.
    const ByLevel& usual_errors() const { return usual_errors_; }
    /// Returns the highest ground, estimated with a margin. The lowest is 0.
    double highest() const { return highest_; }

    /// Returns the bounds of a patch, cached.
    PatchBounds bounds(const SpherePatch& patch) const;

private:
    std::vector<double> sampled_errors(int level, int samples) const;
    void measure_errors();
    void measure_highest();
    PatchBounds enclose(const SpherePatch& patch) const;

    SphereMapping mapping_;
    int quads_;
    std::function<double(const glm::dvec3&)> height_;
    ByLevel errors_{}, usual_errors_{};
    double highest_ = 0;
    mutable std::mutex lock_;
    mutable std::map<SpherePatch, PatchBounds> bounds_;
};

/// A patch of a cover. It is drawn, or culled because it is outside of the picture or hidden.
struct Leaf {
    enum State { drawn, outside, hidden };
    SpherePatch id;
    State state = drawn;
};

/// Patches that cover the whole sphere once, sorted by face, and within a face along a Z-order curve. A culled patch is
/// as large as possible. Drawn neighbours differ by one level at most.
struct Cover {
    std::vector<Leaf> leaves;
    bool is_bounded = false;  ///< most_patches has reduced the number of patches
};

/// The state of a patch in a picture, and its need of a split. A drawn patch is split if `split` is 1 or more; patches
/// with the largest value are split first.
struct PatchNeed {
    Leaf::State state = Leaf::drawn;
    double split = 0;
};

/// Returns the patches that a picture needs, at most `most_patches` of them, which is at least 6.
Cover cover_sphere(SphereMapping mapping, size_t most_patches,
                   const std::function<PatchNeed(const SpherePatch&)>& need_of);

}  // namespace relief
