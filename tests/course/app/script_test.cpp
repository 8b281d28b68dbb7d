// The script `relief`, with stand-ins for the tools that it calls. Each stand-in records its arguments.
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "tests/course/app/course_copy.h"

namespace relief::app {
namespace {

class Script : public testing::Test {
protected:
    TemporaryFolder folder_;
    std::string usr_ = "/usr/bin:/bin";          ///< the folders of the tools that are no stand-ins
    std::map<std::string, std::string> system_;  ///< the variables by which the script knows another system

    void SetUp() override {
        namespace fs = std::filesystem;
        const fs::path source = source_folder;
        fs::create_directories(folder_.path() / "framework/cmake");
        fs::create_directories(folder_.path() / "tests");
        fs::copy(source / "relief", folder_.path());
        copy_commands("course");
        for (const char* system : {"", "_fedora", "_arch", "_opensuse", "_brew", "_msys2"})
            fs::copy(source / ("framework/cmake/packages" + std::string(system) + ".txt"),
                     folder_.path() / "framework/cmake");
        stand_in("cmake",
                 "mkdir -p build && touch build/build.ninja && "
                 "printf 'RELIEF_TESTS:BOOL=ON\\nCMAKE_HOME_DIRECTORY:INTERNAL=%s\\n' \"$PWD\" >build/CMakeCache.txt");
        stand_in("ninja",
                 "[[ -e build/bin/relief ]] && echo 'ninja: no work to do.' && exit\n"
                 "echo '[0/1] Re-checking globbed directories...'; echo '[1/7] Building CXX object a.o'\n"
                 "mkdir -p build/bin && printf '#!/bin/bash\\necho \"ran: $*\"\\n' >build/bin/relief && chmod +x "
                 "build/bin/relief");
        stand_in("ctest", "true");
        stand_in("apt-get", "true");
        stand_in("sudo", "exit 1");
        stand_in("id", "echo 0");
        installed("");
    }
    /// Copies the sources from which the script takes the commands of a half, "course" or "staff".
    void copy_commands(const std::string& half) const {
        const std::string folder = "framework/" + half + "/app";
        std::filesystem::create_directories(folder_.path() / folder);
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(source_folder) / folder))
            std::filesystem::copy(entry.path(), folder_.path() / folder);
    }
    /// Creates a tool that appends its arguments to `calls`, then runs `body`.
    void stand_in(const std::string& name, const std::string& body) const {
        const auto file = folder_.write("tools/" + name, "#!/bin/bash\ncd '" + folder_.path().string() + "'\necho \"" +
                                                             name + " $*\" >>calls\n" + body + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }
    /// Makes all packages appear installed except `but` (a pattern for grep).
    void installed(const std::string& but) const {
        stand_in("dpkg-query",
                 "awk '!/^#/ { print \"installed \" $2 }' framework/cmake/packages.txt | grep -vxE 'installed (" + but +
                     ")'");
    }
    /// Returns the PATH of all runs: the stand-ins, and then the system's tools.
    std::string path() const { return (folder_.path() / "tools").string() + ":" + usr_; }
    Result script(std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.begin(), {"bash", folder_.path() / "relief"});
        std::map<std::string, std::string> environment = system_;
        environment.insert({{"PATH", path()}, {"CI", ""}});
        return run(arguments, {"/", environment});
    }
    std::string calls() const {
        const std::string text = read_all(folder_.path() / "calls");
        std::filesystem::remove(folder_.path() / "calls");
        return text;
    }
};

