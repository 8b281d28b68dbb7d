#include "framework/staff/measure/peers.h"

#include <fmt/format.h>

#include "framework/core/base/module.h"
#include "framework/core/base/paths.h"

namespace relief::measure {
namespace {

constexpr const char* module_file = "relief-peers.so";

const Module& module() {
    static const Module opened = open_own_module(module_file, "libassimp-dev and libembree-dev");
    return opened;
}

}  // namespace

bool has_peers() { return std::filesystem::exists(executable_folder() / module_file); }

std::string obj_text(const Mesh& mesh) {
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    for (const Vertex& v : mesh.vertices) {
        fmt::format_to(out, "v {} {} {}\n", v.position.x, v.position.y, v.position.z);
        fmt::format_to(out, "vt {} {}\n", v.uv.x, v.uv.y);
        fmt::format_to(out, "vn {} {} {}\n", v.normal.x, v.normal.y, v.normal.z);
    }
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        fmt::format_to(out, "{}{}/{}/{}{}", i % 3 == 0 ? "f " : " ", mesh.indices[i] + 1, mesh.indices[i] + 1,
                       mesh.indices[i] + 1, i % 3 == 2 ? "\n" : "");
    return fmt::to_string(text);
}

std::unique_ptr<PeerTangents> assimp_tangents(const Mesh& mesh) {
    return module().function<AssimpTangents>("relief_assimp_tangents")(mesh);
}

std::unique_ptr<PeerHits> embree_hits(const Mesh& mesh, bool robust, bool any_machine) {
    return module().function<EmbreeHits>("relief_embree_hits")(mesh, robust, any_machine);
}

void assimp_model(const std::filesystem::path& path) { module().function<AssimpModel>("relief_assimp_model")(path); }

void openimageio_pixels(const std::filesystem::path& path) {
    module().function<OpenImageIOPixels>("relief_openimageio_pixels")(path);
}

Image openimageio_slopes(const Image& heights) {
    Image slopes;
    module().function<OpenImageIOSlopes>("relief_openimageio_slopes")(heights, slopes);
    return slopes;
}

}  // namespace relief::measure
