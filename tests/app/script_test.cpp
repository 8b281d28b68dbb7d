// The script `relief`, with stand-ins for the tools that it calls: each writes down how it was called.
#include "tests/app/course_copy.h"

namespace relief {
namespace {

class Script : public testing::Test {
protected:
    TemporaryFolder folder_;

    void SetUp() override {
        namespace fs = std::filesystem;
        const fs::path source = RELIEF_SOURCE_FOLDER;
        fs::create_directories(folder_.path() / "framework/cmake");
        fs::copy(source / "relief", folder_.path());
        fs::copy(source / "framework/cmake/packages.txt", folder_.path() / "framework/cmake");
        stand_in("cmake",
                 "mkdir -p build && touch build/build.ninja && "
                 "printf 'RELIEF_TESTS:BOOL=ON\\nCMAKE_HOME_DIRECTORY:INTERNAL=%s\\n' \"$PWD\" >build/CMakeCache.txt");
        stand_in("ninja",
                 "mkdir -p build/bin && printf '#!/bin/bash\\necho \"ran: $*\"\\n' >build/bin/relief && chmod +x "
                 "build/bin/relief");
        stand_in("ctest", "true");
        stand_in("apt-get", "true");
        stand_in("sudo", "exit 1");
        stand_in("id", "echo 0");
        installed("");
    }
    /// A tool that notes its arguments in `calls`, then does as told.
    void stand_in(const std::string& name, const std::string& body) const {
        const auto file = folder_.write("tools/" + name, "#!/bin/bash\ncd '" + folder_.path().string() + "'\necho \"" +
                                                             name + " $*\" >>calls\n" + body + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }
    /// All packages are there but these (a pattern for grep).
    void installed(const std::string& but) const {
        stand_in("dpkg-query",
                 "awk '!/^#/ { print \"installed \" $2 }' framework/cmake/packages.txt | grep -vxE 'installed (" + but +
                     ")'");
    }
    Result script(std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.begin(), {"bash", folder_.path() / "relief"});
        return run(arguments, {"/", {{"PATH", (folder_.path() / "tools").string() + ":/usr/bin:/bin"}, {"CI", ""}}});
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
    EXPECT_EQ(result.err, "") << "quiet where there is no terminal";
    const std::string called = calls();
    EXPECT_TRUE(contains(called, "cmake -S")) << called;
    EXPECT_TRUE(contains(called, "-DCMAKE_BUILD_TYPE=Release")) << called;
    EXPECT_FALSE(contains(called, "apt-get")) << called;
}

TEST_F(Script, TheSecondTimeAsksNoPackageAndConfiguresNothing) {
    script();
    calls();
    EXPECT_EQ(script().code, 0);
    const std::string called = calls();
    for (const char* tool : {"dpkg-query", "apt-get", "cmake"}) EXPECT_FALSE(contains(called, tool)) << called;
}

TEST_F(Script, AMovedCourseIsBuiltAnew) {
    script();
    calls();
    folder_.write("build/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/somewhere/else\n");
    const Result result = script();
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "relief: this folder was moved or copied: building anew\n");
    EXPECT_TRUE(contains(calls(), "cmake -S"));
}

TEST_F(Script, RootInstallsWhatIsMissingAndNoMore) {
    installed("libglm-dev|xvfb");
    EXPECT_EQ(script({"list"}).code, 0);
    std::string called = calls();
    EXPECT_TRUE(contains(called, "apt-get update\n")) << called;
    EXPECT_TRUE(contains(called, "apt-get install -y --no-install-recommends libglm-dev\n")) << called;
    EXPECT_EQ(script({"test"}).code, 0);
    called = calls();
    EXPECT_TRUE(contains(called, "--no-install-recommends libglm-dev xvfb\n")) << "a test wants Xvfb, too: " << called;
}

TEST_F(Script, WithoutRootOrSudoItPrintsTheLineToRunAndStops) {
    installed("libglm-dev");
    stand_in("id", "echo 1000");
    const Result result = script();
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err,
              "relief: packages are missing; as root, run: apt-get install --no-install-recommends libglm-dev\n");
    EXPECT_FALSE(contains(calls(), "cmake"));
}

TEST_F(Script, UsesSudoWhereItWorksWithoutAQuestion) {
    installed("libglm-dev");
    stand_in("id", "echo 1000");
    stand_in("sudo", "[[ $1 == -n ]] && exit 0; exec \"$@\"");
    EXPECT_EQ(script().code, 0);
    EXPECT_TRUE(contains(calls(), "sudo env DEBIAN_FRONTEND=noninteractive apt-get install"));
}

TEST_F(Script, AFailedStepShowsItsLogAndStops) {
    stand_in("ninja", "echo 'lab.cpp:3: error: no'; exit 1");
    const Result result = script({"list"});
    EXPECT_EQ(result.code, 1);
    EXPECT_TRUE(contains(result.err, "lab.cpp:3: error: no\nrelief: failed: building\n")) << result.err;
    EXPECT_EQ(result.out, "");
}

TEST_F(Script, FailedTestsAreAFailure) {
    stand_in("ctest", "exit 8");
    EXPECT_EQ(script({"test", "-R", "cpu"}).code, 8);
    const std::string called = calls();
    EXPECT_TRUE(contains(called, "-R cpu\n")) << called;
    EXPECT_TRUE(contains(called, "--no-tests=error")) << called;
}

}  // namespace
}  // namespace relief
