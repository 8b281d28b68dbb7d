// A whole web page of the course: its template in a frame with style sheets and scripts, its pictures inside or beside.
#pragma once

#include <filesystem>
#include <string>

#include "framework/base/error.h"
#include "framework/image/image.h"
#include "framework/pages/template.h"

namespace relief {

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

/// A page that consists of files: see template.h.
struct Page {
    std::string title;
    std::string body;                          ///< its template
    std::vector<std::string> styles, scripts;  ///< after colors.css and page.css
    PagePictures pictures = PagePictures::inside;
};
/// A whole page in which the browser lets nothing else happen: no picture from elsewhere, no other address, no other
/// script.
std::string render(const Page& page, Fields values);

}  // namespace relief
