// What every fuzz target does: an Error is an answer, anything else that leaves a parser is a crash.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "framework/base/error.h"

namespace relief {

template <class Parse>
int fuzz(const uint8_t* bytes, size_t count, Parse parse) {
    try {
        parse(std::string(reinterpret_cast<const char*>(bytes), count));
    } catch (const Error&) {
    }
    return 0;
}

}  // namespace relief
