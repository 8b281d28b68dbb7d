// The other commands, and their messages for a course with missing or damaged files.
#include <OpenImageIO/oiioversion.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/submission.h"
#include "tests/browser.h"
#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

constexpr bool has_osmesa = RELIEF_HAS_OSMESA;
const Circumstances no_display{{}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}};

/// One copy for all tests of a program. Each test undoes its changes, or works on its own files.
class CourseTest : public testing::Test {
protected:
    static void SetUpTestSuite() { course_ = std::make_unique<CourseCopy>(); }
    static void TearDownTestSuite() { course_.reset(); }
    static const CourseCopy& course() { return *course_; }

    static Result small_shot(std::vector<std::string> more = {}) {
        std::vector<std::string> arguments = {"shot", "1", "--size", "64x48", "-o", "shot.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return course().relief(arguments);
    }
    /// Expects exit code 1, one line with this text, and no picture.
    static void expect_failure(const Result& result, const std::string& text) {
        EXPECT_EQ(result.code, 1);
        EXPECT_TRUE(contains(result.err, text)) << result.err;
        EXPECT_EQ(occurrences(result.err, "\n"), 1u) << result.err;
        EXPECT_FALSE(std::filesystem::exists(course().path() / "shot.png"));
    }
    /// Returns "FILE:LINE" of the first occurrence of a text in a file of the course.
    static std::string place_of(const std::string& file, const std::string& text) {
        const std::string whole = read_all(course().path() / file);
        return fmt::format("{}:{}", file, occurrences(whole.substr(0, whole.find(text)), "\n") + 1);
    }

private:
    static inline std::unique_ptr<CourseCopy> course_;
};

/// Restores a file in its destructor.
class Restore {
public:
    Restore(const CourseCopy& course, const char* file)
        : course_(course), file_(file), old_(read_all(course.path() / file)) {}
    ~Restore() { course_.overwrite(file_, old_); }
    Restore(const Restore&) = delete;
    Restore& operator=(const Restore&) = delete;

private:
    const CourseCopy& course_;
    std::string file_, old_;
};

TEST_F(CourseTest, WorksInAFolderWithASpaceFromAnyWorkingDirectory) {
    const Result result =
        run({course().path() / "bin" / "relief", "shot", "1", "--size", "64x48", "-o", course().path() / "here.png"},
            {"/", {}});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(std::filesystem::exists(course().path() / "here.png"));
}

TEST_F(CourseTest, ALabsOwnExecutableKnowsItsLab) {
    const Result result =
        run({course().path() / "bin" / "lab-01", "shot", "--size", "64x48", "-o", "own.png"}, {course().path(), {}});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(small_shot().code, 0);
    EXPECT_EQ(read_all(course().path() / "own.png"), read_all(course().path() / "shot.png"));
    std::filesystem::remove(course().path() / "shot.png");
}

TEST_F(CourseTest, AShaderThatDoesNotCompileNamesItsFileAndLine) {
    const char* file = "shaders/common/light.glsl";
    const Restore restore(course(), file);
    course().edit(file, "float facing = max", "float facing = mox");
    const Result result = small_shot();
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(result.err.starts_with("relief: " + place_of(file, "float facing = mox") + ": error:")) << result.err;
    EXPECT_TRUE(contains(result.err, "float facing = mox")) << "the whole line: " << result.err;
    EXPECT_TRUE(contains(result.err, "^\n")) << "the place in the line: " << result.err;
}

TEST_F(CourseTest, AMissingOrFaultyFileIsNamed) {
    const struct {
        const char *file, *find, *replace, *said;
    } faults[] = {{"shaders/01_specular_highlights/surface.frag", "common/light.glsl", "common/lihgt.glsl",
                   ": cannot find the included file \"common/lihgt.glsl\": did you mean \"common/light.glsl\"?"},
                  {"shaders/01_specular_highlights/surface.vert", nullptr, nullptr, ": cannot read: No such file"},
                  {"assets/bricks_albedo.png", nullptr, nullptr, ": cannot read: No such file"},
                  {"labs/01_specular_highlights/lab.toml", nullptr, nullptr, ": cannot read: No such file"},
                  {"labs/01_specular_highlights/lab.toml", "camera =", "camrea =", ": unknown key"}};
    for (const auto& [file, find, replace, said] : faults) {
        const Restore restore(course(), file);
        if (find)
            course().edit(file, find, replace);
        else
            std::filesystem::remove(course().path() / file);
        expect_failure(small_shot(), (find ? place_of(file, replace) : file) + said);
        if (contains(said, "key")) expect_failure(course().relief({"list"}), "did you mean 'camera'?");
    }
}

TEST_F(CourseTest, ADamagedTextureIsNamed) {
    const char* file = "assets/bricks_normal.png";
    const Restore restore(course(), file);
    const std::string whole = read_all(course().path() / file);
    for (const std::string& broken : {std::string(), std::string("not a picture"), whole.substr(0, whole.size() / 2)}) {
        course().overwrite(file, broken);
        expect_failure(small_shot(), std::string(file) + ": ");
    }
}

/// A folder of empty files in place of libraries: the linker finds them first and cannot open them.
Circumstances without_libraries(const TemporaryFolder& folder, const std::vector<std::string>& names) {
    for (const std::string& name : names) folder.write(name, "");
    return {{}, {{"LD_LIBRARY_PATH", folder.path().string()}}};
}
const std::vector<std::string> osmesa = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
const std::vector<std::string> egl = {"libEGL.so.1", "libEGL.so"};
const std::string openimageio = fmt::format("libOpenImageIO.so.{}.{}", OIIO_VERSION_MAJOR, OIIO_VERSION_MINOR);

TEST_F(CourseTest, WithoutOsmesaTheRunTakesEglAndTellsWhyWhenAsked) {
    const TemporaryFolder libraries;
    const Circumstances no_osmesa = without_libraries(libraries, osmesa);
    const Result quiet = course().relief({"shot", "1", "--size", "64x48", "-o", "egl.png"}, no_osmesa);
    EXPECT_EQ(quiet.code, 0);
    EXPECT_EQ(quiet.err, "");
    EXPECT_TRUE(std::filesystem::exists(course().path() / "egl.png"));
    const Result verbose = course().relief({"shot", "1", "--size", "64x48", "-o", "egl.png", "--verbose"}, no_osmesa);
    EXPECT_TRUE(contains(verbose.err, "no osmesa context: install the Debian package libosmesa6")) << verbose.err;
    EXPECT_TRUE(contains(verbose.err, "context: egl")) << verbose.err;
    const Result info = course().relief({"info"}, no_osmesa);
    EXPECT_TRUE(contains(info.out, "osmesa   missing: ")) << info.out;
    EXPECT_TRUE(contains(info.out, "egl      OpenGL 4.")) << info.out;
}

TEST_F(CourseTest, WithoutAnyContextEveryPackageIsNamed) {
    const TemporaryFolder libraries;
    without_libraries(libraries, osmesa);
    const Result result = course().relief({"shot", "1", "-o", "shot.png"}, without_libraries(libraries, egl));
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "libosmesa6")) << result.err;
    EXPECT_TRUE(contains(result.err, "libegl1")) << result.err;
    EXPECT_EQ(occurrences(result.err, "\n"), 1u);
}

