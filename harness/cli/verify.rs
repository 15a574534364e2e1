//! `groundtruth verify`.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Args;
use exchange::export::Term;
use groundtruth::printable;
use groundtruth::render::Canvas;
use groundtruth::samplers;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use judge::verdict::{
    self, Answer, Case, Decision, DifferingRegion, RayTolerance, Reference, Strictness, Verdict,
};
use pictures::compare::{Picture, Transfer};
use pictures::sums::Sums;
use text::shell::quoted;
use text::told::Told;

use super::compare::is_scene;
use super::numbers::{number, whole};
use super::scene::SceneArguments;
use super::watch::Watch;
use super::witness::{By, Witnessed};
use super::{Exit, Outcome, announce, mistakes, output, print, replicas, sets};

#[derive(Args)]
pub struct Verify {
    #[command(flatten)]
    scene: Option<SceneArguments>,
    /// The picture to be judged: PNG, JPEG, PPM, HDR, EXR or PFM; - is the standard input. Several are pictures of one
    /// program with other seeds
    #[arg(value_name = "IMAGE", required_unless_present_any = ["scenes", "by", "before"], conflicts_with = "by")]
    images: Vec<PathBuf>,
    /// Let another renderer render the scene, and judge its picture: one ray through the centre of each pixel on both
    /// sides, or 64 samples (--their-samples) if Mitsuba renders a scene with random numbers. docs/renderers.md says
    /// which scenes it can render
    #[arg(long, value_enum, value_name = "RENDERER", conflicts_with_all = ["samples", "encoding", "reference"])]
    by: Option<By>,
    /// The program of that renderer; by default it is looked for on the path. For Mitsuba: a Python that has it
    #[arg(long, value_name = "FILE", requires = "by")]
    pub(super) program: Option<PathBuf>,
    /// The seconds that one picture of that renderer may take
    #[arg(long, value_name = "SECONDS", default_value_t = 3600, requires = "by", value_parser = whole::<u32>(1..=31_536_000))]
    pub(super) time_limit: u32,
    /// Terms that both sides leave out, with commas: phong (the highlights), ambient, absorption (of media), scaling
    /// (the 1/η² of refracted radiance), smooth (interpolated normals), or unshadowed (light that passes through objects:
    /// they block it)
    #[arg(long, value_name = "TERMS", value_delimiter = ',', requires = "by")]
    pub(super) without: Vec<Term>,
    /// The samples per pixel of their picture: ours take as many
    #[arg(long, value_name = "N", value_parser = super::scene::samples(), conflicts_with = "samples")]
    pub(super) their_samples: Option<u32>,
    /// How the samples of their picture are spread, if they are alike in all pixels or ours are to be like them: regular
    /// (one sample: the centre of the pixel), hammersley, random, jittered, n_rooks, multi_jittered,
    /// correlated_multi_jittered or sobol. Ours are spread so, on lenses and lamps too
    #[arg(long, value_name = "SAMPLER", value_parser = super::scene::sampler, conflicts_with = "by")]
    their_sampler: Option<samplers::Kind>,
    /// The pictures of ours that are rendered at first; more follow while theirs is among the farthest out
    #[arg(long, value_name = "R", default_value_t = Strictness::USUAL.first as u32, value_parser = whole::<u32>(3..=u32::MAX.into()))]
    replicas: u32,
    /// The probability of calling a correct picture wrong; a wrong one is called so after 1/P − 1 of our pictures
    #[arg(long, value_name = "P", default_value_t = Strictness::USUAL.level, value_parser = number(1e-4..=0.2, "write a number from 0.0001 to 0.2, such as 0.01"))]
    pub(super) level: f64,
    /// Hold all pictures against the mean of these sums of the scene, which `render --replicas` or `merge` wrote: it
    /// shows smaller differences of a picture with little noise. Ours have other seeds
    #[arg(long, value_name = "FILE")]
    reference: Option<PathBuf>,
    /// The seconds of processor time in which causes of a difference are looked for
    #[arg(long, value_name = "SECONDS", default_value_t = 40, value_parser = whole::<u32>(0..=31_536_000))]
    search: u32,
    /// Say also whether the means of the picture and of each object are within this margin, such as 1%; the exit status is
    /// then 0 if they are, 1 if one is beyond it, and 2 if the noise is too large to tell
    #[arg(long, value_name = "M", value_parser = margin)]
    pub(super) margin: Option<f64>,
    /// Few scenes of the gallery that together show all known mistakes of a chapter, such as ch28
    #[arg(long, value_name = "CHAPTER", exclusive = true)]
    scenes: Option<String>,
    /// How PNG, JPEG and PPM files encode radiance: srgb, linear, or gamma=2.2. If left out, what a PNG file says of
    /// itself (gAMA, sRGB), else the likeliest is taken, and named
    #[arg(long, value_name = "CURVE")]
    pub(super) encoding: Option<Transfer>,
    /// Pictures of any scene by any renderer before a change, each with another seed; instead of a scene
    #[arg(long, value_name = "IMAGE", num_args = 1.., requires = "after",
        conflicts_with_all = ["scene", "images", "by", "their_samples", "their_sampler", "replicas", "reference"])]
    pub(super) before: Vec<PathBuf>,
    /// Pictures of the same scene after it, each with another seed
    #[arg(long, value_name = "IMAGE", num_args = 1.., requires = "before")]
    pub(super) after: Vec<PathBuf>,
    /// A picture with one colour for each region (object, material) of pictures before and after, to compare their means
    #[arg(long, value_name = "IMAGE", requires = "before")]
    pub(super) regions: Option<PathBuf>,
    /// Write a page with the verdict, both pictures, their difference and the map of z
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub(super) json: bool,
}

