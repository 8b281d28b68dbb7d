#include "framework/staff/synctest/flatness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/course/inspect/reading.h"
#include "framework/course/inspect/seam.h"

namespace relief::synctest {
namespace {

/// Returns 0 to 5 for +x, +y, +z, -x, -y, -z, and -1 for NaN.
int nearest_axis(const glm::dvec3& n) {
    if (std::isnan(n.x)) return -1;
    const glm::dvec3 size = glm::abs(n);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return n[axis] < 0 ? axis + 3 : axis;
}
glm::dvec3 direction_of(int axis) {
    glm::dvec3 direction(0);
    direction[axis % 3] = axis < 3 ? 1 : -1;
    return direction;
}

/// Returns the reading under which most pixels are unit vectors.
inspect::Reading reading_of(const Image& picture) {
    inspect::Reading best;
    size_t most = 0;
    std::vector<inspect::Reading> readings = {
        {}, {.curve = inspect::StoredCurve::srgb_added}, {.curve = inspect::StoredCurve::srgb_removed}};
    if (picture.bits == 32) readings.insert(readings.begin(), {.is_signed = true});
    for (const inspect::Reading& reading : readings) {
        size_t unit = 0;
        for (size_t i = 0; i < picture.pixel_count(); ++i) {
            const glm::dvec3 n = reading.vector(&picture.values[i * size_t(picture.channels)]);
            unit += std::abs(glm::length(n) - 1) < 0.1;
        }
        if (unit > most) most = unit, best = reading;
    }
    return best;
}

/// Returns the picture's normals. The background is NaN: it has the colour of all four corners.
std::vector<glm::dvec3> normals_in(const Image& picture, SyncJudgement& result) {
    const inspect::Reading reading = reading_of(picture);
    result.was_srgb = reading.curve == inspect::StoredCurve::srgb_added;
    const float* const corner = picture.pixel(0, 0);
    const auto is_corner_color = [&](const float* pixel) {
        return std::equal(corner, corner + 3, pixel, [](float a, float b) { return std::abs(a - b) < 2.5f / 255; });
    };
    const int right = picture.width - 1, bottom = picture.height - 1;
    const bool is_even = is_corner_color(picture.pixel(right, 0)) && is_corner_color(picture.pixel(0, bottom)) &&
                         is_corner_color(picture.pixel(right, bottom));
    std::vector<glm::dvec3> normals(picture.pixel_count());
    size_t foreground = 0, unit = 0;
    for (size_t i = 0; i < normals.size(); ++i) {
        const float* const pixel = picture.values.data() + i * size_t(picture.channels);
        const glm::dvec3 n = reading.vector(pixel);
        const bool is_background = is_even && is_corner_color(pixel);
        const bool is_normal = !is_background && std::abs(glm::length(n) - 1) < 0.15;
        foreground += !is_background, unit += is_normal;
        normals[i] = is_normal ? n : glm::dvec3(NAN);
    }
    result.shows_normals = 10 * unit > 8 * foreground && reading.curve != inspect::StoredCurve::srgb_removed;
    if (!result.shows_normals && unit + foreground > 0)
        result.problem = reading.curve == inspect::StoredCurve::srgb_removed
                             ? "they were decoded from sRGB, as if the numbers were light"
                             : "their lengths are not 1, as after a tone curve, an exposure or lighting";
    return normals;
}

/// Returns whether a pixel and its eight neighbours have the same number, other than -1.
bool is_inside(const std::vector<int>& axes, int width, int height, int x, int y) {
    if (x < 1 || y < 1 || x + 1 >= width || y + 1 >= height) return false;
    const auto at = [&](int i, int j) { return axes[size_t(j) * size_t(width) + size_t(i)]; };
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (at(i, j) != at(x, y)) return false;
    return at(x, y) >= 0;
}

/// Returns the picture's axes for the cube's x, y and z, from the mean normals of the visible faces +x, +y and +z. A
/// bulge is symmetric, so it does not change the mean's nearest axis. Nothing if two faces give the same axis.
std::optional<std::array<int, 3>> axes_of_faces(const std::array<glm::dvec3, 3>& means) {
    std::array<int, 3> axes{};
    for (size_t face = 0; face < 3; ++face) {
        axes[face] = nearest_axis(means[face]);
        for (size_t other = 0; other < face; ++other)
            if (axes[other] % 3 == axes[face] % 3) return {};
    }
    return axes;
}

/// Returns the mean unit normals of three faces, from any camera, by k-means; nothing if the picture does not show
/// three directions.
std::optional<std::array<glm::dvec3, 3>> means_of_three_faces(const std::vector<glm::dvec3>& normals) {
    std::vector<glm::dvec3> units;
    for (const glm::dvec3& n : normals)
        if (!std::isnan(n.x)) units.push_back(glm::normalize(n));
    if (units.empty()) return {};
    // Begin with three vectors far from each other.
    std::array<glm::dvec3, 3> means{units[units.size() / 2]};
    for (size_t count = 1; count < 3; ++count) {
        double least = 2;
        glm::dvec3 farthest = means[0];
        for (const glm::dvec3& n : units) {
            double nearest = -1;
            for (size_t i = 0; i < count; ++i) nearest = std::max(nearest, glm::dot(means[i], n));
            if (nearest < least) least = nearest, farthest = n;
        }
        means[count] = farthest;
    }
    for (int round = 0; round < 30; ++round) {
        std::array<glm::dvec3, 3> sums{};
        for (const glm::dvec3& n : units) {
            size_t best = 0;
            for (size_t i = 1; i < 3; ++i)
                if (glm::dot(means[i], n) > glm::dot(means[best], n)) best = i;
            sums[best] += n;
        }
        for (size_t i = 0; i < 3; ++i) {
            // A face has 2 % of the pixels at least; else the vectors are blends along an edge.
            if (glm::length(sums[i]) < 0.02 * double(units.size())) return {};
            means[i] = glm::normalize(sums[i]);
        }
    }
    return means;
}

/// Explains why the vectors are no normals of world or object space, from the means of three faces; empty if they may
/// be.
std::string problem_of(const std::array<glm::dvec3, 3>& means) {
    std::vector<double> aside;  // the two components that are most alike: 0, or what a curve made of 0
    double farthest = 0, least_right = 180, most_right = 0;
    for (size_t i = 0; i < 3; ++i) {
        int axis = 0;
        const auto apart = [&](int c) { return std::abs(means[i][(c + 1) % 3] - means[i][(c + 2) % 3]); };
        for (const int c : {1, 2})
            if (apart(c) < apart(axis)) axis = c;
        aside.push_back(means[i][(axis + 1) % 3]), aside.push_back(means[i][(axis + 2) % 3]);
        farthest = std::max(farthest, inspect::angle_between(means[i], direction_of(nearest_axis(means[i]))));
        const double between = inspect::angle_between(means[i], means[(i + 1) % 3]);
        least_right = std::min(least_right, between), most_right = std::max(most_right, between);
    }
    double mean = 0, spread = 0;
    for (const double one : aside) mean += one / 6;
    for (const double one : aside) spread += (one - mean) * (one - mean) / 6;
    // 8 bits move all by 0.004.
    if (std::abs(mean) > 0.012 && std::sqrt(spread) < 0.5 * std::abs(mean))
        return "half of the largest value is not 0, as after a tone curve, an exposure or another gamma";
    if (farthest > 10 && least_right > 84 && most_right < 96)
        return "the faces are perpendicular but turned, as normals in the space of the camera are";
    return {};
}

/// Compares with each renderer, from the documented camera.
void compare(const Image& picture, const std::vector<glm::dvec3>& normals, const std::vector<int>& axes,
             SyncJudgement& result) {
    // Bounds the number of rays for large pictures.
    const int step = std::max(1, (std::max(picture.width, picture.height) + 399) / 400);
    const Image map = bake_synctest_map(512, 8);
    const auto shown_by = [&](const SyncRenderer& renderer) {
        return render_synctest(renderer, map, picture.width, picture.height, step);
    };
    const Image right = shown_by({});
    struct Sample {
        size_t shown, pixel;  ///< pixel indices in the rendered and in the judged picture
        int face;             ///< seen from the camera; -1: none
    };
    std::vector<Sample> samples;
    std::array<glm::dvec3, 3> means{};
    for (int y = 0; y < right.height; ++y)
        for (int x = 0; x < right.width; ++x) {
            const float* const n = right.pixel(x, y);
            const Sample sample{size_t(y) * size_t(right.width) + size_t(x),
                                size_t(y * step) * size_t(picture.width) + size_t(x * step),
                                std::isinf(n[0]) ? -1 : nearest_axis({n[0], n[1], n[2]})};
            samples.push_back(sample);
            if (sample.face >= 0 && sample.face < 3 && axes[sample.pixel] >= 0)
                means[size_t(sample.face)] += normals[sample.pixel];
        }
    const auto axis_of = axes_of_faces(means);
    if (!axis_of) return;
    size_t both = 0, either = 0;
    std::vector<int> covered(axes.size());
    std::transform(axes.begin(), axes.end(), covered.begin(), [](int axis) { return std::min(axis, 0); });
    for (const Sample& sample : samples) {
        const bool here = sample.face >= 0, there = covered[sample.pixel] >= 0;
        both += here && there, either += here || there;
    }
    result.overlap = either > 0 ? double(both) / double(either) : 0;
    if (result.overlap < 0.97) return;

    std::erase_if(samples, [&](const Sample& sample) {
        const int x = int(sample.pixel % size_t(picture.width)), y = int(sample.pixel / size_t(picture.width));
        return sample.face < 0 || !is_inside(covered, picture.width, picture.height, x, y);
    });
    for (const SyncRenderer& renderer : sync_renderers()) {
        const Image shown = shown_by(renderer);
        double sum = 0;
        for (const Sample& sample : samples) {
            glm::dvec3 n(0);  // in the picture's axes
            for (size_t c = 0; c < 3; ++c)
                n += double(shown.values[sample.shown * 3 + c]) * direction_of((*axis_of)[c]);
            sum += inspect::angle_between(normals[sample.pixel], n);
        }
        result.likenesses.push_back({renderer, sum / double(std::max<size_t>(samples.size(), 1))});
    }
    std::stable_sort(result.likenesses.begin(), result.likenesses.end(),
                     [](const auto& a, const auto& b) { return a.degrees < b.degrees; });
}

}  // namespace

std::optional<SyncRenderer> SyncJudgement::renderer() const {
    if (likenesses.empty() || likenesses[0].degrees > 1 || likenesses[0].degrees > 0.5 * likenesses[1].degrees)
        return {};
    return likenesses[0].renderer;
}

SyncJudgement judge_synctest(const Image& picture) {
    SyncJudgement result;
    if (picture.channels < 3) return result;
    const std::vector<glm::dvec3> normals = normals_in(picture, result);
    std::vector<int> axes(normals.size());
    std::transform(normals.begin(), normals.end(), axes.begin(), nearest_axis);
    std::vector<double> angles;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const size_t i = size_t(y) * size_t(picture.width) + size_t(x);
            if (is_inside(axes, picture.width, picture.height, x, y))
                angles.push_back(inspect::angle_between(normals[i], direction_of(axes[i])));
        }
    result.pixels = angles.size();
    result.shows_normals &= !angles.empty() && angles.size() * 100 >= picture.pixel_count();
    if (!result.shows_normals) return result;
    std::sort(angles.begin(), angles.end());
    for (const double angle : angles) result.mean += angle / double(angles.size());
    result.p99 = angles[size_t(0.99 * double(angles.size() - 1))], result.worst = angles.back();
    compare(picture, normals, axes, result);
    if (!result.renderer())
        if (const auto means = means_of_three_faces(normals)) result.problem = problem_of(*means);
    result.shows_normals = result.problem.empty();
    return result;
}

}  // namespace relief::synctest
