//! Chapter 16: shadows.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | shadow rays and the distance of the light | an object behind a point light casts no shadow, one in front of it does; under a directional light an object casts a shadow from any distance | `shadow_ray_stops_at_the_light` |
//! |  | a plane blocks a lamp on its other side, although it has no bounds | `a_plane_casts_a_shadow` |
//! |  | a ray has an occluder within a span exactly if it hits something there | `a_ray_is_blocked_exactly_if_it_hits` |
//! |  | shadows only remove light: for one light, each pixel is the same as without shadows, or black | `shadows_never_brighten` |
//! | self-shadowing and ε | no point of a convex body is in the body's own shadow, at any scale from 1e-6 to 1e6 and for any grazing light: there is no surface acne | `no_convex_body_shades_itself` |
//! |  | by the book's hit functions a planet far from the origin is in its own shadow in many of the pixels that the sun lights, by the library's in none | `acne::the_planet_shades_itself_by_the_textbook_only` |
//! | fig. 16.5, the view from the light | seen from a point light there is no shadow: the picture is the one without shadows, bit for bit; from elsewhere the two differ | `the_view_from_a_light_shows_no_shadow` |
//! | shadows of a sphere | the shadow on y = 0 of a sphere (radius r, centre at height h) is a disc of radius r under a vertical sun, and of radius `H tan(asin(r/(H − h)))` under a lamp at height H | `the_shadow_of_a_sphere_is_a_disc` |
//! | fig. 16.11, shadows of three coloured lights | each light has its own shadow: with three coloured lights, the regions in the shadow of one show the other two (cyan, magenta, yellow), and all these regions occur | `three_coloured_lights_cast_complementary_shadows` |
//! | shadow switches of lights, objects and materials (exercises) | a shadow needs the light's switch, the object's and the material's; those of the receiver do not matter | `a_shadow_needs_the_switches_of_light_object_and_material` |
//!
//! Beyond the book: 3 in `media`, 3 in `segments`, 7 in `tests/laws/ch16.toml`.

mod acne;
mod media;
mod segments;

use groundtruth::cameras;
use groundtruth::lights::PointLight as Lamp;
use groundtruth::render::{pixel, render};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::lamps::white;
use crate::support::stage::*;

laws_of_light!(
    "ch16":
    shadow_ray_stops_at_the_light,
    a_plane_casts_a_shadow,
    a_shadow_needs_the_switches_of_light_object_and_material,
    shadowless_glass_absorbs_only_inside,
    shadowless_glass_leaves_no_shadow_on_the_floor,
    a_surface_inside_a_dielectric_is_lit_through_its_medium,
    a_lamp_under_water_is_dimmed_on_both_ways,
    no_light_comes_through_infinitely_much_water,
    ambient_light_is_dimmed_on_the_way_to_the_eye_only,
    light_without_shadows_is_absorbed_inside_the_body_only,
);

fn sun(direction: Vector) -> Directional {
    Directional { ls: 1.0, color: Rgb::WHITE, direction }
}

fn lamp(location: Point) -> Lamp {
    Lamp { ls: 1.0, color: Rgb::WHITE, location, attenuation: 0.0 }
}

fn ball(x: f64, y: f64, z: f64, radius: f64) -> Sphere {
    sphere(Point::new(x, y, z), radius)
}

/// A heap of shapes over a ground.
fn heap() -> Scene {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, ground(0.0), white());
    put(&mut scene, ball(0.0, 1.2, 0.0, 1.0), white());
    put(&mut scene, ball(1.5, 2.5, -1.0, 0.7), white());
    let block = boxed(Point::new(-2.0, 0.1, -1.0), Point::new(-1.0, 2.0, 1.0));
    put(&mut scene, block, white());
    let disk = Disk { center: Point::new(0.0, 4.0, 0.0), normal: Vector::Y, radius: 0.5 };
    put(&mut scene, disk, white());
    scene.image.width = 80;
    scene.image.height = 60;
    scene.image.pixel_size = 0.1;
    scene.camera.eye = Point::new(4.0, 5.0, 8.0);
    scene.camera.look_at = Point::new(0.0, 1.0, 0.0);
    scene.camera.lens = cameras::Pinhole { distance: 10.0, zoom: 1.0 }.into();
    scene
}

