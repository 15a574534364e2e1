//! What cannot be said is refused, and what is beside it is said: each pair of scenes differs in one thing.

use std::path::Path;

use exchange::export::Target;
use groundtruth::scene::Scene;
use groundtruth::world;

use super::texts::Parts;

pub const MATTE: &str = "matte = { kd = 0.5, cd = 1 }";
pub const SUN: &str =
    "[[lights]]\nname = \"sun\"\nsource.directional = { direction = [1, 2, 3], ls = 1 }\n";
pub const LAMP: &str = "[[lights]]\nname = \"area\"\nsource.area = { object = \"lamp\" }\n\
                    [[materials]]\nname = \"shining\"\nrecipe.emissive = { ls = 1, ce = 1 }\n\
                    [[objects]]\nname = \"lamp\"\nmaterial = \"shining\"\n\
                    shape.sphere = { center = [0, 5, 0], radius = 1 }\n";
pub const PATH: &str = "tracer.path = { max_depth = 3 }\n";
pub const WHITTED: &str = "tracer.whitted = { max_depth = 3 }\n";

/// A ball of this recipe, seen by this camera.
pub fn seen(camera: &str, head: &str, recipe: &str, rest: &str) -> Scene {
    let text = format!(
        "{head}\nimage = {{ width = 4, height = 4 }}\ncamera = {{ {camera} }}\n\
         [[materials]]\nname = \"it\"\nrecipe.{recipe}\n\
         [[objects]]\nname = \"it\"\nmaterial = \"it\"\n{rest}"
    );
    let read = world::from_toml(&text, Path::new("here.toml"));
    read.unwrap_or_else(|error| panic!("{error}: {text}")).0
}

pub const PINHOLE: &str = "eye = [0, 0, 9], lens.pinhole = { distance = 5 }";
pub const BALL: &str = "shape.sphere = { center = [0, 0, 0], radius = 1 }\n";

pub fn ball(head: &str, recipe: &str, rest: &str) -> Scene {
    seen(PINHOLE, head, recipe, &format!("{BALL}{rest}"))
}

/// What is refused, a line each.
pub fn refused(target: Target, scene: &Scene) -> Vec<String> {
    let written = target.write("scene", "scene", scene, "".as_ref());
    written.err().unwrap_or_default().iter().map(ToString::to_string).collect()
}

/// Law: Mitsuba is refused the book's routines of objects that are on, whether the scene or the object says them. Oracle: both
/// sayings, crossed.
#[test]
fn the_routines_of_the_book_are_refused_where_they_are_used() {
    let (book, ours) = ("intersect = \"textbook\"\n", "intersect = \"robust\"\n");
    for (of_scene, own, is_on, expected) in [
        ("", "", true, false),
        (book, "", true, true),
        (book, ours, true, false),
        ("", book, true, true),
        (ours, book, true, true),
        ("", book, false, false),
    ] {
        let other = format!(
            "{own}{SUN}[[objects]]\nname = \"other\"\nmaterial = \"it\"\nintersect = \"robust\"\n{BALL}"
        );
        let mut scene = ball(of_scene, MATTE, &other);
        scene.objects[0].enabled = is_on;
        let all = refused(Target::Mitsuba, &scene);
        let found = all.iter().any(|it| it.starts_with("intersect"));
        assert_eq!(found, expected, "scene `{of_scene}`, object `{own}`, on {is_on}: {all:?}");
        assert_eq!(all.is_empty(), !expected, "what else is refused: {all:?}");
    }
}

/// Law: objects and materials without shadows are refused to Mitsuba where something would be blocked: by any light for tracers of
/// direct light, by suns and point lamps only for paths, which blocked lamps do not count for. Oracle: the definition of shadows.
#[test]
fn what_casts_no_shadow_is_refused_where_it_would_cast_one() {
    for (tracer, lights, blocks) in [
        ("", SUN, true),
        ("", LAMP, true),
        (WHITTED, SUN, true),
        (WHITTED, LAMP, true),
        (PATH, SUN, true),
        (PATH, LAMP, false),
        ("background = 0.5\n", "", false),
    ] {
        for (is_object, is_on) in [(true, true), (true, false), (false, true)] {
            let mut scene = ball(tracer, MATTE, lights);
            scene.objects.push(scene.objects[0].clone());
            let own = scene.objects.len() - 1;
            scene.objects[own].name = "other".to_owned();
            scene.objects[own].enabled = is_on;
            match is_object {
                true => scene.objects[own].casts_shadows = false,
                false => scene.materials[0].casts_shadows = false,
            }
            let all = refused(Target::Mitsuba, &scene);
            let expected = blocks && is_on;
            let what = format!("object {is_object}, on {is_on}, `{tracer}`, {lights}");
            assert_eq!(all.len(), usize::from(expected), "what is refused, {what}: {all:?}");
            let name = if is_object { "\"other\": casts_shadows" } else { "\"it\": casts_shadows" };
            let is_named = all.iter().all(|it| it.contains(name));
            assert!(is_named, "what is refused is {name}, {what}: {all:?}");
        }
    }
}

