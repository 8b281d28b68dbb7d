#include "framework/staff/app/share.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "framework/core/base/process.h"
#include "framework/core/base/system.h"

namespace relief {
namespace {

/// A number in memory that all copies of this process share.
class SharedNumber {
public:
    SharedNumber() : memory_(os::shared_memory(sizeof *number_)) {
        if (!memory_) throw Error(fmt::format("no shared memory: {}", std::strerror(errno)));
        number_ = new (memory_.get()) std::atomic<size_t>(0);
    }
    std::atomic<size_t>& operator*() { return *number_; }

private:
    static_assert(std::atomic<size_t>::is_always_lock_free);
    std::shared_ptr<void> memory_;
    std::atomic<size_t>* number_ = nullptr;
};

/// Messages on a pipe: kind, length, bytes.
enum Kind : uint32_t { said, failed };
struct Head {
    Kind kind;
    uint32_t size;
};

void send(int pipe, Kind kind, const std::string& text) {
    const Head head{kind, uint32_t(text.size())};
    // Ignore failure: without a reader there is no one to tell.
    if (write_all(pipe, {reinterpret_cast<const char*>(&head), sizeof head})) write_all(pipe, text);
}

class Worker {
public:
    Worker(SharedNumber& next, size_t count, const std::function<void(const NextPart&, const Say&)>& work) {
        Pipe pipe;
        process_ = std::make_unique<ChildProcess>([&] {
            try {
                work(
                    [&]() -> std::optional<size_t> {
                        const size_t part = (*next)++;
                        return part < count ? std::optional(part) : std::nullopt;
                    },
                    [&](const std::string& text) { send(pipe.write, said, text); });
            } catch (const std::exception& error) {
                send(pipe.write, failed, error.what());
            }
        });
        read_ = std::move(pipe.read);
    }

    /// Receives texts until the process ends. Returns the reason of its failure, or an empty string.
    std::string listen(const std::function<void(const std::string&)>& hear) {
        std::string failure;
        for (Head head; read_all(read_, &head, sizeof head);) {
            std::string text(head.size, 0);
            if (!read_all(read_, text.data(), text.size())) break;
            if (head.kind == said)
                hear(text);
            else
                failure = text;
        }
        const ChildEnd end = process_->wait();
        if (!end.crash.empty()) return "a process of this program crashed: " + end.crash;
        if (end.code != 0) return fmt::format("a process of this program ended with exit code {}", end.code);
        return failure;
    }

private:
    std::unique_ptr<ChildProcess> process_;
    Descriptor read_{-1};
};

}  // namespace

void share_among_processes(size_t count, const std::function<void(const NextPart&, const Say&)>& work,
                           const std::function<void(const std::string&)>& hear) {
    if (!can_copy_process()) {
        size_t begun = 0;
        return work([&] { return begun < count ? std::optional(begun++) : std::nullopt; }, hear);
    }
    SharedNumber next;
    std::deque<Worker> workers;
    for (size_t i = 0; i < std::min(count, size_t{hardware_threads()}); ++i) workers.emplace_back(next, count, work);
    std::mutex mutex;
    std::string failure;
    parallel_each(workers.size(), unsigned(workers.size()), [&](size_t i) {
        const std::string why = workers[i].listen([&](const std::string& text) {
            const std::lock_guard lock(mutex);
            hear(text);
        });
        if (why.empty()) return;
        *next = count;  // lets the others end soon
        const std::lock_guard lock(mutex);
        if (failure.empty()) failure = why;
    });
    if (!failure.empty()) throw Error(failure);
}

}  // namespace relief
