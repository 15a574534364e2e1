//! Wavefront OBJ (*Advanced Visualizer manual*, appendix B): `v`, `vt`, `vn` and `f`.
//!
//! A corner of a face has separate indices for position, texture coordinate and normal; a mesh has
//! one index for all three. So each distinct corner becomes a vertex, in the order of first use,
//! and a position used with two normals becomes two vertices. Groups, materials, lines and all
//! other statements are skipped. The text is read twice: first the points, because a face may use a
//! point that comes later.

use std::borrow::Cow;
use std::collections::HashMap;

use super::error::quoted;
use super::faces::Faces;
use super::{Location, MeshData, MeshFileError};
use super::{at_most_u32, line_end, parse_word, with_triangles, without_byte_order_mark, words};

/// Reads the bytes of an OBJ file.
///
/// # Errors
/// The first thing that is wrong; the message says in which line.
pub fn parse_obj(bytes: &[u8]) -> Result<MeshData, MeshFileError> {
    let bytes = without_byte_order_mark(bytes);
    let points = Points::read(bytes)?;
    let mut vertices = Vertices::default();
    let mut faces = Faces::default();
    let mut face = Vec::new();
    let mut before = [0; 3]; // points before this line: negative indices count from here
    for (line, text) in statements(bytes) {
        let mut words = words(&text);
        match words.next() {
            Some(b"v") => before[0] += 1,
            Some(b"vt") => before[1] += 1,
            Some(b"vn") => before[2] += 1,
            Some(b"f") => {
                face.clear();
                for word in words {
                    let corner = parse_corner(line, word, before, points.counts())?;
                    face.push(vertices.index_of(corner)?);
                }
                faces.push(&face, || Location::Line(line))?;
            }
            _ => {}
        }
    }
    with_triangles(vertices.into_data(&points), &faces)
}

/// The lines with their numbers, without comments; a line that ends with `\` continues on the next
/// line.
fn statements(bytes: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, [u8]>)> {
    let end = line_end(bytes);
    let mut lines = bytes.split(move |&b| b == end).zip(1..);
    std::iter::from_fn(move || {
        let (line, number) = lines.next()?;
        let mut text = Cow::Borrowed(code(line));
        while text.last() == Some(&b'\\') {
            let text = text.to_mut();
            text.pop();
            let Some((more, _)) = lines.next() else { break };
            text.push(b' ');
            text.extend(code(more));
        }
        Some((number, text))
    })
}

/// The line before its comment.
fn code(line: &[u8]) -> &[u8] {
    line.split(|&b| b == b'#').next().unwrap_or_default().trim_ascii()
}

/// All points of the file, in file order.
#[derive(Default)]
struct Points {
    positions: Vec<[f64; 3]>,
    uvs: Vec<[f64; 2]>,
    normals: Vec<[f64; 3]>,
}

impl Points {
    fn read(bytes: &[u8]) -> Result<Points, MeshFileError> {
        let mut points = Points::default();
        for (line, text) in statements(bytes) {
            let mut words = words(&text);
            match words.next() {
                // a weight or colour after a position is ignored, and so is a third texture
                // coordinate
                Some(b"v") => points.positions.push(numbers(line, ["x", "y", "z"], words)?),
                Some(b"vt") => points.uvs.push(uv(line, words)?),
                Some(b"vn") => points.normals.push(numbers(line, ["nx", "ny", "nz"], words)?),
                _ => {}
            }
        }
        points.counts().iter().try_for_each(|&count| at_most_u32("vertices", count as u64))?;
        Ok(points)
    }

    fn counts(&self) -> [usize; 3] {
        [self.positions.len(), self.uvs.len(), self.normals.len()]
    }
}

fn numbers<'a, const N: usize>(
    line: usize,
    names: [&str; N],
    mut words: impl Iterator<Item = &'a [u8]>,
) -> Result<[f64; N], MeshFileError> {
    let mut values = [0.0; N];
    for (value, name) in values.iter_mut().zip(names) {
        let (location, property) = (Location::Line(line), name.to_string());
        let Some(word) = words.next() else {
            return Err(MeshFileError::MissingValue { location, property });
        };
        let Some(number) = parse_word(word).filter(|number: &f64| number.is_finite()) else {
            let (found, expected) = (quoted(word), "a finite number");
            return Err(MeshFileError::Value { location, property, found, expected });
        };
        *value = number;
    }
    Ok(values)
}