/// Law: mirrors beside matte surfaces that lights light are refused to Mitsuba under `whitted`, and mirrors alone are not: a
/// recipe is matte if its kd is not 0. Oracle: the kd of each recipe.
#[test]
fn mirrors_beside_lit_matte_surfaces_are_refused() {
    let mirror =
        "reflective = { phong = { cd = 1, cs = 1, exponent = 1, kd = 0 }, kr = 1, cr = 1 }";
    let phong = |kd: f64| format!("phong = {{ kd = {kd}, cd = 1, cs = 1, exponent = 1 }}");
    let recipes = |kd: f64| {
        [
            format!("matte = {{ kd = {kd}, cd = 1 }}"),
            phong(kd),
            format!("reflective = {{ {}, kr = 0.5, cr = 1 }}", phong(kd)),
            format!("glossy_reflector = {{ {}, kr = 0.5, cr = 1, exponent = 9 }}", phong(kd)),
            format!("emissive = {{ ls = 1, ce = 1, matte = {{ kd = {kd}, cd = 1 }} }}"),
        ]
    };
    let mut seen = [0; 2];
    for kd in [0.0, 0.25] {
        for recipe in recipes(kd) {
            for (lights, is_lit) in [(SUN, true), ("", false)] {
                let head = format!("{WHITTED}background = 0.5\n");
                let other = format!(
                    "{lights}[[materials]]\nname = \"mirror\"\nrecipe.{mirror}\n\
                     [[objects]]\nname = \"mirror\"\nmaterial = \"mirror\"\n{BALL}"
                );
                let all = refused(Target::Mitsuba, &ball(&head, &recipe, &other));
                let found = all.iter().any(|it| it.contains("mirrors beside lit matte surfaces"));
                let expected = kd > 0.0 && is_lit;
                assert_eq!(found, expected, "a mirror beside {recipe}, lit {is_lit}: {all:?}");
                seen[usize::from(expected)] += 1;
            }
        }
    }
    assert!(seen.iter().all(|n| *n > 3), "said and refused: {seen:?}");
}

/// Law: paths that meet no matte surface see no sun; `global_trace` of a sun is refused where it goes on from matte surfaces.
/// Oracle: the scene.
#[test]
fn suns_are_written_where_something_scatters_their_light() {
    let mirror =
        "reflective = { phong = { cd = 1, cs = 1, exponent = 1, kd = 0 }, kr = 1, cr = 1 }";
    let sky = "background = 0.5\n";
    for (recipe, suns) in [(MATTE, 1), (mirror, 0)] {
        let scene = ball(&format!("{PATH}{sky}"), recipe, SUN);
        let found = Parts::mitsuba(&scene).all("<emitter type=\"directional\"").len();
        assert_eq!(found, suns, "suns of paths on {recipe}");
    }
    for (depth, recipe, lights, expected) in [
        (3, MATTE, SUN, true),
        (2, MATTE, SUN, true),
        (1, MATTE, SUN, false),
        (3, mirror, SUN, false),
        (3, MATTE, LAMP, false),
    ] {
        let head = format!("tracer.global_trace = {{ max_depth = {depth} }}\n{sky}");
        let all = refused(Target::Mitsuba, &ball(&head, recipe, lights));
        let found = all.iter().any(|it| it.starts_with("tracer"));
        assert_eq!(found, expected, "depth {depth}, {recipe}, {lights}: {all:?}");
    }
}

const BOTH: &str = "shines on both sides";

