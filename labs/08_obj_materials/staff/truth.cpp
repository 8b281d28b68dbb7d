// The staff's part of lab 08: see ../truth.h.
#include "truth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "framework/core/image/asset.h"
#include "framework/core/image/color.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/masks.h"

namespace relief::materials {
namespace {

/// Level 0 of a picture, read by GL's bilinear filter in double precision.
class ExactMap {
public:
    ExactMap(const std::string& asset, bool is_color) : image_(read_asset(asset)) {
        if (is_color)
            for (float& value : image_.values) value = float(linear_from_srgb(double(value)));
    }

    glm::dvec4 at(const glm::dvec2& uv) const {
        const double x = uv.x * image_.width - 0.5, y = (1 - uv.y) * image_.height - 0.5;
        const double left = std::floor(x), top = std::floor(y);
        return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                        glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
    }
    glm::dvec2 texel_size() const { return 1.0 / glm::dvec2(image_.width, image_.height); }

private:
    glm::dvec4 texel(double column, double row) const {
        const int w = image_.width, h = image_.height, x = int(column - w * std::floor(column / w)),
                  y = int(row - h * std::floor(row / h));
        const float* const values = image_.pixel(x, y);
        glm::dvec4 result(0);
        for (int c = 0; c < image_.channels; ++c) result[c] = double(values[c]);
        return result;
    }

    Image image_;
};

const ExactMap& exact_map(const std::string& asset, bool is_color) {
    static std::mutex mutex;
    static std::map<std::pair<std::string, bool>, ExactMap> maps;
    const std::lock_guard lock(mutex);
    return maps.try_emplace({asset, is_color}, asset, is_color).first->second;
}

/// Returns the kind of a picture of the course, independent of a student's kind_of().
MapKind true_kind(const std::string& asset) {
    if (asset.ends_with("_height.png")) return MapKind::heights;
    return asset.ends_with("_normal.png") ? MapKind::normals : MapKind::neither;
}

bool is_covered(const std::string& mask, const glm::dvec2& uv) {
    return mask.starts_with("wire") ? is_wire(uv) : leaf_at(uv).has_value();
}

double share_of(const Lights& lights, const glm::dvec3& place) {
    const glm::dvec3 from_lamp = place - lights.place;
    const double d = glm::length(from_lamp);
    if (lights.lamp == sun || d >= lights.range) return 0;
    const double share = 1 / glm::dot(lights.attenuation, glm::dvec3(1, d, d * d));
    if (lights.cone == 0 || d == 0) return share;
    return share * std::pow(std::max(glm::dot(from_lamp / d, lights.axis), 0.0), lights.cone);
}

struct Hit {
    double t;
    const Piece* piece;
    int index;
    glm::dvec3 place, normal;  ///< on the mesh, without bump maps
    glm::dvec4 tangent;
    glm::dvec2 uv;
};

class ExactGarden {
public:
    ExactGarden(const Setting& setting, const Frame& frame) : setting_(setting), frame_(frame) {
        const Mesh& mesh = setting.scene.mesh;
        for (size_t p = 0; p < setting.scene.pieces.size(); ++p) {
            const Piece& piece = setting.scene.pieces[p];
            for (uint32_t i = 0; i + 2 < piece.index_count; i += 3) {
                Triangle triangle{int(p), {}, {}, {}};
                for (size_t k = 0; k < 3; ++k)
                    triangle.corners[k] = &mesh.vertices[mesh.indices[piece.first_index + i + k]];
                bound(triangle);
                triangles_.push_back(triangle);
            }
            kinds_.push_back(true_kind(piece.bumps));
            if (!piece.colors.empty()) colors_[&piece] = &exact_map(piece.colors, true);
            if (!piece.highlights.empty()) highlights_[&piece] = &exact_map(piece.highlights, false);
            if (!piece.bumps.empty()) bumps_[&piece] = &exact_map(piece.bumps, false);
        }
        order();
        find_blocks();
    }

    glm::dvec4 value(int x, int y, const std::string& probe) const {
        std::vector<const Triangle*> near;
        for (const int i : blocks_[size_t(y / block_side * columns() + x / block_side)]) {
            const Triangle& triangle = triangles_[size_t(i)];
            if (x + 1 >= triangle.low.x && x <= triangle.high.x && y + 1 >= triangle.low.y && y <= triangle.high.y)
                near.push_back(&triangle);
        }
        const glm::dvec2 middle(x + 0.5, y + 0.5);
        if (probe == "color") return glm::dvec4(mean_color(near, {x, y}), 0);
        if (probe == "coverage") return coverage(near, {x, y});
        const Ray ray = ray_at(middle);
        const std::vector<Hit> hits = hits_of(near, ray);
        if (probe == "layers") {
            int count = 0;
            for (const Hit& hit : hits) {
                ++count;
                if (!hit.piece->is_glass()) break;
            }
            return glm::dvec4(count, 0, 0, 0);
        }
        if (hits.empty()) return glm::dvec4(no_surface);
        const Hit& hit = hits.front();
        if (probe == "material") return glm::dvec4(hit.index, 0, 0, 0);
        if (probe == "order") return glm::dvec4(ranks_[size_t(hit.index)], 0, 0, 0);
        if (probe == "lamp") return glm::dvec4(share_of(setting_.lights, hit.place), 0, 0, 0);
        if (probe == "specular") return shine_of(hit);
        return glm::dvec4(normal_of(hit, -ray.direction), 0);
    }

private:
    struct Triangle {
        int piece;
        const Vertex* corners[3];
        glm::dvec2 low, high;  ///< pixels that it may cover
    };

