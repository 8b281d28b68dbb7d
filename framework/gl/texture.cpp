#include "framework/gl/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/base/error.h"
#include "framework/base/paths.h"
#include "framework/gl/counters.h"
#include "framework/image/file.h"
#include "framework/image/mips.h"

namespace relief {
namespace {

struct Format {
    GLenum internal, external, type;
    int bytes_per_channel;
};

Format format_of(const Image& image, ColorSpace space) {
    constexpr GLenum external[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    constexpr GLenum unorm8[] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
    constexpr GLenum unorm16[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
    constexpr GLenum floats[] = {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
    const int i = image.channels - 1;
    if (space == ColorSpace::srgb) {
        if (image.bits != 8 || image.channels < 3)
            throw Error(fmt::format("sRGB colour needs 8 bits and 3 or 4 channels; this has {} bits and {}", image.bits,
                                    image.channels));
        return {image.channels == 3 ? GLenum(GL_SRGB8) : GLenum(GL_SRGB8_ALPHA8), external[i], GL_UNSIGNED_BYTE, 1};
    }
    if (image.bits == 8) return {unorm8[i], external[i], GL_UNSIGNED_BYTE, 1};
    if (image.bits == 16) return {unorm16[i], external[i], GL_UNSIGNED_SHORT, 2};
    return {floats[i], external[i], GL_FLOAT, 4};
}

/// Rows from the bottom to the top, as GL wants them, rounded to the type.
template <class Integer>
std::vector<Integer> rows_upwards(const Image& image) {
    std::vector<Integer> result(image.values.size());
    const size_t row = size_t(image.width) * image.channels;
    for (int y = 0; y < image.height; ++y) {
        const float* const from = image.pixel(0, y);
        Integer* const to = result.data() + row * (image.height - 1 - y);
        for (size_t i = 0; i < row; ++i) {
            if constexpr (std::is_same_v<Integer, float>)
                to[i] = from[i];
            else
                to[i] = Integer(std::clamp(from[i], 0.0f, 1.0f) * std::numeric_limits<Integer>::max() + 0.5f);
        }
    }
    return result;
}

void upload_level(int level, const Image& image, const Format& format) {
    const auto upload = [&](const void* rows) {
        glTexImage2D(GL_TEXTURE_2D, level, GLint(format.internal), image.width, image.height, 0, format.external,
                     format.type, rows);
    };
    if (format.type == GL_UNSIGNED_BYTE) upload(rows_upwards<uint8_t>(image).data());
    if (format.type == GL_UNSIGNED_SHORT) upload(rows_upwards<uint16_t>(image).data());
    if (format.type == GL_FLOAT) upload(rows_upwards<float>(image).data());
}

}  // namespace

Texture::Texture(std::string title, std::function<Image()> make, TextureOptions options)
    : Texture(std::move(title), std::function<std::vector<Image>()>([make = std::move(make), options] {
                  std::vector<Image> levels;
                  if (options.mips)
                      levels = mip_chain(make(), options.space);
                  else
                      levels.push_back(make());
                  return levels;
              }),
              options) {}

Texture::~Texture() { counters().texture_bytes -= bytes_; }

Texture::operator GLuint() const {
    if (!name_) create();
    return *name_;
}

void Texture::create() const {
    const std::vector<Image> levels = make_();
    const Image& image = levels.at(0);
    const Format format = [&] {
        try {
            return format_of(image, options_.space);
        } catch (const Error& error) {
            throw Error(title_ + ": " + error.what());
        }
    }();
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(image.width, image.height) > largest)
        throw Error(
            fmt::format("{}: {}x{} is larger than this driver's {}", title_, image.width, image.height, largest));

    // Made in the middle of a draw that has textures bound: whatever is on the active unit must stay there.
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    TextureName name;
    glBindTexture(GL_TEXTURE_2D, name);
    label(GL_TEXTURE, name, title_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    int64_t bytes = 0;
    for (size_t level = 0; level < levels.size(); ++level) {
        upload_level(int(level), levels[level], format);
        bytes += int64_t(levels[level].values.size()) * format.bytes_per_channel;
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, GLint(levels.size()) - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, options_.mips ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    const GLint wrap = options_.wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    const float anisotropy = options_.anisotropy.value_or(is_software_renderer() ? 1.0f : 8.0f);
    if (GLAD_GL_EXT_texture_filter_anisotropic && options_.mips && anisotropy > 1) {
        float most = 1;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(most, anisotropy));
    }
    glBindTexture(GL_TEXTURE_2D, GLuint(bound));
    bytes_ = bytes;
    counters().texture_bytes += bytes;
    name_ = std::move(name);
}

Texture load_texture(const char* asset, TextureOptions options) {
    const std::string name(asset);
    return Texture(
        "assets/" + name, [name] { return read_image(course_root() / "assets" / name); }, options);
}

Texture load_texture(const char* asset, ColorSpace space) {
    return load_texture(asset, TextureOptions{.space = space});
}

void bind(int unit, const Texture& texture) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace relief
