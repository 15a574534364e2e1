//! Ranges of angles of part objects (Suffern, ch. 19).

use crate::invalid::Invalid;
use crate::math::{Aabb, Point, Vector, cos_degrees, sin_degrees};
use crate::shapes::textbook;
use crate::shapes::trimmed::Trim;

/// The directions of a plane from one angle up to another, both included: azimuths φ about the y
/// axis (as the book measures them, `x = ρ sin φ` and `z = ρ cos φ`), or angles θ around a tube.
///
/// A point is tested by cross products with the two ends, not by its angle. They are exact at
/// multiples of 90°, and ranges with a common end leave no gap.
#[derive(Clone, Copy, Debug)]
pub struct Angles {
    /// `[cos, sin]` of the first end and of the last.
    ends: [[f64; 2]; 2],
    width: Width,
    /// As the book tests them.
    pub book: textbook::BookAngles,
}

#[derive(Clone, Copy, Debug)]
enum Width {
    /// Up to 180°: a direction in it is past the start and before the end.
    Narrow,
    /// More than 180°: a direction in it is past the start or before the end.
    Wide,
    All,
}

/// All around: the default of scene files.
pub fn full_turn() -> [f64; 2] {
    [0.0, 360.0]
}

/// `a × b`: positive if `b` is up to 180° on from `a`. `b × a` is exactly the opposite.
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - b[0] * a[1]
}

impl Angles {
    /// From the first number of degrees up to the second; through 360° where the first is larger.
    pub fn new(field: &str, range @ [from, to]: [f64; 2]) -> Result<Self, Invalid> {
        let fits = |degrees: &f64| (-360.0..=360.0).contains(degrees);
        let width = if to >= from { to - from } else { (to - from).rem_euclid(360.0) };
        if !range.iter().all(fits) || width == 0.0 {
            let problem = format!(
                "found {range:?}, but a range between angles from -360 to 360 degrees is needed that is \
                 not empty; [350, 10] passes through 360, [0, 360] goes all around"
            );
            return Err(Invalid::field(field, problem));
        }
        let width = match width {
            w if w >= 360.0 => Width::All,
            w if w > 180.0 => Width::Wide,
            _ => Width::Narrow,
        };
        let ends = range.map(|angle| [cos_degrees(angle), sin_degrees(angle)]);
        Ok(Self { ends, width, book: textbook::BookAngles::degrees(range) })
    }

    /// Whether the direction `[cos, sin]`, of any length, is in the range; `[0, 0]` is.
    pub fn contains(&self, at: [f64; 2]) -> bool {
        let [start, end] = self.ends;
        let (past_start, before_end) = (cross(start, at) >= 0.0, cross(at, end) >= 0.0);
        match self.width {
            Width::Narrow => past_start && before_end,
            Width::Wide => past_start || before_end,
            Width::All => true,
        }
    }

    /// The distances of the point `[cos, sin]` from both ends, negative beyond; infinite for a full
    /// turn. Where the range is wide, a point is beyond the nearer end only, and the other counts
    /// as infinite.
    pub fn end_distances(&self, at: [f64; 2]) -> [f64; 2] {
        let [start, end] = self.ends;
        let (past_start, before_end) = (cross(start, at), cross(at, end));
        match self.width {
            Width::Narrow => [past_start, before_end],
            Width::Wide if past_start > before_end => [past_start, f64::INFINITY],
            Width::Wide => [f64::INFINITY, before_end],
            Width::All => [f64::INFINITY; 2],
        }
    }

    /// The unit vectors away from both ends.
    pub fn away_from_ends(&self) -> [[f64; 2]; 2] {
        let [start, end] = self.ends;
        [[-start[1], start[0]], [end[1], -end[0]]]
    }

    /// The least and the greatest cosine and sine: `[[cos, sin]; 2]`.
    pub fn extremes(&self) -> [[f64; 2]; 2] {
        let [a, b] = self.ends;
        let end = |axis: usize, sign: f64| {
            let pole = [sign * (1.0 - axis as f64), sign * axis as f64];
            let farther = if sign > 0.0 { a[axis].max(b[axis]) } else { a[axis].min(b[axis]) };
            if self.contains(pole) { sign } else { farther }
        };
        [[end(0, -1.0), end(1, -1.0)], [end(0, 1.0), end(1, 1.0)]]
    }

    /// The box around the points of these azimuths, at distances from `near` to `far` from the axis
    /// and heights from `low` to `high`, from the centre.
    pub fn bounds(&self, center: Point, [near, far]: [f64; 2], [low, high]: [f64; 2]) -> Aabb {
        let [[z0, x0], [z1, x1]] = self.extremes();
        // a coordinate is farthest out where its cosine or sine and the distance are
        let least = |c: f64| (near * c).min(far * c);
        let most = |c: f64| (near * c).max(far * c);
        Aabb {
            min: center + Vector::new(least(x0), low, least(z0)),
            max: center + Vector::new(most(x1), high, most(z1)),
        }
    }
}

/// A range of azimuths about the y axis, between two meridians.
impl Trim for Angles {
    fn book_has(&self, v: Vector) -> bool {
        self.book.contains(textbook::angle(v.x(), v.z()))
    }

    #[inline]
    fn distances(&self, v: Vector) -> [f64; 2] {
        self.end_distances([v.z(), v.x()])
    }

    fn away(&self, _: Vector) -> [Vector; 2] {
        self.away_from_ends().map(|[z, x]| Vector::new(x, 0.0, z))
    }
}
