#include "framework/core/image/own_picture.h"

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/image/file.h"

namespace relief {

void OwnPicture::load(const std::filesystem::path& file) {
    Image picture = read_image(file);
    try {
        image_ = prepare_(std::move(picture));
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
}

bool is_nearly_grey(const Image& picture) {
    double spread = 0;
    for (size_t i = 0; picture.channels >= 3 && i < picture.pixel_count(); ++i) {
        const float* const texel = picture.values.data() + i * size_t(picture.channels);
        const auto [low, high] = std::minmax({texel[0], texel[1], texel[2]});
        spread += double(high) - double(low);
    }
    return spread <= 0.02 * double(picture.pixel_count());  // false for NaN
}

Image channels_of(const Image& image, int first, int count) {
    Image some(image.width, image.height, count, image.bits);
    for (size_t i = 0; i < image.pixel_count(); ++i)
        std::copy_n(image.values.data() + i * size_t(image.channels) + size_t(first), count,
                    some.values.data() + i * size_t(count));
    return some;
}

}  // namespace relief
