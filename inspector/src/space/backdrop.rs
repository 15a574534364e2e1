//! The backdrop of the space view: the scene as the orbiting camera sees it, coarse first, and which pieces of the rays
//! it hides.

use std::iter;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use eframe::egui::{
    Color32, ColorImage, Context, Painter, Rect, TextureHandle, TextureOptions, pos2,
};
use groundtruth::film::Tone;
use groundtruth::rgb::Rgb;
use groundtruth::world::World;
use space::{Backdrop as Scene, Orbit, Segment, Sight};
use web_time::Instant;

use crate::explanation::Version;
use crate::picture::worker::Background;
use crate::platform::Slice;

/// The sides of the squares that have one colour, in points of the screen, from the first picture to the last.
const SIDES: [usize; 2] = [2, 1];
/// How many such squares of the first picture, across and down, share one ray inside of an object.
const SHARED: usize = 4;
/// The time for the rays of the first picture that make the borders of objects sharp.
const SHARPENING: Duration = Duration::from_millis(8);
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
    /// The grey where no surface is, as on the screen.
    pub ground: u8,
    /// The pieces of rays over it.
    pub segments: Arc<Vec<Segment>>,
}

type Square = (Color32, Option<u32>);

/// The scene as far as it is drawn.
struct Drawn {
    request: Request,
    /// The step, from 0, after which it is drawn in squares of `SIDES[step]`.
    step: usize,
    /// The colour of each of its squares and the index of the object there, row by row.
    squares: Vec<Square>,
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
            if self.drawn.as_ref().map(|drawn| &drawn.request) == self.wanted.as_ref() {
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
        self.cancelled = Arc::new(AtomicBool::new(false));
        let (world, cancelled) = (Arc::clone(world), Arc::clone(&self.cancelled));
        let runs = self.drawn.as_ref().filter(|_| step > 0).and_then(|drawn| drawn.runs.clone());
        let drawn = Drawn { request, step, squares: Vec::new(), runs };
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
            let colors = drawn.squares.iter().map(|(color, _)| *color).collect();
            let image = ColorImage::new(drawn.size(), colors);
            self.texture = Some(ctx.load_texture("space", image, TextureOptions::LINEAR));
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
        let (Some(texture), Some(drawn)) = (&self.texture, &self.drawn) else { return };
        self.lit = self.lit.take().filter(|(lit, _)| Some(*lit) == object);
        if let Some(object) = object.filter(|_| self.lit.is_none()) {
            let color = |is_edge| if is_edge { LIGHT } else { Color32::TRANSPARENT };
            let image = ColorImage::new(drawn.size(), drawn.outline(object).map(color).collect());
            let texture = painter.ctx().load_texture("lit", image, TextureOptions::LINEAR);
            self.lit = Some((object, texture));
        }
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        // the last squares may reach beyond the area
        let [width, height] = drawn.size().map(|count| (count * SIDES[drawn.step]) as f32);
        let place = Rect::from_min_size(area.min, [width, height].into());
        for texture in iter::once(texture).chain(self.lit.iter().map(|(_, texture)| texture)) {
            painter.image(texture.id(), place, whole, Color32::WHITE);
        }
    }

    /// The object at a point of the area, in points of the screen from its top left corner.
    pub fn object_at(&self, [x, y]: [f32; 2]) -> Option<u32> {
        let drawn = self.drawn.as_ref()?;
        let side = SIDES[drawn.step];
        let [column, row] = [x, y].map(|along| along.max(0.0) as usize / side);
        let [across, _] = drawn.size();
        (column < across).then(|| drawn.squares.get(row * across + column)?.1)?
    }
}

impl Drawn {
    /// Squares across and down.
    fn size(&self) -> [usize; 2] {
        squares(self.request.size, SIDES[self.step])
    }

