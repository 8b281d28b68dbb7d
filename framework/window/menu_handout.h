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
    /// Scrolls by lines, down or up, for the keyboard.
    void scroll(float lines) { scroll_ += lines; }
    /// Names of these knobs can be clicked: that shows the knob's slider, or sets the value that stands after the name.
    void draw(const Box& box, float scale, const std::vector<KnobText>& knobs, MenuWish& wish);

private:
    void draw_block(const Block& block, float width);
    void draw_table(const Block& block, float width);
    void draw_picture(const Span& image, float width);
    /// The spans with a link at each name of a knob.
    Spans with_links(Spans spans) const;
    /// Sets spans at the cursor and moves it below them.
    void set_spans(const Spans& spans, float width, FontRole base = FontRole::text, float indent = 0);

    bool open_ = false, closing_ = false, to_top_ = false;
    float scroll_ = 0;
    std::filesystem::path file_;
    std::string text_, problem_;
    std::vector<Block> blocks_;
    std::map<const Block*, std::vector<std::vector<FormulaCell>>> formulas_;  ///< of blocks that are formulas
    std::vector<KnobText> knobs_;
    std::string clicked_;  ///< "name" or "name=value", of the present frame
    std::map<std::string, std::unique_ptr<HandoutPicture>> pictures_;  ///< by target; nothing if it cannot be shown
};

}  // namespace relief
