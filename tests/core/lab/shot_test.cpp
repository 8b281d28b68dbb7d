// The state that a lab gets for a shot, and the requirements on its picture.
#include "framework/core/lab/shot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/core/gl/counters.h"
#include "framework/core/gl/target.h"
#include "framework/core/lab/words.h"
#include "framework/library/kit/labels.h"
#include "tests/support.h"

namespace relief {
namespace {

/// Fills the left half of the frame with one value and leaves the rest to the background.
class LeftHalf final : public Lab {
public:
    explicit LeftHalf(glm::vec4 value) : value_(value) {}
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glViewport(0, 0, frame.size.x, frame.size.y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, frame.size.x / 2, frame.size.y);
        glClearColor(value_.x, value_.y, value_.z, value_.w);
        glClear(GL_COLOR_BUFFER_BIT);
    }

private:
    glm::vec4 value_;
};

/// Draws nothing, and leaves GL in as bad a state as possible.
class BadNeighbour final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        for (const GLenum one :
             {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD, GL_POLYGON_OFFSET_FILL})
            glEnable(one);
        glDisable(GL_DEPTH_TEST);
        glScissor(0, 0, 1, 1);
        glViewport(1, 1, 1, 1);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_NEVER);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        glFrontFace(GL_CW);
        glClearColor(1, 0, 1, 0);
        glActiveTexture(GL_TEXTURE7);
        glClearDepth(0);
        glDepthRange(1, 0);
        for (const GLenum one : {GL_COLOR_LOGIC_OP, GL_DEPTH_CLAMP, GL_SAMPLE_MASK, GL_SAMPLE_ALPHA_TO_COVERAGE})
            glEnable(one);
        glSampleMaski(0, 0);
        glStencilMask(0);
        glStencilFunc(GL_NEVER, 1, 1);
        glPolygonOffset(1, 1);
        glBlendColor(1, 1, 1, 1);
    }
};

class GivesUpHalfway final : public Lab {
public:
    void draw(const Frame& frame) override {
        BadNeighbour().draw(frame);
        throw Error("no such file");
    }
};

class WithGlError final : public Lab {
public:
    void draw(const Frame&) override { glEnable(0xFFFF); }
};

Image take_left_half(glm::vec4 value, Shot shot) {
    LeftHalf lab(value);
    return render_shot(lab, shot);
}

Shot small_shot(Probe probe = {}) {
    Shot shot;
    shot.size = {16, 8};
    shot.probe = std::move(probe);
    return shot;
}
const Shot small = small_shot(), small_probe = small_shot({"normal"});

TEST(Shot, BackgroundOfAProbeIsInfinityInEveryChannel) {
    const Image probe = take_left_half({1, 2, 3, 4}, small_probe);
    ASSERT_EQ(probe.channels, 4);
    for (int c = 0; c < 4; ++c) {
        EXPECT_EQ(probe.pixel(0, 0)[c], float(c + 1));
        EXPECT_EQ(probe.pixel(15, 7)[c], no_surface);
    }
}

TEST(Shot, ANonFiniteProbeIsReportedWithItsPixel) {
    for (const float wrong : {NAN, no_surface, -no_surface}) {
        const std::string message = message_of([&] { take_left_half({0, wrong, 0, 0}, small_probe); });
        EXPECT_TRUE(contains(message, "64 pixels are not finite, the first at column 0, row 0")) << message;
    }
}

TEST(Shot, AProbeOfAMissingTaskIsShownButNotJudged) {
    const Image probe = take_left_half(glm::vec4(not_written), small_probe);
    EXPECT_EQ(pixels_not_written(probe), 64u);
    EXPECT_TRUE(contains(message_of([&] { refuse_unusable(probe, small_probe); }),
                         "64 pixels come from a task that is not written yet"));
}

TEST(Shot, AProbeWithoutAnySurfaceFails) {
    EXPECT_TRUE(contains(message_of([] { take_left_half(glm::vec4(no_surface), small_probe); }), "no surface"));
}

