// A probe: the quantity under study, written by the shader as floats instead of the colour.
#pragma once

#include <string>

#include "framework/gl/program.h"

namespace relief {

/// "normal", "uv", ...; empty for the picture itself.
struct Probe {
    std::string name;

    explicit operator bool() const { return !name.empty(); }
    /// The shader's permutation: PROBE_normal is defined in all stages.
    operator Define() const { return name.empty() ? "" : "PROBE_" + name; }
    bool operator==(const Probe&) const = default;
};

}  // namespace relief
