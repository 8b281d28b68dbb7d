// SVG pictures, and all diagrams of handouts.
#include "framework/course/pages/svg.h"

#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/course/pages/markdown.h"
#include "tests/support.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// Returns the share of the picture's pixels that are not white paper.
double share_of_ink(const Image& image) {
    size_t ink = 0;
    for (size_t i = 0; i < image.values.size(); i += 3)
        ink += image.values[i] < 0.95f || image.values[i + 1] < 0.95f || image.values[i + 2] < 0.95f;
    return double(ink) / double(image.pixel_count());
}

std::string drawing(const std::string& inside) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 200 100\">" + inside + "</svg>";
}

std::set<fs::path> diagrams_of_handouts() {
    std::set<fs::path> files;
    for (const auto& lab : fs::directory_iterator(fs::path(source_folder) / "labs")) {
        if (!fs::exists(lab.path() / "lab.toml")) continue;
        for (const pages::Block& block : pages::parse_markdown(read_file(lab.path() / "README.md")))
            for (const pages::Span& span : block.spans)
                if (span.image && span.target.ends_with(".svg"))
                    files.insert((lab.path() / span.target).lexically_normal());
    }
    return files;
}

TEST(Svg, DrawsEveryHandoutDiagramAtTheRequestedSize) {
    const std::set<fs::path> files = diagrams_of_handouts();
    EXPECT_GT(files.size(), 15u);
    for (const fs::path& file : files) {
        const std::string svg = read_file(file);
        const glm::ivec2 whole = svg_size(svg);
        for (const int width : {380, 1140}) {
            const glm::ivec2 size(width, width * whole.y / whole.x);
            const Image image = draw_svg(svg, size);
            EXPECT_EQ(glm::ivec2(image.width, image.height), size) << file;
            EXPECT_GT(share_of_ink(image), 0.01) << file << " at " << width;
            EXPECT_LT(share_of_ink(image), 0.7) << file << " at " << width;
        }
    }
}

TEST(Svg, EveryDiagramHasAWhitePlateForDarkPages) {
    size_t count = 0;
    for (const auto& file : fs::directory_iterator(fs::path(source_folder) / "assets/diagrams")) {
        EXPECT_TRUE(contains(read_file(file.path()), "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"))
            << file.path() << ": black letters on a dark ground";
        ++count;
    }
    EXPECT_GT(count, 40u);
}

TEST(Svg, KeepsColorsAndPositions) {
    const std::string svg = drawing("<rect x=\"0\" y=\"0\" width=\"100\" height=\"50\" fill=\"#ff8000\"/>");
    EXPECT_EQ(svg_size(svg), glm::ivec2(200, 100));
    const Image image = draw_svg(svg, {400, 200});
    EXPECT_EQ(image.channels, 3);
    const auto at = [&](int x, int y) { return std::vector<float>(image.pixel(x, y), image.pixel(x, y) + 3); };
    const std::vector<float> orange = {1, 128 / 255.0f, 0}, paper = {1, 1, 1};
    EXPECT_EQ(at(0, 0), orange);
    EXPECT_EQ(at(199, 99), orange) << "as sharp as the size that is wanted";
    EXPECT_EQ(at(200, 99), paper);
    EXPECT_EQ(at(199, 100), paper);
}

TEST(Svg, LettersAndArrowheadsAreDrawn) {
    for (const char* inside :
         {"<text x=\"20\" y=\"60\" font-family=\"DejaVu Sans\" font-size=\"40\">texel</text>",
          "<defs><marker id=\"tip\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"40\" markerHeight=\"40\" "
          "orient=\"auto\"><path d=\"M0 0 10 5 0 10z\"/></marker></defs>"
          "<path d=\"M20 50 H150\" stroke-width=\"1\" marker-end=\"url(#tip)\"/>"})
        EXPECT_GT(share_of_ink(draw_svg(drawing(inside), {400, 200})), 0.01) << inside;
}

TEST(Svg, RejectsInvalidPicturesAndSizes) {
    for (const char* text : {"", "no picture", "<svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><path</svg>"})
        EXPECT_THROW(draw_svg(text, {40, 20}), Error) << text;
    for (const char* text : {"", "<svg>", "<svg viewBox=\"0 0 0 10\">", "<svg viewBox=\"0 0 99999999999 10\">"})
        EXPECT_THROW(svg_size(text), Error) << text;
    for (const glm::ivec2 size : {glm::ivec2(0, 10), {10, -1}, {100000, 10}})
        EXPECT_THROW(draw_svg(drawing(""), size), Error) << size.x << "x" << size.y;
}

}  // namespace
}  // namespace relief
