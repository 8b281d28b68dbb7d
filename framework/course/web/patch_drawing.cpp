#include "framework/course/web/patch_drawing.h"

#include <emscripten.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/gl/object.h"
#include "framework/course/web/patch_shader.h"
#include "framework/course/web/tessellator.h"

namespace relief::web {
namespace {

/// The functions whose place is taken.
struct Below {
    decltype(glad_glAttachShader) attach_shader;
    decltype(glad_glBeginQuery) begin_query;
    decltype(glad_glCreateShader) create_shader;
    decltype(glad_glDeleteProgram) delete_program;
    decltype(glad_glDeleteShader) delete_shader;
    decltype(glad_glDetachShader) detach_shader;
    decltype(glad_glDrawArrays) draw_arrays;
    decltype(glad_glEndQuery) end_query;
    decltype(glad_glGetQueryObjectiv) get_query_objectiv;
    decltype(glad_glGetUniformLocation) get_uniform_location;
    decltype(glad_glLinkProgram) link_program;
    decltype(glad_glShaderSource) shader_source;
    decltype(glad_glUseProgram) use_program;
} below;

EM_JS(void, read_captured, (float* to, int count), {
    GL.currentContext.GLctx.getBufferSubData(0x8C8E, 0, HEAPF32, to >> 2, count);  // GL_TRANSFORM_FEEDBACK_BUFFER
});

GLuint bound(GLenum kind) {
    GLint name = 0;
    glGetIntegerv(kind, &name);
    return GLuint(name);
}

// --- Shaders and programs --------------------------------------------------------------------------------------------

/// A stage of a program with tessellation, by the name of its shader; for other programs only vertex stages.
struct Stage {
    GLenum kind = GL_VERTEX_SHADER;
    std::string text;  ///< of a vertex stage, in GLSL 4.10
    PatchShader patch;
};
std::map<GLuint, Stage> stages;
/// The shaders of the programs that are not linked yet.
std::map<GLuint, std::vector<GLuint>> attached;

/// A uniform of a program with tessellation, in the programs that it becomes; -1 where it is not in use.
struct Place {
    GLint drawing, control;
};
constexpr GLint first_place = 1 << 24;  // far beyond WebGL's own

/// A program with tessellation. Its name is that of the evaluation and the fragment stage.
struct PatchProgram {
    ProgramName vertex, control;
    PatchShader vertex_stage, control_stage, evaluation_stage;
    std::vector<Place> places;
    std::map<std::string, GLint> numbers;  ///< the indices of `places` by the uniforms' names
};
std::map<GLuint, std::unique_ptr<PatchProgram>> patch_programs;
GLuint used_program = 0;

PatchProgram* patch_program(GLuint name) {
    const auto found = patch_programs.find(name);
    return found == patch_programs.end() ? nullptr : found->second.get();
}

GLuint create_stage(GLenum kind) {
    const bool is_of_patch = kind == GL_TESS_CONTROL_SHADER || kind == GL_TESS_EVALUATION_SHADER;
    const GLuint shader = below.create_shader(is_of_patch ? GL_VERTEX_SHADER : kind);
    stages.erase(shader);
    if (kind != GL_FRAGMENT_SHADER) stages[shader].kind = kind;
    return shader;
}

void set_stage_text(GLuint shader, GLsizei count, const GLchar* const* text, const GLint* lengths) {
    const auto found = stages.find(shader);
    if (found == stages.end()) return below.shader_source(shader, count, text, lengths);
    Stage& stage = found->second;
    if (stage.kind == GL_VERTEX_SHADER) {
        stage.text = *text;
        return below.shader_source(shader, count, text, lengths);
    }
    stage.patch =
        patch_shader(*text, stage.kind == GL_TESS_CONTROL_SHADER ? PatchStage::control : PatchStage::evaluation);
    const GLchar* const begin = stage.patch.text.c_str();
    below.shader_source(shader, 1, &begin, nullptr);
}

void delete_stage(GLuint shader) {
    stages.erase(shader);
    below.delete_shader(shader);
}

/// Returns the kind of a shader that is kept in `stages`, or 0.
GLenum kind_of(GLuint shader) {
    const auto found = stages.find(shader);
    return found == stages.end() ? 0 : found->second.kind;
}

/// WebGL's program has one vertex stage: that of the evaluation stage, if there is one.
void attach_stage(GLuint program, GLuint shader) {
    std::vector<GLuint>& shaders = attached[program];
    shaders.push_back(shader);
    const GLenum kind = kind_of(shader);
    if (kind == GL_TESS_EVALUATION_SHADER)
        for (const GLuint other : shaders)
            if (kind_of(other) == GL_VERTEX_SHADER) below.detach_shader(program, other);
    if (kind != GL_TESS_CONTROL_SHADER) below.attach_shader(program, shader);
}
void detach_stage(GLuint program, GLuint shader) {
    std::erase(attached[program], shader);
    const GLenum kind = kind_of(shader);
    const bool is_attached =
        kind != GL_TESS_CONTROL_SHADER && !(kind == GL_VERTEX_SHADER && patch_programs.contains(program));
    if (is_attached) below.detach_shader(program, shader);
}

/// Links a vertex stage that writes values.
void link_capture(const ProgramName& program, GLuint vertex, const PatchShader& stage) {
    const ShaderName fragment(GL_FRAGMENT_SHADER);
    const GLchar* const nothing = "#version 410 core\nvoid main() {}\n";
    glShaderSource(fragment, 1, &nothing, nullptr);
    glCompileShader(fragment);
    std::vector<std::string> names;
    std::vector<const GLchar*> texts;
    for (size_t i = 0; i < stage.values; ++i) names.push_back(value_name(i));
    for (const std::string& name : names) texts.push_back(name.c_str());
    below.attach_shader(program, vertex);
    below.attach_shader(program, fragment);
    glTransformFeedbackVaryings(program, GLsizei(texts.size()), texts.data(), GL_INTERLEAVED_ATTRIBS);
    below.link_program(program);
    GLint done = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) {
        char log[1000] = "";
        glGetProgramInfoLog(program, sizeof log, nullptr, log);
        throw Error({}, "in a browser, a stage before the tessellator does not link", log);
    }
    below.detach_shader(program, vertex);
    below.detach_shader(program, fragment);
}

void link_program(GLuint program) {
    std::map<GLenum, GLuint> shaders;
    for (const GLuint shader : attached[program]) shaders[kind_of(shader)] = shader;
    if (!shaders.contains(GL_TESS_CONTROL_SHADER)) return below.link_program(program);
    const GLuint vertex = shaders[GL_VERTEX_SHADER], control = shaders[GL_TESS_CONTROL_SHADER];
    auto made = std::make_unique<PatchProgram>();
    made->vertex_stage = patch_shader(stages[vertex].text, PatchStage::vertex);
    made->control_stage = stages[control].patch;
    made->evaluation_stage = stages[shaders[GL_TESS_EVALUATION_SHADER]].patch;
    if (made->vertex_stage.written != made->control_stage.read ||
        made->control_stage.written != made->evaluation_stage.read)
        throw Error("in a browser, a stage must declare what the stage before it writes, in the same order");
    const ShaderName capturing(GL_VERTEX_SHADER);
    const GLchar* const text = made->vertex_stage.text.c_str();
    below.shader_source(capturing, 1, &text, nullptr);
    glCompileShader(capturing);
    link_capture(made->vertex, capturing, made->vertex_stage);
    link_capture(made->control, control, made->control_stage);
    below.link_program(program);
    patch_programs[program] = std::move(made);
}

void delete_program(GLuint program) {
    attached.erase(program);
    patch_programs.extract(program);  // whose own programs come here, too
    below.delete_program(program);
}

void use_patch_program(GLuint program) { below.use_program(used_program = program); }

GLint get_uniform_location(GLuint program, const GLchar* name) {
    const GLint drawing = below.get_uniform_location(program, name);
    const std::string_view words(name);
    const bool is_of_lab = words.starts_with("u_") || words.starts_with("s_");  // the course's names
    PatchProgram* const patches = is_of_lab ? patch_program(program) : nullptr;
    const GLint control = patches ? below.get_uniform_location(patches->control, name) : -1;
    if (control < 0) return drawing;
    const auto [number, is_new] = patches->numbers.emplace(name, GLint(patches->places.size()));
    if (is_new) patches->places.push_back({drawing, control});
    return first_place + number->second;
}

/// Sets a uniform in each program that has it.
template <auto& pointer, class Function>
struct Uniform;
template <auto& pointer, class... Values>
struct Uniform<pointer, void(GLAD_API_PTR*)(GLint, Values...)> {
    static inline void(GLAD_API_PTR* real)(GLint, Values...) = nullptr;
    static void GLAD_API_PTR set(GLint place, Values... values) {
        if (place < first_place) return real(place, values...);
        const PatchProgram& program = *patch_program(used_program);
        const Place& places = program.places.at(size_t(place - first_place));
        if (places.drawing >= 0) real(places.drawing, values...);
        below.use_program(program.control);
        real(places.control, values...);
        below.use_program(used_program);
    }
};

// --- Drawing ---------------------------------------------------------------------------------------------------------

int patch_vertices = 3;
bool draws_lines = false;

void patch_parameter(GLenum name, GLint value) {
    if (name == GL_PATCH_VERTICES) patch_vertices = value;
}
void polygon_mode(GLenum, GLenum mode) { draws_lines = mode == GL_LINE; }

/// The query of the number of triangles from patches that is running, and the results of all such queries.
GLuint counting = 0;
std::map<GLuint, GLint> counted;

void begin_query(GLenum target, GLuint query) {
    counted.erase(query);
    if (target != GL_PRIMITIVES_GENERATED) return below.begin_query(target, query);
    counting = query;
    counted[query] = 0;
}
void end_query(GLenum target) {
    if (target != GL_PRIMITIVES_GENERATED) return below.end_query(target);
    counting = 0;
}
void get_query_objectiv(GLuint query, GLenum name, GLint* value) {
    const auto found = counted.find(query);
    if (found == counted.end() || name != GL_QUERY_RESULT) return below.get_query_objectiv(query, name, value);
    *value = found->second;
}

/// The points of one tessellation, and the indices of its triangles, then of their edges.
struct UploadedTessellation {
    VertexArrayName layout;
    BufferName points, indices;
    GLsizei triangles = 0;
};

std::unique_ptr<UploadedTessellation> upload(const Tessellation& made) {
    auto result = std::make_unique<UploadedTessellation>();
    std::vector<uint32_t> indices;
    for (const auto& [a, b, c] : made.triangles) indices.insert(indices.end(), {a, b, c});
    for (const auto& [a, b, c] : made.triangles) indices.insert(indices.end(), {a, b, b, c, c, a});
    result->triangles = GLsizei(made.triangles.size());
    glBindVertexArray(result->layout);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, result->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, result->points);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(made.points.size() * sizeof(glm::vec3)), made.points.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(1);
    glVertexAttribDivisor(1, 1);
    return result;
}

