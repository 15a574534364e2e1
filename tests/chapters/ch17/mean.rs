//! The visible share of the sky, where it has a closed form.

use groundtruth::lights::AmbientOccluder;
use groundtruth::math::Frame;
use groundtruth::samplers::Kind as Sampler;

use super::*;
use crate::prelude::*;
use crate::support::replicas::*;

/// Samples of a pixel.
const SAMPLES: u32 = 1024;

/// The largest standard error that each mean may have: an error of 2 % would be 10 of them.
const POWER: f64 = 2e-3;

/// The radiance of a surface point, in each replica: from a little above it, so that nothing is in between.
fn seen(scene: &Scene, point: Point, normal: impl Into<Vector>) -> Vec<Rgb> {
    let out = normal.into() + 0.3 * Vector::new(0.2, 0.7, -0.4);
    let eye = point + 1e-3 * out;
    replicas(&with_samples(scene.clone(), SAMPLES), |world| view(world, eye, -out))
}

/// Law: a sphere of radius R that lies on a plane occludes the cosine-weighted share `(R/√(R² + x²))³` of the
/// sky at the distance x from the point of contact; `min_amount` of that is added back. Oracle: the closed
/// form (a sphere above the horizon is `sin²α cosθ`, with `sinα = cosθ` here; ch. 17).
/// Book: fig. 17.7, a sphere on a plane.
#[test]
fn a_sphere_on_a_plane_darkens_it_by_the_cube_of_its_sine() {
    for radius in [0.5, 1.0, 30.0] {
        let mut scene = floor(Vector::Y);
        put(&mut scene, ball(Point::new(0.0, radius, 0.0), radius), chalk());
        for share in [0.5, 1.0, 2.0, 3.0] {
            let x = share * radius;
            let sine = radius / (radius * radius + x * x).sqrt();
            let values = seen(&scene, Point::new(0.6 * x, 0.0, 0.8 * x), Vector::Y);
            let what = format!("radius {radius}, distance {x}");
            assert_color(&what, &values, shade(1.0 - sine * sine * sine), 12, POWER);
        }
    }
}

/// Law: where the normal of a sphere above an infinite plane makes the angle a with the plane's, the share
/// `(1 + cos a)/2` of the sky is visible, whatever the height and the azimuth: all at the top, one half at
/// the equator, nothing at the bottom. Oracle: the closed form (ch. 17).
/// Book: fig. 17.7, a sphere on a plane.
#[test]
fn a_sphere_above_a_plane_sees_half_of_one_plus_the_cosine() {
    let up = Normal::new(Vector::new(1.0, 2.0, -0.5)).expect("not zero");
    for (height, cosine) in
        [(1.5, 0.8), (1.5, 0.0), (40.0, 0.3), (1.5, -0.6), (40.0, -0.9), (9.0, 1.0), (9.0, -1.0)]
    {
        let mut scene = floor(up.into());
        let center = Point::ORIGIN + height * up;
        put(&mut scene, ball(center, 1.0), chalk());
        let n = at_angle(up, cosine, 10.0 * cosine);
        let what = format!("height {height}, cosine {cosine}");
        let expected = shade(0.5 * (1.0 + cosine));
        assert_color(&what, &seen(&scene, center + n, n), expected, 7, POWER);
    }
}

/// A wall of height `tall` along a horizontal line at the distance `far` from the origin of the
/// floor, in the direction `phi`; 10⁵ times as long.
fn wall(floor: Normal, phi: f64, tall: f64, far: f64) -> Rectangle {
    let Frame { u, v, w } = Frame::around(floor);
    let (out, along) = (cos(phi) * u + sin(phi) * v, cos(phi) * v - sin(phi) * u);
    let long = 1e5 * (tall + far);
    Rectangle {
        corner: Point::ORIGIN + far * out - long * along,
        a: 2.0 * long * along,
        b: tall * w,
    }
}

