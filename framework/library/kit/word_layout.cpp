#include "framework/library/kit/word_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace relief {
namespace {

using Kind = PictureWord::Kind;
constexpr glm::vec4 plate{0.05f, 0.055f, 0.065f, 0.72f};       ///< behind a text
constexpr glm::vec4 strip_color{0.05f, 0.055f, 0.065f, 1.0f};  ///< behind a legend

/// One tile with its captions and its legend, as indices of words.
struct TileWords {
    glm::vec2 place, size;
    float foot = 0;
    std::vector<size_t> captions = {}, legend = {};
};

struct Line {
    std::string text;
    size_t of;
    float height;
};

/// The edges of a line: left and right of its letters, and above and below them.
float side_of(float height) { return 0.25f * height; }
float step_of(float height) { return std::round(1.25f * height); }

/// Returns the height of a title or of another caption in a tile `high` pixels high, if it has the room. A foot takes
/// its height from the picture, so its letters are smaller than those over a picture.
float caption_height(float high, bool is_title, bool has_foot, const Letters& letters) {
    const float title = std::clamp((has_foot ? 0.065f : 0.09f) * high, letters.least, letters.usual);
    return std::max(letters.least, is_title ? title : 0.8f * title);
}

/// Returns the text with blanks in words that no line has room for, such as the path of a file.
std::string with_short_words(const std::string& text, const std::function<bool(const std::string& line)>& fits) {
    std::string result, word;
    for (const char c : text) {
        const bool is_continued = (static_cast<unsigned char>(c) & 0xc0) == 0x80;  // inside of a letter of UTF-8
        if (c == ' ')
            word.clear();
        else if (word += c; !is_continued && word.size() > 1 && !fits(word))
            result += ' ', word = c;
        result += c;
    }
    return result;
}

class Layout {
public:
    Layout(const std::vector<PictureWord>& words, glm::vec2 size, const Letters& letters)
        : words_(words), size_(size), letters_(letters), foot_(size.y) {}

    WordLayout result() {
        for (size_t i = 0; i < words_.size(); ++i) {
            if (words_[i].kind == Kind::box) place_box(i);
            if (words_[i].kind == Kind::text) place_text(i);
            if (words_[i].kind == Kind::scale) place_scale(i);
        }
        place_notes();
        std::vector<TileWords> tiles = tiles_of_words();
        set_heights(tiles);
        for (const TileWords& tile : tiles) place_tile(tile);
        return std::move(result_);
    }

private:
    float rounded_height(float height) const {
        return letters_.even ? std::max(2.0f, 2 * std::floor(height / 2)) : height;
    }
    float width(const std::string& text, float height) const { return letters_.width(text, height); }

    void add(PlacedWord::Kind kind, glm::vec2 place, glm::vec2 size, glm::vec4 color, size_t of,
             const std::string& text = "") {
        result_.placed.push_back({kind, place, size, color, text, of});
    }
    /// Adds letters with a plate. `place` is the upper left corner of the first letter.
    void add_line(const std::string& text, glm::vec2 place, float height, size_t of, bool has_plate = true) {
        place = glm::round(place);
        const float wide = width(text, height), side = side_of(height);
        if (has_plate)
            add(PlacedWord::Kind::ground, place - glm::vec2(side, 0), {wide + 2 * side, 1.05f * height}, plate, of);
        add(PlacedWord::Kind::text, place, {wide, height}, words_[of].color, of, text);
    }

    void place_box(size_t i) { add(PlacedWord::Kind::box, words_[i].place, words_[i].size, words_[i].color, i); }

    void place_text(size_t i) {
        const PictureWord& word = words_[i];
        if (word.text.empty()) return;
        float height = rounded_height(
            std::clamp(letters_.share * word.size.y, letters_.least, std::max(letters_.least, letters_.usual)));
        const float room = size_.x - 2 * side_of(height);
        if (const float wide = width(word.text, height); wide > room) height = rounded_height(height * room / wide);
        const float wide = width(word.text, height), side = side_of(height);
        const float left = std::clamp(word.place.x - word.anchor * wide, side, std::max(side, size_.x - wide - side));
        const float top = std::clamp(word.place.y + (word.size.y - height) / 2, 0.0f, std::max(0.0f, size_.y - height));
        add_line(word.text, {left, top}, height, i);
    }

