#include "framework/window/menu_handout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "framework/base/error.h"
#include "framework/base/file.h"
#include "framework/base/paths.h"
#include "framework/base/text.h"
#include "framework/image/file.h"
#include "framework/window/menu_style.h"

namespace relief {
namespace {

const ImVec4 plain_color{0.88f, 0.88f, 0.86f, 1}, bold_color{1, 1, 0.98f, 1}, code_color{0.95f, 0.82f, 0.70f, 1},
    link_color{0.56f, 0.74f, 0.95f, 1};
constexpr ImU32 code_back = IM_COL32(46, 48, 56, 255), line_color = IM_COL32(84, 86, 94, 255);

/// What the target of a knob's name begins with.
constexpr std::string_view knob_link = "knob:";

/// How a span looks. Debian's DejaVu has no slanted faces in its small package: italics are quiet.
struct Look {
    ImFont* face;
    ImU32 color;
    bool boxed = false;
    std::string knob = {};  ///< what a click sets or shows: "method", "method=steep"
};
Look look_of(const Span& span, FontRole base) {
    const ImVec4 color = span.code              ? code_color
                         : !span.target.empty() ? (span.image ? quiet : link_color)
                         : span.italic          ? quiet
                         : span.bold            ? bold_color
                                                : plain_color;
    const FontRole role = span.code ? FontRole::code : span.bold && base == FontRole::text ? FontRole::bold : base;
    const bool is_knob = span.code && span.target.starts_with(knob_link);
    return {font(role), ImGui::ColorConvertFloat4ToU32(is_knob ? link_color : color), span.code,
            is_knob ? span.target.substr(knob_link.size()) : ""};
}

/// Sets words from left to right in lines of a width; what is wider than a line is cut.
class TextLayout {
public:
    TextLayout(ImVec2 corner, float width, FontRole base, bool visible)
        : corner_(corner), width_(width), base_(base), visible_(visible), line_(font(base)->FontSize * 1.35f) {}

    void set(const Spans& spans) {
        for (const Span& span : spans) {
            const Look look = look_of(span, base_);
            const std::string& text = span.image ? "[" + span.text + "]" : span.text;
            for (size_t begin = 0; begin <= text.size();) {
                const size_t end = std::min(text.find_first_of(" \n", begin), text.size());
                if (end > begin) word_.push_back({text.substr(begin, end - begin), look, begin > 0 && look.boxed});
                if (end < text.size()) {
                    flush();
                    if (text[end] == '\n')
                        x_ = 0, y_ += line_;
                    else if (x_ > 0)
                        x_ += gap(look);
                }
                begin = end + 1;
            }
        }
        flush();
    }
    float height() const { return y_ + line_; }
    float widest() const { return widest_; }
    /// The knob that was clicked, or empty.
    const std::string& clicked() const { return clicked_; }

private:
    struct Piece {
        std::string text;
        Look look;
        bool goes_on;  ///< in the box of the word before
    };
    static float gap(const Look& look) { return look.face->FontSize * (look.boxed ? 0.6f : 0.36f); }
    static float width_of(const Piece& piece) {
        const char* const text = piece.text.c_str();
        return piece.look.face->CalcTextSizeA(piece.look.face->FontSize, FLT_MAX, 0, text, text + piece.text.size()).x;
    }

    void flush() {
        float whole = 0;
        for (const Piece& piece : word_) whole += width_of(piece);
        if (x_ > 0 && x_ + whole > width_) x_ = 0, y_ += line_;
        for (Piece& piece : word_) {
            while (x_ + width_of(piece) > width_) {
                ImFont* const face = piece.look.face;
                const char* const text = piece.text.c_str();
                const char* rest = nullptr;
                face->CalcTextSizeA(face->FontSize, std::max(1.0f, width_ - x_), 0, text, text + piece.text.size(),
                                    &rest);
                size_t count = size_t(rest - text);
                while (count < piece.text.size() && (piece.text[count] & 0xc0) == 0x80) ++count;  // whole characters
                if (count >= piece.text.size() || (count == 0 && x_ == 0)) break;
                put({piece.text.substr(0, count), piece.look, piece.goes_on});
                piece.text.erase(0, count);
                x_ = 0, y_ += line_;
            }
            put(piece);
        }
        word_.clear();
    }

