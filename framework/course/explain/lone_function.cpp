#include "framework/course/explain/lone_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <regex>
#include <set>

#include "framework/core/base/code_text.h"

namespace relief::check {
namespace {

/// Functions and statements that depend on other pixels, or that take too many steps by hand.
constexpr std::array not_by_hand = {"for",
                                    "while",
                                    "do",
                                    "discard",
                                    "unfinished",
                                    "dFdx",
                                    "dFdy",
                                    "fwidth",
                                    "probed",
                                    "interpolateAtSample",
                                    "interpolateAtCentroid"};
constexpr size_t most_arguments = 16, most_statements = 20;

using GlslStructs = std::vector<GlslStruct>;

/// Returns the number of numbers in a vector or scalar type; 0 for another type.
size_t size_of_vector(const std::string& type) {
    if (type == "float" || type == "int" || type == "bool") return 1;
    static const std::regex vector("[bi]?vec([234])");
    std::smatch match;
    return std::regex_match(type, match, vector) ? size_t(match[1].str()[0] - '0') : 0;
}

size_t size_of_matrix(const std::string& type) {
    static const std::regex matrix("mat([234])(x([234]))?");
    std::smatch match;
    if (!std::regex_match(type, match, matrix)) return 0;
    const auto digit = [&](size_t group) { return size_t(match[group].str()[0] - '0'); };
    return digit(1) * (match[3].matched ? digit(3) : digit(1));
}

/// Returns an expression for a value of this type from the numbers at `at` on, and advances `at`. Returns nothing for a
/// type with arrays or textures.
std::optional<std::string> value_from(const std::string& type, const GlslStructs& structs, size_t& at) {
    const auto number = [&] { return fmt::format("{}[{}]", lone_numbers, at++); };
    if (type == "bool") return number() + " > 0.5";
    const size_t count = size_of_vector(type) + size_of_matrix(type);
    std::string parts;
    for (size_t i = 0; i < count; ++i) parts += (i == 0 ? "" : ", ") + number();
    const auto known = std::find_if(structs.begin(), structs.end(), [&](const auto& one) { return one.name == type; });
    if (count == 0 && known == structs.end()) return {};
    if (count == 0)
        for (const GlslVariable& field : known->fields) {
            const auto part = field.count > 0 ? std::nullopt : value_from(field.type, structs, at);
            if (!part) return {};
            parts += (parts.empty() ? "" : ", ") + *part;
        }
    return fmt::format("{}({})", type, parts);
}

std::set<std::string> words_of(const std::string& text) {
    std::set<std::string> words;
    for (const CodeToken& token : code_tokens(text))
        if (token.kind == CodeToken::word) words.insert(token.text);
    return words;
}

/// Returns the names before an opening parenthesis: a variable may have the name of a function.
std::set<std::string> called_in(const std::string& text) {
    std::set<std::string> called;
    const std::vector<CodeToken> tokens = code_tokens(text);
    for (size_t i = 0; i + 1 < tokens.size(); ++i)
        if (tokens[i].kind == CodeToken::word && tokens[i + 1].text == "(") called.insert(tokens[i].text);
    return called;
}

/// Returns the function and all functions that it calls, also indirectly, in the order of the text.
std::string with_callees(const std::string& fragment, const std::vector<GlslFunction>& all, size_t first) {
    std::vector<bool> taken(all.size());
    std::vector<size_t> waiting = {first};
    taken[first] = true;
    const auto text_of_function = [&](size_t i) {
        return fragment.substr(all[i].begin, all[i].end - all[i].begin) + "\n";
    };
    while (!waiting.empty()) {
        const std::set<std::string> called = called_in(text_of_function(waiting.back()));
        waiting.pop_back();
        for (size_t i = 0; i < all.size(); ++i)
            if (!taken[i] && called.contains(all[i].name)) taken[i] = true, waiting.push_back(i);
    }
    std::string text;
    for (size_t i = 0; i < all.size(); ++i)
        if (taken[i]) text += text_of_function(i);
    return text;
}

/// Returns the structs and constants outside of functions, in the order of the text.
std::string declarations_of(const std::string& fragment, const GlslText& parsed) {
    std::map<size_t, std::string> found;  // by place
    for (const GlslStruct& one : parsed.structs) found[one.begin] = fragment.substr(one.begin, one.end - one.begin);
    std::vector<CodeToken> tokens = code_tokens(fragment);
    std::erase_if(tokens, [&](const CodeToken& token) {
        return std::any_of(parsed.functions.begin(), parsed.functions.end(), [&](const GlslFunction& function) {
            return token.begin >= function.begin && token.begin < function.end;
        });
    });
    for (size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].text != "const") continue;
        const size_t begin = i;
        while (i < tokens.size() && tokens[i].text != ";") ++i;
        if (i < tokens.size())
            found[tokens[begin].begin] = fragment.substr(tokens[begin].begin, tokens[i].end - tokens[begin].begin);
    }
    std::string text;
    for (const auto& [place, declaration] : found) text += declaration + "\n";
    return text;
}

