// The menu window, with real key presses on its own X server (Xvfb).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "framework/core/base/text.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/course/pages/method_comparison.h"
#include "tests/course/app/course_with_new_lab.h"
#include "tests/screen.h"

namespace relief::app {
namespace {

using namespace std::chrono_literals;

/// One line of --verbose.
struct FrameLine {
    int number = 0;
    std::string lab;
    int objects = 0, draws = 0;
    long long bytes = 0;
};

/// The picture's position, from --verbose.
struct Place {
    int width = 0, height = 0, x = 0, y = 0, panel = 0;
    double scale = 0;
};

class Window : public testing::Test {
protected:
    explicit Window(const std::string& screen = "1300x800x24") : screen_(screen) {}
    static constexpr int window_width = 1280;
    const CourseWithNewLab& course_ = CourseWithNewLab::get();
    /// The fragment shader of the new lab. Its destructor restores the original text.
    struct Shader {
        const CourseCopy& course;
        const char* file = "shaders/20_test_wall/surface.frag";
        std::string good = read_all(course.path() / file);
        ~Shader() { restore(); }
        void overwrite(const std::string& text) const { course.overwrite(file, text); }
        void edit(const std::string& find, const std::string& replace) const { course.edit(file, find, replace); }
        void restore() const { overwrite(good); }
    } shader_{course_.course};
    TemporaryFolder folder_;
    /// The factor of Ctrl and +/- that the window keeps for its next start; gone after each test.
    struct Zoom {
        std::filesystem::path file;
        ~Zoom() {
            std::error_code none;
            std::filesystem::remove(file, none);
        }
    } zoom_{course_.course.path() / "build/window.zoom"};
    Screen screen_;
    Circumstances where_{folder_.path(),
                         {{"DISPLAY", screen_.display()}, {"WAYLAND_DISPLAY", ""}, {"LIBGL_ALWAYS_SOFTWARE", "1"}}};
    std::string program_ = course_.program("relief");  ///< has labs 01 and 20
    std::unique_ptr<Process> window_;

