// Lab 08: OBJ materials.
//
// A garden wall at dusk, from an OBJ file and its materials. The material of a surface decides its program, its place
// in the drawing order, and how much of a pixel it covers. Features that it does not name are neither compiled nor
// fetched. Your tasks: labs/08_obj_materials/task.cpp and shaders/08_obj_materials/task.glsl
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "framework/base/error.h"
#include "framework/base/paths.h"
#include "framework/gl/light_target.h"
#include "framework/image/asset.h"
#include "framework/image/mips.h"
#include "framework/kit/kept.h"
#include "framework/kit/labels.h"
#include "framework/kit/light.h"
#include "framework/kit/numbers.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "task.h"
#include "truth.h"

namespace relief::materials {

class ObjMaterials final : public Lab {
public:
    void draw(const Frame& frame) override {
        if (view_ == levels) {
            draw_levels(frame);
        } else if (view_ == lamp_cut) {
            draw_cone(frame);
        } else if (frame.probe && frame.probe.name != "color") {
            glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
            glViewport(0, 0, frame.size.x, frame.size.y);
            if (frame.probe.name == "layers") glClearColor(0, 0, 0, 0);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            draw_pieces(frame, loaded(maps_ != maps_off), frame.probe.name);
        } else {
            draw_light(frame);
        }
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, view_names,
                     "the garden and its programs; or one picture, filters, mip levels, the lamp");
        knobs.choice("file", file_, files, "the OBJ file");
        knobs.choice("maps", maps_, map_choices, "read the maps that materials name; or both, side by side");
        knobs.choice("programs", programs_, program_kinds, "a program for each set of features, or one with branches");
        knobs.steps("highlight", highlight_, 0, 12, "show this material alone in its light; 0: all");
        knobs.choice("filter", filter_, filters, "how the colours of maps are read");
        knobs.group("Glass and masks");
        knobs.choice("order", order_, orders,
                     "order of the surfaces; weighted: glass in any order, blended by weights");
        knobs.choice("blend_in", blend_in_, blend_spaces, "blend light, or the values that sRGB stores");
        knobs.choice("alpha", alpha_, alphas, "what a mask does with a pixel");
        knobs.slider("threshold", threshold_, 0.05f, 0.95f, "for alpha = test: what is above it stays");
        knobs.slider("fence", fence_, 0.5f, 8, "tiles of wire to one of the file's");
        knobs.group("Lantern");
        knobs.choice("lamp", lamp_, lamps, "the lantern with its cone, without it, or daylight");
        knobs.slider("range", range_, 0, 20, "how far the lantern reaches, metres");
        knobs.slider("cone", cone_, 0, 64, "exponent of the lantern's cone; 0 shines all around");
        knobs.slider("lamp_height", lamp_height_, 0, 3, "height of the lantern's light above the ground, metres");
        light_.knobs(knobs, -5, 90);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        const Lights lights = this->lights();
        if (view_ == lamp_cut) {
            if (probe.name != "lamp" || !true_share) return {};
            return image_of_values(frame.size, [&](int x, int y) {
                const glm::dvec2 off = (glm::dvec2(x, frame.size.y - 1 - y) + 0.5 - glm::dvec2(frame.size) / 2.0) *
                                       metres_per_pixel(frame.size);
                return glm::dvec4(true_share(lights, lights.place + glm::dvec3(off, 0)).value_or(0), 0, 0, 0);
            });
        }
        if (view_ == levels) {
            const auto share = true_coverage(mask_of_levels);
            if (probe.name != "coverage" || !share) return {};
            return image_of_values(frame.size, [&](int, int) { return glm::dvec4(*share, 0, 0, 0); });
        }
        const bool has_maps = maps_ != maps_off;
        return materials::truth(frame, probe, {loaded(has_maps).scene, has_maps, lights, double(fence_)});
    }

private:
    enum ViewKind { garden, one, ground, levels, lamp_cut };
    enum File { garden_file, fence_file, ground_file, broken_file, thousand };
    enum MapChoice { maps_on, maps_off, wipe };
    enum Order { sorted, of_file, backwards, weighted };
    enum Alpha { test, keep, to_coverage, hashed };
    static constexpr std::array view_names = {"garden", "one", "ground", "levels", "lamp"};
    static constexpr std::array files = {"garden", "fence", "ground", "broken", "thousand"};
    static constexpr std::array map_choices = {"on", "off", "wipe"};
    static constexpr std::array program_kinds = {"compiled", "branches"};
    static constexpr std::array orders = {"sorted", "file", "backwards", "weighted"};
    static constexpr std::array blend_spaces = {"light", "stored"};
    static constexpr std::array alphas = {"test", "keep", "to-coverage", "hashed"};
    static constexpr std::array filters = {"nearest", "mips", "2", "4", "8", "16", "samples"};
    static constexpr std::array lamps = {"spot", "point", "sun"};
    static constexpr const char* mask_of_levels = "wire_mask.png";
    static constexpr int samples_of_pictures = 4, levels_shown = 6, most_listed = 12;

