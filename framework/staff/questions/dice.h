// Random orders that depend on a text alone, with every standard library.
#pragma once

#include <random>
#include <string>
#include <utility>

#include "framework/core/base/sha256.h"

namespace relief::grade {

inline std::mt19937 dice_of(const std::string& seed) {
    const std::string words = sha256(seed);
    std::seed_seq sequence(words.begin(), words.end());
    return std::mt19937(sequence);
}

/// The same order with every standard library, unlike std::shuffle().
template <class List>
void shuffle(List& list, std::mt19937& dice) {
    for (size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[dice() % i]);
}

}  // namespace relief::grade
