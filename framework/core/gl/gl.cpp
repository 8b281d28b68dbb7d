#include "framework/core/gl/gl.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/draw_watch.h"

namespace relief {
namespace {

DrawWatch::Watch& draw_watch() {
    static DrawWatch::Watch watch;
    return watch;
}

// Each template below replaces one of glad's function pointers by a function that counts, then calls the original.

template <auto& pointer>
using PointerOf = std::remove_reference_t<decltype(pointer)>;

template <auto& pointer, GlKind kind>
struct CountGenerated {
    static inline PointerOf<pointer> real;
    static void GLAD_API_PTR call(GLsizei count, GLuint* names) {
        real(count, names);
        counters().live[int(kind)] += std::max(0, count);
    }
};

template <auto& pointer, GlKind kind>
struct CountDeleted {
    static inline PointerOf<pointer> real;
    static void GLAD_API_PTR call(GLsizei count, const GLuint* names) {
        for (GLsizei i = 0; i < count; ++i) counters().live[int(kind)] -= names[i] != 0;
        real(count, names);
    }
};

template <auto& pointer, class Function>
struct CountDrawImpl;
template <auto& pointer, class... Arguments>
struct CountDrawImpl<pointer, void(GLAD_API_PTR*)(Arguments...)> {
    static inline PointerOf<pointer> real;
    static void GLAD_API_PTR call(Arguments... arguments) {
        ++counters().draw_calls;
        if (draw_watch())
            draw_watch()([&] { real(arguments...); });
        else
            real(arguments...);
    }
};
template <auto& pointer>
using CountDraw = CountDrawImpl<pointer, PointerOf<pointer>>;

template <auto& pointer>
struct CountCreatedProgram {
    static inline PointerOf<pointer> real;
    static GLuint GLAD_API_PTR call() {
        ++counters().live[int(GlKind::program)];
        return real();
    }
};
template <auto& pointer>
struct CountLink {
    static inline PointerOf<pointer> real;
    static void GLAD_API_PTR call(GLuint program) {
        ++counters().links;
        real(program);
    }
};
template <auto& pointer>
struct CountCreatedShader {
    static inline PointerOf<pointer> real;
    static GLuint GLAD_API_PTR call(GLenum stage) {
        ++counters().live[int(GlKind::shader)];
        return real(stage);
    }
};
template <auto& pointer, GlKind kind>
struct CountDeletedOne {
    static inline PointerOf<pointer> real;
    static void GLAD_API_PTR call(GLuint name) {
        counters().live[int(kind)] -= name != 0;
        real(name);
    }
};

template <class Counter>
void put_in_front(PointerOf<Counter::real>& pointer) {
    Counter::real = pointer;
    pointer = Counter::call;
}

void count_calls() {
    put_in_front<CountGenerated<glad_glGenBuffers, GlKind::buffer>>(glad_glGenBuffers);
    put_in_front<CountDeleted<glad_glDeleteBuffers, GlKind::buffer>>(glad_glDeleteBuffers);
    put_in_front<CountGenerated<glad_glGenVertexArrays, GlKind::vertex_array>>(glad_glGenVertexArrays);
    put_in_front<CountDeleted<glad_glDeleteVertexArrays, GlKind::vertex_array>>(glad_glDeleteVertexArrays);
    put_in_front<CountGenerated<glad_glGenTextures, GlKind::texture>>(glad_glGenTextures);
    put_in_front<CountDeleted<glad_glDeleteTextures, GlKind::texture>>(glad_glDeleteTextures);
    put_in_front<CountGenerated<glad_glGenFramebuffers, GlKind::framebuffer>>(glad_glGenFramebuffers);
    put_in_front<CountDeleted<glad_glDeleteFramebuffers, GlKind::framebuffer>>(glad_glDeleteFramebuffers);
    put_in_front<CountGenerated<glad_glGenRenderbuffers, GlKind::renderbuffer>>(glad_glGenRenderbuffers);
    put_in_front<CountDeleted<glad_glDeleteRenderbuffers, GlKind::renderbuffer>>(glad_glDeleteRenderbuffers);
    put_in_front<CountGenerated<glad_glGenQueries, GlKind::query>>(glad_glGenQueries);
    put_in_front<CountDeleted<glad_glDeleteQueries, GlKind::query>>(glad_glDeleteQueries);
    put_in_front<CountGenerated<glad_glGenSamplers, GlKind::sampler>>(glad_glGenSamplers);
    put_in_front<CountDeleted<glad_glDeleteSamplers, GlKind::sampler>>(glad_glDeleteSamplers);
    put_in_front<CountGenerated<glad_glGenProgramPipelines, GlKind::pipeline>>(glad_glGenProgramPipelines);
    put_in_front<CountDeleted<glad_glDeleteProgramPipelines, GlKind::pipeline>>(glad_glDeleteProgramPipelines);
    put_in_front<CountGenerated<glad_glGenTransformFeedbacks, GlKind::transform_feedback>>(
        glad_glGenTransformFeedbacks);
    put_in_front<CountDeleted<glad_glDeleteTransformFeedbacks, GlKind::transform_feedback>>(
        glad_glDeleteTransformFeedbacks);
    put_in_front<CountCreatedProgram<glad_glCreateProgram>>(glad_glCreateProgram);
    put_in_front<CountDeletedOne<glad_glDeleteProgram, GlKind::program>>(glad_glDeleteProgram);
    put_in_front<CountLink<glad_glLinkProgram>>(glad_glLinkProgram);
    put_in_front<CountCreatedShader<glad_glCreateShader>>(glad_glCreateShader);
    put_in_front<CountDeletedOne<glad_glDeleteShader, GlKind::shader>>(glad_glDeleteShader);

    put_in_front<CountDraw<glad_glDrawArrays>>(glad_glDrawArrays);
    put_in_front<CountDraw<glad_glDrawArraysInstanced>>(glad_glDrawArraysInstanced);
    put_in_front<CountDraw<glad_glDrawElements>>(glad_glDrawElements);
    put_in_front<CountDraw<glad_glDrawElementsBaseVertex>>(glad_glDrawElementsBaseVertex);
    put_in_front<CountDraw<glad_glDrawElementsInstanced>>(glad_glDrawElementsInstanced);
    put_in_front<CountDraw<glad_glDrawElementsInstancedBaseVertex>>(glad_glDrawElementsInstancedBaseVertex);
    put_in_front<CountDraw<glad_glDrawRangeElements>>(glad_glDrawRangeElements);
    put_in_front<CountDraw<glad_glMultiDrawArrays>>(glad_glMultiDrawArrays);
    put_in_front<CountDraw<glad_glMultiDrawElements>>(glad_glMultiDrawElements);
    put_in_front<CountDraw<glad_glDrawArraysIndirect>>(glad_glDrawArraysIndirect);
    put_in_front<CountDraw<glad_glDrawElementsIndirect>>(glad_glDrawElementsIndirect);
    put_in_front<CountDraw<glad_glDrawTransformFeedback>>(glad_glDrawTransformFeedback);
}

std::vector<std::string>& caught_errors() {
    static std::vector<std::string> errors;
    return errors;
}

void GLAD_API_PTR on_message(GLenum source, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* text,
                             const void*) {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;  // Program reports these with their place
    // A mistake in a loop must not fill the memory; the first few errors are enough.
    if (type == GL_DEBUG_TYPE_ERROR && caught_errors().size() < 8) caught_errors().emplace_back(text, length);
}

const char* name_of(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "an unknown GL error";
    }
}

}  // namespace

