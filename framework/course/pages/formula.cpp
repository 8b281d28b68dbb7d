#include "framework/course/pages/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief::pages {
namespace {

using Kind = Formula::Kind;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

const std::map<std::string_view, std::string_view> greek = {
    {"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"}, {"theta", "θ"}, {"lambda", "λ"}, {"mu", "μ"},
    {"pi", "π"},    {"sigma", "σ"}, {"phi", "φ"},   {"Sigma", "Σ"}, {"Delta", "Δ"}, {"Lambda", "Λ"}};

/// Signs of more than one character, the longest first, with their displayed form.
constexpr std::pair<std::string_view, std::string_view> long_signs[] = {{"<=>", "⇔"}, {"<=", "≤"}, {">=", "≥"},
                                                                        {"->", "→"},  {"×", "×"},  {"·", "·"}};
const Formula minus{Kind::sign, "−"};

/// Replaces signs in a text by their displayed form.
std::string with_signs(std::string words) {
    const auto replace = [&](std::string_view written, std::string_view shown) {
        for (size_t at = 0; (at = words.find(written, at)) != std::string::npos; at += shown.size())
            words.replace(at, written.size(), shown);
    };
    for (const auto& [written, shown] : long_signs) replace(written, shown);
    replace(" - ", " − ");  // a minus, not a hyphen
    return words;
}

bool is_sign(const Formula& part, std::string_view sign) { return part.kind == Kind::sign && part.text == sign; }
bool has_sign(const Formula& row, std::string_view sign) {
    return std::any_of(row.parts.begin(), row.parts.end(), [&](const Formula& part) { return is_sign(part, sign); });
}

/// Splits a row at each part that is this sign.
std::vector<Formula> split_at(const Formula& row, std::string_view sign) {
    std::vector<Formula> pieces(1);
    for (const Formula& part : row.parts)
        if (is_sign(part, sign))
            pieces.emplace_back();
        else
            pieces.back().parts.push_back(part);
    return pieces;
}

/// Prepares a part of a fraction or a script: a group loses its round brackets, a vector and a matrix keep them.
Formula bare(Formula part) {
    if (part.kind == Kind::row) return part;
    if (part.kind != Kind::bracket || part.text != "(" || has_sign(part.parts[0], ",") ||
        std::any_of(part.parts[0].parts.begin(), part.parts[0].parts.end(),
                    [](const Formula& inside) { return inside.kind == Kind::matrix; }))
        return {.parts = {std::move(part)}};
    return std::move(part.parts[0]);
}

class Parser {
public:
    explicit Parser(std::string_view text) : rest_(text), all_(text) {}

    Formula whole() {
        Formula row = this->row("");
        if (!rest_.empty()) fail(fmt::format("'{}' closes nothing", rest_.front()));
        return row;
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("formula '{}': {}", all_, what)); }

    bool skip_spaces() {
        const size_t begin = std::min(rest_.find_first_not_of(' '), rest_.size());
        rest_.remove_prefix(begin);
        return begin > 0;
    }

    bool take(std::string_view text) {
        if (!rest_.starts_with(text)) return false;
        rest_.remove_prefix(text.size());
        return true;
    }

    /// Parses up to one of the characters in `closing`, or to the end if it is empty.
    Formula row(std::string_view closing) {
        if (++depth_ > 30) fail("its brackets are nested too deep");
        Formula row;
        bool after_operand = false;
        for (;;) {
            const bool spaced = skip_spaces();
            if (rest_.empty() || closing.find(rest_.front()) != std::string_view::npos) break;
            if (closing.empty() && (rest_.front() == ')' || rest_.front() == ']')) break;
            if (std::optional<Formula> sign = take_sign()) {
                row.parts.push_back(std::move(*sign));
                after_operand = false;
                continue;
            }
            if (after_operand && spaced) row.parts.push_back({Kind::gap});
            row.parts.push_back(quotient());
            after_operand = !is_sign(row.parts.back(), "∇");
        }
        --depth_;
        return row;
    }

    std::optional<Formula> take_sign() {
        for (const auto& [written, shown] : long_signs)
            if (take(written)) return Formula{Kind::sign, std::string(shown)};
        const char c = rest_.front();
        if (std::string_view("+-=<>,;:*").find(c) == std::string_view::npos) return {};
        rest_.remove_prefix(1);
        return c == '-' ? minus : Formula{Kind::sign, c == '*' ? "·" : std::string(1, c)};
    }

    /// Parses a factor, or the fraction that begins with it.
    Formula quotient() {
        Formula above = factor();
        const std::string_view before = rest_;
        skip_spaces();
        if (!take("/")) {
            rest_ = before;
            return above;
        }
        skip_spaces();
        const bool negative = take("-");
        Formula divisor = factor();
        if (divisor.kind == Kind::sign)
            fail(fmt::format("only {} would be below the line: put it in brackets with what it belongs to",
                             divisor.text));
        Formula below = bare(std::move(divisor));
        if (negative) below.parts.insert(below.parts.begin(), minus);
        return {Kind::fraction, "", {bare(std::move(above)), std::move(below)}};
    }

