//! The digest by which parts know that they are of one scene.

use std::error::Error;
use std::fmt::Write;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use groundtruth::scene::Scene;
use groundtruth::world::World;
use sha2::{Digest, Sha256};
use toml::{Table, Value};

/// SHA-256 of a scene with all its settings, in hexadecimal digits.
///
/// It is that of the scene file that `export` writes, in which each name of a file (relative to `folder`) is replaced
/// by the SHA-256 of its bytes, and the number of samples by the one that the sampler of its `world` takes. So it is the
/// same on each machine, wherever the files are, and another one when a file has changed.
///
/// # Errors
/// The scene has custom kinds, or a file cannot be read.
pub fn scene_digest(scene: &Scene, world: &World, folder: &Path) -> Result<String, Box<dyn Error>> {
    let mut scene = scene.clone();
    scene.image.samples = world.samples_per_pixel();
    let mut data: Table = toml::from_str(&scenefile::to_toml(&scene)?)?;
    replace_files(&mut data, folder)?;
    Ok(hexadecimal(Sha256::digest(data.to_string())))
}

/// As `scenefile::files_from`: every field called `file` is the name of a file.
fn replace_files(data: &mut Table, folder: &Path) -> Result<(), String> {
    data.iter_mut().try_for_each(|(key, value)| match value {
        Value::String(name) if key == "file" => {
            let path = folder.join(&*name);
            let digest = file_digest(&path).map_err(|e| format!("{}: {e}", path.display()))?;
            // the name's end says which format it is read as
            let end = path.extension().unwrap_or_default().to_string_lossy();
            *name = format!("{digest}.{end}");
            Ok(())
        }
        value => replace_inside(value, folder),
    })
}

fn replace_inside(value: &mut Value, folder: &Path) -> Result<(), String> {
    match value {
        Value::Table(table) => replace_files(table, folder),
        Value::Array(all) => all.iter_mut().try_for_each(|value| replace_inside(value, folder)),
        _ => Ok(()),
    }
}

fn file_digest(path: &Path) -> std::io::Result<String> {
    let (mut file, mut hash) = (File::open(path)?, Sha256::new());
    let mut block = vec![0; 1 << 16];
    loop {
        match file.read(&mut block)? {
            0 => return Ok(hexadecimal(hash.finalize())),
            count => hash.update(&block[..count]),
        }
    }
}

fn hexadecimal(bytes: impl AsRef<[u8]>) -> String {
    bytes.as_ref().iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
