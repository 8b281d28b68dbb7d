// A class on a cluster, with stand-ins for Slurm's commands: submission, and the output of --status.
#include "framework/staff/cluster/cluster.h"

#include <fmt/format.h>

#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/class/progress.h"
#include "framework/staff/cluster/slurm.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Variables = std::map<std::string, std::string>;

Variables array_task(const std::string& task, const std::string& min, const std::string& max, const std::string& step,
                     const std::string& count) {
    return {{"SLURM_ARRAY_TASK_ID", task},
            {"SLURM_ARRAY_TASK_MIN", min},
            {"SLURM_ARRAY_TASK_MAX", max},
            {"SLURM_ARRAY_TASK_STEP", step},
            {"SLURM_ARRAY_TASK_COUNT", count}};
}

// These are the values that Slurm 22.05 sets for the tasks of such an array.
TEST(Shards, OfASlurmArrayAreNumberedByTheirPosition) {
    const struct {
        const char* array;
        Variables variables;
        int index, count;
    } cases[] = {{"1-4", array_task("3", "1", "4", "1", "4"), 2, 4},
                 {"0-15:5", array_task("10", "0", "15", "5", "4"), 2, 4},
                 {"1-7:5", array_task("6", "1", "6", "5", "2"), 1, 2},
                 {"1-4%2", array_task("4", "1", "4", "1", "4"), 3, 4}};
    for (const auto& [array, variables, index, count] : cases) {
        const Environment job(variables);
        const Shard shard = shard_of("");
        EXPECT_EQ(shard.index, index) << array;
        EXPECT_EQ(shard.count, count) << array;
    }
}

TEST(Shards, OfAListOrASingleTaskAreRefusedWithAdvice) {
    for (const Variables& variables : {array_task("2", "2", "5", "1", "2"), array_task("5", "2", "5", "1", "2"),
                                       array_task("7", "3", "11", "1", "3"), array_task("4", "4", "4", "1", "1")}) {
        const Environment job(variables);
        EXPECT_TRUE(contains(message_of<UsageError>([] { shard_of(""); }),
                             "does not say which part of the class it is: give --shard \"$SLURM_ARRAY_TASK_ID/N\""));
        EXPECT_EQ(shard_of("2/16").index, 1) << "what is asked for counts";
    }
}

TEST(Processors, OfAJobAreThoseAllocatedBySlurm) {
    {
        const Environment job({{"SLURM_JOB_ID", "7"}, {"SLURM_CPUS_ON_NODE", "8"}, {"SLURM_CPUS_PER_TASK", "2"}});
        EXPECT_EQ(processors_from_slurm(), 2);
    }
    {
        const Environment job({{"SLURM_JOB_ID", "7"}, {"SLURM_CPUS_ON_NODE", "8"}, {"SLURM_CPUS_PER_TASK", ""}});
        EXPECT_EQ(processors_from_slurm(), 8);
    }
    {
        const Environment job({{"SLURM_JOB_ID", "7"}, {"SLURM_CPUS_PER_TASK", "none"}});
        EXPECT_TRUE(contains(message_of<UsageError>([] { processors_from_slurm(); }), "SLURM_CPUS_PER_TASK is 'none'"));
    }
    const Environment no_job({{"SLURM_JOB_ID", ""}, {"SLURM_CPUS_PER_TASK", "2"}});
    EXPECT_EQ(processors_from_slurm(), std::nullopt);
}

TEST(Roster, IsReadableOnlyByItsOwner) {
    const TemporaryFolder folder;
    fs::permissions(folder.write("class.json", "{}"), fs::perms(0644));  // as an earlier version left it
    write_roster(folder.path(), {.course = "c", .seed = "secret", .labs = {}, .submissions = {}});
    EXPECT_EQ(fs::status(folder.path() / "class.json").permissions(), fs::perms(0600));
    EXPECT_EQ(read_roster(folder.path())->seed, "secret");
}

