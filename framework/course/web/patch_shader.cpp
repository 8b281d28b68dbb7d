#include "framework/course/web/patch_shader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "framework/core/base/code_text.h"
#include "framework/core/base/error.h"
#include "framework/core/base/text.h"

namespace relief::web {
namespace {

/// Returns the definition of a line `#define NAME ...`, or "".
std::string defined(const std::string& text, const std::string& name) {
    const std::string words = "\n#define " + name + " ";
    const size_t at = text.find(words);
    return at == text.npos ? "" : text.substr(at + words.size(), text.find('\n', at + 1) - at - words.size());
}

/// A number or vector within the variables of a corner: each takes one texel.
struct Leaf {
    std::string type, name;
    int count;  ///< of its components
};

/// Converts one text.
class Conversion {
public:
    Conversion(const std::string& text, PatchStage stage)
        : text_(text), stage_(stage), tokens_(code_tokens(text)), structs_(parse_glsl(text).structs) {
        if (stage != PatchStage::vertex) read_layout();
    }

    PatchShader run() {
        change_declarations();
        rename();
        std::string body = changed();
        body.insert(body.find('\n') + 1, in_front() + "#line 2\n");
        result_.text = body + behind();
        return result_;
    }

private:
    bool is_read(const std::string& qualifier) const { return qualifier == "in" && stage_ != PatchStage::vertex; }
    bool is_written(const std::string& qualifier) const {
        return qualifier == "out" && stage_ != PatchStage::evaluation;
    }

    /// Reads the arguments of the whole stage's layout(), which may be macros.
    void read_layout() {
        std::set<std::string> words;
        bool is_within = false;
        for (size_t i = 0; i < tokens_.size(); ++i) {
            is_within = tokens_[i].text == "layout" || (is_within && tokens_[i].text != ")");
            if (!is_within) continue;
            const std::string macro = defined(text_, tokens_[i].text), &word = macro.empty() ? tokens_[i].text : macro;
            words.insert(word);
            if (i >= 2 && tokens_[i - 2].text == "vertices") result_.corners = parse_int(word).value_or(0);
        }
        if (words.contains("fractional_odd_spacing")) result_.spacing = TessellationSpacing::fractional_odd;
        if (words.contains("fractional_even_spacing")) result_.spacing = TessellationSpacing::fractional_even;
        if (stage_ == PatchStage::evaluation) {
            const bool has_both = words.contains("quads") && words.contains("triangles");
            const int chosen = parse_int(defined(text_, "CORNERS")).value_or(0);
            result_.corners = has_both ? chosen : words.contains("quads") ? 4 : 3;
        }
        if (result_.corners < 1) throw Error("in a browser, a stage needs a known number of vertices of a patch");
    }

    /// Turns the inputs from other stages into global variables, and drops the layout of the whole stage.
    void change_declarations() {
        int depth = 0;
        for (size_t first = 0, i = 0; i < tokens_.size(); ++i) {
            const std::string& token = tokens_[i].text;
            depth += (token == "{") - (token == "}");
            if (depth != 0 || (token != ";" && token != "}")) continue;
            const size_t begin = std::exchange(first, i + 1), count = i - begin;
            if (token == "}" || count < 2) continue;
            const auto word = [&](size_t k) { return begin + k < i ? tokens_[begin + k].text : ""; };
            const std::string& last = tokens_[i - 1].text;
            if (word(0) == "layout" && (last == "in" || last == "out")) {
                for (size_t k = begin; k <= i; ++k) changes_[k] = "";
                continue;
            }
            const size_t at = word(0) == "patch" || word(0) == "flat" ? 1 : 0;
            if (!is_read(word(at)) && !is_written(word(at))) continue;
            const bool is_array = last == "]";
            const PatchVariable variable{word(at + 1), word(at + 2), stage_ != PatchStage::vertex && !is_array};
            (is_read(word(at)) ? result_.read : result_.written).push_back(variable);
            for (size_t k = 0; k <= at; ++k) changes_[begin + k] = "";
            if (is_array) changes_[i - 1] = "r_corners]";
        }
    }

    void rename() {
        static const std::map<std::string, std::string> names = {
            {"main", "r_main"},          {"gl_InvocationID", "r_invocation"}, {"gl_TessLevelOuter", "r_outer"},
            {"gl_TessCoord", "r_point"}, {"gl_TessLevelInner", "r_inner"},    {"gl_PatchVerticesIn", "r_corners"}};
        for (size_t i = 0; i < tokens_.size(); ++i)
            if (const auto found = names.find(tokens_[i].text); found != names.end()) changes_[i] = found->second;
    }

    /// Returns the text with the tokens of changes_ replaced.
    std::string changed() const {
        std::string result;
        size_t done = 0;
        for (const auto& [token, replacement] : changes_) {
            result += text_.substr(done, tokens_[token].begin - done) + replacement;
            done = tokens_[token].end;
        }
        return result + text_.substr(done);
    }

