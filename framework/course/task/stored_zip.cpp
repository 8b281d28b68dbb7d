#include "framework/course/task/stored_zip.h"

#include <cstdint>

namespace relief::check {
namespace {

/// CRC-32 of the zip format (ISO 3309).
uint32_t crc32_of(const std::string& bytes) {
    uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= uint8_t(byte);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

void put(std::string& out, uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out += char(value >> 8 * i & 0xff);
}

/// Puts the fields that a local header and a central one share.
void put_common(std::string& out, const std::string& name, const std::string& content) {
    put(out, 10, 2);      // version that unpacking needs: 1.0
    put(out, 0x0800, 2);  // names are UTF-8
    put(out, 0, 2);       // stored
    put(out, 0, 2);       // time
    put(out, 0x21, 2);    // date
    put(out, crc32_of(content), 4);
    put(out, uint32_t(content.size()), 4);
    put(out, uint32_t(content.size()), 4);
    put(out, uint32_t(name.size()), 2);
    put(out, 0, 2);  // no extra field
}

}  // namespace

std::string stored_zip(const std::map<std::string, std::string>& files) {
    std::string out, directory;
    for (const auto& [name, content] : files) {
        const size_t at = out.size();
        put(out, 0x04034b50, 4);
        put_common(out, name, content);
        out += name + content;
        put(directory, 0x02014b50, 4);
        put(directory, 10, 2);  // made by version 1.0
        put_common(directory, name, content);
        for (const int bytes : {2, 2, 2, 4}) put(directory, 0, bytes);  // no comment, disk 0, no attributes
        put(directory, uint32_t(at), 4);
        directory += name;
    }
    const size_t begin = out.size();
    out += directory;
    put(out, 0x06054b50, 4);
    put(out, 0, 4);  // disk 0 of 0
    put(out, uint32_t(files.size()), 2);
    put(out, uint32_t(files.size()), 2);
    put(out, uint32_t(directory.size()), 4);
    put(out, uint32_t(begin), 4);
    put(out, 0, 2);
    return out;
}

}  // namespace relief::check
