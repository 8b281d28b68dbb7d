#include "scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "framework/base/error.h"
#include "framework/base/paths.h"
#include "framework/image/asset.h"

namespace relief::materials {
namespace {

namespace fs = std::filesystem;

/// Sets the tangents from the gradients of u and v on each triangle. xyz points along growing u, and w is the
/// handedness. Degenerate triangles set none.
void add_tangents(Mesh& mesh) {
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex* corner[3];
        for (size_t k = 0; k < 3; ++k) corner[k] = &mesh.vertices[mesh.indices[i + k]];
        const glm::dvec3 a = corner[0]->position, b = corner[1]->position, c = corner[2]->position;
        const glm::dvec3 face = glm::cross(b - a, c - a);
        // The gradient of a corner's weight lies across the opposite edge.
        const std::array across = {glm::cross(face, c - b), glm::cross(face, a - c), glm::cross(face, b - a)};
        glm::dvec3 along_u(0), along_v(0);
        for (size_t k = 0; k < 3; ++k)
            along_u += across[k] * double(corner[k]->uv.x), along_v += across[k] * double(corner[k]->uv.y);
        if (glm::dot(along_u, along_u) == 0) continue;
        for (Vertex* vertex : corner) {
            const glm::dvec3 n = vertex->normal, flat = along_u - n * glm::dot(n, along_u);
            if (glm::dot(flat, flat) == 0) continue;
            const double side = glm::dot(glm::cross(n, flat), along_v) < 0 ? -1 : 1;
            vertex->tangent = glm::vec4(glm::normalize(flat), side);
        }
    }
}

/// Finds the maps of materials and their kinds. Each picture is examined once.
class Maps {
public:
    Maps(const std::function<MapKind(const Image&)>& kind_of, std::vector<std::string>& notes)
        : kind_of_(kind_of), notes_(notes) {}

    /// Returns the path of a map in the folder of assets. If the file is missing, adds a note and returns nothing.
    std::string asset(const Material& material, const char* keyword, const fs::path& file) {
        if (file.empty()) return {};
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored)) return file.lexically_proximate(course_root() / "assets").string();
        note(material,
             fmt::format("{} of '{}' is left out: {} is not there", keyword, material.name, file.filename().string()));
        return {};
    }

    /// Returns the feature of a bump map. Adds a note if it does not hold heights. Returns 0 if it holds no normals
    /// either.
    unsigned bump(const Material& material, const std::string& name) {
        const auto [kind, is_new] = kinds_.try_emplace(name);
        if (is_new) kind->second = kind_of_(read_asset(name));
        if (kind->second == MapKind::heights) return height_map;
        const bool normals = kind->second == MapKind::normals;
        note(material, fmt::format("map_bump of '{}' {}", material.name,
                                   normals ? "holds normals, not heights: read as norm"
                                           : "holds neither heights nor normals: left out"));
        return normals ? unsigned(normal_map) : 0;
    }

private:
    void note(const Material& material, const std::string& message) {
        if (notes_.size() < 20) notes_.push_back(Error({material.file.filename(), material.line}, message).what());
    }

    const std::function<MapKind(const Image&)>& kind_of_;
    std::vector<std::string>& notes_;
    std::map<std::string, MapKind> kinds_;
};

/// Returns the alpha of a level at (u, v) in tiles by GL's bilinear filter.
double alpha_at(const Image& level, double u, double v) {
    const double x = u * level.width - 0.5, y = v * level.height - 0.5;
    const double left = std::floor(x), low = std::floor(y);
    const auto texel = [&](double column, double row) {
        const int w = level.width, h = level.height;
        return double(*level.pixel(((int(column) % w) + w) % w, ((int(row) % h) + h) % h));
    };
    const double bottom = glm::mix(texel(left, low), texel(left + 1, low), x - left);
    return glm::mix(bottom, glm::mix(texel(left, low + 1), texel(left + 1, low + 1), x - left), y - low);
}

/// Returns the alpha at 16,384 evenly distributed places, for any size of texels (Roberts 2018).
std::vector<double> alphas_of(const Image& level) {
    std::vector<double> alphas;
    for (int i = 0; i < 1 << 14; ++i) {
        const double u = (i + 0.5) * 0.7548776662466927, v = (i + 0.5) * 0.5698402909980532;
        alphas.push_back(alpha_at(level, u - std::floor(u), v - std::floor(v)));
    }
    return alphas;
}

}  // namespace

std::string words(unsigned features) {
    static const std::array names = {"Kd", "Ks", "norm", "bump", "d", "glass"};
    std::string text;
    for (size_t i = 0; i < names.size(); ++i)
        if (features >> i & 1) text.append(text.empty() ? "" : " ").append(names[i]);
    return text;
}

