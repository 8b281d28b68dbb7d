// The labs in a browser: Chromium, which draws with Mesa's llvmpipe on an X server of its own.
#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "framework/course/task/stored_zip.h"
#include "framework/staff/web/live_site.h"
#include "tests/browser.h"
#include "tests/process.h"
#include "tests/screen.h"
#include "tests/staff/handout/secrets.h"

namespace relief::web {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A server of this machine for a folder, on a free port.
class Server {
public:
    explicit Server(const fs::path& folder)
        : process_({"bash", "-c", "exec python3 -u -m http.server --bind 127.0.0.1 --directory \"$0\" 0 1>&2",
                    folder.string()}) {
        eventually([&] { return !port().empty(); });
    }
    std::string address() const { return "http://127.0.0.1:" + port() + "/"; }

private:
    std::string port() const {
        const std::string text = process_.err();
        const size_t at = text.find(" port "), end = at == text.npos ? at : text.find(' ', at + 6);
        return end == text.npos ? "" : text.substr(at + 6, end - at - 6);
    }
    Process process_;
};

/// The site, made once, and a browser. With a sample of labs, the site has these, and those that a test names.
class Web : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        std::vector<std::string> words = {relief_program(), "web", "-o", site().string()};
        std::string numbers;
        size_t count = 0;
        for (const LabEntry& lab : registry())
            if (is_in_sample(lab.two_digits()) || lab.number == 5 || lab.number == 6 || lab.number == 10)
                ++count, numbers += (numbers.empty() ? "" : ",") + lab.two_digits();
        has_all_labs_ = count == registry().size();
        if (!has_all_labs_) words.insert(words.end(), {"--labs", numbers});
        if (!tests_all()) words.push_back("--quick");
        const Result made = run(words);
        ASSERT_EQ(made.code, 0) << made.out << made.err;
        server_ = new Server(folder_->path());
        screen_ = new Screen("1600x1200x24");
        browser_ = new Browser(screen_->display());
    }
    static void TearDownTestSuite() { delete browser_, delete screen_, delete server_, delete folder_; }

    /// A subfolder of the server's: a site works from any place.
    static fs::path site() { return folder_->path() / "labs of a course"; }
    /// The students' course of which the site is made.
    static fs::path course() { return fs::path(build_folder) / (has_all_labs_ ? "web-course" : "web-course-some"); }
    static std::string page_of(const LabEntry& lab) {
        return server_->address() + "labs%20of%20a%20course/" + lab.folder + "-live.html";
    }

    static void open(const LabEntry& lab) {
        browser_->open_address(page_of(lab));
        ASSERT_EQ(browser_->wait_for("window.ready"), true) << text_of("#problem");
        browser_->eval("for (const name in pauses) pauses[name] = 0");  // a test types no second letter
        browser_->eval("slow_seconds = 60");  // beside other tests, a picture may take more than 2 s
    }
    static std::string text_of(const std::string& selector) {
        return browser_->eval("document.querySelector(" + json(selector).dump() + ").textContent");
    }
    /// Replaces the text in the editor, as by typing, and waits for the checks.
    static void write_and_check(const std::string& text) {
        const int before = browser_->eval("window.checked ?? 0");
        browser_->eval("editor.replace(" + json(text).dump() + ")");
        browser_->wait_for("(window.checked ?? 0) > " + std::to_string(before));
    }
    /// Replaces the text of task.cpp, as by typing, and waits until the page has compiled it or shows an error.
    static void compile(const std::string& text) {
        browser_->eval("window.built = 0; code_editor.replace(" + json(text).dump() + ")");
        browser_->wait_for("window.built");
    }
    static void compile_and_check(const std::string& text) {
        const int before = browser_->eval("window.checked ?? 0");
        compile(text);
        browser_->wait_for("(window.checked ?? 0) > " + std::to_string(before) + " || !$('problem').hidden");
        EXPECT_EQ(text_of("#problem"), "");
    }
    /// Returns the selector of a task's box.
    static std::string box_of(std::string id) { return "#task-" + id.replace(id.find('.'), 1, "\\."); }
    static std::string said_of(const TaskInfo& task) { return text_of(box_of(task.id) + " .points"); }
    static std::string hint_of(const std::string& task) { return text_of(box_of(task) + " .hint"); }
    /// Opens a file as a knob's picture, as its button does. Without a text, the file is a picture that the browser
    /// makes.
    static void open_own(const std::string& text, const std::string& name, const std::string& type) {
        browser_->eval("window.own = " + json({{"text", text}, {"name", name}, {"type", type}}).dump());
        browser_->eval(R"js((() => {
            const give = bytes => {
                const files = new DataTransfer(), input = document.querySelector("#knobs input[type=file]:not([multiple])");
                files.items.add(new File([bytes], own.name, {type: own.type}));
                input.files = files.files;
                input.dispatchEvent(new Event("change"));
            };
            if (own.text) return give(own.text);
            const canvas = make("canvas", {width: 64, height: 64});
            canvas.getContext("2d").fillRect(0, 0, 32, 64);
            canvas.toBlob(give, own.type);
        })())js");
    }
    /// Returns the value of the first knob that takes a picture.
    static std::string own_value() {
        return browser_->eval("lab.knobs.find(knob => knob.takes && !knob.takes.includes('OBJ')).value");
    }
    static void expect_no_complaint(const std::string& where) {
        for (const std::string& complaint : browser_->complaints()) ADD_FAILURE() << where << ": " << complaint;
        for (const std::string& address : browser_->requests())
            EXPECT_TRUE(address.starts_with(server_->address())) << where << " requests " << address;
    }
    /// Presses the button Download, and returns the file's bytes.
    static std::string download(const std::string& name) {
        browser_->call("Browser.setDownloadBehavior",
                       {{"behavior", "allow"}, {"downloadPath", folder_->path().string()}});
        browser_->eval("$('download').click()");
        const fs::path file = folder_->path() / name;
        EXPECT_TRUE(eventually([&] { return fs::exists(file) && fs::file_size(file) > 0; }));
        return read_file(file);
    }
    /// Grades a submission of a lab, and expects a line of the results.
    static void expect_grade(const fs::path& submission, const LabEntry& lab, const std::string& line) {
        const fs::path marks = folder_->path() / ("marks-" + lab.two_digits());
        const Result graded = run({relief_program(), "grade", submission.string(), "--lab", lab.two_digits(), "--trust",
                                   "-o", marks.string()});
        EXPECT_EQ(graded.code, 0) << graded.err;
        EXPECT_TRUE(contains(read_file(marks / "results.csv"), line)) << read_file(marks / "results.csv");
    }
    static void expect_stale_checks(const std::string& why) {
        EXPECT_EQ(
            browser_->eval("[...document.querySelectorAll('.row')].every(row => row.className === 'row waiting')"),
            true)
            << why << ": " << text_of("#checks");
        EXPECT_TRUE(contains(text_of("#checks"), why)) << text_of("#checks");
        EXPECT_FALSE(contains(text_of("#checks"), "points")) << text_of("#checks");
    }
    static fs::path code_of(const LabEntry& lab) { return course_root() / "labs" / lab.folder / "task.cpp"; }
    static std::string solution(const LabEntry& lab) {
        return read_file(course_root() / "shaders" / lab.folder / "task.glsl");
    }

    static inline bool has_all_labs_ = false;
    static inline TemporaryFolder* folder_ = nullptr;
    static inline Server* server_ = nullptr;
    static inline Screen* screen_ = nullptr;
    static inline Browser* browser_ = nullptr;
};

