// The view `one-pixel` of lab 16: the sum of the light at one place, in numbers.
#pragma once

#include <fmt/format.h>

#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/labels.h"
#include "truth.h"

namespace relief::court {

class OnePixel {
public:
    glm::vec2 place{0.7f, 0.93f};  ///< from the upper left corner, in shares of the picture's size

    /// Returns the pixel's column and row.
    glm::ivec2 in(const Frame& frame) const {
        return glm::clamp(glm::ivec2(place * glm::vec2(frame.size)), glm::ivec2(0), frame.size - 1);
    }

    /// Returns the terms that draw_surfaces() writes at the pixel, or default ones if there is no surface.
    template <class DrawSurfaces>
    Terms draw(const Frame& frame, DrawSurfaces draw_surfaces) const {
        const std::array<glm::vec4, 4> values = draw_pixel(frame.size, in(frame), draw_surfaces);
        return {.ambient = values[0],
                .lamps = values[1],
                .mirror = values[2],
                .light = values[3],
                .occlusion = values[0].w,
                .shadow = values[1].w,
                .share = values[2].w};
    }

    /// Adds the table of the terms and a cross at the pixel.
    void describe(const Frame& frame, const Terms& drawn, const std::optional<Terms>& exact, Labels& labels) const {
        constexpr float longest = 41;  // letters of a line, with a margin
        const float line = std::min(Labels::line_height(frame.size), 2 * float(frame.size.x) / longest);
        labels.cross(glm::vec2(in(frame)) + 0.5f, line);
        static constexpr std::array names = {"light of the sky", "  x occlusion", "+ lamps", "  (shadow",
                                             "+ mirrored sky",   "  (share",      "= light"};
        std::vector<std::string> lines = {
            fmt::format("{:20} {:>8}{}", "", "shader", exact ? fmt::format(" {:>8}", "double") : "")};
        for (size_t i = 0; i < names.size(); ++i)
            lines.push_back(fmt::format("{:20} {:8.4f}{}{}", names[i], numbers(drawn)[i],
                                        exact ? fmt::format(" {:8.4f}", numbers(*exact)[i]) : "",
                                        std::string_view(names[i]).starts_with("  (") ? ")" : ""));
        const float top = float(frame.size.y) - (float(lines.size()) + 0.6f) * line;
        for (size_t i = 0; i < lines.size(); ++i) labels.text(lines[i], {0.5f * line, top + float(i) * line}, line);
    }

private:
    static std::array<double, 7> numbers(const Terms& terms) {
        const auto grey = [](const glm::dvec3& light) { return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)); };
        return {grey(terms.ambient), terms.occlusion, grey(terms.lamps), terms.shadow,
                grey(terms.mirror),  terms.share,     grey(terms.light)};
    }
};

}  // namespace relief::court
