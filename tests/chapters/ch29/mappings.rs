//! From points to texture coordinates.

use groundtruth::textures::Mapping;
use testkit::properties::*;

use crate::prelude::*;

/// An angle by `atan2` and its share of a turn: a few roundings, and those of the point that was made for
/// it, magnified no more than by 4 where the sine is above 1/4.
const ROUNDING: f64 = 64.0 * U;

const ALL: [Mapping; 6] = [
    Mapping::Square,
    Mapping::Cylindrical,
    Mapping::Spherical,
    Mapping::Hemispherical,
    Mapping::LightProbe,
    Mapping::Panoramic,
];

/// The point of a generic object with these coordinates, by the formulas that the mapping inverts.
fn point_at(mapping: Mapping, [u, v]: [f64; 2]) -> Point {
    let phi = TAU * u;
    let on_sphere =
        |theta: f64| Point::new(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi));
    let probe = |sign: f64| {
        let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
        let r = (x * x + y * y).sqrt();
        let alpha = PI * r;
        Point::new(sin(alpha) * x / r, sin(alpha) * y / r, sign * cos(alpha))
    };
    match mapping {
        Mapping::Square => Point::new(2.0 * v - 1.0, 0.0, 2.0 * u - 1.0),
        Mapping::Cylindrical => Point::new(sin(phi), 2.0 * v - 1.0, cos(phi)),
        Mapping::Spherical => on_sphere(PI * (1.0 - v)),
        Mapping::Hemispherical => on_sphere(0.5 * PI * (1.0 - v)),
        Mapping::LightProbe => probe(1.0),
        Mapping::Panoramic => probe(-1.0),
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: each mapping undoes the parametrisation of its generic object: of the sphere u = φ/2π and v =
    /// 1 − θ/π at `(sinθ sinφ, cosθ, sinθ cosφ)`, likewise of square, cylinder, hemisphere and light
    /// probe. Oracle: the parametrisations.
    /// Book: mappings from points to texture coordinates.
    #[test]
    fn mappings_invert_the_parametrisation((u, v) in (0.01..0.99_f64, 0.1..0.9_f64)) {
        for mapping in ALL {
            let is_probe = matches!(mapping, Mapping::LightProbe | Mapping::Panoramic);
            let r = 2.0 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)).sqrt();
            if is_probe && !(0.1..0.9).contains(&r) {
                continue; // the image of the sphere is a disk
            }
            let found = mapping.uv(point_at(mapping, [u, v]));
            let apart = (found[0] - u).abs().max((found[1] - v).abs());
            prop_assert!(
                apart < ROUNDING,
                "{mapping:?}: ({u}, {v}) comes back as {found:?}, {apart:e} off"
            );
        }
    }

    /// Law: on spheres the distance from the centre does not matter, so a hit that rounding moved off the
    /// sphere keeps its texel. Oracle: the same direction at twice the distance, exactly.
    #[test]
    fn spheres_of_every_radius_have_the_same_coordinates((u, v) in (0.0..1.0_f64, 0.0..1.0_f64)) {
        for mapping in &ALL[2..] {
            let p = point_at(Mapping::Spherical, [u, v]);
            let larger = Point::from(p.to_array().map(|c| 2.0 * c));
            prop_assert_eq!(mapping.uv(p), mapping.uv(larger), "{:?} at {:?}", mapping, p);
        }
    }

    /// Law: texture coordinates are within 0 and 1, on the object and within rounding of it, at poles and
    /// on seams too. Oracle: the range itself.
    /// Book: mappings from points to texture coordinates.
    #[test]
    fn coordinates_are_between_0_and_1(
        corner in prop::array::uniform3(prop::sample::select(vec![
            -1.0, 1.0, 0.0, -0.0, 1e-300, -1e-300, 1e-12, -1e-12, 0.5, -0.7,
        ])),
    ) {
        let p = Point::from(corner);
        for mapping in ALL {
            if mapping == Mapping::Hemispherical && p.y().is_sign_negative() {
                continue; // below the horizon
            }
            let uv = mapping.uv(p);
            prop_assert!(
                uv.iter().all(|c| (0.0..=1.0).contains(c)),
                "{mapping:?} of {p:?}: {uv:?}"
            );
        }
    }
}

