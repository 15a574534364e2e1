#!/usr/bin/env bash
# The programs for this machine as one archive, target/package/groundtruth-VERSION-HOST.tar.gz: the command, the inspector, the
# licences. Unpacks it and asks the command once, so that what is packed runs.
set -euo pipefail
cd "$(dirname "$0")/.."

host=$(rustc -vV | sed -n 's/^host: //p')
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
name=groundtruth-$version-$host
end=
case $host in *windows*) end=.exe ;; esac
cargo build --release --quiet --locked --bin groundtruth --bin inspector
rm -rf target/package
mkdir -p "target/package/$name"
cp "target/release/groundtruth$end" "target/release/inspector$end" LICENSE-APACHE LICENSE-MIT README.md "target/package/$name/"
tar -C target/package -czf "target/package/$name.tar.gz" "$name"
rm -r "target/package/$name"
tar -C target/package -xzf "target/package/$name.tar.gz"
"target/package/$name/groundtruth$end" --version
rm -r "target/package/$name"
ls -sh "target/package/$name.tar.gz"
