#include "framework/core/base/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <random>

#include "framework/core/base/error.h"
#include "framework/core/base/system.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

// The file that is being written. A signal handler may access only plain memory like this.
char unfinished_file[4096];
std::atomic<bool> has_unfinished_file = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void remove_unfinished_file() {
    if (has_unfinished_file) os::remove_file(unfinished_file);
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
        if (!finished_) os::remove_file(name_.c_str());
        has_unfinished_file = false;
    }
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    const char* name() const { return name_.c_str(); }
    bool rename_to(const fs::path& target) {
        std::error_code error;
        fs::rename(name_, target, error);
        errno = error.default_error_condition().value();
        finished_ = !error;
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
    const Descriptor file = os::open_to_read(path);
    if (file < 0) fail(path, "read");
    const std::optional<os::FileState> state = os::state_of(file);
    if (!state) fail(path, "read");
    if (!state->is_plain) throw Error({path}, "cannot read: not a file");
    if (state->size > limit)
        throw Error({path}, fmt::format("cannot read: {} bytes, the limit is {}", state->size, limit));
    std::string bytes(size_t(state->size), '\0');
    const std::optional<size_t> have = read_up_to(file, bytes.data(), bytes.size());
    if (!have) fail(path, "read");
    bytes.resize(*have);
    return bytes;
}

namespace {

bool differ_in_case_only(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char c, unsigned char d) { return std::tolower(c) == std::tolower(d); });
}

/// Returns the file that a path names if the case of letters does not count, or nothing.
fs::path in_any_case(const fs::path& path) {
    std::error_code error;
    if (path.empty() || fs::exists(path, error)) return path;
    const fs::path folder =
        path.has_parent_path() && path.parent_path() != path ? in_any_case(path.parent_path()) : fs::path();
    if (folder.empty() && path.has_parent_path()) return {};
    for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end; at.increment(error))
        if (differ_in_case_only(at->path().filename().string(), path.filename().string()))
            return folder / at->path().filename();
    return {};
}

}  // namespace

std::string missing_file(const fs::path& path) {
    const std::string name = path.filename().string();
    const fs::path found = in_any_case(path);
    if (found.empty()) return name + " is not there";
    // Name the folders, too, if the difference is in them.
    const bool same_name = found.filename() == path.filename();
    return fmt::format("{} is not there, but {} is: the case of letters counts", same_name ? path.string() : name,
                       same_name ? found.string() : found.filename().string());
}

namespace {

enum class Kept { soon, on_disk, on_disk_private };

void write_whole(const fs::path& named, std::string_view bytes, Kept kept) {
    // Write to the target of a symbolic link, so that the link stays.
    std::error_code ignored;
    const fs::path path = fs::is_symlink(named, ignored) ? fs::weakly_canonical(named, ignored) : named;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        if (fs::is_directory(status)) throw Error({named}, "cannot write: it is a folder, name a file in it");
        // A rename would replace a pipe or a device, so write into it.
        Descriptor device = os::open_to_write(path);
        if (device < 0 || !write_all(device, bytes) || !device.close()) fail(named, "write");
        return;
    }
    UnfinishedFile unfinished(path);
    Descriptor file = os::create_file(unfinished.name(), kept == Kept::on_disk_private);
    if (file < 0 || !write_all(file, bytes) || (kept != Kept::soon && !os::flush_to_disk(file)) || !file.close() ||
        !unfinished.rename_to(path))
        fail(named, "write");
    if (kept == Kept::soon) return;
    if (!os::flush_folder_to_disk(path.parent_path() / ".")) fail(named, "write");
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) { write_whole(path, bytes, Kept::soon); }
void write_file_to_disk(const fs::path& path, std::string_view bytes) { write_whole(path, bytes, Kept::on_disk); }
void write_private_file(const fs::path& path, std::string_view bytes) {
    write_whole(path, bytes, Kept::on_disk_private);
}

void write_standard_output(std::string_view bytes) {
    if (!write_all(standard_output, bytes))
        throw Error(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
}

void make_folder(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw Error({path}, "cannot make this folder: " + error.message());
}

void clean_up_when_interrupted() { os::clean_up_when_interrupted(remove_unfinished_file); }

}  // namespace relief
