// The menu window, with real key presses on an X server of its own (Xvfb).
#include <chrono>
#include <regex>
#include <thread>

#include "framework/image/file.h"
#include "tests/app/course_with_new_lab.h"

namespace relief {
namespace {

using namespace std::chrono_literals;

/// Waits until something holds, ten seconds at the most: a software renderer shares two cores with other tests.
template <class Condition>
bool eventually(Condition condition) {
    for (int i = 0; i < 200; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(50ms);
    }
    return condition();
}

/// An X server on the first display that is free.
class Screen {
public:
    Screen() {
        server_ = std::make_unique<Process>(
            std::vector<std::string>{"bash", "-c", "exec Xvfb -displayfd 2 -screen 0 1300x800x24 -nolisten tcp 2>&2"});
        eventually([&] { return !number().empty(); });
    }
    std::string display() const { return ":" + number(); }

private:
    std::string number() const {
        static const std::regex whole_line("(^|\n)([0-9]+)\n");
        std::smatch found;
        const std::string text = server_->err();
        return std::regex_search(text, found, whole_line) ? found[2].str() : "";
    }
    std::unique_ptr<Process> server_;
};

/// One line of --verbose.
struct FrameLine {
    int number = 0;
    std::string lab;
    int objects = 0, draws = 0;
    long long bytes = 0;
};

class Window : public testing::Test {
protected:
    const CourseWithNewLab& course_ = CourseWithNewLab::get();
    TemporaryFolder folder_;
    Screen screen_;
    Circumstances where_{folder_.path(),
                         {{"DISPLAY", screen_.display()}, {"WAYLAND_DISPLAY", ""}, {"LIBGL_ALWAYS_SOFTWARE", "1"}}};
    std::unique_ptr<Process> window_;

    void open(const std::string& lab) {
        ASSERT_EQ(course_.failure, "");
        window_ = std::make_unique<Process>(
            std::vector<std::string>{course_.program("relief"), "run", lab, "--verbose"}, where_);
        ASSERT_TRUE(eventually([&] { return !frames().empty(); })) << window_->err();
        ASSERT_EQ(
            run({"xdotool", "search", "--sync", "--onlyvisible", "--name", "^Relief: ", "windowfocus"}, where_).code,
            0);
    }
    std::vector<FrameLine> frames() const {
        static const std::regex form(
            "frame (\\d+): (\\w+), (\\d+) GL objects, (\\d+) draw calls, (\\d+) texture bytes");
        std::vector<FrameLine> result;
        const std::string text = window_->err();
        for (auto found = std::sregex_iterator(text.begin(), text.end(), form); found != std::sregex_iterator();
             ++found)
            result.push_back({std::stoi((*found)[1]), (*found)[2], std::stoi((*found)[3]), std::stoi((*found)[4]),
                              std::stoll((*found)[5])});
        return result;
    }
    void press(const char* key) const { EXPECT_EQ(run({"xdotool", "key", key}, where_).code, 0); }
    /// Presses and waits for the frame of that lab.
    void press_for(const char* key, const std::string& lab) {
        const size_t before = frames().size();
        press(key);
        ASSERT_TRUE(eventually([&] { return frames().size() > before && frames().back().lab == lab; }))
            << key << "\n"
            << window_->err();
    }
    Image saved(const std::string& name) {
        press("s");
        if (eventually([&] { return std::filesystem::exists(folder_.path() / name); }))
            return read_image(folder_.path() / name);
        ADD_FAILURE() << name << "\n" << window_->err();
        return {};
    }
};

TEST_F(Window, SwitchingThereAndBackGivesTheSamePictureAndLeaksNothing) {
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

TEST_F(Window, StandsStillWhenNothingChanges) {
    open("20");
    // The pointer comes and goes: that wakes the menu, not the lab.
    run({"xdotool", "mousemove", "700", "400"}, where_);
    std::this_thread::sleep_for(500ms);
    const size_t before = frames().size();
    std::this_thread::sleep_for(1500ms);
    run({"xdotool", "mousemove", "900", "300"}, where_);
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(frames().size(), before) << window_->err();
    press_for("r", "20_test_wall");
    EXPECT_GT(frames().size(), before);
}

TEST_F(Window, DraggingTurnsTheCameraAndCBringsItBack) {
    open("20");
    const Image before = saved("20_test_wall-1.png");
    for (const std::vector<std::string>& step : std::vector<std::vector<std::string>>{
             {"mousemove", "800", "300"}, {"mousedown", "1"}, {"mousemove", "900", "340"}, {"mouseup", "1"}}) {
        std::vector<std::string> command = {"xdotool"};
        command.insert(command.end(), step.begin(), step.end());
        EXPECT_EQ(run(command, where_).code, 0);
        std::this_thread::sleep_for(300ms);
    }
    EXPECT_NE(saved("20_test_wall-2.png").values, before.values);
    press_for("c", "20_test_wall");
    EXPECT_EQ(saved("20_test_wall-3.png").values, before.values);
}

TEST_F(Window, ABrokenShaderIsShownAndMendedByR) {
    const char* file = "shaders/20_test_wall/surface.frag";
    const std::string good = read_all(course_.course.path() / file);
    course_.course.overwrite(file, "#version 410 core\nnonsense\n");
    open("20");
    EXPECT_TRUE(contains(window_->err(), std::string(file) + ":2: error:")) << window_->err();
    EXPECT_TRUE(window_->running());
    course_.course.overwrite(file, good);
    press_for("r", "20_test_wall");
    saved("20_test_wall-1.png");
}

TEST_F(Window, EscapeEndsItWithExitCodeZero) {
    open("20");
    press("Escape");
    EXPECT_TRUE(eventually([&] { return !window_->running(); }));
    EXPECT_EQ(window_->wait().code, 0);
}

TEST_F(Window, GivesAContextToShotsToo) {
    const Result result =
        run({course_.program("relief"), "shot", "20", "--size", "64x48", "--context", "window", "-o", "w.png"}, where_);
    EXPECT_EQ(result.code, 0) << result.err;
    const Result headless = run({course_.program("relief"), "shot", "20", "--size", "64x48", "-o", "o.png"}, where_);
    EXPECT_EQ(headless.code, 0) << headless.err;
    EXPECT_EQ(read_all(folder_.path() / "w.png"), read_all(folder_.path() / "o.png")) << "one Mesa, the same bits";
}

}  // namespace
}  // namespace relief