TEST_F(CourseTest, AnExplicitContextThatIsMissingFails) {
    const TemporaryFolder libraries;
    const Result result =
        course().relief({"shot", "1", "--context", "osmesa", "-o", "shot.png"}, without_libraries(libraries, osmesa));
    expect_failure(result, "no osmesa context: install the Debian package libosmesa6");
    expect_failure(course().relief({"shot", "1", "--context", "window", "-o", "shot.png"}, no_display),
                   "there is no display");
}

TEST_F(CourseTest, TheContextOfAGpuNeverDrawsInSoftware) {
    const TemporaryFolder no_drivers;
    for (const std::string command : {"shot", "golden"})
        expect_failure(course().relief({command, "1", "--context", "gpu"},
                                       {{}, {{"__EGL_VENDOR_LIBRARY_DIRS", no_drivers.path().string()}}}),
                       "no gpu context: EGL finds no hardware driver");
    const Result update = course().relief({"golden", "1", "--context", "gpu", "--update"});
    EXPECT_EQ(update.code, 2);
    EXPECT_TRUE(contains(update.err, "--update needs the software renderer: leave out --context gpu")) << update.err;
}

TEST_F(CourseTest, AnOldDriverIsReportedWithItsVersionAndTheVariablesThatChoseIt) {
    for (const std::string context : {"osmesa", "egl"}) {
        if (context == "osmesa" && !has_osmesa) continue;
        const Result result = course().relief({"shot", "1", "--context", context, "-o", "shot.png"},
                                              {{}, {{"GALLIUM_DRIVER", "softpipe"}, {"LIBGL_ALWAYS_SOFTWARE", "1"}}});
        expect_failure(result, "no " + context + " context: the driver is softpipe, which has OpenGL 3.3 ");
        EXPECT_TRUE(contains(result.err, "and no 4.1 core (GALLIUM_DRIVER=softpipe, LIBGL_ALWAYS_SOFTWARE=1 is set)"))
            << result.err;
        EXPECT_FALSE(contains(result.err, "Debian package")) << result.err;
    }
}

TEST_F(CourseTest, AMissingDriverIsReportedWithoutACrash) {
    const Result result =
        course().relief({"shot", "1", "-o", "shot.png"}, {{}, {{"GALLIUM_DRIVER", "zonk"}, {"DISPLAY", ""}}});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err,
                         "; no egl context: EGL finds no driver that draws without a surface "
                         "(GALLIUM_DRIVER=zonk is set)\n"))
        << result.err;
    if (!has_osmesa) GTEST_SKIP() << "OSMesa is not installed: its part is not tested";
    EXPECT_TRUE(contains(result.err,
                         "no osmesa context: OSMesa crashes, as it does where it lacks the driver that is "
                         "asked for (GALLIUM_DRIVER=zonk is set); "))
        << result.err;
    EXPECT_FALSE(contains(result.err, "Debian package")) << result.err;
}

TEST_F(CourseTest, InfoContinuesAfterADriverCrashes) {
    // A driver that aborts the process as soon as it is loaded.
    const TemporaryFolder libraries;
    libraries.write("crash.c",
                    "#include <stdlib.h>\n__attribute__((constructor)) static void crash(void) { abort(); }\n");
    ASSERT_EQ(run({"cc", "-shared", "-fPIC", "-o", (libraries.path() / "libOSMesa.so.8").string(),
                   (libraries.path() / "crash.c").string()})
                  .code,
              0);
    const Result result = course().relief(
        {"info"}, {{}, {{"LD_LIBRARY_PATH", libraries.path().string()}, {"GALLIUM_DRIVER", "llvmpipe"}}});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "osmesa   missing: its driver crashes, Aborted (GALLIUM_DRIVER=llvmpipe is set)"))
        << result.out;
    EXPECT_TRUE(contains(result.out, "egl      OpenGL 4.")) << result.out;
    EXPECT_TRUE(contains(result.out, "built    by ")) << result.out;
}

