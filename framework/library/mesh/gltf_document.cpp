#include "framework/library/mesh/gltf_document.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"

namespace relief {
namespace {

using nlohmann::json;

/// Returns a number if it is whole and from 0 to 2^53, or -1.
double whole_number(const json& value) {
    const double number = value.is_number() ? value.get<double>() : -1;
    return number >= 0 && number <= 9007199254740992.0 && number == std::floor(number) ? number : -1;
}

uint32_t word_at(const std::string& bytes, size_t place) {
    uint32_t word = 0;
    for (size_t i = 0; i < 4; ++i) word |= uint32_t(static_cast<unsigned char>(bytes[place + i])) << 8 * i;
    return word;
}

/// The parts of a .glb, or the JSON alone.
struct Chunks {
    std::string_view json;
    std::optional<std::string> binary;
};

Chunks chunks_of(const std::string& bytes) {
    constexpr uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
    if (!bytes.starts_with("glTF")) return {bytes, {}};
    if (bytes.size() < 12) throw Error("damaged: it breaks off in its header");
    if (word_at(bytes, 4) != 2) throw Error(fmt::format("is glTF {}: export glTF 2.0", word_at(bytes, 4)));
    if (word_at(bytes, 8) > bytes.size())
        throw Error(fmt::format("damaged: it has {} of its {} bytes", bytes.size(), word_at(bytes, 8)));
    Chunks chunks;
    const size_t end = word_at(bytes, 8);
    for (size_t place = 12; place + 8 <= end;) {
        const size_t size = word_at(bytes, place);
        const uint32_t kind = word_at(bytes, place + 4);
        const bool is_first = place == 12;
        place += 8;
        if (size > end - place) throw Error("damaged: a chunk ends behind the file");
        if (is_first && kind == json_chunk)
            chunks.json = std::string_view(bytes).substr(place, size);
        else if (!is_first && kind == binary_chunk && !chunks.binary)
            chunks.binary = bytes.substr(place, size);
        place += size;
    }
    if (chunks.json.data() == nullptr) throw Error("damaged: its first chunk is no JSON");
    return chunks;
}

/// Returns what base64 encodes, or nothing for a text that is none.
std::optional<std::string> from_base64(std::string_view text) {
    while (text.ends_with('=')) text.remove_suffix(1);
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<int8_t, 256> value_of;
    value_of.fill(-1);
    for (size_t i = 0; i < digits.size(); ++i) value_of[static_cast<unsigned char>(digits[i])] = int8_t(i);
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    uint32_t kept = 0;
    int bits = 0;
    for (const char c : text) {
        const int8_t value = value_of[static_cast<unsigned char>(c)];
        if (value < 0) return {};
        kept = kept << 6 | uint32_t(value), bits += 6;
        if (bits >= 8) bits -= 8, bytes += char(kept >> bits & 255);
    }
    return bytes;
}

/// Returns the name of a file, in which %20 stands for a blank.
std::string file_name(const std::string& uri) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto digit = [&](size_t i) {
        return i < uri.size() ? digits.find(char(std::tolower(static_cast<unsigned char>(uri[i])))) : digits.npos;
    };
    std::string name;
    for (size_t i = 0; i < uri.size(); ++i) {
        const size_t high = digit(i + 1), low = digit(i + 2);
        if (uri[i] == '%' && high != digits.npos && low != digits.npos)
            name += char(16 * high + low), i += 2;
        else
            name += uri[i];
    }
    return name;
}

/// Returns whether an extension can change no position, normal, tangent or uv, or is read.
bool is_harmless(const std::string& extension) {
    for (const char* const one : {"KHR_mesh_quantization", "KHR_texture_transform", "KHR_lights_punctual"})
        if (extension == one) return true;
    return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_xmp");
}

/// Returns whether a file has another form of what an extension holds, which is read. Where it has none, the buffer or
/// the picture is missing, and is refused.
bool has_fallback(const std::string& extension) {
    return extension.find("_texture_") != std::string::npos || extension.find("compression") != std::string::npos;
}

}  // namespace

std::string quoted_in_message(const std::string& text) {
    std::string line = text.substr(0, 60);
    if (text.size() > line.size()) line += "...";
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    return line;
}

