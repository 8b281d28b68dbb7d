// The exact values of lab 16's probes.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"
#include "scene.h"

namespace relief::court {

enum class Fresnel { whole, schlick, exact };
enum class Gloss { map, even, mirror };

/// A scene with its lights, and which of their terms count.
struct Lighting {
    Scene scene;
    bool has_puddles = false;
    glm::dvec3 to_sun{0, 1, 0};
    double sun_yaw_rad = 0;
    int lamps = 1;                           ///< the first is the sun
    std::array<glm::dvec3, 3> lamp_color{};  ///< of the others: a metre away
    std::array<glm::dvec3, 3> lamp_place{};
    std::array<glm::dvec3, 2> ambient{};  ///< from below, from above
    double exponent = 256, roughness = 0;
    Fresnel fresnel = Fresnel::schlick;
    Gloss gloss = Gloss::map;
    bool reflection = true, shadow = true, ao = true, occlusion = true, light_only = false;
};

/// What makes up the light that leaves a place.
struct Terms {
    glm::dvec3 ambient{0}, lamps{0}, mirror{0}, light{0};
    double occlusion = 1, shadow = 1, share = 0;
};

/// At the place that the ray of each pixel meets: `normal`; `reflection`, the light that is mirrored there; `fresnel`
/// (share); `exponent`; `shadow`, 1 where the sun is seen; `occlusion`, how open it is by 1024 rays; `light`.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Lighting& lighting)> truth;
inline FromStaff<std::optional<Terms>(const Ray& ray, const Lighting& lighting)> exact_terms;

}  // namespace relief::court
