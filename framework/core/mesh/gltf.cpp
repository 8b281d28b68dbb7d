#include "framework/core/mesh/gltf.h"

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/module.h"
#include "framework/core/base/own_file.h"
#include "framework/core/mesh/tinygltf.h"

namespace relief {

bool reads_gltf() { return opens_own_modules(); }

GltfModel read_gltf(const std::filesystem::path& file, const ObjLimits& limits) {
    if (!reads_gltf())
        throw Error({file}, "this program reads no glTF: export the model as OBJ, or build the course on Linux");
    const std::string bytes = read_file(file, limits.bytes);
    static const Module module = open_own_module("relief-tinygltf.so", "libtinygltf-dev");
    try {
        return module.function<ParseGltf>("relief_parse_gltf")(bytes, file.parent_path(), limits);
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
}

bool is_named_as_gltf(const std::filesystem::path& file) {
    const std::string ending = lower_ending(file);
    return ending == ".gltf" || ending == ".glb";
}

}  // namespace relief
