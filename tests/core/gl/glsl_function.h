// Runs one function of a shader file over many inputs, by transform feedback: GL 4.1 has no compute shaders.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "framework/core/gl/texture.h"

namespace relief {

/// Missing components are 0, as in the result of an expression.
inline glm::dvec4 padded(double value) { return {value, 0, 0, 0}; }
template <glm::length_t n, class T>
glm::dvec4 padded(const glm::vec<n, T>& vector) {
    glm::dvec4 all(0);
    for (glm::length_t i = 0; i < n; ++i) all[i] = double(vector[i]);
    return all;
}

/// The arguments of one call, named a, b, ... h (vec4) in the expression: padded numbers and vectors.
struct GlslInput : std::array<glm::vec4, 8> {
    template <class... Values>
    GlslInput(const Values&... values) : array{glm::vec4(padded(values))...} {}
};

/// A change of a shader file's text. `find` must occur exactly once. An empty `find` changes nothing.
struct PlantedMistake {
    std::string find, replace;
};

/// Evaluates `expression` for every input, with shaders/`file` included. It is GLSL over a to h and the samplers s_map
/// and s_other, which sample `map` and `other`. A bool, an int, a float or a vector is padded to a vec4.
std::vector<glm::vec4> evaluate_glsl(const std::string& file, const std::string& expression,
                                     std::span<const GlslInput> inputs, const PlantedMistake& mistake = {},
                                     const Texture* map = nullptr, const Texture* other = nullptr);

}  // namespace relief
