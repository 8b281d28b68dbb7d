#include "framework/staff/grade/stage.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <regex>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/module.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/sha256.h"
#include "framework/core/base/text.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/transplant.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* precompiled = "included_by_tasks.h";

bool is_cpp(const std::string& file) { return file.ends_with(".cpp"); }
bool is_source(const fs::path& file) { return file.extension() == ".cpp" || file.extension() == ".h"; }
bool is_inside(const std::string& path, const std::string& folder) {
    return path == folder || path.starts_with(folder + "/");
}

/// Returns whether a path is inside a folder named `staff`, which a handout leaves out.
bool is_the_staffs(const fs::path& path) { return std::find(path.begin(), path.end(), "staff") != path.end(); }

/// Returns every file below a folder of the course, relative to the course, sorted.
std::vector<std::string> all_files_below(const std::string& folder) {
    std::vector<std::string> files;
    if (fs::is_directory(course_root() / folder))
        for (const auto& entry : fs::recursive_directory_iterator(course_root() / folder))
            if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(course_root()).string());
    std::sort(files.begin(), files.end());
    return files;
}

/// Returns the same without the staff's files.
std::vector<std::string> files_below(const std::string& folder) {
    std::vector<std::string> files = all_files_below(folder);
    std::erase_if(files, is_the_staffs);
    return files;
}

/// Creates a folder that the sandbox's user can read, independent of the umask.
void make_public(const fs::path& folder) {
    if (fs::exists(folder)) return;
    make_public(folder.parent_path());
    fs::create_directory(folder);
    fs::permissions(folder, fs::perms(0755));
}

void put(const fs::path& file, std::string_view content, bool program = false) {
    make_public(file.parent_path());
    write_file(file, content);
    fs::permissions(file, fs::perms(program ? 0755 : 0644));
}

}  // namespace

std::set<std::string> task_files(const Manifest& manifest) {
    std::set<std::string> files;
    for (const TaskInfo& task : manifest.tasks) files.insert(task.file);
    return files;
}

CourseFiles solution_files(const Manifest& manifest) {
    CourseFiles files;
    for (const std::string& file : task_files(manifest)) files[file] = read_file(course_root() / file);
    return files;
}

std::vector<fs::path> built_objects(const LabEntry& lab, const CourseFiles& replaced) {
    const fs::path list = fs::path(RELIEF_BUILD_FOLDER) / "generated/lab_objects" / lab.folder;
    std::vector<fs::path> objects;
    for (const std::string& object : split(read_file(list), '\n')) {
        // The object of several sources has another name.
        const size_t begin = object.rfind("labs/" + lab.folder + "/");
        const std::string source = begin == object.npos ? "" : object.substr(begin, object.rfind('.') - begin);
        if (!replaced.contains(source) && !is_the_staffs(source)) objects.emplace_back(object);
    }
    return objects;
}

namespace {

const std::string prefix = "relief-grade-";

/// Removes the folders of killed runs. A live run on any machine holds a lock on its folder. A run that has just begun
/// may not hold its lock yet, so young folders stay.
void remove_abandoned() {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), ignored)) {
        if (!entry.path().filename().string().starts_with(prefix)) continue;
        const auto age = fs::file_time_type::clock::now() - entry.last_write_time(ignored);
        const Descriptor folder(open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (folder >= 0 && age > std::chrono::seconds(10) && flock(folder, LOCK_EX | LOCK_NB) == 0)
            fs::remove_all(entry.path(), ignored);
    }
}

}  // namespace

PublicFolder::PublicFolder(const fs::path& parent, const std::string& name) {
    std::string path = (parent / (name + "-XXXXXX")).string();
    if (!mkdtemp(path.data())) throw Error({path}, "cannot make this folder");
    path_ = path;
    if (geteuid() == 0) fs::permissions(path_, fs::perms(0755));  // as root, the sandbox runs as another user
}
PublicFolder::~PublicFolder() {
    std::error_code ignored;  // the system cleans its temporary files
    fs::remove_all(path_, ignored);
}

