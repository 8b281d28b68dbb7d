#include "framework/course/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "framework/core/base/error.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/draw_watch.h"
#include "framework/core/gl/target.h"
#include "framework/course/explain/lone_function.h"

namespace relief::check {
namespace {

/// The clear value of the note target; a pixel that keeps it was not drawn.
constexpr float nothing = -123456;

bool is_on(GLenum capability) { return glIsEnabled(capability) == GL_TRUE; }
GLint integer(GLenum what) {
    GLint value = 0;
    glGetIntegerv(what, &value);
    return value;
}

/// A framebuffer with eight colour targets of floats, and depth.
class NoteTarget {
public:
    explicit NoteTarget(glm::ivec2 size) : size_(size) {
        const GLint before = integer(GL_DRAW_FRAMEBUFFER_BINDING), buffer = integer(GL_RENDERBUFFER_BINDING);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
        const auto attach = [&](GLuint name, GLenum format, GLenum place) {
            glBindRenderbuffer(GL_RENDERBUFFER, name);
            glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
            glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, place, GL_RENDERBUFFER, name);
        };
        std::array<GLenum, 8> places{};
        for (size_t i = 0; i < places.size(); ++i) {
            places[i] = GLenum(GL_COLOR_ATTACHMENT0 + i);
            attach(colors_[i], GL_RGBA32F, places[i]);
        }
        attach(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
        glDrawBuffers(GLsizei(places.size()), places.data());
        const bool complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(before));
        glBindRenderbuffer(GL_RENDERBUFFER, GLuint(buffer));
        if (!complete) throw Error("this driver cannot draw eight targets of floats at once");
    }

    GLuint framebuffer() const { return framebuffer_; }
    glm::ivec2 size() const { return size_; }

private:
    glm::ivec2 size_;
    FramebufferName framebuffer_;
    std::array<RenderbufferName, 8> colors_;
    RenderbufferName depth_;
};

/// Binds a note target in place of the lab's target; the destructor restores the lab's state. The lab's viewport, depth
/// test, culling and scissor stay. State that would change a written number, such as blending, is off.
class Noting {
public:
    explicit Noting(const NoteTarget& target) {
        glGetIntegerv(GL_SCISSOR_BOX, box_.data());
        glGetFloatv(GL_COLOR_CLEAR_VALUE, color_.data());
        glGetDoublev(GL_DEPTH_CLEAR_VALUE, &depth_);
        glGetBooleanv(GL_COLOR_WRITEMASK, mask_.data());
        for (const GLenum capability : off) was_on_.push_back(is_on(capability)), glDisable(capability);
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glClearColor(nothing, nothing, nothing, nothing);
        scissored_ = is_on(GL_SCISSOR_TEST);
        glEnable(GL_SCISSOR_TEST);
    }
    ~Noting() {
        if (!scissored_) glDisable(GL_SCISSOR_TEST);
        glScissor(box_[0], box_[1], box_[2], box_[3]);
        glClearColor(color_[0], color_[1], color_[2], color_[3]);
        glClearDepth(depth_);
        glColorMask(mask_[0], mask_[1], mask_[2], mask_[3]);
        for (size_t i = 0; i < off.size(); ++i)
            if (was_on_[i]) glEnable(off[i]);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(packed_));
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(drawn_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_));
    }
    Noting(const Noting&) = delete;
    Noting& operator=(const Noting&) = delete;

    /// Clears a rectangle, and restricts drawing to its intersection with the lab's own scissor. Returns false if that
    /// is empty.
    bool aim(glm::ivec2 corner, glm::ivec2 size, double depth) const {
        glScissor(corner.x, corner.y, size.x, size.y);
        const bool writes = integer(GL_DEPTH_WRITEMASK) == GL_TRUE;
        glClearDepth(depth);
        glDepthMask(GL_TRUE);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (!writes) glDepthMask(GL_FALSE);
        if (!scissored_) return true;
        const glm::ivec2 own{box_[0], box_[1]}, own_end = own + glm::ivec2(box_[2], box_[3]);
        const glm::ivec2 low = glm::max(corner, own), high = glm::min(corner + size, own_end);
        if (low.x >= high.x || low.y >= high.y) return false;
        glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
        return true;
    }

