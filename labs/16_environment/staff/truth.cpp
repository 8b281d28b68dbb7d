// The staff's part of lab 16: see ../truth.h.
#include "truth.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/core/image/asset.h"
#include "framework/core/image/color.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/evening_sky.h"
#include "framework/library/mesh/parallelogram.h"
#include "framework/staff/reference/mesh_rays.h"
#include "framework/staff/reference/near_plane.h"

namespace relief::court {
namespace {

constexpr double pi = glm::pi<double>();

struct Hit {
    double t = INFINITY;
    glm::dvec3 face{0}, tangent{0};
    glm::dvec2 uv{0};
    Material material{};
};

/// A picture of numbers or of light (decoded from sRGB), read by GL's bilinear filter on level 0.
class Map {
public:
    Map(const char* asset, bool is_light) : image_(read_asset(asset)) {
        if (is_light)
            for (float& value : image_.values) value = float(linear_from_srgb(double(value)));
    }
    glm::dvec3 read(const glm::dvec2& uv) const {
        const glm::dvec2 size(image_.width, image_.height);
        const glm::dvec2 place = (uv - glm::floor(uv)) * size - 0.5, low = glm::floor(place), part = place - low;
        const auto at = [&](double x, double y) {
            const int column = (int(x) + image_.width) % image_.width, row = (int(y) + image_.height) % image_.height;
            const float* texel = image_.pixel(column, image_.height - 1 - row);
            return glm::dvec3(texel[0], texel[1], texel[2]);
        };
        return glm::mix(glm::mix(at(low.x, low.y), at(low.x + 1, low.y), part.x),
                        glm::mix(at(low.x, low.y + 1), at(low.x + 1, low.y + 1), part.x), part.y);
    }

private:
    Image image_;
};

struct Maps {
    Map albedo, normals, packed;
};

const Maps& maps_of(Material material) {
    if (material == Material::brick) {
        static const Maps maps{{"bricks_albedo.png", true}, {"bricks_normal.png", false}, {"bricks_packed.png", false}};
        return maps;
    }
    static const Maps maps{{"paving_albedo.png", true}, {"paving_normal.png", false}, {"paving_packed.png", false}};
    return maps;
}

double ramp(double low, double high, double x) {
    const double t = glm::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// The triangles of the displaced floor.
struct RaisedFloor {
    Mesh mesh;
    TriangleTree tree;

    explicit RaisedFloor(const Scene& court) : mesh(mesh_of(court, Material::floor, true)) {
        for (Vertex& vertex : mesh.vertices)
            vertex.position.y =
                float(double(vertex.position.y) + floor_at({vertex.position.x, vertex.position.z}).height);
        tree = build_tree(mesh);
    }
    glm::dvec3 normal_of(uint32_t triangle) const {
        const auto corner = [&](uint32_t i) {
            return glm::dvec3(mesh.vertices[mesh.indices[3 * triangle + i]].position);
        };
        return glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
};

struct Surface {
    glm::dvec3 place, face, normal, albedo;
    double gloss, occlusion, straight, exponent;
};

class Exact {
public:
    explicit Exact(const Lighting& lighting) : lighting_(lighting) {}

    std::optional<glm::dvec4> value(const Ray& ray, const std::string& probe) const {
        const Hit hit = first_hit(ray);
        if (!std::isfinite(hit.t)) return {};
        const Surface surface = surface_at(ray, hit);
        const glm::dvec3 to_eye = -glm::normalize(ray.direction);
        const glm::dvec3 normal = lighting_.light_only ? surface.face : surface.normal;
        if (probe == "normal") return glm::dvec4(surface.normal, 0);
        if (probe == "reflection") return glm::dvec4(mirrored_sky(surface, to_eye, normal), 0);
        if (probe == "fresnel") return glm::dvec4(share(surface.straight, glm::dot(normal, to_eye)), 0, 0, 0);
        if (probe == "exponent") return glm::dvec4(surface.exponent, 0, 0, 0);
        if (probe == "shadow") return glm::dvec4(shadow(surface), 0, 0, 0);
        if (probe == "mirror_open") return glm::dvec4(mirror_openness(surface, to_eye, normal), 0, 0, 0);
        if (probe == "occlusion") return glm::dvec4(lighting_.ao ? openness(surface) : 1, 0, 0, 0);
        return glm::dvec4(terms(surface, to_eye).light, 0);
    }

    std::optional<Terms> terms(const Ray& ray) const {
        const Hit hit = first_hit(ray);
        if (!std::isfinite(hit.t)) return {};
        return terms(surface_at(ray, hit), -glm::normalize(ray.direction));
    }

private:
    /// Calls `take` for each hit with shapes of the scene, of the displaced floor only for those before `end`.
    template <class Take>
    void each_hit(const Scene& scene, const Ray& ray, double end, Take take) const {
        for (const Quad& quad : scene.quads) {
            if (is_raised(quad.material)) {
                static const RaisedFloor floor(lighting_.scene);  // only the court has one
                relief::each_hit(floor.tree, floor.mesh, ray, end, [&](const MeshHit& hit) {
                    take(hit.t, floor.normal_of(hit.triangle), quad.material);
                });
                continue;
            }
            const glm::dvec3 across = glm::cross(quad.right, quad.up);
            const double t = glm::dot(quad.corner - ray.origin, across) / glm::dot(ray.direction, across);
            if (!std::isfinite(t)) continue;
            const glm::dvec3 place = ray.at(t) - quad.corner;
            const double u = glm::dot(place, quad.right) / glm::dot(quad.right, quad.right),
                         v = glm::dot(place, quad.up) / glm::dot(quad.up, quad.up);
            if (u < 0 || u > 1 || v < 0 || v > 1) continue;
            take(t, glm::normalize(across), quad.material);
        }
        for (const Box& box : scene.boxes) {
            const glm::dvec3 a = (box.low - ray.origin) / ray.direction, b = (box.high - ray.origin) / ray.direction;
            const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
            const double enters = std::max({near.x, near.y, near.z}), leaves = std::min({far.x, far.y, far.z});
            if (!(enters <= leaves)) continue;
            for (const double t : {enters, leaves}) {
                const glm::dvec3& ends = t == enters ? near : far;
                glm::dvec3 normal(0);
                const int axis = t == ends.x ? 0 : t == ends.y ? 1 : 2;
                normal[axis] = (ray.direction[axis] > 0) == (t == enters) ? -1 : 1;
                take(t, normal, box.material);
            }
        }
        for (const Column& column : scene.columns) {
            const glm::dvec2 from(ray.origin.x - column.foot.x, ray.origin.z - column.foot.z),
                way(ray.direction.x, ray.direction.z);
            for (const double t :
                 roots(glm::dot(way, way), glm::dot(from, way), glm::dot(from, from) - column.radius * column.radius)) {
                const glm::dvec3 place = ray.at(t);
                if (!(place.y >= column.foot.y && place.y <= column.foot.y + column.height)) continue;
                take(t, glm::dvec3(place.x - column.foot.x, 0, place.z - column.foot.z) / column.radius,
                     Material::marble);
            }
        }
        for (const Ball& ball : scene.balls) {
            const glm::dvec3 from = ray.origin - ball.centre;
            for (const double t : roots(glm::dot(ray.direction, ray.direction), glm::dot(from, ray.direction),
                                        glm::dot(from, from) - ball.radius * ball.radius))
                take(t, (ray.at(t) - ball.centre) / ball.radius, Material::marble);
        }
    }

    bool is_raised(Material material) const { return lighting_.is_displaced && material == Material::floor; }

    /// Returns the roots of a t^2 + 2 b t + c, NaN if there are none.
    static std::array<double, 2> roots(double a, double b, double c) {
        const double root = std::sqrt(b * b - a * c);
        return {(-b - root) / a, (-b + root) / a};
    }

    Hit first_hit(const Ray& ray) const {
        Hit first;
        each_hit(lighting_.scene, ray, INFINITY, [&](double t, const glm::dvec3& face, Material material) {
            if (t > 0 && t < first.t && glm::dot(face, ray.direction) < 0)
                first.t = t, first.face = face, first.material = material;
        });
        if (!std::isfinite(first.t)) return first;
        const glm::dvec3 place = ray.at(first.t);
        const double tile = tile_of[size_t(first.material)];
        const PlaneAxes axes =
            plane_axes(is_raised(first.material) ? glm::dvec3(0, 1, 0) : first.face);  // of its flat plane
        first.tangent = axes.right;
        first.uv = glm::dvec2(glm::dot(place, axes.right), glm::dot(place, axes.up)) / tile;
        if (is_raised(first.material)) {
            const glm::dvec2 slope = floor_at({place.x, place.z}).slope;
            first.face = glm::normalize(glm::dvec3(-slope.x, 1, -slope.y));
            first.tangent = glm::normalize(axes.right - glm::dot(axes.right, first.face) * first.face);
        }
        if (first.material == Material::marble && lighting_.scene.quads.size() == 1 && !lighting_.scene.columns.empty())
            first.uv = around(place);
        return first;
    }

    /// Returns the uv of a place on a column or ball. A tile goes once around.
    glm::dvec2 around(const glm::dvec3& place) const {
        for (const Column& column : lighting_.scene.columns) {
            const glm::dvec3 from = place - column.foot;
            if (std::hypot(from.x, from.z) < 1.001 * column.radius)
                return {std::atan2(from.x, from.z) / (2 * pi), from.y / tile_of[size_t(Material::marble)]};
        }
        const Ball& ball = lighting_.scene.balls.at(0);
        const glm::dvec3 from = (place - ball.centre) / ball.radius;
        return {std::atan2(-from.x, -from.z) / (2 * pi), 0.5 * (0.5 + std::asin(glm::clamp(from.y, -1.0, 1.0)) / pi)};
    }

    bool is_free(const Scene& scene, const Ray& ray, double most) const {
        bool free = true;
        each_hit(scene, ray, most,
                 [&](double t, const glm::dvec3&, Material) { free = free && !(t > 1e-9 && t < most); });
        return free;
    }

    Surface surface_at(const Ray& ray, const Hit& hit) const {
        Surface surface;
        surface.place = ray.at(hit.t), surface.face = hit.face;
        surface.straight = 0.04;
        glm::dvec3 bump(0, 0, 1), packed(marble_gloss, 1, 1);
        if (hit.material == Material::marble) {
            static const Map marble("marble_albedo.png", true);
            surface.albedo = marble.read(hit.uv);
        } else {
            const Maps& maps = maps_of(hit.material);
            surface.albedo = maps.albedo.read(hit.uv);
            bump = maps.normals.read(hit.uv) * 2.0 - 1.0, packed = maps.packed.read(hit.uv);
        }
        if (hit.material == Material::floor) {
            const double depth = water - ground_at({surface.place.x, surface.place.z}).height + 0.5 * (0.6 - packed.g);
            const double wet = ramp(0, 0.12, depth), damp = ramp(-0.35, 0.05, depth);
            bump = glm::mix(bump, glm::dvec3(0, 0, 1), wet);
            packed.r = glm::mix(packed.r, 1.0, std::max(wet, 0.3 * damp)), packed.b = glm::mix(packed.b, 1.0, wet);
            surface.albedo *= glm::mix(1.0, 0.55, damp) * glm::mix(1.0, 0.45, wet);
            surface.straight = glm::mix(0.04, 0.02, wet);
        }
        surface.normal =
            glm::normalize(bump.x * hit.tangent + bump.y * glm::cross(hit.face, hit.tangent) + bump.z * hit.face);
        surface.gloss = lighting_.gloss == Gloss::even ? 1 : packed.r, surface.occlusion = packed.b;
        surface.exponent = lighting_.gloss == Gloss::map ? lighting_.exponent * packed.r * (1 - lighting_.roughness)
                                                         : lighting_.exponent;
        return surface;
    }

    double share(double straight, double cosine) const {
        const double c = glm::clamp(cosine, 0.0, 1.0);
        if (lighting_.fresnel == Fresnel::whole) return 1;
        if (lighting_.fresnel == Fresnel::schlick) return straight + (1 - straight) * std::pow(1 - c, 5);
        const double root = std::sqrt(straight), eta = (1 + root) / (1 - root);
        const double within = std::sqrt(1 - (1 - c * c) / (eta * eta));
        const double s = (c - eta * within) / (c + eta * within), p = (within - eta * c) / (within + eta * c);
        return (s * s + p * p) / 2;
    }

    /// Returns a direction of the world in the coordinates of the sky, which turns with the sun.
    glm::dvec3 turned(const glm::dvec3& direction) const {
        const double s = std::sin(lighting_.sun_yaw_rad), c = std::cos(lighting_.sun_yaw_rad);
        return {c * direction.x - s * direction.z, direction.y, s * direction.x + c * direction.z};
    }

    /// Returns the middle of the mirrored lobe. A direction into the surface is mirrored once more.
    static glm::dvec3 mirrored(const Surface& surface, const glm::dvec3& to_eye, const glm::dvec3& normal) {
        const glm::dvec3 from = 2 * glm::dot(normal, to_eye) * normal - to_eye;
        return from - 2 * std::min(0.0, glm::dot(from, surface.face)) * surface.face;
    }

    /// Returns the share of the lobe cos^m about the mirrored direction that meets the sky.
    double mirror_openness(const Surface& surface, const glm::dvec3& to_eye, const glm::dvec3& normal) const {
        const double m = lighting_.gloss == Gloss::mirror ? 1e9 : surface.exponent;
        int free = 0;
        for (const glm::dvec3& way :
             places_around(mirrored(surface, to_eye, normal), [m](double u) { return std::pow(u, 1 / (m + 1)); }))
            free += glm::dot(way, surface.face) > 0 &&
                    is_free(lighting_.scene, {surface.place + 1e-7 * surface.face, way}, INFINITY);
        return double(free) / places;
    }

    /// Returns the light of the mirrored sky, blurred by cos^m, where m is the surface's exponent. At an angle a the
    /// blur falls off as exp(-m a^2 / 2), and a lobe of the sky of sharpness k as exp(-k a^2 / 2). The wider of the two
    /// is sampled at places of the narrower one, which have equal weights.
    glm::dvec3 mirrored_sky(const Surface& surface, const glm::dvec3& to_eye, const glm::dvec3& normal) const {
        const glm::dvec3 from = turned(mirrored(surface, to_eye, normal));
        if (lighting_.gloss == Gloss::mirror) return evening_sky(from);
        const double m = surface.exponent;
        glm::dvec3 sum(0);
        const std::vector<Lobe>& lobes = evening_lobes();
        const double least = std::exp(-20 / std::max(m, 1e-9));  // a smaller cosine has a power below 2.1e-9
        for (size_t i = 0; i < lobes.size(); ++i) {
            const double k = lobes[i].sharpness;
            if (k <= m) continue;
            double seen = 0;
            for (const glm::dvec3& place : places_of_lobes()[i]) {
                const double cosine = glm::dot(place, from);
                if (cosine > least) seen += std::pow(cosine, m);
            }
            // The integral of the lobe over the sphere is 2 pi / k (1 - exp(-2 k)).
            sum += lobes[i].color * ((m + 1) / k * (1 - std::exp(-2 * k)) * seen / places);
        }
        for (const glm::dvec3& place : places_around(from, [m](double u) { return std::pow(u, 1 / (m + 1)); }))
            for (const Lobe& lobe : lobes)
                if (lobe.sharpness <= m)
                    sum += lobe.color * (std::exp(lobe.sharpness * (glm::dot(place, lobe.middle) - 1)) / places);
        return sum;
    }

    static constexpr int rings = 8, spokes = 11, places = rings * spokes;
    using Places = std::array<glm::dvec3, size_t(places)>;
    /// Returns places around a direction, in rings with equal shares of a lobe. cosine_of(share) returns the cosine of
    /// the angle that bounds a share of the lobe.
    template <class CosineOf>
    static Places places_around(const glm::dvec3& middle, CosineOf cosine_of) {
        const PlaneAxes axes = plane_axes(middle);
        Places found;
        for (int ring = 0; ring < rings; ++ring) {
            const double cosine = cosine_of((ring + 0.5) / rings), sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
            for (int i = 0; i < spokes; ++i) {
                const double turn = 2 * pi * (i + 0.5 * (ring % 2)) / spokes;
                found[size_t(ring * spokes + i)] =
                    cosine * middle + sine * (std::cos(turn) * axes.right + std::sin(turn) * axes.up);
            }
        }
        return found;
    }
    static const std::vector<Places>& places_of_lobes() {
        static const std::vector<Places> all = [] {
            std::vector<Places> made;
            for (const Lobe& lobe : evening_lobes()) {
                const double k = std::max(lobe.sharpness, 1e-3);
                made.push_back(places_around(
                    lobe.middle, [k](double u) { return 1 + std::log(u + (1 - u) * std::exp(-2 * k)) / k; }));
            }
            return made;
        }();
        return all;
    }

    double shadow(const Surface& surface) const {
        if (glm::dot(surface.face, lighting_.to_sun) <= 0) return 0;
        return is_free(lighting_.scene, {surface.place + 1e-7 * surface.face, lighting_.to_sun}, INFINITY) ? 1 : 0;
    }

    /// Returns the scene without boxes and columns beyond the reach of occlusion.
    Scene within_reach(const glm::dvec3& place) const {
        Scene near = lighting_.scene;
        const auto is_far = [&](const glm::dvec3& low, const glm::dvec3& high) {
            return glm::distance(place, glm::clamp(place, low, high)) > 1.001 * near.reach;
        };
        std::erase_if(near.boxes, [&](const Box& box) { return is_far(box.low, box.high); });
        std::erase_if(near.columns, [&](const Column& column) {
            const glm::dvec3 side(column.radius, 0, column.radius);
            return is_far(column.foot - side, column.foot + side + glm::dvec3(0, column.height, 0));
        });
        return near;
    }

    /// Returns the share of 1024 cosine-distributed rays (Hammersley points) that meet no occluder.
    double openness(const Surface& surface) const {
        constexpr int rays = 1024;
        const PlaneAxes axes = plane_axes(surface.face);
        const Scene occluders = within_reach(surface.place);
        int free = 0;
        for (int i = 0; i < rays; ++i) {
            double radical = 0;
            for (int bit = 0; bit < 10; ++bit)
                if (i >> bit & 1) radical += 1.0 / (2 << bit);
            const double square = (i + 0.5) / rays, turn = 2 * pi * radical, r = std::sqrt(square);
            const glm::dvec3 direction =
                r * (std::cos(turn) * axes.right + std::sin(turn) * axes.up) + std::sqrt(1 - square) * surface.face;
            free += is_free(occluders, {surface.place + 1e-7 * surface.face, direction}, lighting_.scene.reach);
        }
        return double(free) / rays;
    }

    glm::dvec3 lamp(const Surface& surface, const glm::dvec3& to_light, const glm::dvec3& to_eye) const {
        const double facing = std::max(0.0, glm::dot(surface.normal, to_light)), exponent = 4 * surface.exponent;
        const glm::dvec3 sum = to_light + to_eye, between = sum / std::max(1e-6, glm::length(sum));
        const double lobe = std::pow(std::max(1e-6, glm::dot(surface.normal, between)), exponent),
                     mirrored = surface.gloss * share(surface.straight, glm::dot(between, to_light));
        return facing * (surface.albedo + mirrored * (exponent + 8) / 8 * lobe);
    }

    Terms terms(const Surface& surface, const glm::dvec3& to_eye) const {
        Terms terms;
        terms.ambient =
            surface.albedo * glm::mix(lighting_.ambient[0], lighting_.ambient[1], 0.5 + 0.5 * surface.normal.y);
        terms.occlusion = (lighting_.ao ? openness(surface) : 1) * (lighting_.occlusion ? surface.occlusion : 1);
        terms.shadow = lighting_.shadow ? shadow(surface) : 1;
        terms.lamps = terms.shadow * lighting_.lamp_color[0] * lamp(surface, lighting_.to_sun, to_eye);
        for (size_t i = 1; i < size_t(lighting_.lamps); ++i) {
            const glm::dvec3 way = lighting_.lamp_place[i] - surface.place;
            const double square = glm::dot(way, way);
            terms.lamps += lighting_.lamp_color[i] / std::max(square, 0.01) *
                           lamp(surface, way / std::sqrt(std::max(square, 1e-8)), to_eye);
        }
        const glm::dvec3 normal = lighting_.light_only ? surface.face : surface.normal;
        terms.share = surface.gloss * share(surface.straight, glm::dot(normal, to_eye));
        if (lighting_.reflection) terms.mirror = terms.share * mirrored_sky(surface, to_eye, normal);
        if (lighting_.mirror_occlusion) terms.mirror *= mirror_openness(surface, to_eye, normal);
        terms.light = terms.ambient * terms.occlusion + terms.lamps + terms.mirror;
        return terms;
    }

    const Lighting& lighting_;
};

std::optional<Image> exact_values(const Frame& frame, const Lighting& lighting) {
    const Exact exact(lighting);
    const glm::dmat4 clip_from_world = frame.camera.clip_from_world();
    return truth_of_rays(
        frame, [&](const Ray& ray) { return exact.value(drawn_part(clip_from_world, ray), frame.probe.name); });
}

std::optional<Terms> terms_of_ray(const Ray& ray, const Lighting& lighting) { return Exact(lighting).terms(ray); }

const decltype(truth)::Provided provided(truth, exact_values);
const decltype(exact_terms)::Provided provided_terms(exact_terms, terms_of_ray);

}  // namespace
}  // namespace relief::court
