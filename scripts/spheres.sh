#!/usr/bin/env bash
# Whole pictures of random spheres (Suffern, figure 22.11), one thread, beside POV-Ray 3.7 (Debian
# package `povray`): the same number, size and spread of spheres, the same camera and light, 400×400
# pixels, one sample, no shadows. Both times are of the picture alone, without reading and building.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v povray >/dev/null || { echo "povray is missing: apt-get install povray" >&2; exit 2; }
cargo build --quiet --bin groundtruth
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

printf '%9s %12s %12s %7s\n' spheres groundtruth POV-Ray ratio
for count in 1000 10000 100000 1000000; do
    radius=$(awk -v n="$count" 'BEGIN { printf "%.17g", (0.75 * 0.1 / (n * 3.14159265358979)) ^ (1 / 3) }')
    cargo run --quiet -- export ch22/thousand-spheres |
        sed "s/^count = .*/count = $count/; s/^radius = .*/radius = $radius/; s/^accel = \"grid\"/accel = \"bvh\"/" \
        > "$work/spheres.toml"
    cat > "$work/spheres.pov" <<SCENE
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 }
camera { location <0, 0, 20> right x * 400 / 3600 up y * 400 / 3600 direction -z }
light_source { <-1000, 2000, 2000> rgb 1 parallel point_at 0 shadowless }
#declare S = seed(15);
#for (I, 1, $count)
  sphere { <2 * rand(S) - 1, 2 * rand(S) - 1, 2 * rand(S) - 1>, $radius
    pigment { rgb <rand(S), rand(S), rand(S)> } finish { ambient 0.06 diffuse 0.7 } }
#end
SCENE
    ours=$(for _ in 1 2 3 4 5; do
        target/debug/groundtruth render "$work/spheres.toml" -o "$work/ours.png" --threads 1 2>&1 |
            sed -n 's/.*rendered in \([0-9.]*\) s.*/\1/p'
    done | median)
    theirs=$(for _ in 1 2 3; do
        povray "+I$work/spheres.pov" "+O$work/pov.png" +W400 +H400 -D -A +WT1 2>&1 |
            sed -n 's/.*Trace Time:.*(\([0-9.]*\) seconds).*/\1/p'
    done | median)
    printf '%9d %11ss %11ss %7s\n' "$count" "$ours" "$theirs" \
        "$(awk -v a="$ours" -v b="$theirs" 'BEGIN { print (b > 0) ? a / b : "-" }')"
done
