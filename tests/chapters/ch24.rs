//! Chapter 24: mirror reflection.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | the direction of reflection | the direction of a reflected ray has length 1, is in the plane of incidence, and is as steep as the incoming one: `d' × n = d × n` and `d'·n = −d·n` | `a_mirror_turns_rays_at_the_angle_they_came_in` |
//! |  | reflected twice, a direction is itself again, bit for bit | `reflecting_twice_changes_nothing` |
//! | the reflected radiance: k_r c_r L | one reflection of a uniform background is `k_r c_r B`, seen from outside and from inside (where the book's mirrors are negative), and black at depth 0 | `one_reflection_of_the_background_is_kr_cr_b` |
//! |  | a perfect mirror ball in a uniform background cannot be seen: L = B, bit for bit | `a_perfect_mirror_ball_in_uniform_light_is_invisible` |
//! |  | an emitter seen by way of k mirrors has the weight `(k_r c_r)ᵏ`: after two mirrors the tint is squared | `an_emitter_over_k_mirrors_weighs_the_kth_power` |
//! | Whitted's tracer and the greatest depth | between two parallel mirrors with the radiance a of their own, depth N gives `Σ_{k≤N} a (k_r c_r)ᵏ`, whatever the angle; beyond N it is black; N + 1 rays are cast | `parallel_mirrors_give_a_geometric_sum` |
//! |  | in a closed room of one material the radiance is `Σ_{k≤N} a k_rᵏ` at every point and in every direction | `a_closed_mirror_room_is_a_furnace` |
//! |  | at depth 0 a reflective surface is its Phong base, and ray casting sees no mirrors either | `without_depth_a_mirror_is_its_base` |
//! |  | a mirror is not a light and does not light the surfaces that face it: only paths from the eye are followed | `a_mirror_lights_no_other_surface` |
//! | images in plane mirrors | what a plane mirror shows is what the mirrored eye sees without it | `a_plane_mirror_shows_what_the_mirrored_eye_sees` |
//! | figs. 24.17 and 24.18, the hall of mirrors | three mirrors at right angles send each ray back where it came from | `a_corner_of_mirrors_sends_rays_back` |
//! |  | three mirrors at right angles show seven more images of the room, mirrored along one, two or three axes and dimmed by one, two or three mirrors | `pictures::a_corner_of_mirrors_shows_eight_rooms` |
//! |  | two facing mirrors show an endless row of rooms; every second one is mirrored, and the k-th is dimmed k times | `pictures::facing_mirrors_show_a_row_of_rooms` |
//! | figs. 24.30 to 24.32, reflective meshes | a smooth mesh reflects about its interpolated normal, and about the flat normal where the interpolated one would send the ray into the mesh | `leaning::a_smooth_mirror_sends_no_ray_inside` |
//! | fig. 24.36, a mirror cone from above | seen straight from above, a mirror cone shows its surroundings: the ring of radius ρ at the height `h (1 − ρ/r)` is reflected away from the axis, at twice the wall's slope from straight up; level if h = r | `a_mirror_cone_from_above_shows_what_is_around_it` |
//! | fig. 24.39, an open mirror cylinder seen from its axis | seen from its axis, an open mirror cylinder shows the sky at its end in rings, the k-th by way of k mirrors: a ray that rises by H/2k of the height H to the end on each radius R of its way is reflected k times, and weighs `(k_r c_r)ᵏ` | `a_mirror_tube_shows_rings_of_the_sky` |
//!
//! Beyond the book: 1 in this file, 1 in `tests/laws/ch24.toml`.

mod leaning;
mod pictures;

use explain::omissions;
use groundtruth::lights::PointLight as Lamp;
use groundtruth::lobes::PerfectSpecular;
use groundtruth::scene::build::phong;
use groundtruth::shapes::Cone;
use testkit::properties::*;

use crate::prelude::*;
use crate::support::stage::*;

laws_of_light!(
    "ch24":
    an_emitter_over_k_mirrors_weighs_the_kth_power,
    a_mirror_lights_no_other_surface,
    a_mirror_tube_shows_rings_of_the_sky,
    an_absorbing_medium_counts_the_whole_way_over_mirrors,
);

const BACKGROUND: Rgb = Rgb::new(0.25, 0.5, 1.0);

/// A mirror whose Phong base is black.
fn mirror(kr: f64, cr: Rgb) -> Reflective {
    Reflective { phong: Phong::default(), kr: kr.into(), cr: cr.into() }
}

/// A mirror that also glows: in ambient light of strength 1 its own radiance is `ka`.
fn glowing(ka: f64, kr: f64, cr: Rgb) -> Reflective {
    let phong = Phong { ka: ka.into(), cd: Rgb::WHITE.into(), ..Phong::default() };
    Reflective { phong, kr: kr.into(), cr: cr.into() }
}

