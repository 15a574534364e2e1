//! Golden images: small pictures that were looked at once and are compared ever since.
//!
//! `goldens/manifest.toml` says what each one shows and why it was accepted. The EXR beside it is the
//! truth; the PNG is for viewing. The digest in the manifest detects an image that does not belong to it.

pub mod compare;
mod entry;
mod error;
pub mod journal;
pub mod review;
mod view;

use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use groundtruth::film::{self, Film, ImageError};
use scenefile::SceneError;

pub use entry::{Golden, leaf};
pub use error::GoldenError;
pub use view::View;

/// SHA-256, as hexadecimal digits, of width and height (32 bits each) and the channels in single
/// precision, all little-endian.
pub fn digest(film: &Film) -> String {
    let mut hash = Sha256::new();
    hash.update(film.width().to_le_bytes());
    hash.update(film.height().to_le_bytes());
    for channel in film.to_f32().flatten() {
        hash.update(channel.to_le_bytes());
    }
    hash.finalize().iter().fold(String::new(), |mut hex, byte| {
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}

/// The result of a check.
#[derive(Clone, Debug, PartialEq)]
pub enum GoldenStatus {
    /// The same bits.
    Same,
    /// Every channel of every pixel is within [`compare::DRIFT`], as after a change of the order of sums.
    Drift,
    /// A different picture.
    Changed,
    /// The manifest has no such golden, or its image is missing.
    Missing,
    /// The image is not the one whose digest the manifest keeps.
    Mismatch,
    /// The gallery has no such scene, or its file is gone.
    NoScene,
}

/// A golden checked.
#[derive(Clone, Debug)]
pub struct GoldenFinding {
    /// The golden's name.
    pub name: String,
    /// The folder of the goldens, as it was named.
    pub folder: PathBuf,
    /// The result.
    pub status: GoldenStatus,
    /// The golden, if the manifest has it.
    pub golden: Option<Golden>,
    /// The accepted picture, if it could be read.
    pub expected: Option<Film>,
    /// The picture that the code renders now.
    pub got: Option<Film>,
}

impl GoldenFinding {
    /// The path of the scene file; `None` for a scene of the gallery.
    pub fn scene_file(&self) -> Option<PathBuf> {
        self.golden.as_ref()?.scene_file(&self.folder)
    }

    /// The scene file as it was accepted and as it is, if they differ.
    pub fn changed_file(&self) -> Option<[String; 2]> {
        let copy = self.folder.join(format!("{}.{COPY}", self.name));
        let [was, is] = [copy, self.scene_file()?].map(std::fs::read_to_string);
        Some([was.ok()?, is.ok()?]).filter(|[was, is]| was != is)
    }
}

#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Manifest {
    #[serde(default)]
    golden: Vec<Golden>,
}

/// The folder of golden images.
#[derive(Clone, Debug)]
pub struct Goldens {
    folder: PathBuf,
    all: Vec<Golden>,
    finished: bool,
}

/// A picture that would be accepted.
#[derive(Clone, Debug)]
pub struct Proposal {
    /// What the manifest will say.
    pub golden: Golden,
    /// The picture.
    pub film: Film,
}

/// Settings of a new golden. Those left out stay as they were, or take their defaults.
#[derive(Clone, Debug, Default)]
pub struct GoldenSettings {
    /// Width and height in pixels; 96 pixels wide in the form of the scene.
    pub size: Option<[u32; 2]>,
    /// Samples for each pixel; 4, or 1 where the scene has 1 and for views other than radiance.
    pub samples: Option<u32>,
    /// What to look for; the scene's own line.
    pub shows: Option<String>,
}

const MANIFEST: &str = "manifest.toml";

/// The extension of the copy of a scene file, as it was accepted.
const COPY: &str = "txt";

/// The extensions of the files of a golden.
const EXTENSIONS: [&str; 3] = ["exr", "png", COPY];

const HEADER: &str = "\
# Golden images: `groundtruth goldens check`, `review` and `accept NAME --because \"…\"`.
# digest: SHA-256 of width, height and the linear pixels (f32, little-endian); the EXR file beside
# is the truth, the PNG file is for eyes.

";

impl Goldens {
    /// Reads the manifest of a folder. If an earlier run was stopped while it accepted pictures, finishes
    /// that first.
    ///
    /// # Errors
    /// [`GoldenError::File`] and [`GoldenError::Manifest`].
    pub fn open(folder: &Path) -> Result<Self, GoldenError> {
        let unfinished = |source| GoldenError::File { path: folder.to_owned(), source };
        let mut finished = false;
        if journal::waits(folder) {
            // the other run may be at work still
            let _lock = journal::lock(folder).map_err(unfinished)?;
            finished = journal::finish(folder).map_err(unfinished)?;
        }
        Ok(Self { folder: folder.to_owned(), all: Self::read(folder)?, finished })
    }

    /// The goldens of the manifest of a folder.
    fn read(folder: &Path) -> Result<Vec<Golden>, GoldenError> {
        let path = folder.join(MANIFEST);
        let text = std::fs::read_to_string(&path).map_err(|source| match source.kind() {
            std::io::ErrorKind::NotFound => GoldenError::NoManifest { path: path.clone() },
            _ => GoldenError::File { path: path.clone(), source },
        })?;
        let wrong = |problem| GoldenError::Manifest { path: path.clone(), problem };
        let manifest: Manifest = toml::from_str(&text).map_err(|e| wrong(e.to_string()))?;
        let mut names = std::collections::BTreeSet::new();
        for golden in &manifest.golden {
            let name = golden.name();
            if golden.because.trim().is_empty() {
                return Err(wrong(format!("{name} does not say why it was accepted (`because`)")));
            }
            if !names.insert(name.clone()) {
                return Err(wrong(format!("{name} is there twice")));
            }
        }
        Ok(manifest.golden)
    }

    /// Whether the folder has no manifest, and no new manifest waiting to be moved there.
    pub fn is_none(folder: &Path) -> bool {
        !journal::waits(folder) && matches!(folder.join(MANIFEST).try_exists(), Ok(false))
    }

    /// No goldens, in an empty folder. Nothing is written until a picture is accepted.
    pub fn none(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), all: Vec::new(), finished: false }
    }

    /// The folder, as it was named.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Whether opening finished an earlier run that was stopped.
    pub fn was_finished(&self) -> bool {
        self.finished
    }

    /// The goldens of the manifest, in its order.
    pub fn all(&self) -> &[Golden] {
        &self.all
    }

    /// The golden of this name.
    pub fn find(&self, name: &str) -> Option<&Golden> {
        self.all.iter().find(|golden| golden.name() == name)
    }

    /// The names of all goldens: those of the manifest, and each scene of the gallery, which may have none.
    pub fn names(&self) -> Vec<String> {
        let mut names: Vec<String> = self.all.iter().map(Golden::name).collect();
        names.extend(gallery::scenes().map(|entry| entry.name.to_owned()));
        names.sort();
        names.dedup();
        names
    }

    /// The file of a golden's picture with this extension.
    pub fn file(&self, name: &str, extension: &str) -> PathBuf {
        self.folder.join(format!("{name}.{extension}"))
    }

    /// Renders a golden and compares it.
    ///
    /// # Errors
    /// [`GoldenError`] if they cannot be compared: a scene that does not build, a damaged file.
    pub fn check(&self, name: &str) -> Result<GoldenFinding, GoldenError> {
        let golden = self.find(name).cloned();
        let (owned, folder) = (name.to_owned(), self.folder.clone());
        let alone = |status| {
            let (name, golden, expected, got) = (owned.clone(), golden.clone(), None, None);
            Ok(GoldenFinding { name, folder: folder.clone(), status, golden, expected, got })
        };
        let Some(known) = &golden else {
            let in_gallery = entry::in_gallery(name).is_some();
            return alone(if in_gallery { GoldenStatus::Missing } else { GoldenStatus::NoScene });
        };
        let got = match known.render(&self.folder) {
            Err(GoldenError::NoScene(_)) => return alone(GoldenStatus::NoScene),
            Err(GoldenError::Scene { source, .. })
                if matches!(*source, SceneError::Unreadable { .. }) =>
            {
                return alone(GoldenStatus::NoScene);
            }
            other => other?,
        };
        let image = self.file(name, "exr");
        let expected = match image.try_exists() {
            Ok(false) => None,
            _ => Some(film::read_exr(&image)?),
        };
        let status = match &expected {
            None => GoldenStatus::Missing,
            Some(expected) if digest(expected) != known.digest => GoldenStatus::Mismatch,
            Some(expected) => compare::verdict(expected, &got),
        };
        Ok(GoldenFinding { name: owned, folder, status, golden, expected, got: Some(got) })
    }

    /// Renders a picture to be accepted under this name, for this reason. The name may be the path of a scene file:
    /// then the golden has the name of that file.
    ///
    /// # Errors
    /// [`GoldenError::NoReason`], [`GoldenError::NoScene`], [`GoldenError::OtherFile`] and [`GoldenError::Scene`].
    pub fn propose(
        &self,
        name: &str,
        because: &str,
        settings: &GoldenSettings,
    ) -> Result<Proposal, GoldenError> {
        if because.trim().is_empty() {
            return Err(GoldenError::NoReason);
        }
        let mut golden = match self.find(entry::leaf(name)) {
            Some(known) => known.same_file(name, &self.folder)?,
            None => Golden::first_version(name, &self.folder)?,
        };
        golden.size = settings.size.unwrap_or(golden.size);
        golden.samples = settings.samples.unwrap_or(golden.samples);
        golden.shows = settings.shows.clone().unwrap_or(golden.shows);
        golden.because = because.trim().to_owned();
        let film = golden.render(&self.folder)?;
        golden.digest = digest(&film);
        Ok(Proposal { golden, film })
    }

    /// Accepts the proposed pictures: all of them, or none. What another run accepted meanwhile stays, and
    /// one that is about to is waited for. If the machine stops meanwhile, the next
    /// [`Goldens::open`] finishes, or finds the goldens as they were.
    ///
    /// # Errors
    /// [`GoldenError::File`] and [`GoldenError::Image`].
    pub fn accept(&mut self, proposals: Vec<Proposal>) -> Result<(), GoldenError> {
        self.change(proposals, &[])
    }

    /// Removes goldens of these names from the manifest, then their files. The scenes stay.
    ///
    /// # Errors
    /// As [`Self::accept`].
    pub fn remove(&mut self, names: &[String]) -> Result<(), GoldenError> {
        self.change(Vec::new(), names)?;
        for (name, extension) in names.iter().flat_map(|name| EXTENSIONS.map(|it| (name, it))) {
            match std::fs::remove_file(self.file(name, extension)) {
                Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                    return Err(self.unwritten(error));
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Accepts these pictures, and removes goldens of these names from the manifest.
    fn change(&mut self, proposals: Vec<Proposal>, removed: &[String]) -> Result<(), GoldenError> {
        std::fs::create_dir_all(&self.folder).map_err(|e| self.unwritten(e))?;
        let _lock = journal::lock(&self.folder).map_err(|e| self.unwritten(e))?;
        journal::finish(&self.folder).map_err(|e| self.unwritten(e))?;
        if !Self::is_none(&self.folder) {
            self.all = Self::read(&self.folder)?;
        }
        self.all.retain(|golden| !removed.contains(&golden.name()));
        let all = self.decide(proposals)?;
        journal::finish(&self.folder).map_err(|e| self.unwritten(e))?;
        self.all = all;
        Ok(())
    }

    /// Writes pictures and manifest to temporary files, so that only moving them remains.
    ///
    /// # Errors
    /// As [`Self::accept`].
    pub fn decide(&self, proposals: Vec<Proposal>) -> Result<Vec<Golden>, GoldenError> {
        journal::clear(&self.folder).map_err(|e| self.unwritten(e))?;
        let staged = journal::stage(&self.folder).map_err(|e| self.unwritten(e))?;

        let mut all = self.all.clone();
        for Proposal { golden, film } in proposals {
            let name = golden.name();
            let (scene, _) = golden.small_scene(&self.folder)?;
            let file = golden.scene_file(&self.folder).map(std::fs::read);
            let file = file.transpose().map_err(|e| self.unwritten(e))?;
            let tone = golden.view.tone(&scene);
            let shown = golden.view.for_eyes(&film);
            for (extension, film) in [("exr", &film), ("png", &shown)] {
                let path = staged.path().join(format!("{name}.{extension}"));
                std::fs::create_dir_all(film::folder_of(&path)).map_err(|e| self.unwritten(e))?;
                // without the name of the temporary folder
                film::write(film, &tone, &path).map_err(|error| match error {
                    ImageError::Unwritable { source, .. } => self.unwritten(source),
                    other => other.into(),
                })?;
            }
            if let Some(file) = file {
                let copy = staged.path().join(format!("{name}.{COPY}"));
                film::replace(&copy, &file).map_err(|e| self.unwritten(e))?;
            }
            all.retain(|other| other.name() != name);
            all.push(golden);
        }
        all.sort_by_key(Golden::name);
        let text = toml::to_string(&Manifest { golden: all.clone() }).map_err(|e| {
            GoldenError::Manifest { path: self.folder.join(MANIFEST), problem: e.to_string() }
        })?;
        film::replace(&staged.path().join(MANIFEST), (HEADER.to_owned() + &text).as_bytes())
            .and_then(|()| journal::decide(&self.folder, staged))
            .map_err(|e| self.unwritten(e))?;
        Ok(all)
    }

    fn unwritten(&self, source: std::io::Error) -> GoldenError {
        GoldenError::File { path: self.folder.clone(), source }
    }
}
