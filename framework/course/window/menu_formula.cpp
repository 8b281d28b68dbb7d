#include "framework/course/window/menu_formula.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

using Kind = pages::Formula::Kind;

/// Slant of letters that stand for numbers, such as x. Sheared here, because Debian's small font package has no slanted
/// faces.
constexpr float slant = 0.2f;

/// Size of a part, after TeX: a fraction within a fraction is as small as a script.
struct Style {
    int depth = 0;
    float size() const { return size_of(*font(depth < 2 ? FontRole::formula : FontRole::script)); }
    Style in_fraction() const { return {depth + 1}; }
    Style in_script() const { return {2}; }
};

template <class Do>
void each_character(const std::string& text, Do does) {
    for (const char* at = text.c_str(); *at != 0;) {
        unsigned character = 0;
        at += std::max(1, ImTextCharFromUtf8(&character, at, nullptr));
        does(ImWchar(character));
    }
}

FormulaBox glyphs(const std::string& text, FontRole role, bool slanted = false) {
    ImFont* const face = font(role);
    const float baseline = std::round(ascent_of(*face));
    FormulaBox box;
    box.above = -size_of(*face), box.below = -size_of(*face);
    each_character(text, [&](ImWchar character) {
        const ImFontGlyph& glyph = glyph_of(*face, character);
        box.width += glyph.AdvanceX;
        if (!glyph.Visible) return;
        box.above = std::max(box.above, baseline - glyph.Y0), box.below = std::max(box.below, glyph.Y1 - baseline);
    });
    if (slanted) box.overhang = slant * std::max(0.0f, box.above);
    box.glyphs.push_back({face, size_of(*face), {0, 0}, slanted, text});
    return box;
}

FormulaBox glyphs(const std::string& text, Style style, bool slanted = false) {
    return glyphs(text, style.depth < 2 ? FontRole::formula : FontRole::script, slanted);
}

float thickness(float size) { return std::max(1.0f, size / 15); }

/// Height of fraction lines above the baseline: that of a minus sign.
float axis(Style style) {
    const FormulaBox minus = glyphs("−", style);
    return (minus.above - minus.below) / 2;
}

bool is_one_letter(const std::string& name) {
    int letters = 0;
    each_character(name, [&](ImWchar) { ++letters; });
    return letters == 1;
}

bool is_one_of(const std::string& text, std::initializer_list<std::string_view> all) {
    return std::find(all.begin(), all.end(), text) != all.end();
}
bool is_relation(const pages::Formula& part) {
    return part.kind == Kind::sign && is_one_of(part.text, {"=", "<", ">", "≤", "≥", "⇔", "→"});
}
bool is_addition(const pages::Formula& part) { return part.kind == Kind::sign && is_one_of(part.text, {"+", "−"}); }
bool is_product(const pages::Formula& part) { return part.kind == Kind::sign && is_one_of(part.text, {"×", "·"}); }
bool is_separator(const pages::Formula& part) {
    return part.kind == Kind::sign && is_one_of(part.text, {",", ";", ":"});
}

FormulaBox box_of(const pages::Formula& part, Style style);

/// One of the boxes of a row.
struct Link {
    FormulaBox box;
    float before;   ///< space to the previous box
    int may_break;  ///< rank of a line break before it: higher is better, 0 forbids it
};

/// Returns whether a bracket must be drawn with lines, because no glyph is as tall as its content.
bool is_tall(const FormulaBox& inside, float size) { return inside.above > 0.95f * size || inside.below > 0.4f * size; }

FormulaBox drawn_bracket(const std::string& form, const FormulaBox& inside, Style style) {
    const float size = style.size(), over = 0.08f * size;
    const float top = -inside.above - over, bottom = inside.below + over, middle = (top + bottom) / 2;
    const bool opens = form == "(" || form == "[";
    FormulaBox box;
    box.width = (form == "|" ? 0.3f : 0.4f) * size, box.above = -top, box.below = bottom;
    const float in = 0.1f * size, outer = opens ? in : box.width - in, inner = opens ? box.width - in : in;
    FormulaBox::Stroke stroke{.points = {}, .thickness = thickness(size)};
    if (form == "|") {
        stroke.points = {{box.width / 2, top}, {box.width / 2, bottom}};
    } else if (form == "[" || form == "]") {
        stroke.points = {{inner, top}, {outer, top}, {outer, bottom}, {inner, bottom}};
    } else {
        for (int i = 0; i <= 16; ++i) {  // part of an ellipse
            const float along = float(i) / 8 - 1;
            stroke.points.push_back({outer + (inner - outer) * (1 - std::sqrt(1 - 0.96f * along * along)) / 0.8f,
                                     middle + (bottom - middle) * along});
        }
    }
    box.strokes.push_back(std::move(stroke));
    return box;
}

