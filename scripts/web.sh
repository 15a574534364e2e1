#!/usr/bin/env bash
# The inspector as a page in target/web, for any static server (python3 -m http.server -d target/web), and the library with the
# gallery as one WebAssembly module without imports, groundtruth.wasm. Two checks: under Node random pixels of every gallery
# scene have the native bits (COUNT pixels a scene, drawn with SEED); in Chromium a link and a click explain what the command
# explains. The compiler is rustup's, if its target wasm32-unknown-unknown is installed; else Debian's (packages below, all of
# one version), fetched and unpacked into target/web-compiler without being installed, with the standard library built anew by
# -Z build-std. QUICK=1 is for a check of every change, in a third of the time: the library is optimised less and has its bits
# compared, of the page only the types are checked. The exit status is 0 if all agrees, 1 if not, 77 without a compiler, Node or Chromium.
set -euo pipefail
cd "$(dirname "$0")/.."

PACKAGES=(rustc-web rust-web-src libstd-rust-web-dev libstd-rust-web-1.96 lld-22 libllvm22)
TARGET=wasm32-unknown-unknown
compiler=$PWD/target/web-compiler
web=(--release --quiet --locked --target "$TARGET" --target-dir target/web-build --manifest-path web/Cargo.toml --lib)
if [ "${QUICK:-}" ]; then
    for setting in lto=false codegen-units=16 opt-level=1 package.groundtruth.opt-level=1; do
        web+=(--config "profile.release.$setting")
    done
fi
both() {
    if [ "${QUICK:-}" ]; then
        cargo build "${web[@]}" --package groundtruth-web "$@"
        cargo check "${web[@]}" --package groundtruth-window "$@"
    else
        cargo build "${web[@]}" --package groundtruth-web --package groundtruth-window "$@"
    fi
}

if rustup target list --installed 2> /dev/null | grep -qx "$TARGET"; then
    both
else
    if ! [ -x "$compiler/rustc" ]; then
        rm -rf "$compiler" "$compiler.new"
        mkdir -p "$compiler.new"
        if ! (cd "$compiler.new" && apt-get download "${PACKAGES[@]}") > /dev/null 2>&1; then
            echo "no compiler for $TARGET: rustup target add $TARGET, or on Debian 12 fetch ${PACKAGES[*]}" >&2
            exit 77
        fi
        for package in "$compiler.new"/*.deb; do dpkg -x "$package" "$compiler.new"; done
        rm "$compiler.new"/*.deb
        printf '#!/bin/sh\nLD_LIBRARY_PATH=%s exec %s "$@"\n' \
            "$compiler/usr/lib/x86_64-linux-gnu" "$compiler/usr/bin/rustc" > "$compiler.new/rustc"
        chmod +x "$compiler.new/rustc"
        mv "$compiler.new" "$compiler"
    fi
    RUSTC=$compiler/rustc RUSTC_BOOTSTRAP=1 \
        CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$compiler/usr/bin/wasm-ld-22 \
        LD_LIBRARY_PATH=$compiler/usr/lib/x86_64-linux-gnu \
        both -Z build-std=std,panic_abort 2> >(grep "^error" -A9 >&2)
fi
rm -rf target/web
mkdir -p target/web
built=target/web-build/$TARGET/release
cp "$built/groundtruth_web.wasm" target/web/groundtruth.wasm
if ! [ "${QUICK:-}" ]; then
    cp web/index.html target/web/
    cargo run --profile tool --quiet --locked --target-dir target/own --manifest-path web/Cargo.toml --package bind -- \
        "$built/groundtruth_window.wasm" target/web
    for module in groundtruth.wasm window_bg.wasm; do
        echo "target/web/$module: $(gzip -9 -c "target/web/$module" | wc -c) bytes compressed"
    done
fi

command -v node > /dev/null || { echo "node is missing: nothing is checked" >&2; exit 77; }
cargo build --quiet --locked --example native_bits
checks=$(mktemp -d)
trap 'rm -rf "$checks"' EXIT
node web/bits.mjs target/web/groundtruth.wasm "${COUNT:-20}" "${SEED:-1}" > "$checks/bits.txt"
target/debug/examples/native_bits "${COUNT:-20}" "${SEED:-1}" | diff - "$checks/bits.txt" || {
    echo "other bits than the native library's" >&2
    exit 1
}
echo "$(grep -c / "$checks/bits.txt") scenes, $(grep -vc / "$checks/bits.txt") pixels: the native bits"

[ -z "${QUICK:-}" ] || exit 0
command -v chromium > /dev/null || { echo "chromium is missing: the page is not checked" >&2; exit 77; }
cargo build --quiet --locked --bin groundtruth
# the sample of a link, then the pixel of a click into the picture
node web/page.mjs target/web '#ch28/glass-sphere&pixel=282,244&sample=3' 500,300 > "$checks/page.txt"
{
    target/debug/groundtruth explain ch28/glass-sphere 282,244 --sample 3
    pixel=$(sed -n 's/^pixel (\([0-9]*\), \([0-9]*\)).*/\1,\2/p' "$checks/page.txt" | tail -n 1)
    target/debug/groundtruth explain ch28/glass-sphere "$pixel" --sample 3
} | diff - "$checks/page.txt" || {
    echo "the page explains otherwise than the command" >&2
    exit 1
}
echo "$(grep -c '^pixel' "$checks/page.txt") pixels: the page explains what the command explains (target/web/page.png)"
