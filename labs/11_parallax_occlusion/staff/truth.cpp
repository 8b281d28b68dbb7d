// What only the staff has of lab 11: see ../truth.h.
#include "truth.h"

#include "framework/base/parallel.h"
#include "framework/staff/reference/relief_sight.h"

namespace relief::occlusion {
namespace {

std::optional<Image> exact_values(const Frame& frame, const Probe& probe, const Mesh& mesh,
                                  const ReliefMapping& mapping, const Image& heights) {
    if (probe.name != "uv" && probe.name != "depth") return {};
    const HeightField field(heights, true);
    const ReliefSights sights(mesh);
    Image image(frame.size.x, frame.size.y, 4);
    std::fill(image.values.begin(), image.values.end(), no_surface);
    const auto draw = [&](int x, int y) {
        const auto sight = sights.look(frame.ray(x, y), mapping);
        if (!sight) return;
        double t = 0;
        if (!sight->faces_away) {
            const auto hit = field.first_hit(sight->ray.in_texels(), 1);
            t = hit ? hit->t : 1;
        }
        float* const pixel = image.pixel(x, y);
        std::fill_n(pixel, 4, 0.0f);
        const glm::dvec2 texel = sight->ray.texel + t * sight->ray.march;
        if (probe.name == "uv")
            pixel[0] = float(texel.x), pixel[1] = float(texel.y);
        else
            pixel[0] = float(sight->distance + t * sight->metres_to_ground);
    };
    parallel_pieces(size_t(frame.size.y), 1, 0, [&](size_t begin, size_t end) {
        for (size_t y = begin; y < end; ++y)
            for (int x = 0; x < frame.size.x; ++x) draw(x, int(y));
    });
    return image;
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::occlusion