fn margin(text: &str) -> Result<f64, String> {
    let part = match text.strip_suffix('%') {
        Some(percent) => percent.trim().parse().map(|percent: f64| percent / 100.0),
        None => text.parse(),
    };
    match part {
        Ok(part) if part > 0.0 && part < 1.0 => Ok(part),
        _ => Err("write a part of the mean, such as 1% or 0.01".to_owned()),
    }
}

impl Verify {
    pub fn run(self) -> Outcome {
        if let Some(chapter) = &self.scenes {
            return print(&mistakes::of_chapter(chapter)?);
        }
        if !self.before.is_empty() {
            return self.sets();
        }
        let arguments = self.scene.as_ref().expect("only --scenes and --before go without a scene");
        let target = self.by.map(By::target);
        let witnessed = match target {
            Some(target) => self.rendered_by(target, arguments)?,
            None => Some(self.given(arguments)?),
        };
        let Some(witnessed) = witnessed else { return Ok(Exit::Unanswered) };
        let Witnessed { scene, mut world, pictures, words: witness, explained_with } = witnessed;
        output::check_distinct(&self.output, arguments.files_of(&scene))?;
        let strictness = Strictness { level: self.level, first: self.replicas as usize };
        let reference = self.reference(arguments, (&scene, &world), &pictures)?;
        let asked = arguments.seed;
        let seed = reference.as_ref().map_or(asked, |reference| reference.first_free(asked));
        if let Some(problem) = verdict::refusal_of_seed(seed) {
            return Err(problem.into());
        }
        announce::long_rendering(&world, &printable::text(arguments.name()), self.replicas);
        let watch = Watch::new(strictness.most(), self.search)?;
        let case = Case {
            is_over: &|| watch.is_over(),
            so_far: &|progress| watch.tell(progress),
            strictness,
            transfer: pictures[0].stated,
            reference: reference.as_ref(),
            tolerance: match target.is_some_and(|target| target.language().is_single) {
                true => RayTolerance::SINGLE,
                false => RayTolerance::DOUBLE,
            },
            ..Case::new(&scene, arguments.files_folder(), seed)
        };
        let renders = &mut |world: &World, canvas: &Canvas| watch.render(world, canvas);
        let verdict = case.verdict(&mut world, &pictures, renders);
        watch.bar.finish_and_clear();
        let Some(mut verdict) = verdict else {
            eprintln!("interrupted; too few pictures were rendered to say anything");
            return Ok(Exit::Interrupted);
        };
        if let Some(margin) = self.margin {
            verdict.hold_to(margin);
        }
        let explained_with = explained_with_size(arguments, &scene) + &explained_with;
        let (more, next) = advice(arguments.name(), &verdict, &explained_with);
        let details = verdict.details() + &more + &witness;
        let told = Told { verdict: verdict.sentence(), details, next };
        let image = self.images.first().map(|image| image.display().to_string());
        let image = image.as_deref().unwrap_or("another renderer");
        let about = format!("verify {image} and {}", arguments.name());
        let page = || verdict::page(&verdict, &about, &told);
        output::tell(&told, &verdict, self.json, (self.output.as_deref(), &page))?;
        Ok(if watch.is_interrupted() { Exit::Interrupted } else { exit(&verdict) })
    }

    /// The mean that pictures are held against, if there is one.
    fn reference(
        &self,
        arguments: &SceneArguments,
        (scene, world): (&Scene, &World),
        pictures: &[Picture],
    ) -> Result<Option<Reference>, Box<dyn Error>> {
        let Some(file) = &self.reference else { return Ok(None) };
        if pictures.len() > 1 {
            let problem = "it is for one picture; leave it out, or judge each by itself";
            return Err(format!("--reference: {problem}").into());
        }
        if pictures[0].step.is_some() {
            return Err(format!(
                "--reference: {} has integers, whose mean is not that of radiance; leave it out, or write EXR or PFM",
                self.images[0].display()
            )
            .into());
        }
        let sums = Sums::read(file)?;
        let scene = replicas::header(arguments, scene, world)?;
        let problem = |problem| format!("{}: {problem}", file.display());
        Ok(Some(Reference::new(&sums, &scene).map_err(problem)?))
    }

