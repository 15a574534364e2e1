//! PLY, the Stanford triangle format (Greg Turk, *The PLY Polygon File Format*, 1994).
//!
//! A header in words declares elements (`vertex`, `face`, …) and the properties each has; the body
//! has their values in that order. Of `vertex` we take `x y z`, `nx ny nz` and the first complete
//! pair of `u v`, `s t`, `texture_u texture_v`, `texture_s texture_t`; of `face` the list
//! `vertex_indices` or `vertex_index`. Everything else is passed over, whatever it holds.

mod header;
mod values;
mod write;

use super::error::quoted;
use super::faces::Faces;
use super::{MeshData, MeshFileError, at_most_u32, checked, without_mark};
use header::{Element, Header, Property};
use values::{Binary, Text, Values};

pub use header::Encoding;
pub use write::write_ply;

/// Reads the bytes of a PLY file, in words or in bytes of either order.
///
/// # Errors
/// The first thing that is wrong; the message says where.
pub fn parse_ply(bytes: &[u8]) -> Result<MeshData, MeshFileError> {
    let header = Header::parse(without_mark(bytes))?;
    match header.encoding {
        Encoding::Ascii => parse_body(&header, Text::new(&header)),
        _ => parse_body(&header, Binary::new(&header)),
    }
}

fn parse_body(header: &Header, mut values: impl Values) -> Result<MeshData, MeshFileError> {
    if header.elements.iter().any(|e| e.name == "tristrips") {
        return Err(MeshFileError::TriangleStrips);
    }
    let vertices = only(header, "vertex")?;
    let faces = only(header, "face")?;
    at_most_u32("vertices", vertices.count)?;
    let (columns, corners) = (Columns::find(vertices)?, corner_list(faces)?);
    let (mut data, mut polygons) = (MeshData::default(), Faces::default());
    for element in &header.elements {
        check_promise(element, header.encoding, &values)?;
        match element.name {
            "vertex" => read_vertices(&mut data, &mut values, element, &columns)?,
            "face" => polygons = read_faces(&mut values, element, corners, vertices.count)?,
            _ => pass_over(&mut values, element)?,
        }
    }
    if !values.left().trim_ascii().is_empty() {
        return Err(MeshFileError::LeftOver { left: values.left().len() });
    }
    checked(data, &polygons)
}

/// The one element of this name.
fn only<'a>(header: &'a Header, name: &'static str) -> Result<&'a Element<'a>, MeshFileError> {
    let mut found = header.elements.iter().filter(|e| e.name == name);
    let element = found.next().ok_or(MeshFileError::MissingElement { element: name })?;
    match found.next() {
        Some(_) => Err(MeshFileError::RepeatedElement { element: name }),
        None => Ok(element),
    }
}

/// The place of the property in its element, if it is there; more than one are an error.
fn position(
    element: &Element,
    of: &'static str,
    property: &str,
) -> Result<Option<usize>, MeshFileError> {
    let mut found =
        (0..element.properties.len()).filter(|&i| element.properties[i].name == property);
    match (found.next(), found.next()) {
        (_, Some(_)) => {
            Err(MeshFileError::RepeatedProperty { element: of, property: property.into() })
        }
        (first, None) => Ok(first),
    }
}

/// A header that lies is found out here, before anything is allocated for it.
fn check_promise(
    element: &Element,
    encoding: Encoding,
    values: &impl Values,
) -> Result<(), MeshFileError> {
    let (size, left) = (element.least_size(encoding), values.left().len());
    // one more: the last word of a file may lack its white space
    if element.count.saturating_mul(size) > left as u64 + 1 {
        let (element, count) = (quoted(element.name.as_bytes()), element.count);
        return Err(MeshFileError::Promise { element, count, size, left });
    }
    Ok(())
}

/// The most columns a vertex has: position, normal, texture coordinates.
const COLUMNS: usize = 8;

/// Which property of a vertex goes where.
struct Columns {
    /// For each property its column, or `None` to pass over it.
    of_property: Vec<Option<usize>>,
    has_normals: bool,
    has_uvs: bool,
}

impl Columns {
    fn find(vertex: &Element) -> Result<Columns, MeshFileError> {
        let mut columns = Columns {
            of_property: vec![None; vertex.properties.len()],
            has_normals: false,
            has_uvs: false,
        };
        for (name, in_words) in [("x", "`x`"), ("y", "`y`"), ("z", "`z`")] {
            if position(vertex, "vertex", name)?.is_none() {
                return Err(MeshFileError::MissingProperty {
                    element: "vertex",
                    property: in_words,
                });
            }
        }
        columns.assign(vertex, 0, ["x", "y", "z"])?;
        columns.has_normals = columns.assign(vertex, 3, ["nx", "ny", "nz"])?;
        for pair in [["u", "v"], ["s", "t"], ["texture_u", "texture_v"], ["texture_s", "texture_t"]]
        {
            columns.has_uvs = columns.has_uvs || columns.assign(vertex, 6, pair)?;
        }
        Ok(columns)
    }

