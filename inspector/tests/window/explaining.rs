//! Selecting a pixel: its tree, its sum, its samples.

use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use groundtruth::cameras::{Stereo, Viewing};
use groundtruth::explain::{self, RecordedRay};
use groundtruth::render;
use groundtruth::rgb::Rgb;
use groundtruth::trace::RayKind;

use crate::support::*;

/// A pixel in which both spheres are seen.
const ON_GLASS: [u32; 2] = [17, 19];

/// Law: after a click on a pixel of the glass sphere the tree begins with the camera's ray of that
/// pixel. Oracle: the library's explanation of the same pixel of a world built anew.
#[test]
fn a_click_on_the_glass_sphere_shows_its_tree() {
    let mut window = glass_window();
    assert!(window.query_by_label_contains("hits \"glass sphere\"").is_none());
    click(&mut window, ON_GLASS);
    let scene = small_glass_sphere();
    let ray = ray_of(&scene, ON_GLASS, 0);
    assert!(ray.line().starts_with("0  camera"));
    assert!(ray.line().contains("hits \"glass sphere\""));
    // in the tree and above the details
    assert_eq!(window.get_all_by_label(&ray.line()).count(), 2);
    assert!(window.query_by_label("Pixel (17, 19)").is_some());
    let ray_count = ray.count();
    assert!(
        ray_count > 5 && text_with(&window, " rays, at ").starts_with(&format!("{ray_count} "))
    );
    for child in &ray.children {
        assert!(window.query_all_by_label(&child.line()).next().is_some(), "{}", child.line());
    }
}

/// The printed sum of the pixel's samples.
fn sum(window: &Window) -> String {
    let labels = window.query_all_by_label_contains("= ");
    let mut texts = labels.map(|label| text_of(&label.accesskit_node()));
    texts.find(|text| text.starts_with("= ") && !text.contains("pixel")).expect("a sum")
}

/// The channels of a colour as the window shows them: one number if they are equal.
fn shown_sum(color: Rgb) -> String {
    text::digits::shortened(&match color.to_array() {
        [r, g, b] if [g, b] == [r, r] => format!("= {r:?}"),
        [r, g, b] => format!("= ({r:?}, {g:?}, {b:?})"),
    })
}

/// Law: the explained pixel is the rendered one, bit for bit, and printed with four digits, on the sphere, on its rim, on the
/// ground and on the background, and the window says that it equals the picture. Oracle: the pixel
/// rendered without a recorder.
#[test]
fn the_printed_sum_is_the_rendered_pixel_bit_for_bit() {
    let mut window = glass_window();
    let world = built(&small_glass_sphere());
    for pixel in [ON_GLASS, [7, 20], [30, 44], [2, 2], [0, 0], [47, 47]] {
        click(&mut window, pixel);
        let bits = |color: Rgb| color.to_array().map(f64::to_bits);
        let rendered = render::pixel(&world, pixel);
        assert_eq!(sum(&window), shown_sum(rendered), "{pixel:?}");
        let explained = window.state().selection.explanation().expect("explained").radiance;
        assert_eq!(bits(explained), bits(rendered), "{pixel:?}");
        assert!(window.query_by_label("= the pixel of the picture, bit for bit").is_some());
    }
}

/// Law: where the picture has another colour, the window says that it differs. (Otherwise "bit for bit"
/// could be a constant text.)
#[test]
fn a_pixel_that_differs_from_its_explanation_is_reported() {
    let mut window = glass_window_at(ON_GLASS);
    // replaces the picture by one of another seed, without the window's knowledge
    let scene = small_glass_sphere();
    let other = groundtruth::world::World::build_seeded(&scene, std::path::Path::new(""), 2);
    let other = other.expect("the scene is valid");
    let canvas = groundtruth::render::Canvas::new(&other);
    canvas.render(&other);
    set(&mut window, |it| it.session.rendering.canvas = std::sync::Arc::new(canvas));
    assert!(text_with(&window, "differs from the pixel of the picture").contains("(0."));
}