/// Returns the tessellation of patches with these levels. Keeps it for other patches, passes and frames.
const UploadedTessellation& tessellation(const PatchShader& stage, const TessellationLevels& levels) {
    using Key = std::tuple<int, TessellationSpacing, TessellationLevels>;
    static std::map<Key, std::unique_ptr<UploadedTessellation>> kept;
    static size_t kept_triangles = 0;
    const Key key(stage.corners, stage.spacing, levels);
    if (const auto found = kept.find(key); found != kept.end()) return *found->second;
    if (kept_triangles > 1'000'000) kept.clear(), kept_triangles = 0;  // 48 MB
    const Tessellation made = tessellate(stage.corners, stage.spacing, levels);
    kept_triangles += 100 + made.triangles.size();
    return *(kept[key] = upload(made));
}

/// What a draw of patches needs besides the tessellations.
struct DrawingObjects {
    VertexArrayName no_attributes;
    BufferName captured, numbers;
    TextureName passed;
};
DrawingObjects& objects() {
    static auto* const all = new DrawingObjects;
    return *all;
}

constexpr GLint passed_unit = 31;

/// Runs a vertex stage that writes values for `count` vertices from `first` on. The result is in the transform feedback
/// buffer and in the texture for the next stage.
void capture(GLuint program, const PatchShader& stage, GLint first, GLsizei count) {
    const auto rows = (GLsizei(stage.values) * count + patch_texels_a_row - 1) / patch_texels_a_row;
    const GLuint buffer = objects().captured;
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, GLsizeiptr(rows) * patch_texels_a_row * GLsizeiptr(sizeof(glm::vec4)),
                 nullptr, GL_STREAM_COPY);
    below.use_program(program);
    const GLint place = below.get_uniform_location(program, "r_passed");
    if (place >= 0) glUniform1i(place, passed_unit);
    glBeginTransformFeedback(GL_POINTS);
    below.draw_arrays(GL_POINTS, first, count);
    glEndTransformFeedback();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, patch_texels_a_row, rows, 0, GL_RGBA, GL_FLOAT, nullptr);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

