//! From far away a lamp is a point light, and the radiance of a lamp seen directly does not fade.

use testkit::properties::*;

use super::*;
use crate::prelude::*;

/// The size of the lamps divided by their distance from the lit point: each sample has an error of a few
/// times that, the mean one of its square.
const SIZE: f64 = 1e-5;

/// Lamps of that size at a distance, their area, and the cosine with which they face the origin.
fn small_lamps(to_lamp: Vector, far: f64, turned: Vector) -> Vec<(shapes::Kind, f64, f64)> {
    let r = SIZE * far;
    let center = Point::ORIGIN + far * to_lamp;
    let normal = Normal::new(0.8 * turned - to_lamp).expect("not opposite");
    let cosine = -normal.dot(to_lamp);
    let (a, b) = (
        r * at_angle(normal, 0.0, 1.0),
        r * at_angle(normal, 0.0, 1.0 + std::f64::consts::FRAC_PI_2),
    );
    let disk = Disk { center, normal: normal.into(), radius: r };
    let triangle = shapes::Triangle { vertices: [center, center + a, center + b], normals: None };
    let pi = std::f64::consts::PI;
    vec![
        (panel(center, a, b).into(), r * r, cosine),
        (disk.into(), pi * r * r, cosine),
        (triangle.into(), 0.5 * r * r, cosine),
        // a sphere has the area of its projected disk
        (ball(center, r).into(), pi * r * r, 1.0),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: laws().cases / 4, ..laws() })]

    /// Law: from far away a flat lamp is a point light of strength `L A cosθ'` that fades with the square of
    /// the distance, a sphere one of `L π R²`; this holds for each sample, whichever point it draws. Oracle:
    /// that point light (ch. 14, 18).
    /// Book: the estimate of an area light: G and 1/pdf.
    #[test]
    fn from_far_away_a_lamp_is_a_point_light(
        (n, to_lamp) in (unit(), unit()),
        turned in unit(),
        exponent in -3.0..3.0_f64,
    ) {
        let cos_i = n.dot(to_lamp);
        prop_assume!(cos_i > 0.1);
        let far = power(10.0, exponent);
        for (shape, area, cosine) in small_lamps(to_lamp.into(), far, turned.into()) {
            if cosine < 0.1 {
                continue;
            }
            let mut scene = floor(n);
            let is_round = matches!(shape, shapes::Kind::Sphere(_));
            let sampling = if is_round { Sampling::SolidAngle } else { Sampling::Area };
            hang(&mut scene, shape.clone(), Some(sampling));
            let eye = Point::ORIGIN + 0.1 * far * at_angle(n, 0.5, 1.0);
            let found = look(&built(&scene), eye, Point::ORIGIN - eye);
            let location = Point::ORIGIN + far * to_lamp;
            let point =
                PointLight { ls: LS * area * cosine, color: CE, location, attenuation: 2.0 };
            let mut by_point = floor(n);
            shine(&mut by_point, point);
            let expected = look(&built(&by_point), eye, Point::ORIGIN - eye);
            // the cosines change by the lamp's size divided by themselves; coordinates of a small lamp far
            // away are rounded
            let tolerance = 8.0 * SIZE / (cosine * cos_i) + 64.0 * U / SIZE;
            close!(found, expected, tolerance, "{shape:?}");
        }
    }

    /// Law: a lamp seen directly has the radiance `l_s c_e`, at any distance and angle, whether a light names
    /// it or not. Oracle: the product, bit for bit.
    /// Book: 18.5, emissive materials.
    #[test]
    fn a_visible_lamp_has_its_radiance(to_eye in unit(), far in 1.0..1e6_f64, spot in unit()) {
        for (name, shape) in every_lamp() {
            let center = Point::new(0.0, 3.0, 0.0);
            let eye = center + far * to_eye;
            let mut scene = stage(Rgb::BLACK);
            hang(&mut scene, shape.clone(), None);
            let seen = look(&built(&scene), eye, center + 0.1 * spot - eye);
            let tree = recorded(&built(&scene), eye, center + 0.1 * spot - eye);
            let hit = tree.root().hit.as_ref().map(|hit| hit.front);
            let expected = if hit == Some(true) { LS * CE } else { Rgb::BLACK };
            prop_assert_eq!(seen, expected, "{}", name);
            scene.lights.clear();
            prop_assert_eq!(look(&built(&scene), eye, center + 0.1 * spot - eye), expected);
        }
    }
}
