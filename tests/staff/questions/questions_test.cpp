// Questions about students' code: the choice of pixels, calls, pictures and questions. Draws nothing.
#include "framework/staff/questions/questions.h"

#include <set>

#include "framework/staff/questions/mistake_riddles.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

check::LoneCall call_with(std::vector<float> inputs, std::vector<float> results, std::vector<float> again) {
    check::LoneCall call;
    call.inputs = std::move(inputs), call.results = std::move(results), call.again = std::move(again);
    return call;
}

TEST(Questions, ACallTellsSomethingIfItsResultMustBeComputed) {
    EXPECT_TRUE(is_telling(call_with({0.031F, -0.012F}, {0.7209F}, {0.7210F})));
    EXPECT_FALSE(is_telling(call_with({0.3F}, {0}, {0}))) << "0";
    EXPECT_FALSE(is_telling(call_with({0.3F}, {1, 0, 0}, {1, 0, 0}))) << "an axis";
    EXPECT_FALSE(is_telling(call_with({0.3F}, {0.99999F, 0.00001F}, {1, 0}))) << "an axis, as it is shown";
    EXPECT_FALSE(is_telling(call_with({0.5F, 0.3F, 0.7F}, {0.3F, 0.7F}, {0.3F, 0.7F}))) << "two arguments";
    EXPECT_FALSE(is_telling(call_with({0.5F, 0.3F}, {0.301F}, {0.301F}))) << "an argument within the margin";
}

TEST(Questions, ACallWhoseRoundedArgumentsGiveAnotherResultIsNotAsked) {
    EXPECT_FALSE(is_telling(call_with({0.031F, -0.012F}, {0.7209F}, {0.7309F})));
    EXPECT_FALSE(is_telling(call_with({0.031F, -0.012F}, {0.7209F}, {NAN})));
}

/// Returns a picture of one colour with some columns of another.
Image striped(int width, int height, int from, int to, float value) {
    Image image(width, height, 3, 8);
    for (int y = 0; y < height; ++y)
        for (int x = from; x < to; ++x)
            for (int i = 0; i < 3; ++i) image.pixel(x, y)[i] = value;
    return image;
}

TEST(Questions, PixelsOfAPictureAreNoBackground) {
    const Image drawn = striped(40, 20, 10, 30, 0.5F);
    const auto pixels = telling_pixels(drawn, nullptr, nullptr, 50, "x");
    EXPECT_EQ(pixels.size(), 50U);
    for (const glm::ivec2 pixel : pixels) EXPECT_TRUE(pixel.x >= 10 && pixel.x < 30 && pixel.y >= 2 && pixel.y < 18);
    EXPECT_EQ(pixels, telling_pixels(drawn, nullptr, nullptr, 50, "x"));
    EXPECT_NE(pixels, telling_pixels(drawn, nullptr, nullptr, 50, "y"));
    EXPECT_TRUE(telling_pixels(striped(40, 20, 0, 0, 0), nullptr, nullptr, 50, "x").empty());
}

TEST(Questions, PixelsOfAFailedCheckAreWrongThere) {
    Image drawn = striped(40, 20, 10, 30, 0.5F);
    const Image expected = striped(40, 20, 10, 20, 0.5F);
    for (int y = 0; y < 20; ++y) drawn.pixel(5, y)[1] = 0.1F;  // wrong, but by less than half
    for (const glm::ivec2 pixel : telling_pixels(drawn, &expected, nullptr, 50, "x"))
        EXPECT_TRUE(pixel.x >= 20 && pixel.x < 30);
    EXPECT_FALSE(telling_pixels(drawn, &expected, nullptr, 50, "x").empty());
    EXPECT_TRUE(telling_pixels(expected, &expected, nullptr, 50, "x").empty());
}

TEST(Questions, PixelsOfAProbeHaveASurfaceAndAWrittenTask) {
    Image drawn(10, 10, 4);
    for (int x = 0; x < 10; ++x)
        for (int y = 0; y < 10; ++y)
            for (int i = 0; i < 4; ++i) drawn.pixel(x, y)[i] = x < 4 ? no_surface : x < 6 ? not_written : 0.5F;
    const ProbeInfo probe{.name = "height", .unit = ""};
    const auto pixels = telling_pixels(drawn, nullptr, &probe, 50, "x");
    EXPECT_EQ(pixels.size(), 2U * 6U);
    for (const glm::ivec2 pixel : pixels) EXPECT_GE(pixel.x, 6);
}

