// Lab 02: normal map storage.
//
// A sphere of directions, stored in each format and read back: lit on the left, the error in degrees on the right.
// Or a normal map: in compressed blocks, in signed bytes, its channels, its vectors. Your tasks:
// shaders/02_normal_map_storage/task.glsl and labs/02_normal_map_storage/task.cpp
#include <fmt/format.h>

#include <map>
#include <memory>

#include "block_view.h"
#include "formats.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/texel_target.h"
#include "framework/core/image/compare.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/view_axes.h"
#include "framework/library/kit/window_triangle.h"
#include "framework/library/maps/own_picture.h"
#include "truth.h"

namespace relief {

class NormalMapStorage final : public Lab {
public:
    void draw(const Frame& frame) override {
        if (shows_map())
            draw_map(frame);
        else
            draw_spheres(frame);
        if (show_ != light && shows_errors()) labels_.scale(frame.size, "0.001~", "10~", 4);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        static const auto names = [] {
            std::array<const char*, storage::formats.size() + block_formats> list{};
            for (size_t i = 0; i < list.size(); ++i)
                list[i] = i < storage::formats.size() ? storage::formats[i].name
                                                      : storage::BlockView::formats.names[i - storage::formats.size()];
            return list;
        }();
        knobs.choice("view", view_, views.names,
                     "every format of a texel, one format, or a map: in blocks, in signed bytes, its channels, its "
                     "vectors");
        knobs.choice("format", format_, names,
                     KnobHelp("the format of the sphere, or of a map in blocks (bc...)").only("view", {"one"}));
        knobs.toggle("mismatch", mismatch_, "decode 8-bit codes with the other convention's rule");
        knobs.choice("show", show_, shows.names, "the light, the error, or half of each");
        block_view_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame) const override {
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t i) {
            return shows_map() ? block_view_.truth(part, panels()[i]) : storage::truth(part, format_of(i));
        });
    }

