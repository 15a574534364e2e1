//! The elements `face` and `tristrips` of a PLY file.

use super::super::MeshFileError;
use super::super::faces::Faces;
use super::header::{Element, Property, Scalar};
use super::values::Values;
use super::{Ignored, is_finite, property_index, skip, wedges};

/// The index of the property that lists the vertices of a face or strip.
pub(super) fn corner_list(face: &Element, element: &'static str) -> Result<usize, MeshFileError> {
    for name in ["vertex_indices", "vertex_index"] {
        let Some(at) = property_index(face, element, name)? else { continue };
        let property = &face.properties[at];
        if property.length.is_none() || !property.scalar.is_integer() {
            let property = name.into();
            let expected = "a list of integers, as `property list uchar int vertex_indices`";
            return Err(MeshFileError::PropertyType { element, property, expected });
        }
        return Ok(at);
    }
    Err(MeshFileError::MissingProperty { element, property: "`vertex_indices` or `vertex_index`" })
}

/// The index of the property that lists the texture coordinates of a face's corners, if there is one.
pub(super) fn texcoord_list(face: &Element) -> Result<Option<usize>, MeshFileError> {
    let is_list = |p: &Property| p.length.is_some() && !p.scalar.is_integer();
    let at = property_index(face, "face", "texcoord")?;
    Ok(at.filter(|&at| is_list(&face.properties[at])))
}

/// The faces read so far.
pub(super) struct FaceReader {
    vertices: u64,
    pub(super) faces: Faces,
    /// The texture coordinates of all corners; those of the last ones may be missing.
    pub(super) uvs_of_corners: Vec<[f64; 2]>,
    corners: Vec<u32>,
    texcoord: Vec<f64>,
}

impl FaceReader {
    /// No faces yet; `vertices` is the declared number of vertices.
    pub(super) fn new(vertices: u64) -> Self {
        let (faces, corners) = (Faces::default(), Vec::new());
        Self { vertices, faces, uvs_of_corners: Vec::new(), corners, texcoord: Vec::new() }
    }

    pub(super) fn read_faces(
        &mut self,
        values: &mut impl Values,
        element: &Element,
        corner_list: usize,
        texcoord_list: Option<usize>,
        ignored: &mut Ignored,
    ) -> Result<(), MeshFileError> {
        self.faces.reserve(element.count as usize); // at most the remaining bytes
        for index in 0..element.count {
            values.begin(element.name, index)?;
            for (at, property) in element.properties.iter().enumerate() {
                match property.length {
                    Some(length) if at == corner_list => {
                        self.corners.clear();
                        for _ in 0..values.length(length, property)? {
                            let index = values.value(property.scalar, property)?;
                            self.corners.push(self.vertex(values, index)?);
                        }
                    }
                    Some(length) if Some(at) == texcoord_list => {
                        self.texcoord.clear();
                        for _ in 0..values.length(length, property)? {
                            self.texcoord.push(values.value(property.scalar, property)?);
                        }
                    }
                    _ => skip(values, property)?,
                }
            }
            ignored.end(values);
            let is_polygon = self.faces.push(&self.corners, || values.location());
            if is_polygon && texcoord_list.is_some() {
                self.push_uvs(values, ignored);
            }
        }
        Ok(())
    }

    /// Appends the texture coordinates of the face read last. A face without any is no fault.
    fn push_uvs(&mut self, values: &impl Values, ignored: &mut Ignored) {
        let end = self.faces.corners().len();
        self.uvs_of_corners.resize(end - self.corners.len(), wedges::NONE);
        if self.texcoord.len() == 2 * self.corners.len() && is_finite(&self.texcoord) {
            self.uvs_of_corners.extend(self.texcoord.chunks(2).map(|uv| [uv[0], uv[1]]));
        } else {
            self.uvs_of_corners.resize(end, wedges::NONE);
            if !self.texcoord.is_empty() {
                ignored.corner_uvs.add(|| values.location());
            }
        }
    }

    pub(super) fn read_strips(
        &mut self,
        values: &mut impl Values,
        element: &Element,
        corner_list: usize,
        ignored: &mut Ignored,
    ) -> Result<(), MeshFileError> {
        for index in 0..element.count {
            values.begin(element.name, index)?;
            for (at, property) in element.properties.iter().enumerate() {
                match property.length {
                    Some(length) if at == corner_list => {
                        let count = values.length(length, property)?;
                        self.read_strip(values, property, count)?;
                    }
                    _ => skip(values, property)?,
                }
            }
            ignored.end(values);
        }
        Ok(())
    }

    /// Reads a list of strips: −1 ends one, and the next number starts another.
    fn read_strip(
        &mut self,
        values: &mut impl Values,
        property: &Property,
        count: u64,
    ) -> Result<(), MeshFileError> {
        self.corners.clear();
        for _ in 0..count {
            let index = values.value(property.scalar, property)?;
            // −1 written as an unsigned number: no vertex has this index
            let ends =
                index == -1.0 || property.scalar == Scalar::U32 && index == f64::from(u32::MAX);
            if ends {
                self.faces.push_strip(&self.corners, || values.location());
                self.corners.clear();
            } else {
                self.corners.push(self.vertex(values, index)?);
            }
        }
        self.faces.push_strip(&self.corners, || values.location());
        Ok(())
    }

    /// The vertex index; fails if it is out of range.
    fn vertex(&self, values: &impl Values, index: f64) -> Result<u32, MeshFileError> {
        let index = index as i64; // an integer of at most 32 bits
        match u32::try_from(index) {
            Ok(corner) if u64::from(corner) < self.vertices => Ok(corner),
            _ => Err(MeshFileError::Index {
                location: values.location(),
                what: "vertex",
                index,
                allowed: match self.vertices {
                    0 => "there are no vertices".into(),
                    count => format!("indices go from 0 to {}", count - 1),
                },
            }),
        }
    }
}
