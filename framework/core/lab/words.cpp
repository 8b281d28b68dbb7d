#include "framework/core/lab/words.h"

#include <iterator>

namespace relief {
namespace {

WithoutWords* latest = nullptr;

}  // namespace

WithoutWords::WithoutWords() : outer_(latest) { latest = this; }
WithoutWords::~WithoutWords() { latest = outer_; }

bool has_words() { return !latest; }

void leave_out(std::vector<PictureWord> words) {
    latest->words_.insert(latest->words_.end(), std::make_move_iterator(words.begin()),
                          std::make_move_iterator(words.end()));
}

}  // namespace relief
