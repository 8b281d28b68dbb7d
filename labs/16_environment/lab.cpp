// Lab 16: environment.
//
// One bumped normal serves all lights: the light of the sky, the lamps, and the mirrored sky. Each of them is hidden in
// its own way. Your tasks: shaders/16_environment/task.glsl
#include <fmt/format.h>

#include "framework/core/gl/cube_texture.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/evening_sky.h"
#include "framework/library/kit/labels.h"
#include "framework/library/kit/light.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/uniforms.h"
#include "occlusion.h"
#include "one_pixel.h"
#include "stage.h"
#include "sun_shadow.h"
#include "truth.h"

namespace relief::court {

class Environment final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (seamless_) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        if (view_ == terms && !frame.probe)
            draw_terms(frame);
        else if (view_ == one_pixel && !frame.probe)
            draw_and_describe_pixel(frame);
        else
            draw_view(frame, {{0, 0}, frame.size}, frame.probe);
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        labels_.draw(frame);
    }

    void knobs(Knobs& knobs) override {
        knobs.group("Picture");
        knobs.choice("view", view_, views.names, "the court; each light and what hides it; or the sum at one pixel");
        knobs.choice("scene", stage_.place, Stage::places.names,
                     "the court; two walls that meet; a plane, alone or under a board");
        knobs.group("Mirror");
        knobs.toggle("reflection", reflection_, "the mirrored sky");
        knobs.choice("fresnel", fresnel_, fresnels.names,
                     "the share that is mirrored: all, Schlick's approximation, exact");
        knobs.choice("gloss", gloss_, glosses.names,
                     "exponents by the packed map, all the largest, or a sky without blur");
        knobs.slider("exponent", exponent_, 0, 512, "exponent of the glossiest place");
        knobs.slider("roughness", roughness_, 0, 1, "1 makes everything rough");
        knobs.choice("normal_for", normal_for_, normal_fors.names,
                     "what the bumped normal serves: all, or only the lamps");
        knobs.choice("mirror_occlusion", mirror_occlusion_, mirror_occlusions.names,
                     "what hides the mirrored sky: nothing, the occlusion of the sky's light, or a guess from it");
        knobs.toggle("seamless", seamless_, "filter across the edges of the cube map");
        knobs.group("Shadow of the sun");
        knobs.toggle("shadow", shadow_.on, "the sun's shadow");
        knobs.choice("shadow_texels", shadow_.texels, SunShadow::texel_counts,
                     "texels along an edge of the shadow map");
        knobs.steps("pcf", shadow_.pcf, 0, 2,
                    KnobHelp("texels around a place that are compared, in each direction").titled("PCF radius"));
        knobs.choice(
            "bias", shadow_.bias, SunShadow::biases.names,
            KnobHelp("how much nearer a place counts: not at all, by a texel, by its plane").titled("Shadow bias"));
        knobs.group("Occlusion");
        knobs.toggle("ao", occlusion_.on,
                     KnobHelp("occlusion by what is near in the picture").titled("Ambient occlusion"));
        knobs.steps("slices", occlusion_.slices, 1, 16,
                    KnobHelp("planes in which horizons are looked for").titled("AO slices"));
        knobs.steps("taps", occlusion_.taps, 1, 48,
                    KnobHelp("places looked at on each side of a plane").titled("AO taps"));
        knobs.toggle("occlusion", map_occlusion_, "the packed map's occlusion");
        knobs.group("Scene");
        knobs.steps("lamps", lamps_, 1, 3, "the sun, and up to two lanterns");
        knobs.toggle("displace", stage_.displace,
                     KnobHelp("the court's floor rises above its puddles").titled("Displace floor"));
        knobs.slider("tilt", stage_.tilt, -89, 89,
                     KnobHelp("how steep it is").in("degrees").only("scene", {"groove", "plane", "board"}));
        knobs.choice("level", level_, levels.names, KnobHelp("mip level of the surfaces' maps").titled("Mip level"));
        knobs.group("One pixel");
        knobs.slider("pixel_x", pixel_.place.x, 0, 1,
                     KnobHelp("place from the left, in widths").only("view", {"one-pixel"}));
        knobs.slider("pixel_y", pixel_.place.y, 0, 1,
                     KnobHelp("place from the top, in heights").only("view", {"one-pixel"}));
        light_.knobs(knobs, -90, 90);
    }

    std::optional<Image> truth(const Frame& frame) const override { return court::truth(frame, lighting()); }

