#include "framework/course/web/webgl.h"

#include <emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/gl/gl.h"
#include "framework/course/web/es_shader.h"
#include "framework/course/web/patch_drawing.h"

extern "C" void* emscripten_webgl_get_proc_address(const char* name);

namespace relief::web {
namespace {

/// Returns WebGL's own function of the type of one of glad's pointers.
template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(emscripten_webgl_get_proc_address(name));
}
// The first call in a function finds WebGL's function of the same name.
#define RELIEF_REAL(name) static const auto real_##name = real<decltype(glad_##name)>(#name)

// --- State -----------------------------------------------------------------------------------------------------------

const GLubyte* get_string(GLenum name) {
    RELIEF_REAL(glGetString);
    // glad takes only what this version has.
    return name == GL_VERSION ? reinterpret_cast<const GLubyte*>("4.1 (WebGL 2)") : real_glGetString(name);
}

void get_integerv(GLenum name, GLint* value) {
    RELIEF_REAL(glGetIntegerv);
    if (name == GL_MAX_COLOR_TEXTURE_SAMPLES)
        *value = 1;  // several samples are in renderbuffers only
    else if (name == GL_MAX_PATCH_VERTICES || name == GL_MAX_TESS_GEN_LEVEL)
        *value = 0;
    else
        real_glGetIntegerv(name, value);
}

bool is_capability_of_es(GLenum capability) {
    constexpr GLenum known[] = {GL_BLEND,
                                GL_CULL_FACE,
                                GL_DEPTH_TEST,
                                GL_DITHER,
                                GL_POLYGON_OFFSET_FILL,
                                GL_RASTERIZER_DISCARD,
                                GL_SAMPLE_ALPHA_TO_COVERAGE,
                                GL_SAMPLE_COVERAGE,
                                GL_SCISSOR_TEST,
                                GL_STENCIL_TEST};
    return std::find(std::begin(known), std::end(known), capability) != std::end(known);
}
void enable(GLenum capability) {
    RELIEF_REAL(glEnable);
    if (is_capability_of_es(capability)) real_glEnable(capability);
}
void disable(GLenum capability) {
    RELIEF_REAL(glDisable);
    if (is_capability_of_es(capability)) real_glDisable(capability);
}
GLboolean is_enabled(GLenum capability) {
    RELIEF_REAL(glIsEnabled);
    return is_capability_of_es(capability) ? real_glIsEnabled(capability) : GLboolean(GL_FALSE);
}

void provoking_vertex(GLenum) {}

void clear_depth(GLdouble depth) { real<void (*)(GLfloat)>("glClearDepthf")(GLfloat(depth)); }
void depth_range(GLdouble nearest, GLdouble farthest) {
    real<void (*)(GLfloat, GLfloat)>("glDepthRangef")(GLfloat(nearest), GLfloat(farthest));
}
void draw_buffer(GLenum buffer) {
    RELIEF_REAL(glDrawBuffers);
    real_glDrawBuffers(1, &buffer);
}

EM_JS(void, set_blend_function_of, (unsigned buffer, unsigned source, unsigned destination), {
    const extension = GL.currentContext.GLctx.getExtension('OES_draw_buffers_indexed');
    if (extension) extension.blendFunciOES(buffer, source, destination);
});
void blend_func_i(GLuint buffer, GLenum source, GLenum destination) {
    set_blend_function_of(buffer, source, destination);
}

// --- Textures and pixels ---------------------------------------------------------------------------------------------

size_t channels_of(GLenum format) {
    switch (format) {
        case GL_RED:
        case GL_R8:
        case GL_R16F:
        case GL_R32F:
            return 1;
        case GL_RG:
        case GL_RG8:
        case GL_RG16F:
        case GL_RG32F:
            return 2;
        case GL_RGB:
        case GL_RGB8:
        case GL_SRGB8:
        case GL_RGB16F:
        case GL_RGB32F:
            return 3;
        default:
            return 4;
    }
}

GLenum format_of_channels(size_t channels) {
    constexpr GLenum formats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    return formats[channels - 1];
}

/// Returns the float format of a 16-bit normalised one, or 0.
GLenum float_format_of(GLenum internal) {
    switch (internal) {
        case GL_R16:
            return GL_R32F;
        case GL_RG16:
            return GL_RG32F;
        case GL_RGB16:
            return GL_RGB32F;
        case GL_RGBA16:
            return GL_RGBA32F;
        default:
            return 0;
    }
}

/// The arguments of an upload, in a combination that ES accepts.
struct Upload {
    GLenum internal, format, type;
    const void* data;
    std::vector<float> values = {};  ///< `data` refers to them if they were converted
};

Upload upload_of(GLint internal, GLenum format, GLenum type, const void* data, size_t pixels) {
    Upload upload{GLenum(internal), format, type, data};
    if (const GLenum floats = float_format_of(upload.internal)) {
        upload.internal = floats;
        upload.type = GL_FLOAT;
        if (data && type == GL_UNSIGNED_SHORT) {
            const auto* from = static_cast<const uint16_t*>(data);
            upload.values.reserve(pixels * channels_of(format));
            for (size_t i = 0; i < pixels * channels_of(format); ++i)
                upload.values.push_back(float(from[i]) / 65535.0f);
            upload.data = upload.values.data();
        }
    }
    const bool is_bytes = upload.internal == GL_RGBA8 || upload.internal == GL_SRGB8_ALPHA8;
    if (!data && is_bytes) upload.type = GL_UNSIGNED_BYTE;  // any type will do: there are no values
    // ES wants as many channels as the texture has.
    const size_t given = channels_of(format), kept = channels_of(upload.internal);
    if (upload.type == GL_FLOAT && kept < given) {
        upload.format = format_of_channels(kept);
        if (data) {
            const auto* from = static_cast<const float*>(upload.data);
            std::vector<float> values;
            values.reserve(pixels * kept);
            for (size_t i = 0; i < pixels; ++i) values.insert(values.end(), from + i * given, from + i * given + kept);
            upload.values = std::move(values);
            upload.data = upload.values.data();
        }
    }
    return upload;
}

void tex_image_2d(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border,
                  GLenum format, GLenum type, const void* data) {
    RELIEF_REAL(glTexImage2D);
    const Upload upload = upload_of(internal, format, type, data, size_t(width) * size_t(height));
    real_glTexImage2D(target, level, GLint(upload.internal), width, height, border, upload.format, upload.type,
                      upload.data);
}
void tex_image_3d(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLsizei depth,
                  GLint border, GLenum format, GLenum type, const void* data) {
    RELIEF_REAL(glTexImage3D);
    const size_t pixels = size_t(width) * size_t(height) * size_t(depth);
    const Upload upload = upload_of(internal, format, type, data, pixels);
    real_glTexImage3D(target, level, GLint(upload.internal), width, height, depth, border, upload.format, upload.type,
                      upload.data);
}
void tex_parameteri(GLenum target, GLenum name, GLint value) {
    RELIEF_REAL(glTexParameteri);
    real_glTexParameteri(target, name, value == GL_CLAMP_TO_BORDER ? GL_CLAMP_TO_EDGE : value);
}
void tex_parameterfv(GLenum target, GLenum name, const GLfloat* values) {
    RELIEF_REAL(glTexParameterfv);
    if (name != GL_TEXTURE_BORDER_COLOR) real_glTexParameterfv(target, name, values);
}

void read_pixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* data) {
    RELIEF_REAL(glReadPixels);
    const size_t channels = channels_of(format), pixels = size_t(width) * size_t(height);
    if (channels == 4 || type != GL_FLOAT) return real_glReadPixels(x, y, width, height, format, type, data);
    std::vector<float> values(pixels * 4);  // ES reads floats with four channels only
    real_glReadPixels(x, y, width, height, GL_RGBA, GL_FLOAT, values.data());
    auto* to = static_cast<float*>(data);
    for (size_t i = 0; i < pixels; ++i) to = std::copy_n(&values[i * 4], channels, to);
}

