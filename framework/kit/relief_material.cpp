#include "framework/kit/relief_material.h"

#include "framework/base/parallel.h"
#include "framework/height/maps.h"
#include "framework/image/asset.h"
#include "framework/image/color.h"
#include "framework/image/mips.h"

namespace relief {
namespace {

constexpr std::array maps = {"smooth", "fbm",    "bricks", "stones", "posts",   "rock",
                             "wall",   "paving", "low",    "high",   "plateau", "damaged"};
constexpr std::array sizes = {"1", "256", "512", "1024", "4096"};
constexpr std::array texels = {1, 256, 512, 1024, 4096};
constexpr std::array bit_counts = {"float", "8"};

/// Light from the depths to the tops, as the material has it.
struct Palette {
    glm::vec3 low, middle, high;
};
Palette palette_of(int map) {
    switch (map) {
        case ReliefMap::smooth:
            return {{0.09f, 0.13f, 0.2f}, {0.28f, 0.36f, 0.36f}, {0.75f, 0.72f, 0.6f}};
        case ReliefMap::fbm:
            return {{0.1f, 0.08f, 0.05f}, {0.36f, 0.27f, 0.16f}, {0.72f, 0.66f, 0.5f}};
        case ReliefMap::bricks:
            return {{0.3f, 0.28f, 0.25f}, {0.34f, 0.16f, 0.1f}, {0.46f, 0.16f, 0.09f}};
        case ReliefMap::posts:
            return {{0.12f, 0.16f, 0.2f}, {0.4f, 0.36f, 0.3f}, {0.95f, 0.8f, 0.4f}};
        default:
            return {{0.1f, 0.1f, 0.09f}, {0.3f, 0.29f, 0.27f}, {0.6f, 0.57f, 0.52f}};
    }
}

/// The largest level of the image's mip chain with `side` texels a side at most.
Image level_of(Image image, int side) {
    std::vector<Image> levels = mip_chain(std::move(image), ColorSpace::linear);
    size_t level = 0;
    while (levels[level].width > side && level + 1 < levels.size()) ++level;
    return std::move(levels[level]);
}

}  // namespace

void ReliefMaterial::knobs(Knobs& knobs) {
    knobs.choice("map", map, maps, "the height map");
    knobs.choice("size", size, sizes, "size of the map, texels; wall and paving have 1024");
    knobs.choice("bits", bits, bit_counts, "bits per stored height");
}

bool ReliefMaterial::is_asset() const { return map == ReliefMap::wall || map == ReliefMap::paving; }

const ReliefMaterial::Made& ReliefMaterial::made() const {
    return made_.get({map, size, bits}, [this] { return make(); });
}

ReliefMaterial::Made ReliefMaterial::make() const {
    Image image, full;
    const char* const height_asset = map == ReliefMap::wall ? "bricks_height.png" : "paving_height.png";
    if (is_asset()) {
        image = read_asset(height_asset);
        if (image.width > asset_texels || bits == 1) full = image;
        if (image.width > asset_texels) image = level_of(std::move(image), asset_texels);
    } else {
        image = make_height_map(HeightMap(map < ReliefMap::wall ? map : map - 2), texels[size_t(size)]);
    }
    mend_heights(image);
    if (bits == 1) image = with_8_bits(std::move(image));
    const bool is_whole = is_asset() && full.values.empty();  // its integers need no mending
    return {
        std::move(image), std::move(full),
        is_whole ? load_texture(height_asset, ColorSpace::linear) : Texture("heights", [this] { return heights(); }),
        is_asset() ? load_texture(map == ReliefMap::wall ? "bricks_albedo.png" : "paving_albedo.png", ColorSpace::srgb)
                   : Texture("albedo", [this] { return albedo(); }, {.space = ColorSpace::srgb}),
        Texture("normals", [this] { return normals(); })};
}

Image ReliefMaterial::albedo() const {
    const Image& heights = this->heights();
    const auto [low, middle, high] = palette_of(map);
    Image image(heights.width, heights.height, 3, 8);
    parallel_pieces(
        heights.pixel_count(), 1 << 14, 0, [&, low = low, middle = middle, high = high](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const float h = heights.values[i];
                const glm::vec3 light = h < 0.5f ? glm::mix(low, middle, h * 2) : glm::mix(middle, high, h * 2 - 1);
                for (int c = 0; c < 3; ++c) image.values[i * 3 + size_t(c)] = float(srgb_from_linear(double(light[c])));
            }
        });
    return image;
}

/// At each texel, across the two chords between the points beside it.
Image ReliefMaterial::normals() const {
    // In full detail, also where the search makes do with less.
    const Image& heights = made().full.values.empty() ? made().heights : made().full;
    const int side = heights.width;
    const auto point = [&](int x, int y) {  // in texels; row 0 is the top
        const float height = *heights.pixel((x + side) % side, (y + side) % side);
        return glm::vec3(x, -y, height * normals_depth * float(side));
    };
    Image image(side, side, 3, 8);
    parallel_pieces(size_t(side), 16, 0, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < side; ++x) {
                const glm::vec3 right = point(x + 1, y) - point(x - 1, y), up = point(x, y - 1) - point(x, y + 1);
                const glm::vec3 stored = 0.5f * glm::normalize(glm::cross(right, up)) + 0.5f;
                for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = stored[c];
            }
    });
    return image;
}

void ReliefMaterial::set(const Program& program) const {
    program.set("s_heights", 0, made().height_texture);
    program.set("s_albedo", 1, made().albedo_texture);
    program.set("s_normals", 2, made().normal_texture);
}

}  // namespace relief
