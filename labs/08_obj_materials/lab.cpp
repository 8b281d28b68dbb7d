// Lab 08: OBJ materials.
//
// A garden wall at dusk, from an OBJ file and its materials. The material of a surface decides its program, its place
// in the drawing order, and how much of a pixel it covers. Features that it does not name are neither compiled nor
// fetched. Your tasks: labs/08_obj_materials/task.cpp and shaders/08_obj_materials/task.glsl
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "captions.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/light_target.h"
#include "framework/core/kit/kept.h"
#include "framework/core/kit/labels.h"
#include "framework/core/kit/numbers.h"
#include "framework/core/kit/tiles.h"
#include "framework/core/kit/window_triangle.h"
#include "framework/core/lab/lab.h"
#include "mask_levels.h"
#include "surfaces.h"
#include "truth.h"

namespace relief::materials {

class ObjMaterials final : public Lab {
public:
    void draw(const Frame& frame) override {
        if (view_ == levels)
            levels_.draw(frame, labels_, surfaces_.alpha, surfaces_.threshold);
        else if (view_ == lamp_cut)
            draw_lamp(frame);
        else if (frame.probe && frame.probe.name != "color")
            draw_probe(frame);
        else
            draw_light(frame);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, view_names,
                     "the garden and its programs; or one picture, filters, mip levels, the lamp");
        knobs.choice("file", file_, files, "the OBJ file");
        knobs.choice("maps", maps_, map_choices,
                     "read the maps that materials name; with and without them side by side; or without normals only");
        knobs.toggle("normal_maps", switches_.normals,
                     "for maps = on, wipe and wipe-normals: read normals and heights");
        knobs.toggle("specular_maps", switches_.highlights, "for maps = on, wipe and wipe-normals: read highlights");
        knobs.toggle("mask_maps", switches_.masks, "for maps = on, wipe and wipe-normals: read masks");
        knobs.choice("programs", surfaces_.program_kind, Surfaces::program_kinds.names,
                     "a program for each set of features, or one with branches");
        knobs.steps("highlight", surfaces_.highlight, 0, 12, "show this material alone in its light; 0: all");
        knobs.choice("filter", surfaces_.filter, Surfaces::filters.names, "how the colours of maps are read");
        knobs.group("Glass and masks");
        knobs.choice("order", surfaces_.order, Surfaces::orders,
                     "order of the surfaces; weighted: glass in any order, blended by weights");
        knobs.choice("blend_in", surfaces_.blend_in, Surfaces::blend_spaces.names,
                     "blend light, or the values that sRGB stores");
        knobs.choice("alpha", surfaces_.alpha, Surfaces::alphas.names, "what a mask does with a pixel");
        knobs.slider("threshold", surfaces_.threshold, 0.05f, 0.95f, "for alpha = test: what is above it stays");
        knobs.slider("fence", surfaces_.fence, 0.5f, 8, "tiles of wire to one of the file's");
        lights_.knobs(knobs);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        const Lights lights = lights_.lights();
        if (view_ == lamp_cut) {
            if (probe.name != "lamp" || !true_share) return {};
            return image_of_values(frame.size, [&](int x, int y) {
                const glm::dvec2 off = (glm::dvec2(x, frame.size.y - 1 - y) + 0.5 - glm::dvec2(frame.size) / 2.0) *
                                       metres_per_pixel(frame.size);
                return glm::dvec4(true_share(lights, lights.place + glm::dvec3(off, 0)).value_or(0), 0, 0, 0);
            });
        }
        if (view_ == levels) {
            const auto share = true_coverage(MaskLevels::mask);
            if (probe.name != "coverage" || !share) return {};
            return image_of_values(frame.size, [&](int, int) { return glm::dvec4(*share, 0, 0, 0); });
        }
        const bool has_maps = maps_ != maps_off;
        return materials::truth(frame_in(frame, whole(frame)), probe,
                                {drawn(has_maps ? chosen : none).scene, has_maps, lights, double(surfaces_.fence)});
    }

private:
    enum ViewKind { garden, one, ground, levels, lamp_cut };
    enum File { garden_file, fence_file, ground_file, broken_file, thousand, lawn };
    enum MapChoice { maps_on, maps_off, wipe, wipe_normals };
    /// The maps of a view: none, those that are switched on, or these without normals and heights.
    enum Read { none, chosen, without_normals };
    static constexpr std::array view_names = {"garden", "one", "ground", "levels", "lamp"};
    static constexpr std::array files = {"garden", "fence", "ground", "broken", "thousand", "lawn"};
    static constexpr std::array map_choices = {"on", "off", "wipe", "wipe-normals"};
    static constexpr int samples_of_pictures = 4;

