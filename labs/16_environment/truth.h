// The exact values of lab 16's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "scene.h"

namespace relief::court {

enum class Fresnel { whole, schlick, exact };
inline constexpr auto fresnels = choices<Fresnel>({{Fresnel::whole, "whole", "FRESNEL_WHOLE"},
                                                   {Fresnel::schlick, "schlick"},
                                                   {Fresnel::exact, "exact", "FRESNEL_EXACT"}});
enum class Gloss { map, even, mirror };
inline constexpr auto glosses = choices<Gloss>(
    {{Gloss::map, "map"}, {Gloss::even, "even", "GLOSS_EVEN"}, {Gloss::mirror, "mirror", "GLOSS_MIRROR"}});

/// A guess of the share of the mirrored lobe that nothing hides, from the share of the sky.
enum class MirrorOcclusion { none, as_sky, lagarde };
inline constexpr auto mirror_occlusions =
    choices<MirrorOcclusion>({{MirrorOcclusion::none, "none"},
                              {MirrorOcclusion::as_sky, "as-sky", "MIRROR_AS_SKY"},
                              {MirrorOcclusion::lagarde, "lagarde", "MIRROR_LAGARDE"}});

/// A scene, its lights, and the terms of the lighting that are switched on.
struct Lighting {
    Scene scene;
    bool is_displaced = false;  ///< the floor rises above its puddles
    glm::dvec3 to_sun{0, 1, 0};
    double sun_yaw_rad = 0;
    int lamps = 1;                           ///< the first is the sun
    std::array<glm::dvec3, 3> lamp_color{};  ///< of the sun; of the others at a distance of one metre
    std::array<glm::dvec3, 3> lamp_place{};
    std::array<glm::dvec3, 2> ambient{};  ///< light from below, and from above
    double exponent = 256, roughness = 0;
    Fresnel fresnel = Fresnel::schlick;
    Gloss gloss = Gloss::map;
    bool reflection = true, shadow = true, ao = true, occlusion = true, light_only = false;
    bool mirror_occlusion = false;  ///< the mirrored sky is hidden by what is in its way
};

/// The terms of the light that leaves a place. `occlusion` and `shadow` are 1 where nothing hides the sky or the sun;
/// `share` is the share of light that is mirrored.
struct Terms {
    glm::dvec3 ambient{0}, lamps{0}, mirror{0}, light{0};
    double occlusion = 1, shadow = 1, share = 0;
};

/// Returns the exact values of a probe at the place that the ray of each pixel hits. Columns and balls are round. A
/// displaced floor has the triangles that are drawn and, at each of their places, the normal of floor_at(), as in the
/// shader: this lab is about the light at a place, so the error does not contain that of the triangles.
///  - `normal`: the bumped normal
///  - `reflection`: light of the mirrored sky
///  - `fresnel`: share of the light that is mirrored
///  - `exponent`: exponent of the highlight
///  - `shadow`: 1 where the sun is visible, else 0
///  - `occlusion`: share of the sky that is visible, by 1024 rays
///  - `mirror_open`: share of the mirrored lobe that meets the sky, by 88 rays of equal weight
///  - `light`: linear light that leaves the place
inline FromStaff<std::optional<Image>(const Frame& frame, const Lighting& lighting)> truth;
/// Returns the exact terms at the place that a ray hits, or nothing if it hits no surface.
inline FromStaff<std::optional<Terms>(const Ray& ray, const Lighting& lighting)> exact_terms;

}  // namespace relief::court