DrawWatch::DrawWatch(Watch watch) { draw_watch() = std::move(watch); }
DrawWatch::~DrawWatch() { draw_watch() = {}; }

Counters& counters() {
    static Counters all;
    return all;
}

void load_gl(LoadFunction* load) {
    const int version = gladLoadGL(load);
    if (version == 0) throw Error("the context has no OpenGL functions");
    if (version < GLAD_MAKE_VERSION(4, 1))
        throw Error(fmt::format("the context has OpenGL {}.{}: the course needs 4.1", GLAD_VERSION_MAJOR(version),
                                GLAD_VERSION_MINOR(version)));
    count_calls();
}

namespace {
bool comparably = false;
}
void draw_comparably() { comparably = true; }
bool draws_comparably() { return comparably; }
ComparableDrawing::~ComparableDrawing() { comparably = before_; }

bool is_software_renderer() {
    const std::string_view renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos;
}

void label(GLenum kind, GLuint name, const std::string& text) {
    if (GLAD_GL_KHR_debug && !text.empty()) glObjectLabel(kind, name, GLsizei(text.size()), text.c_str());
}

void watch_errors() {
    if (!GLAD_GL_KHR_debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, nullptr);
}

std::string take_gl_errors() {
    std::string line;
    // A lost context may return errors endlessly.
    for (int i = 0; i < 8; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        if (caught_errors().empty()) line += (line.empty() ? "" : "; ") + std::string(name_of(error));
    }
    for (const std::string& text : caught_errors()) line += (line.empty() ? "" : "; ") + text;
    caught_errors().clear();
    return line;
}

}  // namespace relief
