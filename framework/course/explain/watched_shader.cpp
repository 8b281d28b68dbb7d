#include "framework/course/explain/watched_shader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "framework/core/base/paths.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;
using Structs = std::vector<GlslStruct>;

// ---- types and values

bool has_floats(const std::string& type) {
    return type == "float" || type.starts_with("vec") || type.starts_with("mat");
}

const GlslStruct* find_struct(const Structs& structs, const std::string& name) {
    const auto found =
        std::find_if(structs.begin(), structs.end(), [&](const GlslStruct& one) { return one.name == name; });
    return found == structs.end() ? nullptr : &*found;
}

ValueShape group_of(size_t count, const ValueShape& part) {
    return {.kind = ValueShape::group, .parts = std::vector<ValueShape>(count, part)};
}

/// Nothing for a type that is not known.
std::optional<ValueShape> shape_of(const std::string& type, const Structs& structs) {
    static const std::map<std::string, ValueShape::Kind> scalars = {{"float", ValueShape::number},
                                                                    {"int", ValueShape::whole},
                                                                    {"uint", ValueShape::whole},
                                                                    {"bool", ValueShape::truth}};
    if (const auto scalar = scalars.find(type); scalar != scalars.end()) return ValueShape{.kind = scalar->second};
    if (type.find("sampler") != std::string::npos) return ValueShape{.kind = ValueShape::texture};
    const auto digit = [&](size_t from_end) { return size_t(type[type.size() - from_end] - '0'); };
    const size_t vec = type.find("vec");
    if (vec <= 1 && type.size() == vec + 4)
        return group_of(digit(1), {.kind = vec == 0         ? ValueShape::number
                                           : type[0] == 'b' ? ValueShape::truth
                                                            : ValueShape::whole});
    if (type.starts_with("mat") && type.size() == 4) return group_of(digit(1), group_of(digit(1), {}));
    if (type.starts_with("mat") && type.size() == 6) return group_of(digit(3), group_of(digit(1), {}));
    const GlslStruct* const known = find_struct(structs, type);
    if (!known) return {};
    ValueShape shape{.kind = ValueShape::group};
    for (const GlslVariable& field : known->fields) {
        auto part = shape_of(field.type, structs);
        if (!part) return {};
        if (field.count > 0) part = group_of(size_t(field.count), *part);
        part->name = field.name;
        shape.parts.push_back(*std::move(part));
    }
    return shape;
}

std::optional<ValueShape> shape_of(const GlslVariable& variable, const Structs& structs) {
    auto shape = shape_of(variable.type, structs);
    if (shape && variable.count > 0) shape = group_of(size_t(variable.count), *shape);
    if (shape) shape->name = variable.name;
    return shape;
}

/// A number of a value: its expression in the shader, and the vector, matrix or array to which it belongs.
struct Leaf {
    std::string text;
    ValueShape::Kind kind;
    int unit;
};

void add_leaves(const ValueShape& shape, const std::string& text, std::vector<Leaf>& leaves, int& units) {
    if (shape.kind == ValueShape::texture) return;
    if (shape.kind != ValueShape::group) {
        leaves.push_back({text, shape.kind, units});
        return;
    }
    for (size_t i = 0; i < shape.parts.size(); ++i) {
        const std::string& field = shape.parts[i].name;
        if (!field.empty()) ++units;
        add_leaves(shape.parts[i], field.empty() ? fmt::format("{}[{}]", text, i) : text + "." + field, leaves, units);
    }
}

std::vector<Leaf> leaves_of(const ValueShape& shape, const std::string& text) {
    std::vector<Leaf> leaves;
    int units = 0;
    add_leaves(shape, text, leaves, units);
    return leaves;
}

size_t count_of(const std::vector<ValueShape>& shapes) {
    size_t count = 0;
    for (const ValueShape& shape : shapes) count += shape.count();
    return count;
}

// ---- the wrapper

