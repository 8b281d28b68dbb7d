#include "framework/course/window/menu_handout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/course/window/menu_formula_block.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_text.h"

namespace relief::window {
namespace {

/// Returns the first word of a text, without punctuation at its end.
std::string first_word(const std::string& text) {
    const size_t begin = text.find_first_not_of(' ');
    if (begin == std::string::npos) return {};
    const size_t end = text.find_first_of(" ,;:|)\n", begin);
    std::string word = text.substr(begin, end == std::string::npos ? end : end - begin);
    while (!word.empty() && word.back() == '.') word.pop_back();
    return word;
}

/// Returns whether a knob accepts this value: one of its choices, or a number if it takes numbers.
bool takes(const KnobText& knob, const std::string& value) {
    if (knob.is_number()) return parse_number(value).has_value();
    return std::find(knob.choices.begin(), knob.choices.end(), value) != knob.choices.end();
}

void draw_code(const std::string& text, float width) {
    const std::string lines = text.substr(0, text.find_last_not_of('\n') + 1);
    ImFont* const face = font(FontRole::code);
    const float margin = size_of(*face) * 0.6f;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    // Wrap long lines, so that all of the code is visible.
    const ImVec2 size = face->CalcTextSizeA(size_of(*face), FLT_MAX, width - 2 * margin, lines.c_str());
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + size.y + 2 * margin}, code_back, 4);
    ImGui::GetWindowDrawList()->AddText(face, size_of(*face), {at.x + margin, at.y + margin},
                                        ImGui::ColorConvertFloat4ToU32(code_color), lines.c_str(), nullptr,
                                        width - 2 * margin);
    ImGui::Dummy({width, size.y + 2 * margin});
}

/// Distributes `room` over columns of the `wanted` widths. If it is too small, columns of at most `whole` keep their
/// width if possible. The others start with their longest word, and each gets the same share of its missing width. If
/// not even the longest words fit, all columns shrink in proportion.
std::vector<float> column_widths(const std::vector<float>& wanted, const std::vector<float>& words, float whole,
                                 float room) {
    const auto sum = [](const std::vector<float>& all) { return std::accumulate(all.begin(), all.end(), 0.0f); };
    if (sum(wanted) <= room) return wanted;
    std::vector<float> widths = words;
    for (size_t column = 0; column < widths.size(); ++column)
        if (wanted[column] <= whole) widths[column] = wanted[column];
    if (sum(widths) > room) widths = words;
    if (sum(widths) > room) widths.assign(widths.size(), 0);
    const float share = (room - sum(widths)) / (sum(wanted) - sum(widths));
    for (size_t column = 0; column < widths.size(); ++column)
        widths[column] += share * (wanted[column] - widths[column]);
    return widths;
}

pages::Spans in_bold(pages::Spans spans) {
    for (pages::Span& span : spans) span.bold = true;
    return spans;
}

}  // namespace

void Handout::open(const LabEntry& lab) { open(std::filesystem::path("labs") / lab.folder / "README.md", ""); }

void Handout::open(const std::filesystem::path& document, const std::string& passage) {
    close();
    passage_ = passage, seeks_ = passage.empty() ? 0 : 2;
    open_ = to_top_ = true;
    try {
        sources_ = pages::load_sources();
    } catch (const Error&) {
        sources_.clear();  // then the list of sources names what is missing
    }
    file_ = course_root() / document;
    look();
}

void Handout::close() {
    open_ = false;
    text_.clear(), problem_.clear(), blocks_.clear(), formulas_.clear();
    pictures_.clear();
}

bool Handout::look() {
    if (!open_) return false;
    const std::string text_before = text_, problem_before = problem_;
    try {
        std::error_code ignored;
        if (!std::filesystem::exists(file_, ignored)) throw Error("There is no handout: no file " + shown(file_) + ".");
        text_ = pages::with_sources(read_file(file_, size_t{1} << 20), sources_, file_);
        problem_.clear();
    } catch (const Error& error) {
        text_.clear();
        problem_ = error.what();
    }
    if (text_ == text_before && problem_ == problem_before) return false;
    blocks_ = pages::parse_markdown(text_);
    formulas_.clear();
    for (const pages::Block& block : blocks_) try {
            if (block.language == "formula") formulas_[&block] = pages::formula_lines(block.text);
        } catch (const Error&) {
            // Show it as plain text.
        }
    pictures_.clear();
    return true;
}

pages::Spans Handout::with_links(pages::Spans spans) const {
    for (size_t i = 0; i < spans.size(); ++i) {
        pages::Span& span = spans[i];
        if (!span.code) continue;
        const size_t equals = span.text.find('=');
        const std::string name = first_word(span.text.substr(0, equals));
        const auto knob =
            std::find_if(knobs_.begin(), knobs_.end(), [&](const KnobText& one) { return one.name == name; });
        if (knob == knobs_.end() || (equals == std::string::npos && name != span.text)) continue;
        // `method=steep`, or in tables: `method` steep
        const std::string value = equals != std::string::npos ? first_word(span.text.substr(equals + 1))
                                  : i + 1 < spans.size() && !spans[i + 1].code ? first_word(spans[i + 1].text)
                                                                               : "";
        span.target = std::string(knob_link) + (takes(*knob, value) ? name + "=" + value : name);
    }
    return spans;
}

void Handout::set_spans(const pages::Spans& spans, float width, FontRole base, float indent) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    TextLayout layout({at.x + indent, at.y}, width - indent, base, true);
    layout.set(with_links(spans));
    if (!layout.clicked().empty()) clicked_ = layout.clicked();
    ImGui::Dummy({width, layout.height()});
}

