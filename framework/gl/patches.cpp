#include "framework/gl/patches.h"

#include <algorithm>
#include <cstdint>

namespace relief {

void draw_patches(int patches, int control_points, int first_index) {
    glPatchParameteri(GL_PATCH_VERTICES, control_points);
    const int together = is_software_renderer() ? 8 : std::max(patches, 1);
    for (int begin = 0; begin < patches; begin += together) {
        const auto offset = (uintptr_t(first_index) + uintptr_t(begin) * uintptr_t(control_points)) * sizeof(uint32_t);
        glDrawElements(GL_PATCHES, std::min(together, patches - begin) * control_points, GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(offset));
    }
}

}  // namespace relief
