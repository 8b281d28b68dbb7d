// Which of four known mistakes made this picture? Questions for everybody, from public views and hints alone.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/staff/grade/mistake_pictures.h"

namespace relief::grade {

/// Returns four indices, `asked` first, of mistakes with different hints, so that the picture of `asked` tells which
/// one it is: it differs visibly from the right picture and from those of the other three. Returns nothing if there are
/// no such four. A mistake without a picture is no choice. Prefers hints with few words in common. See distinct_share.
std::vector<size_t> choices_beside(size_t asked, const Image& right, std::span<const Image> pictures,
                                   const std::vector<std::string>& hints);

struct MistakeRiddle {
    struct Choice {
        std::string hint;
        Image picture;  ///< what the mistake of the hint draws
    };
    const CheckInfo* check = nullptr;  ///< public; it has the view
    bool is_probe = false;             ///< the pictures show the check's probe as colours
    Image right = {};                  ///< 8-bit, as those of the choices
    std::vector<Choice> choices = {};  ///< four
    size_t answer = 0;                 ///< index of the choice whose picture is shown
};

/// Returns a riddle about a task in a shader, the same with each call; nothing if no public view of the task shows one.
/// Prefers a lit picture to a probe, and then the mistake of the task that changes most of the picture. `side`: the
/// longer side of the pictures, in pixels. Needs a current context.
std::optional<MistakeRiddle> riddle_of(MistakePictures& pictures, const LabEntry& lab, const TaskInfo& task, int side);

}  // namespace relief::grade
