//! Goldens of words and lines, written anew by `scripts/renew-texts.sh`; the laws about them are in the other files.

use explain::RecordedRay;
use groundtruth::math::{cos_degrees, sin_degrees};
use groundtruth::world::World;
use space::{Drawing, Label, Role, Section, Stroke, obj, orbit_of, segments, svg_of_rays};

use super::drawing::ROLES;
use super::section;
use super::support::{DOWN, WHITE, block, light, object, traced};

/// An SVG without its pictures, and of long lines of points the first and the last.
fn shortened(svg: &str) -> String {
    let point = |it: &str| {
        let Some((head, rest)) = it.split_once("points=\"") else { return it.to_owned() };
        let (points, tail) = rest.split_once('"').expect("it ends");
        let all: Vec<&str> = points.split(' ').collect();
        match &all[..] {
            [first, second, .., last] if all.len() > 8 => {
                let count = all.len();
                format!("{head}points=\"{first} {second} … {last}\" ({count} points){tail}")
            }
            _ => it.to_owned(),
        }
    };
    let lines = svg.lines().filter(|it| !it.starts_with("<image ")).map(point);
    lines.collect::<Vec<_>>().join("\n")
}

/// Golden: each role, whole and dashed, with an arrow and room for it and without; a dot; words on all sides, on one line and on
/// two; notes with long words and lines of their own; markup in names; a drawing as high as allowed, and one whose words have no room.
#[test]
fn a_drawing_reads_as_before() {
    let mut drawing = Drawing { title: "<&>".to_owned(), ..Drawing::default() };
    for (row, role) in (0_u8..).zip(ROLES) {
        let at = |x: f64| [x, -0.2 * f64::from(row)];
        let line = |from: f64, to: f64| Stroke::new(role, vec![at(from), at(to)]);
        let ray = Some(usize::from(row)).filter(|ray| ray % 2 == 0);
        drawing.strokes.push(Stroke { ray, ..line(0.0, 0.5) });
        drawing.strokes.push(Stroke { arrow: true, dashed: true, ray, ..line(1.0, 1.5) });
        // no room for the head
        drawing.strokes.push(Stroke { arrow: true, ..line(2.0, 2.01) });
        let side = [row % 3, row / 3 % 3].map(|it| it as i8 - 1);
        let text = ["n", "two\nlines", "<a longer word>"][usize::from(row) % 3].to_owned();
        drawing.strokes.push(Stroke::new(role, vec![at(3.0)]));
        drawing.labels.push(Label { at: at(3.0), text, role, side });
    }
    let word = "é".repeat(29);
    drawing.notes.push(format!("{word} {word}é a < b {}\n{word} {word} next", word.repeat(3)));
    let mut text = shortened(&drawing.svg());
    // as high as allowed; and with words that have no room at any scale
    for (way, words) in [([0.01, 300.0], "n"), ([1.0, 0.5], &"a word ".repeat(20))] {
        let line = Stroke::new(Role::Arc, vec![[0.0; 2], way]);
        let label = Label { at: way, text: words.to_owned(), role: Role::Arc, side: [1, 1] };
        let drawing = Drawing { strokes: vec![line], labels: vec![label], ..Drawing::default() };
        text += &format!("\n{}", shortened(&drawing.svg()));
    }
    insta::assert_snapshot!(text);
}

/// Golden: the lines of an OBJ file, each piece in the group of its kind; the second line of a name is no line of the file.
#[test]
fn rays_in_a_file_read_as_before() {
    let (_, world, root) = section::tree("ch28/glass-sphere", [2, 2]);
    insta::assert_snapshot!(obj(&root, &segments(&world, &root, 10.0), "glass\nsphere"));
}

/// The sections of the rays of a tree that are no shadow rays.
fn sections(name: &str, (world, root): (&World, &RecordedRay), text: &mut String) {
    for ray in root.rays().iter().filter(|it| !it.is_shadow()) {
        let Some(section) = Section::of(world, root, ray.number) else { continue };
        *text += &format!("== {name}, ray {}\n{}\n", ray.number, shortened(&section.drawing.svg()));
    }
}