    /// A part of the picture.
    struct View {
        Tile tile;  ///< the camera's picture
        Tile part;  ///< part of the tile that is drawn
        Read maps = chosen;
        bool is_flat = false;  ///< drawn in the colours of the programs
    };
    /// The filters that the view `ground` compares.
    struct Comparison {
        Surfaces::Filter filter;
        const char* title;
    };
    static constexpr std::array<Comparison, 4> comparisons = {{{Surfaces::nearest, "nearest texel"},
                                                               {Surfaces::mips, "mip levels"},
                                                               {Surfaces::taps_4, "4 taps"},
                                                               {Surfaces::taps_16, "16 taps"}}};

    DrawnScene& drawn(Read read) const {
        MapSwitches maps = read == none ? no_maps : switches_;
        if (read == without_normals) maps.normals = false;
        return *scenes_[read].get({file_, maps}, [&] {
            ObjModel model = file_ == thousand
                                 ? thousand_tiles()
                                 : read_obj(course_root() / "assets" / (std::string(files[size_t(file_)]) + ".obj"));
            return std::make_unique<DrawnScene>(make_scene(std::move(model), maps, kind_of));
        });
    }

    static Tile whole(const Frame& frame) { return {{0, 0}, frame.size}; }

    std::vector<View> views_of(const Frame& frame) const {
        if (frame.probe) return {{.tile = whole(frame), .part = whole(frame), .maps = read()}};
        std::vector<View> all;
        if (view_ == ground) {
            for (const Tile& tile : tile_grid(frame.size, 2, 2)) all.push_back({.tile = tile, .part = tile});
            return all;
        }
        Tile left = whole(frame);
        if (view_ == garden) {
            left.size.x = frame.size.x * 7 / 10;
            const glm::ivec2 corner(left.size.x, frame.size.y - frame.size.y * 4 / 10);
            const Tile right{corner, frame.size - corner};
            all.push_back({.tile = right, .part = right, .maps = read(), .is_flat = true});
        }
        Tile with = left, without = left;
        if (is_wipe()) with.size.x /= 2, without.corner.x += with.size.x, without.size.x -= with.size.x;
        if (maps_ != maps_off) all.push_back({.tile = left, .part = with, .maps = chosen});
        if (maps_ != maps_on)
            all.push_back({.tile = left, .part = without, .maps = maps_ == wipe_normals ? without_normals : none});
        return all;
    }
    Read read() const { return maps_ == maps_off ? none : chosen; }
    bool is_wipe() const { return maps_ == wipe || maps_ == wipe_normals; }

    /// Draws a property of the surfaces.
    void draw_probe(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        if (frame.probe.name == "layers") glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        surfaces_.draw(frame_in(frame, whole(frame)), drawn(read()),
                       {.pass = Pass::probe, .filter = surfaces_.filter, .lights = lights_.lights()});
    }

    /// Draws the views into a target of floats, so that glass is blended as light, and encodes the sum at the end.
    void draw_light(const Frame& frame) {
        const std::vector<View> views = views_of(frame);
        begin_light(frame);
        glEnable(GL_SCISSOR_TEST);
        for (size_t i = 0; i < views.size(); ++i) {
            const auto& [tile, part, maps, is_flat] = views[i];
            if (tile.size.x <= 0 || tile.size.y <= 0) continue;
            glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
            glScissor(part.corner.x, part.corner.y, part.size.x, part.size.y);
            draw_sky(frame_in(frame, tile), is_flat);
            surfaces_.draw(frame_in(frame, tile), drawn(maps),
                           {.pass = is_flat ? Pass::flat : Pass::light,
                            .filter = view_ == ground && !frame.probe ? comparisons[i].filter : surfaces_.filter,
                            .lights = lights_.lights(),
                            .target = &*target_});
        }
        glDisable(GL_SCISSOR_TEST);
        encode(frame);
        if (!frame.probe) describe(frame, views);
    }

    bool is_weighted() const { return surfaces_.order == Surfaces::weighted; }

    /// Begins to draw into the target of floats. Weighted glass has two attachments of its own: the weighted sum of its
    /// light, and the share of the light behind it that passes.
    void begin_light(const Frame& frame) {
        const int samples = frame.probe ? 1 : samples_of_pictures, attachments = is_weighted() ? 3 : 1;
        const std::tuple wanted(frame.size, samples, attachments);
        if (!target_ || wanted != target_is_for_) {
            target_.reset();
            target_.emplace(frame.size, samples, attachments), target_is_for_ = wanted;
        }
        if (is_weighted()) {
            target_->begin(1, 2);
            constexpr float nothing[] = {0, 0, 0, 0}, all[] = {1, 1, 1, 1};
            glClearBufferfv(GL_COLOR, 0, nothing), glClearBufferfv(GL_COLOR, 1, all);
        }
        target_->begin();
        glClear(GL_DEPTH_BUFFER_BIT);
    }

