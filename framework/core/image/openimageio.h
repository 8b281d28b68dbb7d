// The function of the module that holds OpenImageIO. framework/core/image/file.cpp opens it at first use.
#pragma once

#include <string>

#include "framework/core/image/file.h"

namespace relief {

/// Throws Error without a place, which the caller adds. `format` is OpenImageIO's name: "openexr" or "jpeg".
using DecodeImage = Image(const std::string& bytes, const char* format, Notes& notes);

}  // namespace relief

extern "C" {
relief::DecodeImage relief_decode_image;
}
