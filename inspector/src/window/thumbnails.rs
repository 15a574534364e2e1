//! Small pictures of the gallery's scenes, for the list of scenes.
//!
//! They are rendered, not stored: they show what the code renders now, the program needs no files, and
//! only visible thumbnails cost time. They are rendered one at a time on a separate thread, with few
//! pixels of one ray each, for a limited time.

use std::collections::HashMap;
use std::time::Duration;

use eframe::egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions};
use gallery::Entry;
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use web_time::Instant;

use crate::picture::display::color;
use crate::picture::worker::Background;

/// Width and height of a thumbnail, in pixels; the picture is centred in it.
pub const SIZE: [u32; 2] = [54, 36];
/// The largest depth of rays in a thumbnail.
const MAX_DEPTH: u32 = 4;
/// The time after which the rest of a thumbnail stays empty.
const MAX_TIME: Duration = Duration::from_millis(250);

/// The thumbnails that were asked for so far.
#[derive(Default)]
pub struct Thumbnails {
    done: HashMap<&'static str, Option<TextureHandle>>,
    working: Background<(&'static str, Option<ColorImage>)>,
}

impl Thumbnails {
    /// The thumbnail of a scene, if it is rendered. If not, starts it, unless another is under way.
    pub fn get(&mut self, ctx: &Context, entry: Entry) -> Option<&TextureHandle> {
        if let Some(Ok((name, image))) = self.working.poll() {
            let load = |image| ctx.load_texture(name, image, TextureOptions::LINEAR);
            self.done.insert(name, image.map(load));
        }
        if !self.working.is_busy() && !self.done.contains_key(entry.name) {
            // not tried again: a failed thumbnail stays empty
            self.done.insert(entry.name, None);
            self.working.start(ctx, move || (entry.name, render_small((entry.build)())));
        }
        self.done.get(entry.name)?.as_ref()
    }

    /// The number of thumbnails that were rendered.
    pub fn count(&self) -> usize {
        self.done.values().flatten().count()
    }
}

/// A scene in few pixels; `None` if it cannot be built.
fn render_small(mut scene: Scene) -> Option<ColorImage> {
    let [width, height] = fitting([scene.image.width, scene.image.height]);
    scene.image.resize(width, height);
    scene.image.samples = 1;
    scene.image.sampler = None;
    scene.camera.stereo = None;
    if let Some(max_depth) = scene.tracer.max_depth() {
        *max_depth = MAX_DEPTH.min(*max_depth);
    }
    let world = World::build(&scene).ok()?;
    let tone = world.image.tone();
    let sides = SIZE.map(|side| side as usize);
    let mut image = ColorImage::filled(sides, Color32::TRANSPARENT);
    // centred
    let [left, top] = [(SIZE[0] - width) / 2, (SIZE[1] - height) / 2];
    let start = Instant::now();
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    // not on the rayon pool, which renders the picture
    for pixel @ [x, y] in pixels {
        if start.elapsed() > MAX_TIME {
            break;
        }
        let at = [left + x, top + y].map(|along| along as usize);
        image[(at[0], at[1])] = color(&tone, render::pixel(&world, pixel));
    }
    Some(image)
}

/// The largest size of these proportions that is not larger than a thumbnail.
pub fn fitting([width, height]: [u32; 2]) -> [u32; 2] {
    let [max_width, max_height] = SIZE.map(f64::from);
    let (width, height) = (f64::from(width), f64::from(height));
    let scale = (max_width / width).min(max_height / height);
    [width, height].map(|side| ((scale * side).round() as u32).max(1))
}