    void add_leaves(std::vector<Leaf>& leaves, const std::string& type, const std::string& name) const {
        static const std::map<std::string, int> counts = {{"float", 1}, {"int", 1},   {"uint", 1},  {"vec2", 2},
                                                          {"vec3", 3},  {"vec4", 4},  {"ivec2", 2}, {"ivec3", 3},
                                                          {"ivec4", 4}, {"uvec2", 2}, {"uvec3", 3}, {"uvec4", 4}};
        if (const auto found = counts.find(type); found != counts.end())
            return leaves.push_back({type, name, found->second});
        const auto found =
            std::find_if(structs_.begin(), structs_.end(), [&](const auto& it) { return it.name == type; });
        if (found == structs_.end())
            throw Error("in a browser, stages around the tessellator pass no " + type + ": " + name);
        for (const GlslVariable& field : found->fields) add_leaves(leaves, field.type, name + "." + field.name);
    }
    std::vector<Leaf> leaves_of(const std::vector<PatchVariable>& variables, const std::string& corner) const {
        std::vector<Leaf> leaves;
        for (const PatchVariable& each : variables)
            add_leaves(leaves, each.type,
                       each.of_patch || stage_ == PatchStage::vertex ? each.name : each.name + corner);
        return leaves;
    }

    std::string in_front() const {
        if (stage_ == PatchStage::vertex) return "";
        const std::string own = stage_ == PatchStage::control
                                    ? "int r_invocation;\nfloat r_outer[4], r_inner[2];\n"
                                    : "layout(location = 0) in vec3 r_point;\nlayout(location = 1) in float r_patch;\n";
        return fmt::format(
            "uniform sampler2D r_passed;\nconst int r_corners = {};\n{}"
            "vec4 r_value(int i) {{ return texelFetch(r_passed, ivec2(i % {}, i / {}), 0); }}\n",
            result_.corners, own, patch_texels_a_row, patch_texels_a_row);
    }

    /// Returns statements that read all variables of the patch `r_number`.
    std::string reading() const {
        const std::vector<Leaf> leaves = leaves_of(result_.read, "[r_i]");
        std::string all = "    for (int r_i = 0; r_i < r_corners; ++r_i) {\n";
        for (size_t k = 0; k < leaves.size(); ++k)
            all += fmt::format("        {} = {}(r_value((r_number * r_corners + r_i) * {} + {}).{});\n", leaves[k].name,
                               leaves[k].type, leaves_in_texture(), k,
                               std::string("xyzw").substr(0, size_t(leaves[k].count)));
        return all + "    }\n";
    }
    /// Returns the values of a corner in the texture. The control stage's also has two values of levels.
    size_t leaves_in_texture() const {
        return leaves_of(result_.read, "").size() + (stage_ == PatchStage::evaluation ? 2 : 0);
    }

    /// Returns main(), which calls the stage's own.
    std::string behind() {
        std::string outputs, main = "\nvoid main() {\n";
        const auto write = [&](const std::string& value) {
            outputs += "out vec4 " + value_name(result_.values) + ";\n";
            main += "    " + value_name(result_.values++) + " = " + value + ";\n";
        };
        if (stage_ == PatchStage::control) {
            main += "    int r_number = gl_VertexID / r_corners;\n" + reading() +
                    "    for (r_invocation = 0; r_invocation < r_corners; ++r_invocation) r_main();\n";
        } else {
            if (stage_ == PatchStage::evaluation) main += "    int r_number = int(r_patch);\n" + reading();
            main += "    r_main();\n";
        }
        if (stage_ == PatchStage::evaluation) return main + "}\n";
        for (const Leaf& leaf : leaves_of(result_.written, "[gl_VertexID % r_corners]")) {
            static constexpr std::array zeros = {", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
            write("vec4(" + leaf.name + zeros[size_t(leaf.count - 1)] + ")");
        }
        if (stage_ == PatchStage::control) {
            write("vec4(r_outer[0], r_outer[1], r_outer[2], r_outer[3])");
            write("vec4(r_inner[0], r_inner[1], 0.0, 0.0)");
        }
        return outputs + main + "    gl_Position = vec4(0.0);\n}\n";
    }

    const std::string& text_;
    const PatchStage stage_;
    std::vector<CodeToken> tokens_;
    std::vector<GlslStruct> structs_;
    std::map<size_t, std::string> changes_;  ///< texts in place of tokens, by index
    PatchShader result_;
};

}  // namespace

std::string value_name(size_t value) { return "r_value_" + std::to_string(value); }

PatchShader patch_shader(const std::string& text, PatchStage stage) { return Conversion(text, stage).run(); }

}  // namespace relief::web
