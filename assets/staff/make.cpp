// Writes the course's own textures and models into a folder: relief-assets FOLDER
#include <cstdio>
#include <filesystem>

#include "assets/garden.h"
#include "assets/staff/rope.h"
#include "assets/staff/textures.h"
#include "assets/urn.h"
#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/image/file.h"
#include "framework/staff/reference/gltf_files.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: relief-assets FOLDER\n");
        return 2;
    }
    try {
        for (const char* surface : {"bricks", "paving", "marble", "quilt", "garden", "rope"})
            for (const relief::NamedTexture& texture : relief::make_textures(surface)) {
                const std::filesystem::path file = std::filesystem::path(argv[1]) / texture.file;
                relief::write_image(file, texture.image, {}, texture.space);
                std::puts(file.c_str());
            }
        auto models = relief::make_garden();
        models.emplace_back("urn.obj", relief::make_urn());
        const auto rope = relief::gltf_files(relief::make_coarse_rope(), "rope", "rope_normal.png");
        models.emplace_back("rope.gltf", rope.json);
        models.emplace_back("rope.bin", rope.buffer);
        for (const auto& [name, text] : models) {
            const std::filesystem::path file = std::filesystem::path(argv[1]) / name;
            relief::write_file(file, text);
            std::puts(file.c_str());
        }
    } catch (const relief::Error& error) {
        std::fprintf(stderr, "relief-assets: %s\n", error.what());
        return 1;
    }
}
