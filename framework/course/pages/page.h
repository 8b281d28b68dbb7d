// A whole web page of the course: its template in a frame with style sheets and scripts. Pictures are embedded or
// beside it.
#pragma once

#include <filesystem>
#include <string>

#include "framework/core/base/error.h"
#include "framework/core/image/image.h"
#include "framework/course/pages/template.h"

namespace relief::pages {

/// Returns an 8-bit picture as a data URI, for an attribute.
std::string picture_uri(const Image& picture);

/// Thrown if a file beside a page cannot be written. It ends the whole page: it is not a problem of one of its parts.
struct CannotWrite : Error {
    using Error::Error;
};
/// Writes a file beside a page, and makes its folder. Throws CannotWrite.
void write_beside_page(const std::filesystem::path& file, const std::string& bytes);

/// The place of a page's pictures: in the page (picture_uri()), or in files beside it.
enum class PagePictures { inside, beside };

/// A page made of template files: see template.h.
struct Page {
    std::string title;
    std::string body;                          ///< name of its template
    std::vector<std::string> styles, scripts;  ///< after colors.css and page.css
    PagePictures pictures = PagePictures::inside;
};
/// Returns a whole page. Its content security policy blocks everything else: other scripts, other addresses, and
/// pictures from elsewhere.
std::string render(const Page& page, Fields values);

}  // namespace relief::pages
