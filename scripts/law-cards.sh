#!/usr/bin/env bash
# Cards of `groundtruth laws` of programs that people use (docs/cards.md): each is fetched into target/cards from the public
# registries, asked through its adapter in examples/laws, and its card printed.
#
#   bash scripts/law-cards.sh [NAME…]        # mitsuba pbrt eradiate; all, if none is named
#
# PROGRAM is the `groundtruth` to run, built if left out; OPTIONS are more words for `laws`, before its `--`. A card stays in
# target/cards/laws-*.txt. A program that cannot be installed is named and skipped. The exit status is 0 if all could be
# asked, whatever they answered, 1 if one could not. All take a few minutes; rs_pbrt takes some more to build.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=target/cards
mkdir -p "$folder"

if [ -z "${PROGRAM:-}" ]; then
    cargo build --quiet --bin groundtruth
    PROGRAM=target/debug/groundtruth
fi

# a Python environment with these packages, apart from that of scripts/cards.sh: venv NAME PACKAGE…
venv() {
    local place=$folder/$1
    shift
    { [ -x "$place/bin/python" ] || python3 -m venv "$place"; } && "$place/bin/pip" install --quiet "$@"
}

fetch() {
    case $1 in
        mitsuba) venv laws-mitsuba mitsuba ;;
        eradiate) venv laws-eradiate eradiate-mitsuba ;;
        pbrt) cargo build --release --quiet --manifest-path examples/laws/pbrt/Cargo.toml --target-dir "$folder/laws-pbrt" ;;
        *) echo "there is no adapter for $1" && return 1 ;;
    esac
}

version() {
    case $1 in
        mitsuba) "$folder/laws-mitsuba/bin/pip" show mitsuba ;;
        eradiate) "$folder/laws-eradiate/bin/pip" show eradiate-mitsuba ;;
        pbrt) sed -n '/^name = "rs_pbrt"/{n;s/version = "\(.*\)"/Version: \1/p}' examples/laws/pbrt/Cargo.lock ;;
    esac | sed -n 's/^Version: //p' | head -n 1
}

failed=0
card() {
    local name=$1 file=$folder/laws-$1.txt status=0
    shift
    # shellcheck disable=SC2086
    "$PROGRAM" laws ${OPTIONS:-} -- "$@" > "$file" || status=$?
    if [ "$status" -le 1 ]; then
        printf '\n%s %s\n' "$name" "$(version "$name")"
        cat "$file"
    else
        echo "$name: no card" >&2
        failed=1
    fi
}

[ $# -gt 0 ] || set -- mitsuba pbrt eradiate
for name; do
    if ! fetch "$name"; then
        echo "$name cannot be installed here" >&2
        failed=1
        continue
    fi
    case $name in
        mitsuba) card mitsuba "$folder/laws-mitsuba/bin/python" examples/laws/mitsuba_bsdfs.py ;;
        eradiate) card eradiate "$folder/laws-eradiate/bin/python" examples/laws/eradiate_bsdfs.py ;;
        pbrt) card pbrt "$folder/laws-pbrt/release/pbrt_bsdfs" ;;
    esac
done
exit "$failed"
