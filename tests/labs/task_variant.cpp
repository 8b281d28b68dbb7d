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
                                        const Expectations& expected) {
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
    for (const auto& [name, text] : files)  // each file is a translation unit
        if (name.ends_with(".cpp")) command.push_back((course.root() / name).string());
    for (const fs::path& object : grade::built_objects(lab, files)) command.push_back(object);
    const fs::path program = course.root() / "bin" / ("lab-" + lab.two_digits());
    const fs::path main =
        build / "CMakeFiles" / ("lab-" + lab.two_digits() + ".dir") / "framework/course/app/main.cpp.o";
    for (const std::string& word :
         {main.string(), "-L" + (build / "bin").string(), std::string("-lrelief"),
          "-Wl,-rpath," + (build / "bin").string(), std::string("-lfmt"), std::string("-o"), program.string()})
        command.push_back(word);
    const Result compiled = run(command);
    EXPECT_EQ(compiled.code, 0) << compiled.err;
    if (compiled.code != 0) return {};
    const Result checked = run({program.string(), "check", "--json"});
    std::vector<VariantCheck> results;
    try {
        const nlohmann::json report = nlohmann::json::parse(checked.out);
        for (const auto& one : report.at("tasks"))
            for (const auto& check : one["checks"])
                results.push_back({one["id"], check["name"], check["outcome"], check["found"], one["mistake"]});
    } catch (const nlohmann::json::exception& error) {
        ADD_FAILURE() << error.what() << "\n" << checked.out << checked.err;
    }
    return results;
}

}  // namespace relief
