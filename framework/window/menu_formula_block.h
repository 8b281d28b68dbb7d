// A handout's block of formulas, in the width that the window has for it. In the window module only.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "framework/base/formula.h"
#include "framework/window/menu_formula.h"

namespace relief {

/// The lines of a block ```formula: labels, formulas and notes beside each other as far as the width reaches.
class FormulaBlock {
public:
    FormulaBlock(std::span<const std::vector<FormulaCell>> lines, float width);
    float height() const { return height_; }
    void draw(ImVec2 corner) const;

private:
    struct Item {
        ImVec2 at;  ///< of a formula its baseline's left end, of words their upper left corner
        FormulaBox formula = {};
        std::string words = {};
        float width = 0;  ///< of words
    };
    struct Cell;
    std::vector<Cell> cells_of(const FormulaCell& cell, float width) const;
    /// Cells beside each other, their baselines on one line, from `top` on. Returns where they end.
    float set_row(std::vector<Cell>& cells, float left, float top);

    std::vector<Item> items_;
    float width_, height_ = 0;
};

}  // namespace relief