private:
    static constexpr std::array<GLenum, 6> off = {GL_BLEND,          GL_FRAMEBUFFER_SRGB, GL_SAMPLE_ALPHA_TO_COVERAGE,
                                                  GL_COLOR_LOGIC_OP, GL_SAMPLE_COVERAGE,  GL_SAMPLE_MASK};
    GLint drawn_ = integer(GL_DRAW_FRAMEBUFFER_BINDING), read_ = integer(GL_READ_FRAMEBUFFER_BINDING);
    GLint packed_ = integer(GL_PIXEL_PACK_BUFFER_BINDING);
    std::array<GLint, 4> box_{};
    std::array<float, 4> color_{};
    std::array<GLboolean, 4> mask_{};
    double depth_ = 1;
    bool scissored_ = false;
    std::vector<bool> was_on_;
};

/// Explains one frame of one lab.
class Watched {
public:
    /// `files`: the shader task files, relative to the course's top folder.
    Watched(const LabEntry& entry, const std::set<std::string>& files, const Shot& shot, const Twins& twins)
        : entry_(entry), shot_(shot), twins_(twins) {
        for (const std::string& file : files) task_files_.insert(course_root() / file);
    }

    /// Draws the frame with twins in place of functions, as `flow` says (see watched::flow), and returns the pixel.
    /// With `notes` also notes the calls of all functions.
    std::vector<float> draw(glm::ivec2 pixel, int flow, bool notes) {
        flow_ = flow;
        programs_.clear();
        passes_.clear();
        depths_.clear();
        found_.clear();
        textures_.clear();
        notes_ = notes;
        const ShaderRewriting rewriting([this](std::vector<ShaderSource>& stages, GLuint program) {
            programs_[program] = watch_functions(stages, task_files_, twins_, functions_);
        });
        const std::unique_ptr<Lab> lab = make_lab(entry_, shot_);
        const Target target(shot_.probe ? TargetKind::probe : TargetKind::picture, shot_.size);
        target_ = target.framebuffer();
        pixel_ = {pixel.x, shot_.size.y - 1 - pixel.y};
        {
            const DrawWatch watch([this](const std::function<void()>& one) { on_draw(one); });
            draw_lab(*lab, frame_of(shot_, target));
        }
        const Image image = shot_.probe ? target.read() : read_picture(target);
        const float* const value = image.pixel(pixel.x, pixel.y);
        return {value, value + image.channels};
    }

    /// Finds, for each kind of pass that draws a texture, the texel that changes the pixel most: changes ever smaller
    /// parts of the textures, and looks whether the pixel changes. `value` is the pixel's. Returns whether the last
    /// draw() had such passes.
    bool find_texels(glm::ivec2 pixel, const std::vector<float>& value) {
        const std::vector<TexturePass> passes = textures_;
        const auto change = [&](const Shaken& shaken) {
            shaken_ = shaken;
            const std::vector<float> now = draw(pixel, 0, false);
            shaken_ = {};
            double sum = 0;
            for (size_t i = 0; i < now.size(); ++i) {
                if (std::isnan(now[i]) && std::isnan(value[i])) continue;
                const double off = std::abs(double(now[i]) - double(value[i]));
                sum += std::isfinite(off) ? off : 1e9;
            }
            return sum;
        };
        std::vector<bool> is_done(passes.size());
        for (size_t i = 0; i < passes.size(); ++i) {
            if (is_done[i]) continue;
            Shaken shaken{.region = {0, 0, passes[i].size}};
            for (size_t k = i; k < passes.size(); ++k)
                if (passes[k] == passes[i]) shaken.passes.push_back(int(k)), is_done[k] = true;
            const std::vector<int> all = shaken.passes;
            // Alpha often says whether a task is written, and changes the whole picture: only if nothing else does.
            double most = change(shaken);
            if (most == 0) shaken.channels = 4, most = change(shaken);
            if (most == 0) continue;
            // If one half changes nothing, the other one does, unless its change is too small for the picture's 8 bits.
            // Only the last part is tried: each try draws the frame.
            Shaken seen = shaken;
            while (const auto halves = shaken.halves()) {
                const double first = change((*halves)[0]),
                             second = first > 0 && first < most / 2 ? change((*halves)[1]) : 0;
                const bool is_first = first > 0 && first >= second;
                shaken = (*halves)[is_first ? 0 : 1];
                if (is_first || second > 0) seen = shaken, most = std::max(first, second);
            }
            if (change(shaken) == 0) shaken = seen;
            for (const int one : all) texels_[one] = {};
            texels_[shaken.passes[shaken.passes.size() / 2]] =
                (glm::ivec2(shaken.region) + glm::ivec2(shaken.region.z, shaken.region.w)) / 2;
        }
        return !passes.empty();
    }

