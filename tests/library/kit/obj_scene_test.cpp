// Surfaces of OBJ models: which maps are found, what the notes say, and models of the user.
#include "framework/library/kit/obj_scene.h"

#include <gtest/gtest.h>

#include "framework/core/base/paths.h"
#include "framework/core/image/file.h"
#include "tests/support.h"

namespace relief {
namespace {

MapKind never_asked(const Image&) { throw Error("no map_bump is there to be examined"); }

constexpr const char* lone_triangle = "v 0 0 0\nv 4 0 0\nv 4 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl a\nf 1/1 2/2 3/3\n";

/// Returns the scene of a triangle in the folder of assets. Its material is the text of an MTL file after `newmtl`.
ObjScene triangle_with(const std::string& mtl, const MapSwitches& maps = {},
                       const std::function<MapKind(const Image&)>& kind_of = never_asked) {
    return make_obj_scene(parse_obj(lone_triangle, "newmtl a\n" + mtl, course_root() / "assets/model.obj"), maps,
                          kind_of);
}

TEST(ObjScene, NamesMapsByTheirAssets) {
    const ObjScene scene = triangle_with("map_Kd bricks_albedo.png\nmap_Ks bricks_normal.png\nmap_d wire_mask.png\n");
    const ObjSurface& surface = scene.surfaces.at(0);
    EXPECT_EQ(surface.colors, "bricks_albedo.png");
    EXPECT_EQ(surface.highlights, "bricks_normal.png");
    EXPECT_EQ(surface.mask, "wire_mask.png");
    EXPECT_FALSE(surface.mask_is_alpha);
    EXPECT_EQ(surface.bumps, "");
    EXPECT_EQ(surface.centre, glm::dvec3(2, 1, 0)) << "the middle of its bounding box";
    EXPECT_TRUE(scene.notes.empty());
    const ObjSurface off = triangle_with("map_Kd bricks_albedo.png\nmap_d wire_mask.png\n", no_maps).surfaces.at(0);
    EXPECT_EQ(off.colors + off.mask, "");
}

TEST(ObjScene, ReadsABumpMapAsItsTexelsSayAndPrefersNorm) {
    int asked = 0;
    const auto normals = [&](const Image& image) {
        ++asked;
        EXPECT_EQ(image.channels, 3);
        return MapKind::normals;
    };
    const ObjScene scene = triangle_with("map_bump bricks_normal.png\n", {}, normals);
    EXPECT_EQ(scene.surfaces.at(0).bump_kind, MapKind::normals);
    EXPECT_EQ(scene.notes.at(0), "model.mtl:1: map_bump of 'a' holds normals, not heights: read as norm");
    EXPECT_EQ(asked, 1);
    const ObjScene both = triangle_with("map_bump bricks_height.png\nnorm bricks_normal.png\n");
    EXPECT_EQ(both.surfaces.at(0).bumps, "bricks_normal.png");
    EXPECT_EQ(both.notes.at(0), "model.mtl:1: map_bump of 'a' is left out: norm is there");
}

TEST(ObjScene, LeavesOutInvisibleSurfacesAndMissingMaps) {
    EXPECT_TRUE(triangle_with("d 0\n").surfaces.empty());
    const ObjScene scene = triangle_with("map_Kd none.png\nillum 2\n");
    EXPECT_EQ(scene.surfaces.at(0).colors, "");
    EXPECT_EQ(scene.notes, (std::vector<std::string>{"model.mtl:1: illum of 'a' has no effect here",
                                                     "model.mtl:1: map_Kd of 'a' is left out: none.png is not there"}));
}

TEST(ObjScene, NamesWordsWithoutEffectInANote) {
    EXPECT_TRUE(triangle_with("Kd 1 0 0\nKs 1 1 1\nKe 1 0 0\nNs 9\nd 0.5\n").notes.empty());
    EXPECT_TRUE(triangle_with("map_Kd -bm 2 none.png\n").notes.at(0).ends_with("none.png is not there"));
    EXPECT_EQ(triangle_with("illum 2\n").notes,
              std::vector<std::string>{"model.mtl:1: illum of 'a' has no effect here"});
    const ObjScene scene = triangle_with(
        "Ka 1 1 1\nillum 2\nTf 1 0 0\nillum 1\nmap_Ka a.png\nmap_Ke a.png\nmap_Ns a.png\ndisp a.png\n"
        "map_d -s 2 2 -o 1 -t 0 -clamp on -mm 0 1 -texres 64 none.png\n");
    ASSERT_EQ(scene.notes.size(), 2u) << "and the missing map";
    EXPECT_EQ(scene.notes[0],
              "model.mtl:1: Ka, illum, Tf, map_Ka, map_Ke, map_Ns, disp, -s, -o, -t, -clamp, -mm and -texres of 'a' "
              "have no effect here");
}

TEST(OwnObj, IsPlacedAroundTheCentreWithTheMapsOfItsFolder) {
    const TemporaryFolder folder;
    write_image(folder.path() / "leaf.png", Image(2, 2, 3, 8));
    folder.write("own.mtl", "newmtl a\nmap_Kd leaf.png\nmap_Ks gone.png\n");
    OwnObj own({1, 2, 3}, std::sqrt(5.0));  // half the diagonal of 4 x 2
    own.read(folder.write("own.obj", std::string("mtllib own.mtl\n") + lone_triangle));
    EXPECT_EQ(own.model().mesh.vertices.at(0).position, glm::vec3(-1, 1, 3));
    const ObjScene scene = make_obj_scene(own.model(), {}, never_asked);
    EXPECT_TRUE(std::filesystem::equivalent(course_root() / "assets" / scene.surfaces.at(0).colors,
                                            folder.path() / "leaf.png"));
    EXPECT_TRUE(contains(scene.notes.at(0), "gone.png is not there")) << scene.notes.at(0);
    EXPECT_FALSE(own.accepts("own.glb")) << "a glTF file has no MTL file";
}

TEST(OwnObj, KeepsTheFormerModelWhenAFileOrAMapIsUnsuitable) {
    const TemporaryFolder folder;
    OwnObj own({0, 0, 0}, 1);
    own.read(folder.write("good.obj", lone_triangle));
    folder.write("noise.png", "no picture");
    folder.write("bad.mtl", "newmtl a\nmap_Kd noise.png\n");
    const auto refusal = [&](const char* name, const std::string& text) {
        const auto file = folder.write(name, text);
        return message_of([&] { own.read(file); });
    };
    EXPECT_TRUE(contains(refusal("a.obj", std::string("mtllib bad.mtl\n") + lone_triangle), "noise.png"));
    EXPECT_TRUE(contains(refusal("b.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "b.obj: has no area"));
    EXPECT_TRUE(contains(refusal("c.obj", "v 0 0 zero\n"), "c.obj:1: "));
    EXPECT_EQ(own.version(), 1);
    EXPECT_EQ(own.file().filename(), "good.obj");
    EXPECT_EQ(own.model().mesh.vertices.size(), 3u);
}

}  // namespace
}  // namespace relief
