// A wrong picture beside the expected one: the pixels that differ and those that do not, as relations need them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/relation.h"

namespace relief::check {

using Value = std::array<double, 4>;  ///< the compared channels of a pixel; the others are 0

double dot(const Value& a, const Value& b);
double length(const Value& a);
Value scaled(Value a, double by);
/// Empty for a vector without length.
std::optional<Value> unit(const Value& value);

struct PixelPair {
    size_t pixel;
    Value expected, drawn;
    double error;
};
using PixelPairs = std::vector<PixelPair>;

/// Two pictures, the pixels that can be compared, and those of them that differ.
class PicturePair {
public:
    /// The images must outlive the pair. `is_unrolled`: each pixel is one component of a vector.
    PicturePair(const Image& drawn, const Image& expected, const Quantity& quantity, bool is_unrolled = false);

    bool is_direction() const { return is_direction_; }
    bool is_picture() const { return is_picture_; }
    bool is_unrolled() const { return is_unrolled_; }
    int channels() const { return channels_; }
    const char* name(int channel) const { return names_[size_t(channel)]; }
    const PixelPairs& differing() const { return differing_; }
    const PixelPairs& same() const { return same_; }
    size_t count() const { return differing_.size() + same_.size(); }
    double sum() const { return sum_; }
    double largest() const { return largest_; }
    int width() const { return expected_.width; }
    int height() const { return expected_.height; }
    const char* noun() const { return is_picture_ ? "picture" : is_direction_ ? "direction" : "value"; }

    /// Returns the compared channels of a pixel, a direction as a unit vector. Empty where a channel is not finite, or
    /// a direction has no length.
    std::optional<Value> value_of(const Image& image, size_t pixel) const;
    std::optional<Value> expected_at(size_t pixel) const { return value_of(expected_, pixel); }
    /// Of a drawn direction; 1 if it has none.
    double drawn_length(size_t pixel) const;
    bool has_base() const { return base_; }
    const std::string& base_knob() const { return base_knob_; }
    /// Precondition: has_base().
    std::optional<Value> base_at(size_t pixel) const { return value_of(*base_, pixel); }

    /// Returns a predicted value in the form in which values are compared: a direction gets unit length.
    std::optional<Value> finished(const std::optional<Value>& value) const;

    /// Degrees between two unit vectors if the pair has directions, else the distance.
    double error(const Value& a, const Value& b) const;
    /// Infinite if nothing is predicted.
    double error(const std::optional<Value>& predicted, const Value& drawn) const;
    /// Errors up to this one are rounding.
    double noise() const { return is_picture_ ? 2.1 / 255 : is_direction_ ? 1e-3 : 1e-6 * largest_ + 1e-12; }
    /// Pixels with a larger error differ: a twentieth of the error that 99 % of the pixels do not exceed.
    double threshold() const { return threshold_; }
    /// Returns whether the prediction leaves at most this share of the pixel's error.
    bool explains(const std::optional<Value>& predicted, const PixelPair& sample, double share) const;

private:
    const Image &drawn_, &expected_;
    const Image* base_;
    std::string base_knob_;
    bool is_direction_, is_picture_, is_unrolled_;
    int channels_;
    std::array<const char*, 4> names_;
    PixelPairs differing_, same_;
    double largest_ = 0, threshold_ = 0, sum_ = 0;
};

/// The frame of a unit normal with a horizontal tangent, where y is up. A vertical normal gets the tangent x.
struct TangentFrame {
    Value tangent, bitangent, normal;
    explicit TangentFrame(const Value& n);
    Value local(const Value& v) const { return {dot(tangent, v), dot(bitangent, v), dot(normal, v)}; }
    Value world(const Value& v) const;
};

}  // namespace relief::check
