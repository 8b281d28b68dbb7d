// A lab's handout, its README.md, over the picture. In the window module only.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/base/markdown.h"
#include "framework/gl/texture.h"
#include "framework/lab/registry.h"

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
    /// Draws it from pixel `left` to the right edge. Its button closes it.
    void draw(int left, float scale);

private:
    void draw_block(const Block& block, float width);
    void draw_table(const Block& block, float width) const;
    void draw_picture(const Span& image, float width);

    bool open_ = false, closing_ = false, to_top_ = false;
    float scroll_ = 0;
    std::filesystem::path file_;
    std::string text_, problem_;
    std::vector<Block> blocks_;
    std::map<std::string, Texture> pictures_;  ///< by target
};

}  // namespace relief
