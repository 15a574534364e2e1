//! Fuzz targets: what is read from outside, and what must hold for any finite input.
//!
//! ```text
//! cargo install --locked cargo-fuzz
//! RUSTC_BOOTSTRAP=1 cargo fuzz run scene_file /tmp/scene_file fuzz/corpus/scene_file
//! ```
//! The first folder takes what the fuzzer finds, the second is the committed corpus: small files,
//! named by what they are. The bodies are ordinary functions, which `tests/fuzz.rs` includes and
//! runs over the corpus, its mutations and random bytes without any fuzzer.

pub mod bodies;
