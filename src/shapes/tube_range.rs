//! A range of angles, asked by signs of cross products instead of by an arc tangent, so that ranges
//! which share an end share it to the last bit and leave no gap.

use crate::invalid::{Invalid, finite};
use crate::math::{cos_degrees, sin_degrees};

/// The angles from one end up to the other, both included.
#[derive(Clone, Copy, Debug)]
pub(super) enum TubeRange {
    /// Every angle.
    Full,
    /// `[cos, sin]` of both ends, and whether the way between them is more than 180°.
    Part { ends: [[f64; 2]; 2], wide: bool },
}

/// `a × b`: positive if `b` is less than 180° on from `a`. Exactly opposite for `b × a`.
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - b[0] * a[1]
}

impl TubeRange {
    /// From `min` degrees up to `max`, past 360° where `min` is above `max`.
    pub(super) fn new(fields: [&str; 2], [min, max]: [f64; 2]) -> Result<Self, Invalid> {
        finite(fields[0], min)?;
        finite(fields[1], max)?;
        for (field, angle) in fields.into_iter().zip([min, max]) {
            if angle.abs() > 360.0 {
                let problem = format!("found {angle}, but degrees from -360 to 360 are needed");
                return Err(Invalid::field(field, problem));
            }
        }
        if max - min >= 360.0 {
            return Ok(Self::Full);
        }
        let turn = if max < min { max - min + 360.0 } else { max - min };
        if turn <= 0.0 {
            let problem = format!("found {max}, which leaves nothing from {} {min}", fields[0]);
            return Err(Invalid::field(fields[1], problem));
        }
        let ends = [min, max].map(|angle| [cos_degrees(angle), sin_degrees(angle)]);
        Ok(Self::Part { ends, wide: turn > 180.0 })
    }

    /// Whether the angle of `[cos, sin]`, of any length, is one of them.
    pub(super) fn contains(&self, at: [f64; 2]) -> bool {
        match *self {
            Self::Full => true,
            Self::Part { ends: [min, max], wide } => {
                let (after, before) = (cross(min, at) >= 0.0, cross(at, max) >= 0.0);
                if wide { after || before } else { after && before }
            }
        }
    }

    /// The least and greatest cosine and sine: `[[cos, sin]; 2]`.
    pub(super) fn extremes(&self) -> [[f64; 2]; 2] {
        let Self::Part { ends: [a, b], .. } = *self else { return [[-1.0; 2], [1.0; 2]] };
        let end = |axis: usize, sign: f64| {
            let pole = [sign * (1.0 - axis as f64), sign * axis as f64];
            let farther = if sign > 0.0 { a[axis].max(b[axis]) } else { a[axis].min(b[axis]) };
            if self.contains(pole) { sign } else { farther }
        };
        [[end(0, -1.0), end(1, -1.0)], [end(0, 1.0), end(1, 1.0)]]
    }
}
