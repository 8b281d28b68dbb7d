// Lab 17: time and error.
//
// A wall from the eye to the horizon, and one number to set: the budget, the error of the picture in pixels. Each patch
// and each pixel takes the cheapest method that keeps the budget. Your tasks: shaders/17_time_and_error/task.glsl
#include <fmt/format.h>

#include <bit>

#include "framework/core/base/text.h"
#include "framework/core/gl/vertex_stream.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/gpu_patches.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/relief_surface.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/uniforms.h"
#include "framework/library/mesh/shapes.h"
#include "methods.h"
#include "truth.h"

namespace relief::budget {

class TimeAndError final : public Lab {
public:
    TimeAndError() { surface_.material.asset_texels = 512, surface_.depth = 0.03f; }

    void draw(const Frame& frame) override {
        const std::vector<Tile> tiles = tiles_of_view(frame.size);
        // Measures first, in a framebuffer of its own.
        const bool is_measured = view_ != picture && !frame.probe;
        const Shares shares = is_measured ? shares_of_methods(frame_in(frame, tiles.back())) : Shares{};
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < tiles.size(); ++i) {
            const Tile& tile = tiles[i];
            const bool shows_methods = view_ == methods_only || i == 1;
            glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
            const Frame part = frame_in(frame, tile);
            const double reach = draw_wall(frame_budget(part), shows_methods);
            studio_.draw(part, tile, {}, plane_of_wall);
            if (std::isfinite(reach))
                labels_.caption(frame.size, tile, 1,
                                fmt::format("triangles coarser beyond {}", amount_of(reach, "metre", 2)));
            if (shows_methods)
                add_legend(labels_, frame.size, tile, shares);
            else
                labels_.caption(
                    frame.size, tile, 0,
                    method_ == automatic ? "budget " + amount_of(budget_, "pixel") : methods.names[size_t(method_)]);
        }
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.slider("budget", budget_, 0.25f, 16,
                     KnobHelp("tolerated error of the relief").in("pixels").titled("Error budget"));
        knobs.choice("view", view_, views.names, "the picture, the methods as colours, or both");
        knobs.choice("method", method_, methods.names, "the cheapest that keeps the budget, or one everywhere");
        knobs.toggle("spend", spend_,
                     KnobHelp("thin the relief by the budget; off: as in labs 11 to 13")
                         .only("method", {"parallax", "exact", "displacement"})
                         .titled("Spend budget"));
        knobs.group("Costs");
        knobs.slider("exact_taps", exact_taps_, 0, 1000, "taps of a march that take as long as an exact search");
        knobs.slider("triangle_taps", triangle_taps_, 0, 10000,
                     "taps that take as long as a triangle: on a graphics card a few");
        knobs.group("Surface");
        surface_.material.knobs(knobs);
        knobs.slider("depth", surface_.depth, 0, 0.25f, KnobHelp("depth of the relief").in("metres"));
        light_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame) const override {
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t) {
            return budget::truth(frame_budget(part), map_errors(), surface_.heights());
        });
    }

