// A deck of slides: Marp Markdown that names pictures, plots, code and known mistakes; they are inserted by the
// course itself, so that no slide disagrees with what is built.
//
//     ![w:560 A wall by one tap](<shot 10 --set view=one --set method=offset>)
//     ![Time against error](<bench parallax --quick>)
//
// is the picture that this command of `relief` draws;
//
//     ```glsl shaders/10_parallax_offset/surface.frag lookup
//     ```
//
// the region `lookup` of that file (framework/check/starter.h); and
//
//     ```mistakes 10 --set view=one --size 400x400
//     v-flipped
//     not-divided
//     ```
//
// two slides with what lab 10 draws with each of these mistakes of its manifest, first without and then with their
// hints. A block ```measured (labs/README.md) becomes speaker's notes. A slide with `<!-- _class: solution -->` is
// shown only when solutions are wanted, and none but it may quote one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

/// A picture that a command of `relief` draws, without its -o.
struct DeckFigure {
    std::vector<std::string> command;
    std::string file;  ///< where the deck expects it, relative to itself
    int line = 0;      ///< of the deck that asks for it
};

struct Deck {
    std::string text;  ///< for Marp
    std::vector<DeckFigure> figures;
};

/// `name` is the folder of its pictures. Throws Error with the deck's file and line for a file, a region, a lab or a
/// mistake that is not there, and for a solution where it is not hidden.
Deck read_deck(const std::string& text, const std::filesystem::path& file, const std::string& name, bool solutions);

}  // namespace relief
