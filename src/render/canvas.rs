//! Pictures that grow while others look at them.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use rayon::prelude::*;

use super::{Renderer, expose};
use crate::film::Film;
use crate::rgb::Rgb;
use crate::trace::UntilStopped;
use crate::world::World;

/// A rectangle of pixels: `x`, `y`, `width`, `height`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    /// The left column.
    pub x: u32,
    /// The top row.
    pub y: u32,
    /// Columns; at least 1.
    pub width: u32,
    /// Rows; at least 1.
    pub height: u32,
}

/// A picture that is being rendered. Other threads can read it and cancel the rendering; a program
/// of one thread renders it piece by piece ([`Canvas::render_until`]).
///
/// The pixels of a coarse picture come first, one of each block; the others follow, tile by tile.
#[derive(Debug)]
pub struct Canvas {
    picture: Mutex<Partial>,
    crop: Crop,
    done: AtomicU64,
    previewed: AtomicU64,
    cancelled: AtomicBool,
}

/// A partly rendered picture. Pixels that are not rendered yet are black in the film.
#[derive(Debug)]
pub struct Partial {
    film: Film,
    rendered: Vec<bool>,
    /// One sample of each pixel of the coarse picture, row by row; empty without a preview.
    preview: Vec<Option<Rgb>>,
}

/// Pixels are rendered in squares of this side.
const TILE: u32 = 16;

/// The coarse picture has one pixel in each square of this side, which divides [`TILE`].
const BLOCK: u32 = 8;
/// One sample in each square of this side comes before all others, so that something of the whole
/// view is seen at once.
const FIRST: u32 = 64;

/// Says when to pause. At least one pixel should be rendered before it says so, or nothing ever is.
pub type Pause<'a> = dyn Fn() -> bool + Sync + 'a;

/// No pause.
fn never() -> bool {
    false
}

/// Whether a pixel belongs to the coarse picture: the top left one of its block does.
fn is_coarse([x, y]: [u32; 2]) -> bool {
    x.is_multiple_of(BLOCK) && y.is_multiple_of(BLOCK)
}

impl Partial {
    fn new(crop: Crop) -> Self {
        let film = Film::new(crop.width, crop.height);
        let rendered = vec![false; film.pixels().len()];
        Self { film, rendered, preview: Vec::new() }
    }

    /// The radiance of a pixel; `None` if it is not rendered yet.
    pub fn get(&self, pixel: [u32; 2]) -> Option<Rgb> {
        self.rendered[self.index(pixel)].then(|| self.film.get(pixel))
    }

    /// The coarse picture's radiance around a pixel: that of the top left pixel of its block, or
    /// before it is rendered, of one of its samples, or of a larger block.
    pub fn coarse(&self, pixel: [u32; 2]) -> Option<Rgb> {
        [BLOCK, FIRST].into_iter().find_map(|side| {
            let corner = pixel.map(|along| along - along % side);
            self.get(corner).or_else(|| *self.preview.get(self.block(corner))?)
        })
    }

    /// The index of a pixel's block.
    fn block(&self, [x, y]: [u32; 2]) -> usize {
        (y / BLOCK * self.film.width().div_ceil(BLOCK) + x / BLOCK) as usize
    }

    /// All pixels, those that are not rendered yet in black.
    pub fn film(&self) -> &Film {
        &self.film
    }

    fn set(&mut self, pixel: [u32; 2], color: Rgb) {
        let index = self.index(pixel);
        self.rendered[index] = true;
        self.film.set(pixel, color);
    }

    fn index(&self, [x, y]: [u32; 2]) -> usize {
        y as usize * self.film.width() as usize + x as usize
    }
}

impl Canvas {
    /// An empty picture of the whole view of a world.
    pub fn new(world: &World) -> Self {
        let [width, height] = world.picture_size();
        Self::cropped(Crop { x: 0, y: 0, width, height })
    }

    /// An empty picture of a part of the view. The part must lie inside it.
    pub fn cropped(crop: Crop) -> Self {
        Self {
            picture: Mutex::new(Partial::new(crop)),
            crop,
            done: AtomicU64::new(0),
            previewed: AtomicU64::new(0),
            cancelled: AtomicBool::new(false),
        }
    }

    /// The part of the view that it is of.
    pub fn crop(&self) -> Crop {
        self.crop
    }

    /// The picture so far; pixels that are not rendered yet are black.
    pub fn film(&self) -> Film {
        self.lock().film.clone()
    }

    /// Reads the picture so far without copying it.
    pub fn look<T>(&self, look: impl FnOnce(&Film) -> T) -> T {
        look(&self.lock().film)
    }

    /// As [`Canvas::look`], with the information which pixels are rendered.
    pub fn look_partly<T>(&self, look: impl FnOnce(&Partial) -> T) -> T {
        look(&self.lock())
    }

    /// The numbers of finished pixels and of all pixels.
    pub fn progress(&self) -> (u64, u64) {
        let whole = u64::from(self.crop.width) * u64::from(self.crop.height);
        (self.done.load(Ordering::Relaxed), whole)
    }

    /// The number of values that were found so far, those of the coarse picture among them: another
    /// one, and there is more to look at.
    pub fn seen(&self) -> u64 {
        self.done.load(Ordering::Relaxed) + self.previewed.load(Ordering::Relaxed)
    }

