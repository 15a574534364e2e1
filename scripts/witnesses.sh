#!/usr/bin/env bash
# Our scenes by other renderers: POV-Ray 3.7 (Debian package `povray`, installed if it is missing and this is root) and
# Mitsuba 3 (Python package `mitsuba`, installed in target/mitsuba if it is missing). Every scene of the gallery that can be
# said to them is rendered by both sides and judged (docs/renderers.md). With WORDs, only the scenes that
# `groundtruth list WORD` lists. What a renderer does not have (highlights, ambient light, …) is left out
# on both sides, and scenes that Mitsuba cannot render otherwise have their paths traced by both (`--tracer path`). Prints the
# table scene × renderer; for each scene that cannot be said, why, if LISTED=1. BY=pov or BY=mitsuba asks only one; PYTHON is
# the Python that has Mitsuba. JOBS scenes are rendered at once: 4 by POV-Ray alone, which sleeps for most of a second in each
# run, otherwise 1.
# The exit status is 0 if every picture agrees, 1 if some differ, 2 if one could not be rendered, 77 without a renderer.
set -euo pipefail
cd "$(dirname "$0")/.."

# Of Mitsuba's pictures with noise about 40 are judged at the level 0.01, so that one in three runs has a false alarm.
# A picture that differs is therefore rendered again with four times the samples, and judged at the level 0.005.
FIRST=(--their-samples 16 --level 0.01)
AGAIN=(--their-samples 64 --level 0.005)

# Known differences, by docs/renderers.md: they are shown and do not count. All are errors of Mitsuba in single precision.
KNOWN=" ch17/sphere-in-sunlight ch17/corner-ambient ch17/corner ch17/corner-dark ch23/leaks-cured ch24/inside-four-spheres "
# POV-Ray ignores hits nearer than 10⁻⁴, which rays in glass have; and does not say which of two surfaces at the same distance it
# hits (ch27/cylinder). Some of its rays pass between the triangles of a mesh (ch23/leaks-cured).
KNOWN_POV=" ch23/leaks-cured ch27/cylinder ch27/ellipsoid ch27/ring ch28/ten-blocks "

by=()
PYTHON=${PYTHON:-target/mitsuba/bin/python}
if [ "${BY:-pov}" = pov ]; then
    if ! command -v povray > /dev/null && [ "$(id -u)" = 0 ] && command -v apt-get > /dev/null; then
        { apt-get -qq update && apt-get -qq install -y povray; } > /dev/null 2>&1 || true
    fi
    if command -v povray > /dev/null; then by+=(pov); else echo "povray is missing: apt-get install povray" >&2; fi
fi
if [ "${BY:-mitsuba}" = mitsuba ]; then
    if ! "$PYTHON" -c "import mitsuba" 2> /dev/null; then
        { python3 -m venv target/mitsuba && target/mitsuba/bin/pip install --quiet mitsuba==3.9.1; } > /dev/null 2>&1 || true
    fi
    if "$PYTHON" -c "import mitsuba" 2> /dev/null; then
        by+=(mitsuba)
    else
        echo "mitsuba is missing: pip install mitsuba, and name that Python by PYTHON" >&2
    fi
