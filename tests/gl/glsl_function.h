// One function of a shader file, run over many inputs: transform feedback, since GL 4.1 has no compute shader.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "framework/gl/texture.h"

namespace relief {

/// The arguments of one call, as vectors named a, b, ... h in the expression.
using GlslInput = std::array<glm::vec4, 8>;

/// A change of a shader file's text; `find` must be there exactly once. An empty one changes nothing.
struct PlantedMistake {
    std::string find, replace;
};

/// `expression` (a vec4 of GLSL, over a to h and the samplers s_map and s_other) for every input, with
/// shaders/`file` included. `map` and `other` are what they read.
std::vector<glm::vec4> evaluate_glsl(const std::string& file, const std::string& expression,
                                     std::span<const GlslInput> inputs, const PlantedMistake& mistake = {},
                                     const Texture* map = nullptr, const Texture* other = nullptr);

}  // namespace relief
