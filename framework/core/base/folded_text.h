// The details of an error from a compiler: lines for everybody, and messages that readers see folded.
#pragma once

#include <string>
#include <vector>

namespace relief {

/// Most of a compiler's messages follow from the first. Error::details() has both parts as one text, see folded_text().
struct FoldedText {
    std::string shown;                ///< lines such as that of the source, with a mark below it
    std::vector<std::string> folded;  ///< the other messages, one each
};

std::string folded_text(const FoldedText& parts);
FoldedText unfolded_text(const std::string& text);

/// Returns the lines of a text for a terminal. The folded ones become one line, such as "and 12 more messages
/// (--verbose shows them)", unless show_all_messages(true) was called, as --verbose does.
std::vector<std::string> lines_for_terminal(const std::string& text);
void show_all_messages(bool on);

/// Returns "12 more messages".
std::string more_messages(size_t count);

}  // namespace relief
