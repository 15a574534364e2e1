//! Chapter 10: depth of field.

use groundtruth::cameras::{Camera, Eye, Kind, Pinhole, ThinLens, ViewPlane, Viewpoint};
use groundtruth::materials::Reflective;
use groundtruth::math::{Point, Ray, Vector, cos, sin};
use groundtruth::rgb::Rgb;
use groundtruth::samplers::{Jittered, Random};
use groundtruth::scene::{Image, Material, Object, Scene, Tracer, Whitted};
use groundtruth::shapes::{Disk, Rectangle};
use groundtruth::{render, trace};
use proptest::prelude::*;
use std::f64::consts::TAU;
use std::sync::Arc;

use crate::calibration::{assert_seen_where_projected, point_at, scene as calibration};
use crate::ch02::statistics::{most_sigmas, sigmas};
use crate::pictures::studio::{add_flat, assert_same_bits, built, pixels, small};
use crate::support::{ANY_FILM, laws};

fn camera(lens: &ThinLens) -> Arc<dyn Camera> {
    Kind::from(lens.clone()).build(&mut ANY_FILM.clone()).expect("a valid lens")
}

/// Lenses of all sizes, focused before and behind their view plane.
fn lens() -> impl Strategy<Value = ThinLens> {
    (1.0..100.0_f64, 0.5..500.0_f64, 0.01..10.0_f64, 0.2..5.0_f64).prop_map(
        |(distance, focal_distance, lens_radius, zoom)| ThinLens {
            distance,
            focal_distance,
            lens_radius,
            zoom,
        },
    )
}

fn rim(turn: f64) -> [f64; 2] {
    [cos(TAU * turn), sin(TAU * turn)]
}

/// Where a ray is at the depth z along −w.
fn at_depth((origin, direction): (Point, Vector), z: f64) -> [f64; 2] {
    let p = origin + ((origin.z() + z) / -direction.z()) * direction;
    [p.x(), p.y()]
}

fn traced(camera: &dyn Camera, film: [f64; 2], lens: [f64; 2]) -> (Point, Vector) {
    camera.ray(film, lens).expect("a thin lens sees all its film")
}

/// The film place whose ray from a point of the lens passes the point at (x, y) in the depth z: found
/// from two rays, as places at a depth depend linearly on the film.
fn place_of(camera: &dyn Camera, lens: [f64; 2], point: [f64; 2], z: f64) -> [f64; 2] {
    let [a, b] = [[0.0, 0.0], [1.0, 1.0]].map(|film| at_depth(traced(camera, film, lens), z));
    [0, 1].map(|i| (point[i] - a[i]) / (b[i] - a[i]))
}

