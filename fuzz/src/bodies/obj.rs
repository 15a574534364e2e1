//! OBJ: any bytes give a valid mesh or an error. The memory is in proportion to the file.

use formats::meshes::{MeshData, parse_obj};

/// The bound that the module promises: bytes of memory for each byte of the file.
const MEMORY_FACTOR: usize = 64;

/// Reads a file and checks the mesh, if there is one.
pub fn run(data: &[u8]) {
    if let Ok(mesh) = parse_obj(data) {
        assert_in_order(&mesh, data.len());
    }
}

/// Checks what `MeshData` promises about every mesh that was read.
pub(super) fn assert_in_order(mesh: &MeshData, file: usize) {
    let count = mesh.vertices.len();
    assert!(mesh.vertices.iter().flatten().all(|x| x.is_finite()));
    assert!(mesh.normals.iter().flatten().flatten().all(|x| x.is_finite()));
    assert!(mesh.uvs.iter().flatten().flatten().all(|x| x.is_finite()));
    assert!(mesh.normals.as_ref().is_none_or(|normals| normals.len() == count));
    assert!(mesh.uvs.as_ref().is_none_or(|uvs| uvs.len() == count));
    assert!(!mesh.triangles.is_empty());
    assert!(mesh.triangles.iter().flatten().all(|&corner| (corner as usize) < count));
    let triangles = mesh.triangles.len();
    assert!(mesh.faces.is_empty() || mesh.faces.len() == triangles);
    assert!(mesh.faces.is_sorted());
    let memory = 24 * mesh.vertices.capacity()
        + 24 * mesh.normals.as_ref().map_or(0, Vec::capacity)
        + 16 * mesh.uvs.as_ref().map_or(0, Vec::capacity)
        + 12 * mesh.triangles.capacity()
        + 4 * mesh.faces.capacity();
    assert!(memory <= MEMORY_FACTOR * file, "{memory} bytes from a file of {file}");
}