/// A lamp that shines on both sides: its refusals, and whether its normal is flipped.
fn two_sided(camera: &str, head: &str, shape: &str) -> Result<bool, Vec<String>> {
    let mut scene =
        seen(camera, head, "emissive = { ls = 1, ce = 1 }", &format!("shape.{shape}\n"));
    scene.materials[0].two_sided = true;
    let all = refused(Target::Mitsuba, &scene);
    if all.is_empty() {
        let text = Target::Mitsuba.write("scene", "scene", &scene, "".as_ref());
        let text = text.expect("nothing is refused").text;
        let flips = text.lines().find(|it| it.contains("flip_normals"));
        return Ok(flips.is_some_and(|it| it.contains("true")));
    }
    assert!(all.iter().all(|it| it.contains(BOTH)), "what is refused: {all:?}");
    Err(all)
}

/// Law: a sphere that shines on both sides shines inward there if the eye is inside, and outward if not; rays that start at many
/// places are refused unless all start before or behind it. Oracle: distances, of a sphere and of one that is scaled.
#[test]
fn a_shining_sphere_shines_to_the_side_of_the_eye() {
    let of = |x: f64, scale: f64| {
        format!(
            "instance = {{ of.sphere = {{ center = [{x}, 0, 0], radius = 1 }}, transform = [{{ scale = [{scale}, {scale}, {scale}] }}] }}"
        )
    };
    for scale in [1.0, 2.0, 0.5] {
        for inward in [false, true] {
            let plain =
                format!("sphere = {{ center = [0, 0, 0], radius = {scale}, inward = {inward} }}");
            for part in [3.0, 1.01, 0.99, 0.3] {
                let z = scale * part;
                let pinhole = format!(
                    "eye = [0, 0, {z}], look_at = [0, 0, -9], lens.pinhole = {{ distance = 5 }}"
                );
                for shape in [&plain, &of(0.0, scale)] {
                    let found = two_sided(&pinhole, "", shape);
                    assert_eq!(found, Ok(part < 1.0), "{shape}, seen from {z}");
                }
            }
        }
        for part in [3.0, 1.01, 0.99, 0.3, -0.99, -1.01] {
            let z = scale * part;
            for lens in [
                "orthographic = {}",
                "thin_lens = { lens_radius = 0.01, distance = 5, focal_distance = 9 }",
            ] {
                for x in [0.0, 20.0] {
                    let camera = format!("eye = [0, 0, {z}], look_at = [0, 0, -9], lens.{lens}");
                    let found = two_sided(&camera, "", &of(x, scale));
                    assert_eq!(
                        found.is_ok(),
                        part.abs() > 1.0,
                        "{lens} from {z}, {x} aside, scale {scale}"
                    );
                }
            }
        }
    }
}

/// Law: a flat lamp that shines on both sides shines to the side that a pinhole or parallel rays see, and is refused where rays may
/// see both: through a lens, and after the first hit; other shapes that shine on both sides are refused. Oracle: the side.
#[test]
fn a_flat_lamp_shines_to_the_side_that_is_seen() {
    for shape in [
        "rectangle = { corner = [-1, -1, 0], a = [2, 0, 0], b = [0, 2, 0] }",
        "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }",
    ] {
        for z in [4.0, -4.0] {
            let at = format!("eye = [1, 2, {z}], look_at = [0, 0, 0]");
            for lens in ["pinhole = { distance = 5 }", "orthographic = {}"] {
                let camera = format!("{at}, lens.{lens}");
                assert_eq!(
                    two_sided(&camera, "", shape),
                    Ok(z < 0.0),
                    "{shape} by {lens} from {z}"
                );
                for (depth, expected) in [(0, true), (1, false)] {
                    let head = format!("tracer.path_trace = {{ max_depth = {depth} }}\n");
                    let found = two_sided(&camera, &head, shape);
                    assert_eq!(found.is_ok(), expected, "{shape}, paths of depth {depth}");
                }
            }
            let lens = "lens.thin_lens = { lens_radius = 0.1, distance = 5, focal_distance = 9 }";
            let found = two_sided(&format!("{at}, {lens}"), "", shape);
            assert!(found.is_err(), "{shape} through a lens is refused");
        }
        // beyond the camera's eye, what is looked at is behind the lamp
        let camera = "eye = [0, 0, 4], look_at = [0, 0, -9], lens.pinhole = { distance = 5 }";
        assert_eq!(two_sided(camera, "", shape), Ok(false), "{shape}, looked through");
    }
    for shape in [
        "open_cylinder = { y0 = 0, y1 = 1, radius = 1 }",
        "box = { min = [0, 0, 0], max = [1, 1, 1] }",
        "triangle = { vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]] }",
    ] {
        let found = two_sided(PINHOLE, "", shape);
        assert!(found.is_err(), "{shape} that shines on both sides is refused");
    }
}

