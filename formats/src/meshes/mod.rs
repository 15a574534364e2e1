//! Mesh files (Suffern, ch. 23): PLY (all three encodings) and Wavefront OBJ, read into arrays.
//!
//! A file is read whole. The counts in its header are checked against the bytes that follow:
//! besides the file itself, reading needs less than 64 bytes of memory for each byte of the file.
//! What every common reader loads and has one meaning is loaded, with a note of what was ignored.
//! The result is checked: finite numbers, indices of existing vertices, one normal and one
//! uv per vertex or none at all. Triangles without area, normals that are not unit and unused
//! vertices are left to the mesh.
//!
//! No crate is used. `tobj` 4.0 overflows on a texture or normal index out of range, shifts the
//! texture coordinates when only some corners have one, turns polylines into triangles and reports
//! no line numbers; `ply-rs-bw` 4.0 allocates what a header declares for an element without
//! properties, misreads a property that is declared twice and rejects `.5` and `1.`.

mod error;
mod faces;
mod notes;
mod numbers;
mod obj;
mod ply;

use std::io::Read;
use std::path::Path;
use std::str::FromStr;

pub use error::{Location, MeshFileError};
use faces::Faces;
pub use obj::parse_obj;
pub use ply::{Encoding, parse_ply, write_ply};

/// The contents of a mesh file. Polygons, convex or not, are already split into triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshData {
    /// Positions, finite.
    pub vertices: Vec<[f64; 3]>,
    /// One for each vertex, as in the file: finite, not necessarily unit; zero for a vertex without
    /// one if other vertices have one.
    pub normals: Option<Vec<[f64; 3]>>,
    /// Texture coordinates, one pair for each vertex, finite; zero for a vertex without them if
    /// other vertices have them.
    pub uvs: Option<Vec<[f64; 2]>>,
    /// Indices into `vertices`, wound as in the file; at least one triangle, and less than 2³².
    pub triangles: Vec<[u32; 3]>,
    /// For each triangle the index of its face in the file, ascending; empty if all faces are
    /// triangles.
    pub faces: Vec<u32>,
    /// For each vertex the first vertex of the same position (the same index in an OBJ file, the same
    /// vertex in a PLY file); empty if no two vertices share one.
    pub first_at_position: Vec<u32>,
    /// What was ignored in the file, in sentences for the user, with line and count.
    pub notes: Vec<String>,
}

/// Reads a `.ply` or `.obj` file; the case of the extension does not matter.
///
/// # Errors
/// A file that cannot be opened, has another extension or is damaged; the message has the path.
pub fn read(path: &Path) -> Result<MeshData, MeshFileError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
    let parse = match extension.as_deref() {
        Some("ply") => parse_ply,
        Some("obj") => parse_obj,
        _ => return Err(MeshFileError::Extension { path: path.into() }),
    };
    let bytes = read_bytes(path)
        .map_err(|source| MeshFileError::Unreadable { path: path.into(), source })?;
    parse(&bytes)
        .map_err(|source| MeshFileError::InFile { path: path.into(), source: Box::new(source) })
}

/// The maximum size of a file, in bytes.
pub const MAX_BYTES: u64 = 1 << 28;

/// All bytes of a file; fails if it is none, such as an endless device, or is too large.
fn read_bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    let problem = std::io::Error::other::<String>;
    let metadata = std::fs::metadata(path)?;
    if !metadata.is_file() {
        return Err(problem("not a file".to_owned()));
    }
    let mut bytes = Vec::new();
    if metadata.len() <= MAX_BYTES {
        bytes.try_reserve_exact(metadata.len() as usize)?;
        // it may grow while it is read
        std::fs::File::open(path)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    }
    let size = metadata.len().max(bytes.len() as u64);
    if size > MAX_BYTES {
        return Err(problem(format!("{size} bytes are too many; at most {MAX_BYTES} fit")));
    }
    Ok(bytes)
}

/// Adds the triangles of the faces; fails if there are none or more than `u32::MAX`.
fn with_triangles(mut data: MeshData, faces: &Faces) -> Result<MeshData, MeshFileError> {
    data.triangles = faces.triangles(&data.vertices)?;
    data.faces = faces.of_triangles();
    faces.note(&mut data.notes);
    if data.triangles.is_empty() {
        return Err(MeshFileError::NoFaces);
    }
    at_most_u32("triangles", data.triangles.len() as u64)?;
    Ok(data)
}

/// Fails if `count` exceeds `u32::MAX`.
fn at_most_u32(what: &'static str, count: u64) -> Result<(), MeshFileError> {
    if count > u64::from(u32::MAX) {
        return Err(MeshFileError::TooMany { what, count });
    }
    Ok(())
}

/// The bytes without the UTF-8 byte-order mark that some editors write; fails if they are UTF-16.
fn without_byte_order_mark(bytes: &[u8]) -> Result<&[u8], MeshFileError> {
    if let [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [0, 1..=0x7f, ..] | [1..=0x7f, 0, ..] = bytes {
        return Err(MeshFileError::Utf16);
    }
    Ok(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes))
}

/// The byte that ends a line: `\r` if the first line ends with `\r` alone, else `\n` (a `\r` before
/// it counts as white space).
fn line_end(bytes: &[u8]) -> u8 {
    match bytes.iter().position(|b| matches!(b, b'\r' | b'\n')) {
        Some(at) if bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n') => b'\r',
        _ => b'\n',
    }
}

fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

fn parse_word<T: FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}
