//! The files of a scene: read once, shared, and bounded together.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::images::{self, Drawn, Encoding, Texels};
use crate::invalid::{BACKSLASH, Invalid};
use crate::mesh_file::{self, MeshData};

/// The most bytes in the mesh files of one scene: more would take gigabytes, because they are read whole.
const MAX_BYTES: u64 = mesh_file::MAX_BYTES;
/// The most texels in its images, of 12 bytes each.
const MAX_TEXELS: u64 = 1 << 26;

/// The folder of a scene's files, the files read so far, and the budget that is left.
#[derive(Debug, Default)]
pub struct Resources {
    folder: PathBuf,
    meshes: HashMap<PathBuf, Arc<MeshData>>,
    bytes: u64,
    images: HashMap<(PathBuf, Option<Encoding>, Option<String>), Arc<Texels>>,
    drawn: HashMap<Drawn, Arc<Texels>>,
    texels: u64,
    /// The number of images that use the surface's own texture coordinates.
    uses_of_uv: u32,
    notes: Vec<String>,
}

impl Resources {
    /// File names are relative to `folder`.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), ..Self::default() }
    }

    /// The contents of a mesh file.
    ///
    /// # Errors
    /// [`Invalid`] of the field `file`.
    pub fn mesh(&mut self, file: &Path) -> Result<Arc<MeshData>, Invalid> {
        let path = self.folder.join(file);
        if let Some(known) = self.meshes.get(&path) {
            return Ok(Arc::clone(known));
        }
        self.take_bytes(&path).map_err(|problem| Invalid::field("file", problem))?;
        let unread =
            |e: mesh_file::MeshFileError| Invalid::field("file", with_advice(file, e.to_string()));
        let mesh = mesh_file::read(&path).map_err(unread)?;
        self.note_all(&path, &mesh.notes);
        let mesh = Arc::new(mesh);
        self.meshes.insert(path, Arc::clone(&mesh));
        Ok(mesh)
    }

    /// What was ignored or clamped in the files read so far, in sentences for the user.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    fn note_all(&mut self, path: &Path, notes: &[String]) {
        for note in notes.iter().map(|note| format!("{}: {note}", path.display())) {
            // a file may be read twice, with two encodings
            if !self.notes.contains(&note) {
                self.notes.push(note);
            }
        }
    }

    /// The number of images so far that use the surface's own texture coordinates.
    pub fn uses_of_uv(&self) -> u32 {
        self.uses_of_uv
    }

    /// Counts an image that uses them.
    pub(crate) fn use_uv(&mut self) {
        self.uses_of_uv += 1;
    }

    /// The texels of an image: of a file, or drawn.
    ///
    /// # Errors
    /// [`Invalid`] names the field, also if there are both or none.
    pub fn texels(
        &mut self,
        file: Option<&Path>,
        drawn: Option<Drawn>,
        encoding: Option<Encoding>,
        layer: Option<&str>,
    ) -> Result<Arc<Texels>, Invalid> {
        match (file, drawn) {
            (Some(file), None) => self.image(file, encoding, layer),
            (None, Some(_)) if layer.is_some() => {
                let problem = "a drawn image has no layers; leave it out";
                Err(Invalid::field("layer", problem))
            }
            (None, Some(_)) if encoding.is_some() => {
                let problem = "a drawn image is linear; the encoding of a file alone can be said";
                Err(Invalid::field("encoding", problem))
            }
            (None, Some(drawn)) => self.drawn(drawn).map_err(|e| e.inside("drawn")),
            (Some(_), Some(_)) => {
                Err(Invalid::field("drawn", "there is a `file` too; leave out one of them"))
            }
            (None, None) => Err(Invalid::new("neither `file` nor `drawn`; an image needs one")),
        }
    }

    /// The texels of an image file.
    ///
    /// # Errors
    /// [`Invalid`] of the field `file`, `encoding` or `layer`.
    fn image(
        &mut self,
        file: &Path,
        encoding: Option<Encoding>,
        layer: Option<&str>,
    ) -> Result<Arc<Texels>, Invalid> {
        let key = (self.folder.join(file), encoding, layer.map(str::to_owned));
        if let Some(known) = self.images.get(&key) {
            return Ok(Arc::clone(known));
        }
        let left = MAX_TEXELS - self.texels;
        let texels = images::read(&key.0, encoding, layer, left)
            .map_err(|e| Invalid::field(e.field, with_advice(file, e.to_string())))?;
        self.texels += u64::from(texels.width()) * u64::from(texels.height());
        self.note_all(&key.0, texels.notes());
        let texels = Arc::new(texels);
        self.images.insert(key, Arc::clone(&texels));
        Ok(texels)
    }

    /// The texels of a drawn image.
    ///
    /// # Errors
    /// [`Invalid`] if it has no texels, or too many.
    fn drawn(&mut self, drawn: Drawn) -> Result<Arc<Texels>, Invalid> {
        if let Some(known) = self.drawn.get(&drawn) {
            return Ok(Arc::clone(known));
        }
        drawn.check()?;
        self.texels += u64::from(drawn.width) * u64::from(drawn.height);
        if self.texels > MAX_TEXELS {
            let problem = format!(
                "{} texels, with the images before it, are too many; at most {MAX_TEXELS} fit",
                self.texels
            );
            return Err(Invalid::new(problem));
        }
        let texels = Arc::new(drawn.draw());
        self.drawn.insert(drawn, Arc::clone(&texels));
        Ok(texels)
    }

    /// Subtracts the size of a file from the budget. The reader reports a file whose size cannot be read.
    fn take_bytes(&mut self, path: &Path) -> Result<(), String> {
        let Ok(file) = std::fs::metadata(path) else { return Ok(()) };
        if !file.is_file() {
            return Err(format!("{}: not a file", path.display()));
        }
        self.bytes += file.len();
        if self.bytes > MAX_BYTES {
            let (path, size, all) = (path.display(), file.len(), self.bytes);
            return Err(format!(
                "{path}: {size} bytes, with the meshes before it {all}, are too many; \
                 at most {MAX_BYTES} fit"
            ));
        }
        Ok(())
    }
}

/// The problem of a file; if its name has a `\b` or `\n` in it, which is no part of a name, what to write instead.
fn with_advice(file: &Path, problem: String) -> String {
    match file.to_string_lossy().contains(char::is_control) {
        true => format!("{problem}; {BACKSLASH}"),
        false => problem,
    }
}
