// Finds labs, knobs, probes and checks by a part of their name. In the window module only.
#pragma once

#include <string>
#include <vector>

#include "framework/lab/knobs.h"
#include "framework/window/menu_layout.h"
#include "framework/window/menu_wish.h"

namespace relief {

class Checks;
class Stage;
struct Manifest;

class Search {
public:
    void open() { wanted_ = true; }
    void close() { closing_ = true; }
    bool is_open() const { return wanted_ || open_; }
    /// Enter or a click takes what is marked; up and down move the mark.
    void draw(float scale, const Stage& stage, const Checks& checks, MenuWish& wish);

private:
    struct Found {
        std::string kind, name, note;
        std::string place;  ///< another lab, or empty
        MenuWish wish;
    };
    /// What a lab has beside its title.
    static void add(const LabEntry& lab, const Manifest& manifest, const std::vector<KnobText>& knobs,
                    std::vector<Found>& all, const std::string& place);
    /// Once: what all labs have.
    void learn_of_labs();
    std::vector<Found> find(const Stage& stage, const Checks& checks) const;

    std::vector<Found> others_;
    bool wanted_ = false, open_ = false, closing_ = false;
    char text_[80] = "";
    int marked_ = 0;
};

}  // namespace relief