    /// Calls `take` with the notes of each pixel. The lab is made once, so that its programs are compiled once. Omits
    /// passes of another size. `fragments` gets the text of each program's fragment stage.
    void note_pixels(const std::vector<glm::ivec2>& pixels, std::map<GLuint, std::string>& fragments,
                     const std::function<void(size_t, std::vector<ExplainedFunction>)>& take) {
        notes_ = true;
        is_alike_only_ = true;
        const ShaderRewriting rewriting([&](std::vector<ShaderSource>& stages, GLuint program) {
            for (const ShaderSource& stage : stages)
                if (stage.stage.extension() == ".frag") fragments[program] = stage.text;
            programs_[program] = watch_functions(stages, task_files_, twins_, functions_);
        });
        const std::unique_ptr<Lab> lab = make_lab(entry_, shot_);
        const Target target(shot_.probe ? TargetKind::probe : TargetKind::picture, shot_.size);
        target_ = target.framebuffer();
        for (size_t i = 0; i < pixels.size(); ++i) {
            passes_.clear();
            depths_.clear();
            found_.clear();
            pixel_ = {pixels[i].x, shot_.size.y - 1 - pixels[i].y};
            {
                const DrawWatch watch([this](const std::function<void()>& one) { on_draw(one); });
                draw_lab(*lab, frame_of(shot_, target));
            }
            take(i, take_notes());
        }
    }

    /// Returns the notes of the last draw(), callees before callers.
    std::vector<ExplainedFunction> take_notes() {
        std::vector<ExplainedFunction> functions;
        // Earlier passes come first, and the picture last.
        for (const bool is_picture : {false, true})
            for (auto& [key, note] : found_)
                if ((key.first == target_) == is_picture) functions.push_back(std::move(note));
        const auto rank = [](const ExplainedFunction& f) {
            return std::tuple(f.pass == 0 ? 1 << 30 : f.pass, f.function.stage, f.function.place.line);
        };
        std::stable_sort(functions.begin(), functions.end(),
                         [&](const ExplainedFunction& a, const ExplainedFunction& b) { return rank(a) < rank(b); });
        std::vector<ExplainedFunction> once;
        for (ExplainedFunction& one : functions) {
            const auto is_same = [&](const ExplainedFunction& other) {
                return other.function.signature == one.function.signature &&
                       other.function.stage == one.function.stage && (other.pass == 0) == (one.pass == 0) &&
                       other.pixel == one.pixel && other.size == one.size && other.calls == one.calls &&
                       other.shown == one.shown;
            };
            if (std::none_of(once.begin(), once.end(), is_same)) once.push_back(std::move(one));
        }
        return once;
    }

    int place_of(const WatchedFunction& function) const {
        for (size_t i = 0; i < functions_.size(); ++i)
            if (functions_[i].signature == function.signature && functions_[i].stage == function.stage) return int(i);
        return -1;
    }

private:
    /// A pass that draws a texture, with the functions that it calls.
    struct TexturePass {
        glm::ivec2 size;
        std::vector<int> functions;
        bool operator==(const TexturePass&) const = default;
    };

