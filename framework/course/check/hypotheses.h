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

/// Predicts what is drawn at a pixel from the expected value there, or nothing. The result may have any length.
using Rule = std::function<std::optional<Value>(size_t pixel, const Value& expected)>;

struct Hypothesis {
    std::string words;  ///< completes "yours is ..."
    Rule rule;
    bool is_fitted = false;  ///< a number in it comes from the pictures, so it must hold in the whole picture
};

/// Returns all hypotheses about the pair, from simple to complex. The pair must outlive them.
std::vector<Hypothesis> hypotheses(const PicturePair& pair);

}  // namespace relief::check
