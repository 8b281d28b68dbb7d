// RAII owners of GL names: created with the object, movable, deleted with it.
#pragma once

#include <utility>

#include "framework/core/gl/gl.h"

namespace relief {

/// `Kind` has `static GLuint make()` and `static void drop(GLuint)`.
template <class Kind>
class GlObject {
public:
    template <class... Arguments>
    explicit GlObject(Arguments... arguments) : name_(Kind::make(arguments...)) {}
    ~GlObject() {
        if (name_) Kind::drop(name_);
    }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
};

#define RELIEF_GL_OBJECT(Type, Gen, Delete)                 \
    struct Type##Kind {                                     \
        static GLuint make() {                              \
            GLuint name = 0;                                \
            Gen(1, &name);                                  \
            return name;                                    \
        }                                                   \
        static void drop(GLuint name) { Delete(1, &name); } \
    };                                                      \
    using Type = GlObject<Type##Kind>

RELIEF_GL_OBJECT(BufferName, glGenBuffers, glDeleteBuffers);
RELIEF_GL_OBJECT(VertexArrayName, glGenVertexArrays, glDeleteVertexArrays);
RELIEF_GL_OBJECT(TextureName, glGenTextures, glDeleteTextures);
RELIEF_GL_OBJECT(FramebufferName, glGenFramebuffers, glDeleteFramebuffers);
RELIEF_GL_OBJECT(RenderbufferName, glGenRenderbuffers, glDeleteRenderbuffers);
RELIEF_GL_OBJECT(QueryName, glGenQueries, glDeleteQueries);
#undef RELIEF_GL_OBJECT

struct ProgramKind {
    static GLuint make() { return glCreateProgram(); }
    static void drop(GLuint name) { glDeleteProgram(name); }
};
using ProgramName = GlObject<ProgramKind>;

struct ShaderKind {
    static GLuint make(GLenum stage) { return glCreateShader(stage); }
    static void drop(GLuint name) { glDeleteShader(name); }
};
using ShaderName = GlObject<ShaderKind>;

}  // namespace relief