// --- Shaders ---------------------------------------------------------------------------------------------------------

GLuint create_shader(GLenum stage) {
    RELIEF_REAL(glCreateShader);
    if (stage != GL_VERTEX_SHADER && stage != GL_FRAGMENT_SHADER)
        throw Error("this view draws with a geometry stage, which no browser has: start the lab on your computer");
    return real_glCreateShader(stage);
}

std::function<std::string()>& text_of_task() {
    static std::function<std::string()> text = [] { return std::string(); };
    return text;
}

void shader_source(GLuint shader, GLsizei, const GLchar* const* text, const GLint*) {
    RELIEF_REAL(glShaderSource);
    RELIEF_REAL(glGetShaderiv);
    GLint stage = 0;
    real_glGetShaderiv(shader, GL_SHADER_TYPE, &stage);
    const std::string converted =
        es_shader(*text, stage == GL_VERTEX_SHADER ? EsStage::vertex : EsStage::fragment, text_of_task()());
    const GLchar* const begin = converted.c_str();
    real_glShaderSource(shader, 1, &begin, nullptr);
}

/// Sets a uniform of doubles with the function for floats. `count` is the number of its values.
template <class Set>
void set_rounded(const GLdouble* values, size_t count, Set set) {
    GLfloat floats[9] = {};
    std::transform(values, values + count, floats, [](GLdouble value) { return GLfloat(value); });
    set(floats);
}
void uniform_2dv(GLint place, GLsizei, const GLdouble* values) {
    set_rounded(values, 2, [&](const GLfloat* floats) { glUniform2fv(place, 1, floats); });
}
void uniform_3dv(GLint place, GLsizei, const GLdouble* values) {
    set_rounded(values, 3, [&](const GLfloat* floats) { glUniform3fv(place, 1, floats); });
}
void uniform_matrix_3dv(GLint place, GLsizei, GLboolean transpose, const GLdouble* values) {
    set_rounded(values, 9, [&](const GLfloat* floats) { glUniformMatrix3fv(place, 1, transpose, floats); });
}

