#include "framework/staff/synctest/files.h"

#include <fmt/format.h>

#include <cmath>

#include "framework/core/base/file.h"
#include "framework/core/base/text.h"
#include "framework/core/image/file.h"
#include "framework/staff/reference/gltf_files.h"
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
