// glTF models, as text and as .glb. A mesh that is read has indices in range, and unit normals and tangents.
#include "framework/library/mesh/gltf.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t count) {
    return relief::fuzz(bytes, count, [](const std::string& text) {
        const auto is_unit = [](const glm::vec3& v) { return std::abs(glm::length(v) - 1) < 0.01f; };
        const relief::GltfModel model = relief::parse_gltf(text, "/no/such/folder", {.corners = 10'000});
        for (const uint32_t index : model.mesh.indices)
            if (index >= model.mesh.vertices.size()) __builtin_trap();
        for (const relief::Vertex& vertex : model.mesh.vertices)
            if (!is_unit(vertex.normal) || !is_unit(glm::vec3(vertex.tangent))) __builtin_trap();
    });
}