/// Returns the opening or closing bracket around `inside`.
FormulaBox bracket(std::string_view form, const FormulaBox& inside, Style style) {
    if (is_tall(inside, style.size())) return drawn_bracket(std::string(form), inside, style);
    return glyphs(std::string(form), style);
}

/// Appends the boxes of a row. Brackets of glyph height are separate boxes, so that a line can break between them.
void add_links(const pages::Formula& row, Style style, bool is_inside, std::vector<Link>& links) {
    const float size = style.size();
    const pages::Formula* previous = nullptr;
    float after = 0;
    for (const pages::Formula& part : row.parts) {
        if (part.kind == Kind::gap) {
            after += 0.2f * size;
            continue;
        }
        const auto add = [&](FormulaBox box, float before = 0, int may_break = 0) {
            links.push_back({std::move(box), before, may_break});
        };
        const bool is_prefix = !previous || previous->kind == Kind::sign;
        const float open = style.depth < 2 ? 1 : 0.25f;  // scripts are set tighter
        const float gap = std::exchange(after, 0.0f);
        const size_t first = links.size();
        if (part.kind == Kind::row) {
            add_links(part, style, is_inside, links);
        } else if (part.kind == Kind::bracket && !is_tall(box_of(part.parts[0], style), size)) {
            add(glyphs(part.text, style));
            add_links(part.parts[0], style, true, links);
            add(glyphs(std::string(pages::closing_of(part.text)), style));
        } else if (is_relation(part)) {
            after = 0.28f * size * open;
            add(box_of(part, style), after, is_inside ? 0 : 4);
        } else if (is_addition(part) && !is_prefix) {
            after = 0.22f * size * open;
            add(box_of(part, style), after, is_inside ? 0 : 3);
        } else if (is_product(part) && !is_prefix) {
            after = 0.2f * size * open;
            add(box_of(part, style), after, is_inside ? 0 : 1);
        } else {
            add(box_of(part, style));
        }
        if (links.size() == first) continue;
        links[first].before += gap;
        if (previous && is_separator(*previous)) {
            links[first].before += 0.3f * size * open;
            links[first].may_break = std::max(links[first].may_break, 2);
        }
        previous = &part;
    }
}

FormulaBox joined(std::span<const Link> links) {
    FormulaBox row;
    row.above = row.below = links.empty() ? 0 : -1e6f;
    for (const Link& link : links) {
        if (&link != links.data()) row.width += link.before;
        // An upright box leaves room for the slanted letter before it.
        if (link.box.overhang == 0) row.width += 0.4f * row.overhang;
        row.add(link.box, {row.width, 0});
        row.width += link.box.width;
        row.overhang = link.box.overhang;
    }
    return row;
}

std::vector<Link> links_of(const pages::Formula& row, Style style) {
    std::vector<Link> links;
    add_links(row, style, false, links);
    return links;
}

FormulaBox fraction(const pages::Formula& part, Style style) {
    const float size = style.size(), line = thickness(size), apart = 0.22f * size;
    const FormulaBox above = box_of(part.parts[0], style.in_fraction()),
                     below = box_of(part.parts[1], style.in_fraction());
    FormulaBox box;
    const float margin = 0.12f * size, height = axis(style);
    const float inner = std::max(above.width, below.width) + 2 * margin;
    box.width = inner + 2 * margin;
    box.add(above, {(box.width - above.width) / 2, -height - line / 2 - apart - above.below});
    box.add(below, {(box.width - below.width) / 2, -height + line / 2 + apart + below.above});
    box.strokes.push_back({{{margin, -height}, {margin + inner, -height}}, line});
    return box;
}

