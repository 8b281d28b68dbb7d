// The material of a relief: a height map, with its colours and its normals.
#pragma once

#include <array>

#include "framework/image/own_picture.h"
#include "framework/kit/kept.h"
#include "framework/lab/lab.h"

namespace relief {

/// The values of ReliefMaterial's knob `map`. Wall and paving are textures, `own` is the user's picture; the others are
/// made from formulas.
struct ReliefMap {
    enum : int { smooth, fbm, bricks, stones, posts, rock, wall, paving, low, high, plateau, damaged, own };
};

class ReliefMaterial {
public:
    enum Size { texels_1, texels_256, texels_512, texels_1024, texels_4096 };

    ReliefMaterial();
    ReliefMaterial(const ReliefMaterial&) = delete;  // its textures are made by what it knows

    void knobs(Knobs& knobs);

    /// Finite, in [0, 1], rounded as they are stored; row 0 at the top.
    const Image& heights() const { return made().heights; }
    /// Counts up when heights() becomes another image, so that what is made from it can be made anew.
    int version() const {
        made();
        return made_.version();
    }
    /// As the normal map has them, made anew with each call.
    Image normals() const;

    /// Binds s_heights to unit 0, s_albedo to 1, s_normals to 2. The program is in use.
    void set(const Program& program) const;

    /// The normal map is made for a relief this deep, in widths of a tile; a shader that knows the real depth scales
    /// its slopes.
    static constexpr float normals_depth = 0.08f;

    // The knobs. A lab may begin with others.
    int map = ReliefMap::wall, size = texels_512, bits = 0;
    int asset_texels = 1024;  ///< no knob: of the wall and the paving, where a lab sees them from far away

private:
    bool is_asset() const;
    Image albedo() const;

    struct Made {
        Image heights, full;  ///< full: of an asset that the search has less of; else empty
        Texture height_texture, albedo_texture, normal_texture;
    };
    const Made& made() const;
    Made make() const;
    /// One channel of heights; or four, a normal map with heights in the fourth.
    OwnPicture own_;
    mutable Kept<Made, int, int, int, int> made_;  ///< by map, size, bits and which picture
};

}  // namespace relief
