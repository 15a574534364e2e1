//! Where shadow rays begin and end.

use groundtruth::lights::{FakeSpherical, JitteredDirectional, Kind, PointLight as Lamp, Spot};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::lamps::white;
use crate::support::stage::*;

fn lamp(location: Point) -> Lamp {
    Lamp { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 }
}

/// A lamp above a floor, which is seen at the origin.
fn lit(scale: f64, location: Point) -> Scene {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, ground(0.0), white());
    shine(&mut scene, lamp(location.scaled(scale)));
    scene
}

fn seen(scene: &Scene, scale: f64) -> Rgb {
    let eye = Point::new(0.03, 0.01, 0.02).scaled(scale);
    look(&built(scene), eye, Point::ORIGIN - eye)
}

proptest! {
    #![proptest_config(laws())]

    /// Law: an object just in front of a point or spot light blocks it, one just behind it does not, down to
    /// a billionth of the distance, at every scale. Oracle: the order of the distances; the scene without the
    /// object.
    #[test]
    fn the_shadow_ray_ends_at_the_light_to_nine_digits(
        (towards, (cosine, phi)) in ((0.2..1.0_f64, 0.0..TAU), (0.3..1.0_f64, 0.0..TAU)),
        exponent in -9.0..-1.0_f64,
        scale in -20..20_i32,
        is_spot in any::<bool>(),
    ) {
        let towards = at_angle(Normal::Y, towards.0, towards.1);
        let (gap, scale) = (power(10.0, exponent), power_of_two(scale));
        let mut lit = lit(scale, Point::ORIGIN + 3.0 * towards);
        if is_spot {
            let (ls, color, direction, attenuation) = (1.0, Rgb::WHITE, -towards, 0.0);
            let (location, inner, outer) = ((Point::ORIGIN + 3.0 * towards).scaled(scale), 20.0, 40.0);
            lit.lights[0].source = Spot { ls, color, location, direction, inner, outer, attenuation }.into();
        }
        let free = seen(&lit, scale);
        prop_assert!(!free.is_black(), "the lamp does not light the ground");
        let normal = at_angle(Normal::new(towards).expect("unit"), cosine, phi);
        for (side, blocked) in [(-1.0, true), (1.0, false)] {
            let mut scene = lit.clone();
            let center = (Point::ORIGIN + (3.0 + side * gap) * towards).scaled(scale);
            put(&mut scene, Disk { center, normal, radius: 0.5 * scale }, white());
            let expected = if blocked { Rgb::BLACK } else { free };
            prop_assert_eq!(
                seen(&scene, scale),
                expected,
                "a disk at {} of the distance",
                1.0 + side * gap
            );
        }
    }

    /// Law: a surface that a point light lies on does not hide it. Oracle: the scene without the
    /// surface; planes and spheres through the light, at angles from straight on to 5°.
    #[test]
    fn a_surface_that_the_light_lies_on_does_not_hide_it(
        towards in (0.2..1.0_f64, 0.0..TAU),
        (cosine, phi) in (0.1..1.0_f64, 0.0..TAU),
        by in point(1.0),
        radius in 0.01..2.0_f64,
        scale in -20..20_i32,
    ) {
        let towards = at_angle(Normal::Y, towards.0, towards.1);
        let scale = power_of_two(scale);
        let location = Point::ORIGIN + 3.0 * towards;
        let lit = lit(scale, location);
        let normal = at_angle(Normal::new(towards).expect("unit"), cosine, phi);
        let mut with_plane = lit.clone();
        let across = by.to_vector() - normal.dot(by.to_vector()) * normal;
        put(&mut with_plane, Plane { point: (location + across).scaled(scale), normal }, white());
        prop_assert_eq!(seen(&with_plane, scale), seen(&lit, scale));
        // the sphere is behind the light, and not around the eye
        prop_assume!(3.0 * towards.y() + radius * (normal.y() - 1.0) > 0.1);
        let mut with_sphere = lit.clone();
        let center = (location + radius * normal).scaled(scale);
        put(&mut with_sphere, sphere(center, radius * scale), white());
        prop_assert_eq!(seen(&with_sphere, scale), seen(&lit, scale));
    }

    /// Law: light from below the true surface does not light its front, however its normals lean, also if
    /// there is nothing behind it: an open surface hides its own back. Light from above is shaded with the
    /// leaning normal. Oracle: the sides, by both cosines; lights of single directions and jittered ones.
    #[test]
    fn an_open_surface_hides_its_front_from_light_below(
        (lean, turn) in (0.2..1.0_f64, 0.0..TAU),
        wi in unit(),
    ) {
        let leaning = at_angle(Normal::Y, lean, turn);
        let (below, behind) = (wi.y() <= 0.0, wi.dot(leaning) <= 0.0);
        prop_assume!(wi.y().abs() > 1e-6 && wi.dot(leaning).abs() > 1e-6);
        let (ls, color, direction) = (1.0, Rgb::WHITE, Vector::from(wi));
        let location = Point::ORIGIN + 2.0 * direction;
        let sources: [Kind; 4] = [
            Directional { ls, color, direction }.into(),
            lamp(location).into(),
            JitteredDirectional { ls, color, direction, jitter: 0.0 }.into(),
            FakeSpherical { ls, color, location, jitter: 0.0, attenuation: 0.0 }.into(),
        ];
        for source in sources {
            let mut scene = stage(Rgb::BLACK);
            let vertices = [[-9.0, 0.0, -6.0], [0.0, 0.0, 12.0], [9.0, 0.0, -6.0]].map(Point::from);
            put(&mut scene, Triangle { vertices, normals: Some([leaning; 3]) }, white());
            shine(&mut scene, source.clone());
            let found = look(&built(&scene), Point::new(0.0, 1.0, 0.0), -Vector::Y).r;
            let expected = if below || behind { 0.0 } else { FRAC_1_PI * wi.dot(leaning) };
            near!(found, expected, 64.0 * U, "{source:?}");
        }
    }
}
