//! Wavefront OBJ (*Advanced Visualizer manual*, appendix B): `v`, `vt`, `vn` and `f`.
//!
//! A corner of a face has separate indices for position, texture coordinate and normal; a mesh has
//! one index for all three. So each distinct corner becomes a vertex, in the order of first use,
//! and a position used with two normals becomes two vertices. All other statements are skipped; for
//! groups, materials, lines and curves a note says so. The text is read twice: first the points, because a face may use a
//! point that comes later.

use std::borrow::Cow;
use std::collections::HashMap;

use super::error::quoted;
use super::faces::Faces;
use super::notes::{NO_NORMAL, NO_UV, Tally};
use super::numbers::{is_within_number, parse_number};
use super::{Location, MeshData, MeshFileError};
use super::{at_most_u32, line_end, parse_word, with_triangles, without_byte_order_mark, words};

/// Reads the bytes of an OBJ file.
///
/// # Errors
/// The first thing that is wrong; the message says in which line.
pub fn parse_obj(bytes: &[u8]) -> Result<MeshData, MeshFileError> {
    let bytes = without_byte_order_mark(bytes)?;
    let mut ignored = Ignored::default();
    let points = Points::read(bytes, &mut ignored)?;
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
            // `fo` is the older name
            Some(b"f" | b"fo") => {
                face.clear();
                for word in words {
                    let mut corner =
                        parse_corner(line, word, before, points.counts(), &mut ignored)?;
                    if !is_finite(&points.positions[corner.0 as usize]) {
                        return Err(position_error(bytes, corner.0));
                    }
                    corner.1 = corner.1.filter(|&at| is_finite(&points.uvs[at as usize]));
                    corner.2 = corner.2.filter(|&at| is_finite(&points.normals[at as usize]));
                    face.push(vertices.index_of(corner)?);
                }
                faces.push(&face, || Location::Line(line));
            }
            _ => {}
        }
    }
    let mut data = vertices.into_data(&points);
    ignored.note(&mut data.notes);
    with_triangles(data, &faces)
}

/// What is ignored in the file.
#[derive(Default)]
struct Ignored {
    /// Faces that name texture coordinates, or normals, of which the file gives none.
    never_given: [Tally; 2],
    normals: Tally,
    uvs: Tally,
    groups: Tally,
    curves: Tally,
}

impl Ignored {
    fn note(&self, notes: &mut Vec<String>) {
        let [uvs, normals] = &self.never_given;
        uvs.note(
            notes,
            "a corner names a texture coordinate, but the file gives none: it is ignored",
        );
        normals.note(notes, "a corner names a normal, but the file gives none: it is ignored");
        self.normals.note(notes, NO_NORMAL);
        self.uvs.note(notes, NO_UV);
        let groups = "`mtllib`, `usemtl` and `g` are ignored: the whole mesh has the material of its \
            object";
        self.groups.note(notes, groups);
        self.curves.note(notes, "points, lines, curves and curved surfaces are ignored");
    }
}

fn is_finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|x| x.is_finite())
}

/// What is wrong with the position of this index: it is used, but not finite.
fn position_error(bytes: &[u8], index: u32) -> MeshFileError {
    let is_position = |text: &[u8]| words(text).next() == Some(b"v");
    let mut positions = statements(bytes).filter(|(_, text)| is_position(text));
    let (line, text) = positions.nth(index as usize).expect("a position read before");
    let axes = ["x", "y", "z"].into_iter().zip(words(&text).skip(1));
    let is_wrong = |word: &[u8]| !parse_number(word).is_some_and(f64::is_finite);
    let (axis, word) = axes.into_iter().find(|(_, word)| is_wrong(word)).expect("it is not finite");
    MeshFileError::Value {
        location: Location::Line(line),
        property: axis.into(),
        found: quoted(word),
        expected: "a finite number",
    }
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
    let mut signs = (0..line.len()).filter(|&at| line[at] == b'#');
    let end = signs.find(|&at| !is_within_number(line, at)).unwrap_or(line.len());
    line[..end].trim_ascii()
}

/// All points of the file, in file order.
#[derive(Default)]
struct Points {
    positions: Vec<[f64; 3]>,
    uvs: Vec<[f64; 2]>,
    normals: Vec<[f64; 3]>,
}

impl Points {
    /// Reads them; those that are not numbers are kept as such.
    fn read(bytes: &[u8], ignored: &mut Ignored) -> Result<Points, MeshFileError> {
        let mut points = Points::default();
        for (line, text) in statements(bytes) {
            let mut words = words(&text);
            match words.next() {
                // a weight or colour after a position is ignored, and so is a third texture
                // coordinate
                Some(b"v") => points.positions.push(numbers(line, ["x", "y", "z"], words)?),
                Some(b"vt") => {
                    let uv = uv(line, words)?;
                    if !is_finite(&uv) {
                        ignored.uvs.add(|| Location::Line(line));
                    }
                    points.uvs.push(uv);
                }
                Some(b"vn") => {
                    let normal = numbers(line, ["nx", "ny", "nz"], words)?;
                    if !is_finite(&normal) {
                        ignored.normals.add(|| Location::Line(line));
                    }
                    points.normals.push(normal);
                }
                Some(b"mtllib" | b"usemtl" | b"g") => ignored.groups.add(|| Location::Line(line)),
                Some(b"p" | b"l" | b"curv" | b"curv2" | b"surf") => {
                    ignored.curves.add(|| Location::Line(line));
                }
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
        let Some(number) = parse_number(word) else {
            let (found, expected) = (quoted(word), "a number");
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
    ignored: &mut Ignored,
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
    for kind in [1, 2] {
        if indices[kind].is_some() && counts[kind] == 0 {
            indices[kind] = None;
            ignored.never_given[kind - 1].add(|| Location::Line(line));
        }
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