    /// A part of textures that is changed.
    struct Shaken {
        std::vector<int> passes = {};  ///< by their order among the passes that draw textures
        glm::ivec4 region{0};          ///< lower corner, and upper corner, which is outside
        int channels = 3;

        /// Returns the two halves: of the passes, or of the longer side of the only one. None for a single texel.
        std::optional<std::array<Shaken, 2>> halves() const {
            std::array<Shaken, 2> parts = {*this, *this};
            const auto middle = passes.begin() + std::ptrdiff_t(passes.size() / 2);
            const glm::ivec2 size(region.z - region.x, region.w - region.y);
            const int along = size.x >= size.y ? 0 : 1;
            if (passes.size() > 1)
                parts[0].passes.assign(passes.begin(), middle), parts[1].passes.assign(middle, passes.end());
            else if (size[along] > 1)
                parts[0].region[along + 2] = parts[1].region[along] = region[along] + size[along] / 2;
            else
                return {};
            return parts;
        }
    };

    void on_draw(const std::function<void()>& draw) {
        const GLuint program = GLuint(integer(GL_CURRENT_PROGRAM));
        const bool to_buffers = is_on(GL_RASTERIZER_DISCARD) || integer(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE) == GL_TRUE;
        if (const auto size = size_of_texture(program); size && !to_buffers) {
            const int place = int(textures_.size());
            textures_.push_back({*size, programs_[program]});
            const bool is_shaken = std::count(shaken_.passes.begin(), shaken_.passes.end(), place) > 0;
            set(program, watched::shaken, is_shaken ? shaken_.channels : 0);
            const glm::vec4 region(shaken_.region);
            glUniform4f(glGetUniformLocation(program, watched::region), region.x, region.y, region.z, region.w);
        }
        if (notes_ && program != 0 && !to_buffers && programs_.contains(program)) take_notes_of(program, draw);
        set(program, watched::flow, flow_);
        set(program, watched::rounds, flow_ != 0 ? 1 : 0);
        const bool is_picture = GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING)) == target_;
        shaken_.passes.empty() || !is_picture ? draw() : draw_pixel(draw);
    }

    /// Draws at most the pixel of the picture.
    void draw_pixel(const std::function<void()>& draw) const {
        const bool is_scissored = is_on(GL_SCISSOR_TEST);
        std::array<GLint, 4> own{};
        glGetIntegerv(GL_SCISSOR_BOX, own.data());
        const glm::ivec2 from = pixel_ - glm::ivec2(own[0], own[1]);
        if (is_scissored && (from.x < 0 || from.y < 0 || from.x >= own[2] || from.y >= own[3])) return;
        glEnable(GL_SCISSOR_TEST);
        glScissor(pixel_.x, pixel_.y, 1, 1);
        draw();
        glScissor(own[0], own[1], own[2], own[3]);
        if (!is_scissored) glDisable(GL_SCISSOR_TEST);
    }

    /// Returns the size of the texture that a watched program draws now; nothing if it draws the picture, or an input
    /// of the same size.
    std::optional<glm::ivec2> size_of_texture(GLuint program) const {
        const auto watched = programs_.find(program);
        if (watched == programs_.end() || watched->second.empty()) return {};
        std::array<GLint, 4> view{};
        glGetIntegerv(GL_VIEWPORT, view.data());
        const glm::ivec2 corner{view[0], view[1]}, end = corner + glm::ivec2(view[2], view[3]);
        const bool is_alike = corner == glm::ivec2(0) && end == shot_.size;
        const bool is_picture = GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING)) == target_;
        if (end.x <= 0 || end.y <= 0 || is_picture || is_alike) return {};
        return end;
    }

    static void set(GLuint program, const char* uniform, int value) {
        glUniform1i(glGetUniformLocation(program, uniform), value);
    }

    void take_notes_of(GLuint program, const std::function<void()>& draw) {
        const GLuint framebuffer = GLuint(integer(GL_DRAW_FRAMEBUFFER_BINDING));
        std::array<GLint, 4> view{};
        glGetIntegerv(GL_VIEWPORT, view.data());
        const glm::ivec2 corner{view[0], view[1]}, end = corner + glm::ivec2(view[2], view[3]);
        if (end.x <= 0 || end.y <= 0) return;
        const bool is_picture = framebuffer == target_, is_alike = corner == glm::ivec2(0) && end == shot_.size;
        const bool is_opaque = !is_on(GL_BLEND);
        const NoteTarget& target = note_target(is_picture ? shot_.size : end);
        const Noting noting(target);
        set(program, watched::flow, flow_);
        set(program, watched::rounds, watched::all_rounds);
        if (is_picture || is_alike)
            note_pixel(program, framebuffer, noting, draw, is_opaque, target.size());
        else if (!programs_[program].empty() && !is_alike_only_)
            note_texel(program, framebuffer, noting, draw, target.size());
        set(program, watched::noting, 0);
        set(program, watched::function, 0);
    }

    /// Notes a pass that draws the picture, or a texture of the same size: takes the same pixel.
    void note_pixel(GLuint program, GLuint framebuffer, const Noting& noting, const std::function<void()>& draw,
                    bool is_opaque, glm::ivec2 size) {
        const auto [place, is_new] = depths_.try_emplace(framebuffer, 1.0F);
        float& depth = place->second;
        const auto again = [&](const std::function<void()>& use) {
            if (!noting.aim(pixel_, {1, 1}, depth)) return;
            draw();
            use();
        };
        float after = depth;
        bool covers = false;
        set(program, watched::noting, 1);
        set(program, watched::function, 0);
        again([&] {
            covers = pixel_of(0, pixel_)[0] != nothing;
            if (covers) glReadPixels(pixel_.x, pixel_.y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &after);
        });
        if (!covers) return;
        // An opaque draw hides the earlier ones.
        if (is_opaque) std::erase_if(found_, [&](const auto& one) { return one.first.first == framebuffer; });
        for (const int function : programs_[program]) note(program, framebuffer, function, pixel_, size, true, again);
        depth = after;
    }

    /// Notes a pass that draws another input of the picture: takes the texel that find_texels() found. If the pixel
    /// reads no such pass, takes the texel that is furthest from its twin.
    void note_texel(GLuint program, GLuint framebuffer, const Noting& noting, const std::function<void()>& draw,
                    glm::ivec2 size) {
        const auto note_at = [&](int function, glm::ivec2 texel, bool is_read) {
            note(program, framebuffer, function, texel, size, is_read, [&](const std::function<void()>& use) {
                if (!noting.aim(texel, {1, 1}, 1)) return;
                draw();
                use();
            });
        };
        if (const auto read = texels_.find(int(textures_.size()) - 1); read != texels_.end()) {
            if (read->second)
                for (const int function : programs_[program]) note_at(function, *read->second, true);
            return;
        }
        for (const int function : programs_[program]) {
            choose(program, function, -1, 0);
            if (!noting.aim({0, 0}, size, 1)) continue;
            draw();
            glReadBuffer(GL_COLOR_ATTACHMENT0);
            std::vector<float> heads(size_t(size.x) * size_t(size.y) * 4);
            glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, heads.data());
            std::optional<size_t> worst;
            for (size_t i = 0; i < heads.size(); i += 4)
                if (heads[i] > 0 && (!worst || heads[i + 2] > heads[*worst + 2])) worst = i;
            if (!worst) continue;
            const auto known = found_.find({framebuffer, function});
            if (known != found_.end() && known->second.worst().excess >= double(heads[*worst + 2])) continue;
            const int at = int(*worst / 4);
            note_at(function, {at % size.x, at / size.x}, false);
        }
    }

    /// Notes a function's calls at one texel of the note target. `again` draws that texel, and then calls its argument.
    void note(GLuint program, GLuint framebuffer, int function, glm::ivec2 at, glm::ivec2 size, bool is_read,
              const std::function<void(const std::function<void()>&)>& again) {
        const WatchedFunction& watched = functions_[size_t(function)];
        ExplainedFunction noted{
            .function = watched, .pixel = {at.x, size.y - 1 - at.y}, .size = size, .is_read = is_read};
        const auto add = [&](int call) {
            std::vector<float> numbers;
            for (size_t slice = 0; slice * note_slice < watched.note_size(); ++slice) {
                choose(program, function, call, int(slice));
                again([&] {
                    for (int i = 0; i < 8; ++i)
                        for (const float number : pixel_of(i, at)) numbers.push_back(number);
                });
            }
            if (numbers.size() < watched.note_size() || !(numbers[0] > 0)) return false;
            noted.calls = int(numbers[0]);
            noted.is_unfinished |= numbers[3] > 0;
            const ExplainedCall one = read_call(watched, numbers);
            if (std::none_of(noted.shown.begin(), noted.shown.end(),
                             [&](const ExplainedCall& other) { return other.has_values_of(one); }))
                noted.shown.push_back(one);
            return true;
        };
        if (!add(-1)) return;
        // Without a difference, the call that differs most is arbitrary.
        if (noted.calls > 1 && !(noted.worst().excess > 1)) noted.shown.clear();
        if (noted.calls > 1) add(0), add(noted.calls - 1);
        std::sort(noted.shown.begin(), noted.shown.end(),
                  [](const ExplainedCall& a, const ExplainedCall& b) { return a.number < b.number; });
        if (framebuffer != target_) {
            const auto known = std::find(passes_.begin(), passes_.end(), framebuffer);
            noted.pass = 1 + int(known - passes_.begin());
            if (known == passes_.end()) passes_.push_back(framebuffer);
        }
        found_[{framebuffer, function}] = std::move(noted);
    }

    void choose(GLuint program, int function, int call, int slice) const {
        set(program, watched::function, function + 1);
        set(program, watched::stage, functions_[size_t(function)].stage);
        set(program, watched::call, call);
        set(program, watched::noting, slice + 1);
    }

    static std::array<float, 4> pixel_of(int target, glm::ivec2 at) {
        std::array<float, 4> value{};
        glReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + target));
        glReadPixels(at.x, at.y, 1, 1, GL_RGBA, GL_FLOAT, value.data());
        return value;
    }

    static ExplainedCall read_call(const WatchedFunction& watched, const std::vector<float>& numbers) {
        ExplainedCall call{.number = int(numbers[1]), .excess = double(numbers[2])};
        auto at = numbers.begin() + note_header;
        const auto take = [&](size_t count) {
            const std::vector<float> taken(at, at + std::ptrdiff_t(count));
            at += std::ptrdiff_t(count);
            return taken;
        };
        call.inputs = take(watched.input_count());
        call.results = take(watched.result_count());
        if (!watched.has_twin) return call;
        const std::vector<float> high = take(watched.result_count()), low = take(watched.result_count());
        for (size_t i = 0; i < high.size(); ++i)
            call.twin.push_back(std::isfinite(high[i]) ? double(high[i]) + double(low[i]) : double(high[i]));
        call.allowed = take(watched.result_count());
        return call;
    }

    const NoteTarget& note_target(glm::ivec2 size) {
        std::unique_ptr<NoteTarget>& target = targets_[{size.x, size.y}];
        if (!target) target = std::make_unique<NoteTarget>(size);
        return *target;
    }

    const LabEntry& entry_;
    const Shot& shot_;
    const Twins& twins_;
    std::set<std::filesystem::path> task_files_;
    std::vector<WatchedFunction> functions_;
    std::map<GLuint, std::vector<int>> programs_;
    std::map<std::pair<int, int>, std::unique_ptr<NoteTarget>> targets_;
    std::map<GLuint, float> depths_;  ///< depth at the pixel, by framebuffer
    std::vector<GLuint> passes_;
    std::map<std::pair<GLuint, int>, ExplainedFunction> found_;  ///< by framebuffer and function
    std::vector<TexturePass> textures_;                          ///< of the last draw()
    Shaken shaken_;
    /// By the order of the passes that draw textures: the texel that the pixel reads. A pass has none if the pixel
    /// reads another one of its kind, and is missing if it reads none of them.
    std::map<int, std::optional<glm::ivec2>> texels_;
    GLuint target_ = 0;
    glm::ivec2 pixel_{0};  ///< counted from the bottom row
    int flow_ = 0;
    bool notes_ = false, is_alike_only_ = false;
};

