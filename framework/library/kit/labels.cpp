#include "framework/library/kit/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "framework/core/lab/shot.h"

namespace relief {
namespace {

// assets/labels.png: 16 by 6 letters from the space on, the last a degree sign.
constexpr int columns = 16, rows = 6;
constexpr char degree = '~';

std::string with_degree_signs(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == degree ? std::string("°") : std::string(1, c);
    return result;
}

/// Breaks a text at blanks into lines of at most `longest` letters. All lines but the first are indented.
std::vector<std::string> broken_into_lines(const std::string& text, size_t longest) {
    constexpr std::string_view indent = "  ";
    std::vector<std::string> lines;
    std::string rest = text;
    while (rest.size() > longest) {
        size_t end = rest.rfind(' ', longest);
        const bool is_word = end == std::string::npos || end <= indent.size();  // which no line has room for
        if (is_word) end = longest;
        lines.push_back(rest.substr(0, end));
        rest = std::string(indent) + rest.substr(end + (is_word ? 0 : 1));
    }
    lines.push_back(rest);
    return lines;
}

}  // namespace

void Labels::quad(glm::vec2 place, glm::vec2 size, glm::vec2 low, glm::vec2 high, glm::vec4 color) {
    const glm::vec2 end = place + size;
    const Corner upper_left{place, {low.x, high.y}, color}, upper_right{{end.x, place.y}, high, color},
        lower_left{{place.x, end.y}, low, color}, lower_right{end, {high.x, low.y}, color};
    for (const Corner& corner : {upper_left, lower_left, upper_right, upper_right, lower_left, lower_right})
        corners_of_this_draw().push_back(corner);
}

void Labels::forget_earlier_draws() {
    if (std::exchange(draw_, draws_begun()) == draws_begun()) return;
    corners_.clear();
    words_.clear();
}

std::vector<Labels::Corner>& Labels::corners_of_this_draw() {
    forget_earlier_draws();
    return corners_;
}

bool Labels::leaves_out(PictureWord word) {
    if (has_words()) return false;
    forget_earlier_draws();
    word.text = with_degree_signs(word.text), word.end = with_degree_signs(word.end);
    words_.push_back(std::move(word));
    return true;
}

void Labels::notes(glm::ivec2 size, const std::vector<std::string>& notes) {
    if (notes.empty()) return;
    const float height = std::max(11.0f, line_height(size) * 0.62f), line = 1.3f * height;
    const auto longest = size_t(std::max(20.0f, (float(size.x) - 2 * height) / (height * letter_aspect)));
    const auto most = size_t(std::max(2.0f, 0.5f * float(size.y) / line));
    std::vector<std::string> lines;
    for (size_t i = 0; i < notes.size(); ++i) {
        const std::vector<std::string> more = broken_into_lines(notes[i], longest);
        const bool is_last = i + 1 == notes.size();
        if (lines.size() + more.size() + (is_last ? 0 : 1) > most && !lines.empty()) {
            lines.push_back(fmt::format("and {} more", notes.size() - i));
            break;
        }
        lines.insert(lines.end(), more.begin(), more.end());
    }
    float top = float(size.y) - line * float(lines.size() + 1);
    const auto is_shorter = [](const std::string& one, const std::string& other) { return one.size() < other.size(); };
    const float widest = width(*std::max_element(lines.begin(), lines.end(), is_shorter), height);
    if (has_words())  // words of a page have grounds of their own
        quad({0.5f * height, top - 0.15f * line}, {widest + height, line * float(lines.size()) + 0.2f * line}, {0, -1},
             {0, -1}, {0.05f, 0.055f, 0.065f, 0.75f});
    for (const std::string& text : lines) {
        this->text(text, {height, top}, height);
        top += line;
    }
}

void Labels::rectangle(glm::vec2 place, glm::vec2 size, glm::vec4 color) {
    if (leaves_out({.kind = PictureWord::Kind::box, .place = place, .size = size, .color = color})) return;
    quad(place, size, {0, -1}, {0, -1}, color);
}

void Labels::cross(glm::vec2 middle, float reach) {
    for (const auto& [color, thick] :
         {std::pair(glm::vec4(0, 0, 0, 0.6f), 3.0f), std::pair(glm::vec4(1, 0.95f, 0.7f, 1), 1.0f)})
        for (const float begin : {-1.0f, 0.3f}) {
            rectangle(middle + glm::vec2(begin * reach, -thick / 2), {0.7f * reach, thick}, color);
            rectangle(middle + glm::vec2(-thick / 2, begin * reach), {thick, 0.7f * reach}, color);
        }
}

void Labels::heat_scale(glm::vec2 place, glm::vec2 size) { quad(place, size, {0, 2}, {1, 2}, glm::vec4(1)); }

void Labels::text(const std::string& text, glm::vec2 place, float height, Align align, glm::vec3 color) {
    if (leaves_out({.place = place,
                    .size = {0, height},
                    .text = text,
                    .color = glm::vec4(color, 1),
                    .anchor = align == Align::left     ? 0.0f
                              : align == Align::centre ? 0.5f
                                                       : 1.0f}))
        return;
    const float letter = height * letter_aspect, whole = width(text, height);
    if (align != Align::left) place.x -= align == Align::centre ? whole / 2 : whole;
    place = glm::round(place);
    rectangle(place - glm::vec2(letter * 0.5f, 0), {whole + letter, height * 1.05f}, {0.05f, 0.055f, 0.065f, 0.72f});
    for (const char c : text) {
        const int index = c == degree ? columns * rows - 1 : std::clamp(int(c), 32, 126) - 32;
        const glm::vec2 cell(1.0f / columns, 1.0f / rows);
        const glm::vec2 low = cell * glm::vec2(index % columns, rows - 1 - index / columns);
        if (c != ' ') quad(place, {letter, height}, low, low + cell, glm::vec4(color, 1));
        place.x += letter;
    }
}

void Labels::caption(glm::ivec2 size, const Tile& tile, int line, const std::string& text, glm::vec3 color) {
    if (leaves_out({.kind = PictureWord::Kind::caption,
                    .place = {float(tile.corner.x), float(size.y - tile.corner.y - tile.size.y)},
                    .size = tile.size,
                    .text = text,
                    .color = glm::vec4(color, 1),
                    .line = line}))
        return;
    // Line spacing does not depend on the text. A long text is drawn smaller.
    const float first = std::min(line_height(size), 0.075f * float(tile.size.y)),
                high = first * (line == 0 ? 1.0f : 0.8f);
    const float height = std::min(high, 0.94f * float(tile.size.x) / ((float(text.size()) + 1) * letter_aspect));
    const float top = float(size.y - tile.corner.y - tile.size.y);
    const float y = line == 0  ? top + high * 0.3f
                    : line > 0 ? top + first * 1.4f + high * 1.05f * float(line - 1)
                               : top + float(tile.size.y) + high * (float(line) * 1.05f - 0.7f);
    this->text(text, {float(tile.corner.x) + float(tile.size.x) / 2, y}, height, Align::centre, color);
}

void Labels::log_scale(glm::ivec2 size, const std::string& low, const std::string& high, int ticks) {
    const float line = usual_line(size) * 0.7f, length = 0.4f * float(size.x);
    const glm::vec2 place((float(size.x) - length) / 2, float(size.y) - line * 1.1f);
    if (leaves_out({.kind = PictureWord::Kind::scale,
                    .place = place,
                    .size = {length, line * 0.8f},
                    .text = low,
                    .end = high,
                    .parts = ticks}))
        return;
    heat_scale(place, {length, line * 0.8f});
    text(low, place - glm::vec2(line * 0.6f, 0), line, Align::right);
    text(high, place + glm::vec2(length + line * 0.6f, 0), line);
    for (int tick = 1; tick < ticks; ++tick)
        rectangle(place + glm::vec2(length * float(tick) / float(ticks), 0), {1, line * 0.8f}, {1, 1, 1, 0.8f});
}

void Labels::draw(const Frame& frame) {
    forget_earlier_draws();
    const std::vector<Corner> corners = std::exchange(corners_, {});
    std::vector<PictureWord> words = std::exchange(words_, {});
    if (frame.probe) return;
    if (!has_words()) {
        for (PictureWord& word : words) word.place /= frame.size, word.size /= frame.size;
        leave_out(std::move(words));
    }
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
