//! Points, vectors, normals. Whole numbers make every product exact, so that laws hold to the bit.

use groundtruth::math::exact_cross;
use testkit::properties::*;

use crate::prelude::*;

/// Whole coordinates: products of four of them and their sums fit into 53 bits.
fn whole() -> impl Strategy<Value = [i64; 3]> {
    prop::array::uniform3(-2047..2048_i64)
}

fn vector(v: [i64; 3]) -> Vector {
    Vector::from(v.map(|x| x as f64))
}

fn point(p: [i64; 3]) -> Point {
    Point::from(p.map(|x| x as f64))
}

/// The vector product in whole numbers, by the determinant's rule.
fn cross([a, b, c]: [i128; 3], [d, e, f]: [i128; 3]) -> [i128; 3] {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: sums, differences, products and quotients of vectors are those of the components. Oracle: whole
    /// numbers.
    /// Book: vectors, points and their products.
    #[test]
    fn vectors_calculate_by_components(a in whole(), b in whole(), k in -9..10_i64) {
        let (u, v) = (vector(a), vector(b));
        let each = |f: &dyn Fn(i64, i64) -> i64| vector(std::array::from_fn(|i| f(a[i], b[i])));
        prop_assert_eq!(u + v, each(&|x, y| x + y));
        prop_assert_eq!(u - v, each(&|x, y| x - y));
        prop_assert_eq!(-u, each(&|x, _| -x));
        prop_assert_eq!(k as f64 * u, each(&|x, _| k * x));
        prop_assert_eq!(u * k as f64, each(&|x, _| k * x));
        prop_assert_eq!((k as f64 * u) / 4.0, 0.25 * each(&|x, _| k * x));
        prop_assert_eq!(u.dot(v), (0..3).map(|i| a[i] * b[i]).sum::<i64>() as f64);
        let mut w = u;
        w += v;
        prop_assert_eq!(w, u + v);
        prop_assert_eq!(u.max_abs(), a.map(i64::abs).into_iter().max().unwrap_or(0) as f64);
        prop_assert_eq!(u.abs().along(u.dominant_axis()), u.max_abs());
    }

    /// Law: `p − q` leads from q to p; points move by vectors; distances are lengths. Oracle: whole
    /// numbers.
    /// Book: vectors, points and their products.
    #[test]
    fn points_move_by_vectors(a in whole(), b in whole()) {
        let (p, q) = (point(a), point(b));
        prop_assert_eq!(q + (p - q), p);
        prop_assert_eq!(p - (p - q), q);
        let squared: i64 = (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum();
        prop_assert_eq!(p.distance_squared(q), squared as f64);
        prop_assert_eq!(p.distance(q), (squared as f64).sqrt());
        prop_assert_eq!(Point::ORIGIN + p.to_vector(), p);
    }

    /// Law: the vector product is right-handed: x × y = z. Oracle: the determinant in whole numbers.
    /// Book: vectors, points and their products.
    #[test]
    fn vector_products_are_right_handed(a in whole(), b in whole()) {
        let expected = cross(a.map(i128::from), b.map(i128::from)).map(|x| x as f64);
        prop_assert_eq!(vector(a).cross(vector(b)).to_array(), expected);
        prop_assert_eq!(Vector::X.cross(Vector::Y), Vector::Z);
        prop_assert_eq!(Vector::Y.cross(Vector::Z), Vector::X);
        prop_assert_eq!(Vector::Z.cross(Vector::X), Vector::Y);
    }

    /// Law: `|u × v|² + (u·v)² = |u|² |v|²` (Lagrange), exactly.
    /// Book: vectors, points and their products.
    #[test]
    fn vector_and_scalar_product_share_the_lengths(a in whole(), b in whole()) {
        let (u, v) = (vector(a), vector(b));
        let (s, c) = (u.cross(v).length_squared(), u.dot(v));
        prop_assert_eq!(s + c * c, u.length_squared() * v.length_squared());
    }

    /// Law: a normal has length 1 within 4u and the direction of its vector, for lengths from 2⁻¹⁰²⁰ to
    /// 2¹⁰¹⁹. Oracle: its length; the unit vector from which the vector was made.
    #[test]
    fn normals_are_unit(v in unit(), exponent in -1020..1020_i32) {
        let scaled = power_of_two(exponent) * v;
        let n = Normal::new(scaled).expect("neither zero nor infinite");
        near!(Vector::from(n).length(), 1.0, 4.0 * U);
        prop_assert!((Vector::from(n) - v).length() <= 8.0 * U, "{n:?} {v:?}");
    }

    /// Law: scaling a vector by a power of two changes no bit of its normal, unless it underflows.
    #[test]
    fn normals_do_not_depend_on_powers_of_two(a in whole(), exponent in -900..900_i32) {
        prop_assume!(a != [0, 0, 0]);
        let n = Normal::new(vector(a));
        prop_assert_eq!(Normal::new(power_of_two(exponent) * vector(a)), n);
        prop_assert_eq!(Normal::new(-vector(a)), n.map(|n| -n));
        prop_assert_eq!(vector(a).unit(), n.map(Vector::from));
    }

    /// Law: `(b − a) × (c − a)` is right to a few u in each component, also for needle triangles, where
    /// nearly everything cancels, and where the edges do not fit into 53 bits. Oracle: 128-bit whole numbers.
    #[test]
    fn exact_cross_survives_needles(
        (a, b) in (corner(), corner()),
        off in prop::array::uniform3(-3..4_i64),
        (k, d) in (0..9_i64, 8..20_i64),
    ) {
        // c is nearly on the edge from a to b
        let c: [i64; 3] = std::array::from_fn(|i| a[i] + (b[i] - a[i]) / d * k + off[i]);
        let edge = |to: [i64; 3]| std::array::from_fn(|i| i128::from(to[i]) - i128::from(a[i]));
        let expected = cross(edge(b), edge(c));
        let found = exact_cross(point(a), point(b), point(c)).to_array();
        // δ₁ × δ₂, the product of the rounding errors of the edges, is left out: edges of up to 54 bits have
        // errors of at most 1, and each component sums two products
        for i in 0..3 {
            let error = (found[i] - expected[i] as f64).abs();
            prop_assert!(error <= 4.0 * U * (expected[i] as f64).abs() + 4.0, "{error}");
        }
    }
}

/// Whole coordinates of up to 53 bits, whose differences need 54.
fn corner() -> impl Strategy<Value = [i64; 3]> {
    const LARGEST: i64 = (1 << 53) - 4;
    prop::array::uniform3(-LARGEST..LARGEST)
}

/// Law: a vector without a direction has no normal.
#[test]
fn vectors_without_direction_have_no_normal() {
    for v in [
        Vector::ZERO,
        Vector::new(-0.0, 0.0, -0.0),
        Vector::new(f64::NAN, 1.0, 0.0),
        Vector::new(0.0, f64::INFINITY, 1.0),
    ] {
        assert_eq!(Normal::new(v), None, "{v:?}");
        assert_eq!(v.unit(), None, "{v:?}");
    }
}

/// Law: the smallest and largest numbers have exact normals along an axis, and the diagonal ones
/// `1/√3`. Oracle: the definition.
#[test]
fn extreme_vectors_have_normals() {
    for length in [5e-324, 1e-310, 1e-200, 1e-140, 1e140, 1e200, f64::MAX] {
        assert_eq!(Normal::new(-length * Vector::Y), Some(-Normal::Y), "{length}");
        let n = Normal::new(length * Vector::new(1.0, 1.0, 1.0)).expect("not zero");
        let third = (1.0_f64 / 3.0).sqrt();
        assert!(n.to_array().iter().all(|x| (x - third).abs() < 4.0 * U), "{length}: {n:?}");
    }
}