TEST_F(CourseTest, AHeadlessRunNeedsNoWindowLibraryAndOpenImageIoOnlyForForeignFiles) {
    const TemporaryFolder libraries;
    const auto where = without_libraries(libraries, {"libglfw.so.3", openimageio, "libGL.so.1"});
    EXPECT_EQ(course().relief({"list"}, where).code, 0);
    EXPECT_EQ(course().relief({"shot", "1", "--size", "64x48", "-o", "drawn.png"}, where).code, 0);
    EXPECT_EQ(course().relief({"shot", "1", "--size", "64x48", "-o", "drawn.exr"}, where).code, 0);
    const fs::path photo = fs::path(source_folder) / "tests/core/image/files/grey.jpg";
    expect_failure(course().relief({"inspect", photo.string()}, where),
                   "install the Debian package libopenimageio-dev");
    fs::rename(course().path() / "bin/relief-openimageio.so", course().path() / "bin/kept");
    expect_failure(course().relief({"inspect", photo.string()}),
                   "./relief build installs libopenimageio-dev and builds it");
    fs::rename(course().path() / "bin/kept", course().path() / "bin/relief-openimageio.so");
}

TEST_F(CourseTest, InfoReportsAllThreeContexts) {
    const Result result = course().relief({"info"}, no_display);
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* part : {has_osmesa ? "osmesa   OpenGL 4." : "osmesa   missing: ", "egl      OpenGL 4.",
                             "window   missing: no window context: there is no display", "llvmpipe",
                             "tessellation level 64", "OpenImageIO ", "GLFW 3."})
        EXPECT_TRUE(contains(result.out, part)) << part << "\n" << result.out;
}

TEST_F(CourseTest, ADriverWithoutOptionalExtensionsGivesTheSamePictures) {
    const Circumstances bare{{},
                             {{"MESA_EXTENSION_OVERRIDE",
                               "-GL_KHR_debug -GL_EXT_texture_filter_anisotropic -GL_ARB_texture_filter_anisotropic "
                               "-GL_ARB_conservative_depth -GL_ARB_pipeline_statistics_query"}}};
    const Result info = course().relief({"info"}, bare);
    EXPECT_TRUE(contains(info.out, "anisotropy 1, ")) << info.out;
    EXPECT_TRUE(contains(info.out, "no KHR_debug")) << info.out;
    for (const char* lab : {"01", "12", "14"}) {
        EXPECT_EQ(course().relief({"shot", lab, "--size", "160x90", "-o", "usual.png"}).code, 0);
        const Result shot = course().relief({"shot", lab, "--size", "160x90", "-o", "bare.png"}, bare);
        EXPECT_EQ(shot.code, 0) << shot.err;
        EXPECT_EQ(read_all(course().path() / "bare.png"), read_all(course().path() / "usual.png")) << lab;
    }
}

TEST_F(CourseTest, ListIsReadByPeopleAndByScripts) {
    EXPECT_TRUE(contains(course().relief({"list"}).out, "01  specular_highlights    Specular highlights"));
    const std::string json = course().relief({"list", "--json"}).out;
    EXPECT_TRUE(json.starts_with("[")) << json;
    EXPECT_TRUE(contains(json, "\"number\": 1,")) << json;
}

TEST_F(CourseTest, ListHasTheLabsOfAPathByWeeks) {
    const std::string all = course().relief({"list", "--path", "all"}).out,
                      some = course().relief({"list", "--path", "short"}).out;
    EXPECT_EQ(all, course().relief({"list"}).out);
    EXPECT_TRUE(contains(some, "week 1: ") && contains(some, "week 3: ")) << some;
    EXPECT_TRUE(contains(some, "04  object_space")) << "the first topic of the course";
    EXPECT_FALSE(contains(some, "02  normal_map_storage"));
    double hours = 0;
    for (const auto& lab : nlohmann::json::parse(course().relief({"list", "--json"}).out))
        if (lab.at("weeks").contains("short")) hours += double(lab.at("hours"));
    EXPECT_TRUE(contains(some, fmt::format("\ntogether {} hours\n", hours))) << some;
}

TEST_F(CourseTest, AGalleryReportsABrokenLabAndContinues) {
    const char* file = "shaders/01_specular_highlights/surface.frag";
    const Restore restore(course(), file);
    course().overwrite(file, "#version 410 core\nnonsense\n");
    const Result result = course().relief({"gallery", "--labs", "1,2", "-o", "pages"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, std::string(file) + ":2:")) << result.err;
    const std::filesystem::path pages = course().path() / "pages";
    EXPECT_TRUE(contains(read_all(pages / "index.html"), "surface.frag:2:"));
    EXPECT_FALSE(contains(read_all(pages / "index.html"), "01_specular_highlights.html"));
    EXPECT_TRUE(contains(read_all(pages / "index.html"), "02_normal_map_storage.html"));
    EXPECT_TRUE(std::filesystem::exists(pages / "02_normal_map_storage.html"));
}

TEST_F(CourseTest, APageOfAnEarlierGalleryStaysUntilItsLabIsComplete) {
    const std::vector<std::string> gallery = {"gallery", "--labs", "1", "-o", "kept"};
    EXPECT_EQ(course().relief(gallery).code, 0);
    const fs::path page = course().path() / "kept/01_specular_highlights.html";
    const std::string complete = read_all(page);
    const char* file = "labs/01_specular_highlights/README.md";
    const Restore restore(course(), file);
    course().overwrite(file, "![none](../../assets/diagrams/none.svg)\n");
    const Result result = course().relief(gallery);
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "none.svg")) << result.err;
    EXPECT_EQ(read_all(page), complete);
}

