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
    void read(const Place& place);

    std::string shown_;  ///< the error whose source lines are loaded
    std::vector<std::string> lines_;
    int first_ = 0;  ///< number of the first line, from 1
};

}  // namespace relief::window