/// Draws one pixel with a fragment shader of lone_function().
class LoneProgram {
public:
    explicit LoneProgram(const std::string& fragment)
        : program_(std::vector<ShaderSource>{
              {"lone.vert",
               "#version 410 core\nvoid main() {\n"
               "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}\n",
               {},
               {}},
              {"lone.frag", fragment, {}, {}}}) {}

    /// Precondition: at most lone_size numbers.
    std::vector<float> run(const std::vector<float>& numbers, size_t result_count) const {
        const Target target(TargetKind::probe, {1, 1});
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glViewport(0, 0, 1, 1);
        for (const GLenum capability : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) glDisable(capability);
        glUseProgram(program_);
        glUniform1fv(glGetUniformLocation(program_, lone_numbers), GLsizei(numbers.size()), numbers.data());
        glBindVertexArray(nothing_);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        const Image image = target.read();
        return {image.values.begin(), image.values.begin() + std::ptrdiff_t(result_count)};
    }

private:
    Program program_;
    VertexArrayName nothing_;
};

/// The programs of functions by themselves, each compiled once.
class LonePrograms {
public:
    /// Returns null for a function that is not alone.
    const LoneProgram* of(const std::map<GLuint, std::string>& fragments, const std::string& signature) {
        if (const auto known = programs_.find(signature); known != programs_.end()) return known->second.get();
        std::unique_ptr<LoneProgram>& made = programs_[signature];
        for (const auto& [program, fragment] : fragments) {
            const std::string text = lone_function(fragment, signature);
            if (text.empty()) continue;
            try {
                made = std::make_unique<LoneProgram>(text);
            } catch (const Error&) {  // it reads more than its arguments
            }
            break;
        }
        return made.get();
    }

private:
    std::map<std::string, std::unique_ptr<LoneProgram>> programs_;
};

