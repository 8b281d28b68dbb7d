// Lab 13: displacement by tessellation.
//
// The tessellator divides each patch into triangles, and the evaluation shader displaces their vertices: the relief is
// real, up to its outline. Your tasks: shaders/13_displacement/task.glsl
#include <fmt/format.h>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/displaced_surface.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/shadow_map.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "truth.h"

namespace relief {

class Displacement final : public Lab {
public:
    Displacement() {
        surface_.density = 4;
        surface_.material.map = ReliefMap::stones;
        surface_.material.size = ReliefMaterial::texels_256;
        surface_.most_density = 32;  // at level 64 a sphere of this density has 12 million triangles
    }

    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const bool is_count = frame.probe.name == "winding";
        if (is_count) DisplacedSurface::begin_winding();
        const auto tiles = tiles_of_view(frame.size);
        for (size_t i = 0; i < tiles.size(); ++i) {
            const Method method = method_of(i);
            const Frame part = frame_in(frame, tiles[i]);
            if (shadow_ && has_shadow(frame.probe)) draw_shadow(part, method);
            glViewport(tiles[i].corner.x, tiles[i].corner.y, tiles[i].size.x, tiles[i].size.y);
            if (frame.probe) {
                draw_surface(part, method, frame.probe);
                continue;
            }
            glPolygonOffset(1, 1);
            glEnable(GL_POLYGON_OFFSET_FILL);  // so that lines are in front
            const int triangles = draw_surface(part, method, "");
            glDisable(GL_POLYGON_OFFSET_FILL);
            studio_.draw(part, tiles[i], surface_.studio_inputs(), [this] { return surface_.mesh_on_floor(); });
            if (show_ != light) draw_wire(part, tiles[i], method, triangles);
            if (view_ != one) describe(frame.size, tiles[i], method, triangles);
            if (const float most = std::max(method.level, inside_of(method)); bounded(most) < most)
                labels_.caption(frame.size, tiles[i], 1, fmt::format("levels up to {:.0f}", bounded(most)));
        }
        if (is_count) DisplacedSurface::end_winding();
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views,
                     "levels side by side, a normal map beside the knobs' surface, its spacings, or only that surface");
        knobs.choice("show", show_, shows, "the light, the triangles, or half of each");
        knobs.group("Tessellation");
        KnobsOnly of_chosen(knobs, "view", {"beside", "spacings", "one"});
        of_chosen.slider("level", chosen_.level, 1, 64, KnobHelp("segments of each edge").titled("Edge level"));
        of_chosen.slider("inside", inside_, 0, 64,
                         KnobHelp("segments of the inside; 0: as along the edges").titled("Inside level"));
        of_chosen.choice("spacing", chosen_.spacing, DisplacedSurface::spacings,
                         KnobHelp("positions of the vertices at a fractional level").only("view", {"beside", "one"}));
        of_chosen.choice("mip", chosen_.mip, mips, KnobHelp("mip level that a vertex reads").titled("Mip level"));
        of_chosen.choice("normals", chosen_.normals, normal_names, "source of the normals");
        light_.knobs(knobs);
        knobs.toggle("shadow", shadow_, "the surface casts a shadow on itself");
        knobs.slider("shadow_level", shadow_level_, 0, 64,
                     KnobHelp("segments of each edge in the shadow map; 0: as in the picture").only("shadow", {"on"}));
        surface_.knobs(knobs);
        knobs.toggle("packed", surface_.material.packed,
                     KnobHelp("height, gloss and occlusion from one texture")
                         .only("map", {"wall", "paving"})
                         .titled("Packed maps"));
    }

    std::optional<Image> truth(const Frame& frame) const override {
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t) {
            return displacement::truth(part, surface_, light_.direction<double>());
        });
    }

