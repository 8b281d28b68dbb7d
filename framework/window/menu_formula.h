// Formulas of a handout, typeset with lines and glyphs. In the window module only.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "framework/base/formula.h"

namespace relief {

/// A formula, or a part of one, as what is drawn: pixels, from the left end of its baseline, y down.
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
    float width = 0, above = 0, below = 0;  ///< what it covers; `below` may be negative
    float overhang = 0;                     ///< how far its last letter leans over its end
    std::vector<Glyphs> glyphs = {};
    std::vector<Stroke> strokes = {};

    /// Puts another one on this one, its baseline's left end at `at`. The width stays.
    void add(const FormulaBox& other, ImVec2 at);
    void scale(float factor);
    void draw(ImDrawList& list, ImVec2 at, ImU32 color) const;
};

/// The formula in one line.
FormulaBox typeset(const Formula& formula);

/// The formula in lines no wider than `width`: it breaks before a relation or a sum's sign, behind a comma, or before a
/// product's sign, and what is still too wide is smaller. Lines behind the first are indented.
std::vector<FormulaBox> typeset(const Formula& formula, float width);

}  // namespace relief
