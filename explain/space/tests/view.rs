//! The rays as SVG and as OBJ, against the recorded points.

use groundtruth::explain::{self, RecordedRay};
use groundtruth::math::{Point, Vector};
use groundtruth::world::World;
use space::{
    End, Orbit, Section, Segment, Visibility, hiding, obj, of_hits, orbit_of, segments, svg_of_rays,
};

use super::section;
use super::support::{FRONT, WHITE, built, light, object, traced};

fn tree_of(name: &str, pixel: [u32; 2]) -> (World, RecordedRay) {
    let scene = (gallery::find(name).expect("a scene of the gallery").build)();
    let world = World::build(&scene).unwrap();
    let root = explain::sample(&scene, &world, pixel, 0).ray.expect("the camera sees something");
    (world, root)
}

/// The numbers between quotes of an SVG's line, by their attributes.
fn attribute(line: &str, name: &str) -> f64 {
    let (_, rest) = line.split_once(&format!(" {name}=\"")).unwrap_or_else(|| panic!("{line}"));
    rest.split('"').next().unwrap().parse().unwrap()
}

/// The drawn lines of each piece of a ray: the number of the ray, and the ends of the lines.
fn drawn(svg: &str) -> Vec<(usize, Vec<[[f64; 2]; 2]>)> {
    let groups = svg.split("<g data-ray=\"").skip(1);
    let of_group = |group: &str| {
        let number = group.split('"').next().unwrap().parse().unwrap();
        let (group, _) = group.split_once("</g>").unwrap();
        let lines = group.lines().filter(|line| line.starts_with("<line"));
        let ends = |line: &str| {
            [("x1", "y1"), ("x2", "y2")].map(|(x, y)| [attribute(line, x), attribute(line, y)])
        };
        (number, lines.map(ends).collect())
    };
    groups.map(of_group).collect()
}

/// Law: each piece that is inside the picture is drawn from the image of its beginning to the image of its end, without a
/// gap. Oracle: the projection of the recorded points (to a tenth of a unit, as written).
#[test]
fn drawn_rays_end_at_the_images_of_the_recorded_points() {
    let mut whole = 0;
    for (name, pixel) in [("ch28/glass-sphere", [200, 150]), ("ch27/torus", [150, 150])] {
        let (world, root) = tree_of(name, pixel);
        let orbit = orbit_of(&world, &root);
        let sight = orbit.sight([800.0, 520.0]);
        let svg = svg_of_rays(&world, &root, &orbit, &[]);
        let mut lines = drawn(&svg).into_iter();
        for piece in segments(&world, &root, 8.0 * orbit.distance) {
            let Some([(_, first), (_, last)]) = sight.clip(piece.from, piece.to) else { continue };
            let (number, lines) = lines.next().expect("a piece in the picture is drawn");
            assert_eq!(number, piece.ray);
            let near = |a: [f64; 2], b: [f64; 2]| (0..2).all(|i| (a[i] - b[i]).abs() < 0.101);
            assert!(lines.windows(2).all(|pair| near(pair[0][1], pair[1][0])), "a gap: {lines:?}");
            for [x, y] in lines.iter().flatten() {
                assert!((-0.1..=800.1).contains(x) && (-0.1..=520.1).contains(y), "{x}, {y}");
            }
            if first == 0.0 && last == 1.0 {
                let [from, to] = [piece.from, piece.to].map(|point| sight.project(point).unwrap());
                assert!(near(lines[0][0], from) && near(lines[lines.len() - 1][1], to));
                whole += 1;
            }
        }
        assert!(lines.next().is_none(), "no more lines than pieces");
        assert!(svg.contains("href=\"data:image/png;base64,iVBOR"));
    }
    assert!(whole > 8, "{whole}");
}

/// Law: the camera of a page sees every point that a ray hits. Oracle: the projection.
#[test]
fn the_camera_of_a_page_sees_each_hit() {
    for (name, pixel) in [
        ("ch28/glass-sphere", [200, 150]),
        ("ch24/floor-mirror", [100, 150]),
        ("ch16/shadows", [200, 150]),
    ] {
        let (world, root) = tree_of(name, pixel);
        let sight = orbit_of(&world, &root).sight([800.0, 520.0]);
        for hit in root.rays().iter().filter_map(|ray| ray.hit.as_ref()) {
            let [x, y] = sight.project(hit.point).expect("before the eye");
            let inside = (0.0..=800.0).contains(&x) && (0.0..=520.0).contains(&y);
            assert!(inside, "{name}: {:?} is at {x}, {y}", hit.point);
        }
    }
}

/// A closed box of side 4 around the origin, seen from inside.
fn room() -> (World, RecordedRay) {
    let camera = "image = { width = 5, height = 5 }\n\
                  camera = { eye = [0, 0, 1], lens.pinhole = { distance = 100 } }\n";
    let lamp = light("lamp", "point = { location = [0, 1, 0], ls = 1 }");
    let room = object("room", "shape.box = { min = [-2, -2, -2], max = [2, 2, 2] }");
    traced(&[camera, &lamp, WHITE, &room].concat(), [2, 2])
}