    void open(const std::string& lab, const std::vector<std::string>& options = {}) {
        ASSERT_EQ(course_.failure, "");
        std::vector<std::string> command = {program_, "run", lab, "--verbose"};
        command.insert(command.end(), options.begin(), options.end());
        window_ = std::make_unique<Process>(command, where_);
        ASSERT_TRUE(eventually([&] { return !frames().empty(); })) << window_->err();
        ASSERT_EQ(
            run({"xdotool", "search", "--sync", "--onlyvisible", "--name", "^Relief: ", "windowfocus"}, where_).code,
            0);
    }
    /// Opens the window without the name of a lab.
    void open_start_page() {
        ASSERT_EQ(course_.failure, "");
        window_ = std::make_unique<Process>(std::vector<std::string>{course_.program("relief"), "--verbose"}, where_);
        ASSERT_EQ(
            run({"xdotool", "search", "--sync", "--onlyvisible", "--name", "^Relief: ", "windowfocus"}, where_).code,
            0);
    }
    /// Returns the window's output, without a line that it has only begun.
    std::string whole_lines() const {
        const std::string text = window_->err();
        return text.substr(0, text.rfind('\n') + 1);
    }
    std::vector<FrameLine> frames() const {
        std::vector<FrameLine> result;
        for (const std::string& line : split(whole_lines(), '\n')) {
            FrameLine frame;
            char lab[64] = {};
            const size_t at = line.find("] frame ");
            if (at == line.npos || std::sscanf(line.c_str() + at + 2,
                                               "frame %d: %63[^,], %d GL objects, %d draw calls, %lld texture bytes",
                                               &frame.number, lab, &frame.objects, &frame.draws, &frame.bytes) != 5)
                continue;
            frame.lab = lab;
            result.push_back(frame);
        }
        return result;
    }
    Place place() const {
        const std::string text = whole_lines();
        const size_t at = text.rfind("picture: ");
        Place last;
        if (at != text.npos)
            std::sscanf(text.c_str() + at, "picture: %dx%d at %d,%d; panel %d; scale %lf", &last.width, &last.height,
                        &last.x, &last.y, &last.panel, &last.scale);
        return last;
    }
    /// Returns a screenshot by xwd with 3 channels. The window is in the upper left corner.
    Image screen() const {
        const std::filesystem::path file = folder_.path() / "screen.xwd";
        EXPECT_EQ(run({"xwd", "-root", "-silent", "-out", file}, where_).code, 0);
        const std::string bytes = read_all(file);
        const auto number = [&](size_t i) {  // the header: big-endian words
            uint32_t value = 0;
            for (size_t k = 0; k < 4; ++k) value = value << 8 | uint8_t(bytes.at(4 * i + k));
            return value;
        };
        const size_t pixels = number(0) + size_t(number(19)) * 12, line = number(12), step = number(11) / 8;
        Image image(int(number(4)), int(number(5)), 3, 8);
        if (bytes.size() < pixels + size_t(image.height) * line) throw std::runtime_error("a short screenshot");
        float* value = image.values.data();
        for (int y = 0; y < image.height; ++y) {
            const char* byte = bytes.data() + pixels + size_t(y) * line;  // blue, green, red
            for (int x = 0; x < image.width; ++x, byte += step)
                for (const int c : {2, 1, 0}) *value++ = float(uint8_t(byte[c])) / 255;
        }
        return image;
    }
    /// Returns whether the screen shows rows [first, end) of a picture at the right edge of the picture's place.
    bool shown(const Image& picture, int first = 0, int end = 1 << 20) const {
        return shown_columns(picture, 0, picture.width, first, end);
    }
    bool shown_columns(const Image& picture, int left, int right, int first = 0, int end = 1 << 20) const {
        const Image all = screen();
        const Place at = place();
        for (int y = first; y < std::min({end, picture.height, at.height}); ++y)
            for (int x = left; x < right; ++x)
                if (!std::equal(picture.pixel(x, y), picture.pixel(x, y) + 3,
                                all.pixel(at.x + at.width - picture.width + x, at.y + y)))
                    return false;
        return true;
    }
    /// Returns whether a message in the alarm colour is at the top of the picture's place.
    bool alarmed() const {
        return has_color(place().x + 20, window_width, place().y, place().y + 100,
                         [](const float* c) { return is_red(c); });
    }
    /// Returns the state of the shaders from the colour of the word in the header. The new lab has no tasks, whose
    /// signs use the same colours.
    char letter() const {
        const int left = window_width * 6 / 10, bottom = place().y;
        const auto is_green = [](const float* c) { return c[1] > 0.6f && c[0] < 0.6f && c[2] < 0.55f; };
        if (has_color(left, window_width, 0, bottom, is_green)) return 'N';
        return has_color(left, window_width, 0, bottom, is_red) ? 'F' : 'U';
    }
    static bool is_red(const float* c) { return c[0] > 0.7f && c[1] < 0.6f && c[2] < 0.5f; }
    template <class Test>
    bool has_color(int left, int right, int top, int bottom, Test test) const {
        const Image all = screen();
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x)
                if (test(all.pixel(x, y))) return true;
        return false;
    }
    /// Returns how often a text occurs in the window's output.
    size_t count(const std::string& part) const { return occurrences(window_->err(), part); }
    void drag(int x = 800, int y = 300, int to_x = 900, int to_y = 340) const {
        const auto text = [](int number) { return std::to_string(number); };
        for (const std::vector<std::string>& step :
             std::vector<std::vector<std::string>>{{"mousemove", text(x), text(y)},
                                                   {"mousedown", "1"},
                                                   {"mousemove", text(to_x), text(to_y)},
                                                   {"mouseup", "1"}}) {
            std::vector<std::string> command = {"xdotool"};
            command.insert(command.end(), step.begin(), step.end());
            EXPECT_EQ(run(command, where_).code, 0);
            std::this_thread::sleep_for(300ms);
        }
    }
    /// Clicks on sliders until one changes. They stand one below the other; the exact positions depend on the panel.
    void turn_a_knob() {
        const size_t frames_before = frames().size();
        for (int y = 195; y < 390 && frames().size() == frames_before; y += 8) {
            run({"xdotool", "mousemove", "270", std::to_string(y)}, where_);
            std::this_thread::sleep_for(100ms);
            run({"xdotool", "mousedown", "1"}, where_);
            std::this_thread::sleep_for(100ms);
            run({"xdotool", "mouseup", "1"}, where_);
            std::this_thread::sleep_for(100ms);
        }
        EXPECT_GT(frames().size(), frames_before);
        rest_the_mouse();
    }
    /// Moves the mouse to a place without a tooltip.
    void rest_the_mouse() const {
        run({"xdotool", "mousemove", "20", "700"}, where_);
        std::this_thread::sleep_for(300ms);
    }
    /// Waits until the screen no longer changes. On a busy machine that takes a while after the last event.
    void settle() const {
        Image before = screen();
        int times = 0;
        EXPECT_TRUE(eventually([&] {
            std::this_thread::sleep_for(100ms);
            Image now = screen();
            times = now.values == before.values ? times + 1 : 0;
            before = std::move(now);
            return times == 3;
        }));
    }
    /// Returns the rows of the screen in a box, for comparison.
    std::vector<float> part(int left, int right, int top, int bottom) const {
        const Image all = screen();
        std::vector<float> values;
        for (int y = top; y < bottom; ++y) values.insert(values.end(), all.pixel(left, y), all.pixel(right, y));
        return values;
    }
    /// Saves under the next free name.
    Image saved_anew() {
        int number = 1;
        const auto name = [&] { return "20_test_wall-" + std::to_string(number) + ".png"; };
        while (std::filesystem::exists(folder_.path() / name())) ++number;
        return saved(name());
    }
    void press(const char* key) const { EXPECT_EQ(run({"xdotool", "key", key}, where_).code, 0); }
    /// Holds a key as long as a hand does. Dear ImGui misses one that is down and up again between two frames.
    void hold(const char* key) const {
        EXPECT_EQ(run({"xdotool", "keydown", key}, where_).code, 0);
        std::this_thread::sleep_for(120ms);
        EXPECT_EQ(run({"xdotool", "keyup", key}, where_).code, 0);
        std::this_thread::sleep_for(120ms);
    }
    /// Presses a key and waits for a frame of that lab.
    void press_for(const char* key, const std::string& lab) {
        const size_t before = frames().size();
        press(key);
        ASSERT_TRUE(eventually([&] { return frames().size() > before && frames().back().lab == lab; }))
            << key << "\n"
            << window_->err();
    }
    /// Opens the search, types into it, and waits for results. The first search reads all labs.
    void search_for(const std::string& letters) {
        const size_t opened = count("] search: open\n"), typed = count("] search: " + letters + "\n");
        press("slash");
        EXPECT_TRUE(eventually([&] { return count("] search: open\n") > opened; })) << window_->err();
        std::this_thread::sleep_for(200ms);  // the input takes the keys in the next frame
        run({"xdotool", "type", "--delay", "80", letters}, where_);
        EXPECT_TRUE(eventually([&] { return count("] search: " + letters + "\n") > typed; })) << window_->err();
    }
    Image saved(const std::string& name) {
        press("s");
        if (eventually([&] { return std::filesystem::exists(folder_.path() / name); }))
            return read_image(folder_.path() / name);
        ADD_FAILURE() << name << "\n" << window_->err();
        return {};
    }
};

TEST_F(Window, ShowsWordsOverThePictureAndSavesThemInIt) {
    program_ = relief_program();
    const std::vector<std::string> set = {"--set", "view=compare"};
    open("06", set);
    const Image saved_picture = saved("06_tangent_space-1.png");
    const auto shot = [&](const std::vector<std::string>& more) {
        const std::string file = folder_.path() / "shot.png";
        std::vector<std::string> command = {
            program_,    "shot",   "06",
            "--context", "window", "-o",
            file,        "--size", fmt::format("{}x{}", saved_picture.width, saved_picture.height)};
        command.insert(command.end(), set.begin(), set.end());
        command.insert(command.end(), more.begin(), more.end());
        const Result result = run(command, where_);
        EXPECT_EQ(result.code, 0) << result.err;
        return read_image(file);
    };
    EXPECT_EQ(shot({}).values, saved_picture.values);
    const Image without = shot({"--words", folder_.path() / "words.html"});
    const int tile = saved_picture.height / 2;
    EXPECT_TRUE(eventually([&] { return shown(without, tile / 4, tile * 3 / 4); }));
    EXPECT_FALSE(shown(without)) << "the words are missing";
    EXPECT_FALSE(shown(saved_picture)) << "the letters are in the picture";
}

TEST_F(Window, MSavesTheMapUnderANewNameEachTime) {
    program_ = relief_program();
    open("03");
    const auto map = [&](const char* name) {
        press("m");
        EXPECT_TRUE(eventually([&] { return std::filesystem::exists(folder_.path() / name); })) << window_->err();
        return read_all(folder_.path() / name);
    };
    const std::string first = map("03_height_to_normal-map-1.png");
    EXPECT_EQ(map("03_height_to_normal-map-2.png"), first);
    EXPECT_EQ(run({program_, "shot", "03", "--map", "-o", "same.png"}, where_).code, 0);
    EXPECT_EQ(read_all(folder_.path() / "same.png"), first);
    press_for("Right", "04_object_space");
    press("m");
    EXPECT_TRUE(eventually([&] { return count("this lab makes no map; these do: 03, 07, 09") == 1; }))
        << window_->err();
}

TEST_F(Window, ABrushPaintsHeightsAndUndoTakesThemBack) {
    program_ = relief_program();
    open("03", {"--set", "view=one", "--set", "show=light", "--set", "source=bricks", "--set", "repeat=1"});
    const auto file = [&](const char* key, const std::string& name) {
        press(key);
        EXPECT_TRUE(eventually([&] { return std::filesystem::exists(folder_.path() / name); })) << window_->err();
        return read_image(folder_.path() / name);
    };
    const std::string stem = "03_height_to_normal-";
    const Image before = file("n", stem + "heights-1.png"), normals = file("m", stem + "map-1.png"),
                picture = saved(stem + "1.png");
    EXPECT_EQ(before.bits, 16);
    EXPECT_EQ(before.channels, 1);
    press("b");
    const Place at = place();
    const int x = at.x + at.width / 2, y = at.y + at.height / 2;
    drag(x - 40, y, x + 40, y);
    rest_the_mouse();
    const Image after = file("n", stem + "heights-2.png"), bumped = file("m", stem + "map-2.png");
    // The stroke is a strip of 40 texels. It is 6 above the middle, because the camera looks 5 cm above it.
    double most = 0, aside = 0;
    for (int v = 0; v < after.height; ++v)
        for (int u = 0; u < after.width; ++u) {
            const double change = *after.pixel(u, v) - *before.pixel(u, v);
            EXPECT_GE(change, -1e-4);
            (std::abs(v - after.height / 2) < 32 ? most : aside) =
                std::max(std::abs(v - after.height / 2) < 32 ? most : aside, change);
        }
    EXPECT_GT(most, 0.05);
    EXPECT_EQ(aside, 0);
    EXPECT_NE(bumped.values, normals.values) << "normals follow";
    EXPECT_NE(saved(stem + "2.png").values, picture.values);
    press("ctrl+z");
    EXPECT_EQ(file("n", stem + "heights-3.png").values, before.values);
    EXPECT_EQ(saved(stem + "3.png").values, picture.values) << "the camera stayed";
    press("ctrl+y");
    EXPECT_EQ(file("n", stem + "heights-4.png").values, after.values);
    press("Escape");
    drag(x - 40, y, x + 40, y);
    EXPECT_EQ(file("n", stem + "heights-5.png").values, after.values);
    EXPECT_NE(saved(stem + "4.png").values, saved(stem + "2.png").values) << "the camera turned";
}

TEST_F(Window, SwitchingLabsAndBackRestoresThePictureAndLeaksNothing) {
    open("01");
    const FrameLine first = frames().back();
    const Image before = saved("01_specular_highlights-1.png");
    for (int i = 0; i < 3; ++i) {
        press_for("Right", "20_test_wall");
        press_for("Left", "01_specular_highlights");
    }
    EXPECT_EQ(frames().back().objects, first.objects);
    EXPECT_EQ(frames().back().bytes, first.bytes);
    EXPECT_EQ(frames().back().draws, first.draws);
    EXPECT_EQ(saved("01_specular_highlights-2.png").values, before.values);
}

// A software renderer compiles a program in its first draw call. The window then pauses, to take events.
TEST_F(Window, PausesWhileALabCompilesAndThenDrawsTheSamePicture) {
    where_.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
    open("01");
    std::string slow = "float slow_to_compile(float x) {\n";
    for (int i = 0; i < 150; ++i) slow += "    x = sin(x + " + std::to_string(i) + ".0) * pow(x, 1.5);\n";
    shader_.edit("void main() {",
                 slow + "    return x;\n}\n\nvoid main() {\n    if (slow_to_compile(gl_FragCoord.x) > 9.0) discard;");
    press_for("Right", "20_test_wall");
    EXPECT_GE(count(": 20_test_wall, compiling"), 1u) << window_->err();
    EXPECT_EQ(count("small picture of 20_test_wall"), 1u) << window_->err();
    const Image opened = saved("20_test_wall-1.png");
    press_for("r", "20_test_wall");
    press("c");
    EXPECT_EQ(saved("20_test_wall-2.png").values, opened.values);
}

TEST_F(Window, TheCameraTurnsUntilItIsStopped) {
    open("20");
    const Image before = saved_anew();
    size_t still = frames().size();
    press("t");
    EXPECT_TRUE(eventually([&] { return frames().size() > still + 5; })) << window_->err();
    press("t");
    settle();
    const Image after = saved_anew();
    EXPECT_GT(difference(before, after, 8.0 / 255).pixels_over, before.pixel_count() / 50);
    still = frames().size();
    EXPECT_TRUE(eventually([&] { return count("asleep after ") > 0; })) << window_->err();
    EXPECT_EQ(frames().size(), still);
}

TEST_F(Window, ASliderRunsAfterARightClickUntilEscape) {
    open("20");
    const size_t still = frames().size();
    // The sliders stand one below the other; the exact places depend on the panel. A second click would stop the
    // slider.
    for (int y = 195; y < 390 && frames().size() == still; y += 8) {
        run({"xdotool", "mousemove", "270", std::to_string(y), "click", "3"}, where_);
        std::this_thread::sleep_for(300ms);
    }
    EXPECT_TRUE(eventually([&] { return frames().size() > still + 5; })) << window_->err();
    press("Escape");
    settle();
    const size_t stopped = frames().size();
    rest_the_mouse();
    EXPECT_EQ(frames().size(), stopped);
}

TEST_F(Window, DrawsNoFrameWhileNothingChanges) {
    open("20");
    // A pointer movement wakes the menu, but not the lab.
    run({"xdotool", "mousemove", "700", "400"}, where_);
    std::this_thread::sleep_for(500ms);
    EXPECT_TRUE(eventually([&] { return count("asleep after ") > 0; })) << window_->err();
    const size_t before = frames().size(), slept = count("asleep after ");
    std::this_thread::sleep_for(1500ms);
    EXPECT_EQ(count("asleep after "), slept) << "whoever draws a frame falls asleep again: " << window_->err();
    run({"xdotool", "mousemove", "900", "300"}, where_);
    EXPECT_TRUE(eventually([&] { return count("asleep after ") > slept; })) << window_->err();
    EXPECT_EQ(frames().size(), before) << window_->err();
    press_for("r", "20_test_wall");
    EXPECT_GT(frames().size(), before);
}

TEST_F(Window, ReloadsASavedShaderAndKeepsTheCamera) {
    open("20");
    drag();
    const Image before = saved("20_test_wall-1.png");
    EXPECT_EQ(letter(), 'U');
    shader_.edit("vec3(0.55, 0.20", "vec3(0.05, 0.40");
    EXPECT_TRUE(eventually([&] { return letter() == 'N'; })) << letter() << window_->err();
    const Image after = saved("20_test_wall-2.png");
    EXPECT_NE(after.values, before.values);
    EXPECT_TRUE(eventually([&] { return shown(after); }));
    shader_.restore();
    EXPECT_TRUE(eventually([&] { return saved_anew().values == before.values; }))
        << "the same camera, the same picture";
}

TEST_F(Window, AFaultOfAShaderKeepsTheLastPictureAndIsReportedUntilItIsGone) {
    open("20");
    const Image good = saved("20_test_wall-1.png");
    const auto file = course_.course.path() / shader_.file, away = folder_.write("away.frag", shader_.good);
    const std::pair<std::string, std::string> faults[] = {
        {"#version 410 core\nnonsense\n", std::string(shader_.file) + ":2: error:"},
        {replaced(shader_.good, "u_light", "u_lamp"), "'u_light'"},
        {"", "No such file"}};  // removed, and renamed back
    for (const auto& [fault, words] : faults) {
        fault.empty() ? void(std::filesystem::remove(file)) : shader_.overwrite(fault);
        ASSERT_TRUE(eventually([&] { return letter() == 'F'; })) << words << window_->err();
        EXPECT_TRUE(contains(window_->err(), words)) << words << window_->err();
        EXPECT_TRUE(eventually([&] { return alarmed(); })) << words;
        EXPECT_TRUE(shown(good, good.height / 2)) << "the lower half: " << words;
        fault.empty() ? std::filesystem::rename(away, file) : shader_.restore();
        EXPECT_TRUE(eventually([&] { return letter() == 'N' && shown(good); })) << words << window_->err();
        EXPECT_FALSE(alarmed()) << words;
    }
    EXPECT_TRUE(window_->running());
}

TEST_F(Window, ReportsAShaderBrokenAtStartAndLoadsItOnceFixed) {
    shader_.overwrite("#version 410 core\nnonsense\n");
    open("20");
    EXPECT_TRUE(contains(window_->err(), std::string(shader_.file) + ":2: error:")) << window_->err();
    EXPECT_TRUE(eventually([&] { return alarmed() && letter() == 'F'; }));
    shader_.restore();
    EXPECT_TRUE(eventually([&] { return letter() == 'N' && !alarmed(); })) << window_->err();
    saved("20_test_wall-1.png");
}

TEST_F(Window, AManifestIsReadAgainByR) {
    const char* file = "labs/20_test_wall/lab.toml";
    const std::string good = read_all(course_.course.path() / file);
    open("20");
    course_.course.overwrite(file, "nonsense\n");
    press("r");
    EXPECT_TRUE(eventually([&] { return alarmed(); })) << window_->err();
    course_.course.overwrite(file, good);
    press_for("r", "20_test_wall");
    saved("20_test_wall-1.png");
}

TEST_F(Window, TheErrorMapMatchesShotError) {
    open("20");
    settle();
    run({"xdotool", "mousemove", "100", "700"}, where_);  // over the picture it would show the values of a pixel
    const int whole = place().height;
    press("e");
    EXPECT_TRUE(eventually([&] { return place().height < whole; })) << "the legend is below the picture";
    const std::string size = std::to_string(place().width / 2) + "x" + std::to_string(place().height);
    const Result shot =
        run({course_.program("relief"), "shot", "20", "--error", "position", "--size", size, "-o", "e.png"},
            {folder_.path(), {}});
    ASSERT_EQ(shot.code, 0) << shot.err;
    // Behind the line of numbers is one about pixels with a surface in only one of the two.
    const size_t begin = shot.out.find("mean");
    const std::string numbers = shot.out.substr(begin, shot.out.find('\n', begin) - begin);
    EXPECT_TRUE(eventually([&] { return contains(window_->err(), "error map: position, " + numbers); }))
        << numbers << window_->err();
    EXPECT_EQ(count("exact values: "), 1u) << "none at the old size: " << window_->err();
    // With the scale of a lab's page. The file has no colour for pixels with a surface in only one of the two.
    ASSERT_EQ(run({course_.program("relief"), "shot", "20", "--error", "position", "--size", size, "-o", "e.pfm"},
                  {folder_.path(), {}})
                  .code,
              0);
    const Image error = read_image(folder_.path() / "e.pfm");
    const Image map = pages::error_map(pages::error_map_max(summarize(error).p99), error);
    EXPECT_TRUE(eventually([&] {
        const Image all = screen();
        const Place at = place();
        int same = 0, different = 0;
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x) {
                if (!std::isfinite(error.pixel(x, y)[0])) continue;
                const float* const wanted = map.pixel(x, y);  // not rounded to 8 bits, unlike the screen
                const bool is_same =
                    std::equal(wanted, wanted + 3, all.pixel(at.x + at.width - map.width + x, at.y + y),
                               [](float a, float b) { return std::abs(a - b) < 1.5f / 255; });
                ++(is_same ? same : different);
            }
        return same > 10000 && different == 0;
    })) << "nothing covers it";
    const size_t maps = count("error map: ");
    run({"xdotool", "mousemove", "700", "400"}, where_);
    std::this_thread::sleep_for(1s);
    EXPECT_EQ(count("error map: "), maps) << "nothing changed";
    press("e");
    EXPECT_TRUE(eventually([&] { return frames().size() >= 3; })) << "the picture takes its room back";
}