private:
    enum View { every, one, blocks, snorm, channels, field };
    static constexpr auto views = choices<View>({{every, "every"},
                                                 {one, "one"},
                                                 {blocks, "blocks"},
                                                 {snorm, "snorm"},
                                                 {channels, "channels"},
                                                 {field, "field"}});
    enum Show { half_and_half, light, error_map };
    static constexpr auto shows =
        choices<Show>({{half_and_half, "half-and-half"}, {light, "light"}, {error_map, "error"}});
    static constexpr glm::ivec2 measured{512, 256};
    static constexpr size_t block_formats = 3;  ///< the first ones of BlockView::formats

    using BlockView = storage::BlockView;

    bool shows_map() const { return view_ >= blocks || (view_ == one && format_ >= int(storage::formats.size())); }
    /// Precondition: shows_map().
    std::span<const BlockView::Panel> panels() const {
        switch (view_) {
            case blocks:
                return BlockView::in_blocks;
            case snorm:
                return BlockView::signed_textures;
            case channels:
                return BlockView::channels;
            case field:
                return BlockView::vectors;
            default:  // BlockView::in_blocks begins with two bytes, which are no format in blocks
                return std::span(BlockView::in_blocks).subspan(size_t(format_) - storage::formats.size() + 1, 1);
        }
    }
    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        const size_t count = shows_map() ? panels().size() : view_ == one ? 1 : storage::formats.size();
        const auto tiles = tiles_of(size, int(count), shows_errors() ? Labels::scale_height(size) : 0);
        return view_ == blocks || view_ == snorm ? Labels::with_feet(size, tiles, 2, 42) : tiles;
    }
    bool shows_errors() const { return view_ != channels && view_ != field; }
    int format_of(size_t tile) const { return view_ == one ? format_ : int(tile); }
    float split() const { return show_ == half_and_half ? 0.0f : show_ == light ? 2.0f : -2.0f; }

    void draw_map(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const auto tiles = tiles_of_view(frame.size);
        for (size_t i = 0; i < tiles.size(); ++i)
            block_view_.draw(frame_in(frame, tiles[i]), frame.size, tiles[i], panels()[i], split(), labels_);
    }

    void draw_spheres(const Frame& frame) {
        const auto tiles = tiles_of_view(frame.size);
        std::vector<ErrorSummary> errors(tiles.size());
        if (!frame.probe)
            for (size_t i = 0; i < tiles.size(); ++i) errors[i] = measure(format_of(i));
        // Only codes pass from the encoder to the decoder.
        const bool decodes = frame.probe.name != "stored";
        if (decodes) {
            const TexelTarget& codes = codes_of(frame.size);
            codes.begin();
            for (size_t i = 0; i < tiles.size(); ++i)
                draw_sphere(frame_in(frame, tiles[i]), tiles[i], program(format_of(i), "", "STORE"));
            codes.bind(0);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < tiles.size(); ++i) {
            draw_sphere(frame_in(frame, tiles[i]), tiles[i], program(format_of(i), frame.probe));
            describe(frame.size, tiles[i], format_of(i), errors[i]);
        }
    }

    const Program& program(int format, const Define& purpose, const char* store = "") const {
        return sphere_.with({fmt::format("FORMAT {}", format), mismatch_ ? "MISMATCH" : "", purpose, store});
    }

    const TexelTarget& codes_of(glm::ivec2 size) {
        return *codes_.get(
            {size}, [&] { return std::make_unique<TexelTarget>(size, std::initializer_list<GLenum>{GL_RGBA32F}); });
    }

    void draw_sphere(const Frame& frame, const Tile& tile, const Program& sphere) {
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        glUseProgram(sphere);
        sphere.set("s_codes", 0);
        sphere.set("u_eye", frame.camera.eye());
        set_rays(sphere, frame);
        sphere.set("u_split", split());
        window_.draw();
    }

    /// Returns the error over evenly distributed directions, computed by the shader. It is measured again when a
    /// program changes, that is, when a shader is saved.
    const ErrorSummary& measure(int format) {
        const Program &encoder = program(format, "MEASURE", "STORE"), &decoder = program(format, "MEASURE");
        return measured_[format].get({encoder, decoder}, [&] {
            const auto draw_with = [&](const Program& sphere) {
                glUseProgram(sphere);
                sphere.set("u_measured", measured);
                sphere.set("s_codes", 0);
                window_.draw();
            };
            const TexelTarget codes(measured, {GL_RGBA32F});
            codes.begin();
            draw_with(encoder);
            codes.bind(0);
            const Image drawn = draw_numbers(measured, [&] { draw_with(decoder); });
            return summarize(channels_of(drawn, 0, 1));
        });
    }

    void describe(glm::ivec2 size, const Tile& tile, int format, const ErrorSummary& error) {
        const storage::Format& about = storage::formats[size_t(format)];
        labels_.caption(size, tile, 0, about.title);
        if (error.count > 0)
            labels_.caption(size, tile, -2,
                            fmt::format("mean {}~ max {}~", rounded(error.mean), rounded(error.largest)));
        if (!mismatch_)
            labels_.caption(size, tile, -1, fmt::format("table {}~ {}~", rounded(about.mean), rounded(about.largest)),
                            {0.62f, 0.63f, 0.65f});
    }

    Programs sphere_{"common/window.vert", "02_normal_map_storage/sphere.frag"};
    WindowTriangle window_;
    Kept<std::unique_ptr<TexelTarget>, glm::ivec2> codes_;
    BlockView block_view_;
    Labels labels_;
    std::map<int, Kept<ErrorSummary, GLuint, GLuint>> measured_;  ///< by format

    int view_ = every, format_ = 0, show_ = half_and_half;
    bool mismatch_ = false;
};

RELIEF_LAB(NormalMapStorage);

}  // namespace relief
