//! Chapter 20: affine transformations.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | points, vectors and homogeneous matrices | vectors ignore translation, points do not, and `M p − M q = M (p − q)`: parallels, ratios and midpoints stay | `vectors_ignore_translation` |
//! |  | a matrix is written row by row, with the translation in the last column | `matrix::a_matrix_has_its_entries_in_rows` |
//! | the basic transformations | determinants: rotation +1, reflection −1, translation 1, scale `abc`, shear `1 − df − ac − be + ade + bcf`; of a composition their product | `determinants_are_those_of_the_steps` |
//! |  | quarter turns map the axes to axes exactly: about x from y to z, about y from z to x, about z from x to y | `quarter_turns_send_axes_to_axes` |
//! |  | a reflection is its own inverse and negates one coordinate | `reflections_turn_one_coordinate` |
//! |  | the six factors a to f of a shear are in the rows `(1, a, b)`, `(c, 1, d)` and `(e, f, 1)` of its matrix | `shears_have_their_factors_in_rows` |
//! |  | the matrices of rotations about the axes have the cosine twice on the diagonal and ∓ the sine beside it, and the inverse is the transpose | `rotations_have_the_books_matrices` |
//! | composition of transformations | steps are applied first to last, `M = Tₙ … T₂ T₁`, and their order matters | `steps_are_applied_in_their_order` |
//! | inverse transformations | `(A B)⁻¹ = B⁻¹ A⁻¹`, and `A.after(B)` is `A B` | `the_inverse_of_a_product_is_the_product_of_inverses_turned_round` |
//! |  | the inverse is that of the rounded matrix, up to one unit in the last place of its largest entry, for steps of every kind, shears included, whose inverse some copies of the book's code have wrong, also where later steps undo earlier scalings | `the_inverse_is_that_of_the_rounded_matrix` |
//! | rotation about a line | a rotation about a line fixes the points of the line, keeps distances from it and turns by its angle, counter-clockwise if the direction points at the viewer; a rotation by 360° more is the same | `a_turn_about_a_line_keeps_it` |
//! | normals under transformations | a normal stays perpendicular to what moves with its surface: `(M⁻ᵀ n)·(M v) = n·v` | `covectors_pair_with_vectors_as_before` |
//!
//! Beyond the book: 1 in this file.

mod matrix;

use dashu_ratio::RBig;
use testkit::properties::*;

use crate::prelude::*;

/// Tolerance for a composition: each step adds a few roundings, and rotates or stretches the errors of
/// earlier steps. Ten steps stay well below this, times the condition of the whole.
const COMPOSED: f64 = 100.0 * U;

fn transform(steps: &[Step]) -> Transform {
    Transform::from_steps(steps).expect("not singular")
}

/// A step of any kind; scales from 1/4 to 4, shears that are far from singular.
fn step() -> impl Strategy<Value = Step> {
    let factor = || (0.25..4.0_f64, any::<bool>()).prop_map(|(f, turn)| if turn { -f } else { f });
    let shear = || -0.4..0.4_f64;
    let angle = || prop_oneof![-360.0..360.0_f64, Just(90.0), Just(-180.0)];
    prop_oneof![
        point(3.0).prop_map(|p| Step::Translate(p.to_vector())),
        [factor(), factor(), factor()].prop_map(|s| Step::Scale(s.into())),
        angle().prop_map(Step::RotateX),
        angle().prop_map(Step::RotateY),
        angle().prop_map(Step::RotateZ),
        (point(3.0), unit(), angle()).prop_map(|(point, n, degrees)| {
            Step::RotateAbout { point, direction: n.into(), degrees }
        }),
        prop_oneof![Just(Axis::X), Just(Axis::Y), Just(Axis::Z)].prop_map(Step::Reflect),
        [shear(), shear(), shear(), shear(), shear(), shear()].prop_map(Step::Shear),
    ]
}

fn steps() -> impl Strategy<Value = Vec<Step>> {
    prop::collection::vec(step(), 1..6)
}

/// The 3×3 part by rows.
fn linear(t: &Transform) -> [[f64; 3]; 3] {
    t.rows().map(|[x, y, z, _]| [x, y, z])
}

fn determinant(t: &Transform) -> f64 {
    let [a, b, c] = linear(t).map(Vector::from);
    a.dot(b.cross(c))
}

