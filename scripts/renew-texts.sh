#!/usr/bin/env bash
# Writes anew all texts that tests hold to what the program prints: the snapshots of ray trees, the answers in
# docs/probe.md, the commands in docs/verify.md, exported scenes, a kept test, and the pages of kinds and of known mistakes.
# They are goldens of words: look at `git diff` and commit what you looked at. The table of mistakes and scenes takes minutes, and is written
# by `cargo run -- mistakes --table > harness/judge/src/mistakes/shown.csv`.
set -euo pipefail
cd "$(dirname "$0")/.."
# INSTA_UPDATE is insta's own
export RENEW_TEXTS=1 INSTA_UPDATE=always
cargo test --quiet --workspace --test chapters --test commands --test exchange --test keep --test rays --test report --test space --test window -- reads_as_before read_as_before the_document the_schema ticks_are_round what_has_a_logarithm
page=$(mktemp)
trap 'rm -f "$page"' EXIT
cargo run --quiet -- kinds --page > "$page" && cp "$page" docs/scene.md
cargo run --quiet -- mistakes --page > "$page" && cp "$page" docs/mistakes.md
git status --short docs tests benches/report/tests harness/exchange/tests explain/*/tests inspector/tests
