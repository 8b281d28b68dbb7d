// Fingerprints of a task's code.
#include "framework/staff/originality/winnowing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support.h"

namespace relief::grade {
namespace {

const std::string starter =
    "struct Ray { vec2 uv, march; };\nconst int secant = 3;\n"
    "// TASK 1.1 (2 points): a\nfloat gap(sampler2D heights, Ray ray, float t) {\n    return unfinished(0.0);\n}\n"
    "// TASK 1.2: b\nfloat sum(float a, int method) {\n    return unfinished(a);\n}\n";

const std::string answer =
    "struct Ray { vec2 uv, march; };\nconst int secant = 3;\n"
    "// TASK 1.1 (2 points): a\nfloat gap(sampler2D heights, Ray ray, float t) {\n"
    "    vec2 place = ray.uv + t * ray.march;\n    float surface = texture(heights, place).r;\n"
    "    return 1.0 - t - surface;\n}\n"
    "// TASK 1.2: b\nfloat half_of(float x) { return 0.5 * x; }\nfloat sum(float a, int method) {\n"
    "    return method == secant ? half_of(a) : a;\n}\n";

GivenNames given_names() {
    GivenNames names;
    names.add(starter);
    return names;
}

std::map<std::string, TaskCode> parts_of(const std::string& text) {
    return code_by_task(text, tasks_of_functions(starter), given_names());
}

std::string normal_text(const std::string& text, const std::string& task = "1.1") {
    std::map<std::string, TaskCode> parts = parts_of(text);
    std::string all;
    for (const NormalToken& token : parts[task].tokens) all += token.text + ' ';
    return all;
}

std::set<uint64_t> fingerprints(const std::vector<NormalToken>& tokens, const Grams& given = {}) {
    std::set<uint64_t> hashes;
    for (const CodeFingerprint& one : winnow(gram_hashes(tokens), given)) hashes.insert(one.hash);
    return hashes;
}

std::vector<NormalToken> random_tokens(std::mt19937& random, size_t count, int kinds) {
    std::vector<NormalToken> tokens;
    for (size_t i = 0; i < count; ++i) tokens.push_back({std::to_string(random() % unsigned(kinds)), i, i + 1});
    return tokens;
}

bool have_common_fingerprint(const std::set<uint64_t>& a, const std::set<uint64_t>& b) {
    return std::any_of(a.begin(), a.end(), [&](uint64_t hash) { return b.contains(hash); });
}

TEST(Winnowing, FindsEveryEqualRunOfTheGuaranteedLength) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const auto shared = random_tokens(random, guaranteed_tokens, 5);
        std::set<uint64_t> found[2];
        for (int side = 0; side < 2; ++side) {
            // Tokens from 100 on do not occur in the shared run, so nothing else is equal.
            auto text = random_tokens(random, random() % 30, 4), after = random_tokens(random, random() % 30, 4);
            for (NormalToken& token : text) token.text += side ? "01" : "02";
            for (NormalToken& token : after) token.text += side ? "03" : "04";
            text.insert(text.end(), shared.begin(), shared.end());
            text.insert(text.end(), after.begin(), after.end());
            found[side] = fingerprints(text);
        }
        EXPECT_TRUE(have_common_fingerprint(found[0], found[1])) << "trial " << trial;
    }
}

TEST(Winnowing, FindsNoRunShorterThanAGram) {
    std::mt19937 random(2);
    const auto shared = random_tokens(random, gram_tokens - 1, 5);
    auto a = random_tokens(random, 40, 100), b = random_tokens(random, 40, 100);
    for (NormalToken& token : a) token.text += "a";
    for (NormalToken& token : b) token.text += "b";
    a.insert(a.begin() + 20, shared.begin(), shared.end());
    b.insert(b.begin() + 10, shared.begin(), shared.end());
    EXPECT_FALSE(have_common_fingerprint(fingerprints(a), fingerprints(b)));
}

