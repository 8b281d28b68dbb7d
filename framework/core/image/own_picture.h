// A picture file of the user, which a knob accepts in addition to its named choices.
#pragma once

#include <filesystem>
#include <functional>

#include "framework/core/image/image.h"

namespace relief {

class OwnPicture {
public:
    /// `prepare` converts a picture for the lab. It throws Error, without a place, when the picture is unsuitable; the
    /// message says which pictures are accepted.
    explicit OwnPicture(std::function<Image(Image)> prepare) : prepare_(std::move(prepare)) {}

    /// Reads and prepares a picture. Throws Error that names the file when it is missing, damaged, too large or refused
    /// by `prepare`; then the previous picture stays.
    void read(const std::filesystem::path& file);

    /// Absolute path; empty until a picture has been read.
    const std::filesystem::path& file() const { return file_; }
    /// The picture as `prepare` returned it.
    const Image& image() const { return image_; }
    /// Increases with each picture that is read.
    int version() const { return version_; }

private:
    std::function<Image(Image)> prepare_;
    std::filesystem::path file_;
    Image image_;
    int version_ = 0;
};

/// Returns whether the first three channels of a pixel span at most 0.02 on average. An image with fewer channels is
/// grey, and one with NaN is not.
bool is_nearly_grey(const Image& picture);

/// Returns `count` channels of an image from channel `first` on, with the same `bits`.
Image channels_of(const Image& image, int first, int count);

}  // namespace relief
