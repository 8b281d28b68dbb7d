// The students' course: its contents, its build, and that a student can earn every point in it.
#include "framework/staff/handout/handout.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/registry.h"
#include "framework/course/check/check.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/overlay.h"
#include "tests/code_shape.h"
#include "tests/process.h"
#include "tests/staff/handout/secrets.h"
#include "tests/support.h"

namespace relief::handout {
namespace {

namespace fs = std::filesystem;

class StudentsCourse : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        const Result made = run({relief_program(), "handout", "-o", course().string()});
        ASSERT_EQ(made.code, 0) << made.err;
        for (const auto& entry : fs::directory_iterator(course_root() / "labs"))
            if (fs::exists(entry.path() / "lab.toml")) labs_->push_back(entry.path().filename());
        std::sort(labs_->begin(), labs_->end());
        ASSERT_GE(labs_->size(), 6u);
    }
    static void TearDownTestSuite() { delete folder_; }

    static fs::path course() { return folder_->path() / "a handout"; }
    static Manifest staff(const std::string& lab) { return load_manifest(course_root() / "labs" / lab / "lab.toml"); }
    /// Returns all files of a folder by their relative paths.
    static std::map<std::string, std::string> files_in(const fs::path& folder) {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file()) all.emplace(entry.path().lexically_relative(folder), read_file(entry.path()));
        return all;
    }
    /// Returns every text that a student could read.
    static std::map<std::string, std::string> texts() {
        std::map<std::string, std::string> all = files_in(course());
        std::erase_if(all,
                      [](const auto& file) { return file.first.ends_with(".png") || file.first.ends_with(".exr"); });
        return all;
    }
    static Result hand_out(const fs::path& folder, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {relief_program(), "handout", "-o", folder.string()});
        return run(more);
    }
    static inline TemporaryFolder* folder_ = nullptr;
    static inline std::vector<std::string>* labs_ = new std::vector<std::string>;
};

TEST_F(StudentsCourse, ContainsNoSolutionMistakeVariantOrHiddenCheck) { expect_no_secrets(texts(), *labs_); }

TEST(Shape, OfCodeIgnoresNamesButKeepsOperations) {
    EXPECT_EQ(shape_of("a = max(b.xy, 0.5f) * glm::sin( c );  // why"), "@ = max ( @ . xy , 0.5 ) * sin ( @ ) ; ");
    EXPECT_EQ(expressions_of({"vec3 a = normalize(b.xyz - dot(b.xyz, c) * c);", "return short_;"}),
              std::vector<std::string>{"normalize ( @ . xyz - dot ( @ . xyz , @ ) * @ ) "});
}

TEST_F(StudentsCourse, ContainsNoSolutionWithRenamedIdentifiers) {
    std::map<std::string, std::string> shapes;
    for (const auto& [path, text] : texts())
        if (!path.ends_with(".toml") && !path.ends_with(".obj"))
            shapes[path] = shape_of(path.ends_with(".md") ? code_in_markdown(text) : text);
    size_t looked_for = 0;
    for (const std::string& lab : *labs_) {
        std::set<std::string> task_files;
        for (const TaskInfo& task : staff(lab).tasks) task_files.insert(task.file);
        for (const std::string& file : task_files)
            for (const std::string& shape :
                 expressions_of(check::solution_lines(read_file(course_root() / file), file))) {
                ++looked_for;
                if (is_common(shape)) continue;
                for (const auto& [path, text] : shapes)
                    EXPECT_FALSE(contains(text, shape)) << file << ": '" << shape << "' can be read in " << path;
            }
    }
    EXPECT_GT(looked_for, 30u);
}

