// The contract of every lab, tested on all labs of the course, and on a new lab.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <utility>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/draw_watch.h"
#include "framework/core/gl/gl.h"
#include "framework/core/gl/program.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/visualize.h"
#include "framework/core/lab/knob_help.h"
#include "framework/core/lab/manifest.h"
#include "tests/support.h"

namespace relief {

static void PrintTo(const LabEntry& lab, std::ostream* stream) { *stream << lab.folder; }

namespace {

class EveryLab : public testing::TestWithParam<LabEntry> {
protected:
    Manifest manifest_ = load_manifest(GetParam());
    Shot shot(Probe probe = {}) const {
        return {.size = {160, 120}, .time = 0.5, .camera = manifest_.camera, .probe = std::move(probe), .set = {}};
    }
    Image picture(const Shot& wanted) const { return render_shot(*make_lab(GetParam(), wanted), wanted); }
};

/// One lab for several small pictures, so that its programs are compiled once, as in the menu.
class SmallLab {
public:
    SmallLab(const LabEntry& entry, Shot shot) : shot_(small(std::move(shot))), lab_(make_lab(entry, shot_)) {}
    Lab& lab() const { return *lab_; }
    const Shot& shot() const { return shot_; }
    Image draw() const {
        draw_lab(*lab_, frame_of(shot_, target_));
        return read_picture(target_);
    }

private:
    static Shot small(Shot shot) {
        shot.size = {96, 72};
        return shot;
    }
    Shot shot_;
    std::unique_ptr<Lab> lab_;
    Target target_{TargetKind::picture, shot_.size};
};

/// Returns the extreme values of a knob: the ends of its range, or all of its choices.
std::vector<std::string> extremes(const KnobText& knob) {
    std::vector<std::string> values;
    std::string range = knob.range;
    if (const size_t whole = range.find(", whole"); whole != std::string::npos) range.resize(whole);
    const bool is_list = range.find(" to ") == std::string::npos;
    const std::string separator = is_list ? ", " : " to ";
    for (size_t begin = 0, end = 0; end != std::string::npos; begin = end + separator.size()) {
        end = range.find(separator, begin);
        values.push_back(range.substr(begin, end - begin));
    }
    return values;
}

/// Returns whether a knob only selects another way to the same picture.
bool finds_it_in_another_way(const LabEntry& lab, const std::string& knob) {
    return (lab.name == "obj_materials" && knob == "programs") ||
           (lab.name == "parallax_occlusion" && knob == "skip") || (lab.name == "relief_exact" && knob == "method") ||
           (lab.name == "tangent_space" && knob == "order");
}

TEST_P(EveryLab, HasATitleAGoalAHandoutAndAShaderFolder) {
    EXPECT_FALSE(manifest_.title.empty());
    EXPECT_FALSE(manifest_.learns.empty());
    const std::filesystem::path handout = course_root() / "labs" / GetParam().folder / "README.md";
    ASSERT_TRUE(std::filesystem::exists(handout));
    if (GetParam().number < 20) {  // one of the course's labs
        const std::string text = read_file(handout), top = text.substr(0, text.find("\n## "));
        EXPECT_TRUE(contains(top, "**Begin here.** Open the lab with `./relief run " + GetParam().two_digits()));
    }
    EXPECT_TRUE(std::filesystem::is_directory(course_root() / "shaders" / GetParam().folder));
}

TEST_P(EveryLab, IsMadeAndDescribedWithoutAnyGlObject) {
    const Counters before = counters();
    describe_knobs(*make_lab(GetParam(), shot()));
    EXPECT_EQ(counters().live, before.live);
}

TEST_P(EveryLab, DrawsTheSamePictureEachTime) { EXPECT_EQ(picture(shot()).values, picture(shot()).values); }

TEST_P(EveryLab, DrawsWithEachKnobAtItsEndsAndCompilesNothingForEqualPictures) {
    const SmallLab small(GetParam(), shot());
    const auto draw = [&] {
        Image image = small.draw();
        refuse_unusable(image, small.shot());
        return image;
    };
    const Image usual = draw();
    for (const KnobText& knob : describe_knobs(small.lab()))
        for (const std::string& value : sample_of(extremes(knob), 4)) {
            set_knob(small.lab(), knob.name, value);
            const int64_t before = counters().links;
            try {
                const bool is_same = draw().values == usual.values;
                if (is_same && !finds_it_in_another_way(GetParam(), knob.name)) {
                    EXPECT_EQ(counters().links, before) << knob.name << " = " << value << " compiles";
                }
            } catch (const Error& error) {
                ADD_FAILURE() << knob.name << " = " << value << ": " << error.what();
            }
            set_knob(small.lab(), knob.name, knob.value);
        }
}

// The window shows such a knob in grey.
TEST_P(EveryLab, IgnoresAKnobWhereItsHelpExcludesIt) {
    const SmallLab small(GetParam(), shot());
    Lab& lab = small.lab();
    const auto draw = [&] { return small.draw().values; };
    const std::vector<KnobText> knobs = describe_knobs(lab);
    for (const KnobText& knob : knobs)
        for (const KnobText& other : knobs) {
            if (read_help(knob.help).knob != other.name) continue;
            for (const std::string& value : extremes(other)) {
                set_knob(lab, other.name, value);
                if (is_ignored(knob.name, describe_knobs(lab))) {
                    const auto usual = draw();
                    for (const std::string& end : extremes(knob)) {
                        set_knob(lab, knob.name, end);
                        EXPECT_EQ(draw() == usual, true)
                            << other.name << " = " << value << ", " << knob.name << " = " << end;
                    }
                    set_knob(lab, knob.name, knob.value);
                }
            }
            set_knob(lab, other.name, other.value);
        }
}

// In the window a shader may not compile while its author types. Once it compiles again, the picture is as before.
TEST_P(EveryLab, ADrawThatThrowsChangesNoKnobAndNotTheNextPicture) {
    std::vector<std::string> views = {""};
    for (const KnobText& knob : describe_knobs(*make_lab(GetParam(), shot())))
        if (knob.name == "view") views = extremes(knob);
    for (const std::string& view : views) {
        Shot wanted = shot();
        if (!view.empty()) wanted.set = {{"view", view}};
        const Image expected = SmallLab(GetParam(), wanted).draw();
        const SmallLab small(GetParam(), wanted);
        const auto values = [&] {
            std::vector<std::string> all;
            for (const KnobText& knob : describe_knobs(small.lab())) all.push_back(knob.name + "=" + knob.value);
            return all;
        };
        const std::vector<std::string> before = values();
        // Each program of the picture fails once: one more program compiles in every frame. The program of the labels
        // always compiles. Otherwise it would fail last, and no program would fail after a caption.
        bool is_broken = true;
        for (int frame = 0; is_broken && frame < 50; ++frame) {
            is_broken = false;
            int compiled = 0;
            const ShaderRewriting fails([&](std::vector<ShaderSource>& stages, GLuint) {
                if (stages.back().stage.stem() != "label" && compiled++ == (frame == 0 ? 0 : 1))
                    is_broken = true, throw Error("does not compile");
            });
            try {
                EXPECT_EQ(small.draw().values == expected.values, true) << view << ": after " << frame << " failures";
            } catch (const Error&) {
                EXPECT_TRUE(is_broken);
            }
            EXPECT_EQ(values(), before) << view << ": frame " << frame;
        }
        EXPECT_FALSE(is_broken) << view;
    }
}

// The window ends the first draw of a lab after each program that takes long to compile, and draws again.
TEST_P(EveryLab, ADrawThatEndsAfterAnyDrawCallDoesNotChangeTheNextPicture) {
    const Image expected = SmallLab(GetParam(), shot()).draw();
    const SmallLab small(GetParam(), shot());
    struct Pause {};
    bool is_whole = false;
    for (int calls = 1; !is_whole; calls += 1 + calls / 10) {
        int left = calls;
        try {
            const DrawWatch watch([&](const std::function<void()>& draw_call) {
                draw_call();
                if (--left == 0) throw Pause();
            });
            small.draw();
            is_whole = true;
        } catch (const Pause&) {
            EXPECT_EQ(take_gl_errors(), "") << "after " << calls << " draw calls";
        }
    }
    EXPECT_EQ(small.draw().values == expected.values, true);
}

TEST_P(EveryLab, DrawsInAnyShapeOfPicture) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(2, 97), glm::ivec2(97, 2)}) {
        Shot odd = shot();
        odd.size = size;
        try {
            picture(odd);
        } catch (const Error& error) {  // two columns of background are a picture of one colour; nothing else may fail
            EXPECT_TRUE(contains(error.what(), "one colour")) << error.what();
        }
    }
}

