#include "framework/core/base/descriptor.h"

#include <cerrno>

namespace relief {

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(size_t(written));
    }
    return true;
}

bool read_all(int descriptor, void* bytes, size_t size) {
    for (char* at = static_cast<char*>(bytes); size > 0;) {
        const ssize_t got = ::read(descriptor, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got, size -= size_t(got);
    }
    return true;
}

}  // namespace relief
