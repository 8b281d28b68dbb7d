// MTL materials: their faces, the meaning of each line, and the paths of files.
#include "framework/library/mesh/obj.h"

#include <filesystem>

#include "framework/core/base/file.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

const std::string square = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";

/// The only material of an MTL text, for a model in the folder m.
Material material(const std::string& lines) {
    const ObjModel model = parse_obj(square + "f 1 2 3\n", "newmtl a\n" + lines, "m/a.obj");
    EXPECT_EQ(model.materials.size(), 1u);
    return model.materials.at(0);
}

TEST(ObjMaterials, EachMaterialHasOneSubsetInTheOrderOfItsFirstFace) {
    const ObjModel model = parse_obj(square +
                                         "mtllib some.mtl\nusemtl b\nf 1 2 3\nusemtl a\nf 2 3 4\nusemtl b\nf 3 4 1\n"
                                         "g other\nf 4 1 2\n",
                                     "newmtl a\nnewmtl b\n");
    ASSERT_EQ(model.subsets.size(), 2u);
    EXPECT_EQ(model.materials.at(size_t(model.subsets[0].material)).name, "b");
    EXPECT_EQ(model.materials.at(size_t(model.subsets[1].material)).name, "a");
    EXPECT_EQ(model.subsets[0].first_index, 0u);
    EXPECT_EQ(model.subsets[0].index_count, 9u) << "a group does not end a material";
    EXPECT_EQ(model.subsets[1].first_index, 9u);
    EXPECT_EQ(model.subsets[1].index_count, 3u);
    EXPECT_EQ(model.mesh.vertices[model.mesh.indices[9]].position, glm::vec3(2, 0, 0));
    EXPECT_EQ(model.mesh.indices.size(), 12u);
}

TEST(ObjMaterials, FacesBeforeAnyUsemtlHaveNoMaterial) {
    const ObjModel model = parse_obj(square + "f 1 2 3\nusemtl a\nf 1 2 3\n", "newmtl a\n");
    ASSERT_EQ(model.subsets.size(), 2u);
    EXPECT_EQ(model.subsets[0].material, -1);
    EXPECT_EQ(model.subsets[1].material, 0);
    EXPECT_TRUE(model.notes.empty());
}

TEST(ObjMaterials, AnUnknownMaterialIsNotedWithItsFirstLine) {
    const ObjModel model = parse_obj(square + "usemtl a\nf 1 2 3\nusemtl wod\nf 1 2 3\nusemtl wod\n", "newmtl a\n");
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(model.notes[0], "model.obj:7: no material file describes 'wod'");
    EXPECT_EQ(model.subsets.at(1).material, -1);
}

TEST(ObjMaterials, EachMaterialStoresItsFileAndLine) {
    const ObjModel model = parse_obj(square + "f 1 2 3\n", "# none\nnewmtl a\nKd 1 0 0\n\nnewmtl b\n", "m/x.obj");
    ASSERT_EQ(model.materials.size(), 2u);
    EXPECT_EQ(model.materials[0].file, "m/x.mtl");
    EXPECT_EQ(model.materials[0].line, 2);
    EXPECT_EQ(model.materials[1].line, 5);
}

TEST(ObjMaterials, NamesMayContainBlanksAndTheFirstOfEqualNamesCounts) {
    const ObjModel model = parse_obj(square + "usemtl red  brick \nf 1 2 3\n",
                                     "newmtl stone\nnewmtl  red  brick\t\nKd 1 0 0\nnewmtl red  brick\nKd 0 0 1\n");
    ASSERT_EQ(model.subsets.at(0).material, 1);
    EXPECT_EQ(model.materials[1].diffuse, glm::vec3(1, 0, 0));
}