    /// Gives these properties the columns from `first` on, if all of them are there.
    fn assign<const N: usize>(
        &mut self,
        vertex: &Element,
        first: usize,
        names: [&str; N],
    ) -> Result<bool, MeshFileError> {
        let mut places = [0; N];
        for (place, name) in places.iter_mut().zip(names) {
            let Some(at) = position(vertex, "vertex", name)? else { return Ok(false) };
            if vertex.properties[at].length.is_some() {
                let (element, property) = ("vertex", name.into());
                let expected = "a single number, not a list";
                return Err(MeshFileError::PropertyType { element, property, expected });
            }
            *place = at;
        }
        for (column, at) in (first..).zip(places) {
            self.of_property[at] = Some(column);
        }
        Ok(true)
    }
}

fn read_vertices(
    data: &mut MeshData,
    values: &mut impl Values,
    element: &Element,
    columns: &Columns,
) -> Result<(), MeshFileError> {
    let capacity = element.count as usize; // not more than bytes are left
    data.vertices = Vec::with_capacity(capacity);
    data.normals = columns.has_normals.then(|| Vec::with_capacity(capacity));
    data.uvs = columns.has_uvs.then(|| Vec::with_capacity(capacity));
    for index in 0..element.count {
        values.begin(element.name, index)?;
        let mut row = [0.0; COLUMNS];
        for (property, column) in element.properties.iter().zip(&columns.of_property) {
            match column {
                Some(column) => row[*column] = finite(values, property)?,
                None => skip(values, property)?,
            }
        }
        values.end()?;
        let [x, y, z, nx, ny, nz, u, v] = row;
        data.vertices.push([x, y, z]);
        data.normals.iter_mut().for_each(|normals| normals.push([nx, ny, nz]));
        data.uvs.iter_mut().for_each(|uvs| uvs.push([u, v]));
    }
    Ok(())
}

fn finite(values: &mut impl Values, property: &Property) -> Result<f64, MeshFileError> {
    let value = values.value(property.scalar, property)?;
    if value.is_finite() {
        return Ok(value);
    }
    Err(MeshFileError::Value {
        place: values.place(),
        property: quoted(property.name.as_bytes()),
        found: value.to_string(),
        expected: "a finite number",
    })
}

/// The place of the list of a face's corners.
fn corner_list(face: &Element) -> Result<usize, MeshFileError> {
    for name in ["vertex_indices", "vertex_index"] {
        let Some(at) = position(face, "face", name)? else { continue };
        let property = &face.properties[at];
        if property.length.is_none() || !property.scalar.is_integer() {
            let (element, property) = ("face", name.into());
            let expected = "a list of integers, as `property list uchar int vertex_indices`";
            return Err(MeshFileError::PropertyType { element, property, expected });
        }
        return Ok(at);
    }
    let property = "`vertex_indices` or `vertex_index`";
    Err(MeshFileError::MissingProperty { element: "face", property })
}

fn read_faces(
    values: &mut impl Values,
    element: &Element,
    corner_list: usize,
    vertices: u64,
) -> Result<Faces, MeshFileError> {
    let mut faces = Faces::with_capacity(element.count as usize); // not more than bytes are left
    let mut corners = Vec::new();
    for index in 0..element.count {
        values.begin(element.name, index)?;
        for (at, property) in element.properties.iter().enumerate() {
            match property.length {
                Some(length) if at == corner_list => {
                    corners.clear();
                    for _ in 0..values.length(length, property)? {
                        corners.push(corner(values, property, vertices)?);
                    }
                }
                _ => skip(values, property)?,
            }
        }
        values.end()?;
        faces.push(&corners, || values.place())?;
    }
    Ok(faces)
}

/// The next index, if there is such a vertex.
fn corner(
    values: &mut impl Values,
    property: &Property,
    vertices: u64,
) -> Result<u32, MeshFileError> {
    let index = values.value(property.scalar, property)? as i64; // an integer of at most 32 bits
    match u32::try_from(index) {
        Ok(corner) if u64::from(corner) < vertices => Ok(corner),
        _ => Err(MeshFileError::Index {
            place: values.place(),
            what: "vertex",
            index,
            allowed: match vertices {
                0 => "there are no vertices".into(),
                _ => format!("indices go from 0 to {}", vertices - 1),
            },
        }),
    }
}

fn skip(values: &mut impl Values, property: &Property) -> Result<(), MeshFileError> {
    let count = match property.length {
        Some(length) => values.length(length, property)?,
        None => 1,
    };
    values.skip(count, property)
}

/// An element we have no use for; without properties it takes no room, whatever its count.
fn pass_over(values: &mut impl Values, element: &Element) -> Result<(), MeshFileError> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for index in 0..element.count {
        values.begin(element.name, index)?;
        element.properties.iter().try_for_each(|property| skip(values, property))?;
        values.end()?;
    }
    Ok(())
}
