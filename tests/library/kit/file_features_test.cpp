// What labs/staff/README.md says about the features of OBJ, MTL and pictures holds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "framework/core/image/file.h"
#include "framework/library/kit/obj_scene.h"
#include "framework/library/kit/own_mesh.h"
#include "framework/library/maps/heights.h"
#include "framework/library/maps/normals.h"
#include "tests/core/image/image_bytes.h"
#include "tests/features.h"

namespace relief {
namespace {

using namespace std::string_literals;
using Lines = std::vector<std::string>;

class FileFeatures : public testing::Test {
protected:
    TemporaryFolder folder_;
    void SetUp() override { testing::internal::CaptureStderr(); }
    void TearDown() override { testing::internal::GetCapturedStderr(); }

    /// Reads an OBJ text as labs take it for a shape.
    std::function<Lines()> obj(const std::string& text) const {
        return [this, text] {
            OwnMesh own(1);
            own.read(folder_.write("m.obj", text));
            return own.notes();
        };
    }
    /// Reads a triangle with an MTL text, as lab 08 does.
    std::function<Lines()> mtl(const std::string& text, const std::string& file = "m.mtl") const {
        return [this, text, file] {
            write_image(folder_.path() / "wall.png", Image(2, 2, 3, 8));
            folder_.write("m.mtl", "newmtl a\n" + text);
            OwnObj own({}, 1);
            own.read(folder_.write("m.obj", "mtllib " + file +
                                                "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\n"
                                                "f 1/1 2/2 3/3\n"));
            return own.notes();
        };
    }
};

TEST_F(FileFeatures, OfObjAndMtlAreAsTheTableSays) {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 0 0\n";
    const std::string f = "f 1/1/1 2/2/1 3/3/1 4/4/1\n";
    const auto far = [](const std::string& x) {
        return "v " + x + "0 0 0\nv " + x + "1 0 0\nv " + x + "1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n";
    };
    expect_features(
        "OBJ and MTL",
        {{"`v`, `vt`, `vn`, `f`", {obj(v + f), obj(v + "s 1\nf -4/-4/1 -3/-3/1 -2/-2/1\ns off\n" + f)}},
         {"polygons", {obj(v + "f 1/1 1/1 2/2 2/2 3/3 3/3 4/4 4/4 1/1\n"), obj(v + "f 1/1 2/2 4/4 3/3\n")}},
         {"positions far", {obj(far("541230")), obj(far("50000000"))}},
         {"faces without `vt`", {obj(v + f + "f 1 2 3\n"), obj(v + f + "f 1/1 2/2 3\n")}},
         {"no `vt` at all", {obj(v + "f 1 2 3\n")}},
         {"a normal of length 0", {obj(v + "f 1/1/1 2/2/2 3/3/1\n")}},
         {"the weight `w`",
          {obj(v + f + "v 0 0 0 2\n"), obj(v + f + "v 0 0 0 1 0 0\n"), obj(v + f + "l 1 2\n"), obj(v + f + "p 1\n"),
           obj(v + f + "curv 0 1 1 2\n")}},
         {"a number that is not finite",
          {obj(v + f + "v 0 nan 0\n"), obj(v + f + "v 0 1e999 0\n"), obj(v + "f 1/1 2/2 9/3\n"), obj(v),
           obj("\xff\xfev\0 \0"s)}},
         {"`Kd`, `Ks`",
          {mtl("Kd 1 0 0\nKs 1 1 1\nKe 0 0 1\nNs 20\nd 0.5\n"), mtl("Tr 0.5\n"), mtl("norm wall.png\n"),
           mtl("map_bump -bm 0.5 wall.png\n"), mtl("map_Kd wall.png\nmap_Ks wall.png\nmap_d wall.png\n")}},
         {"other words",
          {mtl("Ka 1 1 1\n"), mtl("illum 2\n"), mtl("map_Kd -s 2 2 wall.png\n"), mtl("map_Kd -o 0.5 wall.png\n"),
           mtl("map_Kd -clamp on wall.png\n"), mtl("Tf 1 0 0\n")}},
         {"an absolute path",
          {mtl("map_Kd /home/art/wall.png\n"), mtl("map_Kd C:\\art\\wall.png\n"),
           mtl("Kd 1 0 0\n", "/home/art/m.mtl")}},
         {"a missing MTL", {mtl("", "none.mtl"), mtl("map_Kd none.png\n"), mtl("map_Kd Wall.png\n"), mtl("", "M.mtl")}},
         {"opacity 0", {mtl("d 0\n"), mtl("Tr 1\n")}}});
}

/// Reads a picture as labs take it for heights.
std::function<Lines()> heights(const Image& image, ImageFormat format = ImageFormat::exr) {
    return [=] { return heights_in(decode_image(encode_image(image, format))).notes; };
}
std::function<Lines()> heights_of_file(const std::string& file) {
    return [=] { return heights_in(decode_image(file)).notes; };
}
/// Reads a picture as labs take it for a normal map.
std::function<Lines()> normals(const Image& image) {
    return [=] {
        Lines notes;
        normals_in(image, notes);
        return notes;
    };
}
std::function<Lines()> bytes(const std::string& file) {
    return [=] {
        decode_image(file);
        return Lines();
    };
}
/// Returns a float picture of 8 x 8 whose channels vary along x, y, x + y and x - y.
Image varied(int channels, float scale = 1, int bits = 32) {
    Image image(8, 8, channels, bits);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < channels; ++c)
                image.pixel(x, y)[c] =
                    scale * std::array{x / 7.0f, y / 7.0f, (x + y) / 14.0f, (x - y + 7) / 14.0f}[size_t(c)];
    return image;
}
Image grey_with(const Image& alpha, float scale) {
    Image image(8, 8, 4);
    for (size_t i = 0; i < 64; ++i) {
        for (size_t c = 0; c < 3; ++c) image.values[4 * i + c] = scale * float(i % 8) / 7;
        image.values[4 * i + 3] = alpha.values[i];
    }
    return image;
}

/// Returns a grey PNG with a gamma, in 1/100,000, or without chunks about colours.
std::string with_gamma(uint32_t gamma) {
    const std::string png = bare_png(varied(1, 1, 8));
    return gamma ? with_png_chunk(png, "gAMA", big_endian(gamma)) : png;
}

TEST_F(FileFeatures, OfPicturesAreAsTheTableSays) {
    const std::string exr = encode_image(varied(1), ImageFormat::exr);
    const std::string samples = (course_root() / "tests/core/image/files").string();
    std::string integers = exr, parts = exr, many = exr;
    integers[integers.find("Y\0\x02\0\0\0"s) + 2] = 0;
    parts[5] = '\x10';
    Image holes = varied(1), metres = varied(1, 500), end = varied(1, 0.01f), flat(8, 8, 4), blue(8, 8, 4);
    holes.values[3] = NAN;
    metres.values[3] = -9999;
    end.values[3] = 1, end.bits = 16;
    for (size_t i = 0; i < 64; ++i) {
        const float color[3] = {0.5f, 0.5f, 1};
        for (size_t c = 0; c < 3; ++c) flat.values[4 * i + c] = 1, blue.values[4 * i + c] = color[c];
        flat.values[4 * i + 3] = blue.values[4 * i + 3] = float(i) / 63;
    }
    Image none(2, 2, 1);
    std::fill(none.values.begin(), none.values.end(), NAN);
    expect_features(
        "pictures",
        {{"PNG of 1 to 16 bits",
          {bytes(encode_image(varied(3), ImageFormat::png)), bytes(exr), bytes(read_file(samples + "/tiles.exr")),
           bytes(read_file(samples + "/grey.jpg")), bytes("P5 1 1 255\nx"),
           bytes(encode_image(varied(3), ImageFormat::ppm)), bytes(encode_image(varied(1), ImageFormat::pfm))}},
         {"colour profile sRGB", {heights_of_file(with_gamma(0)), heights_of_file(with_gamma(45455))}},
         {"another colour profile", {heights_of_file(with_gamma(55556))}},  // color_profile_test.cpp has all
         {"a linear colour profile", {heights_of_file(with_gamma(100000))}},
         {"normal maps from -1",
          {normals(varied(3, -1)), normals(varied(4)),
           [&] {
               Image hole = varied(3);
               hole.values[4] = NAN;
               return normals(hole)();
           }}},
         {"WebP, TIFF", {bytes("RIFF\x1a\0\0\0WEBPVP8 "s), bytes("II*\0\x08\0\0\0"s), bytes("BM")}},
         {"EXIF orientation", {bytes(encode_image(varied(3), ImageFormat::png))}},  // orientation_test.cpp has all
         {"OpenEXR whose data window is larger", {bytes(with_windows(exr, {0, 0, 7, 7}, {1, 1, 6, 6}))}},
         {"OpenEXR whose data window does not fill",
          {bytes(with_windows(exr, {0, 0, 7, 7}, {0, 0, 8, 7})),
           bytes(with_windows(exr, {0, 0, 7, 7}, {-4, -4, 11, 11}))}},
         {"OpenEXR of several parts", {bytes(integers), bytes(parts)}},
         {"PPM, PGM and PFM whose header",
          {bytes("P5\r\n2 1\r\n255\r\nab"), bytes("P5\n2 1\n255 \nab"), bytes("Pf\n1 1\n2\nabcd")}},
         {"heights in grey", {heights(grey_with(varied(1), 0.5f))}},
         {"heights in the last channel", {heights(flat), heights(varied(4))}},
         {"heights in the fourth channel", {heights(blue)}},
         {"NaN, infinity", {heights(holes), heights(metres)}},
         {"a value at one end", {heights(end, ImageFormat::png)}},
         {"heights in metres", {heights(varied(1, 500)), heights(varied(1, -1))}},
         {"heights in colours", {heights(varied(3)), heights(none)}}});
}

}  // namespace
}  // namespace relief
