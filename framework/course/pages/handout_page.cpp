#include "framework/course/pages/handout_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/file.h"
#include "framework/course/pages/lab_page.h"
#include "framework/course/pages/markdown_page.h"
#include "framework/course/pages/page.h"
#include "framework/course/pages/page_words.h"
#include "framework/course/pages/picture_words.h"
#include "framework/course/pages/sources.h"
#include "framework/course/pages/svg.h"

namespace relief::pages {
namespace {

namespace fs = std::filesystem;

PagePicture drawing_of(const std::string& svg, const fs::path& file) {
    try {
        // All drawings have one scale, so that their letters have one size. A file's drawing has a frame around it.
        constexpr double scale = 0.72, frame = 30;
        const glm::dvec2 size = scale * glm::dvec2(svg_size(svg));
        std::string moving;
        if (is_moving_drawing(svg))
            moving = fmt::format("<svg width=\"{:.0f}\"", size.x) + svg.substr(svg.find("<svg") + 4);
        return {.width = int(size.x + frame), .height = int(size.y + frame), .is_drawing = true, .moving = moving};
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
}

/// Returns the headings of the second level.
Value chapters_of(const List& blocks) {
    List chapters;
    for (const Value& block : blocks)
        if (block.fields.at("heading").text == "2")
            chapters.push_back(Fields{{"id", block.fields.at("id")}, {"title", block.fields.at("title")}});
    return rows(std::move(chapters));
}

/// Returns the page of a link in a file of a folder of the course, or nothing if it has none.
std::optional<std::string> page_of_link(const fs::path& folder, const std::string& target,
                                        std::span<const LabEntry* const> labs) {
    if (target.starts_with("https://") || target.starts_with("http://") || target.starts_with("#")) return target;
    const size_t hash = target.find('#');
    const fs::path file = (folder / target.substr(0, hash)).lexically_normal();
    for (const LabEntry* lab : labs)
        if (file == fs::path("labs") / lab->folder / "README.md")
            return handout_file(*lab) + (hash == std::string::npos ? "" : target.substr(hash));
    return {};
}

class Handout {
public:
    Handout(const LabEntry& lab, const Manifest& manifest, std::span<const LabEntry* const> labs, const PutPicture& put,
            const DrawGolden& draw)
        : lab_(lab), manifest_(manifest), labs_(labs), put_(put), draw_(draw), home_(fs::path("labs") / lab.folder) {}

    /// `in_words`: changes the handout's Markdown.
    List blocks(const std::function<std::string(const std::string&)>& in_words = {}) const {
        const PagePlaces places{
            .link = [this](const std::string& target) { return page_of_link(home_, target, labs_); },
            .picture = [this](const std::string& target) { return picture(target); }};
        const fs::path file = course_root() / home_ / "README.md";
        const std::string text = with_sources(read_file(file, size_t{1} << 24), load_sources(), file);
        return markdown_blocks(parse_markdown(in_words ? in_words(text) : text), places);
    }

    std::string page() const {
        List text = blocks();
        Value contents = chapters_of(text);
        const bool has_moving = std::any_of(text.begin(), text.end(), [](const Value& block) {
            const Value& figure = block.fields.at("figure");
            return figure.kind == Value::Kind::fields && figure.fields.at("moving").kind != Value::Kind::nothing;
        });
        return render(
            {.title = "Handout " + lab_.two_digits() + ": " + manifest_.title,
             .body = "handout",
             .styles = {"site", "markdown", "picture_words"},
             .scripts = has_moving ? std::vector<std::string>{"drawings"} : std::vector<std::string>(),
             .pictures = PagePictures::beside},
            {{"up", Fields{{"file", lab_page_file(lab_)}, {"title", lab_.two_digits() + " " + manifest_.title}}},
             {"contents", std::move(contents)},
             {"blocks", std::move(text)},
             {"previous", neighbour(-1)},
             {"next", neighbour(1)}});
    }

private:
    std::optional<PagePicture> picture(const std::string& target) const {
        const fs::path file = (home_ / target).lexically_normal();
        if (file.is_absolute() || file.begin()->string() == "..") return {};
        PagePicture shown;
        const std::string name = lab_.folder + "/handout-" + file.filename().string();
        if (file.extension() == ".svg") {
            const std::string svg = read_file(course_root() / file);
            shown = drawing_of(svg, file);
            if (!shown.moving.empty()) return shown;
            put_(name, svg);
        } else {
            const GoldenInfo* const golden = golden_of(file);
            std::optional<WordlessPicture> drawn = golden && draw_ ? draw_(*golden) : std::nullopt;
            if (!drawn) drawn = WordlessPicture{read_image(course_root() / file), {}};
            shown = {.width = drawn->image.width,
                     .height = drawn->image.height,
                     .command = golden ? command_of(*golden) : "",
                     .words = picture_words(drawn->words)};
            put_(name, encode_image(drawn->image, ImageFormat::png));
        }
        shown.file = name;
        return shown;
    }

    /// Returns nothing for a picture that is no reference screenshot of the lab.
    const GoldenInfo* golden_of(const fs::path& file) const {
        if (file.parent_path() != home_ / "golden") return nullptr;
        const auto golden = std::find_if(manifest_.goldens.begin(), manifest_.goldens.end(),
                                         [&](const GoldenInfo& one) { return one.name == file.stem().string(); });
        return golden == manifest_.goldens.end() ? nullptr : &*golden;
    }
    std::string command_of(const GoldenInfo& golden) const {
        return fmt::format("./relief shot {} {}", lab_.two_digits(), shot_text(golden.shot, manifest_.camera));
    }

    Value neighbour(int step) const {
        const auto here = std::find(labs_.begin(), labs_.end(), &lab_);
        const auto place = here - labs_.begin() + step;
        if (here == labs_.end() || place < 0 || place >= std::ptrdiff_t(labs_.size())) return {};
        const LabEntry& other = *labs_[size_t(place)];
        return Fields{
            {"file", handout_file(other)}, {"number", other.two_digits()}, {"title", load_manifest(other).title}};
    }

    const LabEntry& lab_;
    const Manifest& manifest_;
    std::span<const LabEntry* const> labs_;
    const PutPicture& put_;
    const DrawGolden& draw_;
    fs::path home_;
};

}  // namespace

std::string handout_file(const LabEntry& lab) { return lab.folder + "-handout.html"; }

List handout_blocks(const LabEntry& lab, const Manifest& manifest, std::span<const LabEntry* const> labs,
                    const PutPicture& put) {
    return Handout(lab, manifest, labs, put, {}).blocks(in_page_words);
}

std::string handout_page(const LabEntry& lab, const Manifest& manifest, std::span<const LabEntry* const> labs,
                         const PutPicture& put, const DrawGolden& draw) {
    return Handout(lab, manifest, labs, put, draw).page();
}

std::string text_page(const fs::path& file, std::span<const LabEntry* const> labs) {
    const PagePlaces places{
        .link = [&](const std::string& target) { return page_of_link(file.parent_path(), target, labs); },
        .picture = [](const std::string&) { return std::optional<PagePicture>(); }};
    const std::vector<Block> text = parse_markdown(read_file(course_root() / file, size_t{1} << 24));
    List blocks = markdown_blocks(text, places);
    Value contents = chapters_of(blocks);
    return render(
        {.title = "Relief: " + (text.empty() ? "" : plain_text(text.front().spans)),
         .body = "handout",
         .styles = {"site", "markdown"},
         .scripts = {},
         .pictures = PagePictures::beside},
        {{"up", ""}, {"contents", std::move(contents)}, {"blocks", std::move(blocks)}, {"previous", ""}, {"next", ""}});
}

}  // namespace relief::pages
