// A handout's formulas, typeset with lines and glyphs. In the window module only.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "framework/course/pages/formula.h"

namespace relief::window {

/// A typeset formula, or a part of one. Units are pixels, the origin is the left end of its baseline, y is down.
struct FormulaBox {
    struct Glyphs {
        ImFont* face;
        float size;
        ImVec2 at;  ///< left end of the baseline
        bool slanted;
        std::string text;
    };
    struct Stroke {
        std::vector<ImVec2> points;
        float thickness;
    };
    float width = 0, above = 0, below = 0;  ///< extent; `below` may be negative
    float overhang = 0;                     ///< how far its last letter leans over its right edge
    std::vector<Glyphs> glyphs = {};
    std::vector<Stroke> strokes = {};

    /// Adds another box with its baseline's left end at `at`. Does not change the width.
    void add(const FormulaBox& other, ImVec2 at);
    void scale(float factor);
    void draw(ImDrawList& list, ImVec2 at, ImU32 color) const;
};

/// Typesets the formula in one line.
FormulaBox typeset(const pages::Formula& formula);

/// Typesets the formula in lines of at most `width` pixels. Breaks before a relation, before a sum's sign, after a
/// comma, or before a product's sign. A line that is still too wide is scaled down. Lines after the first are indented.
std::vector<FormulaBox> typeset(const pages::Formula& formula, float width);

}  // namespace relief::window
