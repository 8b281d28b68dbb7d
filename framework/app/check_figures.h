// A check's pictures in a page: what was drawn, what is expected with a wipe between the two, and where they differ.
#pragma once

#include <string>

#include "framework/grade/check.h"

namespace relief {

/// As people read it: "out of time".
std::string outcome_words(Outcome outcome);
/// The same with a sign and a colour of its own; with `count`, of so many.
std::string outcome_badge(Outcome outcome, size_t count = 0);
extern const char* const badge_style;

/// Whose picture it is, as the page calls it: the reader's own, or that of somebody's submission.
enum class DrawnBy { reader, submission };

/// Where both pictures are, they are shown alike and with a map of the difference; an empty picture is left out. What
/// was drawn need not be trusted: values may be anything.
std::string check_figures(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected,
                          DrawnBy who);

/// For closed_page(): the look of checks, their badges and figures, and what makes the wipe. Without the script the
/// pictures lie side by side.
std::string check_style();
std::string check_script();

}  // namespace relief
