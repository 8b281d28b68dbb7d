// Labs 06 and 01: equal pictures, and resources that must not be loaded.
#include "framework/core/gl/program.h"
#include "framework/core/gl/texture.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

std::vector<Knob> one(std::vector<Knob> knobs) {
    knobs.emplace_back("view", "one");
    return knobs;
}
Image picture(std::vector<Knob> knobs, const Orbit* camera = nullptr) {
    Shot shot = shot_of("06", one(std::move(knobs)), "", {160, 160});
    if (camera) shot.camera = *camera;
    return drawn("06", shot);
}

// One step of 8 bits: each of the two methods rounds once.
TEST(TangentSpace, WorldAndTangentSpaceLightingAgree) {
    for (const char* shape : {"sphere", "column", "wall"})
        expect_same_picture(picture({{"shape", shape}}), picture({{"shape", shape}, {"light_in", "tangent"}}), 1, 8);
}

// The inverse transpose of a product is the product of the inverse transposes, up to the last bits.
TEST(TangentSpace, AMatrixProductAndSuccessiveMatricesGiveTheSameNormals) {
    for (const char* scale : {"0.5", "-1.5"}) {
        std::vector<Knob> knobs = {{"rotate", "50"}, {"scale_y", scale}, {"strength", "0"}};
        const Shot product = shot_of("06", one(knobs), "normal");
        knobs.emplace_back("order", "one-by-one");
        const Shot in_turn = shot_of("06", one(knobs), "normal");
        const double off =
            summarize(error_image(drawn("06", product), drawn("06", in_turn), ErrorMetric::angle)).largest;
        EXPECT_LT(off, 1e-4) << scale;
        EXPECT_GT(off, 0) << "two ways of rounding";
    }
}

TEST(TangentSpace, AFlatMapEqualsNoMap) {
    for (const char* shape : {"sphere", "column", "wall"}) {
        const Image none = picture({{"shape", shape}, {"normals", "vertices"}});
        expect_same_picture(picture({{"shape", shape}, {"map", "one-texel"}}), none, 1, 0);
        expect_same_picture(picture({{"shape", shape}, {"strength", "0"}}), none, 1, 0);
    }
    // Lab 01 does not normalize its vertex normals before it adds them.
    const Image vertices = drawn("01", shot_of("01", {{"method", "vertex-normal"}}));
    expect_same_picture(drawn("01", shot_of("01", {{"method", "normal-map"}, {"strength", "0"}})), vertices, 1, 8);
}

// The cube covers the same pixels before and after a turn by 90 degrees about the vertical.
TEST(TangentSpace, NormalsLeftInTheModelsSpaceAreThoseOfAnotherSideOfATurnedCube) {
    constexpr int side = 96;
    const Shot shot = shot_of("06", {{"view", "turned"}, {"strength", "0"}}, "normal", {3 * side, side});
    const Image normals = drawn("06", shot);
    int sides = 0, tops = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto normal = [&](int tile) {
                const float* const value = normals.pixel(tile * side + x, y);
                return glm::vec3(value[0], value[1], value[2]);
            };
            const glm::vec3 made = normal(0), turned = normal(1), left = normal(2);
            if (made.x == no_surface) continue;
            EXPECT_LT(glm::distance(made, turned), 1e-5f);
            const bool is_top = std::abs(turned.y) > 0.5f;
            EXPECT_NEAR(glm::dot(turned, left), is_top ? 1 : 0, 1e-5);
            ++(is_top ? tops : sides);
        }
    EXPECT_GT(sides, 1000);
    EXPECT_GT(tops, 100);
}

TEST(TangentSpace, TheMapOfATurnedCubeHasTheExactNormals) {
    Shot shot = shot_of("06", {{"view", "turned"}}, "normal", {288, 96});
    shot.camera = {.yaw = 20, .pitch = 10, .distance = 0.3, .target = {0.1, 0, 0.65}};
    const auto lab = make_lab(find_lab("06"), shot);
    Image normals = render_shot(*lab, shot), exact = *find_truth(*lab, shot);
    for (Image* image : {&normals, &exact})  // the third cube is wrong
        for (int y = 0; y < 96; ++y) std::fill_n(image->pixel(192, y), size_t(4 * 96), no_surface);
    EXPECT_LT(summarize(error_image(normals, exact, ErrorMetric::angle)).mean, 3)
        << "8 bits, and filtering; a wrong side costs 20";
}

TEST(TangentSpace, TurningModelLightAndCameraTogetherChangesNothing) {
    Orbit camera = load_manifest(find_lab("06")).camera;
    const Image before = picture({{"light_yaw", "-40"}}, &camera);
    camera.yaw += 70;
    // Edges of triangles and of texel footprints move by a rounding error.
    expect_same_picture(picture({{"light_yaw", "30"}, {"rotate", "70"}}, &camera), before, 2, 160 * 160 / 200);
}

