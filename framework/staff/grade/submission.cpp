#include "framework/staff/grade/submission.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/openat2.h>
#include <strings.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"
#include "framework/core/base/module.h"
#include "framework/core/base/sha256.h"
#include "framework/staff/grade/archive.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

constexpr size_t ignored_shown = 100, links_shown = 10;

/// Returns the task file that a name stands for. Returns nothing for other names, absolute paths and paths with "..".
/// Accepts backslashes, because some Windows programs write them into zips.
std::optional<std::string> task_file_of(std::string name, const std::set<std::string>& wanted) {
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.starts_with("/")) return {};
    for (const fs::path& part : fs::path(name))
        if (part == "..") return {};
    for (const std::string& file : wanted)
        if (name == file || name.ends_with("/" + file)) return file;
    return {};
}

/// Returns whether a link of that name may stand for a task file or for a folder in its path.
bool may_lead_to_task(std::string name, const std::set<std::string>& wanted) {
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::string last = fs::path(name).filename().string();
    for (const std::string& file : wanted)
        for (const fs::path& part : fs::path(file))
            if (part == last) return true;
    return false;
}

std::string too_large() { return fmt::format("larger than {} MiB", max_task_bytes >> 20); }

/// Gathers files and links, from a folder or from an archive.
class Gathering {
public:
    Gathering(Submission& submission, const std::set<std::string>& wanted) : submission_(submission), wanted_(wanted) {}

    void add(ArchiveEntry entry) {
        const std::optional<std::string> file = task_file_of(entry.name, wanted_);
        if (entry.is_link && may_lead_to_task(entry.name, wanted_)) {
            if (submission_.links.size() < links_shown) submission_.links.push_back(printable(entry.name));
            if (file) links_.insert(*file);
        }
        if (!file || !entry.is_file) return ignore(entry.name);
        const auto depth =
            std::count_if(entry.name.begin(), entry.name.end(), [](char c) { return c == '/' || c == '\\'; });
        const auto place = std::pair(depth, entry.name);
        if (const auto before = places_.find(*file); before != places_.end()) {
            if (before->second.first == depth && before->second.second != entry.name) beside_.insert(*file);
            if (before->second < place) return ignore(entry.name);
            ignore(before->second.second);
            if (before->second.first > depth) beside_.erase(*file);
        }
        places_[*file] = place;
        submission_.files.erase(*file);
        submission_.refused.erase(*file);
        if (entry.too_large)
            submission_.refused[*file] = too_large();
        else
            submission_.files[*file] = std::move(entry.content);
    }

    /// Call it after all entries have been added.
    void finish() {
        if (!beside_.empty())
            submission_.doubt =
                fmt::format("has {} in several folders side by side; only '{}' is graded: is it several submissions?",
                            *beside_.begin(), printable(places_.at(*beside_.begin()).second));
        for (const std::string& file : links_)
            if (!places_.contains(file)) submission_.refused[file] = "a link, and links are not followed";
    }

    void ignore(const std::string& name) {
        if (name.ends_with("/")) return;  // a folder entry of an archive
        ++submission_.ignored_count;
        if (submission_.ignored.size() < ignored_shown) submission_.ignored.push_back(printable(name));
    }

private:
    Submission& submission_;
    const std::set<std::string>& wanted_;
    std::map<std::string, std::pair<std::ptrdiff_t, std::string>> places_;
    std::set<std::string> beside_;  ///< task files with another candidate in as few folders
    std::set<std::string> links_;   ///< task files in whose place there is a link
};

/// Opens a file below a folder. Follows no links and never leaves the folder, even if files are moved meanwhile.
int open_beneath(int folder, const std::string& name) {
    open_how how{};
    how.flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS;
    const int file = int(syscall(SYS_openat2, folder, name.c_str(), &how, sizeof how));
    if (file < 0 && (errno == ENOSYS || errno == EPERM))
        throw Error(
            "this system cannot open untrusted folders safely (it needs openat2, Linux 5.6): pass an archive instead");
    return file;
}

/// Reports an unreadable file as a problem of the submission. The student handed it in, and is not to blame for
/// permissions.
[[noreturn]] void refuse_unreadable(const std::string& name) {
    throw Error(fmt::format("cannot read '{}': {}", name, std::strerror(EACCES)));
}

