// The only file that includes OpenImageIO. Built as a module of its own.
#include "framework/core/image/openimageio.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "framework/core/base/system.h"
#include "framework/core/image/stored.h"

namespace {

using namespace relief;

// Returns a file name whose ending selects the format in OpenImageIO.
std::string name_for(const char* format) {
    return std::string("image.") + (std::string_view(format) == "openexr" ? "exr" : format);
}

/// Silences standard error, where libjpeg prints by itself. Its message reaches the user through the Error.
class QuietStandardError {
public:
    QuietStandardError() { os::redirect(standard_error, os::open_nowhere()); }
    ~QuietStandardError() { os::redirect(standard_error, kept_); }
    QuietStandardError(const QuietStandardError&) = delete;
    QuietStandardError& operator=(const QuietStandardError&) = delete;

private:
    const Descriptor kept_ = os::copy_of(standard_error);
};

/// Stays within the buffer. After a seek beyond its end, which the table of a damaged OpenEXR file can ask for,
/// OpenImageIO 2.4 reads behind it.
class BoundedReader final : public OIIO::Filesystem::IOMemReader {
public:
    using OIIO::Filesystem::IOMemReader::IOMemReader;
    bool seek(int64_t offset) override {
        return IOMemReader::seek(std::clamp(offset, int64_t{0}, static_cast<int64_t>(size())));
    }
};

Error damaged(const std::string& reason) { return Error("damaged: " + reason.substr(0, reason.find('\n'))); }

}  // namespace

Image relief_decode_image(const std::string& bytes, const char* format, Notes& notes) {
    OIIO::attribute("try_all_readers", 0);
    OIIO::attribute("limits:imagesize_MB", static_cast<int>(max_image_bytes >> 20));
    OIIO::attribute("limits:channels", 4);

    const QuietStandardError quiet;
    BoundedReader reader(bytes.data(), bytes.size());
    OIIO::ImageSpec as_stored;
    OIIO::Filesystem::IOProxy* const from_memory = &reader;
    as_stored.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &from_memory);
    const auto input = OIIO::ImageInput::open(name_for(format), &as_stored, from_memory);
    if (!input) throw damaged(OIIO::geterror());

    const OIIO::ImageSpec& spec = input->spec();
    check_image_size(spec.width, spec.height, spec.nchannels);
    for (const OIIO::ParamValue& note : spec.extra_attribs) {
        const std::string name = note.name().string();
        if (name.starts_with(note_prefix)) notes.emplace_back(name.substr(note_prefix.size()), note.get_string());
    }
    Image image(spec.width, spec.height, spec.nchannels, spec.format == OIIO::TypeDesc::UINT8 ? 8 : 32);
    const auto read = [&](const OIIO::TypeDesc& type, void* into) {
        if (input->read_image(0, 0, 0, spec.nchannels, type, into)) return;
        const std::string reason = input->geterror();
        throw damaged(reason);
    };
    if (image.bits == 8) {
        // Divided here, because OpenImageIO multiplies by 1 / 255, which is wrong in the last bit.
        std::vector<uint8_t> stored(image.values.size());
        read(OIIO::TypeDesc::UINT8, stored.data());
        std::transform(stored.begin(), stored.end(), image.values.begin(), [](auto v) { return float(v) / 255; });
    } else {
        read(OIIO::TypeDesc::FLOAT, image.values.data());
    }
    return image;
}
