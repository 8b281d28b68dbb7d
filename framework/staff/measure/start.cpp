// The time from the start of the process to one picture: lab 01 as PNG and as PPM, compared with the minimum for both
// (tests/start/floor.cpp). The work of a shot is the time of each of its phases.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/process.h"
#include "framework/core/base/text.h"
#include "framework/core/image/asset.h"
#include "framework/core/image/file.h"
#include "framework/staff/grade/stage.h"
#include "framework/staff/measure/bench.h"

namespace relief::measure {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Environment = std::map<std::string, std::string>;

constexpr const char* texture = "bricks_albedo.png";

/// Keeps the user's folders, where the renderer caches compiled shaders. Without the cache, each run is like the first.
Environment environment(bool with_cache) {
    Environment result = {{"LC_ALL", "C.UTF-8"}};
    for (const char* name : {"HOME", "XDG_CACHE_HOME"})
        if (const char* const value = std::getenv(name)) result[name] = value;
    if (!with_cache) result["MESA_SHADER_CACHE_DISABLE"] = "true";
    return result;
}

ProcessResult run(const Words& command, bool with_cache = true) {
    ProcessResult done = run_process({.command = command,
                                      .environment = environment(with_cache),
                                      .limits = {.wall = 60, .cpu = 60, .memory = size_t{8} << 30}});
    if (done.succeeded()) return done;
    // The reason, without the events of --verbose before it.
    std::string reason;
    for (const std::string& line : split(done.errors, '\n'))
        if (!line.empty() && !line.starts_with('[')) reason += (reason.empty() ? "" : "; ") + line;
    throw Error(fmt::format("{} fails: {}", command[0], reason.empty() ? "it does not say why" : reason));
}

Words shot(const fs::path& output) {
    return {executable_path().string(), "shot", "01", "--size", "512x512", "-o", output.string()};
}

constexpr std::array phases = {"linking_ms", "manifest_ms",     "context_ms", "textures_ms", "programs_ms",
                               "drawing_ms", "reading_back_ms", "writing_ms", "ending_ms"};
using Milliseconds = std::array<double, phases.size()>;

/// Parses the output of --verbose: "[  12.3 ms] drawn", "[  9.1 ms] texture: assets/x.png, 64x64, 1.2 ms".
Milliseconds phases_of(Words command, bool with_cache) {
    command.emplace_back("--verbose");
    const ProcessResult done = run(command, with_cache);
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

/// Returns the median time of each phase of a command, in milliseconds.
BenchWork parts_of(const Words& command, bool with_cache, int repeats) {
    std::array<std::vector<double>, phases.size()> samples;
    phases_of(command, with_cache);  // warm-up
    for (int repeat = 0; repeat < std::max(1, repeats); ++repeat) {
        const Milliseconds took = phases_of(command, with_cache);
        for (size_t p = 0; p < phases.size(); ++p) samples[p].push_back(took[p]);
    }
    BenchWork parts;
    for (size_t p = 0; p < phases.size(); ++p) parts.emplace_back(phases[p], quantile(samples[p], 0.5));
    return parts;
}

std::vector<BenchScene> start_scenes(const BenchSettings& settings) {
    const auto folder = std::make_shared<grade::PublicFolder>(fs::temp_directory_path(), "relief-bench");
    std::vector<BenchScene> result;
    for (const std::string kind : {"png", "ppm"}) {
        BenchScene& scene = result.emplace_back();
        scene.knobs = {{"file", kind}};
        scene.item = "picture";
        const fs::path floor = executable_folder() / ("floor-" + kind);
        const auto at_least = [=](const std::string& samples) {
            fs::path from = course_root() / "assets" / texture;
            if (kind == "ppm") write_image(from = folder->path() / "texture.ppm", read_asset(texture));
            const Words command = {floor.string(), from.string(), (folder->path() / ("floor." + kind)).string(),
                                   samples};
            return BenchSubject{.run = [folder, command] { run(command); }, .is_parallel = true};
        };
        if (fs::exists(floor))
            for (const std::string samples : {"1", "4"})  // a shot has four
                scene.methods.push_back(
                    {"floor", {{"shaders", "cached"}, {"samples", samples}}, [=] { return at_least(samples); }, true});
        else
            print_note(fmt::format("there is no {}: it is built with the tests", floor.string()));
        for (const bool with_cache : {true, false}) {
            if (!with_cache && settings.quick) continue;
            const auto prepare = [=, repeats = settings.repeats] {
                const Words command = shot(folder->path() / ("shot." + kind));
                return BenchSubject{.work = parts_of(command, with_cache, repeats),
                                    .run = [folder, command, with_cache] { run(command, with_cache); },
                                    .is_parallel = true};
            };
            scene.methods.push_back({"shot", {{"shaders", with_cache ? "cached" : "compiled"}}, prepare});
        }
    }
    return result;
}

}  // namespace

const TopicRegistration start_topic(
    {"start", "one picture at 512 x 512 from the start of the process, compared with one hand-written quad",
     "How long does the first picture take?", start_scenes, false, true});

}  // namespace relief::measure
