// relief golden: passing and failing pictures, and the cases in which it refuses to renew.
#include <regex>

#include "framework/core/image/file.h"
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

class Golden : public testing::Test {
protected:
    CourseCopy course_;
    std::filesystem::path file_ = course_.path() / "labs/01_specular_highlights/golden/close.png";

    /// One picture is enough for these tests.
    void SetUp() override {
        const char* manifest = "labs/01_specular_highlights/lab.toml";
        const std::string text = read_all(course_.path() / manifest);
        course_.overwrite(manifest, text.substr(0, text.find("[[golden]]")) +
                                        "[[golden]]\nname = \"close\"\nshot = { size = [160, 120], set = { method = "
                                        "\"normal-map\" }, camera = { distance = 2.4 } }\n");
        std::filesystem::remove(file_);
    }
    Result golden(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"golden", "01"});
        return course_.relief(more);
    }
    void renew() const {
        const Result result = golden({"--update"});
        ASSERT_EQ(result.code, 0) << result.err;
        ASSERT_EQ(result.out, "01_specular_highlights/close: renewed\n");
    }
    /// Changes the reference: the red of its first pixels by `steps` / 255, and its driver.
    void change_reference(int steps, const std::string& driver, size_t pixels = 1) const {
        Notes notes;
        Image image = read_image(file_, &notes);
        for (size_t i = 0; i < pixels; ++i) {
            float& red = image.values[i * size_t(image.channels)];
            red += (red < 0.5f ? 1.0f : -1.0f) * float(steps) / 255;
        }
        if (!driver.empty()) notes = {{"driver", driver}};
        write_image(file_, image, notes);
    }
};

TEST_F(Golden, AMissingReferenceIsAFailure) {
    const Result result = golden();
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "close.png: no reference: look at the picture, then renew with --update"))
        << result.err;
}

