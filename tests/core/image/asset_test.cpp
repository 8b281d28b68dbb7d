// The pictures that the build converted, compared with a conversion at run time.
#include "framework/core/image/asset.h"

#include <cstring>
#include <set>

#include "framework/core/base/file.h"
#include "framework/core/base/module.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/file.h"
#include "framework/core/image/mips.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> pictures() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(course_root() / "assets"))
        if (entry.path().extension() == ".png") names.push_back(entry.path().filename());
    return names;
}

/// A course whose assets are the files that a test writes.
class CourseOfOwn {
public:
    CourseOfOwn() {
        for (const char* part : {"labs", "shaders", "assets"}) fs::create_directories(folder_.path() / part);
        elsewhere_.emplace(folder_.path());
    }
    void put(const std::string& name, const std::string& bytes) const { folder_.write("assets/" + name, bytes); }

private:
    TemporaryFolder folder_;
    std::optional<CourseElsewhere> elsewhere_;
};

bool same(const Texels& a, const Texels& b) {
    if (a.channels != b.channels || a.bits != b.bits || a.space != b.space || a.levels.size() != b.levels.size())
        return false;
    for (size_t i = 0; i < a.levels.size(); ++i)
        if (a.levels[i].width != b.levels[i].width || a.levels[i].height != b.levels[i].height ||
            std::memcmp(a.levels[i].rows, b.levels[i].rows, a.bytes(a.levels[i])) != 0)
            return false;
    return true;
}

/// Returns the colour space of the chain that the build made.
ColorSpace map_space(const std::string& name) {
    const std::string bytes = read_file(framework_folder() / "textures" / (name + ".texels"));
    uint64_t source = 0;
    std::memcpy(&source, bytes.data() + 8, sizeof source);
    return decode_texels(bytes, source, {}).value().space;
}

TEST(Asset, IsStoredConvertedBitForBitAsARunWouldConvertIt) {
    ASSERT_GE(pictures().size(), 10u);
    for (const std::string& name : pictures()) {
        const fs::path picture = course_root() / "assets" / name;
        EXPECT_TRUE(read_file(framework_folder() / "textures" / (name + ".texels")) ==
                    convert_asset(name, read_file(picture)))
            << name;
        EXPECT_EQ(map_space(name), name.ends_with("_albedo.png") ? ColorSpace::srgb : ColorSpace::linear) << name;
        const Image decoded = read_image(picture);
        const Image read = read_asset(name);
        EXPECT_EQ(read.bits, decoded.bits) << name;
        EXPECT_TRUE(read.same_shape(decoded) && read.values == decoded.values) << name;
        for (const ColorSpace space : {ColorSpace::linear, ColorSpace::srgb}) {
            if (space == ColorSpace::srgb && (decoded.channels < 3 || decoded.bits != 8)) continue;
            EXPECT_TRUE(same(read_asset_chain(name, space), pack(mip_chain(decoded, space), space))) << name;
        }
    }
}

TEST(Asset, IsReloadedAfterAReplacementOfAnyTimeAndSize) {
    const std::string name = "bricks_albedo.png", bytes = read_file(course_root() / "assets" / name);
    const Image known = read_asset(name);
    const CourseOfOwn course;
    course.put(name, bytes);
    EXPECT_EQ(read_asset(name).values, known.values);
    // A PPM with a PNG's name and length: only the contents differ.
    Image other(16, 16, 3, 8);
    other.values[5] = 1;
    std::string ppm = encode_image(other, ImageFormat::ppm);
    ppm.resize(bytes.size());
    course.put(name, ppm);
    EXPECT_EQ(read_asset(name).values, other.values);
    EXPECT_TRUE(
        same(read_asset_chain(name, ColorSpace::srgb), pack(mip_chain(other, ColorSpace::srgb), ColorSpace::srgb)));
}

TEST(Asset, ChangesWithEachOfItsBytes) {
    // Blocks have 32 bytes and pieces 65536. Changes a byte at each kind of position.
    const std::string ppm = encode_image(Image(200, 200, 3, 8), ImageFormat::ppm);
    const auto fingerprint = [](const std::string& bytes) { return convert_asset("a.ppm", bytes).substr(8, 8); };
    std::set<std::string> seen = {fingerprint(ppm)};
    for (const size_t at : {size_t{16}, size_t{31}, size_t{32}, size_t{65535}, size_t{65536}, ppm.size() - 1}) {
        std::string changed = ppm;
        changed[at] = 1;
        EXPECT_TRUE(seen.insert(fingerprint(changed)).second) << at;
    }
}

}  // namespace
}  // namespace relief