TEST_F(Script, ConfiguresBuildsAndHandsItsArgumentsOn) {
    const Result result = script({"shot", "01", "-o", "a b.png"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "ran: shot 01 -o a b.png\n");
    const std::string called = calls();
    EXPECT_TRUE(contains(called, "cmake -S")) << called;
    EXPECT_TRUE(contains(called, "-DCMAKE_BUILD_TYPE=Release")) << called;
    EXPECT_FALSE(contains(called, "apt-get")) << called;
}

TEST_F(Script, InstallsAnOptionalPackageOnlyWhereTheSystemHasIt) {
    for (const bool has_it : {false, true}) {
        installed("libmd4c-dev|libosmesa6");
        stand_in("apt-cache", has_it ? "true" : "[[ $2 != libosmesa6 ]]");
        std::filesystem::remove_all(folder_.path() / "build");
        const Result result = script({"list"});
        EXPECT_EQ(result.code, 0) << result.err;
        const std::string called = calls();
        EXPECT_TRUE(contains(called, "libmd4c-dev")) << called;
        EXPECT_EQ(contains(called, "install -y --no-install-recommends libmd4c-dev libosmesa6\n"), has_it) << called;
        EXPECT_EQ(contains(called, "install -y --no-install-recommends libmd4c-dev\n"), !has_it) << called;
    }
}

TEST_F(Script, ASecondRunNeitherQueriesPackagesNorConfigures) {
    script();
    calls();
    EXPECT_EQ(script().code, 0);
    const std::string called = calls();
    for (const char* tool : {"dpkg-query", "apt-get", "cmake"}) EXPECT_FALSE(contains(called, tool)) << called;
}

TEST_F(Script, HelpAndUsageErrorsNeitherInstallNorBuild) {
    installed("libglm-dev");
    for (const std::vector<std::string>& question : {std::vector<std::string>{"--help"},
                                                     {"-h"},
                                                     {"help"},
                                                     {"help", "shot"},
                                                     {"shot", "--help"},
                                                     {"test", "--help"},
                                                     {"build", "-h"}}) {
        const Result result = script(question);
        EXPECT_EQ(result.code, 0) << question[0];
        EXPECT_TRUE(contains(result.out, "./relief test --all") && contains(result.out, "\n  shot ")) << result.out;
    }
    const Result unknown = script({"sh.t"});
    EXPECT_EQ(unknown.code, 2) << "a word, no pattern";
    EXPECT_TRUE(unknown.err.starts_with("relief: unknown command 'sh.t'; there are: list, info, ")) << unknown.err;
    EXPECT_TRUE(unknown.err.ends_with(", build, test, site\n")) << unknown.err;
    EXPECT_EQ(script({"build", "01"}).err, "relief: build takes nothing else: '01'\n");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "calls")) << calls();
}

TEST_F(Script, PrintsTheVersionWithoutABuild) {
    folder_.write("CMakeLists.txt",
                  "cmake_minimum_required(VERSION 3.25)\nproject(relief VERSION 1.2.3 LANGUAGES C)\n");
    for (const char* option : {"-v", "--version"}) EXPECT_EQ(script({option}).out, "relief 1.2.3 (not built)\n");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "calls")) << calls();
    script({"list"});
    for (const char* option : {"-v", "--version"}) EXPECT_EQ(script({option}).out, "ran: --version\n");
}

TEST_F(Script, ANumberRunsThatLab) {
    EXPECT_EQ(script({"3x"}).code, 2);
    EXPECT_EQ(script({"03", "--set", "a=b"}).out, "ran: run 03 --set a=b\n");
}

TEST_F(Script, ABuiltProgramNamesTheNearestCommandOfTheScriptToo) {
    script();
    calls();
    EXPECT_EQ(script({"tets"}).out, "ran: tets\n");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "calls")) << calls();
    const Result guessed = run({relief_program(), "tets"}, {"/", {{"RELIEF_SCRIPT_COMMANDS", "build test site"}}});
    EXPECT_EQ(guessed.code, 2);
    EXPECT_TRUE(contains(guessed.err, "unknown command 'tets': did you mean 'test'?")) << guessed.err;
}

TEST_F(Script, ForwardsHelpToABuiltProgramAndRebuildsItForLabKnobs) {
    script();
    calls();
    EXPECT_EQ(script({"help", "shot"}).out, "ran: shot --help\n");
    EXPECT_EQ(script({"shot", "--help"}).out, "ran: shot --help\n");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "calls")) << calls();
    EXPECT_EQ(script({"shot", "01", "--help"}).out, "ran: shot 01 --help\n");
    EXPECT_TRUE(contains(calls(), "ninja"));
}

/// Returns the lines of a help that begin with two spaces and a word, as "word: the rest".
std::set<std::string> commands_in(const std::string& help, const std::string& heading) {
    std::set<std::string> found;
    std::istringstream lines(help.substr(help.find(heading)));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, word, text;
        if (!line.starts_with("  ") || line.starts_with("   ") || !(words >> name)) continue;
        while (words >> word) text += " " + word;
        found.insert(name + ":" + text);
    }
    return found;
}

TEST_F(Script, ListsTheProgramsCommandsInTheCourseAndInTheHandout) {
    const auto commands_of = [](const Result& help) {
        std::istringstream lines(help.out);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
        // Without the line breaks of a column.
        return commands_in(std::regex_replace(help.out, std::regex("\n {6,}"), " "), "Commands for students:");
    };
    const std::set<std::string> program = commands_of(run({relief_program(), "--help"}));
    std::set<std::string> students = commands_of(script({"--help"}));
    EXPECT_LT(students.size(), program.size());
    for (const char* staff : {"bench", "handout", "grade", "web", "slides", "mistakes", "synctest", "map", "questions"})
        for (const std::string& one : program)
            if (one.starts_with(std::string(staff) + ":")) students.insert(one);
    EXPECT_EQ(students, program);
    copy_commands("staff");
    EXPECT_EQ(commands_of(script({"--help"})), program);
}

