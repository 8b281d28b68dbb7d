// `relief grade --slurm` and `--status` as an instructor runs them, with stand-ins for Slurm's commands.
#include <nlohmann/json.hpp>

#include "framework/core/base/file.h"
#include "framework/staff/class/merge.h"
#include "framework/staff/class/progress.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* shader = "shaders/01_specular_highlights/task.glsl";

class GradeCommand : public testing::Test {
protected:
    TemporaryFolder folder_;
    fs::path marks_ = folder_.path() / "marks";
    std::vector<std::string> submissions_;

    void SetUp() override {
        for (const char* name : {"ann", "ben", "cem"}) {
            folder_.write(std::string("class/") + name + "/" + shader, std::string("// ") + name);
            submissions_.push_back((folder_.path() / "class" / name).string());
        }
        tool("sbatch", "echo \"$*\" >>calls; echo $(($(wc -l <calls) + 10))");
        tool("squeue", "cat queue");
        folder_.write("queue", "");
    }
    void tool(const std::string& name, const std::string& body) const {
        fs::permissions(
            folder_.write("tools/" + name, "#!/bin/bash\ncd '" + folder_.path().string() + "'\n" + body + "\n"),
            fs::perms::owner_all);
    }
    Result grade(std::vector<std::string> words, std::map<std::string, std::string> variables = {}) const {
        words.insert(words.begin(), {relief_program(), "grade"});
        variables.emplace("PATH", (folder_.path() / "tools").string() + ":/usr/bin:/bin");
        variables.emplace("RELIEF_SEED", "secret");
        return run(words, {.folder = folder_.path(), .environment = std::move(variables)});
    }
    Result start(std::vector<std::string> more = {}) const {
        std::vector<std::string> words = submissions_;
        words.insert(words.end(), {"-o", "marks", "--slurm", "2"});
        words.insert(words.end(), more.begin(), more.end());
        return grade(words);
    }
    Result last_job() const {
        return run({"/bin/bash", (marks_ / "slurm/last.sh").string()},
                   {.folder = folder_.path(), .environment = {{"SLURM_JOB_ID", "12"}, {"RELIEF_SEED", ""}}});
    }
    std::string calls() const {
        const fs::path file = folder_.path() / "calls";
        return fs::exists(file) ? read_file(file) : "";
    }
    void give_result(const std::string& name) const {
        const json roster = json::parse(read_file(marks_ / "class.json"));
        grade::SubmissionMark mark;
        mark.name = name, mark.course = roster["course"], mark.isolation = "namespaces";
        mark.labs.push_back({.lab = "01_specular_highlights", .tasks = {}, .log = {}, .times = {}});
        for (const json& one : roster["submissions"])
            if (one["name"] == name) mark.hash = one["hash"];
        write_file(grade::result_file(marks_, name), grade::to_json(mark));
    }
};

TEST_F(GradeCommand, WithoutSlurmExplainsHowToGradeByHand) {
    std::vector<std::string> words = submissions_;
    words.insert(words.end(), {"-o", "marks", "--slurm", "16"});
    fs::create_directories(folder_.path() / "empty");
    const Result result = grade(words, {{"PATH", (folder_.path() / "empty").string()}});
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err,
              "relief: there is no Slurm here (no sbatch on PATH). Grade each part by hand, on any machines: "
              "RELIEF_SEED=WORD relief grade ... --shard 1/16 to --shard 16/16, then relief grade --merge FOLDER\n");
    EXPECT_FALSE(fs::exists(marks_));
}

