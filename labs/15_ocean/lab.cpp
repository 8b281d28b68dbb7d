// Lab 15: ocean.
//
// Two maps of waves scroll over each other. Heights add, so slopes add, and normals do not. Far away a pixel covers
// many waves, of which only the spread of slopes is left. Your tasks: labs/15_ocean/task.cpp and
// shaders/15_ocean/task.glsl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/kit/kept.h"
#include "framework/kit/labels.h"
#include "framework/kit/light.h"
#include "framework/kit/numbers.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "task.h"
#include "truth.h"
#include "waves.h"

namespace relief::ocean {

class Ocean final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const std::vector<View> views = views_of(frame);
        for (const View& view : views) {
            Frame part = frame_in(frame, view.tile);
            if (view_ == far_seas && !frame.probe) part.camera = from_afar(part);
            draw_view(part, view);
        }
        if (!frame.probe) describe(frame.size, views);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, kinds, "two rules for the normal and their errors; four far seas; or one picture");
        knobs.group("Normals");
        knobs.choice("combine", combine_, combines, "for view = one: how the normals of two maps become one");
        knobs.choice("waves", waves_, waves, "both maps, or one of them");
        knobs.choice("normals", source_, sources, "slopes out of normal maps, out of height maps, or by the formula");
        knobs.choice("far", far_, fars, "what the highlight knows of the waves within a pixel");
        knobs.choice("samples", samples_, sample_counts, "for far = samples: places within a pixel");
        knobs.choice("fresnel", fresnel_, fresnels, "share of the mirrored light: Schlick's approximation, or exact");
        knobs.group("Waves");
        knobs.slider("tiles_1", tiles_[0], 0.02f, 8, "how often the first map lies on 16 metres");
        knobs.slider("tiles_2", tiles_[1], 0.02f, 8, "how often the second map lies on 16 metres");
        knobs.slider("amplitude_1", amplitude_[0], 0, 4, "significant wave height of the first map, metres");
        knobs.slider("amplitude_2", amplitude_[1], 0, 4, "significant wave height of the second map, metres");
        knobs.slider("wind", wind_, 0, 20, "metres a second: scales both amplitudes by Cox and Munk's law; 0 does not");
        knobs.slider("shininess", shininess_, 1, 4096, "exponent of the highlight of a single slope");
        knobs.toggle("lock", lock_, "normal maps lie as the height maps do; else they are tiled three times as often");
        knobs.choice("level", level_, levels, "mip level of the maps that a pixel reads");
        knobs.group("Raised waves");
        knobs.toggle("displace", displace_, "raise the waves near the eye by tessellation");
        knobs.slider("budget", budget_, 0.25f, 16, "error of the raised waves, pixels");
        knobs.toggle("wire", wire_, "draw the triangles' edges");
        light_.knobs(knobs, -5, 90);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        Sea sea;
        for (int map = 0; map < 2; ++map)
            if (is_used(map))
                sea.layers.push_back({map, amplitude(map), double(tiles_[size_t(map)]), velocities[size_t(map)]});
        sea.shininess = double(shininess_), sea.to_light = light_.direction<double>();
        sea.displaced = displace_, sea.whole_spread = level_ == int(levels.size()) - 1;
        sea.exact_fresnel = fresnel_ == 1;
        return ocean::truth(frame_in(frame, {{0, 0}, frame.size}), probe, sea);  // as drawn
    }

