//! Chapter 27: simple transparency.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | Snell's law and the refracted direction | a refracted direction t obeys `ω_o × n = −η (t × n)`, Snell's angle, plane and sense in one; it has length 1 and is behind the surface | `refraction_obeys_snell` |
//! |  | refraction is reversible: refracted in and then, from the inside, out again, a direction is the original one | `refraction_can_be_reversed` |
//! |  | straight on, a ray goes straight through, whatever η; so does each ray for η = 1 | `nothing_bends_a_ray_at_normal_incidence_or_between_equal_media` |
//! | total internal reflection | a ray from the rarer side is never totally reflected; one from the denser side is, beyond `asin(1/η)` exactly | `total_reflection_needs_the_denser_side` |
//! |  | total reflection begins at 41.8103° in glass, 48.7535° in water, 24.4075° in diamond, and from glass to water at 62.457° | `critical_angles_are_those_of_the_table` |
//! | the transmitted radiance: k_t/η² | an eye inside the dense medium sees `η² k_t B` through its surface: radiance is squeezed into a smaller cone | `radiance_grows_by_eta_squared_in_the_denser_medium` |
//! |  | a ray leaves a slab in its original direction, displaced by `s = T sin(θ_i − θ_t)/cosθ_t`, with the weight `k_t²` (the two η² cancel) | `a_slab_shifts_a_ray_and_weighs_it_kt_squared` |
//! |  | a slab 1 thick of index 1.5 refracts a ray at 45° to 28.1255° and shifts it by 0.329142 | `a_slab_of_glass_shifts_by_a_third_at_45_degrees` |
//! |  | a wall seen at an angle through a slab is the same picture, moved by `s = T sin(θ_i − θ_t)/cosθ_t` towards the foot of the normal, and `k_t²` times as bright | `pictures::a_wall_behind_a_slab_is_seen_shifted` |
//! | the material Transparent and its tree of rays | a body of η = 1, k_r = 0, k_t = 1 cannot be seen, at any depth from 2 on; at a smaller depth it looks black | `a_body_of_index_one_is_invisible` |
//! |  | a glass ball in a uniform background B, depth N ≥ 1, k_r + k_t = 1: it shows `B (1 − k_t k_rᴺ⁻¹)`: `k_r B` at depth 1, `(k_r + k_t²) B` at depth 2, increasing towards B; at depth 0 it is black | `a_glass_ball_adds_up_its_inner_reflections` |
//! |  | among glass bodies one sample casts at most `2^(depth+1) − 1` rays, however many bodies there are | `glass_casts_no_more_rays_than_a_binary_tree` |
//! |  | where every ray hits glass that sends out two further rays, `2ᴺ⁺¹ − 1` rays are cast at depth N, and the two of each of the `2ᴺ` last ones are too deep: `too_deep` counts those, and `reflected` and `transmitted` count them too | `ray_budget::the_last_rays_of_a_full_binary_tree_are_too_deep` |
//! | equation 27.15 and fig. 27.15, total reflection from outside | a bubble (η < 1) reflects everything, with weight 1 and not k_r, where the ray passes the centre at a distance above η r; nearer, it reflects k_r | `the_rim_of_a_bubble_is_a_perfect_mirror` |
//! | the image in a glass ball | a glass ball focuses a distant light at `η r/(2(η − 1))` from its centre: 1.5 r for 1.5 | `a_glass_ball_focuses_at_one_and_a_half_radii` |
//! |  | a ball of glass shows the wall behind it upside down | `pictures::a_ball_of_glass_turns_the_wall_behind_it_around` |
//! | figs. 27.21 and 27.26, two transparent disks | two transparent disks are a pane if their normals are opposite: behind them a ray has its first direction; if both normals point the same way, it enters twice, and has the sine `sinθ/η²` | `disks_of_one_sense_are_entered_twice` |
//! | shadows of transparent objects | glass blocks light like any other object, unless it casts no shadows; only rays that lead to the eye are refracted | `glass_casts_a_full_shadow_unless_it_casts_none` |
//!
//! Beyond the book: 5 in `ray_budget`.

mod pictures;
mod ray_budget;

use explain::RecordedRay;
use groundtruth::lobes::{PerfectTransmitter, refract};
use groundtruth::textures::{Checker3d, Kind as Texture};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::stage::*;