    void put(const Piece& piece) {
        const float width = width_of(piece), size = piece.look.face->FontSize;
        if (visible_) {
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const ImVec2 at{std::floor(corner_.x + x_), std::floor(corner_.y + y_ + (line_ - size) / 2)};
            if (piece.look.boxed && !piece.text.empty()) {
                const bool goes_on = piece.goes_on && x_ > 0;
                list.AddRectFilled({at.x - (goes_on ? gap(piece.look) : 2), at.y - 1},
                                   {at.x + width + 2, at.y + size + 1}, code_back, 3,
                                   goes_on ? ImDrawFlags_RoundCornersRight : ImDrawFlags_RoundCornersAll);
            }
            list.AddText(piece.look.face, size, at, piece.look.color, piece.text.c_str(),
                         piece.text.c_str() + piece.text.size());
            if (!piece.look.knob.empty() && ImGui::IsWindowHovered() &&
                ImGui::IsMouseHoveringRect({at.x - 2, at.y - 1}, {at.x + width + 2, at.y + size + 1})) {
                list.AddLine({at.x, at.y + size}, {at.x + width, at.y + size}, piece.look.color);
                ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
                if (ImGui::IsMouseReleased(0)) clicked_ = piece.look.knob;
            }
        }
        x_ += width;
        widest_ = std::max(widest_, x_);
    }

    ImVec2 corner_;
    float width_;
    FontRole base_;
    bool visible_;
    float line_, x_ = 0, y_ = 0, widest_ = 0;
    std::vector<Piece> word_;
    std::string clicked_;
};

/// The first word of a text, without what ends a clause.
std::string first_word(const std::string& text) {
    const size_t begin = text.find_first_not_of(' ');
    if (begin == std::string::npos) return {};
    const size_t end = text.find_first_of(" ,;:|)\n", begin);
    std::string word = text.substr(begin, end == std::string::npos ? end : end - begin);
    while (!word.empty() && word.back() == '.') word.pop_back();
    return word;
}

/// Whether a knob's text can be this value: one of its choices, or a number where it takes numbers.
bool takes(const KnobText& knob, const std::string& value) {
    if (value.empty()) return false;
    for (const std::string& choice : split(knob.range, ','))
        if (first_word(choice) == value && choice.find(" to ") == std::string::npos) return true;
    return knob.range.find(" to ") != std::string::npos && parse_number(value).has_value();
}

void draw_code(const std::string& text, float width) {
    const std::string lines = text.substr(0, text.find_last_not_of('\n') + 1);
    ImFont* const face = font(FontRole::code);
    const float margin = face->FontSize * 0.6f;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    // A line that is too long goes on below: nothing is out of sight.
    const ImVec2 size = face->CalcTextSizeA(face->FontSize, FLT_MAX, width - 2 * margin, lines.c_str());
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + size.y + 2 * margin}, code_back, 4);
    ImGui::GetWindowDrawList()->AddText(face, face->FontSize, {at.x + margin, at.y + margin},
                                        ImGui::ColorConvertFloat4ToU32(code_color), lines.c_str(), nullptr,
                                        width - 2 * margin);
    ImGui::Dummy({width, size.y + 2 * margin});
}

Spans in_bold(Spans spans) {
    for (Span& span : spans) span.bold = true;
    return spans;
}

}  // namespace

void Handout::open(const LabEntry& lab) {
    close();
    open_ = to_top_ = true;
    file_ = course_root() / "labs" / lab.folder / "README.md";
    look();
}

void Handout::close() {
    open_ = false;
    text_.clear(), problem_.clear(), blocks_.clear();
    pictures_.clear();
}

