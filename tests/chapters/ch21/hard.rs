//! Instances against exact arithmetic, on hard cases.

use oracle::Shape;
use oracle::hard::{Family, Kind as Hard, cases};

use crate::prelude::*;
use crate::support::hard_cases::{ShapePair, instanced, judge_all, pair, sweep, sweep_as};

/// Law: hits of an instance are as exact as the condition of its matrix allows. Oracle: 512-bit
/// arithmetic on the matrix as the library has it.
#[test]
fn instances_are_exact_within_their_condition() {
    sweep(Hard::Instance, 21, as_many(100, 10_000));
}

/// The matrices of the hard instances: scales from 10⁻⁴ to 10⁴, sheared and mirrored.
fn matrices(count: usize) -> Vec<[[f64; 4]; 3]> {
    let all = [Family::Ordinary, Family::Scaled].map(|f| cases(Hard::Instance, f, 2100, count));
    let matrix = |(shape, _)| match shape {
        Shape::Instance { matrix, .. } => Some(matrix),
        _ => None,
    };
    all.into_iter().flatten().filter_map(matrix).collect()
}

/// Law: the steps that are computed from a matrix compose to that matrix. Oracle: the matrix.
#[test]
fn steps_make_their_matrix() {
    let moved = [[1.0, 0.0, 0.0, 3.0], [0.0, 1.0, 0.0, -2.0], [0.0, 0.0, 1.0, 0.5]];
    let quarter = [[0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 7.0]];
    for matrix in matrices(50).into_iter().chain([moved, quarter]) {
        let steps = exact::steps(&matrix).expect("not singular");
        let made = Transform::from_steps(&steps).expect("not singular").rows();
        let largest = matrix.as_flattened().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let pairs = matrix.as_flattened().iter().zip(made.as_flattened());
        let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let lost = 1e-14 * oracle::condition(&matrix) * largest; // columns may be nearly equal
        assert!(off <= lost, "{matrix:?}: {made:?}");
    }
}

fn sweep_instances_of(kind: Hard, seed: u64, count: usize) {
    let matrices = matrices(50);
    sweep_as(kind, seed, count, |shape, ray, i| {
        instanced(shape, ray, matrices[i % matrices.len()])
    });
}

/// Law and oracle as above, for instances of kinds that the generator does not nest.
#[test]
fn instances_of_cylinders_triangles_and_rectangles_are_exact_within_their_condition() {
    for kind in [Hard::OpenCylinder, Hard::Triangle, Hard::Rectangle, Hard::Plane] {
        sweep_instances_of(kind, 212, as_many(100, 10_000));
    }
}

/// Flat rectangles that are stretched and rotated and then moved back, so that they are flat again up to
/// rounding; that rounding is the whole thickness of their bounding box. The rays graze the box from far
/// away.
fn turned_flat(count: usize) -> impl Iterator<Item = (String, ShapePair, oracle::Ray)> {
    let mut draw = Draw::new(2101);
    (0..count).map(move |index| {
        let height = draw.between(-1.0, 1.0);
        let rectangle = Rectangle {
            corner: Point::new(-1.0, height, -1.0),
            a: 2.0 * Vector::Z,
            b: 2.0 * Vector::X,
        };
        let [a, b] = [(); 2].map(|()| draw.between(-80.0, 80.0));
        let transform = vec![
            Step::RotateX(a),
            Step::Scale(Vector::new(1.0, 1.0, 1e4)),
            Step::RotateZ(b),
            Step::RotateZ(-b),
            Step::Scale(Vector::new(1.0, 1.0, 1e-4)),
            Step::RotateX(-a),
        ];
        let matrix = Transform::from_steps(&transform).expect("a rotation").rows();
        let Rectangle { corner, a, b } = rectangle;
        let exact = Shape::Instance {
            matrix,
            of: Box::new(Shape::Rectangle { corner: corner.into(), a: a.into(), b: b.into() }),
        };
        let instance = Instance::new(rectangle, transform);
        let ours = Kind::from(instance).build(&mut Context::default()).expect("valid");
        let distance = draw.decades(0.0, 6.0);
        let away = draw.direction();
        let across = Vector::new(away.x(), 0.0, away.z());
        let slope = draw.decades(-6.0, 0.0) * across.length();
        let [x, y, z] = (across + slope * Vector::Y).to_array();
        let aim = draw.vector(0.9);
        let origin = [aim.x() + distance * x, height + distance * y, aim.z() + distance * z];
        let ray = oracle::Ray { origin, direction: [-x, -y, -z] };
        (format!("turned {index}"), ShapePair { ours, exact }, ray)
    })
}

/// Law: the bounding box of the instance loses no hit. Oracle: as above.
#[test]
fn instances_turned_flat_keep_every_hit() {
    judge_all(turned_flat(2_000));
}

macro_rules! beveled {
    ($($law:ident $kind:ident;)*) => {$(
        /// Law: hit or miss, every distance and every normal are those of the parts that the book
        /// names, within their condition. Oracle: those parts in 512-bit arithmetic.
        #[test]
        fn $law() {
            sweep(Hard::$kind, 213, as_many(30, 10_000));
        }
    )*};
}
beveled! {
    beveled_boxes_are_the_union_of_their_parts BeveledBox;
    beveled_cylinders_are_the_union_of_their_parts BeveledCylinder;
    beveled_rings_are_the_union_of_their_parts BeveledRing;
    beveled_wedges_are_the_union_of_their_parts BeveledWedge;
}

/// Rays that cross the rounded edge of a cylinder in a short chord. The bevel is 10⁻⁷ to 10⁻¹ of the
/// cylinder's size, the chord 10⁻⁴ to 1 of the bevel.
fn short_chords(count: usize) -> impl Iterator<Item = (String, ShapePair, oracle::Ray)> {
    let mut draw = Draw::new(2113);
    (0..count).map(move |index| {
        let size = draw.decades(-3.0, 3.0);
        let bevel = size * draw.decades(-7.0, -1.0);
        let (y0, y1) = (-size, size * draw.between(0.0, 1.0));
        let solid = oracle::Solid::BeveledCylinder { y0, y1, radius: size, bevel };
        // in the half-plane z = 0: `out` points from the centre of the tube to its surface, `across` is
        // perpendicular to it except for a part along z
        let angle = draw.between(1.0, 89.0);
        let out = Vector::new(cos_degrees(angle), sin_degrees(angle), 0.0);
        let across = Vector::new(-out.y(), out.x(), 0.1 * draw.between(-1.0, 1.0));
        let chord = bevel * draw.decades(-4.0, 0.0);
        let deep = bevel - 0.125 * chord * chord / bevel;
        let middle = Point::new(size - bevel, y1 - bevel, 0.0) + deep * out;
        let origin = middle - (size * draw.between(0.1, 2.0)) * across;
        let ray = oracle::Ray { origin: origin.into(), direction: across.into() };
        let pair = pair(&Shape::Solid(solid)).expect("valid");
        (format!("chord {index}"), pair, ray)
    })
}

/// Law: a ray that crosses a thin edge in a short chord hits it, too. Oracle: as above.
#[test]
fn short_chords_of_thin_edges_are_found() {
    judge_all(short_chords(600));
}
