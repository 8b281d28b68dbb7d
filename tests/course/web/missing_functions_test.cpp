// The functions that the labs get in a browser, compared with OpenGL's.
#include <gtest/gtest.h>

#include <random>

#include "framework/course/web/es_shader.h"
#include "tests/core/gl/fragment_shader.h"
#include "tests/core/gl/glsl_function.h"
#include "tests/support.h"

namespace relief::web {
namespace {

/// Returns the text of a function under another name, `emulated`.
std::string emulation(const std::string& name) {
    for (const MissingFunction& function : missing_functions())
        if (name == function.name) return "#define " + name + " emulated\n" + function.text + "#undef " + name + "\n";
    ADD_FAILURE() << name << " is not among the missing functions";
    return "";
}

/// Numbers of which no two texels are the same, 7 by 5.
Image numbers() {
    Image image(7, 5, 2);
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i) + 1;
    return image;
}

/// Returns the number of values that differ.
int differing(const std::vector<glm::vec4>& some, const std::vector<glm::vec4>& others) {
    int count = 0;
    for (size_t i = 0; i < some.size(); ++i) count += some[i] != others.at(i);
    return count;
}

TEST(MissingFunctions, AGatherReadsTheSameFourTexels) {
    const TemporaryFolder folder;
    const std::string file = folder.write("gather.glsl", emulation("textureGather")).string();
    const Texture map("numbers", numbers, {.mips = false});
    std::mt19937 random(1);
    std::vector<GlslInput> inputs(2000);
    for (GlslInput& input : inputs)
        for (const int axis : {0, 1}) {  // around the middle of a cell of texel centres: GPUs round places to 1/256
            const float texels = axis == 0 ? 7 : 5;
            const float cell = float(int(random() % 40)) - 20, within = 0.01f + 0.98f * float(random() % 1000) / 1000;
            input[0][axis] = (cell + 0.5f + within) / texels;
        }
    for (const char* channel : {"0", "1"}) {
        const std::string arguments = std::string("(s_map, a.xy, ") + channel + ")";
        const auto real = evaluate_glsl(file, "textureGather" + arguments, inputs, {}, &map);
        EXPECT_EQ(differing(real, evaluate_glsl(file, "emulated" + arguments, inputs, {}, &map)), 0) << channel;
        EXPECT_NE(real[0], real[1]);
    }
    EXPECT_EQ(differing(evaluate_glsl(file, "textureGather(s_map, a.xy)", inputs, {}, &map),
                        evaluate_glsl(file, "emulated(s_map, a.xy)", inputs, {}, &map)),
              0);
}

TEST(MissingFunctions, BitsAreTheSame) {
    std::vector<GlslInput> inputs;
    for (const float number : {0.0f, 1.0f, -1.0f, 2.0f, 3.0f, -2.0f, 255.0f, 256.0f, -256.0f, 65535.0f, 16777215.0f,
                               2147483520.0f, -2147483648.0f})
        inputs.push_back({glm::vec4(number)});
    for (const std::string name : {"findMSB", "bitCount"}) {
        const TemporaryFolder folder;
        const std::string file = folder.write("bits.glsl", emulation(name)).string();
        const std::string real = "vec2(" + name + "(int(a.x)), " + name + "(uint(int(a.x))))";
        EXPECT_EQ(differing(evaluate_glsl(file, real, inputs),
                            evaluate_glsl(file, "vec2(emulated(int(a.x)), emulated(uint(int(a.x))))", inputs)),
                  0)
            << name;
    }
}

TEST(MissingFunctions, AMultiplicationIsAddedInEveryWidth) {
    const TemporaryFolder folder;
    const std::string file = folder.write("fma.glsl", emulation("fma")).string();
    const std::vector<GlslInput> inputs = {{glm::vec4(1, 2, -3, 0.5f)}, {glm::vec4(7, -1, 0, 4)}};
    const auto all_widths = [](const std::string& name) {
        return std::vector<std::string>{name + "(a, a.yzwx, a.wzyx)", name + "(a.xyz, a.yzw, a.wzy)",
                                        name + "(a.xy, a.yz, a.wz)", name + "(a.x, a.y, a.z)"};
    };
    for (size_t i = 0; i < 4; ++i) {
        const std::string real = all_widths("fma")[i], ours = all_widths("emulated")[i];
        EXPECT_EQ(differing(evaluate_glsl(file, real, inputs), evaluate_glsl(file, ours, inputs)), 0) << real;
    }
}

// The real function's formula is up to the driver. Mesa's llvmpipe drew the expected pictures.
TEST(MissingFunctions, ALevelIsThatOfLlvmpipe) {
    const Texture map("numbers", [] { return Image(64, 64, 1); }, {.mips = true});
    const std::string text = emulation("textureQueryLod") +
                             "in vec2 v_clip;\n"
                             "uniform float u_scale;\n"
                             "uniform sampler2D s_map;\n"
                             "out vec4 o_levels;\n"
                             "void main() {\n"
                             "    vec2 uv = u_scale * mat2(0.8, 0.6, -0.2, 0.3) * v_clip;\n"
                             "    o_levels = vec4(textureQueryLod(s_map, uv), emulated(s_map, uv));\n"
                             "}\n";
    for (const float scale : {0.5f, 1.0f, 4.0f, 13.0f}) {
        const Image levels = draw_fragments(text, {16, 16}, [&](const Program& program) {
            program.set("u_scale", scale);
            program.set("s_map", 0, map);
        });
        for (size_t i = 0; i < levels.pixel_count(); ++i) {
            const float* const at = &levels.values[i * 4];
            EXPECT_NEAR(at[2], std::max(at[3], 0.0f), 1e-6);
            EXPECT_NEAR(at[3], at[1], 1e-4) << "scale " << scale;
        }
        // The longer derivative is that along x: (0.8, 0.6) times the scale, in a picture 2 wide.
        const float exact = std::log2(scale * 2 / 16 * 64);
        EXPECT_LE(levels.values[3], exact + 1e-4f);
        EXPECT_GE(levels.values[3], exact - 0.044f);
    }
}

}  // namespace
}  // namespace relief::web
