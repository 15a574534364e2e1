//! What can be wrong with a mesh file, in words for the person who has it.

use std::fmt;
use std::path::PathBuf;

/// A mesh file that cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFileError {
    /// The file system's answer.
    #[error("{}: the file cannot be read: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the file system says.
        source: std::io::Error,
    },
    /// Neither PLY nor OBJ, by its name.
    #[error("{}: the name of a mesh file ends in .ply or .obj", path.display())]
    Extension {
        /// The file.
        path: PathBuf,
    },
    /// The file was opened; `source` says what is wrong in it.
    #[error("{}: {source}", path.display())]
    InFile {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        source: Box<MeshFileError>,
    },
    /// Not a PLY file at all.
    #[error("line 1: not a PLY file; the first line of a PLY file is `ply`")]
    NotPly,
    /// A PLY header that does not end.
    #[error("the header has no line `end_header`; the file is cut off: copy or export it again")]
    EndlessHeader,
    /// A line that cannot be understood.
    #[error("line {line}: found `{found}`, expected {expected}")]
    Syntax {
        /// Counted from 1.
        line: usize,
        /// The line or word, shortened.
        found: String,
        /// What would be right.
        expected: &'static str,
    },
    /// No vertices, or no faces, in a PLY header.
    #[error("the header has no element `{element}`; a mesh needs `vertex` and `face`")]
    MissingElement {
        /// The element's name.
        element: &'static str,
    },
    /// An element that occurs twice, where it is not clear which one is meant.
    #[error("the header has two elements `{element}`; remove or rename one")]
    RepeatedElement {
        /// The element's name.
        element: &'static str,
    },
    /// A property without which there is no mesh.
    #[error("element `{element}` has no property {property}; export the mesh again with it")]
    MissingProperty {
        /// The element's name.
        element: &'static str,
        /// The property's name, or names, quoted.
        property: &'static str,
    },
    /// A property that occurs twice, where it is not clear which one is meant.
    #[error("element `{element}` has two properties `{property}`; remove or rename one")]
    RepeatedProperty {
        /// The element's name.
        element: &'static str,
        /// The property's name.
        property: String,
    },
    /// A list where a number is needed, or the other way round.
    #[error("property `{property}` of element `{element}` has to be {expected}")]
    PropertyType {
        /// The element's name.
        element: &'static str,
        /// The property's name.
        property: String,
        /// What would be right.
        expected: &'static str,
    },
    /// Triangle strips.
    #[error(
        "element `tristrips`: triangle strips are not read; \
         convert them to triangles and export the mesh again"
    )]
    TriangleStrips,
    /// More elements than the rest of the file can hold.
    #[error(
        "element `{element}`: the header promises {count} of at least {size} bytes each, but \
         only {left} bytes are left; the file is cut off or its header is wrong"
    )]
    Promise {
        /// The element's name.
        element: String,
        /// As the header says.
        count: u64,
        /// The least that one takes, in bytes.
        size: u64,
        /// Bytes that follow.
        left: usize,
    },
    /// More than indices can count.
    #[error("{count} {what} are too many: {} is the most; split the mesh into parts", u32::MAX)]
    TooMany {
        /// Vertices or triangles.
        what: &'static str,
        /// How many.
        count: u64,
    },
    /// The file ends inside an element.
    #[error("{place}: the file ends here; it is cut off: copy or export it again")]
    CutOff {
        /// What was being read.
        place: Place,
    },
    /// A line with fewer values than it needs.
    #[error("{place}: the line ends before the value of `{property}`")]
    MissingValue {
        /// The line.
        place: Place,
        /// The property's name.
        property: String,
    },
    /// A line of a PLY file with more values than the header says.
    #[error("{place}: `{found}` is one value too many; the header has no property for it")]
    SurplusValue {
        /// The line.
        place: Place,
        /// The value.
        found: String,
    },
    /// A value that is out of range, or none.
    #[error("{place}: `{found}` found for `{property}`, expected {expected}")]
    Value {
        /// Where it stands.
        place: Place,
        /// The property's name.
        property: String,
        /// The value as it stands, shortened.
        found: String,
        /// What would be right.
        expected: &'static str,
    },
    /// An index of nothing.
    #[error("{place}: {what} {index} does not exist; {allowed}")]
    Index {
        /// The face.
        place: Place,
        /// Vertex, normal or texture coordinate.
        what: &'static str,
        /// As the file has it.
        index: i64,
        /// What would be right.
        allowed: String,
    },
    /// A face without area, by its very number of corners.
    #[error("{place}: a face with {count} vertices; it needs at least 3")]
    FewCorners {
        /// The face.
        place: Place,
        /// How many it has.
        count: usize,
    },
    /// A face whose triangles would take too long to find.
    #[error(
        "{place}: a face of {count} corners that is not convex; at most {most} can be split into \
         triangles: cut it into smaller faces"
    )]
    ManyCorners {
        /// The face.
        place: Place,
        /// How many it has.
        count: usize,
        /// How many it may have.
        most: usize,
    },
    /// More data than the header of a PLY file says.
    #[error(
        "{left} bytes are left over after the last element; \
         the header's counts are too small, or the file is damaged"
    )]
    LeftOver {
        /// How many.
        left: usize,
    },
    /// Nothing to hit.
    #[error("no faces; a mesh needs at least one triangle (is it a point cloud, or damaged?)")]
    NoFaces,
}

/// Where in a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
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

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Line(line) => write!(f, "line {line}"),
            Place::Element { name, index } => write!(f, "{name} {index} (counted from 0)"),
        }
    }
}

/// Bytes of a file in a message: at most 40 characters, nothing that moves the cursor.
pub(super) fn quoted(bytes: &[u8]) -> String {
    const MOST: usize = 40;
    // a character has at most 4 bytes: no more of a long line is looked at
    let start = &bytes[..bytes.len().min(4 * MOST + 4)];
    let text = String::from_utf8_lossy(start);
    let mut shown: String = text
        .trim()
        .chars()
        .take(MOST)
        .map(|c| if c.is_control() { '\u{FFFD}' } else { c })
        .collect();
    if text.trim().chars().nth(MOST).is_some() {
        shown.push('…');
    }
    shown
}
