//! Selecting a pixel: its tree, its sum, its samples.

use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use explain::RecordedRay;
use groundtruth::cameras::{Stereo, Viewing};
use groundtruth::render;
use groundtruth::rgb::Rgb;

use crate::support::*;

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