/// Law: beside a long wall that rises to the angle a above the horizon the share `(1 + cos a)/2` of the sky
/// is visible, one half if its height is infinite; for every direction of the wall and of the floor, for
/// either front of the wall, and for instances too. Oracle: the closed form of a long strip, `½ (sin φ₂ − sin
/// φ₁)` with angles from the normal: from `π/2 − a` to `π/2` it is `½ (1 − cos a)`.
#[test]
fn beside_a_wall_half_of_one_plus_the_cosine_of_its_height_is_visible() {
    let mut random = Pcg32::new(17, 0);
    for (i, tall) in [0.2, 0.5, 1.0, 2.0, 5.0, 30.0].into_iter().enumerate() {
        let mut c = || random.uniform() - 0.5;
        let normal = Normal::new(Vector::new(c(), c(), c())).expect("not zero");
        let phi = TAU * (c() + 0.5);
        let mut scene = floor(normal.into());
        let wall = wall(normal, phi, tall, 1.0);
        if i % 2 == 0 {
            put(&mut scene, wall, chalk());
        } else {
            let half = Rectangle { a: -0.5 * wall.a, b: 0.5 * wall.b, ..wall };
            let corner = half.corner.to_vector();
            let half = Rectangle { corner: Point::ORIGIN, ..half };
            let steps = vec![Step::Scale(Vector::new(-2.0, -2.0, -2.0)), Step::Translate(corner)];
            // mirrored in its corner to the other side, and shifted back
            let back = vec![Step::Translate(2.0 * half.b)];
            put(&mut scene, Instance::new(Instance::new(half, steps), back), chalk());
        }
        let cosine = 1.0 / (1.0 + tall * tall).sqrt();
        let values = seen(&scene, Point::ORIGIN, normal);
        let what = format!("wall {i} of height {tall} in direction {phi}");
        assert_color(&what, &values, shade(0.5 * (1.0 + cosine)), 6, POWER);
    }
}

/// Law: turning everything around the normal changes nothing: whatever the azimuth, the walls occlude the
/// same share. Oracle: the closed form of a corner of two infinite walls: a quarter is visible.
/// Book: the ambient occluder: one shadow ray.
#[test]
fn the_azimuth_of_the_frame_does_not_matter() {
    for turn in 0..8 {
        let phi = TAU * f64::from(turn) / 8.0 + 0.1;
        let mut scene = floor(Vector::Y);
        for side in [phi, phi + 0.5 * PI] {
            let normal = Vector::new(cos(side), 0.0, sin(side));
            put(&mut scene, Plane { point: Point::ORIGIN + 0.7 * normal, normal }, chalk());
        }
        let values = seen(&scene, Point::ORIGIN, Vector::Y);
        assert_color(&format!("corner turned by {phi}"), &values, shade(0.25), 8, POWER);
    }
}

/// Law: two colours mix by visibility: `V c_open + (1 − V) min c_occluded`. Oracle: this formula, with the
/// wall's V.
/// Book: ambient occlusion in two colours (an exercise).
#[test]
fn two_colours_mix_by_visibility() {
    let occluded = Rgb::new(0.1, 0.2, 1.0);
    for (min_amount, tall) in [(1.0, 1.0), (0.5, 3.0), (0.125, 0.4)] {
        let mut scene = floor(Vector::Y);
        put(&mut scene, wall(Normal::Y, 1.0, tall, 1.0), chalk());
        let source =
            AmbientOccluder { min_amount, occluded_color: Some(occluded), ..super::occluder() };
        scene.lights[0].source = source.into();
        let visible = 0.5 * (1.0 + 1.0 / (1.0 + tall * tall).sqrt());
        let light = LS * (visible * COLOR + ((1.0 - visible) * min_amount) * occluded);
        let what = format!("min_amount {min_amount}, wall of height {tall}");
        assert_color(&what, &seen(&scene, Point::ORIGIN, Vector::Y), (KA * CD) * light, 3, POWER);
    }
}

fn with_max_distance(scene: &mut Scene, max_distance: f64) {
    let source = AmbientOccluder { max_distance: Some(max_distance), ..super::occluder() };
    scene.lights[0].source = source.into();
}

