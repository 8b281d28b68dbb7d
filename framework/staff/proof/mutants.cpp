#include "framework/staff/proof/mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <regex>
#include <set>
#include <string_view>

#include "framework/core/base/code_text.h"
#include "framework/core/base/text.h"
#include "framework/course/task/starter.h"

namespace relief::grade {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The tokens of a piece of code, without comments, literals and preprocessor lines. An operator is one token.
class Tokens {
public:
    Tokens(const std::string& text, size_t begin, size_t end) : text_(text) {
        for (CodeToken& token : code_tokens(text.substr(begin, end - begin))) {
            token.begin += begin, token.end += begin;
            if (token.kind == CodeToken::literal) continue;
            if (token.kind == CodeToken::symbol && !list_.empty() && is_operator(list_.back(), token))
                list_.back().end = token.end;
            else
                list_.push_back(std::move(token));
        }
    }
    size_t size() const { return list_.size(); }
    const CodeToken& operator[](size_t i) const { return list_[i]; }
    std::string_view text(size_t i) const {
        if (i >= list_.size()) return {};
        return std::string_view(text_).substr(list_[i].begin, list_[i].end - list_[i].begin);
    }
    bool is(size_t i, std::string_view what) const { return text(i) == what; }
    /// Returns the index of the bracket that closes the one at `open`, or size().
    size_t closing(size_t open) const {
        int depth = 0;
        for (size_t i = open; i < size(); ++i) {
            const std::string_view token = text(i);
            depth += token == "(" || token == "[" || token == "{";
            depth -= token == ")" || token == "]" || token == "}";
            if (depth == 0) return i;
        }
        return size();
    }

private:
    /// Returns whether the two symbols together are an operator.
    static bool is_operator(const CodeToken& first, const CodeToken& second) {
        static const std::set<std::string> pairs = {
            "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "++", "--", "::", "->", "<<", ">>"};
        return first.end == first.begin + 1 && second.begin == first.end && pairs.contains(first.text + second.text);
    }

    const std::string& text_;
    std::vector<CodeToken> list_;
};

constexpr std::array<std::pair<const char*, const char*>, 22> operators = {{
    {"+", "-"},   {"-", "+"},   {"*", "/"},  {"/", "*"},          {"+=", "-="}, {"-=", "+="},
    {"*=", "/="}, {"/=", "*="}, {"<", "<="}, {"<", ">"},          {">", ">="},  {">", "<"},
    {"<=", "<"},  {"<=", ">="}, {">=", ">"}, {">=", "<="},        {"==", "!="}, {"!=", "=="},
    {"&&", "||"}, {"||", "&&"}, {"!", ""},   {"?", "&& false ?"},
}};
/// Functions whose call can be replaced by its first argument.
constexpr std::array droppable = {"normalize", "clamp", "max",  "min",   "abs",  "sqrt",
                                  "fract",     "floor", "ceil", "round", "sign", "exp2"};
constexpr std::array<std::pair<const char*, const char*>, 8> twins = {{{"max", "min"},
                                                                       {"min", "max"},
                                                                       {"sin", "cos"},
                                                                       {"cos", "sin"},
                                                                       {"floor", "ceil"},
                                                                       {"ceil", "floor"},
                                                                       {"tan", "sin"},
                                                                       {"round", "floor"}}};
constexpr std::array no_calls = {"if", "for", "while", "switch", "return", "sizeof", "unfinished"};
/// Functions whose arguments can be swapped without effect.
constexpr std::array commutative = {"max", "min", "dot", "distance"};

template <class List>
bool has(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// A scalar part of a function's result: `.origin.x`, `[1].z`, or an empty path for a scalar result.
struct Leaf {
    std::string path, type;
};

/// Returns the scalar parts of a result of this type. `structs`: the text that declares structs. Empty for an unknown
/// type.
std::vector<Leaf> leaves_of(std::string type, const std::string& structs) {
    if (type.starts_with("glm::")) type = type.substr(5);
    if (has(std::array{"float", "double", "int", "bool"}, type)) return {{"", type}};
    std::vector<Leaf> leaves;
    static const std::regex vector("([di]?)vec([234])"), matrix("d?mat([234])(x([234]))?");
    std::smatch match;
    if (std::regex_match(type, match, vector)) {
        const std::string part = match[1] == "i" ? "int" : match[1] == "d" ? "double" : "float";
        for (int i = 0; i < match[2].str()[0] - '0'; ++i) leaves.push_back({std::string(".") + "xyzw"[i], part});
        return leaves;
    }
    const auto add = [&](const std::string& path, const std::string& part) {
        for (const Leaf& leaf : leaves_of(part, structs)) leaves.push_back({path + leaf.path, leaf.type});
    };
    if (std::regex_match(type, match, matrix)) {
        const std::string column = "vec" + (match[3].matched ? match[3].str() : match[1].str());
        for (int i = 0; i < match[1].str()[0] - '0'; ++i) add(fmt::format("[{}]", i), column);
        return leaves;
    }
    const size_t declared = structs.find("struct " + type + " {");
    if (declared == std::string::npos) return {};
    const Tokens tokens(structs, structs.find('{', declared) + 1, structs.find("\n}", declared));
    std::string part;  // type of the current field
    for (size_t i = 0; i < tokens.size(); ++i) {
        if (part.empty()) {
            part = tokens.text(i);
            while (tokens.is(i + 1, "::")) i += 2, part = tokens.text(i);
            continue;
        }
        add("." + std::string(tokens.text(i)), part);
        while (i + 1 < tokens.size() && !tokens.is(i, ",") && !tokens.is(i, ";")) ++i;
        if (tokens.is(i, ";")) part.clear();
    }
    return leaves;
}

class Maker {
public:
    Maker(const std::string& text, const std::filesystem::path& file, const std::string& header) : text_(text) {
        for (const auto& [begin, end] : solutions(text, file)) {
            mutate(begin, end);
            outputs(begin, text + header);
        }
        std::stable_sort(made_.begin(), made_.end(), [](const Made& a, const Made& b) { return a.begin < b.begin; });
    }

    /// Makes changes in the bodies of the functions of `shader`, a text without marks.
    explicit Maker(const std::string& shader) : text_(shader) {
        for (const GlslFunction& function : parse_glsl(shader).functions)
            mutate(shader.find('{', function.name_at) + 1, function.end - 1);
    }

    std::vector<Mutant> take() {
        std::vector<Mutant> mutants;
        for (Made& one : made_) mutants.push_back(std::move(one.mutant));
        return mutants;
    }

private:
    struct Made {
        size_t begin;
        Mutant mutant;
    };

    void mutate(size_t begin, size_t end) {
        const Tokens tokens(text_, begin, end);
        for (size_t i = 0; i < tokens.size(); ++i) token(tokens, i);
    }

    static std::vector<std::pair<size_t, size_t>> solutions(const std::string& text,
                                                            const std::filesystem::path& file) {
        check::solution_lines(text, file);  // throws if marks do not match
        std::vector<std::pair<size_t, size_t>> parts;
        const std::string open = "//[solution";
        for (size_t at = text.find(open); at != std::string::npos; at = text.find(open, at + 1))
            parts.emplace_back(at + open.size(), std::min(text.find("//]", at), text.size()));
        return parts;
    }

    /// Returns the last task named before this place; the first task of the file for a place before all tasks.
    std::string task_at(size_t place) const {
        const std::string word = "TASK ";
        size_t at = text_.rfind(word, place);
        if (at == std::string::npos) at = text_.find(word);
        if (at == std::string::npos) return {};
        size_t end = at + word.size();
        while (end < text_.size() && (is_digit(text_[end]) || (text_[end] == '.' && is_digit(text_[end + 1])))) ++end;
        return text_.substr(at + word.size(), end - at - word.size());
    }

    static std::string on_one_line(std::string_view text) {
        std::string line;
        for (const char c : text)
            if (!std::isspace(static_cast<unsigned char>(c)))
                line += c;
            else if (!line.empty() && line.back() != ' ')
                line += ' ';
        return line;
    }

    void add(const char* rule, size_t begin, size_t end, const std::string& now) {
        keep(begin,
             {task_at(begin), rule, line_at(begin), on_one_line(std::string_view(text_).substr(begin, end - begin)),
              on_one_line(now), text_.substr(0, begin) + now + text_.substr(end)});
    }

    /// Replaces each scalar part of a function's result with 0, with 1, and with the next part of the same type.
    /// Renames the function, and adds one under the old name that calls it and changes the result. `solution`: position
    /// of the solution in the function.
    void outputs(size_t solution, const std::string& structs) {
        static const std::regex signature(R"(^([\w:]+) (\w+)\(([^{}()]*)\) \{\s*(//[^\n]*\s*)*$)");
        const size_t body = text_.rfind(") {\n", solution);
        if (body == std::string::npos) return;
        const size_t begin = text_.rfind('\n', text_.rfind('(', body)) + 1, end = text_.find("\n}", solution);
        const std::string head = text_.substr(begin, text_.rfind('\n', solution) - begin);
        std::smatch match;
        if (end == std::string::npos || !std::regex_match(head, match, signature)) return;
        const std::string type = match[1], name = match[2], arguments = match[3];
        const Tokens tokens(arguments, 0, arguments.size());
        std::string names;
        for (size_t i = 1; i < tokens.size(); ++i)
            if (tokens[i].kind == CodeToken::word &&
                (i + 1 == tokens.size() || tokens.is(i + 1, ",") || tokens.is(i + 1, "[")))
                names += (names.empty() ? "" : ", ") + std::string(tokens.text(i));
        const std::vector<Leaf> leaves = leaves_of(type, structs);
        for (size_t i = 0; i < leaves.size(); ++i) {
            const auto& [path, part] = leaves[i];
            std::set<std::string> values = {"0.0", "1.0"};
            if (part == "int") values = {"0", "1"};
            if (part == "bool") values = {"false", "true"};
            size_t next = i;
            do next = (next + 1) % leaves.size();
            while (leaves[next].type != part);
            if (next != i) values.insert("result" + leaves[next].path);
            for (const std::string& value : values) {
                const std::string call = fmt::format("{}_({})", name, names);
                std::string text = text_;
                text.insert(
                    end + 2,
                    fmt::format(
                        "\n{0} {1}({2}) {{\n    {0} result = {3};\n    result{4} = {5};\n    return result;\n}}", type,
                        name, arguments, call, path, value));
                text.insert(begin + type.size() + 1 + name.size(), "_");
                keep(begin, {task_at(begin), "output", line_at(begin), name + "()" + path, value, std::move(text)});
            }
        }
    }

    int line_at(size_t place) const { return 1 + int(std::count(text_.begin(), text_.begin() + long(place), '\n')); }

    void keep(size_t begin, Mutant mutant) {
        if (mutant.text != text_ && seen_.insert(mutant.text).second) made_.push_back({begin, std::move(mutant)});
    }

    void token(const Tokens& tokens, size_t i) {
        const CodeToken& here = tokens[i];
        const std::string_view word = tokens.text(i);
        if (here.kind == CodeToken::number) {
            constant(tokens, i);
        } else if (here.kind == CodeToken::symbol) {
            const bool has_left =
                i > 0 && (tokens[i - 1].kind != CodeToken::symbol || tokens.is(i - 1, ")") || tokens.is(i - 1, "]")) &&
                !tokens.is(i - 1, "return");
            if (word == "-" && !has_left) return add("sign", here.begin, here.end, "");
            for (const auto& [was, now] : operators)
                if (word == was && (has_left || word == "!")) add("operator", here.begin, here.end, now);
            if (word == "?") add("branch", here.begin, here.end, "|| true ?");
        } else {
            if (i > 0 && tokens.is(i - 1, ".")) swizzle(here, word);
            if (tokens.is(i + 1, "(")) call(tokens, i);
        }
        if (i == 0 || tokens.is(i - 1, ";") || tokens.is(i - 1, "{") || tokens.is(i - 1, "}")) statement(tokens, i);
    }

    void constant(const Tokens& tokens, size_t i) {
        const CodeToken& here = tokens[i];
        const std::string word(tokens.text(i));
        if (word.find_first_of(".eE") == std::string::npos || word.starts_with("0x")) {
            long value = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (error != std::errc()) return;
            const std::string ending(end, word.data() + word.size());  // u, L
            add("off by one", here.begin, here.end, std::to_string(value + 1) + ending);
            if (value > 0) add("off by one", here.begin, here.end, std::to_string(value - 1) + ending);
            return;
        }
        size_t digits = word.size();
        while (digits > 0 && (word[digits - 1] == 'f' || word[digits - 1] == 'F')) --digits;
        const std::string ending = word.substr(digits);
        const double value = std::stod(word.substr(0, digits));
        const auto constant = [&](double other) {
            std::string text = fmt::format("{}", other);
            if (text.find_first_of(".e") == std::string::npos) text += ".0";
            add("constant", here.begin, here.end, text + ending);
        };
        if (value == 0) return constant(1);
        constant(value * 1.1);
        constant(value * 2);
        constant(0);
    }

    void swizzle(const CodeToken& here, std::string_view word) {
        for (const std::string_view set : {"xyzw", "rgba", "stpq"}) {
            if (word.size() > 4 || word.find_first_not_of(set) != std::string_view::npos) continue;
            if (word.size() == 1) {
                const size_t place = set.find(word[0]);
                for (const size_t step : {1, 2})
                    add("channel", here.begin, here.end, std::string(1, set[(place + step) % (place < 3 ? 3 : 4)]));
            } else {
                std::string other(word);
                std::swap(other[0], other[1]);
                add("channel", here.begin, here.end, other);
                other = word;
                std::swap(other[0], other.back());
                add("channel", here.begin, here.end, other);
            }
            return;
        }
    }

    void call(const Tokens& tokens, size_t i) {
        const size_t close = tokens.closing(i + 1);
        if (close >= tokens.size()) return;
        const std::string_view name = tokens.text(i);
        const auto piece = [&](size_t begin, size_t end) { return text_.substr(begin, end - begin); };
        if (name == "if") {
            for (const char* value : {"true", "false"}) add("branch", tokens[i + 1].end, tokens[close].begin, value);
            return;
        }
        if (has(no_calls, name)) return;
        std::vector<std::pair<size_t, size_t>> arguments;
        size_t begin = tokens[i + 1].end;
        for (size_t j = i + 2, inside = 0; j <= close; ++j) {
            inside += tokens.is(j, "(") || tokens.is(j, "[") || tokens.is(j, "{");
            if ((tokens.is(j, ",") && inside == 0) || j == close) {
                arguments.emplace_back(begin, tokens[j].begin);
                begin = tokens[j].end;
            } else {
                inside -= tokens.is(j, ")") || tokens.is(j, "]") || tokens.is(j, "}");
            }
        }
        size_t first = i;  // includes the qualifier: "std::" of std::max
        while (first >= 2 && tokens.is(first - 1, "::")) first -= 2;
        const size_t whole_begin = tokens[first].begin, whole_end = tokens[close].end;
        if (has(droppable, name)) {
            add("dropped call", whole_begin, whole_end, "(" + piece(arguments[0].first, arguments[0].second) + ")");
            if ((name == "max" || name == "min") && arguments.size() == 2)
                add("dropped call", whole_begin, whole_end, "(" + piece(arguments[1].first, arguments[1].second) + ")");
        }
        for (const auto& [was, now] : twins)
            if (name == was) add("other function", tokens[i].begin, tokens[i].end, now);
        if (arguments.size() >= 2 && !has(commutative, name)) {
            const auto& [a, a_end] = arguments[0];
            const auto& [b, b_end] = arguments[1];
            add("swapped arguments", a, b_end,
                std::string(trimmed(piece(b, b_end))) + ", " + std::string(trimmed(piece(a, a_end))));
        }
    }

    static std::string_view trimmed(std::string_view text) {
        const size_t begin = text.find_first_not_of(" \n"), end = text.find_last_not_of(" \n");
        return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end + 1 - begin);
    }

    /// Drops an assignment: `x = 1;`, `x[i] += 2;`, but neither `float x = 1;` nor `return`.
    void statement(const Tokens& tokens, size_t i) {
        if (tokens[i].kind != CodeToken::word || has(no_calls, tokens.text(i)) || tokens.is(i, "const")) return;
        size_t end = i, assigns = 0;
        for (; end < tokens.size() && !tokens.is(end, ";"); ++end) {
            if (tokens.is(end, "{") || tokens.is(end, "}")) return;
            if (assigns == 0 && end > i && tokens[end].kind == CodeToken::word &&
                tokens[end - 1].kind == CodeToken::word)
                return;  // a declaration
            const std::string_view word = tokens.text(end);
            assigns += word == "=" || word == "+=" || word == "-=" || word == "*=" || word == "/=";
        }
        if (end < tokens.size() && assigns > 0) add("dropped statement", tokens[i].begin, tokens[end].end, ";");
    }

    const std::string& text_;
    std::set<std::string> seen_;
    std::vector<Made> made_;
};

}  // namespace

std::vector<Mutant> mutants_of(const std::string& text, const std::filesystem::path& file, const std::string& header) {
    return Maker(text, file, header).take();
}

std::vector<Mutant> line_mutants_of(const std::string& shader) {
    const std::vector<std::string> lines = split(shader, '\n');
    std::vector<Mutant> mutants = Maker(shader).take();
    std::erase_if(mutants, [&](const Mutant& mutant) {
        const std::vector<std::string> changed = split(mutant.text, '\n');
        if (changed.size() != lines.size()) return true;
        for (size_t i = 0; i < lines.size(); ++i)
            if (changed[i] != lines[i] && i + 1 != size_t(mutant.line)) return true;
        return false;
    });
    return mutants;
}

}  // namespace relief::grade
