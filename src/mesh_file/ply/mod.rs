//! PLY, the Stanford triangle format (Greg Turk, *The PLY Polygon File Format*, 1994).
//!
//! The header, a text, declares elements (`vertex`, `face`, …) and their properties; the body has
//! the values in that order. The reader uses `x y z`, `nx ny nz` and the first complete pair of `u
//! v`, `s t`, `texture_u texture_v`, `texture_s texture_t` of `vertex`, and the list
//! `vertex_indices` or `vertex_index` of `face`. All other elements and properties are skipped.

mod header;
mod values;
mod write;

use super::error::quoted;
use super::faces::Faces;
use super::{MeshData, MeshFileError, at_most_u32, with_triangles, without_byte_order_mark};
use header::{Element, Header, Property};
use values::{Binary, Text, Values};

pub use header::Encoding;
pub use write::write_ply;

/// Reads the bytes of a PLY file, ASCII or binary.
///
/// # Errors
/// The first thing that is wrong; the message says where.
pub fn parse_ply(bytes: &[u8]) -> Result<MeshData, MeshFileError> {
    let header = Header::parse(without_byte_order_mark(bytes))?;
    match header.encoding {
        Encoding::Ascii => parse_body(&header, Text::new(&header)),
        _ => parse_body(&header, Binary::new(&header)),
    }
}

fn parse_body(header: &Header, mut values: impl Values) -> Result<MeshData, MeshFileError> {
    if header.elements.iter().any(|e| e.name == "tristrips") {
        return Err(MeshFileError::TriangleStrips);
    }
    let vertices = unique_element(header, "vertex")?;
    let faces = unique_element(header, "face")?;
    at_most_u32("vertices", vertices.count)?;
    let (columns, corners) = (Columns::find(vertices)?, corner_list(faces)?);
    let (mut data, mut polygons) = (MeshData::default(), Faces::default());
    for element in &header.elements {
        check_declared_count(element, header.encoding, &values)?;
        match element.name {
            "vertex" => read_vertices(&mut data, &mut values, element, &columns)?,
            "face" => polygons = read_faces(&mut values, element, corners, vertices.count)?,
            _ => skip_element(&mut values, element)?,
        }
    }
    if !values.remaining().trim_ascii().is_empty() {
        return Err(MeshFileError::LeftOver { left: values.remaining().len() });
    }
    with_triangles(data, &polygons)
}

/// The element of this name; fails if there is none, or more than one.
fn unique_element<'a>(
    header: &'a Header,
    name: &'static str,
) -> Result<&'a Element<'a>, MeshFileError> {
    let mut found = header.elements.iter().filter(|e| e.name == name);
    let element = found.next().ok_or(MeshFileError::MissingElement { element: name })?;
    match found.next() {
        Some(_) => Err(MeshFileError::RepeatedElement { element: name }),
        None => Ok(element),
    }
}

/// The index of the property in its element, `None` if it is missing; fails if there are two.
fn property_index(
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

/// Checks the declared count against the rest of the file, before memory is allocated for it.
fn check_declared_count(
    element: &Element,
    encoding: Encoding,
    values: &impl Values,
) -> Result<(), MeshFileError> {
    let (size, left) = (element.min_size(encoding), values.remaining().len());
    // one more: the last word of a file may have no white space after it
    if element.count.saturating_mul(size) > left as u64 + 1 {
        let (element, count) = (quoted(element.name.as_bytes()), element.count);
        return Err(MeshFileError::DeclaredCount { element, count, size, left });
    }
    Ok(())
}

/// The columns of a vertex: position, normal, texture coordinates.
const COLUMNS: usize = 8;

/// The columns of the properties of a vertex.
struct Columns {
    /// For each property its column; `None` to skip it.
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
        for (name, quoted) in [("x", "`x`"), ("y", "`y`"), ("z", "`z`")] {
            if property_index(vertex, "vertex", name)?.is_none() {
                let (element, property) = ("vertex", quoted);
                return Err(MeshFileError::MissingProperty { element, property });
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

    /// Assigns the columns from `first` on to these properties, if the element has all of them.
    fn assign<const N: usize>(
        &mut self,
        vertex: &Element,
        first: usize,
        names: [&str; N],
    ) -> Result<bool, MeshFileError> {
        let mut indices = [0; N];
        for (index, name) in indices.iter_mut().zip(names) {
            let Some(at) = property_index(vertex, "vertex", name)? else { return Ok(false) };
            if vertex.properties[at].length.is_some() {
                let (element, property) = ("vertex", name.into());
                let expected = "a single number, not a list";
                return Err(MeshFileError::PropertyType { element, property, expected });
            }
            *index = at;
        }
        for (column, at) in (first..).zip(indices) {
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
    let capacity = element.count as usize; // at most the number of remaining bytes
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
        location: values.location(),
        property: quoted(property.name.as_bytes()),
        found: value.to_string(),
        expected: "a finite number",
    })
}

/// The index of the property that lists a face's vertices.
fn corner_list(face: &Element) -> Result<usize, MeshFileError> {
    for name in ["vertex_indices", "vertex_index"] {
        let Some(at) = property_index(face, "face", name)? else { continue };
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
    let mut faces = Faces::with_capacity(element.count as usize); // at most the remaining bytes
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
        faces.push(&corners, || values.location())?;
    }
    Ok(faces)
}

/// The next vertex index; fails if it is out of range.
fn corner(
    values: &mut impl Values,
    property: &Property,
    vertices: u64,
) -> Result<u32, MeshFileError> {
    let index = values.value(property.scalar, property)? as i64; // an integer of at most 32 bits
    match u32::try_from(index) {
        Ok(corner) if u64::from(corner) < vertices => Ok(corner),
        _ => Err(MeshFileError::Index {
            location: values.location(),
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

/// Skips an unused element; without properties it has no bytes, whatever its count.
fn skip_element(values: &mut impl Values, element: &Element) -> Result<(), MeshFileError> {
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
