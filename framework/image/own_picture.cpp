#include "framework/image/own_picture.h"

#include "framework/base/error.h"
#include "framework/image/file.h"

namespace relief {

void OwnPicture::read(const std::filesystem::path& file) {
    Image picture = read_image(file);
    try {
        image_ = prepare_(std::move(picture));
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
    file_ = std::filesystem::absolute(file);
    ++version_;
}

}  // namespace relief
