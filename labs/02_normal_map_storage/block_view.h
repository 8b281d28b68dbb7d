// A normal map on a square, stored in compressed blocks and read back: lit, or its error in degrees.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "framework/core/image/compare.h"
#include "framework/core/kit/choices.h"
#include "framework/core/kit/kept.h"
#include "framework/core/kit/labels.h"
#include "framework/core/kit/window_triangle.h"
#include "maps.h"

namespace relief::storage {

class BlockView {
public:
    /// The formats. `bytes` is two bytes a texel without blocks, for comparison.
    enum Format { bc1, bc5, bc5_snorm, bytes };
    static constexpr auto formats = choices<Format>({{bc1, "bc1", "COLORS"},
                                                     {bc5, "bc5", "TWO_UNSIGNED"},
                                                     {bc5_snorm, "bc5-snorm", "TWO_SIGNED"},
                                                     {bytes, "rg8", "TWO_UNSIGNED"}});
    static constexpr std::array shown = {bytes, bc1, bc5, bc5_snorm};  ///< side by side
    enum Repeat { once, wrapped, mirrored };
    static constexpr auto repeats = choices<Repeat>({{once, "once"}, {wrapped, "wrapped"}, {mirrored, "mirrored"}});

    void knobs(Knobs& knobs) {
        knobs.group("Blocks");
        knobs.choice("map", map_, map_names, "normal map for the formats in blocks");
        knobs.choice("repeat", repeat_, repeats.names,
                     "a map in blocks once, or 2 x 2 tiles of it, each like the other or mirrored at its border");
        knobs.toggle("borders", borders_, "lines between the blocks of 4 x 4 texels, over the error");
    }

    /// Draws the map into a tile of frame.target, with captions in `labels`. `part` is the frame of the tile. To the
    /// right of `split`, in clip coordinates, the picture has the error.
    void draw(const Frame& part, glm::ivec2 size, const Tile& tile, Format format, float split, Labels& labels);

    /// Returns the exact values of a probe: for `normal` the map's own normals, of which a mirrored tile turns x or y
    /// around; for `stored` its codes without rounding and without blocks. +infinity beside the map.
    Image truth(const Frame& part, const Probe& probe, Format format) const;

private:
    struct Stored;
    const Stored& stored(Format format);
    const Image& map() const;
    const ErrorSummary& measure(Format format);
    void set_textures(const Program& program, Format format);

    Programs program_{"common/window.vert", "02_normal_map_storage/blocks.frag"};
    WindowTriangle window_;
    mutable Kept<Image, int> texels_;
    Kept<Texture, int> exact_;
    std::map<Format, Kept<std::shared_ptr<const Stored>, int>> stored_;
    std::map<Format, Kept<ErrorSummary, GLuint, int>> measured_;
    int map_ = 0, repeat_ = once;
    bool borders_ = true;
};

}  // namespace relief::storage
