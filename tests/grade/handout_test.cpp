// The student's course: what is in it, that it builds, and that a student can earn every point there.
#include "framework/grade/handout.h"

#include <nlohmann/json.hpp>

#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "framework/grade/starter.h"
#include "framework/lab/manifest.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief {
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
        ASSERT_GE(labs_->size(), 6u);
    }
    static void TearDownTestSuite() { delete folder_; }

    static fs::path course() { return folder_->path() / "a handout"; }
    static Manifest staff(const std::string& lab) { return load_manifest(course_root() / "labs" / lab / "lab.toml"); }
    /// Whatever a student could read, by its path.
    static std::map<std::string, std::string> texts() {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(course()))
            if (entry.is_regular_file() && entry.path().extension() != ".png" && entry.path().extension() != ".exr")
                all.emplace(entry.path().lexically_relative(course()), read_file(entry.path()));
        return all;
    }
    static void expect_nowhere(const std::string& secret) {
        for (const auto& [path, text] : *texts_)
            EXPECT_FALSE(contains(text, secret)) << "'" << secret << "' can be read in " << path;
    }

    static inline TemporaryFolder* folder_ = nullptr;
    static inline std::vector<std::string>* labs_ = new std::vector<std::string>;
    static inline std::map<std::string, std::string>* texts_ = nullptr;
};

TEST_F(StudentsCourse, HoldsNoSolutionNoMistakeAndNoHiddenCheck) {
    texts_ = new std::map(texts());
    size_t lines = 0, hidden = 0, mistakes = 0;
    for (const std::string& lab : *labs_) {
        const Manifest manifest = staff(lab);
        for (const TaskInfo& task : manifest.tasks)
            for (const std::string& line : solution_lines(read_file(course_root() / task.file), task.file))
                if (line.size() >= 24) expect_nowhere(line), ++lines;  // shorter ones are "if (x == 0) return {};"
        for (const CheckInfo& check : manifest.checks)
            if (check.hidden) expect_nowhere('"' + check.name + '"'), ++hidden;
        for (const MistakeInfo& mistake : manifest.mistakes) expect_nowhere(mistake.hint), ++mistakes;
    }
    EXPECT_GT(lines, 30u);
    EXPECT_GT(hidden, 8u);
    EXPECT_GT(mistakes, 60u);
    delete texts_;
}

TEST_F(StudentsCourse, BeginsWithAReadmeOfItsOwn) {
    const std::string readme = read_file(course() / "README.md");
    EXPECT_TRUE(readme.starts_with("# Relief: your labs\n\nSurface detail")) << readme.substr(0, 80);
    for (const char* command : {"\n./relief list ", "\n./relief run 01 ", "\n./relief check 01 "})
        EXPECT_TRUE(contains(readme, command)) << command;
    for (const std::string& lab : *labs_) {  // and each lab with its handout, whose pictures came along
        const std::string handout = read_file(course() / "labs" / lab / "README.md");
        size_t pictures = 0;
        for (size_t at = handout.find("](../../"); at != std::string::npos;
             at = handout.find("](../../", at + 1), ++pictures) {
            const std::string path = handout.substr(at + 8, handout.find(')', at) - at - 8);
            EXPECT_TRUE(fs::exists(course() / path)) << lab << ": " << path;
        }
        EXPECT_GE(pictures, 1u) << lab;
    }
}

TEST_F(StudentsCourse, HoldsNoTruthButAsPictures) {
    for (const char* left_out :
         {"tests/CMakeLists.txt", "framework/reference/height_field.h", "framework/measure",
          "framework/mesh/tangents.cpp", "framework/image/normal_codec.cpp", "framework/image/normals.cpp",
          "shaders/common/tangent_space.glsl", "shaders/common/normal_map.glsl", ".git", "CONTRIBUTING.md"})
        EXPECT_FALSE(fs::exists(course() / left_out)) << left_out;
    for (const std::string& lab : *labs_) {
        const std::string truth = read_file(course() / "labs" / lab / "truth.cpp");
        for (const char* word : {"first_hit", "HeightField", "point_on", "encode_normal", "with_tangents("})
            EXPECT_FALSE(contains(truth, word)) << lab << ": " << word;
        size_t pictures = 0;
        for (const auto& entry : fs::directory_iterator(course() / "labs" / lab / "expected"))
            pictures += entry.is_regular_file();
        size_t wanted = 0;
        for (const CheckInfo& check : staff(lab).checks)
            wanted += !check.hidden && (check.against == "truth" || check.against == "solution");
        EXPECT_EQ(pictures, wanted) << lab;
    }
}

TEST_F(StudentsCourse, IsNeverWrittenOverWhatIsThere) {
    const Result again = run({relief_program(), "handout", "-o", course().string()});
    EXPECT_EQ(again.code, 1);
    EXPECT_TRUE(contains(again.err, "is there already and not empty")) << again.err;
    EXPECT_FALSE(fs::exists(course().string() + ".part")) << "what was not whole yet";
    const Result file = run({relief_program(), "handout", "-o", (course() / "README.md").string()});
    EXPECT_EQ(file.code, 1);
    EXPECT_TRUE(contains(file.err, "README.md: is there already")) << file.err;
    const Result readonly = run({relief_program(), "handout", "-o", "/proc/handout"});
    EXPECT_EQ(readonly.code, 1);
    EXPECT_TRUE(contains(readonly.err, "/proc/handout.part: cannot make this folder")) << readonly.err;
    const Result nowhere = run({relief_program(), "handout"});
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_TRUE(contains(nowhere.err, "-o FOLDER")) << nowhere.err;
}

TEST_F(StudentsCourse, BuildsSaysWhatIsUnfinishedAndGivesEveryPointForTheSolutions) {
    const fs::path build = course() / "build";
    const auto ninja = [&](const char* target) {
        const Result built = run({"ninja", "-C", build.string(), target});
        ASSERT_EQ(built.code, 0) << built.out.substr(built.out.size() > 4000 ? built.out.size() - 4000 : 0);
    };
    const Result configured = run({"cmake", "-S", course().string(), "-B", build.string(), "-G", "Ninja",
                                   "-DCMAKE_BUILD_TYPE=Debug", "-DRELIEF_TESTS=ON"});
    ASSERT_EQ(configured.code, 0) << configured.err;
    for (const char* target : {"relief_cpu", "relief_framework", "programs"}) ASSERT_NO_FATAL_FAILURE(ninja(target));

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
    for (const std::string& lab : *labs_) {
        const auto [code, report] = check(lab);
        EXPECT_EQ(code, 0) << lab << report.dump(1);
        EXPECT_EQ(report.at("points"), report.at("of")) << lab;
    }
}

TEST(PublicManifest, LosesHiddenChecksAndMistakesAndKeepsTheRestAsItStands) {
    const std::string text = R"(title = "A"  # why
[[task]]
id = "1.1"
title = "T"
file = "f.glsl"
[[check]]
task = "1.1"
name = "open"
against = "solution"
look_at = "x"

# The truth of it.
[[check]]
task = "1.1"
name = "secret"
against = "solution"
look_at = "y"
hidden = true
[[mistake]]
id = "m"
task = "1.1"
hint = "h"
edits = [
  { file = "f.glsl", find = "a", replace = "b" },
]
# The last.
[[golden]]
name = "g"
)";
    EXPECT_EQ(public_manifest(text, "lab.toml"), R"(title = "A"  # why
[[task]]
id = "1.1"
title = "T"
file = "f.glsl"
[[check]]
task = "1.1"
name = "open"
against = "solution"
look_at = "x"
[[golden]]
name = "g"
)");
}

}  // namespace
}  // namespace relief
