//! `groundtruth render`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use clap::{Args, ValueEnum};
use groundtruth::film::{self, Film, Format};
use groundtruth::printable;
use groundtruth::render::{self, Canvas, Crop, Renderer};
use groundtruth::render::{MAX_COUNTED, RaysPerSample};
use groundtruth::scene::Scene;
use groundtruth::world::World;

use super::layers::{Content, LayerArguments};
use super::mistake::{MistakeArgument, note_if_not_shown};
use super::numbers::whole;
use super::output;
use super::part::PartOf;
use super::scene::{self, SceneArguments, start_threads};
use super::{Exit, Outcome, progress, replicas};

#[derive(Args)]
pub struct Render {
    #[command(flatten)]
    scene: SceneArguments,
    /// The picture file: .png or .ppm for display, .exr or .pfm for linear radiance; .sums with
    /// --replicas. - is the standard output, with --format
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// The format of the picture, png, ppm, exr or pfm, whatever the name of the file is
    #[arg(long, value_name = "FORMAT", value_parser = output::format_named)]
    #[arg(conflicts_with = "replicas")]
    format: Option<Format>,
    /// Render R pictures with the seeds --seed, --seed + 1 …, and write their exact sums, for `merge`.
    /// An existing file of the same scene is continued
    #[arg(long, value_name = "R", value_parser = whole::<u32>(1..=u32::MAX.into()))]
    #[arg(conflicts_with_all = ["crop", "stereo", "mistake"])]
    replicas: Option<u32>,
    /// Render only the replicas of part K of N, such as 0/8; K is from 0 to N − 1
    #[arg(long, value_name = "K/N", value_parser = PartOf::parse, requires = "replicas")]
    part: Option<PartOf>,
    /// Render only a part: X,Y,WxH from the top left
    #[arg(long, value_name = "X,Y,WxH", value_parser = scene::crop)]
    crop: Option<Crop>,
    /// How the two images of a stereo pair are written; side-by-side if left out
    #[arg(long, value_enum, value_name = "HOW")]
    stereo: Option<StereoOutput>,
    #[command(flatten)]
    layer: LayerArguments,
    #[command(flatten)]
    mistake: MistakeArgument,
    /// Threads to use; all cores if left out. The picture is the same for any number
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1..=1024))]
    threads: Option<u16>,
}

/// How the two images of a stereo pair are written.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum StereoOutput {
    /// One picture: both images and the gap between them
    SideBySide,
    /// One picture for glasses with a red filter on the left eye and a cyan one on the right eye
    Anaglyph,
    /// Two pictures, -left and -right added to the name
    TwoFiles,
}

impl Render {
    pub fn run(&self) -> Outcome {
        start_threads(self.threads)?;
        let is_sums = self.output.extension().is_some_and(|end| end == "sums");
        let problem = match self.replicas {
            Some(replicas) if is_sums => {
                let part = self.part.unwrap_or_default();
                return replicas::render(&self.scene, replicas, part, &self.output);
            }
            None if !is_sums => return self.picture(),
            Some(_) => {
                "--replicas writes sums: end the name with .sums; `merge` makes a picture of them"
            }
            None => "sums need --replicas R",
        };
        Err(format!("{}: {problem}", self.output.display()).into())
    }

    fn picture(&self) -> Outcome {
        let start = Instant::now();
        let (scene, world) = self.scene.load()?;
        match self.mistake.mistaken(&self.scene, &scene)? {
            None => self.rendered(start, &scene, &world),
            Some(mistaken) => {
                note_if_not_shown(&mistaken, &self.scene, &scene)?;
                self.rendered(start, &scene, &mistaken)
            }
        }
    }

    /// Renders the picture and writes it.
    fn rendered(&self, start: Instant, scene: &Scene, renderer: &impl Renderer) -> Outcome {
        let world = renderer.world();
        let files = self.files(scene, world)?;
        let [width, height] = world.picture_size();
        let crop = self.crop.unwrap_or(Crop { x: 0, y: 0, width, height });
        scene::check_inside(crop, world)?;
        let content = self.layer.content(world, crop, (&self.output, files.format))?;
        let canvas = Arc::new(Canvas::cropped(crop));
        let notes = explain::notes(scene, world);
        notes.iter().for_each(|note| eprintln!("note: {}", printable::text(note)));
        let is_of_hits = matches!(&content, Content::One(layer) if layer.is_of_hit());
        if !is_of_hits {
            let rays = RaysPerSample::measured(world, MAX_COUNTED);
            let samples = canvas.progress().1 as f64 * f64::from(world.samples_per_pixel());
            rays.note(samples).iter().for_each(|note| eprintln!("note: {note}"));
        }
        let loaded = start.elapsed();
        let on_interrupt = Arc::clone(&canvas);
        ctrlc::set_handler(move || on_interrupt.cancel())?;
        progress::watched(
            || content.render(renderer, &canvas),
            || canvas.is_cancelled(),
            || canvas.progress(),
        );
        if canvas.is_cancelled() {
            return progress::nothing_written();
        }
        let rendered = start.elapsed() - loaded;
        let film = canvas.film();
        files.write(self, (scene, world), &content, &film)?;
        let paths: Vec<String> = files.paths.iter().map(|file| output::name(file)).collect();
        let paths = paths.join(", ");
        let (loaded, rendered) = (loaded.as_secs_f64(), rendered.as_secs_f64());
        eprintln!("{paths}: loaded in {loaded:.2} s, rendered in {rendered:.2} s");
        let legend = content.legend(&film, files.format, (scene, world));
        let transfer = || transfer(files.format, scene.image.gamma);
        eprintln!("{paths}: {}", legend.unwrap_or_else(transfer));
        Ok(Exit::Yes)
    }

