// The functions that a page calls. Each takes plain values and returns a JSON object, whose text stays valid until the
// next call:
//   value    the result, if there was no error
//   error    one line, and `details`, `file`, `line` if there are any
//   missing  the empty files that the call tried to read: the page fetches them, and repeats the call
#include <emscripten.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/folded_text.h"
#include "framework/core/base/missing_files.h"
#include "framework/core/base/own_file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/source_text.h"
#include "framework/core/base/text.h"
#include "framework/core/lab/knobs.h"
#include "framework/core/lab/shot.h"
#include "framework/course/check/check.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/task/stored_zip.h"
#include "framework/course/web/webgl.h"
#include "framework/library/maps/visualize.h"

namespace relief::web {
namespace {

using nlohmann::json;

/// The lab that the page shows.
struct OpenLab {
    const LabEntry& entry;
    Manifest manifest;
    std::unique_ptr<Lab> lab;
    check::LabChecker checker;
    /// The pictures of the checks that have run, by index.
    std::map<size_t, check::Verdict> results = {};

    explicit OpenLab(const LabEntry& from)
        : entry(from),
          manifest(check::manifest_to_check(from)),
          lab(from.make()),
          checker(from, manifest, {renderer_name(), move_vertices}) {}
};

std::unique_ptr<OpenLab>& opened() {
    static std::unique_ptr<OpenLab> lab;
    return lab;
}
OpenLab& lab() {
    if (!opened()) throw Error("no lab is open");
    return *opened();
}

/// Does the work, and returns its value or its error.
template <class Work>
const char* answer(const Work& work) {
    static std::string text;
    json result;
    missing_files().clear();
    try {
        result["value"] = work();
    } catch (const Error& error) {
        result["error"] = error.what();
        const FoldedText parts = unfolded_text(error.details());
        result["details"] = parts.shown, result["further"] = parts.folded;
        if (!error.place().file.empty())
            result["file"] = shown(error.place().file), result["line"] = error.place().line;
    } catch (const std::exception& error) {
        result["error"] = error.what();
    }
    for (const std::string& file : missing_files()) result["missing"].push_back(shown(file));
    text = result.dump(-1, ' ', false, json::error_handler_t::replace);
    return text.c_str();
}

/// Describes knobs as a page's controls.
class Controls final : public Knobs {
public:
    json all = json::array();

    void group(const char* heading) override { heading_ = heading; }
    void slider(const char* name, float& value, float low, float high, const KnobHelp& help) override {
        json& knob = add(name, "slider", help);
        knob["value"] = fmt::format("{}", value), knob["low"] = low, knob["high"] = high;
    }
    void steps(const char* name, int& value, int low, int high, const KnobHelp& help) override {
        json& knob = add(name, "steps", help);
        knob["value"] = std::to_string(value), knob["low"] = low, knob["high"] = high;
    }
    void toggle(const char* name, bool& value, const KnobHelp& help) override {
        add(name, "toggle", help)["value"] = value ? "on" : "off";
    }
    void choice(const char* name, int& value, std::span<const char* const> names, const KnobHelp& help) override {
        json& knob = add(name, "choice", help);
        knob["value"] = names[size_t(value)];
        for (const char* each : names) knob["names"].push_back(each);
    }

