// How far a probe is from the truth, as colours beside the picture. In the window module only.
#pragma once

#include <optional>
#include <string>

#include "framework/gl/texture.h"
#include "framework/image/compare.h"
#include "framework/lab/manifest.h"

namespace relief {

class Stage;

/// The colours of errors from `first` to `last`, as wide as is said.
void draw_heat_scale(const std::string& first, const std::string& last, float width);

class ErrorMap {
public:
    bool on() const { return on_; }
    void toggle() {
        on_ = !on_;
        forget();
    }

    /// Call it when the picture changed: the map belongs to the old one.
    void forget();
    /// Whether compute() has not been called yet for this picture.
    bool wanted() const { return on_ && !done_; }
    /// Computes the map of the stage's probe, or for a picture of the probe by which the lab compares its methods, else
    /// of the first one that has exact values. Takes as long as they do. An error is shown in place of the map.
    void compute(Stage& stage);

    /// What it was computed from, while it is shown: one pixel of each belongs to one pixel of the picture.
    struct Compared {
        ProbeInfo probe;
        Image values, exact, errors;
    };
    const Compared* compared() const { return compared_ ? &*compared_ : nullptr; }

    /// Draws it with its corner at `at`. `moves`: the picture is animated, so there is no map.
    void draw(glm::ivec2 at, glm::ivec2 size, bool moves) const;

private:
    void compare(Stage& stage);

    bool on_ = false, done_ = false;
    std::string message_;
    std::optional<Compared> compared_;
    ErrorSummary error_;
    std::optional<Texture> picture_;
};

}  // namespace relief
