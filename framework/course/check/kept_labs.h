// Labs that draw one shot after another.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "framework/core/lab/shot.h"

namespace relief {
struct LabEntry;
}

namespace relief::check {

/// The labs that drew earlier shots. A lab keeps its programs, textures and computed values, so that the next shot
/// makes only what its own knobs need. Every shot is drawn as by a new lab. No file of the lab may change meanwhile.
class KeptLabs {
public:
    explicit KeptLabs(const LabEntry& entry) : entry_(entry) {}
    const LabEntry& entry() const { return entry_; }

    /// Returns the object that draws a shot, as make_drawer() does, until the next call. It is a kept lab if the shot
    /// sets all knobs that were set there before: the others have their defaults.
    Lab& drawer_of(const Shot& shot);
    /// Forgets all labs. Call it after an error, which may have left a lab in the middle of a drawing.
    void forget() { kept_.clear(); }

private:
    struct KeptLab {
        std::unique_ptr<Lab> lab;
        std::set<std::string> knobs;  ///< the names that were set
    };
    const LabEntry& entry_;
    std::vector<KeptLab> kept_;  ///< the one that was used last is at the end
    std::unique_ptr<Lab> calls_;
};

}  // namespace relief::check
