//! The languages for which there is a file that writes logs.

/// A language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WriterLanguage {
    /// C99.
    C,
    /// C++11 and later.
    Cpp,
    /// C# 7 and later.
    CSharp,
    /// Go 1.18 and later.
    Go,
    /// Java.
    Java,
    /// JavaScript, in Node or a page.
    JavaScript,
    /// Python 3.
    Python,
    /// Rust.
    Rust,
}

impl WriterLanguage {
    /// All of them, with their names and the files that write logs.
    pub const ALL: &[(&'static str, Self, &'static str)] = &[
        ("c", Self::C, include_str!("../writers/rays_c.h")),
        ("cpp", Self::Cpp, include_str!("../writers/rays.h")),
        ("csharp", Self::CSharp, include_str!("../writers/Rays.cs")),
        ("go", Self::Go, include_str!("../writers/rays.go")),
        ("java", Self::Java, include_str!("../writers/Rays.java")),
        ("javascript", Self::JavaScript, include_str!("../writers/rays.js")),
        ("python", Self::Python, include_str!("../writers/rays.py")),
        ("rust", Self::Rust, include_str!("../writers/rays.rs")),
    ];

    /// The file that writes a log.
    pub fn writer(self) -> &'static str {
        Self::ALL.iter().find(|(_, language, _)| *language == self).map_or("", |(_, _, text)| text)
    }
}
