// A normal map on a square, stored in a texture's format and read back: lit, its error in degrees, or its texels.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "framework/core/image/compare.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/window_triangle.h"
#include "maps.h"

namespace relief::storage {

class BlockView {
public:
    /// The formats. `bytes` is two bytes a texel without blocks, for comparison. The last four have three components:
    /// bytes, signed bytes, the codes that a shader computes for them, and signed bytes that are decoded once too
    /// often.
    enum Format { bc1, bc5, bc5_snorm, bytes, rgb8, rgb8_snorm, snorm_codes, snorm_twice };
    static constexpr auto formats = choices<Format>({{bc1, "bc1", "COLORS"},
                                                     {bc5, "bc5"},
                                                     {bc5_snorm, "bc5-snorm", "TWO_SIGNED"},
                                                     {bytes, "rg8"},
                                                     {rgb8, "rgb8", "COLORS"},
                                                     {rgb8_snorm, "rgb8-snorm", "THREE_SIGNED"},
                                                     {snorm_codes, "snorm-codes", "CODES"},
                                                     {snorm_twice, "snorm-twice", "SIGNED_TWICE"}});
    /// How a tile shows the map: lit, with the error to the right of the split; only lit; its colours; the heights that
    /// belong to it; or the colours with the vectors that they stand for.
    enum Look { lit_and_error, lit, colors, heights, field };
    static constexpr int all = -1;
    /// The content of a tile.
    struct Panel {
        Format format;
        Look look;
        const char* title;
        int channel;  ///< of colours or heights, or `all`
    };
    static constexpr std::array<Panel, 4> in_blocks = {{{bytes, lit_and_error, "8:8 and z", all},
                                                        {bc1, lit_and_error, "BC1", all},
                                                        {bc5, lit_and_error, "BC5", all},
                                                        {bc5_snorm, lit_and_error, "BC5, signed", all}}};
    static constexpr std::array<Panel, 4> signed_textures = {
        {{rgb8, lit_and_error, "RGB8, 2x - 1", all},
         {rgb8_snorm, lit_and_error, "RGB8_SNORM, as read", all},
         {snorm_codes, lit_and_error, "its codes, in the shader", all},
         {snorm_twice, lit_and_error, "RGB8_SNORM, 2x - 1", all}}};
    static constexpr std::array<Panel, 6> channels = {{{rgb8, heights, "heights", 0},
                                                       {rgb8, colors, "normal map", all},
                                                       {rgb8, lit, "light", all},
                                                       {rgb8, colors, "red: x", 0},
                                                       {rgb8, colors, "green: y", 1},
                                                       {rgb8, colors, "blue: z", 2}}};
    static constexpr std::array<Panel, 1> vectors = {{{rgb8, field, "one vector a texel", all}}};
    enum Repeat { once, wrapped, mirrored };
    static constexpr auto repeats = choices<Repeat>({{once, "once"}, {wrapped, "wrapped"}, {mirrored, "mirrored"}});

    void knobs(Knobs& knobs) {
        knobs.group("Blocks");
        knobs.choice("map", map_, map_names,
                     KnobHelp("normal map of every view on squares")
                         .only("view", {"one", "blocks", "snorm", "channels", "field"}));
        knobs.choice(
            "repeat", repeat_, repeats.names,
            KnobHelp("a map in blocks once, or 2 x 2 tiles of it, each like the other or mirrored at its border")
                .only("view", {"one", "blocks", "snorm", "channels"}));
        knobs.toggle("borders", borders_,
                     KnobHelp("lines between the blocks of 4 x 4 texels, over the error")
                         .only("view", {"one", "blocks", "snorm"}));
    }

    /// Draws the map into a tile of frame.target, with captions in `labels`. `part` is the frame of the tile. A lit map
    /// has the error to the right of `split`, in clip coordinates.
    void draw(const Frame& part, glm::ivec2 size, const Tile& tile, const Panel& panel, float split, Labels& labels);

    /// Returns the exact values of a probe: for `normal` the map's own normals, of which a mirrored tile turns x or y
    /// around; for `stored` its codes without rounding and without blocks. +infinity beside the map.
    Image truth(const Frame& part, const Panel& panel) const;

private:
    struct Stored;
    const Stored& stored(Format format);
    const Image& map() const;
    const ErrorSummary& measure(Format format);
    void set_textures(const Program& program, Format format);
    void draw_vectors(const Frame& part, glm::ivec2 size, const Tile& tile, Labels& labels);
    void describe(glm::ivec2 size, const Tile& tile, const Panel& panel, const ErrorSummary& error, Labels& labels);

    Programs program_{"common/window.vert", "02_normal_map_storage/blocks.frag"};
    Programs vectors_{"02_normal_map_storage/vectors.vert", "02_normal_map_storage/vectors.frag"};
    WindowTriangle window_;
    mutable Kept<Image, int> texels_;
    Kept<Texture, int> exact_, heights_;
    std::map<Format, Kept<std::shared_ptr<const Stored>, int>> stored_;
    std::map<Format, Kept<ErrorSummary, GLuint, int>> measured_;
    int map_ = 0, repeat_ = once;
    bool borders_ = true;
};

}  // namespace relief::storage
