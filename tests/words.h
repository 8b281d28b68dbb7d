// The places of words over a picture, checked.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "framework/library/kit/word_layout.h"

namespace relief {

/// Returns a line for each text that leaves its picture or its tile, overlaps another text, has lost letters, or is too
/// small or left out; an empty text if there is none. `words` are in pixels. With `may_leave_out`, a text may be left
/// out.
inline std::string faults_of_words(const std::vector<PictureWord>& words, glm::vec2 size, const Letters& letters,
                                   bool may_leave_out = false) {
    std::string faults;
    const auto add = [&](const char* fault, const std::string& text) {
        faults += fmt::format("{}: {}\n", fault, text);
    };
    const WordLayout layout = lay_out(words, size, letters);
    if (!may_leave_out)
        for (const std::string& text : layout.left_out) add("left out", text);
    const auto is_left_out = [&](const std::string& text) {
        return std::find(layout.left_out.begin(), layout.left_out.end(), text) != layout.left_out.end();
    };
    constexpr float rounding = 1.01f;  // letters are placed at whole pixels
    const auto is_inside = [](glm::vec2 place, glm::vec2 extent, const PlacedWord& text) {
        const glm::vec2 low = place - rounding, high = place + extent + rounding, end = text.place + text.size;
        return text.place.x >= low.x && text.place.y >= low.y && end.x <= high.x && end.y <= high.y;
    };
    std::vector<PlacedWord> texts;
    for (const PlacedWord& placed : layout.placed)
        if (placed.kind == PlacedWord::Kind::text) texts.push_back(placed);
    for (size_t i = 0; i < texts.size(); ++i) {
        const PlacedWord& text = texts[i];
        const PictureWord& word = words[text.of];
        const bool has_tile = word.kind == PictureWord::Kind::caption || word.kind == PictureWord::Kind::legend;
        if (!is_inside(glm::vec2(0), size, text)) add("leaves the picture", text.text);
        if (has_tile && !is_inside(word.place, word.size, text)) add("leaves its tile", text.text);
        // The numbers of a scale are as high as its strip, from which tiles have their sizes.
        if (text.size.y < letters.least && word.kind != PictureWord::Kind::scale) add("too small", text.text);
        for (size_t k = 0; k < i; ++k) {
            const glm::vec2 low = glm::max(text.place, texts[k].place),
                            high = glm::min(text.place + text.size, texts[k].place + texts[k].size);
            if (high.x - low.x > rounding && high.y - low.y > rounding)
                add("overlap", texts[k].text + " and " + text.text);
        }
    }
    for (size_t i = 0; i < words.size(); ++i) {
        if (words[i].kind != PictureWord::Kind::caption || is_left_out(words[i].text)) continue;
        std::string joined;
        std::vector<PlacedWord> lines;
        for (const PlacedWord& text : texts)
            if (text.of == i) lines.push_back(text);
        std::stable_sort(lines.begin(), lines.end(),
                         [](const PlacedWord& a, const PlacedWord& b) { return a.place.y < b.place.y; });
        for (const PlacedWord& line : lines) joined += (joined.empty() ? "" : " ") + line.text;
        if (joined != words[i].text) add("has lost letters", words[i].text + " is " + joined);
    }
    return faults;
}

}  // namespace relief
