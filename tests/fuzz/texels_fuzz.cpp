// Arbitrary bytes of converted pictures. All levels of an accepted chain can be read.
#include "framework/core/image/texels.h"

#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) {
        const auto chain = relief::decode_texels(text, 77, {});
        if (!chain) return;
        relief::unpack(*chain);
        relief::encode_texels(*chain, 77);
    });
}