    void draw_sky(const Frame& frame, bool is_flat) {
        const Program& program = sky_.with(Surfaces::blend_spaces.define(surfaces_.blend_in));
        glUseProgram(program);
        const glm::dmat4 view = frame.camera.view_from_world();
        const auto row = [&](int i) { return glm::dvec3(view[0][i], view[1][i], view[2][i]); };
        const double up = std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2);
        program.set("u_forward", -row(2));
        program.set("u_right", row(0) * (up * frame.size.x / frame.size.y));
        program.set("u_up", row(1) * up);
        program.set("u_to_sun", lights_.distant.direction());
        program.set("u_day", lights_.lamp == sun && !is_flat ? 1.0f : 0.0f);
        glDepthMask(GL_FALSE);
        window_.draw();
        glDepthMask(GL_TRUE);
    }

    void encode(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        const Program& program =
            encode_.with({frame.probe, fmt::format("SAMPLES {}", target_->samples()), is_weighted() ? "WEIGHTED" : "",
                          Surfaces::blend_spaces.define(surfaces_.blend_in)});
        glUseProgram(program);
        for (int i = 0; i < (is_weighted() ? 3 : 1); ++i) {
            program.set(std::array{"s_light", "s_sum", "s_passed"}[size_t(i)], i);
            target_->bind(i, i);
        }
        window_.draw();
    }

    /// Draws a vertical section through the lamp's light.
    void draw_lamp(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        const Program& program = cut_.with(frame.probe);
        glUseProgram(program);
        set_lamp(program, lights_.lights());
        program.set("u_middle", glm::vec2(frame.size) / 2.0f);
        program.set("u_pixel", metres_per_pixel(frame.size));
        window_.draw();
    }

    static double metres_per_pixel(glm::ivec2 size) { return 5.0 / std::max(1, std::min(size.x, size.y)); }

    void describe(const Frame& frame, const std::vector<View>& views) {
        const Scene& scene = drawn(read()).scene;
        if (view_ == ground)
            for (size_t i = 0; i < views.size(); ++i) {
                labels_.caption(frame.size, views[i].tile, 0, comparisons[i].title);
                if (const double error = measure(i); std::isfinite(error))
                    labels_.caption(frame.size, views[i].tile, -1, fmt::format("{:.1f} % off", 100 * error));
            }
        if (view_ == garden) list_materials(labels_, frame.size, views[0].tile, scene, surfaces_.highlight);
        if (view_ == garden && is_wipe()) {
            const float middle = float(views[1].part.size.x);
            labels_.rectangle({middle - 0.5f, 0}, {1, float(frame.size.y)}, {1, 1, 1, 0.4f});
        }
        if (file_ == ground_file || file_ == broken_file || file_ == lawn) write_notes(labels_, frame.size, scene);
    }

    /// Returns the mean error of a compared filter's colours, relative to 1024 samples, as a share of their mean.
    /// Infinity before the tasks are written.
    double measure(size_t comparison) {
        std::vector<std::string> knobs;
        for (const KnobText& knob : describe_knobs(*this)) knobs.push_back(knob.value);
        return errors_[comparison].get({knobs, surfaces_.renewals()}, [&] {
            const glm::ivec2 size(48, 32);
            const Orbit low{.yaw = -12, .pitch = 5, .distance = 7, .target = {-0.3, 0, -1}, .field_of_view = 40};
            const Frame frame{.target = 0, .size = size, .time = 0, .camera = Camera(low, 1.5), .probe = {}};
            const Image errors = draw_numbers(size, [&] {
                surfaces_.draw(
                    frame, drawn(chosen),
                    {.pass = Pass::filter_error, .filter = comparisons[comparison].filter, .lights = lights_.lights()});
            });
            double off = 0, sum = 0;
            for (size_t i = 0; i < errors.values.size(); i += 4)
                if (std::isfinite(errors.values[i]))
                    off += double(errors.values[i]), sum += double(errors.values[i + 1]);
            return sum > 0 ? off / sum : HUGE_VAL;
        });
    }

    Surfaces surfaces_;
    MaskLevels levels_;
    Programs sky_{"common/window.vert", "08_obj_materials/sky.frag"};
    Programs encode_{"common/window.vert", "08_obj_materials/encode.frag"};
    Programs cut_{"common/window.vert", "08_obj_materials/cone.frag"};
    WindowTriangle window_;
    std::optional<LightTarget> target_;
    std::tuple<glm::ivec2, int, int> target_is_for_;
    mutable std::array<Kept<std::unique_ptr<DrawnScene>, int, MapSwitches>, 3> scenes_;  ///< by Read
    std::array<Kept<double, std::vector<std::string>, int>, comparisons.size()> errors_;
    Labels labels_;

    int view_ = garden, file_ = garden_file, maps_ = maps_on;
    MapSwitches switches_;
    LightKnobs lights_;
};

RELIEF_LAB(ObjMaterials);

}  // namespace relief::materials