laws_of_light!("ch27": glass_casts_a_full_shadow_unless_it_casts_none);

/// cosθ_t² is divided by η² ≥ 0.16: a few u become about 18u in the length; twice that is allowed.
const ROUNDING: f64 = 36.0 * U;

const BACKGROUND: Rgb = Rgb::new(0.25, 0.5, 1.0);

fn glass(kr: f64, kt: f64, eta: f64) -> Transparent {
    Transparent {
        phong: Phong::default(),
        kr: kr.into(),
        cr: Rgb::WHITE.into(),
        kt: kt.into(),
        eta,
    }
}

fn ball() -> Sphere {
    sphere(Point::ORIGIN, 1.0)
}

fn sine(a: Vector, n: Normal) -> f64 {
    a.cross(n).length()
}

/// The camera ray, and the chain of refracted rays that starts with it.
fn through(tree: &RayTree) -> Vec<&RecordedRay> {
    let mut path = vec![tree.root()];
    loop {
        let here = path[path.len() - 1];
        match here.children.iter().find(|node| node.kind == RayKind::Transmitted) {
            Some(next) => path.push(next),
            None => return path,
        }
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a refracted direction t obeys `ω_o × n = −η (t × n)`, Snell's angle, plane and sense in one;
    /// it has length 1 and is behind the surface. Oracle: cross products, which the code under test does
    /// not use.
    /// Book: Snell's law and the refracted direction.
    #[test]
    fn refraction_obeys_snell((n, wo) in normal_and_direction_above(), eta in 0.4..2.5_f64) {
        let Some(t) = refract(wo, n, eta) else {
            prop_assert!(sine(wo, n) > eta - ROUNDING, "total reflection below the critical angle");
            return Ok(());
        };
        near!(t.length(), 1.0, ROUNDING);
        below!(n.dot(t), ROUNDING);
        below!((wo.cross(n) + eta * t.cross(n)).length(), ROUNDING);
    }

    /// Law: refraction is reversible: refracted in and then, from the inside, out again, a direction is the
    /// original one. Oracle: that direction; near the critical angle the way out is as steep as a square
    /// root.
    /// Book: Snell's law and the refracted direction.
    #[test]
    fn refraction_can_be_reversed((n, wo) in normal_and_direction_above(), eta in 0.4..2.5_f64) {
        let Some(t) = refract(wo, n, eta) else { return Ok(()) };
        let cos_i = n.dot(wo);
        let tolerance = 8.0 * ROUNDING / cos_i;
        match refract(t, -n, 1.0 / eta) {
            Some(back) => prop_assert!((back - wo).length() < tolerance.min(1e-6), "{back:?}"),
            None => prop_assert!(cos_i < 1e-6, "only grazing rays depend on rounding"),
        }
    }

    /// Law: straight on, a ray goes straight through, whatever η; so does each ray for η = 1. Oracle:
    /// −ω_o, to a few u.
    /// Book: Snell's law and the refracted direction.
    #[test]
    fn nothing_bends_a_ray_at_normal_incidence_or_between_equal_media(
        (n, wo) in normal_and_direction_above(),
        eta in 0.4..2.5_f64,
    ) {
        let straight = refract(n.into(), n, eta).expect("no total reflection straight on");
        near!(straight, -n, ROUNDING);
        let same = refract(wo, n, 1.0).expect("no boundary");
        prop_assert!((same + wo).length() <= 4.0 * U, "{same:?}");
    }

    /// Law: a ray from the rarer side is never totally reflected; one from the denser side is, beyond
    /// `asin(1/η)` exactly. Oracle: the sine of the angle against the ratio of the indices.
    /// Book: total internal reflection.
    #[test]
    fn total_reflection_needs_the_denser_side(cos_o in cosine(), eta in 1.0..3.0_f64) {
        let lobe = PerfectTransmitter { transmittance: 1.0, eta };
        prop_assert!(!lobe.reflects_totally(cos_o), "total reflection on the rarer side");
        let sine_squared = (1.0 - cos_o) * (1.0 + cos_o);
        let beyond = sine_squared * eta * eta - 1.0;
        if beyond.abs() >= 16.0 * U {
            prop_assert_eq!(lobe.reflects_totally(-cos_o), beyond > 0.0, "beyond by {}", beyond);
        }
    }

    /// Law: a ray leaves a slab in its original direction, displaced by `s = T sin(θ_i − θ_t)/cosθ_t`, with
    /// the weight `k_t²` (the two η² cancel). Oracle: the closed form in the two angles (ch. 27).
    /// Book: the transmitted radiance: k_t/η².
    #[test]
    fn a_slab_shifts_a_ray_and_weighs_it_kt_squared(
        theta in 0.0..1.4_f64,
        phi in 0.0..TAU,
        eta in 0.75..2.5_f64,
        thickness in 0.01..3.0_f64,
        kt in 0.1..1.0_f64,
    ) {
        prop_assume!(sin(theta) < 0.99 * eta);
        let theta_t = std::f64::consts::FRAC_PI_2 - acos(sin(theta) / eta);
        let shift = thickness * sin(theta - theta_t) / cos(theta_t);
        let mut scene = deep_stage(BACKGROUND, 2);
        let slab =
            boxed(Point::new(-1e3, -thickness, -1e3), Point::new(1e3, 0.0, 1e3));
        put(&mut scene, slab, glass(0.1, kt, eta));
        let to_eye = at_angle(Normal::Y, cos(theta), phi);
        let tree = recorded(&built(&scene), Point::ORIGIN + 2.0 * to_eye, -to_eye);
        let [first, within, after] = through(&tree)[..] else { panic!("in and out") };
        let weight = within.weight * after.weight;
        close!(weight, Rgb::grey(kt * kt), 8.0 * U);
        near!(after.ray.direction, first.ray.direction, 1e-13);
        let aside = (after.ray.origin - first.ray.origin).cross(first.ray.direction).length();
        prop_assert!((aside - shift.abs()).abs() <= 1e-12, "{aside} {shift}");
    }

    /// Law: a body of η = 1, k_r = 0, k_t = 1 cannot be seen, at any depth from 2 on; at a smaller depth it
    /// looks black. Oracle: the scene without it (ch. 27).
    /// Book: the material Transparent and its tree of rays.
    #[test]
    fn a_body_of_index_one_is_invisible(
        to_eye in unit(),
        target in point(0.9),
        depth in 0..6_u32,
        kind in 0..3_usize,
    ) {
        let mut scene = deep_stage(BACKGROUND, depth);
        let shape: shapes::Kind = match kind {
            0 => ball().into(),
            1 => boxed(Point::new(-1.0, -0.5, -0.7), Point::new(1.0, 0.8, 0.9)).into(),
            _ => TessellatedSphere::new(7, 5, true).into(),
        };
        let clear = put(&mut scene, shape, glass(0.0, 1.0, 1.0));
        let checker = Checker3d {
            size: 1.0,
            color1: Rgb::WHITE.into(),
            color2: Rgb::new(0.2, 0.4, 0.1).into(),
        };
        let cd = Paint::from(Texture::from(checker));
        let floor = Plane { point: Point::new(0.0, -2.0, 0.0), normal: Vector::Y };
        put(&mut scene, floor, matte(0.0, 1.0, cd));
        shine(&mut scene, Directional { ls: 3.0, color: Rgb::WHITE, direction: Vector::Y });
        scene.objects[clear].casts_shadows = false;
        let eye = Point::ORIGIN + 3.0 * to_eye;
        let tree = recorded(&built(&scene), eye, target - eye);
        let crossings = through(&tree).len() as u32 - 1;
        scene.objects[clear].enabled = false;
        let without = look(&built(&scene), eye, target - eye);
        let seen = tree.root().radiance;
        match crossings {
            _ if depth < crossings => prop_assert_eq!(seen, Rgb::BLACK),
            0 | 2 => close!(seen, without, 1e-12),
            _ => prop_assert!(depth < 2 && crossings == depth + 1, "{crossings} crossings"),
        }
    }

    /// Law: a glass ball in a uniform background B, depth N ≥ 1, k_r + k_t = 1: it shows
    /// `B (1 − k_t k_rᴺ⁻¹)`: `k_r B` at depth 1, `(k_r + k_t²) B` at depth 2, increasing towards B; at depth
    /// 0 it is black. There is no total reflection inside. Oracle: the geometric series of inner reflections
    /// (ch. 27).
    /// Book: the material Transparent and its tree of rays.
    #[test]
    fn a_glass_ball_adds_up_its_inner_reflections(
        to_eye in unit(),
        target in point(0.55),
        kr in 0.05..0.6_f64,
        eta in 1.05..2.5_f64,
        depth in 0..12_u32,
    ) {
        let mut scene = deep_stage(BACKGROUND, depth);
        put(&mut scene, ball(), glass(kr, 1.0 - kr, eta));
        let (eye, world) = (Point::ORIGIN + 3.0 * to_eye, built(&scene));
        let expected = match depth {
            0 => Rgb::BLACK,
            n => (1.0 - (1.0 - kr) * power(kr, f64::from(n - 1))) * BACKGROUND,
        };
        let seen = look(&world, eye, target - eye);
        close!(seen, expected, 64.0 * U);
        // at each depth one ray leaves the ball and one continues inside
        let counts = counted(&world, eye, target - eye);
        let cast = counts.camera + counts.reflected + counts.transmitted - counts.too_deep;
        prop_assert_eq!(cast, u64::from(2 * depth + 1));
        prop_assert_eq!(counts.too_deep, 2);
    }

    /// Law: a bubble (η < 1) reflects everything, with weight 1 and not k_r, where the ray passes the centre
    /// at a distance above η r; nearer, it reflects k_r. Oracle: the impact parameter (equation 27.15).
    /// Book: equation 27.15 and fig. 27.15, total reflection from outside.
    #[test]
    fn the_rim_of_a_bubble_is_a_perfect_mirror(
        to_eye in unit(),
        target in point(1.0),
        eta in 0.3..0.95_f64,
    ) {
        let mut scene = deep_stage(BACKGROUND, 1);
        put(&mut scene, ball(), glass(0.125, 0.875, eta));
        let eye = Point::ORIGIN + 3.0 * to_eye;
        let offset = (eye - Point::ORIGIN).cross((target - eye).unit().expect("outside")).length();
        let expected = match offset {
            b if b > 1.0 + 1e-12 => BACKGROUND,
            b if b > eta => BACKGROUND,
            _ => 0.125 * BACKGROUND,
        };
        let seen = look(&built(&scene), eye, target - eye);
        prop_assert!((offset - eta).abs() < 1e-12 || seen == expected, "{offset}: {seen:?}");
    }

    /// Law: an eye inside the dense medium sees `η² k_t B` through its surface: radiance is squeezed
    /// into a smaller cone. Oracle: the product; outside, looking in, it is `1/η²` (ch. 27).
    /// Book: the transmitted radiance: k_t/η².
    #[test]
    fn radiance_grows_by_eta_squared_in_the_denser_medium(d in unit(), eta in 1.0..2.5_f64) {
        let mut scene = deep_stage(BACKGROUND, 1);
        put(&mut scene, ball(), glass(0.0, 0.9, eta));
        let seen = look(&built(&scene), Point::ORIGIN, d.into());
        close!(seen, eta * eta * 0.9 * BACKGROUND, 8.0 * U);
        let tree = recorded(&built(&scene), Point::ORIGIN + 3.0 * d, -Vector::from(d));
        close!(through(&tree)[1].weight, Rgb::grey(0.9 / (eta * eta)), 4.0 * U);
    }
}

/// Law: total reflection begins at 41.8103° in glass, 48.7535° in water, 24.4075° in diamond, and from
/// glass to water at 62.457°. Oracle: the table of ch. 27, against the angle found by halving an
/// interval.
/// Book: total internal reflection.
#[test]
fn critical_angles_are_those_of_the_table() {
    for (eta, degrees) in [(1.5, 41.8103), (1.33, 48.7535), (2.42, 24.4075), (1.5 / 1.33, 62.457)] {
        let (mut low, mut high) = (0.0, 90.0);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            let wo = Vector::new(sin(to_radians(middle)), 0.0, cos(to_radians(middle)));
            if refract(wo, Normal::Z, 1.0 / eta).is_some() { low = middle } else { high = middle }
        }
        assert!((low - degrees).abs() < 1e-3, "{eta}: {low}");
    }
}

