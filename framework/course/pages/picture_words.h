// Words over a picture that was drawn without them.
#pragma once

#include <span>

#include "framework/core/lab/words.h"
#include "framework/course/pages/template.h"

namespace relief::pages {

/// Returns the fields of {{> picture_words}}. The template stands right after the picture, in the same element of class
/// `worded`. Empty without words.
Value picture_words(std::span<const PictureWord> words);

/// Returns that markup by itself.
std::string picture_words_markup(std::span<const PictureWord> words);

/// Returns the words below an error map of visualize_error(), whose last colour is `largest`, such as "2.5 texels".
PictureWord error_map_scale(const std::string& largest);

}  // namespace relief::pages
