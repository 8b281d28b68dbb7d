// relief shot from the command line.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <glm/glm.hpp>
#include <thread>

#include "framework/core/base/file.h"
#include "framework/core/image/color.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

constexpr bool has_osmesa = RELIEF_HAS_OSMESA;

class ShotCommand : public testing::Test {
protected:
    TemporaryFolder folder_;

    std::filesystem::path file(const char* name) const { return folder_.path() / name; }
    /// Draws a small picture of lab 01, from a working directory outside the course.
    Result shot(std::vector<std::string> more) const {
        std::vector<std::string> command = {relief_program(), "shot", "01", "--size", "96x64"};
        command.insert(command.end(), more.begin(), more.end());
        return run(command, {folder_.path(), {}});
    }
    Result good_shot(std::vector<std::string> more) const {
        const Result result = shot(std::move(more));
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return result;
    }
};

TEST_F(ShotCommand, WritesAPngAndPrintsItsName) {
    EXPECT_EQ(good_shot({"-o", "a.png"}).out, "a.png\n");
    const Image image = read_image(file("a.png"));
    EXPECT_EQ(image.width, 96);
    EXPECT_EQ(image.height, 64);
    EXPECT_EQ(image.channels, 3);
    EXPECT_FALSE(is_one_color(image));
    EXPECT_EQ(good_shot({}).out, "01_specular_highlights.png\n");
}

TEST_F(ShotCommand, WritesWordsAsMarkupInsteadOfIntoThePicture) {
    const auto shot_02 = [&](std::vector<std::string> more) {
        std::vector<std::string> command = {relief_program(), "shot", "02", "--set", "view=one", "--size", "120x90"};
        command.insert(command.end(), more.begin(), more.end());
        const Result result = run(command, {folder_.path(), {}});
        EXPECT_EQ(result.code, 0) << result.err;
    };
    shot_02({"-o", "with.png"});
    shot_02({"-o", "without.png", "--words", "words.html"});
    EXPECT_NE(read_image(file("with.png")).values, read_image(file("without.png")).values);
    EXPECT_TRUE(contains(read_file(file("words.html")), "class=\"tile\"")) << read_file(file("words.html"));
    shot_02({"-o", "error.png", "--error", "normal", "--words", "scale.html"});
    EXPECT_TRUE(contains(read_file(file("scale.html")), "degrees and more")) << read_file(file("scale.html"));
}

TEST_F(ShotCommand, WritesTheMapThatALabMakes) {
    const auto map = [&](std::vector<std::string> more) {
        std::vector<std::string> command = {relief_program(), "shot"};
        command.insert(command.end(), more.begin(), more.end());
        command.insert(command.end(), {"--map", "-o", "map.png"});
        const Result result = run(command, {folder_.path(), {}});
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.out, "map.png\n");
        return read_image(file("map.png"));
    };
    const auto expect_unit_normals = [](const Image& image, const char* lab, double allowed = 1e-4) {
        EXPECT_EQ(image.bits, 16) << lab;
        ASSERT_EQ(image.channels, 3) << lab;
        EXPECT_FALSE(is_one_color(image)) << lab;
        double off = 0;
        size_t count = 0;
        for (size_t i = 0; i < image.pixel_count(); ++i) {
            const glm::dvec3 stored(image.values[3 * i], image.values[3 * i + 1], image.values[3 * i + 2]);
            if (stored == glm::dvec3(0)) continue;  // no island of lab 07
            off += std::abs(glm::length(2.0 * stored - 1.0) - 1), ++count;
        }
        EXPECT_GT(count, image.pixel_count() / 2) << lab;
        EXPECT_LT(off / double(count), allowed) << lab;
    };
    const Image waves = map({"03", "--set", "size=128", "--set", "filter=spline"});
    EXPECT_EQ(waves.width, 128);
    expect_unit_normals(waves, "03");
    EXPECT_EQ(waves.values, map({"03", "--set", "size=128", "--set", "filter=spline", "--set", "view=one"}).values);
    EXPECT_NE(waves.values, map({"03", "--set", "size=128", "--set", "filter=sobel"}).values);
    const Image baked = map({"07", "--set", "map_size=128"});
    EXPECT_EQ(baked.width, 128);
    expect_unit_normals(baked, "07", 0.01);  // padding has means of normals, which are shorter
    expect_unit_normals(map({"09", "--set", "view=faces", "--size", "128x96"}), "09");
}

