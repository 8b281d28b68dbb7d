#include "framework/course/check/kept_labs.h"

#include <algorithm>

#include "framework/course/check/calls.h"

namespace relief::check {

Lab& KeptLabs::drawer_of(const Shot& shot) {
    if (shot.calls) return *(calls_ = make_drawer(entry_, shot));
    std::set<std::string> knobs;
    for (const auto& [name, value] : shot.set) knobs.insert(name);
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const KeptLab& kept) {
        return std::includes(knobs.begin(), knobs.end(), kept.knobs.begin(), kept.knobs.end());
    });
    KeptLab next;
    if (found != kept_.end()) {
        next = std::move(*found);
        kept_.erase(found);
        for (const auto& [name, value] : shot.set) set_knob(*next.lab, name, value);
    } else {
        constexpr size_t most = 3;  // a lab's textures may take tens of megabytes
        if (kept_.size() == most) kept_.erase(kept_.begin());
        next.lab = make_lab(entry_, shot);
    }
    next.knobs = std::move(knobs);
    kept_.push_back(std::move(next));
    return *kept_.back().lab;
}

}  // namespace relief::check