    /// The scene of a file, with its mesh, textures and masks' scales as they are drawn.
    struct Loaded {
        explicit Loaded(Scene made) : scene(std::move(made)) {}
        Scene scene;
        GpuMesh mesh = upload([this] { return scene.mesh; });
        std::map<std::string, Texture> textures;
        std::map<std::string, std::vector<float>> scales;  ///< kept_scales() of each mask
    };

    /// A part of the picture, with or without maps.
    struct View {
        Tile tile;  ///< the camera's picture
        Tile part;  ///< part of the tile that is drawn
        bool has_maps = true;
        bool is_flat = false;  ///< drawn in the colours of the programs
        int filter = -1;       ///< overrides the knob; -1: the knob's filter
    };

    Loaded& loaded(bool with_maps) const {
        return *scenes_[with_maps].get({file_}, [&] {
            static constexpr std::array names = {"garden.obj", "fence.obj", "ground.obj", "broken.obj"};
            ObjModel model =
                file_ == thousand ? thousand_tiles() : read_obj(course_root() / "assets" / names[size_t(file_)]);
            return std::make_unique<Loaded>(make_scene(std::move(model), with_maps, kind_of));
        });
    }

    Lights lights() const {
        return lights_of(Lamp(lamp_), light_.direction<double>(), double(range_), double(cone_), double(lamp_height_));
    }

    std::vector<View> views_of(const Frame& frame) const {
        const Tile whole{{0, 0}, frame.size};
        if (frame.probe) return {{whole, whole, maps_ != maps_off}};
        if (view_ == ground) {
            std::vector<View> all;
            for (const int filter : {0, 1, 3, 5}) {
                const Tile tile = tile_grid(frame.size, 2, 2)[all.size()];
                all.push_back({tile, tile, true, false, filter});
            }
            return all;
        }
        Tile left = whole;
        std::vector<View> all;
        if (view_ == garden) {
            left.size.x = frame.size.x * 7 / 10;
            const glm::ivec2 corner(left.size.x, frame.size.y - frame.size.y * 4 / 10);
            const Tile right{corner, frame.size - corner};
            all.push_back({right, right, maps_ != maps_off, true});
        }
        Tile with = left, without = left;
        if (maps_ == wipe) with.size.x /= 2, without.corner.x += with.size.x, without.size.x -= with.size.x;
        if (maps_ != maps_off) all.push_back({left, with, true});
        if (maps_ != maps_on) all.push_back({left, without, false});
        return all;
    }

