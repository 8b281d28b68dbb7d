// A lab's handout, its README.md, beside the picture. In the window module only.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/base/formula.h"
#include "framework/base/markdown.h"
#include "framework/lab/knobs.h"
#include "framework/lab/registry.h"
#include "framework/window/menu_layout.h"
#include "framework/window/menu_picture.h"
#include "framework/window/menu_style.h"
#include "framework/window/menu_wish.h"

namespace relief {

class Handout {
public:
    bool is_open() const { return open_; }
    void open(const LabEntry& lab);
    void close();

    /// Reads the file again and returns whether it changed. Call it a few times a second.
    bool look();
    /// Scrolls by lines, positive downwards, for the keyboard.
    void scroll(float lines) { scroll_ += lines; }
    /// Draws the handout. The names of `knobs` are links: a click shows the knob's slider, or sets the value after the
    /// name.
    void draw(const Box& box, float scale, const std::vector<KnobText>& knobs, MenuWish& wish);

private:
    void draw_block(const Block& block, float width);
    void draw_table(const Block& block, float width);
    void draw_picture(const Span& image, float width);
    /// Returns the spans with each knob name made a link.
    Spans with_links(Spans spans) const;
    /// Draws spans at the cursor and moves it below them.
    void set_spans(const Spans& spans, float width, FontRole base = FontRole::text, float indent = 0);

    bool open_ = false, closing_ = false, to_top_ = false;
    float scroll_ = 0;
    std::filesystem::path file_;
    std::string text_, problem_;
    std::vector<Block> blocks_;
    std::map<const Block*, std::vector<std::vector<FormulaCell>>> formulas_;  ///< of formula blocks
    std::vector<KnobText> knobs_;
    std::string clicked_;                                              ///< "name" or "name=value", in this frame
    std::map<std::string, std::unique_ptr<HandoutPicture>> pictures_;  ///< by target; null if it cannot be shown
};

}  // namespace relief