/// Converts a number to `type`; a bool becomes 1 or 0.
std::string as(const char* type, const Leaf& leaf) { return fmt::format("{}({})", type, leaf.text); }
std::string back(const Leaf& leaf, const std::string& number) {
    switch (leaf.kind) {
        case ValueShape::truth:
            return number + " > 0.5lf";
        case ValueShape::whole:
            return "int(" + number + ")";
        default:
            return "float(" + number + ")";
    }
}

/// Returns the expression of the maximum magnitude in the leaf's vector, the scale of the rounding errors of its
/// numbers.
std::string size_of_unit(const std::vector<Leaf>& leaves, const Leaf& of) {
    std::string size;
    for (const Leaf& leaf : leaves)
        if (leaf.unit == of.unit && leaf.kind == of.kind)
            size = size.empty() ? "abs(" + leaf.text + ")" : fmt::format("max({}, abs({}))", size, leaf.text);
    return size;
}

/// The relative perturbation of the twin's inputs: about thirty roundings to single precision.
constexpr const char* moved_by = "4.0e-6lf";
/// The error bound: `spreads` times the change under perturbation, plus `roundings` times moved_by of the result's
/// size.
constexpr const char *spreads = "4.0lf", *roundings = "25.0lf";

struct Wrapped {
    const GlslFunction& function;
    const WatchedFunction& watched;
    int place;  ///< 1 + the index in the list of all functions
    bool tells_unfinished;
    std::set<std::string> structs;
};

std::string declared(const std::string& type, const std::string& name, int count) {
    return type + " " + name + (count > 0 ? fmt::format("[{}]", count) : "");
}

/// Returns the code of one call of the twin: its inputs in double precision, perturbed in all rounds but the first.
std::string twin_round(const Wrapped& w) {
    std::string code, names;
    for (size_t i = 0; i < w.function.parameters.size(); ++i) {
        const GlslVariable& parameter = w.function.parameters[i];
        const ValueShape& shape = w.watched.inputs[i];
        const std::string given = fmt::format("relief_a{}", i), twins = fmt::format("relief_t{}", i);
        names += (i > 0 ? ", " : "") + (shape.kind == ValueShape::texture ? given : twins);
        if (shape.kind == ValueShape::texture) continue;
        code +=
            fmt::format("            {};\n", declared(twin_type(parameter.type, w.structs), twins, parameter.count));
        const std::vector<Leaf> from = leaves_of(shape, given), to = leaves_of(shape, twins);
        for (size_t k = 0; k < from.size(); ++k) {
            code += fmt::format("            {} = {};\n", to[k].text, from[k].text);
            if (from[k].kind == ValueShape::number)
                // Zeros stay exact: degenerate inputs are intended, and have cases of their own.
                code += fmt::format(
                    "            if (relief_round > 0) {} += {} * relief_side({}, relief_round) * double({});\n",
                    to[k].text, moved_by, from[k].text, size_of_unit(from, from[k]));
        }
    }
    code += fmt::format("            {} relief_twin = {}{}({});\n", twin_type(w.function.type, w.structs),
                        w.function.name, twin_suffix, names);
    const std::vector<Leaf> leaves = leaves_of(w.watched.results[0], "relief_twin");
    for (size_t k = 0; k < leaves.size(); ++k) {
        code += fmt::format("            relief_new = {};\n", as("double", leaves[k]));
        code += fmt::format("            if (relief_round == 0) relief_exact[{0}] = relief_new;\n", k);
        code += fmt::format(
            "            else if (!isnan(relief_new)) relief_off[{0}] = max(relief_off[{0}], abs(relief_new - "
            "relief_exact[{0}]));\n",
            k);
    }
    return code;
}