    /// Draws the views into a target of floats, so that glass is blended as light, and encodes the sum at the end.
    void draw_light(const Frame& frame) {
        const int samples = frame.probe ? 1 : samples_of_pictures, attachments = order_ == weighted ? 3 : 1;
        const std::tuple wanted(frame.size, samples, attachments);
        if (!target_ || wanted != target_is_for_) {
            target_.reset();
            target_.emplace(frame.size, samples, attachments), target_is_for_ = wanted;
        }
        if (order_ == weighted) {
            target_->begin(1, 2);
            constexpr float nothing[] = {0, 0, 0, 0}, all[] = {1, 1, 1, 1};
            glClearBufferfv(GL_COLOR, 0, nothing), glClearBufferfv(GL_COLOR, 1, all);
        }
        target_->begin();
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        const std::vector<View> views = views_of(frame);
        for (const View& view : views) {
            const Frame part = frame_in(frame, view.tile);
            if (part.size.x <= 0 || part.size.y <= 0) continue;
            glViewport(view.tile.corner.x, view.tile.corner.y, view.tile.size.x, view.tile.size.y);
            glScissor(view.part.corner.x, view.part.corner.y, view.part.size.x, view.part.size.y);
            draw_sky(part, view.is_flat);
            draw_pieces(part, loaded(view.has_maps), view.is_flat ? "FLAT" : "", view.filter);
        }
        glDisable(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        encode(frame);
        if (!frame.probe) describe(frame, views);
    }

    void draw_sky(const Frame& frame, bool is_flat) {
        const Program& program = sky_.with(is_stored() ? "STORED" : "");
        glUseProgram(program);
        const glm::dmat4 view = frame.camera.view_from_world();
        const auto row = [&](int i) { return glm::dvec3(view[0][i], view[1][i], view[2][i]); };
        const double up = std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2);
        program.set("u_forward", -row(2));
        program.set("u_right", row(0) * (up * frame.size.x / frame.size.y));
        program.set("u_up", row(1) * up);
        program.set("u_to_sun", light_.direction());
        program.set("u_day", lamp_ == sun && !is_flat ? 1.0f : 0.0f);
        glDepthMask(GL_FALSE);
        draw_window();
        glDepthMask(GL_TRUE);
    }

    void draw_window() {
        glDisable(GL_DEPTH_TEST);
        glBindVertexArray(nothing_.layout());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glEnable(GL_DEPTH_TEST);
    }

    void encode(const Frame& frame) {
        const Program& program = encode_.with({frame.probe, fmt::format("SAMPLES {}", target_->samples()),
                                               order_ == weighted ? "WEIGHTED" : "", is_stored() ? "STORED" : ""});
        glUseProgram(program);
        for (int i = 0; i < (order_ == weighted ? 3 : 1); ++i) {
            program.set(std::array{"s_light", "s_sum", "s_passed"}[size_t(i)], i);
            target_->bind(i, i);
        }
        draw_window();
    }

    bool is_stored() const { return blend_in_ == 1; }

    /// Returns the indices of a scene's pieces in the order of drawing.
    std::vector<int> order_of(const Scene& scene, const glm::dvec3& eye) const {
        std::vector<int> order(scene.pieces.size());
        std::iota(order.begin(), order.end(), 0);
        if (order_ == backwards) std::reverse(order.begin(), order.end());
        if (order_ == weighted)
            std::stable_partition(order.begin(), order.end(),
                                  [&](int i) { return !scene.pieces[size_t(i)].is_glass(); });
        if (order_ != sorted) return order;
        std::vector<Surface> surfaces;
        for (const Piece& piece : scene.pieces) surfaces.push_back({piece.program, piece.is_glass(), piece.centre});
        order = draw_order(surfaces, eye);
        if (order.size() > surfaces.size())
            throw Error(fmt::format("draw_order() returns {} indices for {} surfaces: each of them once", order.size(),
                                    surfaces.size()));
        for (const int i : order)
            if (i < 0 || size_t(i) >= surfaces.size())
                throw Error(
                    fmt::format("draw_order() returns the index {}: the surfaces are 0 to {}", i, surfaces.size() - 1));
        return order;
    }