TEST_F(CourseTest, AGallerysTextIsEscaped) {
    const char* file = "labs/01_specular_highlights/lab.toml";
    const Restore restore(course(), file);
    course().edit(file, "Specular highlights", "Light & <b>shade</b>");
    EXPECT_EQ(course().relief({"gallery", "--labs", "1", "-o", "escaped"}).code, 0);
    for (const char* page : {"index.html", "01_specular_highlights.html", "01_specular_highlights-handout.html"}) {
        const std::string text = read_all(course().path() / "escaped" / page);
        EXPECT_TRUE(contains(text, "Light &amp; &lt;b&gt;shade&lt;/b&gt;")) << text;
        EXPECT_FALSE(contains(text, "<b>shade")) << page;
    }
}

TEST_F(CourseTest, AClosedOrFullOutputFailsWithoutACrash) {
    const std::string relief = course().path() / "bin" / "relief";
    const auto shell = [&](const std::string& line) { return run({"bash", "-c", line, relief}).code; };
    EXPECT_EQ(shell("\"$0\" shot nope 2>&-"), 2);
    EXPECT_EQ(shell("\"$0\" shot nope 2>/dev/full"), 2);
    EXPECT_EQ(shell("\"$0\" list --json >/dev/full"), 1);
    EXPECT_EQ(shell("\"$0\" list >&-"), 1);
}

TEST_F(CourseTest, WrongUseIsRefusedInOneLine) {
    expect_refused(
        [](const auto& words) { return course().relief(words, no_display); },
        {{{"golden", ""}, "LAB: must not be empty"},
         {{"shot", ""}, "LAB: must not be empty"},
         {{"shot", "1", "--size", ""}, "--size: must not be empty"},
         {{"shot", "1", "-o", ""}, "-o: must not be empty"},
         {{"gallery", "-o", ""}, "-o: must not be empty"},
         {{"gallery", "-o", "/proc/gallery"}, "/proc/gallery: cannot make this folder", 1},
         {{"shto"}, "did you mean 'shot'?"},
         {{"list", "--jsn"}, "did you mean '--json'?"},
         {{"list", "--path", "shor"}, "did you mean 'short'?"},
         {{"run", "1"}, "there is no display", 1},
         {{"shot"}, "LAB is required"},
         {{"check", "1", "-o", "page.png"}, "like checks.html, not 'page.png'"},
         {{"check", "tangent_bsis"}, "did you mean"},
         {{"check", "all"}, "unknown lab 'all'"},  // a part of "parallax" is no lab
         {{"hand-in", "1", "-o", "task.glsl"}, "-o takes the name of a zip file, like hand-in.zip, not 'task.glsl'"},
         {{"hand-in", "77"}, "unknown lab '77'"}});
}

TEST_F(CourseTest, HelpShowsALabsKnobsAndProbes) {
    const Result result = course().relief({"shot", "1", "--help"});
    EXPECT_EQ(result.code, 0);
    for (const char* part : {"--size WxH", "shininess", "2 to 256", "vertex-normal, normal-map", "unit: texel"})
        EXPECT_TRUE(contains(result.out, part)) << part << "\n" << result.out;
}

TEST_F(CourseTest, AProbeReportsAnUnwrittenTaskAndOtherChecksStillRun) {
    const std::string file = "shaders/02_normal_map_storage/task.glsl", before = read_all(course().path() / file);
    const auto probe = [](const char* kind, const char* output) {
        return course().relief({"shot", "2", kind, "normal", "--size", "64x48", "-o", output});
    };
    EXPECT_EQ(probe("--probe", "written.pfm").err, "");
    course().edit(file, "code / 255.0 * 2.0 - 1.0", "unfinished(code)");
    const Result shown = probe("--probe", "missing.pfm");
    EXPECT_EQ(shown.code, 0);
    EXPECT_TRUE(contains(shown.err, "pixels come from a task that is not written yet")) << shown.err;
    const Image missing = read_image(course().path() / "missing.pfm"),
                right = read_image(course().path() / "written.pfm");
    const auto count = [](const Image& image, auto is) {
        return std::count_if(image.values.begin(), image.values.end(), is);
    };
    const auto numbers = count(right, [](float value) { return std::isfinite(value); });
    const auto told = count(missing, [](float value) { return value == not_written; });
    EXPECT_GT(told, 300);
    EXPECT_EQ(count(missing, [](float value) { return std::isfinite(value); }) + told, numbers);
    const Result error = probe("--error", "error.png");
    EXPECT_EQ(error.code, 0);
    EXPECT_TRUE(contains(error.err, "not written yet"));
    const Result checked = course().relief({"check", "2"});
    EXPECT_FALSE(contains(checked.out, "come from a task")) << checked.out;
    EXPECT_TRUE(contains(checked.out, "unfinished")) << checked.out;
    course().overwrite(file, before);
}

