// Pictures without words, for pages that have the words beside them.
#pragma once

namespace relief {

/// While one exists, labs draw no text and no scales over their pictures.
class WithoutWords {
public:
    WithoutWords();
    ~WithoutWords();
    WithoutWords(const WithoutWords&) = delete;
    WithoutWords& operator=(const WithoutWords&) = delete;
};

bool has_words();

}  // namespace relief
