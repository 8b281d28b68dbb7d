// glTF models as tools write them: the resulting mesh, and one line for each kind of damage.
#include "framework/library/mesh/gltf.h"

#include "framework/library/mesh/shapes.h"
#include "tests/library/mesh/gltf_file.h"
#include "tests/support.h"

namespace relief {
namespace {

/// A triangle of 3 x 2 at z = 1, with mirrored uv.
Mesh mirrored_triangle() {
    const glm::vec4 tangent(-1, 0, 0, -1);
    return {{{{0, 0, 1}, {0, 0, 1}, tangent, {1, 0}},
             {{3, 0, 1}, {0, 0, 1}, tangent, {0.25f, 0}},
             {{0, 2, 1}, {0, 0, 1}, tangent, {1, 0.75f}}},
            {0, 1, 2}};
}

class Gltf : public testing::Test {
protected:
    TemporaryFolder folder_;

    GltfModel read(const GltfFile& file, const ObjLimits& limits = {}) const {
        return read_gltf(folder_.write("model.glb", file.glb()), limits);
    }
    /// Returns the message about a file without the folder, and checks that it is one line.
    std::string refusal(const std::string& name, const std::string& bytes, const ObjLimits& limits = {}) const {
        const std::filesystem::path path = folder_.write(name, bytes);
        const std::string message = message_of([&] { read_gltf(path, limits); });
        EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_LT(message.size(), path.string().size() + 250) << message;
        return message.substr(std::min(message.size(), path.string().size() + 2));
    }
    std::string refusal(const GltfFile& file, const ObjLimits& limits = {}) const {
        return refusal("model.glb", file.glb(), limits);
    }
};

TEST_F(Gltf, AMeshComesBackFromEachFormWithItsTangentsAndUv) {
    const Mesh mesh = make_sphere({.sides = 7, .rows = 5});
    const GltfFile file = gltf_of(mesh);
    folder_.write("the bytes.bin", file.bytes);
    for (const std::filesystem::path& path : {folder_.write("a.glb", file.glb()), folder_.write("b.gltf", file.gltf()),
                                              folder_.write("c.GLTF", file.gltf("the%20bytes.bin"))}) {
        const GltfModel read = read_gltf(path);
        EXPECT_TRUE(read.has_uvs && read.has_tangents && read.normal_maps.empty() && read.notes.empty()) << path;
        EXPECT_EQ(read.mesh.indices, mesh.indices);
        ASSERT_EQ(read.mesh.vertices.size(), mesh.vertices.size());
        for (size_t i = 0; i < mesh.vertices.size(); ++i) {
            const Vertex &wanted = mesh.vertices[i], &found = read.mesh.vertices[i];
            EXPECT_EQ(found.position, wanted.position);
            EXPECT_LT(glm::distance(found.normal, wanted.normal), 1e-6f);
            EXPECT_LT(glm::distance(found.tangent, wanted.tangent), 1e-6f);
            EXPECT_LT(glm::distance(found.uv, wanted.uv), 1e-6f) << "1 - (1 - v) is rounded";
        }
    }
}

TEST_F(Gltf, NodesMoveTurnAndScaleAndMirroringOnesKeepTheOutside) {
    GltfFile file = gltf_of(mirrored_triangle());
    // The parent moves, its child turns by 90 degrees about z and scales x by -2.
    file.json["nodes"] = {{{"children", {1}}, {"translation", {10, 20, 30}}},
                          {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}, {"scale", {-2, 1, 1}}}};
    const GltfModel model = read(file);
    // (x, y, z) becomes (-y, -2 x, z), and then moves.
    const auto place = [&](size_t i) { return glm::dvec3(model.mesh.vertices[i].position) + model.centre; };
    EXPECT_LT(glm::distance(place(1), {10, 14, 31}), 1e-5);
    EXPECT_LT(glm::distance(place(2), {8, 20, 31}), 1e-5);
    EXPECT_EQ(model.mesh.indices, (std::vector<uint32_t>{0, 2, 1}));
    for (const Vertex& vertex : model.mesh.vertices) {
        EXPECT_LT(glm::distance(vertex.normal, {0, 0, 1}), 1e-6f);
        // dP/du was along -x, and dP/dv along y.
        EXPECT_LT(glm::distance(vertex.tangent, {0, 1, 0, 1}), 1e-6f);
        EXPECT_LT(glm::distance(vertex.tangent.w * glm::cross(vertex.normal, glm::vec3(vertex.tangent)), {-1, 0, 0}),
                  1e-6f);
    }
    file.json["nodes"] = {{{"mesh", 0}, {"matrix", {-2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}}};
    EXPECT_LT(glm::distance(read(file).mesh.vertices[1].position, {-1, 0, 1}), 1e-6f) << "by columns";
}

TEST_F(Gltf, AllPrimitivesAndInstancesBecomeOneMeshAndPointsAreIgnored) {
    GltfFile file = gltf_of(mirrored_triangle());
    nlohmann::json& primitives = file.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]), primitives.push_back(primitives[0]);
    primitives[1].erase("indices"), primitives[2]["mode"] = 0;
    file.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 1}}});
    EXPECT_EQ(read(file).mesh.indices.size(), 6u) << "node 1 is in no scene";
    file.json.erase("scenes"), file.json.erase("scene");
    const GltfModel all = read(file);
    EXPECT_EQ(all.mesh.indices, (std::vector<uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
    EXPECT_EQ(all.mesh.vertices[6].position.z, 2);
}

TEST_F(Gltf, MissingAttributesAreThoseOfTrianglesAndSaid) {
    GltfFile file = gltf_of(mirrored_triangle());
    nlohmann::json& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
    attributes.erase("TEXCOORD_0");
    EXPECT_FALSE(read(file).has_uvs);
    attributes.erase("NORMAL");
    const GltfModel flat = read(file);
    EXPECT_FALSE(flat.has_tangents) << "glTF ignores tangents without normals";
    for (const Vertex& vertex : flat.mesh.vertices) {
        EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
        EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 1e-6);
    }
    GltfFile zero = gltf_of({{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0, 1}, {0, 0}},
                              {{0, 1, 0}, {0, 0, 0}, {0, 0, 0, 1}, {0, 0}},
                              {{0, 0, 1}, {0, 0, 0}, {0, 0, 0, 1}, {0, 0}}},
                             {0, 1, 2}});
    for (const Vertex& vertex : read(zero).mesh.vertices) {
        EXPECT_EQ(vertex.normal, glm::vec3(1, 0, 0));
        EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 1e-6);
    }
}

