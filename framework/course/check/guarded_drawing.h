// Draws shots in an untrusted process, and reads the stream in which it returns their pixels. The reader decodes no
// image file and trusts no size.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/core/context/context.h"
#include "framework/core/lab/shot.h"
#include "framework/course/check/compiled_shaders.h"
#include "framework/course/explain/explain.h"

namespace relief {
struct LabEntry;
}

namespace relief::check {

/// How shots are drawn: the same for the solution and every submission.
struct Renderer {
    std::optional<ContextKind> context = {};  ///< empty: OSMesa, then EGL
    int threads = 0;                          ///< extra threads of the software renderer
    bool pinned = true;                       ///< identical bits on every machine, see pin_software_renderer()
};

/// Compiled shaders that a process gets, and whether it returns them with its own ones. Only for a process with a cache
/// of its own, see draw_request().
struct ShaderReuse {
    CompiledShaders known = {};
    bool returns = false;
};

/// Returns the request that is sent to the drawing process.
std::string drawing_request(const LabEntry& lab, const std::vector<Shot>& shots, const Renderer& renderer,
                            const ShaderReuse& reuse = {});

/// A shot of which calls are wanted at some pixels, see lone_calls().
struct NotedShot {
    Shot shot;
    std::vector<glm::ivec2> pixels;
};
/// Returns the request for the calls of functions in `files` instead of pictures.
std::string noting_request(const LabEntry& lab, const std::set<std::string>& files, const std::vector<NotedShot>& shots,
                           const Renderer& renderer);

/// Returns the first message of the drawing process, which asks for its request.
std::string drawing_asks();

/// Runs the drawing process. Writes "ask" to standard output, then reads its request from `request_descriptor`. So the
/// static objects of a task are constructed before there is a request to read. Then writes "ready" once it has a
/// context, the pixels or the error of each shot, the compiled shaders if they are wanted, and "done" with its
/// processor time. `course` is the folder of the course to draw. Does not return.
///
/// If MESA_SHADER_CACHE_DIR is set, it names a folder for this process alone. Otherwise no shader is cached, because a
/// submission could read the entries of another.
[[noreturn]] void draw_request(const char* course);

/// The result of one shot.
struct Drawn {
    std::optional<Image> image;  ///< of the shot's size and the format of draw_shot(); its values are not trusted
    std::string error;           ///< the process's error message if there is no image
    double cpu = 0;              ///< seconds of processor time, as the process reports them: see DrawnShots
};

/// The progress of the process: it asked for its request, it had a context, it sent all shots.
enum class DrawingPhase { started, asked, ready, done };

struct DrawnShots {
    std::vector<Drawn> shots;  ///< the complete ones, from the first on
    CompiledShaders compiled;  ///< if they were wanted; not trusted
    DrawingPhase phase = DrawingPhase::started;
    double cpu = 0;              ///< seconds of processor time, as a process in phase `done` reports them; not trusted
    bool has_no_memory = false;  ///< the process says that its memory ran out, and ended
    std::string problem;         ///< why the rest of the stream cannot be read, or empty
};
/// Reads the stream of a process that was asked to draw `shots`. Never throws for bad input; see `problem`.
DrawnShots read_drawings(const std::string& stream, const std::vector<Shot>& shots);

/// Returns the maximum size of the stream in bytes; error messages are truncated to fit.
size_t drawings_size(const std::vector<Shot>& shots);

/// The calls by shot and pixel. A shot that the process did not finish has no pixels.
using NotedCalls = std::vector<std::vector<std::vector<LoneCall>>>;
/// Reads the stream of a process that got a noting_request(). Never throws for bad input, and accepts no more numbers
/// than a call can have; texts are not trusted.
NotedCalls read_notes(const std::string& stream, const std::vector<NotedShot>& shots);
/// Returns the maximum size of that stream in bytes.
size_t notes_size(const std::vector<NotedShot>& shots);

}  // namespace relief::check
