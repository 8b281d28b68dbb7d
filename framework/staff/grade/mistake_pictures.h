// Draws a lab with a known mistake in place of its solution, and finds the check that shows the mistake best.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/staff/grade/attempt.h"

namespace relief::grade {

/// The pair of images that shows a mistake best.
struct MistakePicture {
    const CheckInfo* check = nullptr;        ///< of the mistake's task
    check::Verdict said = {};                ///< the check's verdict about the mistake
    bool is_probe = false;                   ///< the images are the check's probe, not pictures
    const GoldenInfo* screenshot = nullptr;  ///< the images have the view of this screenshot instead of the check's
    Image right = {}, wrong = {};            ///< `wrong` is empty if the mistake draws nothing: see `said`
};

/// Returns the contrast of an image in [0, 1]: the maximum over the channels of the distance between the 1st and the
/// 99th percentile.
double contrast_of(const Image& picture);
/// An image with less contrast looks blank. 1 is the distance from black to white.
constexpr double min_contrast = 0.1;

/// Draws the mistakes of one lab. A mistake in shaders is drawn in the current context. A mistake in C++ is compiled
/// and drawn by a separate process, like a submission; the first such mistake creates the stage.
class MistakePictures {
public:
    /// `renderer`: for mistakes in C++; should match the current context. `side`: the longer side of best()'s images,
    /// in pixels.
    explicit MistakePictures(const LabEntry& lab, const check::Renderer& renderer = {}, int side = 256);

    const Manifest& manifest() const { return manifest_; }

    /// Returns the result of each shot: an image as draw_shot() returns it, or the error. `light`: see draw_shot();
    /// throws UsageError with `light` if the mistake is in C++.
    std::vector<DrawnAttempt> draw(const MistakeInfo& mistake, const std::vector<Shot>& shots, bool light = false);

    /// Returns the pair of images that shows the mistake best, among the views of the failed checks. First prefers a
    /// pair with contrast in both images to a pair with contrast only in the right one. Then prefers pictures that
    /// differ visibly (5 % of the pixels by more than 8/255) to the check's probe. Then prefers the largest difference.
    /// Also tries the views of the lab's screenshots if no pair has contrast in both images. Throws Error if no check
    /// fails. Needs a current context.
    MistakePicture best(const MistakeInfo& mistake);

private:
    struct Right {
        std::optional<Image> expected;  ///< see expectation()
        Image lit, probe;               ///< the solution's images; `probe` is empty if the check has none
    };
    const Right& right(const CheckInfo& check);
    Shot enlarged(Shot shot, bool probe) const;
    struct Candidate;
    std::optional<Candidate> in_a_screenshot(const MistakeInfo& mistake);

    const LabEntry& lab_;
    check::Renderer renderer_;
    int side_;
    Manifest manifest_;
    std::unique_ptr<Stage> stage_;  ///< null until the first mistake in C++
    std::map<const CheckInfo*, Right> right_;
};

}  // namespace relief::grade
