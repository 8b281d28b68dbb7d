#include "clip.h"

namespace relief {

std::vector<ClipCorner> clipped(std::vector<ClipCorner> polygon, const glm::dvec2& grown) {
    for (int plane = 0; plane < 6; ++plane) {
        const int axis = plane / 2;
        const double scale = axis < 2 ? grown[axis] : 1;
        const auto inside = [&](const ClipCorner& corner) {
            return scale * corner.clip.w + (plane % 2 == 0 ? corner.clip[axis] : -corner.clip[axis]);
        };
        std::vector<ClipCorner> kept;
        for (size_t i = 0; i < polygon.size(); ++i) {
            const ClipCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double in_a = inside(a), in_b = inside(b);
            if (in_a >= 0) kept.push_back(a);
            if ((in_a >= 0) == (in_b >= 0)) continue;
            const double share = in_a / (in_a - in_b);
            kept.push_back({glm::mix(a.place, b.place, share), glm::mix(a.clip, b.clip, share)});
        }
        polygon = std::move(kept);
    }
    return polygon;
}

}  // namespace relief
