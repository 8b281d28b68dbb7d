# The libraries for Windows, under the names that CMake's and pkg-config's files give them on Linux. Libraries of headers
# are taken from this system's packages. The others are compiled from Debian's own source archives.
include(FetchContent)

# A header needs a folder of its own: a cross compiler must not see any other header of this system.
set(headers ${PROJECT_BINARY_DIR}/generated/headers)
function(relief_take_headers target place test_file)
  string(MAKE_C_IDENTIFIER "RELIEF_HEADERS_${place}" found)
  find_path(${found} ${test_file} REQUIRED NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include)
  get_filename_component(parent ${headers}/${place} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  if(NOT EXISTS ${headers}/${place})
    file(CREATE_LINK ${${found}}/${place} ${headers}/${place} SYMBOLIC)
  endif()
  if(NOT TARGET ${target})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
  endif()
  target_include_directories(${target} SYSTEM INTERFACE ${headers})
endfunction()
relief_take_headers(fmt::fmt fmt fmt/format.h)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY=1)
relief_take_headers(fmt::fmt glm glm/glm.hpp)
relief_take_headers(CLI11::CLI11 CLI CLI/CLI.hpp)
relief_take_headers(tomlplusplus::tomlplusplus toml++ toml++/toml.h)
relief_take_headers(nlohmann_json::nlohmann_json nlohmann nlohmann/json.hpp)
relief_take_headers(relief_mustache kainjow kainjow/mustache.hpp)
set(RELIEF_MUSTACHE ${headers})

# Reads the version of a library of headers, from the last numbers in the lines of a file that match a pattern.
function(relief_version library file pattern)
  file(STRINGS ${headers}/${file} lines REGEX "define ${pattern}")
  list(TRANSFORM lines REPLACE "^#define +[A-Z0-9_]+[^0-9]+([0-9.]+).*" "\\1")
  list(JOIN lines . version)
  set(${library}_VERSION ${version} PARENT_SCOPE)
endfunction()
relief_version(glm glm/detail/setup.hpp "GLM_VERSION_(MAJOR|MINOR|PATCH|REVISION)[ \t]+[0-9]")
relief_version(CLI11 CLI/Version.hpp "CLI11_VERSION ")
relief_version(tomlplusplus toml++/impl/version.h "TOML_LIB_(MAJOR|MINOR|PATCH)")
relief_version(fmt fmt/core.h "FMT_VERSION ")

# Fetches a source archive of Debian 12. Nothing in it is added to the build here.
function(relief_fetch name file hash)
  FetchContent_Declare(${name} SOURCE_SUBDIR none URL_HASH SHA256=${hash} DOWNLOAD_EXTRACT_TIMESTAMP OFF
    URL https://deb.debian.org/debian/pool/main/${file}
    https://snapshot.debian.org/archive/debian/20251101T000000Z/pool/main/${file})
  FetchContent_MakeAvailable(${name})
  set(${name}_SOURCE_DIR ${${name}_SOURCE_DIR} PARENT_SCOPE)
endfunction()
function(relief_compile target alias)
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${ARGN})
  add_library(${alias} ALIAS ${target})
  target_compile_options(${target} PRIVATE -w)
endfunction()

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

relief_fetch(md4c m/md4c/md4c_0.4.8.orig.tar.gz 4a457df853425b6bb6e3457aa1d1a13bccec587a04c38c622b1013a0da41439f)
relief_compile(relief_md4c PkgConfig::md4c ${md4c_SOURCE_DIR}/src/md4c.c)
target_include_directories(relief_md4c SYSTEM PUBLIC ${md4c_SOURCE_DIR}/src)
set(md4c_VERSION 0.4.8)

relief_take_headers(relief_tinyobj tiny_obj_loader.h tiny_obj_loader.h)
file(WRITE ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp.new
  "#define TINYOBJLOADER_IMPLEMENTATION\n#include <tiny_obj_loader.h>\n")
file(COPY_FILE ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp.new ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp
  ONLY_IF_DIFFERENT)
relief_compile(relief_tinyobjloader tinyobjloader::tinyobjloader ${PROJECT_BINARY_DIR}/generated/tinyobjloader.cpp)
target_link_libraries(relief_tinyobjloader PUBLIC relief_tinyobj)

relief_fetch(imgui i/imgui/imgui_1.86+ds.orig.tar.xz 0dace0e8e57d298eb6e93af12dc19420cb96330832f6495c733b90aeeef11f64)
set(stem ${imgui_SOURCE_DIR}/imgui)
relief_compile(relief_imgui PkgConfig::imgui ${stem}.cpp ${stem}_draw.cpp ${stem}_tables.cpp ${stem}_widgets.cpp
  ${imgui_SOURCE_DIR}/backends/imgui_impl_glfw.cpp ${imgui_SOURCE_DIR}/backends/imgui_impl_opengl3.cpp)
target_include_directories(relief_imgui SYSTEM PUBLIC ${imgui_SOURCE_DIR})
target_include_directories(relief_imgui SYSTEM PRIVATE ${imgui_SOURCE_DIR}/backends)

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
target_link_libraries(relief_imgui PUBLIC glfw)
set(glfw3_VERSION 3.3.8)
set(imgui_VERSION 1.86)
