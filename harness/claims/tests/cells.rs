//! Cells and integrals: whether narrow densities are seen, and their error is known.

use ask::Draw;
use std::convert::Infallible;

use claims::cells::{Cells, DensitySamples, Integrals, integrals};
use groundtruth::math::{Frame, Normal, Vector, cos, exp, sin};
use libm::log;
use testkit::as_many;

const TAU: f64 = std::f64::consts::TAU;

/// Fisher's density on the sphere: `κ exp(κ (cos θ − 1)) / 2π (1 − exp(−2κ))` about an axis.
fn fisher(axis: Vector, kappa: f64, w: Vector) -> f64 {
    // 1 − cos θ as half of a square, which keeps its digits
    let apart = 0.5 * (w - axis).length_squared();
    kappa * exp(-kappa * apart) / (TAU * (1.0 - exp(-2.0 * kappa)))
}

/// A direction with that density, by inversion of its distribution in `1 − cos θ`.
fn drawn(axis: Vector, kappa: f64, draw: &mut Draw) -> Vector {
    let u = draw.between(0.0, 1.0);
    let s = -log(1.0 - u * (1.0 - exp(-2.0 * kappa))) / kappa;
    let (r, phi) = ((s * (2.0 - s)).max(0.0).sqrt(), draw.between(0.0, TAU));
    let frame = Frame::around(Normal::new(axis).expect("a unit vector"));
    frame.to_world(Vector::new(r * cos(phi), r * sin(phi), 1.0 - s))
}

/// The integrals of a density over cells that its directions place.
fn integrated(
    cells: &Cells,
    directions: &[Vector],
    (tolerance, budget): (f64, usize),
    mut density: impl FnMut(Vector) -> f64,
) -> Integrals<1> {
    let samples = DensitySamples { directions, drawn: directions.len() };
    let mut values = |directions: &[Vector]| {
        Ok::<_, Infallible>(directions.iter().map(|w| [density(*w)]).collect())
    };
    let Ok(found) = integrals(cells, samples, [tolerance], budget, &mut values);
    found
}

/// Law: a density that is uniform, or as narrow as 10⁻⁴, has the integral 1, in cells that 8,000 of its directions place,
/// wherever its axis is: on the normal, in the surface, where the azimuth begins. Oracle: 1, in closed form.
#[test]
fn narrow_densities_are_seen_whole() {
    let mut draw = Draw::new(7601);
    let mut axes: Vec<Vector> = (0..6).map(|_| Vector::from(draw.direction())).collect();
    axes.extend([Vector::Z, -Vector::Z, Vector::X, Vector::Y]);
    for (row, kappa) in [1e-3, 1.0, 1e2, 1e4, 1e6, 1e8].into_iter().enumerate() {
        // every third axis, of each density others
        let (first, step) = as_many((row % 3, 3), (0, 1));
        for axis in axes.iter().skip(first).step_by(step) {
            let placing: Vec<Vector> = (0..8_000).map(|_| drawn(*axis, kappa, &mut draw)).collect();
            let cells = Cells::around(&placing, 5);
            let density = |w| fisher(*axis, kappa, w);
            let found = integrated(&cells, &placing, (1e-4, 400_000), density);
            assert!(found.is_known, "κ = {kappa} about {axis:?}");
            // each of up to 64 cells is known to 10⁻⁴, and their errors have both signs
            let [whole] = found.whole.value;
            assert!((whole - 1.0).abs() <= 1e-3, "κ = {kappa} about {axis:?}: {whole}");
        }
    }
}

/// Law: a narrow density with one hundredth of the whole is seen among a uniform one, wherever it is. Oracle: 1, in closed form.
#[test]
fn a_spike_in_a_broad_density_is_seen() {
    let mut draw = Draw::new(7604);
    for kappa in [1e4, 1e6] {
        for share in [0.01, 0.1, 0.5, 0.9] {
            for _ in 0..as_many(2, 4) {
                let axis = Vector::from(draw.direction());
                let direction = |draw: &mut Draw| match draw.between(0.0, 1.0) < share {
                    true => drawn(axis, kappa, draw),
                    false => Vector::from(draw.direction()),
                };
                let placing: Vec<Vector> = (0..16_384).map(|_| direction(&mut draw)).collect();
                let cells = Cells::around(&placing, 5);
                let density = |w| share * fisher(axis, kappa, w) + (1.0 - share) / (2.0 * TAU);
                let found = integrated(&cells, &placing, (1e-4, 400_000), density);
                let [whole] = found.whole.value;
                assert!((whole - 1.0).abs() <= 2e-3, "{share} of κ = {kappa}, {axis:?}: {whole}");
            }
        }
    }
}

