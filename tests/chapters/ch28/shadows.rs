//! Shadow rays that pass straight through what is transparent, and pictures of basic radiance: the two
//! switches of a scene's `transparency`.

use groundtruth::scene::{Transparency, TransparentShadows};
use groundtruth::trace::Outcome;

use crate::prelude::*;
use crate::support::stage::recorded;

const STRAIGHT: Transparency =
    Transparency { shadows: TransparentShadows::Attenuated, scales_radiance: true };

/// A white floor, and a slab of this material from y = 1 to y = 1 + thickness over it.
fn under_glass(recipe: impl Into<groundtruth::materials::Kind>, thickness: f64) -> Scene {
    let mut scene = deep_stage(Rgb::BLACK, 2);
    scene.transparency = STRAIGHT;
    let disk = Disk { center: Point::ORIGIN, normal: Vector::Y, radius: 50.0 };
    put(&mut scene, disk, Matte { ka: 0.0.into(), kd: 1.0.into(), cd: Rgb::WHITE.into() });
    let (min, max) = (Point::new(-50.0, 1.0, -50.0), Point::new(50.0, 1.0 + thickness, 50.0));
    put(&mut scene, Cuboid { min, max }, recipe);
    scene
}

fn clear(eta: f64) -> Dielectric {
    Dielectric { inside: Medium::clear(eta), ..Dielectric::default() }
}

/// What the floor shows under glass, over what it shows without.
fn share(scene: &Scene) -> Rgb {
    let floor =
        |scene: &Scene| look(&built(scene), Point::new(0.0, 0.5, 0.0), Vector::new(0.1, -1.0, 0.0));
    let mut open = scene.clone();
    open.objects.truncate(1);
    let [with, without] = [floor(scene), floor(&open)].map(Rgb::to_array);
    Rgb::from(std::array::from_fn(|i| with[i] / without[i]))
}

/// Law: straight on, glass lets `(1 − R)² exp(−σ d)` through, R = .04: from the sun and from a lamp.
/// Oracle: Fresnel's value straight on and Beer's law.
#[test]
fn light_passes_a_pane_straight_on() {
    let absorption = Rgb::new(0.5, 0.0, 1.25);
    let inside = Medium { eta: 1.5, absorption };
    let mut scene = under_glass(Dielectric { inside, ..Dielectric::default() }, 0.5);
    shine(&mut scene, Directional { ls: 2.0, color: Rgb::WHITE, direction: Vector::Y });
    let expected = absorption.map(|sigma| 0.96 * 0.96 * exp(-0.5 * sigma));
    // the lamp is straight above the point that is looked at
    let mut lamp = scene.clone();
    lamp.lights.clear();
    let location = Point::new(0.05, 8.0, 0.0);
    shine(&mut lamp, PointLight { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 });
    for scene in [scene, lamp] {
        let found = share(&scene);
        let off = (found.r - expected.r).abs().max((found.g - expected.g).abs());
        assert!(off.max((found.b - expected.b).abs()) < 1e-14, "{found:?} and {expected:?}");
    }
}

/// Law: a lamp inside glass loses R at the one surface that its light passes, and nothing by `1/η²`: the
/// power of a lamp does not fill a smaller cone. Oracle: .96 (ch. 28).
#[test]
fn a_lamp_in_glass_shines_out_by_one_surface() {
    let mut scene = under_glass(clear(1.5), 8.0);
    let location = Point::new(0.05, 5.0, 0.0);
    shine(&mut scene, PointLight { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 });
    let found = share(&scene).r;
    assert!((found - 0.96).abs() < 1e-14, "{found} instead of 0.96");
}

