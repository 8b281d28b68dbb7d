# All tests and proofs; sourced by the script `relief` for `test --all`. Continues after a failure.
# shellcheck shell=bash disable=SC2154  # the script's variables

failed=() left_out=()

# Runs one proof. A script that cannot run on this machine prints the reason and exits with 77.
prove() { # its name, command...
  local name=$1 code=0
  shift
  "$@" || code=$?
  case $code in
    0) ;;
    77) left_out+=("$name") ;;
    *) failed+=("$name") ;;
  esac
}

say "1 of 10: every test, and 10,000 random views of displaced surfaces; pictures and solutions through Vulkan"
RELIEF_RANDOM_VIEWS=10000 RELIEF_TEST_ALL=1 prove "tests" run_tests "$build"
RELIEF_TEST_ALL=1 prove "the labs' tests through EGL" "$build/bin/labs_tests" --context egl
PROGRAMS=$build/bin prove "Vulkan" "$root/tests/vulkan.sh"

say "2 of 10: every test under the address and undefined-behaviour sanitizers, but for grade, whose sandbox bounds" \
  "addresses, and those that build programs without them; leaks are not looked for through EGL (tests/CMakeLists.txt says why)"
if [[ ! -f $build/sanitized/build.ninja ]]; then
  # Also source by source and without precompiled headers, which would hide missing includes.
  quietly "configuring with sanitizers" cmake -S "$root" -B "$build/sanitized" -G Ninja \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo -DRELIEF_SANITIZE=ON -DRELIEF_UNITY=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
fi
quietly "building with sanitizers" ninja -C "$build/sanitized"
LSAN_OPTIONS="suppressions='$root/tests/sanitizers/leaks.supp':print_suppressions=0" UBSAN_OPTIONS=print_stacktrace=1 \
  prove "tests under sanitizers" run_tests "$build/sanitized"

say "3 of 10: the grader's proof of every lab, in each context, with one thread and two, with and without what only this" \
  "processor can do, each from other hidden views"
for context in osmesa egl; do
  for threads in 1 2; do
    for pinned in '' --unpinned; do
      # shellcheck disable=SC2086  # zero or one word
      prove "the grader's proof ($context, $threads threads $pinned)" "$build/bin/relief" grade --self-test \
        --context $context --threads $threads $pinned --seed "$context $threads $pinned"
    done
  done
done

say "4 of 10: small changes of every lab's solution, of which the checks notice 97 of 100"
for manifest in "$root"/labs/*/lab.toml; do
  lab=$(basename "$(dirname "$manifest")")
  prove "mutants of lab ${lab%%_*}" "$build/bin/relief" grade --mutate "${lab%%_*}" --seed mutants
done

say "5 of 10: each parser fuzzed for a minute"
quietly "configuring to fuzz" cmake -S "$root/tests/fuzz" -B "$build/fuzz" -G Ninja -DCMAKE_C_COMPILER=clang \
  -DCMAKE_CXX_COMPILER=clang++ -DRELIEF_FUZZ_SECONDS=60
quietly "building to fuzz" ninja -C "$build/fuzz"
prove "fuzzing" run_tests "$build/fuzz"

say "6 of 10: the README's two commands on a bare Debian 12, 13 and testing, and on Ubuntu 24.04; a build for 64-bit ARM"
prove "bare roots" "$root/tests/bare_root.sh" bookworm trixie forky noble arm64

say "7 of 10: a class on a Slurm of two nodes, of which one dies"
PROGRAM=$build/bin/relief prove "Slurm" "$root/tests/slurm.sh"

say "8 of 10: the sandbox on a machine with control groups"
TESTS=$build/bin/framework_tests prove "control groups" "$root/tests/control_groups.sh"

say "9 of 10: the students' packages for Debian and, under Wine, for Windows"
PROGRAM=$build/bin/relief prove "packages" "$root/tests/packages.sh"

say "10 of 10: the tests without GL, with clang and LLVM's C++ library, as on macOS"
prove "LLVM's C++ library" "$root/tests/libcxx.sh"

if ((${#failed[@]})); then
  (IFS=,; say "failed: ${failed[*]}")
  exit 1
fi
if ((${#left_out[@]})); then (IFS=,; say "all others passed; could not be run here: ${left_out[*]}")
else say "all ten passed"; fi