TEST_F(ShotCommand, GivesTheSameBytesForTheSameTimeAndKnobs) {
    for (const char* name : {"a.png", "a.exr", "a.ppm", "a.pfm"}) {
        good_shot({"-o", name, "--set", "shininess=9", "--time", "2"});
        const std::string first = read_all(file(name));
        good_shot({"-o", name, "--set", "shininess=9", "--time", "2"});
        EXPECT_EQ(first, read_all(file(name))) << name;
    }
}

TEST_F(ShotCommand, GivesTheSameBitsWithAndWithoutOptimisedShaders) {
    struct Picture {
        const char *lab, *probe;
    };
    for (const auto& [lab, probe] : {Picture{"02", "normal"}, {"12", "uv"}, {"13", "normal"}, {"18", "normal"}}) {
        std::string bits;
        for (const char* perf : {"nopt", "optimised"}) {
            const Result result =
                run({relief_program(), "shot", lab, "--probe", probe, "--size", "96x64", "-o", "p.exr"},
                    {folder_.path(), {{"GALLIVM_PERF", perf}, {"MESA_SHADER_CACHE_DISABLE", "true"}}});
            EXPECT_EQ(result.code, 0) << result.err;
            const std::string drawn = read_all(file("p.exr"));
            EXPECT_FALSE(drawn.empty());
            EXPECT_TRUE(bits.empty() || drawn == bits) << lab;
            bits = drawn;
        }
    }
}

TEST_F(ShotCommand, GivesTheSameBitsOnOsmesaAndEgl) {
    if (!has_osmesa) GTEST_SKIP() << "OSMesa is not installed";
    good_shot({"-o", "o.png", "--context", "osmesa"});
    good_shot({"-o", "e.png", "--context", "egl"});
    EXPECT_EQ(read_all(file("o.png")), read_all(file("e.png")));
    good_shot({"-o", "o.exr", "--context", "osmesa", "--probe", "normal"});
    good_shot({"-o", "e.exr", "--context", "egl", "--probe", "normal"});
    EXPECT_EQ(read_all(file("o.exr")), read_all(file("e.exr")));
}

TEST_F(ShotCommand, DrawsTheLevelsOfAMaskAlikeWhateverTheProcessorCan) {
    // A third of the pixels' centres lie on the border of two texels.
    const auto levels = [&](std::map<std::string, std::string> environment) {
        const Result result =
            run({relief_program(), "shot", "08", "--set", "view=levels", "--size", "720x480", "-o", "-"},
                {{}, std::move(environment)});
        EXPECT_EQ(result.code, 0) << result.err;
        return result.out;
    };
    EXPECT_EQ(levels({}) == levels({{"GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1"}, {"LP_NATIVE_VECTOR_WIDTH", "128"}}), true);
}

TEST_F(ShotCommand, WritesPpmOrForAProbePfmToStandardOutput) {
    const std::string picture = good_shot({"-o", "-"}).out;
    EXPECT_TRUE(picture.starts_with("P6\n96 64\n255\n"));
    EXPECT_EQ(picture.size(), 13u + 96 * 64 * 3);
    good_shot({"-o", "a.ppm"});
    EXPECT_EQ(picture, read_all(file("a.ppm")));
    const std::string probe = good_shot({"-o", "-", "--probe", "normal"}).out;
    EXPECT_TRUE(probe.starts_with("PF\n96 64\n-1.0\n"));
    EXPECT_EQ(probe.size(), 14u + 96 * 64 * 3 * 4);
}

TEST_F(ShotCommand, KnobsCameraAndMethodChangeThePicture) {
    good_shot({"-o", "a.png"});
    const Image usual = read_image(file("a.png"));
    for (const char* change : {"--set=method=vertex-normal", "--set=strength=0", "--camera=80,30,6",
                               "--camera=80,30,6,0.3,0.2,0", "--camera=20,7,6.6,0.95,1.5,0.35,60"}) {
        good_shot({"-o", "b.png", change});
        EXPECT_GT(difference(usual, read_image(file("b.png")), 2.0 / 255).pixels_over, 50u) << change;
    }
}