TEST_F(Golden, LooksAtSeveralLabs) {
    renew();
    const Result result = course_.relief({"golden", "1,4"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(result.out.starts_with("01_specular_highlights/close: same within 0/255\n04_object_space/"))
        << result.out;
    EXPECT_FALSE(contains(result.out, "02_")) << result.out;
}

TEST_F(Golden, ARenewedReferenceCarriesItsDriverAndPasses) {
    renew();
    Notes notes;
    read_image(file_, &notes);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_TRUE(contains(notes[0].second, "llvmpipe")) << notes[0].second;
    EXPECT_TRUE(contains(notes[0].second, "pinned to sse4.1")) << notes[0].second;
    EXPECT_EQ(golden().out, "01_specular_highlights/close: same within 0/255\n");
}

TEST_F(Golden, OneStepOf255IsAllowedAndTwoAreNot) {
    renew();
    change_reference(1, "");
    EXPECT_EQ(golden().code, 0);
    change_reference(1, "");
    const Result result = golden({"-o", "differences"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "1 of 19200 pixels differ by more than 1/255, the most by 2/255")) << result.err;
    EXPECT_EQ(files_in(course_.path() / "differences").size(), 3u) << "now, reference, difference";
}

TEST_F(Golden, AProbeIsComparedAtItsStoredPrecision) {
    course_.edit("labs/01_specular_highlights/lab.toml", "distance = 2.4 }", "distance = 2.4 }, probe = \"normal\"");
    renew();
    Notes notes;
    Image image = read_image(file_, &notes);
    for (float& value : image.values) value += value < 0.5f ? 1.0f / 255 : -1.0f / 255;
    write_image(file_, image, notes);
    EXPECT_EQ(golden().out, "01_specular_highlights/close: same within 1/255\n") << golden().err;
    change_reference(1, "");
    EXPECT_TRUE(contains(golden().err, "1 of 19200 pixels differ by more than 1/255, the most by 2/255"))
        << golden().err;
}

TEST_F(Golden, APassingReferenceIsNotRenewed) {
    renew();
    change_reference(1, "");
    const std::string before = read_all(file_);
    EXPECT_EQ(golden({"--update"}).out, "01_specular_highlights/close: same within 1/255\n");
    EXPECT_EQ(read_all(file_), before);
    change_reference(1, "");
    EXPECT_EQ(golden({"--update"}).out, "01_specular_highlights/close: renewed\n");
}

TEST_F(Golden, AReferenceOfAnotherDriverIsNotRenewed) {
    renew();
    change_reference(9, "softpipe, Mesa 1.0");
    const std::string before = read_all(file_);
    const Result result = golden({"--update"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "not renewed: it was made by softpipe, Mesa 1.0, this is llvmpipe")) << result.err;
    EXPECT_EQ(read_all(file_), before);
    EXPECT_TRUE(contains(golden().err, "(the reference was made by softpipe, Mesa 1.0, this is llvmpipe"));
}

TEST_F(Golden, AnotherMesaVersionMayDifferInAFewPixelsTheSameOneInNone) {
    renew();
    Notes notes;
    const Image image = read_image(file_, &notes);
    const std::string here = notes.at(0).second,
                      other = std::regex_replace(here, std::regex("Mesa [0-9.]+"), "Mesa 1.2.3");
    ASSERT_NE(here, other);
    // Another version of the distribution's package contains the same Mesa.
    const std::string packaged = std::regex_replace(here, std::regex("Mesa ([0-9.]+)[^,]*"), "Mesa $1-7deb");
    const std::string unpinned = other.substr(0, other.find(", pinned"));
    const auto with = [&](const std::string& driver, size_t pixels, int steps) {
        write_image(file_, image, notes);
        change_reference(steps, driver, pixels);
        return golden();
    };
    // 192 pixels are 1 %, and 2 of 19200 are more than 0.01 %.
    const char* const allowed = "labs/another_mesa.txt";
    course_.overwrite(allowed,
                      "# a comment\nMesa 0\nothers 0.01 0.01\n01_specular_highlights/other 50 50\n"
                      "01_specular_highlights/close 1 0.5\nMesa 98\n01_specular_highlights/close 2 0.5\n");
    const Result same = with(other, 192, 4);
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_TRUE(contains(same.out,
                         "same within 1/255 but for 192 of 19200 pixels: the reference was made by Mesa "
                         "1.2.3, this is "))
        << same.out;
    EXPECT_EQ(with(other, 193, 4).code, 1);
    EXPECT_EQ(with(other, 96, 40).code, 0);
    EXPECT_EQ(with(other, 97, 40).code, 1) << "of larger differences fewer are taken";
    for (const std::string& driver : {here, packaged, unpinned}) EXPECT_EQ(with(driver, 1, 2).code, 1) << driver;
    const std::string newer = std::regex_replace(here, std::regex("Mesa [0-9.]+"), "Mesa 98.0.1");
    EXPECT_EQ(with(newer, 384, 4).code, 0) << "a row of its own";
    EXPECT_EQ(with(newer, 385, 4).code, 1);
    course_.overwrite(allowed, "Mesa 0\nothers 0.01 0.01\nVulkan\nothers 1 1\n");
    EXPECT_EQ(with(other, 2, 2).code, 1) << "what is allowed through Vulkan holds only there";
    course_.overwrite(allowed, "Mesa 0\nothers 0.01 0.01\n");
    EXPECT_EQ(with(other, 1, 40).code, 0);
    EXPECT_EQ(with(other, 2, 2).code, 1);
    std::filesystem::remove(course_.path() / allowed);
    EXPECT_EQ(with(other, 1, 2).code, 1) << "no list, nothing allowed";
}

TEST_F(Golden, ABlankPictureIsNotRenewed) {
    renew();
    const std::string before = read_all(file_);
    course_.edit("labs/01_specular_highlights/lab.toml", "distance = 2.4", "distance = 1000000");
    const Result result = golden({"--update"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "the picture has one colour")) << result.err;
    EXPECT_EQ(read_all(file_), before);
}

TEST_F(Golden, ADamagedReferenceIsNamed) {
    renew();
    course_.overwrite("labs/01_specular_highlights/golden/close.png", "not a picture");
    const Result result = golden();
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "close.png: neither PNG, OpenEXR, JPEG, PPM, PFM nor DDS")) << result.err;
}

}  // namespace
}  // namespace relief::app
