//! File names in scenes, made independent of the scene's folder.

use std::path::{Path, PathBuf};

use groundtruth::invalid::Invalid;
use groundtruth::scene::Scene;
use toml::{Table, Value};

use super::error::SceneError;
use super::file;

/// The same scene, with `folder` joined to its relative file names.
///
/// Every field called `file` is a file name, at any depth of shapes and textures; so this walks the
/// serialised scene instead of asking each kind.
///
/// # Errors
/// [`SceneError::NotPlain`] if the scene has custom kinds or the folder's name is not UTF-8.
pub fn files_from(scene: &Scene, folder: &Path) -> Result<Scene, SceneError> {
    let mut data = file::table(scene).map_err(|invalid| SceneError::NotPlain { invalid })?;
    let joined = join_files(&mut data, folder);
    joined.map_err(|invalid| SceneError::NotPlain { invalid })?;
    // by way of text: to read tables directly, each kind would be compiled a second time
    file::parse(data.to_string(), folder).map(|(scene, _)| scene)
}

/// The names of files in the scene, as they stand in it; none if it has custom kinds, which no file
/// can hold.
pub fn files(scene: &Scene) -> Vec<String> {
    let mut names = Vec::new();
    if let Ok(data) = file::table(scene) {
        names_inside(&Value::Table(data), &mut names);
    }
    names
}

fn names_inside(value: &Value, names: &mut Vec<String>) {
    match value {
        Value::Table(table) => table.iter().for_each(|(key, value)| match value {
            Value::String(name) if key == "file" => names.push(name.clone()),
            value => names_inside(value, names),
        }),
        Value::Array(all) => all.iter().for_each(|value| names_inside(value, names)),
        _ => {}
    }
}

fn join_files(data: &mut Table, folder: &Path) -> Result<(), Invalid> {
    data.iter_mut().try_for_each(|(key, value)| match value {
        Value::String(name) if key == "file" => {
            *name = text(folder.join(&*name))?;
            Ok(())
        }
        value => join_inside(value, folder),
    })
}

fn join_inside(value: &mut Value, folder: &Path) -> Result<(), Invalid> {
    match value {
        Value::Table(table) => join_files(table, folder),
        Value::Array(all) => all.iter_mut().try_for_each(|value| join_inside(value, folder)),
        _ => Ok(()),
    }
}

fn text(path: PathBuf) -> Result<String, Invalid> {
    path.into_os_string().into_string().map_err(|path| {
        Invalid::field("file", format!("{} is not UTF-8 text", Path::new(&path).display()))
    })
}
