// The lights of lab 08's garden: the sun or the dusk, and a lantern.
#pragma once

#include <glm/glm.hpp>

#include "framework/core/kit/choices.h"
#include "framework/core/kit/light.h"

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
};

/// The knobs of the lights.
struct LightKnobs {
    int lamp = spot_lamp;
    float range = 7, cone = 2, height = 1.45f;
    DistantLight distant{.yaw = 165, .pitch = 4};

    void knobs(Knobs& knobs) {
        knobs.group("Lantern");
        knobs.choice("lamp", lamp, lamps.names, "the lantern with its cone, without it, or daylight");
        knobs.slider("range", range, 0, 20, "how far the lantern reaches, metres");
        knobs.slider("cone", cone, 0, 64, "exponent of the lantern's cone; 0 shines all around");
        knobs.slider("lamp_height", height, 0, 3, "height of the lantern's light above the ground, metres");
        distant.knobs(knobs, -5, 90);
    }

    Lights lights() const {
        Lights lights{.lamp = Lamp(lamp),
                      .to_sun = distant.direction<double>(),
                      .axis = glm::normalize(glm::dvec3(-0.32, -1, -0.22)),
                      .range = double(range),
                      .cone = lamp == point_lamp ? 0 : double(cone)};
        lights.place.y = double(height);
        if (lamp == sun) {
            lights.sun = {1.0, 0.9, 0.74}, lights.sky = {0.26, 0.32, 0.42}, lights.ground = {0.10, 0.10, 0.07};
        } else {
            lights.sun = {0.34, 0.13, 0.05}, lights.sky = {0.075, 0.095, 0.175}, lights.ground = {0.032, 0.026, 0.028};
            lights.light = {15, 8, 2.8};
        }
        return lights;
    }
};

}  // namespace relief::materials
