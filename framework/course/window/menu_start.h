// The page with which the window starts: the sum of the points, and a picture of each lab with the points earned in it.
// In the window module only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/core/gl/texture.h"
#include "framework/course/window/menu_checks.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

class StartPage {
public:
    bool is_open() const { return open_; }
    /// Opens the page and marks this lab. Points are computed again if a file of their lab was saved since.
    void open(const LabEntry& marked);
    void close() { open_ = false; }

    /// Returns whether work is left for make_next().
    bool waits() const { return open_ && (loaded_ < cards_.size() || checked_ < cards_.size()); }
    /// Loads one picture. Once all are loaded, runs one check of one lab, which takes as long as `relief check` takes
    /// for it.
    void make_next();

    /// Draws the page over the whole window. A click on a card sets `wish.lab`.
    void draw(glm::ivec2 window, float scale, MenuWish& wish);
    /// Moves the mark by cards or by rows, and scrolls it into view.
    void move(int columns, int rows);
    const LabEntry& marked() const { return *cards_[marked_].lab; }

    /// The lab whose task a student has saved last, at least a minute after the course was unpacked; null if none.
    static const LabEntry* last_edited();

private:
    struct Card {
        const LabEntry* lab;
        std::optional<Texture> picture = {};  ///< absent if the lab has no reference screenshot that can be read
        glm::vec2 size{1};                    ///< of the picture, in pixels
        /// Without optional ones, for which a card has no room. Without points until the checks have run.
        std::vector<check::TaskVerdict> tasks = {};
        bool is_elective = false;  ///< no other lab needs it
        std::string points = {};   ///< empty until the checks have run
        Checks::Files files = {};  ///< with which they ran
        bool is_full() const;      ///< nothing is left to earn
    };
    void load(Card& card);
    void check_next();
    /// Returns the first lab from the one that was edited last on in which points are left to earn; null if none has.
    const LabEntry* next() const;
    void draw_sum(float scale, MenuWish& wish) const;
    void draw_card(size_t index, ImVec2 size, float scale, MenuWish& wish);

    bool open_ = false, seek_ = false;  ///< `seek_`: scroll to the marked card
    std::vector<Card> cards_;           ///< in the order of the labs
    const LabEntry* edited_ = nullptr;
    size_t marked_ = 0, loaded_ = 0, checked_ = 0;
    std::vector<size_t> rows_;  ///< as drawn: the number of cards in each row
    Checks checks_;             ///< of the lab that is being checked
};

}  // namespace relief::window