TEST_F(ShotCommand, DrawsThePictureOfACheck) {
    const auto drawn = [&](std::vector<std::string> more) {
        std::vector<std::string> command = {relief_program(), "shot", "10", "-o", file("check.pfm").string()};
        command.insert(command.end(), more.begin(), more.end());
        const Result result = run(command);
        EXPECT_EQ(result.code, 0) << result.err;
        return read_all(file("check.pfm"));
    };
    const std::string check = drawn({"--check", "eight layers"});
    EXPECT_EQ(check, drawn({"--set", "view=one", "--set", "method=steep", "--set", "steps=8", "--camera", "45,20,0.2",
                            "--probe", "uv", "--size", "128x128"}));
    EXPECT_NE(check, drawn({"--check", "eight layers", "--set", "steps=9"})) << "what is said beside it counts";
    EXPECT_NE(check, drawn({"--check", "eight layers", "--error", "uv"}));
}

TEST_F(ShotCommand, DrawsAKnownMistakeAsPictureProbeAndError) {
    const char* mistake = "--mistake=green-flipped";
    const auto of = [&](const std::string& file_name, std::vector<std::string> more) {
        more.insert(more.begin(), {"-o", file_name, "--set", "method=normal-map"});
        return good_shot(more).out;
    };
    of("right.png", {}), of("wrong.png", {mistake});
    EXPECT_GT(difference(read_image(file("right.png")), read_image(file("wrong.png")), 8.0 / 255).pixels_over, 96u * 3);
    of("right.pfm", {"--probe=normal"}), of("wrong.pfm", {"--probe=normal", mistake});
    EXPECT_NE(read_all(file("right.pfm")), read_all(file("wrong.pfm")));
    const auto mean = [&](const std::string& told) { return std::stod(told.substr(told.find("mean ") + 5)); };
    const double right = mean(of("e.png", {"--error=normal", "--camera=10,60,3"}));
    EXPECT_GT(mean(of("e.png", {"--error=normal", "--camera=10,60,3", mistake})), right + 1) << "degrees";
    // The mistake in a shader must also be visible in the light, and the next run must be without it.
    of("light.exr", {mistake}), of("again.png", {});
    EXPECT_EQ(read_all(file("right.png")), read_all(file("again.png")));
}

TEST_F(ShotCommand, AMistakeInCppIsCompiledForThePicture) {
    const auto draw = [&](const char* name, std::vector<std::string> more) {
        more.insert(more.begin(),
                    {relief_program(), "shot", "05", "--size", "64x48", "--probe", "tangent", "-o", name});
        return run(more, {folder_.path(), {}});
    };
    ASSERT_EQ(draw("right.pfm", {}).code, 0);
    const Result mistaken = draw("wrong.pfm", {"--mistake", "tangent-for-bitangent"});
    ASSERT_EQ(mistaken.code, 0) << mistaken.err;
    EXPECT_NE(read_all(file("right.pfm")), read_all(file("wrong.pfm")));
}

TEST_F(ShotCommand, AnExrHoldsTheLinearValuesOfThePng) {
    good_shot({"-o", "a.png"}), good_shot({"-o", "a.exr"});
    const Image encoded = read_image(file("a.png")), light = read_image(file("a.exr"));
    size_t same = 0;
    for (size_t i = 0; i < encoded.values.size(); ++i)
        same += std::abs(srgb_from_linear(std::min(light.values[i], 1.0f)) - encoded.values[i]) <= 1.01 / 255;
    // The other pixels lie on edges, where one of the four samples is brighter than 1. The float target does not clamp
    // it.
    EXPECT_GT(double(same) / double(encoded.values.size()), 0.95);
}

