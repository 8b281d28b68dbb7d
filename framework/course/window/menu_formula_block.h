// A handout's block of formulas, fitted to the window's width. In the window module only.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "framework/course/pages/formula.h"
#include "framework/course/window/menu_formula.h"

namespace relief::window {

/// The lines of a block ```formula: labels, formulas and notes side by side as far as the width allows.
class FormulaBlock {
public:
    FormulaBlock(std::span<const std::vector<pages::FormulaCell>> lines, float width);
    float height() const { return height_; }
    void draw(ImVec2 corner) const;

private:
    struct Item {
        ImVec2 at;  ///< baseline's left end for formulas, upper left corner for words
        FormulaBox formula = {};
        std::string words = {};
        float width = 0;  ///< for words
    };
    struct Cell;
    std::vector<Cell> cells_of(const pages::FormulaCell& cell, float width) const;
    /// Sets cells side by side on a common baseline, starting at `left` and `top`. Returns the y coordinate of their
    /// lower end.
    float set_row(std::vector<Cell>& cells, float left, float top);

    std::vector<Item> items_;
    float width_, height_ = 0;
};

}  // namespace relief::window
