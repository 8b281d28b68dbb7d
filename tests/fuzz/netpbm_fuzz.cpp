// Arbitrary bytes of PPM, PGM and PFM.
#include "framework/core/image/netpbm.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) { relief::decode_netpbm(text); });
}
