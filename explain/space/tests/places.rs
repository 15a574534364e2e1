//! Where the camera of a drawing stands, and where its dots, heads and words are.

use groundtruth::explain::{self, RecordedRay};
use groundtruth::math::{Pcg32, Vector};
use groundtruth::world::World;
use space::{Drawing, End, Label, Orbit, Role, Section, Stroke, Visibility, segments, svg_of_rays};

use super::borders::near;

/// The scenes and pixels of some trees.
fn trees() -> Vec<(&'static str, World, RecordedRay)> {
    let names = [
        "ch28/glass-sphere",
        "ch24/floor-mirror",
        "ch16/shadows",
        "ch27/torus",
        "ch24/hall-of-mirrors",
    ];
    let mut all = Vec::new();
    for name in names {
        let scene = (gallery::find(name).expect("a scene").build)();
        let [width, height] = World::build(&scene).expect("valid").picture_size();
        let mut random = Pcg32::new(8, 1);
        for _ in 0..6 {
            let pixel = [random.below(width), random.below(height)];
            let world = World::build(&scene).expect("valid");
            if let Some(root) = explain::sample(&scene, &world, pixel, 0).ray {
                all.push((name, world, root));
            }
        }
    }
    all
}

/// Law: of the two sides of the plane of incidence, the camera stands on the one from which fewer middles of pieces are hidden.
/// Oracle: both sides, counted.
#[test]
fn the_camera_stands_where_less_is_hidden() {
    let (mut seen, mut differ) = (0, 0);
    for (name, world, root) in trees() {
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
        let found = space::orbit_of(&world, &root);
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

/// Law: a piece ends in a dot if its end is seen and it does not leave the scene, and has an arrowhead unless it is
/// dark. Oracle: the clipped pieces.
#[test]
fn pieces_end_in_dots_and_heads() {
    let mut seen = [0; 2];
    for (name, world, root) in trees() {
        let orbit = space::orbit_of(&world, &root);
        let sight = orbit.sight([800.0, 520.0]);
        let svg = svg_of_rays(&world, &root, &orbit, &[]);
        let mut groups = svg.split("<g data-ray=\"").skip(1);
        for piece in segments(&world, &root, 8.0 * orbit.distance) {
            let Some([(from, _), (to, last)]) = sight.clip(piece.from, piece.to) else { continue };
            let group = groups.next().expect("a group").split("</g>").next().expect("it ends");
            let has_dot = piece.end != End::Leaves && last == 1.0;
            let what = format!("piece of ray {} of {name}, {:?}", piece.ray, piece.end);
            assert_eq!(
                group.matches("<circle").count(),
                usize::from(has_dot),
                "dots of the {what}"
            );
            let length = (to[0] - from[0]).abs() + (to[1] - from[1]).abs();
            // in a shorter one a head has no room
            if length > 60.0 {
                let has_head = piece.end != End::Dark;
                assert_eq!(
                    group.matches("<polygon").count(),
                    usize::from(has_head),
                    "heads of the {what}"
                );
            }
            seen[usize::from(has_dot)] += 1;
        }
    }
    assert!(seen.iter().all(|n| *n > 10), "pieces without and with a dot: {seen:?}");
}

/// Law: the label n₁ stands in the middle between the reflected ray and the surface, or at the normal if the angle of incidence
/// is above 45°; n₂ stands on the normal, on the other side of the surface. Oracle: the angles of these directions.
#[test]
fn indices_stand_in_free_places() {
    let mut seen = [0; 2];
    for (name, world, root) in trees() {
        for ray in root.rays() {
            let Some(section) = Section::of(&world, &root, ray.number) else { continue };
            let Some(law) = &section.refraction else { continue };
            let at = |head: &str| {
                let label = section.drawing.labels.iter().find(|it| it.text.starts_with(head));
                label.unwrap_or_else(|| panic!("{name}: no {head}")).at
            };
            let ([x, y], [x2, y2]) = (at("n₁ = "), at("n₂ = "));
            let angle = groundtruth::math::to_degrees(groundtruth::math::atan2(x, y));
            let is_steep = law.incidence > 45.0;
            let expected = if is_steep { 0.0 } else { 0.5 * (law.incidence + 90.0) };
            near(angle, expected, 1e-9, "the angle of n₁ to the normal");
            assert!(x2 == 0.0 && y2 < 0.0, "n₂ stands at {x2}, {y2}");
            seen[usize::from(is_steep)] += 1;
        }
    }
    assert!(seen.iter().all(|n| *n > 0), "indices at flat and steep incidence: {seen:?}");
}

/// Law: the box of a drawing is around the points of all lines and words; an empty one has none. Oracle: each coordinate sorted.
#[test]
fn the_box_of_a_drawing_is_around_lines_and_words() {
    let mut random = Pcg32::new(4, 5);
    assert_eq!(Drawing::default().bounds(), None, "the box of nothing");
    for case in 0..40 {
        let mut drawing = Drawing::default();
        let mut all = Vec::new();
        for k in 0..=case % 4 {
            let at = [3.0, 7.0].map(|size| size * (2.0 * random.uniform() - 1.0));
            all.push(at);
            if (k + case) % 2 == 0 {
                drawing.strokes.push(Stroke::new(Role::Arc, vec![at]));
            } else {
                let (text, side) = ("x".to_owned(), [1, 1]);
                drawing.labels.push(Label { at, text, role: Role::Arc, side });
            }
        }
        let sorted = [0, 1].map(|axis| {
            let mut values: Vec<f64> = all.iter().map(|at| at[axis]).collect();
            values.sort_by(f64::total_cmp);
            [values[0], values[values.len() - 1]]
        });
        let expected = [0, 1].map(|end| sorted.map(|ends| ends[end]));
        assert_eq!(drawing.bounds(), Some(expected), "the box of {} points", all.len());
    }
}

/// Law: the number of a ray stands 7 to the right of a point of what is seen of it and 5 above, between a quarter and four fifths of
/// the way; of two numbers one is more than 24 aside or 17 above, where one of the five places is free. The legend is below the
/// picture. Oracle: the clipped pieces; the printed places.
#[test]
fn numbers_stand_beside_their_rays_and_apart() {
    /// Printed to a tenth.
    const PRINTED: f64 = 0.11;
    let (mut seen, mut moved) = (0, 0);
    for (name, world, root) in trees() {
        let orbit = space::orbit_of(&world, &root);
        let sight = orbit.sight([800.0, 520.0]);
        let svg = svg_of_rays(&world, &root, &orbit, &[]);
        let number = |line: &str, key: &str| -> f64 {
            let (_, rest) = line.split_once(&format!(" {key}=\"")).expect("an attribute");
            rest.split('"').next().and_then(|it| it.parse().ok()).expect("a number")
        };
        let legend = svg.lines().find(|it| it.starts_with("<text x=\"8\"")).expect("a legend");
        near(number(legend, "y"), 520.0 + 0.7 * 34.0, PRINTED, "the base line of the legend");
        let mut numbers = svg
            .lines()
            .filter(|it| it.starts_with("<text") && it.contains("paint-order"))
            .map(|it| [number(it, "x") - 7.0, number(it, "y") + 5.0]);
        let pieces = segments(&world, &root, 8.0 * orbit.distance);
        if pieces.len() > 24 {
            assert!(numbers.next().is_none(), "numbers of many pieces of {name}");
            continue;
        }
        let mut before: Vec<[f64; 2]> = Vec::new();
        for piece in pieces.iter().filter(|it| it.end != End::Dark) {
            let Some([(from, _), (to, _)]) = sight.clip(piece.from, piece.to) else { continue };
            let found = numbers.next().expect("a number");
            let at = |part: f64| [0, 1].map(|k| from[k] + part * (to[k] - from[k]));
            let is_free = |it: &[f64; 2]| {
                before.iter().all(|b| (it[0] - b[0]).abs() > 24.0 || (it[1] - b[1]).abs() > 17.0)
            };
            let all = [0.65, 0.4, 0.8, 0.25, 0.52].map(at);
            let expected = all.iter().copied().find(is_free).unwrap_or(all[0]);
            let what = format!("the number of ray {} of {name}", piece.ray);
            (0..2).for_each(|k| near(found[k], expected[k], PRINTED, &what));
            moved += usize::from(expected != all[0]);
            before.push(expected);
            seen += 1;
        }
        assert!(numbers.next().is_none(), "more numbers than pieces of {name}");
    }
    assert!(seen > 20 && moved > 3, "{seen} numbers, {moved} of them moved");
}