fn distance([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    ((a - c) * (a - c) + (b - d) * (b - d)).sqrt()
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a lens of radius 0 is the pinhole of the same distance and zoom, bit for bit, wherever on
    /// the lens and wherever focused.
    #[test]
    fn a_lens_of_radius_0_is_the_pinhole(
        lens in lens(), x in -50.0..50.0_f64, y in -50.0..50.0_f64, turn in 0.0..1.0_f64,
    ) {
        let ThinLens { distance, zoom, .. } = lens;
        let pinhole = Kind::from(Pinhole { distance, zoom }).build(&mut ANY_FILM.clone());
        let expected = pinhole.expect("a valid pinhole").ray([x, y], [0.0; 2]);
        let found = camera(&ThinLens { lens_radius: 0.0, ..lens.clone() }).ray([x, y], rim(turn));
        prop_assert_eq!(found, expected);
        // the centre of any lens is the pinhole, too
        prop_assert_eq!(camera(&lens).ray([x, y], [0.0; 2]), expected);
    }

    /// Law: all rays of a film point meet in one point at the depth f along −w, at `(f/d) p`: the
    /// sharp surface is a plane, not a sphere. Oracle: similar triangles.
    #[test]
    fn the_rays_of_a_film_point_meet_at_the_focal_distance(
        lens in lens(), x in -50.0..50.0_f64, y in -50.0..50.0_f64, turn in 0.0..1.0_f64, r in 0.0..1.0_f64,
    ) {
        let f = lens.focal_distance;
        let camera = camera(&lens);
        let there = rim(turn).map(|l| r * l);
        let meets = at_depth(traced(&*camera, [x, y], there), f);
        let expected = [x, y].map(|c| c / lens.zoom * f / lens.distance);
        let size = distance(expected, [0.0; 2]) + lens.lens_radius + f;
        prop_assert!(distance(meets, expected) < 1e-9 * size, "{meets:?} {expected:?}");
        // and nowhere else: before and behind it they are apart
        let [near, far] = [0.5, 2.0].map(|k| at_depth(traced(&*camera, [x, y], rim(turn)), k * f));
        let centre = [0.5, 2.0].map(|k| at_depth(traced(&*camera, [x, y], [0.0; 2]), k * f));
        prop_assert!((distance(near, centre[0]) - 0.5 * lens.lens_radius).abs() < 1e-9 * size);
        prop_assert!((distance(far, centre[1]) - lens.lens_radius).abs() < 1e-9 * size);
    }

    /// Law: rays start on the lens: a disk of the radius R about the eye, across −w.
    #[test]
    fn rays_start_on_the_lens(lens in lens(), turn in 0.0..1.0_f64, r in 0.0..1.0_f64) {
        let [a, b] = rim(turn).map(|l| r * l);
        let (origin, _) = traced(&*camera(&lens), [3.0, -7.0], [a, b]);
        let expected = Point::new(lens.lens_radius * a, lens.lens_radius * b, 0.0);
        prop_assert_eq!(origin, expected);
    }

    /// Law: a point at the depth z is a disc on the view plane, of the diameter `2 R d |z − f|/(z f)`,
    /// about the place where it is projected. Oracle: the formula (similar triangles), beside the
    /// places whose rays from the lens's rim pass the point.
    #[test]
    fn the_circle_of_confusion(
        lens in lens(), x in -20.0..20.0_f64, y in -20.0..20.0_f64, z in 0.5..500.0_f64, turn in 0.0..1.0_f64,
    ) {
        let ThinLens { distance: d, focal_distance: f, lens_radius, zoom } = lens;
        let camera = camera(&lens);
        let centre = camera.project(Point::new(x, y, -z)).expect("it is ahead");
        let diameter = 2.0 * lens_radius * d * (z - f).abs() / (z * f) * zoom;
        let place = place_of(&*camera, rim(turn), [x, y], z);
        let opposite = place_of(&*camera, rim(turn + 0.5), [x, y], z);
        let slack = 1e-9 * (zoom * d * (1.0 + (lens_radius + 30.0) / z + lens_radius / f));
        prop_assert!((distance(place, opposite) - diameter).abs() < slack);
        prop_assert!((distance(place, centre) - 0.5 * diameter).abs() < slack);
        // on the side of the lens point if it is behind the sharp plane, turned around before it
        let side = (place[0] - centre[0]) * rim(turn)[0] + (place[1] - centre[1]) * rim(turn)[1];
        prop_assert!(side * (z - f) > -slack * (z - f).abs());
    }

    /// Law: the blur of a point grows with the radius, twice as large to the bit, and does not move
    /// its middle; the far limit is `2 R d/f`; at the depth f there is none, whatever the radius.
    #[test]
    fn blur_is_linear_in_the_radius(lens in lens(), z in 0.5..500.0_f64, turn in 0.0..1.0_f64) {
        let blur = |lens: &ThinLens, z: f64| {
            let (a, b) = (rim(turn), rim(turn).map(|l| -l));
            let camera = camera(lens);
            distance(place_of(&*camera, a, [0.0; 2], z), place_of(&*camera, b, [0.0; 2], z))
        };
        let twice = ThinLens { lens_radius: 2.0 * lens.lens_radius, ..lens.clone() };
        // the places of the points are differences of larger numbers
        let slack = |z: f64| 1e-11 * (lens.zoom * lens.distance * lens.lens_radius) * (1.0 / z + 1.0 / lens.focal_distance);
        prop_assert!((blur(&twice, z) - 2.0 * blur(&lens, z)).abs() <= slack(z));
        let limit = 2.0 * lens.lens_radius * lens.distance / lens.focal_distance * lens.zoom;
        prop_assert!((blur(&lens, 1e9) - limit).abs() < 1e-6 * limit);
        prop_assert!(blur(&lens, lens.focal_distance) < slack(lens.focal_distance));
    }

    /// Law: the distance of the view plane scales the picture and nothing else: k times the film of k
    /// times the distance has the same rays; so has k times the film of k times the zoom.
    #[test]
    fn the_distance_only_scales(
        lens in lens(), x in -50.0..50.0_f64, y in -50.0..50.0_f64, turn in 0.0..1.0_f64, k in 0.1..10.0_f64,
    ) {
        let (origin, direction) = traced(&*camera(&lens), [x, y], rim(turn));
        let farther = ThinLens { distance: k * lens.distance, ..lens.clone() };
        let zoomed = ThinLens { zoom: k * lens.zoom, ..lens.clone() };
        for other in [farther, zoomed] {
            let (o, d) = traced(&*camera(&other), [k * x, k * y], rim(turn));
            prop_assert_eq!(o, origin);
            let turned = d.unit().expect("it looks") - direction.unit().expect("it looks");
            prop_assert!(turned.length() < 1e-13);
        }
    }
}

/// Law: the whole picture of a lens of radius 0 is the pinhole's, bit for bit; it draws nothing for a
/// lens that it has not.
#[test]
fn a_picture_through_a_lens_of_radius_0_is_the_pinholes() {
    for name in ["ch14/page-one", "ch24/reflective-set"] {
        let mut scene = small(name, 40, 30, 4);
        let pinhole = render::render(&built(&scene));
        let Kind::Pinhole(Pinhole { distance, zoom }) = scene.camera.lens else {
            panic!("{name} has no pinhole")
        };
        let lens_radius = 0.0;
        scene.camera.lens =
            ThinLens { distance, zoom, focal_distance: 0.7 * distance, lens_radius }.into();
        let world = built(&scene);
        assert_same_bits(name, &render::render(&world), &pinhole);
        assert_eq!(render::camera_sample(&world, [3, 4], 1).expect("no gap").lens, None);
        // a lens worth the name changes it
        scene.camera.lens =
            ThinLens { distance, zoom, focal_distance: 10.0 * distance, lens_radius: 20.0 }.into();
        assert!(render::render(&built(&scene)) != pinhole);
    }
}

/// A lens of radius 1 looking at nothing, with four samples in each of 150 × 100 pixels.
fn nothing_through_a_lens() -> Scene {
    let lens = ThinLens { distance: 40.0, focal_distance: 74.0, lens_radius: 1.0, zoom: 1.0 };
    let camera = Viewpoint::new(Point::new(0.0, 0.0, 50.0), Point::ORIGIN, lens);
    Scene::new("", Image { samples: 4, ..Image::new(150, 100) }, camera)
}

/// Law: samples are uniform over the lens: `E[r²] = R²/2`, `E[r⁴] = R⁴/3`, and the means of lx and ly
/// are 0. Oracle: the integrals; random samples are independent, so that z tests apply.
#[test]
fn lens_samples_are_uniform() {
    let mut scene = nothing_through_a_lens();
    scene.image.samples = 64;
    scene.image.sampler = Some(Random {}.into());
    let mut world = built(&scene);
    let mut samples = Vec::new();
    // one pixel for each seed: the pixels of one picture share 83 sets
    for seed in 0..300 {
        world.reseed(seed);
        for index in 0..64 {
            let sample = render::camera_sample(&world, [5, 7], index).expect("no gap");
            let (ray, lens) = (sample.ray.expect("it sees"), sample.lens.expect("it has a lens"));
            // the ray starts there
            assert_eq!(ray.origin, Point::new(lens[0], lens[1], 50.0));
            samples.push(lens);
        }
    }
    type Moment = fn([f64; 2]) -> f64;
    let moments: [(Moment, f64); 5] = [
        (|[x, _]| x, 0.0),
        (|[_, y]| y, 0.0),
        (|[x, y]| x * y, 0.0),
        (|[x, y]| x * x + y * y, 0.5),
        (|[x, y]| (x * x + y * y) * (x * x + y * y), 1.0 / 3.0),
    ];
    for (moment, expected) in moments {
        let values: Vec<f64> = samples.iter().map(|&lens| moment(lens)).collect();
        assert!(sigmas(&values, expected).abs() < most_sigmas(5), "{expected}");
    }
}

/// Law: the samples of pixel and lens have nothing to do with each other, which would show as bands:
/// over pixels, no place in the pixel correlates with a place on the lens, for patterns that are
/// shuffled. Oracle: products of centred coordinates have the mean 0.
#[test]
fn pixel_and_lens_samples_are_paired_by_chance() {
    let mut scene = nothing_through_a_lens();
    for sampler in [None, Some(Jittered {}.into())] {
        scene.image.sampler = sampler;
        let world = built(&scene);
        let pairs: Vec<([f64; 2], [f64; 2])> = pixels(150, 100)
            .map(|at| {
                let sample = render::camera_sample(&world, at, 2).expect("no gap");
                let corner = render::film_place(&world.image, at, [0.5, 0.5]);
                let place = [sample.film[0] - corner[0], sample.film[1] - corner[1]];
                (place, sample.lens.expect("it has a lens"))
            })
            .collect();
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let products: Vec<f64> = pairs.iter().map(|(p, l)| p[i] * l[j]).collect();
            assert!(sigmas(&products, 0.0).abs() < most_sigmas(8), "{i} {j}");
        }
    }
}

