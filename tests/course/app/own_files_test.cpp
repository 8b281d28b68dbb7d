// Models and colours of the user in the labs, from the command line.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/image/color.h"
#include "framework/core/image/compare.h"
#include "framework/core/image/file.h"
#include "framework/library/mesh/shapes.h"
#include "framework/library/mesh/tangents.h"
#include "tests/course/app/course_copy.h"
#include "tests/library/mesh/gltf_file.h"

namespace relief::app {
namespace {

class OwnFiles : public testing::Test {
protected:
    TemporaryFolder folder_;

    void SetUp() override {
        const Mesh cube = make_box({.size = {4, 4, 4}, .cells = {2, 2, 2}});
        write_model("cube.obj", cube), write_glb("cube.glb", cube);
    }

    /// Writes a model far from the origin, with its uv and normals.
    void write_model(const std::string& name, const Mesh& mesh) const {
        std::string text = "# a model\n";
        for (const auto& [position, normal, tangent, uv] : mesh.vertices)
            text += fmt::format("v {} {} {}\nvt {} {}\nvn {} {} {}\n", position.x + 64, position.y - 32,
                                position.z + 16, uv.x, uv.y, normal.x, normal.y, normal.z);
        for (size_t i = 0; i < mesh.indices.size(); i += 3)
            text += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", mesh.indices[i] + 1, mesh.indices[i + 1] + 1,
                                mesh.indices[i + 2] + 1);
        folder_.write(name, text);
    }
    Result shot(const std::string& lab, const std::vector<std::string>& set, std::vector<std::string> more) const {
        std::vector<std::string> command = {relief_program(), "shot", lab, "--size", "160x120"};
        for (const std::string& one : set) command.insert(command.end(), {"--set", one});
        command.insert(command.end(), more.begin(), more.end());
        return run(command, {folder_.path(), {}});
    }
    Image picture(const std::string& lab, const std::vector<std::string>& set,
                  std::vector<std::string> more = {}) const {
        more.insert(more.end(), {"-o", "picture.exr"});
        const Result result = shot(lab, set, more);
        EXPECT_EQ(result.code, 0) << result.err;
        return result.code == 0 ? read_image(folder_.path() / "picture.exr") : Image(1, 1, 3);
    }
    void write_glb(const std::string& name, const Mesh& mesh, const std::string& normal_map = "") const {
        folder_.write(name, gltf_of(mesh, normal_map).glb());
    }
    /// Writes a picture of one colour, 8 bits as sRGB stores them or light.
    void write_color(const std::string& name, glm::vec3 color, int bits) const {
        Image image(4, 4, 3, bits);
        for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = color[int(i % 3)];
        write_image(folder_.path() / name, image);
    }
};

/// Returns the share of pixels in which two pictures differ by more than `allowed`.
double share_apart(const Image& a, const Image& b, double allowed) {
    EXPECT_TRUE(a.same_shape(b));
    return double(difference(a, b, allowed).pixels_over) / double(a.pixel_count());
}

/// Returns the picture with its upper quarter black. Lab 05 adds the angle to a file's tangents to its title there.
Image below_title(Image picture) {
    std::fill_n(picture.values.begin(), picture.values.size() / 4, 0.0f);
    return picture;
}

TEST_F(OwnFiles, ACubeIsDrawnAsTheBoxOfTheLab) {
    const struct {
        const char *lab, *knob;
        std::vector<std::string> set;
    } labs[] = {
        {"05", "shape", {"view=one", "method=angle", "show=light", "lines=off", "columns=12", "rows=2", "jitter=0"}},
        {"13", "surface", {"view=one", "show=light", "patches=4", "level=3", "depth=0.2"}},
        {"14", "surface", {"view=eye", "patches=4"}}};
    for (const auto& [lab, knob, set] : labs) {
        std::vector<std::string> with_box = set, with_cube = set, with_sphere = set;
        with_box.push_back(fmt::format("{}=box", knob));
        with_cube.push_back(fmt::format("{}=cube.obj", knob));
        with_sphere.push_back(fmt::format("{}=sphere", knob));
        const Image box = picture(lab, with_box, {"--camera", "30,20,4"});
        EXPECT_FALSE(is_one_color(box)) << lab;
        EXPECT_LT(share_apart(box, picture(lab, with_cube, {"--camera", "30,20,4"}), 0.02f), 0.002) << lab;
        with_cube.back() = fmt::format("{}=cube.glb", knob);
        EXPECT_LT(share_apart(below_title(box), below_title(picture(lab, with_cube, {"--camera", "30,20,4"})), 0.02f),
                  0.002)
            << lab;
        EXPECT_GT(share_apart(box, picture(lab, with_sphere, {"--camera", "30,20,4"}), 0.02f), 0.05) << lab;
    }
}

TEST_F(OwnFiles, Lab05DrawsNoFramesOnAModelOfManyVertices) {
    write_model("sphere.obj", make_sphere({.sides = 48, .rows = 24}));  // 1225 vertices
    const auto with = [&](const char* model, const char* lines) {
        return picture("05", {"view=one", fmt::format("shape={}", model), fmt::format("lines={}", lines)});
    };
    EXPECT_EQ(difference(with("sphere.obj", "on"), with("sphere.obj", "off"), 1).largest, 0);
    EXPECT_GT(difference(with("cube.obj", "on"), with("cube.obj", "off"), 1).largest, 0.1);
}

TEST_F(OwnFiles, ACubeOfLab06HasTheBoundsAndTheNormalOfItsFace) {
    const Image normals =
        picture("06", {"view=one", "normals=vertices", "shape=cube.obj", "scale_x=1", "scale_y=1", "scale_z=1"},
                {"--camera", "0,0,4.2,0,0,0,40", "--probe", "normal", "--size", "200x200"});
    // The half side is 1.25 / sqrt(3), and the front face is that much nearer to the eye.
    const double half = 1.25 / std::sqrt(3.0), pixels = half / (4.2 - half) / std::tan(glm::radians(20.0)) * 100;
    ASSERT_EQ(normals.width, 200);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            const double off = std::max(std::abs(x + 0.5 - 100), std::abs(y + 0.5 - 100));
            if (std::abs(off - pixels) < 0.1) continue;
            const float* const normal = normals.pixel(x, y);
            ASSERT_EQ(std::isfinite(normal[0]), off < pixels) << x << " " << y;
            const glm::vec3 off_z = glm::vec3(normal[0], normal[1], normal[2]) - glm::vec3(0, 0, 1);
            ASSERT_TRUE(off > pixels || glm::length(off_z) < 1e-3f) << x << " " << y;
        }
}

