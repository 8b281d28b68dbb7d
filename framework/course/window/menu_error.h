// The error message, over the upper part of the picture. In the window module only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

class Stage;

/// The stage's error, if any, with the source lines around it.
class ErrorBox {
public:
    void draw(const Box& picture, float scale, const Stage& stage, MenuWish& wish);

private:
    void read(const Error& error);

    std::string shown_;  ///< the error whose source lines are loaded
    std::vector<std::string> lines_;
    std::string mark_;                 ///< stands below the line of the error
    std::string details_;              ///< the error's details without the line and its mark
    std::vector<std::string> folded_;  ///< a compiler's other messages
    int first_ = 0;                    ///< number of the first line, from 1
};

}  // namespace relief::window