/// Returns code that calls the twin, and measures the function's distance from it as a multiple of the error bound.
std::string comparison(const Wrapped& w) {
    const std::vector<Leaf> own = leaves_of(w.watched.results[0], "relief_own");
    std::vector<Leaf> exact = own;
    for (size_t k = 0; k < exact.size(); ++k) exact[k].text = fmt::format("relief_exact[{}]", k);
    std::string code = fmt::format(
        "    double relief_exact[{0}], relief_off[{0}], relief_new;\n"
        "    for (int relief_i = 0; relief_i < {0}; ++relief_i) relief_exact[relief_i] = relief_off[relief_i] = "
        "0.0lf;\n"
        "    if (u_relief_rounds > 0) {{\n"
        "        for (int relief_round = 0; relief_round < u_relief_rounds; ++relief_round) {{\n{1}        }}\n",
        own.size(), twin_round(w));
    for (size_t k = 0; k < own.size(); ++k)
        code += fmt::format(
            "        relief_off[{0}] = {1} * relief_off[{0}] + {2} * {3} * {4} + 1e-30lf;\n"
            "        relief_excess = max(relief_excess, relief_excess_of({5}, relief_exact[{0}], relief_off[{0}]));\n",
            k, spreads, roundings, moved_by, size_of_unit(exact, exact[k]), as("double", own[k]));
    return code + "    }\n";
}

std::string wrapper(const Wrapped& w) {
    const GlslFunction& f = w.function;
    std::string parameters, names;
    std::vector<Leaf> inputs, results;
    size_t input = 0, result = 0;
    if (f.type != "void") results = leaves_of(w.watched.results[result++], "relief_own");
    for (size_t i = 0; i < f.parameters.size(); ++i) {
        const GlslVariable& parameter = f.parameters[i];
        const std::string name = fmt::format("relief_a{}", i);
        parameters += fmt::format("{}{} {}", i > 0 ? ", " : "", parameter.qualifier,
                                  declared(parameter.type, name, parameter.count));
        names += (i > 0 ? ", " : "") + name;
        const bool is_input = parameter.qualifier == "in";
        const auto leaves = leaves_of(is_input ? w.watched.inputs[input++] : w.watched.results[result++], name);
        (is_input ? inputs : results).insert((is_input ? inputs : results).end(), leaves.begin(), leaves.end());
    }
    const std::string call = fmt::format("relief_own_{}({})", f.name, names);
    std::string code = fmt::format(
        "\n{} {}({}) {{\n"
        "    bool relief_asked = u_relief_function == {};\n"
        "    int relief_call = relief_asked ? relief_calls++ : 0;\n"
        "    float relief_excess = 0.0;\n",
        f.type, f.name, parameters, w.place);
    if (w.tells_unfinished)
        code += "    bool relief_before = is_unfinished, relief_missing;\n    is_unfinished = false;\n";
    code += f.type == "void" ? fmt::format("    {};\n", call) : fmt::format("    {} relief_own = {};\n", f.type, call);
    if (w.tells_unfinished) code += "    relief_missing = is_unfinished;\n    is_unfinished = relief_before;\n";
    if (w.watched.has_twin) code += comparison(w);

    std::vector<std::string> note = {"0.0", "float(relief_call)", "relief_excess",
                                     w.tells_unfinished ? "float(relief_missing)" : "0.0"};
    for (const Leaf& leaf : inputs) note.push_back(as("float", leaf));
    for (const Leaf& leaf : results) note.push_back(as("float", leaf));
    if (w.watched.has_twin) {
        // Without `precise`, Mesa 26 takes double(float(x)) for x, and the low parts are 0.
        code += fmt::format("    precise float relief_high[{0}], relief_low[{0}];\n", results.size());
        for (size_t k = 0; k < results.size(); ++k)
            code += fmt::format(
                "    relief_high[{0}] = float(relief_exact[{0}]);\n"
                "    relief_low[{0}] = float(relief_exact[{0}] - double(relief_high[{0}]));\n",
                k);
        for (const char* const part : {"relief_high[{}]", "relief_low[{}]", "float(relief_off[{}])"})
            for (size_t k = 0; k < results.size(); ++k) note.push_back(fmt::format(fmt::runtime(part), k));
    }
    code +=
        "    if (relief_asked && (u_relief_call < 0 ? relief_call == 0 || relief_excess > relief_note[2]\n"
        "                                           : relief_call == u_relief_call)) {\n";
    for (size_t i = 0; i < note.size(); ++i) code += fmt::format("        relief_note[{}] = {};\n", i, note[i]);
    code += "    }\n";
    if (w.watched.has_twin) {
        code += fmt::format("    if (u_relief_flow == -1 || u_relief_flow == {}) {{\n        {} relief_better;\n",
                            w.place, f.type);
        const auto better = leaves_of(w.watched.results[0], "relief_better");
        for (size_t k = 0; k < better.size(); ++k)
            code +=
                fmt::format("        {} = {};\n", better[k].text, back(better[k], fmt::format("relief_exact[{}]", k)));
        code += "        return relief_better;\n    }\n";
    }
    if (w.tells_unfinished) code += "    is_unfinished = relief_before || relief_missing;\n";
    return code + (f.type == "void" ? "}\n" : "    return relief_own;\n}\n");
}