void Handout::draw(const Box& box, float scale, const std::vector<KnobText>& knobs, MenuWish& wish) {
    // Not in the frame of the key press, whose draw lists still refer to the pictures.
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
    for (const pages::Block& block : blocks_) draw_block(block, width);
    ImGui::Dummy({0, 6});
    closing_ = ImGui::Button("Close (F1)");
    ImGui::End();
    if (clicked_.empty()) return;
    const size_t equals = clicked_.find('=');
    wish.knob = clicked_.substr(0, equals);
    if (equals != std::string::npos) wish.value = clicked_.substr(equals + 1);
}

void Handout::draw_block(const pages::Block& block, float width) {
    const float em = size_of(*font(FontRole::text));
    const float indent = std::min(float(block.level) * 2 * em, width / 2);
    const auto space = [](float height) { ImGui::Dummy({0, height}); };
    switch (block.kind) {
        case pages::BlockKind::heading:
            space(em * 0.4f);
            mark(block.spans, ImGui::GetCursorScreenPos(), width, 1.9f * em);
            set_spans(block.level > 2 ? in_bold(block.spans) : block.spans, width,
                      block.level > 2 ? FontRole::text : FontRole::title);
            break;
        case pages::BlockKind::paragraph:
            if (block.spans.size() == 1 && block.spans.front().image)
                draw_picture(block.spans.front(), width);
            else
                set_spans(block.spans, width, FontRole::text, indent);
            space(em * 0.2f);
            break;
        case pages::BlockKind::item: {
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
        case pages::BlockKind::quote: {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            set_spans(block.spans, width, FontRole::text, indent + em);
            ImGui::GetWindowDrawList()->AddLine({at.x + indent + 3, at.y},
                                                {at.x + indent + 3, ImGui::GetItemRectMax().y}, line_color, 3);
            break;
        }
        case pages::BlockKind::code:
            if (const auto formulas = formulas_.find(&block); formulas != formulas_.end()) {
                const FormulaBlock typeset(formulas->second, width - indent);
                const ImVec2 at = ImGui::GetCursorScreenPos();
                typeset.draw({at.x + indent, at.y});
                ImGui::Dummy({width, typeset.height()});
            } else if (block.language != "measured") {
                draw_code(block.text, width);
            } else if (ImGui::TreeNode(&block, "How it was measured")) {
                draw_code(block.text, width);
                ImGui::TreePop();
            }
            space(em * 0.2f);
            break;
        case pages::BlockKind::table:
            draw_table(block, width);
            space(em * 0.2f);
            break;
        case pages::BlockKind::rule:
            ImGui::Separator();
            break;
    }
}

void Handout::mark(const pages::Spans& passage, ImVec2 top, float width, float height) {
    if (passage_.empty() || pages::plain_text(passage) != passage_) return;
    if (seeks_ > 0) --seeks_, ImGui::SetScrollFromPosY(top.y - ImGui::GetWindowPos().y, 0.2f);
    ImGui::GetWindowDrawList()->AddRectFilled({top.x - 6, top.y - 2}, {top.x + width, top.y + height},
                                              IM_COL32(230, 138, 92, 70), 4);
}

void Handout::draw_table(const pages::Block& block, float width) {
    const float em = size_of(*font(FontRole::text));
    const size_t columns = block.rows.front().size();
    const auto cell = [&](size_t row, size_t column) {
        return with_links(row == 0 ? in_bold(block.rows[row][column]) : block.rows[row][column]);
    };
    std::vector<float> wanted(columns, 0), least(columns, 0);
    for (size_t row = 0; row < block.rows.size(); ++row)
        for (size_t column = 0; column < columns; ++column) {
            TextLayout layout({}, std::numeric_limits<float>::max(), FontRole::text, false);
            layout.set(cell(row, column));
            wanted[column] = std::max(wanted[column], layout.widest() + 1);
            least[column] = std::max(least[column], layout.widest_word() + 1);
        }
    const float words = std::accumulate(least.begin(), least.end(), 0.0f);
    const float padding = em * (words + 1.2f * em * float(columns) > width ? 0.3f : 0.6f);
    const std::vector<float> widths =
        column_widths(wanted, least, 6 * em, std::max(1.0f, width - padding * 2 * float(columns)));

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
        mark(block.rows[row].front(), {corner.x, y}, whole, height + padding);
        y += height + padding;
        list.AddLine({corner.x, y}, {corner.x + whole, y}, line_color, row == 0 ? 2 : 1);
    }
    ImGui::Dummy({width, y - corner.y});
}

// A picture that cannot be shown is replaced by its text and the reason. It is not tried again until the handout
// changes.
void Handout::draw_picture(const pages::Span& image, float width) {
    const auto [place, is_new] = pictures_.try_emplace(image.target);
    std::unique_ptr<HandoutPicture>& picture = place->second;
    try {
        if (is_new) picture = std::make_unique<HandoutPicture>((file_.parent_path() / image.target).lexically_normal());
        if (picture) picture->draw(width);
    } catch (const Error& error) {
        print_event(fmt::format("handout: {}: {}", image.target, error.what()));
        picture.reset();
        missing_[image.target] = error.what();
    }
    if (!picture) quiet_text(missing_[image.target]);
    set_spans({picture ? pages::Span{.text = image.text, .italic = true} : image}, width);
}

}  // namespace relief::window