TEST_F(OwnFiles, AModelHasNoExactValuesButWhereTheyFollowFromItBeingClosed) {
    const auto error = [&](const auto& words) {  // lab, knob, probe
        return shot(words[0], {"view=one", words[1] + "=cube.obj"}, {"--error", words[2], "-o", "error.png"});
    };
    const char* const said = "there are no exact values for the probe";
    expect_refused(
        error,
        {{{"05", "shape", "tangent"}, said}, {{"06", "shape", "normal"}, said}, {{"13", "surface", "depth"}, said}});
    const std::vector<std::string> closed = {"view=one", "surface=cube.obj", "depth=0.1"};
    const Result winding = shot("13", closed, {"--error", "winding", "-o", "error.png"});
    EXPECT_EQ(winding.code, 0) << winding.err;
    for (const float value : picture("13", closed, {"--probe", "winding"}).values) ASSERT_EQ(value, 0);
}

TEST_F(OwnFiles, ABrokenModelIsRefusedWithOneLine) {
    folder_.write("broken.obj", "v 0 0 0\nv 1 0 zero\nf 1 2 3\n");
    folder_.write("point.obj", "v 1 1 1\nf 1 1 1\n");
    const std::string glb = gltf_of(make_box({})).glb();
    folder_.write("short.glb", std::string_view(glb).substr(0, glb.size() - 9));
    write_glb("map.glb", make_box({}), "not a picture");
    const std::pair<const char*, const char*> labs[] = {{"05", "shape"},   {"06", "shape"},   {"07", "shape"},
                                                        {"07", "fine"},    {"10", "surface"}, {"11", "surface"},
                                                        {"12", "surface"}, {"13", "surface"}, {"14", "surface"}};
    for (const auto& [lab, knob] : labs) {
        const auto drawn = [&](const auto& file) {
            return shot(lab, {fmt::format("{}={}", knob, file[0])}, {"-o", "o.png"});
        };
        expect_refused(drawn, {{{"broken.obj"}, "broken.obj:2: ", 1},
                               {{"point.obj"}, "point.obj: has no area", 1},
                               {{"missing.obj"}, "missing.obj: cannot read", 1},
                               {{"short.glb"}, "short.glb: damaged: ", 1},
                               {{"map.glb"}, "map.glb: its normal map: neither PNG", 1}});
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "o.png"));
        const Result misspelt = shot(lab, {fmt::format("{}=spher", knob)}, {});
        EXPECT_EQ(misspelt.code, 2);
        const bool has_sphere = std::set<std::string>{"05", "06", "13", "14"}.contains(lab);
        EXPECT_EQ(contains(misspelt.err, "did you mean 'sphere'?"), has_sphere) << misspelt.err;
        EXPECT_TRUE(contains(misspelt.err, ", or an OBJ or glTF file")) << misspelt.err;
    }
    const Result analytic = shot("05", {"view=one", "method=analytic", "shape=cube.obj"}, {"-o", "o.png"});
    EXPECT_EQ(analytic.code, 1);
    EXPECT_TRUE(contains(analytic.err, "an own model has none")) << analytic.err;
}

