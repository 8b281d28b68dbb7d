#include "framework/course/check/check_apart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <random>
#include <type_traits>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/process.h"
#include "framework/core/base/system.h"
#include "framework/core/base/text.h"
#include "framework/core/context/context.h"
#include "framework/course/check/check.h"
#include "framework/course/check/kept_lab.h"
#include "framework/course/check/printed.h"

namespace relief::check {
namespace {

namespace fs = std::filesystem;

/// Writes values into a text, or reads them from it. Both ends are copies of one process.
struct CopyWriter {
    std::string& bytes;
    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }

private:
    template <class Value>
    void put(const Value& value) {
        if constexpr (std::is_trivially_copyable_v<Value>) {
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        } else {
            put(value.size());
            if constexpr (std::is_trivially_copyable_v<typename Value::value_type>)
                bytes.append(reinterpret_cast<const char*>(value.data()), value.size() * sizeof(value[0]));
            else
                for (const auto& one : value) put(one);
        }
    }
};
struct CopyReader {
    const std::string& bytes;
    size_t at = 0;
    template <class... Values>
    void operator()(Values&... values) {
        (get(values), ...);
    }

private:
    void take(void* to, size_t size) {
        if (size == 0) return;  // an empty vector may have no address
        std::memcpy(to, bytes.data() + at, size);
        at += size;
    }
    template <class Value>
    void get(Value& value) {
        if constexpr (std::is_trivially_copyable_v<Value>) {
            take(&value, sizeof value);
        } else {
            size_t size = 0;
            get(size);
            value.resize(size);
            if constexpr (std::is_trivially_copyable_v<typename Value::value_type>)
                take(value.data(), size * sizeof(value[0]));
            else
                for (auto& one : value) get(one);
        }
    }
};
template <class Archive, class AnyImage>
void transfer_image(Archive&& archive, AnyImage& image) {
    archive(image.width, image.height, image.channels, image.bits, image.values);
}
template <class Archive, class Verdict>
void transfer(Archive&& archive, Verdict& said) {
    archive(said.outcome, said.found, said.culprit, said.look_at, said.relation, said.used, said.details,
            said.waits_for, said.is_own, said.view, said.index, said.name, said.hidden);
    for (auto* image : {&said.drawn, &said.expected, &said.related}) transfer_image(archive, *image);
}

/// A message of a copy. `begins` and `ends` name a check; `over` and `failed` have a text; `renderer` and `driver`
/// their names.
enum class Tells : uint32_t { renderer, driver, begins, ends, over, failed };
struct Told {
    Tells kind = Tells::failed;
    size_t check = 0;
    double spent = 0;  ///< seconds of processor time of this copy
    std::string text = {};
    CheckResult result = {};
};

void send_told(int pipe, const Told& message) {
    std::string bytes;
    CopyWriter writer{bytes};
    writer(message.kind, message.check, message.spent, message.text);
    if (message.kind == Tells::ends) {
        transfer(writer, message.result.said);
        const Sample sample = message.result.sample.value_or(Sample{});
        writer(message.result.sample.has_value(), sample.values, sample.error, sample.is_drawn);
    }
    const size_t size = bytes.size();
    // Ignore failure: without a reader there is no one to tell.
    if (write_all(pipe, {reinterpret_cast<const char*>(&size), sizeof size})) write_all(pipe, bytes);
}

std::optional<Told> receive_told(int pipe) {
    size_t size = 0;
    if (!read_all(pipe, &size, sizeof size)) return {};
    std::string bytes(size, 0);
    if (!read_all(pipe, bytes.data(), size)) return {};
    Told message;
    CopyReader reader{bytes};
    reader(message.kind, message.check, message.spent, message.text);
    if (message.kind == Tells::ends) {
        transfer(reader, message.result.said);
        Sample sample;
        bool has_sample = false;
        reader(has_sample, sample.values, sample.error, sample.is_drawn);
        if (has_sample) message.result.sample = std::move(sample);
    }
    return message;
}

/// A file without a name for the output of a copy.
class PrintedFile {
public:
    PrintedFile() {
        std::random_device random;
        const fs::path path = fs::temp_directory_path() / fmt::format("relief-check-{:08x}{:08x}", random(), random());
        write_ = os::create_file(path, true);
        read_ = os::open_to_read(path);
        if (write_ < 0 || read_ < 0) throw Error({path}, std::string("cannot make this file: ") + std::strerror(errno));
        std::error_code ignored;
        fs::remove(path, ignored);
    }
    /// Makes this process print into the file.
    void take_output() const {
        for (const int stream : {standard_output, standard_error}) os::redirect(stream, write_);
    }
    /// Returns the text that was printed since the last call.
    std::string take_text() {
        std::string text;
        char block[1 << 12];
        for (size_t got = sizeof block; got == sizeof block;) {
            got = read_up_to(read_, block, sizeof block).value_or(0);
            text.append(block, got);
        }
        return text;
    }

private:
    Descriptor write_{-1}, read_{-1};
};

/// Runs the checks at `order`, and tells each one. Does not throw.
void run_checks(const LabEntry& lab, const Manifest& manifest, const std::vector<size_t>& order,
                const PatienceLimits& limits, LabChecker& checker, KeptPictures pictures,
                const std::function<void(const CheckInfo& check)>& begins,
                const std::function<void(Told message)>& tell) {
    try {
        pin_software_renderer();
        const auto context = open_context(std::nullopt);
        const NamedRenderer renderer = renderer_of_context();
        checker.set_renderer(renderer);
        tell({.kind = Tells::renderer, .text = renderer.name});
        tell({.kind = Tells::driver, .text = describe_context().driver()});
        Watchdog patience([&](const std::string& limit) { tell({.kind = Tells::over, .text = limit}); }, limits);
        KeptLab kept(lab);
        for (const size_t i : order) {
            patience.next();
            tell({.kind = Tells::begins, .check = i});
            if (begins) begins(manifest.checks[i]);
            checker.run(i, expected_of(kept, manifest.checks[i]), kept);
            CheckResult result = checker.take_result(i);
            Verdict& said = result.said;
            if (pictures == KeptPictures::of_failed && !has_failed(said.outcome))
                said.drawn = said.expected = said.related = {};
            tell({Tells::ends, i, os::processor_seconds(), {}, std::move(result)});
        }
    } catch (const std::exception& error) {
        tell({.kind = Tells::failed, .text = error.what()});
    }
}

/// The checks of one lab, run by one copy after another.
class ChecksApart {
public:
    ChecksApart(const LabEntry& lab, const Manifest& manifest, const PatienceLimits& limits, KeptPictures pictures,
                const std::function<void(const CheckInfo& check)>& begins)
        : lab_(lab),
          manifest_(manifest),
          limits_(limits),
          pictures_(pictures),
          begins_(begins),
          checker_(lab, manifest, {}),
          left_(checks_in_order(manifest)),
          progress_(int(left_.size())) {}