    /// The files to be written; fails if one of them cannot be, or is read.
    fn files(&self, scene: &Scene, world: &World) -> Result<Files, Box<dyn Error>> {
        let pair = self.pair(world)?;
        let paths = match pair {
            StereoOutput::TwoFiles if output::is_standard(&self.output) => {
                return Err("two files cannot go to the standard output; name a file by -o".into());
            }
            StereoOutput::TwoFiles => {
                ["-left", "-right"].map(|end| named(&self.output, end)).to_vec()
            }
            _ => vec![self.output.clone()],
        };
        let format = output::format(&self.output, self.format)?;
        output::check_distinct(&paths, self.scene.files_of(scene))?;
        paths.iter().try_for_each(|file| output::writable(file))?;
        Ok(Files { pair, paths, format })
    }

    /// How a stereo pair is written; fails if the scene or the crop does not allow it.
    fn pair(&self, world: &World) -> Result<StereoOutput, &'static str> {
        match self.stereo {
            None => Ok(StereoOutput::SideBySide),
            Some(_) if world.view.stereo().is_none() => {
                Err("--stereo needs a scene whose camera has `stereo`; this one has one eye")
            }
            Some(pair) if pair != StereoOutput::SideBySide && self.crop.is_some() => Err(
                "--crop gives a part of the picture side by side; it goes with no other --stereo",
            ),
            Some(pair) => Ok(pair),
        }
    }
}

/// The files of a picture, or of the two of a stereo pair.
struct Files {
    pair: StereoOutput,
    paths: Vec<PathBuf>,
    format: Format,
}

impl Files {
    fn write(
        &self,
        render: &Render,
        (scene, world): (&Scene, &World),
        content: &Content,
        film: &Film,
    ) -> Result<(), Box<dyn Error>> {
        let films = match (self.pair, render::eye_images(world, film)) {
            (StereoOutput::Anaglyph, Some([left, right])) => vec![film::anaglyph(&left, &right)],
            (StereoOutput::TwoFiles, Some(images)) => images.to_vec(),
            _ => vec![film.clone()],
        };
        let mut made = render.scene.provenance(scene, world)?;
        made.mistake = render.mistake.name().map(str::to_owned);
        let parts = match (self.pair, render.crop) {
            (StereoOutput::TwoFiles, _) => ["left", "right"].map(|eye| Some(format!("{eye} eye"))),
            (StereoOutput::Anaglyph, _) => [Some("anaglyph".to_owned()), None],
            (StereoOutput::SideBySide, crop) => {
                [crop.map(|it| format!("crop {}", scene::crop_words(it))), None]
            }
        };
        for ((film, file), part) in films.iter().zip(&self.paths).zip(parts) {
            let parts: Vec<String> = content.part().into_iter().chain(part).collect();
            made.part = (!parts.is_empty()).then(|| parts.join(", "));
            output::write(file, &content.encode(film, self.format, (scene, world), &made)?)?;
        }
        Ok(())
    }
}

/// What the values of a picture mean, and how `compare` and `verify` know.
fn transfer(format: Format, gamma: f64) -> String {
    let (words, encoding) = match gamma {
        1.0 => ("linear, as gamma is 1".to_owned(), "linear".to_owned()),
        gamma => (format!("radiance to the power 1/{gamma}"), format!("gamma={gamma}")),
    };
    match format {
        Format::Exr | Format::Pfm => "values are linear radiance".to_owned(),
        Format::Png => format!("values are {words}; the file says so (gAMA)"),
        Format::Ppm => format!("values are {words}; compare with --encoding {encoding}"),
    }
}

/// `a-left.png` from `a.png`.
fn named(file: &Path, end: &str) -> PathBuf {
    let mut name = file.file_stem().unwrap_or_default().to_owned();
    name.push(end);
    if let Some(extension) = file.extension() {
        name.push(".");
        name.push(extension);
    }
    file.with_file_name(name)
}
