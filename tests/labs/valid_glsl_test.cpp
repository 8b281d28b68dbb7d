// glslang, the reference compiler of Khronos, against every stage that the labs compile. Mesa accepts more than GLSL
// 4.10, and a strict driver does not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/program.h"
#include "framework/course/check/kept_lab.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/starter.h"
#include "framework/staff/grade/overlay.h"
#include "tests/process.h"
#include "tests/support.h"

namespace relief {
namespace {

/// Texts of stages, each once, with the stage that each comes from.
using Stages = std::map<std::string, std::filesystem::path>;

/// Returns the stages that the lab's first picture and the views of its checks compile, with all their inclusions and
/// definitions.
Stages stages_of(const LabEntry& lab, const Manifest& manifest) {
    Stages stages;
    const ShaderRewriting rewriting([&](std::vector<ShaderSource>& sources, GLuint) {
        for (const ShaderSource& source : sources) stages.emplace(source.text, source.stage);
    });
    std::vector<Shot> shots(1);
    shots[0].camera = manifest.camera;
    for (const CheckInfo& check : manifest.checks)
        if (!check.shot.calls || is_shader(check.shot.calls.file)) shots.push_back(check.shot);
    check::KeptLab kept(lab);
    for (Shot& shot : shots) {
        if (!shot.calls) shot.size = {64, 48};
        draw_shot(kept.drawer_of(shot), shot);
    }
    return stages;
}

/// Returns what glslang says against the stages, empty if they are valid. One process reads all files.
std::string said_by_glslang(const Stages& stages) {
    const TemporaryFolder folder;
    std::vector<std::string> command = {"glslangValidator"};
    for (const auto& [text, stage] : stages)
        command.push_back(folder.write(fmt::format("{}_{}", command.size(), stage.filename().string()), text).string());
    const Result result = run(command);
    if (result.code == 0) return "";
    std::string said = fmt::format("exit code {}: {}\n", result.code, result.err);
    for (const std::string& line : split(result.out, '\n'))
        if (line.find("ERROR") != std::string::npos || line.find("WARNING") != std::string::npos) said += line + '\n';
    return said;
}

class ValidGlsl : public testing::TestWithParam<LabEntry> {
protected:
    Manifest manifest_ = load_manifest(GetParam());
};

TEST_P(ValidGlsl, HasEveryStageOfEveryCheck) {
    const Stages stages = stages_of(GetParam(), manifest_);
    EXPECT_GT(stages.size(), 1u);
    EXPECT_EQ(said_by_glslang(stages), "");
}

TEST_P(ValidGlsl, HasEveryStageOfTheStarters) {
    grade::CourseFiles starters;
    for (const TaskInfo& task : manifest_.tasks)
        if (is_shader(task.file))
            starters[task.file] = check::starter_of(read_file(course_root() / task.file), task.file);
    if (starters.empty()) GTEST_SKIP() << "has no tasks in shaders";
    const grade::CourseOverlay overlay(starters);
    EXPECT_EQ(said_by_glslang(stages_of(GetParam(), manifest_)), "");
}

INSTANTIATE_TEST_SUITE_P(Labs, ValidGlsl, testing::ValuesIn(registry()),
                         [](const auto& entry) { return "_" + entry.param.folder; });

}  // namespace
}  // namespace relief