TEST_F(CourseTest, CheckReportsTheErrorTheLimitAndAHint) {
    const Result right = course().relief({"check", "2"});
    EXPECT_EQ(right.code, 0) << right.out << right.err;
    EXPECT_TRUE(contains(right.out, "7.25 to 11 of 11 points, and 1 to 2 of 2 optional points")) << right.out;
    const std::string file = "shaders/02_normal_map_storage/task.glsl", before = read_all(course().path() / file);
    course().edit(file, "code / 255.0 * 2.0 - 1.0", "code / 255.0");
    const Result wrong = course().relief({"check", "storage"});
    EXPECT_EQ(wrong.code, 1);
    for (const char* part :
         {"2.1  Store a normal in three bytes: 0.75 to 1.5 of 3 points (shaders/02_normal_map_storage/task.glsl)",
          "wrong       three bytes and back: mean ", "(at most 0.26)", "why this limit: rounding to 8 bits costs",
          "look at: a usual cause lies here: decode_unorm8 undoes f: 0 becomes -1 and 255 becomes 1. Yours is "})
        EXPECT_TRUE(contains(wrong.out, part)) << part << "\n" << wrong.out;
    EXPECT_EQ(occurrences(wrong.out, "a usual cause lies here: decode_unorm8"), 1u)
        << "a hint is said once: " << wrong.out;
    // The pixel reported as the worst must be wrong.
    const std::string begin = "the worst pixel: ./relief explain 02 --check 'three bytes and back' --pixel ";
    const size_t at = wrong.out.find(begin);
    ASSERT_NE(at, std::string::npos) << wrong.out;
    const std::string pixel = wrong.out.substr(at + begin.size(), wrong.out.find('\n', at) - at - begin.size());
    const Result there =
        course().relief({"explain", "02", "--check", "three bytes and back", "--pixel", pixel, "--json"});
    ASSERT_EQ(there.code, 0) << pixel << there.err;
    const auto report = nlohmann::json::parse(there.out);
    double off = 0;
    for (size_t i = 0; i < 3; ++i)
        off = std::max(off, std::abs(double(report["value"][i]) - double(report["expected"][i])));
    EXPECT_GT(off, 0.3) << there.out;
    const std::string manifest = "labs/02_normal_map_storage/lab.toml";
    course().edit(manifest, "decode_unorm8 undoes f", "`decode_unorm8` undoes f");
    course().edit(file, "code / 255.0", "code / 254.0 * 2.0 - 1.0");
    const Result unknown = course().relief({"check", "storage"});
    EXPECT_TRUE(contains(unknown.out, "look at: a usual cause lies here: decode_unorm8 undoes f"))
        << "no mistake that is known, and no backticks: " << unknown.out;
    course().edit(manifest, "`decode_unorm8` undoes f", "decode_unorm8 undoes f");
    course().edit(file, "code / 254.0 * 2.0 - 1.0", "code / 255.0");
    course().edit(file, "code / 255.0", "cde / 255.0");
    const Result broken = course().relief({"check", "2"});
    EXPECT_EQ(broken.code, 1);
    EXPECT_TRUE(contains(broken.out, "broken ") && contains(broken.out, "task.glsl:") &&
                contains(broken.out, "error: `cde' undeclared: did you mean `code'?") &&
                contains(broken.out, "cde / 255.0") && contains(broken.out, "^\n") &&
                occurrences(broken.out, "(--verbose shows them)") == 1 && !contains(broken.out, "a missing ;"))
        << broken.out;
    EXPECT_TRUE(
        contains(course().relief({"check", "2", "--verbose"}).out, "operands to arithmetic operators must be numeric"))
        << "all messages";
    course().overwrite(file, "");
    EXPECT_EQ(course().relief({"check", "2"}).code, 1) << "an emptied file is a failed check, and no crash";
    course().overwrite(file, before);
}

TEST_F(CourseTest, ACheckAgainstTheSolutionIsUnprovenWithoutAReference) {
    const std::string file = "shaders/01_specular_highlights/task.glsl", before = read_all(course().path() / file);
    const auto outcome = [](const Result& result) {
        const auto report = nlohmann::json::parse(result.out);
        for (const auto& task : report.at("tasks"))
            for (const auto& check : task.at("checks"))
                if (check.at("name") == "the highlight on the bricks") return check.at("outcome").get<std::string>();
        return std::string("missing");
    };
    const Result own = course().relief({"check", "1"});
    EXPECT_EQ(own.code, 0) << own.out;
    EXPECT_TRUE(contains(own.out, "unproven    the highlight on the bricks: nothing to compare with")) << own.out;
    EXPECT_TRUE(contains(own.out, " to 5 of 5 points")) << own.out;
    const fs::path reference =
        course().path() / "labs/01_specular_highlights/expected" / "the-highlight-on-the-bricks.png";
    fs::create_directories(reference.parent_path());
    ASSERT_EQ(course().relief({"shot", "1", "--check", "the highlight on the bricks", "-o", reference.string()}).code,
              0);
    EXPECT_EQ(outcome(course().relief({"check", "1", "--json"})), "passed");
    course().edit(file, "direction.x * tangent", "direction.y * tangent");
    EXPECT_EQ(outcome(course().relief({"check", "1", "--json"})), "wrong");
    fs::remove_all(reference.parent_path());
    EXPECT_EQ(outcome(course().relief({"check", "1", "--json"})), "unproven");
    course().overwrite(file, before);
}