    /// The numbers of a scale stand beside it, and it is shorter where they need the room.
    void place_scale(size_t i) {
        const PictureWord& word = words_[i];
        const float strip = size_.y - word.place.y;
        foot_ = std::min(foot_, word.place.y - 0.1f * word.size.y);
        const float height =
            rounded_height(std::min({strip, letters_.usual, std::max(letters_.least, word.size.y / 0.8f)}));
        const float gap = 0.6f * height, side = side_of(height);
        const float low = width(word.text, height), high = width(word.end, height);
        const float length = std::min(word.size.x, size_.x - low - high - 2 * (gap + side));
        if (length < height) {
            result_.left_out.push_back(word.text + " to " + word.end);
            return;
        }
        // In the middle, unless one of the numbers would leave the picture.
        const float left = std::clamp((size_.x - length) / 2, low + gap + side,
                                      std::max(low + gap + side, size_.x - high - gap - side - length));
        const float top = word.place.y + (word.size.y - height) / 2;
        add(PlacedWord::Kind::heat, {left, word.place.y}, {length, word.size.y}, glm::vec4(1), i);
        add_line(word.text, {left - gap - low, std::min(top, size_.y - height)}, height, i, false);
        add_line(word.end, {left + length + gap, std::min(top, size_.y - height)}, height, i, false);
        for (int tick = 1; tick < word.parts; ++tick)
            add(PlacedWord::Kind::box, {std::round(left + length * float(tick) / float(word.parts)), word.place.y},
                {1, word.size.y}, {1, 1, 1, 0.8f}, i);
    }

    /// Notes take at most half of the picture. If there are more, the last line counts them.
    void place_notes() {
        std::vector<size_t> notes;
        for (size_t i = 0; i < words_.size(); ++i)
            if (words_[i].kind == Kind::note) notes.push_back(i);
        if (notes.empty()) return;
        const float height = rounded_height(std::max(letters_.least, 0.62f * letters_.usual)), step = step_of(height);
        const float room = size_.x - 2 * height;
        const auto most = size_t(std::max(1.0f, (0.5f * size_.y - 0.5f * step) / step));
        std::vector<Line> lines;
        for (size_t i = 0; i < notes.size(); ++i) {
            const auto fits = [&](const std::string& line) { return width("  " + line, height) <= room; };
            std::vector<std::string> more = broken_into_lines(with_short_words(words_[notes[i]].text, fits), fits);
            for (size_t k = 1; k < more.size(); ++k) more[k] = "  " + more[k];
            const bool is_last = i + 1 == notes.size();
            if (lines.size() + more.size() + (is_last ? 0 : 1) > most && !lines.empty()) {
                lines.push_back({fmt::format("and {} more", notes.size() - i), notes[i], height});
                break;
            }
            if (more.size() > most) {
                more.resize(most);
                while (!fits(more.back() + " ...") && more.back().size() > 1) more.back().pop_back();
                more.back() += " ...";
            }
            for (std::string& line : more) lines.push_back({std::move(line), notes[i], height});
        }
        const float lower_edge = foot_;
        foot_ -= step * float(lines.size()) + 0.5f * step;
        float widest = 0;
        for (const Line& line : lines) widest = std::max(widest, width(line.text, height));
        add(PlacedWord::Kind::ground, {0, foot_}, {std::min(size_.x, widest + 2 * height), lower_edge - foot_}, plate,
            notes.front());
        float top = foot_ + 0.4f * step;
        for (const Line& line : lines) add_line(line.text, {height, top}, height, line.of, false), top += step;
    }

