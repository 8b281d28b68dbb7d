// One picture, or one probe, of one lab: from the manifest, from --set and --camera, or from the menu.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "framework/core/gl/target.h"
#include "framework/core/lab/lab.h"

namespace relief {

/// Calls of a task's functions in place of a view. The picture has one pixel a call: its value.
struct Calls {
    std::string file = {};                   ///< the task's file, relative to the course's top folder
    std::vector<std::string> texts = {};     ///< expressions in the file's language
    std::vector<std::string> includes = {};  ///< files below `shaders` that the task's shader needs before it

    explicit operator bool() const { return !texts.empty(); }
};

struct Shot {
    glm::ivec2 size{1280, 720};
    double time = 0;
    Orbit camera;
    Probe probe;
    std::vector<std::pair<std::string, std::string>> set;  ///< knobs and their values, in order
    Calls calls = {};                                      ///< see check::make_drawer()
    std::vector<PictureWord>* words = nullptr;             ///< see Frame; must outlive the draw
    bool studio = false;                                   ///< see Frame; off for all that is compared or measured
};

/// Returns a camera in the format of `--camera`, to four digits, which suffice for a picture.
std::string camera_text(const Orbit& camera);

/// Returns a shot as options of `relief shot`, such as "--set view=one --camera 30,20,3 --size 640x360". A camera equal
/// to `usual` needs no option.
std::string shot_text(const Shot& shot, const Orbit& usual);

/// Returns the frame of a shot in a target of its size.
Frame frame_of(const Shot& shot, const Target& target);

/// Sets GL to the state that Frame promises, clears nothing, lets the lab draw, and restores that state. Throws the
/// lab's exceptions, and Error for GL errors.
void draw_lab(Lab& lab, const Frame& frame);
/// Returns the number of calls of draw_lab() so far, including calls that threw. It identifies the current draw.
int64_t draws_begun();

/// Makes a lab and sets the shot's knobs. Needs no context. Throws UsageError for an unknown knob or value.
std::unique_ptr<Lab> make_lab(const LabEntry& entry, const Shot& shot);

/// Returns the target's picture without alpha: 8-bit sRGB as stored, or linear floats from a target of
/// TargetKind::light.
Image read_picture(const Target& target);

/// Calls draw_lab() with a new target and reads the pixels: 8-bit sRGB (3 channels) for a picture, linear floats (3
/// channels) if `light`, and floats (4 channels) for a probe. Throws Error when nothing was drawn (a picture of one
/// colour, a probe without a surface). Also throws when a pixel of a probe is neither finite nor background nor
/// not_written.
Image render_shot(Lab& lab, const Shot& shot, bool light = false);

/// The two halves of render_shot(), for callers that draw and validate in different processes. draw_shot() throws only
/// for GL errors. Unless `without_tasks`, refuse_unusable() also throws for pixels that are not_written.
Image draw_shot(Lab& lab, const Shot& shot, bool light = false);
void refuse_unusable(const Image& image, const Shot& shot, bool without_tasks = false);
/// Returns the number of a probe's pixels whose task is not written.
size_t pixels_not_written(const Image& image);

/// Returns the exact values of the shot's probe, or nothing if the lab has none with these knobs. Needs no context.
std::optional<Image> find_truth(const Lab& lab, const Shot& shot);
/// Returns the same, but throws UsageError if the lab has none.
Image truth_of(const Lab& lab, const Shot& shot);

}  // namespace relief
