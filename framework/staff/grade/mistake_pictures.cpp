#include "framework/staff/grade/mistake_pictures.h"

#include <algorithm>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/image/visualize.h"

namespace relief {
namespace {

/// A difference that a person sees, and in how many of the pixels.
constexpr double visible = 8.0 / 255 + 1e-6, visible_share = 0.05;

double share_that_differs(const Image& a, const Image& b) {
    return double(difference(a, b, visible).pixels_over) / double(a.pixel_count());
}

bool in_cpp(const MistakeInfo& mistake) {
    return std::any_of(mistake.edits.begin(), mistake.edits.end(),
                       [](const Edit& edit) { return edit.file.ends_with(".cpp"); });
}

}  // namespace

MistakePictures::MistakePictures(const LabEntry& lab, const Renderer& renderer, int side)
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

/// The check's shot, larger, of its probe or of the light.
Shot MistakePictures::enlarged(const CheckInfo& check, bool probe) const {
    Shot shot = check.shot;
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
        const Shot shot = enlarged(check, probe);
        return render_shot(*make_lab(lab_, shot), shot);
    };
    right.expected = expectation(lab_, check);
    right.lit = draw(false);
    if (check.shot.probe) right.probe = draw(true);
    return right;
}

MistakePicture MistakePictures::best(const MistakeInfo& mistake) {
    // All at once: a mistake in C++ is compiled for them.
    struct Look {
        const CheckInfo* check;
        size_t own, other, lit, probe;  ///< places among the shots
    };
    std::vector<Look> looks;
    std::vector<Shot> shots;
    const auto add = [&](const Shot& shot) {
        shots.push_back(shot);
        return shots.size() - 1;
    };
    for (const CheckInfo& check : manifest_.checks) {
        if (check.task != mistake.task) continue;
        Look look{&check, add(check.shot), 0, add(enlarged(check, false)), 0};
        if (!right(check).expected) look.other = add(manifest_.check(check.against).shot);
        if (check.shot.probe) look.probe = add(enlarged(check, true));
        looks.push_back(look);
    }
    const std::vector<DrawnAttempt> drawn = draw(mistake, shots);

    MistakePicture best;
    double best_score = -1;
    for (const Look& look : looks) {
        const CheckInfo& check = *look.check;
        const Right& good = right(check);
        const DrawnAttempt &own = drawn[look.own], &lit = drawn[look.lit], &probe = drawn[look.probe];
        MistakePicture shown{&check, {own.outcome, own.error}, false, good.lit, lit.image.value_or(Image())};
        const std::optional<Image>& expected = good.expected ? good.expected : drawn[look.other].image;
        if (own.image && expected) shown.said = judge(manifest_, check, *own.image, *expected);
        if (shown.said.outcome == Outcome::passed) continue;
        double score = lit.image ? share_that_differs(good.lit, *lit.image) : 0;
        if (score >= visible_share) {
            score += 1;  // before any probe
        } else if (check.shot.probe && probe.image) {
            const auto [one, other] =
                visualize_probes(good.probe, *probe.image, manifest_.probe(check.shot.probe.name).colors());
            score = share_that_differs(one, other);
            shown.is_probe = true;
            shown.right = good.probe;
            shown.wrong = *probe.image;
        }
        if (score <= best_score) continue;
        best_score = score;
        best = std::move(shown);
    }
    if (!best.check) throw Error("no check of task " + mistake.task + " fails with '" + mistake.id + "'");
    return best;
}

}  // namespace relief
