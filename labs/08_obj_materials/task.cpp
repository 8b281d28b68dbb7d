// Lab 08, your first tasks: the kind of a bump map, and the order of surfaces. The others are in
// shaders/08_obj_materials/task.glsl.
#include "task.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "framework/core/base/unfinished.h"

namespace relief::materials {

// TASK 8.1 (3 points): what does a picture hold that an MTL file names as map_bump? The format says heights; many files
// name a normal map. Nothing but the texels tells: ask in this order. (color_of() gives the first three channels of
// each of the image.pixel_count() texels, where image.channels is 3 or 4.)
//  - Heights: one channel; or, in 99 of 100 texels, no two channels differ by more than 2/255.
//  - Normals: in 99 of 100 texels, 2 c - 1 of the colour c has a length within 0.1 of 1, and z > 0.
//  - Else neither: the lab then leaves the map out. So it does with two channels.
//(kind
MapKind kind_of(const Image& image) {
    //[solution
    if (image.channels == 1) return MapKind::heights;
    if (image.channels < 3) return MapKind::neither;
    size_t grey = 0, upright = 0;
    for (size_t texel = 0; texel < image.pixel_count(); ++texel) {
        const glm::vec3 color = color_of(image, texel), normal = 2.0f * color - 1.0f;
        grey += std::max({color.r, color.g, color.b}) - std::min({color.r, color.g, color.b}) <= 2.001f / 255;
        upright += std::abs(glm::length(normal) - 1) <= 0.1f && normal.z > 0;
    }
    const auto nearly_all = [&](size_t count) { return 100 * count >= 99 * image.pixel_count(); };
    return nearly_all(grey) ? MapKind::heights : nearly_all(upright) ? MapKind::normals : MapKind::neither;
    //]starter
    //| static_cast<void>(image);
    //| unfinished("8.1");
    //]
}
//)

// TASK 8.2 (3 points): in which order are surfaces drawn? First the opaque ones: all of program 0, then of program 1
// and so on, since changing the program costs time. Within a program they go from the nearest to the farthest, so that
// hidden surfaces are never shaded. Then the transparent ones of all programs follow, from the farthest to the nearest,
// since each is blended over the surfaces behind it. The distance is that of the centre. Of two surfaces that are
// equally far, the one with the smaller index comes first.
//(order
std::vector<int> draw_order(std::span<const Surface> surfaces, const glm::dvec3& eye) {
    //[solution
    std::vector<int> order;
    for (int i = 0; i < int(surfaces.size()); ++i) order.push_back(i);
    const auto key = [&](int i) {
        const Surface& surface = surfaces[size_t(i)];
        const double far_away = glm::distance(surface.centre, eye);
        return surface.is_transparent ? std::tuple(1, 0, -far_away) : std::tuple(0, surface.program, far_away);
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    return order;
    //]starter
    //| static_cast<void>(surfaces), static_cast<void>(eye);
    //| unfinished("8.2");
    //]
}
//)

}  // namespace relief::materials
