#include "framework/staff/web/live_site.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/pages/handout_page.h"
#include "framework/course/pages/lab_page.h"
#include "framework/course/pages/template.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/overlay.h"

namespace relief::web {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Returns the paths of the course's files that a lab may read in a browser, relative to the course.
std::vector<std::string> files_of(const fs::path& course, const std::string& lab) {
    std::vector<std::string> files;
    const auto add = [&](const fs::path& folder, const std::function<bool(const fs::path&)>& wanted) {
        std::error_code none;
        if (!fs::is_directory(course / folder, none)) return;
        for (const auto& entry : fs::recursive_directory_iterator(course / folder))
            if (entry.is_regular_file() && wanted(entry.path()))
                files.push_back(entry.path().lexically_relative(course).generic_string());
    };
    const auto has_ending = [](std::initializer_list<const char*> endings) {
        return [endings = std::vector<std::string>(endings.begin(), endings.end())](const fs::path& file) {
            return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
        };
    };
    const auto is_shader = has_ending({".glsl", ".vert", ".frag", ".tesc", ".tese", ".geom"});
    add("shaders/common", is_shader);
    add(fs::path("shaders") / lab, is_shader);
    add(fs::path("labs") / lab, has_ending({".toml"}));
    add(fs::path("labs") / lab / "expected", [](const fs::path&) { return true; });
    add(fs::path("labs") / lab, [](const fs::path& file) { return file.filename() == "task.cpp"; });
    add("assets", has_ending({".png", ".obj", ".mtl"}));
    std::sort(files.begin(), files.end());
    return files;
}

/// Returns whether a page fetches the file before it opens the lab. The other ones are larger, and not all are needed.
bool is_fetched_first(const std::string& file) {
    return !file.starts_with("assets/") && file.find("/expected/") == file.npos;
}

using PartsByTask = std::map<std::string, std::string>;

/// Returns each task's part of a task file of the staff's, as a student would have written it.
PartsByTask written_parts(const std::string& text, const std::string& file) {
    PartsByTask parts;
    for (check::TaskPart& part : check::task_parts(check::solution_of(text, file))) parts[part.task] = part.text;
    return parts;
}

/// Returns the solution of each task, and the first correct variant that changes this task's part alone.
json solutions_of(const Manifest& manifest) {
    json all = json::object();
    for (const TaskInfo& task : manifest.tasks) {
        PartsByTask parts = written_parts(read_file(course_root() / task.file), task.file);
        json& one = all[task.id] = {{"solution", parts[task.id]}};
        for (const EquivalentInfo& variant : manifest.equivalents) {
            const grade::CourseFiles files = grade::edited(variant.edits);
            if (variant.task != task.id || files.size() != 1 || !files.contains(task.file)) continue;
            const PartsByTask changed = written_parts(files.at(task.file), task.file);
            const bool is_in_this_part = std::all_of(changed.begin(), changed.end(), [&](const auto& part) {
                return part.first == task.id || part.second == parts[part.first];
            });
            if (!is_in_this_part) continue;
            one["variant"] = changed.at(task.id), one["why"] = variant.why;
            break;
        }
    }
    return all;
}

class Pages {
public:
    explicit Pages(const LiveSite& site) : site_(site) {
        for (const LabEntry& lab : registry())
            if (fs::exists(site.course / "labs" / lab.folder)) labs_.push_back(&lab);
    }

