// Mutants: each rule changes the solution, and nothing else.
#include "framework/staff/grade/mutants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace relief {
namespace {

const std::string head = "// TASK 1.1: x + 1\nfloat f(float x) {\n    //[solution\n    ";
const std::string tail = "\n    //]starter\n    //| return 1.0 - x;\n    //]\n}\n";

/// "was -> now" of each mutant of one statement.
std::set<std::string> changes(const std::string& statement) {
    std::set<std::string> all;
    for (const Mutant& mutant : mutants_of(head + statement + tail, "task.glsl")) {
        EXPECT_EQ(mutant.task, "1.1");
        EXPECT_EQ(mutant.line, 4);
        EXPECT_TRUE(mutant.text.starts_with(head) && mutant.text.ends_with(tail)) << mutant.text;
        all.insert(mutant.was + " -> " + mutant.now);
    }
    return all;
}
using Changes = std::set<std::string>;

TEST(Mutants, ComeByRule) {
    EXPECT_EQ(changes("return a + b;"), (Changes{"+ -> -"}));
    EXPECT_EQ(changes("return -a;"), (Changes{"- -> "}));
    EXPECT_EQ(changes("return a < b;"), (Changes{"< -> <=", "< -> >"}));
    EXPECT_EQ(changes("return n.x;"), (Changes{"x -> y", "x -> z"}));
    EXPECT_EQ(changes("return n.xyz;"), (Changes{"xyz -> yxz", "xyz -> zyx"}));
    EXPECT_EQ(changes("return normalize(a);"), (Changes{"normalize(a) -> (a)"}));
    EXPECT_EQ(changes("return std::max(a, b);"),
              (Changes{"std::max(a, b) -> (a)", "std::max(a, b) -> ( b)", "max -> min"}));
    EXPECT_EQ(changes("return cross(a, g(b, c));"), (Changes{"a, g(b, c) -> g(b, c), a", "b, c -> c, b"}));
    EXPECT_EQ(changes("return 2;"), (Changes{"2 -> 3", "2 -> 1"}));
    EXPECT_EQ(changes("return 0.5f;"), (Changes{"0.5f -> 0.55f", "0.5f -> 1.0f", "0.5f -> 0.0f"}));
    EXPECT_EQ(changes("if (a == b) return c;"), (Changes{"a == b -> true", "a == b -> false", "== -> !="}));
    EXPECT_EQ(changes("return c ? a : b;"), (Changes{"? -> && false ?", "? -> || true ?"}));
    EXPECT_EQ(changes("x *= y;"), (Changes{"x *= y; -> ;", "*= -> /="}));
    EXPECT_EQ(changes("float y = x;"), Changes{}) << "a declaration stays";
    EXPECT_EQ(changes("return x;  // a + b"), Changes{}) << "words of a comment stay";
}

TEST(Mutants, BelongToTheTaskThatTheFileNamesLast) {
    const std::vector<Mutant> mutants = mutants_of(
        "//[solution\nint a = 1;\n//]\n// TASK 2.1: TASK 2.9 is next\n// TASK 2.10\n//[solution\nint b = 7;\n//]\n",
        "task.cpp");
    ASSERT_EQ(mutants.size(), 4u);
    EXPECT_EQ(mutants[0].task, "2.1") << "before all tasks: the first one's";
    EXPECT_EQ(mutants[2].task, "2.10");
    EXPECT_EQ(mutants[2].line, 7);
}

}  // namespace
}  // namespace relief
