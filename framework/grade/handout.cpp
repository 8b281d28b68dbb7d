#include "framework/grade/handout.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/paths.h"
#include "framework/base/text.h"
#include "framework/grade/check.h"
#include "framework/grade/starter.h"
#include "framework/image/file.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

constexpr const char* taken_along[] = {"CMakeLists.txt", "CMakePresets.json", "LICENSE",       "relief",
                                       ".gitignore",     ".clang-format",     ".editorconfig", "framework",
                                       "labs",           "shaders",           "assets",        "tests/golden"};
// What makes the truth, measures with it, or hands out.
constexpr const char* left_out[] = {"labs/README.md",
                                    "framework/reference",
                                    "framework/measure",
                                    "framework/app/bench.cpp",
                                    "framework/app/bench_page.cpp",
                                    "framework/app/bench_page.h",
                                    "framework/app/grade.cpp",
                                    "framework/app/grade.h",
                                    "framework/app/grade_page.cpp",
                                    "framework/app/grade_page.h",
                                    "framework/app/student_page.cpp",
                                    "framework/app/student_page.h",
                                    "framework/app/handout.cpp",
                                    "framework/app/slides.cpp",
                                    "framework/app/deck.cpp",
                                    "framework/app/deck.h",
                                    "framework/app/mistakes.cpp",
                                    "framework/grade",
                                    "assets/textures.cpp",
                                    "assets/make.cpp"};
constexpr const char* kept_all_the_same[] = {"framework/reference/ray.h", "framework/grade/check.h",
                                             "framework/grade/check.cpp", "framework/grade/starter.h",
                                             "framework/grade/starter.cpp"};

bool is_inside(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

bool is_text(const fs::path& path) {
    const std::set<std::string> kinds = {".cpp", ".h", ".glsl", ".vert", ".tesc", ".tese", ".geom", ".frag"};
    return kinds.contains(path.extension().string());
}

/// What a shader's text includes, below `shaders`.
std::vector<std::string> includes_of(const std::string& text) {
    static const std::regex form("(^|\n)[ \t]*#[ \t]*include[ \t]*\"([^\"\n]+)\"");
    std::vector<std::string> found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), form); match != std::sregex_iterator(); ++match)
        found.push_back((*match)[2]);
    return found;
}

/// The folder of a lab that a path belongs to, or "": what lies below labs, shaders and tests/golden, but for
/// shaders/common.
std::string lab_of(const fs::path& path) {
    for (const char* folder : {"labs", "shaders", "tests/golden"}) {
        const fs::path inside = path.lexically_relative(folder);
        if (is_inside(path, folder) && std::distance(inside.begin(), inside.end()) > 1 && *inside.begin() != "common")
            return *inside.begin();
    }
    return {};
}

/// What a handout of the whole course has, by path, and from that what a handout of some labs has: a part of it, so
/// that nothing can be read there that cannot be read in the whole.
class StudentsCourse {
public:
    StudentsCourse() {
        for (const LabEntry& lab : registry())
            for (const std::string& path : load_manifest(lab).keep_back) kept_back_.emplace(path, lab.folder);
        for (const char* path : taken_along) copy(path);
        common_shaders(whole_);  // for its checks
    }

    HandedFiles with(const std::set<std::string>& labs) const {
        HandedFiles files;
        for (const auto& [path, file] : whole_)
            if (const std::string lab = lab_of(path); lab.empty() || labs.contains(lab)) files.emplace(path, file);
        files.merge(common_shaders(files));
        return files;
    }

private:
    bool stays(const fs::path& path) const {
        for (const char* kept : kept_all_the_same)
            if (is_inside(path, kept) || is_inside(kept, path)) return false;
        for (const char* out : left_out)
            if (is_inside(path, out)) return true;
        if (is_inside(path, "shaders/common") && path.extension() == ".glsl") return true;  // see common_shaders
        return std::any_of(kept_back_.begin(), kept_back_.end(),
                           [&](const auto& back) { return is_inside(path, back.first); });
    }

    void copy(const fs::path& path) {
        const fs::path from = course_root() / path;
        if (path.filename() == "expected" || !fs::exists(from)) return;
        if (fs::is_directory(from)) {
            for (const auto& entry : fs::directory_iterator(from)) copy(path / entry.path().filename());
            return;
        }
        if (stays(path)) return;
        std::string content = read_file(from);
        if (path.filename() == "lab.toml")
            content = public_manifest(content, from);
        else if (is_text(path))
            content = starter_of(content, from);
        const bool executable = (fs::status(from).permissions() & fs::perms::owner_exec) != fs::perms::none;
        whole_[path] = {content, executable};
    }

    /// Those of shaders/common that the shaders among these files include, and what these include in turn.
    HandedFiles common_shaders(const HandedFiles& files) const {
        HandedFiles found;
        std::vector<std::pair<fs::path, std::string>> to_read;
        for (const auto& [path, file] : files)
            if (is_inside(path, "shaders")) to_read.emplace_back(path, file.bytes);
        while (!to_read.empty()) {
            const auto [from, text] = to_read.back();
            to_read.pop_back();
            for (const std::string& name : includes_of(text)) {
                const fs::path path = fs::path("shaders") / name;
                if (files.contains(path) || found.contains(path)) {
                    if (!lab_of(path).empty() && lab_of(path) != lab_of(from))
                        throw Error({from}, fmt::format("includes {} of another lab, which may be handed out later: "
                                                        "what both need belongs in shaders/common",
                                                        path.string()));
                    continue;
                }
                for (const auto& [back, lab] : kept_back_)
                    if (is_inside(path, back))
                        throw Error({from},
                                    fmt::format("includes {}, which holds answers of {}: see keep_back in its lab.toml",
                                                path.string(), lab));
                found[path] = {starter_of(read_file(course_root() / path), path)};
                to_read.emplace_back(path, found[path].bytes);
            }
        }
        return found;
    }

