#include "framework/course/window/menu_error_map.h"
#include "framework/course/manifest/no_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <system_error>
#include <thread>

#include "framework/core/base/cancel.h"
#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/text.h"
#include "framework/course/pages/method_comparison.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_present.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_words.h"
#include "framework/library/kit/made_map.h"
#include "framework/library/kit/obj_scene.h"
#include "framework/library/kit/own_mesh.h"
#include "framework/library/maps/own_picture.h"
#include "framework/library/maps/visualize.h"

namespace relief::window {

void draw_heat(ImDrawList& list, ImVec2 low, ImVec2 high) {
    constexpr int steps = 5;  // visualize_error() interpolates linearly between these colours
    Image values(steps + 1, 1, 1);
    for (int i = 0; i <= steps; ++i) values.values[size_t(i)] = float(i) / steps;
    const Image colors = visualize_error(values, 1);
    const auto color = [&](int i) {
        const float* const c = colors.pixel(i, 0);
        return ImGui::ColorConvertFloat4ToU32({c[0], c[1], c[2], 1});
    };
    const float width = high.x - low.x;
    for (int i = 0; i < steps; ++i)
        list.AddRectFilledMultiColor({low.x + width * float(i) / steps, low.y},
                                     {low.x + width * float(i + 1) / steps, high.y}, color(i), color(i + 1),
                                     color(i + 1), color(i));
}

void draw_heat_scale(const std::vector<std::string>& marks, float width) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight() * 0.6f;
    draw_heat(*ImGui::GetWindowDrawList(), corner, {corner.x + width, corner.y + height});
    ImGui::Dummy({width, height});
    const float left = ImGui::GetCursorPosX();
    const float last = width - ImGui::CalcTextSize(marks.back().c_str()).x;
    for (size_t i = 0; i < marks.size(); ++i) {
        const float share = float(i) / float(marks.size() - 1), wide = ImGui::CalcTextSize(marks[i].c_str()).x;
        if (i > 0 && i + 1 < marks.size() && width * share + wide > last) continue;  // it would touch the last mark
        if (i > 0) ImGui::SameLine();
        // Centred below its colour, but within the scale.
        ImGui::SetCursorPosX(left + std::clamp(width * share - wide / 2, 0.0f, std::max(0.0f, width - wide)));
        ImGui::TextColored(quiet, "%s", marks[i].c_str());
    }
}

namespace {

/// Returns the words of the stage's picture. A probe has none. Then draws the picture small: only the places matter.
std::vector<PictureWord> words_of(const Stage& stage) {
    if (!stage.probe()) return stage.words();
    Shot shot = stage.shot();
    shot.probe = {};
    shot.size = glm::max(shot.size / 4, glm::ivec2(1));
    const Target target(TargetKind::picture, shot.size);
    std::vector<PictureWord> words;
    shot.words = &words;
    draw_lab(*stage.lab(), frame_of(shot, target));
    return words;
}

/// Draws the scale of pages::error_map().
void draw_log_scale(double max, const std::string& unit) {
    draw_heat_scale({rounded(max / 1000), rounded(max / 100), rounded(max / 10), amount_of(max, unit) + " and more"},
                    ImGui::GetContentRegionAvail().x);
}

bool have_same_contents(const OwnFile& one, const OwnFile& other) {
    const auto same_mesh = [](const Mesh& a, const Mesh& b) {
        return a.indices == b.indices && std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                                                    b.vertices.end(), [](const Vertex& v, const Vertex& w) {
                                                        return v.position == w.position && v.normal == w.normal &&
                                                               v.uv == w.uv;
                                                    });
    };
    if (const auto* const picture = dynamic_cast<const OwnPicture*>(&one))
        return picture->image().values == dynamic_cast<const OwnPicture&>(other).image().values;
    if (const auto* const mesh = dynamic_cast<const OwnMesh*>(&one))
        return same_mesh(mesh->mesh(), dynamic_cast<const OwnMesh&>(other).mesh());
    if (const auto* const model = dynamic_cast<const OwnObj*>(&one))
        return same_mesh(model->model().mesh, dynamic_cast<const OwnObj&>(other).model().mesh);
    return false;
}

}  // namespace