TEST_F(StudentsCourse, ContainsNoSolutionTextThatAMistakeOrVariantEdits) {
    size_t looked_for = 0;
    const auto look_for = [&](const Edit& edit) {
        if (!fs::exists(course() / edit.file)) return;
        const std::string handed_out = read_file(course() / edit.file);
        const std::vector<std::string> solution =
            check::solution_lines(read_file(course_root() / edit.file), edit.file);
        for (const std::string& find : trimmed_lines(edit.find)) {
            const bool in_solution = std::any_of(solution.begin(), solution.end(),
                                                 [&](const std::string& line) { return contains(line, find); });
            if (!in_solution || find.size() < 12) continue;
            ++looked_for;
            EXPECT_FALSE(contains(handed_out, find)) << edit.file << ": " << find;
        }
    };
    for (const std::string& lab : *labs_) {
        const Manifest manifest = staff(lab);
        for (const MistakeInfo& mistake : manifest.mistakes)
            for (const Edit& edit : mistake.edits) look_for(edit);
        for (const EquivalentInfo& equivalent : manifest.equivalents)
            for (const Edit& edit : equivalent.edits) look_for(edit);
    }
    EXPECT_GT(looked_for, 100u);
}

TEST_F(StudentsCourse, BeginsWithAReadmeOfItsOwn) {
    const std::string readme = read_file(course() / "README.md");
    EXPECT_TRUE(readme.starts_with("# Relief: your labs\n\nSurface detail")) << readme.substr(0, 80);
    for (const char* command : {"\n./relief list ", "\n./relief run 01 ", "\n./relief check 01 "})
        EXPECT_TRUE(contains(readme, command)) << command;
    for (const std::string& lab : *labs_) EXPECT_TRUE(contains(readme, "(labs/" + lab + "/README.md)")) << lab;
    for (const std::string& lab : *labs_) {  // each lab has its handout with its pictures
        const std::string handout = read_file(course() / "labs" / lab / "README.md");
        size_t pictures = 0;
        for (size_t at = handout.find("](golden/"); at != std::string::npos;
             at = handout.find("](golden/", at + 1), ++pictures) {
            const std::string path = handout.substr(at + 2, handout.find(')', at) - at - 2);
            EXPECT_TRUE(fs::exists(course() / "labs" / lab / path)) << lab << ": " << path;
        }
        EXPECT_GE(pictures, 1u) << lab;
    }
}

TEST_F(StudentsCourse, IsTheCourseWithoutFoldersNamedStaffAndWithStarters) {
    const std::map<std::string, std::string> handed_out = files_in(course());
    for (const auto& [path, text] : handed_out) {
        const fs::path parts(path);
        EXPECT_EQ(std::find(parts.begin(), parts.end(), "staff"), parts.end()) << path;
    }
    size_t left = 0, staffs = 0;
    for (const char* room : {"framework", "labs", "shaders", "assets"})
        for (const auto& [name, text] : files_in(course_root() / room)) {
            const fs::path path = fs::path(room) / name;
            if (std::find(path.begin(), path.end(), "staff") != path.end()) {
                ++staffs;
                continue;
            }
            ASSERT_TRUE(handed_out.contains(path)) << path;
            const bool has_tasks = !path.string().ends_with(".md") && !check::solution_lines(text, path).empty();
            // Regions that slides quote lose their marks.
            const std::string expected =
                contains(text, "//") && !path.string().ends_with(".md") ? check::starter_of(text, path) : text;
            EXPECT_TRUE(handed_out.at(path) == text || handed_out.at(path) == expected) << path;
            if (has_tasks) {
                EXPECT_NE(handed_out.at(path), text) << path;
            }
            ++left;
        }
    EXPECT_GT(left, 250u);
    EXPECT_GT(staffs, 100u);
    for (const char* top : {"tests", "slides", ".git", "CONTRIBUTING.md"})
        EXPECT_FALSE(fs::exists(course() / top)) << top;
}

