#include "framework/staff/reference/gltf_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/core/base/error.h"

namespace relief {
namespace {

template <class Value>
void append_bytes(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

GltfFiles gltf_files(const Mesh& mesh, const std::string& name, const std::string& map_file) {
    if (mesh.vertices.empty() || mesh.vertices.size() > 65535)
        throw Error(fmt::format("{}: {} vertices; a glTF file with indices of 16 bits has 1 to 65,535", name,
                                mesh.vertices.size()));
    using nlohmann::json;
    GltfFiles files;
    json views = json::array(), accessors = json::array();
    const size_t count = mesh.vertices.size();
    const auto add = [&](const char* type, size_t items, int component, int target, const auto& write) {
        const size_t begin = files.buffer.size();
        write(files.buffer);
        views.push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", files.buffer.size() - begin}, {"target", target}});
        accessors.push_back(
            {{"bufferView", views.size() - 1}, {"componentType", component}, {"count", items}, {"type", type}});
    };
    constexpr int floats = 5126, shorts = 5123, vertices = 34962, indices = 34963;  // numeric values of GL's enums
    const auto each = [&](const auto& value) {
        return [&, value](std::string& bytes) {
            for (const Vertex& vertex : mesh.vertices) append_bytes(bytes, value(vertex));
        };
    };
    add("VEC3", count, floats, vertices, each([](const Vertex& vertex) { return vertex.position; }));
    glm::vec3 low = mesh.vertices.at(0).position, high = low;
    for (const Vertex& vertex : mesh.vertices)
        low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
    accessors.back()["min"] = {low.x, low.y, low.z};
    accessors.back()["max"] = {high.x, high.y, high.z};
    add("VEC3", count, floats, vertices, each([](const Vertex& vertex) { return vertex.normal; }));
    add("VEC4", count, floats, vertices, each([](const Vertex& vertex) { return vertex.tangent; }));
    // glTF's v grows down; its tangents keep their sign.
    add("VEC2", count, floats, vertices,
        each([](const Vertex& vertex) { return glm::vec2(vertex.uv.x, 1 - vertex.uv.y); }));
    add("SCALAR", mesh.indices.size(), shorts, indices, [&](std::string& bytes) {
        for (const uint32_t index : mesh.indices) append_bytes(bytes, uint16_t(index));
    });
    const json attributes = {{"POSITION", 0}, {"NORMAL", 1}, {"TANGENT", 2}, {"TEXCOORD_0", 3}};
    const json material = {{"name", "flat"},
                           {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.5}}},
                           {"normalTexture", {{"index", 0}}}};
    const json primitive = {{"attributes", attributes}, {"indices", 4}, {"material", 0}};
    const json all = {{"asset", {{"version", "2.0"}, {"generator", "Relief"}}},
                      {"scene", 0},
                      {"scenes", {{{"nodes", {0}}}}},
                      {"nodes", {{{"mesh", 0}, {"name", name}}}},
                      {"meshes", {{{"name", name}, {"primitives", {primitive}}}}},
                      {"materials", {material}},
                      {"textures", {{{"source", 0}, {"sampler", 0}}}},
                      {"samplers", {{{"magFilter", 9729}, {"minFilter", 9729}, {"wrapS", 33071}, {"wrapT", 33071}}}},
                      {"images", {{{"uri", map_file}}}},
                      {"buffers", {{{"uri", name + ".bin"}, {"byteLength", files.buffer.size()}}}},
                      {"bufferViews", views},
                      {"accessors", accessors}};
    files.json = all.dump(1) + "\n";
    return files;
}

}  // namespace relief
