#include "framework/core/lab/shot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/from_staff.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/core/image/color.h"
#include "framework/core/image/compare.h"

namespace relief {
namespace {

int64_t draws = 0;

// In sRGB encoding, because glClear does not encode.
constexpr glm::vec3 background{0.11f, 0.12f, 0.14f};

double aspect(glm::ivec2 size) { return double(size.x) / size.y; }

/// Sets the state that Frame promises, except for the clear colour.
void restore_state() {
    for (const GLenum capability :
         {GL_BLEND, GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_CLAMP, GL_FRAMEBUFFER_SRGB, GL_POLYGON_OFFSET_FILL,
          GL_PRIMITIVE_RESTART, GL_PROGRAM_POINT_SIZE, GL_RASTERIZER_DISCARD, GL_SAMPLE_ALPHA_TO_COVERAGE,
          GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_TEXTURE_CUBE_MAP_SEAMLESS})
        glDisable(capability);
    for (GLenum i = 0; i < 8; ++i) glDisable(GL_CLIP_DISTANCE0 + i);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_MULTISAMPLE);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDepthRange(0, 1);
    glClearDepth(1);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilMask(~0u);
    glStencilFunc(GL_ALWAYS, 0, ~0u);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glClearStencil(0);
    glPolygonOffset(0, 0);
    glBlendColor(0, 0, 0, 0);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBlendEquation(GL_FUNC_ADD);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(0);
    glBindVertexArray(0);
}

/// Throws Error for a probe without a surface or with broken pixels. If `without_tasks`, pixels of unwritten tasks are
/// valid.
void refuse_broken_probe(const Image& image, const Probe& probe, bool without_tasks) {
    size_t surface = 0, broken = 0, first = 0;
    const size_t missing = pixels_not_written(image);
    if (missing > 0 && !without_tasks)
        throw Error(fmt::format("probe '{}': {} pixels come from a task that is not written yet", probe.name, missing));
    for (size_t i = 0; i < image.pixel_count(); ++i) {
        const float* const value = image.values.data() + i * image.channels;
        const auto finite = std::count_if(value, value + image.channels, [](float v) { return std::isfinite(v); });
        const auto outside = std::count(value, value + image.channels, no_surface);
        const bool is_missing = std::count(value, value + image.channels, not_written) == image.channels;
        surface += finite == image.channels || is_missing;
        if (finite != image.channels && outside != image.channels && !is_missing && broken++ == 0) first = i;
    }
    if (broken > 0)
        throw Error(fmt::format("probe '{}': {} pixels are not finite, the first at column {}, row {}", probe.name,
                                broken, first % size_t(image.width), first / size_t(image.width)));
    if (surface == 0)
        throw Error(fmt::format("probe '{}': no surface was drawn, or the camera does not see it", probe.name));
}

}  // namespace

std::string camera_text(const Orbit& camera) {
    std::string text;
    for (const double number : {camera.yaw, camera.pitch, camera.distance, camera.target.x, camera.target.y,
                                camera.target.z, camera.field_of_view})
        text += (text.empty() ? "" : ",") + rounded(number, 4);
    return text;
}

std::string shot_text(const Shot& shot, const Orbit& usual) {
    std::string text;
    for (const auto& [knob, value] : shot.set) text += fmt::format("--set {}={} ", knob, value);
    if (shot.probe) text += fmt::format("--probe {} ", shot.probe.name);
    if (shot.camera != usual) text += fmt::format("--camera {} ", camera_text(shot.camera));
    if (shot.time != 0) text += fmt::format("--time {} ", plain(shot.time));
    return text + fmt::format("--size {}x{}", shot.size.x, shot.size.y);
}

Frame frame_of(const Shot& shot, const Target& target) {
    return {target.framebuffer(),
            target.size(),
            shot.time,
            Camera(shot.camera, aspect(target.size())),
            shot.probe,
            shot.words,
            shot.studio && !shot.probe};
}

int64_t draws_begun() { return draws; }

void draw_lab(Lab& lab, const Frame& frame) {
    ++draws;
    // Before the call for the lab; after it, also on an exception, for the next user of the context.
    struct Restored {
        Restored() { restore_state(); }
        ~Restored() { restore_state(); }
    };
    {
        const Restored restored;
        if (frame.probe)
            glClearColor(no_surface, no_surface, no_surface, no_surface);
        else
            glClearColor(background.r, background.g, background.b, 1);
        lab.draw(frame);
    }
    const std::string errors = take_gl_errors();
    if (!errors.empty()) throw Error("OpenGL: " + errors);
}

std::unique_ptr<Lab> make_lab(const LabEntry& entry, const Shot& shot) {
    std::unique_ptr<Lab> lab = entry.make();
    for (const auto& [name, value] : shot.set) set_knob(*lab, name, value);
    return lab;
}

Image read_picture(const Target& target) {
    Image image = target.read(3);
    if (target.kind() == TargetKind::light)
        for (float& value : image.values) value = float(linear_from_srgb(value));
    return image;
}

Image draw_shot(Lab& lab, const Shot& shot, bool light) {
    const TargetKind kind = shot.probe ? TargetKind::probe : light ? TargetKind::light : TargetKind::picture;
    const Target target(kind, shot.size);
    draw_lab(lab, frame_of(shot, target));
    glFinish();
    print_event("drawn");
    Image image = shot.probe ? target.read() : read_picture(target);
    print_event("read back");
    const std::string errors = take_gl_errors();
    if (!errors.empty()) throw Error("OpenGL: " + errors);
    return image;
}

size_t pixels_not_written(const Image& image) {
    size_t count = 0;
    for (auto pixel = image.values.begin(); pixel != image.values.end(); pixel += image.channels)
        count += std::count(pixel, pixel + image.channels, not_written) == image.channels;
    return count;
}

void refuse_unusable(const Image& image, const Shot& shot, bool without_tasks) {
    if (shot.calls) return;  // a call may return anything
    if (shot.probe)
        refuse_broken_probe(image, shot.probe, without_tasks);
    else if (image.pixel_count() > 1 && is_one_color(image))
        throw Error("the picture has one colour: nothing was drawn, or the camera does not see it");
}

Image render_shot(Lab& lab, const Shot& shot, bool light) {
    Image image = draw_shot(lab, shot, light);
    refuse_unusable(image, shot, true);
    return image;
}

std::optional<Image> find_truth(const Lab& lab, const Shot& shot) {
    const Frame frame{0, shot.size, shot.time, Camera(shot.camera, aspect(shot.size)), shot.probe};
    return lab.truth(frame);
}

Image truth_of(const Lab& lab, const Shot& shot) {
    auto truth = find_truth(lab, shot);
    if (!truth)
        throw UsageError(
            fmt::format("this lab has no exact values for the probe '{}' with these knobs", shot.probe.name));
    return *std::move(truth);
}

}  // namespace relief
