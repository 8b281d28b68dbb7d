#include "framework/course/pages/picture_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace relief::pages {
namespace {

std::string percent(float share) { return fmt::format("{:.2f}%", 100 * share); }
std::string box_of(const PictureWord& word) {
    return fmt::format("left:{};top:{};width:{};height:{}", percent(word.place.x), percent(word.place.y),
                       percent(word.size.x), percent(word.size.y));
}
std::string color_of(glm::vec4 color) {
    const auto byte = [](float value) { return int(std::lround(255 * std::clamp(value, 0.0f, 1.0f))); };
    return fmt::format("rgb({} {} {} / {:.2f})", byte(color.x), byte(color.y), byte(color.z), color.w);
}

/// Returns the captions of each tile at its top, and at its bottom, and its legend.
List tiles_of_captions(std::span<const PictureWord> words) {
    std::vector<PictureWord> captions;
    for (const PictureWord& word : words)
        if (word.kind == PictureWord::Kind::caption || word.kind == PictureWord::Kind::legend) captions.push_back(word);
    const auto same_tile = [](const PictureWord& a, const PictureWord& b) {
        return a.place == b.place && a.size == b.size;
    };
    List tiles;
    for (size_t i = 0; i < captions.size(); ++i) {
        if (std::any_of(captions.begin(), captions.begin() + std::ptrdiff_t(i),
                        [&](const PictureWord& other) { return same_tile(other, captions[i]); }))
            continue;
        std::vector<PictureWord> lines;
        for (const PictureWord& word : captions)
            if (same_tile(word, captions[i])) lines.push_back(word);
        // From the top: 0, 1, ..., -2, -1.
        std::stable_sort(lines.begin(), lines.end(), [](const PictureWord& a, const PictureWord& b) {
            return unsigned(a.line) < unsigned(b.line);
        });
        const bool has_foot = lines.front().foot > 0;
        List top, bottom, legend;
        for (const PictureWord& word : lines) {
            const std::string color = color_of(word.color);
            if (word.kind == PictureWord::Kind::legend) {
                legend.push_back(Fields{{"text", word.text}, {"style", "background:" + color}});
                continue;
            }
            (word.line < 0 || has_foot ? bottom : top)
                .push_back(Fields{{"text", word.text}, {"style", "color:" + color}});
        }
        tiles.push_back(Fields{
            {"style", box_of(captions[i])},
            {"corner", fmt::format("left:{};top:{}", percent(captions[i].place.x), percent(captions[i].place.y))},
            {"number", std::to_string(tiles.size() + 1)},
            {"top", std::move(top)},
            {"bottom", std::move(bottom)},
            {"legend", std::move(legend)}});
    }
    return tiles;
}

bool same_height(const PictureWord& a, const PictureWord& b) {
    return std::abs(a.place.y - b.place.y) < 0.5f * std::max(a.size.y, b.size.y);
}

/// Returns true for a small box beside a line of text, which shows the colour that the line is about.
bool is_swatch(const PictureWord& word, const PictureWord& text) {
    const float middle = text.place.y + 0.5f * text.size.y;
    return word.kind == PictureWord::Kind::box && word.size.y < 2 * text.size.y && word.place.x < text.place.x &&
           word.place.y < middle && middle < word.place.y + word.size.y;
}

/// Returns the texts that have one height, from left to right, for each height.
std::vector<std::vector<PictureWord>> texts_by_height(std::span<const PictureWord> words) {
    std::vector<std::vector<PictureWord>> rows;
    for (const PictureWord& word : words) {
        if (word.kind != PictureWord::Kind::text || word.text.empty()) continue;
        const auto row =
            std::find_if(rows.begin(), rows.end(), [&](const auto& other) { return same_height(other.front(), word); });
        if (row == rows.end())
            rows.push_back({word});
        else
            row->push_back(word);
    }
    for (auto& row : rows)
        std::stable_sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.place.x < b.place.x; });
    return rows;
}

/// Returns the lines of texts. A line begins with a swatch and ends before the next one. Narrow screens show the lines
/// below the picture.
List lines_of_texts(std::span<const PictureWord> words) {
    List list;
    for (const std::vector<PictureWord>& row : texts_by_height(words)) {
        List swatches, texts;
        const auto end_line = [&] {
            if (!texts.empty()) list.push_back(Fields{{"swatches", std::move(swatches)}, {"texts", std::move(texts)}});
            swatches = {}, texts = {};
        };
        for (size_t i = 0; i < row.size(); ++i) {
            List own;
            for (const PictureWord& word : words)
                if (is_swatch(word, row[i]) && (i == 0 || !is_swatch(word, row[i - 1])))
                    own.push_back(Fields{{"style", box_of(word) + ";background:" + color_of(word.color)}});
            if (!own.empty()) end_line(), swatches = std::move(own);
            const std::string style = fmt::format("left:{};top:{};color:{};transform:translateX({:.0f}%);--high:{:.2f}",
                                                  percent(row[i].place.x), percent(row[i].place.y),
                                                  color_of(row[i].color), -100 * row[i].anchor, 100 * row[i].size.y);
            texts.push_back(Fields{{"text", row[i].text}, {"style", style}});
        }
        end_line();
    }
    return list;
}

Fields fields_of(std::span<const PictureWord> words) {
    const auto has_line = [&](const PictureWord& box) {
        return std::any_of(words.begin(), words.end(), [&](const PictureWord& word) {
            return word.kind == PictureWord::Kind::text && !word.text.empty() && is_swatch(box, word);
        });
    };
    const auto is_behind_text = [&](const PictureWord& box) {
        return std::any_of(words.begin(), words.end(), [&](const PictureWord& word) {
            const glm::vec2 inside = word.place - box.place;
            return word.kind == PictureWord::Kind::text && inside.x >= 0 && inside.y >= 0 && inside.x <= box.size.x &&
                   inside.y <= box.size.y;
        });
    };
    List boxes;  // narrow screens show them over the picture, since they mark its places, but for those behind a text
    Value scale;
    for (const PictureWord& word : words) {
        if (word.kind == PictureWord::Kind::box && !has_line(word)) {
            boxes.push_back(Fields{{"kind", is_behind_text(word) ? "behind" : "mark"},
                                   {"style", box_of(word) + ";background:" + color_of(word.color)}});
        } else if (word.kind == PictureWord::Kind::scale) {
            List ticks;
            for (int tick = 1; tick < word.parts; ++tick)
                ticks.push_back(Fields{{"style", "left:" + percent(float(tick) / float(word.parts))}});
            scale = Fields{{"low", word.text}, {"high", word.end}, {"ticks", std::move(ticks)}};
        }
    }
    List notes;
    for (const PictureWord& word : words)
        if (word.kind == PictureWord::Kind::note) notes.push_back(Fields{{"text", word.text}});
    const List tiles = tiles_of_captions(words);
    return {
        {"tiles", tiles}, {"numbers", tiles.size() > 1 ? tiles : List{}},  // the list of a narrow screen refers to them
        {"boxes", boxes}, {"lines", lines_of_texts(words)},
        {"scale", scale}, {"notes", notes}};
}

}  // namespace

Value picture_words(std::span<const PictureWord> words) {
    if (words.empty()) return {};
    return fields_of(words);
}

std::string picture_words_markup(std::span<const PictureWord> words) {
    return words.empty() ? "" : render("picture_words", fields_of(words));
}

PictureWord error_map_scale(const std::string& largest) {
    return {.kind = PictureWord::Kind::scale, .text = "0", .end = largest + " and more"};
}

}  // namespace relief::pages
