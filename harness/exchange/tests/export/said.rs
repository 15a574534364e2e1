//! What is said as a whole: lights and backgrounds, the parts of solids, sides of materials, shadows,
//! depths, and what is left out on both sides.

use exchange::export::{Target, Term};
use groundtruth::background::Background;
use groundtruth::materials;
use groundtruth::scene::Scene;
use groundtruth::shapes::Kind;

use super::fixtures::near;
use super::refused::{BALL, LAMP, MATTE, PATH, PINHOLE, SUN, WHITTED, ball, refused, seen};
use super::texts::{Parts, each, values};

/// The text of a scene for Mitsuba.
fn text_of(scene: &Scene) -> String {
    let written = Target::Mitsuba.write("scene", "scene", scene, "".as_ref());
    written.unwrap_or_else(|all| panic!("{all:?}")).text
}

fn integer(text: &str, name: &str) -> Option<u32> {
    let head = format!("<integer name=\"{name}\" value=\"");
    text.split_once(&head)?.1.split('"').next()?.parse().ok()
}

/// Law: direct light is one picture of what is seen shining, or of the lights; what would need both, or one for each of several suns,
/// is refused with its place. Oracle: the scene.
#[test]
fn what_needs_several_pictures_is_refused() {
    let second = SUN.replace("\"sun\"", "\"second\"");
    let lens =
        "eye = [0, 0, 9], lens.thin_lens = { lens_radius = 0.1, distance = 5, focal_distance = 9 }";
    let shining = "[[materials]]\nname = \"bright\"\nrecipe.emissive = { ls = 1, ce = 1 }\n\
                   [[objects]]\nname = \"bright\"\nmaterial = \"bright\"\n\
                   shape.sphere = { center = [0, 5, 0], radius = 1 }\n";
    let (sky, black) = ("background = 0.5\n", "background = 0\n");
    // the edges, the suns and whether the background is seen; or the places that are refused
    type Found = Result<(u32, usize, bool), &'static [&'static str]>;
    let cases: [(&str, &str, String, Found); 11] = [
        (PINHOLE, black, SUN.to_owned(), Ok((2, 1, false))),
        (PINHOLE, black, shining.to_owned(), Ok((1, 0, false))),
        (PINHOLE, black, format!("{SUN}{shining}"), Err(&["objects[1] \"bright\""])),
        (PINHOLE, sky, SUN.to_owned(), Err(&["background"])),
        (PINHOLE, sky, format!("{SUN}{second}"), Err(&["background", "lights"])),
        (PINHOLE, black, format!("{SUN}{second}"), Err(&["lights"])),
        (lens, black, format!("{SUN}{second}"), Ok((2, 2, false))),
        (PINHOLE, black, format!("{SUN}{LAMP}"), Ok((2, 1, false))),
        (PINHOLE, sky, LAMP.to_owned(), Err(&["background"])),
        (PINHOLE, sky, String::new(), Ok((1, 0, true))),
        (
            PINHOLE,
            sky,
            format!("{SUN}[[lights]]\nname = \"sky\"\nsource.environment = {{}}\n"),
            Ok((2, 1, true)),
        ),
    ];
    for (camera, background, lights, expected) in cases {
        for tracer in ["", WHITTED] {
            let scene =
                seen(camera, &format!("{tracer}{background}"), MATTE, &format!("{BALL}{lights}"));
            let what = format!("`{tracer}{background}{lights}`");
            match expected {
                Ok(expected) => {
                    let text = text_of(&scene);
                    let suns = text.matches("<emitter type=\"directional\"").count();
                    let has_sky = text.contains("<emitter type=\"constant\"");
                    let found = (integer(&text, "max_depth").expect("a depth"), suns, has_sky);
                    assert_eq!(found, expected, "edges, suns, background of {what}");
                }
                Err(places) => {
                    let all = refused(Target::Mitsuba, &scene);
                    let are_named = places.iter().zip(&all).all(|(place, it)| {
                        it.strip_prefix(place).is_some_and(|rest| rest.starts_with(": "))
                    });
                    assert!(
                        are_named && all.len() == places.len(),
                        "{places:?} of {what}: {all:?}"
                    );
                }
            }
        }
    }
}