    void write() {
        for (const LabEntry& lab : registry()) fs::remove(site_.folder / solutions_file(lab));  // of an earlier site
        for (size_t i = 0; i < labs_.size(); ++i) write_page(i);
        for (const std::string& file : copied_) copy(site_.course / file, fs::path("course") / file);
        for (const char* name : {"relief.js", "relief.wasm"}) copy(site_.module / name, name);
        copy(site_.editor, "editor.js");
        copy(course_root() / "framework/staff/web/icon.svg", "icon.svg");
        copy(course_root() / "framework/staff/web/compiled_task.js", "compiled_task.js");
        if (!site_.compiler.empty()) {
            copy(course_root() / "framework/staff/web/compiler.js", "compiler.js");
            for (const auto& entry : fs::directory_iterator(site_.compiler))
                copy(entry.path(), fs::path("compiler") / entry.path().filename());
        }
        put("live.css", style());
        std::string script;
        for (const char* name : {"wipe", "drawings", "framework/staff/web/live"})
            script += pages::page_file(name, ".js") + "\n";
        put("live.js", script);
    }

private:
    void write_page(size_t i) {
        const LabEntry& lab = *labs_[i];
        const Manifest manifest = load_manifest(site_.course / "labs" / lab.folder / "lab.toml");
        std::string task, code;
        std::vector<std::string> not_here, task_files;
        for (const TaskInfo& each : manifest.tasks) {
            (is_shader(each.file) ? task : code) = each.file;
            if (std::find(task_files.begin(), task_files.end(), each.file) == task_files.end())
                task_files.push_back(each.file);
            if (!is_shader(each.file) && site_.compiler.empty()) not_here.push_back(each.id);
        }
        json first = json::array(), files = json::array();
        bool has_tessellation = false;
        for (const std::string& file : files_of(site_.course, lab.folder)) {
            copied_.insert(file);
            files.push_back(file);
            if (is_fetched_first(file)) first.push_back(file);
            has_tessellation |= file.ends_with(".tese");
        }
        const json data = {{"number", lab.number},
                           {"task", task},
                           {"code", code},
                           {"compiler", !site_.compiler.empty()},
                           {"module_bytes", fs::file_size(site_.module / "relief.wasm")},
                           {"solutions", site_.solutions ? solutions_file(lab) : ""},
                           {"not_here", not_here},
                           {"first", first},
                           {"files", files},
                           {"task_files", task_files}};
        if (site_.solutions) put(solutions_file(lab), solutions_of(load_manifest(lab)).dump());
        const auto neighbour = [&](size_t index) {
            if (index >= labs_.size()) return pages::Value();
            return pages::Value(pages::Fields{{"file", pages::live_page_file(*labs_[index])},
                                              {"number", labs_[index]->two_digits()},
                                              {"title", load_manifest(*labs_[index]).title}});
        };
        put(pages::live_page_file(lab),
            pages::render(
                "framework/staff/web/live",
                {{"number", lab.two_digits()},
                 {"title", manifest.title},
                 {"has_tessellation", has_tessellation},
                 {"lab", data.dump()},
                 {"picture", lab.folder + ".png"},
                 {"code", !code.empty() && !site_.compiler.empty()},
                 {"compiled",
                  not_here.empty() ? "" : (not_here.size() == 1 ? "task " : "tasks ") + join(not_here, ", ")},
                 {"blocks", pages::handout_blocks(lab, manifest, labs_,
                                                  [&](const auto& name, const auto& bytes) { put(name, bytes); })},
                 {"previous", neighbour(i - 1)},
                 {"next", neighbour(i + 1)}}));
    }

    static std::string solutions_file(const LabEntry& lab) { return "solutions/" + lab.folder + ".json"; }

    static std::string style() {
        std::string all;
        for (const char* name : {"colors", "page", "markdown", "framework/staff/web/live"})
            all += pages::page_file(name, ".css") + "\n";
        return all;
    }

    void put(const fs::path& name, const std::string& bytes) const {
        make_folder((site_.folder / name).parent_path());
        write_file(site_.folder / name, bytes);
    }
    void copy(const fs::path& from, const fs::path& name) const { put(name, read_file(from)); }

    const LiveSite& site_;
    std::vector<const LabEntry*> labs_;
    std::set<std::string> copied_;
};

}  // namespace

void write_live_pages(const LiveSite& site) { Pages(site).write(); }

}  // namespace relief::web