private:
    enum ViewKind { halves, far_seas, one };
    enum Combine { mean, whiteout, udn, rnm, slopes };
    enum Far { plain, toksvig, lean, samples };
    static constexpr std::array kinds = {"halves", "far", "one"};
    static constexpr std::array combines = {"mean", "whiteout", "udn", "rnm", "slopes"};
    static constexpr std::array waves = {"both", "first", "second"};
    static constexpr std::array sources = {"maps", "heights", "analytic"};
    static constexpr std::array fars = {"plain", "toksvig", "lean", "samples"};
    static constexpr std::array sample_counts = {"64", "256", "1024"};
    static constexpr std::array fresnels = {"schlick", "exact"};
    static constexpr std::array levels = {"mip", "0", "1", "2", "3", "4", "5", "6", "7", "8"};
    /// Tiles per second. They are binary fractions, so that the sea repeats exactly after 128 seconds.
    static constexpr std::array<glm::dvec2, 2> velocities = {{{1.0 / 128, 9.0 / 128}, {-5.0 / 128, 31.0 / 128}}};
    static constexpr int rings = 26, sectors = 48;
    static constexpr double flat = 20;        ///< exponent of 2 of a segment as long as the sea
    static constexpr float error_scale = 12;  ///< error of the brightest colour (pale yellow), degrees

    struct View {
        Tile tile;
        int rule, far;
        std::string title;
        bool is_wiped = false, is_error = false;
    };

    std::vector<View> views_of(const Frame& frame) const {
        const Tile whole{{0, 0}, frame.size};
        if (frame.probe || view_ == one) return {{whole, combine_, far_, "", false, false}};
        std::vector<View> all;
        if (view_ == far_seas) {
            const auto tiles = tile_grid(frame.size, 2, 2);
            for (int i = 0; i < 4; ++i) all.push_back({tiles[size_t(i)], slopes, i, fars[size_t(i)]});
            return all;
        }
        const int below = frame.size.y / 4;
        all.push_back({{{0, below}, {frame.size.x, frame.size.y - below}}, mean, far_, "", true, false});
        const auto tiles = tile_grid({frame.size.x, below}, 2, 1);
        for (int i = 0; i < 2; ++i) all.push_back({tiles[size_t(i)], i == 0 ? mean : slopes, far_, "", false, true});
        return all;
    }

    bool is_used(int map) const { return (waves_ == 0 || waves_ == map + 1) && amplitude_[size_t(map)] > 0; }

    /// Returns the significant wave height of a map in metres, scaled so that slopes fit the wind.
    double amplitude(int map) const {
        double square = 0;
        for (int i = 0; i < 2; ++i) {
            const glm::dvec3 moments =
                slope_moments(i) * std::pow(double(amplitude_[size_t(i)] * tiles_[size_t(i)]), 2);
            square += moments.x + moments.y;
        }
        // Cox and Munk 1954: the mean squared slope of a clean sea.
        const double law = 0.003 + 0.00512 * double(wind_);
        const double scale = wind_ > 0 && square > 0 ? std::sqrt(law / square) : 1;
        return scale * double(amplitude_[size_t(map)]);
    }

    void draw_view(Frame frame, const View& view) {
        if (frame.size.x <= 0 || frame.size.y <= 0) return;
        glViewport(view.tile.corner.x, view.tile.corner.y, frame.size.x, frame.size.y);
        if (view.is_error) {
            frame.camera = from_above(frame);
            return draw_sea(frame, view, "ERROR");
        }
        if (frame.probe) return draw_sea(frame, view, frame.probe);
        glDisable(GL_DEPTH_TEST);
        draw_sky(frame);
        glEnable(GL_DEPTH_TEST);
        glPolygonOffset(1, 1);
        if (wire_) glEnable(GL_POLYGON_OFFSET_FILL);  // so that lines are in front
        draw_sea(frame, view, view.is_wiped ? "WIPE" : "");
        glDisable(GL_POLYGON_OFFSET_FILL);
        if (!wire_) return;
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        draw_sea(frame, view, "WIRE");
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }

    /// Returns a camera that looks down steeply, so that waves do not hide each other.
    static Camera from_above(const Frame& frame) {
        Orbit orbit = frame.camera.orbit();
        orbit.pitch = 38, orbit.distance = 26, orbit.target = {0, 0, 0}, orbit.field_of_view = 30;
        return Camera(orbit, double(frame.size.x) / std::max(1, frame.size.y));
    }

    /// Returns the length of the longest segment whose error is at most `tolerated` metres, as an exponent of 2 of
    /// metres. The error is twice the root mean square over all waves. A chord of length l of a wave of amplitude a and
    /// k radians per metre is off by a k^2 l^2 / 8, clamped to a.
    double segment_exponent(double tolerated) const {
        constexpr double first = -10;
        constexpr int steps = 16, count = 20 * steps;  // to an exponent of 10
        const std::array<double, 4> sea = {is_used(0) ? amplitude(0) : 0, is_used(1) ? amplitude(1) : 0,
                                           double(tiles_[0]), double(tiles_[1])};
        const std::vector<double>& errors = segment_errors_.get({sea}, [&] {
            std::vector<double> made;
            for (int i = 0; i < count; ++i) {
                const double length = std::exp2(first + double(i) / steps);
                double sum = 0;
                for (size_t map = 0; map < 2; ++map)
                    for (const Wave& wave : waves_of(int(map))) {
                        const double turns = glm::length(glm::dvec2(wave.k)) * sea[map + 2] / tile_metres * length,
                                     angle = 2 * glm::pi<double>() * turns,
                                     part = sea[map] * wave.amplitude * std::min(1.0, angle * angle / 8);
                        sum += part * part / 2;
                    }
                made.push_back(2 * std::sqrt(sum));
            }
            return made;
        });
        if (errors.back() <= tolerated) return flat;
        const auto place = std::upper_bound(errors.begin(), errors.end(), tolerated) - errors.begin();
        return first + double(std::max<std::ptrdiff_t>(0, place - 1)) / steps;
    }

    /// Returns the error in metres that covers the budget in pixels, at a distance in metres.
    double tolerated(const Frame& frame, double distance) const {
        return double(budget_) * distance * 2 * half_height(frame) / frame.size.y;
    }

    /// Returns whether some water in the picture is so near that flat water would exceed the budget.
    bool has_waves_above_budget(const Frame& frame) const {
        double down = 0;  // largest downward component of a unit ray
        for (const glm::dvec2 clip : {glm::dvec2(0, -1), {-1, -1}, {1, -1}, {0, 0}, {0, 1}})
            down = std::max(down, -frame.camera.ray(clip).direction.y);
        if (down > 0.95) down = 1;
        const double nearest = std::max(0.0, frame.camera.eye().y - highest()) / std::max(down, 1e-9);
        return down > 0 && segment_exponent(tolerated(frame, nearest)) < flat;
    }

    /// Returns an upper bound of the height of the sea, metres.
    double highest() const {
        double sum = 0;
        for (int map = 0; map < 2; ++map)
            for (const Wave& wave : waves_of(map)) sum += is_used(map) ? amplitude(map) * std::abs(wave.amplitude) : 0;
        return sum;
    }

    static glm::dvec3 row(const Frame& frame, int i) {
        const glm::dmat4 view = frame.camera.view_from_world();
        return {view[0][i], view[1][i], view[2][i]};
    }

    /// Returns a camera so far away that a pixel covers many waves.
    static Camera from_afar(const Frame& frame) {
        Orbit orbit = frame.camera.orbit();
        orbit.distance *= 6;
        return Camera(orbit, double(frame.size.x) / std::max(1, frame.size.y));
    }

    static double half_height(const Frame& frame) {
        return std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2);
    }

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with();
        glUseProgram(program);
        const double up = half_height(frame), right = up * frame.size.x / frame.size.y;
        program.set("u_forward", -row(frame, 2));
        program.set("u_right", row(frame, 0) * right);
        program.set("u_up", row(frame, 1) * up);
        program.set("u_to_light", light_.direction());
        glBindVertexArray(nothing_.layout());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    void draw_sea(const Frame& frame, const View& view, const Define& purpose) {
        const bool is_raised = displace_ && !view.is_error && has_waves_above_budget(frame);
        const bool is_wire = purpose.text == "WIRE";
        const Program& program = sea_.with(
            {purpose, is_used(0) ? "FIRST" : "", is_used(1) ? "SECOND" : "", is_raised ? "" : "FLAT",
             fmt::format("COMBINE {}", is_wire ? 0 : view.rule), fmt::format("NORMALS {}", is_wire ? 0 : source_),
             fmt::format("FAR {}", is_wire || view.is_error ? 0 : view.far),
             view.far == samples && !is_wire && !view.is_error ? fmt::format("SIDE {}", 8 << samples_) : "",
             fresnel_ == 1 && !is_wire && !view.is_error ? "EXACT_FRESNEL" : "",
             level_ > 0 || view.is_error ? "ONE_LEVEL" : ""});
        glUseProgram(program);
        const glm::dvec3 eye = frame.camera.eye();
        // The sea has no end, so places are relative to the eye, in double precision up to here.
        program.set("u_clip_from_eye", frame.camera.clip_from_world() *
                                           glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, eye.x, eye.y, eye.z, 1));
        program.set("u_eye_height", eye.y);
        program.set("u_near", std::min(0.1, 0.02 * frame.camera.orbit().distance));
        const double first_ring = std::clamp(std::abs(eye.y), 0.5, 1e4),
                     last_ring = 4e4 * std::max(1.0, first_ring / 10);
        const double ratio = std::pow(last_ring / first_ring, 1.0 / (rings - 1));
        program.set("u_rings", glm::vec3(sectors, first_ring, ratio));

        const std::array amplitudes = {amplitude(0), amplitude(1)};
        double square = 0;
        for (int map = 0; map < 2; ++map) {
            if (!is_used(map)) continue;
            const double tiles = double(tiles_[size_t(map)]), a = amplitudes[size_t(map)];
            const glm::dvec3 moments = a * a * tiles * tiles * slope_moments(map);
            square += moments.x + moments.y;
        }
        program.set("u_highest", is_raised ? highest() : 0.0);
        for (int ring = 0; ring <= rings; ++ring) {
            const double radius = ring == 0 ? 0 : first_ring * std::pow(ratio, ring - 1);
            const double off = tolerated(frame, std::hypot(radius, eye.y));
            program.set(fmt::format("u_segments[{}]", ring).c_str(), is_raised ? segment_exponent(off) : flat);
        }

        program.set("u_amplitude", glm::vec2(amplitudes[0], amplitudes[1]));
        program.set("u_tiles", glm::vec2(tiles_[0], tiles_[1]));
        glm::vec4 offset(0);
        for (int map = 0; map < 2; ++map) {
            const glm::dvec2 moved = frame.time == 0 ? glm::dvec2(0) : scroll(velocities[size_t(map)], frame.time),
                             below = double(tiles_[size_t(map)]) / tile_metres * glm::dvec2(eye.x, eye.z),
                             rest = below - glm::floor(below) + moved;
            offset[map * 2] = float(rest.x), offset[map * 2 + 1] = float(rest.y);
        }
        program.set("u_offset", offset);
        program.set("u_level", view.is_error ? 0.0f : float(level_ - 1));
        program.set("u_detail", lock_ ? 1.0f : 3.0f);
        program.set("u_shininess", shininess_);
        program.set("u_to_light", light_.direction());
        program.set("u_split", float(view.tile.corner.x) + float(view.tile.size.x) / 2);
        program.set("u_forward", -row(frame, 2));
        const double pixel = 2 * half_height(frame) / frame.size.y;
        program.set("u_pixel_right", row(frame, 0) * pixel);
        program.set("u_pixel_up", row(frame, 1) * pixel);
        program.set("u_steepest", 5 * std::sqrt(square));
        program.set("u_error_scale", error_scale);
        program.set("u_wire", glm::vec3(0.93f, 0.86f, 0.62f));
        for (int i = 0; i < 2 * waves_a_map; ++i) {
            const Wave& wave = waves_of(i / waves_a_map)[size_t(i % waves_a_map)];
            program.set(fmt::format("u_waves[{}]", i).c_str(),
                        glm::vec4(wave.k.x, wave.k.y, wave.amplitude, wave.phase));
        }
        for (int map = 0; map < 2; ++map) {
            const std::string number = std::to_string(map + 1);
            program.set(("s_waves_" + number).c_str(), 3 * map, wave_maps_[size_t(map)]);
            program.set(("s_moments_" + number).c_str(), 3 * map + 1, moment_maps_[size_t(map)]);
            program.set(("s_normals_" + number).c_str(), 3 * map + 2, normal_maps_[size_t(map)]);
        }
        glBindVertexArray(nothing_.layout());
        glPatchParameteri(GL_PATCH_VERTICES, 4);
        glDrawArrays(GL_PATCHES, 0, rings * sectors * 4);
    }

    void describe(glm::ivec2 size, const std::vector<View>& views) {
        if (view_ == one) return;
        if (view_ == far_seas) {
            for (const View& view : views) labels_.caption(size, view.tile, 0, view.title);
            return;
        }
        const Tile& picture = views[0].tile;
        const int half = size.x / 2;
        labels_.caption(size, {picture.corner, {half, picture.size.y}}, 0, "mean of normals");
        labels_.caption(size, {picture.corner + glm::ivec2(half, 0), {half, picture.size.y}}, 0, "sum of slopes");
        const float line = Labels::line_height(size), top = float(picture.size.y);
        labels_.rectangle({float(half) - 0.5f, 0.5f * top}, {1, 0.5f * top}, {1, 1, 1, 0.35f});
        for (int i = 0; i < 2; ++i)
            if (const double error = measure(views[size_t(i) + 1]); std::isfinite(error))
                labels_.text(fmt::format("{:.1f}~ off", error), {float(half) * (float(i) + 0.5f), top + 0.3f * line},
                             line, Align::centre);
    }

    /// Returns the mean error of a rule in degrees, over the water ahead. Infinity before its task is written.
    double measure(const View& view) {
        std::vector<std::string> knobs;
        for (const KnobText& knob : describe_knobs(*this)) knobs.push_back(knob.value);
        return means_[view.rule == mean ? 0 : 1].get({knobs, sea_.renewals()}, [&] {
            View square = view;
            square.tile = {{0, 0}, {48, 48}};
            const Image drawn = draw_numbers({48, 48}, [&] {
                Frame frame{
                    0, {48, 48}, 0, Camera({.yaw = 180, .pitch = 38, .distance = 26, .field_of_view = 30}, 1), {}};
                draw_sea(frame, square, "MEASURE");
            });
            double sum = 0;
            for (size_t i = 0; i < drawn.values.size(); i += 4) sum += double(drawn.values[i]);
            return sum / double(drawn.pixel_count());
        });
    }

    static Texture map_texture(const char* title, int map, Image MapImages::*image) {
        return Texture(fmt::format("{} {}", title, map + 1), [map, image] { return make_maps(map).*image; });
    }

    Programs sea_{"15_ocean/sea.vert", "15_ocean/sea.tesc", "15_ocean/sea.tese", "15_ocean/sea.frag"};
    Programs sky_{"15_ocean/sky.vert", "15_ocean/sky.frag"};
    std::array<Texture, 2> wave_maps_ = {map_texture("waves", 0, &MapImages::waves),
                                         map_texture("waves", 1, &MapImages::waves)};
    std::array<Texture, 2> moment_maps_ = {map_texture("moments", 0, &MapImages::moments),
                                           map_texture("moments", 1, &MapImages::moments)};
    std::array<Texture, 2> normal_maps_ = {map_texture("normals", 0, &MapImages::normals),
                                           map_texture("normals", 1, &MapImages::normals)};
    GpuMesh nothing_ = upload([] { return Mesh{}; });
    std::array<Kept<double, std::vector<std::string>, int>, 2> means_;
    mutable Kept<std::vector<double>, std::array<double, 4>> segment_errors_;  ///< by amplitudes and tiles
    Labels labels_;

    int view_ = halves, combine_ = slopes, waves_ = 0, source_ = 0, far_ = lean, samples_ = 2, fresnel_ = 0, level_ = 0;
    std::array<float, 2> tiles_ = {0.16f, 2.6f}, amplitude_ = {1.2f, 0.08f};
    float wind_ = 6, shininess_ = 512, budget_ = 3;
    bool lock_ = true, displace_ = true, wire_ = false;
    DistantLight light_{.yaw = 0, .pitch = 7};
};

RELIEF_LAB(Ocean);

}  // namespace relief::ocean
