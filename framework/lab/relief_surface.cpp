#include "framework/lab/relief_surface.h"

#include <glm/gtc/constants.hpp>

#include "framework/base/parallel.h"
#include "framework/base/paths.h"
#include "framework/image/color.h"
#include "framework/image/file.h"
#include "framework/image/height_maps.h"
#include "framework/image/mips.h"
#include "framework/mesh/obj.h"

namespace relief {
namespace {

constexpr std::array shapes = {"wall", "column", "urn"};
constexpr std::array maps = {"smooth", "fbm",    "bricks", "stones", "posts",   "rock",
                             "wall",   "paving", "low",    "high",   "plateau", "damaged"};
constexpr std::array sizes = {"1", "256", "512", "1024", "4096"};
constexpr std::array texels = {1, 256, 512, 1024, 4096};
constexpr std::array bit_counts = {"float", "8"};
enum : int { first_asset = 6, after_assets = 8 };

/// The normal map is made for a relief this deep; a shader that knows the real depth scales its slopes.
constexpr float normals_depth = 0.08f;

/// Light from the depths to the tops, as the material has it.
struct Palette {
    glm::vec3 low, middle, high;
};
Palette palette_of(int map) {
    switch (map) {
        case 0:
            return {{0.09f, 0.13f, 0.2f}, {0.28f, 0.36f, 0.36f}, {0.75f, 0.72f, 0.6f}};
        case 1:
            return {{0.1f, 0.08f, 0.05f}, {0.36f, 0.27f, 0.16f}, {0.72f, 0.66f, 0.5f}};
        case 2:
            return {{0.3f, 0.28f, 0.25f}, {0.34f, 0.16f, 0.1f}, {0.46f, 0.16f, 0.09f}};
        case 4:
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

Mesh make_urn() {
    Mesh mesh = read_obj(course_root() / "assets" / "urn.obj").mesh;
    // A surface of revolution knows its tangents by its uv.
    for (Vertex& vertex : mesh.vertices) {
        const float around = 2 * glm::pi<float>() * vertex.uv.x;
        vertex.tangent = glm::vec4(std::cos(around), 0, -std::sin(around), 1);
    }
    return mesh;
}

constexpr ColumnShape column_shape{.bottom_radius = ReliefSurface::column_radius,
                                   .top_radius = ReliefSurface::column_radius,
                                   .height = ReliefSurface::column_height,
                                   .sides = 96,  // a third of the way around is a tile, and a whole number of them
                                   .rows = 1};
constexpr float around_column = 2 * glm::pi<float>() * ReliefSurface::column_radius;
constexpr float around_urn = 3.2f, up_urn = 2.4f;  // metres per unit of uv, at its middle

}  // namespace

void ReliefSurface::knobs(Knobs& knobs) {
    knobs.choice("surface", shape, shapes, "what the relief is pressed into");
    knobs.choice("map", map, maps, "the height map");
    knobs.choice("size", size, sizes, "of the map, texels; wall and paving have 1024");
    knobs.choice("bits", bits, bit_counts, "of a height");
    knobs.slider("depth", depth, 0, 1, "of the relief, in widths of a tile");
    knobs.steps("repeat", repeat, 1, 8, "how often the tile repeats: a metre of wall, a third of the column");
    knobs.slider("stretch", stretch, 0.25f, 4, "height of a tile over its width: texels that are not square");
    knobs.slider("extent", extent, 0.25f, 64, "side of the wall, metres");
    knobs.toggle("mirror", mirror, "let u run the other way");
    knobs.steps("shift", shift, 0, 10000, "where the uv begin, in tiles");
}

bool ReliefSurface::is_asset() const { return map >= first_asset && map < after_assets; }

const Image& ReliefSurface::heights() const {
    renew();
    return made_->heights;
}

void ReliefSurface::renew() const {
    const std::array of{map, size, bits};
    if (made_ && made_->of == of) return;
    Image image, full;
    if (is_asset()) {
        image = read_image(course_root() / "assets" / (map == first_asset ? "bricks_height.png" : "paving_height.png"));
        if (image.width > asset_texels || bits == 1) full = image;
        if (image.width > asset_texels) image = level_of(std::move(image), asset_texels);
    } else {
        image = make_height_map(HeightMap(map < first_asset ? map : map - 2), texels[size_t(size)]);
    }
    mend_heights(image);
    if (bits == 1) image = with_8_bits(std::move(image));
    ++version_;
    made_.reset(), windows_.reset(), window_texture_.reset();
    made_.emplace(Made{of, std::move(image), std::move(full), Texture("heights", [this] { return made_->heights; }),
                       Texture("albedo", [this] { return albedo(); }, {.space = ColorSpace::srgb}),
                       Texture("normals", [this] { return normals(); })});
}

Image ReliefSurface::albedo() const {
    if (is_asset())
        return read_image(course_root() / "assets" / (map == first_asset ? "bricks_albedo.png" : "paving_albedo.png"));
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
Image ReliefSurface::normals() const {
    // In full detail, also where the search makes do with less.
    const Image& heights = made_->full.values.empty() ? this->heights() : made_->full;
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

const Mesh& ReliefSurface::mesh() const {
    if (shape == wall && extent_ != extent) meshes_[wall].reset(), uploaded_[wall].reset(), extent_ = extent;
    std::optional<Mesh>& mesh = meshes_[shape];
    if (!mesh)
        mesh = shape == wall     ? make_quad({.width = extent, .height = extent})
               : shape == column ? make_column(column_shape)
                                 : make_urn();
    return *mesh;
}

ReliefLay ReliefSurface::lay() const {
    const glm::vec2 metres = shape == wall     ? glm::vec2(extent)
                             : shape == column ? glm::vec2(around_column, column_shape.height)
                                               : glm::vec2(around_urn, up_urn);
    // Around, whole tiles; on the wall a tile is a metre wide.
    const float tile = shape == wall ? 1.0f / float(repeat) : metres.x / float(3 * repeat);
    glm::vec2 tiles = metres / glm::vec2(tile, tile * stretch);
    if (mirror) tiles.x = -tiles.x;
    return {tiles, glm::vec2(float(shift)), glm::vec2(depth, depth / stretch), depth * tile, heights().width};
}

void ReliefSurface::set(const Program& program, const Frame& frame, const glm::dmat4& world_from_model) const {
    const ReliefLay here = lay();
    program.set("u_clip_from_world", frame.camera.clip_from_world());
    program.set("u_world_from_model", world_from_model);
    program.set("u_eye", frame.camera.eye());
    program.set("u_repeat", here.repeat);
    program.set("u_shift", here.shift);
    program.set("u_depth", here.depth);
    program.set("u_depth_metres", here.metres);
    program.set("u_normal_strength", here.depth / normals_depth);
    program.set("s_heights", 0, made_->height_texture);
    program.set("s_albedo", 1, made_->albedo_texture);
    program.set("s_normals", 2, made_->normal_texture);
}

void ReliefSurface::set_exact_hit(const Program& program, int unit) const {
    if (glGetUniformLocation(program, "s_windows") < 0) return;  // this permutation shows no error
    if (!windows_) {
        windows_ = height_windows(heights());
        window_texture_.emplace(
            "windows", [this] { return windows_->clear; }, TextureOptions{.mips = false});
    }
    const auto& grown = windows_->grown;
    program.set("s_windows", unit, *window_texture_);
    program.set("u_grown", glm::vec4(grown[0], grown[1], grown[2], grown[3]));
    program.set("u_most_turns", 4096);
}

void ReliefSurface::draw() const {
    std::optional<GpuMesh>& mesh = uploaded_[(this->mesh(), shape)];
    if (!mesh) mesh = upload([this] { return this->mesh(); });
    glBindVertexArray(mesh->layout());
    glDrawElements(GL_TRIANGLES, mesh->count(), GL_UNSIGNED_INT, nullptr);
}

}  // namespace relief