/// Law: at an angle, both sides of a pane transmit the same share, that of light that is really refracted, up
/// to grazing angles. Oracle: Fresnel's equations in sines and tangents, squared.
#[test]
fn askew_both_sides_of_a_pane_count_alike() {
    /// R by Snell's law, sines and tangents.
    fn reflected(angle: f64, eta: f64) -> f64 {
        let sine = sin(angle) / eta;
        let t = atan2(sine, ((1.0 - sine) * (1.0 + sine)).sqrt());
        let s = sin(angle - t) / sin(angle + t);
        let p = tan(angle - t) / tan(angle + t);
        0.5 * (s * s + p * p)
    }
    for (degrees, eta) in [(10.0_f64, 1.5), (45.0, 1.33), (60.0, 1.5), (85.0, 1.5)] {
        let mut scene = under_glass(clear(eta), 0.5);
        let angle = to_radians(degrees);
        let direction = Vector::new(sin(angle), cos(angle), 0.0);
        shine(&mut scene, Directional { ls: 2.0, color: Rgb::WHITE, direction });
        let passes = 1.0 - reflected(angle, eta);
        let (found, expected) = (share(&scene).r, passes * passes);
        assert!((found - expected).abs() < 1e-12, "{degrees}°: {found} instead of {expected}");
    }
}

/// Law: the same holds for a slab of air in glass, with the light in the glass: the angle is taken as that in
/// the air. Oracle: a slab of glass in air transmits the same share.
#[test]
fn a_bubble_counts_as_a_ball() {
    let inside_out = |inside, outside| Dielectric { inside, outside, ..Dielectric::default() };
    let [air, glass] = [Medium::clear(1.0), Medium::clear(1.5)];
    let shares = [inside_out(glass, air), inside_out(air, glass)].map(|recipe| {
        let mut scene = under_glass(recipe, 0.5);
        shine(
            &mut scene,
            Directional { ls: 2.0, color: Rgb::WHITE, direction: Vector::new(1.0, 1.0, 0.0) },
        );
        share(&scene).r
    });
    assert!((shares[0] - shares[1]).abs() < 1e-14 && shares[0] > 0.8, "{shares:?}");
}

/// Law: simple transparent objects transmit k_t at each of their surfaces, whatever the angle; the ray tree
/// says how many there were; an opaque object blocks the light, also behind glass; and an object that casts
/// no shadow has no effect. Oracle: powers of k_t, and 0.
#[test]
fn simple_glass_counts_kt_for_each_surface() {
    let glass = Transparent {
        phong: Default::default(),
        kr: 0.1.into(),
        cr: Rgb::WHITE.into(),
        kt: 0.9.into(),
        eta: 1.5,
    };
    let mut scene = under_glass(glass.clone(), 0.5);
    shine(
        &mut scene,
        Directional { ls: 2.0, color: Rgb::WHITE, direction: Vector::new(0.2, 1.0, 0.1) },
    );
    let ball = Sphere { center: Point::new(0.45, 3.0, 0.25), radius: 0.5, inward: false };
    put(&mut scene, ball, glass);
    let found = share(&scene).r;
    assert!((found - 0.6561).abs() < 1e-15, "{found} instead of 0.9⁴");
    let tree = recorded(&built(&scene), Point::new(0.0, 0.5, 0.0), Vector::new(0.1, -1.0, 0.0));
    let shadow = tree.rays().pop().expect("a shadow ray");
    assert_eq!(shadow.outcome, Outcome::Unblocked { boundaries: 4 });

    scene.objects[2].casts_shadows = false;
    near!(share(&scene).r, 0.81, 1e-15);
    let above = Disk { center: Point::new(0.0, 9.0, 0.0), normal: Vector::Y, radius: 50.0 };
    let opaque =
        put(&mut scene, above, Matte { ka: 0.0.into(), kd: 0.5.into(), cd: Rgb::WHITE.into() });
    let tree = recorded(&built(&scene), Point::new(0.0, 0.5, 0.0), Vector::new(0.1, -1.0, 0.0));
    let shadow = tree.rays().pop().expect("a shadow ray");
    assert_eq!(shadow.outcome, Outcome::Blocked { blocked_by: opaque as u32 });
    assert_eq!(share(&scene), Rgb::BLACK);
    scene.objects[opaque].enabled = false;
    scene.transparency = Transparency::default();
    assert_eq!(share(&scene), Rgb::BLACK, "opaque, as in the book");
}

