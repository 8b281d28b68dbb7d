#include "framework/staff/grade/variation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/sha256.h"
#include "framework/core/base/text.h"

namespace relief::grade {
namespace {

/// Returns a number in [0, 1) that depends only on `words`.
double drawn_from(const std::string& words) {
    return double(std::stoull(sha256(words).substr(0, 12), nullptr, 16)) / double(1ull << 48);
}

/// Returns an offset in [-largest, largest] whose magnitude is at least 0.3 `largest`: a view that hardly changes tests
/// nothing.
double offset(const std::string& words, double largest) {
    const double t = 2 * drawn_from(words) - 1;
    return largest * (t < 0 ? -0.3 + 0.7 * t : 0.3 + 0.7 * t);
}

/// In [vary] this name is a factor, not a knob.
constexpr const char* picture_size = "picture_size";

}  // namespace

Variation::Variation(const Manifest& manifest, const std::string& lab, const std::string& seed, int attempt) {
    const auto words = [&](const std::string& what) { return fmt::format("{}|{}|{}|{}", seed, lab, attempt, what); };
    yaw_ = offset(words("yaw"), 20);
    pitch_ = offset(words("pitch"), 8);
    distance_ = 1 + offset(words("distance"), 0.15);
    for (const VaryInfo& vary : manifest.vary) {
        const double t = drawn_from(words(vary.knob));
        if (vary.knob == picture_size) {
            size_ = vary.low + t * (vary.high - vary.low);
            continue;
        }
        // Rounds to two decimals, so that a person can type the value in the report.
        set_.emplace_back(vary.knob, vary.choices.empty() ? fmt::format("{:.2f}", vary.low + t * (vary.high - vary.low))
                                                          : vary.choices[size_t(t * double(vary.choices.size()))]);
    }
}

Shot Variation::vary(Shot shot) const {
    shot.camera.yaw += yaw_;
    shot.camera.pitch = std::clamp(shot.camera.pitch + pitch_, -89.0, 89.0);
    shot.camera.distance *= distance_;
    for (const int axis : {0, 1}) shot.size[axis] = std::max(1, int(std::lround(shot.size[axis] * size_)));
    for (const auto& varied : set_)
        if (std::none_of(shot.set.begin(), shot.set.end(), [&](const auto& own) { return own.first == varied.first; }))
            shot.set.push_back(varied);
    return shot;
}

std::string view_text(const Shot& shot) {
    std::string text =
        fmt::format("camera {},{},{}; size {}x{}", rounded(shot.camera.yaw, 4), rounded(shot.camera.pitch, 4),
                    rounded(shot.camera.distance, 4), shot.size.x, shot.size.y);
    for (const auto& [knob, value] : shot.set) text += fmt::format("; {} {}", knob, value);
    return text;
}

}  // namespace relief::grade
