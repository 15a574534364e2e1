//! Programs to start from.

/// A language of which there is one.
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
    /// An adapter that says to every question of the probe that it is not supported.
    pub fn adapter(self) -> &'static str {
        match self {
            Self::Python => include_str!("../../../examples/conform/init.py"),
            Self::Cpp => include_str!("../../../examples/conform/init.cpp"),
            Self::Rust => include_str!("../../../examples/conform/init.rs"),
            Self::Java => include_str!("../../../examples/conform/init.java"),
        }
    }

    /// A program with Lambert's lobe, which keeps all laws. Where the language has no JSON, it ends with the reader and the
    /// writers of the adapter.
    pub fn with_lobe(self) -> String {
        let program = match self {
            Self::Python => include_str!("../../../examples/laws/init.py"),
            Self::Cpp => include_str!("../../../examples/laws/init.cpp"),
            Self::Rust => include_str!("../../../examples/laws/init.rs"),
            Self::Java => include_str!("../../../examples/laws/init.java"),
        };
        let adapter = self.adapter();
        let Some(begin) = adapter.find("// JSON: a value is") else { return program.to_owned() };
        let line = adapter[..begin].rfind('\n').map_or(0, |end| end + 1);
        let json = adapter[line..].split("// The questions:").next().unwrap_or_default();
        program.replace("@JSON@\n", json)
    }
}
