//! Values in directions, and what rounding may do to them.

use ask::Stop;
use groundtruth::math::{Frame, Normal, Vector};

use crate::lobe::Evaluated;

/// A rounding of so many units is always granted.
pub const UNITS: f64 = 64.0;

/// What rounding may do at an edge: finite, so that nothing times it is nothing.
const ANY: f64 = 1e300;

/// Values in a direction, and by how much they change within the rounding of directions.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// The direction that the light comes from.
    pub wi: Vector,
    /// The values.
    pub value: Evaluated,
    /// What rounding may do to the channels of f.
    pub f_slack: [f64; 3],
    /// What rounding may do to the density.
    pub pdf_slack: f64,
}

/// The values in these directions, and what rounding may do to them: directions are moved by twice the square root of
/// the unit of rounding. To first order that is more than the rounding of a direction; to second order, near a peak of
/// width α, it changes a value by u/α², which is what cancellation in `1 − cos² θ` costs.
///
/// # Errors
/// Those of `eval`.
pub fn measured(
    wi: &[Vector],
    rounding: f64,
    eval: impl FnOnce(&[Vector]) -> Result<Vec<Evaluated>, Stop>,
) -> Result<Vec<Measured>, Stop> {
    let step = 2.0 * rounding.sqrt();
    let around = |wi: &Vector| {
        let frame = Frame::around(Normal::new(*wi).unwrap_or(Normal::Z));
        let moved = |by: Vector| (*wi + step * by).unit().unwrap_or(*wi);
        [*wi, moved(frame.u), moved(-frame.u), moved(frame.v), moved(-frame.v)]
    };
    let asked: Vec<Vector> = wi.iter().flat_map(around).collect();
    let values = eval(&asked)?;
    let measured = |(wi, values): (&Vector, &[Evaluated])| {
        let value = values[0];
        let slack = |of: &dyn Fn(&Evaluated) -> f64| {
            let middle = of(&value);
            // at an edge rounding decides between nothing and all, and some densities have no bound there
            if values.iter().any(|it| of(it) == 0.0) && values.iter().any(|it| of(it) != 0.0) {
                return ANY;
            }
            let moved = values.iter().map(|it| (of(it) - middle).abs()).fold(0.0, f64::max);
            moved + UNITS * rounding * middle.abs()
        };
        let f_slack = std::array::from_fn(|k| slack(&|it| it.f[k]));
        Measured { wi: *wi, value, f_slack, pdf_slack: slack(&|it| it.pdf) }
    };
    Ok(wi.iter().zip(values.chunks(5)).map(measured).collect())
}
