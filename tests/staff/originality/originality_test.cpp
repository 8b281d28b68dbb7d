// Which submissions of a class share code.
#include "framework/staff/originality/originality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/overlay.h"
#include "framework/staff/pages/originality_page.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

const std::string task_file = "shaders/11_parallax_occlusion/task.glsl";

std::string solution() { return read_file(course_root() / task_file); }
std::string starter() { return check::starter_of(solution(), task_file); }

/// A folder with submissions of lab 11.
class OriginalityTest : public testing::Test {
protected:
    /// Returns the folder of a submission with this file.
    fs::path hand_in(const std::string& name, const std::string& text, const std::string& file = task_file) {
        folder_.write(name + "/" + file, text);
        return folder_.path() / name;
    }
    /// Returns the folders of the solution and of all variants of the lab.
    std::vector<fs::path> hand_in_right_answers() {
        std::vector<fs::path> paths = {hand_in("right", solution())};
        for (const EquivalentInfo& variant : load_manifest(find_lab("11")).equivalents)
            paths.push_back(hand_in("right " + variant.id, edited(variant.edits).at(task_file)));
        return paths;
    }
    const TemporaryFolder folder_;
};

/// The solution with the march of 11.2 and the search of 11.4 as one person wrote them.
std::string own_answer() {
    const std::string all = solution();
    const size_t march = all.find("    float stride = 1.0 / max(steps, 1.0), above"),
                 march_end = all.find("    //]starter", march), search = all.find("    vec2 weight = vec2(1.0);"),
                 search_end = all.find("    //]starter", search);
    return all.substr(0, march) +
           "    float pace = steps > 1.0 ? 1.0 / steps : 1.0;\n"
           "    vec2 here = vec2(0.0, gap(heights, ray, 0.0)), there = here;\n"
           "    int budget = int(ceil(steps)) + 1;\n"
           "    for (int k = 0; k < budget; ++k) {\n"
           "        if (there.y <= 0.0 || there.x >= 1.0) break;\n"
           "        here = there;\n"
           "        there = vec2(here.x + pace > 1.0 ? 1.0 : here.x + pace, 0.0);\n"
           "        there.y = gap(heights, ray, there.x);\n"
           "    }\n"
           "    Bracket found;\n"
           "    found.before = here.x;\n    found.after = there.x;\n"
           "    found.gap_before = here.y;\n    found.gap_after = there.y;\n"
           "    return found;\n" +
           all.substr(march_end, search - march_end) +
           "    float left = b.gap_before, right = b.gap_after;\n"
           "    bool moved_left = false, moved_right = false;\n"
           "    while (rounds-- > 0) {\n"
           "        if (b.gap_before <= 0.0) break;\n"
           "        float share = 0.5;\n"
           "        if (method != bisection) share = crossing(left, right);\n"
           "        float middle = b.before + share * (b.after - b.before);\n"
           "        float value = gap(heights, ray, middle);\n"
           "        if (value <= 0.0) {\n"
           "            if (moved_right && method == illinois) left *= 0.5; else left = b.gap_before;\n"
           "            b.after = middle, b.gap_after = right = value;\n"
           "            moved_right = true, moved_left = false;\n"
           "            continue;\n"
           "        }\n"
           "        if (moved_left && method == illinois) right *= 0.5; else right = b.gap_after;\n"
           "        b.before = middle, b.gap_before = left = value;\n"
           "        moved_left = true, moved_right = false;\n"
           "    }\n"
           "    return b;\n" +
           all.substr(search_end);
}

/// The same with other names, comments and layout, and with independent statements in another order.
std::string copied_answer() {
    std::string text = own_answer();
    for (const auto& [from, to] : {std::pair("pace", "delta"),
                                   {"there", "now"},
                                   {"here", "last"},
                                   {"budget", "most"},
                                   {"left", "wa"},
                                   {"right", "wb"},
                                   {"middle", "t"},
                                   {"value", "y"},
                                   {"share", "s"},
                                   {"found", "result"}})
        text = replaced(text, from, to);
    text = replaced(text, "    result.before = last.x;\n    result.after = now.x;\n",
                    "    result.after = now.x;  // the end\n\n    result.before = last.x;\n");
    return replaced(text, "float t = b.before + s * (b.after - b.before);",
                    "float t =\n            b.before + s *\n            (b.after - b.before);  // in between");
}

std::vector<const LabEntry*> lab_11() { return {&find_lab("11")}; }

