// Pictures of known mistakes: what is drawn, in shaders and in C++, and which check is chosen to show it.
#include "framework/staff/grade/mistake_pictures.h"

#include "framework/base/paths.h"
#include "framework/image/visualize.h"
#include "tests/support.h"

namespace relief {
namespace {

double share_that_differs(const Image& a, const Image& b) {
    return double(difference(a, b, 8.0 / 255).pixels_over) / double(a.pixel_count());
}

void expect_shown(const LabEntry& lab, MistakePictures& pictures, const MistakeInfo& mistake) {
    const MistakePicture shown = pictures.best(mistake);
    const std::string name = lab.folder + ": " + mistake.id;
    EXPECT_EQ(shown.check->task, mistake.task) << name;
    EXPECT_NE(shown.said.outcome, Outcome::passed) << name;
    EXPECT_FALSE(shown.said.found.empty()) << name;
    EXPECT_EQ(std::max(shown.right.width, shown.right.height), 256) << name;
    ASSERT_TRUE(shown.wrong.same_shape(shown.right)) << name << ": " << shown.said.found;
    if (!shown.is_probe) {
        EXPECT_GE(share_that_differs(shown.right, shown.wrong), 0.05) << name;
        EXPECT_EQ(shown.right.channels, 3);
        return;
    }
    const auto [right, wrong] =
        visualize_probes(shown.right, shown.wrong, pictures.manifest().probe(shown.check->shot.probe.name).colors());
    EXPECT_GE(share_that_differs(right, wrong), 0.0005) << name;
    EXPECT_EQ(right.channels, 3);
}

TEST(MistakePictures, EachOfALabIsShownByACheckOfItsTaskThatFailsInAPictureThatDiffers) {
    const LabEntry& lab = find_lab("02");
    MistakePictures pictures(lab);
    bool any_probe = false, any_light = false;
    for (const MistakeInfo& mistake : pictures.manifest().mistakes) {
        expect_shown(lab, pictures, mistake);
        (pictures.best(mistake).is_probe ? any_probe : any_light) = true;
    }
    EXPECT_TRUE(any_probe && any_light) << "a mistake of less than a degree is not seen in the light";
}

TEST(MistakePictures, AMistakeInCppIsCompiledAndDrawn) {
    const LabEntry& lab = find_lab("05");
    MistakePictures pictures(lab);
    for (const MistakeInfo& mistake : pictures.manifest().mistakes)
        if (mistake.edits.front().file.ends_with(".cpp")) return expect_shown(lab, pictures, mistake);
    FAIL() << "there is none";
}

TEST(MistakePictures, LeaveTheCourseAsItWas) {
    const LabEntry& lab = find_lab("02");
    Shot shot;
    shot.size = {64, 48}, shot.camera = load_manifest(lab).camera;
    const Image before = render_shot(*make_lab(lab, shot), shot);
    const auto root = course_root();
    MistakePictures pictures(lab);
    pictures.draw(pictures.manifest().mistakes.front(), {shot});
    EXPECT_EQ(course_root(), root);
    EXPECT_EQ(render_shot(*make_lab(lab, shot), shot).values, before.values);
}

TEST(MistakePictures, WhatDoesNotCompileSaysWhere) {
    const LabEntry& lab = find_lab("02");
    MistakePictures pictures(lab);
    MistakeInfo broken = pictures.manifest().mistakes.front();
    broken.edits.front().replace = "nonsense";
    const auto drawn = pictures.draw(broken, {Shot()});
    ASSERT_EQ(drawn.size(), 1u);
    EXPECT_FALSE(drawn[0].image);
    EXPECT_TRUE(contains(drawn[0].error, "task.glsl:")) << drawn[0].error;
}

}  // namespace
}  // namespace relief
