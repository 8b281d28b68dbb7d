#include "framework/core/gl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/cube_texture.h"
#include "framework/core/gl/texture.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

GLenum stage_of(const fs::path& path) {
    static const std::map<std::string, GLenum> stages = {{".vert", GL_VERTEX_SHADER},
                                                         {".tesc", GL_TESS_CONTROL_SHADER},
                                                         {".tese", GL_TESS_EVALUATION_SHADER},
                                                         {".geom", GL_GEOMETRY_SHADER},
                                                         {".frag", GL_FRAGMENT_SHADER}};
    const auto found = stages.find(path.extension().string());
    if (found == stages.end())
        throw Error({path}, "the name of a stage must end in .vert, .tesc, .tese, .geom or .frag");
    return found->second;
}

// Returns the log of a shader or of a program: their query functions have the same signatures.
std::string log_of(GLuint name, PFNGLGETSHADERIVPROC parameter, PFNGLGETSHADERINFOLOGPROC read) {
    GLint length = 0;
    parameter(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(size_t(std::max(0, length)), '\0');
    if (!log.empty()) read(name, length, &length, log.data());
    log.resize(size_t(std::max(0, length)));
    return log;
}

ShaderName compile(const ShaderSource& source) {
    ShaderName shader(stage_of(source.stage));
    label(GL_SHADER, shader, shown(source.stage));
    const char* const text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (!done) {
        const ShaderLog log = explain_log(log_of(shader, glGetShaderiv, glGetShaderInfoLog), source.lines, source.text);
        const Place place = log.first.file.empty() ? Place{source.stage} : log.first;
        throw Error(place, log.first_message.empty() ? "does not compile" : log.first_message, log.text);
    }
    return shader;
}

std::vector<ShaderSource> load_shaders(const std::vector<fs::path>& stages, const std::vector<std::string>& defines) {
    std::vector<ShaderSource> sources;
    for (const fs::path& path : stages) sources.push_back(load_shader(path, defines));
    return sources;
}

ShaderRewriting::Rewrite& shader_rewriting() {
    static ShaderRewriting::Rewrite rewrite;
    return rewrite;
}

}  // namespace

ShaderRewriting::ShaderRewriting(Rewrite rewrite) { shader_rewriting() = std::move(rewrite); }
ShaderRewriting::~ShaderRewriting() { shader_rewriting() = {}; }

Program::Program(const std::vector<fs::path>& stages, const std::vector<std::string>& defines)
    : Program(load_shaders(stages, defines)) {}

Program::Program(std::vector<ShaderSource> stages) {
    const Stopwatch watch;
    if (shader_rewriting()) shader_rewriting()(stages, name_);
    std::transform(stages.begin(), stages.end(), stages.begin(), reached_source);
    std::vector<ShaderName> shaders;
    for (const ShaderSource& source : stages) {
        known_.insert(source.names.begin(), source.names.end());
        title_ += (title_.empty() ? "" : " + ") + shown(source.stage);
        shaders.push_back(compile(source));
        glAttachShader(name_, shaders.back());
    }
    label(GL_PROGRAM, name_, title_);
    glLinkProgram(name_);
    GLint done = GL_FALSE;
    glGetProgramiv(name_, GL_LINK_STATUS, &done);
    if (!done) {
        ShaderSource all;
        for (const ShaderSource& source : stages) {
            all.text += source.text;
            all.lines.insert(all.lines.end(), source.lines.begin(), source.lines.end());
        }
        const ShaderLog log = explain_log(log_of(name_, glGetProgramiv, glGetProgramInfoLog), all.lines, all.text);
        throw Error(log.first.file.empty() ? Place{stages.back().stage} : log.first,
                    "does not link with the other stages: " + log.first_message, log.text);
    }
    for (const ShaderName& shader : shaders) glDetachShader(name_, shader);

    GLint count = 0;
    glGetProgramiv(name_, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char name[256];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(name_, GLuint(i), sizeof name, nullptr, &size, &type, name);
        std::string plain_name(name);
        if (plain_name.ends_with("[0]")) plain_name.resize(plain_name.size() - 3);
        locations_.emplace(plain_name, glGetUniformLocation(name_, name));
    }
    print_event(fmt::format("program: {}, {:.1f} ms", title_, watch.milliseconds()));
}

GLint Program::location(const char* uniform) const {
    const auto found = locations_.find(std::string_view(uniform));
    if (found != locations_.end()) return found->second;
    std::string base(uniform);
    base.resize(std::min(base.size(), base.find_first_of(".[")));
    if (!known_.contains(base)) {
        const std::vector<std::string> names(known_.begin(), known_.end());
        throw Error(title_ + ": " + unknown("uniform", uniform, names));
    }
    return glGetUniformLocation(name_, uniform);  // array or struct element, or not in use (-1)
}