TEST_F(OwnFiles, ARayMeetsTheReliefOnAModelWhereTheExactOneDoes) {
    // A mirrored side, and plain ones.
    Mesh model = make_box({.size = {2, 2, 2}});
    for (size_t i = 0; i < 8; ++i) model.vertices[i].uv.x *= -1, model.vertices[i].tangent *= -1;
    write_glb("model.glb", model);
    write_model("plain.obj", model);  // its tangents are made from the uv
    const std::pair<const char*, const char*> labs[] = {
        {"10", "steps=256"}, {"11", "steps=256"}, {"12", "method=cones"}};
    for (const auto& [lab, method] : labs) {
        const auto values = [&](const char* file, const char* what) {
            return picture(lab, {"view=one", method, "map=stones", fmt::format("surface={}", file)},
                           {what, "uv", "--camera", "30,25,5"});
        };
        const Image drawn = values("model.glb", "--probe");
        const auto share_off = [&](const Image& other) {
            size_t seen = 0, off = 0;
            for (size_t i = 0; i < drawn.values.size(); i += size_t(drawn.channels)) {
                if (!std::isfinite(drawn.values[i]) || !std::isfinite(other.values[i])) continue;
                ++seen, off += std::abs(drawn.values[i] - other.values[i]) > 1;  // texels
            }
            EXPECT_GT(seen, 2000u) << lab;
            return double(off) / double(seen);
        };
        EXPECT_LT(share_off(values("model.glb", "--truth")), 0.03) << lab;
        EXPECT_LT(share_off(values("plain.obj", "--probe")), 0.01) << lab;
    }
}

TEST_F(OwnFiles, Lab05ShowsTheTangentsInAGltfFileAsTheyAre) {
    Mesh quad = make_quad({.width = 2, .height = 2});
    for (Vertex& vertex : quad.vertices) vertex.tangent = {0.6f, 0.8f, 0, 1};  // not along u
    write_glb("quad.glb", quad);
    const auto tangents = [&](const char* method) {
        return picture("05", {"view=one", "shape=quad.glb", fmt::format("method={}", method)},
                       {"--probe", "tangent", "--camera", "0,0,3"});
    };
    const Image of_file = tangents("file"), ours = tangents("mikktspace");
    size_t seen = 0;
    for (size_t i = 0; i < of_file.values.size(); i += size_t(of_file.channels)) {
        if (!std::isfinite(of_file.values[i])) continue;
        ++seen;
        ASSERT_NEAR(of_file.values[i], 0.6f, 1e-3);
        ASSERT_NEAR(of_file.values[i + 1], 0.8f, 1e-3);
        ASSERT_NEAR(ours.values[i], 1, 1e-3);
    }
    EXPECT_GT(seen, 1000u);
    const auto every = [&](const char* file) {
        return picture("05", {fmt::format("shape={}", file), "lines=off"}, {"--camera", "0,0,3"});
    };
    write_model("quad.obj", quad);
    const Image six = every("quad.glb"), five = every("quad.obj");
    const auto last_tile = [](const Image& image) {
        double most = 0;
        for (int y = 80; y < 110; ++y)
            for (int x = 136; x < 158; ++x) most = std::max(most, double(image.pixel(x, y)[0]));
        return most;
    };
    EXPECT_GT(last_tile(six), 2 * last_tile(five)) << "a sixth picture, by the file's tangents";
    const Result without = shot("05", {"view=one", "method=file", "shape=quad.obj"}, {"-o", "o.png"});
    EXPECT_EQ(without.code, 1);
    EXPECT_TRUE(contains(without.err, "method=file needs a glTF file with tangents")) << without.err;
}

