// relief grade --slurm and --status: a class on a cluster.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/app/grade.h"
#include "framework/staff/class/progress.h"
#include "framework/staff/cluster/slurm.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* report_file = "report.html";

}  // namespace

void require_slurm(int parts) {
    if (!grade::has_slurm())
        throw Error(
            fmt::format("there is no Slurm here (no sbatch on PATH). Grade each part by hand, on any machines: "
                        "RELIEF_SEED=WORD relief grade ... --shard 1/{0} to --shard {0}/{0}, then relief grade "
                        "--merge FOLDER",
                        parts));
}

int start_class(const grade::ClassOptions& options, int parts, int processors, const std::vector<std::string>& words) {
    make_folder(options.output);
    const Descriptor at_work = grade::hold_output(options.output, grade::Hold::alone);
    if (const auto before = grade::read_cluster(options.output))
        if (const auto jobs = grade::jobs_at_work(*before).value_or(Words()); !jobs.empty())
            throw Error(fmt::format("this class is at work: wait for relief grade --status '{}', or end it: scancel {}",
                                    options.output.string(), join(jobs, " ")));
    grade::enlist_class(options);
    const int count = std::min(parts, int(options.submissions.size()));
    const grade::Cluster cluster = grade::send_class(options.output, count, processors, words);
    fmt::print(
        "{0}: {1} submissions in {2} parts are job {3}, the report is job {4}; how far they are: relief grade "
        "--status {5}\n",
        options.output.string(), options.submissions.size(), count, cluster.parts_job, cluster.report_job,
        quoted_for_shell(options.output.string()));
    return 0;
}

int print_status(const fs::path& folder, bool json) {
    const grade::ClassProgress progress = grade::read_progress(folder);
    const auto cluster = grade::read_cluster(folder);
    const Words lacking = progress.without_result();
    const std::optional<Words> jobs = cluster ? grade::jobs_at_work(*cluster) : Words();
    const bool has_report = cluster ? cluster->has_report : fs::exists(folder / report_file);
    struct Part {
        size_t submissions = 0, results = 0;
        std::string said = {};  ///< the last message of its grader, if it lacks results
    };
    std::vector<Part> parts(cluster ? size_t(cluster->parts) : 0);
    for (size_t i = 0; i < progress.marks.size() && !parts.empty(); ++i) {
        Part& part = parts[i % parts.size()];
        ++part.submissions, part.results += progress.marks[i].has_value();
    }
    for (size_t i = 0; i < parts.size(); ++i)
        if (parts[i].results < parts[i].submissions) parts[i].said = grade::last_message(folder, int(i) + 1);
    const std::string last = cluster && !has_report ? grade::last_message(folder, 0) : "";
    if (json) {
        nlohmann::ordered_json all = {{"submissions", progress.marks.size()},
                                      {"results", progress.results()},
                                      {"report", has_report},
                                      {"without_result", nlohmann::ordered_json::array()}};
        for (const std::string& name : lacking) all["without_result"].push_back(grade::utf8_of_bytes(name));
        for (size_t i = 0; i < parts.size(); ++i)
            all["parts"].push_back({{"part", i + 1},
                                    {"submissions", parts[i].submissions},
                                    {"results", parts[i].results},
                                    {"said", parts[i].said}});
        if (cluster) all["last_job"] = {{"said", last}}, all["jobs"] = nullptr;
        if (cluster && jobs) all["jobs"] = *jobs;
        fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
        return 0;
    }
    fmt::print("{}: {} of {} submissions have a result\n", folder.string(), progress.results(), progress.marks.size());
    for (size_t i = 0; i < parts.size(); ++i)
        fmt::print("part {:>4}  {:>9}{}{}\n", i + 1, fmt::format("{}/{}", parts[i].results, parts[i].submissions),
                   parts[i].said.empty() ? "" : "  ", parts[i].said);
    if (!last.empty()) fmt::print("the last job: {}\n", last);
    if (!jobs)
        fmt::print("squeue fails: it is unknown which jobs wait or run\n");
    else if (!jobs->empty())
        fmt::print("jobs that wait or run: {} (squeue says where, and why they wait)\n", join(*jobs, ", "));
    if (!lacking.empty()) fmt::print("without a result: {}\n", grade::some_of(lacking));
    if (has_report) fmt::print("the report: {}\n", (folder / report_file).string());
    return 0;
}

}  // namespace relief::app
