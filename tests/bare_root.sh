#!/usr/bin/env bash
# Runs the README's two commands on a bare Debian or Ubuntu: in a minimal root from debootstrap, with git and a clone of
# the last commit.
#
#   tests/bare_root.sh [NAME]...            bookworm (Debian 12), trixie (Debian 13), forky (Debian testing), noble (Ubuntu
#                                           24.04); default: the first two. arm64: instead of the two commands, builds
#                                           the course for 64-bit ARM on Debian 12, and runs the tests without GL under
#                                           qemu-user
#
#   MIRROR=http://deb.debian.org/debian     the source of Debian's packages
#   UBUNTU=http://archive.ubuntu.com/ubuntu the source of Ubuntu's packages
#   ROOTS=build/bare_roots                  the folder of pristine roots, which the next run copies, and of logs
#   KEEP=1                                  keep the copy in which the commands ran, as ROOTS/NAME-used
#   PROOFS=1                                also run ./relief test --ci, as CI does
#   CACHE=FOLDER                            a compiler cache that is kept between runs, for debugging
#
# Needs root to make and enter root folders. Takes half an hour or more, and 6 GB, per Debian version.
set -euo pipefail

course=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
roots=${ROOTS:-$course/build/bare_roots}

say() { printf 'bare_root: %s\n' "$*" >&2; }

(($#)) || set -- bookworm trixie
for name in "$@"; do
  case $name in
    bookworm | trixie | forky | noble | arm64) ;;
    *)
      say "there are bookworm (Debian 12), trixie (Debian 13), forky (Debian testing), noble (Ubuntu 24.04) and arm64," \
        "not '$name'"
      exit 2
      ;;
  esac
