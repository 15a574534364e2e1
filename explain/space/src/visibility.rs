//! Which pieces of a segment are hidden behind surfaces.

use groundtruth::math::{Point, Ray, Span};
use groundtruth::world::World;

use super::Backdrop;

/// A surface this close before a point does not hide it, as a part of the distance to the eye: the point lies on it.
const CLOSE: f64 = 1e-5;

/// What can be seen from an eye.
#[derive(Clone, Copy, Debug)]
pub struct Visibility<'a> {
    /// The scene and what of it is looked through.
    pub backdrop: Backdrop<'a>,
    /// The position of the eye.
    pub eye: Point,
}

impl Visibility<'_> {
    /// Whether an opaque surface is between the eye and a point.
    pub fn is_hidden(&self, point: Point) -> bool {
        let ray = Ray::new(self.eye, point - self.eye);
        let span = Span { min: 0.0, max: 1.0 - CLOSE };
        self.backdrop.first_opaque(&ray, span).is_some()
    }

    /// Divides a segment into `pieces` equal ones and returns the runs of those that are hidden and of those that
    /// are not, as parts of its length from 0 to 1; a piece is hidden if its middle is.
    pub fn runs(&self, from: Point, to: Point, pieces: u32) -> Vec<([f64; 2], bool)> {
        let mut runs: Vec<([f64; 2], bool)> = Vec::new();
        let at = |piece: u32| f64::from(piece) / f64::from(pieces);
        for piece in 0..pieces {
            let [start, end] = [at(piece), at(piece + 1)];
            let hidden = self.is_hidden(from + 0.5 * (start + end) * (to - from));
            match runs.last_mut() {
                Some((run, was_hidden)) if *was_hidden == hidden => run[1] = end,
                _ => runs.push(([start, end], hidden)),
            }
        }
        runs
    }
}

impl<'a> Visibility<'a> {
    /// What can be seen of a world in which no object is faded.
    pub fn of(world: &'a World, eye: Point) -> Self {
        Self { backdrop: Backdrop { world, faded: &[] }, eye }
    }
}
