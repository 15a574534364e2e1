//! What a section draws, and where: lengths of rays, arcs and their letters, normals, words, whose outlines there are.

use groundtruth::explain::{self, RecordedHit, RecordedRay};
use groundtruth::math::{Point, Vector, atan2, cos_degrees, sin_degrees, to_degrees};
use groundtruth::trace::RayKind;
use groundtruth::world::World;
use space::{Role, Section, Stroke};

use super::borders::{near, numbers};
use super::section::trees;
use super::support::{WHITE, built, light, object, traced};

/// Of a length: products of a few rounded numbers.
const ROUNDING: f64 = 1e-9;
/// Printed numbers have four digits.
const PRINTED: f64 = 5e-4;

fn is_shadow(ray: &RecordedRay) -> bool {
    matches!(ray.kind, RayKind::Shadow { .. })
}

/// A block of glass under y = 0, seen in the middle under this angle to the y axis, and a matte floor far below; the tree.
pub fn block(degrees: f64) -> (&'static str, World, RecordedRay) {
    let (x, y) = (10.0 * sin_degrees(degrees), 10.0 * cos_degrees(degrees));
    let floor = object("floor", "shape.plane = { point = [0, -9, 0], normal = [0, 1, 0] }");
    let text = format!(
        r#"
        image = {{ width = 5, height = 5 }}
        camera = {{ eye = [{x}, {y}, 0], look_at = [0, 0, 0], up = [0, 0, -1], lens.orthographic = {{}} }}
        tracer.whitted = {{ max_depth = 4 }}
        {WHITE}{floor}[[materials]]
        name = "glass"
        recipe.dielectric = {{ inside = {{ eta = 1.5 }} }}
        [[objects]]
        name = "block"
        material = "glass"
        shape.box = {{ min = [-6, -3, -6], max = [6, 0, 6] }}
        "#
    );
    let (world, root) = traced(&text, [2, 2]);
    ("block", world, root)
}

/// Mirrors of meshes with smooth normals, which leave the plane of incidence.
fn smooth() -> Vec<(&'static str, World, RecordedRay)> {
    let name = "ch24/mirror-meshes";
    let scene = (gallery::find(name).expect("a scene").build)();
    let mut found = Vec::new();
    for x in 1..8 {
        let world = World::build(&scene).expect("valid");
        let [width, height] = world.picture_size();
        let root = explain::sample(&scene, &world, [x * width / 8, height / 2], 0).ray;
        found.extend(root.map(|root| (name, world, root)));
    }
    found
}

/// Trees of the gallery, and blocks seen under angles around the borders at which arcs, letters and indices move.
fn all() -> Vec<(&'static str, World, RecordedRay)> {
    let mut all = trees();
    all.extend(smooth());
    all.extend([0.0, 0.05, 0.2, 5.0, 11.9, 12.1, 30.0, 44.9, 45.1, 60.0, 85.0].map(block));
    all
}

/// Each ray of a tree that hits something, but for shadow rays: the tree's world, the ray, its hit and its section.
fn each(mut look: impl FnMut(&str, &World, &RecordedRay, &RecordedHit, &Section)) {
    for (name, world, root) in all() {
        for ray in root.rays().into_iter().filter(|ray| !is_shadow(ray)) {
            let Some(hit) = &ray.hit else { continue };
            let section = Section::of(&world, &root, ray.number).expect("it hits");
            look(name, &world, ray, hit, &section);
        }
    }
}

/// The length at which rays are cut: 0.8 of the half side of the drawing, which is 0.75 of the object's diagonal, but at most
/// 1.3 of the longest ray that the hit ends or that goes on to the same object.
fn cut(world: &World, ray: &RecordedRay, hit: &RecordedHit) -> f64 {
    let object = world.objects().iter().find(|it| *it.name == *hit.object).expect("it is hit");
    let bounds = object.bounds();
    let diagonal =
        if bounds.is_bounded() { (bounds.max - bounds.min).length() } else { f64::INFINITY };
    let mut longest = hit.t;
    for next in ray.children.iter().filter_map(|child| child.hit.as_ref()) {
        if next.object == hit.object {
            longest = longest.max(next.t);
        }
    }
    0.8 * (0.75 * diagonal).min(1.3 * longest)
}