done
missing=()
[[ $(id -u) == 0 ]] || missing+=("root")
command -v debootstrap >/dev/null || missing+=("the Debian package debootstrap")
if ((${#missing[@]})); then
  printf -v list ', %s' "${missing[@]}"
  say "cannot be run here, it needs: ${list:2}"
  exit 77  # "skipped", by the convention of automake
fi

# Runs a command in a root that shares only the network with this machine. The command sees only its own processes, and
# mounts end with it. The folder is its real root, because a process in a chroot may not create the grader's namespaces.
inside() { # root, command...
  local to=$1 name
  shift
  local environment=(HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    [[ -n ${!name:-} ]] && environment+=("$name=${!name}")
  done
  cp -L /etc/resolv.conf /etc/hosts "$to/etc/"
  # A network may use its own certificates.
  if [[ -n ${NODE_EXTRA_CA_CERTS:-} ]]; then
    cp -L "$NODE_EXTRA_CA_CERTS" "$to/etc/network-certificates.pem"
    environment+=(NODE_EXTRA_CA_CERTS=/etc/network-certificates.pem)
  fi
  # shellcheck disable=SC2016  # expanded in there
  unshare --mount --pid --fork --kill-child bash -c '
    set -e
    mount --bind "$1" "$1"
    cd "$1"
    if [[ -n $2 ]]; then mkdir -p root/.cache/ccache && mount --bind "$2" root/.cache/ccache; fi
    mount --rbind /dev dev
    mount -t tmpfs -o mode=1777 tmpfs dev/shm
    mount -t proc proc proc
    mount -t sysfs -o ro sysfs sys
    mkdir -p mnt/old
    pivot_root . mnt/old
    cd /
    umount -l /mnt/old
    shift 2
    exec "$@"' inside "$to" "${CACHE:-}" env -i "${environment[@]}" "$@" </dev/null
}

# Runs a command in the course of a root, and keeps its output with the second of each line.
logged() { # root, log, command
  local line begin=$SECONDS
  inside "$1" bash -c "cd /course && $3" 2>&1 | while IFS= read -r line; do
    printf '%4d %s\n' $((SECONDS - begin)) "$line"
  done >"$2"
}

# In a root of Debian 12: installs the libraries of 64-bit ARM, builds for it, and runs what needs no GL.
# shellcheck disable=SC2016  # expanded in there
build_for_arm64='
  set -euo pipefail
  export DEBIAN_FRONTEND=noninteractive
  dpkg --add-architecture arm64
  apt-get update
  packages=(g++-aarch64-linux-gnu qemu-user)
  for name in $(awk "/^(build|staff|test) / { print \$2 }" framework/cmake/packages.txt); do
    case $(apt-cache show "$name" | grep -m 1 ^Architecture:):$name in
      *all:* | *:cmake | *:ninja-build | *:pkg-config | *:git | *:ccache | *:bubblewrap) packages+=("$name") ;;
      *:g++ | *:gnuplot-nox) ;;
      *) packages+=("$name:arm64") ;;
    esac
  done
  apt-get install -y --no-install-recommends "${packages[@]}"
  cmake -S . -B build -G Ninja -DCMAKE_TOOLCHAIN_FILE=framework/cmake/arm64.cmake -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
  ninja -C build course cpu_tests
  qemu-aarch64 build/bin/relief info
  qemu-aarch64 build/bin/cpu_tests
'

run_in() { # name of the release
  local name=$1 pristine=$roots/${1/arm64/bookworm} used=$roots/$1-used begin=$SECONDS
  # An older debootstrap has no script for a newer release, and all of a system's newer releases have the same one.
  local components=main mirror=${MIRROR:-http://deb.debian.org/debian} script=sid
  if [[ $name == noble ]]; then
    components=main,universe mirror=${UBUNTU:-http://archive.ubuntu.com/ubuntu} script=gutsy
  fi
  mkdir -p "$roots"
  if [[ ! -e $pristine/etc/debian_version ]]; then
    say "$name: making a root by debootstrap"
    rm -rf "$pristine" "$pristine.new"
    debootstrap --variant=minbase --include=git,ca-certificates --components=$components "${pristine##*/}" "$pristine.new" \
      "$mirror" "/usr/share/debootstrap/scripts/$script" \
      >"$roots/$name-debootstrap.log" 2>&1 || { tail -5 "$roots/$name-debootstrap.log" >&2; return 1; }
    mv "$pristine.new" "$pristine"
  fi
  rm -rf --one-file-system "$used"
  cp -a "$pristine" "$used"
  # Nothing of this machine is shared, not even git's objects.
  git clone --quiet --no-hardlinks "file://$course" "$used/course"

  if [[ $name == arm64 ]]; then
    say "$name: building, and running the tests without GL"
    logged "$used" "$roots/$name.log" "$build_for_arm64" || { tail -30 "$roots/$name.log" >&2; return 1; }
    say "$name: $(grep -oE '\[  PASSED  \] .*' "$roots/$name.log"), after $((SECONDS - begin)) s"
    [[ -n ${KEEP:-} ]] || rm -rf --one-file-system "$used"
    return
  fi

  say "$name: ./relief"
  if ! logged "$used" "$roots/$name-relief.log" './relief'; then
    tail -30 "$roots/$name-relief.log" >&2
    return 1
  fi
  # Without a display, ./relief makes the course page, and prints its path when each lab has its first picture.
  local page=/course/build/gallery/index.html first
  first=$(sed -n "s# *\([0-9]*\) $page\$#\1#p" "$roots/$name-relief.log")
  if [[ -z $first || ! -s $used$page ]]; then
    say "$name: ./relief names no page that is there: $roots/$name-relief.log"
    return 1
  fi
  say "$name: $page has its first pictures after $first s, and is complete after $((SECONDS - begin)) s"

  begin=$SECONDS
  say "$name: ./relief test"
  if ! logged "$used" "$roots/$name-test.log" './relief test'; then
    grep -oE '\[  FAILED  \].*|.*\*\*\*.*|.*tests passed.*' "$roots/$name-test.log" | sort -u >&2 || true
    tail -5 "$roots/$name-test.log" >&2
    return 1
  fi
  say "$name: $(grep -oE '[0-9]+% tests passed.*' "$roots/$name-test.log"), after $((SECONDS - begin)) s"
  if [[ -n ${PROOFS:-} ]]; then
    begin=$SECONDS
    say "$name: ./relief test --ci"
    if ! logged "$used" "$roots/$name-proofs.log" './relief test --ci'; then
      grep -oE '\[  FAILED  \].*|.*\*\*\*.*|.*tests passed.*' "$roots/$name-proofs.log" | sort -u >&2 || true
      return 1
    fi
    say "$name: $(grep -oE '[0-9]+% tests passed.*' "$roots/$name-proofs.log"), after $((SECONDS - begin)) s"
  fi
  [[ -n ${KEEP:-} ]] || rm -rf --one-file-system "$used"
}

if [[ -n $(git -C "$course" status --porcelain) ]]; then
  say "what is not committed is not in it"
fi
failed=()
for name in "$@"; do
  set +e
  (set -e; run_in "$name")  # not in a condition, where bash would continue after a failure
  code=$?
  set -e
  ((code == 0)) || failed+=("$name")
done
if ((${#failed[@]})); then
  say "failed: ${failed[*]}; logs: $roots/NAME-*.log"
  exit 1
fi
