//! `groundtruth render --against`: layers that hold our picture against one of another program.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use groundtruth::film::{self, Channel, Film, Format, Provenance, Tone};
use groundtruth::printable;
use groundtruth::render::{Canvas, Crop};
use groundtruth::scene::Scene;
use groundtruth::world::World;
use judge::verdict::{self, Case, RayTolerance, Strictness, Verdict};
use layers::LayerFilms;
use pictures::compare::{Differences, Picture, Transfer};
use pictures::digits::short;

use super::scene::SceneArguments;
use super::watch::Watch;
use super::{Exit, Outcome, announce, output, progress};

/// The share of the differences that false colours show unclipped: one bright lamp must not hide the rest.
const SHOWN: f64 = 0.9;

/// The layers that need another picture.
#[derive(Clone, Copy, PartialEq)]
pub enum Wanted {
    /// Theirs less ours.
    Difference,
    /// The same in standard deviations of the noise.
    Z,
    /// Both, and all layers of our picture.
    All,
}

/// What is asked of a picture of another program.
pub struct Request<'a> {
    /// Its file.
    pub image: &'a Path,
    /// How it encodes radiance, if the user says so.
    pub encoding: Option<Transfer>,
    /// What of it.
    pub wanted: Wanted,
}

/// What was found.
#[derive(Default)]
struct Found {
    layers: Option<LayerFilms>,
    difference: Option<Differences>,
    verdict: Option<Verdict>,
}

impl Wanted {
    /// The layer of this name.
    ///
    /// # Errors
    /// It is none of these.
    pub fn named(name: &str) -> Result<Self, String> {
        match name {
            "difference" => Ok(Self::Difference),
            "z" => Ok(Self::Z),
            _ => Err(format!(
                "--against: the layer is difference or z, not {}",
                printable::name(name)
            )),
        }
    }
}

impl Request<'_> {
    /// Renders, compares, and writes the file.
    pub fn run(
        &self,
        arguments: &SceneArguments,
        (file, format): (&Path, Option<Format>),
    ) -> Outcome {
        let format = output::format(file, format)?;
        let refused = |problem: &str| Err(format!("{}: {problem}", file.display()).into());
        match (self.wanted, format) {
            (Wanted::All, Format::Png | Format::Ppm | Format::Pfm) => {
                return refused("--layers are channels of one file: end its name with .exr");
            }
            (_, Format::Pfm) => return refused(layers::NO_FILE),
            _ => {}
        }
        output::once([self.image, Path::new(arguments.name())], "input")?;
        let theirs = Picture::read(self.image, self.encoding)?;
        let name = printable::name(&self.image.display().to_string());
        theirs.notes.iter().for_each(|note| eprintln!("note: {name}: {note}"));
        if let Some(problem) =
            verdict::refusal(&theirs).filter(|_| self.wanted != Wanted::Difference)
        {
            return Err(format!("{name}: {problem}").into());
        }
        let (scene, mut world) = arguments.load_fitted(theirs.size, None, None)?;
        let inputs = arguments.files_of(&scene);
        let inputs = inputs.iter().map(PathBuf::as_path).chain([self.image]);
        output::check_distinct([file], inputs)?;
        output::writable(file)?;
        let Some(found) = self.found(arguments, (&scene, &mut world), &theirs)? else {
            return progress::nothing_written();
        };
        let mut made = arguments.provenance(&scene, &world)?;
        made.part = Some(self.part());
        output::write(file, &found.encode(&world, format, &made)?)?;
        let file = printable::name(&file.display().to_string());
        found.legends(format).iter().for_each(|legend| eprintln!("{file}: {legend}"));
        Ok(Exit::Yes)
    }

    /// What the file holds, for its head.
    fn part(&self) -> String {
        match self.wanted {
            Wanted::Difference => "layer difference".to_owned(),
            Wanted::Z => "layer z".to_owned(),
            Wanted::All => "all layers".to_owned(),
        }
    }

    /// Renders what is wanted; `None` if the user interrupted.
    fn found(
        &self,
        arguments: &SceneArguments,
        (scene, world): (&Scene, &mut World),
        theirs: &Picture,
    ) -> Result<Option<Found>, Box<dyn Error>> {
        let with_z = self.wanted != Wanted::Difference;
        let pictures = if with_z { Strictness::USUAL.most() + 1 } else { 1 };
        announce::long_rendering(
            world,
            &printable::text(arguments.name()),
            if with_z { 9 } else { 1 },
        );
        let watch = Watch::new(pictures)?;
        let mut found = Found::default();
        if self.wanted != Wanted::Z {
            let [width, height] = world.picture_size();
            let crop = Crop { x: 0, y: 0, width, height };
            let canvas = Canvas::cropped(crop);
            let films = (self.wanted == Wanted::All).then(|| LayerFilms::new(crop));
            let is_finished = watch.work(&canvas, || match &films {
                Some(films) => films.render(&*world, &canvas),
                None => canvas.render(&*world),
            });
            if !is_finished {
                return Ok(None);
            }
            let ours = Picture::of_film(&canvas.film());
            found.difference = Some(Differences::of(&ours, theirs, 0.0));
            found.layers = films;
        }
        if with_z {
            let verdict = self.verdict(arguments, (scene, world), theirs, &watch)?;
            let Some(verdict) = verdict.filter(|_| !watch.is_interrupted()) else {
                return Ok(None);
            };
            found.verdict = Some(verdict);
        }
        watch.bar.finish_and_clear();
        Ok(Some(found))
    }

    /// The verdict of `verify`; `None` if the user interrupted.
    fn verdict(
        &self,
        arguments: &SceneArguments,
        (scene, world): (&Scene, &mut World),
        theirs: &Picture,
        watch: &Watch,
    ) -> Result<Option<Verdict>, Box<dyn Error>> {
        let seed = arguments.seed();
        if let Some(problem) = verdict::refusal_of_seed(seed) {
            return Err(problem.into());
        }
        let mut case = Case {
            world,
            scene,
            folder: arguments.folder().unwrap_or(Path::new("")),
            is_interrupted: &|| watch.interrupted.load(Ordering::Relaxed),
            so_far: &|_| {},
            strictness: Strictness::USUAL,
            transfer: theirs.stated,
            tone: (scene.image.gamma, scene.image.out_of_gamut),
            seed,
            reference: None,
            tolerance: RayTolerance::DOUBLE,
        };
        Ok(case.verdict(theirs, &mut |world, canvas| watch.render(world, canvas)))
    }
}

