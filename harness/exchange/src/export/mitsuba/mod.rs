//! The XML of Mitsuba 3.
//!
//! Its formulas are those of its documentation ("Plugin reference"); each factor is derived where it is written. A scene
//! becomes one text, and files of its meshes.

mod camera;
mod lights;
mod materials;
mod paths;
mod planes;
mod shapes;
mod text;
mod textures;

use std::collections::BTreeMap;
use std::path::Path;

use groundtruth::printable;
use groundtruth::scene::Scene;

pub use paths::is_noiseless;

use super::leaves::Leaves;
use super::{AnyKind, Exported, How, Target, Unsupported, writer};
use materials::Look;
use paths::Paths;
use pictures::xml::comment;
use shapes::Placed;
use text::{boolean, integer, plugin};

/// A scene being written.
type Writer<'a> = writer::Writer<'a, Xml<'a>>;

/// What is written of it.
#[derive(Default)]
struct Xml<'a> {
    /// The names of further files begin with this.
    stem: &'a str,
    paths: Paths,
    /// What the materials of the leaves do, by their indices.
    looks: BTreeMap<usize, Look>,
    files: Vec<(String, Vec<u8>)>,
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
    let mut writer = Writer::new(Target::Mitsuba, scene, folder, Xml { stem, ..Xml::default() });
    writer.refuse_settings();
    writer.own.paths = writer.paths(&leaves);
    let (_, sensor) = writer.sensor();
    let emitters = writer.emitters();
    writer.looks(&leaves);
    let head = writer.header(name);
    let parts =
        [integrator(&writer.own.paths), sensor, emitters, writer.bsdfs(), writer.shapes(&leaves)];
    writer.unsupported.extend(leaves.unsupported);
    match writer.unsupported.is_empty() {
        true => Ok(Exported {
            text: format!("{head}{}\n</scene>\n", parts.join("\n")),
            files: writer.own.files,
        }),
        false => Err(writer.unsupported),
    }
}

/// How a kind is exported: what is written of it in this scene.
pub(super) fn how(scene: &Scene, kind: &AnyKind) -> How {
    let mut writer = Writer::new(Target::Mitsuba, scene, "".as_ref(), Xml::default());
    match kind {
        AnyKind::Shape(_) => {
            let leaf = &Leaves::of(scene, Target::Mitsuba).all[0];
            writer.shape(&Placed { index: 0, leaf, look: &Look::default() }).0
        }
        AnyKind::Material(it) => writer.look("", it).0,
        AnyKind::Light(it) => writer.light("", it).0,
        AnyKind::Texture(it) => textures::how(it),
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

impl Writer<'_> {
    fn header(&self, name: &str) -> String {
        let about = format!("{}: {}", printable::text(name), printable::text(&self.scene.about));
        format!("{}\n<scene version=\"3.0.0\">\n", comment(&about))
    }
}
