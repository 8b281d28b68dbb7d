#!/usr/bin/env bash
# The README's two commands on a bare Debian: a minimal root by debootstrap with git alone, the last commit cloned into it.
#
#   tests/bare_root.sh [bookworm|trixie]...     Debian 12, Debian 13; both when none is named
#
#   MIRROR=http://deb.debian.org/debian     where packages come from
#   ROOTS=build/bare_roots                  where roots are kept as they were made, to be copied by the next run, and logs
#   KEEP=1                                  the copy in which the commands ran stays, as ROOTS/NAME-used
#   PROOFS=1                                ./relief test --ci as well, as CI runs it
#   CACHE=FOLDER                            a compiler's cache from one run to the next, for whoever mends what it found
#
# Needs root, since it makes and enters root folders; takes half an hour and more, and 6 GB, for each.
set -euo pipefail

course=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
mirror=${MIRROR:-http://deb.debian.org/debian}
roots=${ROOTS:-$course/build/bare_roots}

say() { printf 'bare_root: %s\n' "$*" >&2; }

(($#)) || set -- bookworm trixie
for name in "$@"; do
  if [[ $name != bookworm && $name != trixie ]]; then
    say "there are bookworm (Debian 12) and trixie (Debian 13), and no '$name'"
    exit 2
  fi
done
missing=()
[[ $(id -u) == 0 ]] || missing+=("root")
command -v debootstrap >/dev/null || missing+=("the Debian package debootstrap")
if ((${#missing[@]})); then
  printf -v list ', %s' "${missing[@]}"
  say "cannot be run here, it needs: ${list:2}"
  exit 77  # what is skipped, by the custom of automake
fi

# Runs a command in a root, with nothing of this machine but its network. It sees only its own processes, mounts end with
# it, and the folder is its real root: whoever is merely in a chroot may not make the grader's namespaces.
inside() { # root, command...
  local to=$1 name
  shift
  local environment=(HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
    [[ -n ${!name:-} ]] && environment+=("$name=${!name}")
  done
  cp -L /etc/resolv.conf /etc/hosts "$to/etc/"
  # A network may have certificates of its own.
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

run_in() { # bookworm or trixie
  local name=$1 pristine=$roots/$1 used=$roots/$1-used begin=$SECONDS
  mkdir -p "$roots"
  if [[ ! -e $pristine/etc/debian_version ]]; then
    say "$name: making a root by debootstrap"
    rm -rf "$pristine" "$pristine.new"
    debootstrap --variant=minbase --include=git,ca-certificates "$name" "$pristine.new" "$mirror" \
      >"$roots/$name-debootstrap.log" 2>&1 || { tail -5 "$roots/$name-debootstrap.log" >&2; return 1; }
    mv "$pristine.new" "$pristine"
  fi
  rm -rf --one-file-system "$used"
  cp -a "$pristine" "$used"
  # Of this machine nothing is shared, not even git's objects.
  git clone --quiet --no-hardlinks "file://$course" "$used/course"

  say "$name: ./relief"
  if ! inside "$used" bash -c 'cd /course && ./relief' >"$roots/$name-relief.log" 2>&1; then
    tail -30 "$roots/$name-relief.log" >&2
    return 1
  fi
  # Without a display: the course page, and where it is.
  local page
  page=$(grep -o '/course/build/gallery/index\.html' "$roots/$name-relief.log" | tail -1)
  if [[ -z $page || ! -s $used$page ]]; then
    say "$name: ./relief names no page that is there: $roots/$name-relief.log"
    return 1
  fi
  say "$name: ./relief has made $page, after $((SECONDS - begin)) s"

  begin=$SECONDS
  say "$name: ./relief test"
  if ! inside "$used" bash -c 'cd /course && ./relief test' >"$roots/$name-test.log" 2>&1; then
    grep -E '^\[  FAILED  \]|\*\*\*|tests passed' "$roots/$name-test.log" | sort -u >&2 || true
    tail -5 "$roots/$name-test.log" >&2
    return 1
  fi
  say "$name: $(grep -E 'tests passed' "$roots/$name-test.log"), after $((SECONDS - begin)) s"
  if [[ -n ${PROOFS:-} ]]; then
    begin=$SECONDS
    say "$name: ./relief test --ci"
    if ! inside "$used" bash -c 'cd /course && ./relief test --ci' >"$roots/$name-proofs.log" 2>&1; then
      grep -E '^\[  FAILED  \]|\*\*\*|tests passed' "$roots/$name-proofs.log" | sort -u >&2 || true
      return 1
    fi
    say "$name: $(grep -E 'tests passed' "$roots/$name-proofs.log"), after $((SECONDS - begin)) s"
  fi
  [[ -n ${KEEP:-} ]] || rm -rf --one-file-system "$used"
}

if [[ -n $(git -C "$course" status --porcelain) ]]; then
  say "what is not committed is not in it"
fi
failed=()
for name in "$@"; do
  set +e
  (set -e; run_in "$name")  # not in a condition, where bash would go on after whatever fails
  code=$?
  set -e
  ((code == 0)) || failed+=("$name")
done
if ((${#failed[@]})); then
  say "failed: ${failed[*]}; logs: $roots/NAME-*.log"
  exit 1
fi