/// A texture coordinate; `v` is 0 if it is left out.
fn uv<'a>(
    line: usize,
    mut words: impl Iterator<Item = &'a [u8]>,
) -> Result<[f64; 2], MeshFileError> {
    let [u] = numbers(line, ["u"], &mut words)?;
    let mut rest = words.peekable();
    let [v] = if rest.peek().is_some() { numbers(line, ["v"], rest)? } else { [0.0] };
    Ok([u, v])
}

/// Indices into the lists of positions, texture coordinates and normals, from 0.
type Corner = (u32, Option<u32>, Option<u32>);

/// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
fn parse_corner(
    line: usize,
    word: &[u8],
    before: [usize; 3],
    counts: [usize; 3],
) -> Result<Corner, MeshFileError> {
    let expected = "a corner `v`, `v/vt`, `v//vn` or `v/vt/vn` of integers";
    let wrong = || MeshFileError::Syntax { line, found: quoted(word), expected };
    let mut parts = word.split(|&b| b == b'/');
    let mut indices = [None; 3];
    for (index, part) in indices.iter_mut().zip(&mut parts) {
        if !part.is_empty() {
            *index = Some(parse_word(part).ok_or_else(wrong)?);
        }
    }
    if indices[0].is_none() || parts.next().is_some() {
        return Err(wrong());
    }
    let at = |kind: usize| {
        let index = indices[kind];
        index.map(|i| resolve(line, KINDS[kind], i, before[kind], counts[kind])).transpose()
    };
    Ok((at(0)?.ok_or_else(wrong)?, at(1)?, at(2)?))
}

const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

/// The index from 0 of an OBJ index: from 1 to `count`, or from −`before` to −1, counted back from
/// the current line; 0 is invalid.
fn resolve(
    line: usize,
    what: &'static str,
    index: i64,
    before: usize,
    count: usize,
) -> Result<u32, MeshFileError> {
    let (first, known) = if index < 0 { (before as i64, before) } else { (-1, count) };
    let at = first.saturating_add(index);
    if at >= 0 && at < known as i64 {
        return Ok(at as u32); // there are at most u32::MAX points
    }
    let allowed = match (known, index < 0) {
        (0, true) => "none stands before this line".into(),
        (0, false) => "the file has none".into(),
        (_, true) => format!("negative indices go from -1 to -{before} here"),
        (_, false) => format!("indices go from 1 to {count}"),
    };
    Err(MeshFileError::Index { location: Location::Line(line), what, index, allowed })
}

/// The distinct corners of all faces.
#[derive(Default)]
struct Vertices {
    corners: Vec<Corner>,
    known: HashMap<Corner, u32>,
}

impl Vertices {
    fn index_of(&mut self, corner: Corner) -> Result<u32, MeshFileError> {
        if let Some(&index) = self.known.get(&corner) {
            return Ok(index);
        }
        at_most_u32("vertices", self.corners.len() as u64 + 1)?;
        let index = self.corners.len() as u32;
        self.known.insert(corner, index);
        self.corners.push(corner);
        Ok(index)
    }

    fn into_data(self, points: &Points) -> MeshData {
        let corners = self.corners.iter();
        MeshData {
            vertices: corners.clone().map(|c| points.positions[c.0 as usize]).collect(),
            uvs: zeros_for_missing(corners.clone().map(|c| c.1.map(|at| points.uvs[at as usize]))),
            normals: zeros_for_missing(corners.map(|c| c.2.map(|at| points.normals[at as usize]))),
            first_at_position: self.first_at_position(),
            ..MeshData::default()
        }
    }

    fn first_at_position(&self) -> Vec<u32> {
        let mut first = HashMap::new();
        let positions = self.corners.iter().zip(0..);
        let all = positions.map(|(c, index)| *first.entry(c.0).or_insert(index)).collect();
        if first.len() == self.corners.len() { Vec::new() } else { all }
    }
}

/// All values, with zeros for the missing ones; `None` if all are missing.
fn zeros_for_missing<const N: usize>(
    all: impl Iterator<Item = Option<[f64; N]>> + Clone,
) -> Option<Vec<[f64; N]>> {
    all.clone().any(|one| one.is_some()).then(|| all.map(|one| one.unwrap_or([0.0; N])).collect())
}
