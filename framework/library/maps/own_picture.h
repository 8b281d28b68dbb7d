// A picture file of the user, which a knob accepts in addition to its named choices.
#pragma once

#include <filesystem>
#include <functional>

#include "framework/core/base/own_file.h"
#include "framework/core/image/image.h"

namespace relief {

class OwnPicture final : public OwnFile {
public:
    /// Converts a picture for the lab, and adds to `notes` what it does not read or changes. It throws Error, without a
    /// place, when the picture is unsuitable; the message says which pictures are accepted. Then the previous picture
    /// stays.
    using Prepare = std::function<Image(Image, std::vector<std::string>& notes)>;
    explicit OwnPicture(Prepare prepare) : prepare_(std::move(prepare)) {}

    const char* kind() const override { return "a picture's file"; }
    bool accepts(const std::filesystem::path& file) const override { return !is_named_as_model(file); }
    /// The picture as `prepare` returned it.
    const Image& image() const { return image_; }

private:
    std::vector<std::string> load(const std::filesystem::path& file) override;

    Prepare prepare_;
    Image image_;
};

/// Returns `count` channels of an image from channel `first` on, with the same `bits`.
Image channels_of(const Image& image, int first, int count);

}  // namespace relief
