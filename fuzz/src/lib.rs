//! Fuzz targets: the readers of files and text, and the laws that hold for any finite input.
//!
//! ```text
//! cargo install --locked cargo-fuzz
//! RUSTC_BOOTSTRAP=1 cargo fuzz run scene_file /tmp/scene_file fuzz/corpus/scene_file
//! ```
//! The first folder receives the inputs that the fuzzer finds. The second is the committed corpus: small
//! files, each named after its content. The bodies are ordinary functions, which `harness/tests/fuzz.rs` includes and
//! runs over the corpus, its mutations and random bytes without any fuzzer.

pub mod bodies;
