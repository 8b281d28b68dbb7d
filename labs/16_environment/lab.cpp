// Lab 16: environment.
//
// One bumped normal serves all lights: the light of the sky, the lamps, and the mirrored sky. Each of them is hidden in
// its own way. Your tasks: shaders/16_environment/task.glsl
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "framework/gl/cube_texture.h"
#include "framework/gl/depth_target.h"
#include "framework/gl/texel_target.h"
#include "framework/kit/kept.h"
#include "framework/kit/labels.h"
#include "framework/kit/light.h"
#include "framework/kit/tiles.h"
#include "framework/lab/lab.h"
#include "scene.h"
#include "truth.h"

namespace relief::court {

class Environment final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (seamless_) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        if (frame.probe || view_ != terms) {
            draw_view(frame, {{0, 0}, frame.size}, frame.probe);
            if (!frame.probe && view_ == one_pixel) describe_pixel(frame);
        } else {
            const std::vector<Tile> tiles = tile_grid(frame.size, 3, 2);
            for (size_t i = 0; i < tiles.size(); ++i) {
                draw_view(frame_in(frame, tiles[i]), tiles[i], fmt::format("SHOW {}", i + 1));
                labels_.caption(frame.size, tiles[i], 0, shown[i]);
            }
        }
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views, "the court; each light and what hides it; or the sum at one pixel");
        knobs.choice("scene", scene_, scenes, "the court; two walls that meet; a plane, alone or under a board");
        knobs.group("Mirror");
        knobs.toggle("reflection", reflection_, "the mirrored sky");
        knobs.choice("fresnel", fresnel_, fresnels, "the share that is mirrored: all, Schlick's approximation, exact");
        knobs.choice("gloss", gloss_, glosses, "exponents by the packed map, all the largest, or a sky without blur");
        knobs.slider("exponent", exponent_, 0, 512, "exponent of the glossiest place");
        knobs.slider("roughness", roughness_, 0, 1, "1 makes everything rough");
        knobs.choice("normal_for", normal_for_, normal_fors, "what the bumped normal serves: all, or only the lamps");
        knobs.toggle("seamless", seamless_, "filter across the edges of the cube map");
        knobs.group("Shadow of the sun");
        knobs.toggle("shadow", shadow_, "the sun's shadow");
        knobs.choice("shadow_texels", shadow_texels_, texel_counts, "texels along an edge of the shadow map");
        knobs.steps("pcf", pcf_, 0, 2, "texels around a place that are compared, in each direction");
        knobs.choice("bias", bias_, biases, "how much nearer a place counts: not at all, by a texel, by its plane");
        knobs.group("Occlusion");
        knobs.toggle("ao", ao_, "occlusion by what is near in the picture");
        knobs.steps("slices", slices_, 1, 16, "planes in which horizons are looked for");
        knobs.steps("taps", taps_, 1, 48, "places looked at on each side of a plane");
        knobs.toggle("occlusion", occlusion_, "the packed map's occlusion");
        knobs.group("Scene");
        knobs.steps("lamps", lamps_, 1, 3, "the sun, and up to two lanterns");
        knobs.toggle("displace", displace_, "the court's floor rises above its puddles");
        knobs.slider("tilt", tilt_, -89, 89, "how steep the groove or the plane is, degrees");
        knobs.choice("level", level_, levels, "mip level of the surfaces' maps");
        knobs.group("One pixel");
        knobs.slider("pixel_x", pixel_.x, 0, 1, "for view = one-pixel: place from the left, in widths");
        knobs.slider("pixel_y", pixel_.y, 0, 1, "for view = one-pixel: place from the top, in heights");
        light_.knobs(knobs, -90, 90);
    }

    std::optional<Image> truth(const Frame& frame, const Probe& probe) const override {
        return court::truth(frame, probe, lighting());
    }