/// Law: a shape that is written as its parts is refused if there are more than 200,000; the error says how many. Oracle: the parts
/// that are written of one, counted, times the copies of a lattice.
#[test]
fn too_many_parts_are_counted() {
    let sphere = "sphere = { center = [0, 0, 0], radius = 1 }";
    for (it, parts) in [
        (sphere.to_owned(), 1),
        (format!("compound = {{ parts = [{{ shape.{sphere} }}, {{ shape.{sphere} }}, {{ shape.{sphere} }}] }}"), 3),
        ("solid_cylinder = { y0 = 0, y1 = 1, radius = 1 }".to_owned(), 3),
        ("solid_cone = { height = 1, radius = 1 }".to_owned(), 2),
        ("thick_ring = { y0 = 0, y1 = 1, inner_radius = 1, outer_radius = 2 }".to_owned(), 4),
        ("random_spheres = { count = 7, radius = 0.1, half_side = 1, seed = 1 }".to_owned(), 7),
        (
            "instance = { of.solid_cone = { height = 1, radius = 1 }, transform = [{ rotate_x = 9 }] }".to_owned(),
            2,
        ),
    ] {
        let alone = seen(PINHOLE, "", MATTE, &format!("shape.{it}\n{SUN}"));
        let text = Target::Pov.write("scene", "scene", &alone, "".as_ref()).expect("said");
        let written = text.text.matches("interior_texture").count();
        assert_eq!(written, parts, "parts that are written of {it}");
        let copies = 200_000 / parts + 1;
        let many = format!("lattice = {{ of.{it}, counts = [{copies}, 1, 1], spacing = [3, 3, 3] }}");
        let many = seen(PINHOLE, "", MATTE, &format!("shape.{many}\n{SUN}"));
        let all = refused(Target::Pov, &many).join("\n");
        let expected = format!("{} shapes, and 200000 are the most", copies * parts);
        assert!(all.contains(&expected), "no `{expected}` for {it} in {all}");
    }
}

/// Law: POV-Ray is given 200,000 triangles, and what has the next one is refused, once. Oracle: a sphere of 2 · 1000 · 100
/// triangles, and triangles after it.
#[test]
fn triangles_beyond_the_most_are_refused_once() {
    let rest = "shape.tessellated_sphere = { radius = 1, horizontal = 1000, vertical = 101 }\n"
        .to_owned()
        + SUN
        + &["first", "second"]
            .map(|name| {
                format!(
                    "[[objects]]\nname = \"{name}\"\nmaterial = \"it\"\n\
                 shape.triangle = {{ vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]] }}\n"
                )
            })
            .concat();
    let all = refused(Target::Pov, &seen(PINHOLE, "", MATTE, &rest));
    assert_eq!(all.len(), 1, "what is refused: {all:?}");
    let is_first = all[0].contains("\"first\"") && all[0].contains("200000 triangles");
    assert!(is_first, "the first triangle beyond is refused: {all:?}");
}

/// Law: POV-Ray can be told coordinates and lengths up to 10⁶, before the map and where it moves the origin; the error names the
/// number. Oracle: numbers on both sides.
#[test]
fn povray_is_told_lengths_up_to_a_million() {
    for (x, expected) in
        [(1e6, None), (1_000_001.0, Some("1000001")), (-1_000_001.0, Some("-1000001"))]
    {
        let moved = format!(
            "instance = {{ of.sphere = {{ center = [0, 0, 0], radius = 1 }}, transform = [{{ translate = [0, {x}, 0] }}] }}"
        );
        let beside = format!("sphere = {{ center = [0, 0, {x}], radius = 1 }}");
        for shape in [moved, beside] {
            let all =
                refused(Target::Pov, &seen(PINHOLE, "", MATTE, &format!("shape.{shape}\n{SUN}")));
            let is_expected = match expected {
                None => all.is_empty(),
                Some(number) => all.len() == 1 && all[0].contains(number),
            };
            assert!(is_expected, "{shape}: {all:?}, expected {expected:?}");
        }
    }
}
