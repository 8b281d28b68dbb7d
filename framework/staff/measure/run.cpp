#include "framework/staff/measure/run.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"
#include "framework/core/base/process.h"
#include "framework/core/gl/gl.h"
#include "framework/core/gl/object.h"

namespace relief::measure {
namespace {

using nlohmann::json;

json as_json(const Image& image) {
    if (image.width == 0) return nullptr;
    std::vector<uint8_t> bytes(image.values.size());
    for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = uint8_t(std::lround(image.values[i] * 255));
    return {{"width", image.width}, {"channels", image.channels}, {"bytes", json::binary(std::move(bytes))}};
}

Image image_from(const json& message) {
    if (message.is_null()) return {};
    const auto& bytes = message.at("bytes").get_binary();
    const int width = message.at("width"), channels = message.at("channels");
    Image image(width, int(bytes.size()) / (width * channels), channels, 8);
    for (size_t i = 0; i < bytes.size(); ++i) image.values[i] = float(bytes[i]) / 255;
    return image;
}

json as_json(const BenchSweep& sweep) {
    json places = json::array();
    for (const BenchSweep::Place& place : sweep.places)
        places.push_back({place.hardness, place.error, place.not_finite, place.endless});
    return {{"stated", sweep.stated}, {"why", sweep.why}, {"places", places}};
}

BenchSweep sweep_from(const json& message) {
    BenchSweep sweep{message.at("stated"), message.at("why"), {}};
    for (const json& place : message.at("places")) sweep.places.push_back({place[0], place[1], place[2], place[3]});
    return sweep;
}

json as_json(const BenchSubject& subject) {
    const BenchError& error = subject.error;
    return {{"items", subject.items},
            {"bytes", subject.bytes_per_item},
            {"work", subject.work},
            {"error", {error.mean, error.p99, error.largest}},
            {"unit", error.unit},
            {"wrong", error.wrong ? json(*error.wrong) : json()},
            {"picture", as_json(subject.picture)},
            {"error_map", as_json(subject.error_map)},
            {"max", subject.error_map_max},
            {"sweep", subject.sweep ? as_json(*subject.sweep) : json()}};
}

void read_subject(const json& message, BenchRow& row) {
    row.items = message.at("items");
    row.bytes_per_item = message.at("bytes");
    row.work = message.at("work");
    const auto& error = message.at("error");
    row.error = {error[0], error[1], error[2], message.at("unit")};
    if (!message.at("wrong").is_null()) row.error.wrong = message.at("wrong").get<double>();
    row.picture = image_from(message.at("picture"));
    row.error_map = image_from(message.at("error_map"));
    row.error_map_max = message.at("max");
    if (!message.at("sweep").is_null()) row.sweep = sweep_from(message.at("sweep"));
}

/// Sends a message from the measuring process: a length, then CBOR, which can represent infinity.
void send(int pipe, const json& message) {
    const std::vector<uint8_t> bytes = json::to_cbor(message);
    const uint32_t size = uint32_t(bytes.size());
    if (!write_all(pipe, {reinterpret_cast<const char*>(&size), sizeof size}) ||
        !write_all(pipe, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}))
        _exit(1);  // the reader is gone
}

std::optional<json> receive(int pipe) {
    uint32_t size = 0;
    if (!read_all(pipe, &size, sizeof size)) return {};
    std::vector<uint8_t> bytes(size);
    if (!read_all(pipe, bytes.data(), size)) return {};
    return json::from_cbor(bytes);
}

/// Returns why a subject has no valid results, or "".
std::string fault_of(const BenchSubject& subject) {
    const BenchError& error = subject.error;
    bool finite = std::isfinite(error.mean) && std::isfinite(error.p99) && std::isfinite(error.largest) &&
                  std::isfinite(error.wrong.value_or(0));
    for (const auto& [name, amount] : subject.work) finite = finite && std::isfinite(amount);
    return finite ? "" : "failed: its result is not a number";
}

/// Runs in the measuring process: prepares and times the methods of a scene that have not failed before.
class Measuring {
public:
    Measuring(const BenchTopic& topic, const BenchScene& scene, const BenchRun& run, int pipe, volatile int& current)
        : topic_(topic), scene_(scene), run_(run), pipe_(pipe), current_(current) {}

