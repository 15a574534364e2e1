//! The thin lens: rays, the circle of confusion, `project`, and lenses that are refused.

use groundtruth::cameras::{Camera, Kind, ThinLens};
use testkit::properties::*;

use crate::prelude::*;
use crate::support::ANY_FILM;

fn camera(lens: &ThinLens) -> Arc<dyn Camera> {
    Kind::from(lens.clone()).build(&mut ANY_FILM.clone()).expect("a valid lens")
}

/// Lenses of all sizes, focused in front of and behind their view plane.
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

/// A point of the rim of the unit disk; `turn` in turns.
pub fn rim(turn: f64) -> [f64; 2] {
    [cos(TAU * turn), sin(TAU * turn)]
}

/// Where a ray meets the depth z along −w.
fn at_depth((origin, direction): (Point, Vector), z: f64) -> [f64; 2] {
    let p = origin + ((origin.z() + z) / -direction.z()) * direction;
    [p.x(), p.y()]
}

fn traced(camera: &dyn Camera, film: [f64; 2], lens: [f64; 2]) -> (Point, Vector) {
    camera.ray(film, lens).expect("a thin lens sees all its film")
}

/// The film point whose ray from a point of the lens passes through (x, y) at the depth z, found from two
/// rays: points at a depth depend linearly on the film point.
fn film_of(camera: &dyn Camera, lens: [f64; 2], point: [f64; 2], z: f64) -> [f64; 2] {
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
    /// Book: a lens of radius 0.
    #[test]
    fn a_lens_of_radius_0_is_the_pinhole(
        lens in lens(), x in -50.0..50.0_f64, y in -50.0..50.0_f64, turn in 0.0..1.0_f64,
    ) {
        let ThinLens { distance, zoom, .. } = lens;
        let pinhole = Kind::from(Pinhole { distance, zoom }).build(&mut ANY_FILM.clone());
        let expected = pinhole.expect("a valid pinhole").ray([x, y], [0.0; 2]);
        let found = camera(&ThinLens { lens_radius: 0.0, ..lens.clone() }).ray([x, y], rim(turn));
        prop_assert_eq!(found, expected);
        // rays through the centre of any lens are the pinhole's, too
        prop_assert_eq!(camera(&lens).ray([x, y], [0.0; 2]), expected);
    }

    /// Law: all rays of a film point meet in one point at the depth f along −w, at `(f/d) p`: the
    /// sharp surface is a plane, not a sphere. Oracle: similar triangles.
    /// Book: the thin lens and its focal plane.
    #[test]
    fn the_rays_of_a_film_point_meet_at_the_focal_distance(
        lens in lens(),
        x in -50.0..50.0_f64,
        y in -50.0..50.0_f64,
        turn in 0.0..1.0_f64,
        r in 0.0..1.0_f64,
    ) {
        let f = lens.focal_distance;
        let camera = camera(&lens);
        let there = rim(turn).map(|l| r * l);
        let meets = at_depth(traced(&*camera, [x, y], there), f);
        let expected = [x, y].map(|c| c / lens.zoom * f / lens.distance);
        let size = distance(expected, [0.0; 2]) + lens.lens_radius + f;
        prop_assert!(distance(meets, expected) < 1e-9 * size, "{meets:?} {expected:?}");
        // and nowhere else: in front of it and behind it they are apart
        let [near, far] = [0.5, 2.0].map(|k| at_depth(traced(&*camera, [x, y], rim(turn)), k * f));
        let centre = [0.5, 2.0].map(|k| at_depth(traced(&*camera, [x, y], [0.0; 2]), k * f));
        near!(distance(near, centre[0]), 0.5 * lens.lens_radius, 1e-9 * size);
        near!(distance(far, centre[1]), lens.lens_radius, 1e-9 * size);
    }

    /// Law: rays start on the lens: a disk of radius R around the eye, perpendicular to w.
    /// Book: the thin lens and its focal plane.
    #[test]
    fn rays_start_on_the_lens(lens in lens(), turn in 0.0..1.0_f64, r in 0.0..1.0_f64) {
        let [a, b] = rim(turn).map(|l| r * l);
        let (origin, _) = traced(&*camera(&lens), [3.0, -7.0], [a, b]);
        let expected = Point::new(lens.lens_radius * a, lens.lens_radius * b, 0.0);
        prop_assert_eq!(origin, expected);
    }

    /// Law: the image of a point at the depth z is a disc on the view plane, of the diameter `2 R d |z −
    /// f|/(z f)` (times the zoom), around the point's projection. Oracle: the formula (similar triangles),
    /// against the film points whose rays from the lens's rim pass through the point.
    /// Book: the circle of confusion.
    #[test]
    fn the_circle_of_confusion(
        lens in lens(),
        x in -20.0..20.0_f64,
        y in -20.0..20.0_f64,
        z in 0.5..500.0_f64,
        turn in 0.0..1.0_f64,
    ) {
        let ThinLens { distance: d, focal_distance: f, lens_radius, zoom } = lens;
        let camera = camera(&lens);
        let centre = camera.project(Point::new(x, y, -z)).expect("it is ahead");
        let diameter = 2.0 * lens_radius * d * (z - f).abs() / (z * f) * zoom;
        let point = film_of(&*camera, rim(turn), [x, y], z);
        let opposite = film_of(&*camera, rim(turn + 0.5), [x, y], z);
        let slack = 1e-9 * (zoom * d * (1.0 + (lens_radius + 30.0) / z + lens_radius / f));
        near!(distance(point, opposite), diameter, slack);
        near!(distance(point, centre), 0.5 * diameter, slack);
        // on the side of the lens point if it is behind the sharp plane, on the opposite side in front of it
        let side = (point[0] - centre[0]) * rim(turn)[0] + (point[1] - centre[1]) * rim(turn)[1];
        above!(side * (z - f), -slack * (z - f).abs());
    }
}

/// Law: the focal distances 50, 74 and 98 put the fronts of the three boxes in focus, one after the other: rays from
/// different points of the lens meet there. Oracle: the fronts of the boxes in the scenes, and the plane they lie in.
/// Book: figs. 10.9 and 10.10, three boxes in focus.
#[test]
fn each_focal_distance_of_the_book_is_that_of_a_box() {
    for (figure, name) in [("near", "near box"), ("middle", "middle box"), ("far", "far box")] {
        let entry = gallery::find(&format!("ch10/{figure}-focus")).expect("in the gallery");
        let scene = (entry.build)();
        let sharp = scene.objects.iter().find(|object| object.name == name).expect("a box");
        let shapes::Kind::Cuboid(Cuboid { max, .. }) = &sharp.shape else {
            panic!("{:?}", sharp.shape)
        };
        let view = scene.camera.build(ANY_FILM).expect("a valid camera");
        let met = [[0.0, 0.0], [0.7, 0.1], [-0.3, 0.9]].map(|lens| {
            let ray = view.eyes()[0].ray([3.0, -2.0], lens).expect("it sees all its film");
            ray.at((max.z() - ray.origin.z()) / ray.direction.z())
        });
        near!(met[1], met[0], 1e-12, "{figure}");
        near!(met[2], met[0], 1e-12, "{figure}");
    }
}
