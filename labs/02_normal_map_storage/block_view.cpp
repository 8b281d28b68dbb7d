#include "block_view.h"

#include <fmt/format.h>

#include "blocks.h"
#include "encoded_texture.h"
#include "framework/core/base/text.h"
#include "framework/library/kit/drawn_numbers.h"
#include "framework/library/kit/view_axes.h"
#include "framework/library/maps/bc1.h"
#include "framework/library/maps/own_picture.h"

namespace relief::storage {
namespace {

/// The part of a map that the vectors are drawn for, the upper left quarter: lower left corner and size, in uv.
constexpr glm::dvec3 quarter(0, 0.5, 0.5), whole(0, 0, 1);
constexpr double axis_length = 0.5;  ///< of the axes in vectors.vert

/// Returns the first `channels` components n of a map as colours, (n + 1) / 2.
Image as_colors(const Image& normals, int channels) {
    Image colors(normals.width, normals.height, channels, 8);
    for (size_t i = 0; i < colors.values.size(); ++i) {
        const size_t texel = i / size_t(channels), c = i % size_t(channels);
        colors.values[i] = 0.5f * normals.values[texel * 3 + c] + 0.5f;
    }
    return colors;
}

}  // namespace

/// A map in one format: in blocks or signed bytes, or in bytes.
struct BlockView::Stored {
    std::optional<EncodedTexture> encoded;
    std::optional<Texture> bytes;
    double bytes_per_texel = 0;
};

const Image& BlockView::map() const {
    return texels_.get({map_}, [&] { return normal_map(MapName(map_)); });
}

const BlockView::Stored& BlockView::stored(Format format) {
    return *stored_[format].get({map_}, [&] {
        const auto result = std::make_shared<Stored>();
        const auto keep_bytes = [&](Image image, double bytes_per_texel) {
            result->bytes.emplace(
                "a map in bytes", [image = std::move(image)] { return image; }, TextureOptions{.mips = false});
            result->bytes_per_texel = bytes_per_texel;
        };
        if (format == bytes) {
            keep_bytes(as_colors(map(), 2), 2);
        } else if (format == rgb8) {
            keep_bytes(as_colors(map(), 3), 3);
        } else if (format == bc1) {  // OpenGL has BC1 only as an extension, so the texture has the decoded colours
            keep_bytes(through_bc1(as_colors(map(), 3)), 0.5);
        } else if (format == bc5 || format == bc5_snorm) {
            const BlockMap blocks = compress(map(), format == bc5_snorm);
            result->encoded.emplace(glm::ivec2(blocks.width, blocks.height), blocks.bytes, format == bc5_snorm);
        } else {
            result->encoded.emplace(map());
        }
        if (result->encoded) result->bytes_per_texel = double(result->encoded->bytes()) / double(map().pixel_count());
        return std::shared_ptr<const Stored>(result);
    });
}

void BlockView::set_textures(const Program& program, Format format) {
    const Texture& exact = exact_.get(
        {map_}, [&] { return Texture("exact normals", [texels = map()] { return texels; }, {.mips = false}); });
    program.set("s_exact", 0, exact);
    const Stored& map = stored(format);
    if (map.bytes) {
        program.set("s_stored", 1, *map.bytes);
    } else {
        map.encoded->bind(1);
        program.set("s_stored", 1);
    }
}

/// Returns the error over all texels of the map, computed by the shader.
const ErrorSummary& BlockView::measure(Format format) {
    const Program& program = program_.with({formats.define(format), "MEASURE"});
    return measured_[format].get({program, map_}, [&] {
        const Image drawn = draw_numbers(glm::ivec2(map_size), [&] {
            glUseProgram(program);
            set_textures(program, format);
            window_.draw();
        });
        return summarize(channels_of(drawn, 0, 1));
    });
}

void BlockView::draw(const Frame& part, glm::ivec2 size, const Tile& tile, const Panel& panel, float split,
                     Labels& labels) {
    const ErrorSummary error = part.probe || panel.look != lit_and_error ? ErrorSummary() : measure(panel.format);
    const char* const texels = panel.look <= lit || part.probe ? "" : "TEXELS";
    const Program& program = program_.with({formats.define(panel.format), part.probe, texels});
    glBindFramebuffer(GL_FRAMEBUFFER, part.target);
    glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
    glUseProgram(program);
    set_textures(program, panel.format);
    if (panel.look == heights && !part.probe)
        program.set("s_stored", 1, heights_.get({map_}, [&] {
            return Texture("heights", [map = height_map(MapName(map_))] { return map; }, {.mips = false});
        }));
    program.set("u_eye", part.camera.eye());
    set_rays(program, part);
    program.set("u_part", panel.look == field ? quarter : whole);
    program.set("u_tiles", repeat_ == once || panel.look == field ? 1.0f : 2.0f);
    program.set("u_mirrored", repeat_ == mirrored && panel.look != field);
    program.set("u_split", panel.look == lit ? 2.0f : split);
    program.set("u_borders", borders_ ? 1.0f : 0.0f);
    program.set("u_channel", panel.channel);
    window_.draw();
    if (part.probe) return;
    if (panel.look == field) draw_vectors(part, size, tile, labels);
    describe(size, tile, panel, error, labels);
}

/// Draws a needle for each texel of the quarter, along its vector, and the axes T, B and N at the corner of the square.
void BlockView::draw_vectors(const Frame& part, glm::ivec2 size, const Tile& tile, Labels& labels) {
    if (part.camera.eye().z <= 0) return;  // the square hides them
    const Program& program = vectors_.with();
    glUseProgram(program);
    program.set("s_stored", 1, *stored(rgb8).bytes);
    program.set("u_clip_from_world", part.camera.clip_from_world());
    program.set("u_size", glm::vec2(tile.size));
    program.set("u_part", quarter);
    const int side = int(map_size * quarter.z);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, side * side + 3);  // with the layout of window_, which is bound