/// Closed form: from outside, a closed room hides all that is in it, and nothing else is there; from inside it hides
/// nothing.
#[test]
fn a_room_hides_what_is_in_it_from_outside_only() {
    let (world, root) = room();
    let at = |distance: f64| Orbit { target: Point::ORIGIN, yaw: 30.0, pitch: 20.0, distance };
    assert_eq!(hiding(&world, &root, &at(10.0)), [0]);
    assert_eq!(hiding(&world, &root, &at(1.0)), [0_u32; 0]);
    let svg = svg_of_rays(&world, &root, &at(10.0), &[0]);
    assert!(!svg.contains("opacity=\"0.25\""), "what is looked through hides nothing");
    assert!(svg_of_rays(&world, &root, &at(10.0), &[]).contains("opacity=\"0.25\""));
}

/// Closed form: of a room that is large beside the ray of length 3 in it, the ball is around the hit; of a small ball hit at
/// distance 9.5, around that ball's box. Both have at least 0.12 of the ray's length.
#[test]
fn what_rays_meet_is_around_hits_and_small_objects() {
    let (world, root) = room();
    let (center, radius) = of_hits(&world, &segments(&world, &root, 1.0)).unwrap();
    assert!(center.distance(Point::new(0.0, 0.0, -2.0)) < 1e-9 && (radius - 0.36).abs() < 1e-9);
    assert_eq!(of_hits(&world, &[]), None);
    let piece = Segment {
        ray: 0,
        from: Point::new(0.0, 0.0, 10.0),
        to: Point::new(0.0, 0.0, 0.5),
        end: End::Hit,
    };
    let ball = object("ball", "shape.sphere = { center = [0, 0, 0], radius = 0.5 }");
    let (_, world) = built(&[FRONT, WHITE, &ball].concat());
    let (center, radius) = of_hits(&world, &[piece]).unwrap();
    assert!(center.distance(Point::ORIGIN) < 1e-9 && (radius - 0.12 * 9.5).abs() < 1e-9);
}

/// Law: the lines of an OBJ file are the pieces, bit for bit, each in the group of its kind. Oracle: the file, read by the
/// rules of the format: vertices count from 1.
#[test]
fn an_obj_file_has_each_piece_in_its_group() {
    let (world, root) = tree_of("ch28/glass-sphere", [200, 150]);
    let pieces = segments(&world, &root, 10.0);
    let text = obj(&root, &pieces, "glass\nsphere");
    assert!(text.starts_with("# glass"), "the second line of a name is no line of the file");
    let (mut vertices, mut group, mut found) = (Vec::new(), "", Vec::new());
    for line in text.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["v", x, y, z] => vertices.push(Point::from([x, y, z].map(|it| it.parse().unwrap()))),
            ["g", name] => group = name,
            ["l", from, to] => {
                let [from, to] = [from, to].map(|it| vertices[it.parse::<usize>().unwrap() - 1]);
                found.push((group, from, to));
            }
            _ => assert!(line.starts_with('#'), "{line}"),
        }
    }
    let rays = root.rays();
    let expected = |piece: &Segment| {
        let kind = serde_json::to_value(rays[piece.ray].kind).unwrap();
        let kind = kind["kind"].as_str().unwrap().to_owned();
        let group = match (kind.as_str(), piece.end) {
            ("shadow", End::Occluder) => "shadow_blocked".to_owned(),
            ("shadow", End::Dark) => "shadow_dark".to_owned(),
            ("shadow", _) => "shadow_unblocked".to_owned(),
            _ => kind,
        };
        (group, piece.from, piece.to)
    };
    assert_eq!(found.len(), pieces.len());
    for (group, from, to) in pieces.iter().map(expected) {
        assert!(found.contains(&(&group, from, to)), "{group} {from:?} {to:?}");
    }
}

/// Law: of the two sides of the plane of incidence, the camera stands on the one from which fewer middles of pieces are hidden.
/// Oracle: both sides, counted.
#[test]
fn the_camera_stands_where_less_is_hidden() {
    let (mut seen, mut differ) = (0, 0);
    let names = ["ch28/glass-sphere", "ch24/floor-mirror", "ch16/shadows", "ch27/torus"];
    let parts = [[2, 2], [3, 2], [2, 3], [3, 3], [4, 2]];
    let trees = names.into_iter().flat_map(|name| parts.map(|part| section::tree(name, part)));
    for (name, world, root) in trees {
        let pieces = segments(&world, &root, 1.0);
        let Some(section) = Section::first(&root).and_then(|ray| Section::of(&world, &root, ray))
        else {
            continue;
        };
        let Some(ball) = space::of_hits(&world, &pieces) else { continue };
        let across = section.plane.normal();
        let sides = [across, -across].map(|side| Orbit::from_side(ball, side + 0.35 * Vector::Y));
        let hidden = sides.map(|orbit| {
            let visibility = Visibility::of(&world, orbit.sight([800.0, 520.0]).eye);
            let middles = pieces.iter().take(64).map(|it| it.from + 0.5 * (it.to - it.from));
            middles.filter(|at| visibility.is_hidden(*at)).count()
        });
        let found = orbit_of(&world, &root);
        let at = sides.iter().position(|side| *side == found);
        let at = at.unwrap_or_else(|| panic!("{name}: {found:?} is none of {sides:?}"));
        let least = hidden[0].min(hidden[1]);
        assert_eq!(
            hidden[at], least,
            "middles that are hidden from the camera of {name}: {hidden:?}"
        );
        seen += 1;
        differ += usize::from(hidden[0] != hidden[1]);
    }
    assert!(seen > 10 && differ > 2, "{seen} trees seen, of which {differ} have a better side");
}
