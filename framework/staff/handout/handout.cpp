#include "framework/staff/handout/handout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/course/check/check.h"
#include "framework/course/check/hidden_checks.h"
#include "framework/course/manifest/paths.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/fingerprint_maker.h"

namespace relief::handout {
namespace {

namespace fs = std::filesystem;

/// The folders and files of a course. Anything else in its folder, such as marks, must not be handed out.
constexpr const char* course_parts[] = {
    "CMakeLists.txt", "CMakePresets.json", "LICENSE",   "relief", ".gitignore", ".gitattributes",
    ".clang-format",  ".editorconfig",     "framework", "labs",   "shaders",    "assets"};
constexpr const char* staff = "staff";

bool is_text(const fs::path& path) {
    const std::set<std::string> kinds = {".cpp", ".h", ".glsl", ".vert", ".tesc", ".tese", ".geom", ".frag"};
    return kinds.contains(path.extension().string());
}

/// Returns the lab folder of a path below labs or shaders; "" for other paths and for shaders/common.
std::string lab_of(const fs::path& path) {
    for (const char* folder : {"labs", "shaders"}) {
        const fs::path inside = path.lexically_relative(folder);
        if (*path.begin() == folder && std::distance(inside.begin(), inside.end()) > 1 && *inside.begin() != "common")
            return *inside.begin();
    }
    return {};
}

/// Adds a file or a folder of the course as students get it: with starters, and without folders named `staff`.
void add(const fs::path& path, const std::set<std::string>& labs, HandedFiles& files) {
    const fs::path from = course_root() / path;
    const std::string name = path.filename().string();
    if (name == staff || name == "expected" || !fs::exists(from)) return;
    if (fs::is_directory(from)) {
        for (const auto& entry : fs::directory_iterator(from)) add(path / entry.path().filename(), labs, files);
        return;
    }
    if (const std::string lab = lab_of(path); !lab.empty() && !labs.contains(lab)) return;
    std::string content = read_file(from);
    if (is_text(path)) content = check::starter_of(content, from);
    const bool executable = (fs::status(from).permissions() & fs::perms::owner_exec) != fs::perms::none;
    files[path] = {content, executable};
}

/// Throws Error if a shader includes a file that students do not get, or a file of another lab.
void refuse_lost_includes(const HandedFiles& files) {
    static const std::regex form("(^|\n)[ \t]*#[ \t]*include[ \t]*\"([^\"\n]+)\"");
    for (const auto& [path, file] : files) {
        if (!path.starts_with("shaders/") || !is_text(path)) continue;
        for (auto match = std::sregex_iterator(file.bytes.begin(), file.bytes.end(), form);
             match != std::sregex_iterator(); ++match) {
            const std::string name = (*match)[2], included = "shaders/" + name, lab = lab_of(included);
            if (!lab.empty() && lab != lab_of(path))
                throw Error({path}, fmt::format("includes {} of another lab, which may be handed out later: what both "
                                                "need belongs in shaders/common",
                                                included));
            if (!files.contains(included))
                throw Error({path}, fmt::format("includes {}, which students do not get", included));
        }
    }
}

HandedFiles students_course(const std::set<std::string>& labs) {
    HandedFiles files;
    for (const char* part : course_parts) add(part, labs, files);
    refuse_lost_includes(files);
    return files;
}

/// Returns "all" for all labs, including future ones. Otherwise returns the numbers of the requested labs and of the
/// labs in the folder.
std::string choice_of(const std::optional<std::string>& asked, const std::optional<std::string>& before) {
    if (!asked) return before.value_or("all");
    if (*asked == "all" || before == "all") return "all";
    std::set<int> numbers;
    for (const LabEntry* lab : find_labs(*asked)) numbers.insert(lab->number);
    for (const std::string& word : split(before.value_or(""), ','))
        if (const auto number = parse_int(word)) numbers.insert(*number);
    return fmt::format("{}", fmt::join(numbers, ","));
}

std::vector<const LabEntry*> labs_of(const std::string& choice) {
    const std::vector<std::string> numbers = split(choice, ',');
    std::vector<const LabEntry*> labs;
    for (const LabEntry& lab : registry())  // a delivered lab may no longer exist
        if (choice == "all" || std::find(numbers.begin(), numbers.end(), std::to_string(lab.number)) != numbers.end())
            labs.push_back(&lab);
    if (labs.empty()) throw Error("there is no lab to hand out");
    return labs;
}

std::string readme(const std::vector<const LabEntry*>& labs) {
    std::string table;
    for (const LabEntry* lab : labs) {
        const Manifest manifest = load_manifest(*lab);
        table += fmt::format("| [{0} {1}](labs/{2}/README.md) | {3} | {4} |\n", lab->two_digits(), lab->name,
                             lab->folder, manifest.title, points_of_lab(manifest));
    }
    std::string text = read_file(course_root() / "framework/staff/handout/handout_readme.md");
    for (const auto& [word, with] :
         {std::pair<std::string, std::string>{"LABS\n", table}, {"NN", labs.front()->two_digits()}})
        for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + with.size()))
            text.replace(at, word.size(), with);
    return text;
}