    /// Whether each of the squares is at the border of an object, inside of it.
    fn outline(&self, object: u32) -> impl Iterator<Item = bool> {
        let [columns, rows] = self.size();
        // as wide for small squares as for large ones
        let width = (OUTLINE / SIDES[self.step]).max(1);
        let is_object = move |[column, row]: [usize; 2]| {
            let index = row.min(rows - 1) * columns + column.min(columns - 1);
            self.squares.get(index).is_some_and(|(_, it)| *it == Some(object))
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
        let Self { request, step, squares: drawn, runs } = self;
        let sight = request.orbit.sight(request.size.map(|along| along as f64));
        let scene = Scene { world, faded: &request.faded };
        let empty = Rgb::grey(f64::from(request.ground) / 255.0).powc(TONE.gamma);
        let look = |at: [usize; 2], side: usize| {
            let middle = at.map(|at| (at as f64 + 0.5) * side as f64);
            let (radiance, object) = scene.seen(&sight.ray(middle), empty);
            let [r, g, b] = TONE.to_bytes(radiance);
            (Color32::from_rgb(r, g, b), object)
        };
        let side = if *step == 0 { SHARED * SIDES[0] } else { SIDES[*step] };
        let [columns, rows] = squares(request.size, side);
        for row in drawn.len() / columns..rows {
            if slice.is_over() || cancelled.load(Ordering::Relaxed) {
                return false;
            }
            drawn.extend((0..columns).map(|column| look([column, row], side)));
        }
        if *step == 0 {
            *drawn = sharpened(drawn, request.size, |at| look(at, SIDES[0]));
        }
        let new = || hidden_runs(&scene, &sight, &request.segments, cancelled).map(Arc::new);
        *runs = runs.take().or_else(new);
        runs.is_some()
    }
}

/// How many squares of this side cover a view, across and down.
fn squares(size: [usize; 2], side: usize) -> [usize; 2] {
    size.map(|along| along.div_ceil(side))
}

/// The squares of the first picture: at the borders of objects each has a ray of its own, while there is time; elsewhere
/// colours are interpolated between those of the rays so far, inside of an object.
fn sharpened(
    coarse: &[Square],
    size: [usize; 2],
    look: impl Fn([usize; 2]) -> Square,
) -> Vec<Square> {
    let start = Instant::now();
    let [columns, rows] = squares(size, SHARED * SIDES[0]);
    let at =
        |column: usize, row: usize| coarse[row.min(rows - 1) * columns + column.min(columns - 1)];
    let is_border = |index: usize| {
        let [x, y] = [index % columns, index / columns];
        let [left, up] = [x, y].map(|at| at.saturating_sub(1));
        let around = [(left, y), (x + 1, y), (x, up), (x, y + 1)];
        around.into_iter().any(|(x, y)| at(x, y).1 != coarse[index].1)
    };
    let borders: Vec<bool> = (0..coarse.len()).map(is_border).collect();
    let [across, down] = squares(size, SIDES[0]);
    let square = |index: usize| {
        let place @ [x, y] = [index % across, index / across];
        let inside = y / SHARED * columns + x / SHARED;
        if borders[inside] && start.elapsed() < SHARPENING {
            return look(place);
        }
        let (own, object) = coarse[inside];
        let color = |x: usize, y: usize| if at(x, y).1 == object { at(x, y).0 } else { own };
        let [(x, right), (y, below)] = [x, y].map(|at| {
            let along = ((at as f32 + 0.5) / SHARED as f32 - 0.5).max(0.0);
            (along as usize, along.fract())
        });
        let [above, under] = [y, y + 1].map(|y| color(x, y).lerp_to_gamma(color(x + 1, y), right));
        (above.lerp_to_gamma(under, below), object)
    };
    (0..across * down).map(square).collect()
}

fn hidden_runs(
    scene: &Scene<'_>,
    sight: &Sight,
    segments: &[Segment],
    cancelled: &AtomicBool,
) -> Option<Vec<Runs>> {
    let pieces = (MAX_PIECES / segments.len().max(1)).clamp(1, MAX_PIECES_PER_SEGMENT) as u32;
    let runs = segments.iter().map(|segment| {
        let go_on = !cancelled.load(Ordering::Relaxed);
        go_on.then(|| scene.runs(sight.eye, segment.from, segment.to, pieces))
    });
    runs.collect()
}