TEST_F(GradeCommand, SubmitsAClassWithItsRosterAndKeepsTheSeedPrivate) {
    const Result result = start({"--jobs", "3", "--trust"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(contains(result.out,
                         "marks: 3 submissions in 2 parts are job 11, the report is job 12; how far they are: "
                         "relief grade --status 'marks'\n"))
        << result.out;
    EXPECT_TRUE(contains(calls(), " --cpus-per-task=3 --array=1-2 ")) << calls();
    EXPECT_TRUE(contains(read_file(marks_ / "slurm/part.sh"), "'--trust'"));
    EXPECT_EQ(json::parse(read_file(marks_ / "class.json"))["seed"], "secret");
    EXPECT_EQ(fs::status(marks_ / "class.json").permissions(), fs::perms(0600));
    EXPECT_FALSE(contains(result.out + result.err + calls(), "secret"));
    for (const auto& entry : fs::recursive_directory_iterator(marks_))
        if (entry.is_regular_file() && entry.path().filename() != "class.json") {
            EXPECT_FALSE(contains(read_file(entry.path()), "secret")) << entry.path();
        }
}

TEST_F(GradeCommand, ARunningClassIsNotSubmittedTwice) {
    ASSERT_EQ(start().code, 0);
    folder_.write("queue", "11\n12\n");
    const Result again = start();
    EXPECT_EQ(again.code, 1);
    EXPECT_EQ(again.err,
              "relief: this class is at work: wait for relief grade --status 'marks', or end it: scancel 11 12\n");
    folder_.write("queue", "");
    EXPECT_EQ(start().code, 0);
}

TEST_F(GradeCommand, ValidResultsAreKeptAndStaleOnesRemovedBeforeSubmission) {
    ASSERT_EQ(start().code, 0);
    for (const char* name : {"ann", "ben"}) give_result(name);
    folder_.write(std::string("class/ben/") + shader, "// handed in again");
    ASSERT_EQ(start().code, 0);
    EXPECT_TRUE(fs::exists(marks_ / "results/ann.json"));
    EXPECT_FALSE(fs::exists(marks_ / "results/ben.json")) << "it is of other files";
    ASSERT_EQ(start({"--fresh"}).code, 0);
    EXPECT_FALSE(fs::exists(marks_ / "results/ann.json"));
}

TEST_F(GradeCommand, TheLastJobWritesTheReportWhenAllResultsAreThere) {
    ASSERT_EQ(start().code, 0);
    for (const char* name : {"ann", "ben", "cem"}) give_result(name);
    const Result last = last_job();
    EXPECT_EQ(last.code, 0) << last.err;
    EXPECT_TRUE(contains(read_file(marks_ / "results.csv"), "\ncem,"));
    EXPECT_FALSE(contains(read_file(marks_ / "report.html"), "secret"));
    const Result status = grade({"--status", "marks"});
    EXPECT_EQ(status.out,
              "marks: 3 of 3 submissions have a result\npart    1        2/2\npart    2        1/1\n"
              "the report: marks/report.html\n");
}

TEST_F(GradeCommand, TheLastJobGradesWhatThePartsLeft) {
    ASSERT_EQ(start().code, 0);
    for (const char* name : {"ann", "cem"}) give_result(name);
    folder_.write("queue", "12\n");
    folder_.write("marks/slurm/part-2.log", "relief: no disk\n");
    EXPECT_EQ(grade({"--status", "marks"}).out,
              "marks: 2 of 3 submissions have a result\npart    1        2/2\npart    2        0/1  no disk\n"
              "jobs that wait or run: 12 (squeue says where, and why they wait)\nwithout a result: ben\n");
    const json all = json::parse(grade({"--status", "marks", "--json"}).out);
    EXPECT_EQ(all["submissions"], 3);
    EXPECT_EQ(all["results"], 2);
    EXPECT_EQ(all["report"], false);
    EXPECT_EQ(all["without_result"], json({"ben"}));
    EXPECT_EQ(all["parts"][1], json({{"part", 2}, {"submissions", 1}, {"results", 0}, {"said", "no disk"}}));
    EXPECT_EQ(all["jobs"], json({"12"}));

    const Result last = last_job();
    EXPECT_EQ(last.code, 0) << last.err;
    EXPECT_TRUE(contains(last.out, "1 graded, 2 unchanged, 0 not graded")) << last.out;
    EXPECT_TRUE(contains(read_file(marks_ / "results.csv"), "\nben,graded,"));
}

TEST_F(GradeCommand, WrongUseOfAClusterIsOneClearLine) {
    expect_refused([&](const auto& words) { return start(words); },
                   {{{"--slurm", "0"}, "--slurm takes a whole number from 1 to 1000, not '0'"},
                    {{"--shard", "1/2"}, "--slurm sends all parts: it takes no --shard"},
                    {{"--seed", "x"}, "--slurm takes no --seed, which everybody on this machine can read"}});
    EXPECT_EQ(calls(), "");
}

/// Returns the bytes that this process has read; nothing if the system does not count them.
std::optional<double> bytes_read() {
    std::ifstream counters("/proc/self/io");
    std::string name;
    double bytes = 0;
    if (counters >> name >> bytes) return bytes;
    return {};
}

// The work of a merge must be linear in the size of the class.
TEST(Merge, ReadsEachResultOnce) {
    if (!bytes_read()) GTEST_SKIP() << "the system does not count what is read";
    const auto read_for = [](int count) {
        const TemporaryFolder folder;
        fs::create_directories(folder.path() / "results");
        grade::Roster roster{.course = "c", .seed = "", .labs = {}, .submissions = {}};
        for (int i = 0; i < count; ++i) {
            grade::SubmissionMark mark;
            mark.name = "s" + std::to_string(i), mark.hash = "h", mark.course = "c", mark.isolation = "namespaces";
            mark.problem = std::string(10000, 'x');
            write_file(grade::result_file(folder.path(), mark.name), grade::to_json(mark));
            roster.submissions.push_back({.name = mark.name, .hash = "h", .parts = {{.path = "/"}}});
        }
        grade::write_roster(folder.path(), roster);
        const double before = *bytes_read();
        EXPECT_EQ(grade::merge_class(folder.path()).marks.size(), size_t(count));
        return *bytes_read() - before;
    };
    // A result has slightly more than 10,000 bytes; its line of the roster is read twice.
    EXPECT_NEAR((read_for(600) - read_for(200)) / 400, 10500, 500);
}

TEST_F(GradeCommand, OriginalityWritesStaffFilesAndGradesNothing) {
    std::vector<std::string> words = submissions_;
    words.insert(words.end(), {"-o", "marks", "--originality"});
    const Result result = grade(words);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("3 pairs of submissions compared, 0 to look at"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("a person decides"), std::string::npos);
    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(marks_)) {
        files.insert(entry.path().filename().string());
        EXPECT_EQ(fs::status(entry.path()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    }
    EXPECT_EQ(files, (std::set<std::string>{"originality.csv", "originality.html", "originality.json"}));
}

TEST_F(GradeCommand, OriginalityRefusesWhatItDoesNotUse) {
    const std::string submission = submissions_[0];
    expect_refused(
        [&](const auto& words) { return grade(words); },
        {{{submission, "-o", "marks", "--originality"}, "name at least two"},
         {{submission, "-o", "marks", "--earlier", "class"}, "--earlier goes with --originality"},
         {{submission, "-o", "marks", "--originality", "--earlier", "nowhere"}, "there is no folder 'nowhere'"},
         {{submission, "-o", "marks", "--originality", "--earlier", "class"}, "name it once"},
         {{submission, "-o", "marks", "--originality", "--fresh"}, "takes no --fresh"},
         {{submission, "-o", "marks", "--originality", "--self-test"}, "do not go together"},
         {{submission, "--originality"}, "-o FOLDER"},
         {{submission, "-o", "marks", "--originalty"}, "--originality"}});
    EXPECT_FALSE(fs::exists(marks_));
}

}  // namespace
}  // namespace relief::app