bool Handout::look() {
    if (!open_) return false;
    const std::string text_before = text_, problem_before = problem_;
    try {
        std::error_code ignored;
        if (!std::filesystem::exists(file_, ignored))
            throw Error("This lab has no handout: there is no " + shown(file_) + ".");
        text_ = read_file(file_, size_t{1} << 20);
        problem_.clear();
    } catch (const Error& error) {
        text_.clear();
        problem_ = error.what();
    }
    if (text_ == text_before && problem_ == problem_before) return false;
    blocks_ = parse_markdown(text_);
    pictures_.clear();
    return true;
}

Spans Handout::with_links(Spans spans) const {
    for (size_t i = 0; i < spans.size(); ++i) {
        Span& span = spans[i];
        if (!span.code) continue;
        const size_t equals = span.text.find('=');
        const std::string name = first_word(span.text.substr(0, equals));
        const auto knob =
            std::find_if(knobs_.begin(), knobs_.end(), [&](const KnobText& one) { return one.name == name; });
        if (knob == knobs_.end() || (equals == std::string::npos && name != span.text)) continue;
        // `method=steep`, or as tables have it: `method` steep
        const std::string value = equals != std::string::npos ? first_word(span.text.substr(equals + 1))
                                  : i + 1 < spans.size() && !spans[i + 1].code ? first_word(spans[i + 1].text)
                                                                               : "";
        span.target = std::string(knob_link) + (takes(*knob, value) ? name + "=" + value : name);
    }
    return spans;
}

void Handout::set_spans(const Spans& spans, float width, FontRole base, float indent) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    TextLayout layout({at.x + indent, at.y}, width - indent, base, true);
    layout.set(with_links(spans));
    if (!layout.clicked().empty()) clicked_ = layout.clicked();
    ImGui::Dummy({width, layout.height()});
}

void Handout::draw(const Box& box, float scale, const std::vector<KnobText>& knobs, MenuWish& wish) {
    // Not in the frame of the press, which still has the pictures in its lists.
    if (std::exchange(closing_, false)) close();
    if (!open_) return;
    knobs_ = knobs;
    clicked_.clear();
    begin_in(box, "handout", {18 * scale, 12 * scale}, true);
    if (std::exchange(to_top_, false)) ImGui::SetScrollY(0);
    if (const float lines = std::exchange(scroll_, 0.0f); lines != 0)
        ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + lines * 20 * scale, 0.0f, ImGui::GetScrollMaxY()));

    const float width = ImGui::GetContentRegionAvail().x;
    if (!problem_.empty()) set_spans({{.text = problem_}}, width);
    for (const Block& block : blocks_) draw_block(block, width);
    ImGui::Dummy({0, 6});
    closing_ = ImGui::Button("Close (F1)");
    ImGui::End();
    if (clicked_.empty()) return;
    const size_t equals = clicked_.find('=');
    wish.knob = clicked_.substr(0, equals);
    if (equals != std::string::npos) wish.value = clicked_.substr(equals + 1);
}

void Handout::draw_block(const Block& block, float width) {
    const float em = font(FontRole::text)->FontSize;
    const float indent = std::min(float(block.level) * 2 * em, width / 2);
    const auto space = [](float height) { ImGui::Dummy({0, height}); };
    switch (block.kind) {
        case BlockKind::heading:
            space(em * 0.4f);
            set_spans(block.level > 2 ? in_bold(block.spans) : block.spans, width,
                      block.level > 2 ? FontRole::text : FontRole::title);
            break;
        case BlockKind::paragraph:
            if (block.spans.size() == 1 && block.spans.front().image)
                draw_picture(block.spans.front(), width);
            else
                set_spans(block.spans, width, FontRole::text, indent);
            space(em * 0.2f);
            break;
        case BlockKind::item: {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const std::string marker = block.marker == "*" ? "\u2022" : block.marker;
            TextLayout size({}, width, FontRole::text, false);
            size.set({{.text = marker}});
            TextLayout number({at.x + indent + std::max(0.0f, 1.6f * em - size.widest()), at.y}, width, FontRole::text,
                              true);
            number.set({{.text = marker}});
            set_spans(block.spans, width, FontRole::text, indent + 2 * em);
            break;
        }
        case BlockKind::quote: {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            set_spans(block.spans, width, FontRole::text, indent + em);
            ImGui::GetWindowDrawList()->AddLine({at.x + indent + 3, at.y},
                                                {at.x + indent + 3, ImGui::GetItemRectMax().y}, line_color, 3);
            break;
        }
        case BlockKind::code:
            if (block.language != "measured") {
                draw_code(block.text, width);
            } else if (ImGui::TreeNode(&block, "How it was measured")) {
                draw_code(block.text, width);
                ImGui::TreePop();
            }
            space(em * 0.2f);
            break;
        case BlockKind::table:
            draw_table(block, width);
            space(em * 0.2f);
            break;
        case BlockKind::rule:
            ImGui::Separator();
            break;
    }
}

