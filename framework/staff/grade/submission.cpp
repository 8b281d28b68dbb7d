#include "framework/staff/grade/submission.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/openat2.h>
#include <strings.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <tuple>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"
#include "framework/core/base/module.h"
#include "framework/core/base/sha256.h"
#include "framework/core/base/source_text.h"
#include "framework/course/task/task_names.h"
#include "framework/staff/grade/archive.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

constexpr size_t ignored_shown = 100, links_shown = 10, remarks_shown = 10;
/// Limits of the archives in a folder or in an archive.
constexpr size_t max_inner_archives = 10, max_inner_bytes = size_t{64} << 20;

/// Returns the length of a name without the endings of an archive; that of the whole name if it has none.
size_t length_without_archive_ending(const std::string& name) {
    size_t length = name.size();
    for (const char* ending : {".zip", ".tar", ".tgz", ".gz", ".bz2", ".xz", ".zst", ".tar"})
        if (const size_t size = std::strlen(ending);
            length > size && strncasecmp(name.c_str() + length - size, ending, size) == 0)
            length -= size;
    return length;
}
bool is_named_as_archive(const std::string& name) { return length_without_archive_ending(name) < name.size(); }

/// Returns whether a link of that name may stand for a task file or for a folder in its path.
bool may_lead_to_task(std::string name, const std::set<std::string>& wanted) {
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::string last = fs::path(name).filename().string();
    for (const std::string& file : wanted)
        for (const fs::path& part : fs::path(file))
            if (part == last) return true;
    return false;
}

/// Returns whether an editor or a merge leaves a file of that name beside the one that it changes.
bool is_backup(const std::string& name) {
    return name.ends_with("~") || name.ends_with(".bak") || name.ends_with(".orig") || name.ends_with(".old");
}

std::string too_large() { return fmt::format("larger than {} MiB", max_task_bytes >> 20); }

/// Gathers files and links, from a folder or from an archive.
class Gathering {
public:
    Gathering(Submission& submission, const std::set<std::string>& wanted) : submission_(submission), wanted_(wanted) {}

    bool wants(const std::string& name) const {
        return check::task_file_of(name, wanted_).has_value() || check::is_near_task_file(name, wanted_);
    }

    /// Adds a file or a link. Of equal names, the one with the larger number of the upload counts.
    void add(ArchiveEntry entry, long long upload = 0) {
        std::optional<std::string> file = check::task_file_of(entry.name, wanted_);
        if (entry.is_link && may_lead_to_task(entry.name, wanted_)) {
            if (submission_.links.size() < links_shown) submission_.links.push_back(printable(entry.name));
            if (file) links_.insert(*file);
        }
        if (!entry.is_file) return ignore(entry.name);
        if (is_named_as_archive(entry.name) && archives_.size() < max_inner_archives) archives_.push_back(entry.name);
        if (!file && !check::is_near_task_file(entry.name, wanted_)) return ignore(entry.name);
        ++found_;
        std::string text = entry.too_large ? std::string() : plain_source(std::move(entry.content));
        const bool is_near = !file;
        if (is_near) file = check::task_file_meant(entry.name, text, wanted_);
        if (!file) {
            if (unclear_.size() < remarks_shown) unclear_.push_back(printable(entry.name));
            return ignore(entry.name);
        }
        Versions& versions = versions_[*file];
        Version version{place_of(entry.name, upload, is_near), sha256(text), std::move(text), entry.too_large};
        if (versions.best && versions.best->place < version.place) {
            versions.lose(std::move(version));
            return ignore(entry.name);
        }
        if (versions.best) {
            ignore(versions.best->place.name);
            // The same path again, in an archive, replaces the file.
            if (versions.best->place < version.place || version.place < versions.best->place)
                versions.lose(std::move(*versions.best));
        }
        versions.best = std::move(version);
    }

    /// Returns the number of files that have the name of a task file, or one near it.
    size_t found() const { return found_; }
    /// Returns the names of the first archives among the files.
    const std::vector<std::string>& archives() const { return archives_; }

    /// Call it after all entries have been added.
    void finish() {
        for (auto& [file, versions] : versions_) {
            Version& best = *versions.best;
            tell(file, versions);
            if (best.is_too_large)
                submission_.refused[file] = too_large();
            else
                submission_.files[file] = std::move(best.text);
        }
        for (const std::string& name : unclear_)
            remark(
                fmt::format("'{}' is not graded: neither its folder nor a line // TASK 1.1 in it names its lab", name));
        for (const std::string& file : links_)
            if (!versions_.contains(file)) submission_.refused[file] = "a link, and links are not followed";
    }

    void remark(const std::string& sentence) {
        if (submission_.remarks.size() < remarks_shown) submission_.remarks.push_back(sentence);
    }

