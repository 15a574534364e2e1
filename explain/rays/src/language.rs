//! The files that write logs, by the language of the program.

/// The names of the languages, and the file for each.
pub const WRITERS: [(&str, &str); 8] = [
    // C99
    ("c", include_str!("../writers/rays_c.h")),
    // C++11 and later
    ("cpp", include_str!("../writers/rays.h")),
    // C# 7 and later
    ("csharp", include_str!("../writers/Rays.cs")),
    // Go 1.18 and later
    ("go", include_str!("../writers/rays.go")),
    ("java", include_str!("../writers/Rays.java")),
    // in Node or a page
    ("javascript", include_str!("../writers/rays.js")),
    // Python 3
    ("python", include_str!("../writers/rays.py")),
    ("rust", include_str!("../writers/rays.rs")),
];
