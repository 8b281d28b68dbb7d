// What a picture costs from an empty process on: lab 01 as PNG and as PPM, against the least that a picture costs in
// either (tests/start/floor.cpp), and where the milliseconds of a shot go.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "framework/base/file.h"
#include "framework/base/log.h"
#include "framework/base/paths.h"
#include "framework/base/text.h"
#include "framework/grade/sandbox.h"
#include "framework/grade/stage.h"
#include "framework/image/asset.h"
#include "framework/image/file.h"
#include "framework/measure/topics.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Environment = std::map<std::string, std::string>;

constexpr const char* texture = "bricks_albedo.png";

/// The renderer's cache of compiled shaders lies where the user's does. Without it each run is a first one.
Environment environment(bool with_cache) {
    Environment result = {{"LC_ALL", "C.UTF-8"}};
    for (const char* name : {"HOME", "XDG_CACHE_HOME"})
        if (const char* const value = std::getenv(name)) result[name] = value;
    if (!with_cache) result["MESA_SHADER_CACHE_DISABLE"] = "true";
    return result;
}

SandboxResult run(const Words& command, bool with_cache = true) {
    SandboxResult done = run_trusted({.command = command,
                                      .readable = {},
                                      .environment = environment(with_cache),
                                      .input = {},
                                      .limits = {.wall = 60, .cpu = 60, .memory = size_t{8} << 30}});
    if (done.ending != Ending::exited || done.code != 0)
        throw Error(fmt::format("{} fails: {}", command[0], done.errors));
    return done;
}

Words shot(const fs::path& output) {
    return {executable_path().string(), "shot", "01", "--size", "512x512", "-o", output.string()};
}

constexpr std::array phases = {"linking, options", "manifest",  "context", "textures", "programs",
                               "drawing",          "read back", "writing", "ending"};
using Milliseconds = std::array<double, phases.size()>;

/// From what --verbose says: "[  12.3 ms] drawn", "[  9.1 ms] texture: assets/x.png, 64x64, 1.2 ms".
Milliseconds phases_of(Words command, bool with_cache) {
    command.emplace_back("--verbose");
    const SandboxResult done = run(command, with_cache);
    std::map<std::string, double> at, inside;
    for (const std::string& line : split(done.errors, '\n')) {
        const size_t end = line.find(" ms] ");
        if (!line.starts_with("[") || end == std::string::npos) continue;
        const std::string what = line.substr(end + 5), event = what.substr(0, what.find(':'));
        const auto number = [](std::string text) { return parse_number(text.erase(0, text.find_first_not_of(' '))); };
        at[event] = number(line.substr(1, end - 1)).value_or(0);
        if (what.ends_with(" ms"))
            inside[event] += number(what.substr(what.rfind(',') + 1, what.size() - what.rfind(',') - 4)).value_or(0);
    }
    for (const char* event : {"started", "lab", "context", "drawn", "read back", "written"})
        if (!at.contains(event)) throw Error(fmt::format("relief shot --verbose does not say '{}'", event));
    const double textures = inside["texture"], programs = inside["program"];
    return {at["started"],
            at["lab"] - at["started"],
            at["context"] - at["lab"],
            textures,
            programs,
            at["drawn"] - at["context"] - textures - programs,
            at["read back"] - at["drawn"],
            at["written"] - at["read back"],
            1e3 * done.wall - at["written"]};
}

void print_phases(const fs::path& folder, const BenchSettings& settings) {
    struct Kind {
        const char *name, *file;
        bool with_cache;
        std::array<std::vector<double>, phases.size()> samples = {};
    };
    std::vector<Kind> shots = {{"PPM", "a.ppm", true}, {"PNG", "a.png", true}};
    if (!settings.quick) shots.push_back({"PPM, cold", "a.ppm", false});
    for (int repeat = settings.quick ? 0 : -1; repeat < settings.repeats; ++repeat)  // -1: to warm up
        for (Kind& kind : shots) {
            const Milliseconds took = phases_of(shot(folder / kind.file), kind.with_cache);
            for (size_t p = 0; p < phases.size() && repeat >= 0; ++p) kind.samples[p].push_back(took[p]);
        }
    fmt::print(
        "a shot of lab 01 at 512 x 512, phase by phase, ms (cold: without the renderer's cache of shaders)\n{:<18}",
        "phase");
    for (const Kind& kind : shots) fmt::print("{:>10}", kind.name);
    for (size_t p = 0; p < phases.size(); ++p) {
        fmt::print("\n{:<18}", phases[p]);
        for (const Kind& kind : shots) fmt::print("{:>10.1f}", quantile(kind.samples[p], 0.5));
    }
    fmt::print("\n\n");
}

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    const auto folder = std::make_shared<PublicFolder>(fs::temp_directory_path(), "relief-bench");
    std::vector<BenchMethod> result;
    const auto add = [&](const std::string& name, const std::string& kind, const Words& command, bool with_cache) {
        BenchMethod& method = result.emplace_back();
        method.name = name, method.item = "picture";
        method.knobs = {{"file", kind}, {"shaders", with_cache ? "cached" : "compiled"}};
        method.run = [folder, command, with_cache] { run(command, with_cache); };
    };
    write_image(folder->path() / "texture.ppm", read_asset(texture));
    for (const std::string kind : {"png", "ppm"}) {
        const fs::path floor = executable_folder() / ("floor-" + kind), from = course_root() / "assets" / texture;
        const fs::path out = folder->path() / ("floor." + kind);
        if (fs::exists(floor))
            add("floor", kind,
                {floor.string(), kind == "png" ? from.string() : (folder->path() / "texture.ppm").string(),
                 out.string()},
                true);
        else
            print_note(fmt::format("there is no {}: it is built with the tests", floor.string()));
        for (const bool with_cache : {true, false})
            if (with_cache || !settings.quick)
                add("shot 01", kind, shot(folder->path() / ("shot." + kind)), with_cache);
    }
    print_phases(folder->path(), settings);
    return result;
}

}  // namespace

BenchTopic start_topic() {
    return {"start", "one picture at 512 x 512 from an empty process on, against one quad by hand", methods};
}

}  // namespace relief
