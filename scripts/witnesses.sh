#!/usr/bin/env bash
# Our scenes by POV-Ray 3.7 (Debian package `povray`, installed if it is missing and this is root): every scene of the
# gallery that can be said to it is rendered by both and judged (docs/renderers.md). With WORDs, only the scenes that
# `groundtruth list WORD` lists. Scenes with highlights are rendered without them by both (`--without phong`), because
# POV-Ray's have no cosine. Prints the table scene × verdict; for each scene that cannot be said, why, if LISTED=1.
# The exit status is 0 if every picture agrees, 1 if some differ, 2 if one
# could not be rendered, 77 without POV-Ray.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v povray > /dev/null && [ "$(id -u)" = 0 ] && command -v apt-get > /dev/null; then
    { apt-get -qq update && apt-get -qq install -y povray; } > /dev/null 2>&1 || true
fi
command -v povray > /dev/null || { echo "povray is missing: apt-get install povray" >&2; exit 77; }

if [ -z "${PROGRAM:-}" ]; then
    cargo build --release --quiet --bin groundtruth
    PROGRAM=target/release/groundtruth
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
agree=0 differ=0 refused=0

# 96 columns, and as many rows as the scene's shape needs
size() {
    "$PROGRAM" export "$1" 2> /dev/null | awk '/^width = / && !w { w = $3 } /^height = / && !h { h = $3 }
        END { print "96x" (h * 96 % w == 0 ? h * 96 / w : int(h * 96 / w + 0.5)) }'
}

printf '| scene | verdict |\n| --- | --- |\n'
for scene in $("$PROGRAM" list "$@" | awk '$1 ~ /^ch[0-9]+\// { print $1 }'); do
    without=()
    "$PROGRAM" export "$scene" --format pov > /dev/null 2> "$work/why" || true
    if grep -q '\.ks: ' "$work/why"; then
        without=(--without phong)
    fi
    if ! "$PROGRAM" export "$scene" --format pov "${without[@]}" > /dev/null 2> "$work/why"; then
        refused=$((refused + 1))
        [ -z "${LISTED:-}" ] || { echo "$scene:"; cat "$work/why"; } >&2
        continue
    fi
    if "$PROGRAM" verify "$scene" --by pov --size "$(size "$scene")" --replicas 3 "${without[@]}" > "$work/said" 2> "$work/errors"; then
        agree=$((agree + 1))
    elif [ $? = 1 ]; then
        differ=$((differ + 1))
    else
        cat "$work/errors" >&2
        exit 2
    fi
    verdict=$(grep -E '^(agrees|differs|undecided)' "$work/said")
    apart=$(sed -n 's/^set apart: \([0-9]* pixels\{0,1\}\).*/; \1 set apart/p' "$work/said")
    echo "| $scene | $verdict$apart${without:+; without phong} |"
done
echo
echo "$agree scenes agree, $differ differ, $refused cannot be said"
[ "$differ" = 0 ]