TEST_F(CourseTest, AFaultOfATaskFileNamesThatFileAndItsPlace) {
    const std::string file = "shaders/10_parallax_offset/task.glsl";
    const Restore task(course(), file.c_str());
    const std::string text = read_all(course().path() / file);
    course().overwrite(file, replaced(text, "\n", "\r"));
    const Result cr = course().relief({"check", "10"});
    EXPECT_EQ(cr.code, 0) << cr.out;
    std::string wide = "\xff\xfe";
    for (const char c : text) (wide += c) += '\0';
    for (const auto& [damaged, said] : std::vector<std::pair<std::string, std::string>>{
             {wide, ": this is text in UTF-16: save it as UTF-8"},
             {text + "// the end \\", ": the last line ends in a backslash"},
             {replaced(text, "return ", "return\xc2\xa0"), "is a no-break space (U+00A0): write a blank instead"},
             {text + "#if 0\n", ": this #if has no #endif in this file"},
             {text + "float f() {\n    return 1.0;\n", "error: this { is never closed"},
             {text + "const float last = 1.0\n", "is a ; missing here?"}}) {
        course().overwrite(file, damaged);
        const std::string out = course().relief({"check", "10"}).out;
        EXPECT_TRUE(contains(out, said)) << out;
        EXPECT_TRUE(contains(out, file + ":")) << out;
        EXPECT_FALSE(contains(out, "surface.") || contains(out, "common/")) << "another file is blamed: " << out;
    }
}

/// Returns the text between two words after `from`, and moves `from` past it; "" and npos if there is none.
std::string between(const std::string& text, const std::string& begin, const std::string& end, size_t& from) {
    const size_t at = text.find(begin, from);
    if (at == std::string::npos) return from = at, "";
    from = text.find(end, at + begin.size());
    return text.substr(at + begin.size(), from - at - begin.size());
}

/// Returns the pictures of a check's page, by their alternative texts.
std::map<std::string, Image> pictures_of(const std::string& page) {
    std::map<std::string, Image> pictures;
    for (size_t at = 0;;) {
        const std::string bytes = from_base64(between(page, "<img src=\"data:image/png;base64,", "\"", at));
        if (at == std::string::npos) return pictures;
        pictures[between(page, "alt=\"", "\"", at)] = decode_image(bytes);
    }
}

TEST_F(CourseTest, TheCheckPageIsSelfContained) {
    const std::string file = "shaders/02_normal_map_storage/task.glsl",
                      manifest = "labs/02_normal_map_storage/lab.toml";
    const Restore task(course(), file.c_str()), names(course(), manifest.c_str());
    course().edit(file, "code / 255.0 * 2.0 - 1.0", "code / 255.0");
    course().edit(manifest, "name = \"three bytes and back\"\nshot = { ",
                  "name = \"'a' </script> & \\\"b\\\"\"\nshot = { camera = { target = [0.5, 0, 0] }, ");
    const Result result = course().relief({"check", "2", "-o", "a page/of checks.html"}, no_display);
    EXPECT_EQ(result.code, 1) << "the exit code is that of the checks";
    EXPECT_TRUE(contains(result.err, "the page: " + (course().path() / "a page/of checks.html").string()))
        << result.err;
    const std::string page = read_all(course().path() / "a page/of checks.html");

    size_t checks = 0;
    for (const CheckInfo& check : load_manifest(course().path() / manifest).checks) {
        if (check.hidden && check.against == "solution") continue;  // only the grader draws the solution
        EXPECT_TRUE(contains(check.name, "<") || contains(page, "<h3>" + check.name + "</h3>")) << check.name;
        checks += !check.shot.calls;  // calls have no picture
    }
    const std::string escaped = "&#39;a&#39; &lt;/script&gt; &amp; &quot;b&quot;";
    EXPECT_TRUE(contains(page, "<h3>" + escaped + "</h3>"));
    EXPECT_FALSE(contains(page, "'a' <"));
    for (const char* part :
         {"5.75 of 11 points", "(at most 0.26)", "rounding to 8 bits costs", "decode_unorm8 undoes f",
          "degrees and more", "./relief shot 02 --check &#39;paired bytes&#39; -o mine.png"})
        EXPECT_TRUE(contains(page, part)) << part;
    for (const char* outside : {"http:", "https:", "src=\"/", "@import", "url("})
        EXPECT_FALSE(contains(page, outside)) << outside;

    const std::map<std::string, Image> pictures = pictures_of(page);
    // Yours, the expected one and their difference, with words of their own. Two checks also have the expected picture
    // as the hint changes it.
    EXPECT_EQ(pictures.size(), 3 * checks + 2);
    EXPECT_TRUE(contains(page, "Yours is the expected direction / 2 + 1/2"));
    const auto of_it = [&](const std::string& words) {
        for (const auto& [alt, picture] : pictures)
            if (alt.starts_with(words) && alt.ends_with(": " + escaped)) return picture;
        ADD_FAILURE() << "no picture '" << words << "'";
        return Image(1, 1, 3);
    };
    const Image yours = of_it("What your normal is"), expected = of_it("What is expected");
    EXPECT_EQ(difference(of_it("The expected picture, changed as the hint says"), yours, 8.0 / 255).pixels_over, 0u);
    EXPECT_EQ(yours.width, 128);
    EXPECT_GT(difference(yours, expected, 0.1).pixels_over, 1000u) << "a mistake is seen";
}

TEST_F(CourseTest, TheCheckPageHasAWipeForEachPicture) {
    ASSERT_EQ(course().relief({"check", "2", "-o", "wiped.html"}, no_display).code, 0);
    Browser browser;
    browser.open(course().path() / "wiped.html");
    const Manifest manifest = load_manifest(course().path() / "labs/02_normal_map_storage/lab.toml");
    const auto checks = std::ranges::count_if(manifest.checks, [](const CheckInfo& check) {
        // Only the grader draws the solution for hidden checks, and calls have no picture.
        return (!check.hidden || check.against != "solution") && !check.shot.calls;
    });
    EXPECT_EQ(browser.eval("document.querySelectorAll('.laid').length"), checks);
    EXPECT_EQ(browser.eval("document.querySelectorAll('.wipe').length"), checks);
    std::set<std::string> names;
    browser.eval("document.querySelectorAll('details').forEach(check => check.open = true)");
    for (const Browser::Control& control : browser.controls()) {
        EXPECT_NE(control.name, "") << control.role;
        if (control.role == "slider") names.insert(control.name);
    }
    EXPECT_EQ(int64_t(names.size()), checks) << "each says what it wipes";
    EXPECT_TRUE(names.contains("wipe to the expected picture: three bytes and back"));
    ASSERT_TRUE(browser.tab_to(".wipe input"));
    browser.press("ArrowRight", 3);
    EXPECT_EQ(browser.eval("getComputedStyle(document.querySelector('.laid img + img')).clipPath"),
              "inset(0px 97% 0px 0px)");
    EXPECT_EQ(browser.complaints(), std::vector<std::string>{});
    EXPECT_EQ(browser.accessibility_faults(), std::vector<std::string>{});
}