/// Law: seen from a point light there is no shadow: the picture is the one without shadows, bit for bit; from
/// elsewhere the two differ. Oracle: that picture (ch. 16).
/// Book: fig. 16.5, the view from the light.
#[test]
fn the_view_from_a_light_shows_no_shadow() {
    for (eye, equal) in [(Point::new(4.0, 5.0, 8.0), true), (Point::new(0.0, 9.0, 1.0), false)] {
        let mut scene = heap();
        shine(&mut scene, lamp(eye));
        let shadowed = render(&built(&scene));
        scene.lights[0].shadows = false;
        assert_eq!(shadowed == render(&built(&scene)), equal);
    }
}

/// Law: shadows only remove light: for one light, each pixel is the same as without shadows, or black.
/// Oracle: the picture without shadows.
/// Book: shadow rays and the distance of the light.
#[test]
fn shadows_never_brighten() {
    let mut scene = heap();
    shine(&mut scene, sun(Vector::new(1.0, 2.0, 0.3)));
    let shadowed = render(&built(&scene));
    scene.lights[0].shadows = false;
    let free = render(&built(&scene));
    let mut taken = 0;
    for (a, b) in shadowed.pixels().iter().zip(free.pixels()) {
        assert!(a == b || a.is_black(), "{a:?} in shadow, expected {b:?} or black");
        taken += u32::from(a != b);
    }
    assert!(taken > 100, "{taken}");
}

/// Law: the shadow on y = 0 of a sphere (radius r, centre at height h) is a disc of radius r under a
/// vertical sun, and of radius `H tan(asin(r/(H − h)))` under a lamp at height H. Oracle: the closed
/// form (ch. 16), in each pixel of a picture taken from beneath the sphere.
/// Book: shadows of a sphere.
#[test]
fn the_shadow_of_a_sphere_is_a_disc() {
    let (r, h, height) = (0.8, 1.5, 5.0_f64);
    let sine = r / (height - h);
    let wide = height * sine / (1.0 - sine * sine).sqrt();
    let sources: [(lights::Kind, f64); 2] =
        [(sun(Vector::Y).into(), r), (lamp(Point::new(0.0, height, 0.0)).into(), wide)];
    for (source, radius) in sources {
        let mut scene = stage(Rgb::BLACK);
        put(&mut scene, ground(0.0), white());
        put(&mut scene, ball(0.0, h, 0.0, r), white());
        shine(&mut scene, source);
        scene.camera.eye = Point::new(0.0, 0.5, 0.0);
        (scene.image.width, scene.image.height, scene.image.pixel_size) = (90, 90, 0.03);
        let world = built(&scene);
        for i in 0..8100 {
            let at = [i % 90, i / 90];
            let (ray, _) = camera_ray(&world, at, 0);
            let distance =
                (ray.origin.x() * ray.origin.x() + ray.origin.z() * ray.origin.z()).sqrt();
            let dark = pixel(&world, at).is_black();
            // on the edge itself rounding decides
            assert!((distance - radius).abs() < 1e-12 || dark == (distance < radius), "{distance}");
        }
    }
}

