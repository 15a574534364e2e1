//! `compare`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::slice;

use clap::Args;
use groundtruth::film::{self, Film};
use groundtruth::printable;
use groundtruth::render::{self, Canvas};
use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use judge::verdict::{self, Areas, Case, Cause, Stored, Strictness, Verdict};
use pictures::compare::{self, Comparison, Hypothesis, Picture, Transfer};
use text::shell::quoted;
use text::told::Told;

use super::numbers::number;
use super::scene::OpenedScene;
use super::watch::Watch;
use super::{Exit, Outcome, announce, output};

#[derive(Args)]
pub struct Compare {
    /// A picture file (PNG, JPEG, PPM, HDR, EXR or PFM; - is the standard input), a gallery name, or a
    /// scene file; a scene is rendered at the size of the other side
    a: String,
    /// The same. Differences are B − A; if one side is a picture and the other a scene, they are yours − ours, in either
    /// order
    b: String,
    /// How PNG, JPEG and PPM files encode radiance: srgb, linear, or gamma=2.2. If left out, what a PNG file says of
    /// itself (gAMA, sRGB), else srgb
    #[arg(long, value_name = "CURVE")]
    encoding: Option<Transfer>,
    /// The relative difference up to which channels are equal
    #[arg(long, value_name = "R", default_value_t = 0.0, value_parser = number(0.0..1.0, "write a number from 0 to 1, such as 0.01"))]
    tolerance: f64,
    /// Write a page with both pictures, their difference and its regions
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// A scene's name, and the size of its image.
type Ours<'a> = (&'a str, [u32; 2]);

/// A name is that of a scene if the gallery has it, or if it ends in `.toml`.
pub(super) fn is_scene(name: &str) -> bool {
    gallery::find(name).is_some() || Path::new(name).extension().is_some_and(|it| it == "toml")
}

/// One side of a comparison.
enum Side {
    Picture(Picture),
    Scene(Box<OpenedScene>),
}

impl Side {
    fn picture(&self) -> Option<&Picture> {
        match self {
            Self::Picture(picture) => Some(picture),
            Self::Scene(_) => None,
        }
    }
}

impl Compare {
    pub fn run(mut self) -> Outcome {
        let inputs = [&self.a, &self.b].map(Path::new);
        output::once(inputs, "input")?;
        output::check_distinct(&self.output, inputs)?;
        if is_scene(&self.b) && !is_scene(&self.a) {
            // the first is what the other is held against
            std::mem::swap(&mut self.a, &mut self.b);
        }
        let sides = [self.side(&self.a)?, self.side(&self.b)?];
        let read = sides.iter().zip([&*self.a, &*self.b]);
        let read = read.filter_map(|(side, name)| Some((name, side.picture()?)));
        let size = read.clone().next().map(|(_, picture)| picture.size);
        announce::notes(read);
        let (mut pictures, mut films, mut worlds) = (Vec::new(), Vec::new(), [None, None]);
        for ((side, name), built) in sides.into_iter().zip([&self.a, &self.b]).zip(&mut worlds) {
            match side {
                Side::Picture(picture) => pictures.push(picture),
                Side::Scene(opened) => {
                    let folder = film::folder_of(Path::new(name));
                    let named = scenefile::files(&opened.scene);
                    let named = named.iter().map(|file| folder.join(file));
                    output::check_distinct(&self.output, named)?;
                    let (scene, world) = world_of(&opened, name, size)?;
                    announce::long_rendering(&world, &printable::text(name), 1);
                    films.push(render::render(&world));
                    pictures.push(Picture::of_film(&films[films.len() - 1]));
                    *built = Some((scene, world));
                }
            }
        }
        let (mut verdict, mut note) = (None, None);
        if let (Some((scene, world)), false) = (&mut worlds[0], is_scene(&self.b)) {
            (verdict, note) = self.judged((scene, world), &films[0], &mut pictures)?;
        }
        let size = |world: &World| [world.image.width, world.image.height];
        let ours = [&*self.a, &*self.b].into_iter().zip(&worlds);
        let ours = ours.filter_map(|(name, world)| Some((name, size(&world.as_ref()?.1)))).next();
        let names = self.names();
        let both = [&pictures[0], &pictures[1]];
        let mut comparison = Comparison::named([&*names[0], &*names[1]], both, self.tolerance)?;
        comparison.notes.extend(note);
        comparison.loss = verdict.as_ref().and_then(|verdict| verdict.loss);
        let known = verdict.as_ref().map_or(&[][..], |verdict| &verdict.causes.explained_by);
        if !comparison.is_same() {
            comparison.known_mistakes = known.iter().map(Cause::to_string).collect();
            if let Some(verdict) = &verdict {
                comparison.explained_by = harmless(verdict).into_iter().collect();
            }
            self.ask_scenes(&mut comparison, &pictures, worlds);
        }
        let next = match known.first().and_then(|cause| cause.name) {
            Some(name) => format!("groundtruth mistakes {name}"),
            None => self.next(&comparison, ours),
        };
        self.tell(&comparison, ours, both, next)?;
        Ok(if comparison.is_same() || comparison.loss.is_some() { Exit::Yes } else { Exit::No })
    }

