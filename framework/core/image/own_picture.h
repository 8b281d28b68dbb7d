// A picture file of the user, which a knob accepts in addition to its named choices.
#pragma once

#include <filesystem>
#include <functional>

#include "framework/core/base/own_file.h"
#include "framework/core/image/image.h"

namespace relief {

class OwnPicture final : public OwnFile {
public:
    /// `prepare` converts a picture for the lab. It throws Error, without a place, when the picture is unsuitable; the
    /// message says which pictures are accepted. Then the previous picture stays.
    explicit OwnPicture(std::function<Image(Image)> prepare) : prepare_(std::move(prepare)) {}

    const char* kind() const override { return "a picture's file"; }
    bool accepts(const std::filesystem::path& file) const override { return !is_named_as_model(file); }
    /// The picture as `prepare` returned it.
    const Image& image() const { return image_; }

private:
    void load(const std::filesystem::path& file) override;

    std::function<Image(Image)> prepare_;
    Image image_;
};

/// Returns whether the first three channels of a pixel span at most 0.02 on average. An image with fewer channels is
/// grey, and one with NaN is not.
bool is_nearly_grey(const Image& picture);

/// Returns `count` channels of an image from channel `first` on, with the same `bits`.
Image channels_of(const Image& image, int first, int count);

}  // namespace relief
