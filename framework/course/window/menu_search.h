// Finds labs, knobs and their values, probes, checks, headings of handouts and words of the glossary by a part of their
// name. In the window module only.
#pragma once

#include <string>
#include <vector>

#include "framework/core/lab/knobs.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_wish.h"

namespace relief {
struct Manifest;
}

namespace relief::window {

class Checks;
class Stage;

class Search {
public:
    void open() { wanted_ = true; }
    void close() { closing_ = true; }
    bool is_open() const { return wanted_ || open_; }
    /// Moves the mark, by rows.
    void move(int rows) { marked_ += rows; }
    /// Takes the marked result as soon as all typed letters have reached the text field.
    void take() { taking_ = true; }
    /// Draws the search. A click takes a result, too.
    void draw(float scale, const Stage& stage, const Checks& checks, MenuWish& wish);

private:
    struct Found {
        std::string kind, name, note;
        std::string place;   ///< the lab, if another one; else empty
        std::string option;  ///< the name of a knob
        MenuWish wish;
    };
    /// Adds the knobs, probes and checks of a lab.
    static void add(const LabEntry& lab, const Manifest& manifest, const std::vector<KnobText>& knobs,
                    std::vector<Found>& all, const std::string& place);
    /// Adds the headings of a lab's handout.
    static void add_headings(const LabEntry& lab, std::vector<Found>& all, const std::string& place);
    /// Adds the words of the glossary.
    static void add_words(std::vector<Found>& all);
    /// Collects the contents of all labs, once.
    void learn_of_labs();
    std::vector<Found> find(const Stage& stage, const Checks& checks) const;

    std::vector<Found> others_;
    bool wanted_ = false, open_ = false, closing_ = false, taking_ = false;
    char text_[80] = "";
    int marked_ = 0;
};

}  // namespace relief::window
