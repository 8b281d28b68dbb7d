// Shots drawn by an untrusted process, and the stream in which their pixels come back: no image file is
// decoded, and no size is trusted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/context/context.h"
#include "framework/lab/shot.h"

namespace relief {

struct LabEntry;

/// Who draws, and how: the solution and every submission alike.
struct Renderer {
    std::optional<ContextKind> context = {};  ///< nothing: OSMesa, then EGL
    int threads = 0;                          ///< of the software renderer, beside the one that draws
    bool pinned = true;                       ///< the same bits on every machine, see pin_software_renderer()
};

/// A program that runs out of memory ends with this exit code.
constexpr int out_of_memory_code = 97;

/// What the process that draws is sent when it asks for it, and with what its output begins when it does.
std::string drawing_request(const LabEntry& lab, const std::vector<Shot>& shots, const Renderer& renderer);
std::string drawing_asks();

/// That process: asks for its request, by a message "ask" on standard output, and reads it from `request_descriptor`:
/// so nothing is there yet while a task's own static objects are made. Then it writes "ready" once there is a context,
/// each shot's pixels or what went wrong, and "done". `course` is the course to draw. Does not return.
[[noreturn]] void draw_request(const char* course);

/// The result of one shot.
struct Drawn {
    std::optional<Image> image;  ///< of the shot's size, as draw_shot() has it; its values can be anything
    std::string error;           ///< the process's error message, if there is no image
};

/// How far the process came: it asked for its request, it had a context, it sent all shots.
enum class DrawingPhase { started, asked, ready, done };

struct DrawnShots {
    std::vector<Drawn> shots;  ///< the complete ones, from the first on
    DrawingPhase phase = DrawingPhase::started;
    std::string problem;  ///< why the rest cannot be read, or empty
};
/// Reads the stream that draws `shots`.
DrawnShots read_drawings(const std::string& stream, const std::vector<Shot>& shots);

/// How many bytes that stream has at most, when all goes well and when errors are long.
size_t drawings_size(const std::vector<Shot>& shots);

}  // namespace relief
