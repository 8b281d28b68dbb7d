// Lab 11: parallax occlusion mapping.
//
// March the view ray through the height map, and intersect the line between the last two samples.
// Your tasks: shaders/11_parallax_occlusion/task.glsl
#include <fmt/format.h>

#include "framework/core/base/text.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/relief_surface.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/maps/bounds.h"
#include "truth.h"

namespace relief {

class ParallaxOcclusion final : public Lab {
public:
    ParallaxOcclusion() { surface_.depth = 0.06f; }

    void draw(const Frame& frame) override {
        const auto tiles = tiles_of_view(frame.size);
        std::vector<Figures> figures(tiles.size());
        const bool shows_error = view_ == compare && show_ != picture && !frame.probe;
        if (view_ == compare && !frame.probe)
            for (size_t i = 0; i < tiles.size(); ++i) figures[i] = measure(i, frame, tiles[i].size.y);
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        for (size_t i = 0; i < tiles.size(); ++i) {
            const glm::ivec2 corner = tiles[i].corner, size = tiles[i].size;
            const int left = !shows_error ? size.x : show_ == error ? 0 : size.x * 3 / 4;
            draw_part(frame, tiles[i], {corner, {left, size.y}}, method_of(i), frame.probe);
            if (shows_error)
                draw_part(frame, tiles[i], {corner + glm::ivec2(left, 0), {size.x - left, size.y}}, method_of(i),
                          "ERROR");
            glScissor(corner.x, corner.y, size.x, size.y);
            studio_.draw(frame_in(frame, tiles[i]), tiles[i], surface_.studio_inputs(),
                         [this] { return surface_.mesh(); });
            if (view_ == compare) describe(frame.size, tiles[i], comparisons[i], figures[i]);
        }
        glDisable(GL_SCISSOR_TEST);
        if (shows_error) labels_.scale(frame.size, "0.01", "100 texels", 4);
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views, "methods side by side, or one picture by the knobs");
        knobs.choice("show", show_, shows, KnobHelp("the picture, the error, or both").only("view", {"compare"}));
        knobs.group("March");
        knobs.choice("count", chosen_.count, counts.names,
                     KnobHelp("rule for the number of steps").only("view", {"one"}).titled("Step count by"));
        knobs.steps("steps", steps_, 1, 512,
                    KnobHelp("steps of the march; with count = angle: of a level ray").only("view", {"one"}));
        knobs.steps("least_steps", least_steps_, 1, 512,
                    KnobHelp("steps of a ray straight down").only("count", {"angle"}));
        knobs.slider("texels_per_step", chosen_.texels_per_step, 0.25f, 8,
                     KnobHelp("texels of the mip level per step").only("count", {"texel"}));
        knobs.choice("refine", chosen_.refine, refinements,
                     KnobHelp("how the hit is found between the last two samples").only("view", {"one"}));
        knobs.steps("rounds", chosen_.rounds, 0, 8,
                    KnobHelp("rounds").only("refine", {"bisection", "secant", "illinois"}).titled("Refine rounds"));
        knobs.choice("mip", mip_, mips, KnobHelp("mip level that the march reads").titled("Mip level"));
        knobs.choice("lookup", lookup_, lookups,
                     KnobHelp("implicit: texture() chooses the level, a common mistake").titled("Texture lookup"));
        knobs.toggle("skip", skip_,
                     KnobHelp("skip marches that are too short to see, or over level ground").titled("Skip marches"));
        knobs.toggle("decal", decal_, "paint on a pane at the top of the relief");
        light_.knobs(knobs);
        surface_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame) const override {
        const auto exact = occlusion::truth(frame.probe, surface_.mesh(), surface_.mapping(), surface_.heights());
        if (!exact) return {};
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t) { return exact(part); });
    }

