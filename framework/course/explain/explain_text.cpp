#include "framework/course/explain/explain_text.h"

#include <fmt/format.h>

#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"

namespace relief::check {
namespace {

/// Returns the text of a value, and advances `at` by its numbers.
template <class Number>
std::string text_of(const ValueShape& shape, const Number*& at) {
    switch (shape.kind) {
        case ValueShape::texture:
            return "a texture";
        case ValueShape::truth:
            return *at++ > 0.5 ? "true" : "false";
        case ValueShape::whole:
            return fmt::format("{:.0f}", double(*at++));
        case ValueShape::number:
            return rounded(double(*at++), sizeof(Number) == 4 ? 7 : 10);
        case ValueShape::group:
            break;
    }
    std::string text;
    for (const ValueShape& part : shape.parts)
        text += (text.empty() ? "" : ", ") + (part.name.empty() ? "" : part.name + " ") + text_of(part, at);
    return "(" + text + ")";
}

std::string numbers_of(const std::vector<float>& value) {
    std::string text;
    for (const float number : value) text += (text.empty() ? "" : "  ") + rounded(double(number), 6);
    return value.front() == no_surface ? "no surface" : value.front() == not_written ? "a task is not written" : text;
}

/// Returns " (texels)"; empty for a direction, where the unit is that of the error only.
std::string unit_of(const ProbeInfo& probe) {
    const bool has_unit = !probe.unit.empty() && probe.error != ErrorMetric::angle;
    return has_unit ? fmt::format(" ({})", plural(probe.unit)) : "";
}

std::string where_of(const ExplainedFunction& one) {
    std::string text = fmt::format("{}:{}, {} stage", shown(one.function.place.file), one.function.place.line,
                                   name_of(one.function.stage));
    if (one.pass > 0)
        text += fmt::format(", in an earlier pass, at {},{} of {} x {}{}", one.pixel.x, one.pixel.y, one.size.x,
                            one.size.y, one.is_read ? "" : ", which this pixel does not read");
    return text + (one.calls > 1 ? fmt::format(", {} calls", one.calls) : "");
}

std::string text_of(const ExplainedFunction& one, const ExplainedCall& call) {
    std::string text = one.calls > 1 ? fmt::format("    call {}\n", call.number + 1) : "";
    const auto row = [&](const std::string& name, const std::string& value, const char* rest = "") {
        text += fmt::format("      {:<12} {}{}\n", name, value, rest);
    };
    each_value(one.function.inputs, call.inputs,
               [&](const ValueShape& shape, const float*& at) { row(shape.name, text_of(shape, at)); });
    each_value(one.function.results, call.results,
               [&](const ValueShape& shape, const float*& at) { row(name_of_result(shape), text_of(shape, at)); });
    each_value(one.function.results, call.twin, [&](const ValueShape& shape, const double*& at) {
        if (!call.twin.empty()) row("twin", text_of(shape, at), call.excess > 1 ? "   differs" : "");
    });
    return text;
}

}  // namespace

std::string name_of_result(const ValueShape& shape) { return shape.name.empty() ? "returns" : shape.name; }

std::string text_of(const PixelReport& report) {
    const Explanation& explanation = report.explanation;
    const std::string& probe = report.shot.probe.name;
    const std::string what =
        probe.empty() ? "picture" : fmt::format("probe {}{}", probe, unit_of(report.manifest.probe(probe)));
    std::string text = fmt::format("{}, pixel {},{} of {} x {}\n", report.lab.folder, report.pixel.x, report.pixel.y,
                                   report.shot.size.x, report.shot.size.y);
    text += fmt::format("  {}: {}\n", what, numbers_of(explanation.value));
    if (!report.expected.value.empty())
        text += fmt::format("  {}: {}\n", report.expected.from, numbers_of(report.expected.value));
    if (explanation.functions.empty()) return text + "no function of a task is called at this pixel\n";
    if (explanation.with_twins)
        text += "the functions are called with what twins return: as they are, the pixel does not get as far\n";
    for (size_t i = 0; i < explanation.functions.size(); ++i) {
        const ExplainedFunction& one = explanation.functions[i];
        text += fmt::format("{} {}  ({})\n", explanation.first == i ? ">" : " ", one.function.name, where_of(one));
        if (one.is_unfinished) text += "      is not written yet\n";
        for (const ExplainedCall& call : one.shown) text += text_of(one, call);
    }
    return text;
}

std::string conclusion_of(const PixelReport& report) {
    const Explanation& explanation = report.explanation;
    if (!report.has_twins || explanation.functions.empty()) return {};
    if (!explanation.first) return "no function differs by more than rounding in a way that changes this pixel\n";
    const ExplainedFunction& one = explanation.functions[*explanation.first];
    return fmt::format("the first that differs by more than rounding: {} ({}:{})\n", one.function.name,
                       shown(one.function.place.file), one.function.place.line);
}

}  // namespace relief::check
