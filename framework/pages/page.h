// Shared parts of the course's web pages: escaped text, embedded pictures, a style for light and for dark screens.
#pragma once

#include <filesystem>
#include <string>

#include "framework/base/error.h"
#include "framework/image/image.h"

namespace relief {

/// A text as it may stand in a page, between tags or in a quoted attribute.
std::string html(const std::string& text);
/// The same, with `code` between backticks set as code: that much Markdown a hint has.
std::string html_with_code(const std::string& text);

/// An 8-bit picture as a URI that has all of it, for an attribute.
std::string picture_uri(const Image& picture);

/// What lies beside a page cannot be written: an end to the whole page, not a problem of one of its parts.
struct CannotWrite : Error {
    using Error::Error;
};
/// A file beside a page, in a folder that is made. Throws CannotWrite.
void write_beside_page(const std::filesystem::path& file, const std::string& bytes);

/// Where a page's pictures are: in it (picture_uri()), or files beside it.
enum class PagePictures { inside, beside };

/// A whole page in which the browser lets nothing else happen: no picture from elsewhere, no other address, no script
/// but `script`. `style` is added to the common one, which names the colours: --ground, --card, --text, --quiet,
/// --accent, --good, --bad, --open, --line, --code.
std::string closed_page(const std::string& title, const std::string& style, const std::string& body,
                        const std::string& script, PagePictures pictures = PagePictures::inside);

}  // namespace relief
