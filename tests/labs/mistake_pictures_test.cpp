// Pictures of known mistakes in shaders and in C++, and the choice of the check that shows each of them.
#include "framework/staff/grade/mistake_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "framework/core/base/paths.h"
#include "framework/library/maps/visualize.h"
#include "framework/staff/questions/mistake_riddles.h"
#include "tests/support.h"

namespace relief {
namespace {

double share_that_differs(const Image& a, const Image& b) {
    return double(difference(a, b, 8.0 / 255).pixels_over) / double(a.pixel_count());
}

/// Returns the images as the page of mistakes shows them.
std::pair<Image, Image> as_shown(grade::MistakePictures& pictures, const grade::MistakePicture& shown) {
    if (!shown.is_probe) return {shown.right, shown.wrong};
    const auto [wrong, right] =
        visualize_probes(shown.wrong, shown.right, pictures.manifest().probe(shown.check->shot.probe.name).colors());
    return {right, wrong};
}

void expect_shown(const LabEntry& lab, grade::MistakePictures& pictures, const MistakeInfo& mistake) {
    const grade::MistakePicture shown = pictures.best(mistake);
    const std::string name = lab.folder + ": " + mistake.id;
    EXPECT_EQ(shown.check->task, mistake.task) << name;
    EXPECT_NE(shown.said.outcome, check::Outcome::passed) << name;
    EXPECT_FALSE(shown.said.found.empty()) << name;
    EXPECT_EQ(std::max(shown.right.width, shown.right.height), 256) << name;
    ASSERT_TRUE(shown.wrong.same_shape(shown.right)) << name << ": " << shown.said.found;
    if (!shown.is_probe) {
        EXPECT_GE(share_that_differs(shown.right, shown.wrong), 0.05) << name;
        EXPECT_EQ(shown.right.channels, 3);
        return;
    }
    const auto [right, wrong] = as_shown(pictures, shown);
    EXPECT_GE(share_that_differs(right, wrong), 0.0005) << name;
    EXPECT_EQ(right.channels, 3);
}

// Lab 11 has views of level ground, and lab 16 unbounded values. `relief test --all` tests all mistakes of all labs.
TEST(MistakePictures, HaveContrast) {
    for (const LabEntry& lab : registry()) {
        const std::string number = lab.two_digits();
        if (!tests_all() && number != "11" && number != "16") continue;
        grade::MistakePictures pictures(lab);
        for (const MistakeInfo& mistake : sample_of(pictures.manifest().mistakes, 2)) {
            const grade::MistakePicture shown = pictures.best(mistake);
            const auto [right, wrong] = as_shown(pictures, shown);
            EXPECT_GE(grade::contrast_of(right), grade::min_contrast) << number << " " << mistake.id;
            // NaN has only one colour, and so no contrast.
            const bool is_broken = std::any_of(shown.wrong.values.begin(), shown.wrong.values.end(),
                                               [](float value) { return std::isnan(value); });
            if (is_broken) continue;
            EXPECT_GE(grade::contrast_of(wrong), grade::min_contrast) << number << " " << mistake.id;
        }
    }
}

// `relief test --all` tests all mistakes of the lab.
TEST(MistakePictures, ShowEachMistakeInAFailedCheckOfItsTaskWithAVisibleDifference) {
    const LabEntry& lab = find_lab("02");
    grade::MistakePictures pictures(lab);
    bool any_probe = false, any_light = false;
    std::vector<MistakeInfo> mistakes = sample_of(pictures.manifest().mistakes, 7);
    mistakes.push_back(pictures.manifest().mistake("z-not-a-number"));  // only a probe shows it
    for (const MistakeInfo& mistake : mistakes) {
        expect_shown(lab, pictures, mistake);
        (pictures.best(mistake).is_probe ? any_probe : any_light) = true;
    }
    EXPECT_TRUE(any_probe && any_light) << "a mistake of less than a degree is not seen in the light";
}

TEST(MistakePictures, AMistakeInCppIsCompiledAndDrawn) {
    const LabEntry& lab = find_lab("05");
    grade::MistakePictures pictures(lab);
    for (const MistakeInfo& mistake : pictures.manifest().mistakes)
        if (mistake.edits.front().file.ends_with(".cpp")) return expect_shown(lab, pictures, mistake);
    FAIL() << "there is none";
}

// `relief test --all` tests all tasks of the lab.
TEST(MistakePictures, ARiddleShowsItsMistakeInAPublicViewBesideThreeOtherHints) {
    const LabEntry& lab = find_lab("10");
    grade::MistakePictures pictures(lab, {}, 96);
    const Manifest& manifest = pictures.manifest();
    int riddles = 0;
    for (const TaskInfo& task : manifest.tasks) {
        if (riddles == 1 && !tests_all()) break;
        const auto riddle = grade::riddle_of(pictures, lab, task, 96);
        if (!riddle) continue;
        ++riddles;
        EXPECT_EQ(riddle->check->task, task.id);
        EXPECT_FALSE(riddle->check->hidden);
        std::set<std::string> hints;
        for (const auto& choice : riddle->choices) hints.insert(choice.hint);
        ASSERT_EQ(hints.size(), 4U) << task.id;
        const Image& wrong = riddle->choices[riddle->answer].picture;
        EXPECT_GE(double(difference(riddle->right, wrong, 24.0 / 255 + 1e-6).pixels_over),
                  0.05 * double(riddle->right.pixel_count()));
        // Of all mistakes with one of these hints, only those with the answer's draw the picture.
        Shot shot = riddle->check->shot;
        shot.size = {wrong.width, wrong.height};
        if (!riddle->is_probe) shot.probe = {};
        std::array<bool, 4> is_drawn{}, is_shown{};  // by a mistake of the task with this hint; as the choice's picture
        for (const MistakeInfo& mistake : manifest.mistakes)
            for (size_t i = 0; i < 4; ++i) {
                if (mistake.task != task.id || mistake.hint != riddle->choices[i].hint) continue;
                const auto drawn = std::move(pictures.draw(mistake, {shot}).front().image);
                if (!drawn) continue;
                const Image seen = riddle->is_probe ? visualize_probe(*drawn, manifest.probe(shot.probe.name).colors())
                                                    : visualize_picture(*drawn);
                EXPECT_EQ(seen.values == wrong.values, i == riddle->answer) << task.id << " " << mistake.id;
                is_drawn[i] = true, is_shown[i] |= seen.values == riddle->choices[i].picture.values;
            }
        EXPECT_EQ(is_shown, is_drawn) << "the picture of a hint is that of its mistake: " << task.id;
    }
    EXPECT_GE(riddles, tests_all() ? 2 : 1);
}

TEST(MistakePictures, LeaveTheCourseUnchanged) {
    const LabEntry& lab = find_lab("02");
    Shot shot;
    shot.size = {64, 48}, shot.camera = load_manifest(lab).camera;
    const Image before = render_shot(*make_lab(lab, shot), shot);
    const std::string root = course_root().string();
    grade::MistakePictures pictures(lab);
    pictures.draw(pictures.manifest().mistakes.front(), {shot});
    EXPECT_EQ(course_root().string(), root);
    EXPECT_EQ(render_shot(*make_lab(lab, shot), shot).values, before.values);
}

TEST(MistakePictures, ReportTheLineOfACompileError) {
    const LabEntry& lab = find_lab("02");
    grade::MistakePictures pictures(lab);
    MistakeInfo broken = pictures.manifest().mistakes.front();
    broken.edits.front().replace = "nonsense";
    const auto drawn = pictures.draw(broken, {Shot()});
    ASSERT_EQ(drawn.size(), 1u);
    EXPECT_FALSE(drawn[0].image);
    EXPECT_TRUE(contains(drawn[0].error, "task.glsl:")) << drawn[0].error;
}

}  // namespace
}  // namespace relief