/// Exact values, computed on a thread by another object of the stage's lab. It reads the user's files again, because
/// the thread may not touch the stage's lab.
struct ErrorMap::Work {
    const LabEntry& entry;
    const Shot settings;
    Frame frame;
    std::vector<ProbeInfo> probes;
    Image paint = {};
    std::unique_ptr<Lab> lab = {};
    std::atomic<bool> cancelled = false, ended = false;
    // Results, once it has ended: the exact values of probes.front(), or why there are none.
    std::optional<Image> exact = {};
    std::string failure = {};
    std::thread thread = {};

    explicit Work(const Stage& stage)
        : entry(stage.entry()), settings(stage.settings()), frame(stage.frame()), probes(stage.manifest().probes) {
        if (frame.probe) {
            probes = {stage.manifest().probe(frame.probe.name)};
        } else {
            // For a picture, prefer the probe by which the lab's page compares methods.
            const auto& compare = stage.manifest().compare;
            const std::string chief = compare ? compare->shot.probe.name : "";
            std::stable_partition(probes.begin(), probes.end(),
                                  [&](const ProbeInfo& one) { return one.name == chief; });
        }
        if (auto* const from = dynamic_cast<Paintable*>(stage.lab())) paint = from->paint_layer().values();
    }
    ~Work() {
        cancelled = true;
        if (thread.joinable()) thread.join();
    }

    void run() noexcept {
        try {
            const CancelledBy cancel(cancelled);
            lab = make_lab(entry, settings);
            if (auto* const to = dynamic_cast<Paintable*>(lab.get()); to && !paint.values.empty())
                to->paint_layer().set(std::move(paint));
            while (!cancelled && !exact && !probes.empty()) {
                frame.probe = {probes.front().name, MissingTask::told};
                exact = lab->truth(frame);
                if (!exact) probes.erase(probes.begin());
            }
            if (!cancelled && !exact) failure = capitalized(no_truth(entry, settings)) + ".";
        } catch (const Cancelled&) {
        } catch (const std::exception& error) {  // includes exceptions from a lab: the window stays open
            failure = error.what();
        }
        ended = true;
    }
};

ErrorMap::ErrorMap() = default;
ErrorMap::~ErrorMap() = default;

void ErrorMap::forget() {
    if (work_) work_->cancelled = true;
    done_ = false;
    picture_.reset(), compared_.reset();
    tiles_.clear();
    message_.clear();
}

void ErrorMap::fail(const std::string& message) {
    done_ = true;
    message_ = message;
    print_event("error map: " + message_);
}

bool ErrorMap::begin(const Stage& stage) {
    try {
        if (!stage.lab() || stage.failed()) throw Error("There is no picture to compare.");
        work_ = std::make_unique<Work>(stage);
    } catch (const std::exception& error) {
        fail(error.what());
        return true;
    }
    try {
        work_->thread = std::thread([work = work_.get()] { work->run(); });
        print_event(fmt::format("exact values: {}x{}", work_->frame.size.x, work_->frame.size.y));
    } catch (const std::system_error&) {  // the system has no more threads: use this one
        work_->run();
    }
    return false;
}

bool ErrorMap::finish(Stage& stage) {
    if (!work_ || !work_->ended) return false;
    const std::unique_ptr<Work> work = std::move(work_);
    if (work->cancelled) print_event("exact values: dropped");
    // A change that is not drawn yet makes them out of date, too.
    if (work->cancelled || stage.is_due(stage.size(), stage.shot().time)) return false;
    try {
        compare(stage, *work);
        done_ = true;
    } catch (const std::exception& error) {
        fail(error.what());
    }
    return true;
}