/// Law: typed coordinates select a pixel; invalid ones are refused with a reason, and the selection stays.
#[test]
fn typed_coordinates_select_a_pixel() {
    let mut window = glass_window();
    type_into(&mut window, "Pixel", "30, 44");
    assert_eq!(window.state().selection.pixel, Some([30, 44]));
    assert!(window.query_by_label("Pixel (30, 44)").is_some());
    assert!(
        window.query_all_by_label(&root_line(&small_glass_sphere(), [30, 44])).next().is_some()
    );

    type_into(&mut window, "Pixel", "48, 3");
    let error = "pixel (48, 3) is outside the picture of 48 × 48";
    assert!(window.query_by_label(error).is_some());
    type_into(&mut window, "Pixel", "left");
    let error = "`left` is no pixel; write column and row as 200,150";
    assert!(window.query_by_label(error).is_some());
    assert_eq!(window.state().selection.pixel, Some([30, 44]));
}

/// Law: an arrow key moves by one pixel in its direction, with shift by ten, and stops at the edge;
/// the explanation follows.
#[test]
fn arrow_keys_step_to_the_next_pixel() {
    let mut window = glass_window_at(ON_GLASS);
    let mut at = ON_GLASS;
    for (key, [dx, dy]) in [
        (Key::ArrowRight, [1, 0]),
        (Key::ArrowDown, [0, 1]),
        (Key::ArrowDown, [0, 1]),
        (Key::ArrowLeft, [-1, 0]),
        (Key::ArrowUp, [0, -1]),
    ] {
        press(&mut window, key);
        at = [at[0].saturating_add_signed(dx), at[1].saturating_add_signed(dy)];
        assert_eq!(window.state().selection.pixel, Some(at), "{key:?}");
        let explained = window.state().selection.explanation().expect("explained").pixel;
        assert_eq!(explained, at);
    }
    for _ in 0..6 {
        window.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    }
    settle(&mut window);
    assert_eq!(window.state().selection.pixel, Some([0, at[1]]));
}

/// Law: while coordinates are typed, the arrow keys do not change the selection.
#[test]
fn arrow_keys_in_a_field_do_not_step() {
    let mut window = glass_window_at(ON_GLASS);
    window.get_by_role_and_label(eframe::egui::accesskit::Role::TextInput, "Pixel").focus();
    window.step();
    press(&mut window, Key::ArrowLeft);
    assert_eq!(window.state().selection.pixel, Some(ON_GLASS));
}

/// Law: the chosen sample's tree is shown, and its index cannot leave the pixel's samples. Oracle:
/// the library's explanation of that sample.
#[test]
fn the_sample_chooser_changes_the_tree() {
    let mut window = glass_window();
    // the rim of the sphere, where samples differ
    let pixel = [7, 20];
    click(&mut window, pixel);
    let scene = small_glass_sphere();
    for index in 1..4 {
        push(&mut window, ">");
        let line = root_line_of(&scene, pixel, index);
        assert_eq!(window.get_all_by_label(&line).count(), 2, "sample {index}");
    }
    push(&mut window, ">");
    assert_eq!(window.state().selection.sample, 3);
    assert!(window.query_by_label("Sample 3").is_some());
}

/// Law: a pixel of very many rays is explained one sample at a time, and its sum is still the pixel.
#[test]
fn many_samples_are_explained_one_at_a_time() {
    let mut scene = small_glass_sphere();
    scene.image.resize(6, 6);
    scene.image.samples = 3600;
    let world = built(&scene);
    let mut window = open(scene);
    click(&mut window, [2, 2]);
    let explanation = window.state().selection.explanation().expect("explained");
    assert_eq!((explanation.samples.len(), explanation.samples_per_pixel), (1, 3600));
    assert_eq!(sum(&window), shown_sum(render::pixel(&world, [2, 2])));
    assert_eq!(explanation.radiance, render::pixel(&world, [2, 2]));
    push(&mut window, ">");
    let explanation = window.state().selection.explanation().expect("explained");
    assert_eq!(explanation.samples[0].index, 1);
}