TEST(ObjMaterials, EachMaterialStartsFromTheDefaults) {
    const ObjModel model = parse_obj(square + "f 1 2 3\n",
                                     "Kd 0 0 0\nnewmtl a\nKd 0.25 0.5 1\nKs 1 0.5 0\nNs 96\nnewmtl b\nmap_Kd b.png\n");
    ASSERT_EQ(model.materials.size(), 2u);
    EXPECT_EQ(model.materials[0].diffuse, glm::vec3(0.25, 0.5, 1));
    EXPECT_EQ(model.materials[0].specular, glm::vec3(1, 0.5, 0));
    EXPECT_EQ(model.materials[0].shininess, 96);
    EXPECT_EQ(model.materials[1].diffuse, glm::vec3(1, 1, 1));
    EXPECT_EQ(model.materials[1].specular, glm::vec3(0, 0, 0));
    EXPECT_EQ(model.materials[1].opacity, 1);
}

TEST(ObjMaterials, OpacityIsDOrElseOneMinusTr) {
    EXPECT_EQ(material("d 0.25\n").opacity, 0.25f);
    EXPECT_EQ(material("Tr 0.25\n").opacity, 0.75f);
    EXPECT_EQ(material("d 0.5\nTr 0.25\n").opacity, 0.5f);
    EXPECT_EQ(material("Tr 0.25\nd 0.5\n").opacity, 0.5f);
    EXPECT_EQ(material("d 7\n").opacity, 1);
    EXPECT_EQ(material("Tr 7\n").opacity, 0);
}

TEST(ObjMaterials, MapNamesAreReadAfterTheirOptions) {
    EXPECT_EQ(material("map_Kd wall.png\n").diffuse_map, "m/wall.png");
    EXPECT_EQ(material("map_Kd -s 2 2 1 -o 0.5 0 0 -clamp on wall.png\n").diffuse_map, "m/wall.png");
    EXPECT_EQ(material("map_Kd -s 2 2 wall.png\n").diffuse_map, "m/wall.png") << "two numbers are enough";
    EXPECT_EQ(material("map_Kd -o 1 -mm 0 1 2.png\n").diffuse_map, "m/2.png");
    EXPECT_EQ(material("map_Kd -s 2 2 2\n").diffuse_map, "m/2") << "the last word is the name";
    EXPECT_EQ(material("map_Kd my wall.png \n").diffuse_map, "m/my wall.png");
    EXPECT_EQ(material("map_Kd textures\\sub\\wall.png\n").diffuse_map, "m/textures/sub/wall.png");
    EXPECT_EQ(material("map_Kd ../wall.png\n").diffuse_map, "wall.png");
    EXPECT_EQ(material("map_Kd\n").diffuse_map, "");
    EXPECT_EQ(material("map_Kd -s\n").diffuse_map, "");
    EXPECT_EQ(material("norm n.png\n").normal_map, "m/n.png");
    EXPECT_EQ(material("map_d -mm 0 0.1 h.exr\n").opacity_map, "m/h.exr");
}

TEST(ObjMaterials, OptionsMayFollowAMapName) {
    const Material after = material("map_bump my bump.png -bm 0.25 -s 30 30\n");
    EXPECT_EQ(after.bump_map, "m/my bump.png");
    EXPECT_EQ(after.bump_scale, 0.25f);
    EXPECT_EQ(material("map_bump -bm 0.5 h.png -imfchan l\n").bump_map, "m/h.png");
    EXPECT_EQ(material("map_bump -bm 0.5 h.png -imfchan l\n").bump_scale, 0.5f);
    EXPECT_EQ(material("map_Kd wall -s 2.png\n").diffuse_map, "m/wall -s 2.png") << "it is a part of the name";
    EXPECT_EQ(material("map_Kd wall -bm\n").diffuse_map, "m/wall -bm") << "an option has its number";
}

TEST(ObjMaterials, KeepTheirWordsOnceInTheOrderOfTheFile) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(material("").words, Words{});
    EXPECT_EQ(material("Kd 1 1 1\nTf 1 1 1\nKd 0 0 0\n").words, (Words{"Kd", "Tf"}));
    EXPECT_EQ(material("map_Kd -s 2 2 wall -o.png -clamp on\n").words, (Words{"map_Kd", "-clamp", "-s"}));
    EXPECT_EQ(material("map_Kd -s.png\n").words, Words{"map_Kd"}) << "it is the name";
    std::string many;
    for (int i = 0; i < 100; ++i) many += "x" + std::to_string(i) + "\n";
    EXPECT_EQ(material(many).words.size(), 32u);
}

