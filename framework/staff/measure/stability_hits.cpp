// Intersections of view rays with a relief, by the shaders' searches. Rays graze the surface or begin far from the
// origin; the relief is deep or its map fine. Also intersections of rays with a mesh.
#include <bit>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <memory>
#include <random>

#include "framework/core/base/paths.h"
#include "framework/core/gl/program.h"
#include "framework/core/gl/target.h"
#include "framework/core/gl/texture.h"
#include "framework/library/maps/skips.h"
#include "framework/library/maps/test_maps.h"
#include "framework/staff/measure/edge_rays.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/stability.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/mesh_rays.h"

namespace relief::measure {
namespace {

constexpr unsigned ray_seed = 5;
constexpr double least_slant = 0.002;

struct Setting {
    double cosine = 0.5;  ///< of the angle between ray and normal
    double tiles = 0;     ///< number of tiles between the rays and the origin of uv
    double depth = 0.08;  ///< in tiles
    int size = 256;       ///< side of the map, in texels
};

/// The rays of one point of a sweep, the map, and the exact hits in double precision.
class Rays {
public:
    Rays(const Setting& setting, int side, HeightMap map)
        : setting_(setting),
          heights_(make_height_map(map, setting.size)),
          field_(heights_, true),
          rays_(side, side, 4) {
        std::mt19937 random(ray_seed);
        std::uniform_real_distribution<> share(0, 1);
        for (size_t i = 0; i < rays_.values.size(); i += 4) {
            const double turn = 2 * glm::pi<double>() * share(random);
            const double values[] = {share(random), share(random), std::cos(turn), std::sin(turn)};
            for (size_t k = 0; k < 4; ++k) rays_.values[i + k] = float(values[k]);
        }
    }

    const Setting& setting() const { return setting_; }
    const Image& heights() const { return heights_; }
    float sine() const { return float(std::sqrt(1 - setting_.cosine * setting_.cosine)); }
    float cosine() const { return float(setting_.cosine); }

    /// Returns the rays as the shader gets them: at their position, or relative to their tile.
    Image uploaded(bool without_tiles) const {
        Image rays = rays_;
        if (!without_tiles)
            for (size_t i = 0; i < rays.values.size(); i += 4)
                for (size_t k = 0; k < 2; ++k) rays.values[i + k] = float(double(rays.values[i + k]) + setting_.tiles);
        return rays;
    }

    /// Returns the hit of ray `i`, in texels from the origin of the tile in which the ray begins. `held` clamps the
    /// slant as the course's rays do.
    glm::dvec2 hit(size_t i, bool held) const {
        const float* const ray = &rays_.values[4 * i];
        const double slant = held ? std::max(double(cosine()), least_slant) : double(cosine());
        const glm::dvec2 march =
            -glm::dvec2(ray[2], ray[3]) * (double(sine()) / slant * setting_.depth * setting_.size);
        const glm::dvec2 from = glm::dvec2(ray[0], ray[1]) * double(setting_.size);
        const auto hit = field_.first_hit({{from, 1}, {march, -1}}, 1);
        return from + (hit ? hit->t : 1.0) * march;
    }

    const std::vector<glm::dvec2>& hits(bool held) {
        std::vector<glm::dvec2>& hits = hits_[held];
        if (hits.empty())
            for (size_t i = 0; i < rays_.pixel_count(); ++i) hits.push_back(hit(i, held));
        return hits;
    }

