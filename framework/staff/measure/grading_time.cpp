// Grading submissions: the grader, compared with the simple loop that teachers write: build, draw, idiff. The loop has
// no sandbox, hidden views, exact values or hints.
#include <fmt/format.h>

#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/module.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/paths.h"
#include "framework/staff/class/class.h"
#include "framework/staff/grade/marks.h"
#include "framework/staff/measure/bench.h"

namespace relief::measure {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Returns a correct submission. Each text is different, so that no cache has seen it.
std::string handed_in(const std::string& file, size_t number) {
    return read_file(course_root() / file) + fmt::format("\n// submission {}\n", number);
}

Words shot_words(const std::string& program, const LabEntry& lab, const Shot& shot, const fs::path& output) {
    const Orbit& camera = shot.camera;
    Words words = {program,
                   "shot",
                   lab.two_digits(),
                   "--size",
                   fmt::format("{}x{}", shot.size.x, shot.size.y),
                   "--camera",
                   fmt::format("{},{},{}", camera.yaw, camera.pitch, camera.distance),
                   "-o",
                   output.string()};
    if (shot.probe) words.insert(words.end(), {"--probe", shot.probe.name});
    for (const auto& [knob, value] : shot.set) words.insert(words.end(), {"--set", knob + "=" + value});
    return words;
}

/// The simple loop. Each concurrent grading has its own copy of the course, with the existing programs.
class PlainLoop {
public:
    PlainLoop(const LabEntry& lab, int count) : lab_(lab), manifest_(load_manifest(lab)) {
        for (const CheckInfo& check : manifest_.checks)
            if (!check.shot.calls) shots_.push_back(check.shot);  // `relief shot` draws only views
        for (size_t i = 0; i < size_t(count); ++i) {
            const fs::path here = course(i);
            make_folder(here / "bin");
            for (const char* folder : {"labs", "shaders"})
                fs::copy(course_root() / folder, here / folder, fs::copy_options::recursive);
            fs::create_directory_symlink(course_root() / "assets", here / "assets");
            for (const char* file : {"librelief.so", "librelief-truth.so"})
                fs::copy_file(executable_folder() / file, here / "bin" / file);
            if (fs::exists(framework_folder() / "textures"))
                fs::create_directory_symlink(framework_folder() / "textures", here / "bin/textures");
            fs::copy_file(executable_path(), here / "bin/relief");
            for (const std::string& file : grade::task_files(manifest_)) write_file(here / file, handed_in(file, i));
        }
        for (size_t s = 0; s < shots_.size(); ++s)
            must(shot_words((course(0) / "bin/relief").string(), lab_, shots_[s], reference(s)));
    }

    void grade(size_t i) const {
        const fs::path here = course(i);
        std::string program = (here / "bin/relief").string();
        if (has_cpp()) {
            program = (here / "bin" / ("lab-" + lab_.two_digits())).string();
            build(here, program);
        }
        for (size_t s = 0; s < shots_.size(); ++s) {
            const fs::path drawn = here / reference(s).filename();
            must(shot_words(program, lab_, shots_[s], drawn));
            must({"/usr/bin/idiff", "-q", "-fail", "0.008", "-failpercent", "0.05", drawn.string(),
                  reference(s).string()});
        }
    }

private:
    fs::path course(size_t i) const { return folder_.path() / std::to_string(i); }
    fs::path reference(size_t s) const {
        return folder_.path() / fmt::format("{}.{}", s, shots_[s].probe ? "exr" : "png");
    }
    bool has_cpp() const {
        for (const std::string& file : grade::task_files(manifest_))
            if (file.ends_with(".cpp")) return true;
        return false;
    }
    /// Compiles the lab's sources against the existing framework, like a Makefile beside the lab.
    void build(const fs::path& here, const std::string& program) const {
        const fs::path sources = here / "labs" / lab_.folder;
        Words words = {"/usr/bin/c++",
                       "-std=c++20",
                       "-O2",
                       "-DFMT_SHARED",
                       "-DRELIEF_LAB_FOLDER=\"" + lab_.folder + "\"",
                       "-I" + course_root().string(),
                       "-I" + sources.string(),
                       "-isystem",
                       (executable_folder().parent_path() / "generated/glad/include").string(),
                       (course_root() / "framework/course/app/main.cpp").string()};
        for (const auto& entry : fs::directory_iterator(sources))
            if (entry.path().extension() == ".cpp") words.push_back(entry.path().string());
        words.insert(words.end(), {"-o", program, (here / "bin/librelief.so").string(), "-lfmt"});
        must(words);
    }
    void must(const Words& command) const {
        const std::string libraries = (course(0) / "bin").string();
        const ProcessResult done = run_process(
            {.command = command,
             .environment = {{"LC_ALL", "C.UTF-8"}, {"LP_NUM_THREADS", "0"}, {"LD_LIBRARY_PATH", libraries}},
             .limits = {.wall = 600, .cpu = 600, .memory = size_t{8} << 30}});
        if (!done.succeeded()) throw Error(fmt::format("{} fails: {}{}", command[0], done.errors, done.output));
    }

