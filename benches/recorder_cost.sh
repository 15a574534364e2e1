#!/bin/sh
# Instructions of a small picture with a silent recorder, against the same source with every call
# to a recorder cut out. Needs git, perl and valgrind; run it at the root of the repository.
set -eu
example=release/examples/recorder_cost
target=${CARGO_TARGET_DIR:-$PWD/target}
export CARGO_TARGET_DIR="$target"
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 |
        sed -n 's/.*Collected : //p'
}

cargo build --quiet --release --example recorder_cost
none=$(count "$target/$example" none)
silent=$(count "$target/$example" silent)
cp "$target/$example" "$copy/with"

git archive HEAD | tar -x -C "$copy"
traced=$(ls "$copy"/src/trace/*.rs | grep -v -e recorder.rs -e tree.rs)
calls='recorder\.(enter|hit|draw|term|leave)\('
# shellcheck disable=SC2086
perl -0pi -e "s/^\s*(self\.)?$calls[^;]*\);\n//mg" $traced
# shellcheck disable=SC2086
if grep -nE "$calls" $traced; then
    echo "these calls were not cut out" >&2
    exit 1
fi
cargo build --quiet --release --example recorder_cost --manifest-path "$copy/Cargo.toml" 2>/dev/null
without=$(count "$target/$example" silent)

echo "setting up: $none instructions"
echo "silent recorder: $silent"
echo "no recorder: $without"
awk "BEGIN { printf \"cost: %+.3f %%\\n\", 100 * ($silent - $without) / ($without - $none) }"
