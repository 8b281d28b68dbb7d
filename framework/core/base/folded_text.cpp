#include "framework/core/base/folded_text.h"

#include <fmt/format.h>

#include "framework/core/base/text.h"

namespace relief {
namespace {

constexpr char fold = '\f';  // stands between the parts; no compiler writes it
bool shows_all_messages = false;

}  // namespace

std::string folded_text(const FoldedText& parts) {
    return parts.folded.empty() ? parts.shown : parts.shown + fold + join(parts.folded, "\n");
}

FoldedText unfolded_text(const std::string& text) {
    const size_t at = text.find(fold);
    if (at == std::string::npos) return {text, {}};
    return {text.substr(0, at), split(std::string_view(text).substr(at + 1), '\n')};
}

std::vector<std::string> lines_for_terminal(const std::string& text) {
    const FoldedText parts = unfolded_text(text);
    std::vector<std::string> lines = split(parts.shown, '\n');
    std::erase(lines, "");
    if (shows_all_messages)
        lines.insert(lines.end(), parts.folded.begin(), parts.folded.end());
    else if (!parts.folded.empty())
        lines.push_back(fmt::format("and {} (--verbose shows {})", more_messages(parts.folded.size()),
                                    parts.folded.size() == 1 ? "it" : "them"));
    return lines;
}

void show_all_messages(bool on) { shows_all_messages = on; }

std::string more_messages(size_t count) { return fmt::format("{} more message{}", count, count == 1 ? "" : "s"); }

}  // namespace relief
