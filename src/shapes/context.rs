//! What building a shape needs to know beside its data.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::accel;
use crate::invalid::Invalid;
use crate::mesh_file::{self, MeshData};

/// How deep instances may be nested: far more than any scene, far less than any stack.
const MAX_NESTING: usize = 64;

/// Where files are found, and what has been read already: instances of one mesh file share it.
#[derive(Debug, Default)]
pub struct Context {
    folder: PathBuf,
    accel: accel::Method,
    meshes: HashMap<PathBuf, Arc<MeshData>>,
    depth: usize,
}

impl Context {
    /// File names are relative to `folder`; meshes use `accel` unless they name their own.
    pub fn new(folder: &Path, accel: accel::Method) -> Self {
        Self { folder: folder.to_owned(), accel, ..Self::default() }
    }

    /// The acceleration of a mesh that names none.
    pub fn accel(&self) -> accel::Method {
        self.accel
    }

    /// The contents of a mesh file, read once.
    pub(super) fn mesh(&mut self, file: &Path) -> Result<Arc<MeshData>, Invalid> {
        let path = self.folder.join(file);
        if let Some(known) = self.meshes.get(&path) {
            return Ok(Arc::clone(known));
        }
        let mesh = mesh_file::read(&path).map_err(|e| Invalid::field("file", e.to_string()))?;
        let mesh = Arc::new(mesh);
        self.meshes.insert(path, Arc::clone(&mesh));
        Ok(mesh)
    }

    /// Builds what stands inside an instance, unless that is too deep.
    pub(super) fn nested<T>(
        &mut self,
        build: impl FnOnce(&mut Self) -> Result<T, Invalid>,
    ) -> Result<T, Invalid> {
        if self.depth == MAX_NESTING {
            return Err(Invalid::new(format!(
                "instances are nested deeper than {MAX_NESTING}; combine their transforms"
            )));
        }
        self.depth += 1;
        let built = build(self);
        self.depth -= 1;
        built
    }
}