private:
    enum View { compare, one };
    enum Show { both, picture, error };
    enum Mip { base, footprint };
    enum Lookup { fixed_lod, implicit };
    enum Count { fixed, by_angle, by_texel };
    enum Refine { none, linear, bisection, secant, illinois };
    static constexpr std::array views = {"compare", "one"};
    static constexpr std::array shows = {"both", "picture", "error"};
    static constexpr auto counts =
        choices<Count>({{fixed, "fixed"}, {by_angle, "angle", "BY_ANGLE"}, {by_texel, "texel", "BY_TEXEL"}});
    static constexpr std::array refinements = {"none", "linear", "bisection", "secant", "illinois"};
    static constexpr std::array mips = {"base", "footprint"};
    static constexpr std::array lookups = {"fixed-lod", "implicit"};
    static constexpr glm::ivec2 measured{108, 108};

    struct Method {
        const char* title;
        int count;
        float steps, least_steps, texels_per_step;
        int refine, rounds;
    };
    static constexpr std::array<Method, 6> comparisons = {
        {{"8 steps", fixed, 8, 8, 1, linear, 0},
         {"8 to 32 by angle", by_angle, 32, 8, 1, linear, 0},
         {"64 steps", fixed, 64, 8, 1, linear, 0},
         {"8 + 2 secant", fixed, 8, 8, 1, secant, 2},
         {"16 + 5 bisections", fixed, 16, 8, 1, bisection, 5},
         {"1 in 2 texels + 2 secant", by_texel, 32, 8, 2, secant, 2}}};

    struct Figures {
        double mean = 0, wrong = 0, heights_read = 0;
        int pixels = 0;  ///< 0 before the tasks are written
    };
    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        if (view_ == one) return tiles_of(size, 1);
        return Labels::with_feet(
            size, tiles_of(size, int(comparisons.size()), show_ == picture ? 0 : Labels::scale_height(size)), 3, 31);
    }
    Method method_of(size_t tile) const {
        if (view_ == compare) return comparisons[tile];
        Method method = chosen_;
        method.steps = float(steps_), method.least_steps = float(std::min(steps_, least_steps_));
        return method;
    }

    void draw_part(const Frame& frame, const Tile& tile, const Tile& part, const Method& method,
                   const Define& purpose) {
        if (part.size.x <= 0 || part.size.y <= 0) return;
        use(frame_in(frame, tile), method, purpose);
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        glScissor(part.corner.x, part.corner.y, part.size.x, part.size.y);
        surface_.draw();
    }

    /// Returns the program for a frame and a method, in use and with all uniforms set.
    const Program& use(const Frame& frame, const Method& method, const Define& purpose, float level_bias = 0) {
        const Program& program =
            program_.with({purpose, mip_ == footprint ? "FOOTPRINT" : "", lookup_ == implicit ? "IMPLICIT" : "",
                           counts.define(method.count), fmt::format("REFINE {}", method.refine)});
        glUseProgram(program);
        surface_.set(program, frame);
        program.set("u_to_light", light_.direction());
        program.set("u_steps", method.steps);
        program.set("u_min_steps", method.least_steps);
        program.set("u_texels_per_step", method.texels_per_step);
        program.set("u_rounds", method.rounds);
        program.set("u_level_bias", level_bias);
        program.set("u_skip", skip_);
        if (skip_)
            program.set("s_bounds", 3, bounds_.get({surface_.version()}, [this] {
                return Texture("bounds", [this] { return min_max_atlas(surface_.heights()); }, {.mips = false});
            }));
        program.set("u_decal", decal_ ? 0.9f : 0.0f);
        surface_.set_exact_hit(program, 4);
        return program;
    }

    /// Returns the error and the work of a tile's method, measured in a picture of a fixed size by the frame's camera.
    /// So they depend on the height of the tile only if it chooses mip levels.
    const Figures& measure(size_t tile, const Frame& frame, int height) {
        const float level_bias = mip_ == footprint ? std::log2(float(measured.y) / float(std::max(1, height))) : 0;
        const Program& program = use(frame_in(frame, {{0, 0}, measured}), method_of(tile), "MEASURE", level_bias);
        return measured_[tile].get(
            {program, surface_.version(), frame.camera.orbit(), level_bias, surface_.mapping(), surface_.shape},
            [&] { return figures_of(draw_numbers(measured, [&] { surface_.draw(); })); });
    }

    static Figures figures_of(const Image& drawn) {
        Figures figures;
        for (size_t i = 0; i < drawn.pixel_count(); ++i) {
            const float* const pixel = drawn.values.data() + i * 4;
            if (!std::isfinite(pixel[3])) continue;  // background, or unfinished tasks
            ++figures.pixels;
            figures.mean += double(pixel[0]);
            figures.heights_read += double(pixel[1]);
            figures.wrong += pixel[0] > 1;
        }
        for (double* sum : {&figures.mean, &figures.wrong, &figures.heights_read}) *sum /= std::max(1, figures.pixels);
        return figures;
    }

    void describe(glm::ivec2 size, const Tile& tile, const Method& method, const Figures& figures) {
        labels_.caption(size, tile, 0, method.title);
        if (figures.pixels == 0) return;
        labels_.caption(
            size, tile, -2,
            fmt::format("off {} texels, {} % wrong", rounded(figures.mean), rounded(100 * figures.wrong, 2)));
        labels_.caption(size, tile, -1, rounded(figures.heights_read) + " taps", {0.72f, 0.73f, 0.75f});
    }

    Programs program_{"common/relief.vert", "11_parallax_occlusion/surface.frag"};
    ReliefSurface surface_;
    Kept<Texture, int> bounds_;  ///< by the surface's version
    std::array<Kept<Figures, GLuint, int, Orbit, float, ReliefMapping, int>, comparisons.size()> measured_;
    DistantLight light_;
    Studio studio_;
    Labels labels_;

    int view_ = compare, show_ = both, mip_ = base, lookup_ = fixed_lod, steps_ = 32, least_steps_ = 8;
    bool skip_ = true, decal_ = false;
    Method chosen_{"", fixed, 32, 8, 1, linear, 2};
};

RELIEF_LAB(ParallaxOcclusion);

}  // namespace relief
