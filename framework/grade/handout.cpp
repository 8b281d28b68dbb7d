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
constexpr const char* left_out[] = {"framework/reference",         "framework/measure",
                                    "framework/app/bench.cpp",     "framework/app/handout.cpp",
                                    "framework/grade/handout.cpp", "framework/grade/overlay.cpp",
                                    "assets/textures.cpp",         "assets/make.cpp"};
constexpr const char* kept_all_the_same[] = {"framework/reference/ray.h"};

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

class Handout {
public:
    explicit Handout(fs::path folder) : whole_(std::move(folder)) {
        std::error_code ignored;
        if (fs::exists(whole_) && (!fs::is_directory(whole_) || !fs::is_empty(whole_, ignored)))
            throw Error({whole_}, "is there already and not empty: a handout wants a folder of its own");
        // Beside it until it is whole: half a course must never be taken for one.
        if (!whole_.has_filename()) whole_ = whole_.parent_path();
        folder_ = fs::path(whole_) += ".part";
        fs::remove_all(folder_, ignored);
    }

    HandoutReport write() {
        for (const LabEntry& lab : registry()) {
            const Manifest manifest = load_manifest(lab);
            ++report.labs, report.tasks += int(manifest.tasks.size());
            for (const std::string& path : manifest.keep_back) kept_back_.emplace(path, lab.folder);
        }
        for (const char* path : taken_along) copy(path);
        const fs::path readme = "framework/grade/handout_readme.md";
        put("README.md", read_file(course_root() / readme));
        take_common_shaders();
        write_expected();
        std::error_code failure;
        fs::rename(folder_, whole_, failure);
        if (failure) throw Error({whole_}, "cannot put the handout here: " + failure.message());
        return report;
    }

    HandoutReport report;

private:
    bool stays(const fs::path& path) const {
        for (const char* kept : kept_all_the_same)
            if (is_inside(path, kept) || is_inside(kept, path)) return false;
        for (const char* out : left_out)
            if (is_inside(path, out)) return true;
        if (is_inside(path, "shaders/common") && path.extension() == ".glsl") return true;  // see take_common_shaders
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
        put(path, content);
        fs::permissions(folder_ / path, fs::status(from).permissions());
        if (is_inside(path, "shaders")) include(path, content);
    }

    void put(const fs::path& path, const std::string& content) {
        make_folder((folder_ / path).parent_path());
        write_file(folder_ / path, content);
        ++report.files;
    }

    void include(const fs::path& from, const std::string& text) {
        for (const std::string& name : includes_of(text)) includes_.emplace(fs::path("shaders") / name, from);
    }

    void take_common_shaders() {
        while (!includes_.empty()) {
            const auto [path, from] = *includes_.begin();
            includes_.erase(includes_.begin());
            if (!is_inside(path, "shaders/common") || fs::exists(folder_ / path)) continue;
            for (const auto& [back, lab] : kept_back_)
                if (is_inside(path, back))
                    throw Error({from},
                                fmt::format("includes {}, which holds answers of {}: see keep_back in its lab.toml",
                                            path.string(), lab));
            const std::string content = starter_of(read_file(course_root() / path), path);
            put(path, content);
            include(path, content);
        }
    }

    void write_expected() {
        Progress progress(report.labs);
        for (const LabEntry& lab : registry()) {
            progress.next("expected pictures of " + lab.folder);
            for (const CheckInfo& check : load_manifest(lab).checks) {
                if (check.hidden) continue;
                const std::optional<Image> image = expectation(lab, check);
                if (!image) continue;
                const fs::path file = folder_ / expectation_file(lab, check).lexically_relative(course_root());
                make_folder(file.parent_path());
                if (fs::exists(file))
                    throw Error(
                        fmt::format("labs/{}/lab.toml: two checks have names like '{}'", lab.folder, check.name));
                write_image(file, *image);
                ++report.files, ++report.expected;
            }
        }
    }

    fs::path whole_, folder_;
    std::map<std::string, std::string> kept_back_;  ///< path to lab
    std::map<fs::path, fs::path> includes_;         ///< a file, and one that includes it
};

}  // namespace

std::string public_manifest(const std::string& text, const fs::path& file) {
    const Manifest manifest = parse_manifest(text, file);
    static const std::regex header("\\[\\[?[a-z_.]+\\]\\]?[ \t]*(#.*)?");
    std::vector<std::string> kept;
    size_t checks = 0;
    bool dropping = false;
    for (const std::string& line : split(text, '\n')) {
        if (std::regex_match(line, header)) {
            dropping = line.starts_with("[[mistake]]");
            if (line.starts_with("[[check]]")) dropping = manifest.checks.at(checks++).hidden;
            if (dropping)
                while (!kept.empty() && (kept.back().starts_with("#") || kept.back().empty())) kept.pop_back();
        }
        if (!dropping) kept.push_back(line);
    }
    while (!kept.empty() && kept.back().empty()) kept.pop_back();
    const std::string result = join(kept, "\n") + "\n";
    const Manifest left = parse_manifest(result, file);  // also finds a public check that leans on a hidden one
    if (!left.mistakes.empty() ||
        std::any_of(left.checks.begin(), left.checks.end(), [](const CheckInfo& check) { return check.hidden; }))
        throw Error({file},
                    "write [[check]] and [[mistake]] at the beginning of their lines: a handout cuts them out there");
    return result;
}

HandoutReport write_handout(const fs::path& folder) { return Handout(folder).write(); }

}  // namespace relief