TEST_F(Window, OpensWithAProbeAndACameraAndAClickPinsAPixelsValues) {
    const std::vector<std::string> options = {"--probe", "position", "--camera", "10,15,2.5"};
    std::vector<std::string> with_map = options;
    with_map.emplace_back("--error-map");
    open("20", with_map);
    std::vector<std::string> shot = {course_.program("relief"),
                                     "shot",
                                     "20",
                                     "--size",
                                     std::to_string(place().width / 2) + "x" + std::to_string(place().height),
                                     "-o",
                                     "p.pfm"};
    shot.insert(shot.end(), options.begin(), options.end());
    ASSERT_EQ(run(shot, {folder_.path(), {}}).code, 0);
    const Image values = read_image(folder_.path() / "p.pfm");
    ASSERT_TRUE(eventually([&] { return count("error map: position") == 1; })) << window_->err();
    const int x = 230, y = 400;
    run({"xdotool", "mousemove", std::to_string(place().x + x), std::to_string(place().y + y)}, where_);
    std::this_thread::sleep_for(300ms);
    run({"xdotool", "click", "1"}, where_);
    const float* const pixel = values.pixel(x, y);
    ASSERT_EQ(pixel[2], 0) << "the wall's plane; a last number that is 0 is not shown";
    const std::string numbers = rounded(double(pixel[0]), 5) + "  " + rounded(double(pixel[1]), 5);
    EXPECT_TRUE(eventually([&] { return count("pixel 230, 400: position, value " + numbers + ", exact ") == 1; }))
        << numbers << window_->err();
}