/// Law: a click on a line of the tree shows that ray's numbers, all of them.
/// Oracle: the library's explanation.
#[test]
fn a_click_on_a_ray_shows_its_details() {
    let mut window = glass_window_at(ON_GLASS);
    let scene = small_glass_sphere();
    let root = ray_of(&scene, ON_GLASS, 0);
    let transmitted = |ray: &&RecordedRay| matches!(ray.kind, RayKind::Transmitted);
    let ray = root.children.iter().find(transmitted).expect("it is glass");
    push(&mut window, &ray.line());
    let hit = ray.hit.as_ref().expect("it leaves the sphere");
    let critical = hit.optics.and_then(|optics| optics.critical_angle).expect("from within");
    let exact = |[x, y, z]: [f64; 3]| format!("({x:?}, {y:?}, {z:?})");
    let color = |color: Rgb| match color.to_array() {
        [r, g, b] if [g, b] == [r, r] => format!("{r:?}"),
        channels => exact(channels),
    };
    let expected = [
        ("kind", "transmitted, depth 1".to_owned()),
        ("outcome", "hit".to_owned()),
        ("origin", exact(ray.ray.origin.into())),
        ("direction", exact(ray.ray.direction.into())),
        ("hits", "\"glass sphere\", material \"glass sphere\"".to_owned()),
        ("side", "back".to_owned()),
        ("t", format!("{:?}", hit.t)),
        ("point", exact(hit.point.into())),
        ("error at most", format!("{:?}", hit.error)),
        ("normal", exact(hit.normal.into())),
        ("shading normal", "the normal".to_owned()),
        ("angle of incidence", format!("{:?}°", hit.angle_of_incidence)),
        ("medium in front", "η 1.5, absorption 0".to_owned()),
        ("medium behind", "η 1, absorption 0".to_owned()),
        ("critical angle", format!("{critical:?}°")),
        ("weight", color(ray.weight)),
        ("transmittance", color(ray.transmittance)),
        ("radiance", color(ray.radiance)),
        ("contributes", color(ray.contribution)),
    ];
    for (name, text) in expected {
        // four digits on the screen
        let text = text::digits::shortened(&text);
        let height = |rect: eframe::egui::Rect| rect.center().y;
        let mut names = window.query_all_by_label(name);
        let values: Vec<f32> =
            window.query_all_by_label(&text).map(|value| height(value.rect())).collect();
        let beside = |at: f32| values.iter().any(|value| (value - at).abs() < 3.0);
        assert!(names.any(|label| beside(height(label.rect()))), "{name}: {text}");
    }
    for term in &ray.terms {
        let [name, factors] = [term.name(), term.factors()];
        assert!(window.query_all_by_label(&name).next().is_some(), "{name}");
        assert!(window.query_all_by_label(&factors).next().is_some(), "{factors}");
    }
}

/// Law: an arrow key keeps the ray: of the next pixel the one is selected to which the same kinds of rays lead; where there is
/// none, the camera's. Oracle: the kinds on both paths of the library's trees.
#[test]
fn an_arrow_key_keeps_the_ray() {
    let mut window = glass_window_at(ON_GLASS);
    let next = [ON_GLASS[0] + 1, ON_GLASS[1]];
    let [here, there] = [ON_GLASS, next].map(|pixel| ray_of(&small_glass_sphere(), pixel, 0));
    let kinds = |root: &RecordedRay, number: usize| {
        root.path_to(number).iter().map(|ray| (ray.kind, ray.light.clone())).collect::<Vec<_>>()
    };
    let deep = here.rays().into_iter().filter(|ray| ray.depth == 2).map(|ray| ray.number);
    for number in deep.collect::<Vec<_>>() {
        set(&mut window, |it| it.selection.tree.go_to(&here, number));
        press(&mut window, Key::ArrowRight);
        assert_eq!(window.state().selection.pixel, Some(next));
        let (found, wanted) = (window.state().selection.tree.ray, kinds(&here, number));
        let has_it = there.rays().iter().any(|ray| kinds(&there, ray.number) == wanted);
        assert_eq!(kinds(&there, found), if has_it { wanted } else { kinds(&there, 0) });
        press(&mut window, Key::ArrowLeft);
    }
}

