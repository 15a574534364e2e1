//! Sections against the recorded directions, Snell's law, closed forms of shapes and the world's distances.

use explain::RecordedRay;
use groundtruth::math::{Point, Vector, sin_degrees};
use groundtruth::world::World;
use space::{Role, Section, Window, outlines};

use super::support::{FRONT, WHITE, light, object, traced};
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

/// Law: each point of an outline is on the surface, and the outline of a ball is a closed circle whose pieces are near to it.
/// Closed form: x² + y² + z² = 1, and the middle of a chord c of the circle of radius r is r − √(r² − c²/4) inside it.
#[test]
fn the_outline_of_a_ball_is_a_circle() {
    let lamp = light("lamp", "point = { location = [0, 8, 0], ls = 1 }");
    let text = [FRONT, &lamp, WHITE, &object("ball", BALL)].concat();
    let (world, root) = traced(&text.replace("height = 5", "height = 5, pixel_size = 0.2"), [3, 1]);
    let section = Section::of(&world, &root, 0).unwrap();
    let mut curves = section.drawing.strokes.iter().filter(|it| it.role == Role::Outline);
    let curve = curves.next().expect("a ball has an outline");
    assert_eq!(curves.count(), 0, "more outlines");
    let points: Vec<_> = curve.points.iter().map(|&at| section.plane.to_space(at)).collect();
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
