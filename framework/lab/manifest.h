// lab.toml: what a lab says about itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/image/compare.h"
#include "framework/lab/registry.h"
#include "framework/lab/shot.h"

namespace relief {

/// A quantity that the lab's shaders can write. `error` is how two values of it are compared, and `limit` what 99 % of
/// the pixels keep, by the manifest's camera and the knobs as they are: no more than single precision costs, unless the
/// lab is about methods that are wrong.
struct ProbeInfo {
    std::string name, unit;
    ErrorMetric error = ErrorMetric::distance;
    double limit = 1e-3;  ///< in the unit
};

/// Something a student is to write.
struct TaskInfo {
    std::string id, title, file;  ///< "11.2"; the file is relative to the course's top folder
    int points = 0;
};

/// A reference screenshot, tests/golden/<lab's folder>/<name>.png; of a probe, what visualize_probe() makes of it.
struct GoldenInfo {
    std::string name;
    Shot shot;
};

struct Manifest {
    std::string title;
    std::vector<std::string> learns;
    Orbit camera;
    bool animated = false;
    std::vector<ProbeInfo> probes;
    std::vector<TaskInfo> tasks;
    std::vector<GoldenInfo> goldens;

    int points() const;
    /// Throws UsageError that suggests the nearest.
    const ProbeInfo& probe(const std::string& name) const;
};

/// Reads a manifest. Throws Error with file and line for a missing file, a syntax error, an unknown or
/// missing key, a value of another type or out of range; and for a golden picture whose name or probe is
/// unknown or not unique.
Manifest load_manifest(const std::filesystem::path& file);
/// The same for a text that is there; `file` is only named.
Manifest parse_manifest(const std::string& text, const std::filesystem::path& file);
Manifest load_manifest(const LabEntry& lab);

}  // namespace relief
