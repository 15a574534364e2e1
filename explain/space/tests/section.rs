//! Sections against the recorded directions, Snell's law, closed forms of shapes and the world's distances.

use std::path::Path;

use groundtruth::explain::{self, RecordedRay};
use groundtruth::math::{Pcg32, Point, Vector, sin_degrees};
use groundtruth::trace::RayKind;
use groundtruth::world::{self, World};
use space::{Drawing, Label, Role, Section, SectionPlane, Stroke, Window, outlines};

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
    let mut found = Vec::new();
    for name in names {
        let scene = (gallery::find(name).expect("a scene of the gallery").build)();
        let world = World::build(&scene).unwrap();
        let [width, height] = world.picture_size();
        for pixel in [[width / 2, height / 2], [width / 3, height / 2]] {
            let root = explain::sample(&scene, &world, pixel, 0).ray.unwrap();
            found.push((name, world_of(name), root));
        }
    }
    found
}

fn world_of(name: &str) -> World {
    World::build(&(gallery::find(name).unwrap().build)()).unwrap()
}

fn direction(plane: &SectionPlane, stroke: &Stroke) -> Vector {
    let [from, to] = [stroke.points[0], stroke.points[1]].map(|point| plane.to_space(point));
    (to - from).unit().unwrap()
}

fn lines(drawing: &Drawing) -> impl Iterator<Item = &Stroke> {
    drawing.strokes.iter().filter(|stroke| stroke.ray.is_some())
}

/// Law: the drawn lines of rays have the recorded directions, and their angles are those. Oracle: the recorded directions
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
            for stroke in lines(&section.drawing).filter(|stroke| !stroke.dashed) {
                let off =
                    (direction(&section.plane, stroke) - recorded(stroke.ray.unwrap())).length();
                assert!(off < 3e-6, "{name}, ray {}: {stroke:?} is {off} off", ray.number);
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
    let text = format!(
        r#"
        image = {{ width = 5, height = 5, pixel_size = 0.2 }}
        camera = {{ eye = {eye}, look_at = [0, 0, 0], lens.orthographic = {{}} }}
        [[lights]]
        name = "lamp"
        source.point = {{ location = [0, 8, 0], ls = 1 }}
        [[materials]]
        name = "white"
        recipe.matte = {{ kd = 1, cd = [1, 1, 1] }}
        [[objects]]
        name = "shape"
        material = "white"
        shape.{shape}
        "#
    );
    let (scene, world) = world::from_toml(&text, Path::new("here.toml")).unwrap();
    let root = explain::sample(&scene, &world, [3, 1], 0).ray.unwrap();
    (world, root)
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
    let text = r#"
        image = { width = 5, height = 5 }
        camera = { eye = [0, 0, 10], lens.orthographic = {} }
        [[materials]]
        name = "white"
        recipe.matte = { kd = 1, cd = [1, 1, 1] }
        [[objects]]
        name = "ball"
        material = "white"
        shape.sphere = { center = [0, 0, 0], radius = 1 }
    "#;
    let (scene, world) = world::from_toml(text, Path::new("here.toml")).unwrap();
    let root = explain::sample(&scene, &world, [2, 2], 0).ray.unwrap();
    let section = Section::of(&world, &root, 0).unwrap();
    assert!(section.plane.is_any);
    assert_eq!(section.plane.vector([1.0, 0.0]).to_array(), [1.0, 0.0, 0.0]);
    assert_eq!(section.plane.vector([0.0, 1.0]).to_array(), [0.0, 0.0, 1.0]);
    assert!(section.drawing.notes.iter().any(|note| note.contains("x axis")));
}

