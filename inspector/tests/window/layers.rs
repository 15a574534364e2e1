//! Layers in place of the picture.

use std::sync::Arc;

use egui_kittest::kittest::Queryable;
use groundtruth::film::Tone;
use layers::{Colors, Layer};

use crate::support::*;

/// Law: where a layer is chosen, the screen has its colours, the legend its names, the status its value under the mouse,
/// and a click explains the pixel as before. Oracle: the layer from the library, one pixel at a time.
#[test]
fn a_chosen_layer_is_shown() {
    let scene = small_glass_sphere();
    let mut window = glass_window();
    let world = built(&scene);
    let before = shown(&mut window, [40, 45]);
    choose(&mut window, "Layer", "object");
    let layer = Layer::named("object", &world).expect("a layer");
    let colors = Colors::of(&layer, std::iter::empty(), &world, Tone::PLAIN);
    let mut names = Vec::new();
    for pixel in [[24, 24], [33, 22], [10, 44], [40, 45], [3, 3]] {
        let value = layer.value(&world, pixel);
        assert_eq!(shown(&mut window, pixel), colors.color(value), "{pixel:?}");
        let at = on_screen(&window, pixel);
        hover(&mut window, at);
        let words = value.map_or("none".to_owned(), |value| layer.in_words(value, &world));
        let status = text_with(&window, &format!("({}, {})  ", pixel[0], pixel[1]));
        assert!(status.ends_with(&format!("object {words}")), "{status}");
        names.extend(value.map(|_| words));
    }
    names.sort();
    names.dedup();
    assert!(names.len() > 1, "{names:?}");
    for name in &names {
        assert!(window.query_all_by_label(name).count() > 0, "the legend has no {name}");
    }
    click(&mut window, [24, 24]);
    assert_eq!(window.state().selection.pixel, Some([24, 24]));
    assert!(window.query_all_by_label_contains(&root_line(&scene, [24, 24])).count() > 0);

    choose(&mut window, "Layer", "picture");
    assert_eq!(shown(&mut window, [40, 45]), before);
}

/// Law: *Save* writes the layer that is shown, under a name with that of scene and layer: its colours as PNG, its values in
/// named channels as EXR. A typed name stays. Oracle: the colours of the library, and the channels' names in the file.
#[test]
fn a_shown_layer_is_saved() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let world = built(&small_glass_sphere());
    let mut window = glass_window();
    choose(&mut window, "Layer", "object");
    assert_eq!(window.state().fields.save, "glass-sphere-object.png");
    let png = folder.path().join("object.png");
    type_into(&mut window, "Picture", png.to_str().expect("UTF-8"));
    let layer = Layer::named("object", &world).expect("a layer");
    let colors = Colors::of(&layer, std::iter::empty(), &world, Tone::PLAIN);
    let image = image::open(&png).expect("a picture").to_rgb8();
    for (x, y, color) in image.enumerate_pixels() {
        assert_eq!(color.0, colors.color(layer.value(&world, [x, y])), "({x}, {y})");
    }
    choose(&mut window, "Layer", "normal");
    assert_eq!(window.state().fields.save, png.display().to_string(), "typed");
    let exr = folder.path().join("normal.exr");
    type_into(&mut window, "Picture", exr.to_str().expect("UTF-8"));
    let bytes = std::fs::read(&exr).expect("written");
    for channel in ["N.X", "N.Y", "N.Z"] {
        assert!(bytes.windows(3).any(|part| part == channel.as_bytes()), "{channel}");
    }
    let pfm = folder.path().join("normal.pfm");
    type_into(&mut window, "Picture", pfm.to_str().expect("UTF-8"));
    assert!(window.state().message.as_ref().is_some_and(|(_, is_error)| *is_error));
    assert!(!pfm.exists());
}

/// Law: the work for a layer ends when another is chosen. Oracle: the references to the world, of which the work has one.
#[test]
fn a_layer_that_is_left_is_not_found_further() {
    let mut scene = small_glass_sphere();
    scene.image.samples = 1;
    let window = open(scene.clone());
    // hours
    scene.image.resize(2000, 2000);
    scene.image.samples = 1024;
    let count = |window: &Window| Arc::strong_count(&window.state().session.rendering.world);
    let mut slow = begin(scene, [1280.0, 800.0]);
    slow.run_steps(3);
    slow.state_mut().session.rendering.canvas.cancel();
    let idle = count(&window);
    let wait_for_idle =
        |slow: &mut Window| wait_until(slow, "the work ends", |window| count(window) == idle);
    wait_for_idle(&mut slow);
    let rays = Layer::named("rays", &slow.state().session.rendering.world).expect("a layer");
    slow.state_mut().picture.layer.chosen = Some(rays);
    slow.run_steps(2);
    assert!(count(&slow) > idle, "it is being found");
    slow.state_mut().picture.layer.chosen = None;
    wait_for_idle(&mut slow);
}

/// Law: values are written into pixels of 64 points and more, and not into smaller ones, for the picture and for a layer.
/// Oracle: a pixel of one colour has none but that on the screen, unless something is written there.
#[test]
fn large_pixels_have_their_values_as_text() {
    let mut window = glass_window();
    let size = window.state().session.rendering.size();
    for layer in ["picture", "distance"] {
        choose(&mut window, "Layer", layer);
        for (zoom, is_written) in [(60.0, false), (64.0, true)] {
            set(&mut window, |it| it.picture.set_zoom(size, zoom, None));
            let pixel = [24, 24];
            window.state_mut().picture.reveal(size, pixel);
            window.run_steps(2);
            let at = window.state().picture.placement(size).rect(pixel).shrink(6.0);
            let image = window.render().expect("drawn");
            let rows = at.min.y as u32..at.max.y as u32;
            let colors = rows.flat_map(|y| (at.min.x as u32..at.max.x as u32).map(move |x| [x, y]));
            let mut colors: Vec<_> = colors.map(|[x, y]| image.get_pixel(x, y).0).collect();
            colors.sort_unstable();
            colors.dedup();
            assert_eq!(colors.len() > 1, is_written, "{layer} at {zoom}: {} colours", colors.len());
        }
    }
}
