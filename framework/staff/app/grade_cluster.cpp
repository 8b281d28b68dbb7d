// relief grade --slurm and --status: a class on a cluster.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

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
        if (const auto jobs = grade::jobs_at_work(*before); !jobs.empty())
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
    const std::vector<std::string> lacking = progress.without_result();
    const std::vector<std::string> jobs = cluster ? grade::jobs_at_work(*cluster) : std::vector<std::string>();
    const bool has_report = cluster ? cluster->has_report : fs::exists(folder / report_file);
    const size_t parts = cluster ? size_t(cluster->parts) : 0;
    std::vector<std::array<size_t, 2>> counts(parts);  // of results and of submissions
    for (size_t i = 0; i < progress.marks.size() && parts > 0; ++i)
        counts[i % parts][0] += progress.marks[i].has_value(), ++counts[i % parts][1];
    if (json) {
        nlohmann::ordered_json all = {{"submissions", progress.marks.size()},
                                      {"results", progress.results()},
                                      {"report", has_report},
                                      {"without_result", nlohmann::ordered_json::array()}};
        for (const std::string& name : lacking) all["without_result"].push_back(grade::utf8_of_bytes(name));
        if (cluster) all["jobs"] = jobs;
        for (size_t i = 0; i < parts; ++i)
            all["parts"].push_back({{"part", i + 1},
                                    {"submissions", counts[i][1]},
                                    {"results", counts[i][0]},
                                    {"said", grade::last_message(folder, int(i) + 1)}});
        fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
        return 0;
    }
    fmt::print("{}: {} of {} submissions have a result\n", folder.string(), progress.results(), progress.marks.size());
    for (size_t i = 0; i < parts; ++i) {
        const auto [results, submissions] = counts[i];
        const std::string said = results < submissions ? grade::last_message(folder, int(i) + 1) : "";
        fmt::print("part {:>4}  {:>9}{}{}\n", i + 1, fmt::format("{}/{}", results, submissions),
                   said.empty() ? "" : "  ", said);
    }
    if (!jobs.empty()) fmt::print("Slurm has: {}; squeue shows where they run, or why they wait\n", join(jobs, ", "));
    if (cluster && jobs.empty() && !has_report)
        if (const std::string said = grade::last_message(folder, 0); !said.empty())
            fmt::print("the last job: {}\n", said);
    if (!lacking.empty()) fmt::print("without a result: {}\n", grade::some_of(lacking));
    if (has_report) fmt::print("the report: {}\n", (folder / report_file).string());
    return 0;
}

}  // namespace relief::app