TEST(Roster, KeepsEachSolutionsFirstTimeAndAllowsNone) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "results");
    folder.write(
        "class.json",
        R"({"schema": 1, "course": "c", "seed": "s", "labs": [], "submissions": []})");  // of an earlier version
    EXPECT_TRUE(read_roster(folder.path())->solution_cpu.empty());
    using Figures = std::map<std::string, double>;
    EXPECT_EQ(add_solution_cpu(folder.path(), {{"01_a", 0.5}}), (Figures{{"01_a", 0.5}}));
    EXPECT_EQ(add_solution_cpu(folder.path(), {{"01_a", 7}, {"02_b", 2}}), (Figures{{"01_a", 0.5}, {"02_b", 2}}));
    EXPECT_EQ(read_roster(folder.path())->solution_cpu, (Figures{{"01_a", 0.5}, {"02_b", 2}}));
    EXPECT_EQ(read_roster(folder.path())->seed, "s") << "the rest stays";
}

/// A class of six submissions, and stand-ins for Slurm's commands that record their arguments.
class ClusterTest : public testing::Test {
protected:
    TemporaryFolder folder_;
    fs::path marks_ = folder_.path() / "a class's marks";
    Environment environment_{{{"PATH", (folder_.path() / "tools").string() + ":/usr/bin:/bin"},
                              {"RELIEF_SEED", "secret"},
                              {"SLURM_JOB_ID", ""}}};

    void SetUp() override {
        const std::string here = "cd '" + folder_.path().string() + "'\n";
        // Job numbers count up from 11.
        tool("sbatch", here + "echo \"$*\" >>calls; env >>environment; echo $(($(wc -l <calls) + 10))");
        tool("squeue", here + "cat queue");
        folder_.write("queue", "");
        fs::create_directories(marks_ / "results");
        Roster roster{.course = "c", .seed = "secret", .labs = {}, .submissions = {}};
        for (const char* name : {"ann", "ben", "cem", "dan", "eva", "fay"})
            roster.submissions.push_back({.name = name, .hash = "h", .parts = {{.path = "/"}}});
        write_roster(marks_, roster);
    }
    void tool(const std::string& name, const std::string& body) const {
        fs::permissions(folder_.write("tools/" + name, "#!/bin/bash\n" + body + "\n"), fs::perms::owner_all);
    }
    void give_result(const std::string& name, const std::string& course = "c") const {
        SubmissionMark mark;
        mark.name = name, mark.hash = "h", mark.course = course, mark.isolation = "namespaces";
        write_file(result_file(marks_, name), to_json(mark));
    }
    std::vector<std::string> calls() const {
        std::vector<std::string> lines = split(read_file(folder_.path() / "calls"), '\n');
        lines.pop_back();
        return lines;
    }
    /// Returns the arguments of a call of sbatch, without the words that all calls share.
    static std::string short_form(std::string call, const std::string& marks) {
        for (const std::string& same :
             {std::string("--parsable --propagate=NONE --job-name="),
              " --requeue --open-mode=append --output=" + marks + "/slurm", marks + "/slurm/"})
            if (const size_t at = call.find(same); at != std::string::npos) call.erase(at, same.size());
        return call;
    }
    std::vector<std::string> short_calls() const {
        std::vector<std::string> all;
        for (const std::string& call : calls()) all.push_back(short_form(call, marks_.string()));
        return all;
    }
};
using Calls = std::vector<std::string>;

TEST_F(ClusterTest, SubmitsAnArrayOfPartsAndALastJobAfterThem) {
    send_class(marks_, 3, 2, {"--trust"});
    EXPECT_EQ(short_calls(), (Calls{"relief-part/part-%a.log --cpus-per-task=2 --array=1-3 part.sh",
                                    "relief-report/last.log --cpus-per-task=2 --dependency=afterany:11 last.sh"}));
    const std::string marks = quoted_for_shell(marks_.string());
    for (const auto& [script, said] :
         {std::pair("part.sh", " grade --resume -o " + marks + " --shard \"$SLURM_ARRAY_TASK_ID/3\" '--trust'\n"),
          std::pair("last.sh", " grade --resume -o " + marks + " '--trust'\n")}) {
        const fs::path file = marks_ / "slurm" / script;
        EXPECT_TRUE(read_file(file).ends_with(said)) << read_file(file);
        EXPECT_EQ(run({"/bin/bash", "-n", file.string()}).code, 0) << script;
    }
    EXPECT_EQ(fs::status(marks_ / "slurm").permissions(), fs::perms::owner_all) << "others can read logs with marks";
}

