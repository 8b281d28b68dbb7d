// OBJ models as exporters write them: all notations, and the resulting mesh.
#include "framework/library/mesh/obj.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "framework/library/mesh/polygon.h"
#include "tests/support.h"

namespace relief {
namespace {

const std::string unit_square = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";

/// Returns the positions of the triangles, corner by corner.
std::vector<glm::vec3> corners(const ObjModel& model) {
    std::vector<glm::vec3> all;
    for (const uint32_t index : model.mesh.indices) all.push_back(model.mesh.vertices.at(index).position);
    return all;
}

TEST(Obj, AQuadIsTwoTrianglesWithItsWinding) {
    const ObjModel model = parse_obj(unit_square + "f 1 2 3 4\n");
    EXPECT_EQ(corners(model),
              (std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}, {2, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(parse_obj(unit_square + "f 4 3 2 1\n").mesh.vertices[0].normal, glm::vec3(0, 0, -1));
    EXPECT_TRUE(model.notes.empty());
}

TEST(Obj, CornerIndicesAreReadAsPositionUvAndNormal) {
    const std::string data = unit_square + "vt 0.25 0.5\nvt 1 1\nvn 0 0 2\nvn 0 -3 0\n";
    const ObjModel all = parse_obj(data + "f 1/2/1 2/1/2 3/2/2\n");
    EXPECT_EQ(all.mesh.vertices[0].uv, glm::vec2(1, 1));
    EXPECT_EQ(all.mesh.vertices[1].uv, glm::vec2(0.25, 0.5));
    EXPECT_EQ(all.mesh.vertices[0].normal, glm::vec3(0, 0, 1)) << "made unit";
    EXPECT_EQ(all.mesh.vertices[1].normal, glm::vec3(0, -1, 0));
    EXPECT_TRUE(all.has_normals && all.has_uvs);

    const ObjModel no_uv = parse_obj(data + "f 1//2 2//2 3//2\n");
    EXPECT_TRUE(no_uv.has_normals && !no_uv.has_uvs);
    EXPECT_EQ(no_uv.mesh.vertices[0].uv, glm::vec2(0, 0));
    EXPECT_EQ(no_uv.mesh.vertices[0].normal, glm::vec3(0, -1, 0));

    const ObjModel no_normal = parse_obj(data + "f 1/1 2/1 3/1\n");
    EXPECT_TRUE(!no_normal.has_normals && no_normal.has_uvs);
    EXPECT_EQ(no_normal.mesh.vertices[0].normal, glm::vec3(0, 0, 1)) << "made from the face";
}

TEST(Obj, NegativeIndicesCountBackFromTheLastSoFar) {
    const ObjModel model = parse_obj(
        "v 9 9 9\n" + unit_square + "vt 0 0\nvt 1 0\nvn 0 0 1\nf -4/-2/-1 -3/-1/-1 -2/2/1\n" + "v 7 7 7\nf -1 -2 -3\n");
    EXPECT_EQ(corners(model),
              (std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {7, 7, 7}, {0, 1, 0}, {2, 1, 0}}));
    EXPECT_EQ(model.mesh.vertices[1].uv, glm::vec2(1, 0));
}

TEST(Obj, AFaceMayPrecedeItsVertices) { EXPECT_EQ(parse_obj("f 1 2 3\n" + unit_square).mesh.indices.size(), 3u); }

TEST(Obj, OnlyEqualIndicesShareAVertex) {
    const std::string data = unit_square + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n";
    EXPECT_EQ(parse_obj(data + "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n").mesh.vertices.size(), 4u);
    EXPECT_EQ(parse_obj(data + "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/1/1 4/1/1\n").mesh.vertices.size(), 5u);
    EXPECT_EQ(parse_obj(data + "f 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/1 4/1/1\n").mesh.vertices.size(), 5u);
    EXPECT_EQ(parse_obj(data + "f 1/1/1 2/1/1 3/1/1\nf 1/-2/-2 3/1/1 4/1/1\n").mesh.vertices.size(), 4u);
}

TEST(Obj, AcceptsAnyLineEndingAndBackslashContinuation) {
    const std::string text = "# a square\nv 0 0 0 # the origin\n\n  v\t2  0 0  \nv 2 \\\n 1 \\\n0\nv 0 1 0\nf 1 2 3 4";
    const ObjModel expected = parse_obj(unit_square + "f 1 2 3 4\n");
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string ended = "\xef\xbb\xbf";  // a byte order mark
        for (const char c : text) c == '\n' ? ended += end : ended += c;
        EXPECT_EQ(corners(parse_obj(ended)), corners(expected));
        EXPECT_NE(message_of([&] { parse_obj(ended + end + "f 1 2 x"); }).find("model.obj:10: "), std::string::npos)
            << "lines are counted as an editor does";
    }
    EXPECT_EQ(corners(parse_obj("# C:\\models\\\n" + unit_square + "f 1 2 3 4\n")), corners(expected))
        << "a comment does not go on";
}

TEST(Obj, ReadsNumbersInEveryNotation) {
    const ObjModel model =
        parse_obj("v +1 -.5 1e2 1\nv 1.25E-1 0. 00012 0.5 0.5 0.5\nv 0 0 0\nvt 0.5\nf 1/1 2/1 3/1\n");
    EXPECT_EQ(model.mesh.vertices[0].position, glm::vec3(1, -0.5, 100));
    EXPECT_EQ(model.mesh.vertices[1].position, glm::vec3(0.125, 0, 12));
    EXPECT_EQ(model.mesh.vertices[0].uv, glm::vec2(0.5, 0));
}

TEST(Obj, AFaceWithoutUvKeepsTheUvOfTheOthersAndItsLineIsNamed) {
    const std::string data = unit_square + "vt 0.25 0.5\nvt 1 1\n";
    const ObjModel model = parse_obj(data + "f 1/1 2/2 3/2\nf 3 4 1\n");
    EXPECT_TRUE(model.has_uvs);
    EXPECT_EQ(model.line_without_uv, 8);
    const auto uv = [&](size_t corner) { return model.mesh.vertices[model.mesh.indices[corner]].uv; };
    EXPECT_EQ(uv(0), glm::vec2(0.25, 0.5));
    EXPECT_EQ(uv(1), glm::vec2(1, 1));
    for (const size_t corner : {3, 4, 5}) EXPECT_EQ(uv(corner), glm::vec2(0));
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(model.notes[0],
              "model.obj:8: this face has corners without uv (vt): they get 0, 0; the other faces keep theirs");
    const ObjModel corner = parse_obj(data + "f 1/1 2/2 3\nf 3/1 4/1 1\nf 1/1 2/1 3/1\n");
    EXPECT_EQ(corner.line_without_uv, 7);
    EXPECT_TRUE(corner.notes.at(0).starts_with("model.obj:7: 2 faces, of which this is the first")) << corner.notes[0];
    const ObjModel none = parse_obj(data + "f 1 2 3\n");
    EXPECT_FALSE(none.has_uvs);
    EXPECT_TRUE(none.notes.empty());
}

TEST(Obj, AModelFarFromTheOriginKeepsTheDigitsOfItsShape) {
    const glm::dvec3 far(432100.25, -250.5, 5412300.125);
    std::string text;
    const std::array<glm::dvec3, 4> shape = {{{0, 0, 0.001}, {0.002, 0, 0}, {0.0021, 0.0013, 0}, {0, 0.0007, 0}}};
    for (const glm::dvec3& corner : shape)
        text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", far.x + corner.x, far.y + corner.y, far.z + corner.z);
    // A vertex of no face has no effect on the origin.
    const ObjModel model = parse_obj("v 0 0 0\n" + text + "f 2 3 4 5\n");
    EXPECT_LT(glm::length(model.origin - far), 0.01);
    for (const Vertex& vertex : model.mesh.vertices) {
        double nearest = 1;
        for (const glm::dvec3& corner : shape)
            nearest = std::min(nearest, glm::length(model.origin + glm::dvec3(vertex.position) - far - corner));
        EXPECT_LT(nearest, 1e-6) << "the last digit of the file; a float alone has steps of half a metre there";
    }
    const ObjModel near = parse_obj("v 10 10 10\nv 40 10 10\nv 10 40 10\nf 1 2 3\n");
    EXPECT_EQ(near.origin, glm::dvec3(0)) << "within its own size";
    EXPECT_EQ(near.mesh.vertices[0].position, glm::vec3(10));
}

TEST(Obj, NeighbouringCornersAtOnePositionCountOnce) {
    // An F: a stem of 5, an arm of 3 and an arm of 2. Its corners are positions of their own, once to three times.
    const std::array<std::pair<int, int>, 10> f = {
        {{0, 0}, {1, 0}, {1, 2}, {3, 2}, {3, 3}, {1, 3}, {1, 4}, {4, 4}, {4, 5}, {0, 5}}};
    const auto area_of = [&](int times, bool closes) {
        std::string text, face = "f";
        int count = 0;
        const auto add = [&](const std::pair<int, int>& corner) {
            text += fmt::format("v {} {} 0\n", corner.first, corner.second), face += fmt::format(" {}", ++count);
        };
        for (const auto& corner : f)
            for (int i = 0; i < times; ++i) add(corner);
        if (closes) add(f[0]);
        double area = 0;
        const std::vector<glm::vec3> all = corners(parse_obj(text + face + "\n"));
        for (size_t i = 0; i < all.size(); i += 3) {
            const std::vector<glm::dvec3> triangle(all.begin() + long(i), all.begin() + long(i) + 3);
            EXPECT_GT(vector_area(triangle).z, 0);
            area += vector_area(triangle).z;
        }
        return area;
    };
    for (const int times : {1, 2, 3})
        for (const bool closes : {false, true}) EXPECT_NEAR(area_of(times, closes), 5 + 3 + 2, 1e-6) << times;
    EXPECT_EQ(parse_obj(unit_square + "f 1 1 2 2 3 3 4 4 1\n").mesh.indices.size(), 6u);
    EXPECT_EQ(parse_obj(unit_square + "f 1 1 1\n").mesh.indices.size(), 3u) << "no area, and no harm";
}

TEST(Obj, WeightsAndColoursOfVerticesAreNotedOnce) {
    const ObjModel model = parse_obj("v 0 0 0 1\nv 1 0 0 0.5\nv 0 1 0 2\nv 0 1 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
    EXPECT_EQ(model.notes, (std::vector<std::string>{"model.obj:2: the weight w of a vertex is not read",
                                                     "model.obj:4: the colours of vertices are not read"}));
}

/// A roof: two slopes of 45 degrees that share the ridge 1, 2.
const std::string roof = "v 0 1 0\nv 0 1 -1\nv -1 0 0\nv -1 0 -1\nv 1 0 0\nv 1 0 -1\n";

std::set<std::pair<float, float>> ridge_normals(const ObjModel& model) {
    std::set<std::pair<float, float>> normals;
    for (const Vertex& vertex : model.mesh.vertices)
        if (vertex.position.y == 1)
            normals.insert({std::round(vertex.normal.x * 1e5f) / 1e5f, std::round(vertex.normal.y * 1e5f) / 1e5f});
    return normals;
}

TEST(ObjNormals, AreSmoothWithinASmoothingGroupAndFlatWithout) {
    const std::set<std::pair<float, float>> smooth = {{0, 1}}, sharp = {{-0.70711f, 0.70711f}, {0.70711f, 0.70711f}};
    const std::string left = "f 1 2 4 3\n", right = "f 1 5 6 2\n";
    EXPECT_EQ(ridge_normals(parse_obj(roof + left + right)), smooth) << "while no s has come";
    EXPECT_EQ(ridge_normals(parse_obj(roof + "s 1\n" + left + right)), smooth);
    EXPECT_EQ(ridge_normals(parse_obj(roof + "s off\n" + left + right)), sharp);
    EXPECT_EQ(ridge_normals(parse_obj(roof + "s 0\n" + left + right)), sharp);
    EXPECT_EQ(ridge_normals(parse_obj(roof + "s 1\n" + left + "s 2\n" + right)), sharp);
    EXPECT_EQ(ridge_normals(parse_obj(roof + "v 0 1 0\nv -0 1 -1\n" + left + "f 7 5 6 8\n")), smooth)
        << "equal positions are one, as on both sides of a seam";
}

TEST(ObjNormals, AreAngleWeightedAndIndependentOfTheTriangulation) {
    // At a cube's corner, three right angles meet. So the mean is the diagonal, however the squares are triangulated.
    const ObjModel model = parse_obj(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7\nf 5 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7\nf 2 7 6\nf 1 5 8 4\n");
    ASSERT_EQ(model.mesh.vertices.size(), 8u);
    for (const Vertex& vertex : model.mesh.vertices)
        EXPECT_NEAR(glm::dot(vertex.normal, glm::normalize(vertex.position - 0.5f)), 1, 1e-6);
}

TEST(ObjNormals, OnATwoSidedSheetAreTheFaceNormals) {
    for (const Vertex& vertex : parse_obj(unit_square + "f 1 2 3 4\nf 4 3 2 1\n").mesh.vertices)
        EXPECT_EQ(std::abs(vertex.normal.z), 1);
}

TEST(ObjNormals, ZeroNormalsAreRecomputedFromTheFaces) {
    const ObjModel model = parse_obj(unit_square + "vn 0 0 0\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(model.mesh.vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_FALSE(model.has_normals);
    EXPECT_EQ(model.notes.at(0), "model.obj:6: a normal of length 0; one is made from the faces");
}

TEST(ObjNormals, PointAlongZOnDegenerateFaces) {
    for (const char* face : {"f 1 1 1\n", "f 1 2 1\n", "s off\nf 1 2 1 2 1\n"})
        for (const Vertex& vertex : parse_obj(unit_square + face).mesh.vertices)
            EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1)) << face;
}

TEST(Obj, InitialTangentsAreUnitAndPerpendicular) {
    for (const Vertex& vertex : parse_obj(roof + "f 1 2 4 3\nf 1 5 6 2\n").mesh.vertices) {
        EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 2e-7);
        EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0, 2e-7);
        EXPECT_EQ(vertex.tangent.w, 1);
    }
}

TEST(Obj, AnUnreadStatementIsNotedOnce) {
    const ObjModel model = parse_obj(unit_square + "g a b\no c\nl 1 2\nl 2 3\ns wild\nf 1 2 3\n");
    ASSERT_EQ(model.notes.size(), 2u);
    EXPECT_EQ(model.notes[0], "model.obj:7: 'l' is not read");
    EXPECT_EQ(model.notes[1], "model.obj:9: 's wild' is not a smoothing group; taken as off");
}

TEST(Obj, KeepsTheFirstTwentyNotes) {
    std::string text = unit_square + "f 1 2 3\n";
    for (int i = 0; i < 30; ++i) text += "s x\n";
    EXPECT_EQ(parse_obj(text).notes.size(), 20u);
}

std::string error_of(const std::string& text, const ObjLimits& limits = {}) {
    return message_of([&] { parse_obj(text, {}, "a/b.obj", limits); });
}

TEST(ObjErrors, NameTheFileAndTheLine) {
    EXPECT_EQ(error_of(unit_square + "f 1 2 5\n"), "a/b.obj:5: index 5 is out of range: the file has 4 'v'");
    EXPECT_EQ(error_of(unit_square + "f 1 2 -5\n"), "a/b.obj:5: index -5 is out of range: 4 'v' so far");
    EXPECT_EQ(error_of(unit_square + "vt 0 0\nf 1/1 2/2 3/1\n"),
              "a/b.obj:6: index 2 is out of range: the file has 1 'vt'");
    EXPECT_EQ(error_of(unit_square + "f 1//1 2//1 3//1\n"), "a/b.obj:5: index 1 is out of range: the file has 0 'vn'");
    EXPECT_EQ(error_of(unit_square + "\n# \n\nf 1 2\n"), "a/b.obj:8: a face of 2 corners; it takes 3 at least");
    EXPECT_EQ(error_of("v 0 zero 0\n"), "a/b.obj:1: 'zero' is not a finite number");
    EXPECT_EQ(error_of("v 1 2\n"), "a/b.obj:1: 'v' takes 3 numbers, here are 2");
    EXPECT_EQ(error_of("v\n"), "a/b.obj:1: 'v' takes 3 numbers, here are 0");
    for (const char* number : {"nan", "-inf", "1e39", "1e999", "0x10", "1,5", "--1", "+-1", "1e", "."})
        EXPECT_EQ(error_of(std::string("v 0 0 0\nv 0 ") + number + " 0\n"),
                  std::string("a/b.obj:2: '") + number + "' is not a finite number");
    EXPECT_EQ(error_of("v 0 0e999 0\n"), "a/b.obj: has no faces") << "0e999 is 0";
    EXPECT_EQ(error_of(""), "a/b.obj: has no faces");
    EXPECT_EQ(error_of(unit_square), "a/b.obj: has no faces");
}

TEST(ObjErrors, AContinuedStatementIsReportedAtItsFirstLine) {
    EXPECT_EQ(error_of("v 0 \\\n0 \\\nx\n"), "a/b.obj:1: 'x' is not a finite number");
    EXPECT_EQ(error_of("v 0 \\\n0 0\nv x 0 0\n"), "a/b.obj:3: 'x' is not a finite number");
}

TEST(ObjErrors, ReportInvalidCorners) {
    for (const char* corner : {"0", "1.5", "x", "1/x", "1//x", "1/0", "/1", "1/1/1/1", "99999999999999999999",
                               "1/99999999999999999999", "-2147483649"})
        EXPECT_TRUE(contains(error_of(unit_square + "vt 0 0\nvn 0 0 1\nf 1 2 " + corner + "\n"),
                             std::string("a/b.obj:7: '") + corner + "' is not a corner of a face"))
            << corner;
    EXPECT_EQ(error_of(unit_square + "f 1 2 2147483647\n"),
              "a/b.obj:5: index 2147483647 is out of range: the file has 4 'v'");
    EXPECT_TRUE(
        contains(error_of(unit_square + "f 1 2 -2147483648\n"), "a/b.obj:5: index -2147483648 is out of range"));
    EXPECT_EQ(parse_obj(unit_square + "f 1/ 2// 3//\n").mesh.indices.size(), 3u) << "empty parts are none";
}

TEST(ObjErrors, ReportJunkInPrintableForm) {
    EXPECT_EQ(error_of(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
              "a/b.obj:3: this is not text: it has a byte 0");
    EXPECT_EQ(error_of(std::string("\xff\xfev\0 \0", 6)), "a/b.obj:1: this is text in UTF-16: save it as UTF-8");
    EXPECT_EQ(error_of("v \x01 0 0\n"), "a/b.obj:1: '?' is not a finite number");
    EXPECT_EQ(error_of("v " + std::string(1000, 'y') + " 0 0\n"),
              "a/b.obj:1: '" + std::string(40, 'y') + "...' is not a finite number");
}

TEST(ObjErrors, ReportExceededLimits) {
    EXPECT_EQ(error_of(unit_square + "f 1 2 3\nf 1 2 3\n", {.corners = 5}),
              "a/b.obj:6: the faces have more than 5 corners");
    EXPECT_EQ(error_of(unit_square + "f 1 2 3\n", {.bytes = 10}), "a/b.obj: 40 bytes, the limit is 10");
    std::string face = "f";
    for (int i = 0; i < 1025; ++i) face += " 1";
    EXPECT_EQ(error_of(unit_square + face), "a/b.obj:5: a face of more than 1024 corners");
    face.resize(face.size() - 2);
    EXPECT_EQ(parse_obj(unit_square + face).mesh.indices.size(), 3u * 1022);
    const TemporaryFolder folder;
    const auto file = folder.write("large.obj", unit_square + "f 1 2 3\n");
    EXPECT_TRUE(contains(message_of([&] { read_obj(file, {.bytes = 10}); }), "the limit is 10"));
}

TEST(ObjErrors, ThePathOfAMissingFileIsInTheMessage) {
    EXPECT_TRUE(contains(message_of([] { read_obj("/nowhere/a.obj"); }), "/nowhere/a.obj: cannot read"));
}

}  // namespace
}  // namespace relief