FormulaBox root(const pages::Formula& part, Style style) {
    const float size = style.size(), line = thickness(size), hook = 0.62f * size;
    const FormulaBox inside = box_of(part.parts[0], style);
    const float top = -std::max(inside.above, 0.6f * size) - 0.18f * size, bottom = std::max(inside.below, 0.0f);
    FormulaBox box;
    box.add(inside, {hook, 0});
    box.width = hook + inside.width + inside.overhang + 0.1f * size;
    box.above = -top + line, box.below = bottom;
    const float knee = bottom + (top - bottom) * 0.45f;
    box.strokes.push_back({{{0.05f * size, knee + 0.06f * size},
                            {0.17f * size, knee},
                            {0.33f * size, bottom},
                            {hook - 0.06f * size, top},
                            {box.width, top}},
                           line});
    return box;
}

/// Primes and degree signs are raised already: they stand directly beside the base, and the rest of the script follows.
FormulaBox high_script(const pages::Formula& row, Style style, float up) {
    FormulaBox box;
    box.above = box.below = -1e6f;
    pages::Formula raised;
    for (const pages::Formula& part : row.parts) {
        if (part.kind == Kind::sign && is_one_of(part.text, {"′", "°"})) {
            const FormulaBox mark = glyphs(part.text, style);
            box.add(mark, {box.width, 0});
            box.width += mark.width;
        } else {
            raised.parts.push_back(part);
        }
    }
    if (raised.parts.empty()) return box;
    const FormulaBox script = box_of(raised, style.in_script());
    box.add(script, {box.width, -std::max(up, 0.3f * style.size() + script.below)});
    box.width += script.width;
    return box;
}

FormulaBox scripts(const pages::Formula& part, Style style) {
    const float size = style.size();
    FormulaBox box = box_of(part.parts[0], style);
    const float end = box.width, lean = box.overhang, over = box.above, under = box.below;
    box.overhang = 0;
    if (!part.parts[2].parts.empty()) {
        const FormulaBox high = high_script(part.parts[2], style, std::max(0.38f * size, over - 0.3f * size));
        const float at = end + lean * 0.8f + 0.04f * size;
        box.add(high, {at, 0});
        box.width = std::max(box.width, at + high.width);
    }
    if (!part.parts[1].parts.empty()) {
        const FormulaBox low = box_of(part.parts[1], style.in_script());
        box.add(low, {end + 0.04f * size, std::max({0.2f * size, under, low.above - 0.4f * size})});
        box.width = std::max(box.width, end + 0.04f * size + low.width);
    }
    return box;
}

FormulaBox bracketed(const pages::Formula& part, Style style) {
    const FormulaBox inside = box_of(part.parts[0], style);
    const FormulaBox left = bracket(part.text, inside, style),
                     right = bracket(pages::closing_of(part.text), inside, style);
    FormulaBox box;
    box.above = box.below = -1e6f;
    box.add(left, {0, 0});
    box.add(inside, {left.width, 0});
    const float end = left.width + inside.width + 0.4f * inside.overhang;
    box.add(right, {end, 0});
    box.width = end + right.width;
    return box;
}

FormulaBox matrix(const pages::Formula& part, Style style) {
    const float size = style.size(), apart = 0.8f * size, line = 1.35f * size;
    std::vector<float> widths;
    std::vector<std::vector<FormulaBox>> cells;
    for (const pages::Formula& row : part.parts) {
        cells.emplace_back();
        for (const pages::Formula& cell : row.parts) {
            cells.back().push_back(box_of(cell, style));
            const size_t column = cells.back().size() - 1;
            widths.resize(std::max(widths.size(), column + 1));
            widths[column] = std::max(widths[column], cells.back().back().width);
        }
    }
    FormulaBox box;
    box.above = box.below = -1e6f;
    const float first = -axis(style) - line * float(cells.size() - 1) / 2 + 0.3f * size;
    for (size_t row = 0; row < cells.size(); ++row) {
        float x = 0;
        for (size_t column = 0; column < cells[row].size(); ++column) {
            const FormulaBox& cell = cells[row][column];
            box.add(cell, {x + (widths[column] - cell.width) / 2, first + line * float(row)});
            x += widths[column] + apart;
        }
    }
    for (const float width : widths) box.width += width;
    box.width += apart * float(widths.size() - 1);
    return box;
}

