//! The XML of Mitsuba 3.
//!
//! Its formulas are those of its documentation ("Plugin reference"); each factor is derived where it is written. A scene
//! becomes one text, and files of its meshes.

mod camera;
mod lights;
mod materials;
mod paths;
mod planes;
mod ply;
mod render;
mod shapes;
mod text;
mod textures;

use std::collections::BTreeMap;
use std::path::Path;

use groundtruth::kinds::Resources;
use groundtruth::printable;
use groundtruth::scene::{Intersect, Scene};

pub use paths::is_noiseless;
pub use render::Mitsuba;

use super::leaves::Leaves;
use super::{AnyKind, Exported, How, Target, Unsupported};
use materials::Look;
use paths::Paths;
use pictures::xml::comment;
use shapes::Placed;
use text::{boolean, integer, plugin};
use textures::Cells;

/// A scene being written.
struct Writer<'a> {
    scene: &'a Scene,
    /// The names of further files begin with this.
    stem: &'a str,
    resources: Resources,
    paths: Paths,
    /// What the materials of the leaves do, by their indices.
    looks: BTreeMap<usize, Look>,
    files: Vec<(String, Vec<u8>)>,
    unsupported: Vec<Unsupported>,
}

/// The scene as XML; `name` goes into its first line.
///
/// # Errors
/// All that cannot be said.
pub fn write(
    name: &str,
    stem: &str,
    scene: &Scene,
    folder: &Path,
) -> Result<Exported, Vec<Unsupported>> {
    let leaves = Leaves::of(scene, Target::Mitsuba);
    let mut writer = Writer::new(stem, scene, folder);
    writer.refuse_settings();
    writer.paths = writer.paths(&leaves);
    let (_, sensor) = writer.sensor();
    let emitters = writer.emitters();
    writer.looks(&leaves);
    let head = writer.header(name);
    let parts =
        [integrator(&writer.paths), sensor, emitters, writer.bsdfs(), writer.shapes(&leaves)];
    writer.unsupported.extend(leaves.unsupported);
    match writer.unsupported.is_empty() {
        true => Ok(Exported {
            text: format!("{head}{}\n</scene>\n", parts.join("\n")),
            files: writer.files,
        }),
        false => Err(writer.unsupported),
    }
}

/// How a kind is exported: what is written of it in this scene.
pub(super) fn how(scene: &Scene, kind: &AnyKind) -> How {
    let mut writer = Writer::new("", scene, "".as_ref());
    match kind {
        AnyKind::Shape(_) => {
            let leaf = &Leaves::of(scene, Target::Mitsuba).all[0];
            writer.shape(&Placed { index: 0, leaf, look: &Look::default() }).0
        }
        AnyKind::Material(it) => writer.look("", it).0,
        AnyKind::Light(it) => writer.light("", it).0,
        AnyKind::Texture(it) => Cells::of(it).0,
        AnyKind::Camera(_) => writer.sensor().0,
    }
}

/// Paths of at most so many edges.
fn integrator(paths: &Paths) -> String {
    let mut inner = vec![integer("max_depth", paths.edges)];
    if !paths.has_roulette {
        inner.push(integer("rr_depth", paths.edges + 1));
    }
    inner.push(boolean("hide_emitters", false));
    plugin("integrator", "path", &inner)
}

impl<'a> Writer<'a> {
    fn new(stem: &'a str, scene: &'a Scene, folder: &Path) -> Self {
        Self {
            scene,
            stem,
            resources: Resources::new(folder),
            paths: Paths::default(),
            looks: BTreeMap::new(),
            files: Vec::new(),
            unsupported: Vec::new(),
        }
    }

    /// Refuses a kind that has no counterpart.
    fn no_counterpart(&mut self, path: impl Into<String>, note: &'static str) -> How {
        self.refuse(path, "no counterpart");
        How::None(note)
    }

    fn refuse(&mut self, path: impl Into<String>, problem: impl Into<String>) {
        self.unsupported.push(Unsupported { path: path.into(), problem: problem.into() });
    }

    /// What holds for the whole scene and has no counterpart.
    fn refuse_settings(&mut self) {
        let objects = self.scene.objects.iter().filter(|object| object.enabled);
        let intersect = |it: Option<Intersect>| it.unwrap_or(self.scene.intersect);
        if objects.into_iter().any(|it| intersect(it.intersect) == Intersect::Textbook) {
            let problem =
                "the errors of the book's routines are not those of Mitsuba's; write robust";
            self.refuse("intersect", problem);
        }
    }

    fn header(&self, name: &str) -> String {
        let about = format!("{}: {}", printable::text(name), printable::text(&self.scene.about));
        format!("{}\n<scene version=\"3.0.0\">\n", comment(&about))
    }
}