Scene make_scene(ObjModel model, bool with_maps, const std::function<MapKind(const Image&)>& kind_of) {
    Scene scene{std::move(model.mesh), {}, 0, std::move(model.notes)};
    add_tangents(scene.mesh);
    Maps maps(kind_of, scene.notes);
    std::map<unsigned, int> program_of;
    for (const Subset& subset : model.subsets) {
        Piece piece;
        if (subset.material >= 0) {
            piece.material = model.materials[size_t(subset.material)];
        } else {  // grey and not black, so that a missing material is visible
            piece.material.name = "(missing)";
            piece.material.diffuse = glm::vec3(0.6f);
        }
        const Material& material = piece.material;
        if (material.opacity == 0) continue;
        if (material.opacity < 1) piece.features |= glass;
        if (with_maps) {
            piece.colors = maps.asset(material, "map_Kd", material.diffuse_map);
            piece.highlights = maps.asset(material, "map_Ks", material.specular_map);
            piece.mask = maps.asset(material, "map_d", material.opacity_map);
            piece.bumps = maps.asset(material, "norm", material.normal_map);
            if (!piece.bumps.empty())
                piece.features |= normal_map;
            else if (piece.bumps = maps.asset(material, "map_bump", material.bump_map); !piece.bumps.empty())
                piece.features |= maps.bump(material, piece.bumps);
            if (!piece.colors.empty()) piece.features |= color_map;
            if (!piece.highlights.empty()) piece.features |= highlight_map;
            if (!piece.mask.empty()) piece.features |= mask_map;
        }
        piece.program = program_of.try_emplace(piece.features, int(program_of.size())).first->second;
        piece.first_index = subset.first_index, piece.index_count = subset.index_count;
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (uint32_t i = 0; i < subset.index_count; ++i) {
            const glm::dvec3 place = scene.mesh.vertices[scene.mesh.indices[subset.first_index + i]].position;
            low = glm::min(low, place), high = glm::max(high, place);
        }
        piece.centre = (low + high) / 2.0;
        scene.pieces.push_back(std::move(piece));
    }
    scene.programs = int(program_of.size());
    return scene;
}

ObjModel thousand_tiles() {
    constexpr int columns = 40, rows = 25;
    std::string obj = "s off\n", mtl;
    for (int i = 0; i < columns * rows; ++i) {
        const double x = 0.15 * (i % columns - columns / 2), z = 0.15 * (i / columns - rows / 2);
        for (const auto& [dx, dz] : {std::pair(0.0, 0.14), {0.14, 0.14}, {0.14, 0.0}, {0.0, 0.0}})
            obj += fmt::format("v {:.3f} 0 {:.3f}\nvt {:.3f} {:.3f}\n", x + dx, z + dz, 4 * dx, -4 * dz);
        obj += fmt::format("usemtl {0}\nf {1}/{1} {2}/{2} {3}/{3} {4}/{4}\n", i, 4 * i + 1, 4 * i + 2, 4 * i + 3,
                           4 * i + 4);
        const auto shade = [&](int prime) { return 0.25 + 0.6 * ((i * prime) % 101) / 100; };
        mtl +=
            fmt::format("newmtl {}\nKd {:.2f} {:.2f} {:.2f}\n{}", i, shade(37), shade(53), shade(71),
                        std::array{"", "map_Kd paving_albedo.png\n", "map_d wire_mask.png\n",
                                   "map_Kd bricks_albedo.png\nmap_bump bricks_normal.png\n"}[size_t(i * 7 % 11 % 4)]);
    }
    return parse_obj(obj, mtl, course_root() / "assets" / "thousand.obj");
}

double share_above(const Image& level, double threshold) {
    const std::vector<double> alphas = alphas_of(level);
    return double(std::count_if(alphas.begin(), alphas.end(), [&](double a) { return a > threshold; })) /
           double(alphas.size());
}

std::vector<float> kept_scales(const std::vector<Image>& levels) {
    const double share = share_above(levels.at(0), 0.5);
    std::vector<float> scales = {1};
    for (size_t i = 1; i < levels.size(); ++i) {
        std::vector<double> alphas = alphas_of(levels[i]);
        const auto place = alphas.begin() + std::ptrdiff_t(double(alphas.size() - 1) * (1 - share));
        std::nth_element(alphas.begin(), place, alphas.end());
        scales.push_back(float(0.5 / std::max(*place, 1.0 / 512)));
    }
    return scales;
}

}  // namespace relief::materials