TEST_F(OriginalityTest, ARenamedAndReorderedCopyIsTheFirstPairAndRightAnswersAreNone) {
    std::vector<fs::path> paths = hand_in_right_answers();
    EXPECT_TRUE(compare_class(paths, {}, lab_11()).pairs.empty());
    paths.insert(paths.begin() + 3, hand_in("author", own_answer()));
    paths.push_back(hand_in("copy", copied_answer()));
    const OriginalityReport report = compare_class(paths, {}, lab_11());
    ASSERT_EQ(report.pairs.size(), 1u);
    const SimilarPair& pair = report.pairs.front();
    EXPECT_EQ(report.authors[pair.authors[0]].name, "author");
    EXPECT_EQ(report.authors[pair.authors[1]].name, "copy");
    EXPECT_LT(pair.by_chance, alarm_by_chance);
    std::set<std::string> tasks;
    for (const SharedTask& task : pair.tasks) {
        tasks.insert(task.task);
        EXPECT_GE(task.rare, 10u) << task.task;
        EXPECT_GT(task.sides[0].share, 0.8) << task.task;
        for (const size_t side : {0, 1}) {
            const std::string& file = report.authors[pair.authors[side]].files.at(task.file);
            for (const SharedRange& range : task.sides[side].ranges) EXPECT_LE(range.end, file.size());
            EXPECT_FALSE(task.sides[side].lines.empty());
        }
    }
    EXPECT_EQ(tasks, (std::set<std::string>{"11.2", "11.4"}));
    EXPECT_EQ(report.clusters, (std::vector<std::vector<size_t>>{{pair.authors[0], pair.authors[1]}}));
}

TEST_F(OriginalityTest, MembersOfATeamAreNoPair) {
    ClassFile policy;
    policy.students = {{.student = "jane", .team = "red"}, {.student = "joe", .team = "red"}, {.student = "kim"}};
    std::vector<fs::path> paths = hand_in_right_answers();
    for (const char* name : {"jane", "joe", "kim"}) paths.push_back(hand_in(name, own_answer()));
    const OriginalityReport report = compare_class(paths, {}, lab_11(), policy);
    EXPECT_EQ(report.of_teams, 1u);
    ASSERT_EQ(report.pairs.size(), 2u);
    for (const SimilarPair& pair : report.pairs) EXPECT_EQ(report.authors[pair.authors[1]].name, "kim");
}

TEST_F(OriginalityTest, MarkedLinesAreThoseOfTheCopy) {
    const OriginalityReport report =
        compare_class({hand_in("a", own_answer()), hand_in("b", copied_answer())}, {}, lab_11());
    ASSERT_EQ(report.pairs.size(), 1u);
    for (const SharedTask& task : report.pairs.front().tasks) {
        if (task.task != "11.4") continue;
        const std::string text = own_answer();
        const auto line_of = [&](const std::string& words) {
            return 1 + int(std::count(text.begin(), text.begin() + long(text.find(words)), '\n'));
        };
        const auto has_line = [&](int line) {
            const auto& lines = task.sides[0].lines;
            return std::any_of(lines.begin(), lines.end(),
                               [&](const auto& range) { return range.first <= line && line <= range.second; });
        };
        EXPECT_TRUE(has_line(line_of("float middle = b.before")));
        EXPECT_TRUE(has_line(line_of("moved_right = true, moved_left")));
        EXPECT_FALSE(has_line(line_of("float crossing(")));
    }
}

TEST_F(OriginalityTest, AStarterSharesNothing) {
    const OriginalityReport report =
        compare_class({hand_in("a", starter()), hand_in("b", starter()), hand_in("c", own_answer())}, {}, lab_11());
    EXPECT_TRUE(report.pairs.empty());
    for (const ComparedTask& task : report.tasks) EXPECT_EQ(task.texts, 1u) << task.id;
}

TEST_F(OriginalityTest, ThreeCopiesAreOneCluster) {
    std::vector<fs::path> paths = hand_in_right_answers();
    for (const char* name : {"a", "b", "c"}) paths.push_back(hand_in(name, own_answer()));
    const OriginalityReport report = compare_class(paths, {}, lab_11());
    EXPECT_EQ(report.pairs.size(), 3u);
    ASSERT_EQ(report.clusters.size(), 1u);
    EXPECT_EQ(report.clusters[0].size(), 3u);
}

TEST_F(OriginalityTest, AnEarlierClassIsComparedWithThisOneOnly) {
    const std::vector<fs::path> paths = {hand_in("now/jane", copied_answer()), hand_in("now/joe", solution())};
    hand_in("2026/kim", own_answer());
    hand_in("2026/lee", own_answer());
    const OriginalityReport report = compare_class(paths, {folder_.path() / "2026"}, lab_11());
    EXPECT_EQ(report.compared, 1u + 2u * 2u);
    ASSERT_EQ(report.pairs.size(), 2u);
    for (const SimilarPair& pair : report.pairs) {
        EXPECT_EQ(report.authors[pair.authors[0]].name, "jane");
        EXPECT_TRUE(report.authors[pair.authors[1]].is_earlier);
        EXPECT_TRUE(report.authors[pair.authors[1]].name.starts_with("2026/"));
    }
    EXPECT_THROW(compare_class(paths, {folder_.path() / "none"}, lab_11()), UsageError);
    EXPECT_THROW(compare_class(paths, {folder_.path() / "now"}, lab_11()), UsageError) << "the class itself";
    EXPECT_THROW(compare_class({paths[0]}, {}, lab_11()), UsageError) << "nothing to compare";
}