/// Twice the length of the log leaves room for es_log()'s additions.
void get_shaderiv(GLuint shader, GLenum name, GLint* value) {
    RELIEF_REAL(glGetShaderiv);
    real_glGetShaderiv(shader, name, value);
    if (name == GL_INFO_LOG_LENGTH) *value *= 2;
}
void get_shader_info_log(GLuint shader, GLsizei size, GLsizei* length, GLchar* text) {
    RELIEF_REAL(glGetShaderInfoLog);
    if (size <= 0) return;
    std::string log(size_t(size), '\0');
    GLsizei read = 0;
    real_glGetShaderInfoLog(shader, size, &read, log.data());
    log.resize(size_t(read));
    log = es_log(log);
    log.resize(std::min(log.size(), size_t(size) - 1));
    std::copy(log.begin(), log.end(), text);
    text[log.size()] = '\0';
    if (length) *length = GLsizei(log.size());
}

// --- Moved vertices --------------------------------------------------------------------------------------------------

glm::vec2 moved_by{0}, viewport_size{1};
bool have_moved = false;  ///< until then the uniforms of all programs are 0

void move_program() {
    GLint program = 0, place = -1;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    if (program != 0) place = glGetUniformLocation(GLuint(program), "relief_move");
    if (place >= 0) glUniform2f(place, 2 * moved_by.x / viewport_size.x, 2 * moved_by.y / viewport_size.y);
}
void use_program(GLuint program) {
    RELIEF_REAL(glUseProgram);
    real_glUseProgram(program);
    if (have_moved) move_program();
}
void viewport(GLint x, GLint y, GLsizei width, GLsizei height) {
    RELIEF_REAL(glViewport);
    real_glViewport(x, y, width, height);
    viewport_size = {width, height};
    if (have_moved) move_program();
}

// ---------------------------------------------------------------------------------------------------------------------

GLADapiproc load(const char* name) {
    const auto of = [](auto* function) { return reinterpret_cast<GLADapiproc>(function); };
    static const std::map<std::string_view, GLADapiproc> ours = {
        {"glBlendFunci", of(blend_func_i)},
        {"glClearDepth", of(clear_depth)},
        {"glCreateShader", of(create_shader)},
        {"glDepthRange", of(depth_range)},
        {"glDisable", of(disable)},
        {"glDrawBuffer", of(draw_buffer)},
        {"glEnable", of(enable)},
        {"glGetIntegerv", of(get_integerv)},
        {"glGetShaderInfoLog", of(get_shader_info_log)},
        {"glGetShaderiv", of(get_shaderiv)},
        {"glGetString", of(get_string)},
        {"glIsEnabled", of(is_enabled)},
        {"glProvokingVertex", of(provoking_vertex)},
        {"glReadPixels", of(read_pixels)},
        {"glShaderSource", of(shader_source)},
        {"glTexImage2D", of(tex_image_2d)},
        {"glTexImage3D", of(tex_image_3d)},
        {"glTexParameterfv", of(tex_parameterfv)},
        {"glTexParameteri", of(tex_parameteri)},
        {"glUniform2dv", of(uniform_2dv)},
        {"glUniform3dv", of(uniform_3dv)},
        {"glUniformMatrix3dv", of(uniform_matrix_3dv)},
        {"glUseProgram", of(use_program)},
        {"glViewport", of(viewport)},
    };
    const auto found = ours.find(name);
    return patch_drawing(name, found != ours.end() ? found->second : of(emscripten_webgl_get_proc_address(name)));
}

}  // namespace

void open_webgl(const char* canvas) {
    EmscriptenWebGLContextAttributes attributes_of_context;
    emscripten_webgl_init_context_attributes(&attributes_of_context);
    attributes_of_context.majorVersion = 2;
    attributes_of_context.alpha = attributes_of_context.depth = attributes_of_context.antialias = false;
    attributes_of_context.preserveDrawingBuffer = true;  // a frame is drawn only when something has changed
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context(canvas, &attributes_of_context);
    if (context <= 0) throw Error("this browser has no WebGL 2");
    emscripten_webgl_make_context_current(context);
    for (const char* extension : {"EXT_color_buffer_float", "OES_texture_float_linear"})
        if (!emscripten_webgl_enable_extension(context, extension))
            throw Error(std::string("this browser's WebGL 2 lacks ") + extension);
    emscripten_webgl_enable_extension(context, "WEBGL_debug_renderer_info");
    emscripten_webgl_enable_extension(context, "EXT_float_blend");  // for the probe `winding`, which sums up
    load_gl(load);
    GLAD_GL_EXT_texture_filter_anisotropic = 0;
}

void limit_loops(std::function<std::string()> text) { text_of_task() = std::move(text); }

void move_vertices(glm::vec2 pixels) {
    moved_by = pixels;
    have_moved = true;
}

std::string renderer_name() {
    constexpr GLenum unmasked_renderer = 0x9246;
    const auto* name = reinterpret_cast<const char*>(glGetString(unmasked_renderer));
    if (glGetError() != GL_NO_ERROR || !name) name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name;
}

}  // namespace relief::web
