// A lab's handout, its README.md, or another document of the course, beside the picture. In the window module only.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/core/lab/knobs.h"
#include "framework/core/lab/registry.h"
#include "framework/course/pages/formula.h"
#include "framework/course/pages/markdown.h"
#include "framework/course/pages/sources.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_picture.h"
#include "framework/course/window/menu_style.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

class Handout {
public:
    bool is_open() const { return open_; }
    void open(const LabEntry& lab);
    /// Opens a document below the course's root at a heading, or at the row of a table that begins with a word, and
    /// marks it.
    void open(const std::filesystem::path& document, const std::string& passage);
    void close();

    /// Reads the file again and returns whether it changed. Call it a few times a second.
    bool look();
    /// Scrolls by lines, positive downwards, for the keyboard.
    void scroll(float lines) { scroll_ += lines; }
    /// Draws the handout. The names of `knobs` are links: a click shows the knob's slider, or sets the value after the
    /// name.
    void draw(const Box& box, float scale, const std::vector<KnobText>& knobs, MenuWish& wish);

private:
    void draw_block(const pages::Block& block, float width);
    /// Scrolls to a passage that was asked for, and draws a band over its `height` below `top`.
    void mark(const pages::Spans& passage, ImVec2 top, float width, float height);
    void draw_table(const pages::Block& block, float width);
    void draw_picture(const pages::Span& image, float width);
    /// Returns the spans with each knob name made a link.
    pages::Spans with_links(pages::Spans spans) const;
    /// Draws spans at the cursor and moves it below them.
    void set_spans(const pages::Spans& spans, float width, FontRole base = FontRole::text, float indent = 0);

    bool open_ = false, closing_ = false, to_top_ = false;
    float scroll_ = 0;
    std::filesystem::path file_;
    std::string text_, problem_;
    std::string passage_;  ///< to mark; empty for none
    int seeks_ = 0;        ///< frames that scroll to it: the first one does not know the document's height
    std::vector<pages::Source> sources_;
    std::vector<pages::Block> blocks_;
    std::map<const pages::Block*, std::vector<std::vector<pages::FormulaCell>>> formulas_;  ///< of formula blocks
    std::vector<KnobText> knobs_;
    std::string clicked_;                                              ///< "name" or "name=value", in this frame
    std::map<std::string, std::unique_ptr<HandoutPicture>> pictures_;  ///< by target; null if it cannot be shown
    std::map<std::string, std::string> missing_;                       ///< why a picture cannot be shown, by target
};

}  // namespace relief::window
