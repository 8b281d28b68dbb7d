// Lab 03: height to normal.
//
// A normal map from a height map, by six filters. Heights are exact or rounded to 8 bits, and borders wrap or end.
// Your tasks: shaders/03_height_to_normal/task.glsl
#include <fmt/format.h>

#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/mips.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/made_map.h"
#include "framework/library/kit/studio.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/mesh/shapes.h"
#include "heights.h"
#include "map.h"
#include "settings.h"
#include "truth.h"

namespace relief::heights {

class HeightToNormal final : public Lab, public MapMaker, public Paintable {
public:
    void draw(const Frame& frame) override {
        const auto tiles = tiles_of_view(frame.size);
        Maps& maps = maps_for(tiles.size());
        for (size_t i = 0; i < tiles.size(); ++i) {
            if (!maps.normals.contains(filter_of(i)))
                maps.normals.emplace(filter_of(i), make_normals(filter_of(i), maps.heights));
            if (settings_.is_derived() && !frame.probe)
                derived(maps, filter_of(i));  // reads maps back, which changes bindings
        }
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        for (size_t i = 0; i < tiles.size(); ++i) {
            draw_wall(frame_in(frame, tiles[i]), tiles[i], maps, filter_of(i));
            const glm::vec2 wall(settings_.wall());
            studio_.draw(frame_in(frame, tiles[i]), tiles[i], {wall.x, wall.y},
                         [wall] { return make_quad({.width = 2 * wall.x, .height = 2 * wall.y}); });
            describe(frame.size, tiles[i], filter_of(i), maps.normals.at(filter_of(i)).error);
        }
        if (shows_error()) labels_.scale(frame.size, "0.001~", "10~", 4);
        labels_.notes(notes_of_files(*this));
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override { settings_.knobs(knobs); }

    std::optional<Image> truth(const Frame& frame) const override {
        Image map;
        if (frame.probe.name == "normal" && has_known_slope()) map = exact_image();
        if (frame.probe.name == "height")
            map = paint_.on(settings_.has_colors() ? heights_by_cpu(settings_.color_picture())
                                                   : settings_.stored_heights());
        if (map.values.empty()) return {};
        return truth_in_tiles(frame, tiles_of_view(frame.size), [&](const Frame& part, size_t) {
            return on_wall(part, map, settings_.wall(), settings_.repeat);
        });
    }

    /// Returns the normals by the filter of the knob, green up.
    std::optional<Image> made_map() override {
        Maps& maps = maps_for(tiles_of_view({1, 1}).size());
        if (!maps.normals.contains(settings_.filter))
            maps.normals.emplace(settings_.filter, make_normals(settings_.filter, maps.heights));
        const Map& map = maps.normals.at(settings_.filter);
        if (settings_.map.where == MapSettings::gpu && !map.is_written())
            throw Error("the map is not written yet: see the tasks of this lab");
        Image normals = map.read(3);
        for (float& value : normals.values) value = 0.5f + 0.5f * value;
        return normals;
    }

    std::optional<glm::dvec2> place_on_map(const Frame& frame, glm::dvec2 pixel) const override {
        for (const Tile& tile : tiles_of_view(frame.size)) {
            const glm::dvec2 at = pixel - glm::dvec2(tile.corner.x, frame.size.y - tile.corner.y - tile.size.y);
            if (at.x < 0 || at.y < 0 || at.x >= tile.size.x || at.y >= tile.size.y) continue;
            const Frame part = frame_in(frame, tile);
            const glm::dvec2 in_clip = at / glm::dvec2(tile.size) * 2.0 - 1.0;
            return place_on_wall(part.camera.ray({in_clip.x, -in_clip.y}), settings_.wall(), settings_.repeat);
        }
        return {};
    }
    void paint(const Dab& dab) override { paint_.add(dab, painted_heights(), settings_.map.wrap); }
    PaintLayer& paint_layer() override { return paint_; }
    Image painted_heights() override { return maps_for(tiles_of_view({1, 1}).size()).heights.read(1); }

private:
    /// The maps for one setting of the knobs in MapSettings.
    struct Maps {
        Map heights;
        Texture truth;                                        ///< exact normals
        std::map<int, Map> normals;                           ///< by filter; made when they are first shown
        std::map<std::pair<int, int>, Texture> derived = {};  ///< by the knob `show` and filter
    };

    std::vector<Tile> tiles_of_view(glm::ivec2 frame) const {
        const int below = shows_error() ? Labels::scale_height(frame) : 0;
        if (settings_.view == Settings::one) return tiles_of(frame, 1, below);
        return Labels::with_feet(frame, tiles_of(frame, int(Settings::filters.size()), below), shows_error() ? 2 : 1,
                                 24);
    }
    /// Paint has no formula.
    bool has_known_slope() const { return settings_.map.has_known_slope() && paint_.is_empty(); }
    bool shows_error() const { return settings_.shows_error() && paint_.is_empty(); }
    int filter_of(size_t tile) const { return settings_.view == Settings::one ? settings_.filter : int(tile); }

    // ---- the maps

    /// Returns the maps of the present knobs, made again if these or a program have changed.
    Maps& maps_for(size_t tiles) {
        return maps_.get({programs_of_maps(tiles), settings_.map, settings_.own.version(), paint_.version()}, [this] {
            return Maps{make_heights(), table([this] { return exact_image(); }), {}};
        });
    }

    static Texture table(std::function<Image()> make) {
        return Texture("table", std::move(make), {.wrap = Wrap::clamp, .mips = false});
    }
    Image exact_image() const { return exact_normals(settings_.map.size(), settings_.map.texels()); }

    const Program& normals_program(int filter) const { return normals_program_.with(Settings::filters.define(filter)); }
    /// Returns the programs that fill the maps. A program changes when its shader is saved, and then its maps are made
    /// again.
    std::vector<GLuint> programs_of_maps(size_t tiles) const {
        std::vector<GLuint> programs;
        if (settings_.has_colors()) programs.push_back(heights_program_.with());
        for (size_t i = 0; i < tiles && settings_.map.where == MapSettings::gpu; ++i)
            programs.push_back(normals_program(filter_of(i)));
        return programs;
    }

    Map make_heights() {
        Map heights(settings_.map.size(), GL_R32F);
        if (!settings_.has_colors()) {
            heights.fill(paint_.on(settings_.stored_heights()));
            return heights;
        }
        const Program& program = heights_program_.with();
        glUseProgram(program);
        const Texture picture = table([this] { return settings_.color_picture(); });
        program.set("s_picture", 0, picture);
        heights.fill(window_);
        if (!paint_.is_empty()) heights.fill(paint_.on(heights.read(1)));
        return heights;
    }

    Map make_normals(int filter, const Map& heights) {
        Map map(settings_.map.size(), GL_RGBA32F);
        const bool by_cpu = settings_.map.where == MapSettings::cpu;
        if (!by_cpu) {
            draw_normals(filter, heights, map);
        } else {
            if (!normals_by_cpu)
                throw Error("the CPU's normals are not in this course: they are what task 3.1 asks for");
            map.fill(normals_by_cpu(heights.read(1), {.texels_u = settings_.map.texels().x,
                                                      .texels_v = settings_.map.texels().y,
                                                      .filter = SlopeFilter(filter),
                                                      .wrap = settings_.map.wrap}));
        }
        if (has_known_slope() && (by_cpu || map.is_written()))
            map.error = summarize(error_image(map.read(3), exact_image(), ErrorMetric::angle));
        return map;
    }

    void draw_normals(int filter, const Map& heights, const Map& map) {
        const auto option = SlopeFilter(filter);
        const int size = settings_.map.size();
        const Program& program = normals_program(filter);
        glUseProgram(program);
        const Texture differences = table([&] { return slope_table(option, size, settings_.map.wrap); });
        program.set("u_differences", option == SlopeFilter::spline ? size : 4);
        program.set("u_beside", weight_beside(option));
        program.set("u_wrap", settings_.map.wrap);
        program.set("u_texels", glm::vec2(settings_.map.texels()));
        program.set("s_differences_u", 1, differences);
        program.set("s_differences_v", 1, differences);
        program.set("s_heights", 0), heights.bind(0);
        map.fill(window_);
    }

    /// Returns the occlusion or gloss map of the heights or normals, made when it is first asked for.
    const Texture& derived(Maps& maps, int filter) const {
        const std::pair key(settings_.show, settings_.show == Settings::gloss ? filter : 0);
        if (const auto found = maps.derived.find(key); found != maps.derived.end()) return found->second;
        if (settings_.show == Settings::occlusion && !open_to_the_sky)
            throw Error("how open a place is to the sky is not in this course: it is what task 16.5 asks for");
        Image made = settings_.show == Settings::gloss
                         ? gloss_of(maps.normals.at(filter).read(3), 64)
                         : open_to_the_sky(maps.heights.read(1), settings_.map.texels().y);
        return maps.derived.emplace(key, table([made = std::move(made)] { return made; })).first->second;
    }

    // ---- the picture

    void draw_wall(const Frame& frame, const Tile& tile, Maps& maps, int filter) const {
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        const Map& map = maps.normals.at(filter);
        const bool show_error = shows_error() && map.error.count > 0 && !frame.probe,
                   show_derived = settings_.is_derived() && !frame.probe;
        const Program& program =
            wall_program_.with({frame.probe, show_error || show_derived ? Settings::shows.define(settings_.show) : ""});
        glUseProgram(program);
        program.set("u_clip_from_world", frame.camera.clip_from_world());
        program.set("u_eye", frame.camera.eye());
        const float yaw_rad = glm::radians(settings_.light_yaw);
        program.set("u_light",
                    glm::vec3(2 * std::sin(yaw_rad), settings_.light_height, 0.6f + 0.8f * std::cos(yaw_rad)));
        program.set("u_wall", glm::vec2(settings_.wall()));
        program.set("u_repeat", float(settings_.repeat));
        if (show_error) {
            program.set("u_split", settings_.show == Settings::half_and_half ? 0.5f : 0.0f);
            program.set("s_truth", 2, maps.truth);
        }
        if (show_derived) program.set("s_derived", 3, derived(maps, filter));
        program.set("s_heights", 1), maps.heights.bind(1);
        program.set("s_normals", 0), map.bind(0);
        glBindVertexArray(quad_.layout());
        glDrawElements(GL_TRIANGLES, quad_.count(), GL_UNSIGNED_INT, nullptr);
    }

    void describe(glm::ivec2 size, const Tile& tile, int filter, const ErrorSummary& error) {
        labels_.caption(size, tile, 0, Settings::filters.names[size_t(filter)]);
        if (error.count > 0 && !settings_.is_derived())
            labels_.caption(size, tile, -1,
                            fmt::format("mean {}~ max {}~", rounded(error.mean, 2), rounded(error.largest, 2)));
    }

    Settings settings_;
    Programs heights_program_{"common/window.vert", "03_height_to_normal/heights.frag"};
    Programs normals_program_{"common/window.vert", "03_height_to_normal/normals.frag"};
    Programs wall_program_{"03_height_to_normal/wall.vert", "03_height_to_normal/wall.frag"};
    GpuMesh quad_ = upload([] { return make_quad({.width = 2, .height = 2}); });
    WindowTriangle window_;
    Studio studio_;
    Labels labels_;
    PaintLayer paint_;
    /// By programs, knobs, and versions of the own picture and of the paint.
    Kept<Maps, std::vector<GLuint>, MapSettings, int, int> maps_;
};

RELIEF_LAB(HeightToNormal);

}  // namespace relief::heights
