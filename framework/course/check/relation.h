// Says in a sentence how a wrong picture differs from the expected one, when a simple relation explains it: a component
// negated, half the values, a picture upside down. Unlike the known mistakes, nobody lists these.
#pragma once

#include <optional>
#include <string>

#include "framework/core/image/compare.h"

namespace relief::check {

/// The kind of two compared pictures.
struct Quantity {
    std::string name = {};  ///< of the probe, such as "normal"; empty for a picture of the lab
    ErrorMetric error = ErrorMetric::distance;
    /// The expected picture without relief, and the knob that gives it: "strength = 0". Empty if there is none.
    const Image* base = nullptr;
    std::string base_knob = {};
};

/// A relation between two pictures, at the pixels with a surface in both.
struct Relation {
    /// For a student, without its full stop: "yours is the expected direction with x negated, on 99.8 % of the pixels".
    std::string sentence;
    /// The expected picture with the relation applied: nearly equal to the drawn one. Empty if the relation says only
    /// where the pictures differ.
    Image predicted = {};
};

/// Returns the simplest relation that explains the difference, or nothing. A relation explains it if it leaves less
/// than a tenth of the error (3 % for a function, and for a factor or an offset of the whole) at 95 % of the pixels
/// that differ. If it also predicts a difference where there is none, the sentence says where it holds. If nothing
/// explains the difference, the sentence says which part of the picture is right, or that all values are too large or
/// too small; if that is unknown, too, there is none. Also returns nothing for pictures of different shapes, and if
/// fewer than 40 of about 2,500 sampled pixels differ. `drawn` may hold any values.
std::optional<Relation> relation_between(const Image& drawn, const Image& expected, const Quantity& quantity);

}  // namespace relief::check
