// Faults in a C++ task end only their own checks, and `relief check` says what happened, in which task and line.
#include <gtest/gtest.h>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/check/expectation.h"
#include "tests/labs/task_variant.h"
#include "tests/support.h"

namespace relief {
namespace {

const std::string task_file = "labs/05_tangent_basis/task.cpp";

std::vector<VariantCheck> check_with(const std::vector<std::pair<std::string, std::string>>& begins) {
    const LabEntry& lab = find_lab("5");
    const Manifest manifest = load_manifest(lab);
    std::string text = read_file(course_root() / task_file);
    for (const auto& [function, statement] : begins) {
        const size_t body = text.find("{\n", text.find(function));
        EXPECT_NE(body, std::string::npos) << function;
        text.insert(body + 1, " " + statement);  // keeps the lines' numbers
    }
    Expectations expected;
    for (const CheckInfo& check : manifest.checks)
        if (!check.hidden) expected[check.name] = check::expectation(lab, check);
    return check_variant(lab, {{task_file, text}, {"labs/05_tangent_basis/staff/grading.toml", ""}}, expected,
                         VariantProgram::finds_faults);
}

std::string place_of(const std::string& function) {
    const std::string text = read_file(course_root() / task_file);
    const auto end = text.begin() + std::ptrdiff_t(text.find(function));
    return task_file + ":" + std::to_string(std::count(text.begin(), end, '\n') + 1);
}

TEST(FaultsInCpp, AreNamedWithTheirLineAndLeaveAllOtherChecks) {
#ifdef RELIEF_SANITIZED
    GTEST_SKIP() << "this build has no program for checks of its own";
#endif
    const std::string solve = "FaceBasis solve(", weight = "double corner_weight(", frame = "vertex_tangent(";
    const std::vector<VariantCheck> checks = check_with(
        {{solve,
          "if (const auto* volatile none = static_cast<const Triangle*>(nullptr); none->uv[0].x > 0) return {};"},
         {weight,
          "const glm::dvec3* volatile all = new glm::dvec3[3]; [[maybe_unused]] const volatile double beyond = "
          "all[3].x;"},
         {frame, "for (volatile int i = 0;; i = i + 1) {}"}});
    std::set<std::string> seen;
    for (const VariantCheck& check : checks) {
        SCOPED_TRACE(check.name + ": " + check.outcome + ", " + check.found + ", " + check.look_at);
        if (check.task == "5.4") {
            EXPECT_EQ(check.outcome, "passed") << "a shader has none of these faults";
        }
        if (check.name == "the words of task 5.1") {
            EXPECT_EQ(check.outcome, "crashed");
            EXPECT_TRUE(contains(check.found, place_of(solve) + ": uses a null pointer"));
        } else if (check.name == "the words of task 5.2") {
            EXPECT_EQ(check.outcome, "passed") << "what was read has no effect";
            EXPECT_TRUE(contains(check.found, place_of(weight) + ": reads or writes outside of an array"));
        } else if (check.name == "the words of task 5.3") {
            EXPECT_EQ(check.outcome, "out_of_time");
            EXPECT_TRUE(contains(check.found, "does a loop of task 5.3 not end?"));
            EXPECT_TRUE(contains(check.found, place_of(frame) + " was running"));
        } else {
            continue;
        }
        seen.insert(check.name);
    }
    EXPECT_EQ(seen.size(), 3u);
}

TEST(FaultsInCpp, AnExceptionIsTheResultOfItsCheck) {
    const std::vector<VariantCheck> checks =
        check_with({{"double corner_weight(", "if (corner >= 0) throw std::exception();"}});
    for (const VariantCheck& check : checks) {
        if (check.task == "5.4") {
            EXPECT_EQ(check.outcome, "passed") << check.name << check.found;
        }
        if (check.name != "the words of task 5.2") continue;
        EXPECT_EQ(check.outcome, "broken") << check.found;
        EXPECT_TRUE(contains(check.found, "exception: std::exception")) << check.found;
    }
}

}  // namespace
}  // namespace relief