private:
    enum View { both, picture, methods_only };
    static constexpr auto views = choices<View>({{both, "both"}, {picture, "picture"}, {methods_only, "methods"}});
    static constexpr glm::ivec2 measured{96, 96};

    /// Returns the plane of the wall, which stands on the studio's floor.
    static Mesh plane_of_wall() {
        const glm::vec2 size = wall_high - wall_low, middle = (wall_high + wall_low) / 2.0;
        Mesh mesh = make_quad({.width = size.x, .height = size.y, .columns = 64, .rows = 4});
        for (Vertex& vertex : mesh.vertices) vertex.position += glm::vec3(middle, 0);
        return mesh;
    }

    std::vector<Tile> tiles_of_view(glm::ivec2 size) const {
        return view_ == both ? Labels::with_feet(size, tiles_of(size, 2), 2, 31) : tiles_of(size, 1);
    }

    const MapErrors& map_errors() const {
        return map_errors_.get({surface_.version()},
                               [this] { return MapErrors(surface_.heights(), surface_.material.normals()); });
    }

    /// `smaller`: the height of the frame divided by the height of the picture that it stands for. The budget in pixels
    /// and the cost of a triangle in taps are scaled down with it.
    FrameBudget frame_budget(const Frame& frame, double smaller = 1) const {
        // Thinning gets most of the budget, because it saves time in every method. The rest is the largest error of a
        // method on the thinned relief. So where two methods meet, their difference is within the budget, too.
        double thinning = 0.875, precision = 0.125;
        if (method_ != automatic && !spend_) {
            thinning = 0;
            precision = method_ - first_method == displacement ? 1 : 0;
        }
        return {.frame = frame,
                .pixels = budget_ * smaller,
                .scale = double(surface_.depth),
                .thinning = thinning,
                .precision = precision,
                .exact_taps = double(exact_taps_),
                .triangle_taps = triangle_taps_ * smaller * smaller};
    }

    /// Returns whether a probe asks every pixel for the inputs of its choice, even if its patch has only one method.
    static bool is_of_choice(const Probe& probe) {
        return probe.name == "pixels" || probe.name == "left" || probe.name == "level" || probe.name == "bumps";
    }

    /// Returns the patches with the methods that each is drawn with. If `shows_methods`, each pixel chooses its method
    /// itself and shows it.
    std::vector<Patch> patches_of(const FrameBudget& budget, bool shows_methods) const {
        const Probe& probe = budget.frame.probe;
        const Methods forced = method_ == automatic ? 0 : bit(Method(method_ - first_method));
        if (forced != 0 && forced != bit(displacement) && !is_of_choice(probe)) {
            if (budget.frame.camera.eye().z <= 0) return {};
            return {{.low = wall_low, .high = wall_high, .methods = forced, .may_leave = true}};
        }
        std::vector<Patch> patches = patches_for(budget, map_errors());
        for (Patch& patch : patches) {
            if (forced != 0) patch.methods = forced;
            if (is_of_choice(probe) || (probe.name == "method" && patch.methods != bit(displacement)))
                patch.methods = any_of_a_pixel;
            else if (!shows_methods)
                // The most expensive method replaces the others: its search ends at once in a relief that is thinned
                // to a plane.
                patch.methods = std::bit_floor(patch.methods);
        }
        return joined(patches);
    }

    /// Draws the patches, one draw call for each program. Returns the distance in metres beyond which displaced cells
    /// are coarser than the budget asks; infinity if none is.
    double draw_wall(const FrameBudget& budget, bool shows_methods) {
        double reach = INFINITY;
        const bool with_behind = !is_of_choice(budget.frame.probe);
        for (const auto& [group, corners] : groups_of(patches_of(budget, shows_methods), with_behind)) {
            bind(corners);
            const bool is_displaced = group.methods == bit(displacement);
            const Program& program = program_of(group, budget.frame.probe, shows_methods);
            glUseProgram(program);
            set(program, budget, is_displaced ? map_errors().pieces() : map_errors().levels);
            if (is_displaced) {
                reach = finest_reach(budget, map_errors(), corners);
                program.set("u_reach", reach);
                draw_patches(int(corners.size()) / 4, 4);
            } else {
                glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
            }
        }
        return reach;
    }

    /// Uploads the corners, and binds the vertex array that reads them.
    void bind(std::span<const glm::vec2> corners) {
        corners_.fill(corners);
        if (!layout_) corners_.attach(layout_.emplace());
        glBindVertexArray(*layout_);
    }

    const Program& program_of(const Group& group, const Probe& probe, bool shows_methods) const {
        const auto part = [&](Method method) {
            return group.methods & bit(method) ? methods.define(first_method + method) : "";
        };
        const Define purpose = probe ? Define(probe) : shows_methods ? "METHOD_COLORS" : "";
        const Define only =
            std::has_single_bit(group.methods) ? fmt::format("ONLY_METHOD {}", std::countr_zero(group.methods)) : "";
        return (group.methods == bit(displacement) ? displaced_ : flat_)
            .with({purpose, part(plain), part(normal_map), part(parallax), part(exact), part(displacement), only,
                   group.may_leave ? "MAY_LEAVE" : ""});
    }

    /// Sets the uniforms. `errors` are piece_errors() if the program displaces, and otherwise level_errors().
    /// Precondition: the program is in use.
    void set(const Program& program, const FrameBudget& budget, const std::vector<float>& errors) {
        const MapErrors& maps = map_errors();
        const glm::dmat4 clip_from_world = budget.frame.camera.clip_from_world();
        surface_.material.set(program);
        surface_.set_exact_hit(program, 3);
        program.set("u_clip_from_world", clip_from_world);
        program.set("u_clip_along", glm::vec4(clip_from_world * glm::dvec4(0, 0, 1, 0)));
        program.set("u_eye", budget.frame.camera.eye());
        program.set("u_to_light", light_.direction());
        program.set("u_border", glm::vec4(wall_low, wall_high));
        program.set("u_size", glm::vec2(budget.frame.size));
        program.set("u_first_level", first_level(budget, maps));
        program.set("u_budget", budget.pixels);
        set_each<float>(program, "u_shares", std::array{budget.thinning, budget.precision});
        program.set("u_scale", budget.scale);
        program.set("u_range", maps.range);
        program.set("u_exact_taps", budget.exact_taps);
        program.set("u_levels", int(errors.size()));
        set_each<float>(program, "u_errors", errors);
        program.set("u_texels", float(maps.texels));
        program.set("u_normal_strength", glm::vec2(surface_.depth / ReliefMaterial::normals_depth));
        program.set("u_flat_level", maps.flat_level);
        program.set("u_flat_normal", maps.flat_normal);
        set_each<glm::vec3>(program, "u_colors", colors);
    }

    /// Returns the share of each method, measured on a small copy of the picture. The budget and the cost of a triangle
    /// are scaled down with it, so that each place gets the same method. Returns nothing before the tasks are written.
    Shares shares_of_methods(Frame frame) {
        const double smaller = double(measured.y) / std::max(1, frame.size.y);
        frame.size = measured;
        frame.probe = {"method", MissingTask::told};
        const Image drawn = draw_numbers(measured, [&] { draw_wall(frame_budget(frame, smaller), false); });
        return shares_in(drawn);
    }

    Programs flat_{"17_time_and_error/wall.vert", "17_time_and_error/surface.frag"};
    Programs displaced_{"17_time_and_error/cell.vert", "17_time_and_error/wall.tesc", "17_time_and_error/wall.tese",
                        "17_time_and_error/surface.frag"};
    ReliefSurface surface_;
    mutable Kept<MapErrors, int> map_errors_;  ///< by the surface's version
    std::optional<VertexArrayName> layout_;
    VertexStream corners_{{{0, 2, GL_FLOAT, 0}}};
    Studio studio_;
    Labels labels_;

    int view_ = both, method_ = automatic;
    bool spend_ = false;
    float budget_ = 1, exact_taps_ = 5, triangle_taps_ = 1000;
    DistantLight light_{-60, 30};
};

RELIEF_LAB(TimeAndError);

}  // namespace relief::budget