    void ignore(const std::string& name) {
        if (name.ends_with("/")) return;  // a folder entry of an archive
        ++submission_.ignored_count;
        if (submission_.ignored.size() < ignored_shown) submission_.ignored.push_back(printable(name));
    }

private:
    /// Where a file is. The smallest place counts.
    struct Place {
        bool is_near = false;  ///< its name is not that of a task file
        std::ptrdiff_t depth = 0;
        long long upload = 0;
        int copy = 0;
        std::string name;

        bool operator<(const Place& other) const { return key() < other.key(); }
        std::tuple<bool, std::ptrdiff_t, long long, int, const std::string&> key() const {
            return {is_near, depth, -upload, -copy, name};
        }
    };
    struct Version {
        Place place;
        std::string hash, text;  ///< the text of a version that does not count is dropped
        bool is_too_large = false;
    };
    struct Versions {
        std::optional<Version> best;
        std::vector<Version> others;

        void lose(Version version) {
            version.text.clear();
            version.text.shrink_to_fit();
            others.push_back(std::move(version));
        }
    };

    static Place place_of(const std::string& name, long long upload, bool is_near) {
        const auto depth = std::count_if(name.begin(), name.end(), [](char c) { return c == '/' || c == '\\'; });
        return {is_near, depth, upload, check::copy_number(name), name};
    }

    static std::string reason(const Place& best, const Place& other) {
        if (best.is_near != other.is_near) return "it has the name that is asked for";
        if (best.depth != other.depth) return "it is in fewer folders";
        if (best.upload != other.upload) return "it was uploaded later";
        if (best.copy != other.copy) return "its number is that of the later copy";
        return "it is the first by name. Are these several submissions?";
    }

    /// Remarks which version of a task file counts, if its name is not the one asked for or others have another text.
    void tell(const std::string& file, Versions& versions) {
        const Version& best = *versions.best;
        std::erase_if(versions.others, [&](const Version& one) {
            return one.hash == best.hash || (!best.place.is_near && is_backup(one.place.name));
        });
        std::sort(versions.others.begin(), versions.others.end(),
                  [](const Version& a, const Version& b) { return a.place < b.place; });
        std::string sentence;
        if (best.place.is_near)
            sentence = fmt::format("'{}' is graded as {}, since there is no file of that name and place",
                                   printable(best.place.name), file);
        if (!versions.others.empty()) {
            const size_t more = versions.others.size() - 1;
            sentence += fmt::format(
                "{}not '{}'{}: {}",
                best.place.is_near ? "; and " : fmt::format("'{}' is graded, and ", printable(best.place.name)),
                printable(versions.others.front().place.name), more > 0 ? fmt::format(" and {} more", more) : "",
                reason(best.place, versions.others.front().place));
        }
        if (!sentence.empty()) remark(sentence);
    }

