// Runs one function of a shader file over many inputs, by transform feedback: GL 4.1 has no compute shaders.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "framework/core/gl/texture.h"

namespace relief {

/// The arguments of one call, named a, b, ... h (vec4) in the expression.
using GlslInput = std::array<glm::vec4, 8>;

/// A change of a shader file's text. `find` must occur exactly once. An empty `find` changes nothing.
struct PlantedMistake {
    std::string find, replace;
};

/// Evaluates `expression` for every input, with shaders/`file` included. It is a GLSL vec4 over a to h and the samplers
/// s_map and s_other, which sample `map` and `other`.
std::vector<glm::vec4> evaluate_glsl(const std::string& file, const std::string& expression,
                                     std::span<const GlslInput> inputs, const PlantedMistake& mistake = {},
                                     const Texture* map = nullptr, const Texture* other = nullptr);

}  // namespace relief
