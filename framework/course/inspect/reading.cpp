#include "framework/course/inspect/reading.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "framework/core/image/color.h"
#include "framework/library/maps/heights.h"

namespace relief::inspect {
namespace {

constexpr int grid_side = 128;

/// Calls `visit(texel)` for texels on a grid over the map. Rows are shifted so that a regular pattern cannot fall
/// between the samples.
template <class Visit>
void each_sample(const Image& map, Visit visit) {
    const int columns = std::min(map.width, grid_side), rows = std::min(map.height, grid_side);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            visit(map.pixel(int((int64_t{i} * map.width / columns + j * 37 % 101) % map.width),
                            int(int64_t{j} * map.height / rows)));
}

bool is_finite(const float* texel, int channels) {
    return std::all_of(texel, texel + channels, [](float v) { return std::isfinite(v); });
}

struct Range {
    double low = INFINITY, high = -INFINITY;
    double width() const { return high - low; }
};

std::array<Range, 4> ranges_of(const Image& map) {
    std::array<Range, 4> ranges;
    for (size_t i = 0; i < map.values.size(); ++i) {
        const double value = map.values[i];
        Range& range = ranges[i % size_t(map.channels)];
        if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
    }
    return ranges;
}

VectorStatistics statistics_of(const Image& map, const Recognition& as) {
    VectorStatistics result;
    std::vector<double> off, across;
    double xx = 0, yy = 0, xy = 0, x = 0, y = 0;
    each_sample(map, [&](const float* texel) {
        const glm::dvec3 n = as.reading.vector(texel);
        if (std::isnan(n.x) || as.is_background(texel)) return;
        const double length = glm::length(n);
        off.push_back(std::abs(length - 1));
        across.push_back(std::hypot(n.x, n.y));
        if (std::abs(length - 1) < 0.1) result.unit += 1;
        result.below += glm::dvec3(glm::lessThan(n, glm::dvec3(-0.05 * length)));
        result.above += glm::dvec3(glm::greaterThan(n, glm::dvec3(0.05 * length)));
        if (length > 0) result.mean += n / length;
        xx += n.x * n.x, yy += n.y * n.y, xy += n.x * n.y, x += n.x, y += n.y;
    });
    result.count = off.size();
    if (off.empty()) return result;
    const double count = double(off.size());
    const auto quantile = [](std::vector<double>& values, double share) {
        const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
        std::nth_element(values.begin(), at, values.end());
        return *at;
    };
    result.median_off = quantile(off, 0.5);
    result.long_xy = quantile(across, 0.995);
    result.longest_xy = *std::max_element(across.begin(), across.end());
    result.unit /= count, result.mean /= count, result.below /= count, result.above /= count;
    result.away = result.below.z;
    const double scale = std::sqrt((xx / count - x / count * x / count) * (yy / count - y / count * y / count));
    result.red_green = scale > 0 ? (xy / count - x / count * y / count) / scale : 0;
    return result;
}

double lean(const VectorStatistics& statistics) { return std::hypot(statistics.mean.x, statistics.mean.y); }

/// Returns the colour that is no normal and covers 2 % of the map or more. Nothing if many other texels are no normals
/// either, or if under 5 % are normals.
std::optional<std::array<float, 3>> background_of(const Image& map, const Reading& reading) {
    std::map<std::array<float, 3>, size_t> colors;
    size_t not_unit = 0, count = 0;
    each_sample(map, [&](const float* texel) {
        const glm::dvec3 n = reading.vector(texel);
        if (std::isnan(n.x)) return;
        ++count;
        if (std::abs(glm::length(n) - 1) < 0.1) return;
        ++not_unit, ++colors[{texel[0], texel[1], texel[2]}];
    });
    const auto most =
        std::max_element(colors.begin(), colors.end(), [](auto& a, auto& b) { return a.second < b.second; });
    if (most == colors.end() || double(most->second) < 0.02 * double(count)) return {};
    if (double(most->second) < 0.9 * double(not_unit) || double(count - not_unit) < 0.05 * double(count)) return {};
    return most->first;
}

/// Returns whether the (x, y) of a map without z may belong to normals. A constant blue proves nothing: if all (x, y)
/// are short, z is close to 1 everywhere.
bool may_be_two_channels(const VectorStatistics& statistics) {
    return statistics.long_xy <= 1.02 && statistics.longest_xy > 0.15 && lean(statistics) < 0.25 &&
           std::abs(statistics.red_green) < 0.9;
}

/// Returns whether one colour fills over half of the map, as in a picture of a sign. Its length can be near 1 under any
/// reading.
bool is_mostly_one_color(const Image& map) {
    std::map<std::array<float, 3>, size_t> colors;
    size_t most = 0, count = 0;
    each_sample(map, [&](const float* texel) {
        if (!is_finite(texel, 3)) return;
        most = std::max(most, ++colors[{texel[0], texel[1], texel[2]}]);
        ++count;
    });
    return 2 * most > count;
}

/// Returns the reading of three channels whose lengths are closest to 1 and whose vectors lean least. Another reading
/// must score far better than the plain one to replace it.
Reading best_reading(const Image& map, const std::array<Range, 4>& ranges) {
    const auto judge = [&](const Reading& reading, VectorStatistics& statistics) {
        Recognition as{.kind = MapKind::normals, .reading = reading};
        as.background = background_of(map, reading);
        statistics = statistics_of(map, as);
        return statistics.median_off + 0.3 * lean(statistics);
    };
    VectorStatistics plain, other;
    const double plainly = judge({}, plain);
    Reading best;
    double least = 0.5 * plainly;
    const bool below_0 = std::min(ranges[0].low, ranges[1].low) < -0.01;
    const bool is_plain = is_mostly_one_color(map);
    const auto consider = [&](const Reading& reading, double largest) {
        const double score = judge(reading, other);
        const bool is_tangent_space = lean(other) < 0.15 && other.mean.z > 0.5;
        if (score < std::min(least, largest) && (!is_plain || is_tangent_space)) least = score, best = reading;
    };
    if (map.bits == 32 && below_0) consider({.is_signed = true}, INFINITY);
    if (below_0 || plainly < 0.1) return best;
    consider({.curve = StoredCurve::srgb_removed}, 0.15);
    consider({.curve = StoredCurve::srgb_added}, 0.15);
    if (best.curve == StoredCurve::none && plain.median_off > 0.05 &&
        std::hypot(plain.mean.x - 0.39, plain.mean.y - 0.39) < 0.12 && lean(other) < 0.08 && other.mean.z > 0.5)
        best.curve = StoredCurve::srgb_added;  // lengths are wrong here too, but flat is in the middle of sRGB
    return best;
}

bool recognize_two_channels(const Image& map, const std::array<Range, 4>& ranges, Recognition& as) {
    const auto is_constant = [&](int channel) { return ranges[size_t(channel)].width() < 1.5 / 255; };
    Reading reading{.is_signed = map.bits == 32 && ranges[1].low < -0.01, .z = -1};
    // DXT5 stores x in alpha and y in green; red is then constant, 0 or 1.
    if (map.channels == 4 && is_constant(0) && !is_constant(3) && std::abs(ranges[0].low - 0.5) > 0.49)
        reading.x = 3;
    else if (map.channels > 2 && !is_constant(2))
        return false;
    for (const StoredCurve curve : {StoredCurve::none, StoredCurve::srgb_added}) {
        if (curve != StoredCurve::none && reading.is_signed) continue;
        Recognition tried{.kind = MapKind::normals, .reading = reading};
        tried.reading.curve = curve;
        tried.statistics = statistics_of(map, tried);
        if (!may_be_two_channels(tried.statistics)) continue;
        as = tried;
        return true;
    }
    return false;
}

}  // namespace

glm::dvec3 Reading::vector(const float* texel) const {
    const auto value = [&](int channel) {
        const double v = texel[channel];
        if (!std::isfinite(v)) return double(NAN);
        const double bounded = std::clamp(v, -1e6, 1e6);
        if (is_signed) return bounded;
        const double half = curve == StoredCurve::none         ? bounded
                            : curve == StoredCurve::srgb_added ? linear_from_srgb(bounded)
                                                               : srgb_from_linear(bounded);
        return 2 * half - 1;
    };
    const double vx = value(x), vy = value(y);
    const double vz = z >= 0 ? value(z) : std::sqrt(std::max(0.0, 1 - vx * vx - vy * vy));
    return std::isnan(vx + vy + vz) ? glm::dvec3(NAN) : glm::dvec3(vx, vy, vz);
}

bool Recognition::is_background(const float* texel) const {
    return background && std::equal(background->begin(), background->end(), texel);
}

Recognition recognize(const Image& map) {
    Recognition as;
    const auto ranges = ranges_of(map);
    const auto color_channels = map.channels >= 3 ? 3 : map.channels == 2 ? 2 : 1;
    const bool one_color =
        std::all_of(ranges.begin(), ranges.begin() + color_channels, [](const Range& r) { return !(r.width() > 0); });
    if (one_color && !(map.channels == 4 && ranges[3].width() > 0)) {
        as.kind = MapKind::one_color;
        return as;
    }
    if (map.channels == 1) {
        as.kind = MapKind::heights;
        return as;
    }
    if (map.channels == 2) {
        if (!recognize_two_channels(map, ranges, as)) as.kind = MapKind::heights;  // grey and alpha
        return as;
    }
    if (recognize_two_channels(map, ranges, as)) return as;
    if (is_nearly_grey(map)) {
        as.kind = MapKind::heights;
        return as;
    }
    as.as_it_is = statistics_of(map, as);
    as.reading = best_reading(map, ranges);
    as.background = background_of(map, as.reading);
    as.statistics = statistics_of(map, as);
    const VectorStatistics& s = as.statistics;
    if (s.unit >= 0.8 && s.median_off < 0.04) {
        as.kind = MapKind::normals;
        as.blue_down = s.mean.z < -0.6 && s.away > 0.95;
        as.object_space = !as.blue_down && s.away > 0.1 && s.mean.z < 0.6;
        return as;
    }
    as.background.reset();
    const bool like_normals = s.away < 0.05 && lean(s) < 0.25 && s.mean.z > 0.6 && std::abs(s.red_green) < 0.7;
    as.kind = like_normals ? MapKind::normals : MapKind::neither;
    return as;
}

std::optional<FacedAxis> faced_axis(const VectorStatistics& statistics) {
    for (int axis = 0; axis < 3; ++axis) {
        const double mean = statistics.mean[axis];
        glm::dvec3 aside = statistics.mean;
        aside[axis] = 0;
        if (std::abs(mean) > 0.5 && glm::length(aside) < 0.25 &&
            (mean > 0 ? statistics.below : statistics.above)[axis] < 0.05)
            return FacedAxis{axis, mean < 0};
    }
    return {};
}

Recognition reordered(const Image& map, const Recognition& as, glm::ivec3 channels) {
    Recognition other = as;
    other.reading.x = channels.x, other.reading.y = channels.y, other.reading.z = channels.z;
    other.statistics = statistics_of(map, other);
    other.object_space = false;
    other.blue_down = other.statistics.mean.z < 0;
    return other;
}

std::vector<glm::vec3> vectors_of(const Image& map, const Recognition& as) {
    std::vector<glm::vec3> vectors(map.pixel_count());
    for (size_t i = 0; i < vectors.size(); ++i) {
        const float* const texel = map.values.data() + i * size_t(map.channels);
        vectors[i] = as.is_background(texel) ? glm::vec3(NAN) : glm::vec3(as.reading.vector(texel));
    }
    return vectors;
}

}  // namespace relief::inspect
