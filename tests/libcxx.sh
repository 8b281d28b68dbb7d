#!/usr/bin/env bash
# Builds the course's code without GL with clang and LLVM's C++ library, as on macOS, and runs its tests.
#
#   tests/libcxx.sh
#
#   BUILD=build/libcxx     the folder of the build, which the next run continues
#
# Needs the Debian packages of the purposes build, staff, test and ci (framework/cmake/packages.txt), libc++-dev and
# libc++abi-dev. Takes about five minutes on two cores.
set -euo pipefail

course=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
build=${BUILD:-$course/build/libcxx}

say() { printf 'libcxx: %s\n' "$*" >&2; }

if ! echo '#include <version>' | clang++ -stdlib=libc++ -x c++ -fsyntax-only - 2>/dev/null; then
  say "cannot be run here, it needs: the Debian packages clang, libc++-dev and libc++abi-dev"
  exit 77  # "skipped", by the convention of automake
fi

step() { # what, command...
  local what=$1
  shift
  say "$what"
  "$@" >"$build/log" 2>&1 || { tail -30 "$build/log" >&2; say "failed: $what"; exit 1; }
}

# Debian's libraries in C++ are made for GCC's library: they are compiled here, or used as headers.
mkdir -p "$build"
with=(-G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++)
command -v ccache >/dev/null && with+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
step "configuring GoogleTest" cmake -S /usr/src/googletest -B "$build/googletest" "${with[@]}" \
  -DCMAKE_CXX_FLAGS=-stdlib=libc++ -DCMAKE_INSTALL_PREFIX="$build/usr"
step "building GoogleTest" ninja -C "$build/googletest" install
mkdir -p "$build/usr/lib/cmake/tomlplusplus"
echo 'add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)' \
  >"$build/usr/lib/cmake/tomlplusplus/tomlplusplusConfig.cmake"
step "configuring" cmake -S "$course" -B "$build" "${with[@]}" -DCMAKE_PREFIX_PATH="$build/usr" \
  -DCMAKE_CXX_FLAGS='-stdlib=libc++ -DFMT_HEADER_ONLY'
step "building" ninja -C "$build" cpu_tests
step "running the tests without GL" "$build/bin/cpu_tests"
say "all passed"
