//! Chapter 28: realistic transparency.
//!
//! | of the book | what is held | by the law |
//! | --- | --- | --- |
//! | Fresnel's equations | R is half the sum of `sin²(θ_i − θ_t)/sin²(θ_i + θ_t)` and `tan²(θ_i − θ_t)/tan²(θ_i + θ_t)`, for unpolarised light, and T the rest | `fresnel::reflection_is_fresnels_in_terms_of_angles` |
//! |  | of light in the plane of incidence the square of `(η cosθ_i − cosθ_t)/(η cosθ_i + cosθ_t)` is reflected, of light across it that of `(cosθ_i − η cosθ_t)/(cosθ_i + η cosθ_t)`; the rest is transmitted | `polarised::each_polarisation_divides_as_fresnel_says` |
//! |  | R and T of unpolarised light are the means of both polarisations, of each of which they add up to 1 | `polarised::unpolarised_light_is_the_mean` |
//! |  | light that is not reflected is transmitted: R + T = 1 within 8u, and both are from 0 to 1 | `fresnel::reflected_and_transmitted_light_add_up_to_all` |
//! |  | straight on, R is .04 between air and glass, .020059 air and water, .172395 air and diamond, .003608 water and glass, .055081 glass and diamond, .084487 water and diamond, the same for `1/η`, and T is `4η/(η + 1)²` | `fresnel::normal_incidence_reflects_as_in_the_table` |
//! |  | between equal media nothing is reflected, also at grazing incidence; between other media grazing light is reflected entirely | `fresnel::equal_media_reflect_nothing_and_grazing_light_is_reflected_whole` |
//! |  | at the critical angle R is continuous: beyond it 1, before it `1 − R = T ≤ 2 (1 + η²)/(η cosθ_i) √margin`, margin the distance of `sin²θ_i/η²` from 1 | `fresnel::reflection_is_continuous_at_the_critical_angle` |
//! |  | R and T from the other side, at the refracted angle and with `1/η`, are the same | `fresnel::reflection_is_the_same_from_the_other_side` |
//! |  | light polarised in the plane of incidence is not reflected at Brewster's angle, where tan θ = η; straight on, both polarisations are equal | `polarised::light_in_the_plane_passes_whole_at_brewsters_angle` |
//! |  | at Brewster's angle, 56.3099° for glass, only one polarisation is reflected: R = .073964, half of .147929 | `fresnel::at_brewsters_angle_half_of_the_light_is_never_reflected` |
//! | the material Dielectric | the weights of the two lobes are Fresnel's R and, as radiance, `T/η²`; seen from the inner side with `1/η` | `fresnel::the_lobes_weigh_light_by_fresnels_shares` |
//! |  | a body with the same medium on both sides cannot be seen | `equal_media_have_no_boundary` |
//! |  | straight on, a slab of glass transmits `(1 − R)/(1 + R)` and reflects `2R/(1 + R)`: .923077 and .076923 | `a_slab_divides_light_as_all_its_inner_reflections_do` |
//! | fig. 28.5, a ball of index 0.75 | a ball of index .75 reflects all light where a ray passes its centre at more than .75 radii, and nearer Fresnel's R; at depth 1 before uniform white it shows just that | `a_ball_rarer_than_its_surroundings_is_a_mirror_at_its_rim` |
//! | fig. 28.6, a glass ball before white | a glass ball before uniform white, depth N ≥ 1, shows `1 − (1 − R) R^(N−1)` in each pixel, R the Fresnel value of its angle: the angles inside are all equal | `each_pixel_of_a_glass_ball_is_a_geometric_series` |
//! |  | the centre of a glass ball before uniform white is .04, .9616, .998464 and .99993856 at depths 1 to 4 | `the_centre_of_a_glass_ball_has_the_values_of_the_book` |
//! |  | a path that takes one of two branches at each surface has the mean of the ray tree: in uniform white a glass ball shows `1 − (1 − R) R^(N−1)` at depth N by every path tracer, here at depths 1 to 4 | `a_glass_ball_is_the_same_by_paths_as_by_trees` |
//! | fig. 28.7, the world seen from under water | under water the sky is seen within 48.7535° of straight up only, as `η² (1 − R)` times itself; outside that cone, the surface is a perfect mirror of the ground | `snells_window_is_a_cone` |
//! |  | a fisheye that looks straight up from under water sees the whole sky in a disc of 48.7535° of its 90°, as `1 − R` with the exposure `1/η²`, and around it the ground, mirrored in the surface | `pictures::a_fisheye_under_water_sees_snells_window` |
//! | 28.4, colour filtering | transmittances multiply over lengths; each channel by itself | `fresnel::transmittances_multiply` |
//! |  | the transmittance is 1 wherever σ or t is 0, also if the other is ∞; otherwise an infinite σ or t is black | `fresnel::transmittance_is_one_without_medium_or_without_length` |
//! |  | a tinted ball of index 1 lets `cf^(2√(r² − p²))` through at distance p from its centre, by Beer's law | `a_tinted_ball_filters_by_the_length_of_its_chord` |
//! |  | the filters of two slabs multiply: `cf^(t₁ + t₂)`, at an angle `cf^((t₁ + t₂)/cosθ)` | `tinted_slabs_multiply` |
//! |  | each ray is dimmed by the medium it is in, over its own length, also after total reflection and between nested bodies | `each_ray_is_dimmed_by_its_own_medium` |
//! |  | in a medium that absorbs, what is infinitely far away is black, in the channels that it absorbs only; clear channels pass unchanged | `the_background_behind_an_absorbing_medium_is_black` |
//! |  | a slab transmits `(1 − R)² a/(1 − R² a²)` and reflects `R + (1 − R)² R a²/(1 − R² a²)`, `a = exp(−σ T/cosθ_t)`, at every angle and under every tracer that follows glass: exactly with ray trees, and in the mean with paths | `an_absorbing_slab_sums_the_series_under_every_tracer` |
//! | fig. 28.9, balls of five sizes | the colour of glass depends on its size: before uniform white the centre of a ball of radius r shows `R + (1 − R)² cf^(2r)` at depth 2, as a ball of radius 1 with the filter `cf^r` does | `a_larger_ball_of_the_same_glass_is_darker` |
//! | 28.5, nested dielectrics | only the ratio of the indices bends light: glass in water is η = 1.5/1.33, with R = .003608 straight on, on whichever side the eye is | `glass_in_water_hardly_reflects` |
//! | fig. 28.20, a glass box | a ray that enters a box of η > √2 never leaves through a face at right angles to the first; with 1.33 some do | `no_light_leaves_a_glass_block_by_the_next_face` |
//! | 28.6.3, views from inside | an eye in glass looking straight out at uniform light 1, depth 1, sees `η² (1 − R) = 2.16`; with the exposure `1/η²` it sees .96 | `an_eye_in_glass_sees_2_16` |
//! | 28.7 and 28.8, a glass of water and a fish bowl | along every ray through a glass of water, which has 8 parts, or a fish bowl, which has 7, the medium behind a boundary is the one before the next, from air to air: no gap, no overlap, no normal on the wrong side | `vessels::media_follow_one_another_along_every_ray` |
//! |  | straight down through the water of the glass, light passes 1.2 of water and, in the base, .3 of glass, and the reflections are those of water, water to glass, and glass to air | `vessels::straight_down_a_glass_of_water_light_passes_three_boundaries` |
//! |  | the meniscus of the fish bowl is tangent to the water's level and to the glass: x_c = .901388, y_c = .3, β = 18.408° | `vessels::the_meniscus_touches_level_and_glass_without_an_angle` |
//! |  | a glass of water and a fish bowl whose media are all of index 1 and clear cannot be seen | `vessels::vessels_of_one_medium_cannot_be_seen` |
//!
//! Beyond the book: 1 in `fresnel`, 2 in `recorded_optics`, 3 in `shadows`, 5 in `tests/laws/ch28.toml`.