TEST_F(OwnFiles, Lab06ShowsTheNormalMapInAGltfFile) {
    const std::string bricks = read_file(std::string(source_folder) + "/assets/bricks_normal.png");
    write_glb("bricks.glb", make_sphere({.sides = 24, .rows = 12}), bricks);
    const auto with = [&](const char* map) {
        return picture("06", {"view=one", "shape=bricks.glb", fmt::format("map={}", map)});
    };
    EXPECT_LE(difference(with("bricks"), with("model"), 1).largest, 1e-6);
    EXPECT_GT(share_apart(with("one-texel"), with("model"), 0.05f), 0.05);
    const auto of_cube = [&](const char* map) {
        return picture("06", {"view=one", "shape=cube.glb", fmt::format("map={}", map)});
    };
    EXPECT_EQ(difference(of_cube("one-texel"), of_cube("model"), 1).largest, 0) << "without a map it is flat";
}

TEST_F(OwnFiles, Lab06DrawsEachPartOfAGltfFileWithItsOwnMapAndSaysWhatIsLeftOut) {
    const std::string bricks = read_file(std::string(source_folder) + "/assets/bricks_normal.png");
    Mesh quad = make_quad({.width = 2, .height = 2});
    for (Vertex& vertex : quad.vertices) vertex.uv *= 2.0f;
    GltfFile file = gltf_of(quad, bricks);
    const auto normals = [&](std::vector<std::string> set) {
        folder_.write("quad.glb", file.glb());
        set.insert(set.end(), {"view=one", "shape=quad.glb", "turn=0", "scale_x=1", "scale_y=1", "scale_z=1"});
        return picture("06", set, {"--probe", "normal", "--camera", "0,0,3"});
    };
    const Image mapped = normals({"map=model"}), flat = normals({"normals=vertices"});
    // The map goes on mirrored at u = 1, the middle of the picture.
    const auto asymmetry = [](const Image& image) {
        double most = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const float here = image.pixel(x, y)[0], there = image.pixel(image.width - 1 - x, y)[0];
                if (std::isfinite(here) && std::isfinite(there)) most = std::max(most, double(std::abs(here - there)));
            }
        return most;
    };
    file.json["textures"][0]["sampler"] = 0, file.json["samplers"] = {{{"wrapS", 33648}}};
    EXPECT_LT(asymmetry(normals({"map=model"})), 0.02);
    EXPECT_GT(asymmetry(mapped), 0.2);
    file.json["textures"][0].erase("sampler");
    // One triangle keeps its material, and the other has none.
    nlohmann::json& primitives = file.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1].erase("material");
    for (size_t i = 0; i < 2; ++i)
        primitives[i]["indices"] = file.add_accessor(
            std::vector(quad.indices.begin() + long(3 * i), quad.indices.begin() + long(3 * i) + 3), "SCALAR", 1, 5125);
    const Image halves = normals({"map=model"});
    size_t with_map = 0, without = 0, neither = 0;
    for (size_t i = 0; i < halves.values.size(); i += size_t(halves.channels)) {
        const float value = halves.values[i];
        if (!std::isfinite(value) || mapped.values[i] == flat.values[i]) continue;
        const bool is_mapped = std::abs(value - mapped.values[i]) < 1e-4f, is_flat = value == flat.values[i];
        with_map += is_mapped, without += is_flat, neither += !is_mapped && !is_flat;
    }
    EXPECT_GT(with_map, 500u);
    EXPECT_GT(without, 500u);
    EXPECT_LT(neither, 150u) << "the pixels at the seam";
    // A note is one line, and in the picture.
    const auto seen = [&] { return picture("06", {"view=one", "shape=quad.glb"}); };
    const Image quiet = seen();
    primitives.push_back(primitives[0]), primitives[2]["mode"] = 0;
    folder_.write("quad.glb", file.glb());
    EXPECT_GT(share_apart(quiet, seen(), 0.05f), 0.005);
    const Result noted = shot("06", {"view=one", "shape=quad.glb"}, {"-o", "o.png"});
    EXPECT_EQ(noted.err, "relief: quad.glb: mesh 0, primitive 2: points and lines are not read\n");
}

/// Returns the mean of the angles between the pixels' normals in two pictures, in degrees.
double mean_angle(const Image& a, const Image& b) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < a.values.size(); i += size_t(a.channels)) {
        if (!std::isfinite(a.values[i]) || !std::isfinite(b.values[i])) continue;
        const auto normal = [&](const Image& image) {
            return glm::normalize(glm::dvec3(image.values[i], image.values[i + 1], image.values[i + 2]));
        };
        sum += glm::degrees(std::acos(std::clamp(glm::dot(normal(a), normal(b)), -1.0, 1.0))), ++count;
    }
    EXPECT_GT(count, 1000u);
    return sum / double(count);
}

