#include "framework/course/window/menu_tiles.h"

#include <algorithm>
#include <cmath>

namespace relief::window {

std::vector<TileMean> tile_means(const std::vector<PictureWord>& words, const Image& error) {
    std::vector<TileMean> means;
    size_t tiles = 0;
    for (const PictureWord& word : words) {
        if (word.kind != PictureWord::Kind::caption || word.line != 0) continue;
        ++tiles;
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
        if (count > 0) means.push_back({word.place, word.size, sum / count});
    }
    return tiles > 1 ? means : std::vector<TileMean>();
}

}  // namespace relief::window
