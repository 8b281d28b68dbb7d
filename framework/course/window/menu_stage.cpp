#include "framework/course/window/menu_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/gl/counters.h"
#include "framework/core/gl/draw_watch.h"
#include "framework/core/gl/texture.h"
#include "framework/course/check/check.h"
#include "framework/library/maps/visualize.h"

namespace relief::window {
namespace {

constexpr double patience = 100;  // milliseconds
/// A tiny picture has this part of the frame's width and height. If it takes `quick` milliseconds or less, the frame
/// takes seconds. A frame of more than `longest_frame` seconds is not drawn.
constexpr int tiny = 16;
constexpr double quick = 60, longest_frame = 20;

/// Ends a draw that compiles.
struct Pause {};

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

void Stage::open(const LabEntry& entry, const Shot* start) {
    lab_.reset();
    keep_as_backdrop();
    values_.reset();
    prepared_ = tried_ = drawn_ = false, pauses_ = 0;
    entry_ = &entry;
    manifest_ = {};
    defaults_.clear();
    stale_ = true, renewed_ = false;
    failure_.reset(), shader_failure_.reset();
    const glm::ivec2 size = shot_.size;
    shot_ = {};
    shot_.size = size;
    try {
        manifest_ = check::manifest_to_check(entry);
        shot_.camera = manifest_.camera;
        defaults_ = describe_knobs(*entry.make());
        if (start) shot_ = *start, shot_.size = size;
        shot_.probe.missing = MissingTask::told, shot_.studio = true;
        lab_ = make_lab(entry, shot_);
    } catch (const Error& error) {
        fail(error);
    }
}

void Stage::show(Probe probe) {
    shot_.probe = std::move(probe);
    shot_.probe.missing = MissingTask::told;
    values_.reset();
    changed();
    shown_ = 0;
}

Shot Stage::settings() const {
    Shot shot = shot_;
    shot.set.clear();
    if (lab_)
        for (const KnobText& knob : describe_knobs(*lab_)) shot.set.emplace_back(knob.name, knob.value);
    return shot;
}

void Stage::apply(const Shot& shot) {
    if (!lab_) return;
    std::map<std::string, std::string> now;
    for (const KnobText& knob : describe_knobs(*lab_)) now[knob.name] = knob.value;
    std::vector<std::pair<std::string, std::string>> wanted;
    for (const KnobText& knob : defaults_) wanted.emplace_back(knob.name, knob.value);
    for (const auto& [name, value] : shot.set) {
        const auto same = [&, &knob = name](const auto& one) { return one.first == knob; };
        const auto found = std::find_if(wanted.begin(), wanted.end(), same);
        if (found != wanted.end()) found->second = value;
    }
    for (const auto& [name, value] : wanted) try {
            if (now[name] != value) set_knob(*lab_, name, value);
        } catch (const Error& error) {
            print_error(error.what());
        }
    shot_.camera = shot.camera;
    if (shot.probe.name != shot_.probe.name) show(shot.probe);
    changed();
}

void Stage::reset_knob(const std::string& name) {
    for (const KnobText& knob : defaults_)
        if (knob.name == name) set_knob(*lab_, name, knob.value);
    changed();
}

void Stage::keep_as_backdrop() {
    if (shown_) {
        drop_backdrop();
        backdrop_ = {shown_, shot_.size};
        std::swap(backdrop_target_, target_);
        if (probe_picture_) backdrop_probe_.emplace(*std::move(probe_picture_));
    }
    shown_ = 0;
    probe_picture_.reset();
}

void Stage::drop_backdrop() {
    backdrop_ = {};
    backdrop_target_.reset(), backdrop_probe_.reset();
}

void Stage::fail(const Error& error) {
    drop_backdrop();
    failure_ = error;
    print_error(error.what());
}

bool Stage::look() {
    ShaderNews news = renew_programs();
    shader_failure_ = std::move(news.error);
    if (!news.changed) return false;
    stale_ = true, tried_ = false;
    if (shader_failure_)
        print_error(shader_failure_->what());
    else
        renewed_ = true;
    return true;
}

ShaderState Stage::shaders() const {
    const bool is_cpp = error() && error()->place().file.extension() == ".cpp";  // a task that throws
    return error() && !is_cpp ? ShaderState::failed : renewed_ ? ShaderState::renewed : ShaderState::unchanged;
}

const Error* Stage::error() const { return failure_ ? &*failure_ : shader_failure_ ? &*shader_failure_ : nullptr; }

bool Stage::is_due(glm::ivec2 size, double time) const {
    const bool moves = manifest_.animated && time != shot_.time && !failed();
    return lab_ && (stale_ || moves || size != shot_.size);
}

std::string Stage::step() const {
    if (!is_opening()) return "drawing";
    if (prepared_) return "drawing the picture";
    return pauses_ == 0 ? "loading maps, compiling shaders" : fmt::format("compiling shaders, {} done", pauses_);
}

bool Stage::draw(glm::ivec2 size, double time) {
    if (!is_due(size, time)) return false;
    if (!prepared_ && !prepare(size, time)) return false;
    if (!std::exchange(tried_, true)) {
        if (!is_bearable(size, time)) {
            tried_ = stale_ = false, drawn_ = true;  // tries again after the next change
            shot_.size = size, shot_.time = time;
            return true;
        }
        if (!drawn_ && pauses_ > 0 && !shot_.probe && draw_backdrop(size, time)) return false;
    }
    stale_ = false, drawn_ = true;
    failure_.reset();
    shot_.size = size, shot_.time = time;
    draw_calls_ = 0;
    const int64_t draw_calls_before = counters().draw_calls;
    const auto begin = std::chrono::steady_clock::now();
    try {
        const TargetKind kind = shot_.probe ? TargetKind::probe : TargetKind::picture;
        if (!target_ || target_->size() != size || target_->kind() != kind) {
            shown_ = 0;
            target_ = Target(kind, size);  // made before the old one goes: they share a program
        }
        words_.clear();
        Frame frame = frame_of(shot_, *target_);
        frame.words = &words_;
        draw_lab(*lab_, frame);
        draw_calls_ = counters().draw_calls - draw_calls_before;
        glFinish();
        milliseconds_ = milliseconds_since(begin);
        if (shot_.probe) values_ = target_->read();
        shown_ = shot_.probe ? draw_probe(picture()) : target_->resolve();
        drop_backdrop();
    } catch (const Error& error) {
        fail(error);
    } catch (const std::exception& error) {  // exceptions from a lab must not close the window
        fail(Error(error.what()));
    }
    ++frames_;
    print_event(fmt::format("frame {}: {}, {} GL objects, {} draw calls, {} texture bytes, {:.1f} ms", frames_,
                            entry_->folder, counters().live_objects(), draw_calls_, counters().texture_bytes,
                            milliseconds_));
    return true;
}

// A program is compiled in two steps: when it is linked, and by a software renderer also in its first draw call, which
// takes up to seconds. So the first picture is drawn tiny, and again after each pause, until nothing is compiled.
bool Stage::prepare(glm::ivec2 size, double time) {
    auto last = std::chrono::steady_clock::now();
    int64_t links = counters().links;
    double compiling = 0;  // milliseconds
    try {
        const DrawWatch watch([&](const std::function<void()>& draw_call) {
            draw_call();
            // Pauses only after new work: programs of an earlier attempt are not compiled again.
            if (std::exchange(links, counters().links) < counters().links) compiling += milliseconds_since(last);
            if (compiling > patience) throw Pause();
            last = std::chrono::steady_clock::now();
        });
        draw_part(size / tiny, time);
        return prepared_ = true;
    } catch (const Pause&) {
        ++pauses_;
        print_event(fmt::format("pause {}: {}, compiling", pauses_, entry_->folder));
        return false;
    } catch (const std::exception&) {  // drawing the frame reports it
        return prepared_ = true;
    }
}

/// Draws the frame in another size. Returns its target.
Target Stage::draw_part(glm::ivec2 size, double time) {
    Shot shot = shot_;
    std::vector<PictureWord> left_out;
    shot.size = glm::max(size, glm::ivec2(1)), shot.time = time, shot.words = &left_out;
    Target target(shot.probe ? TargetKind::probe : TargetKind::picture, shot.size);
    draw_lab(*lab_, frame_of(shot, target));
    return target;
}

// A software renderer leaves an endless loop after 65,536 rounds, in each pixel: a frame then takes minutes, in which
// the window does not answer. Two sizes tell what each pixel costs, whatever is drawn once for all of them.
bool Stage::is_bearable(glm::ivec2 size, double time) {
    const auto time_of = [&](int part) {
        const auto begin = std::chrono::steady_clock::now();
        draw_part(size / part, time);
        glFinish();
        return milliseconds_since(begin);
    };
    try {
        // The first drawing also compiles.
        if (time_of(tiny) < quick || time_of(tiny) < quick) return true;
        const double less = time_of(tiny), more = time_of(tiny / 2);
        const double seconds = (more - less) * tiny * tiny / 3 / 1000;
        if (seconds < longest_frame) return true;
        fail(Error(
            fmt::format("the picture would take {:.0f} seconds, so it is not drawn: does a loop not end?", seconds)));
        return false;
    } catch (const std::exception&) {  // drawing the frame reports it
        return true;
    }
}

/// Draws a small picture to show until there is a frame. Returns whether there is one.
bool Stage::draw_backdrop(glm::ivec2 size, double time) {
    try {
        Target small = draw_part(size / 4, time);
        drop_backdrop();
        backdrop_target_ = std::move(small);
        backdrop_ = {backdrop_target_->resolve(), backdrop_target_->size()};
        print_event(fmt::format("small picture of {}", entry_->folder));
        return true;
    } catch (const std::exception&) {  // drawing the frame reports it
        return false;
    }
}

// The values were read back and return as a texture of colours. This happens only after a change.
GLuint Stage::draw_probe(Image picture) {
    shown_ = 0;
    probe_picture_.emplace(ProbePicture{
        Texture("probe as colours", [&] { return std::move(picture); }, {.wrap = Wrap::clamp, .mips = false}),
        FramebufferName()});
    glBindFramebuffer(GL_FRAMEBUFFER, probe_picture_->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, probe_picture_->texture, 0);
    return probe_picture_->framebuffer;
}

void show_alike(Stage& one, Stage& other) {
    if (!one.values_ || !other.values_ || one.failed() || other.failed() || !one.values_->same_shape(*other.values_))
        return;
    auto [a, b] = visualize_probes(*one.values_, *other.values_, one.manifest_.probe(one.shot_.probe.name).colors());
    one.shown_ = one.draw_probe(std::move(a));
    other.shown_ = other.draw_probe(std::move(b));
}

Image Stage::picture() const {
    if (!target_ || failed()) throw Error("there is no picture to save");
    if (shot_.probe)
        return visualize_probe(values_ ? *values_ : target_->read(), manifest_.probe(shot_.probe.name).colors());
    const Target target(TargetKind::picture, shot_.size);
    draw_lab(*lab_, frame_of(shot_, target));
    return read_picture(target);
}

}  // namespace relief::window
