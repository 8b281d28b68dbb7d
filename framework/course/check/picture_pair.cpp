#include "framework/course/check/picture_pair.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relief::check {
namespace {

constexpr size_t most_samples = 2500;

/// Returns the number of channels up to the last that is not 0 in both pictures; at least 1.
int used_channels(const Image& drawn, const Image& expected) {
    const auto is_used = [](const Image& image, int channel) {
        for (size_t i = size_t(channel); i < image.values.size(); i += size_t(image.channels))
            if (std::isfinite(image.values[i]) && image.values[i] != 0) return true;
        return false;
    };
    int count = std::min(4, expected.channels);
    while (count > 1 && !is_used(drawn, count - 1) && !is_used(expected, count - 1)) --count;
    return count;
}

}  // namespace

double dot(const Value& a, const Value& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }
double length(const Value& a) { return std::sqrt(dot(a, a)); }
Value scaled(Value a, double by) {
    for (double& one : a) one *= by;
    return a;
}

PicturePair::PicturePair(const Image& drawn, const Image& expected, const Quantity& quantity, bool is_unrolled)
    : drawn_(drawn),
      expected_(expected),
      base_(quantity.base && quantity.base->same_shape(expected) ? quantity.base : nullptr),
      base_knob_(quantity.base_knob),
      is_direction_(quantity.error == ErrorMetric::angle),
      is_picture_(quantity.name.empty()),
      is_unrolled_(is_unrolled),
      channels_(is_direction_                             ? 3
                : quantity.error == ErrorMetric::absolute ? 1
                : is_picture_                             ? std::min(3, expected.channels)
                                                          : used_channels(drawn, expected)),
      names_(is_picture_                               ? std::array{"red", "green", "blue", "alpha"}
             : quantity.name == "uv" && channels_ <= 2 ? std::array{"u", "v", "", ""}
                                                       : std::array{"x", "y", "z", "w"}) {
    PixelPairs all;
    std::vector<double> errors;
    const size_t pixels = expected.pixel_count(), step = pixels / most_samples + 1;
    for (size_t place = 0; place < pixels; place += step) {
        // One pixel of each run of `step`, at changing places: a regular pattern must not look like the whole.
        const size_t i = std::min(pixels - 1, place + (place / step * 2654435761u >> 8) % step);
        const auto e = value_of(expected, i), d = value_of(drawn, i);
        if (!e || !d) continue;
        all.push_back({i, *e, *d, error(*d, *e)});
        errors.push_back(all.back().error);
        for (int c = 0; c < channels_; ++c) largest_ = std::max(largest_, std::abs((*e)[size_t(c)]));
    }
    if (errors.empty()) return;
    const auto high = errors.begin() + std::ptrdiff_t(double(errors.size()) * 0.99);
    std::nth_element(errors.begin(), high, errors.end());
    threshold_ = std::max(noise(), 0.05 * *high);
    for (PixelPair& one : all) {
        sum_ += one.error;
        (one.error > threshold_ ? differing_ : same_).push_back(one);
    }
}

std::optional<Value> unit(const Value& value) {
    const double of = length(value);
    if (!(of > 1e-12) || !std::isfinite(of)) return {};
    return scaled(value, 1 / of);
}

std::optional<Value> PicturePair::value_of(const Image& image, size_t pixel) const {
    Value value{};
    for (int c = 0; c < channels_; ++c) {
        const float one = image.values[pixel * size_t(image.channels) + size_t(c)];
        if (!std::isfinite(one)) return {};
        value[size_t(c)] = one;
    }
    return finished(value);
}

double PicturePair::drawn_length(size_t pixel) const {
    const float* const v = drawn_.values.data() + pixel * size_t(drawn_.channels);
    const double of = length({v[0], v[1], v[2]});
    return std::isfinite(of) && of > 0 ? of : 1;
}

std::optional<Value> PicturePair::finished(const std::optional<Value>& value) const {
    return value && is_direction_ ? unit(*value) : value;
}

double PicturePair::error(const Value& a, const Value& b) const {
    const double apart = length({a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]});
    return is_direction_ ? 2 * std::asin(std::min(1.0, apart / 2)) * 180 / std::numbers::pi : apart;
}

double PicturePair::error(const std::optional<Value>& predicted, const Value& drawn) const {
    return predicted ? error(*predicted, drawn) : INFINITY;
}

bool PicturePair::explains(const std::optional<Value>& predicted, const PixelPair& sample, double share) const {
    return error(predicted, sample.drawn) <= std::max({share * sample.error, 5 * share * threshold_, noise()});
}

TangentFrame::TangentFrame(const Value& n) : normal(n) {
    const double across = std::hypot(n[0], n[2]);
    tangent = across > 1e-6 ? Value{n[2] / across, 0, -n[0] / across} : Value{1, 0, 0};
    bitangent = {n[1] * tangent[2] - n[2] * tangent[1], n[2] * tangent[0] - n[0] * tangent[2],
                 n[0] * tangent[1] - n[1] * tangent[0]};
}

Value TangentFrame::world(const Value& v) const {
    Value sum{};
    for (size_t c = 0; c < 3; ++c) sum[c] = v[0] * tangent[c] + v[1] * bitangent[c] + v[2] * normal[c];
    return sum;
}

}  // namespace relief::check
