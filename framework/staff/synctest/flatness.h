// Measures how far a picture of the cube's normals is from flat, and finds the renderer that made it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/staff/synctest/cube.h"

namespace relief::synctest {

struct SyncJudgement {
    size_t pixels = 0;                    ///< pixels on a face, without pixels beside an edge
    bool shows_normals = false;           ///< these are normals of the world or the object, and enough to judge
    std::string problem = {};             ///< if not: the cause, if it is known
    double mean = 0, p99 = 0, worst = 0;  ///< degrees from the nearest axis
    bool was_srgb = false;                ///< the picture stores its values with the sRGB curve
    /// Overlap (intersection over union) of the picture's outline and the cube's outline from synctest_camera: 1 if the
    /// camera was the same.
    double overlap = 0;

    struct Likeness {
        SyncRenderer renderer;
        double degrees;  ///< mean angle between the picture and that renderer's result
    };
    /// The nearest first; empty if the camera was a different one.
    std::vector<Likeness> likenesses = {};

    bool is_flat() const { return shows_normals && mean < 0.5; }
    /// Returns the renderer that made the picture; nothing if none is close, or if two are equally close.
    std::optional<SyncRenderer> renderer() const;
};

/// Judges a picture of the cube's normals as 0.5 n + 0.5 (or n itself, in floats), in world or object space. The
/// background must have one colour that is not a normal. The world's axes may have any order and direction. If no known
/// renderer made the picture, the mean normals of its three faces tell normals from other colours: a frame's error is
/// symmetric on a face, so each mean is near an axis. A camera turns all three; a curve or an exposure moves them to or
/// from grey.
SyncJudgement judge_synctest(const Image& picture);

}  // namespace relief::synctest
