// Versions of this build's components, filled in by framework/cmake/versions.cpp.in.
#pragma once

namespace relief::versions {

extern const char* const relief;  ///< the project's version
extern const char* const commit;  ///< the source folder's commit when the build was configured
extern const char* const compiler;
extern const char* const libraries;  ///< with their versions

}  // namespace relief::versions
