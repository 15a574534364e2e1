#!/bin/sh
# Tries the window's clipboard on a virtual screen: each entry of the menu "Copy" must reach another
# program, and text of another program must arrive in the field that names a scene file. Tests of the
# window cannot see this: they have no clipboard.
# Needs the packages of scripts/headless.sh. A program that is built already is tried if it is named:
# scripts/clipboard.sh target/debug/inspector
set -eu
cd "$(dirname "$0")/.."

for tool in Xvfb xdotool xclip; do
    if ! command -v "$tool" >/dev/null; then
        echo "error: $tool is missing; run scripts/headless.sh first" >&2
        exit 2
    fi
done
program=${1:-}
if [ -z "$program" ]; then
    cargo build --bin inspector
    program=${CARGO_TARGET_DIR:-target}/debug/inspector
fi

folder=$(mktemp -d)
window= screen=
finish() {
    [ -z "$window" ] || kill "$window" 2>/dev/null || true
    [ -z "$screen" ] || kill "$screen" 2>/dev/null || true
    rm -rf "$folder"
}
trap finish EXIT
trap 'exit 130' INT TERM

# Xvfb chooses a free display and writes its number
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1400x830x24 -nolisten tcp 3>"$folder/display" 2>"$folder/xvfb.log" &
screen=$!
read -r number <"$folder/display"
export DISPLAY=":$number"

# usual settings, whatever this person's are; a small picture, so that an unoptimised program is quick
XDG_DATA_HOME="$folder" "$program" ch28/glass-sphere --size 48x48 --samples 1 --pixel 24,24 \
    2>"$folder/inspector.log" &
window=$!
# the title says when the picture is finished
title='^ch28/glass-sphere - Groundtruth inspector$'
if ! id=$(timeout 300 xdotool search --sync --onlyvisible --name "$title"); then
    echo "error: no window with a finished picture appeared" >&2
    cat "$folder/inspector.log" >&2
    exit 2
fi
# no window manager gives it the keys
xdotool windowfocus --sync "$id"
sleep 1

failed=0
# Fails unless the clipboard holds a text with these words; a page takes some seconds to be made.
expect() {
    for _ in $(seq 20); do
        held=$(timeout 10 xclip -o -selection clipboard 2>/dev/null || true)
        case $held in
        *"$2"*)
            echo "ok: $1"
            return
            ;;
        esac
        sleep 1
    done
    echo "error: $1: the clipboard holds \"$held\"" >&2
    failed=1
}

# Puts a text of another program on the clipboard.
offer() {
    printf '%s' "$1" | xclip -i -selection clipboard
}

# the entries of the menu "Copy" from top to bottom, and a word of what each copies
try_entry() {
    offer nothing
    xdotool mousemove 1369 107 click 1
    sleep 1
    xdotool mousemove 1230 "$1" click 1
    sleep 1
    expect "$2" "$3"
}
try_entry 135 "the command for a terminal" "groundtruth explain"
try_entry 158 "the probe's line" '{"radiance":'
try_entry 181 "a page for a class" "<!DOCTYPE html>"
try_entry 204 "a test in Rust" "#[test]"
try_entry 227 "the pixel, all its digits" ", 0."
try_entry 250 "all numbers of the selected ray" "angle of incidence"

# pasted into the field of a scene file, and copied from there
offer /from/another/program.toml
xdotool mousemove 630 14 click 1
sleep 1
xdotool key ctrl+v
sleep 1
offer nothing
xdotool key ctrl+a
sleep 0.3
xdotool key ctrl+c
sleep 1
expect "pasted text" /from/another/program.toml
exit "$failed"
