//! `groundtruth bounds`.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use clap::Args;
use exchange::framing;
use groundtruth::math::Aabb;
use groundtruth::printable;

use super::scene::SceneArguments;
use super::{Outcome, print};

#[derive(Args)]
pub struct Bounds {
    /// A gallery name, a scene file, or a mesh file (.ply or .obj)
    #[arg(value_name = "SCENE")]
    scene: String,
}

impl Bounds {
    pub fn run(&self) -> Outcome {
        let path = Path::new(&self.scene);
        let end = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        if end == "ply" || end == "obj" {
            let (scene, world) = framing::scene_of_mesh(path)?;
            let mut text = String::new();
            let name = printable::name(&self.scene);
            for object in world.objects() {
                writeln!(text, "# {name}: {}", words(&object.shape.bounds()))?;
            }
            return print(&(text + "\n" + &scenefile::to_toml(&scene)?));
        }
        let (scene, world) = SceneArguments::of_name(&self.scene).load()?;
        let mut text = "# the box around each object\n".to_owned();
        for object in world.objects() {
            let (name, bounds) = (printable::name(&object.name), words(&object.shape.bounds()));
            writeln!(text, "#   \"{name}\": {bounds}")?;
        }
        let Some(all) = framing::bounds(&world) else {
            return print(&(text + "# no object has an end: every camera sees a part only\n"));
        };
        writeln!(text, "# all that end: {}\n", words(&all))?;
        text += "# a camera that sees all that end, in the direction of the scene's camera\n";
        let camera = BTreeMap::from([("camera", framing::camera(&scene, &all))]);
        print(&(text + &toml::to_string(&camera)?))
    }
}

/// `from [-1, 0, -1] to [1, 2, 1]`.
fn words(bounds: &Aabb) -> String {
    match bounds.is_bounded() {
        true => format!("from {:?} to {:?}", bounds.min.to_array(), bounds.max.to_array()),
        false => "has no end".to_owned(),
    }
}
