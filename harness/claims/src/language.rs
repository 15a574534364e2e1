//! Programs to start from.

/// A language of which there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Language {
    /// Python 3, the standard library alone.
    Python,
    /// C++17, no library.
    Cpp,
}

impl Language {
    /// A program with Lambert's lobe, which keeps all laws.
    pub fn template(self) -> String {
        match self {
            Self::Python => include_str!("../../../examples/laws/init.py").to_owned(),
            Self::Cpp => {
                let adapter = include_str!("../../../examples/conform/init.cpp");
                include_str!("../../../examples/laws/init.cpp")
                    .replace("@JSON@\n", json_of(adapter))
            }
        }
    }
}

/// The reader and the writers of JSON, which both adapters in C++ have.
fn json_of(adapter: &str) -> &str {
    let begin = adapter.find("// JSON: a value is").expect("the adapter reads JSON");
    let end = adapter.find("// The questions:").expect("the adapter has questions");
    &adapter[begin..end]
}
