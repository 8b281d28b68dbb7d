#!/usr/bin/env bash
# Runs `relief grade --slurm` on a real Slurm with two nodes on this machine. Each node has its own processes and its
# own /tmp. A node dies and a grader is killed. The class must complete by itself with every mark.
#
#   tests/slurm.sh
#
#   PROGRAM=build/bin/relief     the program
#   KEEP=1                       keep the folder with Slurm's logs and the classes
#
# Needs root, so that whole nodes can be killed, and the Debian packages slurmctld, slurmd, slurm-client and munge. Uses
# neither this machine's own Slurm nor its configuration. Takes three minutes: Slurm waits two minutes before it
# restarts a job of a dead node.
set -euo pipefail

course=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
program=$(readlink -f -- "${PROGRAM:-$course/build/bin/relief}")
export PATH=$PATH:/usr/sbin:/sbin

say() { printf 'slurm: %s\n' "$*" >&2; }

missing=()
[[ $(id -u) == 0 ]] || missing+=("root")
for tool in slurmctld:slurmctld slurmd:slurmd sbatch:slurm-client munged:munge; do
  command -v "${tool%:*}" >/dev/null || missing+=("the Debian package ${tool#*:}")
done
[[ $(id -u) != 0 ]] || unshare --pid --mount --fork --kill-child mount -t tmpfs tmpfs /mnt 2>/dev/null ||
  missing+=("namespaces of processes and mounts")
