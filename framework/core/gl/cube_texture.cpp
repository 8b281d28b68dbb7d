#include "framework/core/gl/cube_texture.h"

#include <fmt/format.h>

#include "framework/core/base/error.h"
#include "framework/core/base/log.h"
#include "framework/core/base/parallel.h"
#include "framework/core/gl/counters.h"
#include "framework/core/image/mips.h"

namespace relief {

glm::dvec3 cube_map_direction(int face, double s, double t) {
    switch (face) {
        case 0:
            return {1, -t, -s};
        case 1:
            return {-1, -t, s};
        case 2:
            return {s, 1, t};
        case 3:
            return {s, -1, -t};
        case 4:
            return {s, -t, 1};
        default:
            return {-s, -t, -1};
    }
}

CubeTexture::CubeTexture(std::string title, int side, std::function<glm::dvec3(const glm::dvec3& direction)> light)
    : title_(std::move(title)), side_(side), light_(std::move(light)) {}

CubeTexture::Loaded::Loaded() = default;

CubeTexture::Loaded::~Loaded() { counters().texture_bytes -= bytes; }

CubeTexture::operator GLuint() const {
    if (loaded_) return loaded_->name;
    const Stopwatch watch;
    GLint largest = 0, bound = 0;
    glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    if (side_ < 1 || side_ > largest)
        throw Error(
            fmt::format("{}: a cube map has 1 to {} texels along an edge; this has {}", title_, largest, side_));
    std::vector<Image> faces(6, Image(side_, side_, 3));
    parallel_pieces(size_t(6) * size_t(side_), 1, 0, [&](size_t begin, size_t end) {
        for (size_t row = begin; row < end; ++row)
            for (int x = 0; x < side_; ++x) {
                const int face = int(row) / side_, y = int(row) % side_;
                const glm::dvec3 value = light_(
                    glm::normalize(cube_map_direction(face, (x + 0.5) / side_ * 2 - 1, (y + 0.5) / side_ * 2 - 1)));
                for (int c = 0; c < 3; ++c) faces[size_t(face)].pixel(x, y)[c] = float(value[c]);
            }
    });

    // Keep the caller's binding on the active unit.
    glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &bound);
    loaded_.emplace();
    glBindTexture(GL_TEXTURE_CUBE_MAP, loaded_->name);
    label(GL_TEXTURE, loaded_->name, title_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    GLint last = 0;
    while (side_ >> (last + 1)) ++last;
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, last);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, axis, GL_CLAMP_TO_EDGE);
    for (int face = 0; face < 6; ++face)
        for (GLint level = 0; const Image& image : mip_chain(std::move(faces[size_t(face)]), ColorSpace::linear)) {
            glTexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), level++, GL_RGB32F, image.width, image.height,
                         0, GL_RGB, GL_FLOAT, image.values.data());
            loaded_->bytes += int64_t(image.pixel_count()) * 12;
        }
    counters().texture_bytes += loaded_->bytes;
    glBindTexture(GL_TEXTURE_CUBE_MAP, GLuint(bound));
    print_event(fmt::format("cube map: {}, {} texels, {:.1f} ms", title_, side_, watch.milliseconds()));
    return loaded_->name;
}

void bind(int unit, const CubeTexture& texture) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
}

}  // namespace relief
