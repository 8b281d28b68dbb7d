// `relief explain` against known mistakes and correct variants of every lab's shaders.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/compare.h"
#include "framework/course/check/check.h"
#include "framework/course/explain/explain.h"
#include "framework/library/kit/made_map.h"
#include "framework/staff/grade/overlay.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

bool in_shaders(const std::vector<Edit>& edits) {
    return std::all_of(edits.begin(), edits.end(), [](const Edit& edit) { return is_shader(edit.file); });
}

/// Returns the names of the functions in task files that the edits change.
std::set<std::string> edited_functions(const std::vector<Edit>& edits) {
    std::set<std::string> names;
    for (const Edit& edit : edits) {
        const std::string text = read_file(course_root() / edit.file);
        const size_t at = text.find(edit.find);
        for (const GlslFunction& function : parse_glsl(text).functions)
            if (function.begin < at + edit.find.size() && function.end > at) names.insert(function.name);
    }
    return names;
}

Image draw(const LabEntry& lab, const Shot& shot) { return draw_shot(*make_lab(lab, shot), shot); }

/// Returns the pixel at which two pictures differ most, and the difference.
std::pair<glm::ivec2, double> worst_pixel(const Image& a, const Image& b) {
    glm::ivec2 worst{0};
    double most = 0;
    for (size_t i = 0; i < a.pixel_count(); ++i) {
        double off = 0;
        for (size_t c = 0; c < size_t(a.channels); ++c) {
            const float x = a.values[i * size_t(a.channels) + c], y = b.values[i * size_t(a.channels) + c];
            if (x == y) continue;
            const double one = std::abs(double(x) - double(y));
            off += std::isfinite(one) ? one : 1e9;
        }
        if (off > most) most = off, worst = {int(i % size_t(a.width)), int(i / size_t(a.width))};
    }
    return {worst, most};
}

class Explained : public testing::TestWithParam<LabEntry> {
protected:
    struct Said {
        const CheckInfo* check = nullptr;
        glm::ivec2 pixel{0};
        std::string named = {};
    };

    /// Explains a check of the task with these edits, at its worst pixel. For a mistake this is the first check that
    /// fails. For a correct variant it is the check with the largest difference.
    Said said_of(const std::vector<Edit>& edits, const std::string& task, bool is_mistake) {
        Said said;
        double most = -1;
        const grade::CourseOverlay overlay(grade::edited(edits));
        for (const CheckInfo& check : manifest_.checks) {
            if (check.task != task) continue;
            if (is_mistake &&
                check::run_check(GetParam(), manifest_, check, expected_[check.name]).outcome == check::Outcome::passed)
                continue;
            const auto [pixel, off] = worst_pixel(draw(GetParam(), check.shot), right_.at(check.name));
            if (off <= most) continue;
            said.check = &check, said.pixel = pixel, most = off;
            if (is_mistake) break;
        }
        if (!said.check) return said;
        const check::Explanation explanation =
            check::explain(GetParam(), manifest_, said.check->shot, said.pixel, twins_);
        if (explanation.first) said.named = explanation.functions[*explanation.first].function.name;
        return said;
    }

    void SetUp() override {
        std::erase_if(manifest_.checks, [](const CheckInfo& check) { return bool(check.shot.calls); });  // no pixels
        if (!in_shaders_only()) GTEST_SKIP() << "has no shader tasks";
        for (const CheckInfo& check : manifest_.checks) {
            expected_[check.name] = check::expectation(GetParam(), check);
            right_.emplace(check.name, draw(GetParam(), check.shot));
        }
    }
    bool in_shaders_only() const {
        return std::any_of(manifest_.tasks.begin(), manifest_.tasks.end(),
                           [](const TaskInfo& task) { return is_shader(task.file); });
    }

    Manifest manifest_ = load_manifest(GetParam());
    check::Twins twins_ = check::twins_of(manifest_);
    std::map<std::string, std::optional<Image>> expected_;
    std::map<std::string, Image> right_;
};

/// Returns one of the things with edits in shaders, or all of them if tests_all().
template <class Thing>
std::vector<const Thing*> sample_in_shaders(const std::vector<Thing>& things) {
    std::vector<const Thing*> wanted;
    for (const Thing& thing : things)
        if (in_shaders(thing.edits)) wanted.push_back(&thing);
    return sample_of(wanted, 1);
}

/// Collects the unexpected results, one line each.
class Misses {
public:
    template <class Thing>
    void add(const Thing& thing, const CheckInfo* check, glm::ivec2 pixel, const std::string& what) {
        lines_ += fmt::format("\n  {} in '{}' at {},{}: {}", thing.id, check ? check->name : "no check", pixel.x,
                              pixel.y, what);
        ++count_;
    }
    size_t count() const { return count_; }
    const std::string& lines() const { return lines_; }

private:
    std::string lines_;
    size_t count_ = 0;
};