    void measure(std::vector<size_t> methods) {
        if (run_.pinned) pin_software_renderer();
        if (run_.settings.repeats > 0 && !topic_.sweeps) optimize_shaders();  // sweeps draw a picture once
        const auto context = topic_.draws ? open_context(run_.context) : nullptr;
        is_on_gpu_ = context && !is_software_renderer();
        send(pipe_, {{"renderer", context ? describe_context().renderer : "none"}});
        std::vector<BenchSubject> subjects;
        std::vector<size_t> places;
        for (const size_t place : methods) {
            begin(place);
            attempt([&] {
                BenchSubject subject = scene_.methods[place].prepare();
                if (const std::string fault = fault_of(subject); !fault.empty()) return failed(place, fault);
                send(pipe_, {{"method", place}, {"subject", as_json(subject)}, {"clock", clock_name(subject)}});
                subject.picture = subject.error_map = {};
                subjects.push_back(std::move(subject));
                places.push_back(place);
            });
        }
        // Drop a method that fails while it is timed, and start again with the others.
        while (run_.settings.repeats > 0 && !subjects.empty() && !attempt([&] { time(subjects, places, clock()); })) {
            const auto bad = std::find(places.begin(), places.end(), size_t(current_));
            subjects.erase(subjects.begin() + (bad - places.begin()));
            places.erase(bad);
        }
    }

private:
    const char* clock_name(const BenchSubject& subject) const {
        return is_on_gpu_ ? "gpu" : topic_.draws || subject.is_parallel ? "wall" : "cpu";
    }
    BenchClock clock() const {
        if (is_on_gpu_)
            return [](const BenchSubject& subject, size_t times) { return by_gpu_clock(subject.run, times); };
        if (topic_.draws)
            return [](const BenchSubject& subject, size_t times) {
                return by_wall_clock([&] { subject.run(), glFinish(); }, times);
            };
        return [](const BenchSubject& subject, size_t times) {
            return subject.is_parallel ? by_wall_clock(subject.run, times) : by_cpu_clock(subject.run, times);
        };
    }
    void begin(size_t place) { current_ = int(place); }
    void failed(size_t place, const std::string& why) { send(pipe_, {{"method", place}, {"failed", why}}); }

    /// Returns false if the work threw: then the current method has failed.
    template <class Work>
    bool attempt(Work work) {
        try {
            work();
            return true;
        } catch (const std::exception& error) {
            failed(size_t(current_), std::string("failed: ") + error.what());
            return false;
        }
    }

    /// Draws for half a second, since an idle GPU runs at a fraction of its clock rate.
    static void wake_gpu(const BenchSubject& subject) {
        const auto begin = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(500)) subject.run(), glFinish();
    }

    void time(std::span<const BenchSubject> subjects, const std::vector<size_t>& places, const BenchClock& clock) {
        if (is_on_gpu_) begin(places[0]), wake_gpu(subjects[0]);
        BenchTurns turns(subjects, clock, [&](size_t i) { begin(places[i]); });
        for (int round = 1; round <= run_.settings.repeats; ++round) {
            turns.round();
            json times;
            for (const BenchTimes& one : turns.times()) times.push_back({one.median, one.p10, one.p90});
            send(pipe_, {{"round", round}, {"methods", places}, {"times", times}});
        }
    }

    const BenchTopic& topic_;
    const BenchScene& scene_;
    const BenchRun& run_;
    int pipe_;
    volatile int& current_;
    bool is_on_gpu_ = false;
};

/// A number shared by two processes for the lifetime of the object.
class Shared {
public:
    Shared() : page_(mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (page_ == MAP_FAILED) throw Error(fmt::format("no memory to share: {}", std::strerror(errno)));
    }
    ~Shared() { munmap(page_, sizeof(int)); }
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;
    volatile int& value() { return *static_cast<volatile int*>(page_); }

private:
    void* page_;
};

std::string text_of(const ChildEnd& end) {
    return end.crash.empty() ? fmt::format("ended the process, exit code {}", end.code) : "crashed: " + end.crash;
}

/// Writes the messages of the measuring process into the rows.
class Listener {
public:
    Listener(std::vector<BenchRow>& rows, const BenchRun& run, BenchMachine& machine)
        : rows_(rows), run_(run), machine_(machine) {}

