// Files of one's own by size: the time and the memory to read them, in steps of two, beside other libraries.
#include <fmt/format.h>

#include <cmath>

#include "framework/core/base/file.h"
#include "framework/core/image/file.h"
#include "framework/library/maps/bounds.h"
#include "framework/library/maps/test_maps.h"
#include "framework/library/mesh/obj.h"
#include "framework/staff/grade/stage.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/memory.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/tangents_topic.h"

namespace relief::measure {
namespace {

namespace fs = std::filesystem;
using Folder = std::shared_ptr<grade::PublicFolder>;

/// A method that does one thing with `items` items, and whose work is the memory that it takes.
BenchSubject subject_of(size_t items, std::function<void()> run) {
    run();  // loads the libraries that it needs
    return {.items = items, .work = {{"MiB", std::round(double(peak_growth(run)) / (1 << 20))}}, .run = std::move(run)};
}

/// The scene of a file. `make` writes it, once for all methods; the others read it.
struct File {
    size_t items;
    fs::path path;
    std::function<void(const fs::path&)> make;

    BenchSubject read_by(const Folder& folder, const std::function<void(const fs::path&)>& read) const {
        if (!fs::exists(path)) make(path);
        return subject_of(items, [folder, read, path = path] { read(path); });
    }
};

BenchScene reading(const std::string& what, const std::string& size, const std::string& item, const Folder& folder,
                   const File& file, const std::function<void(const fs::path&)>& own, const std::string& peer,
                   const std::function<void(const fs::path&)>& read_by_peer) {
    BenchScene scene{{{"read", what}, {"size", size}}, item};
    scene.methods.push_back({"relief", {}, [=] { return file.read_by(folder, own); }});
    if (has_peers()) scene.methods.push_back({peer, {}, [=] { return file.read_by(folder, read_by_peer); }, true});
    return scene;
}

/// Writes the bench's torus as a model with positions, uv and normals.
void write_model(const fs::path& path, int columns, int rows) {
    write_file(path, obj_text(bench_torus(columns, rows)));
}

std::vector<BenchScene> scale_scenes(const BenchSettings& settings) {
    const auto folder = std::make_shared<grade::PublicFolder>(fs::temp_directory_path(), "relief-scale");
    std::vector<BenchScene> scenes;
    for (const int times : {1, 2, 4}) {  // the largest has 8192 x 8192 texels
        const int side = settings.quick ? 512 : 4096, width = times > 1 ? 2 * side : side,
                  height = times > 2 ? 2 * side : side;
        const std::string size = fmt::format("{}x{}", width, height);
        scenes.push_back(reading(
            "png", size, "texel", folder,
            {.items = size_t(width) * size_t(height),
             .path = folder->path() / (size + ".png"),
             .make =
                 [=](const fs::path& path) {
                     const Image tile = make_height_map(HeightMap::rock, 512);
                     Image image(width, height, 3);
                     for (int y = 0; y < height; ++y)
                         for (int x = 0; x < width; ++x)
                             for (int c = 0; c < 3; ++c)
                                 image.pixel(x, y)[c] = *tile.pixel((x + 171 * c) % 512, (y + x / 512 * 97) % 512);
                     write_image(path, image);
                 }},
            [](const fs::path& path) { read_image(path); }, "OpenImageIO",
            [](const fs::path& path) { openimageio_pixels(path); }));
    }
    for (const int times : {1, 2, 4}) {  // the largest has 300,000 triangles
        const int columns = times * (settings.quick ? 50 : 250), rows = 150;
        const size_t triangles = size_t(2) * size_t(columns) * size_t(rows);
        const std::string size = std::to_string(triangles);
        scenes.push_back(reading(
            "obj", size, "triangle", folder,
            {.items = triangles,
             .path = folder->path() / (size + ".obj"),
             .make = [=](const fs::path& path) { write_model(path, columns, rows); }},
            [](const fs::path& path) { read_obj(path); }, "Assimp", [](const fs::path& path) { assimp_model(path); }));
    }
    for (const int times : {1, 2, 4}) {
        const int side = times * (settings.quick ? 256 : 1024);
        BenchScene& scene =
            scenes.emplace_back(BenchScene{{{"read", "bounds"}, {"size", fmt::format("{}x{}", side, side)}}, "texel"});
        scene.methods.push_back({"relief", {}, [=] {
                                     const auto heights =
                                         std::make_shared<Image>(make_height_map(HeightMap::fbm, side));
                                     return subject_of(heights->pixel_count(), [heights] { min_max_mips(*heights); });
                                 }});
    }
    return scenes;
}

}  // namespace

const TopicRegistration scale_topic(
    {.name = "scale",
     .help =
         "files of one's own by size: PNG to 8192 x 8192, OBJ to 300,000 triangles, bounds of heights; time, memory",
     .question = "How large may a file of one's own be, and what does it cost?",
     .scenes = scale_scenes,
     .only_time = true});

}  // namespace relief::measure
