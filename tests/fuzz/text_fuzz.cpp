// Numbers and words as a user types them.
#include "framework/core/base/text.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count > 300 ? 300 : count, [](const std::string& text) {
        if (const auto number = relief::parse_number(text); number && !relief::parse_number(relief::plain(*number)))
            __builtin_trap();
        relief::parse_int(text);
        const std::vector<std::string> known = {"steps", "scale", text.substr(0, text.size() / 2)};
        relief::unknown("knob", text, known);
        relief::nearest(text, known);
    });
}