    void choice_or_file(const char* name, int& value, OwnFile& own, std::span<const char* const> names,
                        const KnobHelp& help) override {
        Knobs::choice_or_file(name, value, own, names, help);
        all.back()["takes"] = own.kind();
    }

private:
    json& add(const char* name, const char* kind, const KnobHelp& help) {
        all.push_back({{"name", name},
                       {"title", help.title_of(name)},
                       {"kind", kind},
                       {"help", help.sentence()},
                       {"unit", help.unit_after_number()},
                       {"group", heading_}});
        heading_.clear();
        return all.back();
    }
    std::string heading_;
};

json knobs_of(Lab& lab) {
    Controls controls;
    lab.knobs(controls);
    const std::vector<KnobText> knobs = describe_knobs(lab);
    for (json& each : controls.all) each["ignored"] = is_ignored(each["name"], knobs);
    return controls.all;
}

json camera_of(const Orbit& camera) {
    return {{"yaw", camera.yaw},
            {"pitch", camera.pitch},
            {"distance", camera.distance},
            {"target", {camera.target.x, camera.target.y, camera.target.z}},
            {"field_of_view", camera.field_of_view}};
}

Shot shot_of(const json& request) {
    Shot shot;
    shot.size = {request.at("width").get<int>(), request.at("height").get<int>()};
    shot.time = request.value("time", 0.0);
    const json& camera = request.at("camera");
    shot.camera = {.yaw = camera.at("yaw"),
                   .pitch = camera.at("pitch"),
                   .distance = camera.at("distance"),
                   .target = {camera.at("target").at(0), camera.at("target").at(1), camera.at("target").at(2)},
                   .field_of_view = camera.at("field_of_view")};
    shot.probe.name = request.value("probe", "");
    return shot;
}

/// Puts a picture of 3 channels in 8 bits into bytes with alpha, as a canvas takes them.
json bytes_of(const Image& picture) {
    static std::vector<uint8_t> bytes;
    bytes.clear();
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        for (size_t c = 0; c < 3; ++c)
            bytes.push_back(
                uint8_t(std::lround(255 * std::clamp(picture.values[i * size_t(picture.channels) + c], 0.0f, 1.0f))));
        bytes.push_back(255);
    }
    return {
        {"address", reinterpret_cast<uintptr_t>(bytes.data())}, {"width", picture.width}, {"height", picture.height}};
}

/// A picture on its way to the canvas. The page asks whether it is finished, because waiting for it would stop the
/// page.
struct Drawing {
    std::unique_ptr<Target> target = {};
    GLsync end = nullptr;  ///< signalled when the picture is finished; null: nothing was drawn since

    void begin(glm::ivec2 size) {
        if (end) glDeleteSync(end);
        end = nullptr;
        if (!target || target->size() != size) target = std::make_unique<Target>(TargetKind::picture, size);
    }
    void finish() {
        end = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glFlush();
    }
    bool is_finished() const {
        GLint state = GL_SIGNALED;
        if (end) glGetSynciv(end, GL_SYNC_STATUS, 1, nullptr, &state);
        return state == GL_SIGNALED;
    }
    void show() const {
        const glm::ivec2 size = target->size();
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target->resolve());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
};
Drawing& drawing() {
    static Drawing one;
    return one;
}

}  // namespace
}  // namespace relief::web

using namespace relief;
using namespace relief::web;

