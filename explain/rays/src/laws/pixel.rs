use groundtruth::cameras::Side;
use groundtruth::math::{Point, Vector};
use groundtruth::world::World;

use super::LawReport;
use super::as_ours::camera_rays;
use crate::traced::{Traced, size as size_of};
use text::digits::short;

/// How far beside its pixel a ray may go, in pixels: the filters of renderers reach two pixels at most.
const REACH: f64 = 2.0;
/// The part by which width and height may differ in how much larger they are than the scene's: sizes are whole numbers.
const SAME_SHAPE: f64 = 0.02;
/// The same point of the picture, in pixels.
const SAME: f64 = 0.05;
/// A ray that starts at the eye goes through one point of the picture at all distances: these many usual ones are tried.
const DISTANCES: [f64; 2] = [1.0, 30.0];

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let Some(world) = traced.scene_world() else { return };
    for index in camera_rays(traced) {
        let Some(passes) = Passes::of(traced, world, index) else { continue };
        asked.count(index, passes.holds(), || {
            let words = match passes.at {
                Some([x, y]) => {
                    format!("goes through ({}, {}) of the scene's picture", short(x), short(y))
                }
                None => "does not go from the scene's eye through its picture".to_owned(),
            };
            let [x, y] = passes.pixel;
            let [right, below] = [passes.size[0] - 1.0 - x, passes.size[1] - 1.0 - y];
            let causes = [
                ("rows-from-below", passes.is_in([x, below])),
                ("columns-from-the-right", passes.is_in([right, y])),
                ("turned-by-180-degrees", passes.is_in([right, below])),
            ];
            (words, causes)
        });
    }
}

/// Where a camera's ray passes the picture of a scene, in the size that the log has.
pub struct Passes {
    size: [f64; 2],
    pixel: [f64; 2],
    /// From the top left corner, in pixels; `None` if it does not.
    at: Option<[f64; 2]>,
    /// How far beside its pixel it may go.
    reach: f64,
}

impl Passes {
    /// `None` if the scene or the log does not tell, or at the edge of the picture.
    pub fn of(traced: &Traced, world: &World, index: usize) -> Option<Self> {
        let ray = traced.ray(index);
        let ours = world.picture_size().map(f64::from);
        let size = traced.log.head.size.map_or(ours, |size| size.map(f64::from));
        let [across, down] = [ours[0] / size[0], ours[1] / size[1]];
        let shape = (across / down - 1.0).abs();
        let is_told = shape < SAME_SHAPE && world.view.stereo().is_none() && !world.view.has_lens();
        let pixel = ray.pixel?.map(f64::from);
        let reach = REACH + 0.5 * shape * size[0].max(size[1]);
        let is_inside = (0..2).all(|axis| (reach..size[axis] - 1.0 - reach).contains(&pixel[axis]));
        let direction = ray.direction.unit().filter(|_| is_told && is_inside)?;
        // far from the origin of the space, near points are all one
        let scale = traced.scale.max(size_of(ray.origin));
        let at = through(world, (ray.origin, direction), scale);
        let at = at.map(|[x, y]| [0.5 * size[0] + x / across, 0.5 * size[1] - y / across]);
        Some(Self { size, pixel, at, reach })
    }

    /// Whether it passes its pixel.
    pub fn holds(&self) -> bool {
        self.is_in(self.pixel)
    }

    fn is_in(&self, pixel: [f64; 2]) -> bool {
        let near = -self.reach..=1.0 + self.reach;
        self.at.is_some_and(|at| (0..2).all(|axis| near.contains(&(at[axis] - pixel[axis]))))
    }
}

/// The point of the view plane that a ray from the eye goes through, in pixels of the scene from the middle, y up.
fn through(world: &World, (origin, direction): (Point, Vector), scale: f64) -> Option<[f64; 2]> {
    let eye = world.view.eye(Side::Left);
    let at = |far: f64| {
        let film = eye.project(origin + (far * scale) * direction)?;
        Some(film.map(|x| x / world.image.pixel_size))
    };
    let [near, far] = DISTANCES.map(at);
    let ([x, y], far) = near.zip(far)?;
    ((x - far[0]).abs().max((y - far[1]).abs()) <= SAME).then_some([x, y])
}