TEST(Questions, PicturesDifferByFivePercentOfTheirPixels) {
    const auto with = [](int columns, float value) { return striped(100, 10, 0, columns, value); };
    // Of five columns by 25/255, five by 24/255, and four by more.
    EXPECT_EQ(distinct_pictures({with(0, 0), with(5, 25.0F / 255), with(5, 24.0F / 255), with(4, 1)}, 4),
              (std::vector<size_t>{0, 1}));
    EXPECT_EQ(distinct_pictures({with(0, 0), with(50, 1), with(54, 1), Image(), with(55, 1), with(90, 0.5F)}, 4),
              (std::vector<size_t>{0, 1, 4, 5}));
    EXPECT_EQ(distinct_pictures({with(0, 0), with(20, 1), with(40, 1)}, 2).size(), 2U);
}

TEST(Questions, ChoicesBesideAMistakeHaveOtherPicturesAndOtherHints) {
    const auto with = [](int columns) { return striped(100, 10, 0, columns, 1); };
    const Image right = with(0);
    // The third mistake draws the same as the asked one, the fourth nothing, and the fifth has the second one's hint.
    const std::vector<Image> pictures = {with(20), with(40), with(21), Image(), with(60), with(80), with(10)};
    const std::vector<std::string> hints = {"a", "b", "c", "d", "b", "e", "f"};
    EXPECT_EQ(choices_beside(0, right, pictures, hints), (std::vector<size_t>{0, 1, 5, 6}));
    EXPECT_EQ(choices_beside(3, right, pictures, hints), std::vector<size_t>{}) << "it has no picture";
    EXPECT_EQ(choices_beside(0, with(22), pictures, hints), std::vector<size_t>{}) << "it looks right";
    EXPECT_EQ(choices_beside(0, right, std::span(pictures).first(6), hints), std::vector<size_t>{}) << "only three";
    const std::vector<std::string> alike = {
        "Add a half before floor.", "Adding 1 before floor() rounds.", "c", "d", "b", "e", "f"};
    EXPECT_EQ(choices_beside(0, right, pictures, alike), (std::vector<size_t>{0, 4, 5, 6})) << "without the same words";
    EXPECT_EQ(choices_beside(0, right, std::span(pictures).first(6), alike), (std::vector<size_t>{0, 4, 5, 1}))
        << "with the same words, if there are no others";
}

TEST(Questions, AreChosenInTurnOfKindsAndLabs) {
    const auto of = [](const char* lab, QuestionKind kind, const char* task) {
        Question question;
        question.lab = lab, question.kind = kind, question.task = task;
        return question;
    };
    const std::vector<LabQuestions> labs = {
        {{of("a", QuestionKind::value, "1"), of("a", QuestionKind::value, "2"), of("a", QuestionKind::line, "3")}, {}},
        {{of("b", QuestionKind::picture, "4"), of("b", QuestionKind::value, "5")}, {}}};
    std::string order;
    for (const Question& question : chosen_questions(labs, 9)) order += question.task;
    EXPECT_EQ(order, "15432");
    EXPECT_EQ(chosen_questions(labs, 2).size(), 2U);
}

TEST(Questions, EachMutantOfAStudentsFileChangesOneLine) {
    const std::string text =
        "const float least = 0.5;\n// TASK 1.1: a + b\nfloat f(float a, float b) {\n    float c = max(a,\n"
        "                  b);\n    return a - c;\n}\n";
    std::set<std::string> changes;
    for (const Mutant& mutant : line_mutants_of(text)) {
        EXPECT_EQ(mutant.task, "1.1");
        EXPECT_TRUE(mutant.line == 4 ? mutant.text.ends_with("                  b);\n    return a - c;\n}\n")
                                     : mutant.text.ends_with("    return a + c;\n}\n"));
        changes.insert(std::to_string(mutant.line) + ": " + mutant.was + " -> " + mutant.now);
    }
    EXPECT_EQ(changes, (std::set<std::string>{"4: max -> min", "4: max(a, b) -> ( b)", "6: - -> +"}));
}

}  // namespace
}  // namespace relief::grade
