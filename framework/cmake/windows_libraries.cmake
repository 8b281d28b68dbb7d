# What Windows needs beyond the libraries of a browser.
include(framework/cmake/fetched_libraries.cmake)
relief_take_headers(CLI11::CLI11 CLI CLI/CLI.hpp)
relief_version(CLI11 CLI/Version.hpp "CLI11_VERSION ")
if(CMAKE_CROSSCOMPILING)
  relief_take_headers(relief_mustache kainjow kainjow/mustache.hpp)
  set(RELIEF_MUSTACHE ${headers})
endif()

relief_fetch(md4c m/md4c/md4c_0.4.8.orig.tar.gz 4a457df853425b6bb6e3457aa1d1a13bccec587a04c38c622b1013a0da41439f)
relief_compile(relief_md4c PkgConfig::md4c ${md4c_SOURCE_DIR}/src/md4c.c)
target_include_directories(relief_md4c SYSTEM PUBLIC ${md4c_SOURCE_DIR}/src)
set(md4c_VERSION 0.4.8)

include(framework/cmake/rare_libraries.cmake)
FetchContent_Declare(glfw URL_HASH SHA256=f30f42e05f11e5fc62483e513b0488d5bceeab7d9c5da0ffe2252ad81816c713
  URL https://deb.debian.org/debian/pool/main/g/glfw3/glfw3_3.3.8.orig.tar.gz
  https://snapshot.debian.org/archive/debian/20251101T000000Z/pool/main/g/glfw3/glfw3_3.3.8.orig.tar.gz
  DOWNLOAD_EXTRACT_TIMESTAMP OFF)
foreach(part DOCS TESTS EXAMPLES)
  set(GLFW_BUILD_${part} OFF CACHE INTERNAL "")
endforeach()
set(GLFW_INSTALL OFF CACHE INTERNAL "")
FetchContent_MakeAvailable(glfw)
target_compile_options(glfw PRIVATE -w)
set(glfw3_VERSION 3.3.8)

# The menu finds its fonts beside the program.
if(NOT CMAKE_CROSSCOMPILING)
  file(COPY $ENV{MINGW_PREFIX}/share/fonts/TTF/ DESTINATION ${PROJECT_BINARY_DIR}/bin/fonts FILES_MATCHING
    PATTERN DejaVu*.ttf)
endif()