TEST_F(CourseTest, TheCheckPageShowsTheExpectedPictureOrTheCompilerMessage) {
    const std::string file = "shaders/02_normal_map_storage/task.glsl";
    const Restore task(course(), file.c_str());
    course().edit(file, "code / 255.0 * 2.0 - 1.0", "unfinished(code)");
    EXPECT_EQ(course().relief({"check", "2", "-o", "open.html"}).code, 1);
    const std::string unfinished = read_all(course().path() / "open.html");
    EXPECT_TRUE(contains(unfinished, "not written yet"));
    EXPECT_TRUE(contains(unfinished, "What is expected of the check: three bytes and back"));
    EXPECT_FALSE(contains(unfinished, "for the check: three bytes and back"));
    course().edit(file, "unfinished(code)", "<cde>");
    EXPECT_EQ(course().relief({"check", "2", "-o", "broken.html"}).code, 1);
    const std::string broken = read_all(course().path() / "broken.html");
    EXPECT_EQ(occurrences(broken, "<div class=\"compiler\" role=\"alert\">"), 1u) << "once, before all tasks";
    EXPECT_LT(broken.find("role=\"alert\""), broken.find("<section"));
    EXPECT_TRUE(contains(broken, "&lt;cde&gt;") && contains(broken, "^\n</pre>")) << "with its source line";
    EXPECT_TRUE(contains(broken, "waits for task 2.1"));
    EXPECT_TRUE(contains(broken, "<dt>message</dt><dd>" + file)) << "with its place";
    const size_t blocked = broken.find("<details class=\"blocked\">");
    EXPECT_TRUE(contains(broken.substr(blocked, 200), "nothing can be drawn: see the message of the compiler"));
    EXPECT_FALSE(contains(broken, "<details class=\"check\" open")) << "nothing else is there to read";
}

TEST_F(CourseTest, ThePageOpensInABrowserWhereThereIsADisplay) {
    const std::filesystem::path page = course().path() / "build/check/01_specular_highlights.html";
    const TemporaryFolder browser;
    const Circumstances no_opener{{}, {{"DISPLAY", ":99"}, {"PATH", browser.path().string()}}};
    for (const Circumstances& where : {no_display, no_opener}) {
        const Result without = course().relief({"check", "1", "--open"}, where);
        EXPECT_EQ(without.code, 0);
        EXPECT_TRUE(contains(without.err, "open it yourself: " + page.string())) << without.err;
        EXPECT_TRUE(std::filesystem::exists(page));
    }

    std::filesystem::permissions(browser.write("xdg-open",
                                               "#!/bin/sh\nprintf %s \"$1\" >\"$OPENED.part\"; mv \"$OPENED.part\" "
                                               "\"$OPENED\"; sleep 5; : >\"$OPENED.closed\"\n"),
                                 std::filesystem::perms::owner_all);
    const std::filesystem::path opened = browser.path() / "opened";
    const Result with =
        course().relief({"check", "1", "--open"}, {{},
                                                   {{"DISPLAY", ":99"},
                                                    {"OPENED", opened.string()},
                                                    {"PATH", browser.path().string() + ":" + std::getenv("PATH")}}});
    EXPECT_EQ(with.code, 0);
    EXPECT_FALSE(std::filesystem::exists(opened.string() + ".closed")) << "a browser is not waited for";
    EXPECT_FALSE(contains(with.err, "yourself")) << with.err;
    for (int i = 0; i < 500 && !std::filesystem::exists(opened); ++i) usleep(10000);
    EXPECT_EQ(read_all(opened), page.string());
}

TEST_F(CourseTest, AReplacedAssetIsDrawnWithoutARebuild) {
    const auto picture = [](const char* name) {
        EXPECT_EQ(course().relief({"shot", "1", "--size", "64x48", "-o", name}).code, 0);
        return read_all(course().path() / name);
    };
    const std::string usual = picture("usual.ppm");
    {
        const Restore restore(course(), "assets/bricks_albedo.png");
        course().overwrite("assets/bricks_albedo.png", read_all(course().path() / "assets/paving_albedo.png"));
        const std::string other = picture("other.ppm");
        EXPECT_NE(other, usual);
        const Restore textures(course(), "bin/textures/bricks_albedo.png.texels");
        std::filesystem::remove(course().path() / "bin/textures/bricks_albedo.png.texels");
        EXPECT_EQ(picture("plain.ppm"), other);
    }
    EXPECT_EQ(picture("again.ppm"), usual);
}