impl Found {
    /// The bytes of the file.
    fn encode(&self, world: &World, format: Format, made: &Provenance) -> std::io::Result<Vec<u8>> {
        let size = world.picture_size();
        match (&self.layers, &self.difference, &self.verdict) {
            (Some(layers), ..) => layers.encode(world, self.channels(), made),
            _ if format == Format::Exr => film::encode_channels(size, self.channels(), "", made),
            (None, Some(difference), _) => {
                let shown = difference.film(difference.within(SHOWN));
                film::encode(&shown, &Tone::PLAIN, format, made)
            }
            (None, None, Some(verdict)) => {
                let shown: Film = verdict::map_film(&verdict.shown.z, size);
                film::encode(&shown, &Tone::PLAIN, format, made)
            }
            (None, None, None) => unreachable!("something is wanted"),
        }
    }

    /// The values, by the names of their channels.
    fn channels(&self) -> Vec<Channel> {
        let mut channels = Vec::new();
        if let Some(difference) = &self.difference {
            for (index, name) in ["R", "G", "B"].into_iter().enumerate() {
                let values = difference.values().iter().map(|value| value[index] as f32).collect();
                channels.push(Channel { name: format!("difference.{name}"), values });
            }
        }
        if let Some(verdict) = &self.verdict {
            let values = verdict.shown.z.iter().map(|&z| z as f32).collect();
            channels.push(Channel { name: "z".to_owned(), values });
        }
        channels
    }

    /// What a person must know to read the file.
    fn legends(&self, format: Format) -> Vec<String> {
        let is_exr = format == Format::Exr;
        let mut lines: Vec<String> = self
            .layers
            .iter()
            .map(|layers| format!("channels {}", layers.channels().join(", ")))
            .collect();
        if let Some(difference) = &self.difference {
            let about = "difference (theirs less ours, in linear radiance)";
            let end = short(difference.within(SHOWN));
            lines.push(match is_exr {
                true => format!("{about}: channels difference.R, difference.G, difference.B"),
                false => format!(
                    "{about}: grey is 0, white {end} and more, black −{end} and less ({:.0} % of the differences are within)",
                    100.0 * SHOWN
                ),
            });
        }
        if let Some(verdict) = &self.verdict {
            let about = "z (theirs less ours, in standard deviations of the noise)";
            let end = short(verdict::FARTHEST);
            lines.push(match is_exr {
                true => format!("{about}: channel z"),
                false => format!("{about}: grey is 0, white {end} and more, black −{end} and less"),
            });
            let excluded = verdict.shown.excluded.len();
            if excluded > 0 {
                lines.push(format!(
                    "{excluded} pixels do not count: all of ours agree there; their z is 0"
                ));
            }
            lines.push(verdict.sentence());
        }
        lines
    }
}
