// The labs in a browser: a page a lab, with the module, the lab's files and an editor. The files come from a students'
// course, so a site holds no hidden checks and no exact values, and no solutions if the teacher does not ask for them.
#pragma once

#include <filesystem>

namespace relief::web {

/// The sources of a site.
struct LiveSite {
    std::filesystem::path course;  ///< a students' course: see write_handout()
    std::filesystem::path module;  ///< folder of relief.js and relief.wasm, compiled from that course
    std::filesystem::path editor;  ///< the bundle of framework/staff/web/editor.js
    /// Folder of the compiler for tasks in C++, as pack_compiler.mjs writes it. Empty: such tasks are not in the site.
    std::filesystem::path compiler;
    /// Whether the site has the solution of each task and a correct variant, which a page offers with all points.
    bool solutions = false;
    std::filesystem::path folder;  ///< the site
};

/// Adds live_page_file() of each lab in the course, and all that these pages fetch, to a site that has handouts'
/// pictures already. Throws Error if a file cannot be read or written.
void write_live_pages(const LiveSite& site);

}  // namespace relief::web
