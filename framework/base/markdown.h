// Markdown as blocks of styled text, parsed by md4c. How they are shown is up to the caller.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relief {

/// A run of text in one style. A line break that was asked for is a '\n'.
struct Span {
    std::string text;  ///< of an image: what stands in for it
    bool bold = false, italic = false, code = false, image = false;
    std::string target = {};  ///< of a link or an image
    bool operator==(const Span&) const = default;
};
using Spans = std::vector<Span>;

enum class BlockKind { paragraph, heading, item, quote, code, table, rule };

struct Block {
    BlockKind kind = BlockKind::paragraph;
    /// Of a heading 1 to 6; of anything else how deep it stands in lists, from 0; of an item how deep its list does.
    int level = 0;
    std::string marker = {};                    ///< of an item: "*", or its number as written, "2."
    Spans spans = {};                           ///< of a paragraph, a heading, an item, a quote
    std::string text = {};                      ///< of code: its lines
    std::string language = {};                  ///< of code: the first word after its fence
    std::vector<std::vector<Spans>> rows = {};  ///< of a table, the heading first; all have as many cells
    bool operator==(const Block&) const = default;
};

/// CommonMark with GitHub's tables. HTML is treated as text. Any text is valid: syntax that is not
/// closed, or not known, stays as written.
std::vector<Block> parse_markdown(std::string_view text);

/// A line of text, such as a hint, in which code stands between backticks, and nothing else is marked. A backtick without
/// a second one is left out.
Spans line_with_code(std::string_view line);

/// Without styles and backticks: for a terminal.
std::string plain_text(const Spans& spans);

}  // namespace relief