TEST_F(Window, PTracesAPixelThroughTheTaskFunctionsAndEMapsTheErrorOfTheFirstProbe) {
    open("01");
    const Image picture = saved("01_specular_highlights-1.png");
    run({"xdotool", "mousemove", std::to_string(place().x + 520), std::to_string(place().y + 250)}, where_);
    settle();
    press("p");
    EXPECT_TRUE(eventually([&] { return count("pixel 520, 250: direction_of_texel, ") == 1; })) << window_->err();
    EXPECT_TRUE(eventually([&] { return !shown(picture); }));
    press("Escape");
    rest_the_mouse();
    EXPECT_TRUE(eventually([&] { return shown(picture); })) << "Escape closes it";
    EXPECT_TRUE(window_->running());
    press("e");
    ASSERT_TRUE(eventually([&] { return count("error map: ") == 1; })) << window_->err();
    EXPECT_EQ(count("error map: normal, mean"), 1u) << "the direction comes first in the manifest: " << window_->err();
}

TEST_F(Window, TheErrorMapUpdatesWhenADragEnds) {
    open("20");
    press("e");
    ASSERT_TRUE(eventually([&] { return count("error map: ") == 1; })) << window_->err();
    run({"xdotool", "mousemove", "500", "300"}, where_);
    std::this_thread::sleep_for(200ms);
    run({"xdotool", "mousedown", "1"}, where_);
    for (int i = 0; i < 3; ++i) {
        const size_t before = frames().size();
        run({"xdotool", "mousemove", std::to_string(520 + 20 * i), "310"}, where_);
        EXPECT_TRUE(eventually([&] { return frames().size() > before; }));
        std::this_thread::sleep_for(600ms);  // longer than the time that counts as still
    }
    EXPECT_EQ(count("error map: "), 1u);
    run({"xdotool", "mouseup", "1"}, where_);
    EXPECT_TRUE(eventually([&] { return count("error map: ") == 2; })) << window_->err();
}