TEST(Winnowing, TakesAboutTwoOfFiveGrams) {
    std::mt19937 random(3);
    const auto tokens = random_tokens(random, 10'000, 1000);
    EXPECT_NEAR(double(winnow(gram_hashes(tokens), {}).size()), 10'000 * 2.0 / (window_grams + 1), 200)
        << "the density of winnowing is 2 / (w + 1)";
}

TEST(Winnowing, SeesNeitherNewNamesNorCommentsNorLayoutNorSpellings) {
    std::string other = replaced(replaced(replaced(answer, "place", "p2"), "ray", "r"), "heights", "map");
    other = replaced(replaced(other, "surface", "h"), "1.0 - t", "1. /* top */ -\n\n\tt // down\n");
    other = replaced(replaced(other, ").r;", ").x;"), "struct Ray { vec2 uv, march; };",
                     "struct Ray { vec2 uv, march; };\n");
    ASSERT_NE(other, answer);
    EXPECT_EQ(normal_text(other), normal_text(answer));
    EXPECT_EQ(normal_text(replaced(answer, "1.0", "1.0f")), normal_text(answer));
}

TEST(Winnowing, SeesAnotherConstantFunctionFieldAndOperator) {
    for (const auto& [from, to] : {std::pair("1.0 -", "2.0 -"),
                                   {"texture(", "textureLod("},
                                   {"ray.uv", "ray.march"},
                                   {"t * ray", "t + ray"},
                                   {").r", ").g"}})
        EXPECT_NE(normal_text(replaced(answer, from, to)), normal_text(answer)) << from;
    EXPECT_NE(normal_text(replaced(answer, "method == secant", "method == mine"), "1.2"), normal_text(answer, "1.2"));
}

TEST(Winnowing, KeepsMostFingerprintsWhenStatementsChangePlaces) {
    const std::string a = "vec3 a = normalize(cross(b, c)) * 2.0;\n", b = "float d = dot(e, f) + max(g, 0.25) * 3.0;\n",
                      c = "vec2 h = textureSize(m, 0) / vec2(4.0, 5.0);\n";
    const auto first = fingerprints(normal_tokens(a + b + c, {})), second = fingerprints(normal_tokens(c + a + b, {}));
    size_t common = 0;
    for (const uint64_t hash : first) common += second.contains(hash);
    EXPECT_GE(2 * common, first.size());
    EXPECT_LT(common, first.size()) << "the borders of the statements have changed";
}

TEST(Winnowing, OfTheStarterNothingIsLeft) {
    Grams given;
    for (const auto& [task, code] : parts_of(starter))
        for (const uint64_t hash : gram_hashes(code.tokens)) given.insert(hash);
    for (const auto& [task, code] : parts_of(starter)) EXPECT_TRUE(fingerprints(code.tokens, given).empty()) << task;
    for (const auto& [task, code] : parts_of(answer)) EXPECT_FALSE(fingerprints(code.tokens, given).empty()) << task;
}

// Otherwise a window whose smallest hash is of the starter would hide its other grams.
TEST(Winnowing, FindsARunBesideCodeOfTheStarter) {
    std::mt19937 random(4);
    for (int trial = 0; trial < 500; ++trial) {
        const auto tokens = random_tokens(random, guaranteed_tokens, 50);
        const std::vector<uint64_t> grams = gram_hashes(tokens);
        Grams given(grams.begin(), grams.end());
        given.erase(grams[random() % grams.size()]);
        EXPECT_EQ(winnow(grams, given).size(), 1u);
    }
}

TEST(Winnowing, AFunctionBelongsToItsTaskWithoutTheTasksLineAndElsewhere) {
    std::string unmarked = replaced(replaced(answer, "// TASK 1.1 (2 points): a\n", ""), "// TASK 1.2: b\n", "");
    for (const std::string task : {"1.1", "1.2"}) {
        const std::string with_text_above = normal_text(unmarked, task);
        EXPECT_TRUE(with_text_above.ends_with(normal_text(answer, task))) << with_text_above;
    }
    const size_t second = answer.find("// TASK 1.2"), first = answer.find("// TASK 1.1");
    const std::string turned = answer.substr(0, first) + answer.substr(second) + answer.substr(first, second - first);
    EXPECT_EQ(normal_text(turned, "1.2"), normal_text(answer, "1.2"));
}

TEST(Winnowing, SplitsCppInsideANamespace) {
    const std::string file =
        "#include \"task.h\"\nnamespace relief::planet {\n// TASK 9.6: a\ndouble split(double e) { unfinished(); }\n"
        "// TASK 9.7: b\nbool hidden(double e) { unfinished(); }\n}  // end\n";
    const auto tasks = tasks_of_functions(file);
    EXPECT_EQ(tasks, (std::map<std::string, std::string>{{"split", "9.6"}, {"hidden", "9.7"}}));
    EXPECT_EQ(code_by_task(file, tasks, {}).at("9.7").pieces.size(), 1u);
}

TEST(Winnowing, PiecesAndTokensAreRangesOfTheFile) {
    for (const auto& [task, code] : parts_of(answer)) {
        ASSERT_FALSE(code.tokens.empty());
        EXPECT_EQ(code.pieces.front().begin, code.tokens.front().begin);
        EXPECT_EQ(code.pieces.back().end, code.tokens.back().end);
        EXPECT_EQ(answer[code.pieces.back().end - 1], '}');
    }
}

}  // namespace
}  // namespace relief::grade
