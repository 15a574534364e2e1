//! The scene of a question.

use std::fmt;
use std::path::Path;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::limits;
use groundtruth::invalid::{Invalid, Key};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use scenefile::SceneError;

/// A gallery name, a file, or the scene itself.
pub enum Source {
    Named(String),
    Inline(Box<Scene>),
}

impl<'de> Deserialize<'de> for Source {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SourceVisitor)
    }
}

struct SourceVisitor;

impl<'de> Visitor<'de> for SourceVisitor {
    type Value = Source;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a gallery name, a scene file's path, or a scene")
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<Source, E> {
        Ok(Source::Named(name.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Source, A::Error> {
        Scene::deserialize(MapAccessDeserializer::new(map)).map(|it| Source::Inline(Box::new(it)))
    }
}

/// A scene and its world.
pub struct Built {
    pub scene: Scene,
    pub world: World,
    /// Of all shapes.
    pub primitives: u64,
}

impl Source {
    /// The world of the scene after a change, with this seed.
    pub fn built(
        &self,
        seed: u64,
        change: impl FnOnce(&mut Scene) -> Result<(), Invalid>,
    ) -> Result<Built, Invalid> {
        let outer = |e: Invalid| e.inside("scene");
        let (mut scene, folder) = match self {
            Self::Inline(scene) => (Scene::clone(scene), Path::new("")),
            Self::Named(name) => named(name).map_err(outer)?,
        };
        change(&mut scene)?;
        let shapes = scene.objects.iter().map(|object| &object.shape);
        let here = |index: usize, e: Invalid| {
            let name = Some(scene.objects[index].name.clone());
            e.inside("shape").inside(Key::Item(index, name)).inside("objects")
        };
        let primitives = limits::buildable(shapes, here).map_err(outer)?;
        let world = World::build_seeded(&scene, folder, seed).map_err(outer)?;
        Ok(Built { scene, world, primitives })
    }
}

fn named(name: &str) -> Result<(Scene, &Path), Invalid> {
    if let Some(entry) = gallery::find(name) {
        return Ok(((entry.build)(), Path::new("")));
    }
    let path = Path::new(name);
    if path.extension().is_none() && !path.exists() {
        return Err(Invalid::new(gallery::unknown(name)));
    }
    let (scene, _) = scenefile::read(path).map_err(invalid)?;
    Ok((scene, path.parent().unwrap_or(Path::new(""))))
}

/// A scene's error as one of the line; a file's keeps file and line.
fn invalid(error: SceneError) -> Invalid {
    match error {
        SceneError::Invalid { location, invalid } if location.is_unknown() => invalid,
        other => Invalid::new(other.to_string()),
    }
}