/// Golden: planes of incidence: of a block of glass under angles beside those at which arcs, letters and indices change (0.1°,
/// 12°, 45°), with the ways that rays should go, of total reflection, of shading normals, of rays that leave the plane and of rays that are not cast.
#[test]
fn sections_read_as_before() {
    let mut text = String::new();
    for degrees in [0.0, 0.05, 0.2, 11.9, 12.1, 44.9, 45.1] {
        let (name, world, root) = block(degrees);
        let section = Section::of(&world, &root, 0).expect("it hits");
        text += &format!("== {name} under {degrees}°\n{}\n", shortened(&section.drawing.svg()));
    }
    let (_, world, root) = block(30.0);
    let mut told = Section::of(&world, &root, 0).expect("it hits");
    for (degrees, up) in [(50.0, 1.0), (12.5, -1.0)] {
        let way = told.plane.vector([sin_degrees(degrees), up * cos_degrees(degrees)]);
        told.expect(|_| Some(way));
    }
    text += &format!("== where two rays should go\n{}\n", shortened(&told.drawing.svg()));
    for (name, world, root) in [
        section::tree("ch28/glass-box", [3, 2]),
        section::tree("ch24/mirror-meshes", [2, 2]),
        section::tree("ch24/hall-of-mirrors", [3, 2]),
    ] {
        sections(name, (&world, &root), &mut text);
    }
    insta::assert_snapshot!(text);
}

/// What is above a floor at y = 0, which the middle pixel sees at (0, 0, 0) from the height 9: a name, the floor, the light,
/// and objects, of which the first ball blocks the way to a light on the right after 2.
const ABOVE: [(&str, &str, &str, &str); 11] = [
    ("near lamp", LARGE, "point = { location = [-3, 4, 0], ls = 1 }", BALLS),
    ("far lamp", SMALL, FAR, ""),
    ("far lamp over an endless floor", ENDLESS, FAR, ""),
    ("lamp above", LARGE, "point = { location = [0, 5, 0], ls = 1 }", ""),
    ("sun", SMALL, "directional = { direction = [-3, 4, 0], ls = 1 }", ""),
    ("sun and floor", ENDLESS, "directional = { direction = [-3, 4, 0], ls = 1 }", BALLS),
    ("near lamp behind a ball", LARGE, "point = { location = [3, 4, 0], ls = 1 }", BALLS),
    ("far lamp behind a ball", SMALL, THROUGH, BALLS),
    ("far lamp behind a ball, endless floor", ENDLESS, THROUGH, BALLS),
    ("sun behind a ball", LARGE, "directional = { direction = [3, 4, 0], ls = 1 }", BALLS),
    ("shining ball", LARGE, "area = { object = \"tube\" }", TUBE),
];
const SMALL: &str = "shape.disk = { center = [0, 0, 0], normal = [0, 1, 0], radius = 0.5 }";
const LARGE: &str = "shape.disk = { center = [0, 0, 0], normal = [0, 1, 0], radius = 20 }";
const ENDLESS: &str = "shape.plane = { point = [0, 0, 0], normal = [0, 1, 0] }";
const FAR: &str = "point = { location = [-30, 40, 0], ls = 1 }";
const THROUGH: &str = "point = { location = [30, 40, 0], ls = 1 }";
const BALLS: &str = "[[objects]]\nname = \"ball\"\nmaterial = \"white\"\n\
                     shape.sphere = { center = [1.5, 2, 0], radius = 0.5 }\n\
                     [[objects]]\nname = \"beside\"\nmaterial = \"white\"\n\
                     shape.sphere = { center = [-2, 1, 0], radius = 0.25 }\n";
const TUBE: &str = "[[materials]]\nname = \"shining\"\nrecipe.emissive = { ls = 1, ce = 1 }\n\
                    [[objects]]\nname = \"tube\"\nmaterial = \"shining\"\n\
                    shape.sphere = { center = [3, 4, 0], radius = 1e-3 }\n";

/// Golden: shadow rays to near and far lamps, suns and lamps that are seen, over small, large and endless floors, blocked or not.
#[test]
fn sections_of_shadow_rays_read_as_before() {
    let mut text = String::new();
    for (name, floor, source, objects) in ABOVE {
        let parts = [DOWN, WHITE, &light("it", source), &object("floor", floor), objects];
        let (world, root) = traced(&parts.concat(), [2, 2]);
        let section = Section::of(&world, &root, 1).expect("a shadow ray");
        text += &format!("== {name}\n{}\n", shortened(&section.drawing.svg()));
    }
    insta::assert_snapshot!(text);
}

/// Golden: the rays of a pixel in space: hidden and seen parts, heads, dots, numbers beside each other, the legend.
#[test]
fn rays_in_space_read_as_before() {
    let mut text = String::new();
    for (name, parts) in [
        ("ch28/glass-sphere", [2, 2]),
        ("ch24/floor-mirror", [2, 2]),
        ("ch16/shadows", [3, 2]),
        ("ch27/torus", [2, 2]),
        ("ch24/hall-of-mirrors", [3, 3]),
    ] {
        let (_, world, root) = section::tree(name, parts);
        let svg = svg_of_rays(&world, &root, &orbit_of(&world, &root), &[]);
        text += &format!("== {name}\n{}\n", shortened(&svg));
    }
    insta::assert_snapshot!(text);
}
