#include "tests/labs/task_variant.h"

#include <nlohmann/json.hpp>

#include "framework/core/image/file.h"
#include "framework/course/check/check.h"
#include "framework/staff/grade/stage.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief {

namespace fs = std::filesystem;

std::vector<VariantCheck> check_variant(const LabEntry& lab, const grade::CourseFiles& files,
                                        const Expectations& expected, VariantProgram kind) {
    const bool finds_faults = kind == VariantProgram::finds_faults;
    const fs::path build = build_folder, source = source_folder;
    // A separate course folder for the executable. It contains the pictures of the solution, as a handout does.
    const grade::CourseOverlay course(files);
    fs::create_directories(course.root() / "bin");
    for (const CheckInfo& check : load_manifest(lab).checks) {
        const auto image = expected.find(check.name);
        if (image == expected.end() || !image->second) continue;
        const fs::path file = check::expectation_file(lab, check);
        fs::create_directories(file.parent_path());
        write_image(file, *image->second);
    }
    std::vector<std::string> command = {RELIEF_COMPILER, "-std=c++20", "-O1", "-I" + source.string(),
                                        "-I" + (source / "labs" / lab.folder).string()};
#ifdef RELIEF_SANITIZED
    command.push_back("-fsanitize=address,undefined");
#endif
    const std::string name = (finds_faults ? "check-" : "lab-") + lab.two_digits();
    const fs::path objects = build / "CMakeFiles" / (name + ".dir") / "framework/course/app";
    if (finds_faults) {
        // As framework/cmake/add_lab.cmake compiles a task.
        for (const char* option : {"-g1", "-D_GLIBCXX_ASSERTIONS", "-fsanitize=address,undefined",
                                   "-fsanitize-recover=all", "-fno-omit-frame-pointer"})
            command.push_back(option);
        command.push_back((objects / "sanitizers.cpp.o").string());
    }
    for (const auto& [file, text] : files)  // each file is a translation unit
        if (file.ends_with(".cpp")) command.push_back((course.root() / file).string());
    for (const fs::path& object : grade::built_objects(lab, files)) command.push_back(object);
    const fs::path program = course.root() / "bin" / name;
    const fs::path main = objects / "main.cpp.o";
    for (const std::string& word :
         {main.string(), "-L" + (build / "bin").string(), std::string("-lrelief"),
          "-Wl,-rpath," + (build / "bin").string(), std::string("-lfmt"), std::string("-o"), program.string()})
        command.push_back(word);
    const Result compiled = run(command);
    EXPECT_EQ(compiled.code, 0) << compiled.err;
    if (compiled.code != 0) return {};
    const Result checked = run({program.string(), "check", lab.folder, "--json"});
    std::vector<VariantCheck> results;
    try {
        const nlohmann::json report = nlohmann::json::parse(checked.out);
        for (const auto& one : report.at("tasks"))
            for (const auto& check : one["checks"])
                results.push_back(
                    {one["id"], check["name"], check["outcome"], check["found"], one["hint"], check["look_at"]});
    } catch (const nlohmann::json::exception& error) {
        ADD_FAILURE() << error.what() << "\n" << checked.out << checked.err;
    }
    return results;
}

}  // namespace relief
