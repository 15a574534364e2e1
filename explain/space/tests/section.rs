//! Sections against the recorded directions, Snell's law, closed forms of shapes and the world's distances.

use groundtruth::explain::{self, RecordedRay};
use groundtruth::math::{Pcg32, Point, Vector, cos_degrees, sin_degrees};
use groundtruth::world::World;
use space::{RayAngle, Role, Section, Stroke, Window, outlines};

use super::support::{FRONT, WHITE, built, light, object, traced};
use super::why_not::BALL;

/// Of an angle whose cosine is rounded to a few u: its error is that over the sine, and no angle is below 1° here.
const ANGLE: f64 = 1e-9;

/// A tree of the gallery's glass and mirrors, at some pixel.
pub fn trees() -> Vec<(&'static str, World, RecordedRay)> {
    let names = [
        "ch28/glass-sphere",
        "ch28/glass-box",
        "ch28/in-a-diamond",
        "ch27/torus",
        "ch27/ellipsoid",
        "ch24/hall-of-mirrors",
        "ch24/floor-mirror",
        "ch24/mirror-meshes",
    ];
    let parts = [[2, 2], [3, 2]];
    names.into_iter().flat_map(|name| parts.map(|part| tree(name, part))).collect()
}

/// The tree of a pixel of a scene of the gallery, at these parts of its width and height.
pub fn tree(name: &'static str, [x, y]: [u32; 2]) -> (&'static str, World, RecordedRay) {
    let scene = (gallery::find(name).expect("a scene of the gallery").build)();
    let world = World::build(&scene).expect("valid");
    let [width, height] = world.picture_size();
    let root = explain::sample(&scene, &world, [width / x, height / y], 0).ray.expect("a ray");
    (name, world, root)
}

/// Law: where a ray should go is drawn dashed from the hit, as long as the longest ray, and with its angle to the normal on that side; the
/// rays stay. Oracle: directions made of angles; and of a hit on what the world does not have, the rays alone are drawn.
#[test]
fn where_a_ray_should_go_is_dashed() {
    let (_, world, root) = super::incidence::block(30.0);
    let section = Section::of(&world, &root, 0).expect("it hits");
    let sent = section.angles[1..].to_vec();
    assert_eq!(sent.len(), 2, "reflected and refracted");
    for (degrees, up) in [(50.0, 1.0), (12.5, -1.0)] {
        for RayAngle { ray, .. } in &sent {
            let mut told = section.clone();
            let way = [sin_degrees(degrees), up * cos_degrees(degrees)];
            told.expect(|number| (number == *ray).then(|| section.plane.vector(way)));
            let (stroke, rest) = told.drawing.strokes.split_last().expect("lines");
            assert_eq!(rest, section.drawing.strokes);
            let length = |[x, y]: [f64; 2]| (x * x + y * y).sqrt();
            let drawn = rest.iter().filter(|stroke| stroke.ray.is_some());
            let lengths = drawn.flat_map(|stroke| &stroke.points).map(|it| length(*it));
            let off = length(stroke.points[1]) - lengths.fold(0.0, f64::max);
            assert!(stroke.dashed && stroke.ray.is_none() && off.abs() < ANGLE, "{off}");
            let [x, y] = stroke.points[1].map(|it| it / length(stroke.points[1]));
            assert!((x - way[0]).abs() + (y - way[1]).abs() < ANGLE, "({x}, {y})");
            let label = told.drawing.labels.last().expect("words");
            assert_eq!(label.text, format!("ray {ray} should go\n{degrees}°"));
        }
    }

    let alone = Section::of(&built(FRONT).1, &root, 0).expect("it hits");
    assert!(alone.drawing.strokes.iter().all(|stroke| stroke.role != Role::Outline));
    assert_eq!(alone.angles, section.angles);
}

/// Law: the angles of rays are those of the recorded directions. Oracle: the recorded directions
/// and normal, by the arc sine's inverse: sin of the angle is the length of the cross product.
#[test]
fn the_angles_of_a_section_are_those_of_the_recorded_directions() {
    let mut angles = 0;
    for (name, world, root) in trees() {
        for ray in root.rays() {
            let Some(hit) = ray.hit.as_ref() else { continue };
            let section = Section::of(&world, &root, ray.number).expect("it hits");
            let recorded = |number: usize| {
                let found = root.path_to(number).last().copied().unwrap();
                found.ray.direction.unit().unwrap()
            };
            for angle in &section.angles {
                let sine = recorded(angle.ray).cross(hit.normal).length();
                let off = (sin_degrees(angle.degrees) - sine).abs();
                assert!(off < ANGLE, "{name}, ray {}: {angle:?}", ray.number);
                assert!((0.0..=90.0 + ANGLE).contains(&angle.degrees));
                angles += 1;
            }
        }
    }
    assert!(angles > 200, "{angles}");
}

