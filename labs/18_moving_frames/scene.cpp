#include "scene.h"

#include <glm/gtc/matrix_transform.hpp>

namespace relief::moving_frames {

Scene scene_of(const Settings& s, const Body& body) {
    const Pose pose = s.pose();
    Scene scene{.body = body,
                .pose = pose,
                .ball = ball_of(body, pose),
                .materials = {},
                .instances = {},
                .fine = s.fineness(),
                .coarse = s.flock_fineness(),
                .unrolled = s.view == Settings::unrolled_skin};
    // Tiles are nearly square, and a whole number of them goes around the body.
    const glm::dvec2 tiles = (body.is_serpent ? glm::dvec2(7, 31) : glm::dvec2(8, 8)) * double(s.material_scale);
    for (int i = 0; i < material_count; ++i)
        scene.materials[size_t(i)] = texture_transform(s.material_turn, tiles * (i % 3 == 2 ? 0.7 : 1.0));
    Instance& first = scene.instances.emplace_back();
    first.world_from_model = glm::scale(glm::dmat4(1), glm::dvec3(1, double(s.scale_y), 1));
    first.texture = texture_transform(s.instance_turn, {s.instance_scale, 1}, {0.25, 0.1});
    first.material = s.material;
    if (s.view == Settings::the_flock)
        for (const Instance& other : make_flock(s.instances - 1)) scene.instances.push_back(other);
    for (Instance& instance : scene.instances)
        instance.world_from_model = glm::translate(instance.world_from_model, -scene.ball.centre);
    if (!s.textured) {
        for (glm::dmat3& transform : scene.materials) transform = glm::dmat3(1);
        for (Instance& instance : scene.instances) instance.texture = glm::dmat3(1);
    }
    return scene;
}

}  // namespace relief::moving_frames