/// Law: the arriving ray is as long as it is, or cut; one that is sent too, unless the next hit is at most a quarter farther than
/// the cut; each is the projection of its recorded direction, has an arrow, is dashed where it leaves the plane, and its role is
/// that of its kind. Oracle: the recorded hits and directions.
#[test]
fn rays_of_a_section_are_as_long_as_they_are_or_cut() {
    let mut seen = [0; 3];
    each(|name, world, ray, hit, section| {
        let cut = cut(world, ray, hit);
        let plane = section.plane;
        let across = plane.normal();
        let drawn: Vec<&Stroke> =
            section.drawing.strokes.iter().filter(|it| it.ray.is_some()).collect();
        let sent: Vec<&RecordedRay> = ray.children.iter().filter(|it| !is_shadow(it)).collect();
        assert_eq!(drawn.len(), 1 + sent.len(), "rays drawn at ray {} of {name}", ray.number);
        assert_eq!(section.angles.len(), drawn.len(), "angles at ray {} of {name}", ray.number);
        for (k, stroke) in drawn.into_iter().enumerate() {
            let of = if k == 0 { ray } else { sent[k - 1] };
            let what = format!("ray {} in the section of ray {} of {name}", of.number, ray.number);
            assert_eq!(stroke.ray, Some(of.number), "the number of {what}");
            assert_eq!(section.angles[k].ray, of.number, "the angle's ray, {what}");
            assert!(stroke.arrow, "{what} has an arrow");
            let way = of.ray.direction.unit().expect("a direction");
            let (long, role) = match k {
                0 => (hit.t.min(cut), Role::Incoming),
                _ => {
                    let reach = of.hit.as_ref().map_or(f64::INFINITY, |hit| hit.t);
                    let is_sent_on = of.kind == RayKind::Transmitted;
                    let role = if is_sent_on { Role::Transmitted } else { Role::Reflected };
                    seen[usize::from(reach <= 1.25 * cut)] += 1;
                    (if reach <= 1.25 * cut { reach } else { cut }, role)
                }
            };
            assert_eq!(stroke.role, role, "the role of {what}");
            let out = way.dot(across);
            assert_eq!(stroke.dashed, out.abs() > 1e-6, "dashes of {what}, {out} out of the plane");
            let expected = long * (way - out * across);
            let [from, to] = [0, 1].map(|end| plane.to_space(stroke.points[end]));
            let off = (to - from - expected).length();
            near(off / long, 0.0, 10.0 * ROUNDING, &format!("the way of {what}, off"));
            let fixed = if k == 0 { to } else { from };
            near(
                fixed.distance(hit.point) / long,
                0.0,
                10.0 * ROUNDING,
                &format!("the end of {what} at the hit"),
            );
            if stroke.dashed {
                let notes = &section.drawing.notes;
                let head = format!("Ray {} leaves the plane by ", of.number);
                let note = notes.iter().find(|it| it.starts_with(&head)).expect("a note");
                let found = numbers(note);
                let by = to_degrees(atan2(out.abs(), (way - out * across).length()));
                near(found[1], by, PRINTED * by + 1e-9, note);
                near(found[2], section.angles[k].degrees, PRINTED * found[2] + 1e-9, note);
                seen[2] += 1;
            }
        }
    });
    assert!(seen.iter().all(|n| *n > 3), "cut, whole, out of the plane: {seen:?}");
}

/// Law: outlines of the object that is hit are those of the drawing's subject and drawn last; all others are surroundings.
/// Oracle: the names.
#[test]
fn outlines_of_other_objects_are_surroundings() {
    let mut seen = [0; 2];
    each(|name, world, ray, hit, section| {
        let named =
            |index: u32| world.objects().iter().find(|it| it.index == index).expect("it is there");
        let outlines = section.drawing.strokes.iter().filter_map(|it| Some((it.object?, it.role)));
        let mut last = false;
        for (object, role) in outlines {
            let is_hit = *named(object).name == *hit.object;
            let expected = if is_hit { Role::Outline } else { Role::Surroundings };
            assert_eq!(
                role, expected,
                "outline of object {object} at ray {} of {name}",
                ray.number
            );
            assert!(is_hit >= last, "surroundings are drawn first at ray {} of {name}", ray.number);
            last = is_hit;
            seen[usize::from(is_hit)] += 1;
        }
    });
    assert!(seen.iter().all(|n| *n > 10), "outlines of others, of the object: {seen:?}");
}

