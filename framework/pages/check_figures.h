// A check's pictures in a page: what was drawn, what is expected with a wipe between the two, and where they differ.
#pragma once

#include <string>

#include "framework/check/check.h"
#include "framework/pages/template.h"

namespace relief {

/// In words: "out of time".
std::string outcome_words(Outcome outcome);
/// The same for {{> badge}}, with a sign and a colour of its own; with `count`, of so many.
Fields badge(Outcome outcome, size_t count = 0);

/// Whose picture it is, as the page calls it: the reader's own, or that of somebody's submission.
enum class DrawnBy { reader, submission };

/// Two images of a check as pictures, in the same colours, and where both are, a map of where they differ.
struct ComparedImages {
    Image drawn, expected, difference;  ///< 8-bit RGB, or empty
    std::string differs;                ///< how much they do, in words
    std::string largest;                ///< what the map's last colour stands for
    Value scale;                        ///< of the map
};
/// `probe`: what the images hold; nullptr where they are a lab's pictures. Their values can be anything. The map's last
/// colour stands for what 99 % of the pixels keep, and for no less than `allowed`, in the probe's unit; pixels that have a
/// surface in one image only have that colour, too.
ComparedImages compare_images(const ProbeInfo* probe, const Image& drawn, const Image& expected, double allowed = 0);

/// The largest of a check's limits: differences up to it need not be seen.
double largest_limit(const Limits& limits);

/// For {{> check_figures}}: where both pictures are, they are shown alike and with a map of the difference; an empty
/// picture is left out. What was drawn need not be trusted: values may be anything. Without scripts the pictures lie
/// side by side.
Fields check_figures(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected,
                     DrawnBy who);

}  // namespace relief