    Ray ray_at(const glm::dvec2& pixel) const {
        return frame_.camera.ray({pixel.x / frame_.size.x * 2 - 1, 1 - pixel.y / frame_.size.y * 2});
    }

    void bound(Triangle& triangle) const {
        triangle.low = glm::dvec2(-INFINITY), triangle.high = glm::dvec2(INFINITY);
        glm::dvec2 low(INFINITY), high(-INFINITY);
        for (const Vertex* corner : triangle.corners) {
            const glm::dvec4 clip = frame_.camera.clip_from_world() * glm::dvec4(corner->position, 1);
            if (clip.w < 1e-3) return;  // partly behind the eye: it may cover any pixel
            const glm::dvec2 pixel = (glm::dvec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * glm::dvec2(frame_.size);
            low = glm::min(low, pixel), high = glm::max(high, pixel);
        }
        triangle.low = low, triangle.high = high;
    }

    int columns() const { return (frame_.size.x + block_side - 1) / block_side; }

    /// Lists the triangles of each block of pixels, so that a pixel tests only a few of them.
    void find_blocks() {
        const int rows = (frame_.size.y + block_side - 1) / block_side;
        blocks_.resize(size_t(columns() * rows));
        const auto block = [](double pixel, int count) {
            return int(std::clamp(std::floor(pixel / block_side), 0.0, double(count - 1)));
        };
        for (size_t i = 0; i < triangles_.size(); ++i) {
            const Triangle& triangle = triangles_[i];
            if (!(triangle.high.x >= 0 && triangle.high.y >= 0 && triangle.low.x <= frame_.size.x &&
                  triangle.low.y <= frame_.size.y))
                continue;
            for (int row = block(triangle.low.y - 1, rows); row <= block(triangle.high.y + 1, rows); ++row)
                for (int column = block(triangle.low.x - 1, columns()); column <= block(triangle.high.x + 1, columns());
                     ++column)
                    blocks_[size_t(row * columns() + column)].push_back(int(i));
        }
    }

    /// Finds the rank of each piece in the order of task 8.2: opaque ones by program and from near to far, then glass
    /// from far to near. Ties go by index.
    void order() {
        std::map<unsigned, int> program_of;
        std::vector<std::tuple<int, int, double, int>> keys;
        for (size_t i = 0; i < setting_.scene.pieces.size(); ++i) {
            const Piece& piece = setting_.scene.pieces[i];
            unsigned features = piece.features & ~unsigned(normal_map | height_map);
            if (kinds_[i] != MapKind::neither && !piece.bumps.empty())
                features |= kinds_[i] == MapKind::heights ? height_map : normal_map;
            const int program = program_of.try_emplace(features, int(program_of.size())).first->second;
            const double away = glm::distance(piece.centre, frame_.camera.eye());
            keys.emplace_back(piece.is_glass(), piece.is_glass() ? 0 : program, piece.is_glass() ? -away : away,
                              int(i));
        }
        std::sort(keys.begin(), keys.end());
        ranks_.resize(keys.size());
        for (size_t rank = 0; rank < keys.size(); ++rank) ranks_[size_t(std::get<3>(keys[rank]))] = int(rank);
    }

    static std::optional<Hit> meet(const Triangle& triangle, const Ray& ray) {
        const glm::dvec3 a = triangle.corners[0]->position, ab = glm::dvec3(triangle.corners[1]->position) - a,
                         ac = glm::dvec3(triangle.corners[2]->position) - a;
        const glm::dvec3 across = glm::cross(ray.direction, ac);
        const double determinant = glm::dot(ab, across);
        if (determinant == 0) return {};
        const glm::dvec3 off = ray.origin - a;
        const double v = glm::dot(off, across) / determinant;
        const glm::dvec3 other = glm::cross(off, ab);
        const double w = glm::dot(ray.direction, other) / determinant, t = glm::dot(ac, other) / determinant;
        if (v < 0 || w < 0 || v + w > 1 || t <= 1e-6) return {};
        Hit hit{t, nullptr, triangle.piece, ray.at(t), {}, {}, {}};
        const double shares[] = {1 - v - w, v, w};
        for (size_t k = 0; k < 3; ++k) {
            hit.normal += shares[k] * glm::dvec3(triangle.corners[k]->normal);
            hit.tangent += shares[k] * glm::dvec4(triangle.corners[k]->tangent);
            hit.uv += shares[k] * glm::dvec2(triangle.corners[k]->uv);
        }
        hit.normal = glm::normalize(hit.normal);
        return hit;
    }

    glm::dvec2 mask_uv(const Hit& hit) const { return hit.piece->has(color_map) ? hit.uv : setting_.fence * hit.uv; }

    /// Returns all surfaces along the ray, the nearest first. Masked surfaces count where their formula covers them.
    std::vector<Hit> hits_of(const std::vector<const Triangle*>& near, const Ray& ray) const {
        std::vector<Hit> hits;
        for (const Triangle* triangle : near)
            if (auto hit = meet(*triangle, ray)) {
                hit->piece = &setting_.scene.pieces[size_t(hit->index)];
                if (!hit->piece->has(mask_map) || is_covered(hit->piece->mask, mask_uv(*hit))) hits.push_back(*hit);
            }
        std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
        // A ray through the common edge of two triangles hits both, but they are one layer.
        hits.erase(std::unique(hits.begin(), hits.end(),
                               [](const Hit& a, const Hit& b) { return a.index == b.index && b.t - a.t < 1e-9; }),
                   hits.end());
        return hits;
    }

    glm::dvec3 normal_of(const Hit& hit, const glm::dvec3& to_eye) const {
        glm::dvec3 normal = hit.normal;
        const MapKind kind = kinds_[size_t(hit.index)];
        if (const auto map = bumps_.find(hit.piece); map != bumps_.end() && kind != MapKind::neither) {
            glm::dvec3 bump;
            if (kind == MapKind::normals) {
                bump = 2.0 * glm::dvec3(map->second->at(hit.uv)) - 1.0;
            } else {
                const glm::dvec2 texel = map->second->texel_size();
                const auto height = [&](double u, double v) {
                    return map->second->at(hit.uv + texel * glm::dvec2(u, v)).x;
                };
                const glm::dvec2 rise(height(1, 0) - height(-1, 0), height(0, 1) - height(0, -1));
                bump = glm::dvec3(-double(hit.piece->material.bump_scale) * rise / (2.0 * texel), 1);
            }
            const glm::dvec3 tangent = glm::normalize(glm::dvec3(hit.tangent));
            normal = glm::normalize(bump.x * tangent + bump.y * hit.tangent.w * glm::cross(hit.normal, tangent) +
                                    bump.z * hit.normal);
        }
        return glm::dot(hit.normal, to_eye) < 0 ? -normal : normal;
    }

    glm::dvec4 shine_of(const Hit& hit) const {
        const Material& material = hit.piece->material;
        const auto map = highlights_.find(hit.piece);
        if (map == highlights_.end()) return glm::dvec4(material.specular, std::max(double(material.shininess), 1.0));
        const glm::dvec4 texel = map->second->at(hit.uv);
        return glm::dvec4(glm::dvec3(texel), std::max(256 * texel.w, 1.0));
    }

    glm::dvec3 light_of(const Hit& hit, const glm::dvec3& to_eye) const {
        const Lights& lights = setting_.lights;
        const glm::dvec3 normal = normal_of(hit, to_eye);
        const glm::dvec4 shine = shine_of(hit);
        glm::dvec3 color(hit.piece->material.diffuse);
        if (const auto map = colors_.find(hit.piece); map != colors_.end())
            color *= glm::dvec3(map->second->at(hit.uv));
        glm::dvec3 sum = glm::dvec3(hit.piece->material.emission) +
                         color * glm::mix(lights.ground, lights.sky, 0.5 + 0.5 * normal.y);
        const auto add = [&](const glm::dvec3& to_light, const glm::dvec3& light) {
            const double facing = glm::dot(normal, to_light);
            sum += color * light * (hit.piece->is_glass() ? std::abs(facing) : std::max(facing, 0.0));
            if (facing <= 0) return;
            const double gloss = std::max(glm::dot(normal, glm::normalize(to_light + to_eye)), 0.0);
            sum += glm::dvec3(shine) * light * std::pow(gloss, shine.w) * facing;
        };
        add(lights.to_sun, lights.sun);
        if (const double share = share_of(lights, hit.place); share > 0)
            add(glm::normalize(lights.place - hit.place), share * lights.light);
        return sum;
    }

    glm::dvec3 sky(const glm::dvec3& direction) const {
        const double angle = std::atan2(direction.x, -direction.z), height = std::max(direction.y, 0.0);
        const double trees = 0.020 + 0.010 * std::sin(5 * angle + 1) + 0.006 * std::sin(17 * angle) +
                             0.004 * std::sin(41 * angle + 2) + 0.0025 * std::sin(113 * angle) +
                             0.0015 * std::sin(293 * angle);
        const bool is_day = setting_.lights.lamp == sun;
        if (direction.y < trees) return is_day ? glm::dvec3(0.05, 0.08, 0.03) : glm::dvec3(0.006, 0.008, 0.011);
        if (is_day)
            return glm::mix(glm::dvec3(0.62, 0.74, 0.9), glm::dvec3(0.16, 0.33, 0.72), 1 - std::exp(-3 * height));
        return glm::mix(glm::dvec3(0.34, 0.13, 0.075), glm::dvec3(0.018, 0.034, 0.13), 1 - std::exp(-9 * height)) +
               glm::dvec3(0.75, 0.25, 0.05) * std::exp(-5 * (1 - glm::dot(direction, setting_.lights.to_sun))) *
                   std::exp(-6 * height);
    }

    /// Returns the light of all layers along a ray, each composited over the layers behind it.
    glm::dvec3 color(const std::vector<const Triangle*>& near, const Ray& ray) const {
        glm::dvec3 sum(0);
        double passed = 1;
        for (const Hit& hit : hits_of(near, ray)) {
            const double opacity = double(hit.piece->material.opacity);
            sum += passed * opacity * light_of(hit, -ray.direction);
            passed *= 1 - opacity;
            if (passed == 0) return sum;
        }
        return sum + passed * sky(ray.direction);
    }

    /// Returns the number of rays along the side of a pixel: `most`, or fewer if the picture would need too many.
    int rays_along(int most) const {
        constexpr double most_rays = 1 << 24;  // a few seconds
        const double pixels = double(frame_.size.x) * frame_.size.y;
        return std::clamp(int(std::sqrt(most_rays / std::max(1.0, pixels))), 1, most);
    }

    template <class Each>
    void each_ray(const glm::dvec2& corner, int side, Each each) const {
        for (int i = 0; i < side * side; ++i)
            each(ray_at(corner + (glm::dvec2(i % side, i / side) + 0.5) / double(side)));
    }

    glm::dvec3 mean_color(const std::vector<const Triangle*>& near, const glm::dvec2& corner) const {
        if (!setting_.has_maps) return color(near, ray_at(corner + 0.5));
        const int side = rays_along(32);
        glm::dvec3 sum(0);
        each_ray(corner, side, [&](const Ray& ray) { sum += color(near, ray); });
        return sum / double(side * side);
    }

    glm::dvec4 coverage(const std::vector<const Triangle*>& near, const glm::dvec2& corner) const {
        const int side = rays_along(64);
        const auto masked = [&](const Ray& ray, bool is_solid) {
            std::optional<Hit> nearest;
            for (const Triangle* triangle : near) {
                const Piece& piece = setting_.scene.pieces[size_t(triangle->piece)];
                if (!piece.has(mask_map)) continue;
                auto hit = meet(*triangle, ray);
                if (!hit || (nearest && nearest->t <= hit->t)) continue;
                hit->piece = &piece;
                nearest = hit;
            }
            return nearest && (is_solid || is_covered(nearest->piece->mask, mask_uv(*nearest)));
        };
        if (!masked(ray_at(corner + 0.5), true)) return glm::dvec4(no_surface);
        int inside = 0;
        each_ray(corner, side, [&](const Ray& ray) { inside += masked(ray, false); });
        return glm::dvec4(double(inside) / (side * side), 0, 0, 0);
    }

    const Setting& setting_;
    const Frame& frame_;
    static constexpr int block_side = 16;  // pixels
    std::vector<Triangle> triangles_;
    std::vector<std::vector<int>> blocks_;  ///< by block of pixels, row by row: the triangles that may overlap it
    std::vector<MapKind> kinds_;            ///< by piece
    std::vector<int> ranks_;
    std::map<const Piece*, const ExactMap*> colors_, highlights_, bumps_;
};

std::optional<Image> exact_values(const Frame& frame, const Setting& setting) {
    const ExactGarden exact(setting, frame);
    return image_of_values(frame.size, [&](int x, int y) { return exact.value(x, y, frame.probe.name); });
}

std::optional<double> coverage_of(const std::string& mask) {
    return mask.starts_with("wire") ? wire_coverage : leaf_coverage();
}

std::optional<double> exact_share(const Lights& lights, const glm::dvec3& place) { return share_of(lights, place); }

const decltype(truth)::Provided provided_values(truth, exact_values);
const decltype(true_coverage)::Provided provided_coverage(true_coverage, coverage_of);
const decltype(true_share)::Provided provided_share(true_share, exact_share);

}  // namespace
}  // namespace relief::materials
