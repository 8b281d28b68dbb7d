// One picture, or one probe, of one lab: from the manifest, from --set and --camera, or from the menu.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "framework/gl/target.h"
#include "framework/lab/lab.h"

namespace relief {

struct Shot {
    glm::ivec2 size{1280, 720};
    double time = 0;
    Orbit camera;
    Probe probe;
    std::vector<std::pair<std::string, std::string>> set;  ///< knobs, in order
};

/// The camera as `--camera` takes it, with as many digits as a picture shows.
std::string camera_text(const Orbit& camera);

/// The shot as options of `relief shot`: "--set view=one --camera 30,20,3 --size 640x360". `usual`: the camera that needs
/// no option.
std::string shot_text(const Shot& shot, const Orbit& usual);

/// The frame of a shot in a target of its size.
Frame frame_of(const Shot& shot, const Target& target);

/// Sets GL to the state that Frame promises, clears nothing, lets the lab draw, and restores GL. Throws what the
/// lab throws at first use, and Error for GL errors.
void draw_lab(Lab& lab, const Frame& frame);

/// A new lab with the shot's knobs set. Needs no context. Throws UsageError for a knob or a value that is not there.
std::unique_ptr<Lab> make_lab(const LabEntry& entry, const Shot& shot);

/// The target's picture without alpha: 8-bit sRGB as encoded, or linear floats from a target of that kind.
Image read_picture(const Target& target);

/// draw_lab() into a new target, then the pixels: 8-bit sRGB (3 channels) for a picture, linear floats (3
/// channels) when `light`, floats (4 channels) for a probe. Throws Error when nothing was drawn (a picture of
/// one colour, a probe without a surface) or a probe has a pixel that is neither finite nor background nor not_written.
Image render_shot(Lab& lab, const Shot& shot, bool light = false);

/// The two halves of render_shot(), for callers that draw and validate in different processes. draw_shot() throws for
/// GL errors only. Without `without_tasks` refuse_unusable() also refuses what is not_written.
Image draw_shot(Lab& lab, const Shot& shot, bool light = false);
void refuse_unusable(const Image& image, const Shot& shot, bool without_tasks = false);
/// How many pixels of a probe come from a task that is not written.
size_t pixels_not_written(const Image& image);

/// Why a probe has no exact values; without a name, of any probe. A students' course does not have what computes them.
std::string no_truth(const std::string& probe = "");

/// The exact values of the shot's probe. Throws UsageError if the lab has none. Needs no context.
Image truth_of(const Lab& lab, const Shot& shot);

}  // namespace relief
