//! The files of a scene: read once, shared, and bounded together.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::images::{Drawn, listed};
use crate::invalid::{BACKSLASH, Invalid};
use crate::rgb::Rgb;
use formats::images::{self, Encoding, Texels};
use formats::meshes::{self, MeshData};

/// The most bytes in the mesh files of one scene: more would take gigabytes, because they are read
/// whole.
const MAX_BYTES: u64 = meshes::MAX_BYTES;
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

/// Where an image comes from, as a scene says it: exactly one of the first three.
#[derive(Clone, Copy, Debug)]
pub struct ImageSource<'a> {
    /// A file, relative to the scene's folder.
    pub file: Option<&'a Path>,
    /// A formula.
    pub drawn: Option<Drawn>,
    /// Rows of linear colours, from the top down.
    pub texels: Option<&'a [Vec<Rgb>]>,
    /// Of a file: what its numbers mean.
    pub encoding: Option<Encoding>,
    /// Of a file: which of its layers.
    pub layer: Option<&'a str>,
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
            |e: meshes::MeshFileError| Invalid::field("file", with_advice(file, e.to_string()));
        let mesh = meshes::read(&path).map_err(unread)?;
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

    /// The texels of an image: of a file, drawn, or listed.
    ///
    /// # Errors
    /// [`Invalid`] names the field, also if there are two or none.
    pub fn texels(&mut self, image: &ImageSource<'_>) -> Result<Arc<Texels>, Invalid> {
        let ImageSource { file, drawn, texels, encoding, layer } = *image;
        if file.is_none() {
            for (field, said) in [("layer", layer.is_some()), ("encoding", encoding.is_some())] {
                if said && (drawn.is_some() || texels.is_some()) {
                    return Err(Invalid::field(field, "only a file has one; leave it out"));
                }
            }
        }
        match (file, drawn, texels) {
            (Some(file), None, None) => self.image(file, encoding, layer),
            (None, Some(drawn), None) => self.drawn(drawn).map_err(|e| e.inside("drawn")),
            (None, None, Some(rows)) => {
                let listed = listed(rows).map_err(|e| e.inside("texels"))?;
                self.texels += u64::from(listed.width()) * u64::from(listed.height());
                Ok(Arc::new(listed))
            }
            (None, None, None) => Err(Invalid::new("needs one of `file`, `drawn` and `texels`")),
            (Some(_), ..) | (_, Some(_), _) => {
                let second = if drawn.is_some() && file.is_some() { "drawn" } else { "texels" };
                let first = if file.is_some() { "file" } else { "drawn" };
                let problem = format!("there is a `{first}` too; leave out one of them");
                Err(Invalid::field(second, problem))
            }
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

    /// Subtracts the size of a file from the budget. The reader reports a file whose size cannot be
    /// read.
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

/// The problem of a file; if its name has a `\b` or `\n` in it, which is no part of a name, what to
/// write instead.
fn with_advice(file: &Path, problem: String) -> String {
    match file.to_string_lossy().contains(char::is_control) {
        true => format!("{problem}; {BACKSLASH}"),
        false => problem,
    }
}