TEST_F(Web, NoFileOfTheSiteHasASecret) {
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::recursive_directory_iterator(site())) {
        const std::string kind = entry.path().extension().string();
        const bool is_compiler = entry.path().filename().string().starts_with("llvm.core");  // as the package has it
        if (entry.is_regular_file() && kind != ".png" && kind != ".exr" && !is_compiler)
            texts.emplace(entry.path().lexically_relative(site()), read_file(entry.path()));
    }
    EXPECT_TRUE(texts.contains("relief.wasm"));
    EXPECT_FALSE(fs::exists(site() / "solutions"));
    std::vector<std::string> labs;
    for (const LabEntry& lab : registry()) labs.push_back(lab.folder);
    handout::expect_no_secrets(texts, labs);
}

// The module is linked without the functions of task.cpp. The link would also accept any other function without a
// source.
TEST_F(Web, OnlyFunctionsOfTasksAreMissingInTheModule) {
    std::set<std::string> declared;
    const std::regex function(R"(\b(\w+)\([^;{}()]*\);)");
    for (const LabEntry& lab : registry()) {
        const fs::path file = course_root() / "labs" / lab.folder / "task.h";
        if (!fs::exists(file)) continue;
        const std::string text = read_file(file);
        for (std::sregex_iterator at(text.begin(), text.end(), function), end; at != end; ++at)
            declared.insert((*at)[1]);
    }
    const std::string script = read_file(site() / "relief.js");
    const std::regex missing("missing function: (\\w+)");
    size_t count = 0;
    for (std::sregex_iterator at(script.begin(), script.end(), missing), end; at != end; ++at, ++count) {
        int status = 0;
        char* const name = abi::__cxa_demangle((*at)[1].str().c_str(), nullptr, nullptr, &status);
        const std::string full = name ? name : (*at)[1].str();
        std::free(name);
        const size_t bracket = full.find('('), colon = full.rfind(':', bracket);
        EXPECT_TRUE(full.starts_with("relief::") && declared.contains(full.substr(colon + 1, bracket - colon - 1)))
            << full;
    }
    EXPECT_GE(count, 3);  // those of lab 05
}