void Handout::draw_table(const Block& block, float width) {
    const float em = font(FontRole::text)->FontSize, padding = em * 0.6f;
    const size_t columns = block.rows.front().size();
    const auto cell = [&](size_t row, size_t column) {
        return with_links(row == 0 ? in_bold(block.rows[row][column]) : block.rows[row][column]);
    };
    // Each column as wide as it would like; when that is too much, those that want more than their share divide what
    // the modest ones leave.
    std::vector<float> widths(columns, 0);
    for (size_t row = 0; row < block.rows.size(); ++row)
        for (size_t column = 0; column < columns; ++column) {
            TextLayout layout({}, std::numeric_limits<float>::max(), FontRole::text, false);
            layout.set(cell(row, column));
            widths[column] = std::max(widths[column], layout.widest() + 1);
        }
    float left = std::max(1.0f, width - padding * 2 * float(columns));
    std::vector<float> sorted = widths;
    std::sort(sorted.begin(), sorted.end());
    float share = left;
    for (size_t i = 0; i < columns; ++i) {
        share = left / float(columns - i);
        if (sorted[i] > share) break;
        left -= sorted[i];
        share = std::numeric_limits<float>::max();
    }
    for (float& each : widths) each = std::min(each, share);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    float y = corner.y, whole = 0;
    for (const float each : widths) whole += each + 2 * padding;
    for (size_t row = 0; row < block.rows.size(); ++row) {
        float height = 0, x = corner.x;
        for (size_t column = 0; column < columns; ++column) {
            TextLayout layout({x + padding, y + padding / 2}, widths[column], FontRole::text, true);
            layout.set(cell(row, column));
            if (!layout.clicked().empty()) clicked_ = layout.clicked();
            height = std::max(height, layout.height());
            x += widths[column] + 2 * padding;
        }
        y += height + padding;
        list.AddLine({corner.x, y}, {corner.x + whole, y}, line_color, row == 0 ? 2 : 1);
    }
    ImGui::Dummy({width, y - corner.y});
}

// A picture that cannot be read is its text.
void Handout::draw_picture(const Span& image, float width) {
    const std::filesystem::path file = (file_.parent_path() / image.target).lexically_normal();
    auto found = pictures_.find(image.target);
    try {
        if (found == pictures_.end())
            found = pictures_
                        .emplace(image.target, Texture(image.target, [file] { return read_image(file); },
                                                       {.wrap = Wrap::clamp, .anisotropy = 1}))
                        .first;
        const GLuint name = found->second;
        GLint columns = 0, rows = 0;
        glBindTexture(GL_TEXTURE_2D, name);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &columns);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &rows);
        glBindTexture(GL_TEXTURE_2D, 0);
        const float share = std::min(1.0f, width / float(columns));
        ImGui::Image(reinterpret_cast<ImTextureID>(std::uintptr_t(name)), {float(columns) * share, float(rows) * share},
                     {0, 1}, {1, 0});  // row 0 of a texture is the bottom
    } catch (const Error&) {
        set_spans({image}, width);
    }
}

}  // namespace relief