private:
    enum View { compare, beside, spacing, one };
    enum Show { light, half, wire };
    enum Mip { level_0, by_level };
    enum Normals { base, map, heights, surface };
    static constexpr std::array views = {"compare", "beside", "spacings", "one"};
    static constexpr std::array shows = {"light", "half-and-half", "wire"};
    static constexpr std::array mips = {"base", "level"};
    static constexpr std::array normal_names = {"base", "map", "heights", "surface"};

    struct Method {
        const char* title;
        float level;
        int spacing, mip, normals;
        bool is_flat;
    };
    static constexpr std::array<Method, 6> comparisons = {{{"a normal map", 1, 0, by_level, map, true},
                                                           {"level 4", 4, 0, by_level, surface, false},
                                                           {"level 8", 8, 0, by_level, surface, false},
                                                           {"level 16", 16, 0, by_level, surface, false},
                                                           {"8, map level 0", 8, 0, level_0, surface, false},
                                                           {"16, base normals", 16, 0, by_level, base, false}}};

    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        constexpr std::array counts = {int(comparisons.size()), 2, int(DisplacedSurface::spacings.size()), 1};
        return tiles_of(size, counts[size_t(view_)]);
    }
    Method method_of(size_t tile) const {
        if (view_ == compare) return comparisons[tile];
        if (view_ == beside && tile == 0) return comparisons[0];
        Method method = chosen_;
        method.title = "displaced";
        if (view_ == spacing) {
            method.spacing = int(tile);
            method.title = DisplacedSurface::spacings[tile];
        }
        return method;
    }

    float inside_of(const Method& method) const {
        return inside_ > 0 && view_ != compare && !method.is_flat ? inside_ : method.level;
    }

    void draw_wire(const Frame& frame, const Tile& tile, const Method& method, int triangles) {
        // Lines fade where triangles are so small that lines would hide them. The side of a triangle is estimated: half
        // of the triangles face the eye, and cover half of the tile.
        const float side = std::sqrt(2 * float(tile.size.x) * float(tile.size.y) / float(std::max(1, triangles)));
        const float opacity = std::clamp((side - 4) / 10, show_ == wire ? 0.2f : 0.0f, 1.0f);
        if (opacity == 0) return;
        glBlendColor(0, 0, 0, opacity);
        glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
        glEnable(GL_BLEND);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glEnable(GL_SCISSOR_TEST);
        const int left = show_ == half ? tile.size.x / 2 : 0;
        glScissor(tile.corner.x + left, tile.corner.y, tile.size.x - left, tile.size.y);
        draw_surface(frame, method, "WIRE");
        glDisable(GL_SCISSOR_TEST);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        glDisable(GL_BLEND);
    }

    static std::string grouped(int count) {
        return count < 10000 ? fmt::format("{}", count) : fmt::format("{},{:03}", count / 1000, count % 1000);
    }
    void describe(glm::ivec2 size, const Tile& tile, const Method& method, int triangles) {
        labels_.caption(size, tile, 0, method.title);
        labels_.caption(size, tile, -1, grouped(triangles) + " triangles", {0.62f, 0.63f, 0.65f});
    }

    /// Clamps a level so that the whole picture stays within its limit of triangles.
    float bounded(float level) const {
        const int tiles = int(tiles_of_view({1, 1}).size()), passes = (show_ == light ? 1 : 2) + (shadow_ ? 1 : 0);
        return std::min(level, surface_.most_level(tiles * passes));
    }

    /// Returns whether a picture, or a probe, reads the shadow map.
    static bool has_shadow(const Define& purpose) { return purpose.text.empty() || purpose.text == "PROBE_shadow"; }

    /// Puts the surface's program into use, with all uniforms but those of the shadow.
    const Program& use_program(const Frame& frame, const Method& method, const Define& purpose) {
        const Program& program = program_.with(
            {purpose, surface_.corners_define(), DisplacedSurface::spacing_define(method.spacing),
             fmt::format("NORMALS {}", method.normals), method.mip == by_level ? "MIP" : "",
             shadow_ && has_shadow(purpose) ? "SHADOW" : "", surface_.material.is_packed() ? "PACKED" : ""});
        glUseProgram(program);
        surface_.set(program, frame);
        if (method.is_flat) program.set("u_scale", 0.0f);
        program.set("u_level", bounded(method.level));
        program.set("u_inside", bounded(inside_of(method)));
        program.set("u_to_light", light_.direction());
        program.set("u_wire", glm::vec3(0.93f, 0.86f, 0.62f));
        return program;
    }

    /// Draws the depth map of the surface, then returns to the frame's target.
    void draw_shadow(const Frame& frame, const Method& method) {
        Method cast = method;
        if (shadow_level_ > 0 && !method.is_flat) cast.level = shadow_level_;
        const auto [low, high] = surface_.box_around();
        shadow_map_.draw(light_.direction<double>(), low, high, [&](const glm::dmat4& clip_from_model) {
            use_program(frame, cast, "DEPTH").set("u_clip_from_model", clip_from_model);
            surface_.draw();
        });
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
    }

    /// Draws the surface. Returns the number of triangles for a picture, and 0 for a probe or lines.
    int draw_surface(const Frame& frame, const Method& method, const Define& purpose) {
        const Program& program = use_program(frame, method, purpose);
        if (shadow_ && has_shadow(purpose)) shadow_map_.set(program, 3);
        if (surface_.is_one_sided() && purpose.text != "PROBE_winding") glEnable(GL_CULL_FACE);
        // Counting waits for the GPU, and only a picture has a caption. The caller of a probe may have a query running.
        int triangles = 0;
        if (purpose.text.empty())
            triangles = surface_.draw_and_count();
        else
            surface_.draw();
        glDisable(GL_CULL_FACE);
        return triangles;
    }

    Programs program_{"common/patch.vert", "13_displacement/patch.tesc", "13_displacement/surface.tese",
                      "13_displacement/surface.frag"};
    DisplacedSurface surface_;
    ShadowMap shadow_map_;
    Studio studio_;
    Labels labels_;

    int view_ = compare, show_ = half;
    Method chosen_{"", 16, 0, by_level, surface, false};
    float inside_ = 0;
    DistantLight light_;
    bool shadow_ = false;
    float shadow_level_ = 0;
};

RELIEF_LAB(Displacement);

}  // namespace relief