/// Digits of arguments that a person computes with.
constexpr int argument_digits = 4;

/// Returns nothing if an argument cannot be shown.
std::optional<LoneCall> lone_call(const ExplainedFunction& one, const ExplainedCall& call, const LoneProgram& program) {
    LoneCall lone{.name = one.function.name,
                  .file = one.function.place.file.lexically_relative(course_root()).string(),
                  .line = int(one.function.place.line),
                  .number = call.number,
                  .count = one.calls,
                  .arguments = {},
                  .inputs = {},
                  .results = call.results,
                  .again = {}};
    const float* at = call.inputs.data();
    for (const ValueShape& shape : one.function.inputs) {
        const ShownValue value = shown_value(shape, at, argument_digits);
        if (value.text.empty()) return {};
        lone.arguments.push_back(shape.name + " " + value.text);
        lone.inputs.insert(lone.inputs.end(), value.numbers.begin(), value.numbers.end());
    }
    if (lone.inputs.size() > lone_size || lone.results.size() > 4) return {};
    lone.again = program.run(lone.inputs, lone.results.size());
    return lone;
}

std::set<std::string> shader_task_files(const Manifest& manifest) {
    std::set<std::string> files;
    for (const TaskInfo& task : manifest.tasks)
        if (is_shader(task.file)) files.insert(task.file);
    return files;
}

