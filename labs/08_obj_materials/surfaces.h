// Draws the surfaces of lab 08's scene: their order, and for each its program, its maps and its blending.
#pragma once

#include <vector>

#include "framework/core/lab/lab.h"
#include "light_target.h"
#include "scene.h"
#include "settings.h"

namespace relief::materials {

/// Returns the colour of a program where surfaces are drawn flat. Linear light.
glm::vec3 program_color(int program);

enum class Pass { light, flat, filter_error, probe };

class Surfaces {
public:
    explicit Surfaces(const Settings& settings) : settings_(settings) {}

    struct Look {
        Pass pass;  ///< Pass::probe draws the frame's probe
        int filter = Settings::mips;
        const LightTarget* target = nullptr;  ///< bound; for Pass::light only
    };
    /// Draws all surfaces. Throws Error if draw_order() returns an index without a surface, or too many.
    void draw(const Frame& frame, DrawnScene& drawn, const Look& look);

    /// Returns how often a program was compiled again: see Programs::renewals().
    int renewals() const { return programs_.renewals(); }

private:
    std::vector<int> order_of(const Scene& scene, const glm::dvec3& eye) const;
    const Program& program_of(const Piece& piece, const Frame& frame, const Look& look) const;
    void set_frame(const Program& program, const Frame& frame) const;
    void set_material(const Program& program, const Piece& piece) const;
    void set_maps(const Program& program, DrawnScene& drawn, const Piece& piece) const;
    void set_blending(bool is_on, const Frame& frame, const Look& look) const;

    const Settings& settings_;
    Programs programs_{"08_obj_materials/surface.vert", "08_obj_materials/surface.frag"};
    Texture no_map_{"no map", [] { return Image(1, 1, 1, 8); }};
};

}  // namespace relief::materials