/// Law: blur moves light and keeps its sum: a shining disk gives as much light in the whole picture,
/// `π ρ² (d/z)²` film units, with any lens and focus. Oracle: the closed form; standard error over 16
/// seeds.
#[test]
fn blur_keeps_the_light() {
    let (rho, z) = (3.0, 80.0);
    for (focal_distance, lens_radius) in [(80.0, 2.0), (40.0, 1.0), (200.0, 3.0), (40.0, 0.0)] {
        let lens = ThinLens { distance: 100.0, focal_distance, lens_radius, zoom: 1.0 };
        let camera = Viewpoint::new(Point::new(0.0, 0.0, z), Point::ORIGIN, lens);
        let mut scene = Scene::new("", Image { samples: 4, ..Image::new(22, 22) }, camera);
        let disk = Disk { center: Point::new(0.3, -0.2, 0.0), normal: Vector::Z, radius: rho };
        add_flat(&mut scene, "disk", disk, Rgb::WHITE);
        let mut world = built(&scene);
        let light: Vec<f64> = (1..=16)
            .map(|seed| {
                world.reseed(seed);
                render::render(&world).pixels().iter().map(|pixel| pixel.g).sum()
            })
            .collect();
        let area = 0.5 * TAU * rho * rho * (100.0 / z) * (100.0 / z);
        let off = sigmas(&light, area).abs();
        // 16 values: Student's t reaches 5.2 where the normal's quantile is 3.8
        assert!(off < 1.5 * most_sigmas(4), "f {focal_distance}, R {lens_radius}: {off} sigmas");
    }
}

