#include "framework/library/maps/heights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"
#include "framework/core/image/color_profile.h"
#include "framework/library/maps/own_picture.h"

namespace relief {
namespace {

constexpr std::array ordinals = {"first", "second", "third", "fourth"};

std::string texels_that_hold(size_t count) {
    return count == 1 ? "1 texel holds" : fmt::format("{} texels hold", count);
}

bool varies(const Image& picture, int channel) {
    const size_t step = size_t(picture.channels);
    for (size_t i = size_t(channel) + step; i < picture.values.size(); i += step)
        if (picture.values[i] != picture.values[size_t(channel)]) return true;
    return false;
}

/// Returns whether the first three channels are unit normals out of the surface, as 0.5 n + 0.5.
bool is_normal_map(const Image& picture) {
    double up = 0, length = 0;
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        const float* const texel = picture.values.data() + i * size_t(picture.channels);
        const glm::vec3 normal = 2.0f * glm::vec3(texel[0], texel[1], texel[2]) - 1.0f;
        up += double(normal.z), length += double(glm::length(normal));
    }
    const double count = double(picture.pixel_count());
    return up > 0.5 * count && std::abs(length / count - 1) < 0.1;  // false for NaN
}

/// Chooses the channel of the heights. Sets `normals` if the others are a normal map.
void choose_channel(const Image& picture, Heights& result) {
    if (picture.channels == 1) return;
    const int last = picture.channels - 1;
    const bool has_alpha = picture.channels != 3, alpha_varies = has_alpha && varies(picture, last);
    const bool is_grey = is_nearly_grey(picture);
    const auto take_last = [&](const char* why) {
        result.channel = last;
        result.notes.push_back(fmt::format("its {} channel holds the heights: {}", ordinals[size_t(last)], why));
    };
    if (is_grey && (varies(picture, 0) || !alpha_varies)) {
        if (alpha_varies)
            result.notes.push_back(
                fmt::format("its {} channel, alpha, is not read: the heights are in its grey", ordinals[size_t(last)]));
        return;
    }
    if (!alpha_varies)
        throw Error(
            "shows colours or normals: a height map is grey, or the fourth channel of a picture. `relief map heights` "
            "makes heights of a picture");
    if (!is_grey && is_normal_map(picture)) {
        result.channel = last;
        result.normals = channels_of(picture, 0, 3);
        return;
    }
    const bool is_one_color = is_grey || (!varies(picture, 0) && !varies(picture, 1) && !varies(picture, 2));
    take_last(is_one_color ? "the others are all one colour" : "the others show colours");
}

/// Returns whether programs use a number to mark missing data.
bool is_usual_mark(double value) {
    constexpr std::array marks = {-32768.0, -32767.0, 32767.0,  32768.0, 65535.0,
                                  -9999.0,  9999.0,   -99999.0, 99999.0, -10000.0 /* -9999 as a half */};
    return std::abs(value) >= 65504 || std::find(marks.begin(), marks.end(), value) != marks.end();  // the largest half
}

/// A value at one end of a map's heights, and the others.
struct End {
    float value = 0, low = 0, high = 0;
    double gap() const { return value < low ? double(low) - double(value) : double(value) - double(high); }
    double range() const { return double(high) - double(low); }
};
/// Returns the lowest and the highest value of the texels that are no voids, each with the range of the others; nothing
/// if all are equal.
std::optional<std::array<End, 2>> ends_of(const std::vector<float>& values, const std::vector<uint8_t>& voids) {
    float low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};  // the two lowest, the two highest
    for (size_t i = 0; i < values.size(); ++i) {
        const float value = values[i];
        if (!voids.empty() && voids[i]) continue;
        if (value < low[0])
            low[1] = low[0], low[0] = value;
        else if (value > low[0] && value < low[1])
            low[1] = value;
        if (value > high[0])
            high[1] = high[0], high[0] = value;
        else if (value < high[0] && value > high[1])
            high[1] = value;
    }
    if (!(low[0] < high[0])) return {};
    return std::array{End{low[0], low[1], high[0]}, End{high[0], low[0], high[1]}};
}

size_t mark_voids_of(float value, const std::vector<float>& values, std::vector<uint8_t>& voids) {
    voids.resize(values.size());
    size_t count = 0;
    for (size_t i = 0; i < values.size(); ++i)
        if (values[i] == value) voids[i] = 1, ++count;
    return count;
}