int decimals_of(double largest, int digits) { return digits - 1 - int(std::floor(std::log10(largest))); }

/// Formats a number with at most so many decimals, without zeros at the end.
std::string with_decimals(double number, int decimals) {
    std::string text = fmt::format("{:.{}f}", number, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

double largest_of(const ValueShape& shape, const float* numbers) {
    double largest = 0;
    for (size_t i = 0; i < shape.count(); ++i) {
        if (!std::isfinite(numbers[i])) return INFINITY;
        largest = std::max(largest, double(std::abs(numbers[i])));
    }
    return largest;
}

/// Returns false if the value cannot be shown.
bool show(const ValueShape& shape, const float*& at, int digits, std::optional<int> decimals, ShownValue& shown) {
    const bool is_struct = !shape.parts.empty() && !shape.parts[0].name.empty();
    if (shape.kind == ValueShape::texture) return false;
    if (shape.kind == ValueShape::truth) {
        shown.text += *at > 0.5F ? "true" : "false";
        shown.numbers.push_back(*at++ > 0.5F ? 1 : 0);
        return true;
    }
    if (!decimals && !is_struct) {
        const double largest = largest_of(shape, at);
        if (!(largest < 1e6) || (largest != 0 && largest < 1e-6)) return false;
        decimals = largest == 0 ? 0 : std::max(0, decimals_of(largest, digits));
        shown.step = std::max(shown.step, std::pow(10.0, -*decimals));
    }
    if (shape.kind != ValueShape::group) {
        const std::string text = with_decimals(double(*at++), shape.kind == ValueShape::whole ? 0 : *decimals);
        shown.text += text;
        shown.numbers.push_back(std::stof(text));
        return true;
    }
    shown.text += "(";
    for (const ValueShape& part : shape.parts) {
        if (&part != &shape.parts.front()) shown.text += ", ";
        if (!part.name.empty()) shown.text += part.name + " ";
        if (!show(part, at, digits, decimals, shown)) return false;
    }
    shown.text += ")";
    return true;
}

}  // namespace

std::string lone_function(const std::string& fragment, const std::string& signature) {
    const GlslText parsed = parse_glsl(fragment);
    const auto found = std::find_if(parsed.functions.begin(), parsed.functions.end(),
                                    [&](const GlslFunction& one) { return one.signature() == signature; });
    if (found == parsed.functions.end() || !found->has_result_only() || found->parameters.empty()) return {};
    const size_t results = size_of_vector(found->type);
    if (results == 0) return {};
    std::string arguments;
    size_t at = 0;
    for (const GlslVariable& parameter : found->parameters) {
        const auto value = parameter.count > 0 ? std::nullopt : value_from(parameter.type, parsed.structs, at);
        if (!value) return {};
        arguments += (arguments.empty() ? "" : ", ") + *value;
    }
    if (at > most_arguments) return {};
    const std::string closed = with_callees(fragment, parsed.functions, size_t(found - parsed.functions.begin()));
    const std::set<std::string> words = words_of(closed);
    if (std::any_of(not_by_hand.begin(), not_by_hand.end(), [&](const char* word) { return words.contains(word); }) ||
        size_t(std::count(closed.begin(), closed.end(), ';')) > most_statements ||
        closed.find('#') != std::string::npos)
        return {};
    const std::string call = fmt::format("{}({})", found->name, arguments);
    return fmt::format(
        "#version 410 core\n{}uniform float {}[{}];\nout vec4 relief_result;\n{}\nvoid main() {{\n"
        "    relief_result = vec4(0.0);\n    relief_result.{} = {}({});\n}}\n",
        declarations_of(fragment, parsed), lone_numbers, lone_size, closed, std::string("xyzw").substr(0, results),
        results == 1 ? "float" : fmt::format("vec{}", results), call);
}

ShownValue shown_value(const ValueShape& shape, const float*& at, int digits) {
    ShownValue shown;
    if (!show(shape, at, digits, {}, shown)) shown.text.clear();
    return shown;
}

}  // namespace relief::check
