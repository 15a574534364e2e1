#!/usr/bin/env bash
# Builds the wheel `groundtruth-rays` for this machine into target/wheels: the command `groundtruth`, and the module
# `groundtruth_rays` for numpy, for every Python from 3.9 on. CHECK=1 also installs it into a fresh virtual environment,
# where no Rust is needed: a first verdict of `conform`, the laws of the module, and the notebooks.
# The exit status is 77 without Python, or without the packages that it fetches.
set -euo pipefail
cd "$(dirname "$0")/.."

# the programs of a virtual environment, which Windows has elsewhere
programs() { if [ -d "$1/Scripts" ]; then echo "$1/Scripts"; else echo "$1/bin"; fi; }
python=$(command -v python3 || command -v python || true)
tools=$PWD/target/wheel-tools
if ! [ -x "$(programs "$tools")/maturin" ]; then
    { "$python" -m venv "$tools" && "$(programs "$tools")/pip" install --quiet "maturin>=1.16,<2"; } || {
        echo "no wheel: Python 3.9 with venv and pip, and maturin from the network, are needed" >&2
        exit 77
    }
fi
end=
case $(rustc -vV) in *windows*) end=.exe ;; esac
# a wheel that is only checked takes the program that is there, and a module that is built in half the time
profile=release
if [ "${CHECK:-}" ]; then
    profile=dev
    export CARGO_PROFILE_RELEASE_OPT_LEVEL=1 CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16
fi
cargo build --profile "$profile" --quiet --locked --bin groundtruth
mkdir -p python/data/scripts
cp "target/${profile/dev/debug}/groundtruth$end" python/data/scripts/
rm -rf target/wheels
"$(programs "$tools")/maturin" build --release --quiet --locked --strip --manifest-path python/Cargo.toml \
    --target-dir target/python --out target/wheels
rm "python/data/scripts/groundtruth$end"
ls -sh target/wheels/*.whl
[ "${CHECK:-}" ] || exit 0

fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
cp examples/conform/wrong.py "$fresh"
began=$SECONDS
"$python" -m venv "$fresh/env"
PATH=$(programs "$fresh/env"):/usr/bin:/bin
pip install --quiet numpy || exit 77
pip install --quiet target/wheels/*.whl
if command -v cargo > /dev/null; then
    echo "the fresh environment has Rust" >&2
    exit 1
fi
# a program with mistakes: 1 is the right answer
status=0
(cd "$fresh" && groundtruth conform ch03 -- python wrong.py > card.txt) || status=$?
head -n 1 "$fresh/card.txt"
if [ "$status" != 1 ]; then
    echo "conform ended with $status" >&2
    exit 1
fi
echo "from the wheel to a verdict of conform: $((SECONDS - began)) s"
pip install --quiet nbclient nbformat ipykernel matplotlib || exit 77
(cd "$fresh" && python "$OLDPWD/python/tests/check.py")
