# The warnings for the project's own code. CMAKE_COMPILE_WARNING_AS_ERROR turns them into errors.
add_library(relief_warnings INTERFACE)
target_compile_options(relief_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wold-style-cast
    -Woverloaded-virtual -Wformat=2)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  target_compile_options(relief_warnings INTERFACE -Wno-return-type-c-linkage)  # entry points of modules return C++
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(relief_warnings INTERFACE -Wduplicated-cond -Wlogical-op
    # GCC 12 falsely reports overlaps (GCC bug 105651) and, after a precompiled header, overruns in std::string.
    -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -Wno-stringop-overread)
endif()