TEST(ObjMaterials, MapNamesMayBeQuoted) {
    EXPECT_EQ(material("map_Kd \"my wall.png\"\n").diffuse_map, "m/my wall.png");
    EXPECT_EQ(material("map_bump -clamp on \"my -s wall.png\" -bm 2\n").bump_map, "m/my -s wall.png");
    EXPECT_EQ(material("map_bump \"h.png\" -bm 2\n").bump_scale, 2);
    EXPECT_EQ(material("map_Kd \"half.png\n").diffuse_map, "m/\"half.png") << "a quote that does not end";
    EXPECT_EQ(material("map_Kd \"\"\n").diffuse_map, "");
}

TEST(ObjMaterials, LightAndItsMapsAreRead) {
    const Material found = material("Ke 2 1 0\nmap_Ks s.png\nmap_d d.png\n");
    EXPECT_EQ(found.emission, glm::vec3(2, 1, 0));
    EXPECT_EQ(found.specular_map, "m/s.png");
    EXPECT_EQ(found.opacity_map, "m/d.png");
}

TEST(ObjMaterials, ABumpMapHasItsScaleInEverySpelling) {
    for (const std::string keyword : {"map_bump", "map_Bump", "bump"}) {
        const Material found = material(keyword + " -bm 0.25 -imfchan l h.png\n");
        EXPECT_EQ(found.bump_map, "m/h.png") << keyword;
        EXPECT_EQ(found.bump_scale, 0.25f) << keyword;
        EXPECT_EQ(material(keyword + " h.png\n").bump_scale, 1) << keyword;
        EXPECT_EQ(material(keyword + " -bm 1e9999 h.png\n").bump_scale, 1) << keyword;
    }
}

TEST(ObjMaterials, InvalidValuesAreNotedAndSkipped) {
    const ObjModel model =
        parse_obj(square + "f 1 2 3\n", "newmtl a\r\nKd 1 red 0\r\nd -halo 0.5\r\nNs nan\r\nillum 2\r\n", "m/a.obj");
    ASSERT_EQ(model.notes.size(), 3u);
    EXPECT_EQ(model.notes[0], "a.mtl:2: 'Kd' is left out: 'red' is not a finite number");
    EXPECT_EQ(model.notes[1], "a.mtl:3: 'd' is left out: '-halo' is not a finite number");
    EXPECT_EQ(model.materials[0].diffuse, glm::vec3(1, 1, 1));
    EXPECT_EQ(model.materials[0].opacity, 1);
}

TEST(ObjMaterials, AnInvalidMaterialFileIsNoted) {
    const ObjModel model = parse_obj(square + "f 1 2 3\n", std::string_view("newmtl a\n\0\1\2\nnewmtl b\n", 22));
    EXPECT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.notes.at(0), "model.mtl:2: this is not text: it has a byte 0");
    std::string many;
    for (int i = 0; i < 5000; ++i) many += "newmtl m" + std::to_string(i) + "\n";
    EXPECT_EQ(parse_obj(square + "f 1 2 3\n", many).materials.size(), 4096u);
}

