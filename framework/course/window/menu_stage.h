// The lab that the menu shows, redrawn only after a change or in an animation. In the window module only.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "framework/core/base/error.h"
#include "framework/core/lab/knobs.h"
#include "framework/core/lab/shot.h"
#include "framework/core/lab/words.h"
#include "framework/course/manifest/manifest.h"

namespace relief::window {

/// Relates the picture on screen to the shader files.
enum class ShaderState {
    unchanged,  ///< drawn with the shaders that the lab was opened with
    renewed,    ///< drawn with shaders saved since then
    failed      ///< the saved shader has an error: the picture is from the last good program, or missing
};

class Stage {
public:
    /// Deletes the current lab with all its GL objects, then creates this one as its manifest says. `start` replaces
    /// the manifest's knobs, camera and probe. Does not throw: a broken manifest or shader becomes error().
    void open(const LabEntry& entry, const Shot* start = nullptr);

    const LabEntry& entry() const { return *entry_; }
    const Manifest& manifest() const { return manifest_; }
    Lab* lab() const { return lab_.get(); }
    Orbit& camera() { return shot_.camera; }
    const Probe& probe() const { return shot_.probe; }
    void show(Probe probe);

    /// Reloads saved shaders; knobs and camera stay. Call it a few times a second. Returns whether there is anything
    /// new to show.
    bool look();
    ShaderState shaders() const;

    /// Call it after a knob or the camera has moved.
    void changed() { stale_ = true, ++edits_; }
    /// Call it after the lab's picture has changed for another reason.
    void redraw() { stale_ = true; }
    /// Returns the frame of the picture, without its target.
    Frame frame() const {
        return {0, shot_.size, shot_.time, Camera(shot_.camera, double(shot_.size.x) / std::max(1, shot_.size.y)),
                shot_.probe};
    }
    /// Number of changes by the user.
    int64_t edits() const { return edits_; }
    /// The knobs of this lab with their default values.
    const std::vector<KnobText>& defaults() const { return defaults_; }
    /// Returns the current settings as a shot: all knobs, camera and probe.
    Shot settings() const;
    /// Applies knobs, camera and probe of a shot. Knobs that it does not set get their defaults. Reports and skips a
    /// value that cannot be set, such as a picture whose file is missing.
    void apply(const Shot& shot);
    void reset_knob(const std::string& name);
    /// Returns whether draw() would draw.
    bool is_due(glm::ivec2 size, double time) const;
    /// Returns whether drawing may take noticeably long: for a lab's first frame, or after a frame of more than 400 ms.
    bool is_slow() const { return shown_ == 0 || milliseconds_ > 400; }
    /// Draws if something has changed since the last call. Returns whether it did. Before a lab's first frame, a call
    /// may only compile a program and return false. The frame is then still due.
    bool draw(glm::ivec2 size, double time);
    /// Returns whether the lab has no frame yet and waits for one.
    bool is_opening() const { return lab_ && !drawn_; }
    /// Returns what the next call of draw() does, for a user who waits: "compiling shaders, 2 done".
    std::string step() const;

    /// The framebuffer of the last good frame (one sample per pixel), for a blit; 0 if there is none.
    GLuint framebuffer() const { return shown_; }
    /// A picture to show until there is a frame: the last one of the previous lab, or a small one of this lab.
    struct Backdrop {
        GLuint framebuffer = 0;  ///< 0 if there is none
        glm::ivec2 size{0, 0};
    };
    const Backdrop& backdrop() const { return backdrop_; }
    /// The words of the last good frame, which has none: the window draws them over it. Empty for a probe.
    const std::vector<PictureWord>& words() const { return words_; }
    const Shot& shot() const { return shot_; }
    glm::ivec2 size() const { return shot_.size; }
    /// The probe's values, if a probe is shown.
    const std::optional<Image>& values() const { return values_; }
    /// Returns the frame as an 8-bit picture with its words. Throws Error if there is none.
    Image picture() const;

    /// Why there is no picture, or why it is older than its shaders. Null if there is no error.
    const Error* error() const;
    /// Returns whether the last frame failed.
    bool failed() const { return failure_.has_value(); }

    int64_t frames() const { return frames_; }             ///< drawn since the window opened
    int64_t draw_calls() const { return draw_calls_; }     ///< in the last frame
    double milliseconds() const { return milliseconds_; }  ///< of the last frame, to its end on the GPU

    /// If both stages show the same probe, gives both the same colour scale.
    friend void show_alike(Stage& one, Stage& other);

private:
    void fail(const Error& error);
    GLuint draw_probe(Image picture);
    bool prepare(glm::ivec2 size, double time);
    Target draw_part(glm::ivec2 size, double time);
    bool is_bearable(glm::ivec2 size, double time);
    bool draw_backdrop(glm::ivec2 size, double time);
    void keep_as_backdrop();
    void drop_backdrop();

    const LabEntry* entry_ = nullptr;
    Manifest manifest_;
    Shot shot_;
    std::unique_ptr<Lab> lab_;
    std::optional<Target> target_;
    /// The probe as colours, if a probe is shown.
    struct ProbePicture {
        Texture texture;
        FramebufferName framebuffer;
    };
    std::optional<ProbePicture> probe_picture_;
    std::optional<Image> values_;
    std::vector<PictureWord> words_;
    GLuint shown_ = 0;
    Backdrop backdrop_;
    std::optional<Target> backdrop_target_;  ///< owns the backdrop, unless it is a probe
    std::optional<ProbePicture> backdrop_probe_;
    std::vector<KnobText> defaults_;
    bool stale_ = true, renewed_ = false, prepared_ = false, drawn_ = false;
    bool tried_ = false;  ///< whether a tiny picture with these shaders has shown that the frame ends
    int pauses_ = 0;
    int64_t edits_ = 0;
    std::optional<Error> failure_;         ///< from the last frame, or from opening the lab
    std::optional<Error> shader_failure_;  ///< from shaders saved since the lab was opened
    int64_t frames_ = 0, draw_calls_ = 0;
    double milliseconds_ = 0;
};

}  // namespace relief::window