TEST_F(Gltf, SmallNumbersAndStridesAreRead) {
    GltfFile file = gltf_of(mirrored_triangle());
    nlohmann::json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["indices"] = file.add_accessor<uint8_t>({2, 0, 1}, "SCALAR", 1, 5121);
    const size_t uv =
        file.add_accessor<uint16_t>({0, 65535, 9, 9, 65535, 0, 9, 9, 13107, 26214, 9, 9}, "VEC2", 2, 5123);
    file.json["accessors"][uv]["normalized"] = true, file.json["accessors"][uv]["count"] = 3;
    file.json["bufferViews"].back()["byteStride"] = 8;
    primitive["attributes"]["TEXCOORD_0"] = uv;
    const Mesh mesh = read(file).mesh;
    EXPECT_EQ(mesh.indices, (std::vector<uint32_t>{2, 0, 1}));
    EXPECT_EQ(mesh.vertices[0].uv, glm::vec2(0, 0));
    EXPECT_EQ(mesh.vertices[1].uv, glm::vec2(1, 1));
    EXPECT_LT(glm::distance(mesh.vertices[2].uv, {0.2f, 0.6f}), 1e-6f);
}

TEST_F(Gltf, TheNormalMapIsReadFromTheBufferTheTextOrAFile) {
    GltfFile file = gltf_of(mirrored_triangle(), "a picture");
    file.json["materials"][0]["normalTexture"]["scale"] = 0.5;
    const GltfModel inside = read(file);
    ASSERT_EQ(inside.normal_maps.size(), 1u);
    EXPECT_EQ(inside.normal_maps[0].picture, "a picture");
    EXPECT_EQ(inside.normal_maps[0].scale, 0.5);
    file.json["images"] = {{{"uri", "data:image/png;base64,YSBwaWN0dXJl"}}};
    EXPECT_EQ(read(file).normal_maps.at(0).picture, "a picture");
    file.json["images"] = {{{"uri", "a%20map.png"}}};
    EXPECT_NE(refusal(file).find("a map.png"), std::string::npos);
    folder_.write("a map.png", "another picture");
    EXPECT_EQ(read(file).normal_maps.at(0).picture, "another picture");
    // Its uv are those that the map names.
    const size_t uv = file.add_accessor<float>({0, 0, 0.5f, 0, 0, 0.5f}, "VEC2", 2, 5126);
    file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = uv;
    file.json["materials"][0]["normalTexture"]["texCoord"] = 1;
    EXPECT_EQ(read(file).mesh.vertices[1].uv, glm::vec2(0.5f, 1));
}

