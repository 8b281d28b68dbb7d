#include "framework/window/menu_stage.h"

#include <fmt/format.h>

#include <chrono>

#include "framework/base/error.h"
#include "framework/base/log.h"
#include "framework/gl/counters.h"
#include "framework/gl/texture.h"
#include "framework/image/visualize.h"

namespace relief {

void Stage::open(const LabEntry& entry, const Shot* start) {
    lab_.reset();
    probe_picture_.reset(), values_.reset();
    shown_ = 0;
    entry_ = &entry;
    manifest_ = {};
    stale_ = true, renewed_ = false;
    failure_.reset(), shader_failure_.reset();
    const glm::ivec2 size = shot_.size;
    shot_ = {};
    shot_.size = size;
    try {
        manifest_ = load_manifest(entry);
        shot_.camera = manifest_.camera;
        if (start) shot_ = *start, shot_.size = size;
        lab_ = make_lab(entry, shot_);
    } catch (const Error& error) {
        fail(error);
    }
}

void Stage::show(Probe probe) {
    shot_.probe = std::move(probe);
    values_.reset();
    stale_ = true;
    shown_ = 0;
}

void Stage::fail(const Error& error) {
    failure_ = error;
    print_error(error.what());
}

bool Stage::look() {
    ShaderNews news = renew_programs();
    shader_failure_ = std::move(news.error);
    if (!news.changed) return false;
    stale_ = true;
    if (shader_failure_)
        print_error(shader_failure_->what());
    else
        renewed_ = true;
    return true;
}

ShaderState Stage::shaders() const {
    return error() ? ShaderState::failed : renewed_ ? ShaderState::renewed : ShaderState::unchanged;
}

const Error* Stage::error() const { return failure_ ? &*failure_ : shader_failure_ ? &*shader_failure_ : nullptr; }

bool Stage::draw(glm::ivec2 size, double time) {
    const bool moves = manifest_.animated && time != shot_.time && !failed();
    if (!lab_ || !(stale_ || moves || size != shot_.size)) return false;
    stale_ = false;
    failure_.reset();
    shot_.size = size, shot_.time = time;
    draw_calls_ = 0;
    const int64_t draw_calls_before = counters().draw_calls;
    const auto begin = std::chrono::steady_clock::now();
    try {
        const TargetKind kind = shot_.probe ? TargetKind::probe : TargetKind::picture;
        if (!target_ || target_->size() != size || target_->kind() != kind) {
            shown_ = 0;
            target_.emplace(kind, size);
        }
        draw_lab(*lab_, frame_of(shot_, *target_));
        draw_calls_ = counters().draw_calls - draw_calls_before;
        glFinish();
        milliseconds_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        shown_ = shot_.probe ? draw_probe() : target_->resolve();
    } catch (const Error& error) {
        fail(error);
    } catch (const std::exception& error) {  // the window stays open, whatever a lab does
        fail(Error(error.what()));
    }
    ++frames_;
    print_event(fmt::format("frame {}: {}, {} GL objects, {} draw calls, {} texture bytes, {:.1f} ms", frames_,
                            entry_->folder, counters().live_objects(), draw_calls_, counters().texture_bytes,
                            milliseconds_));
    return true;
}

// The numbers go to the CPU and come back as colours; that happens only when they changed.
GLuint Stage::draw_probe() {
    shown_ = 0;
    values_ = target_->read();
    probe_picture_.emplace(
        ProbePicture{Texture("probe as colours", [this] { return picture(); }, {.wrap = Wrap::clamp, .mips = false}),
                     FramebufferName()});
    glBindFramebuffer(GL_FRAMEBUFFER, probe_picture_->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, probe_picture_->texture, 0);
    return probe_picture_->framebuffer;
}

Image Stage::picture() const {
    if (!target_ || failed()) throw Error("there is no picture to save");
    if (shot_.probe)
        return visualize_probe(values_ ? *values_ : target_->read(), manifest_.probe(shot_.probe.name).error);
    return read_picture(*target_);
}

}  // namespace relief
