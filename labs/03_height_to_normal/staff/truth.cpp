// The staff's part of lab 03: see ../truth.h.
#include "truth.h"

#include "framework/staff/reference/ambient_occlusion.h"
#include "framework/staff/reference/normals.h"

namespace relief::heights {
namespace {

Image framework_normals(const Image& heights, const NormalOptions& options) {
    Image normals = normals_from_heights(heights, options);
    for (float& value : normals.values) value = 2 * value - 1;
    normals.bits = 32;
    return normals;
}

Image framework_heights(const Image& picture) {
    Image heights = heights_from_color(picture, ColorSpace::srgb);
    heights.bits = 32;
    return heights;
}

// Students write this integral in task 16.5.
Image open_by_horizons(const Image& heights, double texels) { return occlusion_from_heights(heights, texels, 8, 32); }

const decltype(open_to_the_sky)::Provided provided_open_to_the_sky(open_to_the_sky, open_by_horizons);
const decltype(normals_by_cpu)::Provided provided_normals_by_cpu(normals_by_cpu, framework_normals);
const decltype(heights_by_cpu)::Provided provided_heights_by_cpu(heights_by_cpu, framework_heights);

}  // namespace
}  // namespace relief::heights
