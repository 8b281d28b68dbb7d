#include "framework/library/kit/labels.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "framework/core/lab/shot.h"

namespace relief {
namespace {

// assets/labels.png: 16 by 6 letters from the space on, the last a degree sign.
constexpr int columns = 16, rows = 6, degree = columns * rows - 1;
constexpr float letter_aspect = 0.5f;
constexpr float least_letters = 12;  ///< height in pixels below which letters of labels.png run together

/// Returns a text in UTF-8 as cells of labels.png. Letters that it does not have are question marks.
std::vector<int> cells_of(std::string_view text) {
    std::vector<int> cells;
    for (size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (text.substr(i).starts_with("°"))
            cells.push_back(degree);
        else if ((byte & 0xc0) != 0x80)  // not inside of a letter
            cells.push_back((byte < 32 || byte > 126 ? int('?') : int(byte)) - 32);
    }
    return cells;
}

std::string with_degree_signs(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '~' ? std::string("°") : std::string(1, c);
    return result;
}

}  // namespace

Letters Labels::letters(glm::ivec2 size) {
    // As in a square picture of the same area, but a low one is not all letters.
    const glm::vec2 whole(size);
    const float side = std::min(0.75f * std::sqrt(whole.x * whole.y), 1.6f * std::min(whole.x, whole.y));
    return {.width = [](const std::string& text,
                        float height) { return float(cells_of(text).size()) * height * letter_aspect; },
            .usual = std::max(14.0f, 2 * std::round(0.03f * side)),
            .least = least_letters,
            .even = true};
}

void Labels::add(PictureWord word) {
    if (std::exchange(draw_, draws_begun()) != draws_begun()) words_.clear();
    word.text = with_degree_signs(word.text), word.end = with_degree_signs(word.end);
    words_.push_back(std::move(word));
}

void Labels::add_in_tile(glm::ivec2 size, const Tile& tile, PictureWord word) {
    word.place = {tile.corner.x, size.y - tile.corner.y - tile.size.y};
    word.size = tile.size + glm::ivec2(0, tile.foot), word.foot = float(tile.foot);
    add(std::move(word));
}

std::vector<Tile> Labels::with_feet(glm::ivec2 size, std::vector<Tile> tiles, int captions, int longest) {
    // The window's letters are wider (their mean width in heights, with the plate) and higher, where both are smallest.
    constexpr float widest_letter = 0.65f, highest_letter = 1.12f;

    for (Tile& tile : tiles) {
        const bool is_narrow = widest_letter * least_letters * float(longest) > float(tile.size.x);
        const int lines = captions * (is_narrow ? 2 : 1);
        const float foot = highest_letter * foot_height(float(tile.size.y), lines, letters(size));
        tile.foot = std::min(tile.size.y / 2, int(foot));
        tile.corner.y += tile.foot, tile.size.y -= tile.foot;
    }
    return tiles;
}

void Labels::rectangle(glm::vec2 place, glm::vec2 size, glm::vec4 color) {
    add({.kind = PictureWord::Kind::box, .place = place, .size = size, .color = color});
}

void Labels::cross(glm::vec2 middle, float reach) {
    for (const auto& [color, thick] :
         {std::pair(glm::vec4(0, 0, 0, 0.6f), 3.0f), std::pair(glm::vec4(1, 0.95f, 0.7f, 1), 1.0f)})
        for (const float begin : {-1.0f, 0.3f}) {
            rectangle(middle + glm::vec2(begin * reach, -thick / 2), {0.7f * reach, thick}, color);
            rectangle(middle + glm::vec2(-thick / 2, begin * reach), {thick, 0.7f * reach}, color);
        }
}

void Labels::text(const std::string& text, glm::vec2 place, float height, Align align, glm::vec3 color) {
    add({.place = place,
         .size = {0, height},
         .text = text,
         .color = glm::vec4(color, 1),
         .anchor = align == Align::left     ? 0.0f
                   : align == Align::centre ? 0.5f
                                            : 1.0f});
}

void Labels::caption(glm::ivec2 size, const Tile& tile, int line, const std::string& text, glm::vec3 color) {
    add_in_tile(size, tile,
                {.kind = PictureWord::Kind::caption, .text = text, .color = glm::vec4(color, 1), .line = line});
}

void Labels::legend(glm::ivec2 size, const Tile& tile, const std::string& text, glm::vec3 color, int row) {
    add_in_tile(size, tile,
                {.kind = PictureWord::Kind::legend, .text = text, .color = glm::vec4(color, 1), .line = row});
}

void Labels::notes(const std::vector<std::string>& notes) {
    for (const std::string& note : notes) add({.kind = PictureWord::Kind::note, .text = note});
}

void Labels::scale(glm::ivec2 size, const std::string& low, const std::string& high, int parts) {
    const float line = scale_line(size) * 0.7f, length = 0.4f * float(size.x);
    add({.kind = PictureWord::Kind::scale,
         .place = {(float(size.x) - length) / 2, float(size.y) - line * 1.1f},
         .size = {length, line * 0.8f},
         .text = low,
         .end = high + " and more",  // what is above has the last colour, too
         .parts = parts});
}

std::vector<Labels::Corner> Labels::corners_of(const WordLayout& layout) {
    std::vector<Corner> corners;
    const auto quad = [&](glm::vec2 place, glm::vec2 size, glm::vec2 low, glm::vec2 high, glm::vec4 color) {
        const glm::vec2 end = place + size;
        const Corner upper_left{place, {low.x, high.y}, color}, upper_right{{end.x, place.y}, high, color},
            lower_left{{place.x, end.y}, low, color}, lower_right{end, {high.x, low.y}, color};
        for (const Corner& corner : {upper_left, lower_left, upper_right, upper_right, lower_left, lower_right})
            corners.push_back(corner);
    };
    const glm::vec2 cell(1.0f / columns, 1.0f / rows);
    for (const PlacedWord& word : layout.placed) {
        if (word.kind == PlacedWord::Kind::heat) quad(word.place, word.size, {0, 2}, {1, 2}, glm::vec4(1));
        if (word.kind == PlacedWord::Kind::ground || word.kind == PlacedWord::Kind::box)
            quad(word.place, word.size, {0, -1}, {0, -1}, word.color);
        if (word.kind != PlacedWord::Kind::text) continue;
        const glm::vec2 letter(word.size.y * letter_aspect, word.size.y);
        glm::vec2 place = word.place;
        for (const int index : cells_of(word.text)) {
            const glm::vec2 low = cell * glm::vec2(index % columns, rows - 1 - index / columns);
            if (index != 0) quad(place, letter, low, low + cell, word.color);
            place.x += letter.x;
        }
    }
    return corners;
}

void Labels::draw(const Frame& frame) {
    std::vector<PictureWord> words = std::exchange(words_, {});
    if (frame.probe || std::exchange(draw_, draws_begun()) != draws_begun()) return;
    if (frame.words) {
        for (PictureWord& word : words) frame.words->push_back(scaled(std::move(word), 1.0f / glm::vec2(frame.size)));
        return;
    }
    const std::vector<Corner> corners = corners_of(lay_out(words, glm::vec2(frame.size), letters(frame.size)));
    if (corners.empty()) return;
    if (!uploaded_) {
        uploaded_.emplace();
        glBindVertexArray(uploaded_->layout);
        glBindBuffer(GL_ARRAY_BUFFER, uploaded_->corners);
        for (const GLuint location : {0u, 1u, 2u}) glEnableVertexAttribArray(location);
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Corner),
                              reinterpret_cast<void*>(offsetof(Corner, place)));
        glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Corner), reinterpret_cast<void*>(offsetof(Corner, uv)));
        glVertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, sizeof(Corner),
                              reinterpret_cast<void*>(offsetof(Corner, color)));
    }
    glBindBuffer(GL_ARRAY_BUFFER, uploaded_->corners);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(Corner)), corners.data(), GL_STREAM_DRAW);
    glViewport(0, 0, frame.size.x, frame.size.y);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    const Program& program = program_.with();
    glUseProgram(program);
    program.set("u_size", glm::vec2(frame.size));
    program.set("s_letters", 0, letters_);
    glBindVertexArray(uploaded_->layout);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
}

}  // namespace relief
