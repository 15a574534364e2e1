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
use groundtruth::shapes::Kind;

use super::leaves::Leaves;
use super::target::{ExportLanguage, Written};
use super::{AnyKind, Exported, How, Target, writer};
use ::text::xml::comment;
use materials::Look;
use paths::Paths;
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

pub(super) const LANGUAGE: ExportLanguage = ExportLanguage {
    name: "Mitsuba",
    program: "python3",
    version: &["-c", "import mitsuba; print('Mitsuba', mitsuba.__version__)"],
    missing: Some(
        "it has no module `mitsuba`: `pip install mitsuba`, or run scripts/witnesses.sh, which installs it in \
         target/mitsuba; then give that Python with --program",
    ),
    files: ["scene.xml", "scene.exr"],
    arguments: "render.py scene.xml scene.exr",
    script: Some(["render.py", include_str!("render.py")]),
    write,
    how,
    apart: |kind| match kind {
        Kind::Instance(_) => Some(How::Instance("of what it can say")),
        Kind::Compound(_) | Kind::SolidCylinder(_) => Some(How::Mesh("its parts")),
        _ => None,
    },
    is_noiseless: paths::is_noiseless,
    is_single: true,
};

fn write([name, stem]: [&str; 2], leaves: &Leaves<'_>, scene: &Scene, folder: &Path) -> Written {
    let mut writer = Writer::new(Target::Mitsuba, scene, folder, Xml { stem, ..Xml::default() });
    writer.refuse_settings();
    writer.own.paths = writer.paths(leaves);
    let (_, sensor) = writer.sensor();
    let emitters = writer.emitters();
    writer.looks(leaves);
    let head = writer.header(name);
    let parts =
        [integrator(&writer.own.paths), sensor, emitters, writer.bsdfs(), writer.shapes(leaves)];
    writer.unsupported.extend_from_slice(&leaves.unsupported);
    match writer.unsupported.is_empty() {
        true => Ok(Exported {
            text: format!("{head}{}\n</scene>\n", parts.join("\n")),
            files: writer.own.files,
        }),
        false => Err(writer.unsupported),
    }
}

/// How a kind is exported: what is written of it in this scene.
fn how(scene: &Scene, kind: &AnyKind) -> How {
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
