#include "framework/pages/formula.h"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <optional>

#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/pages/template.h"

namespace relief {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

const std::map<std::string_view, std::string_view> greek = {
    {"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"}, {"theta", "θ"}, {"lambda", "λ"}, {"mu", "μ"},
    {"pi", "π"},    {"sigma", "σ"}, {"phi", "φ"},   {"Sigma", "Σ"}, {"Delta", "Δ"}, {"Lambda", "Λ"}};

/// Signs of more than one character, the longest first.
constexpr std::pair<std::string_view, std::string_view> long_signs[] = {{"<=>", "⇔"}, {"<=", "≤"}, {">=", "≥"},
                                                                        {"->", "→"},  {"×", "×"},  {"·", "·"}};

/// Words, with signs in place of what a keyboard has for them.
std::string with_signs(std::string words) {
    for (const auto& [written, shown] : long_signs)
        for (size_t at = 0; (at = words.find(written, at)) != std::string::npos; at += shown.size())
            words.replace(at, written.size(), shown);
    return words;
}

class Parser {
public:
    explicit Parser(std::string_view text) : rest_(text), all_(text) {}

    std::string whole() {
        std::string row = this->row("");
        if (!rest_.empty()) fail(fmt::format("'{}' closes nothing", rest_.front()));
        return row;
    }

private:
    /// A factor: what a script or a fraction takes.
    struct Part {
        std::string markup;
        std::string inside = {};  ///< of a group that may lose its brackets in a fraction: what is in them
    };

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

    /// Up to one of the characters in `closing`, or to the end if there are none.
    std::string row(std::string_view closing) {
        std::string markup;
        bool after_operand = false;
        top_level_comma_ = false;
        bool comma = false;
        for (;;) {
            const bool spaced = skip_spaces();
            if (rest_.empty() || closing.find(rest_.front()) != std::string_view::npos) break;
            if (closing.empty() && (rest_.front() == ')' || rest_.front() == ']')) break;
            if (const std::optional<std::string> sign = take_sign()) {
                comma |= *sign == ",";
                markup += "<mo>" + html(*sign) + "</mo>";
                after_operand = false;
                continue;
            }
            if (after_operand && spaced) markup += "<mspace width=\"0.2em\"></mspace>";
            markup += quotient();
            after_operand = true;
        }
        top_level_comma_ = comma;
        return markup;
    }

    std::optional<std::string> take_sign() {
        for (const auto& [written, shown] : long_signs)
            if (take(written)) return std::string(shown);
        const char c = rest_.front();
        if (std::string_view("+-=<>,;:*").find(c) == std::string_view::npos) return {};
        rest_.remove_prefix(1);
        return c == '-' ? "−" : c == '*' ? "·" : std::string(1, c);
    }

    /// A factor, or the fraction that it begins.
    std::string quotient() {
        Part above = factor();
        const std::string_view before = rest_;
        skip_spaces();
        if (!take("/")) {
            rest_ = before;
            return above.markup;
        }
        skip_spaces();
        const std::string sign = take("-") ? "<mo>−</mo>" : "";
        const Part below = factor();
        const auto bare = [](const Part& part) { return part.inside.empty() ? part.markup : part.inside; };
        return fmt::format("<mfrac><mrow>{}</mrow><mrow>{}{}</mrow></mfrac>", bare(above), sign, bare(below));
    }

    /// An atom with its scripts.
    Part factor() {
        Part base = atom();
        std::string low, high;
        for (;;) {
            if (take("_"))
                low += script();
            else if (take("'"))
                high += "<mo>′</mo>";
            else if (take("²"))
                high += "<mn>2</mn>";
            else if (take("^"))
                high += script();
            else if (take("°"))
                high += "<mo>°</mo>";
            else
                break;
        }
        if (low.empty() && high.empty()) return base;
        high = "<mrow>" + high + "</mrow>";
        if (low.empty()) return {fmt::format("<msup>{}{}</msup>", base.markup, high)};
        low = "<mrow>" + low + "</mrow>";
        if (high == "<mrow></mrow>") return {fmt::format("<msub>{}{}</msub>", base.markup, low)};
        return {fmt::format("<msubsup>{}{}{}</msubsup>", base.markup, low, high)};
    }