// ---- the stage around it

struct Change {
    size_t at, remove;
    std::string insert;
};

/// Applies the changes and updates the line table; inserted lines get an empty place.
void apply(ShaderSource& source, std::vector<Change> changes) {
    std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.at < b.at; });
    std::string text;
    std::vector<Place> lines;
    size_t at = 0, line = 0;
    const auto copy = [&](size_t to) {
        for (; at < to; ++at) {
            text += source.text[at];
            if (source.text[at] == '\n') lines.push_back(source.lines[line++]);
        }
    };
    for (const Change& change : changes) {
        copy(change.at);
        at += change.remove;
        text += change.insert;
        lines.insert(lines.end(), size_t(std::count(change.insert.begin(), change.insert.end(), '\n')), Place{});
    }
    copy(source.text.size());
    source.text = std::move(text);
    source.lines = std::move(lines);
}

std::optional<WatchedFunction::Stage> stage_of(const fs::path& path) {
    static const std::map<std::string, WatchedFunction::Stage> stages = {{".vert", WatchedFunction::vertex},
                                                                         {".tesc", WatchedFunction::control},
                                                                         {".tese", WatchedFunction::evaluation},
                                                                         {".geom", WatchedFunction::geometry},
                                                                         {".frag", WatchedFunction::fragment}};
    const auto found = stages.find(path.extension().string());
    return found == stages.end() ? std::optional<WatchedFunction::Stage>() : found->second;
}

const Place& place_at(const ShaderSource& source, size_t at) {
    return source.lines[size_t(std::count(source.text.begin(), source.text.begin() + std::ptrdiff_t(at), '\n'))];
}

size_t start_of_line(const ShaderSource& source, size_t line) {
    size_t at = 0;
    for (size_t i = 0; i < line; ++i) at = source.text.find('\n', at) + 1;
    return at;
}

std::string globals(WatchedFunction::Stage stage, size_t note_size) {
    return fmt::format(
        "{}"
        "uniform int {}, {}, {}, {}, {}, {}, {};\n"
        "uniform vec4 {};\n"
        "int relief_calls = 0;\n"
        "float relief_note[{}];\n"
        // Numbers of equal magnitude are perturbed alike, so equal numbers stay equal.
        "double relief_side(float number, int round_) {{\n"
        "    uint bits = (floatBitsToUint(abs(number)) * 2654435761u >> 7) >> round_ & 1u;\n"
        "    return number == 0.0 ? 0.0lf : (bits != 0u) == (number > 0.0) ? 1.0lf : -1.0lf;\n"
        "}}\n"
        "float relief_excess_of(double own, double exact, double off) {{\n"
        "    if (isnan(exact) || isinf(exact)) return isnan(own) || isinf(own) ? 0.0 : 1e30;\n"
        "    if (isnan(own) || isinf(own)) return 1e30;\n"
        "    return float(min(abs(own - exact) / off, 1e30lf));\n"
        "}}\n",
        stage == WatchedFunction::fragment ? "#define RELIEF_FRAGMENT_STAGE\n" : "", watched::noting, watched::function,
        watched::stage, watched::call, watched::rounds, watched::flow, watched::shaken, watched::region, note_size);
}

