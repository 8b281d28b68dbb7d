#include "framework/course/window/menu_formula_block.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_text.h"

namespace relief::window {

/// One cell in a row of the block: a line of a formula, or words.
struct FormulaBlock::Cell {
    float width, above, below;
    Item item;
    bool begins_row = false;  ///< for the second and later lines of a formula
};

std::vector<FormulaBlock::Cell> FormulaBlock::cells_of(const pages::FormulaCell& cell, float width) const {
    std::vector<Cell> cells;
    if (!cell.is_words) {
        for (FormulaBox& line : typeset(cell.formula, width))
            cells.push_back(
                {line.width, line.above, line.below, {.at = {}, .formula = std::move(line)}, !cells.empty()});
        return cells;
    }
    TextLayout words({}, width, FontRole::text, false);
    words.set({{.text = cell.words, .italic = true}});
    // Approximates the baseline of the font.
    const float above = (TextLayout::line_height(FontRole::text) + 0.7f * size_of(*font(FontRole::text))) / 2;
    cells.push_back({words.widest(), above, words.height() - above, {.at = {}, .words = cell.words, .width = width}});
    return cells;
}

float FormulaBlock::set_row(std::vector<Cell>& cells, float left, float top) {
    // Rows are at least as high as a line of text.
    const float line = TextLayout::line_height(FontRole::text);
    float above = line * 0.7f, below = line * 0.3f, x = left;
    for (const Cell& cell : cells) above = std::max(above, cell.above), below = std::max(below, cell.below);
    for (Cell& cell : cells) {
        cell.item.at = {x, top + above - (cell.item.words.empty() ? 0 : cell.above)};
        x += cell.width + 1.6f * size_of(*font(FontRole::formula));
        items_.push_back(std::move(cell.item));
    }
    cells.clear();
    return top + above + below;
}

FormulaBlock::FormulaBlock(std::span<const std::vector<pages::FormulaCell>> lines, float width) : width_(width) {
    const float em = size_of(*font(FontRole::formula)), margin = 0.7f * em, gap = 1.6f * em, between = 0.35f * em;
    const float room = std::max(1.0f, width - 2 * margin);
    // Words before a line's first formula are its label. Labels form a column if that leaves enough width for formulas.
    const auto label_of = [](const std::vector<pages::FormulaCell>& line) {
        return line.size() > 1 && line[0].is_words;
    };
    float labels = 0;
    for (const std::vector<pages::FormulaCell>& line : lines)
        if (label_of(line)) labels = std::max(labels, cells_of(line[0], room)[0].width);
    const bool has_column = labels > 0 && labels < room / 4;
    const float left = margin + (has_column ? labels + em : 0), right = margin + room;

    height_ = margin;
    for (const std::vector<pages::FormulaCell>& line : lines) {
        std::vector<Cell> row;
        float x = left;
        bool is_label = label_of(line);
        const float top = height_;
        const size_t first = items_.size();
        for (const pages::FormulaCell& each : line) {
            if (std::exchange(is_label, false)) {
                std::vector<Cell> label = cells_of(each, has_column ? labels + 1 : room);
                if (has_column)
                    items_.push_back(std::move(label[0].item));
                else
                    height_ = set_row(label, margin, height_);
                continue;
            }
            for (Cell& cell : cells_of(each, right - left)) {
                if (!row.empty() && (cell.begins_row || x + cell.width > right))
                    height_ = set_row(row, left, height_) + between, x = left;
                x += cell.width + gap;
                row.push_back(std::move(cell));
            }
        }
        const bool has_label = has_column && label_of(line);
        if (!row.empty()) height_ = set_row(row, left, height_);
        if (has_label) {
            // Align it with the baseline of the line's first formula or note.
            const Item& beside = items_[first + 1];
            const float above = (TextLayout::line_height(FontRole::text) + 0.7f * size_of(*font(FontRole::text))) / 2;
            items_[first].at = {margin, beside.words.empty() ? std::max(top, beside.at.y - above) : beside.at.y};
        }
        height_ += between;
    }
    height_ += margin - between;
}

void FormulaBlock::draw(ImVec2 corner) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + width_, corner.y + height_}, code_back, 4);
    for (const Item& item : items_) {
        const ImVec2 at{std::floor(corner.x + item.at.x), std::floor(corner.y + item.at.y)};
        if (item.words.empty()) {
            item.formula.draw(list, at, ImGui::ColorConvertFloat4ToU32(plain_color));
        } else {
            TextLayout words(at, item.width, FontRole::text, true);
            words.set({{.text = item.words, .italic = true}});
        }
    }
}

}  // namespace relief::window
