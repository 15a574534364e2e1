//! Reads and writes scenes as TOML.

use std::io::Read;
use std::path::{Path, PathBuf};

use groundtruth::invalid::{Invalid, Key};
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::error::{Location, SceneError};
use super::locations;

/// The maximum size in bytes; large scenes use procedural kinds or mesh files.
const LARGEST_FILE: u64 = 8 << 20;

/// The text of a scene, kept to find the line of an error.
#[derive(Debug)]
pub struct Source {
    text: String,
    path: PathBuf,
}

impl Source {
    /// The folder to which the file names in the scene are relative.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// Builds the scene that was read from it, and may have been changed since.
    ///
    /// # Errors
    /// [`SceneError`] with file, line, object and field.
    pub fn world(&self, scene: &Scene, seed: u64) -> Result<World, SceneError> {
        World::build_seeded(scene, self.folder(), seed).map_err(|error| self.located(error.into()))
    }

    /// The error with the file and line of its field in this text.
    #[must_use]
    pub fn located(&self, error: SceneError) -> SceneError {
        match error {
            SceneError::Invalid { invalid, .. } => {
                let line = locations::line_of(&self.text, &invalid.path);
                SceneError::Invalid { location: Location::line(&self.path, line), invalid }
            }
            other => other,
        }
    }
}

/// The path that means the standard input; files in such a scene are relative to the current
/// folder.
pub const STANDARD_INPUT: &str = "-";

/// Reads a scene file, or the standard input if its path is `-`, without building it.
///
/// # Errors
/// [`SceneError`] with file, line, object and field.
pub fn open(path: &Path) -> Result<(Scene, Source), SceneError> {
    let unreadable = |source| SceneError::Unreadable { path: path.to_owned(), source };
    let mut bytes = Vec::new();
    // limits the bytes that are read, not the reported size: the file may be a pipe
    let read = match path == Path::new(STANDARD_INPUT) {
        true => std::io::stdin().lock().take(LARGEST_FILE + 1).read_to_end(&mut bytes),
        false => std::fs::File::open(path)
            .and_then(|file| file.take(LARGEST_FILE + 1).read_to_end(&mut bytes)),
    };
    read.map_err(unreadable)?;
    if bytes.len() as u64 > LARGEST_FILE {
        let problem = format!("it is too large for a scene (at most {LARGEST_FILE} bytes fit)");
        return Err(unreadable(std::io::Error::other(problem)));
    }
    from_bytes(bytes, path)
}

/// The scene in the bytes of a file; `path` is for error messages and for relative file names.
///
/// # Errors
/// [`SceneError`] with file, line and field.
pub fn from_bytes(bytes: Vec<u8>, path: &Path) -> Result<(Scene, Source), SceneError> {
    parse(String::from_utf8(bytes).map_err(|error| not_utf8(&error, path))?, path)
}

/// The error of bytes that are no text, with the line and the byte in it, both from 1.
fn not_utf8(error: &std::string::FromUtf8Error, path: &Path) -> SceneError {
    let (bytes, at) = (error.as_bytes(), error.utf8_error().valid_up_to());
    let before = &bytes[..at];
    let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
    let byte = at - before.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1) + 1;
    let kind = match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => "the file is UTF-16 text; save it as UTF-8",
        // PNG, JPEG, EXR
        [0x89, b'P', b'N', b'G', ..] | [0xff, 0xd8, ..] | [0x76, 0x2f, 0x31, 0x01, ..] => {
            "the file is a picture; name a scene"
        }
        _ => "save the file as UTF-8 text",
    };
    let problem = format!("byte {byte} of the line, 0x{:02x}, is not UTF-8: {kind}", bytes[at]);
    SceneError::Invalid { location: Location::line(path, line), invalid: Invalid::new(problem) }
}

/// Parses a scene; `path` is for error messages and for relative file names.
///
/// # Errors
/// [`SceneError`] with file, line and field.
pub fn parse(text: String, path: &Path) -> Result<(Scene, Source), SceneError> {
    let scene: Scene =
        toml::from_str(&text).map_err(|e| locations::parse_error(&text, path, &e))?;
    // the reader takes a list for a table, as the values of its fields in the order of their declaration
    if let Some(error) = locations::mismatch_error(&text, path) {
        return Err(error);
    }
    Ok((scene, Source { text, path: path.to_owned() }))
}

/// The scene as TOML; [`parse`] returns the same scene, bit for bit.
///
/// # Errors
/// [`SceneError::NotPlain`] names the part that is of a custom kind.
pub fn to_toml(scene: &Scene) -> Result<String, SceneError> {
    let table = table(scene).map_err(|invalid| SceneError::NotPlain { invalid })?;
    Ok(table.to_string())
}

/// The scene as a table of TOML.
pub(super) fn table(scene: &Scene) -> Result<toml::Table, Invalid> {
    check_plain(scene)?;
    toml::Table::try_from(scene).map_err(|e| Invalid::new(e.to_string()))
}

/// Fails if a part of the scene is of a custom kind.
fn check_plain(scene: &Scene) -> Result<(), Invalid> {
    for (i, object) in scene.objects.iter().enumerate() {
        check_part(&object.shape, &["shape"], Some(("objects", i, &object.name)))?;
    }
    for (i, light) in scene.lights.iter().enumerate() {
        check_part(&light.source, &["source"], Some(("lights", i, &light.name)))?;
    }
    for (i, material) in scene.materials.iter().enumerate() {
        check_part(&material.recipe, &["recipe"], Some(("materials", i, &material.name)))?;
    }
    check_part(&scene.camera.lens, &["camera", "lens"], None)?;
    check_part(&scene.image, &["image", "sampler"], None)
}

/// Fails if serde cannot serialise `data`: the variants of custom kinds have no data.
fn check_part(
    data: &impl serde::Serialize,
    fields: &[&str],
    item: Option<(&str, usize, &str)>,
) -> Result<(), Invalid> {
    if toml::Value::try_from(data).is_ok() {
        return Ok(());
    }
    let problem = Invalid::new("is of a custom kind, which a scene file cannot say");
    let problem = fields.iter().rev().fold(problem, |e, &field| e.inside(field));
    Err(match item {
        Some((list, i, name)) => problem.inside(Key::Item(i, Some(name.to_owned()))).inside(list),
        None => problem,
    })
}
