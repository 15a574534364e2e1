//! The XML of Mitsuba 3.
//!
//! Its formulas are those of its documentation ("Plugin reference"); each factor is derived where it is written. A scene
//! becomes one text, or several whose pictures are to be added: see `passes`.

mod camera;
pub mod kinds;
mod lights;
mod materials;
mod passes;
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

pub use passes::is_noiseless;
pub use render::Program;

use super::leaves::Leaves;
use super::{Said, Target, Unsayable};
use materials::Look;
use passes::Pass;
use pictures::xml::comment;
use text::{boolean, integer, plugin};

/// A scene being written.
struct Writer<'a> {
    scene: &'a Scene,
    /// The names of further files begin with this.
    stem: &'a str,
    resources: Resources,
    /// What the materials of the leaves do, by their indices.
    looks: BTreeMap<usize, Look>,
    files: Vec<(String, Vec<u8>)>,
    unsayable: Vec<Unsayable>,
}

/// The scene as XML; `name` goes into its first line.
///
/// # Errors
/// All that cannot be said.
pub fn write(name: &str, stem: &str, scene: &Scene, folder: &Path) -> Result<Said, Vec<Unsayable>> {
    let leaves = Leaves::of(scene, Target::Mitsuba);
    let mut writer = Writer {
        scene,
        stem,
        resources: Resources::new(folder),
        looks: BTreeMap::new(),
        files: Vec::new(),
        unsayable: Vec::new(),
    };
    writer.refuse_settings();
    let passes = writer.passes(&leaves);
    let sensor = writer.sensor();
    writer.refuse_lights(&passes);
    writer.looks(&leaves);
    let mut scenes = Vec::new();
    for (index, pass) in passes.iter().enumerate() {
        let head = writer.header(name, [index + 1, passes.len()]);
        let parts = [
            integrator(pass),
            sensor.clone(),
            writer.emitters(pass),
            writer.bsdfs(pass),
            writer.shapes(&leaves, pass),
        ];
        scenes.push(format!("{head}{}\n</scene>\n", parts.join("\n")));
        if index == 0 {
            writer.unsayable.extend(leaves.unsayable.iter().cloned());
        }
    }
    let mut unsayable: Vec<Unsayable> = Vec::new();
    for it in writer.unsayable {
        // each pass says it again
        if !unsayable.contains(&it) {
            unsayable.push(it);
        }
    }
    match unsayable.is_empty() {
        true => Ok(Said { scenes, files: writer.files }),
        false => Err(unsayable),
    }
}

/// Paths of at most so many edges.
fn integrator(pass: &Pass) -> String {
    let mut inner = vec![integer("max_depth", pass.edges)];
    if !pass.has_roulette {
        inner.push(integer("rr_depth", pass.edges + 1));
    }
    inner.push(boolean("hide_emitters", false));
    plugin("integrator", "path", &inner)
}

impl Writer<'_> {
    fn refuse(&mut self, path: impl Into<String>, problem: impl Into<String>) {
        self.unsayable.push(Unsayable { path: path.into(), problem: problem.into() });
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

    fn header(&self, name: &str, [index, count]: [usize; 2]) -> String {
        let about = format!("{}: {}", printable::text(name), printable::text(&self.scene.about));
        let mut lines = vec![comment(&about)];
        if count > 1 {
            lines
                .push(comment(&format!("{index} of {count}: the pictures of all are to be added")));
        }
        lines.push("<scene version=\"3.0.0\">\n".to_owned());
        lines.join("\n")
    }
}