TEST_F(Gltf, AnUnusedPictureMayBeMissing) {
    GltfFile file = gltf_of(mirrored_triangle());
    file.json["images"] = {{{"uri", "missing.png"}}};
    EXPECT_EQ(read(file).mesh.indices.size(), 3u);
}

TEST_F(Gltf, DamagedFilesAreRefusedWithOneLineThatNamesTheFault) {
    const GltfFile good = gltf_of(mirrored_triangle(), "a picture");
    const std::string glb = good.glb(), gltf = good.gltf();
    for (size_t size = 0; size < glb.size(); size += 7) refusal("short.glb", glb.substr(0, size));
    for (size_t size = 0; size < gltf.size(); size += 31) refusal("short.gltf", gltf.substr(0, size));
    std::string text = gltf;
    text[text.find("base64,") + 30] = '!';
    EXPECT_TRUE(contains(refusal("base64.gltf", text), "damaged: the base64 of buffer 0 has a character that is none"));
    EXPECT_TRUE(contains(refusal("bin.gltf", good.gltf("missing.bin")), "missing.bin"));
    folder_.write("small.bin", "abc");
    EXPECT_TRUE(contains(refusal("small.gltf", good.gltf("small.bin")), "damaged: buffer 0 has 3 of its "));
    EXPECT_TRUE(contains(refusal("deep.gltf", R"({"asset":{"version":"2.0"},"extras":)" + std::string(1'000'000, '[')),
                         "damaged: its JSON is faulty"));
    EXPECT_TRUE(contains(refusal("obj.gltf", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "damaged: "));

    struct Case {
        std::function<void(nlohmann::json&)> change;
        const char* words;
    };
    const Case cases[] = {
        {[](auto& j) { j["asset"]["version"] = "1.0"; }, "is glTF 1.0: export glTF 2.0"},
        {[](auto& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "needs KHR_draco_mesh_compression, which is not read: export without it"},
        {[](auto& j) { j["scene"] = 7; }, "there is no scene 7"},
        {[](auto& j) { j["scenes"][0]["nodes"] = {5}; }, "there is no node 5, but 1 of them"},
        {[](auto& j) { j["nodes"][0]["children"] = {0}; }, "a node is its own ancestor"},
        {[](auto& j) {
             j["nodes"][0]["children"] = {1}, j["nodes"][1]["children"] = {2, 2}, j["nodes"][2]["name"] = "x";
         },
         "node 2 has two parents"},
        {[](auto& j) {
             j["scenes"][0]["nodes"] = {0, 0};
         },
         "node 0 is twice in its scene"},
        {[](auto& j) { j["nodes"][0]["mesh"] = 3; }, "there is no mesh 3"},
        {[](auto& j) {
             j["nodes"][0]["matrix"] = {1, 0, 0};
         },
         "\"matrix\" of node 0 has 3 numbers instead of 16"},
        {[](auto& j) { j["nodes"][0].erase("mesh"); }, "has no triangles in its scene"},
        {[](auto& j) { j["meshes"][0]["primitives"][0]["mode"] = 7; }, "glTF has no mode 7"},
        {[](auto& j) { j["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }, "it has no positions"},
        {[](auto& j) { j["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 99; }, "there is no accessor 99"},
        {[](auto& j) { j["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = -4; },
         "\"NORMAL\" of mesh 0, primitives 0, attributes is no index"},
        {[](auto& j) { j["meshes"][0]["primitives"][0]["indices"] = 0; }, "its elements are VEC3 instead of SCALAR"},
        {[](auto& j) { j["accessors"][4]["componentType"] = 5126; }, "its indices are no whole numbers"},
        {[](auto& j) { j["accessors"][4]["count"] = 2; }, "2 corners make no whole triangles"},
        {[](auto& j) { j["accessors"][0]["count"] = 4'000'000'000; },
         "4000000000 elements do not fit in their 36 bytes"},
        {[](auto& j) { j["accessors"][0]["count"] = ~uint64_t{0}; }, "\"count\" of accessor 0 is no whole number"},
        {[](auto& j) { j["accessors"][0]["byteOffset"] = 40; }, "do not fit in their 36 bytes"},
        {[](auto& j) { j["accessors"][1]["count"] = 2; }, "3 positions, but 2 of NORMAL"},
        {[](auto& j) {
             j["accessors"][0]["sparse"] = {
                 {"count", 1},
                 {"indices", {{"bufferView", 0}, {"componentType", 5125}, {"byteOffset", 12}}},
                 {"values", {{"bufferView", 0}}}};
         },
         "there is no element 1077936128, but 3 of them"},
        {[](auto& j) { j["accessors"][0].erase("bufferView"), j["accessors"][0]["count"] = 1e15; }, "too large"},
        {[](auto& j) { j["bufferViews"][0]["byteOffset"] = 1'000'000; }, "buffer view 0 ends behind its buffer"},
        {[](auto& j) { j["bufferViews"][0]["byteLength"] = ~uint64_t{0}; }, "is no whole number"},
        {[](auto& j) { j["bufferViews"][0]["buffer"] = 2; }, "there is no buffer 2"},
        {[](auto& j) { j["bufferViews"][0]["byteStride"] = 4; }, "its elements overlap"},
        {[](auto& j) { j["buffers"][0]["byteLength"] = 4'000'000'000; }, "damaged: buffer 0 has "},
        {[](auto& j) { j["textures"] = nlohmann::json::array(); }, "there is no texture 0"},
        {[](auto& j) { j["textures"][0].erase("source"); }, "its normal map is in a format that is not read"},
        {[](auto& j) { j["meshes"] = {5}; }, "damaged: mesh 0 is no object"}};
    for (const auto& [change, words] : cases) {
        GltfFile file = good;
        change(file.json);
        const std::string message = refusal(file);
        EXPECT_TRUE(contains(message, words)) << message << "\n  instead of: " << words;
    }
}

TEST_F(Gltf, IndicesBehindTheVerticesAndNumbersThatAreNotFiniteAreRefused) {
    Mesh mesh = mirrored_triangle();
    mesh.indices = {0, 1, 3};
    EXPECT_EQ(refusal(gltf_of(mesh)), "mesh 0, primitive 0: there is no vertex 3, but 3 of them");
    mesh = mirrored_triangle();
    mesh.vertices[2].position.y = NAN;
    EXPECT_EQ(refusal(gltf_of(mesh)), "mesh 0, primitive 0: vertex 2 has a number that is not finite");
    mesh = mirrored_triangle();
    mesh.vertices[1].uv.x = INFINITY;
    EXPECT_EQ(refusal(gltf_of(mesh)), "mesh 0, primitive 0: vertex 1 has a number that is not finite");
    GltfFile far = gltf_of(mirrored_triangle());
    far.json["nodes"][0]["scale"] = {1e300, 1, 1};
    EXPECT_TRUE(contains(refusal(far), " has a number that is not finite"));
}

TEST_F(Gltf, LimitsHoldForTheFileAndForAllInstancesTogether) {
    GltfFile file = gltf_of(mirrored_triangle());
    EXPECT_TRUE(contains(refusal(file, {.bytes = 500}), "the limit is 500"));
    EXPECT_EQ(read(file, {.corners = 3}).mesh.indices.size(), 3u);
    for (int i = 1; i < 4; ++i) {
        file.json["nodes"].push_back({{"mesh", 0}});
        file.json["scenes"][0]["nodes"].push_back(i);
    }
    EXPECT_EQ(read(file, {.corners = 12}).mesh.indices.size(), 12u);
    EXPECT_EQ(refusal(file, {.corners = 11}), "too large: more than 11 corners or vertices");
}

}  // namespace
}  // namespace relief