TEST(ObjMaterials, FilesAreResolvedAgainstTheModelsFolder) {
    const TemporaryFolder folder;
    folder.write("models/my mats.mtl", "newmtl a\nmap_Kd tex/a.png\n");
    folder.write("models/sub/b.mtl", "newmtl b\nmap_Kd b.png\n");
    const fs::path file = folder.write(
        "models/m.obj", square + "mtllib my mats.mtl\nmtllib sub\\b.mtl\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    const fs::path before = fs::current_path();
    for (const fs::path& place : {before, folder.path(), folder.path() / "models"}) {
        fs::current_path(place);
        const ObjModel model = read_obj(place == before ? file : fs::relative(file));
        fs::current_path(before);
        ASSERT_EQ(model.materials.size(), 2u) << place;
        const fs::path base = place == before ? file.parent_path() : fs::relative(file.parent_path(), place);
        EXPECT_EQ(model.materials[0].diffuse_map, (base / "tex/a.png").lexically_normal());
        EXPECT_EQ(model.materials[1].diffuse_map, (base / "b.png").lexically_normal());
        EXPECT_EQ(model.subsets.at(1).material, 1);
        EXPECT_TRUE(model.notes.empty());
    }
}

TEST(ObjMaterials, AMissingFileIsANoteAndTheOthersAreRead) {
    const TemporaryFolder folder;
    folder.write("b.mtl", "newmtl b\n");
    const fs::path file = folder.write("m.obj", square + "mtllib a.mtl b.mtl b.mtl\nusemtl b\nf 1 2 3\n");
    const ObjModel model = read_obj(file);
    ASSERT_EQ(model.materials.size(), 1u) << "and each only once";
    EXPECT_EQ(model.subsets.at(0).material, 0);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(model.notes[0], "m.obj:5: no materials: a.mtl is not there");
}

TEST(ObjMaterials, AFileOfAnotherMachineIsLookedForBesideTheModel) {
    for (const char* elsewhere : {"/home/art/proj/textures/wall.png", "C:\\art\\wall.png", "d:/art/wall.png",
                                  "\\\\server\\art\\wall.png", "C:wall.png"})
        EXPECT_EQ(material(std::string("norm ") + elsewhere + "\n").normal_map, "m/wall.png") << elsewhere;
    const TemporaryFolder folder;
    const fs::path there = folder.write("there.png", "");
    EXPECT_EQ(material("norm " + there.string() + "\n").normal_map, there) << "a path of this machine";
    folder.write("a.mtl", "newmtl a\nKd 1 0 0\n");
    const ObjModel model = read_obj(folder.write("a.obj", square + "mtllib /home/art/proj/a.mtl\nusemtl a\nf 1 2 3\n"));
    EXPECT_EQ(model.materials.at(0).diffuse, glm::vec3(1, 0, 0));
    EXPECT_TRUE(model.notes.empty());
}

TEST(ObjMaterials, AMissingFileOfAnotherCaseIsNamed) {
    const TemporaryFolder folder;
    folder.write("Wood.MTL", "newmtl a\n");
    const fs::path file = folder.write("m.obj", square + "mtllib wood.mtl\nf 1 2 3\n");
    EXPECT_EQ(read_obj(file).notes.at(0),
              "m.obj:5: no materials: wood.mtl is not there, but Wood.MTL is: the case of letters counts");
    fs::create_directory(folder.path() / "Maps");
    folder.write("Maps/brick.png", "");
    EXPECT_EQ(missing_file(folder.path() / "maps" / "brick.png"),
              (folder.path() / "maps/brick.png").string() + " is not there, but " +
                  (folder.path() / "Maps/brick.png").string() + " is: the case of letters counts");
    EXPECT_EQ(missing_file(folder.path() / "maps" / "stone.png"), "stone.png is not there");
    EXPECT_EQ(missing_file("no/such/folder/stone.png"), "stone.png is not there");
}

TEST(ObjMaterials, OpacityZeroIsNotedWithTheWordThatSaysIt) {
    const auto notes = [](const std::string& mtl) {
        return parse_obj(square + "usemtl a\nf 1 2 3\n", "newmtl b\nd 0\nnewmtl a\n" + mtl).notes;
    };
    ASSERT_EQ(notes("Tr 1\n").size(), 1u) << "b is on no face";
    EXPECT_TRUE(notes("Tr 1.0\n")[0].starts_with("model.mtl:3: 'a' has opacity 0 (Tr 1): its faces are not drawn"));
    EXPECT_TRUE(notes("d 0\n")[0].starts_with("model.mtl:3: 'a' has opacity 0 (d 0): its faces are not drawn"));
    EXPECT_TRUE(notes("Tr 0\n").empty() && notes("d 1\nTr 1\n").empty());
}

}  // namespace
}  // namespace relief