FormulaBox box_of(const pages::Formula& part, Style style) {
    switch (part.kind) {
        case Kind::row:
            return joined(links_of(part, style));
        case Kind::name:
            return glyphs(part.text, style, is_one_letter(part.text));
        case Kind::sign: {
            if (part.text != "∑" || style.depth > 0) return glyphs(part.text, style);
            // Centre the sign on the height of a fraction line.
            const FormulaBox sum = glyphs(part.text, FontRole::sum);
            FormulaBox box;
            box.above = box.below = -1e6f, box.width = sum.width;
            box.add(sum, {0, (sum.above - sum.below) / 2 - axis(style)});
            return box;
        }
        case Kind::number:
        case Kind::words:
            return glyphs(part.text, style);
        case Kind::gap:
            return {.width = 0.2f * style.size()};
        case Kind::fraction:
            return fraction(part, style);
        case Kind::root:
            return root(part, style);
        case Kind::scripts:
            return scripts(part, style);
        case Kind::bracket:
            return bracketed(part, style);
        case Kind::matrix:
            return matrix(part, style);
    }
    return {};
}

/// Returns how many links fit in a line of a width. A break of higher rank wins if the line is at least half full
/// there.
size_t count_in_line(std::span<const Link> links, float width) {
    float x = 0;
    size_t best = links.size();
    int best_rank = 0;
    for (size_t i = 0; i < links.size(); ++i) {
        if (const int rank = links[i].may_break; i > 0 && rank > 0 && (rank >= best_rank || x < width / 2))
            best = i, best_rank = rank;
        x += (i > 0 ? links[i].before : 0) + links[i].box.width;
        if (x + links[i].box.overhang <= width || best_rank == 0) continue;
        return best;
    }
    return x <= width ? links.size() : best;
}

}  // namespace

void FormulaBox::add(const FormulaBox& other, ImVec2 at) {
    above = std::max(above, other.above - at.y), below = std::max(below, other.below + at.y);
    for (Glyphs each : other.glyphs) {
        each.at = {each.at.x + at.x, each.at.y + at.y};
        glyphs.push_back(std::move(each));
    }
    for (Stroke each : other.strokes) {
        for (ImVec2& point : each.points) point = {point.x + at.x, point.y + at.y};
        strokes.push_back(std::move(each));
    }
}

void FormulaBox::scale(float factor) {
    for (float* each : {&width, &above, &below, &overhang}) *each *= factor;
    for (Glyphs& each : glyphs) each.size *= factor, each.at = {each.at.x * factor, each.at.y * factor};
    for (Stroke& each : strokes)
        for (ImVec2& point : each.points) point = {point.x * factor, point.y * factor};
}

void FormulaBox::draw(ImDrawList& list, ImVec2 at, ImU32 color) const {
    for (const Glyphs& each : glyphs) {
        const float baseline = std::floor(at.y + each.at.y + 0.5f);
        const float ascent = std::round(ascent_of(*each.face)) * each.size / size_of(*each.face);
        const int first = list.VtxBuffer.Size;
        list.AddText(each.face, each.size, {at.x + each.at.x, baseline - ascent}, color, each.text.c_str());
        if (each.slanted)
            for (int i = first; i < list.VtxBuffer.Size; ++i)
                list.VtxBuffer[i].pos.x += slant * (baseline - list.VtxBuffer[i].pos.y);
    }
    for (const Stroke& each : strokes) {
        std::vector<ImVec2> points;
        for (const ImVec2& point : each.points) points.push_back({at.x + point.x, at.y + point.y});
        // Snap horizontal lines to pixels, to keep them sharp.
        if (points.size() == 2 && points[0].y == points[1].y)
            points[0].y = points[1].y = std::floor(points[0].y) + 0.5f * float(int(std::round(each.thickness)) % 2);
        list.AddPolyline(points.data(), int(points.size()), color, 0, each.thickness);
    }
}

FormulaBox typeset(const pages::Formula& formula) { return joined(links_of(formula, {})); }

std::vector<FormulaBox> typeset(const pages::Formula& formula, float width) {
    const std::vector<Link> all = links_of(formula, {});
    std::span<const Link> rest = all;
    const float indent = std::min(2 * size_of(*font(FontRole::formula)), width / 4);
    std::vector<FormulaBox> lines;
    while (!rest.empty()) {
        const float left = lines.empty() ? 0 : indent;
        const size_t count = count_in_line(rest, width - left);
        const FormulaBox line = joined(rest.first(count));
        FormulaBox& placed = lines.emplace_back(FormulaBox{.above = -1e6f, .below = -1e6f});
        placed.add(line, {left, 0});
        placed.width = left + line.width + line.overhang;
        if (placed.width > width) placed.scale(width / placed.width);
        rest = rest.subspan(count);
    }
    return lines;
}

}  // namespace relief::window