    CheckedLab run() {
        if (!can_copy_process()) {
            run_checks(lab_, manifest_, left_, limits_, checker_, pictures_, begins_, [&](Told message) {
                if (message.kind == Tells::driver) driver_ = message.text;
                if (message.kind == Tells::begins) begin(message.check);
                if (message.kind == Tells::ends) checker_.keep(message.check, std::move(message.result));
                if (message.kind == Tells::failed) throw Error(message.text);
                if (message.kind != Tells::over) return;
                print_error(fmt::format("lab {}: {}", lab_.two_digits(), unfinished(message.text)));
                std::_Exit(1);
            });
            return {checker_.tasks(), driver_};
        }
        while (!left_.empty()) run_copy();
        return {checker_.tasks(), driver_};
    }

private:
    void run_copy() {
        Pipe pipe;
        PrintedFile printed;
        std::mutex sending;  // the thread that watches the time sends, too
        ChildProcess copy([&] {
            pipe.read.close();
            printed.take_output();
            PatienceLimits limits = limits_;
            limits.lab -= spent_;
            run_checks(lab_, manifest_, left_, limits, checker_, pictures_, begins_, [&](const Told& message) {
                const std::lock_guard lock(sending);
                std::fflush(nullptr);
                send_told(pipe.write, message);
            });
        });
        pipe.write.close();
        running_.reset();
        double spent = 0;
        std::string over;
        while (auto message = receive_told(pipe.read)) {
            spent = std::max(spent, message->spent);
            if (!over.empty()) continue;  // sent before the end that was asked for
            switch (message->kind) {
                case Tells::renderer:
                    checker_.set_renderer({.name = message->text});
                    break;
                case Tells::driver:
                    driver_ = message->text;
                    break;
                case Tells::begins:
                    begin(message->check);
                    break;
                case Tells::ends:
                    keep(message->check, std::move(message->result), read_printed(printed.take_text()));
                    break;
                case Tells::over:
                    over = message->text;
                    copy.abort();  // the report of a sanitizer then shows where it was
                    break;
                case Tells::failed:
                    throw Error(message->text);
            }
        }
        const ChildEnd end = copy.wait();
        if (!over.empty() && running_) spent += std::min(limits_.check, limits_.lab - spent_);
        spent_ += spent;
        if (left_.empty() && !running_) return;
        if (!over.empty() && !running_) running_ = left_.front();  // the time was over between two checks
        if (!running_)
            throw Error("drawing could not begin: the process " + text_of(end, read_printed(printed.take_text())));
        fail(end, over, read_printed(printed.take_text()));
    }