private:
    enum View { court_, terms, one_pixel };
    static constexpr std::array views = {"court", "terms", "one-pixel"};
    static constexpr std::array scenes = {"court", "groove", "plane", "board"};
    static constexpr std::array fresnels = {"whole", "schlick", "exact"};
    static constexpr std::array glosses = {"map", "even", "mirror"};
    static constexpr std::array normal_fors = {"all", "lamps"};
    static constexpr std::array texel_counts = {"256", "512", "1024", "2048"};
    static constexpr std::array biases = {"none", "constant", "plane"};
    static constexpr std::array levels = {"mip", "0"};
    static constexpr std::array shown = {"light of the sky", "lamps",    "mirrored sky",
                                         "x occlusion",      "x shadow", "x gloss and Fresnel"};
    static constexpr int sky_texels = 128;
    static constexpr std::array<glm::dvec3, 2> ambient = {{{0.085, 0.060, 0.065}, {0.210, 0.225, 0.360}}};
    static constexpr std::array<glm::dvec3, 3> lamp_colors = {{{4.2, 2.2, 0.9}, {2.4, 1.15, 0.40}, {0.55, 0.85, 1.5}}};
    static constexpr std::array<glm::dvec3, 3> lamp_places = {{{0, 0, 0}, {-6.1, 2.1, -1.0}, {4.5, 2.4, 2.0}}};

    Place place() const { return Place(scene_); }
    bool is_displaced() const { return displace_ && place() == Place::court; }
    /// Upper bound of the rounding error in the depth map, in depths: a few units in the last place of a float.
    static constexpr double rounding = 1e-6;

    Lighting lighting() const {
        Lighting all;
        all.scene = make_scene(place(), double(tilt_));
        all.is_displaced = is_displaced();
        all.to_sun = light_.direction<double>(), all.sun_yaw_rad = glm::radians(double(light_.yaw));
        all.lamps = lamps_, all.lamp_color = lamp_colors, all.lamp_place = lamp_places, all.ambient = ambient;
        all.exponent = double(exponent_), all.roughness = double(roughness_);
        all.fresnel = Fresnel(fresnel_), all.gloss = Gloss(gloss_);
        all.reflection = reflection_, all.shadow = shadow_, all.ao = ao_, all.occlusion = occlusion_;
        all.light_only = normal_for_ == 1;
        return all;
    }

    // ---- the scene's meshes

    struct Stage {
        Scene scene;
        std::vector<GpuMesh> meshes;
    };
    const Stage& stage() {
        return stage_.get({scene_, tilt_, is_displaced()}, [&] {
            Stage made{make_scene(place(), double(tilt_)), {}};
            for (int i = 0; i < materials; ++i)
                made.meshes.push_back(upload([scene = made.scene, i, displaced = is_displaced()] {
                    return mesh_of(scene, Material(i), displaced);
                }));
            return made;
        });
    }

    bool is_there(int material) {
        const Scene& scene = stage().scene;
        const auto is_it = [&](const auto& thing) { return thing.material == Material(material); };
        return std::any_of(scene.quads.begin(), scene.quads.end(), is_it) ||
               std::any_of(scene.boxes.begin(), scene.boxes.end(), is_it) ||
               (Material(material) == Material::marble && !scene.columns.empty());
    }

    /// Draws the triangles of each material by the program that program_of(material) returns. Occluders come first, the
    /// floor last.
    template <class ProgramOf>
    void draw_meshes(const glm::dmat4& clip_from_world, ProgramOf program_of) {
        for (int i = materials - 1; i >= 0; --i) {
            if (!is_there(i)) continue;
            const Program& program = program_of(i);
            program.set("u_clip_from_world", clip_from_world);
            const GpuMesh& mesh = stage().meshes[size_t(i)];
            glBindVertexArray(mesh.layout());
            glDrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
        }
    }

    const char* displaced(int material) const {
        return Material(material) == Material::floor && is_displaced() ? "DISPLACED" : "";
    }

    static void set_ground(const Program& program) {
        for (int i = 0; i < ground_waves; ++i)
            program.set(fmt::format("u_ground[{}]", i).c_str(), glm::vec4(ground_terms[size_t(i)]));
        program.set("u_water", water);
        program.set("u_rise", rise);
    }

    // ---- the sun's depth map

    struct SunView {
        glm::dmat3 light_from_world;
        glm::dmat4 clip_from_world;
        double texel, depths;  ///< metres
    };
    SunView sun_view() {
        const glm::dvec3 to_sun = light_.direction<double>();
        const Axes axes = axes_of(to_sun);  // valid for a sun at the zenith, too
        SunView view;
        view.light_from_world = glm::transpose(glm::dmat3(axes.right, axes.up, to_sun));
        const Scene& scene = stage().scene;
        const double top = is_displaced() ? 0.3 : 0;
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 corner(i & 1 ? scene.high.x : scene.low.x, i & 2 ? scene.high.y + top : scene.low.y,
                                    i & 4 ? scene.high.z : scene.low.z);
            low = glm::min(low, view.light_from_world * corner), high = glm::max(high, view.light_from_world * corner);
        }
        const double side = std::max(high.x - low.x, high.y - low.y) * 1.01;
        view.texel = side / texels(), view.depths = (high.z - low.z) * 1.01 + 1e-3;
        const glm::dvec3 middle = (low + high) / 2.0;
        const glm::dmat4 clip_from_light(2 / side, 0, 0, 0, 0, 2 / side, 0, 0, 0, 0, -2 / view.depths, 0,
                                         -2 * middle.x / side, -2 * middle.y / side, 2 * middle.z / view.depths, 1);
        view.clip_from_world = clip_from_light * glm::dmat4(view.light_from_world);
        return view;
    }
    int texels() const { return 256 << shadow_texels_; }

    const DepthTarget& shadow_map(const SunView& sun) {
        const Program &plain = depth_.with(""), &raised = depth_.with(is_displaced() ? "DISPLACED" : "");
        return *shadow_map_.get({texels(), sun.clip_from_world, stage_.version(), GLuint(plain), GLuint(raised)}, [&] {
            auto map = std::make_unique<DepthTarget>(glm::ivec2(texels()));
            map->begin();
            glClear(GL_DEPTH_BUFFER_BIT);
            draw_meshes(sun.clip_from_world, [&](int i) -> const Program& {
                const Program& program = *displaced(i) ? raised : plain;
                glUseProgram(program);
                set_ground(program);
                return program;
            });
            return map;
        });
    }

    // ---- ambient occlusion

    static double half_height(const Frame& frame) {
        return std::tan(glm::radians(frame.camera.orbit().field_of_view) / 2);
    }

    const TexelTarget& openness(const Frame& frame) {
        // A picture gets its occlusion at half the resolution, a probe at the full one.
        const glm::ivec2 size = frame.probe ? frame.size : glm::max((frame.size + 1) / 2, 1);
        Nearby& near = *nearby_.get({size}, [&] { return std::make_unique<Nearby>(size); });
        near.surfaces.begin();
        constexpr float nothing[] = {0, 0, 0, 0};
        glClearBufferfv(GL_COLOR, 0, nothing);
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_meshes(frame.camera.clip_from_world(), [&](int i) -> const Program& {
            const Program& program = near_.with(displaced(i));
            glUseProgram(program);
            program.set("u_view_from_world", glm::mat3(frame.camera.view_from_world()));
            set_ground(program);
            return program;
        });
        glDisable(GL_DEPTH_TEST);
        glBindVertexArray(nothing_.layout());
        near.open.begin();
        const Program& search = search_.with();
        glUseProgram(search);
        near.surfaces.bind(0);
        search.set("s_surface", 0);
        const double up = half_height(frame);
        search.set("u_half", glm::vec2(up * frame.size.x / std::max(1, frame.size.y), up));
        search.set("u_slices", slices_);
        search.set("u_taps", taps_);
        search.set("u_reach", stage().scene.reach);
        search.set("u_most", place() == Place::court ? 0.25 * size.y : 1.0 * size.y);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        near.smoothed.begin();
        const Program& smooth = smooth_.with();
        glUseProgram(smooth);
        near.open.bind(0);
        smooth.set("s_open", 0);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glEnable(GL_DEPTH_TEST);
        return near.smoothed;
    }

    // ---- the picture

    struct Needs {
        bool shadow, open, sky;
    };
    Needs needs(const std::string& purpose) const {
        const bool whole = purpose.empty() || purpose == "PROBE_light" || purpose == "TERMS";
        return {shadow_ && (whole || purpose == "PROBE_shadow" || purpose == "SHOW 5"),
                ao_ && (whole || purpose == "PROBE_occlusion" || purpose == "SHOW 4"),
                reflection_ && (whole || purpose == "PROBE_reflection" || purpose == "SHOW 3")};
    }

    void draw_view(const Frame& frame, const Tile& tile, const Define& purpose) {
        if (frame.size.x <= 0 || frame.size.y <= 0) return;
        const Needs need = needs(purpose.text);
        const SunView sun = sun_view();
        const DepthTarget* shadows = need.shadow ? &shadow_map(sun) : nullptr;
        const TexelTarget* open = need.open ? &openness(frame) : nullptr;
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        draw_surfaces(frame, sun, shadows, open, purpose);
        if (!frame.probe) draw_sky(frame);
    }

    static glm::dvec3 row(const Frame& frame, int i) {
        const glm::dmat4 view = frame.camera.view_from_world();
        return {view[0][i], view[1][i], view[2][i]};
    }

    void set_sky(const Program& program) {
        const double yaw = glm::radians(double(light_.yaw));
        program.set("u_sun", glm::vec2(std::sin(yaw), std::cos(yaw)));
        program.set("s_sky", 5, sky_map_);
    }

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with();
        glUseProgram(program);
        const double up = half_height(frame), right = up * frame.size.x / frame.size.y;
        program.set("u_forward", -row(frame, 2));
        program.set("u_right", row(frame, 0) * right);
        program.set("u_up", row(frame, 1) * up);
        set_sky(program);
        glDepthFunc(GL_LEQUAL);  // the sky is at the far plane, so it shows where nothing was drawn
        glBindVertexArray(nothing_.layout());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDepthFunc(GL_LESS);
    }

    void draw_surfaces(const Frame& frame, const SunView& sun, const DepthTarget* shadows, const TexelTarget* open,
                       const Define& purpose) {
        const Needs need = needs(purpose.text);
        draw_meshes(frame.camera.clip_from_world(), [&](int i) -> const Program& {
            const Program& program = surface_.with(
                {purpose, Material(i) == Material::floor ? "FLOOR" : "", displaced(i), need.sky ? "REFLECTION" : "",
                 fmt::format("FRESNEL {}", fresnel_), fmt::format("GLOSS {}", gloss_), shadows ? "SHADOW" : "",
                 fmt::format("BIAS {}", shadows ? bias_ : 0), open ? "AO" : "", occlusion_ ? "OCCLUSION" : "",
                 fmt::format("LAMPS {}", lamps_), normal_for_ == 1 ? "LIGHT_ONLY" : "",
                 level_ == 1 || purpose.text == "TERMS" ? "LEVEL_0" : ""});
            glUseProgram(program);
            set_ground(program);
            set_sky(program);
            program.set("u_eye", frame.camera.eye());
            program.set("u_roughness", roughness_);
            program.set("u_exponent", exponent_);
            program.set("u_side", float(sky_texels));
            for (size_t c = 0; c < 2; ++c) program.set(fmt::format("u_ambient[{}]", c).c_str(), ambient[c]);
            for (size_t lamp = 0; lamp < size_t(lamps_); ++lamp) {
                program.set(fmt::format("u_lamp_color[{}]", lamp).c_str(), lamp_colors[lamp]);
                program.set(fmt::format("u_lamp_place[{}]", lamp).c_str(),
                            lamp == 0 ? light_.direction<double>() : lamp_places[lamp]);
            }
            program.set("u_light_from_world", glm::mat3(sun.light_from_world));
            program.set("u_light_clip_from_world", sun.clip_from_world);
            program.set("u_shadow", glm::vec3(sun.texel, sun.depths, rounding));
            program.set("u_pcf", pcf_);
            const Maps& maps = maps_[size_t(i)];
            program.set("s_albedo", 0, maps.albedo);
            program.set("s_normals", 1, maps.normals);
            program.set("s_packed", 2, maps.packed);
            if (open) open->bind(3), program.set("s_open", 3);
            if (shadows) shadows->bind(4), program.set("s_shadow", 4);
            return program;
        });
    }

    // ---- one pixel

    void describe_pixel(const Frame& frame) {
        const glm::ivec2 at = glm::clamp(glm::ivec2(pixel_ * glm::vec2(frame.size)), glm::ivec2(0), frame.size - 1);
        const Terms drawn = terms_at(frame, at);
        const std::optional<Terms> exact = exact_terms(frame.ray(at.x, at.y), lighting());
        const float line = Labels::line_height(frame.size), wide = Labels::width("x", line);
        const glm::vec2 cross = glm::vec2(at) + 0.5f;
        for (const glm::vec4 color : {glm::vec4(0, 0, 0, 0.6f), glm::vec4(1, 0.95f, 0.7f, 1)}) {
            const float thick = color.a < 1 ? 3.0f : 1.0f, long_ = line;
            labels_.rectangle(cross - glm::vec2(long_, thick / 2), {0.7f * long_, thick}, color);
            labels_.rectangle(cross + glm::vec2(0.3f * long_, -thick / 2), {0.7f * long_, thick}, color);
            labels_.rectangle(cross - glm::vec2(thick / 2, long_), {thick, 0.7f * long_}, color);
            labels_.rectangle(cross + glm::vec2(-thick / 2, 0.3f * long_), {thick, 0.7f * long_}, color);
        }
        const auto grey = [](const glm::dvec3& light) { return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)); };
        std::vector<std::string> lines = {
            fmt::format("{:20} {:>8}{}", "", "shader", exact ? fmt::format(" {:>8}", "double") : "")};
        const auto add = [&](const char* name, double shader, double truth) {
            lines.push_back(fmt::format("{:20} {:8.4f}{}", name, shader, exact ? fmt::format(" {:8.4f}", truth) : ""));
        };
        const Terms& right = exact ? *exact : drawn;
        add("light of the sky", grey(drawn.ambient), grey(right.ambient));
        add("  x occlusion", drawn.occlusion, right.occlusion);
        add("+ lamps", grey(drawn.lamps), grey(right.lamps));
        add("  (shadow", drawn.shadow, right.shadow);
        lines.back() += ")";
        add("+ mirrored sky", grey(drawn.mirror), grey(right.mirror));
        add("  (share", drawn.share, right.share);
        lines.back() += ")";
        add("= light", grey(drawn.light), grey(right.light));
        const float top = float(frame.size.y) - (float(lines.size()) + 0.6f) * line;
        for (size_t i = 0; i < lines.size(); ++i) labels_.text(lines[i], {wide, top + float(i) * line}, line);
    }

    /// Returns the terms that the shader computes at a pixel, or default ones if there is no surface.
    Terms terms_at(const Frame& frame, glm::ivec2 at) {
        if (!pixel_target_)
            pixel_target_.emplace(glm::ivec2(1),
                                  std::initializer_list<GLenum>{GL_RGBA32F, GL_RGBA32F, GL_RGBA32F, GL_RGBA32F}, false,
                                  true);
        const SunView sun = sun_view();
        const DepthTarget* shadows = shadow_ ? &shadow_map(sun) : nullptr;
        const TexelTarget* open = ao_ ? &openness(frame) : nullptr;
        pixel_target_->begin();
        constexpr float nothing[] = {0, 0, 0, 0};
        for (int i = 0; i < 4; ++i) glClearBufferfv(GL_COLOR, i, nothing);
        glClear(GL_DEPTH_BUFFER_BIT);
        glViewport(-at.x, at.y + 1 - frame.size.y, frame.size.x, frame.size.y);
        draw_surfaces(frame, sun, shadows, open, "TERMS");
        std::array<glm::dvec4, 4> values;
        for (size_t i = 0; i < 4; ++i) {
            const Image texel = pixel_target_->read(i);
            for (int c = 0; c < 4; ++c) values[i][c] = double(texel.values[size_t(c)]);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        return {values[0], values[1], values[2], values[3], values[0].w, values[1].w, values[2].w};
    }

    struct Maps {
        Texture albedo, normals, packed;
    };
    static Maps maps_of(const std::string& name) {
        return {load_texture((name + "_albedo.png").c_str(), ColorSpace::srgb),
                load_texture((name + "_normal.png").c_str(), ColorSpace::linear),
                load_texture((name + "_packed.png").c_str(), ColorSpace::linear)};
    }
    static Texture even(const char* title, const glm::vec3& value) {
        return Texture(title, [value] {
            Image texel(1, 1, 3);
            for (int c = 0; c < 3; ++c) texel.values[size_t(c)] = value[c];
            return texel;
        });
    }
    struct Nearby {
        TexelTarget surfaces, open, smoothed;
        explicit Nearby(glm::ivec2 size)
            : surfaces(size, {GL_RGBA32F}, false, true), open(size, {GL_RGBA32F}), smoothed(size, {GL_RGBA32F}) {}
    };

    Programs surface_{"16_environment/scene.vert", "16_environment/surface.frag"};
    Programs depth_{"16_environment/scene.vert", "16_environment/depth.frag"};
    Programs near_{"16_environment/scene.vert", "16_environment/near.frag"};
    Programs search_{"16_environment/window.vert", "16_environment/occlusion.frag"};
    Programs smooth_{"16_environment/window.vert", "16_environment/smooth.frag"};
    Programs sky_{"16_environment/window.vert", "16_environment/sky.frag"};
    CubeTexture sky_map_{"evening sky", sky_texels, sky};
    std::array<Maps, materials> maps_ = {
        maps_of("paving"), maps_of("bricks"), maps_of("paving"),
        Maps{load_texture("marble_albedo.png", ColorSpace::srgb), even("flat normal", {0.5f, 0.5f, 1}),
             even("polish", {float(marble_gloss), 1, 1})}};
    GpuMesh nothing_ = upload([] { return Mesh{}; });
    Kept<Stage, int, float, bool> stage_;
    Kept<std::unique_ptr<DepthTarget>, int, glm::dmat4, int, GLuint, GLuint> shadow_map_;
    Kept<std::unique_ptr<Nearby>, glm::ivec2> nearby_;
    std::optional<TexelTarget> pixel_target_;
    Labels labels_;

    int view_ = court_, scene_ = 0, fresnel_ = 1, gloss_ = 0, normal_for_ = 0, shadow_texels_ = 2, pcf_ = 1, bias_ = 2;
    int slices_ = 2, taps_ = 5, lamps_ = 2, level_ = 0;
    bool reflection_ = true, seamless_ = true, shadow_ = true, ao_ = true, occlusion_ = true, displace_ = true;
    float exponent_ = 256, roughness_ = 0, tilt_ = 30;
    glm::vec2 pixel_{0.7f, 0.93f};
    DistantLight light_{.yaw = 162, .pitch = 10};
};

RELIEF_LAB(Environment);

}  // namespace relief::court
