#!/bin/sh
# Takes docs/inspector.png, or the file that is named: opens the inspector on a virtual screen and
# clicks on the glass sphere.
# Needs the packages of scripts/headless.sh.
set -eu
cd "$(dirname "$0")/.."
picture=${1:-docs/inspector.png}

for tool in Xvfb xdotool import; do
    if ! command -v "$tool" >/dev/null; then
        echo "error: $tool is missing; run scripts/headless.sh first" >&2
        exit 2
    fi
done
cargo build --release -p inspector
program=${CARGO_TARGET_DIR:-target}/release/inspector

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

# usual settings, whatever this person's are
XDG_DATA_HOME="$folder" "$program" ch28/glass-sphere 2>"$folder/inspector.log" &
window=$!
# the title says when the picture is finished
title='^ch28/glass-sphere - Groundtruth inspector$'
if ! timeout 300 xdotool search --sync --onlyvisible --name "$title" >/dev/null; then
    echo "error: no window with a finished picture appeared" >&2
    cat "$folder/inspector.log" >&2
    exit 2
fi
sleep 1
xdotool mousemove 520 370 click 1
sleep 2
xdotool mousemove 620 520
sleep 1
import -window root "png24:$picture"
echo "$picture"
