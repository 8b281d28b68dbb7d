// Shots drawn by an untrusted process, and the stream in which it returns their pixels. The reader decodes no image
// file and trusts no size.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/context/context.h"
#include "framework/lab/shot.h"

namespace relief {

struct LabEntry;

/// How shots are drawn: the same for the solution and every submission.
struct Renderer {
    std::optional<ContextKind> context = {};  ///< empty: OSMesa, then EGL
    int threads = 0;                          ///< extra threads of the software renderer
    bool pinned = true;                       ///< the same bits on every machine, see pin_software_renderer()
};

/// The exit code of a program that ran out of memory.
constexpr int out_of_memory_code = 97;

/// The request that is sent to the drawing process, and the message at the start of its output that asks for it.
std::string drawing_request(const LabEntry& lab, const std::vector<Shot>& shots, const Renderer& renderer);
std::string drawing_asks();

/// The drawing process. It writes "ask" to standard output and reads its request from `request_descriptor`. So there is
/// no request to read while a task's static objects are constructed. Then it writes "ready" once it has a context, the
/// pixels or the error of each shot, and "done" with its processor time. `course` is the folder of the course to draw.
/// Does not return.
[[noreturn]] void draw_request(const char* course);

/// The result of one shot.
struct Drawn {
    std::optional<Image> image;  ///< of the shot's size and as draw_shot() makes it, but its values can be anything
    std::string error;           ///< the process's error message if there is no image
    double cpu = 0;              ///< seconds of processor time, as the process says: see DrawnShots
};

/// How far the process came: it asked for its request, it had a context, it sent all shots.
enum class DrawingPhase { started, asked, ready, done };

struct DrawnShots {
    std::vector<Drawn> shots;  ///< the complete ones, from the first on
    DrawingPhase phase = DrawingPhase::started;
    double cpu = 0;       ///< seconds of processor time, as a process says that is done; a student's can say anything
    std::string problem;  ///< why the rest cannot be read, or empty
};
/// Reads the stream of a process that was asked to draw `shots`.
DrawnShots read_drawings(const std::string& stream, const std::vector<Shot>& shots);

/// The largest size of that stream in bytes, even with long errors.
size_t drawings_size(const std::vector<Shot>& shots);

}  // namespace relief