TEST_F(ShotCommand, WrongUsePrintsOneHelpfulLineAndExitsWithTwo) {
    expect_refused(
        [&](const auto& words) { return shot(words); },
        {{{"--set", "shinyness=3"}, "did you mean 'shininess'?"},
         {{"--set", "shininess=1e9"}, "knob shininess takes 2 to 256, not '1e9'"},
         {{"--set", "shininess=nan"}, "knob shininess takes 2 to 256"},
         {{"--set", "method=normal-mpa"}, "did you mean 'normal-map'?"},
         {{"--set", "method"}, "--set takes knob=value"},
         {{"--probe", "nromal"}, "did you mean 'normal'?"},
         {{"--context", "osmessa"}, "did you mean 'osmesa'?"},
         {{"--size", "0x64"}, "1x1 to 8192x8192"},
         {{"--size", "100000x100000"}, "1x1 to 8192x8192"},
         {{"--size", "64"}, "--size takes WIDTHxHEIGHT"},
         {{"--size", "-3x4"}, "--size takes WIDTHxHEIGHT"},
         {{"--time", "3e9"}, "--time takes seconds"},
         {{"--time", "1e999"}, "--time takes seconds"},
         {{"--camera", "1,2"}, "--camera takes yaw,pitch,distance"},
         {{"--camera", "0,90,1"}, "the pitch, in degrees, is a number from -89 to 89, not '90'"},
         {{"--camera", "0,0,0"}, "the distance, in metres, is a number from 0.001 to 1000000, not '0'"},
         {{"--camera", "0,0,1,2"}, "optionally ,x,y,z of the point"},
         {{"--camera", "0,0,1,2,3,1e9"},
          "z of the point it looks at, in metres, is a number from -1000000 to 1000000, not '1e9'"},
         {{"--camera", "0,0,1,1e308,3,4"},
          "x of the point it looks at, in metres, is a number from -1000000 to 1000000"},
         {{"--camera", "0,0,1,2,3,4,180"}, "the field of view, in degrees, is a number from 1 to 170, not '180'"},
         {{"--camera", "0,0,1,2,3,4,50,6"}, "--camera takes yaw"},
         {{"--probe", "normal", "--error", "normal"}, "give only one of"},
         {{"--mistake", "green-fliped"}, "unknown mistake 'green-fliped': did you mean"},
         {{"--mistake", "green-flipped", "--truth", "normal"}, "--mistake changes the drawn picture"},
         {{"-o", "a.gif"}, "must end in .png, .exr, .ppm or .pfm"},
         {{"--colour"}, "unknown option '--colour'"},
         {{"02"}, "one argument too many"},
         {{"--map"}, "this lab makes no map; these do: 03, 07, 09"}});
    const auto shot_of = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {relief_program(), "shot"});
        return run(words, {folder_.path(), {}});
    };
    expect_refused(shot_of,
                   {{{"03", "--map", "--probe", "normal"}, "give only one of --probe, --truth, --error and --map"},
                    {{"10", "--check", "eight layer"}, "did you mean 'eight layers'?"},
                    {{"speculra"}, "did you mean '01_specular_highlights'?"}});
    EXPECT_TRUE(files_in(folder_.path()).empty());
}

TEST_F(ShotCommand, TheLastOfRepeatedOptionsCounts) {
    good_shot({"-o", "a.png", "--size", "32x16", "--size", "20x10"});
    EXPECT_EQ(read_image(file("a.png")).width, 20);
}

TEST_F(ShotCommand, AnUnwritableOutputLeavesNoFileBehind) {
    folder_.write("old.png/inside", "");
    for (const char* name : {"no/such/folder/a.png", "/proc/a.png", "old.png"}) {
        const Result result = shot({"-o", name});
        EXPECT_EQ(result.code, 1) << name;
        EXPECT_TRUE(contains(result.err, "cannot write")) << result.err;
    }
    EXPECT_EQ(files_in(folder_.path()).size(), 1u) << "only what the test put there";
}

TEST_F(ShotCommand, AFullDiskKeepsTheOldFile) {
    const Result result = shot({"-o", "/dev/full"});
    EXPECT_EQ(result.code, 2) << "the ending is asked first";
    folder_.write("a.png", "old");
    // A limit of 1 KiB on file sizes simulates a full disk.
    const Result full =
        run({"bash", "-c", "trap '' XFSZ; ulimit -f 1; exec \"$0\" shot 1 --size 96x64 -o a.png", relief_program()},
            {folder_.path(), {}});
    EXPECT_EQ(full.code, 1);
    EXPECT_TRUE(contains(full.err, "a.png: cannot write")) << full.err;
    EXPECT_EQ(read_all(file("a.png")), "old");
    EXPECT_EQ(files_in(folder_.path()).size(), 1u);
}

TEST_F(ShotCommand, AClosedPipeIsAnErrorNotACrash) {
    const Result result = run(
        {"bash", "-c", "set -o pipefail; \"$0\" shot 1 --size 800x600 -o - | head -c 1 >/dev/null", relief_program()});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "cannot write to standard output")) << result.err;
}

TEST_F(ShotCommand, CtrlCLeavesNoFile) {
    Process process({relief_program(), "shot", "01", "--size", "4000x3000", "-o", "a.png"}, {folder_.path(), {}});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    process.signal(SIGINT);
    EXPECT_EQ(process.wait().code, 130);
    EXPECT_TRUE(files_in(folder_.path()).empty());
}