mod fresnel;
mod pictures;
mod polarised;
mod recorded_optics;
mod shadows;
mod vessels;

use explain::RecordedRay;
use groundtruth::render::{pixel, render};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::optics;
use crate::support::stage::*;

laws_of_light!(
    "ch28":
    a_slab_divides_light_as_all_its_inner_reflections_do,
    the_centre_of_a_glass_ball_has_the_values_of_the_book,
    a_glass_ball_is_the_same_by_paths_as_by_trees,
    the_background_behind_an_absorbing_medium_is_black,
    an_absorbing_slab_sums_the_series_under_every_tracer,
    glass_in_water_hardly_reflects,
    light_passes_a_pane_straight_on,
    a_lamp_in_glass_shines_out_by_one_surface,
    askew_both_sides_of_a_pane_count_alike,
    simple_glass_counts_kt_for_each_surface,
    without_the_factor_a_picture_shows_basic_radiance,
    a_ball_rarer_than_its_surroundings_is_a_mirror_at_its_rim,
    a_larger_ball_of_the_same_glass_is_darker,
);

const BACKGROUND: Rgb = Rgb::new(0.25, 0.5, 1.0);

fn glass(inside: Medium, outside: Medium) -> Dielectric {
    Dielectric { inside, outside, ..Dielectric::default() }
}

