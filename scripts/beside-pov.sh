#!/usr/bin/env bash
# Scenes of the gallery by us and by POV-Ray 3.7 (Debian package `povray`): the same scene without highlights, 1200×1200 pixels, one
# sample, one thread on one core, nine runs in turns; medians of the processor time of the whole command.
# `beside-pov.sh [SCENE...]`
set -euo pipefail
cd "$(dirname "$0")/.."
command -v povray >/dev/null || { echo "povray is missing: apt-get install povray" >&2; exit 2; }
cargo build --release --quiet --bin groundtruth
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
size=1200
[ $# -gt 0 ] || set -- ch19/torus ch27/torus ch28/glass-sphere ch28/glass-box ch27/common-set

# the processor time of a command in seconds
seconds() { (TIMEFORMAT=%U; { time taskset -c 1 "$@" > /dev/null 2>&1; } 2>&1); }
median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

printf '%-20s %12s %12s %7s\n' scene groundtruth POV-Ray ratio
for scene in "$@"; do
    export=(target/release/groundtruth export "$scene" --without phong --size "${size}x$size" --replace)
    "${export[@]}" -o "$work/ours.toml"
    "${export[@]}" --format pov -o "$work/theirs.pov"
    : > "$work/ours" > "$work/theirs"
    for _ in 1 2 3 4 5 6 7 8 9; do
        seconds target/release/groundtruth render "$work/ours.toml" --samples 1 --threads 1 -o "$work/ours.exr" >> "$work/ours"
        seconds povray "+I$work/theirs.pov" "+O$work/theirs.png" "+W$size" "+H$size" -A -D +FN16 File_Gamma=1.0 +WT1 >> "$work/theirs"
    done
    ours=$(median < "$work/ours") theirs=$(median < "$work/theirs")
    printf '%-20s %11ss %11ss %7s\n' "$scene" "$ours" "$theirs" "$(awk -v a="$ours" -v b="$theirs" 'BEGIN { print a / b }')"
done
