#include "framework/staff/grade/mistake_pictures.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/library/maps/visualize.h"

namespace relief::grade {
namespace {

/// A person sees a difference of `visible` in at least this share of the pixels.
constexpr double visible = 8.0 / 255 + 1e-6, visible_share = 0.05;

double share_that_differs(const Image& a, const Image& b) {
    if (!a.same_shape(b)) return 0;  // the mistake draws nothing
    return double(difference(a, b, visible).pixels_over) / double(a.pixel_count());
}

bool in_cpp(const MistakeInfo& mistake) {
    return std::any_of(mistake.edits.begin(), mistake.edits.end(),
                       [](const Edit& edit) { return edit.file.ends_with(".cpp"); });
}

}  // namespace

double contrast_of(const Image& picture) {
    double largest = 0;
    std::vector<float> values(picture.pixel_count());
    if (values.empty()) return 0;
    for (int c = 0; c < picture.channels; ++c) {
        for (size_t i = 0; i < values.size(); ++i) values[i] = picture.values[i * size_t(picture.channels) + size_t(c)];
        std::sort(values.begin(), values.end());
        const size_t cut = values.size() / 100;
        largest = std::max<double>(largest, values[values.size() - 1 - cut] - values[cut]);
    }
    return largest;
}

/// A pair of images, and how well it shows the mistake.
struct MistakePictures::Candidate {
    MistakePicture shown;
    bool right_has_contrast, wrong_has_contrast, is_lit;
    double share;  ///< share of the pixels that differ visibly

    /// `right` and `wrong`: the images as a person sees them.
    Candidate(MistakePicture picture, const Image& right, const Image& wrong)
        : shown(std::move(picture)),
          right_has_contrast(contrast_of(right) >= min_contrast),
          wrong_has_contrast(contrast_of(wrong) >= min_contrast),
          is_lit(!shown.is_probe),
          share(share_that_differs(right, wrong)) {}