/// Law: on a sphere +z is u = 0, +x a quarter, −z a half, −x three quarters, the equator is v = ½, and
/// the north pole is the top row. Oracle: the book's reference points, exactly.
/// Book: mappings from points to texture coordinates.
#[test]
fn the_sphere_is_mapped_as_in_the_book() {
    let uv = |x, y, z| Mapping::Spherical.uv(Point::new(x, y, z));
    let expected = [
        ([0.0, 0.0, 1.0], [0.0, 0.5]),
        ([1.0, 0.0, 0.0], [0.25, 0.5]),
        ([0.0, 0.0, -1.0], [0.5, 0.5]),
        ([-1.0, 0.0, 0.0], [0.75, 0.5]),
    ];
    for ([x, y, z], expected) in expected {
        assert_eq!(uv(x, y, z), expected, "({x}, {y}, {z})");
    }
    assert_eq!(uv(0.0, 1.0, 0.0)[1], 1.0, "north pole");
    assert_eq!(uv(0.0, -1.0, 0.0)[1], 0.0, "south pole");
    assert_eq!(Mapping::Hemispherical.uv(Point::new(0.0, 1.0, 0.0))[1], 1.0, "zenith");
    assert_eq!(Mapping::Hemispherical.uv(Point::new(0.0, 0.0, 1.0))[1], 0.0, "horizon");
}

/// Law: the centre of a light probe is +z, the plane z = 0 is a circle of half the radius, and −z is the rim;
/// the panoramic kind has z the other way round. Oracle: those distances from the middle.
/// Book: light probes.
#[test]
fn a_light_probe_is_mapped_by_the_angle_to_its_axis() {
    let from_middle = |mapping: Mapping, x, y, z| {
        let [u, v] = mapping.uv(Point::new(x, y, z));
        ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)).sqrt()
    };
    for k in 0..16 {
        let phi = TAU * f64::from(k) / 16.0;
        let (x, y) = (cos(phi), sin(phi));
        for mapping in [Mapping::LightProbe, Mapping::Panoramic] {
            let found = from_middle(mapping, x, y, 0.0);
            assert!((found - 0.25).abs() < ROUNDING, "{mapping:?}, φ = {phi}: {found}, not 0.25");
        }
        // 1e-9 of π is 3e-10 of the angle, half of that from the rim
        let near_rim = from_middle(Mapping::LightProbe, 1e-9 * x, 1e-9 * y, -1.0);
        assert!((near_rim - 0.5).abs() < 1e-9, "beside −z: {near_rim}, not 0.5");
    }
    assert_eq!(from_middle(Mapping::LightProbe, 0.0, 0.0, 1.0), 0.0);
    assert_eq!(from_middle(Mapping::LightProbe, 0.0, 0.0, -1.0), 0.5);
    assert_eq!(from_middle(Mapping::Panoramic, 0.0, 0.0, -1.0), 0.0);
    assert_eq!(from_middle(Mapping::Panoramic, 0.0, 0.0, 1.0), 0.5);
    // +x to the right and +y up
    assert_eq!(Mapping::LightProbe.uv(Point::new(1.0, 0.0, 0.0)), [0.75, 0.5]);
    assert_eq!(Mapping::LightProbe.uv(Point::new(0.0, 1.0, 0.0)), [0.5, 0.75]);
}

/// Law: around an object there is one seam, at φ = 0: a step of a thousandth of a turn changes u by as
/// much, but across the seam by 1 less. Oracle: the angle that was stepped.
/// Book: mappings from points to texture coordinates.
#[test]
fn there_is_one_seam() {
    const STEPS: i32 = 1000;
    for mapping in [Mapping::Cylindrical, Mapping::Spherical, Mapping::Hemispherical] {
        // between multiples, so that no point lies on the seam
        let u = |k: i32| {
            let phi = TAU * (f64::from(k) + 0.5) / f64::from(STEPS);
            mapping.uv(Point::new(sin(phi), 0.25, cos(phi)))[0]
        };
        let step = 1.0 / f64::from(STEPS);
        for k in 0..STEPS {
            let expected = if k == STEPS - 1 { step - 1.0 } else { step };
            let found = u(k + 1) - u(k);
            assert!(
                (found - expected).abs() < 1e-12,
                "{mapping:?}, step {k}: {found}, not {expected}"
            );
        }
    }
}
