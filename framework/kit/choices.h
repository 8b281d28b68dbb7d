// The choices of a knob in one table: their names, and their definitions in the shaders.
#pragma once

#include <array>
#include <span>

#include "framework/gl/program.h"

namespace relief {

struct Choice {
    const char* name;         ///< for --set and the menu
    const char* define = "";  ///< "" for none
};

/// A table in the order of the knob's values. Knobs::choice() takes its names.
template <size_t count>
struct Choices {
    std::array<const char*, count> names{}, defines{};

    constexpr Choices(const Choice (&rows)[count]) {
        for (size_t i = 0; i < count; ++i) names[i] = rows[i].name, defines[i] = rows[i].define;
    }
    operator std::span<const char* const>() const { return names; }
    const char* name(int value) const { return names[size_t(value)]; }
    Define define(int value) const { return defines[size_t(value)]; }
};

}  // namespace relief