/// Law: a slab 1 thick of index 1.5 refracts a ray at 45° to 28.1255° and shifts it by 0.329142. Oracle:
/// those numbers (ch. 27).
/// Book: the transmitted radiance: k_t/η².
#[test]
fn a_slab_of_glass_shifts_by_a_third_at_45_degrees() {
    let mut scene = deep_stage(BACKGROUND, 2);
    let slab = boxed(Point::new(-9.0, -1.0, -9.0), Point::new(9.0, 0.0, 9.0));
    put(&mut scene, slab, glass(0.0, 1.0, 1.5));
    let tree = recorded(&built(&scene), Point::new(-1.0, 1.0, 0.0), Vector::new(1.0, -1.0, 0.0));
    let [first, within, after] = through(&tree)[..] else { panic!("in and out") };
    let angle = to_degrees(acos(-within.ray.direction.y()));
    let aside = (after.ray.origin - first.ray.origin).cross(first.ray.direction).length();
    assert!((angle - 28.1255).abs() < 5e-5 && (aside - 0.329142).abs() < 5e-7, "{angle} {aside}");
}

/// Law: a glass ball focuses a distant light at `η r/(2(η − 1))` from its centre: 1.5 r for 1.5. Oracle:
/// the paraxial formula; a ray at height h misses it by order h².
/// Book: the image in a glass ball.
#[test]
fn a_glass_ball_focuses_at_one_and_a_half_radii() {
    for eta in [1.5, 1.8] {
        let mut scene = deep_stage(BACKGROUND, 2);
        put(&mut scene, ball(), glass(0.0, 1.0, eta));
        let h = 1e-3;
        let tree = recorded(&built(&scene), Point::new(-5.0, h, 0.0), Vector::X);
        let out = through(&tree)[2].ray;
        let focus = out.at(-out.origin.y() / out.direction.y()).x();
        assert!((focus - eta / (2.0 * (eta - 1.0))).abs() < 2.0 * h * h, "{eta}: {focus}");
    }
}

