//! File names in scenes, made independent of the scene's folder.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::Value;

use super::{Scene, SceneError, file};
use crate::invalid::Invalid;

impl Scene {
    /// The same scene, with `folder` joined to its relative file names.
    ///
    /// Every field called `file` is a file name, at any depth of shapes and textures; so this walks
    /// the serialised scene instead of asking each kind.
    ///
    /// # Errors
    /// [`SceneError::NotPlain`] if the scene has custom kinds or the folder's name is not UTF-8.
    pub fn files_from(&self, folder: &Path) -> Result<Self, SceneError> {
        file::check_plain(self)
            .and_then(|()| {
                let mut data = Value::try_from(self).map_err(|e| Invalid::new(e.to_string()))?;
                join_files(&mut data, folder)?;
                Self::deserialize(data).map_err(|e| Invalid::new(e.to_string()))
            })
            .map_err(|invalid| SceneError::NotPlain { invalid })
    }
}

fn join_files(data: &mut Value, folder: &Path) -> Result<(), Invalid> {
    match data {
        Value::Table(table) => table.iter_mut().try_for_each(|(key, value)| match value {
            Value::String(name) if key == "file" => {
                *name = text(folder.join(&*name))?;
                Ok(())
            }
            value => join_files(value, folder),
        }),
        Value::Array(all) => all.iter_mut().try_for_each(|value| join_files(value, folder)),
        _ => Ok(()),
    }
}

fn text(path: PathBuf) -> Result<String, Invalid> {
    path.into_os_string().into_string().map_err(|path| {
        Invalid::field("file", format!("{} is not UTF-8 text", Path::new(&path).display()))
    })
}