// The solutions of all tasks have all points. A page compiles those in C++.
TEST_F(Web, EachLabDrawsAsOutsideOfABrowserAndAcceptsItsSolution) {
    // Channels that differ by more than 1/255, of 57,600. Lab 13 draws triangles as lines, also those that face away:
    // some are seen at the outline.
    const std::map<int, int> allowed = {{13, 60}};
    const std::set<int> not_compared = {5, 8, 9, 19};
    for (const LabEntry& lab : registry()) {
        SCOPED_TRACE(lab.folder);
        if (!is_in_sample(lab.two_digits())) continue;
        open(lab);
        if (fs::exists(code_of(lab))) compile(read_file(code_of(lab)));  // until then, a view may miss a task
        EXPECT_EQ(text_of("#problem"), "");
        write_and_check(solution(lab));
        const Manifest manifest = load_manifest(lab);
        const int points = manifest.points();
        EXPECT_TRUE(text_of("#points").starts_with(fmt::format("{} of {} p", points, points))) << text_of("#checks");
        for (const TaskInfo& task : manifest.tasks)
            EXPECT_TRUE(said_of(task).starts_with(fmt::format("{} of {} ", task.points, task.points))) << said_of(task);
        expect_no_complaint(lab.folder);
        if (not_compared.contains(lab.number)) continue;
        const fs::path file = folder_->path() / "native.ppm";
        ASSERT_EQ(run({relief_program(), "shot", lab.two_digits(), "--size", "160x120", "-o", file.string()}).code, 0);
        const Image native = read_image(file);
        browser_->eval(R"js(window.seen = null;
            call("shot", JSON.stringify({width: 160, height: 120, camera: home, studio: true})).then(shot => {
            window.seen = [...new Float32Array(relief.HEAPF32.buffer, shot.address,
            shot.width * shot.height * shot.channels)]; });)js");
        const json seen = browser_->wait_for("window.seen");
        ASSERT_EQ(seen.size(), native.values.size());
        int differing = 0;
        for (size_t i = 0; i < native.values.size(); ++i)
            differing += std::abs(seen[i].get<float>() - native.values[i]) > 1.01f / 255;
        EXPECT_LE(differing, allowed.contains(lab.number) ? allowed.at(lab.number) : 0);
    }
}

