//! The backdrop of the space view: the scene as the orbiting camera sees it, coarse first, and which pieces of the rays
//! it hides.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use eframe::egui::{
    Color32, ColorImage, Context, Painter, Rect, TextureHandle, TextureOptions, pos2,
};
use groundtruth::film::Tone;
use groundtruth::world::World;
use space::{Backdrop as Scene, Orbit, Segment, Visibility};

use crate::explanation::Version;
use crate::picture::worker::Background;
use crate::platform::Slice;

/// The sides of the squares that share one ray, in points of the screen, from the first picture to the last.
const SIDES: [usize; 3] = [8, 3, 1];
/// The longest wait for the first picture, which is then drawn in the frame of the change.
const MAX_WAIT: Duration = Duration::from_millis(16);
/// The tone of the backdrop.
const TONE: Tone = Tone { gamma: 2.2, ..Tone::PLAIN };
/// The most pieces whose middles are looked at, over all segments.
const MAX_PIECES: usize = 24_000;
/// The most pieces of a segment.
const MAX_PIECES_PER_SEGMENT: usize = 32;
/// The outline of the object that is pointed at: its colour, none of those of rays, and its width in points of the screen.
const LIGHT: Color32 = Color32::from_rgb(255, 90, 220);
const OUTLINE: usize = 2;

/// The runs of a segment that are hidden, and of those that are not.
pub type Runs = Vec<([f64; 2], bool)>;

/// The view that is drawn: which scene, from where, how large, and what of it is looked through.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Of which picture.
    pub version: Version,
    /// The camera.
    pub orbit: Orbit,
    /// Width and height in points of the screen.
    pub size: [usize; 2],
    /// The objects that are looked through.
    pub faded: Vec<u32>,
    /// The pieces of rays over it.
    pub segments: Arc<Vec<Segment>>,
}

/// The scene as far as it is drawn.
struct Drawn {
    request: Request,
    /// The step, from 0, after which it is drawn in squares of `SIDES[step]`.
    step: usize,
    /// The colours of its squares, row by row.
    colors: Vec<Color32>,
    /// The index of the object in each square.
    objects: Vec<Option<u32>>,
    /// The runs of its segments, once they are found.
    runs: Option<Arc<Vec<Runs>>>,
}

/// The scene from the orbiting camera.
#[derive(Default)]
pub struct Backdrop {
    drawn: Option<Drawn>,
    texture: Option<TextureHandle>,
    /// The object that is lit, and its pixels.
    lit: Option<(u32, TextureHandle)>,
    working: Background<Option<Drawn>>,
    /// The step that is being drawn.
    step: usize,
    /// Set when what is being drawn is no longer wanted.
    cancelled: Arc<AtomicBool>,
    wanted: Option<Request>,
}

impl Backdrop {
    /// Starts what is missing of a view, and takes over what is finished.
    pub fn refresh(&mut self, ctx: &Context, world: &Arc<World>, request: Request) {
        self.accept(ctx, Duration::ZERO);
        if self.wanted.as_ref() != Some(&request) {
            // a coarse picture is finished: else nothing would be seen while the camera moves
            if self.step > 0 {
                self.cancelled.store(true, Ordering::Relaxed);
                self.working = Background::default();
            }
            self.wanted = Some(request.clone());
        }
        if self.working.is_busy() {
            return;
        }
        let step = match &self.drawn {
            Some(drawn) if drawn.request == request => drawn.step + 1,
            _ => 0,
        };
        if step == SIDES.len() || request.size.contains(&0) {
            return;
        }
        self.step = step;
        self.cancelled = Arc::new(AtomicBool::new(false));
        let (world, cancelled) = (Arc::clone(world), Arc::clone(&self.cancelled));
        let runs = self.drawn.as_ref().filter(|_| step > 0).and_then(|drawn| drawn.runs.clone());
        let drawn = Drawn { request, step, colors: Vec::new(), objects: Vec::new(), runs };
        let mut drawing = Some(drawn);
        self.working.start_in_slices(ctx, move |slice| {
            let is_whole = drawing.as_mut()?.go_on(&world, slice, &cancelled);
            let is_cancelled = cancelled.load(Ordering::Relaxed);
            (is_whole || is_cancelled).then(|| drawing.take().filter(|_| is_whole))
        });
        if step == 0 {
            self.accept(ctx, MAX_WAIT);
        }
    }

    fn accept(&mut self, ctx: &Context, wait: Duration) {
        if let Some(Ok(Some(drawn))) = self.working.wait(wait) {
            let image = ColorImage::new(drawn.size(), drawn.colors.clone());
            match &mut self.texture {
                Some(texture) => texture.set(image, TextureOptions::LINEAR),
                None => {
                    self.texture = Some(ctx.load_texture("space", image, TextureOptions::LINEAR));
                }
            }
            (self.drawn, self.lit) = (Some(drawn), None);
        }
    }