/// Runs the stages before the tessellator. Returns the numbers of the patches by their levels.
std::map<TessellationLevels, std::vector<float>> run_control(const PatchProgram& program, GLint first, GLsizei count) {
    const bool was_discarding = glIsEnabled(GL_RASTERIZER_DISCARD);
    glEnable(GL_RASTERIZER_DISCARD);
    capture(program.vertex, program.vertex_stage, first, count);
    glBindVertexArray(objects().no_attributes);
    capture(program.control, program.control_stage, 0, count);
    if (!was_discarding) glDisable(GL_RASTERIZER_DISCARD);
    const auto values = size_t(program.control_stage.values);
    std::vector<glm::vec4> written(size_t(count) * values);
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, objects().captured);
    read_captured(&written[0].x, int(4 * written.size()));
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    std::map<TessellationLevels, std::vector<float>> patches;
    const auto corners = size_t(program.control_stage.corners);
    for (size_t patch = 0; patch < size_t(count) / corners; ++patch) {
        const glm::vec4 *const outer = &written[(patch * corners + 1) * values - 2], *const inner = outer + 1;
        TessellationLevels levels{{outer->x, outer->y, outer->z, outer->w}, {inner->x, inner->y}};
        for (float& level : levels.outer) level = std::isnan(level) ? 0 : level;  // they mean the same
        for (float& level : levels.inner) level = std::isnan(level) ? 0 : level;
        patches[levels].push_back(float(patch));
    }
    return patches;
}

