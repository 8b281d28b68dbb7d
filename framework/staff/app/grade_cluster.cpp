// relief grade --slurm and --status: a class on a cluster.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/app/grade.h"
#include "framework/staff/cluster/slurm.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* report_file = "report.html";

void print_part(const grade::PartState& part) {
    std::string text = part.state;
    if (part.state == "runs") text = "runs on " + part.node;
    if (part.state == "failed") text = part.node.empty() ? "failed" : "failed on " + part.node;
    if (part.state == "unknown") text = "unknown, because squeue fails";
    if (!part.reason.empty() && part.reason != "None") text += fmt::format(" ({})", part.reason);
    if (!part.job.empty() && part.state != "done") text += ", job " + part.job;
    if (part.part > 0)
        fmt::print("part {:>4}  {:>9}  {}\n", part.part, fmt::format("{}/{}", part.results, part.submissions), text);
    else
        fmt::print("report     {:>9}  {}\n", "", text);
}

nlohmann::ordered_json as_json(const grade::PartState& part) {
    nlohmann::ordered_json json;
    if (part.part > 0) json = {{"part", part.part}, {"submissions", part.submissions}, {"results", part.results}};
    json.update({{"state", part.state}, {"node", part.node}, {"job", part.job}, {"reason", part.reason}});
    return json;
}

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
    std::vector<grade::PartState> states;
    if (cluster) states = grade::part_states(folder, *cluster, progress);
    const std::vector<std::string> lacking = progress.without_result();
    const bool has_report = cluster ? cluster->has_report : fs::exists(folder / report_file);
    if (json) {
        nlohmann::ordered_json all = {{"submissions", progress.marks.size()},
                                      {"results", progress.results()},
                                      {"report", has_report},
                                      {"without_result", nlohmann::ordered_json::array()}};
        for (const std::string& name : lacking) all["without_result"].push_back(grade::utf8_of_bytes(name));
        for (const grade::PartState& part : states)
            if (part.part > 0)
                all["parts"].push_back(as_json(part));
            else
                all["last_job"] = as_json(part);
        fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
        return 0;
    }
    fmt::print("{}: {} of {} submissions have a result\n", folder.string(), progress.results(), progress.marks.size());
    for (const grade::PartState& part : states) print_part(part);
    if (!lacking.empty()) fmt::print("without a result: {}\n", grade::some_of(lacking));
    if (has_report) fmt::print("the report: {}\n", (folder / report_file).string());
    return 0;
}

}  // namespace relief::app
