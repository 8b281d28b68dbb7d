#include "framework/core/base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <random>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

// The file that is being written. A signal handler may access only plain memory like this.
char unfinished_file[4096];
std::atomic<bool> has_unfinished_file = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void remove_unfinished_file(int signal) {
    if (has_unfinished_file) unlink(unfinished_file);
    _exit(128 + signal);
}

constexpr const char* unfinished_suffix = ".unfinished-";

/// Returns a word that no other process has, not even one with the same process id on another machine or in
/// another PID namespace.
std::string random_word() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}", random(), random());
}

/// A temporary file beside the target. It takes the target's name once it is complete; else the destructor removes it.
class UnfinishedFile {
public:
    explicit UnfinishedFile(const fs::path& target) : name_(target.string() + unfinished_suffix + random_word()) {
        if (name_.size() < sizeof unfinished_file) {
            std::memcpy(unfinished_file, name_.c_str(), name_.size() + 1);
            has_unfinished_file = true;
        }
    }
    ~UnfinishedFile() {
        if (!finished_) unlink(name_.c_str());
        has_unfinished_file = false;
    }
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    const char* name() const { return name_.c_str(); }
    bool rename_to(const fs::path& target) {
        finished_ = std::rename(name_.c_str(), target.c_str()) == 0;
        return finished_;
    }

private:
    std::string name_;
    bool finished_ = false;
};

[[noreturn]] void fail(const fs::path& path, const char* action) {
    throw Error({path}, fmt::format("cannot {}: {}", action, std::strerror(errno)));
}

}  // namespace

std::string read_file(const fs::path& path, size_t limit) {
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0) fail(path, "read");
    if (!S_ISREG(status.st_mode)) throw Error({path}, "cannot read: not a file");
    if (static_cast<size_t>(status.st_size) > limit)
        throw Error({path}, fmt::format("cannot read: {} bytes, the limit is {}", status.st_size, limit));
    std::string bytes(static_cast<size_t>(status.st_size), '\0');
    size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(file, bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(path, "read");
        if (got == 0) break;
        have += static_cast<size_t>(got);
    }
    bytes.resize(have);
    return bytes;
}

namespace {

enum class Kept { soon, on_disk, on_disk_private };

void write_whole(const fs::path& named, std::string_view bytes, Kept kept) {
    // Write to the target of a symbolic link, so that the link stays.
    std::error_code ignored;
    const fs::path path = fs::is_symlink(named, ignored) ? fs::weakly_canonical(named, ignored) : named;
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
        if (S_ISDIR(status.st_mode)) throw Error({named}, "cannot write: it is a folder, name a file in it");
        // A rename would replace a pipe or a device, so write into it.
        Descriptor device(open(path.c_str(), O_WRONLY | O_CLOEXEC));
        if (device < 0 || !write_all(device, bytes) || !device.close()) fail(named, "write");
        return;
    }
    UnfinishedFile unfinished(path);
    const mode_t mode = kept == Kept::on_disk_private ? 0600 : 0666;
    Descriptor file(open(unfinished.name(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (file < 0 || !write_all(file, bytes) || (kept != Kept::soon && fsync(file) != 0) || !file.close() ||
        !unfinished.rename_to(path))
        fail(named, "write");
    if (kept == Kept::soon) return;
    const Descriptor folder(open((path.parent_path() / ".").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder < 0 || fsync(folder) != 0) fail(named, "write");
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) { write_whole(path, bytes, Kept::soon); }
void write_file_to_disk(const fs::path& path, std::string_view bytes) { write_whole(path, bytes, Kept::on_disk); }
void write_private_file(const fs::path& path, std::string_view bytes) {
    write_whole(path, bytes, Kept::on_disk_private);
}

void remove_unfinished_files(const fs::path& folder) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().filename().string().find(unfinished_suffix) != std::string::npos &&
            entry.is_regular_file(none))
            fs::remove(entry.path(), none);
}

void write_standard_output(std::string_view bytes) {
    if (!write_all(STDOUT_FILENO, bytes))
        throw Error(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
}

void make_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw Error({path}, "cannot make this folder: " + error.message());
}

void clean_up_when_interrupted() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, remove_unfinished_file) == SIG_IGN) std::signal(signal, SIG_IGN);  // as under nohup
    std::signal(SIGPIPE, SIG_IGN);  // write() then reports a closed pipe as an error with a message
}

}  // namespace relief