/// Throws Error if the lab's own solution fails a check, hidden or not.
void refuse_unsolved(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                     const std::optional<Image>& expected) {
    const check::Verdict result = check::run_check(lab, manifest, check, expected);
    if (result.outcome != check::Outcome::passed)
        throw Error(fmt::format("lab {} cannot be handed out: its own solution does not pass '{}' ({}: {})",
                                lab.two_digits(), check.name, check::name_of(result.outcome), result.found));
}

/// Returns the expected picture of the check. Throws Error if it cannot be made.
std::optional<Image> expected_of(const LabEntry& lab, const CheckInfo& check) {
    try {
        return check::expectation(lab, check);
    } catch (const Error& error) {
        throw Error(fmt::format("lab {} cannot be handed out: there is nothing to compare '{}' with ({})",
                                lab.two_digits(), check.name, error.what()));
    }
}

/// Adds the expected pictures of public checks, the expected values of public calls, and the fingerprints of known
/// mistakes. Returns the number of pictures.
int add_expected(const std::vector<const LabEntry*>& labs, HandedFiles& files) {
    int count = 0, steps = 0;
    for (const LabEntry* lab : labs) {
        const Manifest manifest = load_manifest(*lab);
        steps += int(manifest.checks.size() + manifest.mistakes.size());
    }
    Progress progress(steps);
    for (const LabEntry* lab : labs) {
        const Manifest manifest = load_manifest(*lab);
        if (const check::HiddenByTask hidden = check::hidden_checks(manifest); !hidden.empty())
            files[check::hidden_checks_file(*lab).lexically_relative(course_root())] = {check::text_of(hidden)};
        for (const CheckInfo& check : manifest.checks) {
            progress.next(fmt::format("lab {}, {}", lab->two_digits(), check.name));
            if (check.shot.calls && check.hidden) continue;  // in C++, only the grader's programs have these
            const std::optional<Image> image = expected_of(*lab, check);
            refuse_unsolved(*lab, manifest, check, image);
            if (check.hidden || !image) continue;
            const fs::path file = check::expectation_file(*lab, check).lexically_relative(course_root());
            if (!files.emplace(file, HandedFile{encode_image(*image, format_of(file))}).second)
                throw Error(fmt::format("labs/{}/lab.toml: two checks have names like '{}'", lab->folder, check.name));
            ++count;
            if (const auto base = check::base_of(*lab, manifest, check))
                files.emplace(check::base_file(*lab, check).lexically_relative(course_root()),
                              HandedFile{encode_image(*base, ImageFormat::exr)});
        }
        if (!manifest.mistakes.empty()) {
            files[check::handed_fingerprints(*lab)] = {
                grade::public_fingerprints(*lab, [&](const std::string& mistake) {
                    progress.next(fmt::format("lab {}, mistake {}", lab->two_digits(), mistake));
                })};
        }
    }
    return count;
}

}  // namespace

HandoutReport write_handout(const fs::path& folder, const std::optional<std::string>& asked) {
    const std::optional<std::string> before = delivered_choice(folder);
    HandoutReport report{choice_of(asked, before), !before};
    const std::vector<const LabEntry*> labs = labs_of(report.choice);
    std::set<std::string> folders;
    for (const LabEntry* lab : labs) {
        folders.insert(lab->folder);
        ++report.labs;
        report.tasks += int(load_manifest(*lab).tasks.size());
    }
    HandedFiles files = students_course(folders);
    files["README.md"] = {readme(labs)};
    files[".github/workflows/check.yml"] = {read_file(course_root() / "framework/staff/handout/handout_check.yml")};
    report.expected = add_expected(labs, files);
    report.files = int(files.size());
    report.delivery = deliver(files, report.choice, folder);
    return report;
}

}  // namespace relief::handout