/// Returns a direction normalised, for probes whose length is arbitrary.
std::vector<float> without_length(std::vector<float> value) {
    const float length = std::sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
    if (std::isfinite(length) && length > 0)
        for (float& number : value) number /= length;
    return value;
}

/// Returns whether two values of a pixel differ by rounding only. A picture may differ by one step of 8 bits. `probe`
/// is null for a picture.
bool is_same(std::vector<float> a, std::vector<float> b, const ProbeInfo* probe) {
    if (probe && probe->any_length) a = without_length(a), b = without_length(b);
    for (size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) continue;
        const float size = std::max(std::abs(a[i]), std::abs(b[i]));
        if (!std::isfinite(size)) return false;
        if (!(std::abs(a[i] - b[i]) <= (probe ? 1e-5F * size + 1e-7F : 1.5F / 255))) return false;
    }
    return true;
}

}  // namespace

const ExplainedCall& ExplainedFunction::worst() const {
    return *std::max_element(shown.begin(), shown.end(),
                             [](const ExplainedCall& a, const ExplainedCall& b) { return a.excess < b.excess; });
}

Explanation explain(const LabEntry& lab, const Manifest& manifest, const Shot& shot, glm::ivec2 pixel,
                    const Twins& twins) {
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= shot.size.x || pixel.y >= shot.size.y)
        throw UsageError(
            fmt::format("the picture is {} x {} pixels: columns 0 to {}, rows 0 to {} from the top; there is no {},{}",
                        shot.size.x, shot.size.y, shot.size.x - 1, shot.size.y - 1, pixel.x, pixel.y));
    const ProbeInfo* const probe = shot.probe ? &manifest.probe(shot.probe.name) : nullptr;
    Watched watched(lab, shader_task_files(manifest), shot, twins);
    Explanation result;
    result.value = watched.draw(pixel, 0, true);
    if (watched.find_texels(pixel, result.value)) watched.draw(pixel, 0, true);
    result.functions = watched.take_notes();
    // Finds the first function that differs and matters: replacing it with its twin changes the pixel.
    const auto find_first = [&](const std::vector<ExplainedFunction>& functions) -> std::optional<size_t> {
        for (size_t i = 0; i < functions.size(); ++i) {
            if (!functions[i].differs()) continue;
            const int flow = 1 + watched.place_of(functions[i].function);
            if (!is_same(watched.draw(pixel, flow, false), result.value, probe)) return i;
        }
        return {};
    };
    result.first = find_first(result.functions);
    if (result.first || twins.empty()) return result;
    // A function may affect the pixel only if the functions before it are right.
    const bool changes = !is_same(watched.draw(pixel, -1, true), result.value, probe);
    std::vector<ExplainedFunction> with_twins = watched.take_notes();
    if (!changes) return result;
    if (const auto first = find_first(with_twins)) {
        result.functions = std::move(with_twins);
        result.first = first;
        result.with_twins = true;
    }
    return result;
}

std::vector<std::vector<LoneCall>> lone_calls(const LabEntry& lab, const std::set<std::string>& files, const Shot& shot,
                                              const std::vector<glm::ivec2>& pixels) {
    const Twins no_twins;
    Watched watched(lab, files, shot, no_twins);
    std::map<GLuint, std::string> fragments;
    std::vector<std::vector<ExplainedFunction>> notes(pixels.size());
    watched.note_pixels(pixels, fragments, [&](size_t pixel, std::vector<ExplainedFunction> functions) {
        notes[pixel] = std::move(functions);
    });
    LonePrograms programs;
    std::vector<std::vector<LoneCall>> calls(pixels.size());
    for (size_t i = 0; i < pixels.size(); ++i)
        for (const ExplainedFunction& one : notes[i]) {
            const bool is_here = one.pixel == pixels[i] && one.size == shot.size;
            if (!is_here || one.is_unfinished || one.function.stage != WatchedFunction::fragment) continue;
            const LoneProgram* const program = programs.of(fragments, one.function.signature);
            if (!program) continue;
            for (const ExplainedCall& call : one.shown)
                if (auto lone = lone_call(one, call, *program)) calls[i].push_back(*std::move(lone));
        }
    return calls;
}

}  // namespace relief::check
