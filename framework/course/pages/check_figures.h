// A check's pictures in a page: the drawn and the expected one with a wipe between them, and a map of their difference.
#pragma once

#include <set>
#include <string>

#include "framework/course/check/check.h"
#include "framework/course/pages/template.h"

namespace relief::pages {

/// Returns the outcome in words: "out of time".
std::string outcome_words(check::Outcome outcome);
/// Returns the fields of {{> badge}}: the outcome in words, with a sign and a colour of its own. Shows `count` if it is
/// not 0.
Fields badge(check::Outcome outcome, size_t count = 0);

/// The owner of a drawn picture, as the page names it: the reader, or somebody's submission.
enum class DrawnBy { reader, submission };

/// Two images of a check as pictures in the same colours. If their shapes agree, there is a map of their difference.
struct ComparedImages {
    Image drawn, expected, difference;  ///< 8-bit RGB, or empty
    std::string differs;                ///< the size of the difference, in words
    std::string largest;                ///< the error of the map's last colour
    Value scale;                        ///< the scale below the map
};
/// Compares two images. `probe` describes their values, which can be anything; nullptr if they are a lab's pictures.
/// The map's last colour stands for the 99 % quantile of the errors, but at least for `allowed`, in the probe's unit.
/// Pixels with a surface in only one of the images get that colour, too.
ComparedImages compare_images(const ProbeInfo* probe, const Image& drawn, const Image& expected, double allowed = 0);

/// Returns the largest of a check's limits. Differences up to it need not be visible.
double largest_limit(const Limits& limits);

/// Returns the fields of {{> check_figures}}. If both pictures exist, they have the same colours, and there is a map of
/// their difference; an empty picture is omitted, as is `related`: see check::Verdict. `drawn` is untrusted: its
/// values can be anything. Without scripts the pictures are side by side.
Fields check_figures(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected,
                     DrawnBy who, const Image& related = {});
/// Removes the sentence about the probe's colours from the fields of check_figures() if `told` has the probe. Otherwise
/// adds the probe to `told`.
void tell_once(Fields& figures, std::set<std::string>& told);

}  // namespace relief::pages