    /// Fails if a scene stands where a picture is meant.
    fn check_order(&self, scene: &str) -> Result<(), String> {
        let names = self.images.iter().map(|image| image.to_string_lossy());
        let Some(other) = names.into_iter().find(|name| is_scene(name)) else { return Ok(()) };
        let [first, second] = [scene, &other].map(quoted);
        let command = match is_scene(scene) {
            true => format!("compare {first} {second}"),
            false => format!("verify {second} {first}"),
        };
        let name = printable::name(&other);
        Err(format!("{name} is a scene, not a picture; did you mean `groundtruth {command}`?"))
    }

    /// The pictures that were given, all of one size and without values that are no numbers, and the scene at their size.
    fn given(&self, arguments: &SceneArguments) -> Result<Witnessed, Box<dyn Error>> {
        let scene = Path::new(arguments.name());
        let inputs = || self.images.iter().map(PathBuf::as_path).chain([scene]);
        output::once(inputs(), "input")?;
        self.check_order(arguments.name())?;
        output::check_distinct(&self.output, inputs().chain(self.reference.as_deref()))?;
        let mut pictures: Vec<Picture> = Vec::new();
        for file in &self.images {
            let picture = Picture::read(file, self.encoding)?;
            if let Some(problem) = verdict::refusal(&picture) {
                return Err(format!("{}: {problem}", output::name(file)).into());
            }
            pictures.push(picture);
        }
        sets::check_size((&pictures[0], &self.images[0]), (&pictures, &self.images))?;
        let why = "several pictures are of one program with other seeds";
        sets::check_seeds(&pictures, &self.images, why)?;
        let names: Vec<_> = self.images.iter().map(|file| file.to_string_lossy()).collect();
        announce::notes(names.iter().map(|name| &**name).zip(&pictures));
        let sampling = (self.their_samples, self.their_sampler.as_ref());
        let (scene, world) = arguments.load_fitted(pictures[0].size, sampling)?;
        let (words, explained_with) = (String::new(), String::new());
        Ok(Witnessed { scene, world, pictures, words, explained_with })
    }
}

/// Lines after those of the verdict, and the next step: what a picture that agrees does not say, or the commands that
/// explain the worst pixels of one that differs.
fn advice(scene: &str, verdict: &Verdict, arguments: &str) -> (String, String) {
    let mistakes = judge::mistakes::command(scene);
    let explain = |region: &DifferingRegion| {
        let [x, y] = region.worst;
        format!("groundtruth explain {} {x},{y}{arguments}", quoted(scene))
    };
    if let Some(worst) = verdict.regions.first() {
        let others = verdict.regions[1..].iter().map(|it| format!("  {}\n", explain(it)));
        let others: String = others.collect();
        let title = "why ours has these values in other pixels:\n";
        let more = if others.is_empty() { others } else { title.to_owned() + &others };
        return (more, explain(worst));
    }
    let hidden = judge::mistakes::not_shown_by(scene).unwrap_or_default().len();
    let more = match verdict.decision {
        Decision::Agrees if hidden > 0 => {
            let all = judge::mistakes::all().len();
            format!("this scene cannot show {hidden} of the {all} known mistakes\n")
        }
        Decision::Agrees if judge::mistakes::is_file(scene) => {
            let about = "it says nothing of mistakes that this scene cannot show";
            format!("{about}: {mistakes} lists them\n")
        }
        _ => String::new(),
    };
    (more, mistakes)
}

/// The exit status of a verdict; by the margin, if there is one.
fn exit(verdict: &Verdict) -> Exit {
    match (verdict.margin, verdict.decision) {
        (Some((_, Answer::Agrees)), _) | (None, Decision::Agrees) => Exit::Yes,
        (Some((_, Answer::DiffersByMore)), _) | (None, Decision::Differs) => Exit::No,
        (Some((_, Answer::CannotTell)), _) => Exit::Unanswered,
        (None, Decision::Undecided) => Exit::Interrupted,
    }
}

/// The arguments of `explain` for the scene as it was rendered; of a stereo pair, the size of each eye's image.
fn explained_with_size(arguments: &SceneArguments, scene: &Scene) -> String {
    let given = arguments.arguments();
    let given = given[1..].chunks(2).filter(|pair| !["--size", "--samples"].contains(&&*pair[0]));
    let given = given.map(|pair| format!(" {}", pair.join(" "))).collect::<String>();
    format!(" --size {}x{}{given}", scene.image.width, scene.image.height)
}