fn clear(eta: f64) -> Dielectric {
    glass(Medium::clear(eta), Medium::default())
}

/// A medium of this index whose colour filter is `exp(−σ)`.
fn tinted(eta: f64, absorption: Rgb) -> Medium {
    Medium { eta, absorption }
}

fn ball() -> Sphere {
    sphere(Point::ORIGIN, 1.0)
}

fn child(node: &RecordedRay, kind: RayKind) -> Option<&RecordedRay> {
    node.children.iter().find(|node| node.kind == kind)
}

/// Law: a glass ball before uniform white, depth N ≥ 1, shows `1 − (1 − R) R^(N−1)` in each pixel, R the
/// Fresnel value of its angle: the angles inside are all equal. Oracle: that series, with R in terms of
/// sines and tangents, from the pixel's distance to the centre (ch. 28).
/// Book: fig. 28.6, a glass ball before white.
#[test]
fn each_pixel_of_a_glass_ball_is_a_geometric_series() {
    for depth in [0, 1, 2, 3, 4, 6] {
        let mut scene = deep_stage(Rgb::WHITE, depth);
        put(&mut scene, ball(), clear(1.5));
        (scene.image.width, scene.image.height, scene.image.pixel_size) = (41, 41, 0.055);
        let world = built(&scene);
        let film = render(&world);
        for i in 0..41 * 41 {
            let at = [i % 41, i / 41];
            let (ray, _) = camera_ray(&world, at, 0);
            let sine = (ray.origin.x() * ray.origin.x() + ray.origin.y() * ray.origin.y()).sqrt();
            let r = optics::by_angles(sine, 1.5);
            let expected = match depth {
                _ if sine > 1.0 => 1.0,
                0 => 0.0,
                n => 1.0 - (1.0 - r) * power(r, f64::from(n - 1)),
            };
            near!(film.get(at).g, expected, 1e-12, "{depth} {sine}");
        }
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a body with the same medium on both sides cannot be seen. Oracle: the background, exact;
    /// no ray is reflected.
    /// Book: the material Dielectric.
    #[test]
    fn equal_media_have_no_boundary(to_eye in unit(), target in point(0.9), eta in 0.5..3.0_f64) {
        let mut scene = deep_stage(BACKGROUND, 4);
        put(&mut scene, ball(), glass(Medium::clear(eta), Medium::clear(eta)));
        let mesh = TessellatedSphere { radius: 0.8, ..TessellatedSphere::new(5, 4, true) };
        put(&mut scene, mesh, glass(Medium::clear(eta), Medium::clear(eta)));
        let eye = Point::ORIGIN + 3.0 * to_eye;
        prop_assert_eq!(look(&built(&scene), eye, target - eye), BACKGROUND);
        prop_assert_eq!(counted(&built(&scene), eye, target - eye).reflected, 0);
    }

    /// Law: a tinted ball of index 1 lets `cf^(2√(r² − p²))` through at distance p from its centre, by
    /// Beer's law. Oracle: the chord, by Pythagoras (ch. 28).
    /// Book: 28.4, colour filtering.
    #[test]
    fn a_tinted_ball_filters_by_the_length_of_its_chord(
        to_eye in unit(),
        target in point(0.8),
        sigma in color(),
    ) {
        let mut scene = deep_stage(BACKGROUND, 2);
        put(&mut scene, ball(), glass(tinted(1.0, 3.0 * sigma), Medium::default()));
        let eye = Point::ORIGIN + 3.0 * to_eye;
        let d = (target - eye).unit().expect("outside");
        let p = (eye - Point::ORIGIN).cross(d).length();
        let chord = 2.0 * (1.0 - p * p).max(0.0).sqrt();
        let expected = sigma.map(|sigma| exp(-3.0 * sigma * chord)) * BACKGROUND;
        let seen = look(&built(&scene), eye, d);
        // the chord's end is known to some u over the cosine
        let tolerance = 64.0 * U * (1.0 + 6.0 / chord.max(1e-9));
        close!(seen, expected, tolerance);
    }

    /// Law: the filters of two slabs multiply: `cf^(t₁ + t₂)`, at an angle `cf^((t₁ + t₂)/cosθ)`. Oracle:
    /// one exponential (Beer; ch. 28).
    /// Book: 28.4, colour filtering.
    #[test]
    fn tinted_slabs_multiply(
        (t1, t2) in (0.0..2.0_f64, 0.0..2.0_f64),
        (cosine, phi) in (0.2..1.0_f64, 0.0..TAU),
        sigma in color(),
    ) {
        let mut scene = deep_stage(BACKGROUND, 4);
        let below = |top: f64, t: f64| {
            let (min, max) = (Point::new(-1e3, top - t - 1e-3, -1e3), Point::new(1e3, top, 1e3));
            boxed(min, max)
        };
        for (top, t) in [(0.0, t1), (-4.0, t2)] {
            put(&mut scene, below(top, t), glass(tinted(1.0, sigma), Medium::default()));
        }
        let to_eye = at_angle(Normal::Y, cosine, phi);
        let seen = look(&built(&scene), Point::ORIGIN + 2.0 * to_eye, -to_eye);
        let length = (t1 + t2 + 2e-3) / cosine;
        let expected = sigma.map(|sigma| exp(-sigma * length)) * BACKGROUND;
        close!(seen, expected, 1e-12);
    }

    /// Law: each ray is dimmed by the medium it is in, over its own length, also after total reflection and
    /// between nested bodies. Oracle: for each ray of the tree, the balls that contain its midpoint, and the
    /// exponential of its length (ch. 28: `t` of the secondary ray, not of the hit before).
    /// Book: 28.4, colour filtering.
    #[test]
    fn each_ray_is_dimmed_by_its_own_medium(
        from in point(3.0),
        target in point(1.5),
        (outer, inner) in (1.0..2.5_f64, 1.0..2.5_f64),
    ) {
        let media = [
            Medium::default(),
            tinted(outer, Rgb::new(0.1, 0.2, 0.3)),
            tinted(inner, Rgb::new(0.7, 0.0, 0.4)),
        ];
        let balls = [
            Sphere { radius: 2.0, ..ball() },
            sphere(Point::new(0.5, 0.0, 0.3), 0.9),
        ];
        let mut scene = deep_stage(BACKGROUND, 5);
        put(&mut scene, balls[0].clone(), glass(media[1], media[0]));
        put(&mut scene, balls[1].clone(), glass(media[2], media[1]));
        let within = |p: Point| balls.iter().filter(|b| b.center.distance(p) < b.radius).count();
        scene.camera.medium = media[within(from)];
        let tree = recorded(&built(&scene), from, target - from);
        for node in tree.rays() {
            let Some(hit) = &node.hit else {
                prop_assert_eq!(node.transmittance, Rgb::WHITE);
                continue;
            };
            prop_assume!(hit.t > 1e-9);
            let sigma = media[within(node.ray.at(0.5 * hit.t))].absorption;
            let expected = sigma.map(|sigma| exp(-sigma * hit.t));
            close!(node.transmittance, expected, 8.0 * U);
            prop_assert_eq!(node.folded(), node.radiance);
        }
    }

    /// Law: under water the sky is seen within 48.7535° of straight up only, as `η² (1 − R)` times itself;
    /// outside that cone, the surface is a perfect mirror of the ground. Oracle: the critical angle, and
    /// black or an emitter beneath (the Snell window; ch. 28).
    /// Book: fig. 28.7, the world seen from under water.
    #[test]
    fn snells_window_is_a_cone(degrees in 0.0..89.9_f64, phi in 0.0..TAU) {
        let theta = groundtruth::math::to_radians(degrees);
        let mut scene = deep_stage(Rgb::WHITE, 1);
        let water = glass(Medium::clear(1.33), Medium::default());
        put(&mut scene, ground(0.0), water);
        let deep = Plane { point: Point::new(0.0, -3.0, 0.0), normal: Vector::Y };
        put(&mut scene, deep, Emissive::new(0.5, Rgb::new(1.0, 0.0, 0.0)));
        scene.camera.medium = Medium::clear(1.33);
        let eye = Point::new(0.0, -1.0, 0.0);
        let tree = recorded(&built(&scene), eye, at_angle(Normal::Y, cos(theta), phi));
        let (seen, outside) = (tree.root().radiance, 1.33 * sin(theta));
        if (degrees - 48.7535).abs() < 1e-3 {
            return Ok(());
        }
        if degrees > 48.7535 {
            prop_assert_eq!(seen, Rgb::new(0.5, 0.0, 0.0));
            prop_assert_eq!(tree.rays().len(), 2);
        } else {
            let r = optics::by_angles(outside, 1.33);
            let sky = (1.33 * 1.33) * (1.0 - r);
            near!(seen.b, sky, 1e-11);
            near!(seen.r - sky, 0.5 * r, 1e-11);
        }
    }
}

/// Law: an eye in glass looking straight out at uniform light 1, depth 1, sees `η² (1 − R) = 2.16`; with
/// the exposure `1/η²` it sees .96. Oracle: those numbers (ch. 28).
/// Book: 28.6.3, views from inside.
#[test]
fn an_eye_in_glass_sees_2_16() {
    let mut scene = deep_stage(Rgb::WHITE, 1);
    put(&mut scene, Plane { point: Point::ORIGIN, normal: Vector::Z }, clear(1.5));
    scene.camera.eye = Point::new(0.0, 0.0, -5.0);
    scene.camera.medium = Medium::clear(1.5);
    scene.camera.look_at = Point::ORIGIN;
    // the reflected ray ends on a black surface
    let dark = Plane { point: Point::new(0.0, 0.0, -9.0), normal: -Vector::Z };
    put(&mut scene, dark, Emissive::new(0.0, Rgb::WHITE));
    close!(pixel(&built(&scene), [0, 0]), Rgb::grey(2.16), 16.0 * U);
    scene.camera.exposure_time = 1.0 / 2.25;
    close!(pixel(&built(&scene), [0, 0]), Rgb::grey(0.96), 16.0 * U);
}

/// Law: a ray that enters a box of η > √2 never leaves through a face at right angles to the first; with 1.33
/// some do. Oracle: the inequality `sin² ≥ 1 − 1/η² > 1/η²`, counted over 10⁴ random rays (ch. 28).
/// Book: fig. 28.20, a glass box.
#[test]
fn no_light_leaves_a_glass_block_by_the_next_face() {
    let escapes = |eta: f64| {
        let mut scene = deep_stage(BACKGROUND, 2);
        let block = boxed(Point::new(-1.0, -1.0, -1.0), Point::new(1.0, 1.0, 1.0));
        put(&mut scene, block, clear(eta));
        let (world, mut random) = (built(&scene), Pcg32::new(28, 0));
        let mut count = 0;
        for _ in 0..10_000 {
            let mut c = || 2.0 * random.uniform() - 1.0;
            let (spot, away) = (Point::new(c(), c(), 1.0), Vector::new(5.0 * c(), 5.0 * c(), 1.0));
            let tree = recorded(&world, spot + away, -away);
            let inside = child(tree.root(), RayKind::Transmitted).expect("glass lets light in");
            let Some(hit) = &inside.hit else { panic!("a closed box") };
            let out = child(inside, RayKind::Transmitted).is_some();
            count += u32::from(out && hit.normal.z() == 0.0);
        }
        count
    };
    assert_eq!((escapes(1.5), escapes(1.42)), (0, 0));
    above!(escapes(1.33), 50);
}
