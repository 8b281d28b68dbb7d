// The checks in front of OpenImageIO: format by content, size, channels, memory.
#include "framework/core/image/file.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) {
        relief::Notes notes;
        const relief::Image image = relief::decode_image(text, &notes);
        const bool allowed = image.width >= 1 && image.height >= 1 && image.width <= relief::max_image_side &&
                             image.height <= relief::max_image_side && image.channels >= 1 && image.channels <= 4 &&
                             image.values.size() == image.pixel_count() * size_t(image.channels);
        if (!allowed) __builtin_trap();
    });
}
