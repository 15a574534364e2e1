#!/bin/sh
# Takes docs/inspector.png and the pictures of docs/inspector.md, or those whose names are given (INTO=FOLDER: into another
# folder): opens the inspector on a virtual screen, each time at a pixel. Needs the packages of scripts/headless.sh.
set -eu
cd "$(dirname "$0")/.."
wanted=${*:-all}
into=${INTO:-docs}
taken=0

for tool in Xvfb xdotool import; do
    if ! command -v "$tool" >/dev/null; then
        echo "error: $tool is missing; run scripts/headless.sh first" >&2
        exit 2
    fi
done
cargo build --bin inspector
program=${CARGO_TARGET_DIR:-target}/debug/inspector

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

# picture NAME SCENE ARGUMENTS...: a window on the scene, once its picture is finished
picture() {
    name=$1 scene=$2
    shift 2
    case " $wanted " in *" all "* | *" $name "*) ;; *) return 0 ;; esac
    # usual settings, whatever this person's are
    XDG_DATA_HOME="$folder" "$program" "$scene" "$@" 2>"$folder/inspector.log" &
    window=$!
    # the title says when the picture is finished
    if ! timeout 300 xdotool search --sync --onlyvisible --name "^$scene - Groundtruth inspector\$" >/dev/null; then
        echo "error: no window with a finished picture appeared" >&2
        cat "$folder/inspector.log" >&2
        exit 2
    fi
    sleep 4
    import -window root "png24:$into/$name.png"
    kill "$window"
    wait "$window" 2>/dev/null || true
    window=
    taken=$((taken + 1))
    echo "$into/$name.png"
}

picture inspector ch28/glass-sphere --size 300x300 --pixel 146,176 --view both
picture your-rays examples/rays/black-dots.jsonl --view both
picture tour-acne ch16/surface-acne --pixel 138,115 --view both
picture tour-terminator ch23/smooth-sphere --pixel 90,110 --view both
picture tour-lost-roots ch19/lost-roots --pixel 145,80
picture tour-total-reflection ch27/mirror-ring --pixel 185,111 --view both --tab section
picture tour-colour-bleeding ch26/cornell-box --size 140x140 --samples 16 --pixel 24,118 --sample 2 --view both
picture tour-noise ch26/cornell-box-path-trace --size 140x140 --pixel 70,60 --view both --tab sum

if [ "$taken" = 0 ]; then
    echo "error: no picture has such a name: $wanted" >&2
    exit 2
fi
