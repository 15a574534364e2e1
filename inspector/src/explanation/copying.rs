//! Commands that reproduce a pixel outside the window, and the word that says they are copied.

use eframe::egui::{Context, Id, Ui};
use groundtruth::scene;
use pictures::shell::quoted;

use crate::explanation::Shown;
use crate::picture::worker::Rendering;

/// The command that explains a sample of a pixel in a terminal.
pub fn explain_command(shown: &Shown<'_>, [x, y]: [u32; 2], sample: u32) -> String {
    let rendering = shown.rendering;
    let mistake = shown.mistaken().map(|program| program.mistake().name);
    let mistake = mistake.map_or(String::new(), |name| format!(" --mistake {name}"));
    let image = &rendering.scene.image;
    let (width, height, samples) = (image.width, image.height, image.samples);
    let (name, seed) = (quoted(&rendering.source.name()), rendering.world.seed);
    let mut tracer = rendering.scene.tracer;
    let depth = tracer.max_depth().map_or(String::new(), |depth| format!(" --max-depth {depth}"));
    let tracer = format!("--tracer {}{depth}", tracer.name());
    let changed = if is_changed(rendering) { "  # the window shows a changed scene" } else { "" };
    format!(
        "groundtruth explain {name} {x} {y} --size {width}x{height} --samples {samples} \
         {tracer} --seed {seed} --sample {sample}{mistake}{changed}"
    )
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

/// Notes that something was put on the clipboard now.
pub fn set_copied(ctx: &Context) {
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
fn is_changed(rendering: &Rendering) -> bool {
    let mut read = rendering.read.clone();
    let image = &rendering.scene.image;
    read.image.resize(image.width, image.height);
    read.image.samples = image.samples;
    read.tracer = rendering.scene.tracer;
    scene::to_toml(&read).ok() != scene::to_toml(&rendering.scene).ok()
}
