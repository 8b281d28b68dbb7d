// The staff's part of lab 19: see ../truth.h.
#include "truth.h"

#include <cmath>

#include "exact.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/view_axes.h"
#include "framework/staff/reference/mesh_rays.h"
#include "layers.h"
#include "scene.h"

namespace relief::layered_normals {
namespace {

struct Layer {
    Map normals, slopes, bends;
    explicit Layer(const LayerMaps& maps) : normals(maps.normals), slopes(maps.slopes), bends(maps.bends) {}
};
const Layer& stone_layer() {
    static const Layer layer(stone_maps());
    return layer;
}
const Layer& grain_layer() {
    static const Layer layer(grain_maps());
    return layer;
}

/// The plane z = 0, seen by a camera.
class Wall {
public:
    Wall(const Frame& frame, const Settings& settings)
        : settings_(settings),
          eye_(frame.camera.eye()),
          axes_(view_axes(frame.camera)),
          pixel_(2 * axes_.half_height / frame.size.y),
          to_light_(settings.light.direction<double>()) {}

    /// Returns the value where a ray meets the wall, or nothing where it does not.
    std::optional<glm::dvec4> value(const Ray& ray, const std::string& probe) const {
        const glm::dvec3 forward = ray.direction / glm::dot(ray.direction, axes_.forward);
        if (!(forward.z * eye_.z < 0 && std::abs(forward.z) > 1e-4 * glm::length(forward))) return {};
        const double away = -eye_.z / forward.z;
        Place place{eye_ + away * forward, {}, {}, away * glm::length(forward), -glm::normalize(forward)};
        const auto footprint = [&](const glm::dvec3& step) {
            return away * glm::dvec2(step - forward * (step.z / forward.z));
        };
        place.across = footprint(pixel_ * axes_.right), place.up = footprint(pixel_ * axes_.up);
        const Layers layers = layers_at(glm::dvec2(place.position), place);
        if (probe == "normal") return glm::dvec4(exact_normal(layers, place), 0);
        if (probe == "detail") return glm::dvec4(layers.detail, 0);
        if (probe == "variance") return glm::dvec4(variance(layers, place), 0, 0, 0);
        if (probe == "highlight") return glm::dvec4(highlight(layers, place), 0, 0, 0);
        if (probe == "reads") return glm::dvec4(layers.strength > 0 ? 2 : 1, 0, 0, 0);
        return {};
    }

private:
    struct Place {
        glm::dvec3 position;
        glm::dvec2 across, up;  ///< to the next pixel, and to the one above
        double distance;
        glm::dvec3 to_eye;
    };
    struct Layers {
        glm::dvec3 base, detail;
        glm::dvec4 base_texel, detail_texel;
        double strength;  ///< of the detail
    };

    double tile(bool is_detail) const { return is_detail ? stone_tile / double(settings_.tiles) : stone_tile; }
    double level(const Place& place, bool is_detail) const {
        const double widest = std::max(glm::length(place.across), glm::length(place.up));
        return std::max(std::log2(widest * texels / tile(is_detail)), 0.0);
    }

    Layers layers_at(glm::dvec2 position, const Place& place) const {
        Layers layers;
        layers.base_texel = stone_layer().normals.at(position / tile(false), level(place, false));
        layers.base = scaled(layers.base_texel, settings_.strengths().x);
        const double end = settings_.fade_end(), t = std::clamp((place.distance / end - 0.5) * 2, 0.0, 1.0);
        layers.strength = double(settings_.strengths().y) * (1 - t * t * (3 - 2 * t));
        layers.detail_texel = {0, 0, 1, 0}, layers.detail = {0, 0, 1};
        if (layers.strength > 0) {
            layers.detail_texel = grain_layer().normals.at(position / tile(true), level(place, true));
            layers.detail = scaled(layers.detail_texel, layers.strength);
        }
        return layers;
    }
    static glm::dvec3 scaled(const glm::dvec4& normal, double strength) {
        return glm::normalize(glm::dvec3(strength * normal.x, strength * normal.y, normal.z));
    }

    glm::dvec3 exact_normal(const Layers& layers, const Place& place) const {
        if (layers.strength == 0) return layers.base;
        const glm::dvec4 bend = stone_layer().bends.at(glm::dvec2(place.position) / tile(false), level(place, false));
        return exact_blend(Settings::Question(settings_.question), layers.base, layers.detail,
                           layers.detail_texel.w * layers.strength * tile(true),
                           glm::dvec3(bend.y, bend.z, bend.w) * (double(settings_.strengths().x) / tile(false)));
    }