    /// Asks the rendering to stop soon.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether the rendering was cancelled.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Partial> {
        self.picture.lock().expect("nothing panics while it holds the picture")
    }

    /// Renders one sample of each pixel of the coarse picture, for [`Partial::coarse`]: the first
    /// picture of a scene whose pixels take long. They do not count as done. It stops when it is
    /// time to pause, and the next call goes on there. Whether all is done.
    pub fn preview(&self, renderer: &impl Renderer, is_over: &Pause<'_>) -> bool {
        let Crop { width, height, .. } = self.crop;
        let blocks = width.div_ceil(BLOCK) as usize * height.div_ceil(BLOCK) as usize;
        self.lock().preview.resize(blocks, None);
        let sample = |at| {
            let radiance = renderer.sample(at, 0, &mut (), &mut UntilStopped(&self.cancelled));
            (!self.is_cancelled()).then(|| expose(renderer.world(), [radiance].into_iter()))
        };
        let each = |side: u32| {
            let wanted = |picture: &Partial, at: [u32; 2]| {
                let is_corner = at.iter().all(|along| along.is_multiple_of(side));
                is_corner && picture.preview[picture.block(at)].is_none()
            };
            self.each_tile(&sample, wanted, is_over, |picture, at, color| {
                let block = picture.block(at);
                picture.preview[block] = Some(color);
                self.previewed.fetch_add(1, Ordering::Relaxed);
            })
        };
        each(FIRST) && each(BLOCK)
    }

    /// Renders every pixel once, in parallel on the current rayon pool; returns early if cancelled.
    pub fn render(&self, renderer: &impl Renderer) {
        self.render_until(renderer, &never);
    }

    /// As [`Canvas::render`], until it is time to pause; the next call goes on there. Whether all
    /// is done.
    pub fn render_until(&self, renderer: &impl Renderer, is_over: &Pause<'_>) -> bool {
        self.fill_all(&|at| renderer.pixel(at, &self.cancelled), is_over)
    }

    /// As [`Canvas::render`], with another value for each pixel of the view.
    pub fn fill(&self, value: impl Fn([u32; 2]) -> Rgb + Sync) {
        self.fill_until(value, &never);
    }

    /// As [`Canvas::fill`], until it is time to pause; the next call goes on there. Whether all is
    /// done.
    pub fn fill_until(&self, value: impl Fn([u32; 2]) -> Rgb + Sync, is_over: &Pause<'_>) -> bool {
        self.fill_all(&|at| Some(value(at)), is_over)
    }

    /// Renders the pixels of the coarse picture only.
    pub fn render_coarse(&self, renderer: &impl Renderer) {
        self.fill_those(&|at| renderer.pixel(at, &self.cancelled), is_coarse, &never);
    }

    /// Fills the pixels of the coarse picture, then the others.
    fn fill_all(
        &self,
        value: &(impl Fn([u32; 2]) -> Option<Rgb> + Sync),
        is_over: &Pause<'_>,
    ) -> bool {
        self.fill_those(value, is_coarse, is_over)
            && self.fill_those(value, |at| !is_coarse(at), is_over)
    }

    /// Fills those of the wanted pixels that are not rendered yet.
    fn fill_those(
        &self,
        value: &(impl Fn([u32; 2]) -> Option<Rgb> + Sync),
        wanted: impl Fn([u32; 2]) -> bool + Sync,
        is_over: &Pause<'_>,
    ) -> bool {
        let wanted = |picture: &Partial, at| wanted(at) && picture.get(at).is_none();
        self.each_tile(value, wanted, is_over, |picture, at, color| {
            picture.set(at, color);
            // under the lock: when `progress` says that all are done, `film` has all of them
            self.done.fetch_add(1, Ordering::Relaxed);
        })
    }

    /// Finds the values of the wanted pixels, and keeps them tile by tile, until it is time to
    /// pause, or a value is `None`, as all are after cancelling. Whether all were found.
    fn each_tile(
        &self,
        value: &(impl Fn([u32; 2]) -> Option<Rgb> + Sync),
        wanted: impl Fn(&Partial, [u32; 2]) -> bool + Sync,
        is_over: &Pause<'_>,
        keep: impl Fn(&mut Partial, [u32; 2], Rgb) + Sync,
    ) -> bool {
        let Crop { x, y, width, height } = self.crop;
        let (across, down) = (width.div_ceil(TILE), height.div_ceil(TILE));
        let of_tile = |tile: u32| {
            let (left, top) = (tile % across * TILE, tile / across * TILE);
            let (right, bottom) = ((left + TILE).min(width), (top + TILE).min(height));
            let pixels = (top..bottom).flat_map(|row| (left..right).map(move |c| [c, row]));
            let pixels: Vec<_> = {
                let picture = self.lock();
                pixels.filter(|&at| wanted(&picture, at)).collect()
            };
            let found = |&at: &[u32; 2]| {
                let [column, row] = at;
                let is_stopped = self.is_cancelled() || is_over();
                let color = (!is_stopped).then(|| value([x + column, y + row])).flatten();
                color.map(|color| (at, color))
            };
            let found: Vec<_> = pixels.iter().map_while(found).collect();
            let is_whole = found.len() == pixels.len();
            let mut picture = self.lock();
            found.into_iter().for_each(|(at, color)| keep(&mut picture, at, color));
            is_whole
        };
        (0..across * down).into_par_iter().map(of_tile).reduce(|| true, |a, b| a && b)
    }
}