void draw_arrays(GLenum mode, GLint first, GLsizei count) {
    if (mode != GL_PATCHES) return below.draw_arrays(mode, first, count);
    const PatchProgram* const program = patch_program(used_program);
    if (!program || patch_vertices != program->control_stage.corners)
        throw Error("in a browser, a patch has as many vertices as its control stage gives it");
    if (count < patch_vertices) return;
    const GLuint layout = bound(GL_VERTEX_ARRAY_BINDING), buffer = bound(GL_ARRAY_BUFFER_BINDING);
    const GLuint unit = bound(GL_ACTIVE_TEXTURE);
    glActiveTexture(GL_TEXTURE0 + passed_unit);
    glBindTexture(GL_TEXTURE_2D, objects().passed);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    const auto patches = run_control(*program, first, count);
    below.use_program(used_program);
    glUniform1i(below.get_uniform_location(used_program, "r_passed"), passed_unit);
    std::vector<float> all;
    for (const auto& [levels, numbers] : patches) all.insert(all.end(), numbers.begin(), numbers.end());
    glBindBuffer(GL_ARRAY_BUFFER, objects().numbers);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(all.size() * sizeof(float)), all.data(), GL_STREAM_DRAW);
    size_t drawn = 0;
    for (const auto& [levels, numbers] : patches) {
        const UploadedTessellation& made = tessellation(program->evaluation_stage, levels);
        const size_t begin = std::exchange(drawn, drawn + numbers.size());
        if (made.triangles == 0) continue;
        if (counting) counted[counting] += made.triangles * GLint(numbers.size());
        glBindVertexArray(made.layout);
        glBindBuffer(GL_ARRAY_BUFFER, objects().numbers);
        glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, 0, reinterpret_cast<const void*>(begin * sizeof(float)));
        const GLsizei indices = 3 * made.triangles;
        if (draws_lines)
            glDrawElementsInstanced(GL_LINES, 2 * indices, GL_UNSIGNED_INT,
                                    reinterpret_cast<const void*>(size_t(indices) * sizeof(uint32_t)),
                                    GLsizei(numbers.size()));
        else
            glDrawElementsInstanced(GL_TRIANGLES, indices, GL_UNSIGNED_INT, nullptr, GLsizei(numbers.size()));
    }
    glActiveTexture(unit);
    glBindVertexArray(layout);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
}