/// Returns the names of the libraries that a run opens, from the dynamic linker's log.
std::string libraries_of(const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {relief_program()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const TemporaryFolder folder;
    const Result result = run(command, {folder.path(), {{"LD_DEBUG", "files"}}});
    EXPECT_EQ(result.code, 0);
    std::string names;
    for (size_t at = result.err.find("calling init: "); at != std::string::npos;
         at = result.err.find("calling init: ", at + 1))
        names += result.err.substr(at + 14, result.err.find('\n', at) - at - 14) + '\n';
    return names;
}

TEST_F(ShotCommand, AnErrorWithoutAPixelToCompareSaysWhyAndFails) {
    // An eye inside the planet sees no front side of the exact ground.
    const Result result = run({relief_program(), "shot", "09", "--size", "64x48", "--set", "view=planet", "--camera",
                               "20,12,0.5", "--error", "normal", "-o", file("e.png").string()});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err,
                         "probe 'normal': no pixel can be compared: 3072 have a surface only as it is "
                         "drawn, 0 only in the expected values"))
        << result.err;
    EXPECT_FALSE(std::filesystem::exists(file("e.png")));
}

TEST_F(ShotCommand, NamesTheKnobThatGivesExactValues) {
    const auto error_of_lab_05 = [&](const char* shape) {
        return run({relief_program(), "shot", "05", "--size", "64x48", "--set", std::string("shape=") + shape,
                    "--error", "tangent", "-o", file("e.png").string()});
    };
    const Result result = error_of_lab_05("urn");
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(contains(result.err, "with shape=quad there are, for this probe")) << result.err;
    EXPECT_EQ(error_of_lab_05("quad").code, 0);
    const Result steps = run({relief_program(), "shot", "12", "--size", "64x48", "--error", "steps"});
    EXPECT_TRUE(contains(steps.err, "this lab has no exact values for the probe 'steps'")) << steps.err;
}

TEST_F(ShotCommand, OpensNoLibraryThatItDoesNotNeed) {
    // All textures of the labs are prepared, so OpenImageIO reads none of them. libpng writes a PNG.
    for (const char* lab : {"01", "03", "04", "05", "06", "10", "11", "12", "13", "14"}) {
        const std::string plain = libraries_of({"shot", lab, "--size", "64x64", "-o", "a.png"});
        EXPECT_TRUE(contains(plain, has_osmesa ? "libOSMesa" : "libEGL")) << lab;
        for (const char* unwanted : {"OpenImageIO", "relief-openimageio", "rsvg", "cairo", "glfw", "imgui",
                                     "relief-window", "archive", "relief-staff", "seccomp"})
            EXPECT_FALSE(contains(plain, unwanted)) << lab << ": " << unwanted;
        for (const char* of_egl : {"libEGL", "libX11"})
            EXPECT_FALSE(has_osmesa && contains(plain, of_egl)) << lab << ": " << of_egl;
    }
    const std::string exr = libraries_of({"shot", "01", "--size", "64x64", "-o", "a.exr"});
    for (const char* unwanted : {"OpenImageIO", "glfw", "imgui", "relief-window"})
        EXPECT_FALSE(contains(exr, unwanted)) << unwanted;
    EXPECT_TRUE(contains(libraries_of({"grade", "--help"}), "relief-staff")) << "so the search above can find it";
    // Exact values need no context, and neither does a list.
    const std::vector<std::vector<std::string>> without_context = {
        {"shot", "01", "--size", "64x64", "--truth", "normal", "-o", "a.pfm"}, {"list"}, {"--help"}};
    for (const auto& arguments : without_context)
        for (const char* unwanted : {"OSMesa", "LLVM", "OpenImageIO"})
            EXPECT_FALSE(contains(libraries_of(arguments), unwanted)) << arguments[0] << ": " << unwanted;
}

TEST_F(ShotCommand, VerbosePrintsTimedEventsInOrder) {
    const Result result = shot({"-o", "a.ppm", "--verbose"});
    EXPECT_EQ(result.code, 0);
    double before = 0;
    for (const char* event :
         {"started: ", "lab: 01_specular_highlights", has_osmesa ? "context: osmesa" : "context: egl",
          "program: ", "texture: ", "drawn", "read back", "written: a.ppm"}) {
        const size_t at = result.err.find(std::string(" ms] ") + event);
        ASSERT_NE(at, std::string::npos) << event << "\n" << result.err;
        const double when = std::stod(result.err.substr(result.err.rfind('[', at) + 1));
        EXPECT_GE(when, before) << event;
        before = when;
    }
}

}  // namespace
}  // namespace relief::app