TEST_F(Script, InstallsCcacheBeforeTheFirstConfigure) {
    installed("ccache");
    EXPECT_EQ(script({"list"}).code, 0);
    const std::string called = calls();
    EXPECT_LT(called.find("install -y --no-install-recommends ccache\n"), called.find("cmake -S")) << called;
}

TEST_F(Script, ABuildFolderOfAnotherPathIsLeftAlone) {
    script();
    calls();
    const std::string cache = "CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere/else\n";
    folder_.write("build/CMakeCache.txt", cache);
    for (const std::vector<std::string>& words : {std::vector<std::string>{"list"}, {"build"}, {"test"}}) {
        const Result result = script(words);
        EXPECT_EQ(result.code, 1);
        const std::string build = (folder_.path() / "build").string();
        EXPECT_EQ(result.err, "relief: " + build +
                                  " is the build folder of the course in /somewhere/else, and is left alone: if you "
                                  "moved or copied the course from there, remove it (rm -r " +
                                  build + "); if that course is in use, clone it to work here\n");
    }
    EXPECT_EQ(read_all(folder_.path() / "build/CMakeCache.txt"), cache);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "calls")) << calls();
}

TEST_F(Script, RunsABuiltProgramInAReadOnlyCourse) {
    namespace fs = std::filesystem;
    script();
    calls();
    folder_.write("build/.ninja_log", "");
    // Root may write to everything, so another user comes.
    std::vector<std::string> visitor;
    if (geteuid() == 0) visitor = {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
    const auto visits = [&](const std::vector<std::string>& words) {
        std::vector<std::string> command = visitor;
        command.insert(command.end(), {"bash", folder_.path() / "relief"});
        command.insert(command.end(), words.begin(), words.end());
        return run(command, {"/", {{"PATH", path()}, {"CI", ""}}});
    };
    const fs::path build = folder_.path() / "build";
    for (const fs::path& place : {build / ".ninja_log", build}) {
        fs::permissions(place, fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write,
                        fs::perm_options::remove);
        const Result shown = visits({"shot", "01"});
        EXPECT_EQ(shown.out, "ran: shot 01\n");
        EXPECT_EQ(shown.err, "");
    }
    for (const char* word : {"build", "site", "test"}) {
        const Result refused = visits({word});
        EXPECT_EQ(refused.code, 1);
        EXPECT_EQ(refused.err, "relief: nothing can be built here: you may not write to " + build.string() +
                                   "; copy the course to a folder of your own\n");
    }
    fs::permissions(build, fs::perms::owner_write, fs::perm_options::add);
    EXPECT_FALSE(fs::exists(folder_.path() / "calls")) << calls();
}

TEST_F(Script, HandInPacksATaskThatDoesNotCompile) {
    EXPECT_EQ(script({"hand-in", "3"}).out, "ran: hand-in 3\n");
    stand_in("ninja", "echo 'FAILED: a.o'; echo \"labs/05_x/task.cpp:3:1: error: expected ';'\"; exit 1");
    const Result packed = script({"hand-in", "3"});
    EXPECT_EQ(packed.code, 1);
    EXPECT_EQ(packed.out, "ran: hand-in 3\n") << "by the program of the last build";
    EXPECT_TRUE(contains(packed.err, "labs/05_x/task.cpp:3:1: error: ")) << packed.err;
    EXPECT_TRUE(contains(packed.err, "relief: it is packed all the same:\n")) << packed.err;
    EXPECT_EQ(script({"list"}).out, "") << "no other command runs an old program";
}

TEST_F(Script, WithoutATerminalABuildSaysHowFarItIs) {
    // Time is a file: ninja's stand-in lets it pass, and that of sleep waits for it.
    stand_in("sleep",
             "[[ $1 == 10 ]] || exit 1\nwhile [[ ! -e tick && -e calls ]]; do /bin/sleep 0.01; done; rm -f tick");
    stand_in("ninja",
             "echo '[1/7] Building CXX object a.o'; echo '[3/7] Building CXX object b.o'\n"
             "for i in {1..40}; do touch tick; for j in {1..10}; do [[ -e tick ]] && /bin/sleep 0.01; done; done\n"
             "mkdir -p build/bin && printf '#!/bin/bash\\ntrue\\n' >build/bin/relief && chmod +x build/bin/relief");
    const Result result = script({"list"});
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(contains(result.err, "relief: building: 3 of 7 steps done, 4 left\n")) << result.err;
}

TEST_F(Script, BuildsTheSiteInOrderAndOnlyOutdatedParts) {
    folder_.write("framework/staff/staff.cmake", "");
    stand_in("ninja",
             "[[ -e build/bin/relief ]] && exit\nmkdir -p build/bin\n"
             "printf '#!/bin/bash\\necho \"relief $*\" >>calls; [[ $2 == --quiz ]] && set quiz\\nmkdir -p build/$1\\n"
             "touch build/$1/{index,00_relief}.html\\n' >build/bin/relief && chmod +x build/bin/relief");
    const auto made = [&] {
        const Result result = run({"bash", folder_.path() / "relief", "site"}, {folder_.path(), {{"PATH", path()}}});
        EXPECT_EQ(result.code, 0) << result.err;
        const std::string build = (folder_.path() / "build").string();
        EXPECT_EQ(result.out, build + "/gallery/index.html\n" + build + "/mistakes/index.html\n");
        std::string commands;
        std::istringstream lines(calls());
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("relief ")) commands += line.substr(7) + "; ";
        return commands;
    };
    EXPECT_EQ(made(), "slides; bench --quick; mistakes --quiz; gallery; mistakes; ");
    EXPECT_EQ(made(), "");
    folder_.write("shaders/changed.glsl", "");
    EXPECT_EQ(made(), "slides; mistakes --quiz; gallery; mistakes; ") << "measurements stay";
    folder_.write("build/bench/index.html", "measured at length");
    EXPECT_EQ(made(), "gallery; ") << "it takes a copy";
    std::filesystem::remove(folder_.path() / "build/mistakes/index.html");
    EXPECT_EQ(made(), "mistakes; ");
    std::filesystem::remove_all(folder_.path() / "framework/staff");
    std::filesystem::remove_all(folder_.path() / "build/gallery");
    const Result students = script({"site"});
    EXPECT_EQ(students.out, (folder_.path() / "build/gallery/index.html").string() + "\n");
    EXPECT_EQ(script({"site", "1"}).err, "relief: site takes nothing else: '1'\n");
}

