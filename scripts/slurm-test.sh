#!/bin/sh
# Tries the Slurm script of docs/many-machines.md on this machine, with a small picture: all tasks of the array,
# one of them interrupted, requeued and continued, one run twice; the merged sums must have the bytes of a single run.
# The daemons are plain processes with all their files in a temporary folder; an installed Slurm is not touched.
# Needs root and Debian's packages slurm-wlm and munge, which `slurm-test.sh --install` installs. A program that is
# built already is tried if it is named: scripts/slurm-test.sh target/debug/groundtruth
# Exit status: 0 all is well, 1 it is not, 77 not tried.
set -eu
cd "$(dirname "$0")/.."

skip() {
    echo "not tried: $1" >&2
    exit 77
}
fail() {
    echo "error: $1" >&2
    exit 1
}

[ "$(id -u)" -eq 0 ] || skip "the daemons of Slurm need root"
if [ "${1:-}" = --install ]; then
    shift
    apt-get update
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends slurm-wlm munge
fi
for tool in munged slurmctld slurmd sbatch srun; do
    command -v "$tool" >/dev/null || skip "$tool is missing; scripts/slurm-test.sh --install installs it"
done
program=${1:-}
if [ -z "$program" ]; then
    cargo build --bin groundtruth
    program=${CARGO_TARGET_DIR:-target}/debug/groundtruth
fi
program=$(realpath "$program")

folder=$(mktemp -d)
daemons=
finish() {
    scancel --user=root 2>/dev/null || true
    # the last started first: slurmd, slurmctld, munged
    for daemon in $daemons; do
        kill "$daemon" 2>/dev/null || true
        wait "$daemon" 2>/dev/null || true
    done
    rm -rf "$folder"
}
trap finish EXIT
trap 'exit 130' INT TERM

# Starts a daemon in the foreground mode of its own, and notes its process.
start() {
    log=$1
    shift
    "$@" >"$folder/$log.out" 2>&1 &
    daemons="$! $daemons"
}
# Waits until a command succeeds, at most so many seconds.
await() {
    seconds=$1
    shift
    while ! "$@" >/dev/null 2>&1; do
        [ "$seconds" -gt 0 ] || fail "waited in vain for: $*; $(tail -n 5 "$folder"/*.log 2>&1)"
        seconds=$((seconds - 1))
        sleep 1
    done
}

# munged wants a folder that all may enter
chmod 711 "$folder"
mkdir "$folder/state" "$folder/spool" "$folder/bin"
dd if=/dev/urandom of="$folder/munge.key" bs=1024 count=1 status=none
chmod 400 "$folder/munge.key"
start munged munged --foreground --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" --seed-file="$folder/munge.seed"
await 10 munge --socket="$folder/munge.socket" --no-input

# eight processors, however many there are: two tasks of the script at a time
host=$(hostname -s)
cat >"$folder/slurm.conf" <<END
ClusterName=slurm-test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
SlurmctldPidFile=$folder/slurmctld.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdPidFile=$folder/slurmd.pid
SlurmdLogFile=$folder/slurmd.log
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=8 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP
END
export SLURM_CONF="$folder/slurm.conf"
start slurmctld slurmctld -D -f "$SLURM_CONF"
start slurmd slurmd -D -f "$SLURM_CONF" -N "$host"
is_idle() { [ "$(sinfo --noheader --format=%T)" = idle ]; }
await 60 is_idle

# the script of the page, with a smaller picture and fewer parts
scene='ch18/rectangle --size 96x64 --samples 16' replicas=600 parts=6
awk '/^## /{here = $2 == "Slurm"} here && /^```$/{exit} here && on; here && /^```sh/{on = 1}' \
    docs/many-machines.md >"$folder/page.sh"
sed -e "s|ch18/rectangle|$scene|" -e "s|--replicas 1000|--replicas $replicas|" -e "s|/64\"|/$parts\"|" \
    -e "s|--array=0-63|--array=0-$((parts - 1))|" "$folder/page.sh" >"$folder/array.sh"
changed=$(diff "$folder/page.sh" "$folder/array.sh" | grep -c '^>' || true)
[ "$changed" -eq 3 ] || fail "docs/many-machines.md: $changed lines of the script name scene, replicas and parts, not 3"
ln -s "$program" "$folder/bin/groundtruth"
export PATH="$folder/bin:$PATH"

cd "$folder"
mkdir -p parts again/parts
# shellcheck disable=SC2086 # a list of words
groundtruth render $scene --replicas "$replicas" -o single.sums

# Whether no task of a job waits or runs.
is_over() { [ -z "$(squeue --noheader --job="$1")" ]; }
# Whether the program of a task runs, and has had the time to begin.
is_rendering() { squeue --steps --noheader --format=%i | grep -q "^$1\.0$" && sleep 1; }

job=$(sbatch --parsable array.sh)
killed=2
await 120 is_rendering "${job}_$killed"
scancel --signal=TERM "${job}_$killed"
log="slurm-${job}_$killed.out"
await 60 grep -q "interrupted; parts/$killed.sums: " "$log"
# the smaller part is valid; 1: others are missing
status=0
groundtruth merge "parts/$killed.sums" -o smaller.sums || status=$?
[ "$status" -eq 1 ] || fail "merge of the interrupted part: status $status"
echo "ok: task $killed was interrupted: $(grep -o '[0-9]* of [0-9]* replicas' "$log" | head -n 1)"
await 600 is_over "$job"
grep -q "^parts/$killed.sums: " "$log" || fail "task $killed was not continued: $(cat "$log")"
echo "ok: it was requeued, and is complete"

twice=1
job=$(sbatch --parsable --array="$twice" --chdir=again array.sh)
await 120 is_over "$job"
groundtruth merge parts/*.sums "again/parts/$twice.sums" -o mean.sums 2>notes
grep -q "again/parts/$twice.sums" notes || fail "the part that came twice is not named: $(cat notes)"
echo "ok: task $twice ran twice, and counts once"
cmp mean.sums single.sums || fail "the merged parts are not those of a single run"
echo "ok: $parts merged parts have the bytes of a single run"