/// Law: the sky is drawn from where a tracer with an environment light draws uniformly; else its weight is 0, and a black lamp takes
/// the samples if no other light does. Oracle: the lights of the scene.
#[test]
fn the_sky_is_sampled_where_ours_is() {
    let sky = "[[lights]]\nname = \"sky\"\nsource.environment = {}\n";
    let global = "tracer.global_trace = { max_depth = 1 }\n";
    let path_trace = "tracer.path_trace = { max_depth = 3 }\n";
    for (tracer, lights, is_sampled, has_black) in [
        ("", sky.to_owned(), false, true),
        ("", format!("{sky}{SUN}"), false, false),
        ("", format!("{sky}{LAMP}"), false, false),
        (PATH, sky.to_owned(), true, false),
        (PATH, String::new(), false, true),
        (PATH, SUN.to_owned(), false, false),
        (PATH, LAMP.to_owned(), false, false),
        (global, sky.to_owned(), true, false),
        (path_trace, sky.to_owned(), false, true),
    ] {
        let text = text_of(&ball(&format!("{tracer}background = 0.5\n"), MATTE, &lights));
        let constant = text.lines().find(|it| it.contains("type=\"constant\"")).expect("a sky");
        let weight = values(constant, "sampling_weight")[0];
        assert_eq!(weight, f64::from(is_sampled), "the weight of the sky, `{tracer}{lights}`");
        let black = text.contains("<emitter type=\"point\">");
        assert_eq!(black, has_black, "a black lamp, `{tracer}{lights}`");
    }
}

/// Law: a path has one edge more than our depth says; it ends at random only where matte surfaces take light away: else roulette
/// begins beyond the last edge. POV-Ray's level is one more, too. Oracle: the depth.
#[test]
fn depths_are_one_less_than_edges() {
    let mirror =
        "reflective = { phong = { cd = 1, cs = 1, exponent = 1, kd = 0 }, kr = 1, cr = 1 }";
    for depth in [0, 1, 7] {
        for (tracer, recipe, has_roulette) in
            [("path", MATTE, true), ("path", mirror, false), ("whitted", mirror, false)]
        {
            let head = format!("tracer.{tracer} = {{ max_depth = {depth} }}\nbackground = 0.5\n");
            let scene = ball(&head, recipe, "");
            let text = text_of(&scene);
            assert_eq!(integer(&text, "max_depth"), Some(depth + 1), "edges of {tracer}, {recipe}");
            let found = integer(&text, "rr_depth");
            let is_late = found.is_some_and(|it| it > depth + 1);
            assert_eq!(
                (found.is_none(), is_late),
                (has_roulette, !has_roulette),
                "roulette from {found:?} on"
            );
            if tracer == "whitted" {
                let text = Target::Pov.write("scene", "scene", &scene, "".as_ref()).expect("said");
                let level = format!("max_trace_level {}\n", depth + 1);
                assert!(text.text.contains(&level), "POV-Ray's level of depth {depth}");
            }
        }
    }
    let text = Target::Pov.write("scene", "scene", &ball("", MATTE, SUN), "".as_ref());
    assert!(text.expect("said").text.contains("max_trace_level 1\n"), "the level of ray_cast");
}

/// The numbers in a statement.
fn numbers(statement: &str) -> Vec<f64> {
    let marks = |c: char| c.is_whitespace() || "<>,{}".contains(c);
    statement
        .split(marks)
        .map_while(|it| if it.is_empty() { Some(None) } else { it.parse().ok().map(Some) })
        .flatten()
        .collect()
}

