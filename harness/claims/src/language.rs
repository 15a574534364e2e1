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
    /// A program with Lambert's lobe, which keeps all laws.
    pub fn template(self) -> String {
        match self {
            Self::Python => include_str!("../../../examples/laws/init.py").to_owned(),
            Self::Cpp => {
                let adapter = include_str!("../../../examples/conform/init.cpp");
                let end = adapter.find("// The questions:").expect("the adapter has questions");
                with_json(include_str!("../../../examples/laws/init.cpp"), &adapter[..end])
            }
            Self::Rust => include_str!("../../../examples/laws/init.rs").to_owned(),
            Self::Java => with_json(
                include_str!("../../../examples/laws/init.java"),
                include_str!("../../../examples/conform/init.java"),
            ),
        }
    }
}

/// The program with the reader and the writers of JSON of conform's adapter in its language, with which that ends.
fn with_json(program: &str, adapter: &str) -> String {
    let begin = adapter.find("// JSON: a value is").expect("the adapter reads JSON");
    let line = adapter[..begin].rfind('\n').map_or(0, |end| end + 1);
    program.replace("@JSON@\n", &adapter[line..])
}