ArchiveEntry read_beneath(int folder, const std::string& name) {
    ArchiveEntry entry;
    entry.name = name;
    struct stat link {};
    entry.is_link = fstatat(folder, name.c_str(), &link, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(link.st_mode);
    const Descriptor file(open_beneath(folder, name));
    if (file < 0 && errno == EACCES && S_ISREG(link.st_mode)) refuse_unreadable(name);
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return entry;
    entry.is_file = true;
    entry.content.resize(max_task_bytes + 1);
    size_t have = 0;
    while (have < entry.content.size()) {
        const ssize_t got = read(file, entry.content.data() + have, entry.content.size() - have);
        if (got <= 0) break;
        have += size_t(got);
    }
    entry.too_large = have > max_task_bytes;
    entry.content.resize(entry.too_large ? 0 : have);
    entry.content.shrink_to_fit();  // a whole class is kept in memory
    return entry;
}

void gather_folder(const fs::path& path, const std::set<std::string>& wanted, Gathering& gathering) {
    const Descriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder < 0) throw Error(fmt::format("cannot read: {}", std::strerror(errno)));
    std::vector<std::string> names;
    size_t entries = 0;
    for (fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied), end; entry != end;
         ++entry) {
        if (++entries > max_entries) throw Error(fmt::format("has more than {} files and folders", max_entries));
        std::error_code unknown;  // a link to itself counts as an ordinary name
        const std::string name = entry->path().lexically_relative(path).string();
        if (entry->is_symlink(unknown) || !entry->is_directory(unknown))
            names.push_back(name);
        else if (may_lead_to_task(name, wanted) && access(entry->path().c_str(), R_OK | X_OK) != 0)
            refuse_unreadable(name);
    }
    std::sort(names.begin(), names.end());
    for (const std::string& name : names)
        if (task_file_of(name, wanted) || may_lead_to_task(name, wanted))
            gathering.add(read_beneath(folder, name));
        else
            gathering.ignore(name);
}

std::string hash_of(const Submission& submission) {
    std::string all;
    for (const auto& [name, content] : submission.files) all += name + '\n' + sha256(content) + '\n';
    for (const auto& [name, reason] : submission.refused) all += name + '\n' + reason + '\n';
    return sha256(all);
}

}  // namespace

std::string hash_of_files(const Submission& submission, const std::set<std::string>& files) {
    Submission part;
    for (const std::string& file : files) {
        if (const auto found = submission.files.find(file); found != submission.files.end()) part.files.insert(*found);
        if (const auto found = submission.refused.find(file); found != submission.refused.end())
            part.refused.insert(*found);
    }
    return hash_of(part);
}

std::string submission_name(const fs::path& path) {
    const fs::path plain = path.lexically_normal();
    std::string name = (plain.has_filename() ? plain : plain.parent_path()).filename().string();
    if (name.empty() || name == "." || name == "..") name = fs::absolute(path).lexically_normal().filename().string();
    std::error_code unknown;
    if (fs::is_directory(path, unknown)) return composed(name);
    for (const char* ending : {".zip", ".tar", ".tgz", ".gz", ".bz2", ".xz", ".zst", ".tar"})
        if (const size_t length = std::strlen(ending);
            name.size() > length && strcasecmp(name.c_str() + name.size() - length, ending) == 0)
            name.resize(name.size() - length);
    return composed(name);
}

std::vector<ArchiveEntry> read_archive(const fs::path& path, size_t largest,
                                       const std::function<bool(const std::string&)>& wanted) {
    static const Module module = open_own_module("relief-archive.so", "libarchive-dev");
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0) throw Error(fmt::format("cannot read: {}", std::strerror(errno)));
    if (!S_ISREG(status.st_mode)) throw Error("neither a folder nor a file");
    if (size_t(status.st_size) > max_archive_bytes)
        throw Error(fmt::format("larger than {} MiB", max_archive_bytes >> 20));
    std::vector<ArchiveEntry> entries;
    module.function<decltype(relief_read_archive)>("relief_read_archive")(file, largest, wanted, entries);
    return entries;
}

Submission read_submission(const fs::path& path, const std::set<std::string>& wanted) {
    Submission submission;
    submission.name = submission_name(path);
    try {
        Gathering gathering(submission, wanted);
        if (fs::is_directory(path)) {
            gather_folder(path, wanted, gathering);
        } else {
            const auto is_wanted = [&](const std::string& name) { return task_file_of(name, wanted).has_value(); };
            for (ArchiveEntry& entry : read_archive(path, max_task_bytes, is_wanted)) gathering.add(std::move(entry));
        }
        gathering.finish();
        submission.hash = hash_of(submission);
    } catch (const std::exception& error) {  // including errors of directory iterators
        submission.problem = printable(error.what(), 400);
        submission.files.clear();
    }
    return submission;
}

}  // namespace relief::grade
