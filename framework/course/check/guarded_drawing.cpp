#include "framework/course/check/guarded_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/folded_text.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/process.h"
#include "framework/core/base/system.h"
#include "framework/core/lab/registry.h"
#include "framework/course/check/kept_lab.h"

namespace relief::check {
namespace {

using nlohmann::json;

constexpr size_t longest_error = 4000;
constexpr size_t longest_request = (size_t{4} << 20) + longest_compiled;
constexpr size_t longest_notes = size_t{1} << 20;

enum class Kind : uint32_t { ask, ready, image, error, done, notes, compiled, no_memory };

/// Precedes each message. Both ends are on one machine, so byte order and padding agree.
struct Header {
    uint32_t magic = 0x464c5231;  // "1RLF"
    Kind kind = Kind::ask;
    uint32_t shot = 0;
    uint32_t size = 0;  ///< bytes that follow
    float cpu = 0;      ///< seconds of processor time since the previous message; 0 unless an image or an error
};

size_t pixel_bytes(const Shot& shot) {
    return size_t(shot.size.x) * size_t(shot.size.y) * (shot.probe ? 4 * sizeof(float) : 3);
}

json as_json(const Shot& shot) {
    const Orbit& camera = shot.camera;
    json text = {{"size", {shot.size.x, shot.size.y}},
                 {"time", shot.time},
                 {"camera",
                  {camera.yaw, camera.pitch, camera.distance, camera.target.x, camera.target.y, camera.target.z,
                   camera.field_of_view}},
                 {"probe", shot.probe.name},
                 {"set", shot.set}};
    if (shot.calls)
        text["calls"] = {{"file", shot.calls.file}, {"texts", shot.calls.texts}, {"includes", shot.calls.includes}};
    return text;
}

Shot shot_of(const json& from) {
    Shot shot;
    shot.size = {from.at("size").at(0).get<int>(), from.at("size").at(1).get<int>()};
    shot.time = from.at("time");
    const auto camera = from.at("camera").get<std::array<double, 7>>();
    shot.camera = {camera[0], camera[1], camera[2], {camera[3], camera[4], camera[5]}, camera[6]};
    shot.probe.name = from.at("probe");
    shot.set = from.at("set").get<decltype(shot.set)>();
    if (from.contains("calls")) {
        const json& calls = from.at("calls");
        shot.calls = {calls.at("file"), calls.at("texts"), calls.at("includes")};
    }
    return shot;
}

json as_json(const LoneCall& call) {
    return {{"name", call.name},     {"file", call.file},       {"line", call.line},
            {"number", call.number}, {"count", call.count},     {"arguments", call.arguments},
            {"inputs", call.inputs}, {"results", call.results}, {"again", call.again}};
}

/// Throws std::exception for anything else.
LoneCall call_of(const json& from) {
    LoneCall call{.name = from.at("name"),
                  .file = from.at("file"),
                  .line = from.at("line"),
                  .number = from.at("number"),
                  .count = from.at("count"),
                  .arguments = from.at("arguments"),
                  .inputs = from.at("inputs"),
                  .results = from.at("results"),
                  .again = from.at("again")};
    if (call.results.empty() || call.results.size() > 4 || call.again.size() != call.results.size())
        throw std::length_error("a call has one to four results");
    return call;
}

/// Returns the calls at each pixel as JSON, which has no infinity: such calls are omitted.
std::string notes_of(const std::vector<std::vector<LoneCall>>& pixels) {
    json all = json::array();
    for (const std::vector<LoneCall>& calls : pixels) {
        json& here = all.emplace_back(json::array());
        for (const LoneCall& call : calls) {
            const auto is_finite = [](const std::vector<float>& numbers) {
                return std::all_of(numbers.begin(), numbers.end(), [](float number) { return std::isfinite(number); });
            };
            if (is_finite(call.results) && is_finite(call.again)) here.push_back(as_json(call));
        }
    }
    return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Returns a probe's floats unchanged, and a picture's values as bytes: they are multiples of 1/255.
std::string bytes_of(const Image& image, bool probe) {
    std::string bytes;
    if (probe) {
        bytes.assign(reinterpret_cast<const char*>(image.values.data()), image.values.size() * sizeof(float));
    } else {
        bytes.reserve(image.values.size());
        for (const float value : image.values) bytes += static_cast<char>(std::lround(value * 255));
    }
    return bytes;
}

Image image_of(const char* bytes, const Shot& shot) {
    Image image(shot.size.x, shot.size.y, shot.probe ? 4 : 3, shot.probe ? 32 : 8);
    if (shot.probe)
        std::memcpy(image.values.data(), bytes, image.values.size() * sizeof(float));
    else
        for (size_t i = 0; i < image.values.size(); ++i)
            image.values[i] = float(static_cast<unsigned char>(bytes[i])) / 255.0f;
    return image;
}

/// The output stream. Text that a student's code prints to standard output goes to standard error instead.
class Stream {
public:
    Stream() { os::redirect(standard_output, standard_error); }

    void send(Kind kind, size_t shot, std::string_view bytes) {
        const double now = os::processor_seconds(), spent = now - std::exchange(cpu_, now);
        // The first message must have the same bytes in every process; see drawing_asks().
        const bool is_drawn = kind == Kind::image || kind == Kind::error;
        const Header header{
            .kind = kind, .shot = uint32_t(shot), .size = uint32_t(bytes.size()), .cpu = is_drawn ? float(spent) : 0};
        if (!write_all(descriptor_, {reinterpret_cast<const char*>(&header), sizeof header}) ||
            !write_all(descriptor_, bytes))
            std::_Exit(1);  // the reader is gone
    }

private:
    const Descriptor descriptor_ = os::copy_of(standard_output);
    double cpu_ = 0;  ///< at the last message
};

/// Says that memory ran out, and ends the process. Allocates nothing.
[[noreturn]] void end_without_memory(Stream& stream) {
    stream.send(Kind::no_memory, 0, {});
    std::_Exit(1);
}

/// Returns os::processor_seconds() as bytes.
std::string processor_time() {
    const double seconds = os::processor_seconds();
    return {reinterpret_cast<const char*>(&seconds), sizeof seconds};
}

/// Reads the request to its end and closes the descriptor, so that a student's code cannot read it.
std::string read_request() {
    const Descriptor from(request_descriptor);
    std::string text;
    char block[1 << 14];
    while (text.size() <= longest_request) {
        const size_t got = read_up_to(from, block, sizeof block).value_or(0);
        text.append(block, got);
        if (got < sizeof block) break;
    }
    return text;
}

/// Returns the error that `call` throws, or nothing: one line, then the compiler's further lines. Ends the process if
/// memory runs out.
template <class Call>
std::string error_of(Stream& stream, Call call) {
    try {
        call();
        return {};
    } catch (const Error& error) {
        const FoldedText parts = unfolded_text(error.details());
        std::string text = std::string(error.what()) + (parts.shown.empty() ? "" : "\n" + parts.shown);
        for (const std::string& message : parts.folded) text += (text.ends_with('\n') ? "" : "\n") + message;
        return text;
    } catch (const std::bad_alloc&) {
        end_without_memory(stream);
    } catch (const std::exception& error) {
        return std::string("it throws: ") + error.what();
    } catch (...) {
        return "it throws something that is no std::exception";
    }
}

std::string notes_in(const LabEntry& lab, const Shot& shot, const std::set<std::string>& files, const json& pixels) {
    std::vector<glm::ivec2> at;
    for (const json& pixel : pixels) at.emplace_back(pixel.at(0).get<int>(), pixel.at(1).get<int>());
    return notes_of(lone_calls(lab, files, shot, at));
}

/// Returns whether the protocol allows this message now. The header is not trusted: it can hold any values.
bool is_expected(const Header& header, const DrawnShots& drawn, const std::vector<Shot>& shots) {
    if (header.magic != Header{}.magic) return false;
    const bool is_ready = drawn.phase == DrawingPhase::ready;
    const size_t next = drawn.shots.size();
    const bool is_next = is_ready && next < shots.size() && header.shot == next;
    switch (header.kind) {
        case Kind::ask:
            return drawn.phase == DrawingPhase::started && header.size == 0;
        case Kind::ready:
            return drawn.phase == DrawingPhase::asked && header.size == 0;
        case Kind::image:
            return is_next && header.size == pixel_bytes(shots[next]);
        case Kind::error:
            return is_next && header.size <= longest_error;
        case Kind::done:
            return is_ready && header.size == sizeof(double);
        case Kind::compiled:
            return is_ready && next == shots.size() && drawn.compiled.empty() && header.size <= longest_compiled;
        case Kind::no_memory:
            return header.size == 0;
        case Kind::notes:
            return false;
    }
    return false;
}

}  // namespace

std::string drawing_request(const LabEntry& lab, const std::vector<Shot>& shots, const Renderer& renderer,
                            const ShaderReuse& reuse) {
    json request = {{"lab", lab.folder},
                    {"context", renderer.context ? name_of(*renderer.context) : "auto"},
                    {"threads", renderer.threads},
                    {"pinned", renderer.pinned},
                    {"returns_compiled", reuse.returns},
                    {"shots", json::array()}};
    for (const Shot& shot : shots) request["shots"].push_back(as_json(shot));
    const std::string text = request.dump();  // has no character 0, so it begins after the last one
    return reuse.known.empty() ? text : packed(reuse.known) + '\0' + text;
}

std::string noting_request(const LabEntry& lab, const std::set<std::string>& files, const std::vector<NotedShot>& shots,
                           const Renderer& renderer) {
    std::vector<Shot> drawn;
    json pixels = json::array();
    for (const NotedShot& one : shots) {
        drawn.push_back(one.shot);
        json& here = pixels.emplace_back(json::array());
        for (const glm::ivec2 pixel : one.pixels) here.push_back({pixel.x, pixel.y});
    }
    json request = json::parse(drawing_request(lab, drawn, renderer));
    request["notes"] = {{"files", files}, {"pixels", pixels}};
    return request.dump();
}

std::string drawing_asks() {
    const Header header;
    return {reinterpret_cast<const char*>(&header), sizeof header};
}

void draw_request(const char* course) {
    static Stream stream;
    std::set_new_handler([] { end_without_memory(stream); });
    const CourseElsewhere elsewhere(course);
    stream.send(Kind::ask, 0, {});
    const std::string text = read_request();
    const size_t begin = text.rfind('\0') + 1;  // 0 if there are no compiled shaders
    const json request = json::parse(text.begin() + std::ptrdiff_t(begin), text.end());
    const LabEntry& lab = find_lab(request.at("lab").get<std::string>());
    std::vector<Shot> shots;
    for (const json& one : request.at("shots")) shots.push_back(shot_of(one));
    if (request.at("pinned")) pin_software_renderer();
    os::set_environment("LP_NUM_THREADS", std::to_string(request.at("threads").get<int>()));
    const char* const cache = std::getenv("MESA_SHADER_CACHE_DIR");
    if (!cache)
        os::set_environment("MESA_SHADER_CACHE_DISABLE", "true");
    else if (begin > 0)
        write_compiled(cache, unpacked(std::string_view(text).substr(0, begin - 1)));
    const auto context = open_context(context_kind(request.at("context")));
    stream.send(Kind::ready, 0, {});
    const json notes = request.value("notes", json());
    KeptLab kept(lab);
    for (size_t i = 0; i < shots.size(); ++i) {
        std::string answer;
        const std::string error = error_of(stream, [&] {
            answer = notes.is_null() ? bytes_of(draw_shot(kept.drawer_of(shots[i]), shots[i]), bool(shots[i].probe))
                                     : notes_in(lab, shots[i], notes.at("files"), notes.at("pixels").at(i));
        });
        if (error.empty()) {
            stream.send(notes.is_null() ? Kind::image : Kind::notes, i, answer);
        } else {
            kept.forget();
            stream.send(Kind::error, i, error.substr(0, longest_error));
        }
    }
    if (cache && request.at("returns_compiled"))
        stream.send(Kind::compiled, shots.size(), packed(read_compiled(cache)));
    stream.send(Kind::done, shots.size(), processor_time());
    std::_Exit(0);  // skips the tear-down of the driver, which takes time
}

DrawnShots read_drawings(const std::string& stream, const std::vector<Shot>& shots) {
    DrawnShots drawn;
    for (size_t at = 0; at < stream.size() && drawn.phase != DrawingPhase::done;) {
        Header header;
        if (stream.size() - at < sizeof header) break;
        std::memcpy(&header, stream.data() + at, sizeof header);
        at += sizeof header;
        if (!is_expected(header, drawn, shots)) {
            drawn.problem = "it writes something other than its drawing to standard output";
            break;
        }
        if (stream.size() - at < header.size) break;  // the process ended in the middle of a message
        const size_t next = drawn.shots.size();
        switch (header.kind) {
            case Kind::ask:
                drawn.phase = DrawingPhase::asked;
                break;
            case Kind::ready:
                drawn.phase = DrawingPhase::ready;
                break;
            case Kind::image:
                drawn.shots.push_back({image_of(stream.data() + at, shots[next]), {}, header.cpu});
                break;
            case Kind::error:
                drawn.shots.push_back({{}, stream.substr(at, header.size), header.cpu});
                break;
            case Kind::done:
                if (next == shots.size()) drawn.phase = DrawingPhase::done;
                std::memcpy(&drawn.cpu, stream.data() + at, sizeof drawn.cpu);
                break;
            case Kind::compiled:
                drawn.compiled = unpacked(std::string_view(stream).substr(at, header.size));
                break;
            case Kind::no_memory:
                drawn.has_no_memory = true;
                return drawn;
            case Kind::notes:
                break;
        }
        at += header.size;
    }
    return drawn;
}

size_t drawings_size(const std::vector<Shot>& shots) {
    size_t size = 4 * sizeof(Header) + sizeof(double) + longest_compiled;
    for (const Shot& shot : shots) size += sizeof(Header) + std::max(pixel_bytes(shot), longest_error);
    return size;
}

NotedCalls read_notes(const std::string& stream, const std::vector<NotedShot>& shots) {
    NotedCalls calls(shots.size());
    for (size_t at = 0; stream.size() - at >= sizeof(Header);) {
        Header header;
        std::memcpy(&header, stream.data() + at, sizeof header);
        at += sizeof header;
        if (header.magic != Header{}.magic || header.size > stream.size() - at) return calls;
        const std::string_view bytes = std::string_view(stream).substr(at, header.size);
        at += header.size;
        if (header.kind != Kind::notes || header.shot >= shots.size()) continue;
        try {
            std::vector<std::vector<LoneCall>> pixels;
            for (const json& pixel : json::parse(bytes)) {
                std::vector<LoneCall>& here = pixels.emplace_back();
                for (const json& call : pixel) here.push_back(call_of(call));
            }
            if (pixels.size() == shots[header.shot].pixels.size()) calls[header.shot] = std::move(pixels);
        } catch (const std::exception&) {  // not what the process was asked for
        }
    }
    return calls;
}

size_t notes_size(const std::vector<NotedShot>& shots) {
    return 3 * sizeof(Header) + sizeof(double) + shots.size() * (sizeof(Header) + longest_notes);
}

}  // namespace relief::check
