#include "framework/course/window/menu_tiles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace relief::window {

std::vector<TileMean> tile_means(const std::vector<PictureWord>& words, const Image& error) {
    std::vector<TileMean> means;
    std::vector<std::pair<glm::vec2, glm::vec2>> seen;
    for (const PictureWord& word : words) {
        if (word.kind != PictureWord::Kind::caption) continue;
        const std::pair place(word.place, word.size);
        if (std::find(seen.begin(), seen.end(), place) != seen.end()) continue;
        seen.push_back(place);
        const auto column = [&](float share) {
            return std::clamp(int(std::lround(share * float(error.width))), 0, error.width);
        };
        const auto row = [&](float share) {
            return std::clamp(int(std::lround(share * float(error.height))), 0, error.height);
        };
        double sum = 0;
        int count = 0;
        for (int y = row(word.place.y); y < row(word.place.y + word.size.y); ++y)
            for (int x = column(word.place.x); x < column(word.place.x + word.size.x); ++x)
                if (const float value = error.pixel(x, y)[0]; std::isfinite(value) && value != not_written)
                    sum += double(value), ++count;
        if (count > 0) means.push_back({word.place, word.size, word.foot, sum / count});
    }
    return seen.size() > 1 ? means : std::vector<TileMean>();
}

std::vector<size_t> even_rows(size_t count, size_t columns) {
    std::vector<size_t> lengths;
    for (size_t rows = (count + columns - 1) / columns; rows > 0; --rows) {
        lengths.push_back((count + rows - 1) / rows);
        count -= lengths.back();
    }
    return lengths;
}

glm::ivec2 beside(glm::ivec2 pixel, glm::ivec2 size, const Box& room, const std::vector<Box>& words) {
    constexpr int gap = 16;
    std::optional<glm::ivec2> first;
    for (const bool is_above : {false, true})
        for (const bool is_left : {false, true}) {
            const Box box{
                {is_left ? pixel.x - gap - size.x : pixel.x + gap, is_above ? pixel.y - gap - size.y : pixel.y + gap},
                size};
            if (box.at.x < room.at.x || box.at.y < room.at.y || box.right() > room.right() ||
                box.bottom() > room.bottom())
                continue;
            const bool hides = std::any_of(words.begin(), words.end(), [&](const Box& word) {
                return word.at.x < box.right() && box.at.x < word.right() && word.at.y < box.bottom() &&
                       box.at.y < word.bottom();
            });
            if (!hides) return box.at;
            if (!first) first = box.at;
        }
    return first.value_or(glm::clamp(pixel + gap, room.at, glm::max(room.at, room.at + room.size - size)));
}

}  // namespace relief::window
