#include "framework/library/kit/relief_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "framework/core/image/asset.h"
#include "framework/core/image/color.h"
#include "framework/core/image/color_profile.h"
#include "framework/core/image/mips.h"
#include "framework/library/maps/heights.h"
#include "framework/library/maps/resample.h"
#include "framework/library/maps/test_maps.h"

namespace relief {
namespace {

constexpr std::array maps = {"smooth", "fbm",    "bricks", "stones", "posts",   "rock",
                             "wall",   "paving", "low",    "high",   "plateau", "damaged"};
constexpr std::array color_names = {"map"};
constexpr std::array sizes = {"1", "256", "512", "1024", "4096"};
constexpr std::array texels = {1, 256, 512, 1024, 4096};
constexpr std::array bit_counts = {"float", "8"};

/// Linear colours at heights 0, 0.5 and 1.
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

/// Returns the largest level of the image's mip chain that is at most `side` texels wide.
Image level_of(Image image, int side) {
    std::vector<Image> levels = mip_chain(std::move(image), ColorSpace::linear);
    size_t level = 0;
    while (levels[level].width > side && level + 1 < levels.size()) ++level;
    return std::move(levels[level]);
}

/// Returns whether an image is a normal map with heights in the fourth channel.
bool has_normals(const Image& image) { return image.channels == 4; }

/// Returns the heights of a user's picture. If the picture is a normal map with heights, it stays with them.
Image own_heights(Image picture, std::vector<std::string>& notes) {
    Heights found = heights_in(std::move(picture));
    notes = std::move(found.notes);
    if (found.normals.values.empty()) return std::move(found.image);
    Image both(found.image.width, found.image.height, 4, found.image.bits);
    for (size_t i = 0; i < both.pixel_count(); ++i) {
        std::copy_n(&found.normals.values[3 * i], 3, &both.values[4 * i]);
        both.values[4 * i + 3] = found.image.values[i];
    }
    return both;
}

/// Returns the colours of a user's picture in three channels, as sRGB stores them. Pictures of floats hold light. A
/// grey picture is grey; alpha is ignored.
Image own_albedo(Image picture, std::vector<std::string>& notes) {
    if (picture.channels % 2 == 0) notes.push_back("its alpha is not read");
    size_t not_finite = 0;
    Image colors(picture.width, picture.height, 3, 8);
    for (size_t i = 0; i < picture.pixel_count(); ++i)
        for (size_t c = 0; c < 3; ++c) {
            const float stored = picture.values[i * size_t(picture.channels) + (picture.channels < 3 ? 0 : c)];
            const double shown = picture.bits == 32 ? srgb_from_linear(double(stored)) : double(stored);
            colors.values[i * 3 + c] = std::isfinite(shown) ? float(std::clamp(shown, 0.0, 1.0)) : 0;
            not_finite += !std::isfinite(shown);
        }
    if (not_finite > 0) notes.push_back(fmt::format("{} values are NaN or infinity: read as 0", not_finite));
    if (std::string note = profile_note(picture, false); !note.empty()) notes.push_back(std::move(note));
    return colors;
}

}  // namespace

ReliefMaterial::ReliefMaterial() : own_(own_heights), own_colors_(own_albedo) {}

void ReliefMaterial::knobs(Knobs& knobs) {
    knobs.choice_or_file("map", map, own_, maps, KnobHelp("the height map").titled("Height map"));
    knobs.choice_or_file("colors", colors, own_colors_, color_names,
                         KnobHelp("colours: those of the map").titled("Colours"));
    knobs.choice("size", size, sizes,
                 KnobHelp("size of the map, texels; wall and paving have 1024").titled("Map size"));
    knobs.choice("bits", bits, bit_counts, KnobHelp("bits per stored height").titled("Bits per height"));
}

bool ReliefMaterial::is_asset() const { return map == ReliefMap::wall || map == ReliefMap::paving; }

const ReliefMaterial::Made& ReliefMaterial::made() const {
    const bool is_own = map == ReliefMap::own;
    return made_.get({map, is_asset() ? 0 : size, bits, is_packed(), is_own ? own_.version() : 0},
                     [this] { return make(); });
}

ReliefMaterial::Made ReliefMaterial::make() const {
    Image image, full;
    const char* const height_asset = map == ReliefMap::wall ? "bricks_height.png" : "paving_height.png";
    const char* const packed_asset = map == ReliefMap::wall ? "bricks_packed.png" : "paving_packed.png";
    if (is_packed()) {
        full = read_asset(height_asset);
        image = channels_of(read_asset(packed_asset), 1, 1);
    } else if (is_asset()) {
        image = read_asset(height_asset);
        if (image.width > asset_texels || bits == 1) full = image;
        if (image.width > asset_texels) image = level_of(std::move(image), asset_texels);
    } else if (map == ReliefMap::own) {
        image = resampled(own_.image(), texels[size_t(size)], texels[size_t(size)]);
        if (has_normals(image)) image = channels_of(image, 3, 1);
    } else {
        image = make_height_map(HeightMap(map < ReliefMap::wall ? map : map - 2), texels[size_t(size)]);
    }
    mend_heights(image);
    if (bits == 1) image = with_8_bits(std::move(image));
    const auto heights_first = [packed_asset] {
        Image three = read_asset(packed_asset);
        for (size_t i = 0; i < three.pixel_count(); ++i) std::swap(three.values[i * 3], three.values[i * 3 + 1]);
        return three;
    };
    const bool is_whole = is_asset() && full.values.empty();  // its integers are valid already
    return {std::move(image), std::move(full),
            is_packed() ? Texture("packed map", heights_first)
            : is_whole  ? load_texture(height_asset, ColorSpace::linear)
                        : Texture("heights", [this] { return heights(); }),
            is_asset()
                ? load_texture(map == ReliefMap::wall ? "bricks_albedo.png" : "paving_albedo.png", ColorSpace::srgb)
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

/// Returns the normals of the user's picture if it has any. Else the normal of a texel is perpendicular to two chords:
/// from its left to its right neighbour, and from its lower to its upper one.
Image ReliefMaterial::normals() const {
    // At full size, also where the search uses smaller heights.
    const Image& heights = made().full.values.empty() ? made().heights : made().full;
    const int side = heights.width;
    if (map == ReliefMap::own && has_normals(own_.image())) {
        Image stored = channels_of(resampled(own_.image(), side, side), 0, 3);
        stored.bits = 8;
        return stored;
    }
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

const Texture& ReliefMaterial::own_albedo_texture() const {
    return own_albedo_.get({own_colors_.version()}, [this] {
        return Texture("own colours", [this] { return own_colors_.image(); }, {.space = ColorSpace::srgb});
    });
}

void ReliefMaterial::set(const Program& program) const {
    program.set("s_heights", 0, made().height_texture);
    program.set("s_albedo", 1, colors == own_colors ? own_albedo_texture() : made().albedo_texture);
    program.set("s_normals", 2, made().normal_texture);
}

}  // namespace relief
