// Features of glTF 2.0 and of its extensions, with values from the specification, and the instructor's table of them.
#include <fmt/format.h>

#include "framework/library/mesh/gltf.h"
#include "tests/features.h"
#include "tests/library/mesh/gltf_file.h"
#include "tests/library/mesh/test_meshes.h"

namespace relief {
namespace {

using Json = nlohmann::json;
constexpr int bytes_type = 5120, unsigned_bytes = 5121, shorts = 5122, unsigned_shorts = 5123, unsigned_ints = 5125,
              floats_type = 5126;

/// Returns a fan of four triangles around (1, 1, 0), with u and v along x and y.
Mesh four_corners() {
    Mesh mesh;
    for (const glm::vec2 at : {glm::vec2(1, 1), glm::vec2(0, 0), glm::vec2(2, 0), glm::vec2(2, 2), glm::vec2(0, 2)})
        mesh.vertices.push_back({{at, 0}, {0, 0, 1}, {1, 0, 0, 1}, at / 4.0f});
    mesh.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
    return mesh;
}

Json& primitive_of(GltfFile& file, size_t index = 0) { return file.json["meshes"][0]["primitives"][index]; }

/// Returns the positions of a model's triangles in the file's coordinates.
std::vector<glm::dvec3> corner_positions(const GltfModel& model) {
    std::vector<glm::dvec3> positions;
    for (const uint32_t index : model.mesh.indices)
        positions.push_back(glm::dvec3(model.mesh.vertices[index].position) + model.centre);
    return positions;
}

/// Adds a skin with a joint for each node in `joints`.
void add_skin(GltfFile& file, const std::vector<int>& joints, const std::vector<float>& inverse_bind = {}) {
    file.json["skins"] = {{{"joints", joints}}};
    if (!inverse_bind.empty())
        file.json["skins"][0]["inverseBindMatrices"] = file.add_accessor(inverse_bind, "MAT4", 16, floats_type);
    file.json["nodes"][0]["skin"] = 0;
}
/// Gives all five vertices the same joints and weights.
void add_influence(GltfFile& file, std::array<uint8_t, 4> joints, glm::vec4 weights, int set = 0) {
    std::vector<uint8_t> all;
    std::vector<float> shares;
    for (int i = 0; i < 5; ++i)
        for (int k = 0; k < 4; ++k) all.push_back(joints[size_t(k)]), shares.push_back(weights[k]);
    Json& attributes = primitive_of(file)["attributes"];
    attributes["JOINTS_" + std::to_string(set)] = file.add_accessor(all, "VEC4", 4, unsigned_bytes);
    attributes["WEIGHTS_" + std::to_string(set)] = file.add_accessor(shares, "VEC4", 4, floats_type);
}

class GltfFeatures : public testing::Test {
protected:
    TemporaryFolder folder_;
    GltfFile file_ = gltf_of(four_corners());
    GltfFile mapped_ = gltf_of(four_corners(), "a picture");