[[ -x $program ]] || missing+=("the program: ./relief build")
if ((${#missing[@]})); then
  printf -v list ', %s' "${missing[@]}"
  say "cannot be run here, it needs: ${list:2}"
  exit 77  # "skipped", by the convention of automake
fi

# Not in /tmp, since each node has its own.
mkdir -p "$course/build"
here=$(mktemp -d "$course/build/slurm-XXXXXX")
chmod 755 "$here"
mkdir "$here"/{state,g1,g2,run,log}
export SLURM_CONF=$here/slurm.conf
unset "${!SBATCH_@}"  # settings for this machine's own Slurm
declare -A nodes=()

stop_node() { # name
  # The first process of a PID namespace takes all others with it, like a power cut.
  kill -KILL "${nodes[$1]}" 2>/dev/null || true
  wait "${nodes[$1]}" 2>/dev/null || true
  unset "nodes[$1]"
}
end() {
  local name
  for name in "${!nodes[@]}"; do stop_node "$name"; done
  for name in slurmctld munged; do [[ ! -s $here/run/$name.pid ]] || kill "$(<"$here/run/$name.pid")" 2>/dev/null || true; done
  if [[ -n ${KEEP:-} ]]; then say "kept: $here"; else rm -rf --one-file-system "$here"; fi
}
trap end EXIT
trap 'exit 130' INT TERM
fail() {
  say "failed: $*"
  for log in "$here"/*/slurm/*.log "$here"/log/*; do printf '== %s\n' "$log" && tail -5 "$log"; done >&2 || true
  exit 1
}

port=$((20000 + RANDOM % 10000))
cat >"$SLURM_CONF" <<END
ClusterName=relief
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$here/run/munge.socket
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/%n
SlurmctldPidFile=$here/run/slurmctld.pid
SlurmdPidFile=$here/run/slurmd-%n.pid
SlurmctldLogFile=$here/log/slurmctld
SlurmdLogFile=$here/log/%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,bf_interval=1
SlurmdTimeout=6
KillWait=2
ReturnToService=2
MpiDefault=none
NodeName=g1 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 RealMemory=1000
NodeName=g2 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 RealMemory=1000
PartitionName=all Nodes=g1,g2 Default=YES State=UP
END

# Since version 23.02 slurmd requires control groups even if nothing uses them. A container seldom has them.
[[ $(slurmd -V) =~ \ ([0-9]+)\. ]] && ((BASH_REMATCH[1] < 23)) || echo CgroupPlugin=disabled >"$here/cgroup.conf"

start_node() { # name
  # Process ids in the namespace begin at 1, so graders on two nodes often have equal ids.
  # shellcheck disable=SC2016  # expanded in there
  unshare --pid --mount --fork --kill-child --mount-proc bash -c \
    'mount -t tmpfs -o mode=1777,size=1G tmpfs /tmp && exec slurmd -D -N "$1"' node "$1" >"$here/log/$1.out" 2>&1 &
  nodes[$1]=$!
}
state_of_node() { sinfo --noheader --Node --nodes "$1" --format %T; }

wait_until() { # what, seconds, command...
  local what=$1 end=$((SECONDS + $2))
  shift 2
  until "$@"; do
    ((SECONDS < end)) || fail "waited in vain until $what"
    sleep 0.2
  done
}
is_idle() { [[ $(state_of_node "$1") == idle ]]; }
has_results() { # folder, number
  local found
  found=$(find "$1/results" -name '*.json' | wc -l)
  ((found >= $2))
}
has_ended() { [[ $(squeue --noheader --states=all --format=%T | grep -cvE 'COMPLETED|FAILED|CANCELLED|NODE_FAIL') == 0 ]]; }
part_on() { squeue --noheader --array --states=RUNNING --nodelist "$1" --name=relief-part --format=%K; }
part_runs_on() { [[ -n $(part_on "$1") ]]; }
other_part_on() { part_runs_on "$1" && [[ $(part_on "$1") != "$2" ]]; } # node, part
kill_grader_on() { # node
  local space
  space=$(readlink "/proc/${nodes[$1]}/ns/pid_for_children")
  wait_until "a grader runs on $1" 20 grader_in "$space"
  kill -KILL "$grader"
}
grader_in() { # namespace of processes
  local process words
  for process in /proc/[0-9]*; do
    [[ $(readlink "$process/ns/pid") == "$1" ]] || continue
    words=$(tr '\0' ' ' <"$process/cmdline" 2>/dev/null) || continue
    [[ $words == *"grade --resume"*"--shard"* && $words != */bin/bash* ]] || continue
    grader=${process#/proc/}
    return 0
  done 2>/dev/null
  return 1
}

make_class() { # folder, number of submissions
  local i file=shaders/02_normal_map_storage/task.glsl
  for ((i = 1; i <= $2; ++i)); do
    mkdir -p "$1/s$i/${file%/*}"
    { cat "$course/$file"; echo "// $i"; } >"$1/s$i/$file"
  done
}
make_class_file() { # folder: one was late by less than a day, and one of the roster handed in nothing
  cat >"$1.toml" <<END
utc_offset = "+00:00"
hand_ins = "$1.csv"
[[assigned]]
lab = 2
due = 2027-03-01T12:00:00
[late]
percent_per_day = 10
END
  printf '[[student]]\nstudent = "%s"\n' s1 s2 s3 s4 s5 s6 s7 s8 absent >>"$1.toml"
  printf 'student,handed_in\n%s,2027-03-01 11:00\n' s1 >"$1.csv"
  printf '%s,2027-03-01 11:00\n' s2 s3 s4 s5 s6 s7 >>"$1.csv"
  echo 's8,2027-03-02 11:00' >>"$1.csv"
}
check_marks() { # folder, number of submissions with all points, of all others
  local file
  [[ -s $1/report.html ]] || fail "$1 has no report"
  [[ $(grep -c ',graded,11,' "$1/results.csv") == "$2" ]] || fail "not every submission of $1 has its mark"
  [[ $(wc -l <"$1/results.csv") == $(($2 + ${3:-0} + 1)) ]] || fail "$1 has a submission twice"
  [[ $(stat -c %a "$1/class.json") == 600 ]] || fail "others can read class.json"
  for file in $(grep -rlF -- "$RELIEF_SEED" "$1" "$here/state" "$here/g1" "$here/g2" "$here/log" || true); do
    [[ ${file##*/} == class.json ]] || fail "the seed is in $file"
  done
}

dd if=/dev/urandom of="$here/key" bs=1024 count=1 status=none
chmod 400 "$here/key"
munged --force --key-file="$here/key" --socket="$here/run/munge.socket" --log-file="$here/log/munged" \
  --pid-file="$here/run/munged.pid" --seed-file="$here/run/munged.seed" 2>"$here/log/munged.out" ||
  fail "munged does not start"
slurmctld -c || fail "slurmctld does not start"
start_node g1
start_node g2
wait_until "g1 is there" 60 is_idle g1
wait_until "g2 is there" 60 is_idle g2
export RELIEF_SEED=a-word-that-nobody-may-read

say "a node dies, and a grader on the other one is killed"
make_class "$here/first" 18
"$program" grade "$here"/first/* -o "$here/marks" --slurm 6 >&2
wait_until "there are results" 120 has_results "$here/marks" 2
wait_until "a part runs on g1" 60 part_runs_on g1
stop_node g1
begun=$(part_on g2)
wait_until "the next part runs on g2" 60 other_part_on g2 "$begun"
kill_grader_on g2
wait_until "the class has ended" 300 has_ended
check_marks "$here/marks" 18
grep -q ' graded, 1[0-9] unchanged, 0 not graded' "$here/marks/slurm/last.log" ||
  fail "the last job did not grade what the killed grader left"

say "a class with a class file"
start_node g1
wait_until "g1 is back" 60 is_idle g1
make_class "$here/second" 8
make_class_file "$here/second"
"$program" grade "$here"/second/* -o "$here/more" --class "$here/second.toml" --slurm 4 >&2
wait_until "the class has ended" 300 has_ended
check_marks "$here/more" 7 2
grep -q '^s8,.*,9\.9,' "$here/more/results.csv" || fail "the late one has not lost a tenth"
grep -q '^absent,nothing handed in,0,' "$here/more/results.csv" || fail "who handed in nothing is not there with 0 points"
[[ $("$program" grade --status "$here/more") == *"8 of 8 submissions have a result"*"the report: $here/more/report.html" ]] ||
  fail "--status does not say that all is done"

say "passed: all marks are there, none twice"