    std::map<std::string, std::string> kept_back_;  ///< path to lab
    HandedFiles whole_;                             ///< without the common shaders
};

/// "all" for all that there are and may come; else numbers: the labs that were asked for and those that are there
/// already.
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
    for (const LabEntry& lab : registry())  // a lab that was handed out may be gone since
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
                             lab->folder, manifest.title, manifest.points());
    }
    std::string text = read_file(course_root() / "framework/grade/handout_readme.md");
    for (const auto& [word, with] :
         {std::pair<std::string, std::string>{"LABS\n", table}, {"NN", labs.front()->two_digits()}})
        for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + with.size()))
            text.replace(at, word.size(), with);
    return text;
}

/// Throws Error where a check, hidden or not, asks for what the lab's own solution does not give.
void refuse_unsolved(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                     const std::optional<Image>& expected) {
    const CheckResult result = run_check(lab, manifest, check, expected);
    if (result.outcome != Outcome::passed)
        throw Error(fmt::format("lab {} cannot be handed out: its own solution does not pass '{}' ({}: {})",
                                lab.two_digits(), check.name, name_of(result.outcome), result.found));
}

/// What the solution draws or what is true; refuses a lab whose solution does not draw at all.
std::optional<Image> expected_of(const LabEntry& lab, const CheckInfo& check) {
    try {
        return expectation(lab, check);
    } catch (const Error& error) {
        throw Error(fmt::format("lab {} cannot be handed out: there is nothing to hold '{}' against ({})",
                                lab.two_digits(), check.name, error.what()));
    }
}

/// What the public checks compare with; gives their number.
int add_expected(const std::vector<const LabEntry*>& labs, HandedFiles& files) {
    Progress progress(int(labs.size()));
    int count = 0;
    for (const LabEntry* lab : labs) {
        progress.next("expected pictures of " + lab->folder);
        const Manifest manifest = load_manifest(*lab);
        for (const CheckInfo& check : manifest.checks) {
            const std::optional<Image> image = expected_of(*lab, check);
            refuse_unsolved(*lab, manifest, check, image);
            if (check.hidden || !image) continue;
            const fs::path file = expectation_file(*lab, check).lexically_relative(course_root());
            if (!files.emplace(file, HandedFile{encode_image(*image, format_of(file))}).second)
                throw Error(fmt::format("labs/{}/lab.toml: two checks have names like '{}'", lab->folder, check.name));
            ++count;
        }
    }
    return count;
}

}  // namespace

std::string public_manifest(const std::string& text, const fs::path& file) {
    const Manifest manifest = parse_manifest(text, file);
    static const std::regex header("\\[\\[?[a-z_.]+\\]\\]?[ \t]*(#.*)?");
    std::vector<std::string> kept;
    size_t checks = 0;
    bool dropping = false;
    for (const std::string& line : split(text, '\n')) {
        if (std::regex_match(line, header)) {
            dropping = false;
            for (const char* kept_back : {"[[mistake]]", "[[equivalent]]", "[vary]"})
                dropping |= line.starts_with(kept_back);
            if (line.starts_with("[[check]]")) dropping = manifest.checks.at(checks++).hidden;
            if (dropping)
                while (!kept.empty() && (kept.back().starts_with("#") || kept.back().empty())) kept.pop_back();
        }
        if (!dropping) kept.push_back(line);
    }
    while (!kept.empty() && kept.back().empty()) kept.pop_back();
    const std::string result = join(kept, "\n") + "\n";
    const Manifest left = parse_manifest(result, file);  // also finds a public check that leans on a hidden one
    if (!left.mistakes.empty() || !left.equivalents.empty() || !left.vary.empty() ||
        std::any_of(left.checks.begin(), left.checks.end(), [](const CheckInfo& check) { return check.hidden; }))
        throw Error({file},
                    "write [[check]], [[mistake]], [[equivalent]] and [vary] at the beginning of their lines: "
                    "a handout cuts them out there");
    return result;
}

HandoutReport write_handout(const fs::path& folder, const std::optional<std::string>& asked) {
    const std::optional<std::string> before = delivered_choice(folder);
    HandoutReport report{choice_of(asked, before), !before};
    const std::vector<const LabEntry*> labs = labs_of(report.choice);
    std::set<std::string> folders;
    for (const LabEntry* lab : labs) {
        folders.insert(lab->folder);
        ++report.labs, report.tasks += int(load_manifest(*lab).tasks.size());
    }
    HandedFiles files = StudentsCourse().with(folders);
    files["README.md"] = {readme(labs)};
    files[".github/workflows/check.yml"] = {read_file(course_root() / "framework/grade/handout_check.yml")};
    report.expected = add_expected(labs, files);
    report.files = int(files.size());
    report.delivery = deliver(files, report.choice, folder);
    return report;
}

}  // namespace relief