/// Law: the parts of a solid are its faces: disks with the normals outward, walls from end to end, and each has the material of its
/// name. Oracle: the faces by hand.
#[test]
fn solids_are_written_as_their_faces() {
    let disc =
        |y: f64, up: f64, outer: f64, inner: f64| vec![0.0, y, 0.0, 0.0, up, 0.0, outer, inner];
    let wall = |y0: f64, y1: f64, r: f64| vec![0.0, y0, 0.0, 0.0, y1, 0.0, r];
    let cone = |h: f64, r: f64| vec![0.0, 0.0, 0.0, r, 0.0, h, 0.0, 0.0];
    type Faces = Vec<(&'static str, Vec<f64>, &'static str, bool)>;
    let cases: [(&str, Faces); 3] = [
        (
            "solid_cylinder = { y0 = -0.5, y1 = 2, radius = 0.75",
            vec![
                ("disc", disc(-0.5, -1.0, 0.75, 0.0), "bottom", true),
                ("disc", disc(2.0, 1.0, 0.75, 0.0), "top", true),
                ("cylinder", wall(-0.5, 2.0, 0.75), "wall", true),
            ],
        ),
        (
            "solid_cone = { height = 2, radius = 0.75",
            vec![
                ("disc", disc(0.0, -1.0, 0.75, 0.0), "base", true),
                ("cone", cone(2.0, 0.75), "wall", true),
            ],
        ),
        (
            "thick_ring = { y0 = -0.5, y1 = 2, inner_radius = 0.25, outer_radius = 0.75",
            vec![
                ("disc", disc(-0.5, -1.0, 0.75, 0.25), "bottom", true),
                ("disc", disc(2.0, 1.0, 0.75, 0.25), "top", true),
                ("cylinder", wall(-0.5, 2.0, 0.25), "inner_wall", false),
                ("cylinder", wall(-0.5, 2.0, 0.75), "outer_wall", true),
            ],
        ),
    ];
    let other = "[[materials]]\nname = \"other\"\nrecipe.matte = { kd = 0.25, cd = 1 }\n";
    for (solid, faces) in cases {
        for with in 0..=faces.len() {
            let named = faces.get(with).map_or(String::new(), |it| format!("{} = \"other\"", it.2));
            let shape = format!("shape.{solid}, materials = {{ {named} }} }}\n{other}{SUN}");
            let parts = Parts::pov(&seen(PINHOLE, "", MATTE, &shape));
            let mut found: Vec<&str> = parts.all("");
            found.retain(|it| it.contains("interior_texture"));
            assert_eq!(found.len(), faces.len(), "faces of {solid}");
            for (index, (statement, (word, expected, name, is_out))) in
                found.iter().zip(&faces).enumerate()
            {
                let head = format!(" {word} {{ ");
                let rest = statement
                    .strip_prefix(&head)
                    .unwrap_or_else(|| panic!("no {word}: {statement}"));
                let numbers = numbers(rest);
                assert_eq!(numbers.len(), expected.len(), "numbers of {statement}");
                numbers.iter().zip(expected).for_each(|(found, expected)| near(*found, *expected));
                let material = usize::from(index == with);
                let side = if *is_out { "front" } else { "back" };
                let texture = format!(" texture {{ {side}_{material} }}");
                assert!(statement.contains(&texture), "`{texture}` of {name}: {statement}");
            }
        }
    }
}

/// Law: POV-Ray's objects cast no shadow if object or material say so. Oracle: both, crossed.
#[test]
fn objects_and_materials_without_shadows_cast_none() {
    for (by_object, by_material) in [(true, true), (true, false), (false, true), (false, false)] {
        let mut scene = ball("", MATTE, SUN);
        scene.objects[0].casts_shadows = by_object;
        scene.materials[0].casts_shadows = by_material;
        let found = Parts::pov(&scene).one("sphere").contains(" no_shadow");
        assert_eq!(
            found,
            !(by_object && by_material),
            "object {by_object}, material {by_material}"
        );
    }
}