Stage::Stage(Isolation isolation)
    : isolation_(isolation),
      folder_(fs::temp_directory_path(), prefix + std::to_string(getpid())),
      lock_(open(folder_.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    flock(lock_, LOCK_SH);
    remove_abandoned();
    // A submission can read all of /usr, and so would find the solutions in a course there.
    if (is_inside(fs::weakly_canonical(course_root()).string(), "/usr"))
        throw Error("the course is below /usr, which every submission can read: move it to another folder");
    copy_programs();
    copy_assets();
    make_public(folder_.path() / "courses");
    fs::create_directory(folder_.path() / "programs");  // with solutions: no submission can read this folder
    fs::permissions(folder_.path() / "programs", fs::perms(0700));
}

void Stage::copy_programs() {
    for (const char* name : {"librelief.so", "librelief-truth.so"})
        put(folder_.path() / "bin" / name, read_file(executable_folder() / name), true);
    // The running program may be `relief` or a lab's own.
    put(folder_.path() / "bin" / "relief", read_file(executable_path()), true);
}

/// Copies the assets and the textures that the build converted from them. So drawing needs no library for image files.
void Stage::copy_assets() {
    for (const std::string& file : files_below("assets"))
        if (!is_source(file)) put(folder_.path() / file, read_file(course_root() / file));
    make_public(textures());
    if (fs::is_directory(framework_folder() / "textures"))
        for (const auto& entry : fs::directory_iterator(framework_folder() / "textures"))
            put(textures() / entry.path().filename(), read_file(entry.path()));
}

void Stage::add(const LabEntry& lab) {
    if (labs_.contains(lab.folder)) return;
    const Manifest manifest = load_manifest(lab);
    LabPart part;
    for (const std::string& file : files_below("shaders/" + lab.folder))
        part.shaders[file] = check::starter_of(read_file(course_root() / file), file);
    for (const std::string& file : files_below("shaders/common"))
        put(folder_.path() / file, check::starter_of(read_file(course_root() / file), file));
    part.readable = {folder_.path() / "bin", folder_.path() / "assets", folder_.path() / "shaders"};
    for (const std::string& file : task_files(manifest)) {
        if (!is_cpp(file)) continue;
        part.solutions[file] = read_file(course_root() / file);
        part.sources[file] = check::starter_of(part.solutions[file], file);
    }
    if (!part.sources.empty()) build_lab(lab, manifest, part);
    labs_[lab.folder] = std::move(part);
}

constexpr size_t compiler_memory = size_t{2} << 30;

Words Stage::compiler(const LabEntry& lab) const {
    const std::string include = (folder_.path() / "students" / lab.folder / "include").string();
    // The build's options (see the top CMakeLists.txt), except -O1: a task runs for milliseconds.
    return {RELIEF_COMPILER,
            "-std=c++20",
            "-O1",
            "-fPIC",
            "-ffp-contract=off",
            "-fno-math-errno",
            "-fno-trapping-math",
            "-fmax-errors=20",  // ten thousand errors take minutes
            "-DFMT_SHARED",
            "-DRELIEF_LAB_FOLDER=\"" + lab.folder + "\"",
            "-I" + include,
            "-I" + include + "/labs/" + lab.folder,
            "-isystem",
            include + "/glad"};
}

/// Runs a command on the course's own sources, which need no sandbox. Throws Error if it fails.
void Stage::must(const Words& command, const char* what) const {
    const ProcessResult done =
        run_process({.command = command, .limits = {.wall = 600, .cpu = 600, .file = size_t{1} << 30}});
    if (!done.succeeded())
        throw Error(fmt::format("cannot {}: {}", what, done.errors.substr(0, done.errors.find('\n'))));
}

namespace {

/// Returns the main program of a lab with C++ tasks, with the calls of its hidden examples. It is compiled once, so an
/// example costs a submission no time.
std::string main_of(const Manifest& manifest, const std::string& includes, const CourseFiles& sources) {
    std::string text = includes;
    std::string calls;
    for (const ExampleInfo& example : manifest.examples) {
        const auto source = sources.find(manifest.task(example.task).file);
        if (source == sources.end() || !example.hidden) continue;
        // An unqualified name means a function of the task.
        static const std::regex opening("\nnamespace ([a-z0-9_:]+) \\{");
        std::smatch found;
        const bool is_found = std::regex_search(source->second, found, opening);
        for (const std::string& call : example.calls)
            calls += fmt::format("    if (call == R\"call({0})call\") {{ {1} return as_pixel({0}); }}\n", call,
                                 is_found ? "using namespace " + found[1].str() + ";" : "");
    }
    text +=
        "#include \"framework/course/check/calls.h\"\n"
        "namespace relief::check {\n"
        "[[noreturn]] void draw_request(const char* course);\n"
        "namespace {\n"
        "std::optional<glm::dvec4> value([[maybe_unused]] const std::string& call) {\n" +
        calls +
        "    return {};\n"
        "}\n"
        "const ProvidedCalls provided(&value);\n"
        "}\n"
        "}\n"
        "int main(int, char** words) { relief::check::draw_request(words[3]); }\n";
    return text;
}

}  // namespace

/// Compiles one of the course's own sources.
void Stage::compile_ours(const LabEntry& lab, const fs::path& source, const fs::path& object,
                         const Words& options) const {
    Words command = compiler(lab);
    command.insert(command.end(), options.begin(), options.end());
    command.insert(command.end(), {"-c", source.string(), "-o", object.string()});
    must(command, "compile the lab for its C++ tasks");
}

/// Prepares the headers, the lab's objects, and the library that students build. None of them contains an answer.
void Stage::build_lab(const LabEntry& lab, const Manifest& manifest, LabPart& part) {
    const fs::path here = folder_.path() / "students" / lab.folder, include = here / "include",
                   build = RELIEF_BUILD_FOLDER;
    for (const std::string& file : files_below("framework"))
        if (file.ends_with(".h")) put(include / file, check::starter_of(read_file(course_root() / file), file));
    for (const auto& entry : fs::recursive_directory_iterator(build / "generated/glad/include"))
        if (entry.is_regular_file())
            put(include / "glad" / entry.path().lexically_relative(build / "generated/glad/include"),
                read_file(entry.path()));
    for (const std::string& file : files_below("labs/" + lab.folder))
        if (file.ends_with(".h")) put(include / file, check::starter_of(read_file(course_root() / file), file));
    // A lab's C++ may share a file of constants with its shaders.
    for (const auto& [file, text] : part.shaders) put(include / file, text);
    // Precompiles the headers that the tasks' starters include: they take nine tenths of a task's compile time.
    std::string includes;
    for (const auto& [name, text] : part.sources)
        for (const std::string& line : split(text, '\n'))
            if (line.starts_with("#include")) includes += line + '\n';
    put(include / precompiled, includes);
    compile_ours(lab, include / precompiled, (include / precompiled).string() + ".gch", {"-x", "c++-header"});
    part.objects.push_back(here / "main.o");
    const fs::path main = folder_.path() / "programs/main.cpp";  // it has the text of hidden calls
    write_file(main, main_of(manifest, includes, part.sources));
    compile_ours(lab, main, part.objects.back(), {"-include", (include / precompiled).string()});
    build_others(lab, manifest, part);
    for (const fs::path& object : built_objects(lab, part.sources)) {
        part.objects.push_back(here / object.filename());
        put(part.objects.back(), read_file(object));
    }

    fs::copy_file(folder_.path() / "bin/librelief.so", here / "librelief.so");
    fs::create_directory_symlink(textures(), here / "textures");
    for (const auto& entry : fs::recursive_directory_iterator(here))
        fs::permissions(entry.path(), fs::perms(entry.is_directory() ? 0755 : 0644));
    part.readable = {here, textures(), folder_.path() / "assets", folder_.path() / "shaders"};
}

void Stage::build_others(const LabEntry& lab, const Manifest& manifest, LabPart& part) const {
    const fs::path folder = folder_.path() / "programs",
                   header = folder_.path() / "students" / lab.folder / "include" / precompiled;
    const auto has_others = [&](const TaskInfo& task) {
        return std::any_of(manifest.tasks.begin(), manifest.tasks.end(),
                           [&](const TaskInfo& other) { return other.id != task.id && is_cpp(other.file); });
    };
    for (const TaskInfo& task : manifest.tasks) {
        if (!is_cpp(task.file) || !has_others(task)) continue;
        for (const auto& [file, text] : part.solutions) {
            const fs::path object = folder / fmt::format("others-{}-{}.o", task.id, part.others[task.id].size()),
                           source = folder / "others.cpp";
            write_file(source, file == task.file ? without_task(text, manifest.tasks, task) : text);
            compile_ours(lab, source, object, {"-include", header.string()});
            part.others[task.id].push_back(object);
        }
    }
}

StagedCourse Stage::course(const LabEntry& lab, const CourseFiles& files, const std::string& alone) const {
    const LabPart& part = labs_.at(lab.folder);
    StagedCourse course;
    course.folder = std::make_unique<PublicFolder>(folder_.path() / "courses", "c");
    const fs::path& root = course.folder->path();
    const auto text = [&](const auto& starter) {
        const auto own = files.find(starter.first);
        return own == files.end() ? starter.second : own->second;
    };
    for (const auto& starter : part.shaders) put(root / starter.first, text(starter));
    for (const auto& starter : part.sources)
        put(root / starter.first, alone.empty() || files.contains(starter.first) ? text(starter) : "");
    if (const auto others = part.others.find(alone); others != part.others.end())
        for (const fs::path& object : others->second) {
            course.objects.push_back(root / object.filename());
            put(course.objects.back(), read_file(object));
        }
    put(root / "labs/README.md", "");  // the program recognises a course by labs/ and shaders/
    fs::create_directory_symlink(folder_.path() / "shaders/common", root / "shaders/common");
    fs::create_directory_symlink(folder_.path() / "assets", root / "assets");
    course.program = folder_.path() / "bin/relief";
    course.libraries = part.readable.front();
    course.readable = part.readable;
    course.readable.push_back(root);
    return course;
}

namespace {

/// Returns whether a compiler perhaps could not start its subprocesses, or write its files. Messages about a source
/// begin with a place in it. But a source can imitate a message of the compiler with #line, so this is only a guess.
bool may_be_the_machines(const ProcessResult& done) {
    static const std::regex own(
        "(^|\n)[^ :\n]*(sh: [0-9]+: Cannot fork|(\\+\\+|cc|gcc|clang|collect2|ld|as)(-[0-9]+)?: "
        "(fatal error|error|fatal): [^\n]*(cannot execute|cannot fork|vfork|posix_spawn|"
        "Resource temporarily unavailable|Cannot allocate memory))|No space left on device");
    return done.ending == Ending::failed ||
           (done.ending == Ending::exited && done.code != 0 && std::regex_search(done.errors, own));
}

/// Returns how a compiler ended. A limit may end only a subprocess; then only the message tells.
Ending ending_of(const ProcessResult& compiler) {
    static const std::regex time("CPU time limit exceeded"),
        memory("virtual memory exhausted|out of memory allocating|Killed signal terminated program");
    if (compiler.ending != Ending::exited) return compiler.ending;
    if (std::regex_search(compiler.errors, time)) return Ending::out_of_time;
    return std::regex_search(compiler.errors, memory) ? Ending::out_of_memory : Ending::exited;
}

}  // namespace

/// Returns the file that keeps the program of a course whose C++ tasks are all starters or solutions; empty if a task
/// has other text.
fs::path Stage::program_of_ours(const LabEntry& lab, const StagedCourse& course) const {
    const LabPart& part = labs_.at(lab.folder);
    if (!course.objects.empty()) return {};
    std::string all = lab.folder;
    for (const auto& [file, starter] : part.sources) {
        const std::string text = read_file(course.folder->path() / file);
        if (text != starter && text != part.solutions.at(file)) return {};
        all += '\n' + sha256(text);
    }
    return folder_.path() / "programs" / sha256(all);
}

Compiled Stage::compile(const LabEntry& lab, StagedCourse& course, double cpu, double wall) const {
    if (labs_.at(lab.folder).sources.empty()) return {};
    const fs::path ours = program_of_ours(lab, course), program = course.folder->path() / "program";
    if (!ours.empty() && fs::exists(ours)) {
        put(program, read_file(ours), true);
        course.program = program;
        return {};
    }
    ProcessResult done = run_compiler(lab, course, cpu, wall);
    if (may_be_the_machines(done)) done = run_compiler(lab, course, cpu, wall);  // the machine may be less busy now
    // If the starters fail in the same way, the machine is to blame.
    if (may_be_the_machines(done) && may_be_the_machines(run_compiler(lab, this->course(lab, {}), cpu, wall)))
        done.ending = Ending::failed;
    Compiled compiled{.ending = ending_of(done), .message = {}, .seconds = done.wall, .stopped = done.stopped};
    if (done.succeeded()) {
        put(program, done.output, true);
        course.program = program;
        if (!ours.empty()) write_file(ours, done.output);
        return compiled;
    }
    compiled.message = done.errors.empty() ? "the compiler says nothing" : done.errors;
    return compiled;
}

ProcessResult Stage::run_compiler(const LabEntry& lab, const StagedCourse& course, double cpu, double wall) const {
    const LabPart& part = labs_.at(lab.folder);
    const fs::path& root = course.folder->path();
    const fs::path library = folder_.path() / "students" / lab.folder;
    // The program comes back through the pipe, so that only the sandbox's own memory need be writable.
    Words command = {"/bin/sh", "-c", "cd \"$1\" && shift && \"$@\" -o /tmp/program && cat /tmp/program", "sh",
                     root.string()};
    for (const std::string& word : compiler(lab)) command.push_back(word);
    command.insert(command.end(), {"-include", (library / "include" / precompiled).string()});
    for (const auto& [source, starter] : part.sources) command.push_back(source);
    for (const auto* const objects : {&part.objects, &course.objects})
        for (const fs::path& object : *objects) command.push_back(object.string());
    for (const std::string& word :
         {(library / "librelief.so").string(), "-Wl,-rpath," + library.string(), std::string("-Wl,-z,lazy"),
          std::string("-Wl,--allow-shlib-undefined"), std::string("-lfmt")})
        command.push_back(word);
    return run_sandboxed({.command = command,
                          .environment = {{"LC_ALL", "C.UTF-8"}, {"TMPDIR", "/tmp"}},
                          .limits = {.wall = wall,
                                     .cpu = std::ceil(cpu),
                                     .memory = compiler_memory,
                                     .output = size_t{32} << 20,
                                     .file = size_t{128} << 20}},
                         {.isolation = isolation_, .readable = course.readable, .processes = 16});
}

std::string Stage::hash() const {
    std::string all;
    for (const char* folder : {"labs", "shaders", "assets"})
        for (const std::string& file : all_files_below(folder))
            all += file + sha256(read_file(course_root() / file)) + '\n';
    for (const char* program : {"relief", "librelief.so", "librelief-truth.so"})
        all += sha256(read_file(folder_.path() / "bin" / program));
    all += sha256(read_file(executable_folder() / "librelief-staff.so"));
    return sha256(all);
}

}  // namespace relief::grade
