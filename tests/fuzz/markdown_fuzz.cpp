// Arbitrary handouts. All rows of a table have the same number of cells, and no list is nested deeper than the text's
// length.
#include "framework/course/pages/markdown.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [&](const std::string& text) {
        for (const relief::pages::Block& block : relief::pages::parse_markdown(text)) {
            if (block.level < 0 || size_t(block.level) > count) __builtin_trap();
            for (const auto& row : block.rows)
                if (row.empty() || row.size() != block.rows.front().size()) __builtin_trap();
        }
    });
}