/// Law: among glass bodies one sample casts at most `2^(depth+1) − 1` rays, however many bodies there
/// are. Oracle: the full binary tree, over random rays among three glass bodies.
/// Book: the material Transparent and its tree of rays.
#[test]
fn glass_casts_no_more_rays_than_a_binary_tree() {
    let mut scene = deep_stage(BACKGROUND, 7);
    put(&mut scene, ball(), glass(0.2, 0.8, 1.5));
    let inner = sphere(Point::new(0.1, 0.0, 0.0), 0.8);
    put(&mut scene, inner, glass(0.2, 0.8, 1.2));
    let block = boxed(Point::new(-0.4, -0.4, -0.4), Point::new(0.4, 0.3, 0.5));
    put(&mut scene, block, glass(0.2, 0.8, 1.4));
    let (world, mut random, mut most) = (built(&scene), Pcg32::new(27, 0), 0);
    for _ in 0..500 {
        let mut c = || 2.0 * random.uniform() - 1.0;
        let (from, target) = (Point::new(3.0 * c(), 3.0 * c(), 3.0), Point::new(c(), c(), c()));
        let counts = counted(&world, from, target - from);
        most = most.max(counts.camera + counts.reflected + counts.transmitted - counts.too_deep);
    }
    assert!((60..=255).contains(&most), "{most}");
}

/// Law: two transparent disks are a pane if their normals are opposite: behind them a ray has its first
/// direction; if both normals point the same way, it enters twice, and has the sine `sinθ/η²`. Oracle: Snell's law, not
/// at all or twice.
/// Book: figs. 27.21 and 27.26, two transparent disks.
#[test]
fn disks_of_one_sense_are_entered_twice() {
    for (second, entered) in [(-Vector::Z, 0.0), (Vector::Z, 2.0)] {
        let mut scene = deep_stage(BACKGROUND, 2);
        for (z, normal) in [(0.0, Vector::Z), (-3.0, second)] {
            let disk = Disk { center: Point::new(0.0, 0.0, z), normal, radius: 50.0 };
            put(&mut scene, disk, glass(0.0, 1.0, 1.5));
        }
        for theta in [0.0, 0.4, 0.8, 1.2] {
            let to_eye = at_angle(Normal::Z, cos(theta), 0.3);
            let tree = recorded(&built(&scene), Point::ORIGIN + 2.0 * to_eye, -to_eye);
            let [_, _, after] = through(&tree)[..] else { panic!("two disks") };
            near!(sine(after.ray.direction, Normal::Z), sin(theta) / power(1.5, entered), ROUNDING);
        }
    }
}
