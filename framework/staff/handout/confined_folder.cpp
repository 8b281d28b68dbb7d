#include "framework/staff/handout/confined_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "framework/core/base/error.h"

namespace relief::handout {
namespace {

namespace fs = std::filesystem;

// A fixed name is safe, because the lock allows one process at a time. A leftover of an interrupted run is overwritten.
constexpr const char* unfinished_name = ".relief-unfinished";
constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

bool read_all(int descriptor, std::string& bytes) {
    char buffer[1 << 16];
    for (;;) {
        const ssize_t got = ::read(descriptor, buffer, sizeof buffer);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return got == 0;
        bytes.append(buffer, size_t(got));
    }
}

}  // namespace

ConfinedFolder::ConfinedFolder(const fs::path& folder)
    : folder_(folder), top_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (top_ < 0) fail({}, "open this folder");
    if (flock(top_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw Error({folder}, "another run is writing here: wait until it ends");
}

void ConfinedFolder::fail(const fs::path& path, const char* action) const {
    throw Error({path.empty() ? folder_ : folder_ / path}, fmt::format("cannot {}: {}", action, std::strerror(errno)));
}

Descriptor ConfinedFolder::open_parent(const fs::path& path, bool make, fs::path& reached) const {
    Descriptor here(openat(top_, ".", folder_flags));
    for (const fs::path& name : path.parent_path()) {
        reached /= name;
        if (name == ".." || name == "." || name == "/") throw Error({path}, "is not a path below a folder");
        if (make && mkdirat(here, name.c_str(), 0777) != 0 && errno != EEXIST) return Descriptor(-1);
        Descriptor next(openat(here, name.c_str(), folder_flags));
        if (next < 0) return next;
        here = std::move(next);
    }
    return here;
}

ConfinedFolder::Found ConfinedFolder::look(const fs::path& path) const {
    fs::path reached;
    const Descriptor parent = open_parent(path, false, reached);
    if (parent < 0) {
        if (errno == ENOENT) return {};
        if (errno == ENOTDIR || errno == ELOOP) return {Kind::behind, {}, reached};
        fail(reached, "open this folder");
    }
    struct stat status {};
    if (fstatat(parent, path.filename().c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
        if (errno == ENOENT) return {};
        fail(path, "look at this");
    }
    if (!S_ISREG(status.st_mode)) return {Kind::other};
    const Descriptor file(openat(parent, path.filename().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    Found found{Kind::file};
    if (file < 0) return {Kind::other};
    if (!read_all(file, found.bytes)) fail(path, "read");
    return found;
}

void ConfinedFolder::write(const fs::path& path, std::string_view bytes, bool executable) const {
    fs::path reached;
    const Descriptor parent = open_parent(path, true, reached);
    if (parent < 0) fail(reached, "make this folder");
    if (unlinkat(top_, unfinished_name, 0) != 0 && errno != ENOENT) fail(unfinished_name, "remove");
    Descriptor file(
        openat(top_, unfinished_name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, executable ? 0777 : 0666));
    if (file >= 0 && write_all(file, bytes) && file.close() &&
        renameat(top_, unfinished_name, parent, path.filename().c_str()) == 0)
        return;
    const int reason = errno;
    unlinkat(top_, unfinished_name, 0);
    errno = reason;
    fail(path, "write");
}

void ConfinedFolder::remove(const fs::path& path) const {
    fs::path reached;
    const Descriptor parent = open_parent(path, false, reached);
    if (parent < 0 || unlinkat(parent, path.filename().c_str(), 0) != 0) fail(path, "remove");
    for (fs::path folder = path.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        const Descriptor above = open_parent(folder, false, reached);
        if (above < 0 || unlinkat(above, folder.filename().c_str(), AT_REMOVEDIR) != 0) return;  // not empty
    }
}

}  // namespace relief::handout