/// Law: where the recorder says how light refracts, both sides of Snell's law are equal, with the recorded directions; on
/// total reflection the first is larger than n₂. Oracle: the ratio η that the recorder keeps.
#[test]
fn both_sides_of_snells_law_are_equal() {
    let (mut refracted, mut total) = (0, 0);
    for (name, world, root) in trees() {
        for ray in root.rays() {
            let Some(optics) = ray.hit.as_ref().and_then(|hit| hit.optics) else { continue };
            let section = Section::of(&world, &root, ray.number).expect("it hits");
            let law = section.refraction.expect("it refracts");
            let [front, behind] = law.indices;
            assert!((behind / front - optics.eta).abs() < 1e-12, "{name}: {law:?}");
            let incident = front * sin_degrees(law.incidence);
            match law.refraction {
                None => {
                    assert!(incident >= behind * (1.0 - 1e-12), "{name}: {law:?}");
                    total += 1;
                }
                Some(degrees) => {
                    let off = (incident - behind * sin_degrees(degrees)).abs();
                    assert!(off < 1e-9, "{name}: {law:?} is {off} off");
                    assert!((0.0..=90.0).contains(&degrees), "{name}: {law:?}");
                    refracted += 1;
                }
            }
            assert!(section.drawing.notes.contains(&law.to_string()));
        }
    }
    assert!(refracted > 50 && total > 5, "{refracted} refracted, {total} totally reflected");
}

/// A scene of one white object with a lamp at (0, 8, 0), seen by an orthographic camera from z = 10 along −z.
fn one(shape: &str, eye: &str) -> (World, RecordedRay) {
    let camera = format!("eye = {eye}, look_at = [0, 0, 0], lens.orthographic = {{}}");
    let image = "width = 5, height = 5, pixel_size = 0.2";
    let lamp = light("lamp", "point = { location = [0, 8, 0], ls = 1 }");
    let shape = object("shape", &format!("shape.{shape}"));
    let text = format!("image = {{ {image} }}\ncamera = {{ {camera} }}\n{lamp}{WHITE}{shape}");
    traced(&text, [3, 1])
}

/// The points of a drawing's outlines in space, and how many pieces of each outline there are.
fn outline(section: &Section) -> Vec<Vec<Point>> {
    let strokes = section.drawing.strokes.iter().filter(|it| it.role == Role::Outline);
    strokes.map(|it| it.points.iter().map(|&at| section.plane.to_space(at)).collect()).collect()
}

/// Law: each point of an outline is on the surface, and the outline of a ball is a closed circle whose pieces are near to it.
/// Closed form: x² + y² + z² = 1, and the middle of a chord c of the circle of radius r is r − √(r² − c²/4) inside it.
#[test]
fn the_outline_of_a_ball_is_a_circle() {
    let (world, root) = one("sphere = { center = [0, 0, 0], radius = 1 }", "[0, 0, 10]");
    let section = Section::of(&world, &root, 0).unwrap();
    let curves = outline(&section);
    assert_eq!(curves.len(), 1);
    let [points] = &curves[..] else { unreachable!() };
    assert_eq!(points.first(), points.last(), "it is closed");
    for ends in points.windows(2) {
        assert!((ends[0].distance(Point::ORIGIN) - 1.0).abs() < 1e-12, "{:?}", ends[0]);
        // the plane of incidence of a ball contains its centre: the circle has its radius
        let middle = ends[0] + 0.5 * (ends[1] - ends[0]);
        assert!(1.0 - middle.distance(Point::ORIGIN) < 1.2e-3, "{}", ends[0].distance(ends[1]));
    }
    let turn: f64 = points
        .windows(2)
        .map(|ends| (ends[0] - Point::ORIGIN).cross(ends[1] - Point::ORIGIN).length())
        .sum();
    assert!((turn - std::f64::consts::TAU).abs() < 1e-2, "once around: {turn}");
}