TEST(Shot, APictureOfOneColourFails) {
    LeftHalf half({1, 0, 0, 1});
    EXPECT_NO_THROW(render_shot(half, small));
    const Image background = render_shot(half, small);
    const float* const pixel = background.pixel(15, 0);
    EXPECT_TRUE(contains(message_of([&] { take_left_half({pixel[0], pixel[1], pixel[2], 1}, small); }), "one colour"));
}

TEST(Shot, AGlErrorFailsThePicture) {
    WithGlError lab;
    EXPECT_TRUE(contains(message_of([&] { render_shot(lab, small); }), "GL_INVALID_ENUM"));
}

TEST(Shot, IsIndependentOfTheGlStateOfAnotherLab) {
    BadNeighbour bad;
    const Image before = take_left_half({0, 1, 0, 1}, small);
    EXPECT_THROW(render_shot(bad, small), Error) << "it draws nothing";
    // A lab may enable these tests without setting what they compare, as with a new context.
    const auto integer = [](GLenum name) {
        GLint value = 0;
        glGetIntegerv(name, &value);
        return value;
    };
    const auto number = [](GLenum name) {
        GLfloat value[4] = {};
        glGetFloatv(name, value);
        return value[0];
    };
    EXPECT_EQ(integer(GL_STENCIL_FUNC), GL_ALWAYS);
    EXPECT_NE(integer(GL_STENCIL_WRITEMASK), 0);
    EXPECT_EQ(number(GL_POLYGON_OFFSET_FACTOR), 0);
    EXPECT_EQ(number(GL_BLEND_COLOR), 0);
    const Image after = take_left_half({0, 1, 0, 1}, small);
    EXPECT_EQ(before.values, after.values);
}

TEST(Shot, ALabThatThrowsHalfwayLeavesACleanGlState) {
    GivesUpHalfway lab;
    EXPECT_THROW(render_shot(lab, small), Error);
    for (const GLenum one : {GL_SCISSOR_TEST, GL_BLEND, GL_RASTERIZER_DISCARD}) EXPECT_FALSE(glIsEnabled(one));
    GLboolean mask[4];
    glGetBooleanv(GL_COLOR_WRITEMASK, mask);
    EXPECT_TRUE(mask[0] && mask[3]);
}

/// Its picture shows the time.
class Clock final : public Lab {
public:
    void draw(const Frame& frame) override {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.target);
        glClearColor(float(frame.time), 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
    }
};

TEST(Shot, HandsTheTimeToTheLab) {
    Clock lab;
    Shot shot = small_probe;
    shot.time = 2.5;
    EXPECT_EQ(render_shot(lab, shot).values[0], 2.5f);
}

TEST(Shot, AFloatPictureHoldsLinearLight) {
    LeftHalf lab({0.5f, 1.5f, 0, 1});
    const Image light = render_shot(lab, small, true);
    ASSERT_EQ(light.bits, 32);
    EXPECT_NEAR(light.pixel(0, 0)[0], std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_GT(light.pixel(0, 0)[1], 1.0f) << "nothing is clipped";
}

/// Draws a word over the left half.
class Labelled final : public Lab {
public:
    void draw(const Frame& frame) override {
        LeftHalf({0, 1, 0, 1}).draw(frame);
        labels_.text("word", {1, 1}, 6);
        labels_.draw(frame);
    }

private:
    Labels labels_;
};

TEST(Shot, GivesItsWordsToTheCallerThatTakesThem) {
    Labelled lab;
    const Image plain = take_left_half({0, 1, 0, 1}, small), labelled = render_shot(lab, small);
    EXPECT_NE(labelled.values, plain.values);
    std::vector<PictureWord> words;
    Shot wordless = small;
    wordless.words = &words;
    EXPECT_EQ(render_shot(lab, wordless).values, plain.values);
    ASSERT_EQ(words.size(), 1u);
    EXPECT_EQ(words[0].text, "word");
    EXPECT_EQ(words[0].place, glm::vec2(1.0f / float(small.size.x), 1.0f / float(small.size.y)));
    EXPECT_EQ(render_shot(lab, small).values, labelled.values);
}

TEST(Shot, LeavesNoObjectBehind) {
    const Counters before = counters();
    take_left_half({0, 1, 0, 1}, small);
    EXPECT_EQ(counters().live, before.live);
}

}  // namespace
}  // namespace relief
