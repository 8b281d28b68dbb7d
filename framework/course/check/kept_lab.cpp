#include "framework/course/check/kept_lab.h"

#include <utility>

#include "framework/course/check/calls.h"

namespace relief::check {

Lab& KeptLab::drawer_of(const Shot& shot) {
    if (shot.calls) return *(calls_ = make_drawer(entry_, shot));
    if (!lab_) {
        lab_ = make_lab(entry_, {});
        for (const KnobText& knob : describe_knobs(*lab_)) defaults_[knob.name] = knob.value;
        set_.clear();
    }
    for (const std::string& name : std::exchange(set_, {})) set_knob(*lab_, name, defaults_.at(name));
    for (const auto& [name, value] : shot.set) {
        set_knob(*lab_, name, value);
        set_.insert(name);
    }
    return *lab_;
}

}  // namespace relief::check
