//! Adapters to start from.

/// A language of which there is an adapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Language {
    /// Python 3, the standard library alone.
    Python,
    /// C++17, no library.
    Cpp,
    /// Rust, with serde_json.
    Rust,
    /// Java 11, the standard library alone.
    Java,
}

impl Language {
    /// An adapter that says to every question that it is not supported.
    pub fn template(self) -> &'static str {
        match self {
            Self::Python => include_str!("../../../examples/conform/init.py"),
            Self::Cpp => include_str!("../../../examples/conform/init.cpp"),
            Self::Rust => include_str!("../../../examples/conform/init.rs"),
            Self::Java => include_str!("../../../examples/conform/init.java"),
        }
    }
}
