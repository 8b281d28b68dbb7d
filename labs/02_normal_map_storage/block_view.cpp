#include "block_view.h"

#include <fmt/format.h>

#include "blocks.h"
#include "framework/core/base/text.h"
#include "framework/core/gl/counters.h"
#include "framework/core/image/bc1.h"
#include "framework/core/image/own_picture.h"
#include "framework/core/kit/numbers.h"
#include "framework/core/kit/view_axes.h"

namespace relief::storage {
namespace {

/// A texture of BC5 blocks in the driver, without mip levels.
class BlockTexture {
public:
    BlockTexture(const BlockMap& map, bool is_signed) : bytes_(int64_t(map.bytes.size())) {
        GLint bound = 0;
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
        glBindTexture(GL_TEXTURE_2D, name_);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        glCompressedTexImage2D(GL_TEXTURE_2D, 0, is_signed ? GL_COMPRESSED_SIGNED_RG_RGTC2 : GL_COMPRESSED_RG_RGTC2,
                               map.width, map.height, 0, GLsizei(map.bytes.size()), map.bytes.data());
        glBindTexture(GL_TEXTURE_2D, GLuint(bound));
        counters().texture_bytes += bytes_;
    }
    ~BlockTexture() { counters().texture_bytes -= bytes_; }
    BlockTexture(const BlockTexture&) = delete;

    void bind(int unit) const {
        glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, name_);
    }

private:
    TextureName name_;
    int64_t bytes_;
};

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

/// A map in one format: in blocks, or in bytes.
struct BlockView::Stored {
    std::unique_ptr<BlockTexture> blocks;
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
        if (format == bytes)
            keep_bytes(as_colors(map(), 2), 2);
        else if (format == bc1)  // OpenGL has BC1 only as an extension, so the texture has the decoded colours
            keep_bytes(through_bc1(as_colors(map(), 3)), 0.5);
        else {
            const BlockMap compressed = compress(map(), format == bc5_snorm);
            result->blocks = std::make_unique<BlockTexture>(compressed, format == bc5_snorm);
            result->bytes_per_texel = double(compressed.bytes.size()) / double(map().pixel_count());
        }
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
        map.blocks->bind(1);
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

void BlockView::draw(const Frame& part, glm::ivec2 size, const Tile& tile, Format format, float split, Labels& labels) {
    const ErrorSummary error = part.probe ? ErrorSummary() : measure(format);
    const Program& program = program_.with({formats.define(format), part.probe});
    glBindFramebuffer(GL_FRAMEBUFFER, part.target);
    glViewport(tile.corner.x, tile.corner.y, tile.size.x, tile.size.y);
    glUseProgram(program);
    set_textures(program, format);
    program.set("u_eye", part.camera.eye());
    set_rays(program, part);
    program.set("u_tiles", repeat_ == once ? 1.0f : 2.0f);
    program.set("u_mirrored", repeat_ == mirrored);
    program.set("u_split", split);
    program.set("u_borders", borders_ ? 1.0f : 0.0f);
    window_.draw();

    constexpr std::array titles = {"BC1", "BC5", "BC5, signed", "8:8 and z"};
    labels.caption(size, tile, 0, titles[size_t(format)]);
    const double stored_bytes = stored(format).bytes_per_texel;
    labels.caption(size, tile, -1,
                   fmt::format("{} {} a texel", plain(stored_bytes), stored_bytes == 1 ? "byte" : "bytes"));
    if (error.count > 0)
        labels.caption(size, tile, -2, fmt::format("mean {}~ max {}~", rounded(error.mean), rounded(error.largest)));
}

Image BlockView::truth(const Frame& part, const Probe& probe, Format format) const {
    const Image& normals = map();
    return truth_of_rays(part, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const double t = -ray.origin.z / ray.direction.z;
        const glm::dvec3 place = ray.at(t);
        if (!(t > 0) || std::max(std::abs(place.x), std::abs(place.y)) >= 1) return {};
        glm::dvec2 uv = (0.5 * glm::dvec2(place) + 0.5) * (repeat_ == once ? 1.0 : 2.0), sign(1);
        for (int c = 0; c < 2; ++c) {
            const bool second = uv[c] >= 1;
            uv[c] -= second;
            if (second && repeat_ == mirrored) uv[c] = 1 - uv[c], sign[c] = -1;
        }
        const auto texel = [](double x) { return std::clamp(int(x * map_size), 0, map_size - 1); };
        const float* n = normals.pixel(texel(uv.x), map_size - 1 - texel(uv.y));
        const glm::dvec3 normal(n[0], n[1], n[2]);
        if (probe.name == "normal") return glm::dvec4(sign.x * normal.x, sign.y * normal.y, normal.z, 0);
        if (format == bc5_snorm) return glm::dvec4(127.0 * normal.x, 127.0 * normal.y, 0, 0);
        const glm::dvec3 codes = 127.5 * (normal + 1.0);
        return glm::dvec4(codes.x, codes.y, format == bc1 ? codes.z : 0, 0);
    });
}

}  // namespace relief::storage
