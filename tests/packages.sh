#!/usr/bin/env bash
# Makes the students' ZIP file for Windows and their Debian package, and runs both, the first under Wine: pictures must
# equal those of the build to the last bit, the solutions of all labs must have all points, no starter may have them, and
# the menu must open.
#
#   tests/packages.sh
#
#   PROGRAM=build/bin/relief     the program of Linux, with its modules beside it
#   KEEP=FOLDER                  make everything in this folder, and keep it
#
# Needs the Debian packages of the purposes build, ci and packages (framework/cmake/packages.txt), and a network for the
# libraries' sources. Takes about ten minutes, most of them to compile.
set -euo pipefail

course=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
program=$(readlink -f -- "${PROGRAM:-$course/build/bin/relief}")
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)

say() { printf 'packages: %s\n' "$*" >&2; }

missing=()
[[ -x $program ]] || missing+=("the program: ./relief build")
[[ -x $wine ]] || missing+=("the Debian package wine64")
for tool in cmake:cmake ninja:ninja-build x86_64-w64-mingw32-g++-posix:g++-mingw-w64-x86-64-posix Xvfb:xvfb \
  xdotool:xdotool xwd:x11-apps dpkg-shlibdeps:dpkg-dev; do
  command -v "${tool%:*}" >/dev/null || missing+=("the Debian package ${tool#*:}")
done
if ((${#missing[@]})); then
  printf -v list ', %s' "${missing[@]}"
  say "cannot be run here, it needs: ${list:2}"
  exit 77  # "skipped", by the convention of automake
fi

here=${KEEP:-$(mktemp -d)}
mkdir -p "$here"
export WINEPREFIX=$here/wine WINEDEBUG=-all LC_ALL=C.UTF-8  # the locale of file names under Wine
server=
end() {
  "${wine%/*}/wineserver" -k 2>/dev/null || true
  [[ -z $server ]] || kill "$server" 2>/dev/null || true
  [[ -n ${KEEP:-} ]] || rm -rf "$here"
}
trap end EXIT
Xvfb -displayfd 1 -screen 0 1600x1000x24 -noreset >"$here/display" 2>/dev/null &
server=$!
for ((i = 0; i < 100; ++i)); do [[ -s $here/display ]] && break || sleep 0.1; done
DISPLAY=:$(<"$here/display")
export DISPLAY

failed=()
expect() { # what, command...
  local what=$1
  shift
  if "$@" >"$here/log" 2>&1; then return; fi
  say "failed: $what"
  tail -15 "$here/log" >&2
  failed+=("$what")
}

command -v ccache >/dev/null && export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
say "compiling a handout with the solutions' C++ code for both"
rm -rf "$here/handout"
"$program" handout -o "$here/handout" >/dev/null
for lab in "$course"/labs/[0-9][0-9]_*; do
  for file in "$lab"/*.cpp "$lab"/*.h; do
    if [[ -e $file ]]; then cp "$file" "$here/handout/labs/${lab##*/}/"; fi
  done
done
for preset in windows package; do
  (cd "$here/handout" && cmake --preset $preset && cmake --build --preset $preset --target relief package) \
    >"$here/build.log" 2>&1 || { tail -30 "$here/build.log" >&2; say "failed: building"; exit 1; }
done

# Wine's programs do not set the variables of the Linux libraries that draw for them.
export GALLIUM_OVERRIDE_CPU_CAPS=sse4.1 LP_NATIVE_VECTOR_WIDTH=128 LIBGL_ALWAYS_SOFTWARE=1

# Tries the program in a folder of an unpacked course.
try_package() { # its name, the folder, command...
  local package=$1 folder=$2 lab name number
  shift 2
  say "$package: $(du -sh "$folder" | cut -f1) unpacked"
  expect "$package: info" "$@" info
  for lab in "$course"/labs/[0-9][0-9]_*; do
    name=${lab##*/} number=${lab##*/}
    expect "$package, $name: a starter has not all points" bash -c '! "$@" >/dev/null 2>&1' bash "$@" check "${number%%_*}"
  done
  cp -r "$course"/shaders/. "$folder/shaders/"
  sed -i 's/$/\r/' "$folder/shaders/06_tangent_space/task.glsl"
  for lab in "$course"/labs/[0-9][0-9]_*; do
    name=${lab##*/} number=${name%%_*}
    expect "$package, $name: the solution has all points" "$@" check "$number"
    expect "$package, $name: a picture" "$@" shot "$number" --size 640x360 -o "$here/ü.png"
    expect "$package, $name: the picture of the build" "$program" shot "$number" --size 640x360 -o "$here/ours.png"
    expect "$package, $name: the pictures are equal" cmp "$here/ü.png" "$here/ours.png"
  done
  "$@" >"$here/menu.log" 2>&1 &
  local menu=$! colours
  expect "$package: the menu's window opens" timeout 60 xdotool search --sync --onlyvisible --name Relief
  sleep 5  # for the first picture
  colours=$(xwd -root -silent | od -An -tx1 -v -w3 | sort -u | wc -l)
  ((colours > 1000)) || { say "failed: $package: the menu shows $colours colours"; failed+=("$package: the menu's picture"); }
  [[ -z ${KEEP:-} ]] || xwd -root -silent >"$here/${package// /-}.xwd"
  kill "$menu" 2>/dev/null || true
}

unpacked="$here/Übung 课程"
rm -rf "$unpacked" "$here/deb"
mkdir "$unpacked"
(cd "$unpacked" && cmake -E tar xf "$here"/handout/build/windows/relief-*-windows.zip)
folder=$(echo "$unpacked"/relief-*)
try_package "ZIP file" "$folder" "$wine" "$folder/relief.exe"
"${wine%/*}/wineserver" -k || true
dpkg-deb -x "$here"/handout/build/package/relief_*.deb "$here/deb"
try_package "Debian package" "$here/deb/usr/lib/relief" "$here/deb/usr/bin/relief"

if ((${#failed[@]})); then
  printf -v list ', %s' "${failed[@]}"
  say "failed: ${list:2}"
  exit 1
fi
say "all passed"