/// What arrives from each of 40 points of the lens, for one film place.
fn through_the_lens(scene: &Scene, film: [f64; 2]) -> Vec<f64> {
    let world = built(scene);
    let ray = |i: i32| -> Ray {
        let r = f64::from(i % 4 + 1) / 4.0;
        let eye: &Eye = &world.view.eyes()[0];
        eye.ray(film, rim(f64::from(i) / 40.0).map(|l| r * l)).expect("it sees")
    };
    (0..40).map(|i| trace::radiance(&world, &ray(i), &mut ()).g).collect()
}

/// Law: a mirrored thing is sharp where the whole way along −w, to the mirror and on, is the focal
/// distance; not where the mirror is. Oracle: the edge of a shining half plane, whose image divides
/// the film: right beside it all points of the lens agree if it is sharp, and not if not.
#[test]
fn a_mirrored_edge_is_sharp_at_the_length_of_the_whole_way() {
    // the mirror 30 ahead; the half plane x > 1 is 20 behind the lens
    let scene = |focal_distance: f64| {
        let lens = ThinLens { distance: 10.0, focal_distance, lens_radius: 0.5, zoom: 1.0 };
        let camera = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), lens);
        let mut scene = Scene::new("", Image::new(8, 8), camera);
        scene.tracer = Tracer::Whitted(Whitted { max_depth: 2 });
        let mirror = Reflective { phong: Default::default(), kr: 1.0, cr: Rgb::WHITE.into() };
        scene.materials.push(Material::new("mirror", mirror));
        let square = |corner: Point, side: f64| Rectangle {
            corner,
            a: Vector::new(side, 0.0, 0.0),
            b: Vector::new(0.0, side, 0.0),
        };
        let mirror = square(Point::new(-50.0, -50.0, -30.0), 100.0);
        scene.objects.push(Object::new("mirror", "mirror", mirror));
        add_flat(&mut scene, "wall", square(Point::new(1.0, -50.0, 20.0), 100.0), Rgb::WHITE);
        scene
    };
    // seen at x = d · 1/80 of the mirrored plane
    let edge = 10.0 / 80.0;
    let agree = |focal_distance: f64, x: f64| {
        let light = through_the_lens(&scene(focal_distance), [x, 0.1]);
        light.iter().all(|&l| l == light[0]).then_some(light[0])
    };
    assert_eq!(agree(80.0, edge + 1e-6), Some(1.0));
    assert_eq!(agree(80.0, edge - 1e-6), Some(0.0));
    for out_of_focus in [30.0, 50.0, 79.0, 81.0] {
        assert_eq!(agree(out_of_focus, edge + 1e-6), None, "{out_of_focus}");
    }
}