/// Marks texels without a height, if there are any, and adds a note for each mark of them.
void find_voids(Heights& result) {
    const std::vector<float>& values = result.image.values;
    std::vector<uint8_t>& voids = result.voids;
    result.not_finite = size_t(std::count_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }));
    if (result.not_finite > 0) voids.resize(values.size());
    for (size_t i = 0; i < voids.size(); ++i) voids[i] = !std::isfinite(values[i]);
    if (result.not_finite == values.size()) throw Error("has no height: all texels hold NaN or infinity");
    if (result.not_finite > 0)
        result.notes.push_back(fmt::format("{} NaN or infinity: voids, filled from the heights around them",
                                           texels_that_hold(result.not_finite)));
    const int bits = result.image.bits;
    const double unit = bits == 16 ? 65535 : 1;  // a picture of integers was stored in these steps
    const auto shown = [&](float value) {
        return plain(bits == 16 ? std::round(double(value) * unit) : double(value));
    };
    for (bool found = bits != 8; found;) {
        found = false;
        const auto ends = ends_of(values, voids);
        if (!ends) break;
        const bool is_beyond = (*ends)[0].value < 0 || (*ends)[1].value > 1;
        for (const End& end : *ends) {
            const double stored = bits == 16 ? std::round(double(end.value) * unit) : double(end.value);
            // Of integers only 32768 is sure: -32768, read without its sign.
            const bool is_usual = bits == 16 ? stored == 32768 : is_usual_mark(stored) && is_beyond;
            const double factor = is_usual ? (bits == 16 ? 1 : 0.1) : bits == 16 ? 4 : 2;
            if (!(end.gap() > factor * end.range()) || (!is_usual && end.range() == 0)) continue;
            if (bits == 32 && !is_beyond) continue;
            const bool is_void = is_usual || bits == 32;
            std::vector<uint8_t> marked = voids;
            const std::string about = fmt::format("{} {}, far from all others ({} to {})",
                                                  texels_that_hold(mark_voids_of(end.value, values, marked)),
                                                  shown(end.value), shown(end.low), shown(end.high));
            if (is_void) {
                voids = std::move(marked), found = true;
                result.notes.push_back(about + ": voids, filled from the heights around them");
                break;
            }
            result.notes.push_back(about + ": if it marks voids, give these texels a height");
        }
    }
}

/// Gives each void the weighted mean of the heights around it, from the finest level of a pyramid that has any there
/// (Gortler et al. 1996, push and pull).
void fill_voids(Image& heights, const std::vector<uint8_t>& voids) {
    struct Level {
        int width, height;
        std::vector<float> means;
        std::vector<uint8_t> empty;
        size_t at(int x, int y) const { return size_t(y) * size_t(width) + size_t(x); }
    };
    std::vector<Level> levels = {{heights.width, heights.height, std::move(heights.values), voids}};
    while (levels.back().width > 1 || levels.back().height > 1) {
        const Level& fine = levels.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, {}};
        coarse.means.resize(size_t(coarse.width) * size_t(coarse.height)), coarse.empty.resize(coarse.means.size());
        for (int y = 0; y < coarse.height; ++y)
            for (int x = 0; x < coarse.width; ++x) {
                double sum = 0;
                int count = 0;
                for (int j = 2 * y; j < std::min(2 * y + 2, fine.height); ++j)
                    for (int i = 2 * x; i < std::min(2 * x + 2, fine.width); ++i)
                        if (!fine.empty[fine.at(i, j)]) sum += double(fine.means[fine.at(i, j)]), ++count;
                coarse.means[coarse.at(x, y)] = count ? float(sum / count) : 0;
                coarse.empty[coarse.at(x, y)] = count == 0;
            }
        levels.push_back(std::move(coarse));
    }
    for (size_t l = levels.size() - 1; l-- > 0;) {
        Level& fine = levels[l];
        const Level& coarse = levels[l + 1];
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x) {
                if (!fine.empty[fine.at(x, y)]) continue;
                // Bilinear: three quarters of the texel that covers this one, and a quarter of its neighbour.
                const auto neighbour = [](int i, int count) { return (i / 2 + (i % 2 ? 1 : count - 1)) % count; };
                const int nx = neighbour(x, coarse.width), ny = neighbour(y, coarse.height);
                const auto mean = [&](int i, int j) { return double(coarse.means[coarse.at(i, j)]); };
                fine.means[fine.at(x, y)] = float(0.5625 * mean(x / 2, y / 2) + 0.1875 * mean(nx, y / 2) +
                                                  0.1875 * mean(x / 2, ny) + 0.0625 * mean(nx, ny));
            }
    }
    heights.values = std::move(levels[0].means);
}

/// Scales floats beyond [0, 1].
void scale(Heights& result) {
    std::vector<float>& values = result.image.values;
    const float lowest = *std::min_element(values.begin(), values.end());
    const float highest = *std::max_element(values.begin(), values.end());
    if (lowest >= 0 && highest <= 1) return;
    result.low = double(lowest), result.high = double(highest);
    const double range = result.high - result.low;
    for (float& value : values) value = range > 0 ? float((double(value) - result.low) / range) : 0;
    result.notes.push_back(
        fmt::format("heights from {} to {} are scaled to 0 to 1", plain(result.low), plain(result.high)));
}

}  // namespace

Heights heights_in(Image picture) {
    Heights result;
    if (std::string note = profile_note(picture, true); !note.empty()) result.notes.push_back(std::move(note));
    choose_channel(picture, result);
    result.image = picture.channels == 1 ? std::move(picture) : channels_of(picture, result.channel, 1);
    find_voids(result);
    if (!result.voids.empty()) fill_voids(result.image, result.voids);
    scale(result);
    return result;
}

bool is_nearly_grey(const Image& picture) {
    if (picture.channels < 3) return true;
    double spread = 0, size = 0;
    size_t count = 0;
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        const float* const texel = picture.values.data() + i * size_t(picture.channels);
        if (!std::isfinite(texel[0]) && !std::isfinite(texel[1]) && !std::isfinite(texel[2])) continue;
        const auto [low, high] = std::minmax({double(texel[0]), double(texel[1]), double(texel[2])});
        spread += high - low, size += std::abs(high), ++count;
    }
    return spread <= (picture.bits == 32 ? 0.02 * size : 0.02 * double(count));  // false if only some channels are NaN
}

}  // namespace relief