    Submission& submission_;
    const std::set<std::string>& wanted_;
    size_t found_ = 0;
    std::map<std::string, Versions> versions_;
    std::vector<std::string> unclear_;   ///< files with a name near a task file's, whose lab is unknown
    std::vector<std::string> archives_;  ///< the first ones
    std::set<std::string> links_;        ///< task files in whose place there is a link
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

/// Returns a regular file that is open, with its content. It is no file if it is of another kind.
ArchiveEntry content_of(int file, const std::string& name) {
    ArchiveEntry entry;
    entry.name = name;
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

ArchiveEntry read_beneath(int folder, const std::string& name) {
    struct stat link {};
    const bool is_link = fstatat(folder, name.c_str(), &link, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(link.st_mode);
    const Descriptor file(open_beneath(folder, name));
    if (file < 0 && errno == EACCES && S_ISREG(link.st_mode)) refuse_unreadable(name);
    ArchiveEntry entry = content_of(file, name);
    entry.is_link = is_link;
    return entry;
}

/// Opens an archive. Throws Error if it is no regular file, or too large.
Descriptor open_archive(const fs::path& path) {
    Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file < 0 || fstat(file, &status) != 0) throw Error(fmt::format("cannot read: {}", std::strerror(errno)));
    if (!S_ISREG(status.st_mode)) throw Error("neither a folder nor a file");
    if (size_t(status.st_size) > max_archive_bytes)
        throw Error(fmt::format("larger than {} MiB", max_archive_bytes >> 20));
    return file;
}

/// Adds the files of an archive, with `prefix` before their names. An absolute path stays one, so it is refused.
void gather_archive(int file, const std::string& prefix, long long upload, Gathering& gathering) {
    const auto whole = [&](const std::string& name) {
        return name.starts_with("/") || name.starts_with("\\") ? name : prefix + name;
    };
    const auto largest = [&](const std::string& name) { return gathering.wants(whole(name)) ? max_task_bytes : 0; };
    for (ArchiveEntry& entry : read_archive(file, largest)) {
        entry.name = whole(entry.name);
        gathering.add(std::move(entry), upload);
    }
}

/// Adds the files of an archive that is in a folder or an archive. A damaged one only gets a remark.
void gather_inner(int file, const std::string& name, long long upload, Gathering& gathering) {
    try {
        gather_archive(file, name + "/", upload, gathering);
    } catch (const Error& error) {
        gathering.remark(fmt::format("'{}' cannot be read: {}", printable(name), printable(error.what())));
    }
}

/// Adds the files of a folder, with `prefix` before their names.
void gather_folder(const fs::path& path, const std::string& prefix, const std::set<std::string>& wanted,
                   Gathering& gathering) {
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
    std::vector<std::string> archives;
    const size_t before = gathering.found();
    for (const std::string& name : names)
        if (gathering.wants(name) || may_lead_to_task(name, wanted)) {
            ArchiveEntry entry = read_beneath(folder, name);
            entry.name = prefix + name;
            gathering.add(std::move(entry));
        } else {
            gathering.ignore(prefix + name);
            if (is_named_as_archive(name) && archives.size() < max_inner_archives) archives.push_back(name);
        }
    if (gathering.found() > before) return;
    for (const std::string& name : archives) {
        const Descriptor file(open_beneath(folder, name));
        struct stat status {};
        if (file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
            size_t(status.st_size) <= max_archive_bytes)
            gather_inner(file, prefix + name, 0, gathering);
    }
}

/// Returns a descriptor of a file that holds these bytes and has no name.
Descriptor in_memory(const std::string& bytes) {
    Descriptor file(memfd_create("archive", MFD_CLOEXEC));
    for (size_t done = 0; file >= 0 && done < bytes.size();) {
        const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
        if (written <= 0) throw Error(fmt::format("cannot unpack: {}", std::strerror(errno)));
        done += size_t(written);
    }
    if (file < 0 || lseek(file, 0, SEEK_SET) != 0) throw Error(fmt::format("cannot unpack: {}", std::strerror(errno)));
    return file;
}

/// Adds the files of the archives in an archive.
void gather_archives_in(const fs::path& path, const std::vector<std::string>& names, const std::string& prefix,
                        long long upload, Gathering& gathering) {
    const std::set<std::string> wanted(names.begin(), names.end());
    const auto largest = [&](const std::string& name) { return wanted.contains(prefix + name) ? max_inner_bytes : 0; };
    for (const ArchiveEntry& entry : read_archive(open_archive(path), largest))
        if (!entry.content.empty()) gather_inner(in_memory(entry.content), prefix + entry.name, upload, gathering);
}

/// Adds one part of a submission. `prefix` stands before the names in a folder or an archive.
void gather_part(const SubmissionPart& part, const std::string& prefix, const std::set<std::string>& wanted,
                 Gathering& gathering) {
    if (fs::is_directory(part.path)) return gather_folder(part.path, prefix, wanted, gathering);
    const std::string name = part.file.empty() ? part.path.filename().string() : part.file;
    const Descriptor file = open_archive(part.path);
    if (gathering.wants(name)) {  // a task file by itself
        gathering.add(content_of(file, name), part.upload);
        return;
    }
    const size_t found = gathering.found(), archives = gathering.archives().size();
    gather_archive(file, prefix, part.upload, gathering);
    const std::vector<std::string> inner(gathering.archives().begin() + std::ptrdiff_t(archives),
                                         gathering.archives().end());
    if (gathering.found() == found && !inner.empty())
        gather_archives_in(part.path, inner, prefix, part.upload, gathering);
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
    if (!fs::is_directory(path, unknown)) name.resize(length_without_archive_ending(name));
    return composed(name);
}

std::vector<ArchiveEntry> read_archive(int file, const std::function<size_t(const std::string&)>& largest) {
    static const Module module = open_own_module("relief-archive.so", "libarchive-dev");
    std::vector<ArchiveEntry> entries;
    module.function<decltype(relief_read_archive)>("relief_read_archive")(file, largest, entries);
    return entries;
}

Submission read_submission(const std::string& name, const std::vector<SubmissionPart>& parts,
                           const std::set<std::string>& wanted) {
    Submission submission;
    submission.name = name;
    try {
        Gathering gathering(submission, wanted);
        for (const SubmissionPart& part : parts)
            gather_part(part, parts.size() > 1 ? submission_name(part.path) + "/" : "", wanted, gathering);
        gathering.finish();
        submission.hash = hash_of(submission);
    } catch (const std::exception& error) {  // including errors of directory iterators
        submission.problem = printable(error.what(), 400);
        submission.files.clear();
    }
    return submission;
}

Submission read_submission(const fs::path& path, const std::set<std::string>& wanted) {
    return read_submission(submission_name(path), {{path}}, wanted);
}

}  // namespace relief::grade