/// A surface with a coloured base and a highlight.
fn shiny() -> Phong {
    phong(0.2, 0.6, Rgb::new(1.0, 0.5, 0.2), 0.3, 5.0)
}

fn ambient(scene: &mut Scene) {
    shine(scene, Ambient { ls: 1.0, color: Rgb::WHITE });
}

/// `a + a q + … + a qⁿ`, added up.
fn geometric(a: f64, q: f64, n: u32) -> f64 {
    (0..=n).map(|k| a * power(q, f64::from(k))).sum()
}

/// The direction of each ray that is not a shadow ray.
fn path(tree: &RayTree) -> Vec<Vector> {
    let shadow = |kind| matches!(kind, RayKind::Shadow { .. });
    tree.rays().iter().filter(|node| !shadow(node.kind)).map(|node| node.ray.direction).collect()
}

proptest! {
    #![proptest_config(laws())]

    /// Law: the direction of a reflected ray has length 1, is in the plane of incidence, and is as steep
    /// as the incoming one: `d' × n = d × n` and `d'·n = −d·n`. Oracle: products the code does not use
    /// (ch. 24).
    /// Book: the direction of reflection.
    #[test]
    fn a_mirror_turns_rays_at_the_angle_they_came_in((n, wo) in normal_and_direction_above()) {
        let mut scene = deep_stage(BACKGROUND, 1);
        put(&mut scene, Plane { point: Point::ORIGIN, normal: n.into() }, mirror(1.0, Rgb::WHITE));
        let tree = recorded(&built(&scene), Point::ORIGIN + 2.0 * wo, -wo);
        let [before, after] = path(&tree)[..] else { panic!("two rays") };
        near!(after.length(), 1.0, 8.0 * U);
        near!(after.cross(n), before.cross(n), 16.0 * U);
        near!(after.dot(n), -before.dot(n), 16.0 * U);
        above!(after.dot(n), 0.0);
    }

    /// Law: reflected twice, a direction is itself again, bit for bit. Oracle: itself.
    /// Book: the direction of reflection.
    #[test]
    fn reflecting_twice_changes_nothing(wo in unit()) {
        let lobe = Lobe::from(PerfectSpecular { reflectance: Rgb::WHITE });
        let wo = Vector::from(wo);
        let once = lobe.sample(wo, [0.5; 2]).map(|sample| sample.wi).expect("mirrors reflect");
        prop_assert_eq!(lobe.sample(once, [0.5; 2]).map(|sample| sample.wi), Some(wo));
        prop_assert_eq!(once.z(), wo.z());
    }

    /// Law: one reflection of a uniform background is `k_r c_r B`, seen from outside and from inside
    /// (where the book's mirrors are negative), and black at depth 0. Oracle: the product.
    /// Book: the reflected radiance: k_r c_r L.
    #[test]
    fn one_reflection_of_the_background_is_kr_cr_b(
        (n, wo) in normal_and_direction_above(),
        kr in 0.01..1.0_f64,
        cr in color(),
        back in any::<bool>(),
    ) {
        let side = if back { -1.0 } else { 1.0 };
        for (depth, expected) in
            [(0, Rgb::BLACK), (1, kr * cr * BACKGROUND), (7, kr * cr * BACKGROUND)]
        {
            let mut scene = deep_stage(BACKGROUND, depth);
            put(&mut scene, Plane { point: Point::ORIGIN, normal: n.into() }, mirror(kr, cr));
            prop_assert_eq!(
                look(&built(&scene), Point::ORIGIN + 2.0 * side * wo, -side * wo),
                expected
            );
        }
    }

    /// Law: between two parallel mirrors with the radiance a of their own, depth N gives
    /// `Σ_{k≤N} a (k_r c_r)ᵏ`, whatever the angle; beyond N it is black; N + 1 rays are cast. Oracle:
    /// the geometric sum, by channel.
    /// Book: Whitted's tracer and the greatest depth.
    #[test]
    fn parallel_mirrors_give_a_geometric_sum(
        depth in 0..40_u32,
        kr in 0.1..1.0_f64,
        cr in color(),
        d in unit(),
    ) {
        prop_assume!(d.y().abs() > 1e-9);
        let mut scene = deep_stage(BACKGROUND, depth);
        for (y, normal) in [(-1.0, Vector::Y), (1.0, -Vector::Y)] {
            put(&mut scene, Plane { point: Point::new(0.0, y, 0.0), normal }, glowing(0.3, kr, cr));
        }
        ambient(&mut scene);
        let world = built(&scene);
        let seen = look(&world, Point::ORIGIN, d.into());
        let expected = cr.map(|cr| geometric(0.3, kr * cr, depth));
        close!(seen, expected, 256.0 * U);
        let counts = counted(&world, Point::ORIGIN, d.into());
        // a mirror that reflects nothing sends no ray
        let reflected = if cr.is_black() { 0 } else { u64::from(depth) + 1 };
        prop_assert_eq!((counts.camera, counts.reflected), (1, reflected));
        prop_assert_eq!(counts.too_deep, u64::from(!cr.is_black()));
    }

    /// Law: in a closed room of one material the radiance is `Σ_{k≤N} a k_rᵏ` at every point and in
    /// every direction. So with depth it tends to `a/(1 − k_r)`, and `a k_r^(N+1)/(1 − k_r)` of that is
    /// missing. Oracle: the furnace (ch. 13, 24). With k_r = 1 and without radiance of its own the room
    /// is black, after N + 1 rays.
    /// Book: Whitted's tracer and the greatest depth.
    #[test]
    fn a_closed_mirror_room_is_a_furnace(
        depth in 0..60_u32,
        round in any::<bool>(),
        from in point(0.5),
        d in unit(),
        kr in 0.1..0.95_f64,
    ) {
        let room = |material: Reflective| {
            let mut scene = deep_stage(BACKGROUND, depth);
            match round {
                true => put(&mut scene, sphere(Point::ORIGIN, 1.0), material),
                false => {
                    let (min, max) = (Point::new(-1.0, -0.7, -2.0), Point::new(0.8, 1.0, 1.5));
                    put(&mut scene, boxed(min, max), material)
                }
            };
            ambient(&mut scene);
            built(&scene)
        };
        let seen = look(&room(glowing(0.2, kr, Rgb::WHITE)), from, d.into()).r;
        let missing = 0.2 * power(kr, f64::from(depth + 1)) / (1.0 - kr);
        prop_assert!((seen + missing - 0.2 / (1.0 - kr)).abs() <= 256.0 * U / (1.0 - kr), "{seen}");
        let dark = room(mirror(1.0, Rgb::WHITE));
        prop_assert_eq!(look(&dark, from, d.into()), Rgb::BLACK);
        prop_assert_eq!(counted(&dark, from, d.into()).reflected, u64::from(depth) + 1);
    }

    /// Law: a perfect mirror ball in a uniform background cannot be seen: L = B, bit for bit. Oracle: B.
    /// Book: the reflected radiance: k_r c_r L.
    #[test]
    fn a_perfect_mirror_ball_in_uniform_light_is_invisible(to_eye in unit(), target in point(1.2)) {
        let mut scene = deep_stage(BACKGROUND, 1);
        put(&mut scene, sphere(Point::ORIGIN, 1.0), mirror(1.0, Rgb::WHITE));
        let eye = Point::ORIGIN + 3.0 * to_eye;
        prop_assert_eq!(look(&built(&scene), eye, target - eye), BACKGROUND);
    }

    /// Law: what a plane mirror shows is what the mirrored eye sees without it. Oracle: that eye, below
    /// the ground.
    /// Book: images in plane mirrors.
    #[test]
    fn a_plane_mirror_shows_what_the_mirrored_eye_sees(eye in point(3.0), spot in point(2.0)) {
        let eye = eye.with(1, eye.y().abs() + 0.5);
        let spot = spot.with(1, 0.0);
        let mut scene = deep_stage(BACKGROUND, 3);
        put(&mut scene, sphere(Point::new(0.0, 2.0, 0.0), 1.5), shiny());
        put(&mut scene, sphere(Point::new(2.0, 1.0, 1.5), 0.9), shiny());
        put(&mut scene, boxed(Point::new(-3.0, 0.5, -3.0), Point::new(-1.0, 3.0, -1.0)), shiny());
        let floor = put(&mut scene, ground(0.0), mirror(1.0, Rgb::WHITE));
        ambient(&mut scene);
        let (ls, color, direction) = (2.0, Rgb::WHITE, Vector::new(1.0, 2.0, 0.5));
        shine(&mut scene, Directional { ls, color, direction });
        let (color, location) = (BACKGROUND, Point::new(0.0, 6.0, 3.0));
        shine(&mut scene, Lamp { ls, color, location, attenuation: 1.0 });
        let world = built(&scene);
        let tree = recorded(&world, eye, spot - eye);
        let Some(hit) = &tree.root().hit else { return Ok(()) };
        prop_assume!(hit.object == world.names.objects[floor]);
        scene.objects[floor].enabled = false;
        let mirrored = eye.with(1, -eye.y());
        close!(tree.root().radiance, look(&built(&scene), mirrored, spot - mirrored), 1e-9);
    }

    /// Law: at depth 0 a reflective surface is its Phong base, and ray casting sees no mirrors either.
    /// Oracle: the Phong material, bit for bit (ch. 24).
    /// Book: Whitted's tracer and the greatest depth.
    #[test]
    fn without_depth_a_mirror_is_its_base((n, wo) in normal_and_direction_above(), sun in unit()) {
        let seen = |mirrored: bool, tracer: Tracer| {
            let mut scene = Scene { tracer, ..stage(BACKGROUND) };
            let plane = Plane { point: Point::ORIGIN, normal: n.into() };
            let covered = Reflective { phong: shiny(), ..mirror(0.5, Rgb::WHITE) };
            put(&mut scene, plane, if mirrored { materials::Kind::from(covered) } else { shiny().into() });
            ambient(&mut scene);
            shine(&mut scene, Directional { ls: 2.0, color: Rgb::WHITE, direction: sun.into() });
            look(&built(&scene), Point::ORIGIN + 2.0 * wo, -wo)
        };
        let whitted = |max_depth| Tracer::Whitted(Whitted { max_depth });
        let plain = seen(false, Tracer::RayCast);
        prop_assert_eq!(seen(true, whitted(0)), plain);
        prop_assert_eq!(seen(true, Tracer::RayCast), plain);
        prop_assert_eq!(seen(false, whitted(5)), plain);
        prop_assert_eq!(seen(true, whitted(1)), plain + 0.5 * BACKGROUND);
    }

    /// Law: three mirrors at right angles send each ray back where it came from. Oracle: −d (the corner
    /// reflector).
    /// Book: figs. 24.17 and 24.18, the hall of mirrors.
    #[test]
    fn a_corner_of_mirrors_sends_rays_back(from in point(1.0), d in unit()) {
        let d = Vector::new(-d.x().abs(), -d.y().abs(), -d.z().abs());
        prop_assume!(d.x() * d.y() * d.z() < -1e-6);
        let mut scene = deep_stage(BACKGROUND, 3);
        for normal in [Vector::X, Vector::Y, Vector::Z] {
            put(
                &mut scene,
                Plane { point: Point::new(-1.0, -1.0, -1.0), normal },
                mirror(1.0, Rgb::WHITE),
            );
        }
        let path = path(&recorded(&built(&scene), from, d));
        prop_assert_eq!(path.len(), 4);
        at_most!((path[3] + path[0]).length(), 32.0 * U);
        prop_assert_eq!(look(&built(&scene), from, d), BACKGROUND);
    }
}