    std::vector<TileWords> tiles_of_words() const {
        std::vector<TileWords> tiles;
        for (size_t i = 0; i < words_.size(); ++i) {
            const PictureWord& word = words_[i];
            const bool is_caption = word.kind == Kind::caption, is_legend = word.kind == Kind::legend;
            if ((!is_caption && !is_legend) || word.text.empty()) continue;
            auto tile = std::find_if(tiles.begin(), tiles.end(), [&](const TileWords& other) {
                return other.place == word.place && other.size == word.size;
            });
            if (tile == tiles.end()) tile = tiles.insert(tile, {word.place, word.size, word.foot});
            (is_caption ? tile->captions : tile->legend).push_back(i);
        }
        // From the top: 0, 1, ..., -2, -1.
        const auto is_above = [&](size_t a, size_t b) { return unsigned(words_[a].line) < unsigned(words_[b].line); };
        for (TileWords& tile : tiles) {
            std::stable_sort(tile.captions.begin(), tile.captions.end(), is_above);
            std::stable_sort(tile.legend.begin(), tile.legend.end(), is_above);
        }
        return tiles;
    }

    static float room_of(const PictureWord& caption, float height) { return caption.size.x - 2 * side_of(height) - 2; }

    /// Titles have one height in the whole picture, and so have all other captions: the largest that the narrowest tile
    /// has room for, but no smaller than seven tenths. A longer text is broken into lines. A foot has room for its
    /// lines in the letters of labels.png; others shrink.
    void set_heights(const std::vector<TileWords>& tiles) {
        for (const TileWords& tile : tiles) {
            const float needed = foot_height(tile.size.y, int(tile.captions.size()), letters_);
            const float share = tile.foot > 0 ? std::min(1.0f, tile.foot / needed) : 1;
            for (const size_t i : tile.captions) {
                const bool is_title = words_[i].line == 0;
                const float high =
                    std::max(letters_.least, share * caption_height(tile.size.y, is_title, tile.foot > 0, letters_));
                const float wide = width(words_[i].text, high), room = room_of(words_[i], high);
                const float fitting = wide > room ? high * room / wide : high;
                float& height = height_[is_title ? 0 : 1];
                height = std::min(height, rounded_height(std::max({letters_.least, 0.7f * high, fitting})));
            }
        }
    }

    void place_tile(const TileWords& tile) {
        const float end = std::min(tile.place.y + tile.size.y, foot_);
        float bottom = place_legend(tile, end);
        // Lines of each caption, and those that have room.
        std::vector<std::vector<Line>> lines;
        std::vector<bool> has_room;
        for (const size_t i : tile.captions) {
            const float height = height_[words_[i].line == 0 ? 0 : 1], room = room_of(words_[i], height);
            const auto fits = [&](const std::string& line) { return width(line, height) <= room; };
            std::vector<Line> own;
            for (std::string& text : broken_into_lines(words_[i].text, fits))
                own.push_back({std::move(text), i, height});
            has_room.push_back(std::all_of(own.begin(), own.end(), [&](const Line& line) { return fits(line.text); }));
            lines.push_back(std::move(own));
        }
        float top = tile.place.y;
        if (tile.foot > 0) top = std::min(end, tile.place.y + tile.size.y - tile.foot), bottom = std::max(top, bottom);
        float left = bottom - top - 0.5f * letters_.least;
        for (const size_t k : by_importance(tile)) {
            float high = 0;
            for (const Line& line : lines[k]) high += step_of(line.height);
            if (high > left) has_room[k] = false;
            if (has_room[k])
                left -= high;
            else
                result_.left_out.push_back(words_[tile.captions[k]].text);
        }
        top += 0.2f * letters_.least, bottom -= 0.05f * letters_.least;
        const auto is_from_top = [&](const Line& line) { return tile.foot > 0 || words_[line.of].line >= 0; };
        for (size_t k = 0; k < lines.size(); ++k)
            for (const Line& line : lines[k])
                if (has_room[k] && is_from_top(line)) add_caption(tile, line, top), top += step_of(line.height);
        for (size_t k = lines.size(); k-- > 0;)
            for (auto line = lines[k].rbegin(); line != lines[k].rend(); ++line)
                if (has_room[k] && !is_from_top(*line))
                    bottom -= step_of(line->height), add_caption(tile, *line, bottom);
    }

    void add_caption(const TileWords& tile, const Line& line, float top) {
        add_line(line.text, {tile.place.x + (tile.size.x - width(line.text, line.height)) / 2, top}, line.height,
                 line.of, tile.foot == 0);
    }