TEST_F(OwnFiles, Lab07ReadsAModelBakedByMikkTSpaceRightOnlyInItsFrame) {
    // A flat cube on one whose normals are averaged over three faces. Each face is a sixth of the map.
    Mesh fine = make_box({.size = {4, 4, 4}}), coarse = fine;
    for (size_t i = 0; i < coarse.vertices.size(); ++i) {
        Vertex& vertex = coarse.vertices[i];
        vertex.normal = glm::normalize(vertex.position);
        const double face = double(i / 4);
        vertex.uv = (glm::dvec2(std::fmod(face, 3), std::floor(face / 3)) + 0.1 + 0.8 * glm::dvec2(vertex.uv)) / 3.0;
    }
    coarse = with_tangents(coarse, TangentMethod::mikktspace);
    write_glb("fine.glb", fine), write_glb("coarse.glb", coarse);
    const Result baked =
        run({relief_program(), "map", "bake", "fine.glb", "coarse.glb", "-o", "n.png", "--size", "512"},
            {folder_.path(), {}});
    ASSERT_EQ(baked.code, 0) << baked.err;
    write_glb("baked.glb", coarse, read_file(folder_.path() / "n.png"));
    const auto degrees = [&](const std::string& wears, const std::string& frame) {
        const std::vector<std::string> set = {"view=one", "shape=baked.glb", "fine=fine.glb",
                                              "level=0",  "wears=" + wears,  "frame=" + frame};
        return mean_angle(picture("07", set, {"--probe", "normal"}), picture("07", set, {"--truth", "normal"}));
    };
    EXPECT_LT(degrees("file", "interpolated"), 0.5) << "8 bits";
    EXPECT_LT(degrees("map", "interpolated"), 0.1) << "baked by the lab, in 16 bits";
    // The lab's own cube: 5 degrees, from every side.
    EXPECT_NEAR(degrees("file", "gram-schmidt"), 5, 1);
    EXPECT_GT(degrees("nothing", "interpolated"), 20);
    const Result without = shot("07", {"view=one", "wears=file", "shape=cube.glb"}, {"-o", "o.png"});
    EXPECT_EQ(without.code, 1);
    EXPECT_TRUE(contains(without.err, "wears=file needs a glTF file with a normal map")) << without.err;
}

TEST_F(OwnFiles, ColorsOfTheMapGivenAsAFileChangeNothing) {
    const std::string albedo = std::string(source_folder) + "/assets/bricks_albedo.png";
    for (const std::string lab : {"10", "11", "12"}) {
        const std::vector<std::string> set = {"view=one", "map=wall"};
        std::vector<std::string> own = set;
        own.push_back("colors=" + albedo);
        EXPECT_EQ(difference(picture(lab, set), picture(lab, own), 1).largest, 0) << lab;
    }
}

TEST_F(OwnFiles, ColorsAreThoseOfAPictureAsSrgbOrAsLight) {
    write_color("stored.png", {0.8f, 0.4f, 0}, 8);
    write_color("light.exr", {float(linear_from_srgb(0.8)), float(linear_from_srgb(0.4)), 0}, 32);
    write_color("black.png", {0, 0, 0}, 8);
    for (const std::string lab : {"10", "11", "12"}) {
        const auto with = [&](const char* colors) {
            return picture(lab, {"view=one", "map=posts", fmt::format("colors={}", colors)});
        };
        const Image stored = with("stored.png"), black = with("black.png");
        EXPECT_LE(difference(stored, with("light.exr"), 1).largest, 0.02) << lab;
        EXPECT_GT(share_apart(stored, with("map"), 0.05f), 0.3) << lab;
        // What is not albedo, such as highlights, is in the black picture. The rest has the proportions of the colour.
        double sums[3] = {};
        for (size_t i = 0; i < stored.values.size(); ++i)
            sums[i % 3] += double(stored.values[i]) - double(black.values[i]);  // EXR has light
        EXPECT_GT(sums[0], 0) << lab;
        EXPECT_NEAR(sums[1] / sums[0], linear_from_srgb(0.4) / linear_from_srgb(0.8), 0.02) << lab;
        EXPECT_NEAR(sums[2] / sums[0], 0, 0.01) << lab;
    }
}

TEST_F(OwnFiles, ABrokenPictureOfColorsIsRefusedWithOneLine) {
    folder_.write("text.png", "not a picture");
    expect_refused([&](const auto& words) { return shot("12", {"colors=text.png"}, words); },
                   {{{"-o", "o.png"}, "text.png: neither PNG", 1}});
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "o.png"));
}

}  // namespace
}  // namespace relief::app
