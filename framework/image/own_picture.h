// A picture of the user's own, which a knob takes beside the names of its choice.
#pragma once

#include <filesystem>
#include <functional>

#include "framework/image/image.h"

namespace relief {

class OwnPicture {
public:
    /// `prepare` makes of a picture what the lab needs, or throws Error, without a place, that says what would be
    /// right.
    explicit OwnPicture(std::function<Image(Image)> prepare) : prepare_(std::move(prepare)) {}

    /// Throws Error that names the file when it is missing, damaged, too large or refused by `prepare`; the picture
    /// before then stays.
    void read(const std::filesystem::path& file);

    /// Absolute; empty until a picture was read.
    const std::filesystem::path& file() const { return file_; }
    /// As `prepare` made it.
    const Image& image() const { return image_; }
    /// Counts up with each picture that was read.
    int version() const { return version_; }

private:
    std::function<Image(Image)> prepare_;
    std::filesystem::path file_;
    Image image_;
    int version_ = 0;
};

/// Whether the first three channels are 0.02 apart on average at most; fewer channels are grey.
bool is_nearly_grey(const Image& picture);

/// Some of an image's channels; its bits stay.
Image channels_of(const Image& image, int first, int count);

}  // namespace relief