/// Law: POV-Ray's finish has ka, kd/π, and kr · cr and ls where they are not 0; the back of a one-sided surface has no kd and does not
/// shine, but ka and the mirror. Oracle: the numbers of the recipes.
#[test]
fn sides_have_the_numbers_of_their_material() {
    let phong = "phong = { ka = 0.25, kd = 0.5, cd = 1, cs = 1, exponent = 1 }";
    for (recipe, ka, kd, mirror, ls) in [
        ("matte = { ka = 0.25, kd = 0.5, cd = 1 }".to_owned(), 0.25, 0.5, 0.0, 0.0),
        (phong.to_owned(), 0.25, 0.5, 0.0, 0.0),
        (format!("reflective = {{ {phong}, kr = 0.75, cr = 0.5 }}"), 0.25, 0.5, 0.375, 0.0),
        ("emissive = { ls = 3, ce = 1 }".to_owned(), 0.0, 0.0, 0.0, 3.0),
    ] {
        for two_sided in [false, true] {
            let mut scene = ball(WHITTED, &recipe, SUN);
            scene.materials[0].two_sided = two_sided;
            let parts = Parts::pov(&scene);
            for (side, is_dark) in [("front_0", false), ("back_0", !two_sided)] {
                let text = parts.one(&format!("#declare {side}"));
                let kd = if is_dark { 0.0 } else { kd };
                near(each(text, "ambient")[0][0], ka);
                near(each(text, "diffuse")[0][0], kd / std::f64::consts::PI);
                let reflected = each(text, "rgb").len() - 1;
                assert_eq!(
                    reflected,
                    usize::from(mirror > 0.0),
                    "mirrors of {side}, {recipe}: {text}"
                );
                if mirror > 0.0 {
                    near(each(text, "rgb")[1][0], mirror);
                }
                let emission = each(text, "emission");
                let shines = ls > 0.0 && !is_dark;
                assert_eq!(
                    emission.len(),
                    usize::from(shines),
                    "whether {side} of {recipe} shines: {text}"
                );
                if shines {
                    near(emission[0][0], ls);
                }
            }
        }
    }
}

/// Law: an error names the list, the index in it and the name of what is refused. Oracle: the scene.
#[test]
fn refusals_begin_with_their_places() {
    let lamp = "[[lights]]\nname = \"weak\"\nsource.point = { location = [0, 9, 0], ls = 1, attenuation = 1.5 }\n";
    let unnamed = "[[objects]]\nname = \"odd\"\nmaterial = \"it\"\nshape.rosette = {}\n";
    let bump = "[[materials]]\nname = \"rough\"\nrecipe.matte = { kd = 1, cd = 1 }\nbump.noise = { amount = 0.1 }\n\
                [[objects]]\nname = \"rough\"\nmaterial = \"rough\"\nshape.sphere = { center = [0, 0, 0], radius = 3 }\n";
    let all = refused(Target::Mitsuba, &ball("", MATTE, lamp));
    let expected = "lights[0] \"weak\": source.point.attenuation: found 1.5";
    assert!(all.len() == 1 && all[0].starts_with(expected), "no `{expected}` in {all:?}");
    let read = std::panic::catch_unwind(|| ball("", MATTE, &format!("{SUN}{unnamed}")));
    if let Ok(scene) = read {
        let all = refused(Target::Mitsuba, &scene);
        assert!(all.iter().all(|it| it.starts_with("objects[1] \"odd\": shape.")), "{all:?}");
    }
    if let Ok(scene) = std::panic::catch_unwind(|| ball("", MATTE, &format!("{SUN}{bump}"))) {
        for target in [Target::Mitsuba, Target::Pov] {
            let all = refused(target, &scene);
            assert!(all.iter().any(|it| it.starts_with("materials[1] \"rough\": bump")), "{all:?}");
        }
    }
}

