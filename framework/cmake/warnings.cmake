# The warnings for the project's own code. CMAKE_COMPILE_WARNING_AS_ERROR turns them into errors.
add_library(relief_warnings INTERFACE)
target_compile_options(relief_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wold-style-cast
    -Woverloaded-virtual -Wduplicated-cond -Wlogical-op -Wformat=2
    # GCC 12 falsely reports overlaps (GCC bug 105651) and, after a precompiled header, overruns in std::string.
    -Wno-restrict $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow$<SEMICOLON>-Wno-array-bounds$<SEMICOLON>-Wno-stringop-overread>)
