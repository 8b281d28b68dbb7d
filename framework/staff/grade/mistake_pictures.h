// Pictures of known mistakes: draws a lab with a mistake in place of its solution, and finds the check that shows it
// best.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/staff/grade/attempt.h"

namespace relief {

/// The pair of images that shows a mistake best.
struct MistakePicture {
    const CheckInfo* check = nullptr;        ///< of the mistake's task
    Judgement said = {};                     ///< the check's verdict about the mistake
    bool is_probe = false;                   ///< the images are the check's probe, not pictures
    const GoldenInfo* screenshot = nullptr;  ///< the images have the view of this screenshot instead of the check's
    Image right = {}, wrong = {};            ///< `wrong` is empty if the mistake draws nothing: see `said`
};

/// The contrast of an image in [0, 1]: the largest distance, over the channels, between the 1st and the 99th
/// percentile.
double contrast_of(const Image& picture);
/// An image with less contrast looks blank: a tenth of the way from black to white.
constexpr double min_contrast = 0.1;

/// The mistakes of one lab. A mistake in shaders is drawn in the current context. A mistake in C++ is compiled and
/// drawn by a separate process, like a submission; the first one prepares the stage for that.
class MistakePictures {
public:
    /// `renderer`: as the current context draws. `side`: the longer side of best()'s images, in pixels.
    explicit MistakePictures(const LabEntry& lab, const Renderer& renderer = {}, int side = 256);

    const Manifest& manifest() const { return manifest_; }

    /// The result of each shot: an image as draw_shot() makes it, or the error. `light`: see draw_shot(); throws
    /// UsageError if the mistake is in C++.
    std::vector<DrawnAttempt> draw(const MistakeInfo& mistake, const std::vector<Shot>& shots, bool light = false);

    /// The images that show the mistake best, of the views of the checks that fail: a pair of which both have contrast
    /// comes before one of which only the right one has; then a pair of pictures that differ visibly (5 % of the pixels
    /// by more than 8/255) before one of the check's probe; then the pair that differs most. Without contrast in both,
    /// the views of the lab's screenshots are tried, too. Throws Error if no check fails. Needs a context.
    MistakePicture best(const MistakeInfo& mistake);

private:
    struct Right {
        std::optional<Image> expected;  ///< see expectation()
        Image lit, probe;               ///< of the solution; `probe` is empty if the check has none
    };
    const Right& right(const CheckInfo& check);
    Shot enlarged(Shot shot, bool probe) const;
    struct Candidate;
    std::optional<Candidate> in_a_screenshot(const MistakeInfo& mistake);

    const LabEntry& lab_;
    Renderer renderer_;
    int side_;
    Manifest manifest_;
    std::unique_ptr<Stage> stage_;  ///< once there was a mistake in C++
    std::map<const CheckInfo*, Right> right_;
};

}  // namespace relief
