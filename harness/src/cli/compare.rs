//! `compare`.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Args;
use groundtruth::film;
use groundtruth::gallery;
use groundtruth::render;
use groundtruth::scene::{self, Scene};
use groundtruth::world::{DEFAULT_SEED, World};
use harness::compare::{self, Comparison, Picture, Transfer};

use super::{Exit, Outcome, print};

#[derive(Args)]
pub struct Compare {
    /// A picture file (PNG, JPEG, PPM, HDR, EXR or PFM), a gallery name, or a scene file; a scene is
    /// rendered at the size of the other side
    a: String,
    /// The same
    b: String,
    /// How PNG, JPEG and PPM files encode radiance: srgb, linear, or gamma=2.2
    #[arg(long, value_name = "CURVE", default_value = "srgb")]
    encoding: Transfer,
    /// The relative difference up to which channels are equal
    #[arg(long, value_name = "R", default_value_t = 0.0, value_parser = tolerance)]
    tolerance: f64,
    /// Write a page with both pictures, their difference and its regions
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(r) if (0.0..1.0).contains(&r) => Ok(r),
        _ => Err("write a number from 0 to 1, such as 0.01".to_owned()),
    }
}

/// One side of a comparison.
enum Side {
    Picture(Picture),
    Scene(Box<Scene>, Option<scene::Source>),
}

impl Compare {
    pub fn run(self) -> Outcome {
        let sides = [self.side(&self.a)?, self.side(&self.b)?];
        let size = sides.iter().find_map(|side| match side {
            Side::Picture(picture) => Some(picture.size),
            Side::Scene(..) => None,
        });
        let (mut pictures, mut worlds) = (Vec::new(), [None, None]);
        for ((side, name), built) in sides.into_iter().zip([&self.a, &self.b]).zip(&mut worlds) {
            match side {
                Side::Picture(picture) => {
                    picture.notes.iter().for_each(|note| eprintln!("note: {name}: {note}"));
                    pictures.push(picture);
                }
                Side::Scene(scene, source) => {
                    let world = world_of(*scene, source, name, size)?;
                    pictures.push(Picture::of_film(&render::render(&world)));
                    *built = Some(world);
                }
            }
        }
        let mut comparison = Comparison::of(&pictures[0], &pictures[1], self.tolerance)?;
        if !comparison.is_same() {
            self.ask_scenes(&mut comparison, &pictures, worlds);
        }
        if let Some(file) = &self.output {
            let commands = |pixel| self.commands(comparison.size, pixel);
            let (names, both) = ([&*self.a, &*self.b], [&pictures[0], &pictures[1]]);
            let html = compare::page(&comparison, names, both, &commands);
            film::replace(file, html.as_bytes()).map_err(|e| format!("{}: {e}", file.display()))?;
        }
        match self.json {
            true => print(&(serde_json::to_string_pretty(&comparison)? + "\n"))?,
            false => print(&(comparison.to_string() + &self.advice(&comparison)))?,
        };
        Ok(if comparison.is_same() { Exit::Yes } else { Exit::No })
    }

    /// What only a scene can tell: whether its film points are off by half a pixel, and whether it has noise.
    fn ask_scenes(
        &self,
        comparison: &mut Comparison,
        pictures: &[Picture],
        worlds: [Option<World>; 2],
    ) {
        for (index, world) in worlds.into_iter().enumerate() {
            let Some(mut world) = world else { continue };
            let [ours, theirs] = if index == 0 { [&self.a, "B"] } else { [&self.b, "A"] };
            if comparison.explained_by.is_empty() {
                let found = compare::half_pixel_shifts(&mut world, &pictures[1 - index], theirs);
                comparison.explained_by = found;
            }
            comparison.notes.extend(compare::noise_note(&mut world, comparison, ours));
        }
    }

    /// A name is that of a scene if the gallery has it, or if it ends in `.toml`.
    fn side(&self, name: &str) -> Result<Side, Box<dyn Error>> {
        let path = Path::new(name);
        if let Some(entry) = gallery::find(name) {
            return Ok(Side::Scene(Box::new((entry.build)()), None));
        }
        if path.extension().is_some_and(|extension| extension == "toml") {
            let (scene, source) = scene::open(path)?;
            return Ok(Side::Scene(Box::new(scene), Some(source)));
        }
        if path.extension().is_none() && !path.exists() {
            return Err(gallery::unknown(name).into());
        }
        Ok(Side::Picture(Picture::read(path, self.encoding)?))
    }

    /// The commands that explain a pixel, if a side is a scene.
    fn commands(&self, [width, height]: [u32; 2], [x, y]: [u32; 2]) -> Vec<String> {
        let is_scene = |name: &&String| gallery::find(name).is_some() || name.ends_with(".toml");
        let scene = [&self.a, &self.b].into_iter().find(is_scene);
        let explain =
            |scene| format!("groundtruth explain {scene} {x} {y} --size {width}x{height}");
        scene.map(explain).into_iter().collect()
    }

    /// The commands for the worst pixel of each region.
    fn advice(&self, comparison: &Comparison) -> String {
        let of_region = |region: &compare::Region| self.commands(comparison.size, region.worst);
        let commands: Vec<String> = comparison.listed().flat_map(of_region).collect();
        if commands.is_empty() {
            return String::new();
        }
        format!("why ours is so:\n  {}\n", commands.join("\n  "))
    }
}

/// The scene, built at this size.
fn world_of(
    mut scene: Scene,
    source: Option<scene::Source>,
    name: &str,
    size: Option<[u32; 2]>,
) -> Result<World, Box<dyn Error>> {
    if let Some([width, height]) = size {
        let [w, h] = [scene.image.width, scene.image.height].map(u64::from);
        // a size is rounded to whole pixels
        if (w * u64::from(height)).abs_diff(h * u64::from(width)) > w.max(h) {
            eprintln!(
                "note: {name} has the shape of {w} × {h}; as with `render --size`, its width is kept"
            );
        }
        scene.image.resize(width, height);
    }
    Ok(match &source {
        Some(source) => World::of_source(&scene, source, DEFAULT_SEED)?,
        None => World::build_seeded(&scene, Path::new(""), DEFAULT_SEED)?,
    })
}