    /// Draws all pieces. `purpose` is empty for light, or FLAT, MEASURE, or the name of a probe.
    void draw_pieces(const Frame& frame, Loaded& loaded, const std::string& purpose, int filter = -1) {
        const std::vector<int> order = order_of(loaded.scene, frame.camera.eye());
        const Program* in_use = nullptr;
        glBindVertexArray(loaded.mesh.layout());
        for (size_t rank = 0; rank < order.size(); ++rank) {
            const Piece& piece = loaded.scene.pieces[size_t(order[rank])];
            if (purpose == "coverage" && !piece.has(mask_map)) continue;
            if (purpose == "MEASURE" && !piece.has(color_map)) continue;
            const bool is_light = purpose.empty(), is_blended = piece.is_glass() && (is_light || purpose == "layers");
            const Program& program = program_of(piece, purpose, filter < 0 ? filter_ : filter);
            if (&program != in_use) {
                glUseProgram(program);
                set_frame(program, frame);
                in_use = &program;
            }
            set_piece(program, loaded, piece);
            const bool is_shown = highlight_ == 0 || highlight_ == order[rank] + 1;
            program.set("u_dim", is_shown ? 1.0f : 0.15f);
            program.set("u_number", float(purpose == "order" ? int(rank) : order[rank]));
            set_blending(is_blended, purpose);
            if (is_light && alpha_ == to_coverage && piece.has(mask_map) && target_->samples() > 1)
                glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
            glDrawElements(GL_TRIANGLES, GLsizei(piece.index_count), GL_UNSIGNED_INT,
                           reinterpret_cast<const void*>(uintptr_t(piece.first_index) * sizeof(uint32_t)));
            glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        }
        set_blending(false, purpose);
    }

    /// Switches between glass and opaque surfaces. Glass is blended and writes no depth, so it hides nothing.
    void set_blending(bool is_on, const std::string& purpose) {
        glDepthMask(is_on ? GL_FALSE : GL_TRUE);
        (is_on ? glEnable : glDisable)(GL_BLEND);
        if (order_ == weighted && purpose.empty()) target_->begin(is_on ? 1 : 0, is_on ? 2 : 1);
        if (!is_on) return glBlendFunc(GL_ONE, GL_ZERO);
        if (purpose == "layers") return glBlendFunc(GL_ONE, GL_ONE);
        if (order_ != weighted) return glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glBlendFunci(0, GL_ONE, GL_ONE);
        glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
    }

    const Program& program_of(const Piece& piece, const std::string& purpose, int filter) const {
        static constexpr std::array filter_kinds = {0, 1, 2, 2, 2, 2, 3}, taps = {1, 1, 2, 4, 8, 16, 1};
        const bool is_flat = purpose == "FLAT", is_light = purpose.empty(), is_named = is_flat || purpose == "MEASURE";
        const bool branches = programs_ == 1 && is_light;
        const unsigned features = branches ? all_features : piece.features;
        const bool reads_colors = (features & color_map) && (is_light || purpose == "MEASURE");
        const bool draws_mask = (features & mask_map) && (is_light || is_flat || purpose == "coverage");
        const size_t reads = reads_colors ? size_t(filter) : 1;
        return surface_.with(
            {is_light   ? Define("")
             : is_named ? Define(purpose)
                        : Define("PROBE_" + purpose),
             fmt::format("FEATURES {}", features), branches ? "BRANCHES" : "",
             fmt::format("LAMP {}", is_light || purpose == "lamp" ? std::min(lamp_, int(sun)) : int(sun)),
             fmt::format("FILTER {}", filter_kinds[reads]), fmt::format("TAPS {}", taps[reads]),
             fmt::format("ALPHA {}", !draws_mask ? int(test)
                                     : is_flat   ? int(keep)
                                                 : alpha_),
             is_light || is_flat || purpose == "coverage" || !piece.has(mask_map) ? "" : "PLAIN_MASK",
             is_light && is_stored() ? "STORED" : "",
             is_light && order_ == weighted && piece.is_glass() ? "WEIGHTED" : ""});
    }

    void set_frame(const Program& program, const Frame& frame) {
        const Lights lights = this->lights();
        program.set("u_clip_from_world", frame.camera.clip_from_world());
        program.set("u_eye", frame.camera.eye());
        program.set("u_threshold", threshold_);
        program.set("u_to_sun", lights.to_sun);
        program.set("u_sun", lights.sun);
        program.set("u_sky", lights.sky);
        program.set("u_ground", lights.ground);
        set_lamp(program, lights);
    }

