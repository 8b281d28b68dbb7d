#include "tests/labs/task_variant.h"

#include <nlohmann/json.hpp>

#include "tests/process.h"
#include "tests/support.h"

namespace relief {

namespace fs = std::filesystem;

std::vector<VariantCheck> check_with_task(const LabEntry& lab, const std::string& task, const CourseFiles& files) {
    const fs::path build = RELIEF_BUILD_FOLDER, source = RELIEF_SOURCE_FOLDER;
    const TemporaryFolder folder;
    const fs::path objects = build / "CMakeFiles" / ("lab_objects_" + lab.two_digits() + ".dir") / "labs" / lab.folder;
    std::vector<std::string> command = {RELIEF_COMPILER, "-std=c++20", "-O1", "-I" + source.string(),
                                        "-I" + (source / "labs" / lab.folder).string()};
#ifdef RELIEF_SANITIZED
    command.push_back("-fsanitize=address,undefined");
#endif
    for (const auto& [name, text] : files)
        command.push_back(folder.write(fs::path(name).filename().string(), text).string());
    for (const auto& entry : fs::directory_iterator(objects)) {
        const std::string object = entry.path().filename();  // "task.cpp.o"
        const bool replaced = files.contains("labs/" + lab.folder + "/" + entry.path().stem().string());
        if (object.ends_with(".o") && !replaced) command.push_back(entry.path());
    }
    // The executable stands where it finds its libraries, its modules and the course.
    const fs::path program = build / "bin" / ("lab-" + lab.two_digits() + "-variant");
    for (const std::string& word :
         {(source / "framework/app/main.cpp").string(), "-L" + (build / "bin").string(), std::string("-lrelief"),
          "-Wl,-rpath," + (build / "bin").string(), std::string("-lfmt"), std::string("-o"), program.string()})
        command.push_back(word);
    const Result compiled = run(command);
    EXPECT_EQ(compiled.code, 0) << compiled.err;
    if (compiled.code != 0) return {};
    const Result checked = run({program.string(), "check", "--json"});
    fs::remove(program);
    std::vector<VariantCheck> results;
    try {
        for (const auto& one : nlohmann::json::parse(checked.out)["tasks"])
            if (one["id"] == task)
                for (const auto& check : one["checks"])
                    results.push_back({check["name"], check["outcome"], check["found"]});
    } catch (const nlohmann::json::exception& error) {
        ADD_FAILURE() << error.what() << "\n" << checked.out << checked.err;
    }
    return results;
}

}  // namespace relief
