//! PLY, the Stanford triangle format (Greg Turk, *The PLY Polygon File Format*, 1994).
//!
//! The header, a text, declares elements (`vertex`, `face`, …) and their properties; the body has
//! the values in that order. The reader uses `x y z`, `nx ny nz` and the first complete pair of `u
//! v`, `s t`, `texture_u texture_v`, `texture_s texture_t` of `vertex`, the list `vertex_indices` or
//! `vertex_index` of `face` and `tristrips`, and the list `texcoord` of `face`, which goes before the
//! coordinates of vertices. All other elements and properties are skipped.

mod faces;
mod header;
mod values;
mod wedges;
mod write;

use super::error::quoted;
use super::faces::Faces;
use super::notes::{NO_NORMAL, NO_UV, Tally};
use super::{
    Location, MeshData, MeshFileError, at_most_u32, with_triangles, without_byte_order_mark,
};
use faces::{FaceReader, corner_list, texcoord_list};
use header::{Element, Header, Property};
use values::{Binary, Text, Values};

pub use header::Encoding;
pub use write::write_ply;

/// Reads the bytes of a PLY file, ASCII or binary.
///
/// # Errors
/// The first thing that is wrong; the message says where.
pub fn parse_ply(bytes: &[u8]) -> Result<MeshData, MeshFileError> {
    let header = Header::parse(without_byte_order_mark(bytes)?)?;
    match header.encoding {
        Encoding::Ascii => parse_body(&header, Text::new(&header)),
        _ => parse_body(&header, Binary::new(&header)),
    }
}

fn parse_body(header: &Header, mut values: impl Values) -> Result<MeshData, MeshFileError> {
    let vertices = unique_element(header, "vertex")?
        .ok_or(MeshFileError::MissingElement { element: "vertex" })?;
    let (polygons, strips) =
        (unique_element(header, "face")?, unique_element(header, "tristrips")?);
    if polygons.is_none() && strips.is_none() {
        return Err(MeshFileError::MissingElement { element: "face" });
    }
    at_most_u32("vertices", vertices.count)?;
    let columns = Columns::find(vertices)?;
    let corners_of_faces = polygons.map(|face| corner_list(face, "face")).transpose()?;
    let corners_of_strips = strips.map(|strip| corner_list(strip, "tristrips")).transpose()?;
    let texcoord = polygons.map(texcoord_list).transpose()?.flatten();
    let (mut data, mut ignored) = (MeshData::default(), Ignored::default());
    let mut reader = FaceReader::new(vertices.count);
    for element in &header.elements {
        check_declared_count(element, header.encoding, &values)?;
        match (element.name, corners_of_faces, corners_of_strips) {
            ("vertex", ..) => {
                read_vertices(&mut data, &mut values, element, &columns, &mut ignored)?;
            }
            ("face", Some(list), _) => {
                reader.read_faces(&mut values, element, list, texcoord, &mut ignored)?;
            }
            ("tristrips", _, Some(list)) => {
                reader.read_strips(&mut values, element, list, &mut ignored)?;
            }
            _ => skip_element(&mut values, element, &mut ignored)?,
        }
    }
    if !values.remaining().trim_ascii().is_empty() {
        return Err(MeshFileError::LeftOver { left: values.remaining().len() });
    }
    let FaceReader { mut faces, uvs_of_corners, .. } = reader;
    ignored.replace_positions(&mut data, &faces)?;
    wedges::apply(&uvs_of_corners, &mut data, &mut faces)?;
    ignored.note(&mut data.notes);
    with_triangles(data, &faces)
}

/// What is ignored in the body.
#[derive(Default)]
pub(super) struct Ignored {
    surplus: Tally,
    normals: Tally,
    uvs: Tally,
    corner_uvs: Tally,
    positions: Tally,
    /// The vertices whose positions are not finite, ascending, and their locations.
    not_finite: Vec<(u32, Location)>,
}

impl Ignored {
    /// Ends an element, and counts it if it has more values than the header declares.
    fn end(&mut self, values: &mut impl Values) {
        if values.end() {
            self.surplus.add(|| values.location());
        }
    }

    /// Replaces the positions that are not finite by one that is used; fails if a face uses one.
    fn replace_positions(
        &mut self,
        data: &mut MeshData,
        faces: &Faces,
    ) -> Result<(), MeshFileError> {
        if self.not_finite.is_empty() {
            return Ok(());
        }
        for &corner in faces.corners() {
            let position = data.vertices[corner as usize];
            let Some(axis) = position.iter().position(|x| !x.is_finite()) else { continue };
            let index = self.not_finite.partition_point(|(vertex, _)| *vertex < corner);
            return Err(MeshFileError::Value {
                location: self.not_finite[index].1.clone(),
                property: ["x", "y", "z"][axis].into(),
                found: position[axis].to_string(),
                expected: "a finite number",
            });
        }
        let used = faces.corners().first().map_or([0.0; 3], |&c| data.vertices[c as usize]);
        for (vertex, location) in self.not_finite.drain(..) {
            data.vertices[vertex as usize] = used;
            self.positions.add(|| location);
        }
        Ok(())
    }

    fn note(&self, notes: &mut Vec<String>) {
        let beyond = "the values beyond those that the header declares are ignored";
        self.surplus.note(notes, beyond);
        let unused = "a position that is not a finite number is ignored, because no face uses it";
        self.positions.note(notes, unused);
        self.normals.note(notes, NO_NORMAL);
        self.uvs.note(notes, NO_UV);
        let corners = "a face whose `texcoord` are not two finite numbers for each corner: they are \
            ignored";
        self.corner_uvs.note(notes, corners);
    }
}

/// The element of this name; fails if there is more than one.
fn unique_element<'a>(
    header: &'a Header,
    name: &'static str,
) -> Result<Option<&'a Element<'a>>, MeshFileError> {
    let mut found = header.elements.iter().filter(|e| e.name == name);
    match (found.next(), found.next()) {
        (_, Some(_)) => Err(MeshFileError::RepeatedElement { element: name }),
        (element, None) => Ok(element),
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
    ignored: &mut Ignored,
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
                Some(column) => row[*column] = values.value(property.scalar, property)?,
                None => skip(values, property)?,
            }
        }
        ignored.end(values);
        let [x, y, z, nx, ny, nz, u, v] = row;
        let (position, mut normal, mut uv) = ([x, y, z], [nx, ny, nz], [u, v]);
        if !is_finite(&position) {
            ignored.not_finite.push((index as u32, values.location()));
        }
        if !is_finite(&normal) {
            normal = [0.0; 3];
            ignored.normals.add(|| values.location());
        }
        if !is_finite(&uv) {
            uv = [0.0; 2];
            ignored.uvs.add(|| values.location());
        }
        data.vertices.push(position);
        data.normals.iter_mut().for_each(|normals| normals.push(normal));
        data.uvs.iter_mut().for_each(|uvs| uvs.push(uv));
    }
    Ok(())
}

fn is_finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|x| x.is_finite())
}

fn skip(values: &mut impl Values, property: &Property) -> Result<(), MeshFileError> {
    let count = match property.length {
        Some(length) => values.length(length, property)?,
        None => 1,
    };
    values.skip(count, property)
}

/// Skips an unused element; without properties it has no bytes, whatever its count.
fn skip_element(
    values: &mut impl Values,
    element: &Element,
    ignored: &mut Ignored,
) -> Result<(), MeshFileError> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for index in 0..element.count {
        values.begin(element.name, index)?;
        element.properties.iter().try_for_each(|property| skip(values, property))?;
        ignored.end(values);
    }
    Ok(())
}
