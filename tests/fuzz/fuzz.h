// The frame of every fuzz target: an Error is a valid result; any other exception of a parser is a crash.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "framework/core/base/error.h"

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