    GltfModel read(const GltfFile& file) const { return parse_gltf(file.glb(), folder_.path()); }
    std::string refusal(const GltfFile& file) const {
        return message_of([&] { read(file); });
    }
    void expect_positions(const GltfFile& file, const std::function<glm::dvec3(glm::dvec3)>& moved,
                          double allowed = 1e-6) const {
        const std::vector<glm::dvec3> plain = corner_positions(read(gltf_of(four_corners()))),
                                      found = corner_positions(read(file));
        ASSERT_EQ(found.size(), plain.size());
        for (size_t i = 0; i < plain.size(); ++i)
            EXPECT_LT(glm::distance(found[i], moved(plain[i])), allowed) << "corner " << i;
    }
};

TEST_F(GltfFeatures, SparseAccessorsReplaceElementsOfTheirViewOrOfZeros) {
    const std::vector<float> lifted = {1, 1, 7, 0, 2, 8};
    const size_t values = file_.add_view({reinterpret_cast<const char*>(lifted.data()), 24});
    const auto sparse = [&](size_t view, int type) {
        return Json{{"count", 2},
                    {"indices", {{"bufferView", view}, {"componentType", type}}},
                    {"values", {{"bufferView", values}}}};
    };
    const auto lift = [](glm::dvec3 p) {
        const double z = p == glm::dvec3(1, 1, 0) ? 7 : p == glm::dvec3(0, 2, 0) ? 8 : 0;
        return glm::dvec3(p.x, p.y, z);
    };
    file_.json["accessors"][0]["sparse"] = sparse(file_.add_view(std::string("\0\4", 2)), unsigned_bytes);
    expect_positions(file_, lift);
    file_.json["accessors"][0]["sparse"] = sparse(file_.add_view(std::string("\0\0\4\0", 4)), unsigned_shorts);
    expect_positions(file_, lift);
    file_.json["accessors"][0]["sparse"] = sparse(file_.add_view(std::string("\0\0\0\0\4\0\0\0", 8)), unsigned_ints);
    expect_positions(file_, lift);
    file_.json["accessors"][0].erase("bufferView");
    expect_positions(file_, [&](glm::dvec3 p) { return lift(p).z > 0 ? lift(p) : glm::dvec3(0); });
    EXPECT_TRUE(read(file_).notes.empty());
}

TEST_F(GltfFeatures, AnAccessorWithoutAViewHasZeros) {
    file_.json["accessors"][3].erase("bufferView"), file_.json["accessors"][3].erase("byteOffset");
    const GltfModel model = read(file_);
    EXPECT_TRUE(model.has_uvs);
    for (const Vertex& vertex : model.mesh.vertices) EXPECT_EQ(vertex.uv, glm::vec2(0, 1)) << "1 - v";
}

TEST_F(GltfFeatures, StripsAndFansHaveTheTrianglesAndTheWindingOfTheSpecification) {
    // 3.7.2.1: strip p_i = {v_i, v_(i + 1 + i % 2), v_(i + 2 - i % 2)}; fan p_i = {v_(i + 1), v_(i + 2), v_0}.
    primitive_of(file_)["mode"] = 5;
    primitive_of(file_)["indices"] = file_.add_accessor<uint16_t>({1, 2, 0, 3, 4}, "SCALAR", 1, unsigned_shorts);
    EXPECT_EQ(read(file_).mesh.indices, (std::vector<uint32_t>{1, 2, 0, 2, 3, 0, 0, 3, 4}));
    primitive_of(file_)["indices"] = file_.add_accessor<uint16_t>({1, 2, 0, 0, 3, 3, 4}, "SCALAR", 1, unsigned_shorts);
    EXPECT_EQ(read(file_).mesh.indices, (std::vector<uint32_t>{1, 2, 0})) << "two equal corners join strips";
    primitive_of(file_)["mode"] = 6;
    primitive_of(file_)["indices"] = file_.add_accessor<uint8_t>({0, 1, 2, 3, 4, 1}, "SCALAR", 1, unsigned_bytes);
    EXPECT_EQ(read(file_).mesh.indices, (std::vector<uint32_t>{1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 0}));
    // All of them face +z, also when their normals are made from the winding.
    primitive_of(file_)["attributes"].erase("NORMAL");
    for (const Vertex& vertex : read(file_).mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
    primitive_of(file_).erase("indices");
    EXPECT_EQ(read(file_).mesh.indices.size(), 9u) << "five vertices in order";
    primitive_of(file_)["mode"] = 5;
    EXPECT_EQ(read(file_).mesh.indices.size(), 9u);
}

TEST_F(GltfFeatures, MorphTargetsAreAddedByTheWeightsOfTheNodeOrElseOfTheMesh) {
    const auto all = [&](glm::vec3 value) {
        std::vector<float> numbers;
        for (int i = 0; i < 5; ++i) numbers.insert(numbers.end(), {value.x, value.y, value.z});
        return file_.add_accessor(numbers, "VEC3", 3, floats_type);
    };
    primitive_of(file_)["targets"] = {{{"POSITION", all({0, 0, 4})}, {"NORMAL", all({1, 0, 0})}},
                                      {{"POSITION", all({8, 0, 0})}, {"TANGENT", all({0, 0, -1})}}};
    expect_positions(file_, [](glm::dvec3 p) { return p; });
    file_.json["meshes"][0]["weights"] = {1, 0};
    expect_positions(file_, [](glm::dvec3 p) { return p + glm::dvec3(0, 0, 4); });
    EXPECT_LT(glm::distance(read(file_).mesh.vertices[0].normal, glm::normalize(glm::vec3(1, 0, 1))), 1e-6f);
    file_.json["nodes"][0]["weights"] = {0.5, 1};
    expect_positions(file_, [](glm::dvec3 p) { return p + glm::dvec3(8, 0, 2); });
    const Vertex vertex = read(file_).mesh.vertices[0];
    EXPECT_LT(glm::distance(vertex.normal, glm::normalize(glm::vec3(0.5, 0, 1))), 1e-6f);
    EXPECT_LT(glm::distance(vertex.tangent, glm::vec4(glm::normalize(glm::vec3(1, 0, -1)), 1)), 1e-6f);
    EXPECT_TRUE(read(file_).notes.empty());
    // Quantised targets are normalised integers, with KHR_mesh_quantization.
    const size_t small = file_.add_accessor<int8_t>(
        {127, 0, 0, 9, 127, 0, 0, 9, 127, 0, 0, 9, 127, 0, 0, 9, 127, 0, 0, 9}, "VEC3", 3, bytes_type);
    file_.json["accessors"][small]["normalized"] = true, file_.json["accessors"][small]["count"] = 5;
    file_.json["bufferViews"].back()["byteStride"] = 4;
    primitive_of(file_)["targets"] = {{{"POSITION", small}}};
    file_.json["nodes"][0]["weights"] = {-3};
    expect_positions(file_, [](glm::dvec3 p) { return p - glm::dvec3(3, 0, 0); });
    // Without normals in the file, they are those of the morphed triangles.
    primitive_of(file_)["attributes"].erase("NORMAL");
    primitive_of(file_)["targets"] = {
        {{"POSITION",
          file_.add_accessor<float>({0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0, 0, 0}, "VEC3", 3, floats_type)}}};
    file_.json["nodes"][0]["weights"] = {1};  // z = x
    for (const Vertex& one : read(file_).mesh.vertices)
        EXPECT_LT(glm::distance(one.normal, glm::normalize(glm::vec3(-1, 0, 1))), 1e-6f);
}

TEST_F(GltfFeatures, SkinsHaveThePoseOfTheirJointsAndNotTheTransformOfTheirNode) {
    const double half = std::sqrt(0.5);
    file_.json["nodes"] = {{{"mesh", 0}, {"translation", {50, 60, 70}}, {"scale", {3, 3, 3}}},
                           {{"children", {2}}, {"translation", {0, 0, 5}}},
                           {{"rotation", {0, 0, half, half}}}};
    file_.json["scenes"][0]["nodes"] = {0, 1};
    add_skin(file_, {2});
    add_influence(file_, {0, 0, 0, 0}, {1, 0, 0, 0});
    const auto turned = [](glm::dvec3 p) { return glm::dvec3(-p.y, p.x, p.z + 5); };
    expect_positions(file_, turned);
    const Vertex vertex = read(file_).mesh.vertices[0];
    EXPECT_LT(glm::distance(vertex.normal, {0, 0, 1}), 1e-6f);
    EXPECT_LT(glm::distance(vertex.tangent, {0, 1, 0, 1}), 1e-6f);
    // An inverse bind matrix comes first: it moves by (1, 2, 3).
    add_skin(file_, {2}, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1});
    expect_positions(file_, [&](glm::dvec3 p) { return turned(p + glm::dvec3(1, 2, 3)); });
    // Two joints share a vertex, and small integers need not add up to 1.
    file_.json["nodes"][2].erase("rotation");
    add_skin(file_, {0, 1, 2});
    file_.json["nodes"][0] = {{"mesh", 0}, {"skin", 0}};
    add_influence(file_, {0, 1, 2, 2}, {0.3f, 0.3f, 0, 0});
    expect_positions(file_, [](glm::dvec3 p) { return p + glm::dvec3(0, 0, 2.5); });
    add_influence(file_, {1, 0, 0, 0}, {0.6f, 0, 0, 0}, 1);
    expect_positions(file_, [](glm::dvec3 p) { return p + glm::dvec3(0, 0, 3.75); });
    EXPECT_TRUE(read(file_).notes.empty());
    add_influence(file_, {9, 0, 0, 0}, {0.6f, 0, 0, 0}, 1);
    EXPECT_EQ(refusal(file_), "damaged: mesh 0, primitive 0 names joint 9 of 3");
}

TEST_F(GltfFeatures, AMirroringSkinKeepsTheOutside) {
    file_.json["nodes"] = {{{"mesh", 0}}, {{"scale", {-1, 1, 1}}}};
    file_.json["scenes"][0]["nodes"] = {0, 1};
    add_skin(file_, {1});
    add_influence(file_, {0, 0, 0, 0}, {1, 0, 0, 0});
    const GltfModel model = read(file_);
    const auto at = corner_positions(model);
    EXPECT_GT(glm::cross(at[1] - at[0], at[2] - at[0]).z, 0);
    EXPECT_LT(glm::distance(model.mesh.vertices[0].normal, {0, 0, 1}), 1e-6f);
    EXPECT_LT(glm::distance(model.mesh.vertices[0].tangent, {-1, 0, 0, -1}), 1e-6f);
}

TEST_F(GltfFeatures, SamplersSayHowAMapGoesOnBeyondItsBorder) {
    const auto wraps = [&](Json sampler) {
        mapped_.json["samplers"] = {std::move(sampler)};
        mapped_.json["textures"][0]["sampler"] = 0;
        const GltfNormalMap map = read(mapped_).normal_maps.at(0);
        return std::pair(map.wrap_u, map.wrap_v);
    };
    EXPECT_EQ(wraps({{"wrapS", 33648}, {"wrapT", 33071}}), std::pair(GltfWrap::mirror, GltfWrap::clamp));
    EXPECT_EQ(wraps({{"wrapS", 10497}}), std::pair(GltfWrap::repeat, GltfWrap::repeat));
    EXPECT_EQ(wraps({{"minFilter", 9987}}), std::pair(GltfWrap::repeat, GltfWrap::repeat));
}

TEST_F(GltfFeatures, EachPrimitiveHasTheMapOfItsMaterial) {
    Json& primitives = mapped_.json["meshes"][0]["primitives"];
    for (int i = 0; i < 4; ++i) primitives.push_back(primitives[0]);
    primitives[1].erase("material"), primitives[2]["material"] = 1, primitives[3]["material"] = 2;
    Json& materials = mapped_.json["materials"];
    materials.push_back({{"name", "plain"}});
    materials.push_back({{"normalTexture", {{"index", 0}, {"scale", 0.5}}}});
    const GltfModel model = read(mapped_);
    ASSERT_EQ(model.normal_maps.size(), 2u);
    EXPECT_EQ(model.normal_maps[1].scale, 0.5);
    ASSERT_EQ(model.parts.size(), 3u) << "smooth, the map, the map at half its strength";
    const std::pair<int, uint32_t> wanted[] = {{-1, 24}, {0, 24}, {1, 12}};
    uint32_t first = 0;
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(model.parts[i].normal_map, wanted[i].first);
        EXPECT_EQ(model.parts[i].index_count, wanted[i].second);
        EXPECT_EQ(model.parts[i].first_index, first);
        first += model.parts[i].index_count;
    }
    EXPECT_EQ(first, model.mesh.indices.size());
    // The vertices of primitives 1 and 2, which are smooth, come first.
    EXPECT_EQ(model.mesh.indices[0], 5u);
    EXPECT_EQ(model.mesh.indices[24], 0u);
}

TEST_F(GltfFeatures, NormalisedIntegersAreNumbersFromMinusOneToOne) {
    // 3.11: max(c / 127, -1), c / 255, max(c / 32767, -1), c / 65535.
    const auto normal_of = [&](size_t accessor) {
        file_.json["accessors"][accessor]["normalized"] = true;
        primitive_of(file_)["attributes"]["NORMAL"] = accessor;
        return read(file_).mesh.vertices[0].normal;
    };
    const std::vector<int8_t> small = {-128, 0, 127, 0};
    std::vector<int8_t> normals;
    std::vector<int16_t> large;
    for (int i = 0; i < 5; ++i) {
        normals.insert(normals.end(), small.begin(), small.end());
        large.insert(large.end(), {-32768, 0, 16384});
    }
    size_t accessor = file_.add_accessor(normals, "VEC3", 3, bytes_type);
    file_.json["accessors"][accessor]["count"] = 5, file_.json["bufferViews"].back()["byteStride"] = 4;
    EXPECT_LT(glm::distance(normal_of(accessor), glm::normalize(glm::vec3(-1, 0, 1))), 1e-6f);
    accessor = file_.add_accessor(large, "VEC3", 3, shorts);
    EXPECT_LT(glm::distance(normal_of(accessor), glm::normalize(glm::vec3(-1, 0, 16384 / 32767.0f))), 1e-6f);
}

TEST_F(GltfFeatures, QuantisedPositionsAreWholeNumbersInTheScaleOfTheirNode) {
    std::vector<int16_t> positions;
    for (const Vertex& vertex : four_corners().vertices)
        positions.insert(positions.end(), {int16_t(1000 * vertex.position.x), int16_t(1000 * vertex.position.y), 3, 0});
    const size_t accessor = file_.add_accessor(positions, "VEC3", 3, shorts);
    file_.json["accessors"][accessor]["count"] = 5, file_.json["bufferViews"].back()["byteStride"] = 8;
    primitive_of(file_)["attributes"]["POSITION"] = accessor;
    file_.json["extensionsRequired"] = file_.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    file_.json["nodes"][0]["scale"] = {0.001, 0.001, 0.001};
    expect_positions(file_, [](glm::dvec3 p) { return p + glm::dvec3(0, 0, 0.003); });
}

TEST_F(GltfFeatures, TextureTransformsMoveTheUvOfTheNormalMap) {
    const auto uv_of = [&](Json transform, size_t vertex) {
        mapped_.json["materials"][0]["normalTexture"]["extensions"]["KHR_texture_transform"] = std::move(transform);
        return read(mapped_).mesh.vertices[vertex].uv;
    };
    // Vertex 2 has u = 0.5 and the file's v = 1.
    EXPECT_LT(glm::distance(uv_of({{"offset", {0.25, 0.5}}}, 2), {0.75f, 1 - 1.5f}), 1e-6f);
    EXPECT_LT(glm::distance(uv_of({{"scale", {4, 0.5}}}, 2), {2, 1 - 0.5f}), 1e-6f);
    // A quarter turn counter-clockwise in a picture, where v grows downwards: (1, 0) becomes (0, -1).
    EXPECT_LT(glm::distance(uv_of({{"rotation", M_PI / 2}}, 2), {1, 1 + 0.5f}), 1e-6f);
    // First the scale, then the rotation, then the offset.
    EXPECT_LT(glm::distance(uv_of({{"rotation", M_PI / 2}, {"scale", {2, 3}}, {"offset", {0.5, 0.25}}}, 2),
                            {0.5f + 3, 1 - (0.25f - 1)}),
              1e-6f);
    mapped_.json["extensionsUsed"] = {"KHR_texture_transform"};
    EXPECT_LT(glm::distance(uv_of({{"offset", {0.25, 0}}}, 2), {0.75f, 0}), 1e-6f);
    mapped_.json["extensionsRequired"] = {"KHR_texture_transform"};
    EXPECT_LT(glm::distance(uv_of({{"offset", {0.25, 0}}}, 2), {0.75f, 0}), 1e-6f);
    // Its texCoord replaces that of the texture.
    const size_t other = mapped_.add_accessor<float>({0, 0, 0, 0, 0.125f, 0.25f, 0, 0, 0, 0}, "VEC2", 2, floats_type);
    primitive_of(mapped_)["attributes"]["TEXCOORD_1"] = other;
    EXPECT_LT(glm::distance(uv_of({{"texCoord", 1}, {"scale", {2, 2}}}, 2), {0.25f, 0.5f}), 1e-6f);
    EXPECT_TRUE(read(mapped_).notes.empty());
    // A model without a normal map has the uv of its colours.
    mapped_.json["materials"][0] = {
        {"pbrMetallicRoughness",
         {{"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {3, 1}}}}}}}}}}};
    EXPECT_LT(glm::distance(read(mapped_).mesh.vertices[2].uv, {1.5f, 0}), 1e-6f);
}

TEST_F(GltfFeatures, CompressedMeshesAreRefusedInOneLineAndTheirFallbackIsRead) {
    for (const char* const extension : {"EXT_meshopt_compression", "KHR_draco_mesh_compression"}) {
        GltfFile file = file_;
        file.json["extensionsUsed"] = file.json["extensionsRequired"] = {extension};
        file.json["buffers"] = {{{"byteLength", 400}}, {{"byteLength", 10}, {"uri", "missing.bin"}}};
        EXPECT_EQ(refusal(file), fmt::format("needs {}, which is not read: export without it", extension));
    }
    // Not required: the plain form is there.
    file_.json["extensionsUsed"] = {"EXT_meshopt_compression"};
    file_.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
    EXPECT_TRUE(read(file_).notes.empty());
    file_.json["buffers"].push_back(
        {{"byteLength", 60}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    file_.json["bufferViews"][0]["buffer"] = 1, file_.json["bufferViews"][0]["byteOffset"] = 0;
    EXPECT_EQ(refusal(file_),
              "buffer 1 has no bytes but with EXT_meshopt_compression, which is not read: export without it");
    GltfFile draco = gltf_of(four_corners());
    primitive_of(draco)["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
    EXPECT_EQ(read(draco).mesh.indices.size(), 12u);
    draco.json["accessors"][0].erase("bufferView");
    EXPECT_TRUE(contains(refusal(draco), "needs KHR_draco_mesh_compression"));
}

std::vector<glm::vec4> corner_tangents_of(const Mesh& mesh) {
    std::vector<glm::vec4> tangents;
    for (const uint32_t index : mesh.indices) tangents.push_back(mesh.vertices[index].tangent);
    return tangents;
}

TEST_F(GltfFeatures, MissingTangentsAreThoseOfMikkTSpaceByTheUvOfTheNormalMap) {
    Mesh torus = jittered_torus(12, 8, 5);
    for (Vertex& vertex : torus.vertices)
        if (vertex.uv.x > 0.5f) vertex.uv.x = 1 - vertex.uv.x;  // mirrored: vertices there become two
    GltfFile file = gltf_of(torus, "a picture");
    primitive_of(file)["attributes"].erase("TANGENT");
    const GltfModel model = read(file);
    EXPECT_FALSE(model.has_tangents);
    EXPECT_TRUE(model.notes.empty()) << "the standard allows it";
    EXPECT_GT(model.mesh.vertices.size(), torus.vertices.size());
    // The file stores 1 - v, which rounds.
    for (Vertex& vertex : torus.vertices) vertex.uv.y = 1 - (1 - vertex.uv.y);
    expect_mikktspace(corner_tangents_of(model.mesh), torus);
    // The normal map reads other uv, with u and v exchanged.
    std::vector<float> exchanged;
    for (const Vertex& vertex : torus.vertices) exchanged.insert(exchanged.end(), {vertex.uv.y, 1 - vertex.uv.x});
    primitive_of(file)["attributes"]["TEXCOORD_1"] = file.add_accessor(exchanged, "VEC2", 2, floats_type);
    file.json["materials"][0]["normalTexture"]["texCoord"] = 1;
    for (Vertex& vertex : torus.vertices) vertex.uv = {vertex.uv.y, 1 - (1 - vertex.uv.x)};
    expect_mikktspace(corner_tangents_of(read(file).mesh), torus);
}

TEST_F(GltfFeatures, TangentsWithoutLengthOrHandednessAreMadeAnewAndTheOthersStay) {
    Mesh mesh = four_corners();
    for (Vertex& vertex : mesh.vertices) vertex.tangent = {0, 1, 0, -1};
    mesh.vertices[1].tangent = {0, 0, 0, 1}, mesh.vertices[2].tangent.w = 0;
    const GltfModel model = read(gltf_of(mesh));
    EXPECT_FALSE(model.has_tangents);
    EXPECT_EQ(model.notes,
              std::vector<std::string>{"mesh 0, primitive 0: tangents of length 0, or with w = 0, are made "
                                       "anew, by MikkTSpace"});
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const bool is_made = mesh.indices[i] == 1 || mesh.indices[i] == 2;
        EXPECT_LT(glm::distance(model.mesh.vertices[model.mesh.indices[i]].tangent,
                                is_made ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, -1)),
                  1e-6f);
    }
}

TEST_F(GltfFeatures, NormalsWithoutLengthAreThoseOfATriangleWithOneNote) {
    Mesh mesh = four_corners();
    for (Vertex& vertex : mesh.vertices) vertex.normal = {0, 0, 0};
    const GltfModel model = read(gltf_of(mesh));
    for (const Vertex& vertex : model.mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(model.notes,
              std::vector<std::string>{"mesh 0, primitive 0: normals without length are made anew, from a triangle"});
}

TEST_F(GltfFeatures, FarFromTheOriginOnlyTheDifferencesAreRounded) {
    file_.json["nodes"] = {{{"children", {1}}, {"translation", {432100.25, 250, 5412300.125}}},
                           {{"mesh", 0}, {"translation", {0.0625, 0, 0}}, {"scale", {0.001, 0.001, 0.001}}}};
    expect_positions(
        file_, [](glm::dvec3 p) { return glm::dvec3(432100.3125, 250, 5412300.125) + 0.001 * p; }, 2e-9);
    EXPECT_EQ(read(gltf_of(four_corners())).centre, glm::dvec3(0)) << "near the origin, the numbers of the file stay";
}

TEST_F(GltfFeatures, APrimitiveWithoutUvLeavesThoseOfTheOthers) {
    Json& primitives = mapped_.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]), primitives.push_back(primitives[0]);
    for (const size_t i : {size_t{0}, size_t{2}}) primitives[i]["attributes"].erase("TEXCOORD_0");
    const GltfModel model = read(mapped_);
    EXPECT_TRUE(model.has_uvs);
    const Mesh mesh = four_corners();
    for (size_t i = 0; i < 5; ++i) EXPECT_EQ(model.mesh.vertices[5 + i].uv, mesh.vertices[i].uv);
    EXPECT_EQ(model.notes,
              (std::vector<std::string>{"mesh 0, primitive 0 and 1 more: a normal map, but no uv for it: it is smooth",
                                        "mesh 0, primitive 0 and 1 more: no uv: (0, 0) everywhere"}));
    ASSERT_EQ(model.parts.size(), 2u);
    EXPECT_EQ(model.parts[1].normal_map, 0);
    EXPECT_EQ(model.parts[1].index_count, 12u);
}

TEST_F(GltfFeatures, MessagesNeverShowTheBytesOfAFile) {
    const std::string text = file_.gltf(), media = "application/octet-stream";
    const auto with = [&](const std::string& other) {
        std::string changed = text;
        return changed.replace(changed.find("data:" + media), 5 + media.size(), other);
    };
    for (const char* const valid : {"data:", "data:application/gltf-buffer", "data:text/plain;charset=utf-8"})
        EXPECT_EQ(parse_gltf(with(valid), {}).mesh.indices.size(), 12u) << valid;
    std::string raw = with("data:");
    raw.replace(raw.find(";base64"), 7, "");
    EXPECT_EQ(message_of([&] { parse_gltf(raw, {}); }), "buffer 0 is a data URI that is not read: only base64 is");
    EXPECT_EQ(message_of([&] { parse_gltf("{\"secret\": secret}", {}); }), "damaged: its JSON is faulty at byte 12");
}

TEST_F(GltfFeatures, TheTableForInstructorsSaysWhatIsRead) {
    using Change = std::function<void(GltfFile&)>;
    const auto set = [](const std::string& pointer, Json value) -> Change {
        return [=](GltfFile& file) { file.json[Json::json_pointer(pointer)] = value; };
    };
    const auto uses = [&](const char* extension) { return set("/extensionsUsed", Json::array({extension})); };
    const auto needs = [&](const char* extension) { return set("/extensionsRequired", Json::array({extension})); };
    const std::string primitive = "/meshes/0/primitives/0", map = "/materials/0/normalTexture";
    const std::map<std::string, Change> features = {
        {"lists, strips and fans of triangles", set(primitive + "/mode", 6)},
        {"points and lines",
         [](GltfFile& file) {
             auto& all = file.json["meshes"][0]["primitives"];
             all.push_back(all[0]), all[1]["mode"] = 0;
         }},
        {"transforms of nodes, also far from the origin", set("/nodes/0/translation", Json::array({1e7, 0, 0}))},
        {"scenes but the default one", set("/scenes/1", Json{{"nodes", Json::array()}})},
        {"sparse accessors",
         [](GltfFile& file) {
             const size_t view = file.add_view(std::string(16, '\0'));
             file.json["accessors"][0]["sparse"] = {{"count", 1},
                                                    {"indices", {{"bufferView", view}, {"componentType", 5121}}},
                                                    {"values", {{"bufferView", view}}}};
         }},
        {"accessors without a buffer view", [](GltfFile& file) { file.json["accessors"][3].erase("bufferView"); }},
        {"normalised integers",
         [](GltfFile& file) {
             const size_t uv = file.add_accessor<uint8_t>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, "VEC2", 2, 5121);
             file.json["accessors"][uv]["normalized"] = true, file.json["bufferViews"].back()["byteStride"] = 2;
             primitive_of(file)["attributes"]["TEXCOORD_0"] = uv;
         }},
        {"morph targets, with the weights of the node or the mesh",
         [](GltfFile& file) {
             primitive_of(file)["targets"] = {{{"POSITION", 0}}};
             file.json["meshes"][0]["weights"] = {1};
         }},
        {"skins, in the pose of the nodes",
         [](GltfFile& file) {
             add_skin(file, {0});
             add_influence(file, {0, 0, 0, 0}, {1, 0, 0, 0});
         }},
        {"animations", set("/animations", Json{Json::object()})},
        {"missing normals", [](GltfFile& file) { primitive_of(file)["attributes"].erase("NORMAL"); }},
        {"normals without length", [](GltfFile& file) { file.json["accessors"][1].erase("bufferView"); }},
        {"missing tangents", [](GltfFile& file) { primitive_of(file)["attributes"].erase("TANGENT"); }},
        {"tangents without length, or with w = 0",
         [](GltfFile& file) { file.json["accessors"][2].erase("bufferView"); }},
        {"a primitive without uv beside others",
         [](GltfFile& file) {
             auto& all = file.json["meshes"][0]["primitives"];
             all.push_back(all[0]), all[1].erase("material"), all[1]["attributes"].erase("TEXCOORD_0");
         }},
        {"a normal map for each material, with its scale and texCoord", set(map + "/scale", 0.5)},
        {"wrap modes of samplers",
         [](GltfFile& file) {
             file.json["samplers"] = {{{"wrapS", 33648}}};
             file.json["textures"][0]["sampler"] = 0;
         }},
        {"nearest filtering of samplers",
         [](GltfFile& file) {
             file.json["samplers"] = {{{"magFilter", 9728}}};
             file.json["textures"][0]["sampler"] = 0;
         }},
        {"normal maps in WebP, KTX2 or DDS",
         [](GltfFile& file) {
             file.json["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
         }},
        {"KHR_texture_transform", set(map + "/extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}})},
        {"KHR_mesh_quantization", needs("KHR_mesh_quantization")},
        {"KHR_materials_ and KHR_lights_punctual: light alone", needs("KHR_materials_ior")},
        {"the normal map of a clear coat",
         set("/materials/0/extensions", {{"KHR_materials_clearcoat", {{"clearcoatNormalTexture", {{"index", 0}}}}}})},
        {"EXT_meshopt_compression, KHR_draco_mesh_compression", needs("EXT_meshopt_compression")},
        {"other extensions that are used", uses("EXT_mesh_gpu_instancing")},
        {"other extensions that are required", needs("EXT_mesh_gpu_instancing")},
        {"glTF 1.0", set("/asset/version", "1.0")},
    };
    const auto read_with = [this](const Change& change) {
        return [this, change] {
            GltfFile file = mapped_;
            change(file);
            return parse_gltf(file.glb(), {}).notes;
        };
    };
    ASSERT_EQ(outcome_of(read_with([](GltfFile&) {})), "read");
    FeatureCases cases;
    for (const auto& [feature, change] : features) cases[feature] = {read_with(change)};
    expect_features("of glTF 2.0", cases);
}

}  // namespace
}  // namespace relief
