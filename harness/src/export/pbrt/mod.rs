//! Scene files of pbrt-v4.
//!
//! Its conventions are read from its documentation ("pbrt-v4 Input File Format") and from its source (`cameras.cpp`,
//! `film.cpp`, `lights.cpp`, `shapes.cpp`, `textures.cpp`, `cpu/integrators.cpp`); each factor is derived where it is
//! written. Points and vectors of the world are written as they are: only the camera's axes are left-handed there.
//!
//! pbrt computes with spectra. The product of two spectra has the product of their colours if one of them is grey, so each
//! path of light may meet one colour at most.

mod camera;
mod checks;
pub mod kinds;
mod lights;
mod materials;
mod meshes;
mod planes;
mod shapes;
mod text;
mod textures;

use std::collections::BTreeMap;
use std::path::Path;

use groundtruth::printable;
use groundtruth::scene::{Intersect, Scene, SceneError, Tracer};
use groundtruth::world::{DEFAULT_SEED, World};

use super::Unsayable;
use materials::Look;
use text::parameter;

/// A scene being written.
struct Writer<'a> {
    scene: &'a Scene,
    world: &'a World,
    /// Where the files that the scene names are.
    folder: &'a Path,
    text: String,
    /// The statements of plain materials.
    named: String,
    /// What the materials that objects have are in pbrt.
    looks: BTreeMap<usize, Option<Look>>,
    /// How many textures have a name.
    textures: usize,
    /// How many shapes there are so far; a triangle counts as one.
    shapes: usize,
    /// Whether something matte reflects light.
    reflects: bool,
    /// How often light is reflected if this is no path tracer.
    depth: u32,
    /// What shines here without lighting anything, or refracts, and why that cannot be said where something matte reflects.
    unlit: Vec<(String, &'static str)>,
    /// The places of lights, and of surfaces, that are not grey.
    coloured_lights: Vec<String>,
    coloured_surfaces: Vec<String>,
    unsayable: Vec<Unsayable>,
}

/// The scene as the text of a `.pbrt` file; `name` goes into its first line, and files that the scene names are in `folder`.
///
/// # Errors
/// All that cannot be said, or why the scene is not valid.
pub fn write(name: &str, scene: &Scene, folder: &Path) -> Result<String, Vec<Unsayable>> {
    let invalid =
        |e: SceneError| vec![Unsayable { path: "the scene".to_owned(), problem: e.to_string() }];
    let world = World::build_seeded(scene, folder, DEFAULT_SEED).map_err(invalid)?;
    let mut writer = Writer::new(scene, &world, folder);
    writer.refuse_settings();
    writer.header(name);
    writer.camera();
    let head = std::mem::take(&mut writer.text);
    writer.lights();
    writer.objects();
    writer.refuse_unlit();
    writer.colors_meet();
    if writer.unsayable.is_empty() {
        writer.checks();
    }
    let integrator = writer.integrator();
    let Writer { named, text, mut unsayable, .. } = writer;
    unsayable.sort_by_key(|it| section(&it.path));
    let whole = || format!("{head}{integrator}WorldBegin\n{named}{text}");
    if unsayable.is_empty() { Ok(whole()) } else { Err(unsayable) }
}

/// The place of a part of the scene among the others.
fn section(path: &str) -> Option<usize> {
    ["lights", "materials", "objects"].iter().position(|list| path.starts_with(list))
}

impl<'a> Writer<'a> {
    fn new(scene: &'a Scene, world: &'a World, folder: &'a Path) -> Self {
        Self {
            scene,
            world,
            folder,
            text: String::new(),
            named: String::new(),
            looks: BTreeMap::new(),
            textures: 0,
            shapes: 0,
            reflects: false,
            depth: 1,
            unlit: Vec::new(),
            coloured_lights: Vec::new(),
            coloured_surfaces: Vec::new(),
            unsayable: Vec::new(),
        }
    }

    fn refuse(&mut self, path: impl Into<String>, problem: impl Into<String>) {
        self.unsayable.push(Unsayable { path: path.into(), problem: problem.into() });
    }

    fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    /// Whether light that is reflected more than once counts.
    fn is_path(&self) -> bool {
        matches!(self.scene.tracer, Tracer::Path(_) | Tracer::PathTrace(_) | Tracer::GlobalTrace(_))
    }

    /// What holds for the whole scene and has no counterpart.
    fn refuse_settings(&mut self) {
        if let Tracer::GlobalTrace(_) = self.scene.tracer {
            self.refuse(
                "tracer",
                "global_trace; write path, which has the same mean and is what pbrt does",
            );
        }
        let objects = self.scene.objects.iter().filter(|object| object.enabled);
        let intersect = |it: Option<Intersect>| it.unwrap_or(self.scene.intersect);
        if objects.into_iter().any(|it| intersect(it.intersect) == Intersect::Textbook) {
            let problem = "the errors of the book's routines are not those of pbrt's; write robust";
            self.refuse("intersect", problem);
        }
    }

    /// Textures are not blurred over the width of a pixel, as ours are not.
    fn header(&mut self, name: &str) {
        self.line(&format!("# {}: {}", printable::text(name), printable::text(&self.scene.about)));
        self.line("# Linear radiance in the file pbrt.exr:  pbrt this.pbrt");
        self.line("Option \"disabletexturefiltering\" true");
        if self.is_centred() {
            self.line("Option \"disablepixeljitter\" true");
        }
    }

    /// pbrt's `path` reflects light `maxdepth` times at most, and adds light of surfaces that it meets after so many
    /// reflections: our path tracers up to `max_depth` edges, and so `whitted` where glass is all that it follows; otherwise
    /// light is reflected once.
    fn integrator(&self) -> String {
        let depth = if self.is_path() { self.followed() } else { self.depth };
        let depth = parameter("integer maxdepth", [depth.into()]);
        format!("Integrator \"path\" {depth} \"string lightsampler\" [ \"uniform\" ]\n")
    }

    /// How many edges our tracer follows.
    fn followed(&self) -> u32 {
        match self.scene.tracer {
            Tracer::RayCast => 0,
            Tracer::Whitted(it) => it.max_depth,
            Tracer::Path(it) | Tracer::PathTrace(it) | Tracer::GlobalTrace(it) => it.max_depth,
        }
    }

    /// Where something reflects, all that shines is a light in pbrt.
    fn refuse_unlit(&mut self) {
        if self.reflects {
            for (path, problem) in std::mem::take(&mut self.unlit) {
                self.refuse(path, problem);
            }
        }
    }

    /// Colours of which two meet on a path of light.
    ///
    /// pbrt turns a colour into a spectrum that has this colour under the standard illuminant. A grey is exactly constant,
    /// so its product with any spectrum has the product of the colours. The product of two spectra that are not grey has
    /// another colour.
    fn colors_meet(&mut self) {
        if self.is_path() {
            let problem = "coloured, and light is reflected more than once: pbrt is spectral, so grey or one bounce only";
            for path in std::mem::take(&mut self.coloured_surfaces) {
                self.refuse(path, problem);
            }
        } else if !self.coloured_surfaces.is_empty() {
            let problem =
                "coloured, and so are surfaces: pbrt multiplies their spectra, not their colours";
            for path in std::mem::take(&mut self.coloured_lights) {
                self.refuse(path, problem);
            }
        }
    }
}