/// Law: under a path tracer a lamp that paths can meet is not sampled through glass: its light would be
/// counted twice. A point light is. Oracle: the picture with opaque glass, bit for bit, and k_t².
#[test]
fn paths_do_not_count_a_lamp_twice() {
    let glass = Transparent {
        phong: Default::default(),
        kr: 0.1.into(),
        cr: Rgb::WHITE.into(),
        kt: 0.9.into(),
        eta: 1.5,
    };
    for tracer in
        [Tracer::GlobalTrace(Depth { max_depth: 5 }), Tracer::Path(Depth { max_depth: 5 })]
    {
        let mut scene = under_glass(glass.clone(), 0.5);
        scene.tracer = tracer;
        let disk = Disk { center: Point::new(0.0, 4.0, 0.0), normal: -Vector::Y, radius: 1.0 };
        let lamp = put(&mut scene, disk, Emissive::new(5.0, Rgb::WHITE));
        shine(&mut scene, Area { object: lamp.to_string(), sampling: None });
        let eye = (Point::new(0.0, 0.5, 0.0), Vector::new(0.1, -1.0, 0.0));
        let straight = look(&built(&scene), eye.0, eye.1);
        scene.transparency = Transparency::default();
        assert_eq!(straight, look(&built(&scene), eye.0, eye.1), "{tracer:?}");

        let mut scene = under_glass(glass.clone(), 0.5);
        scene.tracer = tracer;
        let location = Point::new(0.0, 8.0, 0.0);
        shine(&mut scene, PointLight { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 });
        let found = share(&scene).r;
        assert!((found - 0.81).abs() < 1e-14, "{tracer:?}: {found}");
    }
}

/// Law: without the 1/η² of radiance, an eye in glass looking straight out at uniform light 1 sees
/// 1 − R = .96 instead of 2.16, and an eye in air that looks into glass at an emitter in it sees .96
/// instead of .96/2.25; through a whole pane nothing changes, to the last bits, under each tracer.
/// Oracle: those numbers (ch. 28), and each other.
#[test]
fn without_the_factor_a_picture_shows_basic_radiance() {
    let plain = Transparency { scales_radiance: false, ..Transparency::default() };
    let mut scene = deep_stage(Rgb::WHITE, 1);
    put(
        &mut scene,
        Cuboid { min: Point::new(-9.0, -9.0, -9.0), max: Point::new(9.0, 9.0, 0.0) },
        clear(1.5),
    );
    let out = |scene: &Scene| look(&built(scene), Point::new(0.0, 0.0, -4.0), Vector::Z).r;
    let [scaled, basic] = [Transparency::default(), plain].map(|transparency| {
        scene.transparency = transparency;
        out(&scene)
    });
    assert!((scaled - 2.16).abs() < 1e-14 && (basic - 0.96).abs() < 1e-14, "{scaled}, {basic}");

    scene.background = Rgb::BLACK.into();
    let lamp = Disk { center: Point::new(0.0, 0.0, -2.0), normal: Vector::Z, radius: 1.0 };
    put(&mut scene, lamp, Emissive::new(1.0, Rgb::WHITE));
    let into = |scene: &Scene| look(&built(scene), Point::new(0.0, 0.0, 4.0), -Vector::Z).r;
    let [scaled, basic] = [Transparency::default(), plain].map(|transparency| {
        scene.transparency = transparency;
        into(&scene)
    });
    assert!(
        (scaled - 0.96 / 2.25).abs() < 1e-14 && (basic - 0.96).abs() < 1e-14,
        "{scaled}, {basic}"
    );

    let depth = Depth { max_depth: 9 };
    for tracer in [Tracer::PathTrace(depth), Tracer::Path(depth), deep_stage(Rgb::BLACK, 9).tracer]
    {
        let mut scene = deep_stage(Rgb::WHITE, 9);
        scene.tracer = tracer;
        put(
            &mut scene,
            Cuboid { min: Point::new(-9.0, -9.0, -1.0), max: Point::new(9.0, 9.0, 0.0) },
            clear(1.5),
        );
        let through = |scene: &Scene| {
            look(&built(scene), Point::new(0.0, 0.0, 4.0), Vector::new(0.3, 0.1, -1.0)).r
        };
        let scaled = through(&scene);
        scene.transparency = plain;
        let basic = through(&scene);
        assert!((scaled - basic).abs() < 1e-14, "{tracer:?}: {scaled} and {basic}");
    }
}
