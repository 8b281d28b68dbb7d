// How far a picture of the cube's normals is from flat, and which renderer makes such a picture.
#pragma once

#include <optional>
#include <vector>

#include "framework/staff/synctest/cube.h"

namespace relief {

struct SyncJudgement {
    size_t pixels = 0;                    ///< that show a face, without those beside an edge
    bool shows_normals = false;           ///< of these there are enough to judge
    double mean = 0, p99 = 0, worst = 0;  ///< degrees from the axis that is nearest
    bool was_srgb = false;                ///< the picture holds its numbers as sRGB stores light
    /// How much of the cube's outline by synctest_camera and of the picture's is both: 1 where the camera was that.
    double overlap = 0;

    struct Likeness {
        SyncRenderer renderer;
        double degrees;  ///< mean angle between the picture and what that renderer shows
    };
    /// The nearest first; empty where the camera was another.
    std::vector<Likeness> likenesses = {};

    bool is_flat() const { return shows_normals && mean < 0.5; }
    /// The renderer that made such a picture; none where none is near, or two are as near.
    std::optional<SyncRenderer> renderer() const;
};

/// A picture of the cube's normals as 0.5 n + 0.5 (or n itself, in floats), in the space of the world or the object,
/// before a background of one colour that is no normal. The world's axes may be named in any order and direction.
SyncJudgement judge_synctest(const Image& picture);

}  // namespace relief