TEST_F(Window, TheHandoutAndTheListOfKeysOpenBesideThePictureAndEscapeClosesThem) {
    open("01");
    const Image picture = saved("01_specular_highlights-1.png");
    ASSERT_TRUE(eventually([&] { return shown(picture); }));
    for (const auto& [key, close] : {std::pair("F1", "F1"), {"F1", "Escape"}, {"question", "Escape"}}) {
        press(key);
        EXPECT_TRUE(eventually([&] { return !shown(picture); }));
        press(close);
        EXPECT_TRUE(eventually([&] { return shown(picture); })) << key << close;
    }
    EXPECT_TRUE(window_->running());
    // A lab without a handout shows a message and continues.
    const auto file = course_.course.path() / "labs/01_specular_highlights/README.md";
    std::filesystem::rename(file, folder_.path() / "README.md");
    press("F1");
    EXPECT_TRUE(eventually([&] { return !shown(picture); }));
    std::filesystem::rename(folder_.path() / "README.md", file);
    press("Escape");
    EXPECT_TRUE(eventually([&] { return shown(picture); }));
}

TEST_F(Window, TheHandoutShowsADiagramOrTheAltTextOfABrokenOne) {
    const char* file = "labs/20_test_wall/README.md";
    const std::string good = read_all(course_.course.path() / file);
    course_.course.overwrite("labs/20_test_wall/square.svg",
                             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 40 20\">"
                             "<rect x=\"10\" y=\"5\" width=\"20\" height=\"10\" fill=\"#ff00ff\"/></svg>");
    course_.course.overwrite("labs/20_test_wall/broken.svg", "<svg viewBox=\"0 0 40 20\">");
    for (const bool is_broken : {true, false}) {
        course_.course.overwrite(file, is_broken ? "![words](broken.svg)\n" : "![words](square.svg)\n");
        open("20");
        press("F1");
        ASSERT_TRUE(eventually([&] { return place().x + place().width < window_width; })) << window_->err();
        settle();
        const Place at = place();
        const Image all = screen();
        double paper = 0, drawn = 0;
        for (int y = at.y; y < at.y + 400; ++y)
            for (int x = at.x + at.width; x < window_width; ++x) {
                const float* const color = all.pixel(x, y);
                paper += color[0] == 1 && color[1] == 1 && color[2] == 1;
                drawn += color[0] == 1 && color[1] == 0 && color[2] == 1;
            }
        if (is_broken) {
            EXPECT_EQ(drawn, 0);
            EXPECT_LT(paper, 1000) << "the letters of a button, at the most";
        } else {
            EXPECT_GT(drawn, 10000);
            EXPECT_GT(paper, 3 * drawn) << "around the square, which is a quarter, and a margin";
        }
        EXPECT_EQ(count("handout: broken.svg: "), is_broken ? 1u : 0u) << "tried once";
        EXPECT_TRUE(window_->running());
    }
    course_.course.overwrite(file, good);
}

