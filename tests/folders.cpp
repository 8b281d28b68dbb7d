#include "tests/support.h"

namespace relief {

const char* const source_folder = RELIEF_SOURCE_FOLDER;
const char* const build_folder = RELIEF_BUILD_FOLDER;

}  // namespace relief
