//! The section of a shadow ray: how much of its way is drawn, in which window, with which words.

use groundtruth::explain::RecordedRay;
use groundtruth::math::{Point, Vector, atan2, to_degrees};
use groundtruth::world::World;
use space::{Role, Section, Stroke};

use super::borders::{near, numbers};
use super::support::{DOWN, WHITE, light, object, traced};

/// Of a length: products of a few rounded numbers.
const ROUNDING: f64 = 1e-9;

/// What is above a floor at y = 0, which the middle pixel sees at (0, 0, 0) from the height 9.
pub struct Case {
    pub name: &'static str,
    floor: &'static str,
    light: String,
    objects: &'static str,
    /// The way from (0, 0, 0) to the light, or a unit vector to a sun.
    way: [f64; 3],
    is_sun: bool,
    /// Where a ball around this point of the way, of this radius, blocks it.
    blocked: Option<(f64, &'static str)>,
}

const BALL: &str = "[[objects]]\nname = \"ball\"\nmaterial = \"white\"\n\
                    shape.sphere = { center = [1.5, 2, 0], radius = 0.5 }\n\
                    [[objects]]\nname = \"beside\"\nmaterial = \"white\"\n\
                    shape.sphere = { center = [-2, 1, 0], radius = 0.25 }\n";
const LAMP: &str = "[[materials]]\nname = \"shining\"\nrecipe.emissive = { ls = 1, ce = 1 }\n\
                    [[objects]]\nname = \"tube\"\nmaterial = \"shining\"\n\
                    shape.sphere = { center = [3, 4, 0], radius = 1e-3 }\n";

fn lamp([x, y, z]: [f64; 3]) -> String {
    format!("point = {{ location = [{x}, {y}, {z}], ls = 1 }}")
}

pub fn cases() -> Vec<Case> {
    // a disk of radius r has the diagonal 2 √2 r
    let small = "disk = { center = [0, 0, 0], normal = [0, 1, 0], radius = 0.5 }";
    let large = "disk = { center = [0, 0, 0], normal = [0, 1, 0], radius = 20 }";
    let endless = "plane = { point = [0, 0, 0], normal = [0, 1, 0] }";
    let near = [3.0, 4.0, 0.0];
    let far = [-30.0, 40.0, 0.0];
    let through = [30.0, 40.0, 0.0];
    let case = |name, floor, light, objects, way| Case {
        name,
        floor,
        light,
        objects,
        way,
        is_sun: false,
        blocked: None,
    };
    let sun = "directional = { direction = [-3, 4, 0], ls = 1 }".to_owned();
    let sun_behind = "directional = { direction = [3, 4, 0], ls = 1 }".to_owned();
    vec![
        case("near lamp", large, lamp([-3.0, 4.0, 0.0]), BALL, [-3.0, 4.0, 0.0]),
        case("far lamp", small, lamp(far), "", far),
        case("far lamp over an endless floor", endless, lamp(far), "", far),
        case("lamp above", large, lamp([0.0, 5.0, 0.0]), "", [0.0, 5.0, 0.0]),
        Case { is_sun: true, ..case("sun", small, sun.clone(), "", [-0.6, 0.8, 0.0]) },
        Case { is_sun: true, ..case("sun and floor", endless, sun, BALL, [-0.6, 0.8, 0.0]) },
        Case {
            blocked: Some((2.0, "ball")),
            ..case("near lamp behind a ball", large, lamp(near), BALL, near)
        },
        Case {
            blocked: Some((2.0, "ball")),
            ..case("far lamp behind a ball", small, lamp(through), BALL, through)
        },
        Case {
            blocked: Some((2.0, "ball")),
            ..case("far lamp behind a ball, endless floor", endless, lamp(through), BALL, through)
        },
        Case {
            blocked: Some((2.0, "ball")),
            is_sun: true,
            ..case("sun behind a ball", large, sun_behind, BALL, [0.6, 0.8, 0.0])
        },
        case("shining ball", large, "area = { object = \"tube\" }".to_owned(), LAMP, near),
    ]
}

pub fn tree(case: &Case) -> (World, RecordedRay) {
    let (light, floor) = (light("it", &case.light), format!("shape.{}", case.floor));
    let text = [DOWN, WHITE, &light, &object("floor", &floor), case.objects].concat();
    traced(&text, [2, 2])
}

/// Three diagonals of the floor's box, or the distance of the camera if it has no end.
fn room(case: &Case) -> f64 {
    let radius = numbers(case.floor.rsplit("radius").next().unwrap_or("")).last().copied();
    match case.floor.starts_with("plane") {
        true => 9.0,
        false => 3.0 * 8.0_f64.sqrt() * radius.expect("a radius"),
    }
}

/// Law: the way is drawn to the light if that is at most as far away as three diagonals of what is lit (as the camera, if it is
/// endless), or three times as far as what blocks it; else so much of it, which is said with the light's distance; to a sun, three
/// diagonals. It is light, or blocked up to a dot and dark from there. Oracle: closed forms of each scene.
#[test]
fn the_way_to_a_light_is_drawn_as_far_as_there_is_room() {
    let mut cuts = [0; 2];
    for case in cases() {
        let (world, root) = tree(&case);
        let section = Section::of(&world, &root, 1).expect("a shadow ray");
        let (plane, drawing) = (section.plane, &section.drawing);
        let name = case.name;
        let way = Vector::from(case.way);
        let unit = way.unit().expect("it is long");
        // a sample of a lamp of radius 0.001
        let off = if case.objects == LAMP { 1e-2 } else { ROUNDING };
        let room = room(&case);
        let least = case.blocked.map_or(room, |(t, _)| 3.0 * t);
        let whole = if case.is_sun { room } else { way.length() };
        let is_cut = whole > 1.000_001 * least.max(room);
        let shown = if is_cut { least } else { whole };
        let end = Point::ORIGIN + shown * unit;
        let of = |role: Role| -> Vec<&Stroke> {
            drawing.strokes.iter().filter(|it| it.role == role).collect()
        };
        let at = |stroke: &Stroke, k: usize| plane.to_space(stroke.points[k]);
        let is_at = |found: Point, expected: Point, what: &str| {
            near(
                found.distance(expected),
                0.0,
                off * shown.max(1.0),
                &format!("{what}, {name}, off"),
            );
        };
        let [shadow, dark, blocked] = [Role::Shadow, Role::Dark, Role::Blocked].map(of);
        match case.blocked {
            None => {
                let counts = [shadow.len(), dark.len(), blocked.len()];
                assert_eq!(counts, [1, 0, 0], "light, dark, blocked strokes, {name}");
                is_at(at(shadow[0], 0), Point::ORIGIN, "the begin of the way");
                is_at(at(shadow[0], 1), end, "the end of the way");
            }
            Some((t, by)) => {
                let counts = [shadow.len(), dark.len(), blocked.len()];
                assert_eq!(counts, [0, 1, 2], "light, dark, blocked strokes, {name}");
                let met = Point::ORIGIN + t * unit;
                is_at(at(blocked[0], 0), Point::ORIGIN, "the begin of the way");
                is_at(at(blocked[0], 1), met, "the end of the light part of the way");
                is_at(at(dark[0], 0), met, "the begin of the dark part of the way");
                is_at(at(dark[0], 1), end, "the end of the way");
                is_at(at(blocked[1], 0), met, "the dot");
                let text = format!("blocked by \"{by}\"");
                assert!(drawing.labels.iter().any(|it| it.text == text), "{text}, {name}");
            }
        }
        let degrees = to_degrees(atan2(unit.cross(Vector::Y).length(), unit.y()));
        near(section.angles[0].degrees, degrees, 1e4 * off, "the angle");
        let note = drawing.notes.iter().find(|it| it.contains(" away: "));
        assert_eq!(note.is_some(), is_cut, "whether {name} is said to be cut");
        if let Some(note) = note {
            near(numbers(note)[0], way.length(), 5e-4 * way.length(), note);
        }
        cuts[usize::from(is_cut)] += 1;
    }
    assert!(cuts.iter().all(|n| *n > 2), "whole ways, and cut ones: {cuts:?}");
}
