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

#include "framework/base/error.h"
#include "framework/gl/object.h"
#include "framework/gl/shader_source.h"

namespace relief {

class CubeTexture;
class Texture;

/// A linked program. Uniforms are set by name: one that this permutation does not use is skipped, one that
/// is in none of the program's files throws Error and suggests the nearest name.
class Program {
public:
    /// Compiles and links `stages` (paths; the ending says which stage: .vert .tesc .tese .geom .frag).
    /// Throws Error with the file and line of the first mistake, and the whole log as details.
    Program(const std::vector<std::filesystem::path>& stages, const std::vector<std::string>& defines);
    /// The same from text that is read already.
    explicit Program(std::vector<ShaderSource> stages);

    operator GLuint() const { return name_; }

    // These set the program that is in use: call glUseProgram first.
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
    /// Binds the texture to a unit and points the sampler at it. A sampler that this permutation does not use
    /// loads no texture.
    void set(const char* sampler, int unit, const Texture& texture) const;
    void set(const char* sampler, int unit, const CubeTexture& texture) const;

private:
    GLint location(const char* uniform) const;  ///< -1 when not in use

    ProgramName name_;
    std::string title_;
    std::set<std::string> known_;
    std::map<std::string, GLint, std::less<>> locations_;
};

/// While this lives, programs are made of what `rewrite` makes of the text of their stages; it is told the program's
/// name. One at a time.
class ShaderRewriting {
public:
    using Rewrite = std::function<void(std::vector<ShaderSource>& stages, GLuint program)>;
    explicit ShaderRewriting(Rewrite rewrite);
    ~ShaderRewriting();
    ShaderRewriting(const ShaderRewriting&) = delete;
    ShaderRewriting& operator=(const ShaderRewriting&) = delete;
};

/// One preprocessor definition, "NAME" or "NAME VALUE"; an empty one stands for none.
struct Define {
    std::string text;
    Define(const char* definition) : text(definition) {}
    Define(std::string definition) : text(std::move(definition)) {}
};

class Permutation;

/// The permutations of one set of shader files, each compiled when it is first used. What with() returned stays valid
/// as long as this object, also when its files change: see renew_programs().
class Programs {
public:
    /// Paths below the course's `shaders` folder. Nothing is read yet.
    Programs(std::initializer_list<const char*> stages);
    ~Programs();
    Programs(Programs&&) noexcept;
    Programs& operator=(Programs&&) noexcept;
    template <class... Names>
    explicit Programs(const char* first, Names... others) : Programs({first, others...}) {}

    /// The program with these definitions. Throws what Program's constructor throws.
    const Program& with(std::initializer_list<Define> defines = {}) const;
    const Program& with(const Define& define) const { return with({define}); }
    /// How often renew_programs() has compiled one of them anew: for values that are measured with them, and kept.
    int renewals() const;

private:
    std::vector<std::string> stages_;
    mutable std::map<std::vector<std::string>, std::unique_ptr<Permutation>> permutations_;
};

/// The result of looking for saved shader files.
struct ShaderNews {
    bool changed = false;        ///< since the call before, something was compiled anew or is to be tried again
    std::optional<Error> error;  ///< why a program on screen is older than its files; stays until they are mended
};

/// Looks at the files of every permutation in use, in every Programs that lives, and compiles what reads differently
/// into the same Program. One that does not compile leaves the last good program in place. Call it a few times a
/// second: a text counts when two calls in a row saw it, so that a file which is half written, or away for a moment
/// while an editor renames, is no news.
ShaderNews renew_programs();

}  // namespace relief
