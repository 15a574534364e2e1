//! The path through nested shapes to the one that a ray hit, from the outermost to the innermost.

use std::fmt;

use serde::Serialize;

use formats::printable;

/// The path from a shape to its innermost part that was hit: an instance of a compound of meshes
/// has three levels. A shape that holds no others and has no numbered parts has none.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct PartPath {
    levels: Vec<Level>,
}

/// One level of a [`PartPath`]. Numbers count from 0.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Level {
    /// What an instance transforms.
    Instance {},
    /// A part of a compound, or of a solid that is made of parts, such as a beveled box.
    Part {
        /// Its index among the parts; of a compound, that in the scene file.
        index: u32,
        /// Its name; empty if it has none.
        #[serde(skip_serializing_if = "String::is_empty")]
        name: String,
    },
    /// A copy in a lattice: how many times `spacing` it is moved along each axis.
    Copy([u32; 3]),
    /// One of random spheres, by its index in
    /// [`RandomSpheres::spheres`](crate::shapes::RandomSpheres).
    Sphere(u32),
    /// A triangle of a mesh. Of a mesh file, the triangles are those of its faces in the order of
    /// the file, a polygon of n corners being cut into n − 2; triangles of area zero are counted,
    /// although no ray hits them. Of a mesh of lists, it is the index into `triangles`.
    Triangle(u32),
    /// A face of a box.
    Face(Face),
}

/// A face of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Face {
    /// The face of least x.
    MinX,
    /// The face of greatest x.
    MaxX,
    /// The face of least y.
    MinY,
    /// The face of greatest y.
    MaxY,
    /// The face of least z.
    MinZ,
    /// The face of greatest z.
    MaxZ,
}

impl PartPath {
    /// The levels, the outermost first.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// Whether the path has no levels.
    pub fn is_empty(&self) -> bool {
        self.levels.is_empty()
    }

    /// The path of one level.
    pub fn to(level: Level) -> Self {
        Self { levels: vec![level] }
    }

    /// The same path inside of this level.
    #[must_use]
    pub fn inside(mut self, level: Level) -> Self {
        self.levels.insert(0, level);
        self
    }

    /// The number of the triangle at its end, if a mesh was hit.
    pub fn triangle(&self) -> Option<u32> {
        match self.levels.last() {
            Some(Level::Triangle(number)) => Some(*number),
            _ => None,
        }
    }
}

/// In plain words: `part 2 of a compound, instance, triangle 1543`; empty for a path without
/// levels.
impl fmt::Display for PartPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, level) in self.levels.iter().enumerate() {
            let comma = if index == 0 { "" } else { ", " };
            write!(f, "{comma}{level}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Instance {} => f.write_str("instance"),
            Self::Part { index, name } if name.is_empty() => {
                write!(f, "part {index} of a compound")
            }
            Self::Part { index, name } => write!(f, "part {index} ({})", printable::name(name)),
            Self::Copy(copy) => write!(f, "copy {copy:?} of a lattice"),
            Self::Sphere(number) => write!(f, "sphere {number}"),
            Self::Triangle(number) => write!(f, "triangle {number}"),
            Self::Face(face) => write!(f, "face {face}"),
        }
    }
}

impl fmt::Display for Face {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::MinX => "of least x",
            Self::MaxX => "of greatest x",
            Self::MinY => "of least y",
            Self::MaxY => "of greatest y",
            Self::MinZ => "of least z",
            Self::MaxZ => "of greatest z",
        })
    }
}
