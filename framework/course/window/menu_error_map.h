// The error of a probe, as colours beside the picture. In the window module only.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/gl/texture.h"
#include "framework/core/image/compare.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_tiles.h"

namespace relief::window {

class Stage;

/// Fills a rectangle with the colours of errors, from the smallest on the left to the largest on the right.
void draw_heat(ImDrawList& list, ImVec2 low, ImVec2 high);
/// Draws the colour scale of errors, `width` pixels wide, with evenly spaced marks: two or more.
void draw_heat_scale(const std::vector<std::string>& marks, float width);

/// Exact values are computed on a thread, so that the window goes on drawing.
class ErrorMap {
public:
    ErrorMap();
    ~ErrorMap();  // waits for the thread, which ends soon
    bool on() const { return on_; }
    void toggle() {
        on_ = !on_;
        forget();
    }

    /// Call it when the picture has changed: the map is out of date, and exact values that are being computed are
    /// dropped.
    void forget();
    /// Returns whether begin() has yet to be called for this picture. False until a dropped computation has ended.
    bool wanted() const { return on_ && !done_ && !work_; }
    /// Returns whether finish() has yet to be called.
    bool computes() const { return work_ != nullptr; }
    /// Begins to compute the exact values of the probe on screen. For a picture, takes the probe by which the lab
    /// compares its methods, else the first probe with exact values. Returns whether there is anything new to show: an
    /// error, in place of the map.
    bool begin(const Stage& stage);
    /// Makes the map once the exact values are there. Returns whether there is anything new to show.
    bool finish(Stage& stage);

    /// Inputs of the map on screen. All images have the size of the picture.
    struct Compared {
        ProbeInfo probe;
        Image values, exact, errors;
    };
    const Compared* compared() const { return compared_ ? &*compared_ : nullptr; }

    /// Draws it, and the mean of each tile; without a map, what it waits for: with `moves` the picture is animated.
    /// Returns the places of the numbers in the window.
    std::vector<Box> draw(const Box& box, bool moves) const;
    /// Draws a caption below both halves.
    void draw_legend(const Box& box, const std::string& probe) const;

private:
    struct Work;
    void compare(Stage& stage, const Work& work);
    void fail(const std::string& message);
    void draw_notes() const;

    bool on_ = false, done_ = false;
    std::unique_ptr<Work> work_;
    std::string message_;
    std::optional<Compared> compared_;
    ErrorSummary error_;
    size_t one_sided_ = 0;  ///< pixels
    std::optional<Texture> picture_;
    std::vector<TileMean> tiles_;
};

}  // namespace relief::window