void ErrorMap::compare(Stage& stage, const Work& work) {
    if (!work.exact) throw Error(work.failure);
    const auto ours = files_of(*stage.lab()), theirs = files_of(*work.lab);
    for (size_t i = 0; i < ours.size(); ++i)
        if (!have_same_contents(*ours[i].second, *theirs.at(i).second))
            throw Error({ours[i].second->file()}, "has changed since it was loaded: load it again");
    const ProbeInfo& probe = work.probes.front();
    const Image& exact = *work.exact;
    const Target target(TargetKind::probe, work.frame.size);
    Frame frame = work.frame;
    frame.target = target.framebuffer();
    draw_lab(*stage.lab(), frame);
    Image values = target.read();
    const Image error = error_image(values, exact, probe.error);
    error_ = summarize(error);
    const std::string nothing = nothing_to_compare(values, exact, error_);
    if (!nothing.empty() && error_.missing + error_.not_finite == 0)  // otherwise these pixels are magenta
        throw Error(fmt::format("Probe {}: {}.", probe.name, nothing));
    one_sided_ = one_sided(values, exact).count();
    const double scale = pages::error_map_max(error_.p99);
    Image shown = error;
    mark_one_sided(shown, values, exact, scale);
    compared_ = {probe, std::move(values), exact, error};
    tiles_ = tile_means(words_of(stage), error);
    picture_.emplace(
        "error map", [&] { return pages::error_map(scale, shown); },
        TextureOptions{.wrap = Wrap::clamp, .mips = false});
    bind(0, *picture_);  // uploads it now, while `error` is in scope
    print_event(fmt::format("error map: {}, mean {}, rms {}, 99 % {}, largest {}, over {} pixels", probe.name,
                            amount_of(error_.mean, probe.unit, 6), plain(error_.rms), plain(error_.p99),
                            plain(error_.largest), error_.count));
}

std::vector<Box> ErrorMap::draw(const Box& box, bool moves) const {
    if (on_ && !done_)
        draw_note(box, moves ? "the error map needs a paused animation: press space" : "computing the exact values ...",
                  true);
    if (!on_ || !picture_) return {};
    const ImVec2 low{float(box.at.x), float(box.at.y)}, high{float(box.right()), float(box.bottom())};
    // Row 0 of a texture is the bottom.
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddImage(texture_id(*picture_), low, high, {0, 1}, {1, 0});
    std::vector<PictureWord> means;
    for (const TileMean& tile : tiles_)
        means.push_back({.kind = PictureWord::Kind::caption,
                         .place = tile.place,
                         .size = tile.size,
                         .text = amount_of(tile.mean, compared_->probe.unit),
                         .line = tile.foot > 0 ? 0 : -1,
                         .foot = tile.foot});
    return draw_words(std::move(means), box, 0, box.size.x + 1);
}

void ErrorMap::draw_legend(const Box& box, const std::string& probe) const {
    if (box.size.y == 0) return;
    begin_in(box, "error map", ImGui::GetStyle().WindowPadding, true);
    if (ImGui::BeginTable("halves", 2, ImGuiTableFlags_SizingStretchSame)) {
        ImGui::TableNextColumn();
        push_font(font(FontRole::bold));
        wrapped("Left: " + (probe.empty() ? "the picture" : probe));
        ImGui::PopFont();
        if (picture_) draw_notes();
        ImGui::TableNextColumn();
        push_font(font(FontRole::bold));
        wrapped(picture_ ? fmt::format("Right: the error of {}", compared_->probe.name) : "Right: the error map");
        ImGui::PopFont();
        if (!picture_)
            wrapped(message_);
        else if (error_.count > 0 && error_.largest == 0)
            wrapped("None: every pixel has the exact value.");
        else if (error_.count > 0)
            draw_log_scale(pages::error_map_max(error_.p99), compared_->probe.unit);
        ImGui::EndTable();
    }
    ImGui::End();
}

void ErrorMap::draw_notes() const {
    if (error_.count > 0)
        wrapped(fmt::format("error{}: mean {}, 99 % below {}, largest {}", tiles_.empty() ? "" : " in all",
                            rounded(error_.mean), rounded(error_.p99),
                            amount_of(error_.largest, compared_->probe.unit)));
    if (one_sided_ > 0)
        quiet_text(fmt::format("{} pixels, in the lightest colour: a surface in only one of the two", one_sided_));
    if (error_.missing > 0)
        quiet_text(fmt::format("{} pixels, in magenta: a task that is not written yet", error_.missing));
    if (error_.not_finite > 0)
        colored_text(alarm, fmt::format("{} pixels, in magenta: NaN or infinite", error_.not_finite));
}

}  // namespace relief::window