TEST_F(ClusterTest, KeepsTheSeedOutOfCommandsJobsAndScripts) {
    send_class(marks_, 3, 0, {});
    for (const char* file : {"calls", "environment"})
        EXPECT_FALSE(contains(read_file(folder_.path() / file), "secret")) << read_file(folder_.path() / file);
    for (const auto& entry : fs::directory_iterator(marks_ / "slurm"))
        EXPECT_FALSE(contains(read_file(entry.path()), "secret")) << entry.path();
}

TEST_F(ClusterTest, AJobInheritsTheUsersVariablesButNotTheSubmittingJobs) {
    const Environment job({{"SLURM_CPUS_PER_TASK", "64"}, {"SLURM_CONF", "/etc/x.conf"}, {"SBATCH_PARTITION", "long"}});
    send_class(marks_, 1, 0, {});
    const std::string environment = read_file(folder_.path() / "environment");
    EXPECT_FALSE(contains(environment, "SLURM_CPUS_PER_TASK")) << "the new one may have other processors";
    EXPECT_TRUE(contains(environment, "SLURM_CONF=/etc/x.conf\n") && contains(environment, "SBATCH_PARTITION=long\n"));
}

TEST_F(ClusterTest, KnowsItsJobsInTheQueueAndTheLastMessageOfAGrader) {
    send_class(marks_, 3, 0, {});
    const auto jobs = [&] { return jobs_at_work(*read_cluster(marks_)); };
    folder_.write("queue", "11\n11\n12\n99\n");
    EXPECT_EQ(jobs(), (Calls{"11", "12"}));
    folder_.write("queue", "99\n");
    EXPECT_EQ(jobs(), Calls());
    tool("squeue", "exit 1");
    EXPECT_EQ(jobs(), std::nullopt) << "only Slurm can say";
    EXPECT_EQ(last_message(marks_, 2), "") << "it has no log";
    folder_.write("a class's marks/slurm/part-2.log",
                  "relief: first\nrelief: /tmp/x: cannot write: No space left\n11/11\n");
    EXPECT_EQ(last_message(marks_, 2), "/tmp/x: cannot write: No space left");
}

TEST_F(ClusterTest, ARefusalBySlurmIsReportedVerbatim) {
    tool("sbatch", "echo 'sbatch: error: invalid partition specified: lnog' >&2; exit 1");
    EXPECT_EQ(message_of([&] { send_class(marks_, 3, 0, {}); }),
              "Slurm takes no job: sbatch: error: invalid partition specified: lnog");
}

TEST_F(ClusterTest, AResultCountsIfCompleteOfThisCourseAndNotAMachineFailure) {
    give_result("ann");
    give_result("ben", "another course");
    folder_.write("a class's marks/results/cem.json", read_file(result_file(marks_, "ann")).substr(0, 100));
    fs::copy_file(result_file(marks_, "ann"), result_file(marks_, "dan"));
    SubmissionMark failed;
    failed.name = "eva", failed.course = "c";
    LabMark& lab = failed.labs.emplace_back(LabMark{.lab = "01"});
    lab.tasks.emplace_back().checks.push_back({.outcome = check::Outcome::machine, .found = "no disk", .name = "all"});
    write_file(result_file(marks_, "eva"), to_json(failed));
    const ClassProgress progress = read_progress(marks_);
    EXPECT_EQ(progress.results(), 1u);
    EXPECT_EQ(progress.without_result(), (Calls{"ben", "cem", "dan", "eva", "fay"}));
    EXPECT_EQ(some_of({"a", "b", "c", "d", "e", "f", "g"}), "a, b, c, d, e and 2 more");
}

}  // namespace
}  // namespace relief::grade
