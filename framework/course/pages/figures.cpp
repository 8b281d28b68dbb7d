#include "framework/course/pages/figures.h"

namespace relief::pages {

Fields figure(const Image& image, const std::string& src, const char* kind, const std::string& caption,
              const std::string& alt, Value scale) {
    return {{"kind", kind},       {"src", src}, {"width", image.width},     {"height", image.height},
            {"caption", caption}, {"alt", alt}, {"scale", std::move(scale)}};
}

Value error_scale(std::vector<std::string> marks) {
    if (!marks.empty()) marks.back() += " and more";
    return rows(marks);
}

}  // namespace relief::pages
