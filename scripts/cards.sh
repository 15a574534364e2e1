#!/usr/bin/env bash
# Report cards of programs that people use (docs/cards.md): each is fetched into target/cards from the public registries,
# asked the questions of `groundtruth conform` through its adapter in examples/conform/programs, and its card printed.
#
#   bash scripts/cards.sh [NAME…]        # trimesh embree parry three povray mitsuba; all, if none is named
#
# PROGRAM is the `groundtruth` to run, built if left out; OPTIONS are more words for `conform`, before its `--`.
# A card is printed for each profile that fits: `careful` for double precision, `book` beside it for single precision.
# It stays in target/cards/*.json. A program that cannot be installed is named and skipped. The exit status is 0 if all
# could be asked, whatever they answered, 1 if one could not, 77 if none could. POV-Ray takes a quarter of an hour, the
# others a few minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
adapters=examples/conform/programs
folder=target/cards
mkdir -p "$folder"

if [ -z "${PROGRAM:-}" ]; then
    cargo build --quiet --bin groundtruth
    PROGRAM=target/debug/groundtruth
fi

# a Python environment with these packages: venv NAME PACKAGE…
venv() {
    local place=$folder/$1
    shift
    { [ -x "$place/bin/python" ] || python3 -m venv "$place"; } && "$place/bin/pip" install --quiet "$@"
}

fetch() {
    case $1 in
        trimesh) venv trimesh numpy scipy rtree trimesh ;;
        embree) venv embree embreex ;;
        mitsuba) venv mitsuba mitsuba numpy ;;
        three) npm install --prefix "$folder/three" --silent --no-audit --no-fund three && cp "$adapters/ask_three.mjs" "$folder/three" ;;
        parry)
            cargo build --release --quiet --manifest-path "$adapters/Cargo.toml" --target-dir "$folder/parry" &&
                cargo build --release --quiet --manifest-path "$adapters/Cargo.toml" --target-dir "$folder/parry-f64" --features f64 ;;
        povray)
            command -v povray || { [ "$(id -u)" = 0 ] && apt-get -qq update && apt-get -qq install -y povray; } ;;
        *) echo "there is no adapter for $1" && return 1 ;;
    esac
}

version() {
    case $1 in
        trimesh | mitsuba) "$folder/$1/bin/pip" show "$1" ;;
        embree) "$folder/embree/bin/pip" show embreex ;;
        three) sed -n 's/.*"version": "\(.*\)".*/Version: \1/p' "$folder/three/node_modules/three/package.json" ;;
        parry) sed -n '/^name = "parry3d"/{n;s/version = "\(.*\)"/Version: \1/p}' "$adapters/Cargo.lock" ;;
        povray) povray --version 2>&1 | sed -n 's/^POV-Ray \([0-9.]*[0-9]\).*/Version: \1/p' ;;
    esac | sed -n 's/^Version: //p' | head -n 1
}

# card FILE TITLE PROFILE COMMAND…
card() {
    local file=$folder/$1.json title=$2 profile=$3 status=0
    shift 3
    # shellcheck disable=SC2086
    "$PROGRAM" conform --timeout 60 --profile "$profile" --json ${OPTIONS:-} -- "$@" > "$file" 2> "$folder/errors" || status=$?
    if [ "$status" -le 1 ]; then
        python3 scripts/card.py "$title, profile $profile" "$file"
    else
        echo "$title: no card" >&2
        cat "$folder/errors" >&2
        failed=1
    fi
}

cards() {
    local v python=$folder/$1/bin/python
    v=$(version "$1")
    case $1 in
        trimesh) card trimesh "trimesh $v" careful "$python" "$adapters/ask_trimesh.py" ;;
        embree)
            card embree "Embree in embreex $v" careful "$python" "$adapters/ask_embree.py"
            card embree-book "Embree in embreex $v" book "$python" "$adapters/ask_embree.py"
            card embree-robust "Embree in embreex $v, robust" careful "$python" "$adapters/ask_embree.py" --robust
            card embree-robust-book "Embree in embreex $v, robust" book "$python" "$adapters/ask_embree.py" --robust ;;
        parry)
            card parry "parry3d $v" careful "$folder/parry/release/ask_parry"
            card parry-book "parry3d $v" book "$folder/parry/release/ask_parry"
            card parry-f64 "parry3d-f64 $v" careful "$folder/parry-f64/release/ask_parry" ;;
        three)
            card three "three.js $v" careful node "$folder/three/ask_three.mjs"
            card three-book "three.js $v" book node "$folder/three/ask_three.mjs" ;;
        povray)
            card povray "POV-Ray $v" careful python3 "$adapters/ask_povray.py"
            OPTIONS="${OPTIONS:-} shapes/torus shapes/algebraic" \
                card povray-sturm "POV-Ray $v, sturm" careful python3 "$adapters/ask_povray.py" --sturm ;;
        mitsuba)
            card mitsuba "Mitsuba $v, scalar_rgb" careful "$python" "$adapters/ask_mitsuba.py"
            card mitsuba-book "Mitsuba $v, scalar_rgb" book "$python" "$adapters/ask_mitsuba.py"
            # each question is compiled anew: shapes only, and few cases
            OPTIONS="intersect occluded --cases 8" \
                card mitsuba-llvm-book "Mitsuba $v, llvm_ad_rgb" book "$python" "$adapters/ask_mitsuba.py" llvm_ad_rgb ;;
    esac
}

[ $# -gt 0 ] || set -- trimesh embree parry three povray mitsuba
asked=0 missing=""
for name in "$@"; do
    if ! fetch "$name" > "$folder/log" 2>&1; then
        echo "$name: cannot be installed, skipped: $(tail -n 1 "$folder/log")" >&2
        missing="$missing $name"
        continue
    fi
    failed=""
    cards "$name"
    if [ -n "$failed" ]; then missing="$missing $name"; else asked=$((asked + 1)); fi
done
[ "$asked" -gt 0 ] || exit 77
[ -z "$missing" ]