    std::string script() {
        const std::string sign = take("-") ? "<mo>−</mo>" : "";
        const Part part = atom();
        return sign + (part.inside.empty() ? part.markup : part.inside);
    }

    Part atom() {
        if (rest_.empty()) fail("it ends where a name or a number is expected");
        const char c = rest_.front();
        if (c == '(' || c == '[') return group(c == '(' ? ")" : "]");
        if (take("|")) {
            const std::string inside = row("|");
            if (!take("|")) fail("a | is not closed");
            return {"<mrow><mo>|</mo>" + inside + "<mo>|</mo></mrow>"};
        }
        if (take("\"")) {
            const size_t end = rest_.find('"');
            if (end == std::string_view::npos) fail("a quotation mark is not closed");
            const std::string words = html(std::string(rest_.substr(0, end)));
            rest_.remove_prefix(end + 1);
            return {"<mtext>" + words + "</mtext>"};
        }
        if (is_digit(c)) return {number()};
        if (is_letter(c)) return named();
        fail(fmt::format("'{}' means nothing here", rest_.substr(0, 1)));
    }

    Part group(const char* closing) {
        const std::string opening(1, rest_.front());
        rest_.remove_prefix(1);
        const std::string inside = row(closing);
        const bool is_vector = top_level_comma_;
        if (!take(closing)) fail(fmt::format("a {} is not closed", opening));
        // Without a mathematical font a bracket that may grow does so around anything.
        const char* const grows = inside.find("<mfrac>") == std::string::npos ? " stretchy=\"false\"" : "";
        return {fmt::format("<mrow><mo{0}>{1}</mo>{2}<mo{0}>{3}</mo></mrow>", grows, opening, inside, closing),
                is_vector || opening == "[" ? "" : inside};
    }

    std::string number() {
        size_t end = 0;
        while (end < rest_.size() &&
               (is_digit(rest_[end]) || (rest_[end] == '.' && end + 1 < rest_.size() && is_digit(rest_[end + 1]))))
            ++end;
        const std::string digits(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return "<mn>" + digits + "</mn>";
    }

    std::string_view letters() {
        size_t end = 0;
        while (end < rest_.size() && is_letter(rest_[end])) ++end;
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }

    Part named() {
        std::string name(letters());
        if (name == "sqrt" && rest_.starts_with("(")) {
            const Part inside = group(")");
            return {"<msqrt>" + (inside.inside.empty() ? inside.markup : inside.inside) + "</msqrt>"};
        }
        if (name == "sum") return {"<mo>∑</mo>"};
        if (name == "grad") return {"<mo>∇</mo>"};
        if (const auto letter = greek.find(name); letter != greek.end()) {
            name = letter->second;
        } else {
            // Names of code: to_light, p.xy. A subscript has one letter on at least one side of its line.
            while (rest_.size() > 1 && is_letter(rest_[1]) && (rest_[0] == '.' || rest_[0] == '_')) {
                const bool next_is_single = rest_.size() == 2 || !is_letter(rest_[2]);
                if (rest_[0] == '_' && (name.size() == 1 || next_is_single)) break;
                name += rest_[0];
                rest_.remove_prefix(1);
                name += letters();
            }
        }
        std::string markup = "<mi>" + name + "</mi>";
        if (!rest_.empty() && is_digit(rest_.front())) markup = fmt::format("<msub>{}{}</msub>", markup, number());
        // A function: its argument's brackets stay in a fraction.
        if (rest_.starts_with("(")) markup = "<mrow>" + markup + group(")").markup + "</mrow>";
        return {markup};
    }

    std::string_view rest_, all_;
    bool top_level_comma_ = false;  ///< of the last row
};

}  // namespace

std::string formula_mathml(std::string_view formula) {
    return "<math displaystyle=\"true\"><mrow>" + Parser(formula).whole() + "</mrow></math>";
}

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
                cells.push_back({true, with_signs(line.substr(begin + 1, end - begin - 1))});
                begin = end + 1;
            } else {
                end = std::min(line.find("  ", begin), line.size());
                cells.push_back({false, formula_mathml(std::string_view(line).substr(begin, end - begin))});
                begin = end;
            }
        }
        if (!cells.empty()) lines.push_back(std::move(cells));
    }
    return lines;
}

}  // namespace relief