TEST_F(StudentsCourse, ContainsTheTruthOnlyAsPictures) {
    for (const std::string& lab : *labs_) {
        std::set<std::string> pictures, wanted, bases;
        for (const auto& file : fs::directory_iterator(course() / "labs" / lab / "expected"))
            pictures.insert(file.path().filename().string());
        const Manifest manifest = staff(lab);
        LabEntry entry;
        entry.folder = lab;
        for (const CheckInfo& check : manifest.checks) {
            if (check.hidden || (check.against != "truth" && check.against != "solution")) continue;
            wanted.insert(check::expectation_file(entry, check).filename().string());
            if (check.shot.probe && !manifest.probe(check.shot.probe.name).without.empty())
                bases.insert(check::base_file(entry, check).filename().string());
        }
        for (const std::string& name : wanted) EXPECT_TRUE(pictures.contains(name)) << lab << ": " << name;
        for (const std::string& name : pictures)
            EXPECT_TRUE(wanted.contains(name) || bases.contains(name) || name == "hidden_checks.json" ||
                        name == "fingerprints.json")
                << lab << ": " << name;
    }
}

TEST_F(StudentsCourse, NeverOverwritesForeignFiles) {
    const TemporaryFolder other;
    other.write("thesis.txt", "years");
    const Result taken = hand_out(other.path());
    EXPECT_EQ(taken.code, 1);
    EXPECT_TRUE(contains(taken.err, "is there already, not empty and not a handout")) << taken.err;
    EXPECT_EQ(files_in(other.path()).size(), 1u);
    EXPECT_FALSE(fs::exists(other.path().string() + ".part")) << "what was not whole yet";
    const Result file = hand_out(course() / "README.md");
    EXPECT_EQ(file.code, 1);
    EXPECT_TRUE(contains(file.err, "README.md: is there already")) << file.err;
    const Result readonly = hand_out("/proc/handout", {"--labs", "2"});
    EXPECT_EQ(readonly.code, 1);
    EXPECT_TRUE(contains(readonly.err, "/proc/handout.part: cannot make this folder")) << readonly.err;
    const Result nowhere = run({relief_program(), "handout"});
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_TRUE(contains(nowhere.err, "-o FOLDER")) << nowhere.err;
}

TEST_F(StudentsCourse, OfSomeLabsIsASubsetAndCanBeExtended) {
    const TemporaryFolder outer;
    const fs::path part = outer.path() / "part";
    ASSERT_EQ(hand_out(part, {"--labs", "10"}).code, 0);
    const std::map<std::string, std::string> whole = files_in(course()), some = files_in(part);
    for (const auto& [path, text] : some)
        if (path != "README.md" && path != ".relief-handout") {
            ASSERT_TRUE(whole.contains(path)) << path;
            EXPECT_TRUE(text == whole.at(path)) << path;
        }
    const auto names_in = [&](const char* folder) {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(part / folder)) names.insert(entry.path().filename().string());
        return names;
    };
    EXPECT_EQ(names_in("labs"), (std::set<std::string>{"10_parallax_offset", "GLOSSARY.md", "README.md",
                                                       "another_mesa.txt", "sources.toml"}));
    EXPECT_EQ(names_in("shaders"), (std::set<std::string>{"10_parallax_offset", "README.md", "common"}));
    EXPECT_FALSE(contains(some.at("README.md"), "normal_map_storage"));
    EXPECT_TRUE(contains(some.at("README.md"), "./relief check 10 "));
    const Result configured =
        run({"cmake", "-S", part.string(), "-B", (outer.path() / "build").string(), "-G", "Ninja"});
    EXPECT_EQ(configured.code, 0) << configured.err;
    const std::string built = read_file(outer.path() / "build/build.ninja");
    EXPECT_TRUE(contains(built, "\nbuild lab-10:"));
    EXPECT_FALSE(contains(built, "\nbuild lab-01:"));

    // The student has edited a file, and the course delivers more labs.
    const std::string file = "shaders/10_parallax_offset/task.glsl";
    write_file(part / file, some.at(file) + "// mine\n");
    const Result more = hand_out(part, {"--labs", "6,1"});
    EXPECT_EQ(more.code, 0) << more.err;
    for (const char* line :
         {"\nnew      shaders/06_tangent_space/task.glsl\n", "\nupdated  README.md\n", ": 3 labs (1,6,10), "})
        EXPECT_TRUE(contains('\n' + more.out, line)) << line << more.out;
    EXPECT_TRUE(contains(read_file(part / "README.md"), "(labs/06_tangent_space/README.md)"));
    EXPECT_TRUE(contains(hand_out(part).out, "everything is up to date\n")) << "no --labs: those that are there";
    const Result none = hand_out(part, {"--labs", "88-89"});
    EXPECT_EQ(none.code, 2);
    EXPECT_TRUE(contains(none.err, "'88-89' contains no lab")) << none.err;

    // `relief test --all` lets it grow to the whole course.
    ASSERT_EQ(hand_out(part, {"--labs", tests_all() ? "all" : "2"}).code, 0);
    std::map<std::string, std::string> grown = files_in(part);
    EXPECT_EQ(grown[file], some.at(file) + "// mine\n");
    grown[file] = some.at(file);
    EXPECT_TRUE(grown.contains("shaders/02_normal_map_storage/task.glsl"));
    if (tests_all()) {
        EXPECT_TRUE(grown == whole);
    }
}

