//! What reproduces a pixel outside the window: commands, a page, a test; and the word that says they are copied.

use std::path::Path;
use std::sync::Arc;

use clap::ValueEnum;
use eframe::egui::{Context, Id, Ui};
use explain::PixelExplanation;
use groundtruth::world::DEFAULT_SEED;
use keep::{Kept, PixelPage, ReducedScene, SmallPicture};
use text::shell::quoted;

use crate::explanation::{Shown, Subject};
use crate::picture::worker::{Background, Rendering};
use crate::scene::source::Built;
use crate::splits::Mode;

/// A text for the clipboard that takes a while to make.
#[derive(Default)]
pub struct Making {
    /// The work on it.
    pub working: Background<Result<String, String>>,
    /// Why the last one could not be made.
    pub problem: Option<String>,
}

impl Making {
    /// Puts the text on the clipboard once it is made.
    pub fn refresh(&mut self, ctx: &Context) {
        match self.working.poll().map(Result::flatten) {
            Some(Ok(text)) => copy(ctx, text),
            Some(Err(problem)) => self.problem = Some(problem),
            None => {}
        }
    }

    /// Makes the page of a sample of a pixel, with the section of a ray.
    pub fn page(
        &mut self,
        ctx: &Context,
        shown: &Shown<'_>,
        answer: &PixelExplanation,
        (sample, ray): (u32, usize),
    ) {
        let rendering = shown.rendering;
        let command = explain_command(shown, answer.pixel, sample);
        let (built, canvas) = (rendering.built.clone(), Arc::clone(&rendering.canvas));
        let mut answer = answer.clone();
        // the page shows the first of the samples
        answer.samples.retain(|explained| explained.index == sample);
        self.working.start(ctx, move || {
            let Built { source, scene, world, .. } = &built;
            let picture = &SmallPicture::of(&canvas.film(), world.samples_per_pixel());
            let name = &*source.name();
            let (explanation, ray, command) = (&answer, Some(ray), &*command);
            Ok(PixelPage { name, scene, world, explanation, picture, ray, command }.html())
        });
    }

    /// Makes a test that a sample keeps its bits, with the scene reduced to what it needs.
    pub fn test(&mut self, ctx: &Context, rendering: &Rendering, pixel: [u32; 2], sample: u32) {
        let Built { source, scene, .. } = rendering.built.clone();
        let kept = Kept { pixel, sample: Some(sample), seed: rendering.world.seed };
        self.working.start(ctx, move || {
            let reduced = ReducedScene::of(&scene, source.folder(), kept);
            let name = source.name();
            let file = if source.entry().is_none() { &*name } else { "scene.toml" };
            Ok(reduced.map_err(|e| e.to_string())?.rust_test(&name, Path::new(file)))
        });
    }
}

/// The command that explains a sample of a pixel in a terminal.
pub fn explain_command(shown: &Shown<'_>, [x, y]: [u32; 2], sample: u32) -> String {
    let subject = shown.subject();
    if let Some(command) = subject.program.and_then(|program| program.log_command()) {
        return command.to_owned();
    }
    let mistake = subject.program.and_then(|program| program.mistake());
    let mistake = mistake.map_or(String::new(), |it| format!(" --mistake {}", it.name));
    let Built { source, scene, world, .. } = subject.built();
    let (width, height, samples) = (scene.image.width, scene.image.height, scene.image.samples);
    let (name, seed) = (quoted(&source.name()), world.seed);
    let mut tracer = scene.tracer;
    let depth = tracer.max_depth().map_or(String::new(), |depth| format!(" --max-depth {depth}"));
    let tracer = format!("--tracer {}{depth}", tracer.name());
    let changed = if is_changed(&subject) { "  # the window shows a changed scene" } else { "" };
    format!(
        "groundtruth explain {name} {x} {y} --size {width}x{height} --samples {samples} \
         {tracer} --seed {seed} --sample {sample}{mistake}{changed}"
    )
}

/// What a link to the page says after `#` to show a sample of a pixel of ours; see `Arguments::of_link`. None for a
/// scene that is not the gallery's, or was changed otherwise than a link can say.
pub fn link(rendering: &Rendering, [x, y]: [u32; 2], sample: u32, view: Mode) -> Option<String> {
    let (name, read, now) = (rendering.source.entry()?.name, &*rendering.read, &*rendering.scene);
    let subject = Subject { rendering, program: None };
    if is_changed(&subject) {
        return None;
    }
    let view = view.to_possible_value().filter(|_| view != Mode::default());
    let [size, old_size] = [now, read].map(|scene| [scene.image.width, scene.image.height]);
    let (samples, mut tracer, seed) = (now.image.samples, now.tracer, rendering.world.seed);
    let is_other_tracer = tracer != read.tracer;
    let said = [
        ("sample", (sample > 0).then(|| sample.to_string())),
        ("view", view.map(|view| view.get_name().to_owned())),
        ("size", (size != old_size).then(|| format!("{}x{}", size[0], size[1]))),
        ("samples", (samples != read.image.samples).then(|| samples.to_string())),
        ("tracer", is_other_tracer.then(|| tracer.name().to_owned())),
        ("max-depth", tracer.max_depth().filter(|_| is_other_tracer).map(|it| it.to_string())),
        ("seed", (seed != DEFAULT_SEED).then(|| seed.to_string())),
    ];
    let said = said.into_iter().filter_map(|(option, value)| Some(format!("&{option}={}", value?)));
    Some(format!("{name}&pixel={x},{y}{}", said.collect::<String>()))
}

/// The line that asks `probe` for a pixel.
pub fn probe_line(rendering: &Rendering, pixel: [u32; 2]) -> String {
    let (scene, seed) = (&*rendering.scene, rendering.world.seed);
    let question = serde_json::json!({
        "radiance": { "scene": scene, "pixel": pixel, "seed": seed, "replicas": 1 }
    });
    question.to_string()
}

/// Seconds for which "copied" is shown.
const SHOWN_SECONDS: f64 = 2.0;

/// The id under which the time of the last copy is kept.
fn copied_at() -> Id {
    Id::unique("copied at")
}

/// Puts a text on the clipboard, and notes when.
pub fn copy(ctx: &Context, text: String) {
    ctx.copy_text(text);
    let now = ctx.input(|input| input.time);
    ctx.data_mut(|data| data.insert_temp(copied_at(), now));
}

/// Shows "copied" for a short time after something was put on the clipboard.
pub fn show_copied(ui: &mut Ui) {
    let Some(at) = ui.data(|data| data.get_temp::<f64>(copied_at())) else { return };
    let left = at + SHOWN_SECONDS - ui.input(|input| input.time);
    if left > 0.0 {
        ui.weak("copied");
        ui.request_repaint_after(std::time::Duration::from_secs_f64(left));
    }
}

/// Whether something was changed in the window that the command line has no option for.
fn is_changed(subject: &Subject<'_>) -> bool {
    let Built { read, scene, .. } = subject.built();
    let mut read = (**read).clone();
    read.image.resize(scene.image.width, scene.image.height);
    read.image.samples = scene.image.samples;
    read.tracer = scene.tracer;
    scenefile::to_toml(&read).ok() != scenefile::to_toml(scene).ok()
}
