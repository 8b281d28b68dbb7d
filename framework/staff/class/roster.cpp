#include "framework/staff/class/roster.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* file_name = "class.json";
constexpr int roster_schema = 1;

/// Returns a whole number in the environment; `otherwise` if the variable is missing or empty.
int number(const char* name, int otherwise) {
    const char* const text = std::getenv(name);
    if (!text || !*text) return otherwise;
    const auto value = parse_int(text);
    if (!value) throw UsageError(fmt::format("{} is '{}', not a whole number", name, text));
    return *value;
}

Shard checked(int index, int count, const std::string& from) {
    if (count < 1 || index < 0 || index >= count)
        throw UsageError(fmt::format("{} asks for part {} of {}: parts are 1/{} to {}/{}", from, index + 1, count,
                                     std::max(count, 1), std::max(count, 1), std::max(count, 1)));
    return {index, count, from};
}

/// Returns the position of this task in --array=FIRST-LAST:STEP. In a list, such as --array=2,5, Slurm does not tell a
/// task the other tasks. Nor does it tell a single task that it is one of several.
Shard shard_of_array() {
    const int task = number("SLURM_ARRAY_TASK_ID", 0), first = number("SLURM_ARRAY_TASK_MIN", 0),
              step = std::max(1, number("SLURM_ARRAY_TASK_STEP", 1)), count = number("SLURM_ARRAY_TASK_COUNT", 1),
              last = number("SLURM_ARRAY_TASK_MAX", first + (count - 1) * step);
    if (count < 2 || (last - first) / step + 1 != count || task < first || (task - first) % step != 0)
        throw UsageError(fmt::format(
            "task {} of a Slurm array of {}, from {} to {}, does not say which part of the class it is: give "
            "--shard \"$SLURM_ARRAY_TASK_ID/N\", of N parts in all",
            task, count, first, last));
    return checked((task - first) / step, count, "SLURM_ARRAY_TASK_ID");
}

}  // namespace

std::string to_json(const Roster& roster) {
    ordered_json json = {{"schema", roster_schema},
                         {"course", roster.course},
                         {"seed", utf8_of_bytes(roster.seed)},
                         {"labs", roster.labs},
                         {"solution_cpu_seconds", roster.solution_cpu},
                         {"submissions", ordered_json::array()},
                         {"given", ordered_json::array()}};
    for (const Roster::One& one : roster.submissions) {
        ordered_json parts = ordered_json::array();
        for (const SubmissionPart& part : one.parts)
            parts.push_back({{"path", utf8_of_bytes(part.path.string())},
                             {"file", utf8_of_bytes(part.file)},
                             {"upload", part.upload}});
        json["submissions"].push_back(
            {{"name", utf8_of_bytes(one.name)}, {"hash", one.hash}, {"parts", parts}, {"remarks", one.remarks}});
    }
    for (const fs::path& path : roster.given) json["given"].push_back(utf8_of_bytes(path.string()));
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::optional<Roster> read_roster(const fs::path& folder) {
    const fs::path file = folder / file_name;
    if (!fs::exists(file)) return {};
    try {
        const ordered_json json = ordered_json::parse(read_file(file, size_t{1} << 28));
        if (json.at("schema") != roster_schema) throw Error({file}, "was written by another version: use a new folder");
        Roster roster{.course = json.at("course"),
                      .seed = bytes_of_utf8(json.at("seed").get<std::string>()),
                      .labs = json.at("labs"),
                      .submissions = {}};
        if (json.contains("solution_cpu_seconds")) json.at("solution_cpu_seconds").get_to(roster.solution_cpu);
        if (!json.at("submissions").is_array())
            throw Error({file}, "has no list of submissions: remove it, or use a new folder");
        for (const ordered_json& one : json.at("submissions")) {
            Roster::One& read = roster.submissions.emplace_back();
            read.name = bytes_of_utf8(one.at("name").get<std::string>());
            read.hash = one.at("hash");
            read.remarks = one.value("remarks", read.remarks);
            for (const ordered_json& part : one.at("parts"))
                read.parts.push_back({bytes_of_utf8(part.at("path").get<std::string>()),
                                      bytes_of_utf8(part.at("file").get<std::string>()), part.at("upload")});
        }
        for (const ordered_json& path : json.value("given", ordered_json::array()))
            roster.given.push_back(bytes_of_utf8(path.get<std::string>()));
        return roster;
    } catch (const ordered_json::exception&) {
        throw Error({file}, "is no roster of a class: remove it, or use a new folder");
    }
}

void write_roster(const fs::path& folder, const Roster& roster) {
    write_private_file(folder / file_name, to_json(roster));
}

std::map<std::string, double> add_solution_cpu(const fs::path& folder, const std::map<std::string, double>& measured) {
    const Descriptor held(open((folder / "results").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    flock(held, LOCK_EX);  // until this function returns; a file system without locks does not lock
    Roster roster = read_roster(folder).value();
    const size_t before = roster.solution_cpu.size();
    roster.solution_cpu.insert(measured.begin(), measured.end());
    if (roster.solution_cpu.size() > before) write_roster(folder, roster);
    return roster.solution_cpu;
}

Shard shard_of(const std::string& text) {
    if (!text.empty()) {
        const size_t slash = text.find('/');
        const auto index = parse_int(text.substr(0, slash));
        const auto count = slash == std::string::npos ? std::nullopt : parse_int(text.substr(slash + 1));
        if (!index || !count) throw UsageError(fmt::format("--shard takes i/n, like 2/8, not '{}'", text));
        return checked(*index - 1, *count, "--shard");
    }
    if (std::getenv("SLURM_ARRAY_TASK_ID")) return shard_of_array();
    for (const std::string prefix : {"TEST", "GTEST"})
        if (const std::string index = prefix + "_SHARD_INDEX"; std::getenv(index.c_str()))
            return checked(number(index.c_str(), 0), number((prefix + "_TOTAL_SHARDS").c_str(), 1), index);
    return {};
}

}  // namespace relief::grade