TEST_F(Window, UndoAndRedoRestoreKnobsAndCameraAndCTheCamera) {
    open("20");
    const Image before = saved("20_test_wall-1.png");
    turn_a_knob();
    const Image after = saved("20_test_wall-2.png");
    ASSERT_NE(after.values, before.values);
    drag();
    const Image turned = saved("20_test_wall-3.png");
    EXPECT_NE(turned.values, after.values);
    press_for("ctrl+z", "20_test_wall");
    EXPECT_EQ(saved("20_test_wall-4.png").values, after.values) << "the camera is undone";
    press_for("ctrl+z", "20_test_wall");
    EXPECT_EQ(saved("20_test_wall-5.png").values, before.values) << "the knob is undone";
    press_for("ctrl+y", "20_test_wall");
    press_for("ctrl+y", "20_test_wall");
    EXPECT_EQ(saved("20_test_wall-6.png").values, turned.values);
    press_for("c", "20_test_wall");
    EXPECT_EQ(saved("20_test_wall-7.png").values, after.values);
}

TEST_F(Window, AHoldsAPictureLeftOfADraggableBorder) {
    open("20");
    const Image a = saved("20_test_wall-1.png");
    press("a");
    turn_a_knob();
    const Image b = saved("20_test_wall-2.png");
    ASSERT_NE(a.values, b.values);
    const int names = 60, reach = 16;  // rows of the two labels; columns of the border and its handle
    const auto wiped = [&](int at) {
        return shown_columns(a, 0, at - reach, names) && shown_columns(b, at + reach, b.width, names);
    };
    EXPECT_TRUE(eventually([&] { return wiped(b.width / 2); }));
    const Place at = place();
    drag(at.x + at.width / 2, at.y + at.height / 2, at.x + at.width / 4, at.y + at.height / 2);
    rest_the_mouse();
    EXPECT_TRUE(eventually([&] { return wiped(b.width / 4); }));
    press_for("x", "20_test_wall");
    EXPECT_EQ(saved("20_test_wall-3.png").values, a.values) << "A is the present setting now";
    press("a");
    EXPECT_TRUE(eventually([&] { return shown(a); })) << "the whole picture again";
}

TEST_F(Window, ThePanelIsAsWideAsItsBorderIsDragged) {
    open("20");
    const Place before = place();
    drag(before.panel, 500, before.panel + 100, 500);
    EXPECT_TRUE(eventually([&] { return std::abs(place().panel - before.panel - 100) <= 5; })) << place().panel;
    EXPECT_EQ(place().x, place().panel);
    EXPECT_EQ(place().x + place().width, window_width);
}

TEST_F(Window, ControlPlusAndMinusScaleTheInterface) {
    open("20");
    const Place before = place();
    press("ctrl+plus");
    EXPECT_TRUE(eventually([&] { return place().scale > before.scale; }));
    EXPECT_GT(place().panel, before.panel);
    EXPECT_GT(place().y, before.y) << "the header, too";
    press("ctrl+minus");
    press("ctrl+minus");
    EXPECT_TRUE(eventually([&] { return place().scale < before.scale; }));
    press("ctrl+0");
    EXPECT_TRUE(eventually([&] { return place().scale == before.scale && place().panel == before.panel; }));
}

TEST_F(Window, StartsAgainWithTheSizeThatItsUserChoseLast) {
    open("20");
    const Place usual = place();
    press("ctrl+plus");
    EXPECT_TRUE(eventually([&] { return place().scale > usual.scale; }));
    const Place chosen = place();
    press("ctrl+q");
    EXPECT_EQ(window_->wait().code, 0);
    open("20");
    EXPECT_EQ(place().scale, chosen.scale);
    EXPECT_EQ(place().panel, chosen.panel);
}

TEST_F(Window, KeysReachTheKnobsAfterF6AndAreTheLabsAgainAfterEscape) {
    open("20");
    const Image before = saved_anew();
    const size_t still = frames().size();
    press("F6");
    EXPECT_TRUE(eventually([&] { return count("keys: panel") == 1; })) << window_->err();
    // Past the names of the pages and the probes to the first knob, a slider. Space takes it, an arrow changes it, and
    // a second space lets go of it.
    for (const char* key : {"Down", "Down", "Down", "Down", "Down", "space", "Right", "space"}) hold(key);
    EXPECT_TRUE(eventually([&] { return frames().size() > still; })) << window_->err();
    EXPECT_EQ(frames().back().lab, "20_test_wall") << "the arrows open no other lab";
    press("Escape");
    EXPECT_TRUE(eventually([&] { return count("keys: the lab") == 1; })) << window_->err();
    EXPECT_NE(saved_anew().values, before.values);
    press_for("Right", "01_specular_highlights");
}

TEST_F(Window, HeaderAndStatusStayWhileThePanelScrolls) {
    open("01");
    ASSERT_TRUE(eventually([&] { return count("checks: ") == 1; })) << window_->err();
    for (int i = 0; i < 9; ++i) press("ctrl+plus");
    settle();
    const Place at = place();
    // Over the picture the mouse shows no tooltip.
    const auto mouse_to = [&](int x) {
        run({"xdotool", "mousemove", std::to_string(x), "500"}, where_);
        settle();
    };
    mouse_to(at.x + 100);
    const auto header = [&] { return part(0, window_width, 0, at.y); };
    const auto status = [&] { return part(0, window_width, at.y + at.height, 800); };
    const auto panel = [&] { return part(0, at.panel, at.y + 120, at.y + at.height); };
    const auto header_before = header(), status_before = status(), panel_before = panel();
    mouse_to(at.x / 2);
    for (int i = 0; i < 5; ++i) run({"xdotool", "click", "5"}, where_);
    mouse_to(at.x + 100);
    EXPECT_TRUE(eventually([&] { return panel() != panel_before; }));
    EXPECT_EQ(header() == header_before, true);
    EXPECT_EQ(status() == status_before, true);
}

TEST_F(Window, SearchFindsALabByAPartOfItsName) {
    open("20");
    search_for("specu");
    EXPECT_EQ(frames().back().lab, "20_test_wall") << "letters are no keys while one types";
    press_for("Return", "01_specular_highlights");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "20_test_wall-1.png"));
}

TEST_F(Window, SearchFindsAKnobOfAnotherLab) {
    open("20");
    search_for("shininess");
    press_for("Return", "01_specular_highlights");
}

TEST_F(Window, SearchFindsAValueOfAKnobInWordsAndSetsIt) {
    open("01");
    const Image before = saved("01_specular_highlights-1.png");
    search_for("side by side");  // the value side-by-side of the knob method
    press_for("Return", "01_specular_highlights");
    rest_the_mouse();
    const Image after = saved("01_specular_highlights-2.png");
    EXPECT_NE(after.values, before.values);
    const Result shot = run({course_.program("relief"), "shot", "01", "--set", "method=side-by-side", "--size",
                             fmt::format("{}x{}", after.width, after.height), "-o", "beside.png"},
                            {folder_.path(), {}});
    EXPECT_EQ(shot.code, 0) << shot.err;
    EXPECT_EQ(after.values, read_image(folder_.path() / "beside.png").values);
}

