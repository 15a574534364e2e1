//! Changes the fields of scenes, and says which of them pictures show.
//!
//! A golden sees a field if a small change of the field, in the golden's own scene, changes a pixel. The picture of the
//! changed scene is held against the one that the code renders of the unchanged scene, not against the stored one: where
//! these two differ, every change would seem to be seen. A field with its default value is not counted, because a program
//! that ignores the field would draw the same picture.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use rayon::prelude::*;
use toml::Table;

use golden::{Golden, GoldenError, View};

use super::changes::{changed, changes};
use super::fields::{Leaf, leaves};

/// A field is changed in at most so many places of a scene, evenly spread.
const PLACES: usize = 12;

/// Pixels are rendered in this stride, so that the first ones are spread over the picture.
const STRIDE: usize = 61;

/// The program whose goldens are examined.
pub struct Program<'a> {
    /// What it makes of a scene before it builds it: nothing, unless a law plants a mistake.
    pub reads: &'a (dyn Fn(Scene) -> Scene + Sync),
}

/// Which fields goldens say, other than by default, and which of them they see.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    /// The fields that a changed pixel shows.
    pub seen: BTreeSet<String>,
    /// The fields that were changed without any pixel that differs, and the goldens that say them.
    pub unseen: BTreeMap<String, Vec<String>>,
}

impl Program<'_> {
    /// The program as it is.
    pub const OURS: Program<'static> = Program { reads: &|scene| scene };

    /// Changes the fields of these goldens until each is seen; a field that one golden sees is not tried on others.
    pub fn controls(&self, goldens: &[Golden], folder: &Path) -> Result<Controls, GoldenError> {
        let found = Mutex::new(Controls::default());
        goldens.par_iter().try_for_each(|golden| -> Result<(), GoldenError> {
            let case = Case::of(golden, folder, self)?;
            for (field, places) in &case.fields {
                let is_known = found.lock().expect("no panic").seen.contains(field);
                if is_known {
                    continue;
                }
                let is_seen = case.sees(places);
                let mut found = found.lock().expect("no panic");
                match is_seen {
                    true => drop(found.seen.insert(field.clone())),
                    false => found.unseen.entry(field.clone()).or_default().push(golden.name()),
                }
            }
            Ok(())
        })?;
        let mut found = found.into_inner().expect("no panic");
        let Controls { seen, unseen, .. } = &mut found;
        // where a field of a kind is seen, the kind is
        let has_seen = |kind: &str| seen.iter().any(|field| is_field_of(field, kind));
        let kinds: Vec<String> = unseen.keys().filter(|kind| has_seen(kind)).cloned().collect();
        seen.extend(kinds);
        unseen.retain(|field, _| !seen.contains(field));
        unseen.values_mut().for_each(|names| names.sort());
        Ok(found)
    }
}

/// A golden's scene as data, and its picture.
struct Case<'a> {
    program: &'a Program<'a>,
    view: View,
    folder: PathBuf,
    scene: Table,
    /// By the names of the fields.
    fields: BTreeMap<String, Vec<Leaf>>,
    size: [u32; 2],
    pixels: Vec<[u32; 3]>,
}

impl<'a> Case<'a> {
    fn of(golden: &Golden, folder: &Path, program: &'a Program<'a>) -> Result<Self, GoldenError> {
        let wrong = |source| GoldenError::Scene { name: golden.name(), source: Box::new(source) };
        let (scene, source) = golden.small_scene(folder)?;
        let folder = source.map_or_else(PathBuf::new, |source| source.folder().to_owned());
        // the text is what any other program would read
        let text = groundtruth::scene::to_toml(&scene).map_err(wrong)?;
        let table: Table = text.parse().expect("what was written can be read");
        let scene = (program.reads)(scene);
        let world = World::build_seeded(&scene, &folder, DEFAULT_SEED).map_err(wrong)?;
        let size = world.picture_size();
        let all = 0..size[0] as usize * size[1] as usize;
        let pixels =
            all.into_par_iter().map(|index| stored(golden.view.pixel(&world, at(index, size))));
        let pixels = pixels.collect();
        let mut fields: BTreeMap<String, Vec<Leaf>> = BTreeMap::new();
        for leaf in leaves(&table) {
            fields.entry(leaf.field.clone()).or_default().push(leaf);
        }
        let view = golden.view;
        Ok(Self { program, view, folder, scene: table, fields, size, pixels })
    }

    /// Whether some change of a field, in some of its places, changes a pixel.
    fn sees(&self, places: &[Leaf]) -> bool {
        for leaf in spread(places) {
            for change in changes(leaf, &self.scene) {
                let changed = changed(&self.scene, &leaf.path, &change);
                // what is no scene is another program's business
                let Ok(scene) = changed.try_into::<Scene>() else { continue };
                let scene = (self.program.reads)(scene);
                let built = World::build_seeded(&scene, &self.folder, DEFAULT_SEED);
                let Ok(world) = built else { continue };
                if self.differs(&world) {
                    return true;
                }
            }
        }
        false
    }

    /// Whether some pixel differs from the picture's; ends at the first.
    fn differs(&self, world: &World) -> bool {
        if world.picture_size() != self.size {
            return true;
        }
        let count = self.pixels.len();
        let in_order =
            (0..STRIDE).into_par_iter().flat_map_iter(|first| (first..count).step_by(STRIDE));
        let differs = |index: usize| {
            stored(self.view.pixel(world, at(index, self.size))) != self.pixels[index]
        };
        in_order.find_any(|index| differs(*index)).is_some()
    }
}

/// Whether this is a field of this kind.
pub fn is_field_of(field: &str, kind: &str) -> bool {
    field.strip_prefix(kind).is_some_and(|rest| rest.starts_with('.'))
}

/// Some places, evenly spread over all.
fn spread(places: &[Leaf]) -> impl Iterator<Item = &Leaf> {
    // names are texts everywhere
    let most = if places.first().is_some_and(Leaf::is_label) { 1 } else { PLACES };
    let count = places.len().min(most);
    (0..count).map(move |index| &places[index * places.len() / count])
}

fn at(index: usize, [width, _]: [u32; 2]) -> [u32; 2] {
    let width = width as usize;
    [index % width, index / width].map(|it| u32::try_from(it).expect("inside a picture"))
}

/// The bits of a pixel as a file stores them.
fn stored(color: Rgb) -> [u32; 3] {
    let mut film = Film::new(1, 1);
    film.set([0, 0], color);
    film.to_f32().next().expect("one pixel").map(f32::to_bits)
}
