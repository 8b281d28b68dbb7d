#include "framework/course/window/menu_history.h"

#include "framework/course/window/menu_stage.h"

namespace relief::window {
namespace {

constexpr size_t most_steps = 500;

bool same(const Shot& a, const Shot& b) { return a.set == b.set && a.camera == b.camera && a.probe == b.probe; }

}  // namespace

void History::begin(const Stage& stage) { steps_ = {stage.settings()}, at_ = 0, edits_ = stage.edits(); }

void History::note(const Stage& stage) {
    if (edits_ == stage.edits()) return;
    edits_ = stage.edits();
    Shot now = stage.settings();
    if (same(now, steps_[at_])) return;
    steps_.resize(at_ + 1);
    steps_.push_back(std::move(now));
    if (steps_.size() > most_steps) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

void History::undo(Stage& stage) {
    if (at_ > 0) go(stage, at_ - 1);
}

void History::redo(Stage& stage) {
    if (at_ + 1 < steps_.size()) go(stage, at_ + 1);
}

void History::go(Stage& stage, size_t step) {
    at_ = step;
    stage.apply(steps_[at_]);
    edits_ = stage.edits();  // a value that text does not hold exactly is no new step
}

}  // namespace relief::window
