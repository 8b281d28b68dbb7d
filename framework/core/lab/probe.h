// A probe: the quantity under study, written by the shader as floats instead of the colour.
#pragma once

#include <string>
#include <utility>

#include "framework/core/gl/program.h"

namespace relief {

/// What a probe writes for a pixel whose task is not written.
enum class MissingTask {
    placeholder,  ///< the task's placeholder, as checks of other tasks need it
    told          ///< not_written, as people need it
};

/// The probe's name, such as "normal" or "uv"; empty for the picture itself.
struct Probe {
    std::string name;
    MissingTask missing;

    Probe(std::string of = {}, MissingTask what = MissingTask::placeholder) : name(std::move(of)), missing(what) {}

    explicit operator bool() const { return !name.empty(); }
    /// Returns the definitions of the shader's permutation, such as PROBE_normal, in all stages.
    operator Define() const {
        return name.empty() ? Define("") : Define("PROBE_" + name, missing == MissingTask::told ? "TELL_MISSING" : "");
    }
    bool operator==(const Probe&) const = default;
};

}  // namespace relief