TEST_F(Script, SimultaneousStartsBuildOneAfterTheOther) {
    // A build fails if another build is running in the folder.
    stand_in("ninja",
             "mkdir building || exit 1; sleep 0.2; rmdir building\n"
             "mkdir -p build/bin && printf '#!/bin/bash\nflock --nonblock build/lock echo free\n' >build/bin/relief."
             "$$ && chmod +x build/bin/relief.$$ && mv build/bin/relief.$$ build/bin/relief");
    const std::vector<std::string> words = {"bash", folder_.path() / "relief", "list"};
    const Circumstances where{folder_.path(), {{"PATH", path()}}};
    std::vector<std::unique_ptr<Process>> starts;
    for (int i = 0; i < 6; ++i) starts.push_back(std::make_unique<Process>(words, where));
    int waited = 0, free = 0;
    for (const auto& start : starts) {
        const Result result = start->wait();
        EXPECT_TRUE(result.code == 0 || result.out.empty()) << result.err;
        EXPECT_FALSE(contains(result.err, "failed")) << result.err;
        waited += contains(result.err, "another ./relief is building here: waiting for its end\n");
        free += result.out == "free\n";
    }
    EXPECT_GE(waited, 1);
    EXPECT_GE(free, 1) << "the lock is held while the program runs";
}

TEST_F(Script, RootInstallsOnlyTheMissingPackagesAndWithoutATerminalEachStepIsALine) {
    installed("libglm-dev|xvfb");
    const Result list = script({"list"});
    EXPECT_EQ(list.code, 0);
    EXPECT_EQ(list.err,
              "relief: installing 1 package: libglm-dev\nrelief: configuring\n"
              "relief: building, 7 steps\n");
    std::string called = calls();
    EXPECT_TRUE(contains(called, "apt-get update\n")) << called;
    EXPECT_TRUE(contains(called, "apt-get install -y --no-install-recommends libglm-dev\n")) << called;
    EXPECT_EQ(script({"list"}).err, "") << "up to date";
    const Result test = script({"test"});
    EXPECT_EQ(test.code, 0);
    EXPECT_EQ(test.err, "relief: installing 1 package: libglm-dev\nrelief: configuring\nrelief: testing\n");
    called = calls();
    EXPECT_FALSE(contains(called, "xvfb")) << "what is run every day wants no X server: " << called;
    EXPECT_EQ(script({"test", "--ci"}).code, 0);
    called = calls();
    EXPECT_TRUE(contains(called, "--no-install-recommends libglm-dev xvfb\n")) << called;
}