    /// Writes the page and prints what is said.
    fn tell(
        &self,
        comparison: &Comparison,
        ours: Option<Ours<'_>>,
        both: [&Picture; 2],
        next: String,
    ) -> Outcome {
        let verdict = comparison.sentence();
        let details = comparison.details() + &self.advice(comparison, ours);
        let told = Told { verdict, details, next };
        let commands = |pixel| ours.map_or(Vec::new(), |ours| self.commands(ours, pixel));
        let page = || compare::page(comparison, &told, [&*self.a, &*self.b], both, &commands);
        output::tell(&told, comparison, self.json, (self.output.as_deref(), &page))
    }

    /// What only a scene can tell: whether its film points are off by half a pixel, and whether it has noise.
    fn ask_scenes(
        &self,
        comparison: &mut Comparison,
        pictures: &[Picture],
        worlds: [Option<(Scene, World)>; 2],
    ) {
        for (index, world) in worlds.into_iter().enumerate() {
            let Some((_, mut world)) = world else { continue };
            let ours = if index == 0 { &self.a } else { &self.b };
            let theirs = &comparison.names[1 - index];
            if comparison.explained_by.is_empty() && comparison.known_mistakes.is_empty() {
                let found = compare::half_pixel_shifts(&mut world, &pictures[1 - index], theirs);
                comparison.explained_by = found;
            }
            if index == 0 {
                let Areas { objects, object_of, .. } = Areas::of(&world);
                comparison.find_object((&objects, &object_of), [&pictures[0], &pictures[1]]);
            }
            comparison.notes.extend(compare::noise_note(&mut world, comparison, ours));
        }
    }

    /// How the picture stores its values, by which it is read and our colours above 1 are mapped; and if the scene has no
    /// noise and the picture is not ours, why.
    fn judged(
        &self,
        (scene, world): (&Scene, &mut World),
        film: &Film,
        pictures: &mut [Picture],
    ) -> Result<(Option<Verdict>, Option<String>), Box<dyn Error>> {
        let (stated, tone) = (pictures[1].stated, (scene.image.gamma, scene.image.out_of_gamut));
        let candidates = Stored::candidates(&pictures[1], stated, tone);
        let mut stored = verdict::plausible(&candidates, &pictures[1], slice::from_ref(film))[0];
        let (mut judged, mut note) = (None, None);
        if !compare::has_noise(world) && verdict::refusal(&pictures[1]).is_none() {
            let watch = Watch::new(Strictness::USUAL.first, 40)?;
            let case = Case {
                is_over: &|| watch.is_over(),
                so_far: &|progress| watch.tell(progress),
                strictness: Strictness { first: 3, ..Strictness::USUAL },
                transfer: stated,
                ..Case::new(scene, film::folder_of(Path::new(&self.a)), DEFAULT_SEED)
            };
            let renders = &mut |world: &World, canvas: &Canvas| watch.render(world, canvas);
            judged = case.verdict(world, &pictures[1..], renders);
            watch.bar.finish_and_clear();
            stored = judged.as_ref().map_or(stored, |verdict| verdict.stored);
        }
        pictures[0] = Picture::of_film(&stored.mapped(film));
        if let (Some(transfer), None) = (stored.transfer(), stated) {
            note = Some(format!("yours is read as {stored}; nothing says so (--encoding)"));
            pictures[1].transfer = transfer;
        }
        Ok((judged, note))
    }

    /// What the sides are called: `ours` and `yours`, if one is a scene, else as they were given.
    fn names(&self) -> [String; 2] {
        match [&self.a, &self.b].map(|name| is_scene(name)) {
            [true, false] => ["ours", "yours"].map(str::to_owned),
            _ => [&self.a, &self.b].map(|name| printable::text(name).to_string()),
        }
    }

