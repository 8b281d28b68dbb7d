// Mutants: each rule changes only the solution.
#include "framework/staff/proof/mutants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace relief::grade {
namespace {

const std::string head = "// TASK 1.1: x + 1\nfloat f(float x) {\n    //[solution\n    ";
const std::string tail = "\n    //]starter\n    //| return 1.0 - x;\n    //]\n}\n";

/// Returns "was -> now" for each mutant of one statement.
std::set<std::string> changes(const std::string& statement) {
    std::set<std::string> all;
    for (const Mutant& mutant : mutants_of(head + statement + tail, "task.glsl")) {
        if (mutant.rule == "output") continue;
        EXPECT_EQ(mutant.task, "1.1");
        EXPECT_EQ(mutant.line, 4);
        EXPECT_TRUE(mutant.text.starts_with(head) && mutant.text.ends_with(tail)) << mutant.text;
        all.insert(mutant.was + " -> " + mutant.now);
    }
    return all;
}
using Changes = std::set<std::string>;

TEST(Mutants, FollowTheRules) {
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

/// Returns "was -> now" for each mutant of a function's outputs.
std::set<std::string> outputs(const std::string& text, const std::string& header = {}) {
    std::set<std::string> all;
    for (const Mutant& mutant : mutants_of(text, "task.glsl", header))
        if (mutant.rule == "output") all.insert(mutant.was + " -> " + mutant.now);
    return all;
}
std::string function(const std::string& signature) {
    return "// TASK 1.1: x\n" + signature + " {\n    // TASK 1.2\n    //[solution\n    return x;\n    //]\n}\n";
}

TEST(Mutants, ReplaceEachComponentOfAResultByZeroOneAndTheNextComponent) {
    EXPECT_EQ(outputs(function("float f(float x)")), (Changes{"f() -> 0.0", "f() -> 1.0"}));
    EXPECT_EQ(outputs(function("bool f()")), (Changes{"f() -> false", "f() -> true"}));
    EXPECT_EQ(outputs(function("glm::dvec2 f(const glm::dvec2& x)")),
              (Changes{"f().x -> 0.0", "f().x -> 1.0", "f().x -> result.y", "f().y -> 0.0", "f().y -> 1.0",
                       "f().y -> result.x"}));
    EXPECT_EQ(outputs(function("mat2x4 f()")).size(), 3u * 8);
    EXPECT_EQ(outputs(function("ivec3 f()")).size(), 3u * 3);
    EXPECT_EQ(outputs(function("Ray f()"), "struct Ray {\n    vec3 a, b;  // c, d\n    float e = 0;\n};").size(),
              3u * 7);
    EXPECT_EQ(outputs(function("glm::Box f()"), "struct Box {\n    glm::dvec3 a{0}, b{0};\n    int e = 0;\n};").size(),
              3u * 6 + 2)
        << "the only whole number has no other part of its type";
    EXPECT_EQ(outputs(function("void f(int x)")), Changes{});
    EXPECT_EQ(outputs("//[solution\nconst float x = 1.5;\n//]\n"), Changes{}) << "no function";
}

TEST(Mutants, RenameTheSolutionToReplaceAnOutput) {
    const std::string text =
        "// TASK 1.1\n//(region\nvec2 f(vec2 x, float y[9],\n       int z) {\n    //[solution\n    return x;\n    "
        "//]\n}\n//)\n";
    const std::vector<Mutant> mutants = mutants_of(text, "task.glsl");
    ASSERT_EQ(mutants.size(), 6u);
    EXPECT_EQ(mutants[0].line, 3);
    EXPECT_EQ(mutants[0].text,
              "// TASK 1.1\n//(region\nvec2 f_(vec2 x, float y[9],\n       int z) {\n    //[solution\n    return x;\n  "
              "  //]\n}\n"
              "vec2 f(vec2 x, float y[9],\n       int z) {\n    vec2 result = f_(x, y, z);\n    result.x = 0.0;\n"
              "    return result;\n}\n//)\n");
}

TEST(Mutants, BelongToTheLastTaskNamedAbove) {
    const std::vector<Mutant> mutants = mutants_of(
        "//[solution\nint a = 1;\n//]\n// TASK 2.1: TASK 2.9 is next\n// TASK 2.10\n//[solution\nint b = 7;\n//]\n",
        "task.cpp");
    ASSERT_EQ(mutants.size(), 4u);
    EXPECT_EQ(mutants[0].task, "2.1") << "before all tasks: the first one's";
    EXPECT_EQ(mutants[2].task, "2.10");
    EXPECT_EQ(mutants[2].line, 7);
}

}  // namespace
}  // namespace relief::grade