// The goal is 95 % over all labs. A single lab may miss one of ten.
TEST_P(Explained, BlamesTheEditedFunctionFirst) {
    Misses misses;
    const auto mistakes = sample_in_shaders(manifest_.mistakes);
    for (const MistakeInfo* const mistake : mistakes) {
        const std::set<std::string> edited = edited_functions(mistake->edits);
        const Said said = said_of(mistake->edits, mistake->task, true);
        if (!edited.contains(said.named))
            misses.add(*mistake, said.check, said.pixel,
                       fmt::format("named '{}', edited {}", said.named, fmt::join(edited, ", ")));
    }
    fmt::print("{} of {} mistakes{}\n", mistakes.size() - misses.count(), mistakes.size(), misses.lines());
    EXPECT_LE(double(misses.count()), 0.1 * double(mistakes.size())) << misses.lines();
}

TEST_P(Explained, BlamesNoFunctionOfACorrectVariant) {
    // This task accepts any perpendicular, and the probe shows which one was chosen. The difference is real, and the
    // variant is correct.
    const std::string free_choice = "another-perpendicular-in-the-shader";
    if (!tests_all() && GetParam().number % 3 != 1) GTEST_SKIP() << "a sample: lab 10 and every third other one";
    Misses misses;
    const auto variants = sample_in_shaders(manifest_.equivalents);
    for (const EquivalentInfo* const variant : variants) {
        const Said said = said_of(variant->edits, variant->task, false);
        if (!said.named.empty() && variant->id != free_choice)
            misses.add(*variant, said.check, said.pixel, fmt::format("named '{}'", said.named));
    }
    fmt::print("{} of {} variants{}\n", variants.size() - misses.count(), variants.size(), misses.lines());
    EXPECT_EQ(misses.count(), 0U) << misses.lines();
}

// A student's course has no twins.
TEST(Explain, WithoutTwinsValuesAreListedButNoFunctionIsBlamed) {
    const LabEntry& lab = find_lab("10");
    const Manifest manifest = load_manifest(lab);
    const check::Twins twins = check::twins_of(manifest);
    const grade::CourseOverlay overlay(grade::edited(manifest.mistake("against-the-ray").edits));
    const check::Explanation with = check::explain(lab, manifest, manifest.check("eight layers").shot, {65, 80}, twins);
    const check::Explanation without = check::explain(lab, manifest, manifest.check("eight layers").shot, {65, 80}, {});
    EXPECT_TRUE(with.first);
    EXPECT_FALSE(without.first);
    EXPECT_EQ(without.value, with.value);
    ASSERT_EQ(without.functions.size(), with.functions.size());
    for (size_t i = 0; i < with.functions.size(); ++i) {
        const check::ExplainedCall &one = with.functions[i].shown.front(), &other = without.functions[i].shown.front();
        EXPECT_EQ(other.inputs, one.inputs);
        EXPECT_EQ(other.results, one.results);
        EXPECT_TRUE(other.twin.empty());
    }
}

// Lab 15 measures the slopes of the sea in a small picture, once for each of its two views.
TEST(Explain, EqualPassesAreListedOnce) {
    const LabEntry& lab = find_lab("15");
    const Manifest manifest = load_manifest(lab);
    Shot shot;
    shot.size = {256, 144}, shot.camera = manifest.camera;
    const check::Explanation all = check::explain(lab, manifest, shot, {40, 40}, {});
    size_t in_earlier_passes = 0, in_the_picture = 0;
    for (const check::ExplainedFunction& one : all.functions)
        if (one.function.name == "slope_of") ++(one.pass == 0 ? in_the_picture : in_earlier_passes);
    EXPECT_EQ(in_earlier_passes, 1u);
    EXPECT_EQ(in_the_picture, 1u);
}

// The window paints on the map of lab 03, so the lab knows the place on the map below a pixel.
TEST(Explain, ShowsTheTexelThatThePixelReads) {
    const LabEntry& lab = find_lab("03");
    const Manifest manifest = load_manifest(lab);
    const Shot shot = manifest.check("sobel on clean heights").shot;
    const check::Twins twins = check::twins_of(manifest);
    const std::unique_ptr<Lab> drawn = make_lab(lab, shot);
    const Frame frame = {0, shot.size, 0, Camera(shot.camera, double(shot.size.x) / shot.size.y), {}};
    for (const glm::ivec2 pixel : {glm::ivec2(82, 34), {47, 50}, {40, 90}}) {
        const check::Explanation explanation = check::explain(lab, manifest, shot, pixel, twins);
        const auto sobel = std::find_if(explanation.functions.begin(), explanation.functions.end(),
                                        [](const auto& one) { return one.function.name == "sobel"; });
        ASSERT_NE(sobel, explanation.functions.end());
        EXPECT_TRUE(sobel->is_read);
        const auto uv = dynamic_cast<Paintable&>(*drawn).place_on_map(frame, glm::dvec2(pixel) + 0.5);
        ASSERT_TRUE(uv);
        const glm::dvec2 texel = glm::dvec2(uv->x, 1 - uv->y) * glm::dvec2(sobel->size);
        // A filter reads the texels around the place: their centres are less than a texel away.
        EXPECT_LT(std::abs(sobel->pixel.x + 0.5 - texel.x), 1) << pixel.x << ", " << pixel.y;
        EXPECT_LT(std::abs(sobel->pixel.y + 0.5 - texel.y), 1) << pixel.x << ", " << pixel.y;
    }
}

INSTANTIATE_TEST_SUITE_P(Labs, Explained, testing::ValuesIn(registry()),
                         [](const auto& entry) { return "_" + entry.param.folder; });

}  // namespace
}  // namespace relief