    double variance(const Layers& layers, const Place& place) const {
        double sum = 1 / settings_.precision();
        if (settings_.filter == Settings::toksvig) {
            const double base = settings_.strengths().x;
            sum += base * base * lost_variance(layers.base_texel);
            if (layers.strength > 0) sum += layers.strength * layers.strength * lost_variance(layers.detail_texel);
        } else if (settings_.filter == Settings::derivatives) {
            const auto normal = [&](const Layers& of) {
                return of.strength > 0 ? blended(Settings::Blend(settings_.blend), of.base, of.detail) : of.base;
            };
            const glm::dvec2 here(place.position);
            sum += turning_variance(normal(layers_at(here + place.across, place)) - normal(layers),
                                    normal(layers_at(here + place.up, place)) - normal(layers));
        }
        return sum;
    }

    double highlight(const Layers& layers, const Place& place) const {
        constexpr int side = 32;
        const glm::dvec3 halfway = place.to_eye + to_light_;
        const glm::dvec2 wanted = -glm::dvec2(halfway) / std::max(halfway.z, 1e-4);
        double sum = 0;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const glm::dvec2 off = (glm::dvec2(column, row) + 0.5) / double(side) - 0.5,
                                 position = glm::dvec2(place.position) + off.x * place.across + off.y * place.up;
                glm::dvec2 slope =
                    double(settings_.strengths().x) * glm::dvec2(stone_layer().slopes.at(position / tile(false), 0));
                if (layers.strength > 0)
                    slope += layers.strength * glm::dvec2(grain_layer().slopes.at(position / tile(true), 0));
                slope -= wanted;
                sum += falls(Settings::Brdf(settings_.brdf), settings_.precision() * glm::dot(slope, slope));
            }
        return sum / (side * side);
    }

    const Settings& settings_;
    glm::dvec3 eye_;
    ViewAxes axes_;
    double pixel_;  ///< its side, one metre ahead
    glm::dvec3 to_light_;
};

/// Returns the value on a solid at a place whose mesh has this normal.
std::optional<glm::dvec4> solid_value(const glm::dvec3& place, const glm::dvec3& flat, const std::string& probe,
                                      const Settings& settings) {
    Surface surface{flat, glm::dmat3(0)};
    if (settings.shape != Settings::cube) surface = surface_at(place, settings.shape == Settings::rock);
    const glm::dvec3 weights = plane_weights(surface.normal, settings.sharpness);
    const double tile = stone_tile / double(settings.tiles), strength = settings.grain;
    glm::dvec3 heights(0);
    glm::dmat3 gradients(0);
    int reads = 0;
    for (int i = 0; i < 3; ++i) {
        if (weights[i] == 0 && probe != "planes") continue;
        const glm::dmat3 frame = plane_frame(i, surface.normal[i] < 0 ? -1 : 1);
        const glm::dvec4 texel = grain_layer().normals.at(glm::dvec2(place * frame) / tile, 0);
        const glm::dvec2 slope = -strength * glm::dvec2(texel) / texel.z;
        gradients[i] = frame[0] * slope.x + frame[1] * slope.y;
        heights[i] = strength * tile * texel.w;
        ++reads;
    }
    if (probe == "weights") return glm::dvec4(weights, 0);
    if (probe == "planes") return glm::dvec4(gradients[0] + gradients[1] + gradients[2], 0);
    if (probe == "reads") return glm::dvec4(reads, 0, 0, 0);
    const glm::dvec3 gradient =
        gradients * weights + weight_gradients(surface.normal, surface.turns, settings.sharpness) * heights;
    if (probe == "gradient") return glm::dvec4(gradient, 0);
    if (probe == "normal") return glm::dvec4(bumped(surface.normal, gradient), 0);
    return {};
}

std::optional<Image> exact_values(const Frame& frame, const Settings& settings) {
    const Frame seen = settings.seen(frame);
    if (settings.shows_solid(frame.probe)) {
        const Mesh mesh = solid_mesh(settings.shape);
        const TriangleTree tree = build_tree(mesh);
        return truth_of_rays(seen, [&](const Ray& ray) -> std::optional<glm::dvec4> {
            const auto hit = first_hit(tree, mesh, ray, 1e9);
            if (!hit) return {};
            const Vertex& corner = mesh.vertices[mesh.indices[hit->triangle * 3]];
            return solid_value(ray.origin + hit->t * ray.direction, corner.normal, frame.probe.name, settings);
        });
    }
    const Wall wall(seen, settings);
    return truth_of_rays(seen, [&](const Ray& ray) { return wall.value(ray, frame.probe.name); });
}

const decltype(truth)::Provided provided(truth, exact_values);

}  // namespace
}  // namespace relief::layered_normals
