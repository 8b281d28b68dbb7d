// The relations between a wrong picture and the expected one that relation_between() tries.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/picture_pair.h"

namespace relief::check {

/// Fewer samples than this do not show a relation.
constexpr size_t least_differing = 40;

/// Predicts the drawn value of a pixel from the expected one, or nothing. The result may have any length.
using Rule = std::function<std::optional<Value>(size_t pixel, const Value& expected)>;

struct Hypothesis {
    std::string words;  ///< completes "yours is ..."
    Rule rule;
    bool is_constant = false;
    /// Whether it may hold in a part of the picture only: not if a number in it comes from the pictures, nor for the
    /// expected picture at another place.
    bool may_hold_in_part = true;
    /// The share of the error that it may leave. A function, or a number taken from the pictures, fits
    /// many pictures by chance, so it must leave less.
    double most_left = 0.1;
};

/// Returns all hypotheses about the pair, from simple to complex. The pair must outlive them.
std::vector<Hypothesis> hypotheses(const PicturePair& pair);

}  // namespace relief::check