// ---------------------------------------------------------------------------------------------------------------------

struct Hook {
    GLADapiproc function;
    std::function<void(GLADapiproc)> set_below;
};
template <class Function>
Hook hook(Function function, Function& place) {
    return {reinterpret_cast<GLADapiproc>(function),
            [&place](GLADapiproc real) { place = reinterpret_cast<Function>(real); }};
}
template <auto& pointer>
Hook uniform_hook() {
    using Setter = Uniform<pointer, std::remove_reference_t<decltype(pointer)>>;
    return hook(&Setter::set, Setter::real);
}
template <class Function>
Hook whole_hook(Function function) {
    return {reinterpret_cast<GLADapiproc>(function), [](GLADapiproc) {}};
}

}  // namespace

GLADapiproc patch_drawing(const char* name, GLADapiproc function) {
    static const std::map<std::string_view, Hook> hooks = {
        {"glAttachShader", hook(attach_stage, below.attach_shader)},
        {"glBeginQuery", hook(begin_query, below.begin_query)},
        {"glCreateShader", hook(create_stage, below.create_shader)},
        {"glDeleteProgram", hook(delete_program, below.delete_program)},
        {"glDeleteShader", hook(delete_stage, below.delete_shader)},
        {"glDetachShader", hook(detach_stage, below.detach_shader)},
        {"glDrawArrays", hook(draw_arrays, below.draw_arrays)},
        {"glEndQuery", hook(end_query, below.end_query)},
        {"glGetQueryObjectiv", hook(get_query_objectiv, below.get_query_objectiv)},
        {"glGetUniformLocation", hook(get_uniform_location, below.get_uniform_location)},
        {"glLinkProgram", hook(link_program, below.link_program)},
        {"glPatchParameteri", whole_hook(patch_parameter)},
        {"glPolygonMode", whole_hook(polygon_mode)},
        {"glShaderSource", hook(set_stage_text, below.shader_source)},
        {"glUniform1f", uniform_hook<glad_glUniform1f>()},
        {"glUniform1i", uniform_hook<glad_glUniform1i>()},
        {"glUniform2fv", uniform_hook<glad_glUniform2fv>()},
        {"glUniform3fv", uniform_hook<glad_glUniform3fv>()},
        {"glUniform4fv", uniform_hook<glad_glUniform4fv>()},
        {"glUniformMatrix3fv", uniform_hook<glad_glUniformMatrix3fv>()},
        {"glUniformMatrix4fv", uniform_hook<glad_glUniformMatrix4fv>()},
        {"glUseProgram", hook(use_patch_program, below.use_program)},
    };
    const auto found = hooks.find(name);
    if (found == hooks.end()) return function;
    found->second.set_below(function);
    return found->second.function;
}

}  // namespace relief::web
