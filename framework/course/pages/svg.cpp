#include "framework/course/pages/svg.h"

#include <regex>

#include "framework/core/base/error.h"
#include "framework/core/base/module.h"
#include "framework/core/base/text.h"
#include "framework/core/image/stored.h"
#include "framework/course/pages/librsvg.h"

namespace relief {

glm::ivec2 svg_size(const std::string& svg) {
    static const std::regex box("viewBox=\"0 0 ([0-9]+) ([0-9]+)\"");
    std::smatch found;
    const bool is_there = std::regex_search(svg, found, box);
    const glm::ivec2 size =
        is_there ? glm::ivec2(parse_int(found[1].str()).value_or(0), parse_int(found[2].str()).value_or(0))
                 : glm::ivec2(0);
    if (size.x < 1 || size.y < 1) throw Error("a drawing needs viewBox=\"0 0 WIDTH HEIGHT\"");
    return size;
}

bool is_moving_drawing(const std::string& svg) {
    return svg.substr(0, svg.find('>')).find(" data-moves=\"") != std::string::npos;
}

Image draw_svg(const std::string& svg, glm::ivec2 size) {
    static const Module module = open_own_module("relief-librsvg.so", "librsvg2-dev");
    check_image_size(size.x, size.y, 4);
    return module.function<DrawSvg>("relief_draw_svg")(svg, size);
}

}  // namespace relief
