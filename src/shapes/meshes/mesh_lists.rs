//! Meshes given as lists in the scene (Suffern, ch. 23): the vertices and the `vertex_faces`
//! indices of the book's `Mesh`, without a file.
//!
//! The book trusts such lists; here they are checked like a mesh file (finite numbers, indices in
//! range, one normal and one uv for each vertex), because scene files are written by hand.

use crate::invalid::Invalid;
use crate::math::Point;
use crate::shapes::Mesh;
use formats::meshes::MeshData;

/// The lists of a mesh as the contents of a mesh file.
pub fn data(mesh: &Mesh) -> Result<MeshData, Invalid> {
    let (Some(vertices), Some(triangles)) = (&mesh.vertices, &mesh.triangles) else {
        return Err(Invalid::new("needs either `file`, or `vertices` and `triangles`"));
    };
    each("vertices", vertices, |at| check_finite(&at.to_array()))?;
    check_triangles(triangles, vertices.len())?;
    for (field, found) in
        [("normals", mesh.normals.as_ref().map(Vec::len)), ("uvs", mesh.uvs.as_ref().map(Vec::len))]
    {
        if let Some(found) = found.filter(|&found| found != vertices.len()) {
            let needed = vertices.len();
            let problem = format!("found {found}, but each of the {needed} vertices needs one");
            return Err(Invalid::field(field, problem));
        }
    }
    let normals = mesh.normals.as_deref().unwrap_or_default();
    each("normals", normals, |n| check_finite(&n.to_array()))?;
    let uvs = mesh.uvs.as_deref().unwrap_or_default();
    each("uvs", uvs, |uv| check_finite(uv))?;
    Ok(MeshData {
        vertices: vertices.iter().copied().map(Point::to_array).collect(),
        triangles: triangles.clone(),
        normals: mesh.normals.as_ref().map(|all| all.iter().map(|n| n.to_array()).collect()),
        uvs: mesh.uvs.clone(),
        ..MeshData::default()
    })
}

/// Fails if the mesh has both a file and a list.
pub fn check_absent(mesh: &Mesh) -> Result<(), Invalid> {
    let given = [
        ("vertices", mesh.vertices.is_some()),
        ("triangles", mesh.triangles.is_some()),
        ("normals", mesh.normals.is_some()),
        ("uvs", mesh.uvs.is_some()),
    ];
    match given.into_iter().find(|(_, given)| *given) {
        Some((field, _)) => {
            Err(Invalid::field(field, "found beside `file`; leave one of them out"))
        }
        None => Ok(()),
    }
}

fn check_finite(numbers: &[f64]) -> Result<(), Invalid> {
    if numbers.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Err(Invalid::new(format!("found {numbers:?}, but finite numbers are needed")))
}

fn check_triangles(triangles: &[[u32; 3]], vertices: usize) -> Result<(), Invalid> {
    if triangles.is_empty() {
        return Err(Invalid::field("triangles", "found none, but a mesh has at least one"));
    }
    each("triangles", triangles, |triangle| {
        for (corner, &index) in triangle.iter().enumerate() {
            if index as usize >= vertices {
                let problem = match vertices {
                    0 => format!("found {index}, but there are no vertices"),
                    _ => format!("found {index}, but vertices go from 0 to {}", vertices - 1),
                };
                return Err(Invalid::new(problem).inside(corner));
            }
        }
        Ok(())
    })
}

/// Checks each element; an error names the first invalid one.
fn each<T>(
    list: &str,
    elements: &[T],
    check: impl Fn(&T) -> Result<(), Invalid>,
) -> Result<(), Invalid> {
    for (index, element) in elements.iter().enumerate() {
        check(element).map_err(|e| e.inside(index).inside(list))?;
    }
    Ok(())
}
