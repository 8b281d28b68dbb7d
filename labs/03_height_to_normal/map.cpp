#include "map.h"

#include <algorithm>
#include <array>

namespace relief::heights {

Map::Map(int side, GLenum format) : side_(side), format_(format) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(format_), side_, side_, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
}

void Map::fill(WindowTriangle& window) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, side_, side_);
    window.draw();
}

void Map::fill(const Image& image) const {
    std::vector<float> upwards;
    for (int y = image.height; y-- > 0;)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 4; ++c) upwards.push_back(c < image.channels ? image.pixel(x, y)[c] : 1);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(format_), side_, side_, 0, GL_RGBA, GL_FLOAT, upwards.data());
}

Image Map::read(int channels) const {
    std::vector<float> upwards(size_t(side_) * side_ * channels);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    constexpr std::array<GLenum, 5> formats = {0, GL_RED, GL_RG, GL_RGB, GL_RGBA};
    glReadPixels(0, 0, side_, side_, formats[size_t(channels)], GL_FLOAT, upwards.data());
    Image image(side_, side_, channels);
    const size_t row = size_t(side_) * channels;
    for (int y = 0; y < side_; ++y) std::copy_n(upwards.data() + row * (side_ - 1 - y), row, image.pixel(0, y));
    return image;
}

bool Map::is_written() const {
    const Image image = read(4);
    for (size_t i = 3; i < image.values.size(); i += 4)
        if (image.values[i] < 0.5f) return false;
    return true;
}

void Map::bind(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, texture_);
}

}  // namespace relief::heights