    void begin(size_t check) {
        progress_.next(manifest_.checks[check].name);
        running_ = check;
    }

    void keep(size_t check, CheckResult result, const Printed& printed) {
        show(printed);
        std::erase(left_, check);
        running_.reset();
        Verdict& said = result.said;
        if (!printed.fault.empty()) {
            const std::string fault = with_place(printed);
            if (said.outcome == Outcome::wrong)
                said.look_at = fault;
            else
                said.found += ", but " + fault;
        }
        checker_.keep(check, std::move(result));
    }

    /// Says why the running check has no result, and which checks are not tried.
    void fail(const ChildEnd& end, const std::string& over, const Printed& printed) {
        show(printed);
        const size_t check = *running_;
        Verdict why{Outcome::crashed, "the program " + text_of(end, printed)};
        if (!over.empty()) why = {Outcome::out_of_time, unfinished(over)};
        if (!over.empty() && !printed.place.empty()) why.found += fmt::format(" ({} was running)", printed.place);
        if (printed.has_no_memory) why.outcome = Outcome::out_of_memory;
        set(check, why);
        if (over.empty()) return;
        const std::string& task = manifest_.checks[check].task;
        const bool has_time = spent_ < limits_.lab;
        for (const size_t other : std::vector(left_))
            if (!has_time)
                set(other, {Outcome::out_of_time,
                            fmt::format("not tried: the {} seconds for a lab are over (--patient allows more)",
                                        rounded(limits_.lab))});
            else if (manifest_.checks[other].task == task)
                set(other, {Outcome::out_of_time,
                            fmt::format("not tried, because '{}' did not end", manifest_.checks[check].name)});
    }

    void set(size_t check, Verdict said) {
        std::erase(left_, check);
        checker_.keep(check, {.said = std::move(said)});
    }

    std::string unfinished(const std::string& limit) const {
        const CheckInfo& check = manifest_.checks[*running_];
        std::string tasks = "task " + check.task;
        for (const std::string& other : check.needs) tasks += ", or " + other;
        return fmt::format("not finished after {} of processor time: does a loop of {} not end?", limit, tasks);
    }

    static std::string with_place(const Printed& printed) {
        return printed.place.empty() ? printed.fault : printed.place + ": " + printed.fault;
    }
    static std::string text_of(const ChildEnd& end, const Printed& printed) {
        if (!printed.fault.empty()) return "stops: " + with_place(printed);
        if (!end.crash.empty()) return "crashes: " + end.crash;
        return fmt::format("ends in the middle, with exit code {}", end.code);
    }
    static void show(const Printed& printed) {
        if (!printed.text.empty()) write_all(standard_error, printed.text);
    }

    const LabEntry& lab_;
    const Manifest& manifest_;
    const PatienceLimits limits_;
    const KeptPictures pictures_;
    const std::function<void(const CheckInfo& check)>& begins_;
    LabChecker checker_;
    std::vector<size_t> left_;  ///< the checks without a result
    std::optional<size_t> running_;
    double spent_ = 0;  ///< seconds of processor time of all copies
    std::string driver_;
    Progress progress_;
};

}  // namespace

CheckedLab check_lab_apart(const LabEntry& lab, const Manifest& manifest, const PatienceLimits& limits,
                           KeptPictures pictures, const std::function<void(const CheckInfo& check)>& begins) {
    CheckedLab checked = ChecksApart(lab, manifest, limits, pictures, begins).run();
    tell_unproven(lab, manifest, checked.tasks);
    return checked;
}

}  // namespace relief::check