/// Law: the integral over a cell is the share of directions in it, also if these are rounded to single precision around the
/// normal, where `1 − cos θ` has no digits left. Oracle: 100,000 directions of the density, by their standard deviation.
#[test]
fn cells_hold_their_share() {
    let mut draw = Draw::new(7602);
    let axis = Vector::from(draw.direction());
    shares(axis, 300.0, &mut draw, |w| w);
    shares(Vector::Z, 1e7, &mut draw, |w| Vector::from(w.to_array().map(|x| f64::from(x as f32))));
}

fn shares(axis: Vector, kappa: f64, draw: &mut Draw, rounded: fn(Vector) -> Vector) {
    let mut drawn = || rounded(drawn(axis, kappa, draw));
    let placing: Vec<Vector> = (0..8_000).map(|_| drawn()).collect();
    let cells = Cells::around(&placing, 4);
    let density = |w| fisher(axis, kappa, w);
    let found = integrated(&cells, &placing, (1e-5, 400_000), density);
    let n = 100_000.0;
    let mut counts = vec![0.0; cells.all.len()];
    for _ in 0..n as usize {
        counts[cells.index(drawn())] += 1.0;
    }
    for (count, cell) in counts.iter().zip(&found.cells) {
        let expected = n * cell.value[0];
        // five standard deviations: once in a million
        assert!((count - expected).abs() <= 5.0 * expected.sqrt() + 5.0, "{count} for {expected}");
    }
}

/// Law: a function that no budget settles is not said to be known. Oracle: noise, whose pieces never agree.
#[test]
fn what_does_not_settle_is_not_known() {
    let mut draw = Draw::new(7603);
    let cells = Cells::around(&[], 4);
    let found = integrated(&cells, &[], (1e-6, 50_000), |_| draw.between(0.0, 1.0));
    assert!(!found.is_known);
}

/// Law: how far a point is outside of each domain. Oracle: points at a known distance from its border, on each side.
#[test]
fn points_outside_are_told_by_how_far() {
    use claims::Domain::{Disk, Hemisphere, Sphere, Square, Triangle};
    for (domain, [x, y, z], expected) in [
        (Square, [0.5, 0.25, 0.0], 0.0),
        (Square, [1.0, 1.0, 0.0], 0.0),
        (Square, [1.25, 0.5, 0.0], 0.25),
        (Square, [0.5, 1.125, 0.0], 0.125),
        (Square, [-0.5, 0.5, 0.0], 0.5),
        (Square, [0.5, -0.25, 0.0], 0.25),
        (Disk, [0.0, -1.0, 0.0], 0.0),
        (Disk, [0.25, 0.5, 0.0], 0.0),
        (Disk, [0.0, 1.5, 0.0], 0.5),
        (Disk, [-3.0, 4.0, 0.0], 4.0),
        (Triangle, [0.25, 0.75, 0.0], 0.0),
        (Triangle, [0.75, 0.75, 0.0], 0.5),
        (Triangle, [-0.25, 0.5, 0.0], 0.25),
        (Triangle, [0.5, -0.125, 0.0], 0.125),
        (Hemisphere, [0.0, 1.0, 0.0], 0.0),
        (Hemisphere, [0.0, 0.0, -1.0], 1.0),
        (Hemisphere, [0.0, 0.0, 2.0], 1.0),
        (Hemisphere, [0.5, 0.0, 0.0], 0.5),
        (Sphere, [0.0, 0.0, -1.0], 0.0),
        (Sphere, [0.0, -3.0, 0.0], 2.0),
        (Sphere, [0.25, 0.0, 0.0], 0.75),
        (Square, [f64::NAN, 0.5, 0.0], f64::INFINITY),
        (Sphere, [0.0, 1.0, f64::NAN], f64::INFINITY),
    ] {
        let found = domain.outside(Vector::new(x, y, z));
        assert_eq!(found, expected, "[{x}, {y}, {z}] outside of {domain:?}");
    }
}
