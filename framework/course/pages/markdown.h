// Parses Markdown to blocks of styled text, by md4c. The caller decides how to display them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relief::pages {

/// A run of text in one style. A hard line break is a '\n'.
struct Span {
    std::string text;  ///< of an image: its alternative text
    bool bold = false, italic = false, code = false, image = false;
    std::string target = {};  ///< of a link or an image
    bool operator==(const Span&) const = default;
};
using Spans = std::vector<Span>;

enum class BlockKind { paragraph, heading, item, quote, code, table, rule };

struct Block {
    BlockKind kind = BlockKind::paragraph;
    /// Of a heading: 1 to 6. Of an item: the depth of its list, from 0. Of any other block: the number of lists around
    /// it.
    int level = 0;
    std::string marker = {};                    ///< of an item: "*", or its number and a point, "2."
    Spans spans = {};                           ///< of a paragraph, a heading, an item, a quote
    std::string text = {};                      ///< of code: its lines
    std::string language = {};                  ///< of code: the first word after its fence
    std::vector<std::vector<Spans>> rows = {};  ///< of a table, heading first, all with the same number of cells
    bool operator==(const Block&) const = default;
};

/// Parses CommonMark with GitHub's tables. HTML is treated as text. Any text is valid: syntax that is unknown or not
/// closed stays as written.
std::vector<Block> parse_markdown(std::string_view text);

/// Parses a line of text, such as a hint, where backticks enclose code and no other mark-up exists. Drops a backtick
/// without a partner.
Spans line_with_code(std::string_view line);

/// Returns the text without styles and backticks, for a terminal.
std::string plain_text(const Spans& spans);

}  // namespace relief::pages
