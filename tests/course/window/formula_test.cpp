// Formulas of handouts, typeset as in the window.
#include "framework/course/window/menu_formula.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <filesystem>
#include <map>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/course/pages/markdown.h"
#include "framework/course/window/menu_formula_block.h"
#include "framework/course/window/menu_imgui.h"
#include "framework/course/window/menu_style.h"

namespace relief::window {
namespace {

using Lines = std::vector<std::vector<pages::FormulaCell>>;

/// Dear ImGui with the window's fonts, in the middle of a frame.
class WindowFormula : public testing::Test {
protected:
    WindowFormula() {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = {4000, 4000};
        style_menu(1);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({4000, 4000});
        ImGui::Begin("page", nullptr, fixed_window);
    }
    ~WindowFormula() override {
        ImGui::End();
        ImGui::EndFrame();
        ImGui::DestroyContext();
    }

    /// Returns the blocks of formulas of each handout.
    static std::map<std::string, std::vector<Lines>> handouts() {
        std::map<std::string, std::vector<Lines>> all;
        for (const auto& lab : std::filesystem::directory_iterator(course_root() / "labs")) {
            if (!std::filesystem::exists(lab.path() / "lab.toml")) continue;
            std::vector<Lines>& blocks = all[lab.path().filename()];
            for (const pages::Block& block : pages::parse_markdown(read_file(lab.path() / "README.md")))
                if (block.language == "formula") blocks.push_back(pages::formula_lines(block.text));
            EXPECT_FALSE(blocks.empty()) << lab.path();
        }
        EXPECT_GE(all.size(), 18u);
        return all;
    }
    /// Returns the characters that a font lacks.
    static std::set<unsigned> missing(const std::string& text, ImFont& face) {
        std::set<unsigned> characters;
        for (const char* at = text.c_str(); *at != 0;) {
            unsigned character = 0;
            at += ImTextCharFromUtf8(&character, at, nullptr);
            if (character != '\n' && !has_glyph(face, ImWchar(character))) characters.insert(character);
        }
        return characters;
    }
    static std::set<unsigned> missing(const FormulaBox& box) {
        std::set<unsigned> characters;
        for (const FormulaBox::Glyphs& each : box.glyphs) characters.merge(missing(each.text, *each.face));
        return characters;
    }
    /// Returns the first glyphs with this text, or null.
    static const FormulaBox::Glyphs* find(const FormulaBox& box, const std::string& text) {
        for (const FormulaBox::Glyphs& each : box.glyphs)
            if (each.text == text) return &each;
        return nullptr;
    }
    static constexpr float dock = 444;  ///< width for a handout: the dock's 480 pixels minus its margins
};

/// Text in the window's fonts.
class WindowText : public WindowFormula {};

TEST_F(WindowText, BreaksAtBlanksOnlyAndFits) {
    const std::string text = "wrong: mean 0.296 degrees (at most 0.26),\n\n  largest 0.71 degrees";
    const float widest = ImGui::CalcTextSize("(at most").x;
    for (float width = widest; width < 500; width += 7) {
        const std::string lines = broken_at_blanks(text, width);
        ASSERT_EQ(lines.size(), text.size());
        for (size_t i = 0; i < text.size(); ++i)
            EXPECT_EQ(lines[i], text[i] == ' ' && lines[i] == '\n' ? '\n' : text[i]);
        // Dear ImGui finds nothing more to break.
        EXPECT_EQ(ImGui::CalcTextSize(lines.c_str(), nullptr, false, width).y, ImGui::CalcTextSize(lines.c_str()).y)
            << width << ": " << lines;
        EXPECT_LE(ImGui::CalcTextSize(lines.c_str()).x, width);
    }
}

TEST_F(WindowFormula, EverySymbolOfTheHandoutsHasAGlyph) {
    for (const auto& [handout, blocks] : handouts())
        for (const Lines& lines : blocks)
            for (const auto& line : lines)
                for (const pages::FormulaCell& cell : line)
                    EXPECT_EQ(missing(typeset(cell.formula)), std::set<unsigned>()) << handout;
}

TEST_F(WindowFormula, EveryCharacterOfTheHandoutsHasAGlyph) {
    for (const auto& [handout, blocks] : handouts()) {
        const std::string text = read_file(course_root() / "labs" / handout / "README.md");
        for (const FontRole role : {FontRole::text, FontRole::bold, FontRole::code})
            EXPECT_EQ(missing(text, *font(role)), std::set<unsigned>()) << handout;
    }
}

TEST_F(WindowFormula, EveryWritableSignHasAGlyph) {
    const FormulaBox all = typeset(
        pages::parse_formula("alpha beta gamma delta theta lambda mu pi sigma phi Sigma Delta Lambda <=> a <= b >= c "
                             "-> d × e · f + g - h = i "
                             "< j > k * m' n° sqrt(p) |q| [r, s; t] sum grad"));
    EXPECT_EQ(missing(all), std::set<unsigned>());
    EXPECT_EQ(missing(typeset({.parts = {{pages::Formula::Kind::name, "ℵ"}}})), std::set<unsigned>{0x2135})
        << "what is missing is found";
}

TEST_F(WindowFormula, EveryGlyphStaysInItsBlockAtAnyWidth) {
    for (const auto& [handout, blocks] : handouts())
        for (const Lines& lines : blocks)
            for (const float width : {90.0f, 150.0f, 260.0f, dock, 900.0f}) {
                ImDrawList& list = *ImGui::GetWindowDrawList();
                const int first = list.VtxBuffer.Size;
                const FormulaBlock block(lines, width);
                block.draw({100, 100});
                ASSERT_GT(list.VtxBuffer.Size, first);
                for (int i = first; i < list.VtxBuffer.Size; ++i) {
                    const ImVec2 at = list.VtxBuffer[i].pos;
                    ASSERT_TRUE(at.x >= 99 && at.x <= 101 + width && at.y >= 99 && at.y <= 101 + block.height())
                        << handout << " at a width of " << width << ": " << at.x - 100 << ", " << at.y - 100;
                }
            }
}

TEST_F(WindowFormula, NoFormulaOfTheHandoutsIsMadeSmallerInADockOfTheUsualWidth) {
    for (const auto& [handout, blocks] : handouts())
        for (const Lines& lines : blocks)
            for (const auto& line : lines)
                for (const pages::FormulaCell& cell : line)
                    for (const FormulaBox& box : typeset(cell.formula, dock - 90))
                        for (const FormulaBox::Glyphs& each : box.glyphs)
                            EXPECT_EQ(each.size, size_of(*each.face)) << handout << ": " << each.text;
}

TEST_F(WindowFormula, AFractionHasItsPartsAboveAndBelowItsLine) {
    const FormulaBox box = typeset(pages::parse_formula("a / b"));
    ASSERT_EQ(box.strokes.size(), 1u);
    const float line = box.strokes[0].points[0].y;
    EXPECT_LT(line, 0) << "as high as a minus";
    EXPECT_LT(find(box, "a")->at.y, line);
    EXPECT_GT(find(box, "b")->at.y, line + 5);
    EXPECT_EQ(box.strokes[0].points[1].y, line);
}

TEST_F(WindowFormula, ScriptsAreSmallerAndRaisedOrLowered) {
    const FormulaBox box = typeset(pages::parse_formula("w_i^2"));
    EXPECT_EQ(find(box, "w")->at.y, 0);
    EXPECT_GT(find(box, "i")->at.y, 0);
    EXPECT_LT(find(box, "2")->at.y, 0);
    EXPECT_LT(find(box, "i")->size, find(box, "w")->size);
    EXPECT_EQ(find(typeset(pages::parse_formula("n'")), "′")->at.y, 0) << "a prime is high by itself";
}

TEST_F(WindowFormula, OnlySingleLetterNamesAreItalic) {
    const FormulaBox box = typeset(pages::parse_formula("x · depth - 2 pi"));
    EXPECT_TRUE(find(box, "x")->slanted);
    EXPECT_TRUE(find(box, "π")->slanted);
    EXPECT_FALSE(find(box, "depth")->slanted);
    EXPECT_FALSE(find(box, "2")->slanted);
}

TEST_F(WindowFormula, BracketsGrowWithAFraction) {
    EXPECT_NE(find(typeset(pages::parse_formula("(a + b)")), "("), nullptr);
    const FormulaBox tall = typeset(pages::parse_formula("x (1 + a / b)"));
    EXPECT_EQ(find(tall, "("), nullptr) << "drawn in lines";
    EXPECT_EQ(tall.strokes.size(), 3u);
}

TEST_F(WindowFormula, AMatrixHasItsColumnsBelowEachOther) {
    const FormulaBox box = typeset(pages::parse_formula("(a, b; c, d)"));
    EXPECT_NEAR(find(box, "a")->at.x, find(box, "c")->at.x, 2);
    EXPECT_EQ(find(box, "a")->at.y, find(box, "b")->at.y);
    EXPECT_LT(find(box, "a")->at.y, find(box, "c")->at.y);
}

TEST_F(WindowFormula, ALineBreaksBeforeARelationRatherThanAProduct) {
    const pages::Formula formula = pages::parse_formula("first · second = third · fourth");
    const std::vector<FormulaBox> lines = typeset(formula, typeset(formula).width * 0.8f);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_NE(find(lines[0], "second"), nullptr);
    EXPECT_EQ(find(lines[0], "="), nullptr);
    EXPECT_NE(find(lines[1], "="), nullptr);
    EXPECT_EQ(typeset(formula, 1000).size(), 1u);
}

}  // namespace
}  // namespace relief::window
