//! Scenes as TOML text.

use std::io::Read;
use std::path::{Path, PathBuf};

use super::error::Place;
use super::{Scene, SceneError, places};
use crate::invalid::{Invalid, Key};

/// Larger files are no scenes: large things are procedural kinds or mesh files.
const LARGEST_FILE: u64 = 8 << 20;

/// The text of a scene, kept to say where in it something is wrong.
#[derive(Debug)]
pub struct Source {
    text: String,
    path: PathBuf,
}

impl Source {
    /// The folder that the files named by the scene are relative to.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// An error of a scene of this text, with file and line.
    #[must_use]
    pub fn located(&self, error: SceneError) -> SceneError {
        match error {
            SceneError::Invalid { invalid, .. } => {
                let line = places::line_of(&self.text, &invalid.path);
                SceneError::Invalid { place: Place::line(&self.path, line), invalid }
            }
            other => other,
        }
    }
}

/// Reads a scene file without building it.
///
/// # Errors
/// [`SceneError`] with file, line, object and field.
pub fn open(path: &Path) -> Result<(Scene, Source), SceneError> {
    let unreadable = |source| SceneError::Unreadable { path: path.to_owned(), source };
    let file = std::fs::File::open(path).map_err(unreadable)?;
    let mut text = String::new();
    // no more than fits is read, whatever the file says about its size: it may be a pipe
    file.take(LARGEST_FILE + 1).read_to_string(&mut text).map_err(unreadable)?;
    if text.len() as u64 > LARGEST_FILE {
        let problem = format!("it is too large for a scene (at most {LARGEST_FILE} bytes fit)");
        return Err(unreadable(std::io::Error::other(problem)));
    }
    parse(text, path)
}

/// The scene in a text; `path` is for error messages and for files it names.
///
/// # Errors
/// [`SceneError`] with file, line and field.
pub fn parse(text: String, path: &Path) -> Result<(Scene, Source), SceneError> {
    let scene: Scene = toml::from_str(&text).map_err(|e| places::unreadable(&text, path, &e))?;
    Ok((scene, Source { text, path: path.to_owned() }))
}

/// The scene as text that reads back to the same scene, every bit of it.
///
/// # Errors
/// [`SceneError::NotPlain`] names what is of a custom kind.
pub fn to_toml(scene: &Scene) -> Result<String, SceneError> {
    all_plain(scene).map_err(|invalid| SceneError::NotPlain { invalid })?;
    toml::to_string(scene)
        .map_err(|e| SceneError::NotPlain { invalid: Invalid::new(e.to_string()) })
}

/// Whether nothing is of a user's own kind, which has no text.
pub(super) fn all_plain(scene: &Scene) -> Result<(), Invalid> {
    for (i, object) in scene.objects.iter().enumerate() {
        plain(&object.shape, &["shape"], Some(("objects", i, &object.name)))?;
    }
    for (i, light) in scene.lights.iter().enumerate() {
        plain(&light.source, &["source"], Some(("lights", i, &light.name)))?;
    }
    for (i, material) in scene.materials.iter().enumerate() {
        plain(&material.recipe, &["recipe"], Some(("materials", i, &material.name)))?;
    }
    plain(&scene.camera.lens, &["camera", "lens"], None)?;
    plain(&scene.image, &["image", "sampler"], None)
}

/// Whether serde can write it: it refuses the variants of users' own kinds, which carry no data.
fn plain(
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