TEST_F(CourseTest, ABrokenOrMissingConvertedTextureIsReadFromTheOriginal) {
    const char* const file = "bin/textures/bricks_normal.png.texels";
    const Restore restore(course(), file);
    const std::string good = read_all(course().path() / file);
    const auto picture = [](const char* output) {
        const Result result = course().relief({"shot", "1", "--size", "64x48", "-o", output});
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return read_all(course().path() / output);
    };
    const std::string usual = picture("usual.ppm");
    for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), std::string(good.size(), '\0')}) {
        course().overwrite(file, bad);
        EXPECT_EQ(picture("broken.ppm"), usual) << bad.size() << " bytes";
    }
    std::filesystem::remove(course().path() / file);
    EXPECT_EQ(picture("gone.ppm"), usual);
}

TEST_F(CourseTest, HelpVersionAndALabsNumberNeedNoOtherWord) {
    const auto out = [&](const std::vector<std::string>& words) { return course().relief(words).out; };
    EXPECT_EQ(out({"help"}), out({"--help"}));
    EXPECT_EQ(out({"help", "shot"}), out({"shot", "--help"}));
    EXPECT_TRUE(out({"-v"}).starts_with("relief "));
    EXPECT_EQ(out({"-v"}), out({"--version"}));
    EXPECT_EQ(out({"03", "--help"}), out({"run", "03", "--help"}));
    EXPECT_EQ(course().relief({"99"}).err, course().relief({"run", "99"}).err);
}

TEST_F(CourseTest, HandInPacksWhatIsWrittenAndSaysWhatIsNot) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const fs::path archive = folder.path() / "hand-in.zip";
    const auto hand_in = [&](std::vector<std::string> more = {}) {
        more.insert(more.begin(), "hand-in");
        more.insert(more.end(), {"-o", archive.string()});
        return course().relief(more);
    };
    const auto packed = [&] {
        const Result listed = run({"python3", "-c",
                                   "import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1])\n"
                                   "assert z.testzip() is None\nprint(*z.namelist())",
                                   archive.string()});
        EXPECT_EQ(listed.code, 0) << listed.err;
        return listed.out;
    };
    const char *first = "shaders/01_specular_highlights/task.glsl", *second = "shaders/03_height_to_normal/task.glsl",
               *cpp = "labs/05_tangent_basis/task.cpp", *beside = "shaders/05_tangent_basis/task.glsl";
    const Restore keep_first(course(), first), keep_second(course(), second), keep_cpp(course(), cpp);
    const auto starter = [](const char* file) {
        return check::starter_of(read_all(fs::path(source_folder) / file), file);
    };

    const Result written = hand_in({"1,5"});
    EXPECT_EQ(written.code, 0) << written.err;
    EXPECT_TRUE(contains(written.out, "lab 01  tasks 1.1, 1.2 written\n")) << written.out;
    EXPECT_TRUE(contains(written.out, archive.string() + ": 3 task files. Hand in this file")) << written.out;
    EXPECT_EQ(packed(), std::string(cpp) + " " + first + " " + beside + "\n");
    EXPECT_EQ(grade::read_submission(archive, {first, cpp}).files,
              (std::map<std::string, std::string>{{first, read_all(course().path() / first)},
                                                  {cpp, read_all(course().path() / cpp)}}))
        << "the grader reads it";

    // Labs without a written task are left out, and an earlier archive is replaced with a word.
    course().overwrite(first, starter(first));
    course().overwrite(cpp, starter(cpp));
    const Result half = hand_in({"1-3,5"});
    EXPECT_EQ(half.code, 0) << half.err;
    EXPECT_TRUE(contains(half.out, "lab 05  task 5.4 written; not written: tasks 5.1, 5.2, 5.3\n")) << half.out;
    EXPECT_TRUE(contains(half.out, "nothing written, so not packed: lab 01\n")) << half.out;
    EXPECT_TRUE(contains(half.out, ", which replaces the earlier one: ")) << half.out;
    EXPECT_FALSE(contains(packed(), first));

    // Faults that can be found without a compiler: damaged text, a wrong name, a missing file.
    course().overwrite(second, read_all(course().path() / second) + "#if 1\n");
    course().overwrite("shaders/03_height_to_normal/task (1).glsl", "newer");
    fs::remove(course().path() / cpp);
    const Result faulty = hand_in({"3,5"});
    fs::remove(course().path() / "shaders/03_height_to_normal/task (1).glsl");
    EXPECT_EQ(faulty.code, 1);
    EXPECT_TRUE(contains(faulty.out, second + std::string(": line "))) << faulty.out;
    EXPECT_TRUE(contains(faulty.out, "shaders/03_height_to_normal/task (1).glsl: not packed: only task.glsl counts"))
        << faulty.out;
    EXPECT_TRUE(contains(faulty.out, cpp + std::string(": missing"))) << faulty.out;
    EXPECT_EQ(packed(), second + std::string(" ") + beside + "\n") << "packed all the same";

    const std::string before = read_all(archive);
    const Result nothing = hand_in({"1"});
    EXPECT_EQ(nothing.code, 1);
    EXPECT_EQ(nothing.err, "relief: no task is written: there is nothing to hand in\n");
    EXPECT_EQ(read_all(archive), before) << "the earlier archive stays";
}

TEST_F(CourseTest, NoHelpShowsHowItsOptionsAreWritten) {
    for (const char* command :
         {"list",    "info",  "run", "shot",   "gallery",  "check",   "golden",   "hand-in", "new-lab", "bench",
          "handout", "grade", "web", "slides", "mistakes", "inspect", "synctest", "map",     "explain", "questions"}) {
        const Result result = course().relief({command, "--help"});
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_FALSE(contains(result.out, "{") || contains(result.out, "!-")) << result.out;
    }
}

}  // namespace
}  // namespace relief::app