TEST_F(Window, SearchOpensAHandoutAtAHeadingAndTheGlossaryAtAWord) {
    const char* file = "labs/20_test_wall/README.md";
    const std::string good = read_all(course_.course.path() / file);
    std::string lines = "# A lab\n\n";
    for (int i = 0; i < 200; ++i) lines += "A line.\n\n";
    course_.course.overwrite(file, lines + "## Quaternionic\n\nThe end.\n");
    course_.course.overwrite("labs/GLOSSARY.md", "| word | meaning |\n|---|---|\n| umbra | the dark part |\n");
    open("20");
    // The mark is the only large area of its colour in the handout.
    const auto marked = [&] {
        const Place at = place();
        return has_color(at.x + at.width, window_width, at.y, at.y + at.height, [](const float* c) {
            return std::abs(c[0] - 0.312f) < 0.02f && std::abs(c[1] - 0.217f) < 0.02f &&
                   std::abs(c[2] - 0.179f) < 0.02f;
        });
    };
    search_for("quaternionic");
    press("Return");
    EXPECT_TRUE(eventually([&] { return place().x + place().width < window_width && marked(); })) << window_->err();
    press("Escape");
    EXPECT_TRUE(eventually([&] { return place().x + place().width == window_width; }));
    search_for("umbra");
    press("Return");
    EXPECT_TRUE(eventually([&] { return place().x + place().width < window_width && marked(); })) << window_->err();
    course_.course.overwrite(file, good);
}

TEST_F(Window, TheChecksReportTheSameAsReliefCheck) {
    // A handout makes the data by which known mistakes are named.
    const std::filesystem::path course = course_.course.path();
    std::filesystem::create_directories(course / "framework/staff/handout");
    for (const char* name : {"framework/staff/handout/handout_readme.md", "framework/staff/handout/handout_check.yml"})
        std::filesystem::copy_file(std::filesystem::path(source_folder) / name, course / name);
    const Result handout =
        run({course_.program("relief"), "handout", "-o", folder_.path() / "students", "--labs", "1"});
    ASSERT_EQ(handout.code, 0) << handout.err;
    const Result check = run({course_.program("relief"), "check", "01"}, {folder_.path(), {}});
    ASSERT_TRUE(contains(check.out, "3 to 5 of 5 points")) << check.out << check.err;
    open("01");
    EXPECT_TRUE(eventually([&] { return count("checks: 3 to 5 of 5 points") == 1; })) << window_->err();
    const size_t frames_before = frames().size();
    const std::string task = "shaders/01_specular_highlights/task.glsl";
    const std::string good = read_all(course_.course.path() / task);
    const std::string hint = "look at: A stored 0.5 means 0: without the shift every normal leans towards (1, 1, 1).";
    EXPECT_EQ(count(hint), 0u);
    course_.course.edit(task, "stored * 2.0 - 1.0", "stored");
    const Result wrong = run({course_.program("relief"), "check", "01"}, {folder_.path(), {}});
    const std::string points = wrong.out.substr(wrong.out.rfind('\n', wrong.out.size() - 2) + 1);
    EXPECT_TRUE(eventually([&] { return count("checks: " + points) == 1; })) << points << window_->err();
    EXPECT_TRUE(contains(wrong.out, hint)) << wrong.out;
    EXPECT_EQ(count(hint), 1u) << window_->err();
    course_.course.overwrite(task, good);
    EXPECT_TRUE(eventually([&] { return count("checks: 3 to 5 of 5 points") == 2; })) << window_->err();
    EXPECT_LE(frames().size(), frames_before + 4) << "checks draw into targets of their own";
}

TEST_F(Window, ACheckShowsYoursAndTheExpectedPictureAndThenThePictureWithItsKnobs) {
    const std::string name = "bricks on a column";
    const std::string task = "shaders/01_specular_highlights/task.glsl";
    const std::string good = read_all(course_.course.path() / task);
    course_.course.edit(task, "stored * 2.0 - 1.0", "1.0 - stored * 2.0");
    // The probe of a direction has the same colours alone and beside another one.
    const std::vector<std::string> view = {"--camera", "4,8,0.35,1.4,1.3,1.65,20", "--set", "method=normal-map"};
    const auto shot = [&](const char* size, const char* file, const char* what) {
        std::vector<std::string> command = {
            course_.program("relief"), "shot", "01", what, "normal", "--size", size, "-o", file};
        command.insert(command.end(), view.begin(), view.end());
        const Result result = run(command, {folder_.path(), {}});
        EXPECT_EQ(result.code, 0) << result.err;
        return read_image(folder_.path() / file);
    };
    const Image yours = shot("128x128", "yours.png", "--probe"), expected = shot("128x128", "truth.png", "--truth");
    ASSERT_NE(yours.values, expected.values);
    window_ = std::make_unique<Process>(
        std::vector<std::string>{course_.program("relief"), "run", "01", "--verbose", "--check", name}, where_);
    EXPECT_TRUE(eventually([&] { return count("checks: ") == 1; })) << window_->err();
    run({"xdotool", "search", "--sync", "--onlyvisible", "--name", "^Relief: ", "windowfocus"}, where_);
    rest_the_mouse();  // over a pane it would show the values of a pixel
    // The magnification is an integer: 3 if there is room for two panes of 384 pixels side by side.
    const auto place_of = [&](const Image& picture, int left, int right) {
        const Image all = screen();
        for (const int factor : {2, 3, 4})
            for (int top = place().y; top < 300; ++top)
                for (int x0 = place().x; x0 < place().x + 40; ++x0) {
                    bool same = true;
                    for (int y = 30; same && y < 120; y += 7)
                        for (int x = left; same && x < right; x += 5)
                            same = std::equal(picture.pixel(x, y), picture.pixel(x, y) + 3,
                                              all.pixel(x0 + x * factor, top + y * factor));
                    if (same) return factor;
                }
        return 0;
    };
    EXPECT_TRUE(eventually([&] { return place_of(yours, 2, 60) > 0; })) << "left of the border";
    EXPECT_GT(place_of(expected, 68, 126), 0) << "right of it";
    EXPECT_EQ(frames().size(), 0u) << "the picture itself is not drawn where nobody sees it";
    press("Escape");
    EXPECT_TRUE(eventually([&] { return !frames().empty(); })) << window_->err();
    const Image live = saved("01_specular_highlights-1.png");
    const std::string size = std::to_string(place().width) + "x" + std::to_string(place().height);
    EXPECT_EQ(shot(size.c_str(), "live.png", "--probe").values, live.values) << "its knobs, camera and probe";
    course_.course.overwrite(task, good);
}