TEST_F(OriginalityTest, BrokenFilesAreNamedAndHideNoPair) {
    std::string bytes;
    for (int i = 0; i < 5000; ++i) bytes += char(i * 7 % 256);
    std::string endless;
    for (int i = 0; i < 30'000; ++i) endless += "x + ";
    make_folder(folder_.path() / "empty");
    folder_.write("torn.zip", "PK\3\4 this is no archive");
    const std::vector<fs::path> paths = {hand_in("author", own_answer()),
                                         hand_in("copy", copied_answer()),
                                         hand_in("bytes", bytes),
                                         hand_in("endless", "float crossing(float before, float after) {\n" + endless),
                                         hand_in("unclosed", replaced(solution(), "float texels =", "{{{(((")),
                                         hand_in("huge", std::string(2 << 20, 'x')),
                                         hand_in("nothing", ""),
                                         folder_.path() / "empty",
                                         folder_.path() / "torn.zip"};
    const OriginalityReport report = compare_class(paths, {}, lab_11());
    ASSERT_FALSE(report.pairs.empty());
    EXPECT_EQ(report.authors[report.pairs[0].authors[1]].name, "copy");
    const auto problem = [&](const std::string& name) {
        const auto one = std::find_if(report.authors.begin(), report.authors.end(),
                                      [&](const Author& author) { return author.name == name; });
        return one->problems.empty() ? "" : one->problems.front();
    };
    EXPECT_NE(problem("endless").find("more than 20000 tokens"), std::string::npos);
    EXPECT_NE(problem("huge").find("larger than 1 MiB"), std::string::npos);
    EXPECT_EQ(problem("empty"), "there is no task file in it");
    EXPECT_NE(problem("torn"), "");
    EXPECT_EQ(problem("author"), "");
}

TEST_F(OriginalityTest, FilesNameThePairAndEscapeNames) {
    const OriginalityReport report =
        compare_class({hand_in("=evil()", own_answer()), hand_in("<b>bold", copied_answer())}, {}, lab_11());
    const std::string csv = originality_csv(report), page = pages::originality_page(report);
    EXPECT_NE(csv.find("'=evil()"), std::string::npos);
    EXPECT_EQ(page.find("<b>bold"), std::string::npos);
    EXPECT_NE(page.find("&lt;b&gt;bold"), std::string::npos);
    EXPECT_NE(page.find("A person decides."), std::string::npos);
    const auto json = nlohmann::json::parse(originality_json(report));
    EXPECT_EQ(json.at("schema"), 1);
    EXPECT_EQ(json.at("pairs").at(0).at("submissions").at(0), "=evil()");
    EXPECT_EQ(json.at("clusters").size(), 1u);
    EXPECT_NE(originality_table(report).find("=evil()"), std::string::npos);
}

TEST_F(OriginalityTest, ShortTasksAreNamed) {
    const OriginalityReport report =
        compare_class({hand_in("a", own_answer()), hand_in("b", solution())}, {}, lab_11());
    std::map<std::string, bool> is_too_short;
    for (const ComparedTask& task : report.tasks) is_too_short[task.id] = task.is_too_short;
    EXPECT_TRUE(is_too_short.at("11.3"));
    EXPECT_FALSE(is_too_short.at("11.4"));
}

// The known solutions of a task are right answers that nobody has copied. Each is one submission of its lab's class.
TEST_F(OriginalityTest, TheCoursesOwnVariantsAreNoPairs) {
    for (const LabEntry& lab : registry()) {
        std::vector<fs::path> paths;
        const Manifest manifest = load_manifest(lab);
        for (const EquivalentInfo& variant : manifest.equivalents)
            for (const auto& [file, text] : edited(variant.edits))
                paths.push_back(hand_in(lab.folder + "/" + variant.id, text, file));
        std::sort(paths.begin(), paths.end());
        paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
        if (paths.size() < 2) continue;
        const OriginalityReport report = compare_class(paths, {}, {&lab});
        EXPECT_TRUE(report.pairs.empty()) << originality_table(report);
    }
}

TEST(BitsOfCopy, AWayThatManyGoGivesNone) {
    const std::vector<double> weights(20, 0.5);
    const Having all(20, true), none(20, false);
    std::vector<const Having*> others(30, &none);
    EXPECT_GT(bits_of_copy(weights, all, others), 20) << "nobody else has any of it";
    for (size_t i = 0; i < 10; ++i) others[i] = &all;
    EXPECT_LT(bits_of_copy(weights, all, others), 2) << "a third of the others have all of it: log2(3) and a little";
    EXPECT_LT(bits_of_copy(weights, none, others), 0) << "nothing is shared";
}

TEST(BitsOfCopy, OneOfAnotherWayGivesMoreTheRarerItIs) {
    const std::vector<double> weights(20, 0.5);
    const Having all(20, true), none(20, false);
    std::vector<const Having*> others(200, &none);
    double before = 1e9;
    for (const size_t count : {0, 1, 4, 20, 100}) {
        for (size_t i = 0; i < count; ++i) others[i] = &all;
        const double bits = bits_of_copy(weights, all, others);
        EXPECT_LT(bits, before) << count;
        before = bits;
    }
}

}  // namespace
}  // namespace relief::grade
