// The lights of lab 08's garden: the sun or the dusk, and a lantern.
#pragma once

#include <glm/glm.hpp>

#include "framework/core/gl/program.h"
#include "framework/library/kit/choices.h"

namespace relief::materials {

enum Lamp { spot_lamp, point_lamp, sun };
inline constexpr auto lamps = choices<Lamp>({{spot_lamp, "spot", "LAMP"}, {point_lamp, "point", "LAMP"}, {sun, "sun"}});

/// Light is linear: 1 is white paper in full light. Lengths are in metres.
struct Lights {
    Lamp lamp = spot_lamp;
    glm::dvec3 to_sun{0, 1, 0}, sun{0}, sky{0}, ground{0};  ///< `sky` comes from above, `ground` from below
    glm::dvec3 place{1, 1.45, 0.6}, axis{0, -1, 0}, light{0};
    double range = 7, cone = 2;
    glm::dvec3 attenuation{1, 0.3, 0.5};  ///< coefficients of 1, the distance and its square

    /// Sets the uniforms of shaders/08_obj_materials/lamp.glsl, and u_lamp_light. Precondition: the program is in use.
    void set_lamp(const Program& program) const {
        program.set("u_lamp", place);
        program.set("u_lamp_light", light);
        program.set("u_axis", axis);
        program.set("u_range", range);
        program.set("u_cone", cone);
        program.set("u_attenuation", attenuation);
    }
    /// Sets the uniforms of shaders/08_obj_materials/light.glsl and of the lamp likewise.
    void set(const Program& program) const {
        program.set("u_to_sun", to_sun);
        program.set("u_sun", sun);
        program.set("u_sky", sky);
        program.set("u_ground", ground);
        set_lamp(program);
    }
};

}  // namespace relief::materials