    static void set_lamp(const Program& program, const Lights& lights) {
        program.set("u_lamp", lights.place);
        program.set("u_lamp_light", lights.light);
        program.set("u_axis", lights.axis);
        program.set("u_range", lights.range);
        program.set("u_cone", lights.cone);
        program.set("u_attenuation", lights.attenuation);
    }

    void set_piece(const Program& program, Loaded& loaded, const Piece& piece) {
        const Material& material = piece.material;
        program.set("u_diffuse", material.diffuse);
        program.set("u_shine", glm::vec4(material.specular, std::max(material.shininess, 1.0f)));
        program.set("u_emission", material.emission);
        program.set("u_opacity", material.opacity);
        program.set("u_bump", material.bump_scale);
        program.set("u_tiling", piece.has(mask_map) && !piece.has(color_map) ? fence_ : 1.0f);
        program.set("u_features", int(piece.features));
        program.set("u_flat", program_color(piece.program));
        if (piece.has(mask_map) && alpha_ != hashed) {
            const std::vector<float>& scales = scales_of(loaded, piece.mask);
            for (size_t i = 0; i < 12; ++i)
                program.set(fmt::format("u_scales[{}]", i).c_str(), scales[std::min(i, scales.size() - 1)]);
        }
        const auto map = [&](const char* sampler, int unit, const std::string& asset, ColorSpace space) {
            if (asset.empty() && programs_ == 0) return;
            program.set(sampler, unit, asset.empty() ? no_map_ : texture(loaded, asset, space));
        };
        map("s_colors", 0, piece.colors, ColorSpace::srgb);
        map("s_highlights", 1, piece.highlights, ColorSpace::linear);
        map("s_bumps", 2, piece.bumps, ColorSpace::linear);
        map("s_mask", 3, piece.mask, ColorSpace::linear);
    }

    static const Texture& texture(Loaded& loaded, const std::string& asset, ColorSpace space) {
        const std::string key = (space == ColorSpace::srgb ? "color " : "") + asset;
        const auto found = loaded.textures.find(key);
        return found != loaded.textures.end()
                   ? found->second
                   : loaded.textures.emplace(key, load_texture(asset.c_str(), space)).first->second;
    }

    static const std::vector<float>& scales_of(Loaded& loaded, const std::string& mask) {
        std::vector<float>& scales = loaded.scales[mask];
        if (scales.empty()) scales = kept_scales(levels_of(mask));
        return scales;
    }

    /// Returns the mip levels of a mask as in its texture, rounded to 8 bits.
    static std::vector<Image> levels_of(const std::string& mask) {
        std::vector<Image> levels = mip_chain(read_asset(mask), ColorSpace::linear);
        for (Image& level : levels)
            for (float& alpha : level.values) alpha = std::round(alpha * 255) / 255;
        return levels;
    }

    static glm::vec3 program_color(int program) {
        static constexpr std::array<glm::vec3, 8> colors = {{{0.20f, 0.62f, 0.25f},
                                                             {0.55f, 0.55f, 0.75f},
                                                             {0.85f, 0.32f, 0.16f},
                                                             {0.75f, 0.72f, 0.62f},
                                                             {0.16f, 0.55f, 0.85f},
                                                             {0.85f, 0.72f, 0.12f},
                                                             {0.75f, 0.22f, 0.62f},
                                                             {0.20f, 0.70f, 0.65f}}};
        return colors[size_t(program) % colors.size()];
    }

    void describe(const Frame& frame, const std::vector<View>& views) {
        const Scene& scene = loaded(maps_ != maps_off).scene;
        if (view_ == ground) {
            static constexpr std::array titles = {"nearest texel", "mip levels", "4 taps", "16 taps"};
            for (size_t i = 0; i < views.size(); ++i) {
                labels_.caption(frame.size, views[i].tile, 0, titles[i]);
                if (const double error = measure(i, views[i]); std::isfinite(error))
                    labels_.caption(frame.size, views[i].tile, -1, fmt::format("{:.1f} % off", 100 * error));
            }
        }
        if (view_ == garden) {
            list(frame, views[0].tile, scene);
            if (maps_ == wipe) {
                const float middle = float(views[1].part.size.x);
                labels_.rectangle({middle - 0.5f, 0}, {1, float(frame.size.y)}, {1, 1, 1, 0.4f});
            }
        }
        if (file_ == ground_file || file_ == broken_file) write_notes(frame, scene);
    }

