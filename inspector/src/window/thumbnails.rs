//! Small pictures of the gallery's scenes, for the list of scenes.
//!
//! They are rendered, not stored: they show what the code renders now, the program needs no files, and
//! only visible thumbnails cost time. They are rendered one at a time beside the window, with few
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
use crate::platform::Slice;

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
            let mut small = None;
            self.working.start_in_slices(ctx, move |slice| {
                let small = small.get_or_insert_with(|| Small::of((entry.build)()));
                let Some(small) = small else { return Some((entry.name, None)) };
                small.is_finished(slice).then(|| (entry.name, Some(small.image.clone())))
            });
        }
        self.done.get(entry.name)?.as_ref()
    }
}

/// A scene in few pixels, as far as they are rendered.
struct Small {
    world: World,
    image: ColorImage,
    /// How many pixels are rendered, row by row.
    done: u32,
    start: Instant,
}

impl Small {
    /// None of its pixels yet; `None` if it cannot be built.
    fn of(mut scene: Scene) -> Option<Self> {
        let [width, height] = fitting([scene.image.width, scene.image.height]);
        scene.image.resize(width, height);
        scene.image.samples = 1;
        scene.image.sampler = None;
        scene.camera.stereo = None;
        if let Some(max_depth) = scene.tracer.max_depth() {
            *max_depth = MAX_DEPTH.min(*max_depth);
        }
        let world = World::build(&scene).ok()?;
        let image = ColorImage::filled(SIZE.map(|side| side as usize), Color32::TRANSPARENT);
        Some(Self { world, image, done: 0, start: Instant::now() })
    }

    /// Renders more pixels, until all are rendered or the time for it is over; whether one of these is so.
    fn is_finished(&mut self, slice: &Slice) -> bool {
        let size @ [width, height] = self.world.picture_size();
        // centred
        let [left, top] = [0, 1].map(|axis| (SIZE[axis] - size[axis]) / 2);
        let tone = self.world.image.tone();
        // not on the rayon pool, which renders the picture
        while self.done < width * height && self.start.elapsed() <= MAX_TIME {
            if slice.is_over() {
                return false;
            }
            let pixel @ [x, y] = [self.done % width, self.done / width];
            let at = [left + x, top + y].map(|along| along as usize);
            self.image[(at[0], at[1])] = color(&tone, render::pixel(&self.world, pixel));
            self.done += 1;
        }
        true
    }
}

/// The largest size of these proportions that is not larger than a thumbnail.
pub fn fitting([width, height]: [u32; 2]) -> [u32; 2] {
    let [max_width, max_height] = SIZE.map(f64::from);
    let (width, height) = (f64::from(width), f64::from(height));
    let scale = (max_width / width).min(max_height / height);
    [width, height].map(|side| ((scale * side).round() as u32).max(1))
}
