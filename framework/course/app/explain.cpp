// relief explain: follows one pixel of a lab through the functions of its shader task files.
#include "framework/course/app/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/app/command.h"
#include "framework/course/app/shot_options.h"
#include "framework/course/check/check.h"
#include "framework/course/explain/explain_text.h"

namespace relief::app {
namespace {

using Json = nlohmann::ordered_json;

template <class Number>
Json json_of(const check::ValueShape& shape, const Number*& at) {
    if (shape.kind == check::ValueShape::texture) return nullptr;
    if (shape.kind == check::ValueShape::truth) return *at++ > 0.5;
    if (shape.kind == check::ValueShape::whole) return int64_t(*at++);
    if (shape.kind == check::ValueShape::number) {
        const double number = double(*at++);
        return std::isfinite(number) ? Json(number) : Json(fmt::format("{}", number));  // JSON has no infinity
    }
    const bool is_struct = !shape.parts.empty() && !shape.parts[0].name.empty();
    Json json = is_struct ? Json::object() : Json::array();
    for (const check::ValueShape& part : shape.parts)
        if (is_struct)
            json[part.name] = json_of(part, at);
        else
            json.push_back(json_of(part, at));
    return json;
}

Json json_of(const check::ExplainedFunction& one, const check::ExplainedCall& call) {
    Json inputs = Json::object(), results = Json::object(), twin = Json::object();
    check::each_value(one.function.inputs, call.inputs, [&](const check::ValueShape& shape, const float*& at) {
        inputs[shape.name] = json_of(shape, at);
    });
    check::each_value(one.function.results, call.results, [&](const check::ValueShape& shape, const float*& at) {
        results[check::name_of_result(shape)] = json_of(shape, at);
    });
    Json json = {{"call", call.number}, {"inputs", inputs}, {"results", results}};
    if (call.twin.empty()) return json;
    check::each_value(one.function.results, call.twin, [&](const check::ValueShape& shape, const double*& at) {
        twin[check::name_of_result(shape)] = json_of(shape, at);
    });
    json["twin"] = twin;
    json["differs"] = call.excess > 1;
    return json;
}

void print_json(const check::PixelReport& report) {
    const check::Explanation& explanation = report.explanation;
    Json functions = Json::array();
    for (const check::ExplainedFunction& one : explanation.functions) {
        Json calls = Json::array();
        for (const check::ExplainedCall& call : one.shown) calls.push_back(json_of(one, call));
        functions.push_back({{"name", one.function.name},
                             {"file", shown(one.function.place.file)},
                             {"line", one.function.place.line},
                             {"stage", check::name_of(one.function.stage)},
                             {"pass", one.pass},
                             {"pixel", {one.pixel.x, one.pixel.y}},
                             {"read", one.is_read},
                             {"unfinished", one.is_unfinished},
                             {"call_count", one.calls},
                             {"calls", calls}});
    }
    Json json = {{"lab", report.lab.folder},
                 {"pixel", {report.pixel.x, report.pixel.y}},
                 {"size", {report.shot.size.x, report.shot.size.y}},
                 {"probe", report.shot.probe.name},
                 {"value", explanation.value}};
    json["expected"] = report.expected.value.empty() ? Json() : Json(report.expected.value);
    json["with_twins"] = explanation.with_twins;
    json["first"] = explanation.first ? Json(explanation.functions[*explanation.first].function.name) : Json();
    json["functions"] = functions;
    // Invalid UTF-8 in a path is replaced. `value` may be NaN or infinite, which dump() prints as null.
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

// ---- the command

glm::ivec2 parse_pixel(const std::string& text) {
    const auto parts = split(text, ',');
    const auto column = parts.size() == 2 ? parse_int(parts[0]) : std::nullopt,
               row = parts.size() == 2 ? parse_int(parts[1]) : std::nullopt;
    if (!column || !row)
        throw UsageError(fmt::format("--pixel takes COLUMN,ROW, from the picture's upper left corner, not '{}'", text));
    return {*column, *row};
}

struct ExplainArguments {
    std::string lab, pixel, check, probe, mistake, submission, size, context = "auto";
    ShotOptions options;
    bool json = false;
};

/// Returns the expected value at the pixel. If a check draws this very shot, it is the check's expected value, else the
/// probe's exact value.
check::ExpectedValue expected_at(const LabEntry& lab, const Manifest& manifest, const Shot& shot, glm::ivec2 pixel) {
    std::optional<Image> image;
    std::string from;
    const auto text = [&](Shot any) {  // sorted, so that the order of knobs does not matter
        std::sort(any.set.begin(), any.set.end());
        return shot_text(any, manifest.camera);
    };
    const auto check = std::find_if(manifest.checks.begin(), manifest.checks.end(),
                                    [&](const CheckInfo& one) { return text(one.shot) == text(shot); });
    if (check != manifest.checks.end()) {
        image = check::expectation(lab, *check);
        from = "expected by the check";
    } else if (shot.probe) {
        image = find_truth(*make_lab(lab, shot), shot);
        from = "the exact value";
    }
    if (!image || image->width != shot.size.x || image->height != shot.size.y) return {};
    const float* const value = image->pixel(pixel.x, pixel.y);
    return {{value, value + image->channels}, from};
}

/// Returns the first check of this probe, else the first check of all.
const CheckInfo& check_near(const Manifest& manifest, const std::string& probe) {
    const auto same = std::find_if(manifest.checks.begin(), manifest.checks.end(),
                                   [&](const CheckInfo& one) { return one.shot.probe.name == probe; });
    return same == manifest.checks.end() ? manifest.checks.front() : *same;
}

int explain_pixel(const ExplainArguments& arguments) {
    const LabEntry& lab = find_lab(arguments.lab);
    const Manifest manifest = load_manifest(lab);
    if (std::none_of(manifest.tasks.begin(), manifest.tasks.end(),
                     [](const TaskInfo& task) { return is_shader(task.file); }))
        throw UsageError(fmt::format("no task of lab {} is in a shader: look at its probes with relief shot {} --help",
                                     lab.two_digits(), lab.two_digits()));
    if (!arguments.mistake.empty()) manifest.mistake(arguments.mistake);  // throws first if there is no such mistake
    if (!arguments.mistake.empty() && !arguments.submission.empty())
        throw UsageError("give only one of --mistake and --submission");
    Shot shot;
    shot.camera = manifest.camera;
    if (!arguments.check.empty()) shot = manifest.view_of_check(arguments.check);
    if (!arguments.size.empty()) shot.size = parse_size(arguments.size);
    arguments.options.apply(shot);
    if (!arguments.probe.empty()) shot.probe.name = manifest.probe(arguments.probe).name;
    const glm::ivec2 pixel = parse_pixel(arguments.pixel);
    if (!arguments.check.empty())
        if (const TaskInfo& task = manifest.task(manifest.check(arguments.check).task); !is_shader(task.file))
            print_note(fmt::format("task {} is in C++: only functions of shaders are followed", task.id));

    const auto context = open_context(context_kind(arguments.context));
    const check::Twins twins = check::twins_of(manifest);
    const check::ExpectedValue expected = expected_at(lab, manifest, shot, pixel);
    if (expected.value.empty() && twins.empty() && !manifest.checks.empty())
        print_note(fmt::format("what is right at a pixel is known in the pictures of checks: add --check {}",
                               quoted_for_shell(check_near(manifest, shot.probe.name).name)));
    std::shared_ptr<void> others;
    if (!arguments.mistake.empty() || !arguments.submission.empty())
        others = course_with(manifest, arguments.mistake, arguments.submission);
    const check::Explanation explanation = check::explain(lab, manifest, shot, pixel, twins);
    const check::PixelReport report{lab, manifest, shot, pixel, explanation, expected, !twins.empty()};
    arguments.json ? print_json(report) : fmt::print("{}{}", check::text_of(report), check::conclusion_of(report));
    return 0;
}

class ExplainCommand final : public Command {
public:
    void options(CommandOptions& options) override {
        options.lab(explain_.lab, true);
        options.value("--pixel", "COLUMN,ROW", explain_.pixel, "the pixel, counted from the upper left corner, 0,0");
        options.value("--check", "NAME", explain_.check, "in this check's picture");
        options.value("--size", "WxH", explain_.size, "size of the picture in pixels [1280x720, or the check's]");
        explain_.options.options(options);
        options.value("--probe", "NAME", explain_.probe,
                      "of a quantity as the shader computes it, instead of the picture");
        options.flag("--json", explain_.json, "print the result as JSON, for scripts");
        options.value("--context", "NAME", explain_.context, context_help);
        if (!course_with) return;
        options.value("--mistake", "ID", explain_.mistake,
                      "with a known mistake: an id from the lab's staff/grading.toml");
        options.value("--submission", "PATH", explain_.submission, "with the task files of a folder or an archive");
    }
    int run() override { return explain_pixel(explain_); }

private:
    ExplainArguments explain_;
};
RELIEF_COMMAND(ExplainCommand, 7, "explain", "follows one pixel through the functions of the task file");

}  // namespace

}  // namespace relief::app
