#!/usr/bin/env bash
# A second way from OpenGL to pixels: Mesa's zink, which translates to Vulkan, on the software renderer lavapipe.
# Compares the reference screenshots, and checks the solution of every lab.
#
#   tests/vulkan.sh
#
#   PROGRAMS=build/bin     the folder of the built programs
#
# Needs the Debian package mesa-vulkan-drivers.
set -euo pipefail

course=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
programs=${PROGRAMS:-$course/build/bin}
export MESA_LOADER_DRIVER_OVERRIDE=zink LIBGL_ALWAYS_SOFTWARE=1
export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp}  # lavapipe complains without it

say() { printf 'vulkan: %s\n' "$*" >&2; }

driver=$("$programs/relief" info | grep -A 1 '^egl ')
if [[ $driver != *'zink (llvmpipe'* ]]; then
  say "cannot be run here, it needs: the Debian package mesa-vulkan-drivers"
  exit 77  # "skipped", by the convention of automake
fi
say "the driver: $(sed -n 's/^ *\(zink.*\)/\1/p' <<<"$driver")"

failed=0
say "the reference screenshots"
"$programs/relief" golden --context egl -o "$course/build/golden-differences-vulkan" || failed=1
say "the checks of the solutions"
"$programs/course_tests" --context egl --gtest_filter='*TheSolutionPasses*' || failed=1
exit $failed
