// relief-textures PICTURE FILE: makes the file that asset.h reads. The build calls it for each picture. A picture that
// cannot be read gives an empty file and no error, so that the problem shows only when the picture is used.
#include <cstdio>
#include <filesystem>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/log.h"
#include "framework/core/image/asset.h"
#include "framework/core/image/file.h"

int main(int argc, char** argv) {
    using namespace relief;
    if (argc != 3) {
        std::fprintf(stderr, "usage: relief-textures PICTURE FILE\n");
        return 2;
    }
    std::string converted;
    try {
        const std::filesystem::path from = argv[1];
        converted = convert_asset(from.filename(), read_file(from, max_image_bytes));
    } catch (const Error& error) {
        print_note(Error({argv[1]}, error.what()).what());
    }
    try {
        write_file(argv[2], converted);
    } catch (const Error& error) {
        print_error(error.what());
        return 1;
    }
}
