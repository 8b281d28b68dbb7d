#include "framework/core/base/source_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "framework/core/base/code_text.h"
#include "framework/core/base/file.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

constexpr size_t longest_source = size_t{1} << 24;
constexpr size_t tab_width = 4;

/// A character that looks like one of ASCII. Word processors, web pages and other keyboards write it.
struct Lookalike {
    char32_t code;
    const char* name;
    const char* instead;
};
constexpr std::array lookalikes = {Lookalike{0x00a0, "a no-break space", "a blank"},
                                   Lookalike{0x00b4, "an acute accent", "'"},
                                   Lookalike{0x00b7, "a middle dot", "*"},
                                   Lookalike{0x00d7, "a multiplication sign", "*"},
                                   Lookalike{0x00f7, "a division sign", "/"},
                                   Lookalike{0x037e, "a Greek question mark", ";"},
                                   Lookalike{0x2002, "a wide space", "a blank"},
                                   Lookalike{0x2003, "a wide space", "a blank"},
                                   Lookalike{0x2007, "a no-break space", "a blank"},
                                   Lookalike{0x2009, "a thin space", "a blank"},
                                   Lookalike{0x200b, "an invisible space", "nothing"},
                                   Lookalike{0x200c, "an invisible character", "nothing"},
                                   Lookalike{0x200d, "an invisible character", "nothing"},
                                   Lookalike{0x200e, "an invisible character", "nothing"},
                                   Lookalike{0x200f, "an invisible character", "nothing"},
                                   Lookalike{0x2010, "a hyphen", "-"},
                                   Lookalike{0x2011, "a hyphen", "-"},
                                   Lookalike{0x2012, "a dash", "-"},
                                   Lookalike{0x2013, "a dash", "-"},
                                   Lookalike{0x2014, "a dash", "-"},
                                   Lookalike{0x2018, "a typographic quote", "'"},
                                   Lookalike{0x2019, "a typographic quote", "'"},
                                   Lookalike{0x201c, "a typographic quote", "\""},
                                   Lookalike{0x201d, "a typographic quote", "\""},
                                   Lookalike{0x201e, "a typographic quote", "\""},
                                   Lookalike{0x2028, "a line separator", "the end of a line"},
                                   Lookalike{0x2029, "a paragraph separator", "the end of a line"},
                                   Lookalike{0x202f, "a no-break space", "a blank"},
                                   Lookalike{0x2044, "a fraction slash", "/"},
                                   Lookalike{0x2060, "an invisible character", "nothing"},
                                   Lookalike{0x2062, "an invisible character", "nothing"},
                                   Lookalike{0x2212, "a minus sign", "-"},
                                   Lookalike{0x2215, "a division slash", "/"},
                                   Lookalike{0x2217, "an asterisk operator", "*"},
                                   Lookalike{0x2264, "a less-or-equal sign", "<="},
                                   Lookalike{0x2265, "a greater-or-equal sign", ">="},
                                   Lookalike{0x22c5, "a dot operator", "*"},
                                   Lookalike{0x3000, "a wide space", "a blank"},
                                   Lookalike{0xfeff, "a byte order mark", "nothing"},
                                   Lookalike{0xff08, "a wide bracket", "("},
                                   Lookalike{0xff09, "a wide bracket", ")"},
                                   Lookalike{0xff0c, "a wide comma", ","},
                                   Lookalike{0xff1b, "a wide semicolon", ";"},
                                   Lookalike{0xff1d, "a wide equals sign", "="}};

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }
bool is_beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// A character at the start of a text: its code point and its length in bytes. Bytes that are no UTF-8 have no code.
struct Utf8Character {
    std::optional<char32_t> code;
    size_t size = 1;
};
Utf8Character utf8_character(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const size_t size = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
    if (size == 0 || size > text.size()) return {};
    char32_t code = size == 1 ? first : first & (0x7fU >> size);
    for (size_t i = 1; i < size; ++i) {
        if (!continues_character(text[i])) return {};
        code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3fU);
    }
    return {code, size};
}

