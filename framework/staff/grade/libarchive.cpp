// The module relief-archive.so, the only file that uses libarchive.
#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>

#include <cstring>
#include <memory>

#include "framework/core/base/error.h"
#include "framework/staff/grade/archive.h"

namespace relief::grade {
namespace {

struct Free {
    void operator()(archive* reader) const { archive_read_free(reader); }
};
using Reader = std::unique_ptr<archive, Free>;

[[noreturn]] void fail(archive* reader) {
    const char* const reason = archive_error_string(reader);
    throw Error(fmt::format("not a zip or tar archive, or damaged: {}", reason ? reason : "no reason given"));
}

[[noreturn]] void too_much() { throw Error(fmt::format("unpacks to more than {} MiB", max_unpacked_bytes >> 20)); }

Reader open(int descriptor) {
    Reader reader(archive_read_new());
    archive* const a = reader.get();
    archive_read_support_format_zip(a);
    archive_read_support_format_tar(a);
    archive_read_support_filter_gzip(a);
    archive_read_support_filter_bzip2(a);
    archive_read_support_filter_xz(a);
    archive_read_support_filter_zstd(a);
    if (archive_read_open_fd(a, descriptor, 1 << 16) != ARCHIVE_OK) fail(a);
    return reader;
}

/// Reads an entry to its end, block by block, to count the unpacked bytes. A skip would not count them.
void read_content(archive* reader, ArchiveEntry& entry, bool keep, size_t largest, size_t& unpacked) {
    const void* block = nullptr;
    size_t size = 0;
    int64_t offset = 0;
    for (;;) {
        const int state = archive_read_data_block(reader, &block, &size, &offset);
        if (state == ARCHIVE_EOF) return;
        if (state < ARCHIVE_WARN) fail(reader);
        unpacked += size;
        if (unpacked > max_unpacked_bytes) too_much();
        // The end of a block counts, since the holes of a sparse file are not blocks.
        entry.too_large |= offset < 0 || uint64_t(offset) + size > largest;
        if (!keep || entry.too_large) continue;
        entry.content.resize(size_t(offset));
        entry.content.append(static_cast<const char*>(block), size);
    }
}

/// Sets this thread's encoding to UTF-8: libarchive converts names to it, and returns none if that fails.
class Utf8Names {
public:
    Utf8Names() : locale_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), before_(uselocale(locale_)) {}
    ~Utf8Names() {
        uselocale(before_);
        if (locale_) freelocale(locale_);
    }
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    locale_t locale_, before_;
};

}  // namespace

extern "C" [[gnu::visibility("default")]] void relief_read_archive(
    int descriptor, const std::function<size_t(const std::string&)>& largest, std::vector<ArchiveEntry>& entries) {
    const Utf8Names utf8;
    const Reader reader = open(descriptor);
    size_t unpacked = 0, names = 0;
    archive_entry* found = nullptr;
    for (;;) {
        const int state = archive_read_next_header(reader.get(), &found);
        if (state == ARCHIVE_EOF) return;
        if (state < ARCHIVE_WARN) fail(reader.get());
        if (entries.size() == max_entries) throw Error(fmt::format("has more than {} entries", max_entries));
        const char* const name = archive_entry_pathname(found);
        if (!name) throw Error("has a file whose name cannot be read: pack it anew, as zip or tar");
        // The unpacked bytes so far, including a tar's headers with their long names.
        if (archive_filter_bytes(reader.get(), 0) > int64_t(max_unpacked_bytes)) too_much();
        const size_t length = std::strlen(name);
        if (length > max_name_bytes) throw Error(fmt::format("has a name of more than {} bytes", max_name_bytes));
        names += length;
        if (names > max_names_bytes)
            throw Error(fmt::format("has names of more than {} MiB in all", max_names_bytes >> 20));
        ArchiveEntry& entry = entries.emplace_back();
        entry.name = name;
        entry.is_link = archive_entry_hardlink(found) || archive_entry_symlink(found);
        entry.is_file = archive_entry_filetype(found) == AE_IFREG && !entry.is_link;
        const size_t most = entry.is_file ? largest(entry.name) : 0;
        const bool keep = most > 0;
        // A zip has an index, so skipping an unwanted entry unpacks nothing.
        const bool is_zip = (archive_format(reader.get()) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_ZIP;
        if (keep || !is_zip) read_content(reader.get(), entry, keep, most, unpacked);
        if (entry.too_large) entry.content.clear();
    }
}

}  // namespace relief::grade
