#!/bin/sh
# Fetches Embree 4 from the Python package `embreex` and measures our meshes against it and others;
# `peers.sh occlusion` measures a whole picture of ambient occlusion, and `peers.sh cornell` the Cornell
# box beside Mitsuba 3, from the Python package `mitsuba`.
set -eu
cd "$(dirname "$0")/.."
if [ "${1:-}" = cornell ]; then
    [ -d target/mitsuba ] || python3 -m venv target/mitsuba
    target/mitsuba/bin/pip install --quiet mitsuba numpy
    cargo build --release --bin groundtruth
    shift
    exec target/mitsuba/bin/python benches/peers/cornell.py "$@"
fi
folder=target/embree
if [ ! -d "$folder" ]; then
    python3 -m pip download --quiet --no-deps --only-binary :all: --dest "$folder.wheel" embreex
    python3 -m zipfile -e "$folder.wheel"/embreex-*.whl "$folder"
fi
EMBREE=$(ls "$PWD/$folder"/embreex.libs/libembree4*.so* | head -n 1)
export EMBREE
exec cargo run --release --manifest-path benches/peers/Cargo.toml --bin "${1:-peers}"
