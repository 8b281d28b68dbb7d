// Lab 08: OBJ materials.
//
// A garden wall at dusk, from an OBJ file and its materials. The material of a surface decides its program, its place
// in the drawing order, and how much of a pixel it covers. Features that it does not name are neither compiled nor
// fetched. Your tasks: labs/08_obj_materials/task.cpp and shaders/08_obj_materials/task.glsl
#include <fmt/format.h>

#include <cmath>

#include "captions.h"
#include "framework/core/base/paths.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/kept.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/view_axes.h"
#include "framework/library/kit/window_triangle.h"
#include "lamp_cut.h"
#include "light_target.h"
#include "mask_levels.h"
#include "surfaces.h"
#include "task.h"

namespace relief::materials {

class ObjMaterials final : public Lab {
public:
    void draw(const Frame& frame) override {
        if (settings_.view == Settings::levels)
            levels_.draw(frame, labels_, settings_.alpha, settings_.threshold);
        else if (settings_.view == Settings::lamp_cut)
            lamp_cut_.draw(frame, settings_.lights());
        else if (frame.probe && frame.probe.name != "color")
            draw_probe(frame);
        else
            draw_light(frame);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override { settings_.knobs(knobs); }

    std::optional<Image> truth(const Frame& frame) const override {
        if (settings_.view == Settings::lamp_cut) return LampCut::truth(frame.size, frame.probe, settings_.lights());
        if (settings_.view == Settings::levels) return MaskLevels::truth(frame.size, frame.probe);
        if (settings_.file == Settings::own_file) return {};  // the truth knows the course's maps only
        return materials::truth(frame_in(frame, whole(frame)),
                                {drawn(read()).scene, read() == chosen, settings_.lights(), double(settings_.fence)});
    }

private:
    /// The maps of a view: none, all that are switched on, or all that are but normals and heights.
    enum Read { none, chosen, without_normals };
    /// A part of the picture.
    struct View {
        Tile tile;  ///< the camera's picture
        Tile part;  ///< part of the tile that is drawn
        Read maps = chosen;
        bool is_flat = false;  ///< drawn in the colours of the programs
        int filter = Settings::mips;
    };
    /// The filters that the view `ground` compares.
    struct Comparison {
        Settings::Filter filter;
        const char* title;
    };
    static constexpr std::array<Comparison, 4> comparisons = {{{Settings::nearest, "nearest texel"},
                                                               {Settings::mips, "mip levels"},
                                                               {Settings::taps_4, "4 taps"},
                                                               {Settings::taps_16, "16 taps"}}};

    // ---- the scene, and the parts of the picture

    ObjModel model() const {
        if (settings_.file == Settings::own_file) return settings_.own.model();
        if (settings_.file == Settings::thousand) return thousand_tiles();
        const std::string name = Settings::files.names[size_t(settings_.file)];
        return read_obj(course_root() / "assets" / (name + ".obj"));
    }
    DrawnScene& drawn(Read read) const {
        MapSwitches maps = read == none ? no_maps : settings_.switches;
        if (read == without_normals) maps.normals = false;
        return *scenes_[read].get({settings_.file, settings_.own.version(), maps},
                                  [&] { return std::make_unique<DrawnScene>(make_scene(model(), maps, kind_of)); });
    }
    Read read() const { return settings_.maps == Settings::maps_off ? none : chosen; }
    static Tile whole(const Frame& frame) { return {{0, 0}, frame.size}; }

    std::vector<View> views_of(const Frame& frame) const {
        if (frame.probe)
            return {{.tile = whole(frame), .part = whole(frame), .maps = read(), .filter = settings_.filter}};
        std::vector<View> all;
        if (settings_.view == Settings::ground) {
            const std::vector<Tile> tiles = tile_grid(frame.size, 2, 2);
            for (size_t i = 0; i < tiles.size(); ++i)
                all.push_back({.tile = tiles[i], .part = tiles[i], .filter = comparisons[i].filter});
            return all;
        }
        Tile left = whole(frame);
        if (settings_.view == Settings::garden) {
            left.size.x = frame.size.x * 7 / 10;
            const glm::ivec2 from(left.size.x, frame.size.y - frame.size.y * 4 / 10);
            const Tile right{from, frame.size - from};
            all.push_back({.tile = right, .part = right, .maps = read(), .is_flat = true});
        }
        View with{.tile = left, .part = left, .filter = settings_.filter}, without = with;
        without.maps = settings_.maps == Settings::wipe_normals ? without_normals : none;
        if (settings_.is_wipe()) {
            with.part.size.x /= 2;
            without.part.corner.x += with.part.size.x, without.part.size.x -= with.part.size.x;
        }
        if (settings_.maps != Settings::maps_off) all.push_back(with);
        if (settings_.maps != Settings::maps_on) all.push_back(without);
        return all;
    }

    // ---- pictures

    /// Draws the views into a target of floats, so that glass is blended as light, and encodes the sum at the end.
    void draw_light(const Frame& frame) {
        const std::vector<View> views = views_of(frame);
        begin_light(frame);
        glEnable(GL_SCISSOR_TEST);
        for (const View& view : views) draw_view(frame, view);
        glDisable(GL_SCISSOR_TEST);
        encode(frame);
        if (!frame.probe) describe(frame, views);
    }

    /// Draws a property of the surfaces.
    void draw_probe(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        if (frame.probe.name == "layers") glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        surfaces_.draw(frame_in(frame, whole(frame)), drawn(read()), {.pass = Pass::probe, .filter = settings_.filter});
    }

    // ---- passes

    /// Begins to draw into the target of floats. Weighted glass has two attachments of its own: the weighted sum of its
    /// light, and the share of the light behind it that passes.
    void begin_light(const Frame& frame) {
        const int samples = frame.probe ? 1 : 4;
        const std::tuple wanted(frame.size, samples, attachments());
        if (!target_ || wanted != target_is_for_) {
            target_.reset();  // first, so that there is never memory for two
            target_.emplace(frame.size, samples, attachments()), target_is_for_ = wanted;
        }
        if (settings_.is_weighted()) {
            target_->begin(1, 2);
            constexpr float nothing[] = {0, 0, 0, 0}, all[] = {1, 1, 1, 1};
            glClearBufferfv(GL_COLOR, 0, nothing), glClearBufferfv(GL_COLOR, 1, all);
        }
        target_->begin();
        glClear(GL_DEPTH_BUFFER_BIT);
    }

    void draw_view(const Frame& frame, const View& view) {
        const auto& [tile, part, maps, is_flat, filter] = view;
        if (tile.size.x <= 0 || tile.size.y <= 0) return;
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        glScissor(part.corner.x, part.corner.y, part.size.x, part.size.y);
        draw_sky(frame_in(frame, tile), is_flat);
        surfaces_.draw(frame_in(frame, tile), drawn(maps),
                       {.pass = is_flat ? Pass::flat : Pass::light, .filter = filter, .target = &*target_});
    }

    void draw_sky(const Frame& frame, bool is_flat) {
        const Program& program = sky_.with(Settings::blend_spaces.define(settings_.blend_in));
        glUseProgram(program);
        set_rays(program, frame);
        program.set("u_to_sun", settings_.distant.direction());
        program.set("u_day", settings_.lamp == sun && !is_flat ? 1.0f : 0.0f);
        glDepthMask(GL_FALSE);
        window_.draw();
        glDepthMask(GL_TRUE);
    }

    void encode(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        const Program& program =
            encode_.with({frame.probe, fmt::format("SAMPLES {}", target_->samples()),
                          Settings::orders.define(settings_.order), Settings::blend_spaces.define(settings_.blend_in)});
        glUseProgram(program);
        for (int i = 0; i < attachments(); ++i) {
            program.set(std::array{"s_light", "s_sum", "s_passed"}[size_t(i)], i);
            target_->bind(i, i);
        }
        window_.draw();
    }
    int attachments() const { return settings_.is_weighted() ? 3 : 1; }

    // ---- words and measurements

    void describe(const Frame& frame, const std::vector<View>& views) {
        const Scene& scene = drawn(read()).scene;
        if (settings_.view == Settings::ground) describe_filters(frame, views);
        if (settings_.view == Settings::garden) {
            list_materials(labels_, frame.size, views[0].tile, scene, settings_.highlight);
            if (settings_.is_wipe())
                labels_.rectangle({float(views[1].part.size.x) - 0.5f, 0}, {1, float(frame.size.y)}, {1, 1, 1, 0.4f});
        }
        if (settings_.shows_notes()) labels_.notes(scene.notes);
    }

    void describe_filters(const Frame& frame, const std::vector<View>& views) {
        for (size_t i = 0; i < views.size(); ++i) {
            labels_.caption(frame.size, views[i].tile, 0, comparisons[i].title);
            if (const double error = measure(views[i].filter); std::isfinite(error))
                labels_.caption(frame.size, views[i].tile, -1, fmt::format("{:.1f} % off", 100 * error));
        }
    }

    /// Returns the mean error of a filter's colours, relative to 1024 samples, as a share of their mean. Infinity
    /// before the tasks are written.
    double measure(int filter) {
        return errors_[size_t(filter)].get({knob_values(*this), surfaces_.renewals()}, [&] {
            const glm::ivec2 size(48, 32);
            const Orbit low{.yaw = -12, .pitch = 5, .distance = 7, .target = {-0.3, 0, -1}, .field_of_view = 40};
            const Frame frame{.target = 0, .size = size, .time = 0, .camera = Camera(low, 1.5), .probe = {}};
            const Image errors = draw_numbers(
                size, [&] { surfaces_.draw(frame, drawn(chosen), {.pass = Pass::filter_error, .filter = filter}); });
            double off = 0, sum = 0;
            for (size_t i = 0; i < errors.values.size(); i += 4)
                if (std::isfinite(errors.values[i]))
                    off += double(errors.values[i]), sum += double(errors.values[i + 1]);
            return sum > 0 ? off / sum : HUGE_VAL;
        });
    }

    Settings settings_;
    Surfaces surfaces_{settings_};
    MaskLevels levels_;
    LampCut lamp_cut_;
    Programs sky_{"common/window.vert", "08_obj_materials/sky.frag"};
    Programs encode_{"common/window.vert", "08_obj_materials/encode.frag"};
    WindowTriangle window_;
    std::optional<LightTarget> target_;
    std::tuple<glm::ivec2, int, int> target_is_for_;  ///< size, samples and attachments
    mutable std::array<Kept<std::unique_ptr<DrawnScene>, int, int, MapSwitches>, 3> scenes_;  ///< by Read
    std::array<Kept<double, std::vector<std::string>, int>, Settings::filters.size()> errors_;
    Labels labels_;
};

RELIEF_LAB(ObjMaterials);

}  // namespace relief::materials