void GltfObject::refuse(const char* key, const char* what) const {
    throw Error(fmt::format("damaged: \"{}\" of {} is no {}", key, name_, what));
}
const json* GltfObject::find(const char* key) const {
    if (!json_->is_object()) throw Error(fmt::format("damaged: {} is no object", name_));
    const auto found = json_->find(key);
    return found == json_->end() ? nullptr : &*found;
}
const json& GltfObject::array(const char* key) const {
    static const json none = json::array();
    const json* const value = find(key);
    if (value && !value->is_array()) refuse(key, "list");
    return value ? *value : none;
}
int GltfObject::index(const char* key) const {
    const json* const value = find(key);
    if (!value) return -1;
    const double number = whole_number(*value);
    if (number < 0 || number > INT32_MAX) refuse(key, "index");
    return int(number);
}
size_t GltfObject::whole(const char* key, size_t otherwise) const {
    const json* const value = find(key);
    if (!value) return otherwise;
    const double number = whole_number(*value);
    if (number < 0) refuse(key, "whole number from 0 to 2^53");
    return size_t(number);
}
double GltfObject::number(const char* key, double otherwise) const {
    const json* const value = find(key);
    if (!value) return otherwise;
    if (!value->is_number()) refuse(key, "number");
    return value->get<double>();
}
bool GltfObject::flag(const char* key) const {
    const json* const value = find(key);
    if (value && !value->is_boolean()) refuse(key, "true or false");
    return value && value->get<bool>();
}
std::string GltfObject::text(const char* key) const {
    const json* const value = find(key);
    if (!value) return {};
    if (!value->is_string()) refuse(key, "text");
    return value->get<std::string>();
}
std::vector<std::string> GltfObject::texts(const char* key) const {
    std::vector<std::string> all;
    for (const json& one : array(key)) {
        if (!one.is_string()) refuse(key, "list of texts");
        all.push_back(one.get<std::string>());
    }
    return all;
}
std::vector<double> GltfObject::numbers(const char* key) const {
    std::vector<double> all;
    for (const json& one : array(key)) {
        if (!one.is_number()) refuse(key, "list of numbers");
        all.push_back(one.get<double>());
    }
    return all;
}
std::vector<double> GltfObject::numbers(const char* key, size_t count) const {
    std::vector<double> all = numbers(key);
    if (has(key) && all.size() != count)
        throw Error(fmt::format("damaged: \"{}\" of {} has {} numbers instead of {}", key, name_, all.size(), count));
    return all;
}
std::vector<int> GltfObject::indices(const char* key) const {
    std::vector<int> all;
    for (const json& one : array(key)) {
        const double number = whole_number(one);
        if (number < 0 || number > INT32_MAX) refuse(key, "list of indices");
        all.push_back(int(number));
    }
    return all;
}
GltfObject GltfObject::object(const char* key) const {
    static const json none = json::object();
    const json* const value = find(key);
    if (value && !value->is_object()) refuse(key, "object");
    return {value ? *value : none, fmt::format("{}, {}", name_, key)};
}
std::vector<GltfObject> GltfObject::objects(const char* key) const {
    std::vector<GltfObject> all;
    for (const json& one : array(key)) {
        if (!one.is_object()) refuse(key, "list of objects");
        all.emplace_back(one, fmt::format("{}, {} {}", name_, key, all.size()));
    }
    return all;
}
std::vector<std::string> GltfObject::keys() const {
    std::vector<std::string> all;
    for (const auto& [key, value] : json_->items()) all.push_back(key);
    return all;
}

void GltfNotes::add(const std::string& part, const std::string& message) {
    for (Note& note : notes_)
        if (note.message == message) {
            note.count += part != note.last;
            note.last = part;
            return;
        }
    constexpr size_t most = 20;
    if (notes_.size() < most) notes_.push_back({part, message});
}
std::vector<std::string> GltfNotes::lines() const {
    std::vector<std::string> all;
    for (const auto& [part, message, last, count] : notes_)
        all.push_back(part.empty() ? message
                      : count == 1 ? fmt::format("{}: {}", part, message)
                                   : fmt::format("{} and {} more: {}", part, count - 1, message));
    return all;
}