/// Law: objects beyond `max_distance` do not count. Below a ceiling at height h the share `(h/D)²`
/// is visible, as `1 − (h/D)²` of the cosine-weighted sky is within `acos(h/D)` of the zenith.
/// Beside a wall without end at the distance d it is one minus a segment of the unit disk, `(acos q
/// − q √(1 − q²))/π` for `q = d/D`, as the cosine-weighted sky is that disk (Nusselt). Oracle:
/// these closed forms.
#[test]
fn objects_beyond_the_largest_distance_do_not_count() {
    for q in [0.1, 0.5, 0.9] {
        let mut scene = floor(Vector::Y);
        put(&mut scene, Plane { point: Point::new(0.0, q * 4.0, 0.0), normal: Vector::Y }, chalk());
        with_max_distance(&mut scene, 4.0);
        let values = seen(&scene, Point::ORIGIN, Vector::Y);
        assert_color(&format!("ceiling at {q} D"), &values, shade(q * q), 6, POWER);

        scene.objects[1].shape =
            Plane { point: Point::new(q * 4.0, 0.0, 0.0), normal: Vector::X }.into();
        let segment = (acos(q) - q * (1.0 - q * q).sqrt()) / PI;
        let values = seen(&scene, Point::ORIGIN, Vector::Y);
        assert_color(&format!("wall at {q} D"), &values, shade(1.0 - segment), 6, POWER);
    }
}

/// Law: where an interpolated normal leans by δ from the true one, directions below the true
/// surface are blocked by the surface itself: `(1 + cos δ)/2` is visible on a smooth convex mesh
/// alone. Oracle: the share of a tilted plane; δ from the normals that are recorded.
#[test]
fn directions_below_the_true_surface_are_blocked() {
    let mut scene = stage(Rgb::BLACK);
    put(&mut scene, TessellatedSphere::new(5, 4, true), chalk());
    shine(&mut scene, occluder());
    let world = built(&scene);
    let mut leans = 0;
    for i in 0..8 {
        let to_eye = at_angle(Normal::Y, 0.2 * f64::from(i) - 0.7, 1.3 * f64::from(i));
        let tree = recorded(&world, Point::ORIGIN + 3.0 * to_eye, -to_eye);
        let Some(hit) = &tree.root().hit else { panic!("the sphere is there") };
        let cosine = Vector::from(hit.normal).dot(hit.shading_normal);
        leans += u32::from(cosine < 0.97);
        let values = seen(&scene, hit.point, hit.normal);
        let what = format!("point {i}, where the normals' cosine is {cosine}");
        assert_color(&what, &values, shade(0.5 * (1.0 + cosine)), 8, POWER);
    }
    assert!(leans >= 3, "the normals lean at {leans} points only");
}

/// Law: an open surface also blocks directions below itself, although nothing else is behind it. Oracle: the
/// share of a tilted plane, for a triangle with given leaning normals.
#[test]
fn an_open_surface_blocks_directions_below_itself() {
    for cosine in [0.9, 0.5, 0.2] {
        let mut scene = stage(Rgb::BLACK);
        let vertices = [[-3.0, 0.0, -2.0], [0.0, 0.0, 4.0], [3.0, 0.0, -2.0]].map(Point::from);
        let leaning = at_angle(Normal::Y, cosine, 2.0);
        put(&mut scene, Triangle { vertices, normals: Some([leaning; 3]) }, chalk());
        shine(&mut scene, occluder());
        let values = seen(&scene, Point::ORIGIN, Vector::Y);
        let what = format!("a normal that leans by acos {cosine}");
        assert_color(&what, &values, shade(0.5 * (1.0 + cosine)), 3, POWER);
    }
}

/// Law: a mirror shows the floor as dark as it is. Oracle: the closed form of a sphere on a plane,
/// and the mirror itself, which hides half of the sky beside it.
#[test]
fn a_mirror_shows_the_same_occlusion() {
    let mut scene = floor(Vector::Y);
    scene.tracer = Tracer::Whitted(Whitted { max_depth: 3 });
    let phong = Phong { ka: 0.0.into(), kd: 0.0.into(), ks: 0.0.into(), ..Phong::default() };
    let mirror = Reflective { phong, kr: 0.5.into(), cr: Rgb::WHITE.into() };
    put(&mut scene, Plane { point: Point::new(2.0, 0.0, 0.0), normal: -Vector::X }, mirror);
    let scene = with_samples(scene, SAMPLES);
    let (eye, spot) = (Point::new(0.5, 1.0, 0.0), Point::new(1.0, 0.0, 0.3));
    let image = Point::new(3.0, 0.0, 0.3);
    let values = replicas(&scene, |world| view(world, eye, image - eye));
    let direct = replicas(&scene, |world| view(world, eye, spot - eye));
    assert_color("directly", &direct, shade(0.5), 2, POWER);
    assert_color("in the mirror", &values, 0.5 * shade(0.5), 2, POWER);
}