TEST_F(Window, AKnobsNameInTheHandoutSetsTheValueAfterIt) {
    const char* file = "labs/20_test_wall/README.md";
    const std::string good = read_all(course_.course.path() / file);
    course_.course.overwrite(file, "`tiles` 3, or `tiles=5`\n");
    open("20");
    press("F1");
    EXPECT_TRUE(eventually([&] { return frames().size() >= 2; }));
    settle();
    const Place at = place();
    ASSERT_LT(at.x + at.width, window_width) << "the handout stands right of the picture";
    run({"xdotool", "mousemove", std::to_string(at.x + at.width + 18 + 15), std::to_string(at.y + 12 + 10)}, where_);
    std::this_thread::sleep_for(300ms);
    const size_t before = frames().size();
    run({"xdotool", "click", "1"}, where_);
    EXPECT_TRUE(eventually([&] { return frames().size() > before; })) << window_->err();
    const Image after = saved("20_test_wall-1.png");
    const Result shot = run({course_.program("relief"), "shot", "20", "--set", "tiles=3", "--size",
                             std::to_string(at.width) + "x" + std::to_string(at.height), "-o", "three.png"},
                            {folder_.path(), {}});
    EXPECT_EQ(shot.code, 0) << shot.err;
    EXPECT_EQ(after.values, read_image(folder_.path() / "three.png").values);
    course_.course.overwrite(file, good);
}

TEST_F(Window, EscapeClosesAListAndDoesNotEndTheWindow) {
    open("20");
    // The place where the list of labs opens, below its closed line.
    const auto below = [&] {
        const Image all = screen();
        return std::vector<float>(all.pixel(0, 45), all.pixel(0, 90));
    };
    run({"xdotool", "mousemove", "150", "20"}, where_);
    settle();
    const std::vector<float> closed = below();
    run({"xdotool", "click", "1"}, where_);
    ASSERT_TRUE(eventually([&] { return below() != closed; })) << window_->err();
    press("Escape");
    EXPECT_TRUE(eventually([&] { return below() == closed; })) << window_->err();
    press("Escape");
    settle();
    EXPECT_TRUE(window_->running());
}

TEST_F(Window, StartsWithAllLabsAndTheirPointsAndDrawsALabOnlyWhenItIsOpened) {
    open_start_page();
    EXPECT_TRUE(eventually([&] { return count("start page: 20_test_wall: no tasks") == 1; })) << window_->err();
    EXPECT_EQ(count("start page: 01_specular_highlights: 3 to 5 of 5 points"), 1u) << window_->err();
    EXPECT_TRUE(frames().empty()) << window_->err();
    press("Right");
    press_for("Return", "20_test_wall");
    press("Home");
    press("Left");
    press_for("Return", "01_specular_highlights");
}

TEST_F(Window, TheStartPageChecksALabAnewOnlyAfterOneOfItsFilesWasSaved) {
    const char* task = "shaders/01_specular_highlights/task.glsl";
    const std::string good = read_all(course_.course.path() / task);
    open_start_page();
    ASSERT_TRUE(eventually([&] { return count("start page: 20_test_wall: ") == 1; })) << window_->err();
    press_for("Return", "01_specular_highlights");
    press("Home");
    ASSERT_TRUE(eventually([&] { return count("start page: up to date") == 2; })) << window_->err();
    EXPECT_EQ(count("start page: 01_specular_highlights: "), 1u) << window_->err();
    press("Return");  // the lab keeps its picture
    course_.course.overwrite(task, "// nothing\n");
    press("Home");
    EXPECT_TRUE(eventually([&] { return count("start page: 01_specular_highlights: 0 of 5 points") == 1; }))
        << window_->err();
    course_.course.overwrite(task, good);
}

TEST_F(Window, TheStartPageNamesTheLabThatWasEditedLast) {
    const std::filesystem::path task = course_.course.path() / "shaders/01_specular_highlights/task.glsl";
    const auto unpacked =
        std::filesystem::last_write_time(course_.course.path() / "labs/01_specular_highlights/lab.toml");
    for (const auto& [minutes, times] : {std::pair(0, 0u), {5, 1}}) {
        std::filesystem::last_write_time(task, unpacked + std::chrono::minutes(minutes));
        open_start_page();
        ASSERT_TRUE(eventually([&] { return count("start page: all pictures are loaded") == 1; })) << window_->err();
        EXPECT_EQ(count("start page: edited last: 01_specular_highlights"), times) << window_->err();
        press("ctrl+q");
        EXPECT_EQ(window_->wait().code, 0);
    }
}

TEST_F(Window, AnOldDriverIsReported) {
    Circumstances where = where_;
    where.environment["GALLIUM_DRIVER"] = "softpipe";
    const Result result = run({course_.program("relief"), "shot", "20", "--context", "window", "-o", "w.png"}, where);
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "no window: the driver is softpipe, which has OpenGL ")) << result.err;
}

TEST_F(Window, GivesAContextToShotsToo) {
    const Result result =
        run({course_.program("relief"), "shot", "20", "--size", "64x48", "--context", "window", "-o", "w.png"}, where_);
    EXPECT_EQ(result.code, 0) << result.err;
    const Result headless = run({course_.program("relief"), "shot", "20", "--size", "64x48", "-o", "o.png"}, where_);
    EXPECT_EQ(headless.code, 0) << headless.err;
    EXPECT_EQ(read_all(folder_.path() / "w.png"), read_all(folder_.path() / "o.png")) << "one Mesa, the same bits";
}

/// A display of 2560 x 1440 pixels, without a scale set by the desktop.
class WindowOnALargeDisplay : public Window {
protected:
    WindowOnALargeDisplay() : Window("2560x1440x24") {}
};

TEST_F(WindowOnALargeDisplay, IsLargerSoThat1080ScaledRowsRemain) {
    open("20");
    EXPECT_NEAR(place().scale, 1440.0 / 1080, 0.005) << "as --verbose rounds it";
    EXPECT_EQ(place().panel, 340 * 1440 / 1080);
}

}  // namespace
}  // namespace relief::app