TEST_F(Script, CiRunsOnlyTheMainTestsIfTheDailyOnesHavePassed) {
    EXPECT_EQ(script({"test"}).code, 0);
    EXPECT_TRUE(contains(calls(), "--label-exclude ^ci$\n"));
    EXPECT_EQ(script({"test", "--ci"}).code, 0);
    EXPECT_TRUE(contains(calls(), "--label-regex ^ci$\n"));
    folder_.write("shaders/changed.glsl", "");
    EXPECT_EQ(script({"test", "--ci"}).code, 0);
    EXPECT_FALSE(contains(calls(), "--label"));
    EXPECT_EQ(script({"test", "-R", "handout"}).code, 0);
    EXPECT_TRUE(contains(calls(), "-R handout\n")) << "among all tests";
}

// A sample that misses what a change touches guards nothing; one that changes between two runs helps nobody to look.
TEST_F(Script, CiChoosesFiveLabsByTheCommitAndThoseThatItTouchesFirst) {
    const auto chosen = [&](const std::map<std::string, std::string>& variables = {}) {
        std::map<std::string, std::string> all = {{"PATH", path()}};
        all.insert(variables.begin(), variables.end());
        const Result result = run({"bash", folder_.path() / "relief", "test", "--ci"}, {"/", all});
        const std::string labs = read_all(folder_.path() / "labs-of-ctest");
        EXPECT_TRUE(contains(result.err, "look at labs " + labs.substr(0, 14) + "; at all of them with --all\n"))
            << result.err;
        return labs.substr(0, 14);
    };
    const auto git = [&](const std::string& words) {
        const std::string command = "git -c user.name=x -c user.email=x@x.org -c init.defaultBranch=main " + words;
        EXPECT_EQ(run({"bash", "-c", "cd '" + folder_.path().string() + "'; " + command}).code, 0) << words;
    };
    stand_in("ctest", "echo \"$RELIEF_TEST_LABS\" >labs-of-ctest");
    for (int lab = 10; lab < 30; ++lab)
        for (const char* folder : {"labs/", "shaders/"})
            folder_.write(folder + std::to_string(lab) + "_lab_" + std::to_string(lab) + "/file", "text");
    folder_.write(".gitignore", "build\ncalls\nlabs-of-ctest\ntools\n");
    EXPECT_EQ(chosen().size(), 14u) << "five numbers, without a repository";
    git("init -q; git add -A; git -c user.name=x -c user.email=x@x.org commit -q -m 1");
    const std::string first = chosen();
    EXPECT_EQ(chosen(), first);
    std::set<std::string> samples = {first};
    for (int i = 0; i < 4; ++i) {
        git("commit -q --allow-empty -m more");
        samples.insert(chosen());
    }
    EXPECT_GE(samples.size(), 4u) << "one of fifteen thousand samples twice";
    for (int lab = 10; lab < 30; ++lab) {
        const std::string number = std::to_string(lab);
        if (contains(chosen(), number)) continue;
        const auto file = folder_.write("shaders/" + number + "_lab_" + number + "/file", "an edit");
        EXPECT_TRUE(contains(chosen(), number)) << chosen();
        folder_.write("shaders/" + number + "_lab_" + number + "/file", "text");
        folder_.write("tests/labs/lab_" + number + "_test.cpp", "a new file");
        EXPECT_TRUE(contains(chosen(), number)) << chosen();
        git("add -A; git -c user.name=x -c user.email=x@x.org commit -q -m touches");
        EXPECT_TRUE(contains(chosen(), number)) << "the last commit";
        for (int i = 0; i < 3; ++i) git("commit -q --allow-empty -m more");
        EXPECT_TRUE(contains(chosen({{"RELIEF_TEST_SINCE", "HEAD~4"}}), number)) << "all since a push";
        break;
    }
}

TEST_F(Script, WithoutRootOrSudoPrintsTheInstallCommandAndStops) {
    installed("libglm-dev");
    stand_in("id", "echo 1000");
    const Result result = script({"list"});
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err,
              "relief: packages are missing; as root, run: apt-get update && apt-get install "
              "--no-install-recommends libglm-dev\n");
    EXPECT_FALSE(contains(calls(), "cmake"));
}

/// The stand-ins of a system without apt-get: its package manager, and a tool that knows what is installed.
class OtherSystem : public Script {
protected:
    void SetUp() override {
        namespace fs = std::filesystem;
        Script::SetUp();
        fs::remove(folder_.path() / "tools/apt-get");
        fs::remove(folder_.path() / "tools/dpkg-query");
        fs::create_directories(folder_.path() / "usr");
        for (const auto& tool : fs::directory_iterator("/usr/bin")) {
            const std::string name = tool.path().filename();
            if (!name.starts_with("apt") && !name.starts_with("dpkg") && name != "npm")
                fs::create_symlink(tool.path(), folder_.path() / "usr" / name);
        }
        usr_ = (folder_.path() / "usr").string();
    }
    /// Adds a package manager, and makes all packages appear installed except `but` (a pattern for grep).
    void manager(const std::string& name, const std::string& but) const {
        stand_in(name,
                 name == "pacman" ? "[[ $1 != -T ]] || ! printf '%s\\n' \"${@:2}\" | grep -xE '" + but + "'" : "");
        if (name != "pacman") stand_in("rpm", "! grep -qxE '" + but + "' <<<\"${@: -1}\"");
    }
};

