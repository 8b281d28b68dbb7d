// relief web: makes the course's site with the labs in it, for a browser.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/registry.h"
#include "framework/course/app/command.h"
#include "framework/course/app/gallery.h"
#include "framework/staff/app/tool.h"
#include "framework/staff/handout/handout.h"
#include "framework/staff/web/live_site.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

/// Throws Error with the program's output if it fails.
void run_or_throw(const std::string& what, const std::vector<std::string>& command, const fs::path& folder) {
    const ProcessResult result = run_tool(command, folder, 3600);
    if (!result.succeeded())
        throw Error({}, fmt::format("{} failed: {}", what, name_of(result.ending)), result.output + result.errors);
}

/// Compiles the students' course for a browser, and returns the module's folder. The first time takes minutes. If
/// `quick`, does not optimise: that takes less than half of the time.
fs::path compile(const fs::path& course, bool quick) {
    const fs::path build = course / "build" / (quick ? "web-quick" : "web");
    std::vector<std::string> configure = {"cmake", "--preset", "web", "-B", build.string()};
    if (quick)
        for (const char* language : {"C", "CXX"})
            configure.push_back(fmt::format("-DCMAKE_{}_FLAGS_RELEASE=-O0 -DNDEBUG", language));
    std::error_code none;
    if (!fs::exists(build / "build.ninja", none)) run_or_throw("configuring for a browser", configure, course);
    print_note("compiling for a browser");
    run_or_throw("compiling for a browser", {"ninja", "relief"}, build);
    return build / "bin";
}

/// Bundles the editor with its libraries, and returns the file.
fs::path bundle_editor() {
    const fs::path tools = course_root() / "build" / "editor", bundle = tools / "bundle.js";
    const fs::path program = tools / "node_modules" / "esbuild" / "bin" / "esbuild";
    std::error_code none;
    if (!fs::exists(program, none)) throw Error({program}, "is missing: ./relief web installs it");
    run_or_throw("bundling the editor",
                 {"/usr/bin/env", "NODE_PATH=" + (tools / "node_modules").string(), "node", program.string(),
                  (course_root() / "framework/staff/web/editor.js").string(), "--bundle", "--minify", "--target=es2020",
                  "--outfile=" + bundle.string()},
                 tools);
    return bundle;
}

/// Packs the compiler for the course's tasks in C++ with the headers that they need. Returns its folder; an empty path
/// if it is not installed. `build`: where the module was built.
fs::path pack_compiler(const fs::path& course, const fs::path& build) {
    const fs::path package = course_root() / "build/editor/node_modules/@yowasp/clang", folder = build / "compiler";
    std::error_code none;
    if (!fs::exists(package, none)) {
        print_note("the compiler for tasks in C++ is not installed: the site is made without it");
        return {};
    }
    print_note("packing the compiler for tasks in C++");
    run_or_throw("packing the compiler",
                 {"/usr/bin/env", "node", (course_root() / "framework/staff/web/pack_compiler.mjs").string(),
                  package.string(), course.string(), (build / "generated/headers/glm").string(), folder.string()},
                 course_root());
    return folder;
}

/// Returns the folder of the students' course that has these labs (see find_labs(); empty: all). A course of some labs
/// replaces one that has others, whose module would be larger than asked for.
fs::path course_with(const std::string& labs) {
    const fs::path build = course_root() / "build";
    if (labs.empty()) return build / "web-course";
    const fs::path course = build / "web-course-some";
    const std::vector<const LabEntry*> chosen = find_labs(labs);
    const auto is_another = [&](const LabEntry& lab) {
        return fs::exists(course / "labs" / lab.folder) &&
               std::find(chosen.begin(), chosen.end(), &lab) == chosen.end();
    };
    if (std::any_of(registry().begin(), registry().end(), is_another)) fs::remove_all(course);
    return course;
}

/// `labs`: see find_labs(); empty: all.
int make_site(const fs::path& folder, const std::string& labs, bool quick, bool has_compiler, bool solutions) {
    const fs::path course = course_with(labs);
    make_folder(folder);
    pin_software_renderer();
    const auto context = open_context(std::nullopt);
    print_note("making the students' course");
    handout::write_handout(course, labs.empty() ? std::optional<std::string>() : std::optional(labs));
    const fs::path module = compile(course, quick);
    const fs::path editor = bundle_editor();
    const fs::path compiler = has_compiler ? pack_compiler(course, module.parent_path()) : fs::path();
    print_note("drawing the site's pictures");
    if (const int code = make_gallery({.folder = folder, .labs = labs, .is_live = true})) return code;
    web::write_live_pages({.course = course,
                           .module = module,
                           .editor = editor,
                           .compiler = compiler,
                           .solutions = solutions,
                           .folder = folder});
    fmt::print("{}\n", fs::absolute(folder / "index.html").lexically_normal().string());
    return 0;
}

/// Serves the site to this machine until it is interrupted. A browser runs no module from a file.
int serve(const fs::path& folder, const std::string& port) {
    fmt::print("http://127.0.0.1:{}/\n", port);
    std::fflush(stdout);
    become_program({"python3", "-m", "http.server", "--bind", "127.0.0.1", "--directory", folder.string(), port});
    throw Error("python3 cannot be started: install the Debian package python3");
}

class WebCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.value("-o", "FOLDER", output_, "folder for the site [the course's build/site-web]");
        options.value("--labs", "LABS", labs_, "like 1-5 or 1,3,10-12 [all]");
        options.flag("--quick", quick_, "compile in half of the time, for a first look: the labs react more slowly");
        options.flag("--no-compiler", no_compiler_, "without the compiler (90 MB), so without the tasks in C++");
        options.flag("--solutions", solutions_,
                     "with all solutions, for people who learn alone: a page offers one when its task has all points");
        options.flag("--serve", serve_, "then serve it to this machine's browser");
        options.value("--port", "NUMBER", port_, "of the server [8000]");
    }
    int run() override {
        const std::optional<int> port = parse_int(port_);
        if (!port || *port < 1 || *port > 65535)
            throw UsageError("--port takes a number from 1 to 65535, not '" + port_ + "'");
        const fs::path folder = output_.empty() ? course_root() / "build" / "site-web" : fs::path(output_);
        const int code = make_site(folder, labs_, quick_, !no_compiler_, solutions_);
        return code == 0 && serve_ ? serve(folder, port_) : code;
    }

private:
    std::string output_, labs_;
    bool quick_ = false, no_compiler_ = false, solutions_ = false, serve_ = false;
    std::string port_ = "8000";
};
RELIEF_COMMAND(WebCommand, 13, "web", "makes a site on which the labs run in a browser, for any web server");

}  // namespace
}  // namespace relief::app
