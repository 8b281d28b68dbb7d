#include "framework/core/base/unfinished.h"

#include "framework/core/base/error.h"

namespace relief {

void unfinished(const char* task, const char* file, int line) {
    throw Error({file, line}, "task " + std::string(task) + " is not written yet");
}

}  // namespace relief