/// Expects that a larger value is never darker. Pixels without a surface, or without a value, are left out.
void expect_rising(const Image& probe, const Image& picture, const std::string& name,
                   const std::function<double(const float*)>& value, const std::function<double(const float*)>& color) {
    std::vector<std::pair<double, double>> all;
    for (size_t i = 0; i < probe.pixel_count(); ++i) {
        const float* const own = &probe.values[i * size_t(probe.channels)];
        if (std::isfinite(own[0]) && !std::isnan(value(own)))
            all.emplace_back(value(own), color(&picture.values[i * 3]));
    }
    std::sort(all.begin(), all.end());
    for (size_t i = 1; i < all.size(); ++i)
        ASSERT_GE(all[i].second, all[i - 1].second - 1e-6) << name << ": colours are rounded to floats";
}

/// Expects that a probe's picture repeats no colour.
void expect_no_repetition(const Image& probe, const ProbeInfo& info) {
    const Image picture = visualize_probe(probe, info.colors());
    if (info.error != ErrorMetric::absolute) {
        for (int c = 0; c < 3; ++c)
            expect_rising(
                probe, picture, info.name, [=](const float* v) { return double(v[c]); },
                [=](const float* color) { return double(color[c]); });
        return;
    }
    // Each scale of single numbers rises in lightness. If the sign matters, values below 0 have a separate scale.
    for (const double sign : {1.0, -1.0})
        expect_rising(
            probe, picture, info.name, [=](const float* v) { return sign * *v >= 0 ? std::abs(double(*v)) : NAN; },
            [](const float* color) { return double(color[0]) + color[1] + color[2]; });
}

