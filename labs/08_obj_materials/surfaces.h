// Draws the surfaces of lab 08's scene: their order, and for each its program, its maps and its blending.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "framework/core/gl/light_target.h"
#include "framework/core/kit/choices.h"
#include "framework/core/lab/lab.h"
#include "lights.h"
#include "scene.h"

namespace relief::materials {

/// A scene with its mesh, its textures, and the factors of its masks, as they are drawn.
class DrawnScene {
public:
    explicit DrawnScene(Scene made) : scene(std::move(made)) {}
    DrawnScene(const DrawnScene&) = delete;  // its mesh refers to this object

    const Texture& texture(const std::string& asset, ColorSpace space);
    /// Returns the texture of a piece's mask, in its first channel.
    const Texture& mask_texture(const Piece& piece);
    /// Returns coverage_scales() of a piece's mask.
    const std::vector<float>& scales(const Piece& piece);

    const Scene scene;
    const GpuMesh mesh = upload([this] { return scene.mesh; });

private:
    std::map<std::string, Texture> textures_;
    std::map<std::string, std::vector<float>> scales_;
};

/// Returns coverage_scales() of a mask's mip levels as they are in its texture, rounded to 8 bits. With `is_alpha` the
/// mask is the fourth channel of the picture.
std::vector<float> scales_of(const std::string& mask, bool is_alpha = false);

/// Returns the colour of a program where surfaces are drawn flat. Linear light.
glm::vec3 program_color(int program);

enum class Pass { light, flat, filter_error, probe };

class Surfaces {
public:
    enum ProgramKind { compiled, branches };
    enum Filter { nearest, mips, taps_2, taps_4, taps_8, taps_16, samples };
    enum Order { sorted, of_file, backwards, weighted };
    enum BlendIn { light, stored };
    enum Alpha { test, keep, to_coverage, hashed };
    static constexpr auto program_kinds =
        choices<ProgramKind>({{compiled, "compiled"}, {branches, "branches", "BRANCHES"}});
    static constexpr auto filters = choices<Filter>({{nearest, "nearest", "NEAREST_TEXEL"},
                                                     {mips, "mips", "MIP_LEVELS"},
                                                     {taps_2, "2", "TAPS 2"},
                                                     {taps_4, "4", "TAPS 4"},
                                                     {taps_8, "8", "TAPS 8"},
                                                     {taps_16, "16", "TAPS 16"},
                                                     {samples, "samples", "MANY_SAMPLES"}});
    static constexpr std::array orders = {"sorted", "file", "backwards", "weighted"};
    static constexpr auto blend_spaces = choices<BlendIn>({{light, "light"}, {stored, "stored", "STORED"}});
    static constexpr auto alphas = choices<Alpha>({{test, "test", "ALPHA_TEST"},
                                                   {keep, "keep", "ALPHA_KEEP"},
                                                   {to_coverage, "to-coverage", "ALPHA_TO_COVERAGE"},
                                                   {hashed, "hashed", "ALPHA_HASHED"}});

    struct Look {
        Pass pass;  ///< Pass::probe draws the frame's probe
        int filter = mips;
        Lights lights;
        const LightTarget* target = nullptr;  ///< bound; for Pass::light only
    };
    /// Draws all surfaces. Throws Error if draw_order() returns other indices than those of the surfaces.
    void draw(const Frame& frame, DrawnScene& drawn, const Look& look);

    /// Returns how often a program was compiled again: see Programs::renewals().
    int renewals() const { return programs_.renewals(); }

    // The knobs.
    int program_kind = compiled, filter = mips, order = sorted, blend_in = light, alpha = to_coverage;
    int highlight = 0;  ///< a surface that is shown alone in its light, from 1 on; 0: all
    float threshold = 0.5f, fence = 1;

private:
    std::vector<int> order_of(const Scene& scene, const glm::dvec3& eye) const;
    const Program& program_of(const Piece& piece, const Frame& frame, const Look& look) const;
    void set_frame(const Program& program, const Frame& frame, const Lights& lights) const;
    void set_material(const Program& program, const Piece& piece) const;
    void set_maps(const Program& program, DrawnScene& drawn, const Piece& piece) const;
    void set_blending(bool is_on, const Frame& frame, const Look& look) const;

    Programs programs_{"08_obj_materials/surface.vert", "08_obj_materials/surface.frag"};
    Texture no_map_{"no map", [] { return Image(1, 1, 1, 8); }};
};

/// Sets the uniforms of shaders/08_obj_materials/lamp.glsl, and u_lamp_light. Precondition: the program is in use.
void set_lamp(const Program& program, const Lights& lights);

}  // namespace relief::materials