/// Law: a term that is left out is left out everywhere, and nothing else is changed. Oracle: the scene with the term made absent by
/// hand.
#[test]
fn a_term_that_is_left_out_is_left_out_everywhere() {
    let highlight =
        |ks: f64| format!("phong = {{ cd = 1, cs = 1, exponent = 1, ks = {ks}, kd = 0 }}");
    let recipes = |ks: f64| {
        [
            highlight(ks),
            format!("reflective = {{ {}, kr = 0.5, cr = 1 }}", highlight(ks)),
            format!("glossy_reflector = {{ {}, kr = 0.5, cr = 1, exponent = 9 }}", highlight(ks)),
            format!("transparent = {{ {}, kr = 0.5, cr = 1, kt = 0.5, eta = 1.5 }}", highlight(ks)),
            format!("dielectric = {{ {}, inside = {{ eta = 1.5 }} }}", highlight(ks)),
            MATTE.to_owned(),
        ]
    };
    let plain = |scene: &Scene| groundtruth::scene::to_toml(scene).expect("plain data");
    for (with, without) in recipes(0.25).iter().zip(recipes(0.0)) {
        let mut scene = ball("", with, SUN);
        Term::Phong.remove(&mut scene);
        assert_eq!(plain(&scene), plain(&ball("", &without, SUN)), "{with} without phong");
    }
    let triangle = "triangle = { vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]";
    let smooth = |is_smooth: bool| {
        let normals = if is_smooth { ", normals = [[0, 0, 1], [0, 0, 1], [0, 1, 1]]" } else { "" };
        let triangle = format!("{triangle}{normals} }}");
        let tessellated = format!(
            "tessellated_sphere = {{ radius = 1, horizontal = 8, vertical = 5, smooth = {is_smooth} }}"
        );
        let mesh = format!(
            "mesh = {{ vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles = [[0, 1, 2]], smooth = {is_smooth} }}"
        );
        [
            mesh.clone(),
            triangle.clone(),
            tessellated.clone(),
            format!("instance = {{ of.{tessellated}, transform = [{{ rotate_x = 9 }}] }}"),
            format!(
                "compound = {{ parts = [{{ shape.{triangle} }}, {{ shape.instance = {{ of.{mesh}, transform = [{{ rotate_x = 9 }}] }} }}] }}"
            ),
        ]
    };
    for (with, without) in smooth(true).iter().zip(smooth(false)) {
        let of = |shape: &str| seen(PINHOLE, "", MATTE, &format!("shape.{shape}\n{SUN}"));
        let mut scene = of(with);
        Term::Smooth.remove(&mut scene);
        assert_eq!(plain(&scene), plain(&of(&without)), "{with} without smooth");
        assert!(!matches!(scene.objects[0].shape, Kind::Plane(_)), "it is the shape");
    }
    let sky = "[[lights]]\nname = \"sky\"\nsource.environment = {}\n";
    for (tracer, lights, is_on, is_light) in [
        ("", "", true, false),
        (WHITTED, "", true, false),
        (PATH, "", true, true),
        ("", sky, true, true),
        ("", sky, false, false),
        (PATH, sky, false, true),
    ] {
        let mut scene =
            ball(&format!("{tracer}background = 0.5\n"), MATTE, &format!("{SUN}{lights}"));
        if let Some(light) = scene.lights.get_mut(1) {
            light.enabled = is_on;
        }
        Term::Background.remove(&mut scene);
        let is_black = matches!(scene.background, Background::Color(it) if it.is_black());
        assert_eq!(
            is_black, !is_light,
            "the background is left out, `{tracer}{lights}`, on {is_on}"
        );
    }
    let water = "dielectric = { inside = { eta = 1.5, absorption = [1, 2, 3] }, outside = { eta = 1.25, absorption = [3, 2, 1] } }";
    let mut scene = ball("", water, SUN);
    Term::Absorption.remove(&mut scene);
    let materials::Kind::Dielectric(it) = &scene.materials[0].recipe else {
        panic!("a dielectric")
    };
    let clear = [it.inside.absorption, it.outside.absorption, scene.camera.medium.absorption];
    assert!(clear.iter().all(|it| it.is_black()), "absorptions that are left: {clear:?}");
    assert_eq!([it.inside.eta, it.outside.eta], [1.5, 1.25], "the indices of refraction");
}
