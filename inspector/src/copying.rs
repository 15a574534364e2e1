//! Commands that reproduce a pixel outside the window.

use groundtruth::scene;

use crate::worker::Rendering;

/// The command that explains a sample of a pixel in a terminal.
pub fn explain_command(rendering: &Rendering, [x, y]: [u32; 2], sample: u32) -> String {
    let image = &rendering.scene.image;
    let (width, height, samples) = (image.width, image.height, image.samples);
    let (name, seed) = (rendering.source.name(), rendering.world.seed);
    let mut tracer = rendering.scene.tracer;
    let depth = tracer.max_depth().map_or(String::new(), |depth| format!(" --max-depth {depth}"));
    let tracer = format!("--tracer {}{depth}", tracer.name());
    let changed = if is_changed(rendering) { "  # the window shows a changed scene" } else { "" };
    format!(
        "groundtruth explain {name:?} {x} {y} --size {width}x{height} --samples {samples} \
         {tracer} --seed {seed} --sample {sample}{changed}"
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

/// Whether something was changed in the window that the command line has no option for.
fn is_changed(rendering: &Rendering) -> bool {
    let mut read = rendering.read.clone();
    let image = &rendering.scene.image;
    read.image.resize(image.width, image.height);
    read.image.samples = image.samples;
    read.tracer = rendering.scene.tracer;
    scene::to_toml(&read).ok() != scene::to_toml(&rendering.scene).ok()
}
