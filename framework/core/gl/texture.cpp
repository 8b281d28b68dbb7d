#include "framework/core/gl/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <tuple>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/paths.h"
#include "framework/core/gl/counters.h"
#include "framework/core/image/asset.h"
#include "framework/core/image/mips.h"

namespace relief {
namespace {

struct Format {
    GLenum internal, external, type;
};

Format format_of(const Texels& texels) {
    constexpr GLenum external[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    constexpr GLenum unorm8[] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
    constexpr GLenum unorm16[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
    constexpr GLenum floats[] = {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
    const int i = texels.channels - 1;
    if (texels.space == ColorSpace::srgb) {
        if (texels.bits != 8 || texels.channels < 3)
            throw Error(fmt::format("sRGB colour needs 8 bits and 3 or 4 channels; this has {} bits and {}",
                                    texels.bits, texels.channels));
        return {texels.channels == 3 ? GLenum(GL_SRGB8) : GLenum(GL_SRGB8_ALPHA8), external[i], GL_UNSIGNED_BYTE};
    }
    if (texels.bits == 8) return {unorm8[i], external[i], GL_UNSIGNED_BYTE};
    if (texels.bits == 16) return {unorm16[i], external[i], GL_UNSIGNED_SHORT};
    return {floats[i], external[i], GL_FLOAT};
}

GLint wrap_of(Wrap wrap) {
    return wrap == Wrap::repeat ? GL_REPEAT : wrap == Wrap::clamp ? GL_CLAMP_TO_EDGE : GL_MIRRORED_REPEAT;
}

/// Returns how many samples a filtered read takes along its longer axis.
float anisotropy_of(const TextureOptions& options) {
    return options.anisotropy.value_or(is_software_renderer() || draws_comparably() ? 1.0f : 8.0f);
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

Texture::Texture(std::string title, std::function<std::vector<Image>()> make, TextureOptions options)
    : title_(std::move(title)),
      make_([make = std::move(make), space = options.space] { return pack(make(), space); }),
      options_(options) {}

Texture::Loaded::~Loaded() { counters().texture_bytes -= bytes; }

Texture::operator GLuint() const {
    if (!loaded_ && is_asset_) {
        // The key has the course's root and all sampling options: a process may read several courses.
        using Key = std::tuple<std::string, ColorSpace, Wrap, Wrap, bool, float>;
        static std::map<Key, std::weak_ptr<const Loaded>> assets;
        std::weak_ptr<const Loaded>& shared =
            assets[Key((course_root() / title_).string(), options_.space, options_.wrap,
                       options_.wrap_v.value_or(options_.wrap), options_.mips, anisotropy_of(options_))];
        loaded_ = shared.lock();
        if (loaded_)
            counters().shared_bytes += loaded_->bytes;
        else
            shared = loaded_ = create();
    }
    if (!loaded_) loaded_ = create();
    return loaded_->name;
}

std::shared_ptr<const Texture::Loaded> Texture::create() const {
    const Stopwatch watch;
    const Texels texels = make_();
    const Texels::Level& first = texels.levels.at(0);
    const Format format = [&] {
        try {
            return format_of(texels);
        } catch (const Error& error) {
            throw Error(title_ + ": " + error.what());
        }
    }();
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(first.width, first.height / options_.layers) > largest)
        throw Error(
            fmt::format("{}: {}x{} is larger than this driver's {}", title_, first.width, first.height, largest));

    // A texture is created in the middle of a draw: keep the caller's binding on the active unit.
    const GLenum target = this->target();
    const bool layered = target == GL_TEXTURE_2D_ARRAY;
    GLint bound = 0;
    glGetIntegerv(layered ? GL_TEXTURE_BINDING_2D_ARRAY : GL_TEXTURE_BINDING_2D, &bound);
    const auto loaded = std::make_shared<Loaded>();
    glBindTexture(target, loaded->name);
    label(GL_TEXTURE, loaded->name, title_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    // Set the level count before the upload: some drivers otherwise allocate and copy the texture twice.
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, layered ? 0 : GLint(texels.levels.size()) - 1);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, layered ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER,
                    layered         ? GL_NEAREST
                    : options_.mips ? GL_LINEAR_MIPMAP_LINEAR
                                    : GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, wrap_of(options_.wrap));
    glTexParameteri(target, GL_TEXTURE_WRAP_T, wrap_of(options_.wrap_v.value_or(options_.wrap)));
    const float anisotropy = anisotropy_of(options_);
    if (GLAD_GL_EXT_texture_filter_anisotropic && options_.mips && !layered && anisotropy > 1) {
        float max_anisotropy = 1;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &max_anisotropy);
        glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(max_anisotropy, anisotropy));
    }
    const std::span<const Texels::Level> levels(texels.levels.data(), layered ? 1 : texels.levels.size());
    for (GLint i = 0; const Texels::Level& level : levels) {
        if (layered)
            glTexImage3D(target, i++, GLint(format.internal), level.width, level.height / options_.layers,
                         options_.layers, 0, format.external, format.type, level.rows);
        else
            glTexImage2D(target, i++, GLint(format.internal), level.width, level.height, 0, format.external,
                         format.type, level.rows);
        loaded->bytes += int64_t(texels.bytes(level));
    }
    counters().texture_bytes += loaded->bytes;
    glBindTexture(target, GLuint(bound));
    print_event(fmt::format("texture: {}, {}x{}, {:.1f} ms", title_, first.width, first.height, watch.milliseconds()));
    return loaded;
}

Texture load_texture(const char* asset, TextureOptions options) {
    Texture texture;
    texture.title_ = std::string("assets/") + asset;
    texture.make_ = [name = std::string(asset), options] {
        Texels chain = read_asset_chain(name, options.space);
        if (!options.mips) chain.levels.resize(1);
        return chain;
    };
    texture.options_ = options;
    texture.is_asset_ = true;
    return texture;
}

Texture load_texture(const char* asset, ColorSpace space) {
    return load_texture(asset, TextureOptions{.space = space});
}

void bind(int unit, const Texture& texture) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(texture.target(), texture);
}

}  // namespace relief