    /// Writes the scene's notes along the lower edge.
    void write_notes(const Frame& frame, const Scene& scene) {
        const float line = Labels::line_height(frame.size) * 0.62f;
        float top = float(frame.size.y) - 1.3f * line * float(scene.notes.size() + 1);
        for (const std::string& whole : scene.notes) {
            const std::string note = whole.substr(whole.rfind('/', whole.find(':')) + 1);  // without the folder
            labels_.text(note, {line, top}, std::min(line, 1.8f * float(frame.size.x) / float(note.size() + 4)));
            top += 1.3f * line;
        }
    }

    /// Lists the materials below a tile: name, features and triangles, in the colour of the program.
    void list(const Frame& frame, const Tile& tile, const Scene& scene) {
        const float left = float(tile.corner.x), width = float(tile.size.x),
                    top = float(tile.size.y) + 0.03f * float(frame.size.y),
                    line = std::min(width / 17.5f, (float(frame.size.y) - top) / (1.35f * float(most_listed + 2)));
        labels_.rectangle({left, float(tile.size.y)}, {width, float(frame.size.y - tile.size.y)},
                          {0.05f, 0.055f, 0.065f, 1});
        labels_.text(fmt::format("{} materials, {} programs,", scene.pieces.size(), scene.programs), {left + line, top},
                     line);
        labels_.text(fmt::format("{} draws", scene.pieces.size()), {left + line, top + 1.25f * line}, line);
        labels_.text("triangles", {left + width - line, top + 1.25f * line}, line, Align::right);
        for (size_t i = 0; i < std::min(scene.pieces.size(), size_t(most_listed)); ++i) {
            const Piece& piece = scene.pieces[i];
            const float y = top + line * (2.9f + 1.3f * float(i));
            const glm::vec3 color = glm::pow(program_color(piece.program), glm::vec3(1 / 2.2f));
            labels_.rectangle({left + line, y + 0.1f * line}, {0.8f * line, 0.8f * line}, glm::vec4(color, 1));
            labels_.text(piece.material.name.substr(0, 12), {left + 2.4f * line, y}, line, Align::left,
                         highlight_ == int(i) + 1 ? glm::vec3(1, 0.85f, 0.4f) : glm::vec3(0.93f, 0.92f, 0.89f));
            labels_.text(words(piece.features), {left + 8.6f * line, y}, line);
            labels_.text(fmt::format("{}", piece.index_count / 3), {left + width - line, y}, line, Align::right);
        }
    }

    /// Returns the mean error of a filter's colours compared with 1024 samples, as a share of their mean. Infinity
    /// before the tasks are written.
    double measure(size_t place, const View& view) {
        std::vector<std::string> knobs;
        for (const KnobText& knob : describe_knobs(*this)) knobs.push_back(knob.value);
        return errors_[place].get({knobs, surface_.renewals()}, [&] {
            const glm::ivec2 size(48, 32);
            const Image drawn = draw_numbers(size, [&] {
                const Orbit low{.yaw = -12, .pitch = 5, .distance = 7, .target = {-0.3, 0, -1}, .field_of_view = 40};
                draw_pieces({0, size, 0, Camera(low, 1.5), {}}, loaded(true), "MEASURE", view.filter);
            });
            double off = 0, sum = 0;
            for (size_t i = 0; i < drawn.values.size(); i += 4)
                if (std::isfinite(drawn.values[i])) off += double(drawn.values[i]), sum += double(drawn.values[i + 1]);
            return sum > 0 ? off / sum : HUGE_VAL;
        });
    }