TEST(TangentSpace, TheMirroredHalfOfTheWallIsLitLikeTheOther) {
    Orbit camera = load_manifest(find_lab("06")).camera;
    camera.yaw = 0;
    const Image wall = picture({{"shape", "wall"}, {"turn", "0"}, {"light_yaw", "0"}}, &camera);
    Image mirrored = wall;
    for (int y = 0; y < wall.height; ++y)
        for (int x = 0; x < wall.width; ++x) std::copy_n(wall.pixel(wall.width - 1 - x, y), 3, mirrored.pixel(x, y));
    // Samples within a pixel are not mirrored, so the outline and sharp edges may differ.
    const Difference off = difference(wall, mirrored, 24.0 / 255);
    EXPECT_LT(off.pixels_over, wall.pixel_count() / 100) << off.largest * 255;
    expect_same_picture(wall, mirrored, 8, wall.pixel_count() / 12);
}

TEST(TangentSpace, TheMirroredHalfHasMirroredNormals) {
    Shot shot = shot_of("06", one({{"shape", "wall"}, {"turn", "0"}}), "normal", {128, 128});
    shot.camera.yaw = 0;
    const Image normals = drawn("06", shot);
    Image mirrored = normals;
    for (int y = 0; y < normals.height; ++y)
        for (int x = 0; x < normals.width; ++x) {
            std::copy_n(normals.pixel(normals.width - 1 - x, y), 4, mirrored.pixel(x, y));
            if (mirrored.pixel(x, y)[0] != no_surface) mirrored.pixel(x, y)[0] *= -1;
        }
    const ErrorSummary off = summarize(error_image(normals, mirrored, ErrorMetric::angle));
    EXPECT_GT(off.count, normals.pixel_count() / 4);
    // Pixel centres are mirrored. Mip levels are not, because they depend on the neighbours in a quad.
    EXPECT_LT(off.mean, 0.05);
}

TEST(TangentSpace, AScaleOfAMillionOrAMillionthLooksTheSame) {
    const auto normals = [&](const char* size, double factor) {
        Shot shot = shot_of("06", one({{"size", size}}), "normal", {64, 64});
        shot.camera.distance *= factor;
        return drawn("06", shot);
    };
    const Image usual = normals("0", 1);
    for (const auto& [size, factor] : {std::pair("6", 1e6), std::pair("-6", 1e-6)})
        EXPECT_LT(summarize(error_image(normals(size, factor), usual, ErrorMetric::angle)).mean, 0.05) << size;
}

TEST(TangentSpace, WithoutAMapUsesNoTangentSamplerOrTexture) {
    const Programs programs{"06_tangent_space/surface.vert", "06_tangent_space/surface.frag"};
    const Program& plain = programs.with();
    const Program& mapped = programs.with("NORMAL_MAP");
    for (const char* attribute : {"a_tangent", "a_uv"}) {
        EXPECT_EQ(glGetAttribLocation(plain, attribute), -1) << attribute;
        EXPECT_GE(glGetAttribLocation(mapped, attribute), 0) << attribute;
    }
    for (const char* uniform : {"s_normals", "u_strength", "u_turn"})
        EXPECT_EQ(glGetUniformLocation(plain, uniform), -1) << uniform;
    EXPECT_EQ(glGetUniformLocation(mapped, "u_turn"), -1) << "nothing is turned";
    EXPECT_GE(glGetUniformLocation(programs.with({"NORMAL_MAP", "TURNED"}), "u_turn"), 0);

    const auto bytes = [](const char* lab, std::vector<Knob> knobs) {
        return work_of(lab, shot_of(lab, std::move(knobs), "", {64, 64})).texture_bytes;
    };
    EXPECT_EQ(bytes("06", one({{"normals", "vertices"}})), 0);
    // 1024 x 1024 texels of 3 bytes, and a third of that for the other mip levels.
    EXPECT_NEAR(double(bytes("06", one({{"normals", "map"}}))), 3.0 * 1024 * 1024 * 4 / 3, 16);
    // The columns have an albedo map; a normal map each for columns and floor is added. The floor's albedo map, which
    // lab 01 makes by hand, is not counted.
    EXPECT_EQ(bytes("01", {{"method", "normal-map"}}), 3 * bytes("01", {{"method", "vertex-normal"}}));
}

TEST(TangentSpace, BumpsWithoutATangentHaveNoExactNormal) {
    for (const char* trouble : {"along-normal", "missing"})
        for (const char* strength : {"0", "1"}) {
            const Shot shot = shot_of("06", {{"view", "one"}, {"trouble", trouble}, {"strength", strength}}, "normal");
            EXPECT_EQ(find_truth(*make_lab(find_lab("06"), shot), shot).has_value(), strength[0] == '0') << trouble;
        }
}

}  // namespace
}  // namespace relief