/// Law: the outline of a box is closed, each of its points is on a face, and it goes into the corners. Closed form: on the
/// box's surface the largest |coordinate| is 1; a corner of the section is where two of them are.
#[test]
fn the_outline_of_a_box_goes_into_its_corners() {
    let box_ = "box = { min = [-1, -1, -1], max = [1, 1, 1] }";
    let (world, root) = one(box_, "[3, 4, 10]");
    let section = Section::of(&world, &root, 0).unwrap();
    let curves = outline(&section);
    assert_eq!(curves.len(), 1);
    let points = &curves[0];
    assert_eq!(points.first(), points.last(), "it is closed");
    let mut corners = 0;
    for point in points {
        let mut sizes = point.to_array().map(f64::abs);
        sizes.sort_by(f64::total_cmp);
        assert!((sizes[2] - 1.0).abs() < 1e-12, "{point:?}");
        corners += u32::from(1.0 - sizes[1] < 2e-4);
    }
    assert!(corners >= 4, "{corners} points are in corners");
}

/// Law: a plane has one straight outline across the window, through the hit. Closed form: y = 0.
#[test]
fn the_outline_of_a_plane_is_a_line() {
    let (world, root) = one("plane = { point = [0, 0, 0], normal = [0, 1, 0] }", "[0, 5, 10]");
    let section = Section::of(&world, &root, 0).unwrap();
    let curves: Vec<&Stroke> =
        section.drawing.strokes.iter().filter(|it| it.role == Role::Outline).collect();
    assert_eq!(curves.len(), 1);
    let points = &curves[0].points;
    assert_eq!(points.len(), 2, "straight pieces are one");
    assert!(points.iter().all(|point| point[1].abs() < 1e-12));
    let [left, right] = [points[0][0].min(points[1][0]), points[0][0].max(points[1][0])];
    assert!(left < 0.0 && right > 0.0);
}

/// Law: the coordinates of a plane keep lengths and lead back. Oracle: distances in space.
#[test]
fn coordinates_of_a_section_keep_lengths() {
    let mut random = Pcg32::new(5, 1);
    for (_, world, root) in trees() {
        let Some(Section { plane, .. }) = Section::of(&world, &root, 0) else { continue };
        let mut at = || [0, 1].map(|_| 20.0 * random.uniform() - 10.0);
        for _ in 0..20 {
            let (a, b) = (at(), at());
            let [p, q] = [a, b].map(|point| plane.to_space(point));
            let [x, y] = [a[0] - b[0], a[1] - b[1]];
            let flat = (x * x + y * y).sqrt();
            assert!((p.distance(q) - flat).abs() < 1e-12 * flat.max(1.0));
            let back = plane.to_plane(p);
            assert!((0..2).all(|axis| (back[axis] - a[axis]).abs() < 1e-11), "{a:?} {back:?}");
        }
    }
}

/// Law: a ray along the normal has the plane of the world's x axis. Closed form: seen from above, ball and ray are met at
/// (0, 1, 0) along y.
#[test]
fn a_ray_along_the_normal_has_the_plane_of_the_x_axis() {
    let (world, root) = traced(&[FRONT, WHITE, &object("ball", BALL)].concat(), [2, 2]);
    let section = Section::of(&world, &root, 0).unwrap();
    assert!(section.plane.is_any);
    assert_eq!(section.plane.vector([1.0, 0.0]).to_array(), [1.0, 0.0, 0.0]);
    assert_eq!(section.plane.vector([0.0, 1.0]).to_array(), [0.0, 0.0, 1.0]);
    assert!(section.drawing.notes.iter().any(|note| note.contains("x axis")));
}

/// Law: in each scene of the gallery, each point of an outline is a point of a surface. Oracle: rays through the point from
/// outside of the plane meet a surface there.
#[test]
fn points_of_outlines_are_on_surfaces_in_each_scene() {
    let mut points = 0;
    for (name, world, root) in trees() {
        let Some(Section { plane, .. }) = Section::of(&world, &root, 0) else { continue };
        for curve in outlines(&world, &plane, Window { center: [0.0; 2], half: 3.0 }) {
            for at in curve.points.iter().step_by(7) {
                let point = plane.to_space(*at);
                let is_met = [Vector::X, Vector::Y, Vector::Z].into_iter().any(|axis| {
                    let axis = axis + 0.3 * plane.normal();
                    [axis, -axis].into_iter().any(|way| {
                        let ray = groundtruth::math::Ray::new(point - 1e-3 * way, way);
                        let span = groundtruth::math::Span { min: 0.0, max: 2e-3 };
                        world
                            .hit(&ray, span)
                            .is_some_and(|hit| hit.surface.point.distance(point) < 1e-7)
                    })
                });
                assert!(is_met, "{name}: {point:?}");
                points += 1;
            }
        }
    }
    assert!(points > 100, "{points}");
}