/// The product of two maps as 4×4 matrices, by the schoolbook sum.
fn product(a: &Transform, b: &Transform) -> [[f64; 4]; 3] {
    let (a, b) = (a.rows(), b.rows());
    let entry = |i: usize, j: usize| {
        let sum: f64 = (0..3).map(|k| a[i][k] * b[k][j]).sum();
        if j == 3 { sum + a[i][3] } else { sum }
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// The largest difference of two matrices.
fn difference(a: [[f64; 4]; 3], b: [[f64; 4]; 3]) -> f64 {
    let entries = a.iter().flatten().zip(b.iter().flatten());
    entries.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// The scale of the rounding errors of a product with this map: 1 plus its largest entry.
fn size(t: &Transform) -> f64 {
    let all = t.rows();
    1.0 + all.iter().flatten().fold(0.0, |most, x| x.abs().max(most))
}

proptest! {
    #![proptest_config(laws())]

    /// Law: steps are applied first to last, `M = Tₙ … T₂ T₁`, and their order matters. Oracle: a point moved step by
    /// step.
    /// Book: composition of transformations.
    #[test]
    fn steps_are_applied_in_their_order(steps in steps(), p in point(3.0)) {
        let one_by_one =
            steps.iter().fold(p, |p, step| transform(std::slice::from_ref(step)).point(p));
        let at_once = transform(&steps).point(p);
        let stretch: f64 =
            steps.iter().map(|s| size(&transform(std::slice::from_ref(s)))).product();
        at_most!(one_by_one.distance(at_once), COMPOSED * stretch * 10.0);
    }

    /// Law: `(A B)⁻¹ = B⁻¹ A⁻¹`, and `A.after(B)` is `A B`. Oracle: the schoolbook product.
    /// Book: inverse transformations.
    #[test]
    fn the_inverse_of_a_product_is_the_product_of_inverses_turned_round(
        a in steps(),
        b in steps(),
    ) {
        let (a, b) = (transform(&a), transform(&b));
        let both = a.after(&b);
        at_most!(difference(both.rows(), product(&a, &b)), COMPOSED * size(&a) * size(&b));
        let (x, y) = (a.inverse(), b.inverse());
        let wrong = difference(both.inverse().rows(), product(&y, &x));
        at_most!(wrong, COMPOSED * size(&x) * size(&y) * size(&a) * size(&b));
    }

    /// Law: determinants: rotation +1, reflection −1, translation 1, scale `abc`, shear
    /// `1 − df − ac − be + ade + bcf`; of a composition their product. Oracle: those formulas.
    /// Book: the basic transformations.
    #[test]
    fn determinants_are_those_of_the_steps(steps in steps()) {
        let of = |step: &Step| match *step {
            Step::Scale(s) => s.x() * s.y() * s.z(),
            Step::Reflect(_) => -1.0,
            Step::Shear([a, b, c, d, e, f]) => 1.0 - d * f - a * c - b * e + a * d * e + b * c * f,
            _ => 1.0,
        };
        let expected: f64 = steps.iter().map(of).product();
        let t = transform(&steps);
        let scale = size(&t) * size(&t) * size(&t);
        near!(determinant(&t), expected, COMPOSED * scale);
    }

    /// Law: vectors ignore translation, points do not, and `M p − M q = M (p − q)`: parallels, ratios and midpoints stay.
    /// Book: points, vectors and homogeneous matrices.
    #[test]
    fn vectors_ignore_translation(
        steps in steps(),
        shift in point(9.0),
        p in point(3.0),
        q in point(3.0),
    ) {
        let t = transform(&steps);
        let mut more = steps;
        more.push(Step::Translate(shift.to_vector()));
        let shifted = transform(&more);
        let v = p - q;
        prop_assert_eq!(shifted.vector(v), t.vector(v));
        let rounding = COMPOSED * (9.0 + 10.0 * size(&t));
        near!(shifted.point(p) - t.point(p), shift.to_vector(), rounding);
        near!(t.point(p) - t.point(q), t.vector(v), rounding);
    }

    /// Law: a rotation about a line fixes the points of the line, keeps distances from it and turns by
    /// its angle, counter-clockwise if the direction points at the viewer; a rotation by 360° more is the
    /// same. Oracle: geometry.
    /// Book: rotation about a line.
    #[test]
    fn a_turn_about_a_line_keeps_it(
        q in point(3.0),
        n in unit(),
        degrees in -180.0..180.0_f64,
        p in point(3.0),
        s in -3.0..3.0_f64,
    ) {
        let about =
            |degrees| transform(&[Step::RotateAbout { point: q, direction: 2.5 * n, degrees }]);
        let t = about(degrees);
        let on_line = q + s * n;
        at_most!(t.point(on_line).distance(on_line), COMPOSED * 10.0);
        at_most!(about(degrees + 360.0).point(p).distance(t.point(p)), 1e4 * U);
        let across = |p: Point| (p - q) - (p - q).dot(n) * n;
        let (before, after) = (across(p), across(t.point(p)));
        near!(before.length(), after.length(), COMPOSED * 10.0);
        let square = before.length_squared();
        near!(before.dot(after), square * cos_degrees(degrees), COMPOSED * 100.0);
        let sine = before.cross(after).dot(n);
        near!(sine, square * sin_degrees(degrees), COMPOSED * 100.0);
    }

    /// Law: a normal stays perpendicular to what moves with its surface: `(M⁻ᵀ n)·(M v) = n·v`.
    /// Book: normals under transformations.
    #[test]
    fn covectors_pair_with_vectors_as_before(steps in steps(), n in unit(), v in point(3.0)) {
        let (t, v) = (transform(&steps), v.to_vector());
        let paired = t.covector(n).dot(t.vector(v));
        near!(paired, n.dot(v), COMPOSED * 10.0 * size(&t) * size(&t.inverse()));
    }

    /// Law: a singular map is refused, with its condition number in the message; one that is nearly
    /// so is accepted up to 1e12. Oracle: the condition of `diag(1, 1, s)`, `√(2 + s²)·√(2 + s⁻²)`.
    #[test]
    fn singular_maps_are_refused_with_their_condition(
        exponent in -320..-1_i32,
        turn in -180.0..180.0_f64,
    ) {
        let s = groundtruth::math::power(10.0, f64::from(exponent));
        let flat = [Step::RotateX(turn), Step::Scale(Vector::new(1.0, 1.0, s))];
        let condition = (2.0 + s * s).sqrt() * (2.0 * s * s + 1.0).sqrt() / s;
        match Transform::from_steps(&flat) {
            Ok(t) => {
                below!(condition, 1.001e12);
                near!(t.condition() / condition, 1.0, 1e-6);
            }
            Err(singular) => {
                above!(condition, 0.999e12);
                let same = singular.condition == condition
                    || (singular.condition / condition - 1.0).abs() < 1e-6
                    || (singular.condition.is_infinite() && condition > 1e150);
                prop_assert!(same, "{} for {condition:e}", singular);
                let number = format!("{:.1e}", singular.condition);
                prop_assert!(
                    singular.to_string().contains(&number),
                    "{singular}, expected {number}"
                );
            }
        }
    }

    /// Law: the inverse is that of the rounded matrix, up to one unit in the last place of its largest
    /// entry, for steps of every kind, shears included, whose inverse some copies of the book's code have wrong, also
    /// where later steps undo earlier scalings. Oracle: the adjugate over the determinant, in rational numbers.
    /// Book: inverse transformations.
    #[test]
    fn the_inverse_is_that_of_the_rounded_matrix(
        steps in steps(),
        (first, second, degrees) in (-5.0..5.0_f64, -5.0..5.0_f64, 0.0..90.0_f64),
        undone in any::<bool>(),
    ) {
        let stretch = |exponent| Vector::new(1.0, groundtruth::math::power(10.0, exponent), 1.0);
        let mut wild = vec![
            Step::RotateZ(degrees),
            Step::Scale(stretch(first)),
            Step::RotateZ(0.7 * degrees),
            Step::RotateX(degrees),
        ];
        if undone {
            wild.insert(3, Step::Scale(stretch(second)));
            wild.extend([
                Step::RotateX(-degrees),
                Step::Scale(stretch(-second)),
                Step::RotateZ(-0.7 * degrees),
                Step::Scale(stretch(-first)),
            ]);
        }
        let t = transform(&[&steps[..], &wild].concat());
        let exact = |x: f64| RBig::try_from(x).expect("finite");
        let [m, x] = [linear(&t), linear(&t.inverse())];
        let most = x.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let minor = |i: usize, j: usize| {
            let at = |k: usize, l: usize| exact(m[(i + k) % 3][(j + l) % 3]);
            at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)
        };
        let terms = (0..3).map(|j| exact(m[0][j]) * minor(0, j));
        let determinant = terms.fold(RBig::ZERO, |sum, term| sum + term);
        let inverse = |i: usize, j: usize| minor(j, i) / &determinant;
        for (i, j) in (0..9).map(|index| (index / 3, index % 3)) {
            let off = exact(x[i][j]) - inverse(i, j);
            prop_assert!(off.to_f64().value().abs() <= 2.0 * U * most, "{i} {j}: {t:?}");
        }
        let moved = t.rows().map(|row| row[3]);
        let far: f64 = moved.iter().map(|x| x.abs()).sum();
        for (i, [.., found]) in t.inverse().rows().into_iter().enumerate() {
            let back = (0..3).fold(exact(found), |sum, j| sum + inverse(i, j) * exact(moved[j]));
            prop_assert!(back.to_f64().value().abs() <= 8.0 * U * most * far, "{i}: {t:?}");
        }
    }
}

/// Law: quarter turns map the axes to axes exactly: about x from y to z, about y from z to x, about z
/// from x to y. Oracle: worked by hand; a third of a turn about (1, 1, 1).
/// Book: the basic transformations.
#[test]
fn quarter_turns_send_axes_to_axes() {
    let turned = |step, v: Vector| transform(&[step]).vector(v);
    assert_eq!(turned(Step::RotateX(90.0), Vector::Y), Vector::Z);
    assert_eq!(turned(Step::RotateY(90.0), Vector::Z), Vector::X);
    assert_eq!(turned(Step::RotateZ(90.0), Vector::X), Vector::Y);
    let about = Step::RotateAbout {
        point: Point::ORIGIN,
        direction: Vector::new(1.0, 1.0, 1.0),
        degrees: 120.0,
    };
    near!(turned(about, Vector::X), Vector::Y, 8.0 * U);
}

/// Law: a reflection is its own inverse and negates one coordinate. Oracle: the coordinates.
/// Book: the basic transformations.
#[test]
fn reflections_turn_one_coordinate() {
    let p = Point::new(2.0, 3.0, 5.0);
    let images = [
        (Axis::X, Point::new(-2.0, 3.0, 5.0)),
        (Axis::Y, Point::new(2.0, -3.0, 5.0)),
        (Axis::Z, Point::new(2.0, 3.0, -5.0)),
    ];
    for (axis, image) in images {
        let t = transform(&[Step::Reflect(axis)]);
        assert_eq!((t.point(p), t.point(image)), (image, p));
        assert_eq!(t.inverse().rows(), t.rows());
    }
}

/// Law: the six factors a to f of a shear are in the rows `(1, a, b)`, `(c, 1, d)` and `(e, f, 1)` of its
/// matrix. Oracle: worked by hand.
/// Book: the basic transformations.
#[test]
fn shears_have_their_factors_in_rows() {
    let t = transform(&[Step::Shear([0.5, 0.25, -0.5, 0.125, 0.75, -0.25])]);
    // x' = x + a y + b z, y' = c x + y + d z, z' = e x + f y + z at (2, 4, 8)
    assert_eq!(t.point(Point::new(2.0, 4.0, 8.0)), Point::new(6.0, 4.0, 8.5));
}

/// Law: the matrices of rotations about the axes have the cosine twice on the diagonal and ∓ the sine beside it, and the
/// inverse is the transpose. Oracle: the book's rows, at 30°, where the sine is 1/2.
/// Book: the basic transformations.
#[test]
fn rotations_have_the_books_matrices() {
    let (c, s) = (0.75_f64.sqrt(), 0.5);
    for (step, rows) in [
        (Step::RotateX(30.0), [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]),
        (Step::RotateY(30.0), [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]),
        (Step::RotateZ(30.0), [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]),
    ] {
        let t = transform(&[step]);
        for (i, j) in (0..9).map(|index| (index / 3, index % 3)) {
            near!(linear(&t)[i][j], rows[i][j], 2.0 * U, "row {i}, column {j}");
            near!(linear(&t.inverse())[i][j], rows[j][i], 4.0 * U, "row {i}, column {j}");
        }
    }
}
