// Uniforms that are arrays.
#pragma once

#include <string>

#include "framework/core/gl/program.h"

namespace relief {

/// Sets the elements of an array: `uniform`[0] to the first of `values`, as an Element, and so on. Precondition: the
/// program is in use.
template <class Element, class Values>
void set_each(const Program& program, const std::string& uniform, const Values& values) {
    for (size_t i = 0; const auto& value : values)
        program.set((uniform + "[" + std::to_string(i++) + "]").c_str(), Element(value));
}

}  // namespace relief
