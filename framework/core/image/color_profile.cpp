#include "framework/core/image/color_profile.h"

#include <fmt/format.h>

#include <cctype>

#include "framework/core/image/orientation.h"

namespace relief {
namespace {

using namespace std::string_view_literals;

size_t big_endian_at(std::string_view bytes, size_t at, size_t count) {
    size_t number = 0;
    for (size_t i = at; i < at + count; ++i)
        number = number << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0);
    return number;
}
std::string_view part_of(std::string_view bytes, size_t at, size_t count) {
    return at < bytes.size() ? bytes.substr(at, count) : std::string_view();
}

/// Returns the text of a tag in ASCII, of type desc or mluc, whose first language is taken. Other letters become '?'.
std::string text_of(std::string_view tag) {
    const bool is_wide = tag.starts_with("mluc"sv);
    const std::string_view letters = is_wide ? part_of(tag, big_endian_at(tag, 24, 4), big_endian_at(tag, 20, 4))
                                             : part_of(tag, 12, big_endian_at(tag, 8, 4));
    std::string text;
    for (size_t i = 0; i < letters.size() && text.size() < 60; i += is_wide ? 2 : 1) {
        const size_t letter = big_endian_at(letters, i, is_wide ? 2 : 1);
        if (letter == 0) break;
        text += letter >= ' ' && letter < 127 ? char(letter) : '?';
    }
    return text;
}

bool contains_word(std::string text, std::string_view word) {
    for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
    return text.find(word) != std::string::npos;
}
bool is_linear(const std::string& profile) { return contains_word(profile, "linear") || profile == "gamma 1"; }

}  // namespace

std::string icc_profile_name(std::string_view profile) {
    constexpr size_t header = 128, tag_size = 12;
    const size_t tags = std::min<size_t>(big_endian_at(profile, header, 4), profile.size() / tag_size);
    for (size_t i = 0; i < tags; ++i) {
        const size_t at = header + 4 + tag_size * i;
        if (part_of(profile, at, 4) != "desc") continue;
        const std::string name =
            text_of(part_of(profile, big_endian_at(profile, at + 4, 4), big_endian_at(profile, at + 8, 4)));
        if (name.empty()) break;
        return contains_word(name, "srgb") && !is_linear(name) ? "" : name;
    }
    return "unnamed";
}

std::string jpeg_profile_name(std::string_view bytes) {
    constexpr int app2 = 0xe2;
    const std::string_view segment = jpeg_segment(bytes, app2, "ICC_PROFILE\0"sv);
    return segment.empty() ? "" : icc_profile_name(part_of(segment, 2, segment.size()));  // behind "part 1 of n"
}

std::string profile_note(const Image& picture, bool is_map) {
    if (picture.profile.empty() || (is_map && is_linear(picture.profile))) return {};
    return fmt::format("its colour profile ({}) is not applied: {}", picture.profile,
                       is_map ? "a map's numbers are taken as stored" : "its colours are taken as sRGB");
}

}  // namespace relief
