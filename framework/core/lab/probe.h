// A probe: the quantity under study, written by the shader as floats instead of the colour.
#pragma once

#include <string>

#include "framework/core/gl/program.h"

namespace relief {

/// The probe's name, such as "normal" or "uv"; empty for the picture itself.
struct Probe {
    std::string name;

    explicit operator bool() const { return !name.empty(); }
    /// Returns the define of the shader's permutation, such as PROBE_normal in all stages.
    operator Define() const { return name.empty() ? "" : "PROBE_" + name; }
    bool operator==(const Probe&) const = default;
};

}  // namespace relief