/// Returns one vec4 of the current slice, by its index among eight.
constexpr const char* slices = R"(
vec4 relief_slice(int place) {
    int first = (u_relief_noting - 1) * 32 + 4 * place;
    relief_note[0] = float(relief_calls);
    return vec4(relief_note[first], relief_note[first + 1], relief_note[first + 2], relief_note[first + 3]);
}
)";

/// Turns each `out vec4` with a location into a plain variable. A macro keeps its name, from which the new main()
/// copies.
std::vector<Change> without_outputs(const std::string& text) {
    std::vector<Change> changes;
    const std::vector<CodeToken> tokens = code_tokens(text);
    const auto is = [&](size_t i, const char* word) { return i < tokens.size() && tokens[i].text == word; };
    for (size_t i = 0; i < tokens.size(); ++i)
        if (is(i, "layout") && is(i + 1, "(") && is(i + 2, "location") && is(i + 5, ")") && is(i + 6, "out") &&
            is(i + 7, "vec4") && is(i + 9, ";"))
            changes.push_back(
                {tokens[i].begin, tokens[i + 9].end - tokens[i].begin,
                 fmt::format("vec4 {0};\n#define RELIEF_OUT_{1} {0}\n", tokens[i + 8].text, tokens[i + 4].text)});
    return changes;
}

/// Returns the change of an output at this texel. Neighbours change differently, since a constant would not change a
/// difference between them.
constexpr const char* shake = R"(
vec4 relief_shake(uint output_) {
    vec2 at = gl_FragCoord.xy;
    if (u_relief_shaken == 0 || any(lessThan(at, u_relief_region.xy)) || any(greaterThan(at, u_relief_region.zw)))
        return vec4(0.0);
    uint bits = (uint(at.x) * 1973u + uint(at.y) * 9277u + output_ * 26699u + 1u) * 2654435761u;
    bits = (bits ^ (bits >> 15)) * 2246822519u;
    vec4 side = vec4(bits >> 20 & 1u, bits >> 21 & 1u, bits >> 22 & 1u, bits >> 23 & 1u) * 1.5 - 0.75;
    return vec4(side.rgb, u_relief_shaken == 4 ? side.a : 0.0);
}
)";

std::string fragment_main(bool notes, bool carries) {
    std::string code, writes;
    for (int i = 0; i < 8; ++i) {
        code += fmt::format("layout(location = {0}) out vec4 relief_out_{0};\n", i);
        writes += fmt::format(
            "#ifdef RELIEF_OUT_{0}\n    relief_out_{0} = RELIEF_OUT_{0} + relief_shake({0}u);\n#endif\n", i);
    }
    std::string noted;
    for (int i = 0; i < 8; ++i) {
        const std::string own = fmt::format("relief_slice({})", i), carried = fmt::format("relief_carried[{}]", i);
        noted += fmt::format("        relief_out_{} = {};\n", i,
                             notes && carries ? fmt::format("u_relief_stage == {} ? {} : {}",
                                                            int(WatchedFunction::fragment), own, carried)
                             : notes          ? own
                                              : carried);
    }
    if (carries) code += "flat in vec4 relief_carried[8];\n";
    return code + shake + "void main() {\n    relief_main();\n" + writes + "    if (u_relief_noting > 0) {\n" + noted +
           "    }\n}\n";
}