void Program::set(const char* uniform, bool value) const { glUniform1i(location(uniform), value); }
void Program::set(const char* uniform, int value) const { glUniform1i(location(uniform), value); }
void Program::set(const char* uniform, float value) const { glUniform1f(location(uniform), value); }
void Program::set(const char* uniform, double value) const { glUniform1f(location(uniform), float(value)); }
void Program::set(const char* uniform, const glm::vec2& value) const {
    glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::ivec2& value) const {
    glUniform2iv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec3& value) const {
    glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::vec4& value) const {
    glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat3& value) const {
    glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* sampler, int unit, const Texture& texture) const {
    const GLint place = location(sampler);
    if (place < 0) return;
    glUniform1i(place, unit);
    bind(unit, texture);
}
void Program::set(const char* sampler, int unit, const CubeTexture& texture) const {
    const GLint place = location(sampler);
    if (place < 0) return;
    glUniform1i(place, unit);
    bind(unit, texture);
}

/// One program, and the texts that show whether its files have changed.
class Permutation {
public:
    Permutation(std::vector<fs::path> stages, std::vector<std::string> defines)
        : stages_(std::move(stages)), defines_(std::move(defines)) {
        all().push_back(this);
    }
    ~Permutation() { std::erase(all(), this); }
    Permutation(const Permutation&) = delete;
    Permutation& operator=(const Permutation&) = delete;

    /// All live permutations. A lab's Programs are private, and the window must not know the lab. So permutations
    /// register themselves here, as labs do in their registry.
    static std::vector<Permutation*>& all() {
        static std::vector<Permutation*> permutations;
        return permutations;
    }

    /// Compiles the program on first use. Throws when its files do not compile; the next call tries again.
    const Program& program() {
        if (!program_) compile(read());
        return *program_;
    }

    /// Returns whether the files have new text: two reads in a row agree, and differ from the last text tried.
    /// Recompiles the program then, unless it has never compiled. Finds errors in functions that the program does not
    /// reach, too: a person who writes one wants to know.
    bool look() {
        Text text = read();
        const bool settled = text.whole == std::exchange(seen_, text.whole);
        if (!settled || text.whole == looked_at_) return false;
        looked_at_ = text.whole;
        const bool is_new = text.whole != std::exchange(tried_, text.whole);
        if (!program_) return is_new;  // failed at first use: the next program() compiles it
        error_.reset();
        try {
            for (const ShaderSource& source : text.sources) relief::compile(source);
            if (text.whole != made_of_) compile(std::move(text)), ++renewals_;
        } catch (const Error& error) {
            error_ = error;
        }
        return is_new;
    }
    const std::optional<Error>& error() const { return error_; }
    int renewals() const { return renewals_; }

private:
    struct Text {
        std::vector<ShaderSource> sources;
        std::string whole;           ///< text of all stages, or the error message
        std::optional<Error> error;  ///< a missing file or a wrong #include
    };
    // Comparing text is reliable on every file system, and reading a few small files is as fast as asking for their
    // times.
    Text read() const {
        Text text;
        try {
            text.sources = load_shaders(stages_, defines_);
            for (const ShaderSource& source : text.sources) text.whole += source.text + '\0';
        } catch (const Error& error) {
            text.whole = error.what();
            text.error = error;
        }
        return text;
    }
    void compile(Text text) {
        tried_ = seen_ = text.whole;
        if (text.error) throw *text.error;
        // Into the same Program: a lab may hold a reference to it.
        program_ = Program(text.sources);
        made_of_ = std::move(text.whole);
    }

    std::vector<fs::path> stages_;
    std::vector<std::string> defines_;
    std::optional<Program> program_;
    std::string made_of_, tried_, looked_at_, seen_;
    std::optional<Error> error_;
    int renewals_ = 0;
};

Programs::Programs(std::initializer_list<const char*> stages) : stages_(stages.begin(), stages.end()) {}
Programs::Programs(Programs&&) noexcept = default;
Programs& Programs::operator=(Programs&&) noexcept = default;
Programs::~Programs() = default;

const Program& Programs::with(std::initializer_list<Define> defines) const {
    std::vector<std::string> key;
    for (const Define& define : defines)
        for (const std::string& text : {define.text, define.second})
            if (!text.empty()) key.push_back(text);
    std::unique_ptr<Permutation>& permutation = permutations_[key];
    if (!permutation) {
        std::vector<fs::path> paths;
        for (const std::string& stage : stages_) paths.push_back(course_root() / "shaders" / stage);
        permutation = std::make_unique<Permutation>(paths, key);
    }
    return permutation->program();
}

int Programs::renewals() const {
    int sum = 0;
    for (const auto& [key, permutation] : permutations_) sum += permutation->renewals();
    return sum;
}

ShaderNews renew_programs() {
    ShaderNews news;
    for (Permutation* const permutation : Permutation::all()) {
        news.changed |= permutation->look();
        if (!news.error && permutation->error()) news.error = permutation->error();
    }
    return news;
}

}  // namespace relief
