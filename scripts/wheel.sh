#!/usr/bin/env bash
# Builds the wheel `groundtruth-rays` for this machine into target/wheels: the command `groundtruth`, and the module
# `groundtruth_rays` for numpy, for every Python from 3.9 on. CHECK=1 also installs it into a fresh virtual environment,
# where no Rust is needed: a first verdict of `conform`, the laws of the module, and the notebooks.
# The exit status is 77 without Python, or without the packages that it fetches.
set -euo pipefail
cd "$(dirname "$0")/.."

tools=$PWD/target/wheel-tools
if ! [ -x "$tools/bin/maturin" ]; then
    { python3 -m venv "$tools" && "$tools/bin/pip" install --quiet "maturin>=1.16,<2"; } || {
        echo "no wheel: Python 3.9 with venv and pip, and maturin from the network, are needed" >&2
        exit 77
    }
fi
cargo build --release --quiet --locked --bin groundtruth
mkdir -p python/data/scripts
cp target/release/groundtruth python/data/scripts/
rm -rf target/wheels
"$tools/bin/maturin" build --release --quiet --locked --strip --manifest-path python/Cargo.toml \
    --target-dir target/python --out target/wheels
rm python/data/scripts/groundtruth
ls -sh target/wheels/*.whl
[ "${CHECK:-}" ] || exit 0

fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
began=$SECONDS
python3 -m venv "$fresh/env"
"$fresh/env/bin/pip" install --quiet target/wheels/*.whl
export PATH=$fresh/env/bin:/usr/bin:/bin
cp examples/conform/wrong.py "$fresh"
cd "$fresh"
command -v cargo && { echo "the fresh environment has Rust" >&2; exit 1; }
# a program with known mistakes: 1 is the right answer
status=0
groundtruth conform ch03 -- python wrong.py > card.txt || status=$?
head -n 1 card.txt
[ "$status" = 1 ] || { echo "conform ended with $status" >&2; exit 1; }
echo "from the wheel to a verdict of conform: $((SECONDS - began)) s"
cd "$OLDPWD"
pip install --quiet nbclient nbformat ipykernel matplotlib
python python/tests/check.py
