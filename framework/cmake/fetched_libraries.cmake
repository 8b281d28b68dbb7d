# The libraries for a system other than this one, under the names that CMake's and pkg-config's files give them on Linux.
# Libraries of headers are taken from this system's packages. The others are compiled from Debian's own source archives.
include(framework/cmake/fetch.cmake)

# A header needs a folder of its own: a cross compiler must not see any other header of this system.
set(headers ${PROJECT_BINARY_DIR}/generated/headers)
if(NOT CMAKE_CROSSCOMPILING)  # in MSYS2, the compiler finds them
  set(headers $ENV{MINGW_PREFIX}/include)
endif()
function(relief_take_headers target place test_file)
  if(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
  endif()
  if(NOT CMAKE_CROSSCOMPILING)
    return()
  endif()
  string(MAKE_C_IDENTIFIER "RELIEF_HEADERS_${place}" found)
  find_path(${found} ${test_file} REQUIRED NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include)
  get_filename_component(parent ${headers}/${place} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  if(NOT EXISTS ${headers}/${place})
    file(CREATE_LINK ${${found}}/${place} ${headers}/${place} SYMBOLIC)
  endif()
  target_include_directories(${target} SYSTEM INTERFACE ${headers})
endfunction()
relief_take_headers(fmt::fmt fmt fmt/format.h)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY=1)
relief_take_headers(fmt::fmt glm glm/glm.hpp)
relief_take_headers(tomlplusplus::tomlplusplus toml++ toml++/toml.h)
relief_take_headers(nlohmann_json::nlohmann_json nlohmann nlohmann/json.hpp)

# Reads the version of a library of headers, from the last numbers in the lines of a file that match a pattern.
function(relief_version library file pattern)
  if(NOT EXISTS ${headers}/${file})
    set(${library}_VERSION "of another form" PARENT_SCOPE)
    return()
  endif()
  file(STRINGS ${headers}/${file} lines REGEX "define ${pattern}")
  list(TRANSFORM lines REPLACE "^#define +[A-Z0-9_]+[^0-9]+([0-9.]+).*" "\\1")
  list(JOIN lines . version)
  set(${library}_VERSION ${version} PARENT_SCOPE)
endfunction()
relief_version(glm glm/detail/setup.hpp "GLM_VERSION_(MAJOR|MINOR|PATCH|REVISION)[ \t]+[0-9]")
relief_version(tomlplusplus toml++/impl/version.h "TOML_LIB_(MAJOR|MINOR|PATCH)")
relief_version(fmt fmt/core.h "FMT_VERSION ")

relief_fetch(zlib z/zlib/zlib_1.2.13.dfsg.orig.tar.bz2 71feb7947e3c00ef125f83b79a4e529bde31171e5babe48b391f06758d1ab0a1)
file(GLOB sources ${zlib_SOURCE_DIR}/*.c)
relief_compile(relief_zlib ZLIB::ZLIB ${sources})
target_include_directories(relief_zlib SYSTEM PUBLIC ${zlib_SOURCE_DIR})
set(ZLIB_VERSION_STRING 1.2.13)

relief_fetch(libpng libp/libpng1.6/libpng1.6_1.6.39.orig.tar.gz
  a00e9d2f2f664186e4202db9299397f851aea71b36a35e74910b8820e380d441)
file(GLOB sources ${libpng_SOURCE_DIR}/png*.c)
list(FILTER sources EXCLUDE REGEX "pngtest\\.c$")
relief_compile(relief_png PNG::PNG ${sources})
set(settings ${PROJECT_BINARY_DIR}/generated/libpng)
configure_file(${libpng_SOURCE_DIR}/scripts/pnglibconf.h.prebuilt ${settings}/pnglibconf.h COPYONLY)
target_include_directories(relief_png SYSTEM PUBLIC ${libpng_SOURCE_DIR} ${settings})
target_link_libraries(relief_png PUBLIC relief_zlib)
set(PNG_VERSION_STRING 1.6.39)

if(NOT CMAKE_CROSSCOMPILING)
  return()  # rare_libraries.cmake fetches it
endif()
set(tinyobjloader_FOUND ON)
relief_take_headers(relief_tinyobj tiny_obj_loader.h tiny_obj_loader.h)
file(WRITE ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp.new
  "#define TINYOBJLOADER_IMPLEMENTATION\n#include <tiny_obj_loader.h>\n")
file(COPY_FILE ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp.new ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp
  ONLY_IF_DIFFERENT)
relief_compile(relief_tinyobjloader tinyobjloader::tinyobjloader ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp)
target_link_libraries(relief_tinyobjloader PUBLIC relief_tinyobj)
