//! The files that a scene names.

use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::Value;

use super::{Scene, SceneError, file};
use crate::invalid::Invalid;

impl Scene {
    /// The same scene whose file names, relative to `folder` before, are independent of it.
    ///
    /// Every field called `file` is the name of a file, at whatever depth of shapes and textures: so
    /// the scene's data is walked, and no kind is asked.
    ///
    /// # Errors
    /// [`SceneError::NotPlain`] for a scene or a folder that has no text.
    pub fn files_from(&self, folder: &Path) -> Result<Self, SceneError> {
        file::all_plain(self)
            .and_then(|()| {
                let mut data = Value::try_from(self).map_err(|e| Invalid::new(e.to_string()))?;
                rename(&mut data, folder)?;
                Self::deserialize(data).map_err(|e| Invalid::new(e.to_string()))
            })
            .map_err(|invalid| SceneError::NotPlain { invalid })
    }
}

fn rename(data: &mut Value, folder: &Path) -> Result<(), Invalid> {
    match data {
        Value::Table(table) => table.iter_mut().try_for_each(|(key, value)| match value {
            Value::String(name) if key == "file" => {
                *name = text(folder.join(&*name))?;
                Ok(())
            }
            value => rename(value, folder),
        }),
        Value::Array(all) => all.iter_mut().try_for_each(|value| rename(value, folder)),
        _ => Ok(()),
    }
}

fn text(path: PathBuf) -> Result<String, Invalid> {
    path.into_os_string().into_string().map_err(|path| {
        Invalid::field("file", format!("{} is not UTF-8 text", Path::new(&path).display()))
    })
}
