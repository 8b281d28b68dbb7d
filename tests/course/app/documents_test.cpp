// The documents state the numbers of labs and tasks that the manifests have.
#include <algorithm>
#include <regex>

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/course/manifest/manifest.h"
#include "tests/support.h"

namespace relief::app {
namespace {

namespace fs = std::filesystem;

/// Numbers of labs and tasks. `cpp_labs` are the labs with a task in C++, such as "02, 05 and 08".
struct Counts {
    int labs = 0, tasks = 0, glsl = 0, cpp = 0;
    std::string cpp_labs;
};

Counts counts_of_manifests() {
    Counts counts;
    std::vector<std::string> cpp_labs;
    for (const auto& folder : fs::directory_iterator(fs::path(source_folder) / "labs")) {
        const fs::path file = folder.path() / "lab.toml";
        if (!fs::exists(file)) continue;
        ++counts.labs;
        const int before = counts.cpp;
        for (const TaskInfo& task : load_manifest(file).tasks)
            ++counts.tasks, ++(is_shader(task.file) ? counts.glsl : counts.cpp);
        if (counts.cpp > before) cpp_labs.push_back(folder.path().filename().string().substr(0, 2));
    }
    std::sort(cpp_labs.begin(), cpp_labs.end());
    for (size_t i = 0; i < cpp_labs.size(); ++i)
        counts.cpp_labs += (i == 0 ? "" : i + 1 == cpp_labs.size() ? " and " : ", ") + cpp_labs[i];
    return counts;
}

/// Returns the faults of a text: each count of labs or tasks that differs, with the words around it.
std::vector<std::string> wrong_counts(const std::string& text, const Counts& counts) {
    static const std::regex count("\\b([0-9]+)\\s(labs|tasks)\\b(\\sin\\s(GLSL|C\\+\\+))?");
    std::vector<std::string> faults;
    for (std::sregex_iterator at(text.begin(), text.end(), count), end; at != end; ++at) {
        const std::string language = (*at)[4];
        const int right = (*at)[2] == "labs"   ? counts.labs
                          : language.empty()   ? counts.tasks
                          : language[0] == 'G' ? counts.glsl
                                               : counts.cpp;
        if ((*at)[1] != std::to_string(right)) faults.push_back(at->str() + ", not " + std::to_string(right));
    }
    return faults;
}

TEST(Documents, StateTheNumbersOfLabsAndTasksThatTheManifestsHave) {
    const Counts counts = counts_of_manifests();
    ASSERT_GT(counts.cpp, 0);
    for (const char* file : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md", "labs/README.md", "labs/staff/README.md",
                             "labs/staff/ADDING.md", "framework/staff/grade/README.md", "tests/README.md"})
        for (const std::string& fault : wrong_counts(read_file(fs::path(source_folder) / file), counts))
            ADD_FAILURE() << file << ": " << fault;
    const std::string guide = read_file(fs::path(source_folder) / "labs/staff/README.md");
    EXPECT_NE(guide.find("Labs " + counts.cpp_labs + " have tasks in C++."), guide.npos) << counts.cpp_labs;
}

TEST(Documents, AWrongCountIsFound) {
    const Counts counts{.labs = 19, .tasks = 96, .glsl = 87, .cpp = 9, .cpp_labs = ""};
    EXPECT_TRUE(
        wrong_counts("19 labs, 96 tasks: the 87 tasks in GLSL, the 9 tasks\nin C++; one of two tasks", counts).empty());
    const std::vector<std::string> faults = wrong_counts("18 labs, 88 tasks, 79 tasks\nin GLSL", counts);
    EXPECT_EQ(faults, (std::vector<std::string>{"18 labs, not 19", "88 tasks, not 96", "79 tasks\nin GLSL, not 87"}));
}

}  // namespace
}  // namespace relief::app
