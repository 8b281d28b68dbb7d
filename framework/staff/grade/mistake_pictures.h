// Pictures of known mistakes: a lab drawn with one of them in place of its solution, and the check that shows it best.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/staff/grade/attempt.h"

namespace relief {

/// What shows a mistake best, beside the same of the solution.
struct MistakePicture {
    const CheckInfo* check = nullptr;  ///< of the mistake's task
    Judgement said;                    ///< what the check finds
    bool is_probe = false;             ///< the images are the check's probe, and no pictures
    Image right, wrong;                ///< `wrong` is empty where nothing comes of it: see `said`
};

/// Of one lab. A mistake in shaders is drawn in the current context; one in C++ by a process of its own, as a
/// submission is, with what is needed for that made at the first.
class MistakePictures {
public:
    /// `renderer` is that of the current context; `side` the longer one of what best() gives, in pixels.
    explicit MistakePictures(const LabEntry& lab, const Renderer& renderer = {}, int side = 256);

    const Manifest& manifest() const { return manifest_; }

    /// As draw_shot() has them, or what went wrong. `light`: see there; throws UsageError for a mistake in C++.
    std::vector<DrawnAttempt> draw(const MistakeInfo& mistake, const std::vector<Shot>& shots, bool light = false);

    /// Of the checks that fail with it: the one whose picture without the probe differs most from the solution's, when
    /// it is visibly another (5 % of the pixels by more than 8/255), else the one whose probe does. Throws Error when
    /// none fails. Wants a context.
    MistakePicture best(const MistakeInfo& mistake);

private:
    struct Right {
        std::optional<Image> expected;  ///< see expectation()
        Image lit, probe;               ///< of the solution; the latter empty where the check has none
    };
    const Right& right(const CheckInfo& check);
    Shot enlarged(const CheckInfo& check, bool probe) const;

    const LabEntry& lab_;
    Renderer renderer_;
    int side_;
    Manifest manifest_;
    std::unique_ptr<Stage> stage_;  ///< when there was a mistake in C++
    std::map<const CheckInfo*, Right> right_;
};

}  // namespace relief
