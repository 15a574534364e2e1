//! The errors of mesh files, worded for the person who has the file.

use std::fmt;
use std::path::PathBuf;

/// A mesh file that cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFileError {
    /// The file system reports an error.
    #[error("{}: the file cannot be read: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The error of the file system.
        source: std::io::Error,
    },
    /// The extension is neither `.ply` nor `.obj`.
    #[error("{}: the name of a mesh file ends in .ply or .obj", path.display())]
    Extension {
        /// The file.
        path: PathBuf,
    },
    /// The file was read; `source` says what is wrong in it.
    #[error("{}: {source}", path.display())]
    InFile {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        source: Box<MeshFileError>,
    },
    /// Text of two bytes a character.
    #[error("the text is UTF-16; save it again as UTF-8 or ASCII")]
    Utf16,
    /// Not a PLY file at all.
    #[error("line 1: not a PLY file; the first line of a PLY file is `ply`")]
    NotPly,
    /// A PLY header without the line `end_header`.
    #[error("the header has no line `end_header`; the file is cut off: copy or export it again")]
    UnterminatedHeader,
    /// A line or word that does not follow the format.
    #[error("line {line}: found `{found}`, expected {expected}")]
    Syntax {
        /// Counted from 1.
        line: usize,
        /// The line or word, shortened.
        found: String,
        /// What would be right.
        expected: &'static str,
    },
    /// A PLY header without the element `vertex` or `face`.
    #[error(
        "the header has no element `{element}`; a mesh needs `vertex` and `face` (or `tristrips`)"
    )]
    MissingElement {
        /// The element's name.
        element: &'static str,
    },
    /// An element `vertex` or `face` that is declared twice.
    #[error("the header has two elements `{element}`; remove or rename one")]
    RepeatedElement {
        /// The element's name.
        element: &'static str,
    },
    /// A PLY header without a property that every mesh needs.
    #[error("element `{element}` has no property {property}; export the mesh again with it")]
    MissingProperty {
        /// The element's name.
        element: &'static str,
        /// The property's name, or names, quoted.
        property: &'static str,
    },
    /// A property that the reader needs and the header declares twice.
    #[error("element `{element}` has two properties `{property}`; remove or rename one")]
    RepeatedProperty {
        /// The element's name.
        element: &'static str,
        /// The property's name.
        property: String,
    },
    /// A list where a single number is needed, or a single number where a list is needed.
    #[error("property `{property}` of element `{element}` has to be {expected}")]
    PropertyType {
        /// The element's name.
        element: &'static str,
        /// The property's name.
        property: String,
        /// What would be right.
        expected: &'static str,
    },
    /// A declared count of elements that needs more bytes than the rest of the file has.
    #[error(
        "element `{element}`: the header promises {count} of at least {size} bytes each, but \
         only {left} bytes are left; the file is cut off or its header is wrong"
    )]
    DeclaredCount {
        /// The element's name.
        element: String,
        /// The declared count.
        count: u64,
        /// The smallest possible size of one element, in bytes.
        size: u64,
        /// The bytes that follow.
        left: usize,
    },
    /// More than `u32::MAX`: indices are `u32`.
    #[error("{count} {what} are too many: {} is the most; split the mesh into parts", u32::MAX)]
    TooMany {
        /// Vertices or triangles.
        what: &'static str,
        /// How many.
        count: u64,
    },
    /// The file ends inside an element.
    #[error("{location}: the file ends here; it is cut off: copy or export it again")]
    CutOff {
        /// What was being read.
        location: Location,
    },
    /// A line with fewer values than it needs.
    #[error("{location}: the line ends before the value of `{property}`")]
    MissingValue {
        /// The line.
        location: Location,
        /// The property's name.
        property: String,
    },
    /// A value that is out of range or not a number.
    #[error("{location}: `{found}` found for `{property}`, expected {expected}")]
    Value {
        /// The line or element of the value.
        location: Location,
        /// The property's name.
        property: String,
        /// The value as written in the file, shortened.
        found: String,
        /// What would be right.
        expected: &'static str,
    },
    /// An index out of range.
    #[error("{location}: {what} {index} does not exist; {allowed}")]
    Index {
        /// The face.
        location: Location,
        /// Vertex, normal or texture coordinate.
        what: &'static str,
        /// The index as written in the file.
        index: i64,
        /// The valid range.
        allowed: String,
    },
    /// A face with too many corners for ear clipping, whose time can grow as their cube.
    #[error(
        "{location}: a face of {count} corners that is not convex; at most {max} can be split into \
         triangles: cut it into smaller faces"
    )]
    ManyCorners {
        /// The face.
        location: Location,
        /// How many it has.
        count: usize,
        /// The maximum.
        max: usize,
    },
    /// More data than the header of a PLY file declares.
    #[error(
        "{left} bytes are left over after the last element; \
         the header's counts are too small, or the file is damaged"
    )]
    LeftOver {
        /// The number of bytes.
        left: usize,
    },
    /// A file without faces.
    #[error("no faces; a mesh needs at least one triangle (is it a point cloud, or damaged?)")]
    NoFaces,
}

/// A location in a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Location {
    /// A line of a text file, counted from 1.
    Line(usize),
    /// An element of a binary file.
    Element {
        /// The element's name.
        name: String,
        /// Counted from 0, as the file's own indices are.
        index: u64,
    },
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Location::Line(line) => write!(f, "line {line}"),
            Location::Element { name, index } => write!(f, "{name} {index} (counted from 0)"),
        }
    }
}

/// Bytes of a file, shortened to 40 characters for a message; control characters are replaced.
pub(super) fn quoted(bytes: &[u8]) -> String {
    const MAX_CHARS: usize = 40;
    // a character has at most 4 bytes: the rest of a long line is not decoded
    let start = &bytes[..bytes.len().min(4 * MAX_CHARS + 4)];
    let text = String::from_utf8_lossy(start);
    let mut shown: String = text
        .trim()
        .chars()
        .take(MAX_CHARS)
        .map(|c| if c.is_control() { '\u{FFFD}' } else { c })
        .collect();
    if text.trim().chars().nth(MAX_CHARS).is_some() {
        shown.push('…');
    }
    shown
}
