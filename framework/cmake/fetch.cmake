# Functions for libraries that are compiled here, from Debian's own source archives.
include(FetchContent)

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