TEST_F(StudentsCourse, BuildsReportsUnfinishedTasksAndGivesFullPointsForSolutions) {
    const fs::path build = course() / "build";
    const auto ninja = [&](const char* target) {
        const Result built = run({"ninja", "-C", build.string(), target},
                                 {{}, {{"CCACHE_BASEDIR", course().string()}, {"CCACHE_NOHASHDIR", "1"}}});
        ASSERT_EQ(built.code, 0) << built.out.substr(built.out.size() > 4000 ? built.out.size() - 4000 : 0);
    };
    // With a compiler cache the course is built as this one was, since most files are equal. Otherwise it uses the
    // fastest build type.
    const std::string launcher = RELIEF_COMPILER_LAUNCHER;
    const std::string type = launcher.empty() ? "Debug" : RELIEF_BUILD_TYPE;
    const Result configured = run({"cmake", "-S", course().string(), "-B", build.string(), "-G", "Ninja",
                                   "-DCMAKE_BUILD_TYPE=" + type, "-DCMAKE_CXX_COMPILER_LAUNCHER=" + launcher,
                                   "-DCMAKE_COMPILE_WARNING_AS_ERROR=" RELIEF_STRICT, "-DRELIEF_TESTS=ON"});
    ASSERT_EQ(configured.code, 0) << configured.err;
    for (const char* target : {"relief_cpu", "relief_framework", "programs"}) ASSERT_NO_FATAL_FAILURE(ninja(target));

    // Objects that the compiler cache took from the staff's course must depend on this course's files: otherwise an
    // edit would not be compiled.
    const Result dependencies = run({"ninja", "-C", build.string(), "-t", "deps"});
    EXPECT_TRUE(contains(dependencies.out, "framework/core/lab/lab.h"));
    EXPECT_FALSE(contains(dependencies.out, course_root().string() + "/framework/"));

    const auto check = [&](const std::string& lab) {
        const Result checked = run({(build / "bin/relief").string(), "check", lab, "--json"});
        return std::pair(checked.code, nlohmann::json::parse(checked.out));
    };
    for (const std::string& lab : *labs_) {
        const auto [code, report] = check(lab);
        EXPECT_EQ(code, 1) << lab;
        EXPECT_EQ(report.at("points"), 0) << lab;
        for (const auto& task : report.at("tasks"))
            for (const auto& one : task.at("checks"))
                EXPECT_EQ(one.at("outcome"), "unfinished") << lab << ": " << one.at("name");
    }
    const Result shot = run({(build / "bin/relief").string(), "shot", "05", "-o", (build / "x.png").string()});
    EXPECT_EQ(shot.code, 1);
    EXPECT_TRUE(contains(shot.err, "task.cpp:") && contains(shot.err, "task 5.1 is not written yet")) << shot.err;

    for (const std::string& lab : *labs_)
        for (const TaskInfo& task : staff(lab).tasks)
            fs::copy_file(course_root() / task.file, course() / task.file, fs::copy_options::overwrite_existing);
    ASSERT_NO_FATAL_FAILURE(ninja("programs"));
    // The same solutions pass the same checks in the staff's course, where all labs are tested.
    const std::vector<std::string> drawn = sample_of(*labs_, 4);
    for (const std::string& lab : drawn) {
        const auto [code, report] = check(lab);
        EXPECT_EQ(code, 0) << lab << report.dump(1);
        EXPECT_EQ(report.at("points"), report.at("of")) << lab;
        int hidden = 0, told = 0;
        for (const CheckInfo& one : staff(lab).checks) hidden += one.hidden;
        for (const auto& task : report.at("tasks")) told += task.value("hidden_checks", 0);
        EXPECT_EQ(told, hidden) << lab;
    }
    // Without exact values, the pictures of checks still show whether a pixel is right.
    const auto explain = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {(build / "bin/relief").string(), "explain", "06", "--pixel", "9,9"});
        return run(more);
    };
    const std::string check_named = staff("06_tangent_space").checks.front().name;
    EXPECT_TRUE(contains(explain({}).err, "add --check '")) << check_named;
    EXPECT_TRUE(contains(explain({"--check", check_named}).out, "expected by the check: "));
    // The handout alone suffices to name a known mistake.
    const Manifest storage = staff("02_normal_map_storage");
    const MistakeInfo& mistake = storage.mistakes.front();
    for (const auto& [file, text] : grade::edited(mistake.edits)) write_file(course() / file, text);
    for (const auto& task : check("02").second.at("tasks"))
        EXPECT_EQ(task.at("mistake"), task.at("id") == mistake.task ? mistake.hint : "") << task.at("id");
    for (const auto& [file, text] : grade::edited(mistake.edits))
        write_file(course() / file, read_file(course_root() / file));
    // The golden pictures pass, so no picture needs a removed or replaced file.
    for (const std::string& lab : drawn) {
        const Result golden = run({(build / "bin/relief").string(), "golden", lab});
        EXPECT_EQ(golden.code, 0) << golden.err;
    }
    // The student's site has pictures of every method but no error maps, since it has no truth.
    const Result site = run({(build / "bin/relief").string(), "gallery", "--labs", "2"});
    EXPECT_EQ(site.code, 0) << site.err;
    EXPECT_EQ(site.err, "") << "nothing to be made by commands that are not there";
    const std::string page = read_file(build / "gallery/02_normal_map_storage.html");
    EXPECT_TRUE(contains(page, "format-oct16.png") && !contains(page, "-error.png"));
    for (const char* command : {"bench", "handout", "grade", "slides", "mistakes", "synctest"}) {
        const Result asked = run({(build / "bin/relief").string(), command});
        EXPECT_EQ(asked.code, 2);
        EXPECT_TRUE(contains(asked.err, std::string("'") + command + "' is a command for staff only")) << asked.err;
    }
    const Result error = run({(build / "bin/relief").string(), "shot", "1", "--error", "normal", "-o", "-"});
    EXPECT_EQ(error.code, 2);
    EXPECT_TRUE(
        contains(error.err, "the code that computes the exact values of 'normal' is not included in this course"))
        << error.err;

    // A C++ task that does not compile stops no other lab.
    const fs::path task = course() / "labs/05_tangent_basis/task.cpp";
    write_file(task, read_file(task) + "int broken = ;\n");
    const Result other = run({(course() / "relief").string(), "check", "06"});
    EXPECT_EQ(other.code, 0) << other.err;
    EXPECT_TRUE(contains(other.err, "labs/05_tangent_basis/task.cpp:")) << other.err;
    EXPECT_TRUE(contains(other.err, "lab 06 is built without the other labs:")) << other.err;
    EXPECT_EQ(run({(course() / "relief").string(), "check", "05"}).code, 1);
}

}  // namespace
}  // namespace relief::handout