extern "C" {

/// Creates the context of a canvas, named by a CSS selector, and returns the renderer's name.
EMSCRIPTEN_KEEPALIVE const char* relief_start(const char* canvas) {
    return answer([&]() -> json {
        open_webgl(canvas);
        return renderer_name();
    });
}

/// Opens a lab by its number. Returns its title, knobs, camera, probes, tasks, and checks with their views.
EMSCRIPTEN_KEEPALIVE const char* relief_open(int number) {
    return answer([&]() -> json {
        opened().reset();
        opened() = std::make_unique<OpenLab>(find_lab(std::to_string(number)));
        const Manifest& manifest = lab().manifest;
        for (const TaskInfo& task : manifest.tasks)
            if (is_shader(task.file)) limit_loops([file = course_root() / task.file] { return read_source(file); });
        json probes = json::array(), tasks = json::array(), checks = json::array();
        for (const ProbeInfo& probe : manifest.probes) probes.push_back({{"name", probe.name}, {"unit", probe.unit}});
        for (const TaskInfo& task : manifest.tasks)
            tasks.push_back({{"id", task.id}, {"title", task.title}, {"file", task.file}, {"points", task.points}});
        for (const CheckInfo& check : manifest.checks)
            checks.push_back({{"name", check.name},
                              {"task", check.task},
                              {"camera", camera_of(check.shot.camera)},
                              {"probe", check.shot.probe.name},
                              {"has_view", !check.shot.calls},
                              {"set", check.shot.set}});
        return {{"title", manifest.title},
                {"folder", lab().entry.folder},
                {"knobs", knobs_of(*lab().lab)},
                {"camera", camera_of(manifest.camera)},
                {"animated", manifest.animated},
                {"probes", probes},
                {"tasks", tasks},
                {"checks", checks}};
    });
}

/// Sets a knob, and returns all knobs.
EMSCRIPTEN_KEEPALIVE const char* relief_set(const char* knob, const char* value) {
    return answer([&] {
        set_knob(*lab().lab, knob, value);
        return knobs_of(*lab().lab);
    });
}

/// Makes the lab again, after another task.cpp was compiled. Returns all knobs, which have their first values.
EMSCRIPTEN_KEEPALIVE const char* relief_renew() {
    return answer([&] {
        lab().lab = lab().entry.make();
        return knobs_of(*lab().lab);
    });
}

/// Begins to draw. `request` has `width`, `height`, `camera`, and `time` in seconds. A task file that does not compile
/// is an error, and the picture keeps the last program that did.
EMSCRIPTEN_KEEPALIVE const char* relief_draw(const char* request) {
    return answer([&]() -> json {
        Shot shot = shot_of(json::parse(request));
        shot.studio = true;
        renew_programs();  // a changed text counts once it was read twice
        const ShaderNews news = renew_programs();
        drawing().begin(shot.size);
        draw_lab(*lab().lab, frame_of(shot, *drawing().target));
        drawing().finish();
        if (news.error) throw *news.error;
        return true;
    });
}

/// Returns whether the picture of relief_draw() is finished, and shows it on the canvas.
EMSCRIPTEN_KEEPALIVE const char* relief_show() {
    return answer([&]() -> json {
        if (!drawing().is_finished()) return false;
        if (drawing().end) drawing().show();
        return true;
    });
}

/// Returns a probe's values at a pixel, from the left and the top. `request` also has `probe`, `x` and `y`.
EMSCRIPTEN_KEEPALIVE const char* relief_pixel(const char* request) {
    return answer([&]() -> json {
        const json from = json::parse(request);
        const Image image = draw_shot(*lab().lab, shot_of(from));
        const int x = std::clamp(from.at("x").get<int>(), 0, image.width - 1);
        const int y = std::clamp(from.at("y").get<int>(), 0, image.height - 1);
        json values = json::array();
        for (int c = 0; c < image.channels; ++c) {
            const float value = image.pixel(x, y)[c];
            if (std::isfinite(value))
                values.push_back(value);
            else
                values.push_back(std::isnan(value) ? "NaN" : value == no_surface ? "no surface" : "infinite");
        }
        return values;
    });
}

/// Runs a check by its index, and returns its outcome.
EMSCRIPTEN_KEEPALIVE const char* relief_check(int index) {
    return answer([&]() -> json {
        const size_t i = size_t(index);
        const CheckInfo& check = lab().manifest.checks.at(i);
        const check::Verdict& result = lab().results[i] = lab().checker.run(i, check::expectation(lab().entry, check));
        const FoldedText parts = unfolded_text(result.details);
        return {{"outcome", name_of(result.outcome)},
                {"found", result.found},
                {"details", parts.shown},
                {"further", parts.folded}};
    });
}

/// Returns, after all checks have run, each check's outcome and hint, each task's points and known mistake, and the
/// points of all tasks, or of those in shaders alone if the page has no compiler.
EMSCRIPTEN_KEEPALIVE const char* relief_advice(int has_compiler) {
    return answer([&]() -> json {
        const std::vector<check::TaskVerdict> results = lab().checker.tasks();
        std::vector<check::TaskVerdict> written;
        std::copy_if(results.begin(), results.end(), std::back_inserter(written),
                     [&](const check::TaskVerdict& task) { return has_compiler || is_shader(task.file); });
        json tasks = json::array(), checks = json::array();
        checks.get_ref<json::array_t&>().resize(lab().manifest.checks.size());
        for (const check::TaskVerdict& task : results) {
            for (const check::Verdict& said : task.checks)
                checks[said.index] = {
                    {"outcome", name_of(said.outcome)}, {"found", said.found}, {"look_at", said.look_at}};
            tasks.push_back({{"id", task.id},
                             {"has_all", task.points() >= task.of},
                             {"said", points_text(task)},
                             {"hint", task.hint}});
        }
        const check::PointSum sum = check::sum_of(written), optional = check::sum_of(written, true);
        return {{"tasks", tasks},
                {"checks", checks},
                {"points", sum.points},
                {"of", sum.of},
                {"optional", optional.points},
                {"said", points_text(written)}};
    });
}

/// Returns the archive of the lab's task files that `relief hand-in` makes, as an address and a size in bytes.
EMSCRIPTEN_KEEPALIVE const char* relief_hand_in() {
    return answer([&]() -> json {
        static std::string archive;
        std::map<std::string, std::string> files;
        for (const TaskInfo& task : lab().manifest.tasks) files[task.file] = read_file(course_root() / task.file);
        archive = check::stored_zip(files);
        return {{"address", reinterpret_cast<uintptr_t>(archive.data())}, {"size", archive.size()}};
    });
}

/// Returns a picture of a probe, as an address of bytes. `request` as for relief_draw(), with `probe`.
EMSCRIPTEN_KEEPALIVE const char* relief_probe(const char* request) {
    return answer([&]() -> json {
        const Shot shot = shot_of(json::parse(request));
        const ProbeInfo& probe = lab().manifest.probe(shot.probe.name);
        return bytes_of(visualize_probe(draw_shot(*lab().lab, shot), probe.colors()));
    });
}

/// Returns a picture of a check that has run, as an address of bytes. `which`: 0 the drawn one, 1 the expected one,
/// 2 their difference.
EMSCRIPTEN_KEEPALIVE const char* relief_picture(int index, int which) {
    return answer([&]() -> json {
        const check::Verdict& result = lab().results.at(size_t(index));
        if (result.drawn.values.empty() || result.expected.values.empty())
            throw Error("this check compares no pictures");
        const std::string& name = lab().manifest.checks.at(size_t(index)).shot.probe.name;
        const ProbeInfo* const probe = name.empty() ? nullptr : &lab().manifest.probe(name);
        if (which == 2) {
            const Image error =
                error_image(result.drawn, result.expected, probe ? probe->error : ErrorMetric::distance);
            return bytes_of(visualize_error(error, summarize(error).largest));
        }
        const Image& shown = which == 1 ? result.expected : result.drawn;
        if (!probe) return bytes_of(visualize_picture(shown));
        const auto pictures = visualize_probes(result.drawn, result.expected, probe->colors());
        return bytes_of(which == 1 ? pictures.second : pictures.first);
    });
}

/// Draws a shot as a check does: `request` as for relief_draw(), with `probe`, `studio`, and `set`, a list of knobs and
/// values. Returns the address of its floats, for tests.
EMSCRIPTEN_KEEPALIVE const char* relief_shot(const char* request) {
    return answer([&]() -> json {
        static Image image;
        const json from = json::parse(request);
        Shot shot = shot_of(from);
        shot.set = from.value("set", shot.set);
        shot.studio = from.value("studio", false);
        image = draw_shot(*make_lab(lab().entry, shot), shot);
        return {{"address", reinterpret_cast<uintptr_t>(image.values.data())},
                {"width", image.width},
                {"height", image.height},
                {"channels", image.channels}};
    });
}
}
