// A lab that draws one shot after another.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "framework/core/lab/shot.h"

namespace relief {
struct LabEntry;
}

namespace relief::check {

/// The lab that drew the earlier shots. It keeps its programs, textures and computed values, so that the next shot
/// makes only what its own knobs need. Every shot is drawn as by a new lab. No file of the lab may change meanwhile.
class KeptLab {
public:
    explicit KeptLab(const LabEntry& entry) : entry_(entry) {}
    const LabEntry& entry() const { return entry_; }

    /// Returns the object that draws a shot, as make_drawer() does, until the next call. Knobs that the shot does not
    /// set have their defaults.
    Lab& drawer_of(const Shot& shot);
    /// Forgets the lab. Call it after an error, which may have left the lab in the middle of a drawing.
    void forget() { lab_.reset(); }

private:
    const LabEntry& entry_;
    std::unique_ptr<Lab> lab_, calls_;
    std::map<std::string, std::string> defaults_;  ///< of all knobs
    std::set<std::string> set_;                    ///< the knobs that the last shot set
};

}  // namespace relief::check