/// Returns the main() of a stage before the fragment stage. It passes on its own note, or the note of an earlier stage.
std::string handing_main(const char* out, const char* in, WatchedFunction::Stage stage, bool notes) {
    std::string code =
        fmt::format("{} vec4 {}[8];\n", out, stage == WatchedFunction::control ? "relief_of_patch" : "relief_carried");
    if (in) code += fmt::format("{} vec4 relief_of_patch[8];\n", in);
    code += "void main() {\n    relief_main();\n";
    const char* const to = stage == WatchedFunction::control ? "relief_of_patch" : "relief_carried";
    code += stage == WatchedFunction::control ? "    if (gl_InvocationID == 0 && u_relief_noting > 0)\n"
                                              : "    if (u_relief_noting > 0)\n";
    const std::string own = notes ? "relief_slice(relief_i)" : "vec4(0.0)";
    code +=
        fmt::format("        for (int relief_i = 0; relief_i < 8; ++relief_i)\n            {}[relief_i] = {};\n", to,
                    in ? fmt::format("u_relief_stage == {} ? {} : relief_of_patch[relief_i]", int(stage), own) : own);
    return code + "}\n";
}

/// The functions of task files in one stage, with their indices in the list of all functions.
struct StageFunctions {
    GlslText text;
    std::vector<std::pair<const GlslFunction*, int>> watched;
};

class Watcher {
public:
    Watcher(const std::set<fs::path>& task_files, const Twins& twins, std::vector<WatchedFunction>& functions)
        : task_files_(task_files), twins_(twins), functions_(functions) {}

    StageFunctions find(const ShaderSource& source, WatchedFunction::Stage stage) {
        StageFunctions found{parse_glsl(source.text), {}};
        for (const GlslFunction& function : found.text.functions) {
            const Place& place = place_at(source, function.name_at);
            if (!task_files_.contains(place.file)) continue;
            if (const auto at = number(describe(function, found.text, place, stage)))
                found.watched.emplace_back(&function, *at);
        }
        return found;
    }

    /// Adds the wrappers to a stage's text; `rest` becomes its new end.
    void rewrite(ShaderSource& source, WatchedFunction::Stage kind, const StageFunctions& stage,
                 const std::string& rest) {
        std::vector<Change> changes;
        size_t note = note_slice;
        std::set<std::string> structs;
        for (const GlslStruct& one : stage.text.structs) structs.insert(one.name);
        const bool tells = source.text.find("bool is_unfinished") != std::string::npos;
        for (const auto& [function, place] : stage.watched) {
            const WatchedFunction& watched = functions_[size_t(place)];
            note = std::max(note, (watched.note_size() + note_slice - 1) / note_slice * note_slice);
            changes.push_back({function->name_at, 0, "relief_own_"});
            changes.push_back({function->end, 0, wrapper({*function, watched, place + 1, tells, structs})});
        }
        const auto first_of_task = std::find_if(source.lines.begin(), source.lines.end(),
                                                [&](const Place& place) { return task_files_.contains(place.file); });
        const size_t line = first_of_task == source.lines.end() ? 1 : size_t(first_of_task - source.lines.begin());
        const TwinText* const twin = stage.watched.empty() ? nullptr : twin_of(first_of_task->file);
        changes.push_back({start_of_line(source, line), 0, globals(kind, note) + (twin ? twin->declarations : "")});
        for (const GlslFunction& function : stage.text.functions)
            if (function.name == "main") changes.push_back({function.name_at, 0, "relief_"});
        if (rest.find("relief_out_0") != std::string::npos)
            for (const Change& change : without_outputs(source.text)) changes.push_back(change);
        changes.push_back(
            {source.text.size(), 0, (twin ? twin->functions : "") + (stage.watched.empty() ? "" : slices) + rest});
        apply(source, std::move(changes));
    }

private:
    const TwinText* twin_of(const fs::path& file) const {
        const auto found = twins_.find(shown(file));
        return found == twins_.end() ? nullptr : &found->second;
    }

    std::optional<WatchedFunction> describe(const GlslFunction& function, const GlslText& text, const Place& place,
                                            WatchedFunction::Stage stage) const {
        WatchedFunction watched{function.name, function.signature(), place, stage, {}, {}, false};
        if (function.type != "void") {
            const auto shape = shape_of(function.type, text.structs);
            if (!shape) return {};
            watched.results.push_back(*shape);
        }
        for (const GlslVariable& parameter : function.parameters) {
            const auto shape = shape_of(parameter, text.structs);
            if (!shape) return {};
            (parameter.qualifier == "in" ? watched.inputs : watched.results).push_back(*shape);
        }
        const TwinText* const twin = twin_of(place.file);
        watched.has_twin = twin && function.has_result_only() && twin->signatures.contains(watched.signature);
        return watched;
    }