TEST_P(EveryLab, EachProbeIsFiniteAgreesWithItsTruthAndRepeatsNoColour) {
    EXPECT_FALSE(manifest_.probes.empty());
    for (const ProbeInfo& info : manifest_.probes) {
        const Shot wanted = shot({info.name});
        const auto lab = make_lab(GetParam(), wanted);
        const Image probe = render_shot(*lab, wanted);  // throws when it is not a number anywhere
        expect_no_repetition(probe, info);
        const Frame frame{0, wanted.size, wanted.time, Camera(wanted.camera, 4.0 / 3), wanted.probe};
        const auto truth = lab->truth(frame, wanted.probe);
        if (!truth) continue;
        const ErrorSummary error = summarize(error_image(probe, *truth, info.error));
        EXPECT_GT(error.count, probe.pixel_count() / 100) << info.name;
        EXPECT_EQ(error.not_finite, 0u) << info.name;
        EXPECT_LT(error.p99, info.limit) << info.name << " in " << info.unit;
    }
}

// A lab that draws a picture that is higher than wide with a wider field of view must use it for the exact values, too.
TEST_P(EveryLab, AgreesWithItsExactValuesInAPortraitPictureAsInALandscapeOne) {
    const auto mean_error = [&](const ProbeInfo& info, glm::ivec2 size) -> std::optional<double> {
        Shot wanted = shot({info.name});
        wanted.size = size;
        const auto lab = make_lab(GetParam(), wanted);
        const Frame frame{0, size, wanted.time, Camera(wanted.camera, double(size.x) / size.y), wanted.probe};
        const auto truth = lab->truth(frame, wanted.probe);
        if (!truth) return {};
        return summarize(error_image(render_shot(*lab, wanted), *truth, info.error)).mean;
    };
    for (const ProbeInfo& info : manifest_.probes) {
        const std::optional<double> landscape = mean_error(info, {96, 48});
        if (!landscape) continue;
        // The two pictures show other parts of a scene: at most 1.2 times the error. Another camera gives 17 times.
        EXPECT_LE(mean_error(info, {48, 96}), 3 * *landscape) << info.name << " in " << info.unit;
        return;  // one probe is enough
    }
}

TEST_P(EveryLab, FreesEveryObjectAndByte) {
    const Counters before = counters();
    picture(shot());
    EXPECT_EQ(counters().live, before.live);
    EXPECT_EQ(counters().texture_bytes, before.texture_bytes);
}

TEST_P(EveryLab, ComesBackIdenticalAfterAnyOtherLab) {
    const Shot own = shot();
    const auto lab = make_lab(GetParam(), own);
    const Image before = render_shot(*lab, own);
    const Counters objects = counters();
    // Every sixth lab, so that each lab is the other one three times. `relief test --all` draws all pairs.
    const size_t step = tests_all() ? 1 : std::min<size_t>(6, registry().size());
    for (size_t i = size_t(GetParam().number) % step; i < registry().size(); i += step) {
        const LabEntry& other = registry()[i];
        Shot theirs;
        theirs.size = {64, 48};
        theirs.camera = load_manifest(other).camera;
        render_shot(*make_lab(other, theirs), theirs);
        EXPECT_EQ(render_shot(*lab, own).values, before.values) << "after " << other.folder;
    }
    EXPECT_EQ(counters().live, objects.live);
}

INSTANTIATE_TEST_SUITE_P(Labs, EveryLab, testing::ValuesIn(registry()),
                         [](const auto& lab) { return "Lab" + lab.param.folder; });

TEST(Labs, AreRegistered) { EXPECT_FALSE(registry().empty()); }

}  // namespace
}  // namespace relief
