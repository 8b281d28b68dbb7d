#include "framework/core/lab/words.h"

namespace relief {
namespace {

int without_words = 0;

}  // namespace

WithoutWords::WithoutWords() { ++without_words; }
WithoutWords::~WithoutWords() { --without_words; }

bool has_words() { return without_words == 0; }

}  // namespace relief
