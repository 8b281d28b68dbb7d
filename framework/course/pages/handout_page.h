// A lab's handout as a page of the course's web site: contents, figures with the command that draws them, and links to
// the next and previous handout.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "framework/core/image/image.h"
#include "framework/core/lab/words.h"
#include "framework/course/manifest/manifest.h"
#include "framework/course/pages/template.h"

namespace relief::pages {

/// Returns the page's file name, such as "05_tangent_basis-handout.html".
std::string handout_file(const LabEntry& lab);

/// Takes a picture's name and bytes, to be written beside the page.
using PutPicture = std::function<void(const std::string& name, const std::string& bytes)>;

/// A reference screenshot without its words.
struct WordlessPicture {
    Image image;
    std::vector<PictureWord> words;
};
/// Draws a reference screenshot. Returns nothing if the page should show the stored one.
using DrawGolden = std::function<std::optional<WordlessPicture>(const GoldenInfo& golden)>;

/// Returns the handout's text in_page_words(), for {{#blocks}}{{> block}}{{/blocks}}, otherwise as for handout_page().
List handout_blocks(const LabEntry& lab, const Manifest& manifest, std::span<const LabEntry* const> labs,
                    const PutPicture& put);

/// Returns the page. `labs` are all labs with a page, in order. `put` writes a file of that name beside the page.
/// The words of pictures by `draw` are laid over them as text. Throws Error for a missing picture and for an invalid
/// formula.
std::string handout_page(const LabEntry& lab, const Manifest& manifest, std::span<const LabEntry* const> labs,
                         const PutPicture& put, const DrawGolden& draw);

/// Returns a page of another Markdown file of the course, without pictures. `file` is relative to the course's top
/// folder. Links to the handouts of `labs` lead to their pages.
std::string text_page(const std::filesystem::path& file, std::span<const LabEntry* const> labs);

}  // namespace relief::pages
