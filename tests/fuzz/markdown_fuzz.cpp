// Handouts, whatever is in them: no table's rows differ in length, and no list is deeper than its text.
#include "framework/base/markdown.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [&](const std::string& text) {
        for (const relief::Block& block : relief::parse_markdown(text)) {
            if (block.level < 0 || size_t(block.level) > count) __builtin_trap();
            for (const auto& row : block.rows)
                if (row.empty() || row.size() != block.rows.front().size()) __builtin_trap();
        }
    });
}
