// lab.toml, whatever it says.
#include "framework/lab/manifest.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) { relief::parse_manifest(text, "lab.toml"); });
}
