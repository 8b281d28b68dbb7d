#include "framework/course/window/menu_history.h"

namespace relief::window {
namespace {

constexpr size_t most_steps = 500;

bool same(const Shot& a, const Shot& b) { return a.set == b.set && a.camera == b.camera && a.probe == b.probe; }

}  // namespace

void History::begin(Shot now) { steps_ = {std::move(now)}, at_ = 0; }

void History::note(const Shot& now) {
    if (steps_.empty()) return begin(now);
    if (same(now, steps_[at_])) return;
    steps_.resize(at_ + 1);
    steps_.push_back(now);
    if (steps_.size() > most_steps) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

std::optional<Shot> History::undo() {
    if (at_ == 0) return {};
    return steps_[--at_];
}

std::optional<Shot> History::redo() {
    if (at_ + 1 >= steps_.size()) return {};
    return steps_[++at_];
}

}  // namespace relief::window