    /// Returns the captions of a tile: the title, then the last line, then the others.
    std::vector<size_t> by_importance(const TileWords& tile) const {
        std::vector<size_t> order(tile.captions.size());
        for (size_t k = 0; k < order.size(); ++k) order[k] = k;
        const auto rank = [&](size_t k) {
            const int line = words_[tile.captions[k]].line;
            return line == 0 ? 0 : line == -1 ? 1 : 1 + std::abs(line);
        };
        const auto is_earlier = [&](size_t a, size_t b) { return rank(a) < rank(b); };
        std::stable_sort(order.begin(), order.end(), is_earlier);
        return order;
    }

    /// Places the legend in a strip that ends at `bottom`. Returns where the strip begins.
    float place_legend(const TileWords& tile, float bottom) {
        if (tile.legend.empty()) return bottom;
        const float height = rounded_height(std::max(letters_.least, 0.7f * letters_.usual)), step = step_of(height);
        const float edge = 0.5f * height, swatch = height, gap = 0.4f * height, end = tile.size.x - edge;
        struct Entry {
            size_t of;
            float x;
            int row;
        };
        std::vector<Entry> entries;
        float x = edge;
        int row = 0;
        for (const size_t i : tile.legend) {
            const float wide = swatch + gap + width(words_[i].text, height);
            if (edge + wide > end) {
                result_.left_out.push_back(words_[i].text);
                continue;
            }
            const bool begins_row = !entries.empty() && words_[i].line != words_[entries.back().of].line;
            if (x > edge && (begins_row || x + wide > end)) x = edge, ++row;
            entries.push_back({i, x, row});
            x += wide + 0.9f * height;
        }
        const float top = std::round(bottom - step * float(row + 1) - 0.5f * gap);
        if (top < tile.place.y + 0.5f * tile.size.y) {  // the tile is for its picture
            for (const Entry& entry : entries) result_.left_out.push_back(words_[entry.of].text);
            return bottom;
        }
        add(PlacedWord::Kind::ground, {tile.place.x, top}, {tile.size.x, bottom - top}, strip_color,
            tile.legend.front());
        for (const Entry& entry : entries) {
            const glm::vec2 place =
                glm::round(glm::vec2(tile.place.x + entry.x, top + 0.6f * gap + step * float(entry.row)));
            add(PlacedWord::Kind::box, place + glm::vec2(0, 0.1f * height), glm::vec2(0.8f * swatch),
                words_[entry.of].color, entry.of);
            result_.placed.push_back({PlacedWord::Kind::text,
                                      glm::round(place + glm::vec2(swatch + gap, 0)),
                                      {width(words_[entry.of].text, height), height},
                                      {0.93f, 0.92f, 0.89f, 1},
                                      words_[entry.of].text,
                                      entry.of});
        }
        return top;
    }

    const std::vector<PictureWord>& words_;
    const glm::vec2 size_;
    const Letters& letters_;
    float foot_;                                            ///< where the strips at the foot of the picture begin
    std::array<float, 2> height_ = {HUGE_VALF, HUGE_VALF};  ///< of titles, and of other captions
    WordLayout result_;
};

}  // namespace

float foot_height(float high, int lines, const Letters& letters) {
    const auto step = [&](bool is_title) { return step_of(caption_height(high, is_title, true, letters)); };
    return step(true) + float(lines - 1) * step(false) + 0.5f * letters.least;
}

std::vector<std::string> broken_into_lines(const std::string& text,
                                           const std::function<bool(const std::string& line)>& fits) {
    std::vector<std::string> lines;
    std::string line;
    for (size_t begin = 0; begin < text.size();) {
        size_t end = std::min(text.find(' ', begin), text.size());
        if (text.compare(end, 2, " %") == 0) end += 2;  // a number keeps its sign
        std::string word = text.substr(begin, end - begin);
        begin = end + 1;
        if (!line.empty() && fits(line + " " + word)) {
            line += " " + word;
            continue;
        }
        if (!line.empty()) lines.push_back(std::exchange(line, ""));
        line = std::move(word);
    }
    if (!line.empty() || lines.empty()) lines.push_back(line);
    return lines;
}

WordLayout lay_out(const std::vector<PictureWord>& words, glm::vec2 size, const Letters& letters) {
    return Layout(words, size, letters).result();
}

}  // namespace relief
