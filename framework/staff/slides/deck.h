// A deck of slides: Marp Markdown that names pictures, plots, code and known mistakes. They are generated from the
// course itself, so that slides always agree with the code.
//
//     ![w:560 A wall by one tap](<shot 10 --set view=one --set method=offset>)
//     ![Time against error](<bench parallax --quick>)
//
// becomes the picture that this command of `relief` draws. The words of a picture of a lab are laid over it as text, in
// letters that a class can read. Pictures of mistakes, and those behind a title (`![bg`), keep the words
// that the lab draws into them. A picture whose alternative text begins with the word `bare` has no words.
//
//     ```glsl shaders/10_parallax_offset/surface.frag lookup
//     ```
//
// becomes the region `lookup` of that file (framework/course/task/starter.h).
//
//     ```mistakes 10 --set view=one --size 400x400
//     v-flipped
//     not-divided
//     ```
//
// becomes two slides with lab 10's pictures of these mistakes of its manifest, first without and then with their hints.
// A block ```measured (labs/README.md) becomes speaker's notes. A slide with `<!-- _class: solution -->` is shown only
// if solutions are requested. Other slides must not quote a solution.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief::slides {

/// A picture drawn by a command of `relief`, given without its -o.
struct DeckFigure {
    std::vector<std::string> command;
    std::string file;  ///< path that the deck expects, relative to the deck
    int line = 0;      ///< line of the deck that requests it
    bool has_words = true;
};

struct Deck {
    std::string text;  ///< for Marp
    std::vector<DeckFigure> figures;
};

/// Reads a deck. `name` is the folder of its pictures. The entries of the bibliography that a slide cites become
/// speaker's notes. Throws Error with the deck's file and line if a file, a region,
/// a lab or a mistake is missing. Also throws if a slide that is not hidden quotes a solution.
Deck read_deck(const std::string& text, const std::filesystem::path& file, const std::string& name, bool solutions);

/// Returns a deck in which the picture `file` is followed by the markup of its words. Leaves a deck as it is if there
/// are no words, or if the picture is not an ordinary one.
std::string with_words(const std::string& deck, const std::string& file, const std::string& words);

/// Returns a deck in which the text of each drawing that moves (pages/svg.h) stands in its place. `drawings` is the
/// folder that the deck names `diagrams`. A script moves such a drawing only in the page itself.
std::string with_moving_drawings(const std::string& deck, const std::filesystem::path& drawings);

}  // namespace relief::slides