    /// Parses an atom with its scripts.
    Formula factor() {
        Formula base = atom(), low, high;
        if (base.kind == Kind::scripts) {  // f0²
            low = std::move(base.parts[1]);
            base = Formula(std::move(base.parts[0]));
        }
        const auto add = [](Formula& script, Formula part) {
            for (Formula& each : part.parts) script.parts.push_back(std::move(each));
        };
        for (;;) {
            if (take("_"))
                add(low, script());
            else if (take("'"))
                high.parts.push_back({Kind::sign, "′"});
            else if (take("²"))
                high.parts.push_back({Kind::number, "2"});
            else if (take("^"))
                add(high, script());
            else if (take("°"))
                high.parts.push_back({Kind::sign, "°"});
            else
                break;
        }
        if (low.parts.empty() && high.parts.empty()) return base;
        const bool is_function = base.kind == Kind::name && rest_.starts_with("(");
        Formula all{Kind::scripts, "", {std::move(base), std::move(low), std::move(high)}};
        return is_function ? Formula{.parts = {std::move(all), group()}} : all;
    }

    Formula script() {
        const bool negative = take("-");
        if (rest_.empty()) fail("it ends where a script is expected");
        Formula part = is_letter(rest_.front()) ? Formula{.parts = {name()}} : bare(atom());
        if (negative) part.parts.insert(part.parts.begin(), minus);
        return part;
    }

    Formula atom() {
        if (rest_.empty()) fail("it ends where a name or a number is expected");
        const char c = rest_.front();
        if (c == '(' || c == '[') return group();
        if (take("|")) {
            Formula inside = row("|");
            if (!take("|")) fail("a | is not closed");
            return {Kind::bracket, "|", {std::move(inside)}};
        }
        if (take("\"")) {
            const size_t end = rest_.find('"');
            if (end == std::string_view::npos) fail("a quotation mark is not closed");
            const std::string words(rest_.substr(0, end));
            rest_.remove_prefix(end + 1);
            return {Kind::words, words};
        }
        if (is_digit(c)) return number();
        if (is_letter(c)) return named();
        fail(fmt::format("'{}' means nothing here", rest_.substr(0, 1)));
    }

    Formula group() {
        const std::string opening(1, rest_.front());
        rest_.remove_prefix(1);
        Formula inside = row(closing_of(opening));
        if (!take(closing_of(opening))) fail(fmt::format("a {} is not closed", opening));
        if (has_sign(inside, ";")) {
            Formula matrix{Kind::matrix};
            for (const Formula& line : split_at(inside, ";")) matrix.parts.push_back({.parts = split_at(line, ",")});
            inside = {.parts = {std::move(matrix)}};
        }
        return {Kind::bracket, opening, {std::move(inside)}};
    }

    Formula number() {
        size_t end = 0;
        while (end < rest_.size() &&
               (is_digit(rest_[end]) || (rest_[end] == '.' && end + 1 < rest_.size() && is_digit(rest_[end + 1]))))
            ++end;
        const std::string digits(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return {Kind::number, digits};
    }

    std::string_view letters() {
        size_t end = 0;
        while (end < rest_.size() && is_letter(rest_[end])) ++end;
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }

    Formula named() {
        if (rest_.starts_with("sqrt(")) {
            letters();
            return {Kind::root, "", {bare(group())}};
        }
        Formula all = name();
        // A function keeps the brackets of its argument in a fraction.
        if (all.kind != Kind::sign && rest_.starts_with("(")) return {.parts = {std::move(all), group()}};
        return all;
    }

    /// Parses a name. A number at its end becomes a subscript.
    Formula name() {
        std::string name(letters());
        if (name == "sum") return {Kind::sign, "∑"};
        if (name == "grad") return {Kind::sign, "∇"};
        if (const auto letter = greek.find(name); letter != greek.end()) {
            name = letter->second;
        } else {
            // Names of code, such as to_light and p.xy. A subscript has a single letter on at least one side of the
            // underscore.
            while (rest_.size() > 1 && is_letter(rest_[1]) && (rest_[0] == '.' || rest_[0] == '_')) {
                const bool next_is_single = rest_.size() == 2 || !is_letter(rest_[2]);
                if (rest_[0] == '_' && (name.size() == 1 || next_is_single)) break;
                name += rest_[0];
                rest_.remove_prefix(1);
                name += letters();
            }
        }
        Formula all{Kind::name, name};
        if (!rest_.empty() && is_digit(rest_.front()))
            all = {Kind::scripts, "", {std::move(all), {.parts = {number()}}, {}}};
        return all;
    }

    std::string_view rest_, all_;
    int depth_ = 0;
};

}  // namespace

Formula parse_formula(std::string_view text) { return Parser(text).whole(); }

std::vector<std::vector<FormulaCell>> formula_lines(std::string_view block) {
    std::vector<std::vector<FormulaCell>> lines;
    for (const std::string& line : split(std::string(block), '\n')) {
        std::vector<FormulaCell> cells;
        size_t begin = 0;
        while ((begin = line.find_first_not_of(' ', begin)) != std::string::npos) {
            const bool is_words = line[begin] == '"';
            size_t end;
            if (is_words) {
                end = line.find('"', begin + 1);
                if (end == std::string::npos)
                    throw Error(fmt::format("formula '{}': a quotation mark is not closed", line));
                cells.push_back({.is_words = true, .words = with_signs(line.substr(begin + 1, end - begin - 1))});
                begin = end + 1;
            } else {
                end = std::min(line.find("  ", begin), line.size());
                cells.push_back({.formula = parse_formula(std::string_view(line).substr(begin, end - begin))});
                begin = end;
            }
        }
        if (!cells.empty()) lines.push_back(std::move(cells));
    }
    return lines;
}

}  // namespace relief::pages