/// Law: the section of a shadow ray contains hit, normal and light, and says what blocks it and where. Closed form: from
/// (0.4, 0, 0) on the floor to the lamp (0, 8, 0), the way x = 0.4 − 0.4 s, y = 8 s meets the ball of radius 1 around
/// (0, 4, 0) first at the smaller root of (0.4 − 0.4 s)² + (8 s − 4)² = 1.
#[test]
fn the_section_of_a_shadow_ray_shows_its_occluder() {
    let text = r#"
        image = { width = 5, height = 5, pixel_size = 0.2 }
        camera = { eye = [0, 2, 10], look_at = [0, 0, 0], lens.orthographic = {} }
        [[lights]]
        name = "lamp"
        source.point = { location = [0, 8, 0], ls = 1 }
        [[materials]]
        name = "white"
        recipe.matte = { kd = 1, cd = [1, 1, 1] }
        [[objects]]
        name = "floor"
        material = "white"
        shape.plane = { point = [0, 0, 0], normal = [0, 1, 0] }
        [[objects]]
        name = "ball"
        material = "white"
        shape.sphere = { center = [0, 4, 0], radius = 1 }
    "#;
    let (scene, world) = world::from_toml(text, Path::new("here.toml")).unwrap();
    let root = explain::sample(&scene, &world, [4, 2], 0).ray.unwrap();
    let shadow = root.rays().into_iter().find(|it| matches!(it.kind, RayKind::Shadow { .. }));
    let section = Section::of(&world, &root, shadow.unwrap().number).unwrap();
    assert_eq!(Section::first(&root), Some(shadow.unwrap().number));
    let hit = root.hit.as_ref().unwrap().point;
    assert!(hit.distance(Point::new(0.4, 0.0, 0.0)) < 1e-12, "{hit:?}");
    let lamp = Point::new(0.0, 8.0, 0.0);
    assert!((lamp - section.plane.origin).dot(section.plane.normal()).abs() < 1e-12);
    let blocked = section.drawing.strokes.iter().find(|it| it.role == Role::Blocked).unwrap();
    let met = section.plane.to_space(blocked.points[1]);
    // 64.16 s² − 64.32 s + 15.16 = 0
    let s = (64.32 - (64.32_f64 * 64.32 - 4.0 * 64.16 * 15.16).sqrt()) / (2.0 * 64.16);
    assert!(met.distance(Point::new(0.4 - 0.4 * s, 8.0 * s, 0.0)) < 1e-9, "{met:?}");
    let dark = section.drawing.strokes.iter().find(|it| it.role == Role::Dark).unwrap();
    assert!(section.plane.to_space(dark.points[1]).distance(lamp) < 1e-9);
    let normal = section.drawing.labels.iter().find(|it| it.text == "normal").unwrap();
    let away_from_light = -dark.points[1][0].signum();
    assert_eq!(f64::from(normal.side[0]), away_from_light, "the side of the word `normal`");
    let about = section.drawing.strokes.iter().filter(|it| it.role == Role::Outline);
    let mut objects: Vec<u32> = about.filter_map(|it| it.object).collect();
    objects.dedup();
    assert_eq!(objects, [0, 1]);
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

/// Law: words of a scene cannot be markup. Oracle: the text of the SVG.
#[test]
fn names_are_escaped_in_svg() {
    let mut drawing = Drawing { title: "<&>".to_owned(), ..Drawing::default() };
    drawing.notes.push("a < b".to_owned());
    drawing.strokes.push(Stroke::new(Role::Arc, vec![[0.0, 0.0], [1.0, 1.0]]));
    let svg = drawing.svg();
    assert!(svg.contains("<title>&lt;&amp;&gt;</title>") && svg.contains("a &lt; b"), "{svg}");
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

/// The numbers of an attribute in each element of this name.
fn attributes(svg: &str, element: &str, name: &str) -> Vec<f64> {
    let of = |it: &str| it.split_once(&format!("{name}=\""))?.1.split('"').next()?.parse().ok();
    svg.lines().filter(|it| it.starts_with(element)).filter_map(of).collect()
}

/// Law: the words of a drawing are inside of it, on the side of their point that they ask for, and 8 away from it. Oracle: the
/// box of each text from its printed place and anchor, with letters of 25, 0.56 of that wide, in lines of 1.15 of it.
#[test]
fn words_stand_beside_their_points_inside_of_the_drawing() {
    let random = &mut Pcg32::new(1, 61);
    for case in 0..60_u32 {
        let mut drawing = Drawing::default();
        let scale = [0.01, 1.0, 300.0][case as usize % 3];
        let mut point = || [scale * random.uniform(), 0.7 * scale * random.uniform()];
        for index in 0..1 + case as usize % 5 {
            let (at, mut text) = (point(), "word ".repeat(1 + index % 4));
            text += &index.to_string();
            let side = [index as i8 % 3 - 1, (index as i8 + case as i8) % 3 - 1];
            drawing.strokes.push(Stroke::new(Role::Arc, vec![at]));
            drawing.labels.push(Label { at, text, role: Role::Arc, side });
        }
        drawing.strokes.push(Stroke::new(Role::Arc, vec![point(), point()]));
        let svg = drawing.svg();
        let box_of_all = svg.split_once("viewBox=\"0 0 800 ").unwrap().1;
        let height: f64 = box_of_all.split('"').next().unwrap().parse().unwrap();
        let [cx, cy] = ["cx", "cy"].map(|name| attributes(&svg, "<circle", name));
        let [x, y] = [" x", " y"].map(|name| attributes(&svg, "<text", name));
        for (index, label) in drawing.labels.iter().enumerate() {
            let (width, line) = (0.56 * 25.0 * label.text.chars().count() as f64, 1.15 * 25.0);
            let left = x[index] - [width, 0.5 * width, 0.0][(label.side[0] + 1) as usize];
            let bottom = y[index] + 0.3 * 25.0;
            let sides = [[left, left + width, cx[index]], [bottom - line, bottom, cy[index]]];
            for (axis, [low, high, at]) in sides.into_iter().enumerate() {
                let most = [800.0, height][axis];
                assert!(low >= -0.6 && high <= most + 0.6, "{label:?}: {low} to {high} of {most}");
                // y goes down here
                let away = match label.side[axis] * [1, -1][axis] {
                    0 => (0.5 * (low + high) - at).abs() + 8.0,
                    side if side < 0 => at - high,
                    _ => low - at,
                };
                assert!((away - 8.0).abs() < 0.15, "{label:?}: {away} away, expected 8");
            }
        }
    }
}
