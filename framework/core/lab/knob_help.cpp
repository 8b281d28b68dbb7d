#include "framework/core/lab/knob_help.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace relief {
namespace {

std::string with_capital(std::string text) {
    if (!text.empty()) text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

}  // namespace

KnobHelp&& KnobHelp::in(const char* name_of_unit) && {
    unit = name_of_unit;
    return std::move(*this);
}

KnobHelp&& KnobHelp::only(const char* other_knob, std::vector<std::string> its_values) && {
    knob = other_knob, values = std::move(its_values);
    return std::move(*this);
}

KnobHelp&& KnobHelp::titled(const char* words) && {
    title = words;
    return std::move(*this);
}

std::string KnobHelp::title_of(std::string_view name) const {
    if (!title.empty()) return title;
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return with_capital(words);
}

std::string KnobHelp::condition() const {
    std::string condition;
    for (size_t i = 0; i < values.size(); ++i)
        condition += (i == 0 ? knob + " = " : i + 1 == values.size() ? " and " : ", ") + values[i];
    return condition;
}

std::string KnobHelp::line() const {
    std::string line = values.empty() ? text : "for " + condition() + ": " + text;
    if (!unit.empty()) line += ", " + unit;
    return line;
}

std::string KnobHelp::sentence() const {
    std::string sentence = with_capital(line());
    if (sentence.empty()) return sentence;
    if (std::string_view(".!?").find(sentence.back()) == std::string_view::npos) sentence += '.';
    return sentence;
}

std::string KnobHelp::unit_after_number() const {
    if (unit == "degrees") return "\u00b0";
    if (unit == "metres") return " m";
    if (unit == "pixels") return " px";
    return unit.empty() ? "" : " " + unit;
}

}  // namespace relief