/// Law: a mirror under `ray_cast`, which is black, is explained by a note that names its material; under
/// `whitted` there is nothing to say, and of a matte surface neither. Oracle: the picture, and the name.
#[test]
fn a_mirror_that_is_not_traced_is_named() {
    let mut scene = stage(Rgb::WHITE);
    put(&mut scene, sphere(Point::ORIGIN, 1.0), mirror(1.0, Rgb::WHITE));
    put(&mut scene, ground(-1.0), matte(0.0, 1.0, Rgb::WHITE));
    for (tracer, brightness, notes) in
        [(Tracer::RayCast, 0.0, 1), (Tracer::Whitted(Whitted { max_depth: 3 }), 1.0, 0)]
    {
        scene.tracer = tracer;
        let world = built(&scene);
        assert_eq!(look(&world, Point::new(0.0, 0.0, 3.0), -Vector::Z), Rgb::grey(brightness));
        let mut said = omissions(&world);
        // that the scene has no light is said, too
        said.retain(|note| !note.starts_with("no light is on"));
        assert_eq!(said.len(), notes, "{said:?}");
        assert!(said.iter().all(|note| note.contains("\"0\"")), "{said:?}");
    }
}

/// Law: seen straight from above, a mirror cone shows its surroundings: the ring of radius ρ at the height `h (1 − ρ/r)`
/// is reflected away from the axis, at twice the wall's slope from straight up; level if h = r. Oracle: angles in the
/// plane through the axis.
/// Book: fig. 24.36, a mirror cone from above.
#[test]
fn a_mirror_cone_from_above_shows_what_is_around_it() {
    for (height, radius, rho, phi) in
        [(2.0, 2.0, 0.5, 0.3), (1.0, 2.0, 1.5, 2.0), (3.0, 1.0, 0.4, 4.0)]
    {
        let mut scene = deep_stage(BACKGROUND, 1);
        put(&mut scene, Cone { height, radius, inward: false }, mirror(1.0, Rgb::WHITE));
        let out = Vector::new(sin(phi), 0.0, cos(phi));
        let tree = recorded(&built(&scene), Point::new(0.0, 9.0, 0.0) + rho * out, -Vector::Y);
        let [_, after] = path(&tree)[..] else { panic!("one mirror") };
        let turned = 2.0 * atan2(height, radius);
        near!(after, sin(turned) * out + cos(turned) * Vector::Y, 16.0 * U);
        let at = tree.root().ray.at(tree.root().hit.as_ref().expect("the cone").t);
        near!(at.y(), height * (1.0 - rho / radius), 32.0 * U);
    }
}
