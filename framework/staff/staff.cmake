# The code that stays with the staff, in two libraries. librelief-truth has the exact values: programs are linked to it if
# it exists. librelief-staff has all else: a program opens it at the first of its commands, which it registers itself.

# Links no GL.
file(GLOB reference_sources CONFIGURE_DEPENDS framework/staff/reference/*.cpp)
add_library(relief_reference OBJECT ${reference_sources})
target_link_libraries(relief_reference PUBLIC relief_cpu PRIVATE nlohmann_json::nlohmann_json relief_warnings)
# Suppresses the warning about the ABI of vector arguments: all functions that take them are inlined.
set_source_files_properties(framework/staff/reference/normals_row.cpp PROPERTIES COMPILE_OPTIONS -Wno-psabi)
relief_takes_precompiled_headers(relief_reference)
relief_in_batches(relief_reference)
add_library(relief_truth SHARED $<TARGET_OBJECTS:relief_reference>)
set_target_properties(relief_truth PROPERTIES OUTPUT_NAME relief-truth)
target_link_libraries(relief_truth PUBLIC relief_framework)
relief_shows_only(library relief_truth)

pkg_check_modules(libseccomp IMPORTED_TARGET libseccomp)
pkg_check_modules(libarchive IMPORTED_TARGET libarchive)
pkg_check_modules(glib IMPORTED_TARGET glib-2.0)
if(NOT libseccomp_FOUND OR NOT libarchive_FOUND OR NOT glib_FOUND)
  if(RELIEF_TESTS)
    message(FATAL_ERROR "the tests need libseccomp, libarchive and GLib: framework/cmake/packages.txt names the packages")
  endif()
  message(STATUS "bench, grade, handout, slides, mistakes and synctest are not built: see framework/cmake/packages.txt")
  return()
endif()

file(GLOB staff_sources CONFIGURE_DEPENDS framework/staff/*/*.cpp labs/*/staff/bench.cpp)
list(FILTER staff_sources EXCLUDE REGEX "(staff/reference/.*|grade/(libarchive|glib)|measure/peers_module)\\.cpp$")
add_library(relief_staff SHARED ${staff_sources})
set_target_properties(relief_staff PROPERTIES OUTPUT_NAME relief-staff)
target_link_libraries(relief_staff PUBLIC relief_truth
  PRIVATE tomlplusplus::tomlplusplus nlohmann_json::nlohmann_json PkgConfig::libseccomp relief_warnings)
relief_takes_precompiled_headers(relief_staff)
relief_is_compiled_for_size(relief_staff ${staff_sources})
relief_in_batches(relief_staff)
# The grader compiles C++ tasks with the build's compiler.
set_source_files_properties(framework/staff/grade/stage.cpp PROPERTIES COMPILE_DEFINITIONS
  "RELIEF_COMPILER=\"${CMAKE_CXX_COMPILER}\";RELIEF_BUILD_FOLDER=\"${PROJECT_BINARY_DIR}\"")

# Opened when an archive is graded.
add_library(relief_archive MODULE framework/staff/grade/libarchive.cpp)
target_link_libraries(relief_archive PRIVATE relief_staff PkgConfig::libarchive relief_warnings)
set_target_properties(relief_archive PROPERTIES PREFIX "" OUTPUT_NAME relief-archive)
set(RELIEF_STAFF_MODULES relief_archive)
# Opened when a name is not ASCII.
add_library(relief_unicode MODULE framework/staff/grade/glib.cpp)
target_link_libraries(relief_unicode PRIVATE relief_staff PkgConfig::glib relief_warnings)
set_target_properties(relief_unicode PROPERTIES PREFIX "" OUTPUT_NAME relief-unicode)
list(APPEND RELIEF_STAFF_MODULES relief_unicode)
# Opened when `relief bench` measures other libraries for the same purpose. Without them it omits these rows.
pkg_check_modules(assimp IMPORTED_TARGET assimp)
find_package(embree 4 QUIET)  # Debian 13
if(NOT embree_FOUND)
  find_package(embree 3 QUIET)  # Debian 12
endif()
if(assimp_FOUND AND embree_FOUND AND openimageio_FOUND)
  add_library(relief_peers MODULE framework/staff/measure/peers_module.cpp)
  target_link_libraries(relief_peers PRIVATE relief_staff PkgConfig::assimp PkgConfig::openimageio embree relief_warnings)
  target_compile_definitions(relief_peers PRIVATE RELIEF_EMBREE=${embree_VERSION_MAJOR})
  set_target_properties(relief_peers PROPERTIES PREFIX "" OUTPUT_NAME relief-peers)
  list(APPEND RELIEF_STAFF_MODULES relief_peers)
endif()
relief_shows_only(library relief_staff)
relief_shows_only(module ${RELIEF_STAFF_MODULES})
