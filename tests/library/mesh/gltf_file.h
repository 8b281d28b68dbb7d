// glTF files for tests: a mesh as JSON and bytes, which a test can change before it writes them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "framework/core/base/mesh.h"

namespace relief {

struct GltfFile {
    nlohmann::json json;
    std::string bytes;  ///< of the only buffer

    /// Adds bytes to the buffer, as a buffer view. Returns its number.
    size_t add_view(std::string_view data) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}});
        bytes += data;
        return json["bufferViews"].size() - 1;
    }

    template <class Number>
    size_t add_accessor(const std::vector<Number>& numbers, const char* type, size_t components, int component_type) {
        const size_t view = add_view({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)});
        json["accessors"].push_back({{"bufferView", view},
                                     {"componentType", component_type},
                                     {"count", numbers.size() / components},
                                     {"type", type}});
        return json["accessors"].size() - 1;
    }

    std::string glb() const {
        const auto padded = [](std::string text, char with) {
            text.resize((text.size() + 3) / 4 * 4, with);
            return text;
        };
        const auto number = [](size_t value) {
            std::string four;
            for (int i = 0; i < 4; ++i) four += char(value >> 8 * i);
            return four;
        };
        nlohmann::json sized = json;
        const std::string data = padded(bytes, '\0');
        if (!sized["buffers"][0].contains("byteLength")) sized["buffers"][0]["byteLength"] = data.size();
        const std::string text = padded(sized.dump(), ' ');
        return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + data.size()) + number(text.size()) + "JSON" +
               text + number(data.size()) + std::string("BIN\0", 4) + data;
    }

    /// As text, with the bytes in it, or in a file of this name.
    std::string gltf(const std::string& file = "") const {
        nlohmann::json all = json;
        all["buffers"] = {{{"byteLength", bytes.size()},
                           {"uri", file.empty() ? "data:application/octet-stream;base64," + base64() : file}}};
        return all.dump();
    }

    std::string base64() const {
        constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (size_t i = 0; i < bytes.size(); i += 3) {
            uint32_t three = 0;
            for (size_t k = 0; k < 3; ++k)
                three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
            for (size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
        }
        return text;
    }
};

/// Returns the file of a mesh with all of its attributes. glTF's v grows downwards. A picture's file becomes its normal
/// map.
inline GltfFile gltf_of(const Mesh& mesh, const std::string& normal_map = "") {
    constexpr int floats = 5126, whole = 5125;
    std::vector<float> positions, normals, tangents, uvs;
    for (const auto& [position, normal, tangent, uv] : mesh.vertices) {
        positions.insert(positions.end(), {position.x, position.y, position.z});
        normals.insert(normals.end(), {normal.x, normal.y, normal.z});
        tangents.insert(tangents.end(), {tangent.x, tangent.y, tangent.z, tangent.w});
        uvs.insert(uvs.end(), {uv.x, 1 - uv.y});
    }
    GltfFile file;
    file.json = {{"asset", {{"version", "2.0"}}},
                 {"scene", 0},
                 {"scenes", {{{"nodes", {0}}}}},
                 {"nodes", {{{"mesh", 0}}}},
                 {"buffers", {nlohmann::json::object()}}};
    nlohmann::json primitive;
    primitive["attributes"] = {{"POSITION", file.add_accessor(positions, "VEC3", 3, floats)},
                               {"NORMAL", file.add_accessor(normals, "VEC3", 3, floats)},
                               {"TANGENT", file.add_accessor(tangents, "VEC4", 4, floats)},
                               {"TEXCOORD_0", file.add_accessor(uvs, "VEC2", 2, floats)}};
    primitive["indices"] = file.add_accessor(mesh.indices, "SCALAR", 1, whole);
    if (!normal_map.empty()) {
        primitive["material"] = 0;
        file.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
        file.json["textures"] = {{{"source", 0}}};
        file.json["images"] = {{{"bufferView", file.add_view(normal_map)}, {"mimeType", "image/png"}}};
    }
    file.json["meshes"] = {{{"primitives", {primitive}}}};
    return file;
}

}  // namespace relief