TEST_F(OtherSystem, InstallsOnlyTheMissingPackagesUnderTheSystemsNames) {
    const std::string fedora = "dnf install --setopt=install_weak_deps=False -y ";
    for (const auto& [name, but, command] : std::vector<std::array<std::string, 3>>{
             {"dnf", "glad2|glm-devel|gtest-devel", fedora + "glad2 glm-devel\n"},
             {"zypper", "Mesa-dri|fmt-devel|gtest", "zypper install --no-recommends -y Mesa-dri fmt-devel\n"},
             {"pacman", "ninja|glfw|gtest", "pacman -S --needed --noconfirm ninja glfw\n"}}) {
        std::filesystem::remove_all(folder_.path() / "build");
        manager(name, but);
        const Result result = script({"list"});
        EXPECT_EQ(result.code, 0) << result.err;
        EXPECT_TRUE(result.err.starts_with("relief: installing 2 packages: ")) << result.err;
        std::string called = calls();
        EXPECT_TRUE(contains(called, command)) << called;
        EXPECT_LT(called.find(command), called.find("cmake -S")) << called;
        EXPECT_FALSE(contains(called, "apt-get")) << called;
        EXPECT_EQ(script({"test"}).code, 0);
        called = calls();
        EXPECT_TRUE(contains(called, name == "dnf" ? " gtest-devel\n" : " gtest\n")) << called;
        std::filesystem::remove_all(folder_.path() / "build");
        manager(name, "none");
        EXPECT_EQ(script({"build"}).err, "relief: configuring\nrelief: building, 7 steps\n");
        called = calls();
        EXPECT_FALSE(contains(called, " install ") || contains(called, "pacman -S")) << called;
        std::filesystem::remove(folder_.path() / "tools" / name);
    }
}

TEST_F(OtherSystem, WithoutRootOrSudoPrintsItsOwnInstallCommandAndStops) {
    stand_in("id", "echo 1000");
    for (const auto& [name, command] :
         std::map<std::string, std::string>{{"dnf", "dnf install --setopt=install_weak_deps=False cmake git\n"},
                                            {"zypper", "zypper install --no-recommends cmake git\n"},
                                            {"pacman", "pacman -S --needed cmake git\n"}}) {
        manager(name, "cmake|git");
        const Result result = script({"list"});
        EXPECT_EQ(result.code, 1);
        EXPECT_EQ(result.err, "relief: packages are missing; as root, run: " + command);
        EXPECT_FALSE(contains(calls(), "cmake -S"));
        std::filesystem::remove(folder_.path() / "tools" / name);
    }
}

TEST_F(OtherSystem, WithAnUnknownPackageManagerPrintsDebiansNamesAndBuilds) {
    const Result result = script({"list"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(
        result.err.starts_with("relief: there is no apt-get, brew, dnf, pacman or zypper here: install what "
                               "Debian calls g++ cmake ninja-build "))
        << result.err;
    EXPECT_EQ(result.out, "ran: list\n");
    EXPECT_EQ(script({"list"}).err, "") << "only once";
}

// Neither Homebrew nor MSYS2 needs root. Neither system has a variable DISPLAY.
TEST_F(OtherSystem, OnMacOsInstallsHomebrewsPackagesAsTheUserAndOpensTheMenu) {
    system_ = {{"OSTYPE", "darwin23"}};
    stand_in("id", "echo 501");
    stand_in("brew", "[[ $1 != list ]] || awk '!/^#/ { print $2 }' framework/cmake/packages_brew.txt | grep -vx glm");
    Result result = script();
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "ran: \n");
    EXPECT_TRUE(result.err.starts_with("relief: installing 1 package: glm\n")) << result.err;
    EXPECT_TRUE(contains(calls(), "brew install glm\n"));
    std::filesystem::remove(folder_.path() / "tools/brew");
    std::filesystem::remove_all(folder_.path() / "build");
    result = script({"list"});
    EXPECT_TRUE(contains(result.err, "there is no apt-get, brew, dnf")) << result.err;
}

TEST_F(OtherSystem, InMsys2InstallsItsPackagesAsTheUserAndOpensTheMenu) {
    system_ = {{"OSTYPE", "msys"}, {"MSYSTEM", "UCRT64"}};
    stand_in("id", "echo 197609");
    stand_in("cygpath", "echo \"$2\"");
    manager("pacman", "mingw-w64-ucrt-x86_64-glm");
    const Result result = script();
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "ran: \n");
    EXPECT_TRUE(contains(calls(), "pacman -S --needed --noconfirm mingw-w64-ucrt-x86_64-glm\n"));
    system_["MSYSTEM"] = "MINGW64";
    EXPECT_EQ(script().err, "relief: this needs MSYS2's terminal UCRT64: here is MINGW64\n");
}