/// Law: the first section of a tree is that of the camera's ray if its hit sends a ray on, or nothing, and that of its first
/// shadow ray if it sends only such. Oracle: four scenes.
#[test]
fn the_first_section_says_most() {
    let tree = |recipe: &str, lamps: usize| {
        let mut text = format!(
            "image = {{ width = 5, height = 5 }}\ntracer.whitted = {{ max_depth = 1 }}\n\
             camera = {{ eye = [0, 0, 10], lens.orthographic = {{}} }}\n\
             [[materials]]\nname = \"it\"\nrecipe.{recipe}\n\
             [[objects]]\nname = \"ball\"\nmaterial = \"it\"\n\
             shape.sphere = {{ center = [0, 0, 0], radius = 1.5 }}\n"
        );
        for lamp in 0..lamps {
            let source = format!("point = {{ location = [0, {lamp}, 9], ls = 1 }}");
            text += &light(&lamp.to_string(), &source);
        }
        let (scene, world) = built(&text);
        [[2, 2], [0, 0]].map(|pixel| {
            let root = explain::sample(&scene, &world, pixel, 0).ray.expect("a ray");
            let first = Section::first(&root);
            let is_drawn = first.is_some_and(|ray| Section::of(&world, &root, ray).is_some());
            assert_eq!(is_drawn, first.is_some(), "whether the first section is drawn");
            first
        })
    };
    let matte = "matte = { kd = 1, cd = 1 }";
    let mirror = "reflective = { phong = { cd = 1, cs = 1, exponent = 1 }, kr = 1, cr = 1 }";
    let glass = "dielectric = { inside = { eta = 1.5 } }";
    assert_eq!(tree(matte, 0), [Some(0), None], "first sections without lights");
    assert_eq!(tree(matte, 2), [Some(1), None], "first sections with two lamps");
    assert_eq!(tree(mirror, 2), [Some(0), None], "first sections of a mirror");
    assert_eq!(tree(glass, 2), [Some(0), None], "first sections of glass");
}

/// Law: the plane contains hit, normal and ray, its axes are at right angles, and x goes where the ray goes. Where the ray is along
/// the normal x is the world's x axis, or z, if the normal is nearer to x, as far as it is along the surface. Oracle: products.
#[test]
fn the_plane_of_incidence_goes_where_the_ray_goes() {
    let mut straight = 0;
    each(|name, _, ray, hit, section| {
        let plane = section.plane;
        let [x, y] = [[1.0, 0.0], [0.0, 1.0]].map(|at| plane.vector(at));
        let z = plane.normal();
        let what = format!("ray {} of {name}", ray.number);
        for (a, b, expected) in
            [(x, x, 1.0), (y, y, 1.0), (z, z, 1.0), (x, y, 0.0), (y, z, 0.0), (z, x, 0.0)]
        {
            near(a.dot(b), expected, ROUNDING, &format!("a product of axes of {what}"));
        }
        near((x.cross(y) - z).length(), 0.0, ROUNDING, "x × y, off z");
        assert_eq!(plane.to_space([0.0; 2]), hit.point, "the origin of the plane of {what}");
        let way = ray.ray.direction.unit().expect("a direction");
        let sine = way.cross(hit.normal).length();
        assert_eq!(plane.is_any, sine <= 1e-7, "whether any plane will do for {what}");
        if plane.is_any {
            let n = hit.normal;
            let axis = if n.x().abs() <= n.z().abs() { Vector::X } else { Vector::Z };
            let along = axis - axis.dot(n) * Vector::from(n);
            near(x.cross(along).length(), 0.0, ROUNDING, "the x axis, off");
            assert!(x.dot(along) > 0.0, "the x axis of {what} goes the other way");
            straight += 1;
        } else {
            near(way.dot(x), sine, ROUNDING, "the ray's way to the right");
            let off = if sine > 1e-4 { 1e-9 } else { 1e-5 };
            near(way.dot(z), 0.0, off, "the ray's way out of its plane");
        }
    });
    assert!(straight > 0, "rays along the normal: {straight}");
    let (_, world, root) = block(0.0);
    let section = Section::of(&world, &root, 0).expect("it hits");
    assert_eq!(section.plane.vector([1.0, 0.0]), Vector::X, "the x axis of a block from above");
    assert_eq!(section.plane.origin, Point::ORIGIN, "the origin of a block from above");
}
