#include "assets/staff/masks.h"

#include <algorithm>

#include "assets/bricks.h"
#include "assets/surface.h"
#include "framework/core/base/parallel.h"
#include "framework/core/image/color.h"
#include "framework/staff/reference/masks.h"

namespace relief {
namespace {

constexpr int side = 512, places = 16;

template <class Covers>
Image mask_of(Covers covers) {
    Image mask(side, side, 1, 8);
    parallel_pieces(size_t(side), 8, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < side; ++x) {
                int inside = 0;
                for (int i = 0; i < places * places; ++i) {
                    const glm::dvec2 at =
                        glm::dvec2(x, side - 1 - y) + (glm::dvec2(i % places, i / places) + 0.5) / double(places);
                    inside += covers(at / double(side));
                }
                *mask.pixel(x, y) = std::round(float(inside) * 255 / (places * places)) / 255;
            }
    });
    return mask;
}

}  // namespace

Image make_wire_mask() { return mask_of(is_wire); }

Image make_leaf_mask() {
    return mask_of([](const glm::dvec2& uv) { return leaf_at(uv).has_value(); });
}

Image make_leaf_colors() {
    const glm::vec3 dark = light_of(24, 46, 22), fresh = light_of(84, 118, 44), red = light_of(110, 48, 30);
    Image light(side, side, 3);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::dvec2 uv((x + 0.5) / side, 1 - (y + 0.5) / side);
            glm::vec3 color = dark;  // also beside a leaf, so that filtering does not tint its rim
            if (const auto leaf = leaf_at(uv)) {
                Dice dice(hash(uint32_t(leaf->number), 83));
                color = glm::mix(dark, fresh, dice.between(0.1f, 0.9f));
                if (dice.chance(0.12f)) color = glm::mix(color, red, dice.between(0.3f, 0.9f));
                const glm::vec2 at(leaf->place);
                const float middle = glm::abs(at.x),
                            vein = glm::min(middle, glm::abs(middle - 0.75f * glm::abs(at.y - 0.2f)));
                color *= 0.8f + 0.3f * at.y;
                color = glm::mix(color * 1.55f + 0.01f, color, ramp(0.01f, 0.05f, vein));
                color *= 1 + 0.15f * noise(glm::vec2(x, y) * (tile / side), 16, hash(uint32_t(leaf->number)));
            }
            for (int c = 0; c < 3; ++c) light.pixel(x, y)[c] = color[c];
        }
    return stored_albedo(light);
}

Image make_leaves_with_alpha() {
    const Image colors = make_leaf_colors(), mask = make_leaf_mask();
    Image both(side / 2, side / 2, 4, 8);
    for (int y = 0; y < side / 2; ++y)
        for (int x = 0; x < side / 2; ++x)
            for (int c = 0; c < 4; ++c) {
                double sum = 0;
                for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                    const glm::ivec2 from(2 * x + dx, 2 * y + dy);
                    sum += c < 3 ? linear_from_srgb(double(colors.pixel(from.x, from.y)[c]))
                                 : double(*mask.pixel(from.x, from.y));
                }
                both.pixel(x, y)[c] = float(c < 3 ? srgb_from_linear(sum / 4) : sum / 4);
            }
    return both;
}

Image make_brick_highlights() {
    const SurfaceMaps bricks = make_bricks();
    const int step = bricks.heights.width / side;
    Image map(side, side, 4, 8);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const glm::vec2 p = glm::vec2(x, y) * (tile / side);
            const float height = *bricks.heights.pixel(x * step, y * step);
            // Wet bricks shine on their raised parts, in patches. The joints are dull: their exponent is 0.
            const float out = ramp(0.45f, 0.8f, height), wet = ramp(-0.3f, 0.5f, noise(p, 128, 3, 84));
            const float shine = out * glm::mix(0.25f, 1.0f, wet) * (1 + 0.3f * grain_noise(p, 85));
            const glm::vec4 texel(0.02f + 0.30f * shine * glm::vec3(1, 0.93f, 0.86f),
                                  out * glm::mix(0.06f, 0.35f, wet));
            for (int c = 0; c < 4; ++c) map.pixel(x, y)[c] = std::round(glm::clamp(texel[c], 0.0f, 1.0f) * 255) / 255;
        }
    return map;
}

}  // namespace relief
