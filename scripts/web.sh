#!/usr/bin/env bash
# The library and the gallery as one WebAssembly module without imports, target/web/groundtruth.wasm, and its check: random pixels
# of every gallery scene have the native bits, under Node (COUNT pixels a scene, drawn with SEED). The compiler is rustup's, if its
# target wasm32-unknown-unknown is installed; else Debian's (packages below, all of one version), fetched and unpacked into
# target/web-compiler without being installed, with the standard library built anew by -Z build-std.
# The exit status is 0 if all bits agree, 1 if some differ, 77 without a compiler or Node.
set -euo pipefail
cd "$(dirname "$0")/.."

PACKAGES=(rustc-web rust-web-src libstd-rust-web-dev libstd-rust-web-1.96 lld-22 libllvm22)
TARGET=wasm32-unknown-unknown
compiler=$PWD/target/web-compiler
build=(cargo build --release --quiet --locked --target "$TARGET" --target-dir target/web-build --manifest-path web/Cargo.toml --lib)

if rustup target list --installed 2> /dev/null | grep -qx "$TARGET"; then
    "${build[@]}"
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
        "${build[@]}" -Z build-std=std,panic_abort 2> >(grep "^error" -A9 >&2)
fi
mkdir -p target/web
cp "target/web-build/$TARGET/release/groundtruth_web.wasm" target/web/groundtruth.wasm
echo "target/web/groundtruth.wasm: $(gzip -9 -c target/web/groundtruth.wasm | wc -c) bytes compressed"

command -v node > /dev/null || { echo "node is missing: the bits are not compared" >&2; exit 77; }
cargo build --release --quiet --locked --target-dir target/own --manifest-path web/Cargo.toml --bin native_bits
node web/bits.mjs target/web/groundtruth.wasm "${COUNT:-20}" "${SEED:-1}" > target/web/bits.txt
target/own/release/native_bits "${COUNT:-20}" "${SEED:-1}" | diff - target/web/bits.txt > target/web/bits.diff || {
    echo "other bits than the native library's: target/web/bits.diff" >&2
    exit 1
}
echo "$(grep -c / target/web/bits.txt) scenes, $(grep -vc / target/web/bits.txt) pixels: the native bits"
