// The staff's part of lab 12: see ../truth.h.
#include "truth.h"

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/near_plane.h"
#include "framework/staff/reference/relief_sight.h"
#include "framework/staff/reference/surfaces.h"
#include "framework/staff/reference/terminator.h"

namespace relief::exact {
namespace {

struct Seen {
    double distance = std::numeric_limits<double>::infinity();
    glm::dvec2 texel{};
    glm::dvec4 ray{};    ///< value of the probe `ray`
    glm::dvec3 light{};  ///< direction to the light in tangent space
    double lit = 0;
    bool is_ball = false;
    double texels = 1;  ///< along a side of the map
};

class SeenObject {
public:
    SeenObject(const Object& object, bool outline)
        : field_(object.surface->heights(), true),
          sights_(object.surface->mesh()),
          mapping_(object.surface->mapping()),
          model_from_world_(glm::inverse(object.world_from_model)),
          is_closed_(object.is_closed()),
          radius_(object.radius(outline)),
          border_(object.border(outline)) {}

    /// `begin`: the distance from which on the base is drawn.
    void look(const Ray& world, double begin, const glm::dvec3& to_light, bool wants_light, Seen& nearest) const {
        const glm::dmat3 turn(model_from_world_);
        const Ray ray{glm::dvec3(model_from_world_ * glm::dvec4(world.origin, 1)), turn * world.direction};
        const auto sight = sights_.look(ray, mapping_, begin, is_closed_);
        if (!sight || (radius_ > 0 && sight->faces_away)) return;
        double t = 0, bend = 0;
        if (!sight->faces_away) {
            double t_end = 1;
            if (radius_ > 0) {
                const double across = glm::dot(ray.direction, sight->tangent) * sight->metres_to_ground;
                bend = across * across / (2 * radius_ * double(mapping_.metres));
                t_end = bend < 0.25 ? 2 / (1 + std::sqrt(1 - 4 * bend)) : 1 / bend;
            }
            const auto hit = field_.first_hit(sight->ray.in_texels(), t_end, bend);
            if (!hit && bend >= 0.25) return;
            t = hit ? hit->t : t_end;
        }
        const double distance = sight->distance + t * sight->metres_to_ground;
        const glm::dvec2 texel = sight->ray.texel + t * sight->ray.march, uv = texel / double(mapping_.texels);
        const auto [low, high] = border_;
        if (uv.x < double(low.x) || uv.y < double(low.y) || uv.x > double(high.x) || uv.y > double(high.y)) return;
        if (distance >= nearest.distance) return;
        const glm::dvec2 entry = sight->ray.texel - glm::floor(sight->uv) * double(mapping_.texels);
        const glm::dvec3 light =
            glm::dvec3(turn * to_light) * glm::dmat3(sight->tangent, sight->bitangent, sight->normal);
        nearest = {distance, texel, {sight->ray.march, entry}, light, 0, false, double(mapping_.texels)};
        if (!wants_light) return;
        nearest.lit =
            field_.is_lit(texel, {glm::dvec2(light) * glm::dvec2(mapping_.depth) * double(mapping_.texels), light.z});
    }

private:
    HeightField field_;
    ReliefSights sights_;
    ReliefMapping mapping_;
    glm::dmat4 model_from_world_;
    bool is_closed_;
    double radius_;
    std::pair<glm::vec2, glm::vec2> border_;
};

void look(const Ball& ball, const Ray& ray, Seen& nearest) {
    const SphereShape sphere{.radius = float(ball.radius)};
    const auto hit = first_hit(sphere, {ray.origin - ball.centre, ray.direction});
    if (hit && hit->t < nearest.distance) nearest = {hit->t, {}, {}, {}, 0, true};
}

std::function<Image(const Frame&)> exact_values(const Probe& probe, const Sight& sight) {
    const bool uv = probe.name == "uv", depth = probe.name == "depth", shadow = probe.name == "shadow";
    const bool way = probe.name == "ray", guess = probe.name == "guess";
    if (!uv && !depth && !shadow && !way && !guess) return {};
    std::vector<SeenObject> objects;
    for (const Object& object : sight.objects) objects.emplace_back(object, sight.outline);
    return [=, objects = std::move(objects), to_light = sight.to_light, ball = sight.ball](const Frame& frame) {
        const glm::dmat4 clip_from_world = frame.camera.clip_from_world();
        return truth_of_rays(frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
            Seen seen;
            const double begin = near_plane(clip_from_world, ray);
            for (const SeenObject& object : objects) object.look(ray, begin, to_light, shadow, seen);
            if (ball) look(*ball, ray, seen);
            if (std::isinf(seen.distance) || (seen.is_ball && !depth)) return {};
            if (way) return seen.ray;
            if (guess) {
                const glm::dvec2 place = glm::dvec2(seen.ray.z, seen.ray.w) / seen.texels, slope = 8.0 * place - 4.0;
                return glm::dvec4(estevez_shadow({0, 0, 1}, glm::normalize(glm::dvec3(-slope, 1)), seen.light), 0, 0,
                                  0);
            }
            return glm::dvec4(depth ? glm::dvec2(seen.distance, 0) : uv ? seen.texel : glm::dvec2(seen.lit, 0), 0, 0);
        });
    };
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::exact