TEST_F(OtherSystem, TheStaffsCommandsAndTheTestsNeedLinux) {
    system_ = {{"OSTYPE", "darwin23"}};
    copy_commands("staff");
    EXPECT_EQ(script({"grade", "x"}).err, "relief: 'grade' is a command for staff only: it needs Linux\n");
    EXPECT_EQ(script({"test"}).err, "relief: the tests need Linux: ./relief check LAB looks at your work\n");
    stand_in("brew", "");
    EXPECT_EQ(script({"build"}).code, 0);
    EXPECT_TRUE(contains(calls(), " course\n"));
}

TEST_F(OtherSystem, EachListHasOnePurposeAndOnePackageALineForAllThatAUserNeeds) {
    const std::map<std::string, std::set<std::string>> purposes_of = {
        {"fedora", {"build", "pictures", "slides", "staff", "test"}},
        {"arch", {"build", "pictures", "slides", "staff", "test"}},
        {"opensuse", {"build", "pictures", "slides", "staff", "test"}},
        {"brew", {"build", "pictures"}},
        {"msys2", {"build"}}};
    for (const auto& [system, all] : purposes_of) {
        std::istringstream lines(read_all(folder_.path() / "framework/cmake" / ("packages_" + system + ".txt")));
        std::set<std::string> purposes, packages;
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("#")) continue;
            std::smatch parts;
            ASSERT_TRUE(std::regex_match(line, parts, std::regex("([a-z]+) ([A-Za-z0-9_+@.-]+)")))
                << system << ": " << line;
            purposes.insert(parts[1]);
            EXPECT_TRUE(packages.insert(parts[2]).second) << system << ": " << line;
        }
        EXPECT_EQ(purposes, all) << system;
    }
}

// Most of the packages and half of the build are for the staff, or for rare files.
TEST_F(Script, InstallsAndBuildsWhatTheCommandNeeds) {
    installed("libglm-dev|libopenimageio-dev|libseccomp-dev|libgtest-dev");
    const auto packages_and_targets = [&](const std::vector<std::string>& arguments) {
        std::filesystem::remove_all(folder_.path() / "build");
        script(arguments);
        const std::string called = calls();
        std::string found;
        for (const char* name : {"libglm", "libopenimageio", "libseccomp", "libgtest"})
            if (contains(called, std::string(" ") + name + "-dev")) found += std::string(name) + " ";
        const std::string build = (folder_.path() / "build").string();
        const size_t begin = called.find("ninja -C " + build) + 10 + build.size();
        return found + called.substr(begin, called.find('\n', begin) - begin);
    };
    copy_commands("staff");
    EXPECT_EQ(packages_and_targets({"shot", "01", "--set", "map=a.png"}), "libglm course");
    EXPECT_EQ(packages_and_targets({}), "libglm relief relief_converted_textures") << "there is no display";
    EXPECT_EQ(packages_and_targets({"inspect", "a photo.JPG"}), "libglm libopenimageio course");
    EXPECT_EQ(packages_and_targets({"shot", "06", "--set", "shape=a model.glb"}), "libglm libopenimageio course");
    EXPECT_EQ(packages_and_targets({"grade", "x"}), "libglm libopenimageio libseccomp programs");
    EXPECT_EQ(packages_and_targets({"explain", "01", "--mistake=x"}), "libglm libopenimageio libseccomp programs");
    EXPECT_EQ(packages_and_targets({"build"}), "libglm libopenimageio libseccomp programs");
    EXPECT_EQ(packages_and_targets({"test"}), "libglm libopenimageio libseccomp libgtest tests_of_every_day");
    std::filesystem::remove_all(folder_.path() / "framework/staff");
    EXPECT_EQ(packages_and_targets({"build"}), "libglm libopenimageio course") << "a students' course";
}

TEST_F(Script, KeepsTheStaffsLibraryUpToDateOnceItIsBuilt) {
    folder_.write("build/bin/librelief-staff.so", "");
    script({"list"});
    EXPECT_TRUE(contains(calls(), " programs\n"));
}