    const LabEntry& lab_;
    Manifest manifest_;
    std::vector<Shot> shots_;
    grade::PublicFolder folder_{fs::temp_directory_path(), "relief-bench"};
};

/// The grader's setup for one lab, and its submissions.
struct Graded {
    grade::Stage stage;
    std::unique_ptr<grade::LabGrader> grader;
    std::vector<grade::Submission> submissions;

    Graded(const LabEntry& lab, const grade::GradeSetup& setup, int count) : stage(setup.isolation) {
        stage.add(lab);
        grader = std::make_unique<grade::LabGrader>(lab, stage, setup);
        grader->reuse_shaders();
        submissions.resize(size_t(count));
        for (size_t i = 0; i < submissions.size(); ++i)
            for (const std::string& file : grade::task_files(grader->manifest()))
                submissions[i].files[file] = handed_in(file, i);
    }
};

std::vector<BenchScene> grade_scenes(const BenchSettings& settings) {
    std::vector<BenchScene> result;
    const int count = int(hardware_threads()) * (settings.quick ? 1 : 2);
    const grade::Isolation isolation = grade::isolation_for(true).level;
    const bool has_idiff = fs::exists("/usr/bin/idiff");
    if (!has_idiff) print_note("the plain loop is skipped: there is no idiff (Debian package openimageio-tools)");
    for (const auto& [number, kind] : {std::pair{"02", "shaders"}, {"05", "C++"}}) {
        if (settings.quick && kind == std::string("C++")) continue;  // compiling is slow
        const LabEntry& lab = find_lab(number);
        BenchScene& scene = result.emplace_back();
        scene.knobs = {{"lab", lab.folder}, {"tasks", kind}};
        scene.item = "submission";
        const auto subject = [count](const std::function<void(size_t)>& grade) {
            return BenchSubject{.items = size_t(count),
                                .run = [count, grade] { parallel_each(size_t(count), 0, grade); },
                                .is_parallel = true};
        };
        for (const std::string seed : {"", "bench"})
            scene.methods.push_back({"relief", {{"hidden_views", seed.empty() ? "no" : "yes"}}, [=, &lab] {
                                         const auto graded = std::make_shared<Graded>(
                                             lab, grade::GradeSetup{.isolation = isolation, .seed = seed}, count);
                                         return subject([graded](size_t i) {
                                             const grade::LabMark mark = graded->grader->mark(graded->submissions[i]);
                                             if (mark.points() != mark.max_points())
                                                 throw Error("a correct submission does not get all points");
                                         });
                                     }});
        if (!has_idiff) continue;
        const auto plain = [=, &lab] {
            const auto loop = std::make_shared<PlainLoop>(lab, count);
            return subject([loop](size_t i) { loop->grade(i); });
        };
        scene.methods.push_back({"plain-loop", {{"hidden_views", "no"}}, plain, true});
    }
    return result;
}

}  // namespace

const TopicRegistration grade_topic({"grade", "grading submissions, compared with a plain loop of build, draw, idiff",
                                     "How long does a submission take to grade?", grade_scenes, false, true});

}  // namespace relief::measure
