// One check in place of the picture: the student's picture and the expected one with a wipe between them, and their
// difference. In the window module only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "framework/core/gl/texture.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

class Checks;

class CheckView {
public:
    bool is_open() const { return !name_.empty(); }
    const std::string& name() const { return name_; }
    /// Shows a check, whose settings the stage has after this many edits.
    void open(const std::string& check, int64_t edits) { name_ = check, edits_ = edits, version_ = -1, border_ = 0.5f; }
    /// Closes it after a later edit: a change of a knob is meant for the picture.
    void close_after_edits(int64_t edits) {
        if (is_open() && edits != edits_) close();
    }
    void close();

    void draw(const Box& box, float scale, const Checks& checks, MenuWish& wish);

private:
    void make(const Checks& checks, size_t check);

    std::string name_;
    int64_t edits_ = 0;
    int version_ = -1;  ///< version of the checks whose pictures are shown
    glm::ivec2 size_{0, 0};
    std::optional<Texture> drawn_, expected_, difference_;
    std::string differs_, largest_;
    float border_ = 0.5f;  ///< the student's picture is left of it; a fraction of the width
};

}  // namespace relief::window