private:
    enum View { court_, terms, one_pixel };
    static constexpr auto views = choices<View>({{court_, "court"}, {terms, "terms"}, {one_pixel, "one-pixel"}});
    enum NormalFor { all_lights, lamps_only };
    static constexpr auto normal_fors = choices<NormalFor>({{all_lights, "all"}, {lamps_only, "lamps", "LIGHT_ONLY"}});
    enum Level { mip, base };
    static constexpr auto levels = choices<Level>({{mip, "mip"}, {base, "0", "LEVEL_0"}});
    static constexpr int sky_texels = 128;
    static constexpr std::array<glm::dvec3, 2> ambient = {{{0.085, 0.060, 0.065}, {0.210, 0.225, 0.360}}};
    static constexpr std::array<glm::dvec3, 3> lamp_colors = {{{4.2, 2.2, 0.9}, {2.4, 1.15, 0.40}, {0.55, 0.85, 1.5}}};
    static constexpr std::array<glm::dvec3, 3> lamp_places = {{{0, 0, 0}, {-6.1, 2.1, -1.0}, {4.5, 2.4, 2.0}}};

    Lighting lighting() const {
        return {.scene = stage_.scene(),
                .is_displaced = stage_.is_displaced(),
                .to_sun = light_.direction<double>(),
                .sun_yaw_rad = glm::radians(double(light_.yaw)),
                .lamps = lamps_,
                .lamp_color = lamp_colors,
                .lamp_place = lamp_places,
                .ambient = ambient,
                .exponent = double(exponent_),
                .roughness = double(roughness_),
                .fresnel = Fresnel(fresnel_),
                .gloss = Gloss(gloss_),
                .reflection = reflection_,
                .shadow = shadow_.on,
                .ao = occlusion_.on,
                .occlusion = map_occlusion_,
                .light_only = normal_for_ == lamps_only,
                .mirror_occlusion = mirror_occlusion_ != int(MirrorOcclusion::none)};
    }

    // ---- views

    /// Draws each light above what hides it.
    void draw_terms(const Frame& frame) {
        struct Term {
            const char *title, *purpose;
        };
        static constexpr std::array<Term, 6> shown = {{{"light of the sky", "SHOW_ambient"},
                                                       {"lamps", "SHOW_lamps"},
                                                       {"mirrored sky", "SHOW_reflection"},
                                                       {"x occlusion", "SHOW_occlusion"},
                                                       {"x shadow", "SHOW_shadow"},
                                                       {"x gloss and Fresnel", "SHOW_share"}}};
        const std::vector<Tile> tiles = tile_grid(frame.size, 3, 2);
        for (size_t i = 0; i < tiles.size(); ++i) {
            draw_view(frame_in(frame, tiles[i]), tiles[i], shown[i].purpose);
            labels_.caption(frame.size, tiles[i], 0, shown[i].title);
        }
    }

    /// Draws one picture in four passes: two that find what hides light, the surfaces, the sky.
    void draw_view(const Frame& frame, const Tile& tile, const Define& purpose) {
        if (frame.size.x <= 0 || frame.size.y <= 0) return;
        draw_shadow(purpose);
        draw_occlusion(frame, purpose);
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
        draw_surfaces(frame, purpose);
        if (!frame.probe) draw_sky(frame);
    }

    /// Draws the court, and writes the terms of the light at a pixel, as drawn and exact.
    void draw_and_describe_pixel(const Frame& frame) {
        draw_view(frame, {{0, 0}, frame.size}, "");
        const Terms drawn = pixel_.draw(frame, [&] { draw_surfaces(frame, "TERMS"); });
        const glm::ivec2 at = pixel_.in(frame);
        pixel_.describe(frame, drawn, exact_terms(frame.ray(at.x, at.y), lighting()), labels_);
    }

    /// Returns whether a picture depends on a quantity. The light depends on all of them.
    static bool shows(const Define& purpose, const char* quantity) {
        const std::string& text = purpose.text;
        return text.empty() || text == "TERMS" || text == "PROBE_light" || text == std::string("PROBE_") + quantity ||
               text == std::string("SHOW_") + quantity;
    }

    // ---- passes

    bool has_shadow(const Define& purpose) const { return shadow_.on && shows(purpose, "shadow"); }
    bool has_occlusion(const Define& purpose) const {
        return occlusion_.on && (shows(purpose, "occlusion") || purpose.text == "PROBE_mirror_open");
    }

    void draw_shadow(const Define& purpose) {
        if (has_shadow(purpose)) shadow_.draw(stage_, light_.direction<double>());
    }

    void draw_occlusion(const Frame& frame, const Define& purpose) {
        if (has_occlusion(purpose)) occlusion_.draw(frame, stage_);
    }

    void draw_surfaces(const Frame& frame, const Define& purpose) {
        stage_.draw(frame.camera.clip_from_world(), [&](Material material) -> const Program& {
            const Program& program = program_of(material, purpose);
            glUseProgram(program);
            set_lights(program);
            set_sky(program);
            program.set("u_eye", frame.camera.eye());
            program.set("u_roughness", roughness_);
            program.set("u_exponent", exponent_);
            program.set("u_side", float(sky_texels));
            maps_.set(program, material);
            if (has_occlusion(purpose)) occlusion_.set(program);
            if (has_shadow(purpose)) shadow_.set(program);
            return program;
        });
    }

    const Program& program_of(Material material, const Define& purpose) const {
        const bool has_sky = reflection_ && shows(purpose, "reflection");
        return surface_.with({purpose, material == Material::floor ? "FLOOR" : "", stage_.displaced(material),
                              has_sky ? "REFLECTION" : "", fresnels.define(fresnel_), glosses.define(gloss_),
                              mirror_occlusions.define(mirror_occlusion_), has_shadow(purpose) ? "SHADOW" : "",
                              SunShadow::biases.define(has_shadow(purpose) ? shadow_.bias : SunShadow::none),
                              has_occlusion(purpose) ? "AO" : "", map_occlusion_ ? "OCCLUSION" : "",
                              fmt::format("LAMPS {}", lamps_), normal_fors.define(normal_for_),
                              levels.define(purpose.text == "TERMS" ? base : level_)});
    }

    void draw_sky(const Frame& frame) {
        const Program& program = sky_.with();
        glUseProgram(program);
        set_rays(program, frame);
        set_sky(program);
        window_.draw_behind();
    }

    void set_lights(const Program& program) const {
        set_each<glm::vec3>(program, "u_ambient", ambient);
        set_each<glm::vec3>(program, "u_lamp_color", lamp_colors);
        set_each<glm::vec3>(program, "u_lamp_place", lamp_places);
        program.set("u_lamp_place[0]", light_.direction<double>());
    }

    void set_sky(const Program& program) {
        const double yaw = glm::radians(double(light_.yaw));
        program.set("u_sun", glm::vec2(std::sin(yaw), std::cos(yaw)));
        program.set("s_sky", 5, sky_map_);
    }

    Programs surface_{"16_environment/scene.vert", "16_environment/surface.frag"};
    Programs sky_{"common/far_window.vert", "16_environment/sky.frag"};
    CubeTexture sky_map_{"evening sky", sky_texels, evening_sky};
    WindowTriangle window_;
    Stage stage_;
    MaterialMaps maps_;
    SunShadow shadow_;
    Occlusion occlusion_;
    OnePixel pixel_;
    Labels labels_;

    int view_ = court_, fresnel_ = int(Fresnel::schlick), gloss_ = int(Gloss::map), normal_for_ = all_lights;
    int mirror_occlusion_ = int(MirrorOcclusion::none);
    int lamps_ = 2, level_ = mip;
    bool reflection_ = true, seamless_ = true, map_occlusion_ = true;
    float exponent_ = 256, roughness_ = 0;
    DistantLight light_{.yaw = 162, .pitch = 10};
};

RELIEF_LAB(Environment);

}  // namespace relief::court