fi
[ ${#by[@]} -gt 0 ] || exit 77

if [ -z "${PROGRAM:-}" ]; then
    cargo build --quiet --bin groundtruth
    PROGRAM=target/debug/groundtruth
fi
all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
if [ "${by[*]}" = pov ]; then JOBS=${JOBS:-4}; else JOBS=${JOBS:-1}; fi
declare -A columns=([pov]=96 [mitsuba]=64)
declare -A title=([pov]=POV-Ray [mitsuba]=Mitsuba)

# so many columns, and as many rows as the scene's shape needs
size() {
    "$PROGRAM" export "$1" 2> /dev/null | awk -v n="$2" '
        /^width = / && !w { w = $3 } /^height = / && !h { h = $3 }
        END { print n "x" (h * n % w == 0 ? h * n / w : int(h * n / w + 0.5)) }'
}

# sets `without` and `tracer` so that the scene of a size can be said to a renderer; fails if it cannot
sayable() {
    without="" tracer=()
    local term
    while ! "$PROGRAM" export "$1" --size "$3" --format "$2" -o "$work/scene.xml" --replace ${without:+--without "$without"} "${tracer[@]}" \
        > /dev/null 2> "$work/why"; do
        for term in phong ambient unshadowed absorption scaling smooth background; do
            if [[ ,$without, != *,$term,* ]] && grep -q -e "--without $term" "$work/why"; then
                without=${without:+$without,}$term
                continue 2
            fi
        done
        if [ ${#tracer[@]} = 0 ] && grep -q -e "--tracer path" "$work/why"; then
            tracer=(--tracer path)
            continue
        fi
        return 1
    done
}

# the verdict on a scene by a renderer, as a cell of the table, and what it counts as
cell() {
    local scene=$1 by=$2 options status=0
    options=(--by "$by" --size "$3" --replicas 3 ${without:+--without "$without"} "${tracer[@]}")
    if [ "$by" = mitsuba ]; then
        options+=(--program "$PYTHON")
        "$PROGRAM" verify "$scene" "${options[@]}" "${FIRST[@]}" > "$work/said" 2> "$work/errors" || status=$?
        # a scene without random numbers takes no samples
        if [ "$status" = 2 ] && grep -q "no random numbers" "$work/errors"; then
            status=0
            "$PROGRAM" verify "$scene" "${options[@]}" > "$work/said" 2> "$work/errors" || status=$?
        elif [ "$status" = 1 ]; then
            status=0
            "$PROGRAM" verify "$scene" "${options[@]}" "${AGAIN[@]}" > "$work/said" 2> "$work/errors" || status=$?
        fi
    else
        "$PROGRAM" verify "$scene" "${options[@]}" > "$work/said" 2> "$work/errors" || status=$?
    fi
    if [ "$status" = 1 ] && [ "$by" = mitsuba ] && [[ $KNOWN = *" $scene "* ]]; then
        status=3
    fi
    if [ "$status" = 1 ] && [ "$by" = pov ] && [[ $KNOWN_POV = *" $scene "* ]]; then
        status=3
    fi
    case $status in
        0) outcome=agree ;;
        1) outcome=differ ;;
        3) outcome=known ;;
        *) cat "$work/errors" >&2; exit 2 ;;
    esac
    local apart
    apart=$(sed -n 's/^not counted: \([0-9]* pixels\{0,1\}\).*/; \1 set apart/p' "$work/said")
    verdict=$(sed -n -E -e 's/^agrees: it is our picture.*/equal/p' -e 's/^agrees: no value.*/agrees/p' \
        -e 's/^rank: ([0-9]+) of ([0-9]+) .*/agrees, \1 of \2/p' -e 's/^(differs).*/\1/p' "$work/said")
    [ "$status" != 3 ] || verdict+=", known"
    verdict+="$apart${without:+; without ${without//,/, }}${tracer:+; path}"
}

# writes the line of a scene into a folder, and a file for each renderer with what it counts as
row() {
    local scene=$1 line="" said=0 it picture verdict outcome
    work=$2
    mkdir "$work"
    for it in "${by[@]}"; do
        verdict="" outcome=refused
        picture=$(size "$scene" "${columns[$it]}")
        if sayable "$scene" "$it" "$picture"; then
            said=1
            cell "$scene" "$it" "$picture"
        elif [ -n "${LISTED:-}" ]; then
            { echo "$scene to ${title[$it]}:"; cat "$work/why"; } >&2
        fi
        line+=" $verdict |"
        echo "$outcome" > "$work/$it"
    done
    [ "$said" = 0 ] || echo "| \`$scene\` |$line" > "$work/line"
}

# prints the lines of the scenes that are being rendered, and waits for them
finish() {
    local index
    for index in "${!running[@]}"; do
        wait "${running[$index]}" || exit 2
        [ ! -f "$all/$index/line" ] || cat "$all/$index/line"
    done
    running=()
}

# how many scenes count as this for a renderer
count() {
    cat "$all"/*/"$1" 2> /dev/null | grep -c -x "$2" || true
}

printf '| scene |'; for it in "${by[@]}"; do printf ' %s |' "${title[$it]}"; done
printf '\n| --- |'; for it in "${by[@]}"; do printf ' --- |'; done
echo
running=() index=0
for scene in $("$PROGRAM" list "$@" | awk '$1 ~ /^ch[0-9]+\// { print $1 }'); do
    row "$scene" "$all/$index" &
    running[index]=$!
    index=$((index + 1))
    [ ${#running[@]} -lt "$JOBS" ] || finish
done
finish
echo
failed=0 known=0
for it in "${by[@]}"; do
    differ=$(count "$it" differ)
    echo "${title[$it]}: $(count "$it" agree) scenes agree, $differ differ, $(count "$it" refused) cannot be said"
    failed=$((failed + differ))
    known=$((known + $(count "$it" known)))
done
[ "$known" = 0 ] || echo "besides, $known scenes differ as docs/renderers.md says"
[ "$failed" = 0 ]