    std::optional<int> number(const std::optional<WatchedFunction>& watched) {
        if (!watched) return {};
        const auto found = std::find_if(functions_.begin(), functions_.end(), [&](const WatchedFunction& one) {
            return one.signature == watched->signature && one.stage == watched->stage &&
                   one.place.file == watched->place.file;
        });
        const int place = int(found - functions_.begin());
        if (found == functions_.end()) functions_.push_back(*watched);
        return place;
    }

    const std::set<fs::path>& task_files_;
    const Twins& twins_;
    std::vector<WatchedFunction>& functions_;
};

}  // namespace

std::string twin_type(const std::string& type, const std::set<std::string>& structs) {
    if (type == "float") return "double";
    if (has_floats(type)) return "d" + type;
    return structs.contains(type) ? type + twin_suffix : type;
}

size_t ValueShape::count() const {
    if (kind == texture) return 0;
    return kind == group ? count_of(parts) : 1;
}

size_t WatchedFunction::input_count() const { return count_of(inputs); }
size_t WatchedFunction::result_count() const { return count_of(results); }
size_t WatchedFunction::note_size() const { return note_header + input_count() + result_count() * (has_twin ? 4 : 1); }

const char* name_of(WatchedFunction::Stage stage) {
    constexpr const char* names[] = {"vertex", "tessellation control", "tessellation evaluation", "geometry",
                                     "fragment"};
    return names[stage];
}

std::vector<int> watch_functions(std::vector<ShaderSource>& stages, const std::set<fs::path>& task_files,
                                 const Twins& twins, std::vector<WatchedFunction>& functions) {
    // Ignores the framework's own shaders, which come from no file.
    if (std::any_of(stages.begin(), stages.end(), [](const ShaderSource& source) { return source.lines.empty(); }))
        return {};
    Watcher watcher(task_files, twins, functions);
    std::map<WatchedFunction::Stage, ShaderSource*> sources;
    for (ShaderSource& source : stages)
        if (const auto stage = stage_of(source.stage)) sources[*stage] = &source;
    // A geometry stage does not pass notes on.
    if (!sources.contains(WatchedFunction::fragment) || sources.contains(WatchedFunction::geometry)) return {};
    const bool has_patches =
        sources.contains(WatchedFunction::control) && sources.contains(WatchedFunction::evaluation);
    if (has_patches) sources.erase(WatchedFunction::vertex);  // its notes would have to pass through every patch

    std::map<WatchedFunction::Stage, StageFunctions> found;
    std::vector<int> places;
    for (const auto& [stage, source] : sources) {
        found.emplace(stage, watcher.find(*source, stage));
        for (const auto& [function, place] : found.at(stage).watched) places.push_back(place);
    }
    if (places.empty()) return {};
    const auto notes = [&](WatchedFunction::Stage stage) {
        return found.contains(stage) && !found.at(stage).watched.empty();
    };
    const bool of_patch = notes(WatchedFunction::control);
    bool carries = false;
    for (const auto& [stage, source] : sources) {
        if (stage == WatchedFunction::fragment) {
            watcher.rewrite(*source, stage, found.at(stage), fragment_main(notes(stage), carries));
        } else if (stage == WatchedFunction::control ? of_patch : notes(stage) || of_patch) {
            const bool is_control = stage == WatchedFunction::control;
            watcher.rewrite(*source, stage, found.at(stage),
                            handing_main(is_control ? "patch out" : "flat out",
                                         !is_control && of_patch ? "patch in" : nullptr, stage, notes(stage)));
            carries = true;
        }
    }
    return places;
}

}  // namespace relief::check
