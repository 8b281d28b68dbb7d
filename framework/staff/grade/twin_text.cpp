#include "framework/staff/grade/twin_text.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/course/explain/explain.h"

namespace relief::grade {
namespace {

/// The functions of twin.glsl, by their GLSL names in single precision.
constexpr std::array<std::string_view, 18> single_only = {
    "exp",  "log", "sin",     "cos",     "tan",        "asin",    "acos",        "atan", "exp2",
    "log2", "pow", "radians", "degrees", "textureLod", "texture", "textureGrad", "dFdx", "dFdy"};
bool is_single_only(const std::string& word) {
    return std::find(single_only.begin(), single_only.end(), word) != single_only.end();
}

/// A range of the text outside functions: a struct, a constant, or a variable between stages.
struct Range {
    size_t begin, end;
    bool is_kept;  ///< true: becomes a declaration of the twins
};

struct TaskNames {
    std::set<std::string> structs, all;
};

bool is_within(const std::vector<Range>& ranges, size_t at, bool kept) {
    return std::any_of(ranges.begin(), ranges.end(), [&](const Range& range) {
        return range.is_kept == kept && at >= range.begin && at < range.end;
    });
}

/// Returns the declarations outside of functions, such as structs and constants; adds their names to `names`.
std::vector<Range> declarations(const std::string& text, const GlslText& parsed, TaskNames& names) {
    std::vector<Range> ranges;
    for (const GlslStruct& one : parsed.structs) {
        ranges.push_back({one.begin, one.end, true});
        names.structs.insert(one.name);
        names.all.insert(one.name);
    }
    std::vector<CodeToken> outside;
    for (const CodeToken& token : code_tokens(text)) {
        const auto holds = [&](const auto& one) { return token.begin >= one.begin && token.begin < one.end; };
        if (std::none_of(parsed.functions.begin(), parsed.functions.end(), holds) &&
            std::none_of(parsed.structs.begin(), parsed.structs.end(), holds))
            outside.push_back(token);
    }
    for (size_t i = 0; i < outside.size(); ++i) {
        const size_t first = i;
        while (i + 1 < outside.size() && outside[i].text != ";") ++i;
        const bool is_constant = outside[first].text == "const";
        ranges.push_back({outside[first].begin, outside[i].end, is_constant});
        int depth = 0;
        for (size_t k = first; is_constant && k < i; ++k) {
            if (outside[k].text == "(" || outside[k].text == "[") ++depth;
            if (outside[k].text == ")" || outside[k].text == "]") --depth;
            if (depth == 0 && outside[k + 1].text == "=") names.all.insert(outside[k].text);
        }
    }
    return ranges;
}

std::string translated(const CodeToken& token, bool is_field, const TaskNames& names) {
    if (token.kind == CodeToken::number) {
        const bool is_float = token.text.find_first_of(".eE") != std::string::npos && !token.text.starts_with("0x");
        if (!is_float) return token.text;
        return token.text.substr(0, token.text.find_last_not_of("fFlL") + 1) + "lf";
    }
    if (token.kind != CodeToken::word || is_field) return token.text;
    if (names.all.contains(token.text)) return token.text + check::twin_suffix;
    if (is_single_only(token.text)) return "relief_" + token.text;
    return check::twin_type(token.text, {});
}

/// Returns the text in double precision. Omits ranges for which `keep` is false, except their line breaks.
template <class Keep>
std::string translated(const std::string& text, const TaskNames& names, const std::vector<Range>& fields, Keep keep) {
    std::string result;
    size_t at = 0;
    std::string before;
    const auto copy = [&](size_t to) {
        for (; at < to; ++at)
            if (text[at] == '\n' || keep(at)) result += text[at];
    };
    for (const CodeToken& token : code_tokens(text)) {
        copy(token.begin);
        const bool is_field =
            before == "." || (is_within(fields, token.begin, true) && !names.structs.contains(token.text));
        if (keep(token.begin))
            result += translated(
                token, is_field && token.kind == CodeToken::word && check::twin_type(token.text, {}) == token.text,
                names);
        at = token.end;
        before = token.text;
    }
    copy(text.size());
    return result;
}

std::string prototype(const GlslFunction& function, const TaskNames& names) {
    std::string parameters;
    for (const GlslVariable& parameter : function.parameters) {
        const std::string array = parameter.count > 0 ? "[" + std::to_string(parameter.count) + "]" : "";
        parameters += (parameters.empty() ? "" : ", ") + parameter.qualifier + " " +
                      check::twin_type(parameter.type, names.structs) + " " + parameter.name + array;
    }
    return check::twin_type(function.type, names.structs) + " " + function.name + check::twin_suffix + "(" +
           parameters + ");\n";
}

const FromStaff<check::Twins(const Manifest&)>::Provided provided(check::twins_of, twins_of_course);

}  // namespace

check::TwinText twin_text(const std::string& text, const std::string& includes) {
    const std::string whole = includes + "\n" + text;
    const GlslText parsed = parse_glsl(whole);
    TaskNames names;
    for (const GlslFunction& function : parsed.functions) names.all.insert(function.name);
    const std::vector<Range> ranges = declarations(whole, parsed, names);
    std::vector<Range> structs;
    for (const GlslStruct& one : parsed.structs) structs.push_back({one.begin, one.end, true});

    static const std::string helpers = read_file(course_root() / "framework" / "staff" / "grade" / "twin.glsl");
    check::TwinText twin;
    twin.declarations = helpers;
    twin.declarations +=
        translated(whole, names, structs, [&](size_t at) { return is_within(ranges, at, true); }) + "\n";
    for (const GlslFunction& function : parsed.functions) {
        twin.declarations += prototype(function, names);
        twin.signatures.insert(function.signature());
    }
    std::string functions = translated(whole, names, structs, [&](size_t at) {
        return !is_within(ranges, at, true) && !is_within(ranges, at, false);
    });
    // Removes #include lines, which a compiler would reject.
    for (size_t at = 0; (at = functions.find("#include", at)) != std::string::npos;)
        functions.erase(at, functions.find('\n', at) - at);
    twin.functions = std::move(functions);
    return twin;
}

check::Twins twins_of_course(const Manifest& manifest) {
    check::Twins twins;
    for (const TaskInfo& task : manifest.tasks) {
        if (!is_shader(task.file) || twins.contains(task.file)) continue;
        const std::string text = read_file(course_root() / task.file);
        std::string includes;
        for (const std::string& name : included_by(text))
            if (name != "common/unfinished.glsl") includes += read_file(course_root() / "shaders" / name) + "\n";
        twins.emplace(task.file, twin_text(text, includes));
    }
    return twins;
}

}  // namespace relief::grade