TEST_F(Web, AMistakeIsNamedMendedAndHandedIn) {
    const LabEntry& lab = find_lab("06");
    const MistakeInfo mistake = load_manifest(lab).mistake("handedness-forgotten");
    open(lab);
    std::string text = solution(lab);
    for (const Edit& edit : mistake.edits) text.replace(text.find(edit.find), edit.find.size(), edit.replace);
    write_and_check(text);
    EXPECT_TRUE(contains(text_of("#task-6\\.1 .hint"), mistake.hint)) << text_of("#task-6\\.1 .hint");
    EXPECT_FALSE(text_of("#points").starts_with("15 of 15"));

    write_and_check(solution(lab));
    EXPECT_TRUE(text_of("#points").starts_with("15 of 15 public points; ")) << text_of("#points");
    const std::string file = download("task.glsl");
    EXPECT_EQ(file, solution(lab));
    const fs::path submission = folder_->path() / "class" / "ada";
    fs::create_directories(submission / "shaders" / lab.folder);
    write_file(submission / "shaders" / lab.folder / "task.glsl", file);
    expect_grade(submission, lab, "ada,graded,15,15");
}

// Of lab 05, or of all five labs that have tasks in C++.
TEST_F(Web, StartersInCppFailAndMistakesAreNamed) {
    for (const LabEntry& lab : registry()) {
        SCOPED_TRACE(lab.folder);
        if (!fs::exists(code_of(lab)) || !(tests_all() || lab.number == 5)) continue;
        open(lab);
        const std::string code = read_file(code_of(lab)), file = "labs/" + lab.folder + "/task.cpp";
        const Manifest manifest = load_manifest(lab);
        compile(browser_->eval("starters.get(site.code)"));  // the browser may keep another test's text
        write_and_check(solution(lab));
        for (const TaskInfo& task : manifest.tasks) {
            if (task.file != file) continue;
            EXPECT_TRUE(said_of(task).starts_with(fmt::format("0 of {} ", task.points))) << said_of(task);
        }
        int mistakes = 0;
        for (const MistakeInfo& mistake : manifest.mistakes) {
            if (manifest.task(mistake.task).file != file || (mistakes && !tests_all())) continue;
            ++mistakes;
            std::string text = code;
            for (const Edit& edit : mistake.edits) text.replace(text.find(edit.find), edit.find.size(), edit.replace);
            compile_and_check(text);
            EXPECT_TRUE(contains(hint_of(mistake.task), mistake.hint)) << mistake.id << ": " << hint_of(mistake.task);
            const TaskInfo& task = manifest.task(mistake.task);
            EXPECT_FALSE(said_of(task).starts_with(fmt::format("{} of {} ", task.points, task.points)));
        }
        EXPECT_GT(mistakes, 0);
        expect_no_complaint(lab.folder);
    }
}