    void hear(const json& message) {
        if (message.contains("stopped")) throw Error(message.at("stopped").get<std::string>());
        if (message.contains("wrong use")) throw UsageError(message.at("wrong use").get<std::string>());
        if (message.contains("renderer")) {
            machine_.renderer = message.at("renderer");
            return report(first_open());
        }
        if (message.contains("subject")) {
            BenchRow& row = rows_[message.at("method")];
            read_subject(message.at("subject"), row);
            row.clock = message.at("clock");
            row.state = "measured";
            return report(first_open());
        }
        if (message.contains("failed")) {
            BenchRow& row = rows_[message.at("method")];
            row.state = message.at("failed");
            row.repeats = 0;
            return report(first_open());
        }
        const int round = message.at("round");
        const std::vector<size_t> methods = message.at("methods");
        for (size_t i = 0; i < methods.size(); ++i) {
            const auto& times = message.at("times")[i];
            rows_[methods[i]].times = {times[0], times[1], times[2]};
            rows_[methods[i]].repeats = round;
        }
        report(round < run_.settings.repeats ? fmt::format("round {} of {}", round + 1, run_.settings.repeats)
                                             : "done");
    }

private:
    std::string first_open() const {
        for (const BenchRow& row : rows_)
            if (row.state == "open") return row.method + ", its error and work";
        return "warming up";
    }
    void report(const std::string& next) const {
        if (run_.report) run_.report(rows_, next);
    }

    std::vector<BenchRow>& rows_;
    const BenchRun& run_;
    BenchMachine& machine_;
};

}  // namespace

double by_gpu_clock(const std::function<void()>& run, size_t times) {
    // A pair of timestamps a run instead of an elapsed-time query: if a run calls glFinish, llvmpipe loses the start of
    // the elapsed time. The runs are queued, and only the time between both stamps counts: otherwise a picture of 20
    // microseconds would measure how fast the CPU sends commands.
    const std::vector<QueryName> begins(std::min(times, size_t(256))), ends(begins.size());
    double seconds = 0;
    for (size_t done = 0; done < times; done += begins.size()) {
        const size_t count = std::min(begins.size(), times - done);
        for (size_t i = 0; i < count; ++i) {
            glQueryCounter(begins[i], GL_TIMESTAMP);
            run();
            glQueryCounter(ends[i], GL_TIMESTAMP);
        }
        for (size_t i = 0; i < count; ++i) {
            GLuint64 from = 0, to = 0;
            glGetQueryObjectui64v(begins[i], GL_QUERY_RESULT, &from);
            glGetQueryObjectui64v(ends[i], GL_QUERY_RESULT, &to);
            seconds += double(to - from) * 1e-9;
        }
    }
    return seconds;
}

int steps_of(const BenchScene& scene, const BenchSettings& settings) {
    return 1 + int(scene.methods.size()) + settings.repeats;
}

std::vector<BenchRow> run_scene(const BenchTopic& topic, const BenchScene& scene, const BenchRun& run,
                                BenchMachine& machine) {
    std::vector<BenchRow> rows = open_rows(topic, scene);
    Listener listener(rows, run, machine);
    Shared current;
    // A crash ends the process. The next one skips the method that crashed.
    for (bool again = true; again;) {
        again = false;
        std::vector<size_t> methods;
        for (size_t i = 0; i < rows.size(); ++i)
            if (rows[i].state == "open" || rows[i].is_measured()) {
                methods.push_back(i);
                rows[i].state = "open";
            }
        if (methods.empty()) break;
        current.value() = -1;
        Pipe pipe;
        ChildProcess child([&] {
            pipe.read.close();
            try {
                Measuring(topic, scene, run, pipe.write, current.value()).measure(methods);
            } catch (const UsageError& error) {
                send(pipe.write, {{"wrong use", error.what()}});
            } catch (const std::exception& error) {
                send(pipe.write, {{"stopped", error.what()}});
            }
        });
        pipe.write.close();
        while (const auto message = receive(pipe.read)) listener.hear(*message);
        const ChildEnd end = child.wait();
        if (end.crash.empty() && end.code == 0) break;
        if (current.value() < 0) throw Error("the measuring process " + text_of(end) + " before it measured anything");
        BenchRow& row = rows[size_t(current.value())];
        row.state = text_of(end);
        row.repeats = 0;
        again = true;
    }
    return rows;
}

}  // namespace relief::measure