    constexpr std::array axes = {"T", "B", "N"};
    for (int i = 0; i < 3; ++i) {
        glm::dvec4 tip(-1, -1, 0, 1);
        tip[i] += axis_length * 1.12;
        const glm::dvec4 clip = part.camera.clip_from_world() * tip;
        if (clip.w <= 0) continue;
        const glm::dvec2 place = (0.5 + 0.5 * glm::dvec2(clip) / clip.w) * glm::dvec2(tile.size);
        const float high = Labels::line_height(size);
        labels.text(axes[size_t(i)], glm::vec2(tile.corner.x + place.x, size.y - tile.corner.y - place.y - 0.5 * high),
                    high, Align::centre);
    }
}

void BlockView::describe(glm::ivec2 size, const Tile& tile, const Panel& panel, const ErrorSummary& error,
                         Labels& labels) {
    if (error.count == 0) return labels.caption(size, tile, 0, panel.title);
    const double stored_bytes = stored(panel.format).bytes_per_texel;
    labels.caption(
        size, tile, 0,
        fmt::format("{}: {} {} a texel", panel.title, plain(stored_bytes), stored_bytes == 1 ? "byte" : "bytes"));
    labels.caption(size, tile, -1, fmt::format("mean {}~ max {}~", rounded(error.mean), rounded(error.largest)));
}

Image BlockView::truth(const Frame& part, const Panel& panel) const {
    const Image& normals = map();
    const bool is_field = panel.look == field;
    const glm::dvec3 shown = is_field ? quarter : whole;
    return truth_of_rays(part, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const double t = -ray.origin.z / ray.direction.z;
        const glm::dvec3 place = ray.at(t);
        if (!(t > 0) || std::max(std::abs(place.x), std::abs(place.y)) >= 1) return {};
        glm::dvec2 uv = (0.5 * glm::dvec2(place) + 0.5) * (repeat_ == once || is_field ? 1.0 : 2.0), sign(1);
        for (int c = 0; c < 2; ++c) {
            const bool second = uv[c] >= 1;
            uv[c] -= second;
            if (second && repeat_ == mirrored) uv[c] = 1 - uv[c], sign[c] = -1;
        }
        uv = glm::dvec2(shown) + shown.z * uv;
        const auto texel = [](double x) { return std::clamp(int(x * map_size), 0, map_size - 1); };
        const float* n = normals.pixel(texel(uv.x), map_size - 1 - texel(uv.y));
        const glm::dvec3 normal(n[0], n[1], n[2]);
        if (part.probe.name == "normal") return glm::dvec4(sign.x * normal.x, sign.y * normal.y, normal.z, 0);
        const bool has_two = panel.format == bc5 || panel.format == bc5_snorm || panel.format == bytes;
        const bool is_unsigned = panel.format <= rgb8 && panel.format != bc5_snorm;
        const glm::dvec3 codes = is_unsigned ? 127.5 * (normal + 1.0) : 127.0 * normal;
        return glm::dvec4(codes.x, codes.y, has_two ? 0 : codes.z, 0);
    });
}

}  // namespace relief::storage