    fn side(&self, name: &str) -> Result<Side, Box<dyn Error>> {
        let path = Path::new(name);
        let is_nothing = path.extension().is_none() && !path.exists() && !output::is_standard(path);
        Ok(match is_scene(name) || is_nothing {
            true => Side::Scene(Box::new(OpenedScene::of(name)?)),
            false => Side::Picture(Picture::read(path, self.encoding)?),
        })
    }

    /// The commands that explain a pixel of a scene whose image (of a stereo pair: each eye's) has this size.
    fn commands(&self, (scene, [width, height]): Ours<'_>, [x, y]: [u32; 2]) -> Vec<String> {
        let explain =
            format!("groundtruth explain {} {x},{y} --size {width}x{height}", quoted(scene));
        let inspect = self.window(scene).map(|window| format!("{window} --pixel {x},{y}"));
        std::iter::once(explain).chain(inspect).collect()
    }

    /// The command that shows a scene and the picture of the other side in the window.
    fn window(&self, scene: &str) -> Option<String> {
        let file = if self.a == scene { &self.b } else { &self.a };
        let encoding = Transfer::option(self.encoding);
        let (scene, picture) = (quoted(scene), quoted(file));
        (!is_scene(file)).then(|| format!("inspector {scene} --compare {picture}{encoding}"))
    }

    /// The next step: the noise of a picture that differs from a scene's is judged, or the worst pixel explained if its
    /// shape is not that of the scene; of two files, a page shows where.
    fn next(&self, comparison: &Comparison, ours: Option<Ours<'_>>) -> String {
        let [a, b] = [&self.a, &self.b].map(|name| quoted(name));
        let curve = Transfer::option(self.encoding);
        let is_picture = !is_scene(&self.b);
        match (ours, &comparison.worst) {
            (Some((scene, _)), None) => judge::mistakes::command(scene),
            (Some((scene, _)), Some(_)) if is_picture && has_shape(scene, comparison.size) => {
                format!("groundtruth verify {} {b}{curve}", quoted(scene))
            }
            (Some(ours), Some(worst)) => self.commands(ours, worst.worst).swap_remove(0),
            (None, Some(_)) if self.output.is_none() => {
                format!("groundtruth compare {a} {b}{curve} -o compare.html")
            }
            (None, _) => format!("groundtruth verify --before {a} --after {b}{curve}"),
        }
    }

    /// The commands for the worst pixel of each region, and the window.
    fn advice(&self, comparison: &Comparison, ours: Option<Ours<'_>>) -> String {
        let Some(ours) = ours.filter(|_| !comparison.is_same()) else { return String::new() };
        let explain = |region: &compare::Region| self.commands(ours, region.worst).swap_remove(0);
        let commands: Vec<String> = comparison.listed().map(explain).collect();
        let window = self.window(ours.0).map(|window| format!("to look: {window}\n"));
        format!(
            "why ours has these values in the worst pixels:\n  {}\n{}",
            commands.join("\n  "),
            window.unwrap_or_default()
        )
    }
}

/// What changes all pixels and explains the picture.
fn harmless(verdict: &Verdict) -> Option<Hypothesis> {
    let explained = verdict.explained.as_ref().filter(|it| it.agrees)?;
    Some(Hypothesis { what: explained.what.replace("theirs", "yours"), left: 0.0 })
}

/// Whether a size has the shape of the scene of this name; `false` if that cannot be said.
fn has_shape(name: &str, size: [u32; 2]) -> bool {
    let opened = OpenedScene::of(name);
    opened.is_ok_and(|mut it| matches!(compare::fit(&mut it.scene, size), Ok(true)))
}

/// The scene at this size, and built.
fn world_of(
    opened: &OpenedScene,
    name: &str,
    size: Option<[u32; 2]>,
) -> Result<(Scene, World), Box<dyn Error>> {
    let mut scene = opened.scene.clone();
    if let Some(size) = size {
        let [w, h] = [scene.image.width, scene.image.height];
        if !compare::fit(&mut scene, size)? {
            let (name, why) = (printable::name(name), "as with `render --size`");
            eprintln!("note: {name} has the shape of {w} × {h}; {why}, its width is kept");
        }
    }
    let world = opened.world(&scene, DEFAULT_SEED)?;
    Ok((scene, world))
}