/// Law: a picture shows a point where `project` says, to a hundredth of a pixel: through the centre of
/// the lens, blurred or not.
#[test]
fn a_picture_agrees_with_project() {
    let lens = ThinLens { distance: 11.0, focal_distance: 12.0, lens_radius: 0.004, zoom: 1.25 };
    let scene = calibration(lens);
    for (film, depth) in [([3.1, -2.2], 12.0), ([-5.0, 3.3], 13.0), ([0.4, 0.7], 11.0)] {
        let point = point_at(&scene, 0, film, depth);
        assert_seen_where_projected(scene.clone(), 0, point);
    }
}

/// Law: behind the lens nothing is seen, and the picture ends at its edges, which belong to it.
/// Oracle: similar triangles, by hand.
#[test]
fn project_ends_at_the_edges() {
    let lens = ThinLens { distance: 2.0, focal_distance: 5.0, lens_radius: 1.0, zoom: 1.0 };
    let viewpoint = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), lens);
    let view = viewpoint.build(ViewPlane { width: 8.0, height: 4.0 }).expect("a valid view");
    let project = |x, y, z| view.eyes()[0].project(Point::new(x, y, z));
    assert_eq!(project(2.0, -1.0, -1.0), Some([4.0, -2.0]));
    assert_eq!(project(2.001, 0.0, -1.0), None);
    assert_eq!(project(0.0, -1.001, -1.0), None);
    assert_eq!(project(0.5, 0.25, -1.0), Some([1.0, 0.5]));
    assert_eq!(project(0.5, 0.25, 1.0), None);
    assert_eq!(project(0.5, 0.25, 0.0), None);
    assert_eq!(project(0.0, 0.0, 0.0), None);
}

/// Law: a lens that cannot be built says which field is wrong. Oracle: the field that was spoiled.
#[test]
fn lenses_that_cannot_be_built_name_the_field() {
    let good = ThinLens { distance: 2.0, focal_distance: 5.0, lens_radius: 1.0, zoom: 1.0 };
    for (spoiled, field) in [
        (ThinLens { distance: 0.0, ..good.clone() }, "distance: found 0"),
        (ThinLens { focal_distance: -1.0, ..good.clone() }, "focal_distance: found -1"),
        (ThinLens { lens_radius: -0.5, ..good.clone() }, "lens_radius: found -0.5"),
        (ThinLens { zoom: f64::NAN, ..good.clone() }, "zoom: found NaN"),
    ] {
        let error = Kind::from(spoiled).build(&mut ANY_FILM.clone()).expect_err("it is spoiled");
        assert!(error.to_string().starts_with(&format!("thin_lens.{field}")), "{error}");
    }
    // a lens so large that its rays are no numbers is refused with the picture
    let lens = ThinLens { lens_radius: 1e308, distance: 1e10, ..good };
    let camera = Viewpoint::new(Point::ORIGIN, Point::new(0.0, 0.0, -1.0), lens);
    let scene = Scene::new("", Image::new(2, 2), camera);
    assert!(groundtruth::world::World::build(&scene).is_err());
}