size_t characters_in(std::string_view text) {
    return size_t(std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

/// Returns the name of an encoding with units of two or four bytes, or nothing. Half of the bytes of such a text in
/// English are 0.
std::optional<std::string> wide_encoding_of(std::string_view text) {
    const std::string_view begin = text.substr(0, 256);
    if (begin.starts_with(std::string_view("\xff\xfe\0\0", 4)) ||
        begin.starts_with(std::string_view("\0\0\xfe\xff", 4)))
        return "UTF-32";
    if (begin.starts_with("\xff\xfe") || begin.starts_with("\xfe\xff")) return "UTF-16";
    const auto zeros = size_t(std::count(begin.begin(), begin.end(), '\0'));
    if (begin.size() < 8 || zeros < begin.size() / 3) return {};
    return zeros > begin.size() / 2 + 1 ? "UTF-32" : "UTF-16";
}

/// Looks for the first fault.
class FaultFinder {
public:
    FaultFinder(const std::string& text, bool is_glsl) : text_(text), is_glsl_(is_glsl) {}

    std::optional<SourceFault> find() {
        if (const auto encoding = wide_encoding_of(text_))
            return SourceFault{0, fmt::format("this is text in {}: save it as UTF-8", *encoding)};
        if (const size_t zero = text_.find('\0'); zero != std::string_view::npos)
            return fault(zero, fmt::format("{} is a byte 0, where a compiler stops reading: remove it", column(zero)));
        for (const CodeToken& token : all_tokens(text_))
            if (auto found = fault_at(token)) return found;
        if (!is_glsl_) return {};
        if (!opened_.empty()) return fault(opened_.back(), "this #if has no #endif in this file", false);
        const std::string_view rest = std::string_view(text_).substr(0, text_.find_last_not_of('\n') + 1);
        if (rest.ends_with('\\') && text_.size() - rest.size() <= 1)
            return fault(
                rest.size() - 1,
                "the last line ends in a backslash, which joins it with the line behind it: remove the backslash");
        return {};
    }

private:
    std::optional<SourceFault> fault_at(const CodeToken& token) {
        if (token.kind == CodeToken::literal && !is_glsl_) return {};
        if (token.kind == CodeToken::comment) {
            const bool is_open = token.text.starts_with("/*") && (token.text.size() < 4 || !token.text.ends_with("*/"));
            if (is_open && is_glsl_) return fault(token.begin, "this comment is never closed by */", false);
        } else if (token.kind == CodeToken::directive) {
            return fault_of_directive(token);
        } else {
            for (size_t i = 0; i < token.text.size(); ++i)
                if (is_beyond_ascii(token.text[i])) return character(token.begin + i);
        }
        return {};
    }

    std::optional<SourceFault> fault_of_directive(const CodeToken& line) {
        const std::vector<CodeToken> words = tokens_of_directive(line);
        const std::string word = words.size() > 1 ? words[1].text : "";
        if (!is_glsl_) return {};
        if (word == "if" || word == "ifdef" || word == "ifndef") opened_.push_back(line.begin);
        if ((word == "else" || word == "elif" || word == "endif") && opened_.empty())
            return fault(line.begin, fmt::format("this #{} has no #if before it in this file", word), false);
        if (word == "endif") opened_.pop_back();
        const bool is_one_line = line.end - line.begin == line.text.size();
        for (const CodeToken& part : words)
            if (is_beyond_ascii(part.text[0])) return character(line.begin + (is_one_line ? part.begin : 0));
        return {};
    }

    /// Returns the fault of a character beyond ASCII in code.
    std::optional<SourceFault> character(size_t place) const {
        const Utf8Character one = utf8_character(std::string_view(text_).substr(place));
        const auto known = std::find_if(lookalikes.begin(), lookalikes.end(),
                                        [&](const Lookalike& each) { return one.code == each.code; });
        if (known != lookalikes.end())
            return fault(place, fmt::format("{} is {} (U+{:04X}): write {} instead", column(place), known->name,
                                            unsigned(known->code), known->instead));
        if (!is_glsl_) return {};
        if (one.code)
            return fault(place, fmt::format("{} is '{}' (U+{:04X}): outside of comments GLSL has only ASCII characters",
                                            column(place), text_.substr(place, one.size), unsigned(*one.code)));
        return fault(place, fmt::format("{} is a byte 0x{:02x}, which is not UTF-8: save the file as UTF-8",
                                        column(place), static_cast<unsigned char>(text_[place])));
    }

    size_t begin_of_line(size_t place) const {
        return place == 0 ? 0 : text_.rfind('\n', place - 1) + 1;  // npos + 1 is 0
    }
    std::string column(size_t place) const {
        const size_t begin = begin_of_line(place);
        return fmt::format("column {}", 1 + characters_in(std::string_view(text_).substr(begin, place - begin)));
    }
    SourceFault fault(size_t place, std::string message, bool is_marked = true) const {
        const size_t begin = begin_of_line(place);
        const std::string line = text_.substr(begin, text_.find('\n', place) - begin);
        const int number = 1 + int(std::count(text_.begin(), text_.begin() + std::ptrdiff_t(place), '\n'));
        return {number, std::move(message), marked_line(line, is_marked ? place - begin : std::string::npos)};
    }

    const std::string& text_;
    bool is_glsl_;
    std::vector<size_t> opened_;  ///< where each open #if stands
};

}  // namespace

std::string plain_source(std::string bytes) {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
    if (bytes.find('\r') == std::string::npos) return bytes;
    std::string text;
    text.reserve(bytes.size());
    for (size_t i = 0; i < bytes.size(); ++i)
        if (bytes[i] != '\r')
            text += bytes[i];
        else if (i + 1 == bytes.size() || bytes[i + 1] != '\n')
            text += '\n';
    return text;
}

std::string read_source(const fs::path& file) { return plain_source(read_file(file, longest_source)); }

std::optional<SourceFault> fault_of_source(const std::string& text, const fs::path& file) {
    return FaultFinder(text, file.extension() != ".cpp" && file.extension() != ".h").find();
}

void refuse_faulty_source(const std::string& text, const fs::path& file) {
    if (const auto fault = fault_of_source(text, file)) throw Error({file, fault->line}, fault->message, fault->quote);
}

std::string marked_line(const std::string& line, size_t byte) {
    std::string shown, below;
    for (size_t i = 0, column = 0; i < line.size(); ++i) {
        if (continues_character(line[i])) {
            shown += line[i];
            continue;
        }
        const size_t width = line[i] == '\t' ? tab_width - column % tab_width : 1;
        shown += line[i] == '\t' ? std::string(width, ' ') : std::string(1, line[i]);
        if (i < byte) below.append(width, ' ');
        column += width;
    }
    // A control character would move the cursor of a terminal, or be invisible on a page.
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return "    " + shown + "\n" + (byte <= line.size() ? "    " + below + "^\n" : "");
}

}  // namespace relief
