#!/usr/bin/env bash
# Runs the sandbox's tests on a machine with control groups v2. It is a virtual machine with Debian's kernel and this
# machine's files, read-only. The tests run once as a user with a delegated group, and once as root.
#
#   tests/control_groups.sh
#
#   TESTS=build/bin/framework_tests     the program with the tests
#   KERNEL=build/control_groups         the folder of the unpacked kernel package, kept for the next run
#
# Needs the Debian package qemu-system-x86, and 500 MB for Debian's kernel. Takes two minutes, because the processor is
# emulated.
set -euo pipefail

course=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
tests=$(readlink -f -- "${TESTS:-$course/build/bin/framework_tests}")
kernel=${KERNEL:-$course/build/control_groups}

say() { printf 'control_groups: %s\n' "$*" >&2; }

missing=()
[[ $(uname -m) == x86_64 ]] || missing+=("an x86-64 processor")
command -v qemu-system-x86_64 >/dev/null || missing+=("the Debian package qemu-system-x86")
[[ -x $tests ]] || missing+=("the tests: ./relief test")
if ((${#missing[@]})); then
  printf -v list ', %s' "${missing[@]}"
  say "cannot be run here, it needs: ${list:2}"
  exit 77  # "skipped", by the convention of automake
fi

mkdir -p "$kernel"
kernel=$(readlink -f -- "$kernel")
if [[ ! -e $kernel/unpacked ]]; then
  say "unpacking Debian's kernel"
  packages=$(mktemp -d)
  trap 'rm -rf "$packages"' EXIT
  name=$(apt-cache depends linux-image-amd64 | awk '/Depends: linux-image/ { print $2; exit }')
  (cd "$packages" && apt-get -qq -o APT::Sandbox::User=root download "${name:-linux-image-amd64}" busybox-static) >/dev/null
  for package in "$packages"/*.deb; do dpkg -x "$package" "$kernel"; done
  touch "$kernel/unpacked"
fi
busybox=$kernel/bin/busybox
modules=$(cd "$kernel" && echo lib/modules/*)
"$busybox" depmod -b "$kernel" "${modules##*/}"

# The kernel's first process: it mounts this machine's files and continues in them.
here=$(mktemp -d)
trap 'rm -rf "$here" "${packages:-}"' EXIT
mkdir -p "$here"/first/{bin,dev,root}
cp "$busybox" "$here/first/bin/"
while read -r module; do
  mkdir -p "$here/first/$(dirname "$module")"
  cp "$kernel/$module" "$here/first/$module"
done < <(sed -nE 's#^(.*/(9p|9pnet_virtio|virtio_pci)\.ko):#\1#p' "$kernel/$modules/modules.dep" | tr ' ' '\n' |
  sed "s#^#$modules/#")
cp "$kernel/$modules/modules.dep" "$here/first/$modules/"
cat >"$here/first/init" <<'END'
#!/bin/busybox sh
b=/bin/busybox
for module in virtio_pci 9pnet_virtio 9p; do $b modprobe $module; done
$b mount -t devtmpfs none /dev
$b mount -t 9p -o trans=virtio,version=9p2000.L,ro,cache=loose,msize=1048576 files /root
for each in proc:proc sysfs:sys devtmpfs:dev tmpfs:tmp tmpfs:run cgroup2:sys/fs/cgroup; do
  $b mount -t ${each%:*} none /root/${each#*:}
done
$b chmod 1777 /root/tmp
$b cp /inside /root/run/inside
exec $b switch_root /root /bin/bash /run/inside
END
chmod +x "$here/first/init"
cat >"$here/first/inside" <<END
export PATH=/usr/bin:/bin HOME=/tmp
groups=/sys/fs/cgroup
echo '+memory +pids' >\$groups/cgroup.subtree_control
# The second run uses the groups as the first run left them.
mkdir \$groups/users \$groups/roots
chown -R 1000:1000 \$groups/users
# As systemd marks a group that it delegates to a service or a scope.
for group in users roots; do
  /usr/bin/python3 -c "import os; os.setxattr('\$groups/\$group', 'user.delegate', b'1')"
done
(
  echo \$BASHPID >\$groups/users/cgroup.procs
  for i in 1 2; do
    setpriv --reuid 1000 --regid 1000 --clear-groups '$tests' --gtest_color=no --gtest_filter='Sandbox.*' && echo "PASSED user \$i"
  done
)
(
  echo \$BASHPID >\$groups/roots/cgroup.procs
  '$tests' --gtest_color=no --gtest_filter='Sandbox.*' && echo 'PASSED root'
)
echo o >/proc/sysrq-trigger
sleep 10
END
(cd "$here/first" && "$busybox" find . | "$busybox" cpio -o -H newc | gzip -1) >"$here/first.gz" 2>/dev/null

say "starting the machine"
log=$kernel/log
timeout 900 qemu-system-x86_64 -accel tcg -cpu max -m 3G -nodefaults -nographic -no-reboot -serial stdio \
  -kernel "$kernel"/boot/vmlinuz-* -initrd "$here/first.gz" -append 'console=ttyS0 quiet panic=-1' \
  -virtfs local,path=/,mount_tag=files,security_model=none,readonly=on,multidevs=remap \
  </dev/null 2>&1 | tr -d '\r' >"$log" || true
for claim in 'user 1' 'user 2' root; do
  if ! grep -q "^PASSED $claim$" "$log"; then
    tail -40 "$log" >&2
    say "failed as $claim; all that it printed: $log"
    exit 1
  fi
done
if [[ $(grep -c '^isolation: namespaces and control groups' "$log") != 3 ]]; then
  grep '^isolation' "$log" >&2
  say "failed: the machine has control groups, and the sandbox did not use them"
  exit 1
fi
say "passed: $(grep -c '\[       OK' "$log") tests"
