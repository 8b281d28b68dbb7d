#include "framework/staff/measure/peers.h"

#include "framework/core/base/module.h"
#include "framework/core/base/paths.h"

namespace relief::measure {
namespace {

constexpr const char* file = "relief-peers.so";

const Module& module() {
    static const Module opened = open_own_module(file, "libassimp-dev and libembree-dev");
    return opened;
}

}  // namespace

bool has_peers() { return std::filesystem::exists(executable_folder() / file); }

std::unique_ptr<PeerTangents> assimp_tangents(const Mesh& mesh) {
    return module().function<AssimpTangents>("relief_assimp_tangents")(mesh);
}

std::unique_ptr<PeerHits> embree_hits(const Mesh& mesh, bool robust, bool any_machine) {
    return module().function<EmbreeHits>("relief_embree_hits")(mesh, robust, any_machine);
}

Image openimageio_slopes(const Image& heights) {
    Image slopes;
    module().function<OpenImageIOSlopes>("relief_openimageio_slopes")(heights, slopes);
    return slopes;
}

}  // namespace relief::measure