TEST_F(Web, AFaultInCppStaysInThePageAndNamesItsLine) {
    const LabEntry& lab = find_lab("05");
    open(lab);
    const std::string text = read_file(code_of(lab)), before = "    const auto& [p, uv] = triangle;\n";
    const size_t at = text.find(before);
    ASSERT_NE(at, text.npos);
    const std::string place =
        "task.cpp:" + std::to_string(1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n')) + ": ";
    const auto expect = [&](const std::string& line, const std::string& message) {
        compile(std::string(text).insert(at, "    " + line + "\n"));
        browser_->wait_for("!$('problem').hidden");
        EXPECT_TRUE(contains(text_of("#problem"), place + message)) << line << ": " << text_of("#problem");
        EXPECT_EQ(browser_->eval(
                      "$('code').shadowRoot.querySelectorAll('.cm-lint-marker-error, .cm-lintRange-error').length > 0"),
                  true)
            << line;
    };
    const std::string stops = "task 5.1 stops: ";
    expect("while (true) {}", stops + "it runs for more than");
    expect("if (triangle.uv[triangle.uv.size()].x > 0) return {};", stops + "out-of-bounds access in std::array<T, N>");
    expect("if (triangle.uv.at(triangle.uv.size()).x > 0) return {};", stops + "out_of_range was thrown: ");
    expect("volatile int zero = 0, part = 7 / zero; static_cast<void>(part);", stops + "divide by zero");
    compile(text +
            "\nstatic const int never = [] {\n    for (volatile int i = 0; i >= 0;) {\n    }\n    return 1;\n}();\n");
    browser_->wait_for("!$('problem').hidden");
    EXPECT_TRUE(contains(text_of("#problem"), "it runs for more than")) << text_of("#problem");
    expect("missing();", "use of undeclared identifier 'missing'");
    expect_stale_checks("waits for a text that compiles");
    // Until the text compiles, the page draws with the last one that did, whose errors are of no interest.
    browser_->eval("window.drawn = false; redraw().then(() => { window.drawn = true; })");
    browser_->wait_for("window.drawn");
    EXPECT_TRUE(contains(text_of("#problem"), "'missing'")) << text_of("#problem");
    compile(std::string(text).insert(at, "    int spare = 1;\n"));
    EXPECT_TRUE(contains(text_of("#warnings"), place.substr(0, place.size() - 1)) &&
                contains(text_of("#warnings"), "unused variable 'spare'"))
        << text_of("#warnings");
    browser_->wait_for("$('problem').hidden");
}

// Two files are one archive, as `relief hand-in` makes it.
TEST_F(Web, ALabInCppAndGlslIsHandedInAndGraded) {
    const LabEntry& lab = find_lab("05");
    const std::string code = read_file(code_of(lab));
    open(lab);
    compile(code);
    write_and_check(solution(lab));
    EXPECT_TRUE(text_of("#points").starts_with("14 of 14 public points; ")) << text_of("#points");
    const std::string file = download("hand-in.zip");
    EXPECT_EQ(file, check::stored_zip({{"labs/" + lab.folder + "/task.cpp", code},
                                       {"shaders/" + lab.folder + "/task.glsl", solution(lab)}}));
    const fs::path submission = folder_->path() / "class-of-archives" / "ada.zip";
    fs::create_directories(submission.parent_path());
    write_file(submission, file);
    expect_grade(submission, lab, "ada,graded,14,14");
}

TEST_F(Web, AnErrorNamesItsLine) {
    const LabEntry& lab = find_lab("06");
    open(lab);
    std::string text = solution(lab);
    const size_t at = text.find("dot(");
    const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
    text.replace(at, 4, "dott(");
    browser_->eval("editor.replace(" + json(text).dump() + ")");
    browser_->wait_for("!$('problem').hidden");
    EXPECT_TRUE(contains(text_of("#problem"), "task.glsl:" + std::to_string(line) + ": ")) << text_of("#problem");
    EXPECT_EQ(browser_->eval(
                  "$('editor').shadowRoot.querySelectorAll('.cm-lint-marker-error, .cm-lintRange-error').length > 0"),
              true);
    expect_no_complaint("the mark of an error");
    browser_->eval("editor.replace(" + json(solution(lab)).dump() + ")");
    browser_->wait_for("$('problem').hidden");
}

// The loop ends after most_rounds, so that the browser is not stuck. The canvas is small, so that it ends soon.
TEST_F(Web, AnEndlessLoopInAShaderIsStoppedAndTheTextIsKept) {
    const LabEntry& lab = find_lab("06");
    const auto write = [](const std::string& text) {
        browser_->eval("pauses.check = 1e9; editor.replace(" + json(text).dump() + ")");  // no check
    };
    open(lab);
    browser_->width(240);
    const std::string right = solution(lab) + "// mine\n", begin = "    vec3 across = ", end = "return mat3(t, ";
    write(right);
    browser_->wait_for("good_text === editor.text()");
    std::string text = right;
    text.insert(text.find(begin), "    float x = 0.5;\n    while (x < 2.0) x = 0.5 * x + 0.25;\n");
    text.insert(text.find(end) + end.size(), "x * ");
    const auto expect_stopped = [&](const std::string& why) {
        EXPECT_TRUE(text_of("#problem").starts_with("Task 6.1: does a loop not end? " + why)) << text_of("#problem");
        EXPECT_EQ(browser_->eval("editor.text()"), text);
        EXPECT_EQ(browser_->eval("$('check').disabled"), true);
    };
    browser_->eval("slow_seconds = 0.02");  // not 2 s, for which the test would wait
    write(text);
    browser_->wait_for("stopped");
    expect_stopped("A picture took ");
    expect_stale_checks("waits for a text that is drawn in time");
    EXPECT_EQ(browser_->eval("new TextDecoder().decode(relief.FS.readFile('/course/' + site.task))"), right)
        << "the page draws with the last text that was drawn in time";
    open(lab);
    expect_stopped("It was not drawn in time in an earlier visit.");
    browser_->eval("pauses.check = 1e9; document.querySelector('#problem button').click()");
    browser_->wait_for("good_text === editor.text() && $('problem').hidden");  // the student says that it ends
    text = right;
    write(text);
    browser_->wait_for("good_text === editor.text() && $('problem').hidden");
    // As when the browser ends a draw: the page begins again without the text.
    browser_->eval(
        "suspicion.set('6.1'); $('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()");
    browser_->wait_for("$('status').textContent === 'restarted without your text'");
    expect_stopped("The browser ended the drawing.");
    browser_->width(0);
    browser_->eval("pauses.check = 0");
    write_and_check(solution(lab));
    EXPECT_TRUE(text_of("#points").starts_with("15 of 15 public points; ")) << text_of("#points");
    EXPECT_EQ(text_of("#problem"), "");
}

TEST_F(Web, ATextAndAViewSurviveAReload) {
    const LabEntry& lab = find_lab("10");
    open(lab);
    browser_->eval(
        "set_knob('steps', 9).then(() => { $('knobs').elements['knob-view'].value = 'one'; "
        "$('knobs').elements['knob-view'].dispatchEvent(new Event('input')); })");
    browser_->wait_for("location.hash.includes('steps=9') && location.hash.includes('view=one')");
    const std::string text = solution(lab) + "// mine\n", address = browser_->eval("location.href");
    browser_->eval("editor.replace(" + json(text).dump() + ")");
    browser_->open_address("about:blank");
    browser_->open_address(address);
    browser_->wait_for("window.ready");
    EXPECT_EQ(browser_->eval("editor.text()"), text);
    EXPECT_EQ(browser_->eval("lab.knobs.find(knob => knob.name === 'steps').value"), "9");
    browser_->eval("editor.replace(starter)");
    EXPECT_EQ(browser_->eval("kept()"), json());
}

TEST_F(Web, AnOwnPictureAndTheTextSurviveALostContext) {
    const LabEntry& lab = find_lab("10");
    open(lab);
    write_and_check(solution(lab));
    browser_->eval("set_knob('steps', 9)");
    browser_->wait_for("lab.knobs.find(knob => knob.name === 'steps').value === '9'");
    open_own("not a picture", "none.png", "image/png");
    browser_->wait_for("!$('problem').hidden");
    EXPECT_EQ(text_of("#problem"), "/own/none.png: neither PNG, OpenEXR, JPEG, PPM, PFM nor DDS");
    EXPECT_EQ(own_value(), "wall");
    open_own("", "mine.jpg", "image/jpeg");
    browser_->wait_for("$('problem').hidden && lab.knobs.some(knob => knob.value === 'mine.png')");
    EXPECT_EQ(browser_->eval("location.hash.includes('mine')"), false);  // a link cannot have it
    browser_->eval("$('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()");
    browser_->wait_for("$('status').textContent === 'restarted'");
    EXPECT_EQ(browser_->eval("lab.knobs.find(knob => knob.name === 'steps').value"), "9");
    EXPECT_EQ(own_value(), "mine.png");
    EXPECT_EQ(browser_->eval("editor.text()"), solution(lab));
    browser_->eval("$('check').click()");
    browser_->wait_for("$('status').textContent.startsWith('checked')");
    EXPECT_TRUE(text_of("#points").starts_with("11 of 11 public points; ")) << text_of("#points");
}

TEST_F(Web, TheCoursePageShowsThePointsAndGoesOn) {
    const LabEntry& lab = find_lab("06");
    const auto open_course = [] { browser_->open_address(server_->address() + "labs%20of%20a%20course/"); };
    open_course();
    browser_->eval("localStorage.clear()");
    open_course();
    EXPECT_TRUE(text_of("a.begin").starts_with("Begin here: ")) << text_of("a.begin");
    open(lab);
    write_and_check(browser_->eval("starter + '// begun'"));
    open_course();
    EXPECT_TRUE(text_of("a.begin").starts_with("Continue with lab 06 ")) << text_of("a.begin");
    EXPECT_TRUE(contains(text_of("#lab-06 .points"), "you have 0 of 15")) << text_of("#lab-06 .points");
    open(lab);
    write_and_check(solution(lab));
    EXPECT_EQ(browser_->eval("document.querySelectorAll('.compare').length"), 0) << "this site has no solutions";
    open_course();
    EXPECT_TRUE(contains(text_of("#lab-06 .points"), "you have 15 of 15")) << text_of("#lab-06 .points");
    EXPECT_TRUE(contains(text_of(".sum"), "15of them yours")) << text_of(".sum");
    const auto place = std::find_if(registry().begin(), registry().end(), [&](const LabEntry& one) {
        return one.number > lab.number && fs::exists(site() / (one.folder + "-live.html")) &&
               !load_manifest(one).elective;
    });
    EXPECT_TRUE(text_of("a.begin").starts_with("Continue with lab " + place->two_digits())) << text_of("a.begin");
    EXPECT_EQ(browser_->eval("document.querySelector('a.begin').getAttribute('href')"), place->folder + "-live.html");
    expect_no_complaint("the course page");
}

// A site with solutions, as `relief web --solutions` makes it beside its pictures.
TEST_F(Web, APageWithAllPointsOffersTheSolutionIfTheTeacherWantsIt) {
    const LabEntry& lab = find_lab("06");
    const Manifest manifest = load_manifest(lab);
    LiveSite with_solutions{.course = course(),
                            .module = course() / "build" / (tests_all() ? "web" : "web-quick") / "bin",
                            .editor = fs::path(build_folder) / "editor" / "bundle.js",
                            .compiler = {},
                            .solutions = true,
                            .folder = folder_->path() / "with-solutions"};
    write_live_pages(with_solutions);
    browser_->open_address(server_->address() + "with-solutions/" + lab.folder + "-live.html");
    browser_->wait_for("window.ready");
    const std::string text = "// mine\n" + solution(lab);
    write_and_check(text);
    EXPECT_EQ(browser_->eval("document.querySelectorAll('.compare').length"), manifest.tasks.size());
    for (const TaskInfo& task : manifest.tasks) {
        browser_->eval("document.querySelector(" + json(box_of(task.id) + " .compare button").dump() + ").click()");
        const json columns = browser_->wait_for(
            "document.querySelector('dialog') && [...document.querySelectorAll('dialog pre')].map(one => "
            "one.textContent)");
        ASSERT_EQ(columns.size(), 3) << task.id;
        std::vector<std::string> own;
        for (const check::TaskPart& part : check::task_parts(solution(lab)))
            if (part.task == task.id) own = check::solution_lines(part.text, task.file);
        for (const std::string& line : own) {
            EXPECT_TRUE(contains(columns[0].get<std::string>(), line)) << task.id << ": " << line;
            EXPECT_TRUE(contains(columns[1].get<std::string>(), line)) << task.id << ": " << line;
        }
        EXPECT_FALSE(contains(columns[1].get<std::string>(), "//[")) << columns[1];
        EXPECT_NE(columns[2], columns[1]);
        const std::string heading = text_of("dialog section:last-child h3");
        EXPECT_TRUE(std::any_of(
            manifest.equivalents.begin(), manifest.equivalents.end(),
            [&](const EquivalentInfo& one) { return one.task == task.id && heading == "Also correct: " + one.why; }))
            << heading;
        browser_->press("Escape");
        browser_->wait_for("!document.querySelector('dialog')");
    }
    const fs::path file = with_solutions.folder / "solutions" / (lab.folder + ".json");
    EXPECT_TRUE(fs::exists(file));
    with_solutions.solutions = false;
    write_live_pages(with_solutions);
    EXPECT_FALSE(fs::exists(file)) << "the next site in this folder is made without them";
}

// The page of lab 05 has all that others have, and a second editor.
TEST_F(Web, PagesAreAccessible) {
    open(find_lab("05"));
    for (const std::string& fault : browser_->accessibility_faults()) ADD_FAILURE() << fault;
    expect_no_complaint("axe-core");
}

TEST_F(Web, TheCanvasTakesKeys) {
    open(find_lab("06"));
    ASSERT_TRUE(browser_->tab_to("#canvas"));
    browser_->press("ArrowRight", 2);
    EXPECT_EQ(browser_->eval("home.yaw - camera.yaw"), 10);
    browser_->wait_for("location.hash.includes('camera=')");
}

}  // namespace
}  // namespace relief::web
