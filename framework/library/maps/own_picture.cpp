#include "framework/library/maps/own_picture.h"

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/image/file.h"

namespace relief {

std::vector<std::string> OwnPicture::load(const std::filesystem::path& file) {
    Image picture = read_image(file);
    try {
        std::vector<std::string> notes;
        image_ = prepare_(std::move(picture), notes);
        for (std::string& note : notes) note = note_about({file}, note);
        return notes;
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
}

Image channels_of(const Image& image, int first, int count) {
    Image some(image.width, image.height, count, image.bits);
    for (size_t i = 0; i < image.pixel_count(); ++i)
        std::copy_n(image.values.data() + i * size_t(image.channels) + size_t(first), count,
                    some.values.data() + i * size_t(count));
    return some;
}

}  // namespace relief
