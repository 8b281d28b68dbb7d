# A toolchain file: compiles for a browser, with Emscripten (Debian's package of that name).
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
# All objects need the same kind of exceptions. libpng's longjmp takes their form too.
set(exceptions "-fwasm-exceptions -sSUPPORT_LONGJMP=wasm")
foreach(kind C_FLAGS CXX_FLAGS EXE_LINKER_FLAGS)
  set(CMAKE_${kind}_INIT ${exceptions})
endforeach()
# -O3 makes the module larger and no faster to use.
foreach(language C CXX)
  set(CMAKE_${language}_FLAGS_RELEASE_INIT "-O2 -DNDEBUG")
  set(CMAKE_${language}_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
endforeach()
