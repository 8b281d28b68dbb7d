// The material of a relief: a height map, with its colours and its normals.
#pragma once

#include <array>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/kept.h"
#include "framework/library/maps/own_picture.h"

namespace relief {

/// The values of ReliefMaterial's knob `map`. Wall and paving are textures, `own` is the user's picture, and the others
/// are computed from formulas.
struct ReliefMap {
    enum : int { smooth, fbm, bricks, stones, posts, rock, wall, paving, low, high, plateau, damaged, own };
};

class ReliefMaterial {
public:
    enum Colors { colors_of_map, own_colors };
    enum Size { texels_1, texels_256, texels_512, texels_1024, texels_4096 };

    ReliefMaterial();
    ReliefMaterial(const ReliefMaterial&) = delete;  // its textures refer to this object

    void knobs(Knobs& knobs);

    /// Returns the heights: finite, in [0, 1], rounded to the stored bits; row 0 is the top.
    const Image& heights() const { return made().heights; }
    /// Increases when heights() becomes another image, so that a caller can update values made from it.
    int version() const {
        made();
        return made_.version();
    }
    /// Computes the contents of the normal map, again with each call.
    Image normals() const;

    /// Binds s_heights to unit 0, s_albedo to 1, s_normals to 2. Precondition: the program is in use.
    void set(const Program& program) const;

    /// The depth of relief that the normal map is made for, in widths of a tile. A shader scales its slopes to the real
    /// depth.
    static constexpr float normals_depth = 0.08f;

    // The knobs. A lab may set other defaults.
    int map = ReliefMap::wall, size = texels_512, bits = 0, colors = colors_of_map;
    int asset_texels = 1024;  ///< not a knob: maximum size of the wall's and the paving's heights
    /// Not one of knobs(): the wall's and the paving's heights are those of their packed maps. Then s_heights has the
    /// height in red, the gloss in green and the occlusion in blue.
    bool packed = false;
    bool is_packed() const { return packed && is_asset(); }

private:
    bool is_asset() const;
    const Texture& own_albedo_texture() const;
    Image albedo() const;

    struct Made {
        Image heights, full;  ///< full: an asset's original heights, if `heights` are smaller or rounded; else empty
        Texture height_texture, albedo_texture, normal_texture;
    };
    const Made& made() const;
    Made make() const;
    /// One channel of heights, or four: a normal map with heights in the fourth.
    OwnPicture own_;
    OwnPicture own_colors_;                  ///< as sRGB stores them
    mutable Kept<Texture, int> own_albedo_;  ///< by the version of the picture
    /// Inputs: map, size, bits, is_packed() and version of the picture; size and version are 0 for maps without them.
    mutable Kept<Made, int, int, int, bool, int> made_;
};

}  // namespace relief