TEST_F(Script, UsesSudoWhereItWorksWithoutAQuestion) {
    installed("libglm-dev");
    stand_in("id", "echo 1000");
    stand_in("sudo", "[[ $1 == -n ]] && exit 0; exec \"$@\"");
    EXPECT_EQ(script().code, 0);
    EXPECT_TRUE(contains(calls(), "sudo env DEBIAN_FRONTEND=noninteractive apt-get install"));
}

TEST_F(Script, AFailedBuildShowsTheFirstCompilerErrorAndWhereTheOthersAre) {
    const std::string task_file = (folder_.path() / "labs/05_x/task.cpp").string();
    folder_.write("messages.txt", "[1/3] Building CXX object task.o\nFAILED: task.o\n/usr/bin/c++ -c " + task_file +
                                      "\n" + task_file + ":1:1: warning: w\n" + task_file +
                                      ": In function 'int f()':\n" + task_file +
                                      ":3:5: error: no\n    3 | x\n      | ^\n" + task_file +
                                      ":9:1: note: candidate: 'int g()'\n    9 | int g();\n" + task_file +
                                      ":2:1: note: it is declared here\n" + "../labs/a.h:1:1: error: b\n    1 | b\n" +
                                      task_file + ":7:1: error: c\nninja: build stopped: subcommand failed.\n");
    stand_in("ninja", "cat '" + (folder_.path() / "messages.txt").string() + "'; exit 1");
    const Result result = script({"check", "5"});
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(contains(result.err,
                         "\nlabs/05_x/task.cpp: In function 'int f()':\nlabs/05_x/task.cpp:3:5: error: no\n    3 | x\n"
                         "      | ^\nlabs/05_x/task.cpp:2:1: note: it is declared here\n"
                         "relief: and 2 more errors, which may follow from the first: see build/errors.txt\n"
                         "relief: failed: building\n"))
        << result.err;
    for (const char* no : {"c++ -c", "FAILED", "stopped", "candidate", "warning"})
        EXPECT_FALSE(contains(result.err, no)) << result.err;
    const std::string all = read_all(folder_.path() / "build/errors.txt");
    EXPECT_TRUE(contains(all, "labs/a.h:1:1: error: b") && contains(all, "candidate")) << all;
    stand_in("ninja", "echo 'lab.cpp:3: error: no'; exit 1");
    EXPECT_TRUE(contains(script({"list"}).err, "lab.cpp:3: error: no\nrelief: failed: building\n")) << "a single error";
}

TEST_F(Script, ABuildShowsTheWarningsAboutAStudentsFileOnce) {
    const std::string task_file = (folder_.path() / "labs/05_x/task.cpp").string();
    const std::string warning = ":9:1: warning: no return statement [-Wreturn-type]\n    9 | }\n      | ^\n";
    const std::string step = "] Building CXX object task.o\n" + task_file + ": In function 'int f()':\n" + task_file;
    folder_.write("messages.txt",
                  "[1/3" + step + warning + "[2/3" + step + warning + "../framework/a.h:1:1: warning: w\n");
    stand_in("ninja", "cat '" + (folder_.path() / "messages.txt").string() + "'");
    const Result result = script({"check", "5"});
    const std::string shown = "labs/05_x/task.cpp" + warning;
    EXPECT_TRUE(contains(result.err, shown) && result.err.find(shown) == result.err.rfind(shown)) << result.err;
    EXPECT_FALSE(contains(result.err, "a.h:1:1") || contains(result.err, "Building")) << result.err;
}

TEST_F(Script, AFailedBuildNamesATaskThatNoCompilerReads) {
    const std::string file = "labs/05_x/task.cpp";
    stand_in("ninja", "echo '" + (folder_.path() / file).string() + ":1:1: error: stray character'; exit 1");
    folder_.write(file, std::string_view("\xff\xfe/\0/\0", 6));
    EXPECT_TRUE(contains(script({"check", "5"}).err, file + ": this is text in UTF-16: save it as UTF-8"));
    folder_.write(file, "// a\rint f();\r");
    EXPECT_TRUE(contains(script({"check", "5"}).err, file + ": its lines end in CR alone"));
    folder_.write(file, "// a\r\nint f();\r\n");
    EXPECT_FALSE(contains(script({"check", "5"}).err, "CR alone"));
}

TEST_F(Script, FailedTestsAreAFailure) {
    stand_in("ctest", "exit 8");
    EXPECT_EQ(script({"test", "-R", "cpu"}).code, 8);
    const std::string called = calls();
    EXPECT_TRUE(contains(called, "-R cpu\n")) << called;
    EXPECT_TRUE(contains(called, "--no-tests=error")) << called;
}

}  // namespace
}  // namespace relief::app