/// Law: each light has its own shadow: with three coloured lights, the regions in the shadow of one show the
/// other two (cyan, magenta, yellow), and all these regions occur. Oracle: whether the segment from the
/// ground to a light passes through the sphere, by the distance of its centre (ch. 16).
/// Book: fig. 16.11, shadows of three coloured lights.
#[test]
fn three_coloured_lights_cast_complementary_shadows() {
    let mut scene =
        gallery::find("ch16/coloured-shadows").map(|entry| (entry.build)()).expect("is there");
    scene.image.resize(100, 90);
    scene.image.samples = 1;
    let world = built(&scene);
    let lights = [(3.0, 10.0, 2.0), (-3.0, 10.0, 2.0), (0.0, 10.0, -3.0)]
        .map(|(x, y, z)| Point::new(x, y, z));
    let mut regions = [0; 8];
    for i in 0..9000 {
        let at = [i % 100, i / 100];
        let (ray, _) = camera_ray(&world, at, 0);
        let Some(hit) = world.hit(&ray, Span::AHEAD).filter(|hit| hit.object.index == 1) else {
            continue;
        };
        let p = ray.at(hit.t);
        let arriving = lights.map(|light| {
            let wi = (light - p).unit().expect("far away");
            let across = (Point::ORIGIN - p).cross(wi).length();
            let lit = if across > 1.0 { 1.0 } else { 0.0 };
            lit * 12.0 * wi.y() * (0.35 * 0.7 * FRAC_1_PI)
        });
        let (seen, [r, g, b]) = (pixel(&world, at), arriving);
        close!(seen, Rgb::new(r, g, b), 1e-12);
        regions[arriving.iter().fold(0, |code, c| 2 * code + usize::from(*c > 0.0))] += 1;
    }
    let [_, .., white] = regions;
    let [yellow, magenta, cyan] = [regions[0b110], regions[0b101], regions[0b011]];
    assert!(white > 1000 && yellow > 20 && magenta > 20 && cyan > 20, "{regions:?}");
}

proptest! {
    #![proptest_config(laws())]

    /// Law: no point of a convex body is in the body's own shadow, at any scale from 1e-6 to 1e6 and for any
    /// grazing light: there is no surface acne. Oracle: the same without shadows, bit for bit.
    /// Book: self-shadowing and ε.
    #[test]
    fn no_convex_body_shades_itself(
        exponent in -20..20_i32,
        (n, wi) in normal_and_direction_above(),
        anchor in point(1.0),
        spot in point(1.0),
        kind in 0..4_usize,
        near in any::<bool>(),
    ) {
        let s = power_of_two(exponent);
        let at = |p: Point| p.scaled(s);
        let tiny = 1e-3 * n.x().abs() + 1e-4;
        let big = sphere(at(anchor) - s / tiny * n, s / tiny);
        let block =
            Cuboid { min: at(Point::new(-1.5, -2.0, -1.1)), max: at(Point::new(1.2, 1.0, 2.0)) };
        let shape: shapes::Kind = match kind {
            0 => Plane { point: at(anchor), normal: n.into() }.into(),
            1 => big.into(),
            2 => block.into(),
            _ => TessellatedSphere { radius: s, ..TessellatedSphere::new(7, 5, false) }.into(),
        };
        let mut scene = stage(Rgb::BLACK);
        put(&mut scene, shape, white());
        shine(&mut scene, sun(wi));
        if near {
            scene.lights[0].source = lamp(at(anchor) + 0.5 * s * wi).into();
        }
        let eye = at(anchor) + 4.0 * s * at_angle(n, 0.4, 1.0);
        let target = if kind < 2 {
            at(anchor) + 0.1 * s * n.cross(Vector::new(0.3, 0.5, 0.7))
        } else {
            at(spot)
        };
        let mut shading = |shadows| {
            scene.lights[0].shadows = shadows;
            look(&built(&scene), eye, target - eye)
        };
        let free = shading(false);
        // a lamp inside a body is rightly hidden by it
        prop_assume!(!(near && kind >= 1) || free.is_black() || kind == 1);
        prop_assert_eq!(shading(true), free);
    }

    /// Law: a ray has an occluder within a span exactly if it hits something there. Oracle: `hit` over the
    /// same span.
    /// Book: shadow rays and the distance of the light.
    #[test]
    fn a_ray_is_blocked_exactly_if_it_hits(
        origin in point(4.0),
        d in unit(),
        (min, length) in (0.0..3.0_f64, 0.0..10.0_f64),
    ) {
        let world = built(&heap());
        let (ray, span) = (ray(origin, d.into()), Span { min, max: min + length });
        prop_assert_eq!(world.occluder(&ray, span).is_some(), world.hit(&ray, span).is_some());
    }
}