/// Pixels whose variance is taken, and how far the ratio of a sample variance of that many nearly
/// normal values to its expectation may be from 1: five standard deviations `√(2/4096)`.
const PIXELS: u32 = 4096;
const VARIANCE_RATIO: f64 = 5.0 * 0.0221;

/// The variance of the radiance at the origin, in units of unoccluded light, over reseeded pixels.
fn variance(scene: &Scene, sampler: Sampler, samples: u32) -> f64 {
    let mut scene = scene.clone();
    (scene.image.samples, scene.image.sampler) = (samples, Some(sampler));
    let mut world = built(&scene);
    let eye = Point::new(-1e-3, 1e-3, 0.0);
    let mut one = |seed| {
        world.reseed(seed);
        view(&world, eye, Point::ORIGIN - eye).g / shade(1.0).g
    };
    let values: Vec<f64> = (0..u64::from(PIXELS)).map(&mut one).collect();
    let n = f64::from(PIXELS);
    let mean = values.iter().sum::<f64>() / n;
    values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (n - 1.0)
}

/// Law: N independent samples of a point of which the share A is occluded have the standard
/// deviation `√(A (1 − A)/N) (1 − min)`, that of a coin; multi-jittered ones less. Oracle: the
/// binomial distribution (ch. 17), by the variance over reseeded pixels.
/// Book: fig. 17.7, noise by the number of samples.
#[test]
fn noise_is_that_of_a_coin() {
    let mut scene = floor(Vector::Y);
    put(&mut scene, wall(Normal::Y, 0.3, 2.0, 1.0), chalk());
    let occluded = 0.5 * (1.0 - 1.0 / 5.0_f64.sqrt());
    for samples in [4, 16] {
        let expected = occluded * (1.0 - occluded) / f64::from(samples) * (1.0 - MIN) * (1.0 - MIN);
        let found = variance(&scene, Random {}.into(), samples);
        let ratio = found / expected;
        assert!(
            (ratio - 1.0).abs() < VARIANCE_RATIO,
            "{samples} samples: variance {found:e}, expected {expected:e}: ratio {ratio}"
        );
        let spread = variance(&scene, MultiJittered {}.into(), samples) / expected;
        assert!(
            spread < 0.7,
            "{samples} multi-jittered samples have {spread} of a coin's variance"
        );
    }
}

/// Law: an object above a point of an open two-sided surface darkens that side and not the other: each viewer
/// sees the sky of the viewer's side. Oracle: the closed form of a disk parallel to the surface, `R²/(R² +
/// h²)`, and a free sky.
/// Book: open surfaces.
#[test]
fn an_open_surface_is_darkened_on_the_viewers_side() {
    let mut scene = floor(Vector::Y);
    scene.materials[0].two_sided = true;
    for (above, side) in [(true, 1.0), (true, -1.0), (false, 1.0), (false, -1.0)] {
        let mut scene = scene.clone();
        let y = if above { 1.0 } else { -1.0 };
        let (center, normal) = (Point::new(0.0, y, 0.0), Vector::Y);
        let disk = Disk { center, normal, radius: 2.0 };
        put(&mut scene, disk, chalk());
        let visible = if above == (side > 0.0) { 1.0 - 4.0 / 5.0 } else { 1.0 };
        let values = seen(&scene, Point::ORIGIN, side * Vector::Y);
        let what = format!("disk at y = {y}, seen from y = {side}");
        assert_color(&what, &values, shade(visible), 4, POWER);
    }
}

/// Law: a block occludes the view factor of its face; sky is visible around its edges. Oracle: the view
/// factor of a rectangle perpendicular to the surface that stands on it, `(1/2π)(atan(b/c) − (c/√(c² + h²))
/// atan(b/√(c² + h²)))` for one half of width b, height h, distance c.
#[test]
fn a_block_hides_the_view_factor_of_its_face() {
    let (b, h, c) = (1.5, 0.8, 1.0_f64);
    let slant = (c * c + h * h).sqrt();
    let half = (atan2(b, c) - c / slant * atan2(b, slant)) / TAU;
    let mut scene = floor(Vector::Y);
    let block = Cuboid { min: Point::new(-b, 0.0, c), max: Point::new(b, h, c + 1e-6) };
    put(&mut scene, block, chalk());
    let values = seen(&scene, Point::ORIGIN, Vector::Y);
    assert_color("block", &values, shade(1.0 - 2.0 * half), 1, POWER);
}