/// Law: lights that add nothing are one line until it is clicked, and then stand with their reasons, each reason once; a hit
/// from within says so in the tree, and total reflection, too. Oracle: the library's lines; the side and the angle of the hits.
#[test]
fn what_adds_nothing_is_folded() {
    let mut window = glass_window_at(ON_GLASS);
    let root = ray_of(&small_glass_sphere(), ON_GLASS, 0);
    let reasons = explain::lines(&root.unlit);
    assert!(root.unlit.len() > 1 && reasons.len() > 1, "{reasons:?}");
    let shown =
        |window: &Window| reasons.iter().filter(|it| window.query_by_label(it).is_some()).count();
    assert_eq!(shown(&window), 0);
    push(&mut window, &format!("{} lights add nothing", root.unlit.len()));
    assert_eq!(shown(&window), reasons.len());

    let behind = |ray: &&RecordedRay| ray.hit.as_ref().is_some_and(|hit| !hit.front);
    let inside = root.children.iter().find(behind).expect("it leaves the sphere");
    let row = window.get_by_label(&inside.line()).rect();
    let notes: Vec<_> = window.query_all_by_label_contains("inside").map(|it| it.rect()).collect();
    assert!(notes.iter().any(|it| (it.center().y - row.center().y).abs() < 2.0), "{notes:?}");
    let mut window = open(small("ch27/mirror-ring", [48, 48], 1));
    let at_rim = (0..48).map(|x| [x, 28]).find(|&pixel| {
        let root = ray_of(&small("ch27/mirror-ring", [48, 48], 1), pixel, 0);
        let optics = root.hit.as_ref().and_then(|hit| hit.optics.as_ref());
        optics.is_some_and(|optics| optics.angle_of_refraction.is_none())
    });
    click(&mut window, at_rim.expect("the ring"));
    text_with(&window, "total reflection");
}

/// Law: the numbers of a ray include the texture at its hit: field, colour, texel and coordinates.
/// Oracle: the library's explanation.
#[test]
fn the_texture_of_a_hit_is_among_the_numbers() {
    let scene = small("ch29/earth", [48, 48], 1);
    let mut window = open(scene.clone());
    click(&mut window, [24, 24]);
    let root = ray_of(&scene, [24, 24], 0);
    let hit = root.hit.as_ref().expect("the middle of the globe");
    let [texture] = &hit.textures[..] else { panic!("one texture, not {:?}", hit.textures) };
    let texel = texture.texel.expect("of an image");
    let ([r, g, b], [u, v]) = (texture.color.to_array(), texel.uv);
    let expected = format!(
        "cd ({r:?}, {g:?}, {b:?}), texel ({}, {}) at u {u:?}, v {v:?}",
        texel.column, texel.row
    );
    let expected = text::digits::shortened(&expected);
    assert!(window.query_all_by_label(&expected).next().is_some(), "not shown: {expected}");
}

/// Law: the hits on the path to a ray are marked where the camera sees them. The hit of the camera's ray is
/// at the position of its sample in the pixel, up to rounding. Oracle: the sample's position on the film.
#[test]
fn the_path_to_a_ray_is_marked_in_the_picture() {
    let mut window = glass_window_at(ON_GLASS);
    let scene = small_glass_sphere();
    let world = built(&scene);
    let root = ray_of(&scene, ON_GLASS, 0);
    let with_hit = root.children.iter().find(|child| child.hit.is_some());
    let number = with_hit.expect("glass sends on rays that hit").number;
    set(&mut window, |it| it.selection.tree.go_to(&root, number));
    let trail = window.state().selection.trail(&window.state().session.rendering.world);
    assert_eq!(trail.len(), 2);
    let film = render::camera_sample(&world, ON_GLASS, 0).expect("no gap").film;
    let expected = render::image_point(&world.image, film);
    let [x, y] = trail[0].0.expect("the camera sees what it hit");
    let off = (x - expected[0]).abs().max((y - expected[1]).abs());
    // positions up to 48 pixels, from points with a relative error of about 1e-14
    assert!(off < 1e-9, "{off:e}");
    assert_eq!([x as u32, y as u32], ON_GLASS);
}

/// Law: in a stereo pair, the hit is marked in the image of the eye whose ray was selected. Oracle: the
/// pixel that was clicked.
#[test]
fn each_eye_marks_its_own_hits() {
    let mut scene = small_glass_sphere();
    scene.camera.stereo = Some(Stereo { viewing: Viewing::Parallel, gap: 4, separation: 3.0 });
    let in_the_right_image = [scene.image.width + 4 + ON_GLASS[0], ON_GLASS[1]];
    let mut window = open(scene);
    for pixel in [ON_GLASS, in_the_right_image] {
        click(&mut window, pixel);
        let trail = window.state().selection.trail(&window.state().session.rendering.world);
        let [x, y] = trail[0].0.expect("the eye sees what it hit");
        assert_eq!([x as u32, y as u32], pixel);
    }
}
