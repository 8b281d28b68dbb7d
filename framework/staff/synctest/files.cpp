#include "framework/staff/synctest/files.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/staff/synctest/cube.h"

namespace relief::synctest {
namespace {

constexpr int map_side = 512, picture_side = 512;

/// Returns the picture of a renderer that uses the map's frame.
Image expected_picture() {
    const Image normals = render_synctest({}, bake_synctest_map(map_side, 8), picture_side, picture_side);
    Image picture(picture_side, picture_side, 3, 8);
    for (size_t i = 0; i < normals.values.size(); ++i)
        picture.values[i] = std::isinf(normals.values[i]) ? 0 : 0.5f * normals.values[i] + 0.5f;
    return picture;
}

std::string readme() {
    const Camera camera(synctest_camera, 1);
    const glm::dvec3 eye = camera.eye();
    return fmt::format(R"(# Does a renderer read normal maps in the frame in which they were baked?

A cube of twelve triangles, whose normals are averaged at its corners, wears the normal map of a flat cube, baked by
MikkTSpace's rule: normal and tangent as interpolated, neither made unit, bitangent = w cross(normal, tangent) at the
pixel. A renderer of the same rule shows faces that are flat to 0.3 degrees. With another frame they bulge by 4 to 8.

| file | what |
|---|---|
| `cube.gltf`, `cube.bin` | the cube with tangents, glTF 2.0; its map is `cube_normal.png` |
| `cube.obj`, `cube.mtl` | the same without tangents: the engine makes them, by MikkTSpace |
| `cube_normal.png`, `cube_normal_16.png` | the map, 512 x 512 texels of 8 and of 16 bits; linear, green up |
| `expected.png` | the picture that a renderer of the same rule makes |

1. Import `cube.gltf` or `cube.obj` as it is: keep its normals and its triangles, do not weld, do not compress. The map is
   linear (not sRGB) and green-up.
2. Draw the normal of the shaded surface, in the space of the world or the object, as colour 0.5 n + 0.5: most engines
   have such a view of their G-buffer. No light, no tone mapping, no antialiasing, a black background. PNG or EXR.
3. Camera: at ({}, {}, {}), looking at the origin, y up, vertical field of view {} degrees, any size. (In
   an engine with another axis up, that is what the model has as y.) With another camera the picture is still judged for
   flatness, but the frame is not named.
4. `./relief synctest --judge PICTURE`
)",
                       rounded(eye.x, 5), rounded(eye.y, 5), rounded(eye.z, 5), synctest_camera.field_of_view);
}

template <class Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string synctest_obj(const Mesh& mesh, const std::string& material_file) {
    std::string text = fmt::format("mtllib {}\no cube\n", material_file);
    for (const Vertex& vertex : mesh.vertices)
        text +=
            fmt::format("v {} {} {}\nvt {} {}\nvn {} {} {}\n", vertex.position.x, vertex.position.y, vertex.position.z,
                        vertex.uv.x, vertex.uv.y, vertex.normal.x, vertex.normal.y, vertex.normal.z);
    text += "usemtl flat\n";
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        text += "f";
        for (size_t corner = 0; corner < 3; ++corner) text += fmt::format(" {0}/{0}/{0}", mesh.indices[i + corner] + 1);
        text += "\n";
    }
    return text;
}

GltfFiles gltf_files(const Mesh& mesh, const std::string& name, const std::string& map_file) {
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
            for (const Vertex& vertex : mesh.vertices) append(bytes, value(vertex));
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
        for (const uint32_t index : mesh.indices) append(bytes, uint16_t(index));
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

void write_synctest(const std::filesystem::path& folder) {
    make_folder(folder);
    const Mesh mesh = make_synctest_cube();
    const GltfFiles gltf = gltf_files(mesh, "cube", "cube_normal.png");
    write_file(folder / "cube.gltf", gltf.json);
    write_file(folder / "cube.bin", gltf.buffer);
    write_file(folder / "cube.obj", synctest_obj(mesh, "cube.mtl"));
    write_file(folder / "cube.mtl", "newmtl flat\nKd 0.8 0.8 0.8\nnorm cube_normal.png\n");
    write_image(folder / "cube_normal.png", bake_synctest_map(map_side, 8), {}, ColorSpace::linear);
    write_image(folder / "cube_normal_16.png", bake_synctest_map(map_side, 16), {}, ColorSpace::linear);
    write_image(folder / "expected.png", expected_picture(), {}, ColorSpace::linear);
    write_file(folder / "README.md", readme());
}

}  // namespace relief::synctest
