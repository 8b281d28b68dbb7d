// Arbitrary formulas of handouts. Every formula that parses can be displayed.
#include "framework/course/pages/formula.h"
#include "tests/fuzz/fuzz.h"

namespace {

void hold(const relief::pages::Formula& part) {
    using Kind = relief::pages::Formula::Kind;
    const bool has_parts = part.kind == Kind::row || part.kind == Kind::matrix;
    const size_t wanted = part.kind == Kind::fraction                             ? 2
                          : part.kind == Kind::scripts                            ? 3
                          : part.kind == Kind::root || part.kind == Kind::bracket ? 1
                                                                                  : 0;
    if (!has_parts && part.parts.size() != wanted) __builtin_trap();
    for (const relief::pages::Formula& each : part.parts) hold(each);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [&](const std::string& text) {
        for (const auto& line : relief::pages::formula_lines(text))
            for (const relief::pages::FormulaCell& cell : line) hold(cell.formula);
    });
}