    int side() const { return rays_.width; }

private:
    Setting setting_;
    Image heights_;
    HeightField field_;
    Image rays_;
    std::map<bool, std::vector<glm::dvec2>> hits_;
};

struct Search {
    const char* name;
    std::vector<std::string> defines;
    double stated;  ///< in texels, for 99 of 100 rays
    const char* why;
    bool peer = false;
};

const std::vector<Search>& searches() {
    constexpr const char* exact = "Cells are counted in whole numbers: no place is compared with its own rounding.";
    constexpr const char* steps = "It steps over what is narrower than a step.";
    static const std::vector<Search> all = {
        {"windows", {"EXACT", "WINDOWS"}, 0.05, exact},
        {"walk", {"EXACT"}, 0.05, exact},
        {"exact-of-error-maps", {"EXACT_COMMON"}, 0.05, exact},
        {"steep-32", {"STEEP"}, 1, steps},
        {"secant-8", {"MARCH", "BY_TEXEL 0"}, 1, steps},
        {"by-texel-2",
         {"MARCH", "BY_TEXEL 2"},
         1,
         "Two texels a step pass over what is narrower, and there are no more than 1024."},
        {"usual", {"USUAL"}, 1, "It steps over what is narrower than a step; its uv keep their whole tiles.", true},
        {"relief-mapping-32+5",
         {"RELIEF_MAPPING"},
         1,
         "It steps over what is narrower than a step; its uv keep their whole tiles.",
         true},
        {"walk-with-a-nudge",
         {"NUDGED"},
         0.05,
         "A ten-thousandth of a texel is less than a float resolves some thousand texels from the origin, or along the "
         "ray: it comes to its wall and stays there.",
         true}};
    return all;
}

/// Draws one search over all rays. Returns 4 floats per ray.
Image search(const Search& method, const Rays& rays) {
    const auto folder = course_root() / "framework" / "staff" / "measure";
    const Program program({folder / "rays.vert", folder / "rays.frag"}, method.defines);
    const Texture heights("heights", [&] { return rays.heights(); }, {.mips = false});
    const Texture places("rays", [&] { return rays.uploaded(!method.peer); }, {.mips = false});
    HeightWindows windows;
    const bool has_windows = method.defines.back() == "WINDOWS" || method.defines.back() == "EXACT_COMMON";
    if (has_windows) windows = height_windows(rays.heights());
    const Texture clearance("windows", [&] { return windows.clearance; }, {.mips = false, .layers = 8});

    const Target target(TargetKind::probe, glm::ivec2(rays.side()));
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glViewport(0, 0, rays.side(), rays.side());
    glUseProgram(program);
    program.set("s_heights", 0, heights);
    program.set("s_rays", 1, places);
    program.set("u_sine", rays.sine());
    program.set("u_cosine", rays.cosine());
    program.set("u_depth", rays.setting().depth);
    program.set("u_highest", *std::max_element(rays.heights().values.begin(), rays.heights().values.end()));
    if (has_windows) {
        program.set("s_windows", 3, clearance);
        program.set("u_window_extent", windows.extents());
        if (method.defines.front() == "EXACT") {
            program.set("u_block", float(windows.block));
            program.set("u_per_block", 1.0f / float(windows.block));
        }
    }
    const VertexArrayName nothing;
    glBindVertexArray(nothing);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    Image found = target.read(4);
    glBindVertexArray(0);
    glUseProgram(0);
    return found;
}

BenchSweep::Place place_of(const Search& method, Rays& rays, double hardness) {
    const Image found = search(method, rays);
    const Setting& setting = rays.setting();
    const std::vector<glm::dvec2>& hits = rays.hits(!method.peer);
    const glm::dvec2 dropped(method.peer ? setting.tiles : 0);
    Tally tally;
    const int side = rays.side();
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const size_t i = size_t(y) * size_t(side) + size_t(x);  // row 0 is the top in both images
            const float* const hit = found.pixel(x, y);
            if (hit[2] > 0)
                tally.endless();
            else
                tally.add(glm::length((glm::dvec2(hit[0], hit[1]) - dropped) * double(setting.size) - hits[i]));
        }
    return tally.most(hardness);
}

BenchScene hits_scene(const char* input, const char* axis, const std::vector<double>& hardness, int side, HeightMap map,
                      const std::function<Setting(double)>& setting) {
    // All methods share the rays of a point and their exact hits.
    const auto made = std::make_shared<std::map<double, std::unique_ptr<Rays>>>();
    std::vector<SweptMethod> methods;
    for (const Search& method : searches())
        methods.push_back({method.name, method.stated, method.why,
                           [=](double hard) {
                               std::unique_ptr<Rays>& rays = (*made)[hard];
                               if (!rays) rays = std::make_unique<Rays>(setting(hard), side, map);
                               return place_of(method, *rays, hard);
                           },
                           method.peer});
    return sweep_scene(input, axis, "texel", hardness, methods);
}

/// The first hit of a mesh, as in a bake, with increasing distance from the origin, where positions are rounded.
BenchScene mesh_scene(const BenchSettings& settings) {
    using HitsOf = std::function<std::vector<double>(const RaysThroughEdges&)>;
    const auto method = [quick = settings.quick](const char* name, const char* why, const HitsOf& search, bool peer) {
        return SweptMethod{name, 1e-6, why,
                           [=](double away) {
                               const RaysThroughEdges rays(quick ? 16 : 48, quick ? 2000 : 20'000, away);
                               const std::vector<double> hits = search(rays);
                               Tally tally;
                               for (size_t i = 0; i < hits.size(); ++i)
                                   if (hits[i] < 0)
                                       tally.lost();
                                   else
                                       tally.add(glm::length(rays.rays[i].direction) * std::abs(hits[i] - 1));
                               return tally.most(away);
                           },
                           peer};
    };
    std::vector<SweptMethod> methods = {method(
        "double", "All corners and rays in double precision: an edge belongs to both of its triangles.",
        [](const RaysThroughEdges& rays) {
            const auto tree = build_tree(rays.mesh);
            std::vector<double> hits;
            for (const Ray& ray : rays.rays) {
                const auto hit = first_hit(tree, rays.mesh, ray, 2);
                hits.push_back(hit ? hit->t : -1);
            }
            return hits;
        },
        false)};
    for (const bool robust : {true, false})
        if (has_peers())
            methods.push_back(method(
                robust ? "Embree-robust" : "Embree",
                "Some rays slip through a vertex or an edge; in floats all others begin beside their place.",
                [robust](const RaysThroughEdges& rays) {
                    std::vector<double> hits;
                    embree_hits(rays.mesh, robust, true)->run(rays.rays, hits);
                    return hits;
                },
                true));
    return sweep_scene("hits-of-mesh", "radii of the mesh from the origin", "metre",
                       decades(0, 5, settings.quick ? 2.5 : 0.5), methods);
}

}  // namespace

std::vector<BenchScene> hit_sweeps(const BenchSettings& settings) {
    const int side = settings.quick ? 16 : 48;
    std::vector<double> angles;
    for (const double degrees : {30.0, 60.0, 75.0, 85.0, 88.0, 89.0, 89.5, 89.9, 89.99})
        if (!settings.quick || degrees == 60 || degrees == 85 || degrees == 89 || degrees == 89.99)
            angles.push_back(1 / std::cos(glm::radians(degrees)));
    const std::vector<double> tiles = decades(0, 6, settings.quick ? 2 : 0.5);
    std::vector<double> depths = {0.01, 0.03, 0.1, 0.3, 1, 3}, sizes = {64, 128, 256, 512, 1024, 2048};
    if (settings.quick) depths = {0.01, 0.1, 1}, sizes = {64, 512};
    return {hits_scene("hits-angle", "1 / cosine of the angle (11: 85, 57: 89, 573: 89.9, 5730: 89.99 degrees)", angles,
                       side, HeightMap::fbm, [](double hard) { return Setting{.cosine = 1 / hard}; }),
            hits_scene("hits-tiles", "tiles from the origin of uv", tiles, side, HeightMap::fbm,
                       [](double hard) { return Setting{.tiles = std::round(hard)}; }),
            hits_scene("hits-depth", "depth of the relief, tiles (seen at 75 degrees)", depths, side, HeightMap::fbm,
                       [](double hard) { return Setting{.cosine = std::cos(glm::radians(75.0)), .depth = hard}; }),
            hits_scene("hits-size", "size of the map, texels (seen at 75 degrees)", sizes, side, HeightMap::bricks,
                       [](double hard) { return Setting{.cosine = std::cos(glm::radians(75.0)), .size = int(hard)}; }),
            mesh_scene(settings)};
}

}  // namespace relief::measure
