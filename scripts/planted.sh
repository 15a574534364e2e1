#!/bin/sh
# Plants each mistake and decoy of power/planted into one scratch copy of the last commit (target/power, about 8 GB), behind
# a switch, builds its tests once, and prints which law finds which. A first run takes hours on two cores, of which the build
# and one run of all tests are half an hour; parts share them: scripts/planted.sh 2/8 asks every eighth, from the second.
# With MUTANTS=400 as many mutants of cargo-mutants' list are drawn and planted, too (tracer, formats, harness; SEED=1 says
# which); cargo install --locked cargo-mutants. With WHAT=matrix every test is run on each change that it reaches, which takes
# some eight hours of processor for 230 changes: which test finds what alone stands in target/power/matrix.csv. The tables of all parts: cargo run --manifest-path power/Cargo.toml -- score
set -eu
cd "$(dirname "$0")/.."

set -- "${1:-1/1}"
if [ -n "${MUTANTS:-}" ]; then
    mkdir -p target
    cargo mutants --list --json --workspace --exclude 'oracle/**' --exclude 'gallery/**' --exclude 'inspector/**' \
        >target/mutants.json
    set -- "$1" --mutants target/mutants.json --of "$MUTANTS" --seed "${SEED:-1}"
fi
exec cargo run --release --quiet --target-dir target/own --manifest-path power/Cargo.toml -- "${WHAT:-run}" "$@"