    bool is_readable() const { return right_has_contrast && wrong_has_contrast; }
    bool operator<(const Candidate& other) const {
        const auto rank = [](const Candidate& one) {
            return std::tuple(one.right_has_contrast, one.wrong_has_contrast, one.is_lit, one.share);
        };
        return rank(*this) < rank(other);
    }
};

MistakePictures::MistakePictures(const LabEntry& lab, const check::Renderer& renderer, int side)
    : lab_(lab), renderer_(renderer), side_(side), manifest_(load_manifest(lab)) {}

std::vector<DrawnAttempt> MistakePictures::draw(const MistakeInfo& mistake, const std::vector<Shot>& shots,
                                                bool light) {
    CourseFiles files = edited(mistake.edits);
    if (in_cpp(mistake)) {
        if (light) throw UsageError("'" + mistake.id + "' is a mistake in C++: its picture is 8-bit, .png or .ppm");
        if (!stage_) {
            stage_ = std::make_unique<Stage>(probe_isolation().level);
            stage_->add(lab_);
        }
        files.merge(solution_files(manifest_));  // keeps the edited files
        return attempt(*stage_, lab_, files, shots, renderer_, {}).shots;
    }
    std::vector<DrawnAttempt> drawn;
    const CourseOverlay overlay(files);
    for (const Shot& shot : shots) {
        DrawnAttempt& one = drawn.emplace_back();
        try {
            one.image = draw_shot(*make_lab(lab_, shot), shot, light);
        } catch (const Error& error) {
            one.error = error.what();
        }
    }
    return drawn;
}

/// Returns the shot, scaled so that its longer side has `side_` pixels. `probe`: whether to keep its probe.
Shot MistakePictures::enlarged(Shot shot, bool probe) const {
    const double scale = double(side_) / std::max(shot.size.x, shot.size.y);
    shot.size = glm::max(glm::ivec2(glm::dvec2(shot.size) * scale + 0.5), 1);
    if (!probe) shot.probe = {};
    return shot;
}

const MistakePictures::Right& MistakePictures::right(const CheckInfo& check) {
    const auto [place, is_new] = right_.try_emplace(&check);
    Right& right = place->second;
    if (!is_new) return right;
    const auto draw = [&](bool probe) {
        const Shot shot = enlarged(check.shot, probe);
        return render_shot(*make_lab(lab_, shot), shot);
    };
    right.expected = check::expectation(lab_, check);
    right.lit = draw(false);
    if (check.shot.probe) right.probe = draw(true);
    return right;
}

MistakePicture MistakePictures::best(const MistakeInfo& mistake) {
    // All shots in one call, so that a mistake in C++ is compiled only once.
    struct Look {
        const CheckInfo* check;
        size_t own, other, lit, probe;  ///< indices of shots
    };
    std::vector<Look> looks;
    std::vector<Shot> shots;
    const auto add = [&](const Shot& shot) {
        shots.push_back(shot);
        return shots.size() - 1;
    };
    for (const CheckInfo& check : manifest_.checks) {
        if (check.task != mistake.task || check.shot.calls) continue;
        Look look{&check, add(check.shot), 0, add(enlarged(check.shot, false)), 0};
        if (!right(check).expected) look.other = add(manifest_.check(check.against).shot);
        if (check.shot.probe) look.probe = add(enlarged(check.shot, true));
        looks.push_back(look);
    }
    const std::vector<DrawnAttempt> drawn = draw(mistake, shots);

    std::optional<Candidate> best;
    const auto consider = [&](Candidate candidate) {
        if (!best || *best < candidate) best = std::move(candidate);
    };
    for (const Look& look : looks) {
        const CheckInfo& check = *look.check;
        const Right& good = right(check);
        const DrawnAttempt &own = drawn[look.own], &lit = drawn[look.lit], &probe = drawn[look.probe];
        MistakePicture shown{.check = &check, .said = {own.outcome, own.error}};
        const std::optional<Image>& expected = good.expected ? good.expected : drawn[look.other].image;
        if (own.image && expected) shown.said = check::judge(manifest_, check, *own.image, *expected);
        if (shown.said.outcome == check::Outcome::passed) continue;
        if (check.added && best) continue;  // its view was looked at with its task's first check
        shown.right = good.lit, shown.wrong = lit.image.value_or(Image());
        Candidate picture(shown, good.lit, shown.wrong);
        const bool is_seen = picture.share >= visible_share;
        // An invisible difference in the picture may be visible in the probe.
        if (is_seen || !check.shot.probe || !probe.image) consider(std::move(picture));
        if (!check.shot.probe || !probe.image) continue;
        const auto [wrong_seen, right_seen] =
            visualize_probes(*probe.image, good.probe, manifest_.probe(check.shot.probe.name).colors());
        shown.is_probe = true, shown.right = good.probe, shown.wrong = *probe.image;
        consider(Candidate(std::move(shown), right_seen, wrong_seen));
    }
    if (!best) throw Error("no check of task " + mistake.task + " fails with '" + mistake.id + "'");
    if (best->is_readable()) return std::move(best->shown);
    if (std::optional<Candidate> other = in_a_screenshot(mistake)) {
        other->shown.check = best->shown.check, other->shown.said = best->shown.said;
        consider(*std::move(other));
    }
    return std::move(best->shown);
}

/// Returns the pair that shows the mistake best in the views of screenshots without a probe. Returns nothing if it is
/// invisible in all of them.
std::optional<MistakePictures::Candidate> MistakePictures::in_a_screenshot(const MistakeInfo& mistake) {
    std::vector<const GoldenInfo*> goldens;
    std::vector<Shot> shots;
    for (const GoldenInfo& golden : manifest_.goldens)
        if (!golden.shot.probe) goldens.push_back(&golden), shots.push_back(enlarged(golden.shot, false));
    const std::vector<DrawnAttempt> drawn = draw(mistake, shots);
    std::optional<Candidate> best;
    for (size_t i = 0; i < shots.size(); ++i) {
        if (!drawn[i].image) continue;
        MistakePicture shown{.screenshot = goldens[i], .wrong = *drawn[i].image};
        shown.right = render_shot(*make_lab(lab_, shots[i]), shots[i]);
        Candidate candidate(shown, shown.right, shown.wrong);
        if (candidate.share >= visible_share && (!best || *best < candidate)) best = std::move(candidate);
    }
    return best;
}

}  // namespace relief::grade