    /// Whether something of the wanted view is still to be drawn.
    pub fn is_busy(&self) -> bool {
        let done = self.drawn.as_ref().map(|drawn| (&drawn.request, drawn.step));
        self.wanted.as_ref().is_some_and(|wanted| done != Some((wanted, SIDES.len() - 1)))
    }

    /// The hidden runs of the segments, if they are known for these.
    pub fn runs(&self, segments: &Arc<Vec<Segment>>) -> Option<Arc<Vec<Runs>>> {
        let drawn = self.drawn.as_ref()?;
        drawn.runs.clone().filter(|_| Arc::ptr_eq(&drawn.request.segments, segments))
    }

    /// Draws it, with one object lit.
    pub fn paint(&mut self, painter: &Painter, area: Rect, object: Option<u32>) {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        if let (Some(texture), Some(drawn)) = (&self.texture, &self.drawn) {
            // the last squares may reach beyond the area
            let [width, height] = drawn.size().map(|count| (count * SIDES[drawn.step]) as f32);
            let place = Rect::from_min_size(area.min, [width, height].into());
            painter.image(texture.id(), place, whole, Color32::WHITE);
            if object.is_none() {
                self.lit = None;
            }
            if let Some(object) = object {
                if self.lit.as_ref().is_none_or(|(lit, _)| *lit != object) {
                    let color = |is_edge| if is_edge { LIGHT } else { Color32::TRANSPARENT };
                    let light = drawn.outline(object).map(color);
                    let image = ColorImage::new(drawn.size(), light.collect());
                    let texture = painter.ctx().load_texture("lit", image, TextureOptions::LINEAR);
                    self.lit = Some((object, texture));
                }
                if let Some((_, texture)) = &self.lit {
                    painter.image(texture.id(), place, whole, Color32::WHITE);
                }
            }
        }
    }

    /// The index of the object that is lit.
    pub fn lit(&self) -> Option<u32> {
        self.lit.as_ref().map(|(object, _)| *object)
    }

    /// The object at a point of the area, in points of the screen from its top left corner.
    pub fn object_at(&self, [x, y]: [f32; 2]) -> Option<u32> {
        let drawn = self.drawn.as_ref()?;
        let side = SIDES[drawn.step];
        let [column, row] = [x, y].map(|along| along.max(0.0) as usize / side);
        let [across, _] = drawn.size();
        (column < across).then(|| drawn.objects.get(row * across + column).copied().flatten())?
    }
}

impl Drawn {
    /// Squares across and down.
    fn size(&self) -> [usize; 2] {
        self.request.size.map(|along| along.div_ceil(SIDES[self.step]))
    }

    /// Whether each of the squares is at the border of an object, inside of it.
    fn outline(&self, object: u32) -> impl Iterator<Item = bool> {
        let [columns, rows] = self.size();
        // as wide for small squares as for large ones
        let width = (OUTLINE / SIDES[self.step]).max(1);
        let is_object = move |[column, row]: [usize; 2]| {
            let index = row.min(rows - 1) * columns + column.min(columns - 1);
            self.objects.get(index) == Some(&Some(object))
        };
        (0..columns * rows).map(move |index| {
            let [x, y] = [index % columns, index / columns];
            let [left, up] = [x, y].map(|at| at.saturating_sub(width));
            let around = [[left, y], [x + width, y], [x, up], [x, y + width]];
            is_object([x, y]) && !around.into_iter().all(is_object)
        })
    }

    /// Draws more rows; whether it is whole. It may be cancelled before.
    fn go_on(&mut self, world: &World, slice: &Slice, cancelled: &AtomicBool) -> bool {
        let (side, [columns, rows]) = (SIDES[self.step], self.size());
        let Self { request, colors, objects, runs, .. } = self;
        let sight = request.orbit.sight(request.size.map(|along| along as f64));
        let scene = Scene { world, faded: &request.faded };
        for row in colors.len() / columns..rows {
            if slice.is_over() || cancelled.load(Ordering::Relaxed) {
                return false;
            }
            for column in 0..columns {
                let middle = [column, row].map(|at| (at as f64 + 0.5) * side as f64);
                let (radiance, object) = scene.seen(&sight.ray(middle));
                let [r, g, b] = TONE.to_bytes(radiance);
                colors.push(Color32::from_rgb(r, g, b));
                objects.push(object);
            }
        }
        let seen = Visibility { backdrop: scene, eye: sight.eye };
        let new = || hidden_runs(&seen, &request.segments, cancelled).map(Arc::new);
        *runs = runs.take().or_else(new);
        runs.is_some()
    }
}

fn hidden_runs(
    seen: &Visibility<'_>,
    segments: &[Segment],
    cancelled: &AtomicBool,
) -> Option<Vec<Runs>> {
    let pieces = (MAX_PIECES / segments.len().max(1)).clamp(1, MAX_PIECES_PER_SEGMENT) as u32;
    let runs = segments.iter().map(|segment| {
        let go_on = !cancelled.load(Ordering::Relaxed);
        go_on.then(|| seen.runs(segment.from, segment.to, pieces))
    });
    runs.collect()
}
