// How far a probe is from the truth, as colours beside the picture. In the window module only.
#pragma once

#include <optional>
#include <string>

#include "framework/gl/texture.h"
#include "framework/image/compare.h"
#include "framework/lab/manifest.h"

namespace relief {

class Stage;

class ErrorMap {
public:
    bool on() const { return on_; }
    void toggle() {
        on_ = !on_;
        forget();
    }

    /// The picture changed: the map is of another one.
    void forget();
    /// Whether compute() is still to be called for this picture.
    bool wanted() const { return on_ && !done_; }
    /// The map of what the stage shows: of its probe, or for a picture of the probe by which the lab compares methods,
    /// else of the first one that has a truth. Takes as long as the truth does. Whatever goes wrong is shown in the
    /// map's place.
    void compute(Stage& stage);

    /// Right of the picture, at pixel `x`; `moves` when the picture does, so that it waits for nothing.
    void draw(int x, glm::ivec2 size, bool moves) const;

private:
    void compare(Stage& stage);

    bool on_ = false, done_ = false;
    std::string message_;
    ProbeInfo probe_;
    ErrorSummary error_;
    std::optional<Texture> picture_;
};

}  // namespace relief