    /// Draws levels 0 to 5 of the wires' mask in four rows: threshold, kept coverage, alpha to coverage, mean.
    void draw_levels(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const int rows = frame.probe ? 1 : 4;
        const std::vector<Tile> tiles = tile_grid(frame.size, levels_shown, rows);
        for (int row = 0; row < rows; ++row)
            for (int level = 0; level < levels_shown; ++level) {
                const Tile& tile = tiles[size_t(row * levels_shown + level)];
                if (tile.size.x <= 0 || tile.size.y <= 0) continue;
                glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
                const int method = frame.probe ? alpha_ : row;
                draw_level(level, method, frame.probe);
                if (frame.probe) continue;
                const std::string name = row == 0 ? fmt::format("above {:.2f}", threshold_)
                                                  : std::array{"", "kept", "kept, smooth", "alpha"}[size_t(row)];
                labels_.caption(frame.size, tile, 0, fmt::format("{}, level {}", name, level));
                if (const double share = measure_level(level, method); std::isfinite(share))
                    labels_.caption(frame.size, tile, -1, fmt::format("{:.1f} %", 100 * share));
            }
    }

    void draw_level(int level, int method, const Define& purpose) {
        if (!masks_) masks_.emplace(load_texture(mask_of_levels, ColorSpace::linear));
        if (level_scales_.empty()) level_scales_ = kept_scales(levels_of(mask_of_levels));
        const Program& program = levels_.with({purpose, fmt::format("ALPHA {}", method)});
        glUseProgram(program);
        program.set("s_mask", 0, *masks_);
        program.set("u_level", level);
        program.set("u_scale", level_scales_[size_t(level)]);
        program.set("u_threshold", threshold_);
        program.set("u_part", 0.25f);
        draw_window();
    }

    double measure_level(int level, int method) {
        return coverages_[size_t(method * levels_shown + level)].get({threshold_, levels_.renewals()}, [&] {
            return double(draw_numbers({1, 1}, [&] { draw_level(level, method, "MEASURE"); }).values[0]);
        });
    }

    static double metres_per_pixel(glm::ivec2 size) { return 5.0 / std::max(1, std::min(size.x, size.y)); }

    void draw_cone(const Frame& frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        const Program& program = cut_.with(frame.probe);
        glUseProgram(program);
        set_lamp(program, lights());
        program.set("u_middle", glm::vec2(frame.size) / 2.0f);
        program.set("u_pixel", metres_per_pixel(frame.size));
        draw_window();
    }

    Programs surface_{"08_obj_materials/surface.vert", "08_obj_materials/surface.frag"};
    Programs sky_{"08_obj_materials/window.vert", "08_obj_materials/sky.frag"};
    Programs encode_{"08_obj_materials/window.vert", "08_obj_materials/encode.frag"};
    Programs levels_{"08_obj_materials/window.vert", "08_obj_materials/levels.frag"};
    Programs cut_{"08_obj_materials/window.vert", "08_obj_materials/cone.frag"};
    Texture no_map_{"no map", [] { return Image(1, 1, 1, 8); }};
    GpuMesh nothing_ = upload([] { return Mesh{}; });
    std::optional<LightTarget> target_;
    std::tuple<glm::ivec2, int, int> target_is_for_;
    mutable std::array<Kept<std::unique_ptr<Loaded>, int>, 2> scenes_;  ///< index 0 without maps, 1 with them; by file
    std::optional<Texture> masks_;
    std::vector<float> level_scales_;
    std::array<Kept<double, std::vector<std::string>, int>, 4> errors_;
    std::array<Kept<double, float, int>, 4 * levels_shown> coverages_;
    Labels labels_;

    int view_ = garden, file_ = garden_file, maps_ = maps_on, programs_ = 0, order_ = sorted, blend_in_ = 0,
        alpha_ = to_coverage, filter_ = 1, lamp_ = spot_lamp, highlight_ = 0;
    float threshold_ = 0.5f, fence_ = 1, range_ = 7, cone_ = 2, lamp_height_ = 1.45f;
    DistantLight light_{.yaw = 165, .pitch = 4};
};

RELIEF_LAB(ObjMaterials);

}  // namespace relief::materials