GltfDocument::GltfDocument(const std::string& bytes, std::filesystem::path folder, const ObjLimits& limits)
    : folder_(std::move(folder)), limits_(limits), bytes_left_(limits.bytes) {
    if (bytes.size() > limits.bytes) throw Error(fmt::format("{} bytes, the limit is {}", bytes.size(), limits.bytes));
    auto [text, binary] = chunks_of(bytes);
    while (text.ends_with('\0')) text.remove_suffix(1);  // some writers pad with them instead of blanks
    chunk_ = std::move(binary);
    try {
        json_ = json::parse(text);
    } catch (const json::exception& error) {
        const auto* const parsing = dynamic_cast<const json::parse_error*>(&error);
        throw Error(parsing ? fmt::format("damaged: its JSON is faulty at byte {}", parsing->byte)
                            : "damaged: its JSON is faulty");
    }
    if (!json_.is_object()) throw Error("damaged: its JSON is no object");
    const std::string version = root_.object("asset").text("version");
    if (version.empty()) throw Error("damaged: it has no version of glTF");
    if (!version.starts_with("2.")) throw Error(fmt::format("is glTF {}: export glTF 2.0", quoted_in_message(version)));
    check_extensions();
}

void GltfDocument::check_extensions() {
    const std::vector<std::string> required = root_.texts("extensionsRequired");
    for (const std::string& extension : required)
        if (!is_harmless(extension))
            throw Error(fmt::format("needs {}, which is not read: export without it", quoted_in_message(extension)));
    for (const std::string& extension : root_.texts("extensionsUsed"))
        if (!is_harmless(extension) && !has_fallback(extension))
            notes.add("", fmt::format("{} is not read", quoted_in_message(extension)));
}

size_t GltfDocument::count(const char* list) const { return root_.objects(list).size(); }

GltfObject GltfDocument::element(const char* list, int index, const char* kind) const {
    const auto found = json_.find(list);
    const size_t count = found == json_.end() || !found->is_array() ? 0 : found->size();
    if (index < 0 || size_t(index) >= count)
        throw Error(fmt::format("damaged: there is no {} {}, but {} of them", kind, index, count));
    const json& value = (*found)[size_t(index)];
    if (!value.is_object()) throw Error(fmt::format("damaged: {} {} is no object", kind, index));
    return {value, fmt::format("{} {}", kind, index)};
}

std::string GltfDocument::read_uri(const std::string& uri, const std::string& name) {
    std::string bytes;
    if (uri.starts_with("data:")) {
        const size_t comma = uri.find(',');
        if (comma == uri.npos || !std::string_view(uri).substr(0, comma).ends_with(";base64"))
            throw Error(fmt::format("{} is a data URI that is not read: only base64 is", name));
        std::optional<std::string> decoded = from_base64(std::string_view(uri).substr(comma + 1));
        if (!decoded) throw Error(fmt::format("damaged: the base64 of {} has a character that is none", name));
        return *std::move(decoded);
    }
    bytes = read_file(folder_ / file_name(uri), bytes_left_);
    bytes_left_ -= bytes.size();
    return bytes;
}

std::span<const char> GltfDocument::buffer(int index) {
    const GltfObject buffer = element("buffers", index, "buffer");
    const size_t length = buffer.whole("byteLength", 0);
    const std::string* bytes = nullptr;
    if (buffer.has("uri")) {
        if (!buffers_.contains(index)) buffers_[index] = read_uri(buffer.text("uri"), buffer.name());
        bytes = &buffers_[index];
    } else if (index == 0 && chunk_) {
        bytes = &*chunk_;
    } else {
        const std::vector<std::string> extensions = buffer.object("extensions").keys();
        if (extensions.empty()) throw Error(fmt::format("{} names no file with its bytes", buffer.name()));
        throw Error(fmt::format("{} has no bytes but with {}, which is not read: export without it", buffer.name(),
                                quoted_in_message(extensions.front())));
    }
    if (bytes->size() < length)
        throw Error(fmt::format("damaged: {} has {} of its {} bytes", buffer.name(), bytes->size(), length));
    return std::span(bytes->data(), length);
}

std::span<const char> GltfDocument::view(int index) {
    const GltfObject view = element("bufferViews", index, "buffer view");
    const std::span<const char> bytes = buffer(view.index("buffer"));
    const size_t offset = view.whole("byteOffset", 0), length = view.whole("byteLength", 0);
    if (offset > bytes.size() || length > bytes.size() - offset)
        throw Error(fmt::format("damaged: buffer view {} ends behind its buffer of {} bytes", index, bytes.size()));
    return bytes.subspan(offset, length);
}

std::string GltfDocument::picture(int index) {
    const GltfObject image = element("images", index, "image");
    if (image.has("uri")) return read_uri(image.text("uri"), image.name());
    if (!image.has("bufferView")) throw Error(fmt::format("damaged: {} has no bytes", image.name()));
    const std::span<const char> bytes = view(image.index("bufferView"));
    return {bytes.begin(), bytes.end()};
}

}  // namespace relief
