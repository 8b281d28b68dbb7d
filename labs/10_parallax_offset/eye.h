// Ways to bring the eye and a model into one space, for the direction from which a relief is seen.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "framework/core/lab/lab.h"

namespace relief::offsets {

/// The space of the shader's rays. `world`: the shader takes dot products with the model's axes in the world.
/// `inverse`: the inverse of the model's matrix brings the eye into the model's space, in floats as a shader would
/// compute it. `inverse_in_double`: the same in doubles.
enum class EyeBy { world, inverse, inverse_in_double };

/// The shader's inputs. All vectors are in the space to which `space_from_model` leads.
struct PlacedEye {
    glm::dmat4 clip_from_space, space_from_model;
    glm::dvec3 eye, to_light, up;
};

/// Returns a pose of the model: turned by degrees about an axis of its own, and moved along x by metres.
inline glm::dmat4 pose_of(double turn, double away) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::dvec3(away, 0, 0));
    return glm::rotate(moved, glm::radians(turn), glm::normalize(glm::dvec3(1, 2, 3)));
}

/// Places a model in the world, and the camera, the light and `up` with it. So only rounding makes the picture depend
/// on the pose. `to_light` is relative to the model.
inline PlacedEye place(EyeBy by, const Camera& camera, const glm::dmat4& world_from_model, const glm::dvec3& to_light) {
    const glm::dvec3 up(0, 1, 0), eye_in_world(world_from_model * glm::dvec4(camera.eye(), 1));
    if (by == EyeBy::world) {
        const glm::dmat3 turn(world_from_model);
        return {camera.clip_from_world() * glm::inverse(world_from_model), world_from_model, eye_in_world,
                turn * to_light, turn * up};
    }
    PlacedEye placed{camera.clip_from_world(), glm::dmat4(1), camera.eye(), to_light, up};
    if (by == EyeBy::inverse)
        placed.eye = glm::vec3(glm::inverse(glm::mat4(world_from_model)) * glm::vec4(glm::vec3(eye_in_world), 1));
    else
        placed.eye = glm::dvec3(glm::inverse(world_from_model) * glm::dvec4(eye_in_world, 1));
    return placed;
}

}  // namespace relief::offsets
