#include "skirted_patch.h"

namespace relief {

int SkirtedPatch::hangs_from(int i) const {
    const int side = quads + 1, at = i % side;
    switch (i / side) {
        case 0:
            return at;
        case 1:
            return at * side + quads;
        case 2:
            return quads * side + quads - at;
        default:
            return (quads - at) * side;
    }
}

std::vector<uint32_t> SkirtedPatch::indices() const {
    const int side = quads + 1;
    std::vector<uint32_t> indices;
    const auto quad = [&](int a, int b, int c, int d) {
        for (const int corner : {a, b, d, a, d, c}) indices.push_back(uint32_t(corner));
    };
    for (int y = 0; y < quads; ++y)
        for (int x = 0; x < quads; ++x) {
            const int a = y * side + x;
            quad(a, a + 1, a + side, a + side + 1);
        }
    for (int border = 0; border < 4; ++border)
        for (int at = 0; at < quads; ++at) {
            const int i = border * side + at, below = grid_vertices() + i;
            quad(below, below + 1, hangs_from(i), hangs_from(i + 1));
        }
    return indices;
}

}  // namespace relief
