// The lab that the menu shows: redrawn only when something changed or moves. In the window module only.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "framework/base/error.h"
#include "framework/lab/knobs.h"
#include "framework/lab/manifest.h"

namespace relief {

/// The picture on screen, compared with the shader files.
enum class ShaderState {
    unchanged,  ///< drawn with the shaders that the lab was opened with
    renewed,    ///< drawn with shaders saved since then
    failed      ///< the saved shader has an error: the picture is that of the last good program, or there is none
};

class Stage {
public:
    /// Deletes the present lab with all its GL objects, then makes this one as its manifest says.
    /// A broken manifest or shader becomes error(); nothing is thrown. `start` has knobs, camera and probe in place of
    /// the manifest's.
    void open(const LabEntry& entry, const Shot* start = nullptr);
    void restart() { open(*entry_); }

    const LabEntry& entry() const { return *entry_; }
    const Manifest& manifest() const { return manifest_; }
    Lab* lab() const { return lab_.get(); }
    Orbit& camera() { return shot_.camera; }
    const Probe& probe() const { return shot_.probe; }
    void show(Probe probe);

    /// Reloads saved shaders; knobs and camera stay. Call it a few times a second. Returns whether there is
    /// anything new to show.
    bool look();
    ShaderState shaders() const;

    /// Call it when a knob or the camera moved.
    void changed() { stale_ = true, ++edits_; }
    /// How often the user has changed what is shown.
    int64_t edits() const { return edits_; }
    /// The knobs of this lab as a new one has them.
    const std::vector<KnobText>& defaults() const { return defaults_; }
    /// What is shown, as a shot: all knobs, camera and probe.
    Shot settings() const;
    /// Shows knobs, camera and probe of a shot; knobs that it does not set are at their defaults. What cannot be set (a
    /// picture whose file is gone) is said and left out.
    void apply(const Shot& shot);
    void reset_knob(const std::string& name);
    /// Whether draw() would draw.
    bool is_due(glm::ivec2 size, double time) const;
    /// Whether that may take so long that somebody waits: the first frame of a lab, and where the last one did.
    bool is_slow() const { return shown_ == 0 || milliseconds_ > 400; }
    /// Draws when something changed since the last call; returns whether it did.
    bool draw(glm::ivec2 size, double time);

    /// The last frame without an error (one sample per pixel), for a blit; 0 if there is none.
    GLuint framebuffer() const { return shown_; }
    const Shot& shot() const { return shot_; }
    glm::ivec2 size() const { return shot_.size; }
    /// The probe's values, where a probe is shown.
    const std::optional<Image>& values() const { return values_; }
    /// The same as an 8-bit picture. Throws Error if there is none.
    Image picture() const;

    /// Why there is no picture, or why it is older than its shaders. Null if there is no error.
    const Error* error() const;
    /// Whether the last frame failed.
    bool failed() const { return failure_.has_value(); }

    int64_t frames() const { return frames_; }             ///< drawn since the window opened
    int64_t draw_calls() const { return draw_calls_; }     ///< in the last frame
    double milliseconds() const { return milliseconds_; }  ///< of the last frame, to its end on the GPU

    /// Where both stages show the same probe, gives both pictures the same colours.
    friend void show_alike(Stage& one, Stage& other);

private:
    void fail(const Error& error);
    GLuint draw_probe(Image picture);

    const LabEntry* entry_ = nullptr;
    Manifest manifest_;
    Shot shot_;
    std::unique_ptr<Lab> lab_;
    std::optional<Target> target_;
    /// The probe as colours, when a probe is shown.
    struct ProbePicture {
        Texture texture;
        FramebufferName framebuffer;
    };
    std::optional<ProbePicture> probe_picture_;
    std::optional<Image> values_;
    GLuint shown_ = 0;
    std::vector<KnobText> defaults_;
    bool stale_ = true, renewed_ = false;
    int64_t edits_ = 0;
    std::optional<Error> failure_;         ///< of the last frame, or of opening the lab
    std::optional<Error> shader_failure_;  ///< of shaders that were saved since
    int64_t frames_ = 0, draw_calls_ = 0;
    double milliseconds_ = 0;
};

}  // namespace relief
