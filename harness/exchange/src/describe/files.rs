//! The files that a scene names, and what is in them.

use std::error::Error;
use std::path::Path;

use serde_json::Value;

use formats::images;
use formats::meshes::{self, MeshData};

use super::page::DescriptionPage;
use super::tables::all_of;
use super::texts;
use super::values::row;

/// More texels than any scene may have.
const ALL_TEXELS: u64 = u64::MAX;

/// The section of the files, if there are any.
///
/// # Errors
/// A file cannot be read, though it could be when the scene was built.
pub fn write(
    page: &mut DescriptionPage,
    data: &Value,
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    let mut names: Vec<&str> = all_of(data, "file").into_iter().filter_map(Value::as_str).collect();
    names.sort_unstable();
    names.dedup();
    if names.is_empty() {
        return Ok(());
    }
    page.heading("Files");
    page.tell("files");
    for name in names {
        let path = folder.join(name);
        let bytes = std::fs::metadata(&path).map_err(|e| format!("{}: {e}", path.display()))?.len();
        page.blank();
        page.line(0, &format!("{name:?}: {bytes} bytes; {}", contents(&path)?));
    }
    Ok(())
}

fn contents(path: &Path) -> Result<String, Box<dyn Error>> {
    let extension = path.extension().map(|it| it.to_string_lossy().to_lowercase());
    if matches!(extension.as_deref(), Some("ply" | "obj")) {
        return Ok(mesh(&meshes::read(path)?));
    }
    Ok(match images::read_stored(path, ALL_TEXELS) {
        Ok(images::Stored { texels, .. }) => {
            format!("an image of {} columns and {} rows.", texels.width(), texels.height())
        }
        Err(_) => "an image of several layers.".to_owned(), // the world has read one of them
    })
}

fn mesh(data: &MeshData) -> String {
    let corner = |pick: fn(f64, f64) -> f64| {
        let all = data.vertices.iter().copied();
        all.reduce(|a, b| [0, 1, 2].map(|axis| pick(a[axis], b[axis]))).unwrap_or_default()
    };
    let has = |list: bool| if list { "with" } else { "without" };
    let values = [
        ("vertices", data.vertices.len().to_string()),
        ("triangles", data.triangles.len().to_string()),
        ("normals", has(data.normals.is_some()).to_owned()),
        ("uvs", has(data.uvs.is_some()).to_owned()),
        ("min", row(corner(f64::min))),
        ("max", row(corner(f64::max))),
    ];
    texts::filled("mesh file", &values)
}
