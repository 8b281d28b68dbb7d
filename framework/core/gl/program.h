// Shader programs from files, in the permutations that a lab uses.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/gl/object.h"
#include "framework/core/gl/shader_source.h"

namespace relief {

class CubeTexture;
class Texture;

/// A linked program whose uniforms are set by name. Setting a uniform that this permutation does not use has no effect,
/// if its name begins with u_ or s_. A name that appears in none of the program's files throws Error, which suggests
/// the nearest name.
class Program {
public:
    /// Compiles and links `stages`, paths whose extension names the stage: .vert .tesc .tese .geom .frag. Throws Error
    /// with the file and line of the first mistake, and the whole log as details.
    Program(const std::vector<std::filesystem::path>& stages, const std::vector<std::string>& defines);
    /// Compiles and links stages whose text is already loaded.
    explicit Program(std::vector<ShaderSource> stages);

    operator GLuint() const { return name_; }

    // Precondition of all set(): the program is in use (glUseProgram).
    void set(const char* uniform, bool value) const;
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, double value) const;
    void set(const char* uniform, const glm::vec2& value) const;
    void set(const char* uniform, const glm::ivec2& value) const;
    void set(const char* uniform, const glm::vec3& value) const;
    void set(const char* uniform, const glm::vec4& value) const;
    void set(const char* uniform, const glm::dvec3& value) const { set(uniform, glm::vec3(value)); }
    void set(const char* uniform, const glm::mat3& value) const;
    void set(const char* uniform, const glm::mat4& value) const;
    void set(const char* uniform, const glm::dmat4& value) const { set(uniform, glm::mat4(value)); }
    /// Binds the texture to a unit and sets the sampler to that unit. Does nothing if this permutation does not use the
    /// sampler, so the texture is not loaded.
    void set(const char* sampler, int unit, const Texture& texture) const;
    void set(const char* sampler, int unit, const CubeTexture& texture) const;

private:
    GLint location(const char* uniform) const;  ///< -1 if the uniform is not in use

    ProgramName name_;
    std::string title_;
    std::set<std::string> known_;
    std::map<std::string, GLint, std::less<>> locations_;
};

/// While it lives, `rewrite` may change the text of a program's stages before they are compiled. It also gets the name
/// of the program. At most one ShaderRewriting at a time.
class ShaderRewriting {
public:
    using Rewrite = std::function<void(std::vector<ShaderSource>& stages, GLuint program)>;
    explicit ShaderRewriting(Rewrite rewrite);
    ~ShaderRewriting();
    ShaderRewriting(const ShaderRewriting&) = delete;
    ShaderRewriting& operator=(const ShaderRewriting&) = delete;
};

/// A preprocessor definition, "NAME" or "NAME VALUE", and maybe a second one that goes with it. An empty text defines
/// nothing.
struct Define {
    std::string text, second;
    Define(const char* definition) : text(definition) {}
    Define(std::string definition, std::string with_it = {})
        : text(std::move(definition)), second(std::move(with_it)) {}
};

class Permutation;

/// The permutations of one set of shader files, each compiled at first use. References returned by with() stay valid
/// for the lifetime of this object, even when renew_programs() recompiles the program.
class Programs {
public:
    /// `stages` are paths below the course's `shaders` folder. Reads no files yet.
    Programs(std::initializer_list<const char*> stages);
    ~Programs();
    Programs(Programs&&) noexcept;
    Programs& operator=(Programs&&) noexcept;
    template <class... Names>
    explicit Programs(const char* first, Names... others) : Programs({first, others...}) {}

    /// Returns the program with these definitions. Throws the same errors as Program's constructor.
    const Program& with(std::initializer_list<Define> defines = {}) const;
    const Program& with(const Define& define) const { return with({define}); }
    /// Returns how often renew_programs() has recompiled one of these programs. Measurements that are kept must be
    /// repeated when it grows.
    int renewals() const;

private:
    std::vector<std::string> stages_;
    mutable std::map<std::vector<std::string>, std::unique_ptr<Permutation>> permutations_;
};

/// Result of renew_programs().
struct ShaderNews {
    bool changed = false;        ///< a file changed since the last call: its programs were, or will be, recompiled
    std::optional<Error> error;  ///< why a program on screen is older than its files; stays until they compile
};

/// Recompiles every used permutation of every live Programs whose files have changed, into the same Program object. If
/// the new text does not compile, the last good program stays in use. Call it a few times a second. A change counts
/// only after two calls in a row have read the same text. So a half-written file is ignored, and so is one that an
/// editor renames and that is missing for a moment.
ShaderNews renew_programs();

}  // namespace relief
