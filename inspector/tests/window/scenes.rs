//! Opening scenes, switching lights and objects, saving; and the window never waits.

use std::path::PathBuf;

use egui_kittest::kittest::Queryable;
use groundtruth::film::read_exr;
use inspector::picture::worker::Progress;
use inspector::platform::Purpose;
use inspector::scene::source::Source;

use crate::support::*;

const ON_GROUND: [u32; 2] = [30, 44];

/// Law: a light that is switched off sends no shadow rays and changes the picture; switched on
/// again, the picture is the old one, bit for bit.
#[test]
fn a_light_switched_off_leaves_picture_and_tree() {
    let mut window = glass_window_at(ON_GROUND);
    let before = film(&window);
    let to_lamp =
        |window: &Window| window.query_all_by_label_contains("shadow ray to \"high lamp\"").count();
    assert!(to_lamp(&window) > 0, "the pixel must see the lamp for the test to mean anything");

    push(&mut window, "high lamp");
    assert_eq!(to_lamp(&window), 0);
    assert!(window.query_all_by_label_contains("shadow ray to \"front lamp\"").count() > 0);
    assert!(film(&window) != before);
    assert_eq!(window.state().selection.pixel, Some(ON_GROUND));
    assert!(window.query_by_label("= the pixel of the picture, bit for bit").is_some());
    let mut scene = small_glass_sphere();
    let lamp = scene.lights.iter_mut().find(|light| light.name == "high lamp");
    lamp.expect("the scene has it").enabled = false;
    assert!(film(&window) == rendered(&scene));

    push(&mut window, "high lamp");
    assert!(film(&window) == before);
    assert!(to_lamp(&window) > 0);
}

/// Law: "only" leaves one object, "all on" brings back the others.
#[test]
fn only_this_object_is_left_and_all_come_back() {
    let mut window = glass_window();
    let before = film(&window);
    // four lights, then the glass sphere, the red sphere and the ground
    window.get_all_by_label("only").nth(5).expect("a button for each").click();
    settle(&mut window);
    let enabled = |window: &Window| -> Vec<bool> {
        window.state().session.rendering.scene.objects.iter().map(|object| object.enabled).collect()
    };
    assert_eq!(enabled(&window), [false, true, false]);
    let objects = window.state().session.rendering.world.objects();
    assert_eq!(objects.iter().map(|object| &*object.name).collect::<Vec<_>>(), ["red sphere"]);
    push(&mut window, "all on");
    assert_eq!(enabled(&window), [true, true, true]);
    assert!(film(&window) == before);
}

/// Law: the saved EXR holds the picture in single precision, whatever the exposure on the screen;
/// a name without a known format is an error in the window.
#[test]
fn the_picture_is_saved_and_errors_are_shown() {
    let mut window = glass_window();
    window.state_mut().picture.tone.exposure = 4.0;
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("saved.exr");
    type_into(&mut window, "Picture", &path.display().to_string());
    assert!(window.query_by_label(&format!("saved {}", path.display())).is_some());
    let saved = read_exr(&path).expect("a picture");
    let expected = film(&window);
    assert!(saved.to_f32().eq(expected.to_f32()));

    let path = folder.path().join("saved.bmp");
    type_into(&mut window, "Picture", &path.display().to_string());
    let error = format!(
        "{}: unknown picture format; end the name with .png, .ppm, .exr or .pfm",
        path.display()
    );
    assert!(window.query_by_label(&error).is_some());
    assert!(!path.exists());
}

/// What *Save* writes under this name.
fn saved(window: &mut Window, name: &str) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(name);
    type_into(window, "Picture", &path.display().to_string());
    String::from_utf8_lossy(&std::fs::read(&path).expect("it is saved")).into_owned()
}

/// Law: a saved picture names its scene, and one in which a light was switched off is no longer that of the gallery.
/// Oracle: the file's text.
#[test]
fn a_saved_picture_says_how_it_was_made() {
    let mut window = glass_window();
    let usual = saved(&mut window, "usual.png");
    let [width, height] = window.state().session.rendering.size();
    for text in ["Scene\0ch28/glass-sphere", &format!("Size\0{width}x{height}"), "Samples\0"] {
        assert!(usual.contains(text), "{text:?}");
    }
    push(&mut window, "high lamp");
    let dark = saved(&mut window, "dark.png");
    assert!(!dark.contains("ch28/glass-sphere") && dark.contains("Scene\0sha256:"));
}

/// Law: as a part of another page the window has scene, picture and explanation, without bars; clicks explain. Oracle: the
/// labels of the bars; the same pixel in a whole window.
#[test]
fn an_embedded_window_has_no_bars() {
    let [mut whole, mut embedded] = [glass_window(), glass_window()];
    embedded.state_mut().is_embedded = true;
    for window in [&mut whole, &mut embedded] {
        settle(window);
        click(window, ON_GROUND);
    }
    for (part, of_bars) in [("Save", true), ("Open", true), ("Whole", true), ("high lamp", false)] {
        assert!(whole.query_by_label(part).is_some(), "{part}");
        assert_eq!(embedded.query_by_label(part).is_none(), of_bars, "{part}");
    }
    let root = root_line(&small_glass_sphere(), ON_GROUND);
    assert!(embedded.query_all_by_label_contains(&root).count() > 0, "{root}");
}

/// Law: a file that is chosen in the desktop's chooser is opened, or the picture is saved there, and its field names it;
/// a chooser that is closed without a choice changes nothing. Oracle: the library's scene and picture.
#[test]
fn a_chosen_file_is_opened_or_saved() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let [scene_file, picture_file] =
        ["small.toml", "saved.exr"].map(|name| folder.path().join(name));
    let mut scene = small_glass_sphere();
    scene.image.resize(20, 10);
    write(&scene_file, &scene);
    let mut window = glass_window();
    let ctx = window.ctx.clone();
    let choose = |window: &mut Window, purpose: Purpose, file: Option<PathBuf>| {
        window.state_mut().chooser.wait_for(&ctx, purpose, |chosen| chosen(file));
        settle(window);
    };
    choose(&mut window, Purpose::Scene, None);
    // a desktop without a chooser looks the same as one whose user closes it
    text_with(&window, "no file chosen");
    text_with(&window, "the path can be typed");
    assert_eq!(window.state().session.rendering.source.name(), "ch28/glass-sphere");
    choose(&mut window, Purpose::Scene, Some(scene_file.clone()));
    assert_eq!(window.state().session.rendering.size(), [20, 10]);
    assert_eq!(window.state().fields.open, scene_file.display().to_string());
    choose(&mut window, Purpose::Picture, Some(picture_file.clone()));
    let saved = read_exr(&picture_file).expect("a picture");
    assert!(saved.to_f32().eq(film(&window).to_f32()));
    assert_eq!(window.state().fields.save, picture_file.display().to_string());
}

/// Law: a picture that is shown in another way than the scene says, and saved so, says how; not if it is shown as the scene
/// says, nor as radiance. Oracle: the text.
#[test]
fn a_saved_picture_says_another_exposure() {
    let mut window = glass_window();
    assert!(!saved(&mut window, "plain.png").contains("Tone\0"));
    set(&mut window, |it| it.picture.tone.exposure = 2.0);
    let said = "tEXtTone\0exposure 2, gamma 1, max_to_one";
    assert!(saved(&mut window, "brighter.png").contains(said));
    assert!(!saved(&mut window, "brighter.exr").contains("Tone\0"));
}

/// Law: a picture that is saved under a relative name is reported with the whole path. Oracle: the present folder.
#[test]
fn a_saved_picture_is_named_with_its_folder() {
    let here = std::env::current_dir().expect("a present folder");
    let folder = tempfile::tempdir_in(&here).expect("a temporary folder");
    let name = folder.path().file_name().expect("a name").to_string_lossy().into_owned();
    let mut window = glass_window();
    type_into(&mut window, "Picture", &format!("{name}/saved.png"));
    let whole = here.join(name).join("saved.png");
    assert!(whole.exists());
    assert!(window.query_by_label(&format!("saved {}", whole.display())).is_some());
}

/// Law: a frame returns although the picture is far from finished; a pixel is explained meanwhile;
/// another scene stops the old picture.
#[test]
fn the_window_does_not_wait_for_the_picture() {
    let mut scene = small_glass_sphere();
    scene.image.resize(600, 600);
    // hours of work
    scene.image.samples = 10_000;
    let mut window = begin(scene.clone(), [1280.0, 800.0]);
    let running = |window: &Window| match window.state().session.rendering.progress() {
        Progress::Running(part, _) => part < 0.5,
        _ => false,
    };
    window.run_steps(5);
    assert!(running(&window));
    let old = window.state().session.rendering.canvas.clone();

    // 10 000 samples take a while also for one pixel, but not for the window
    let at = on_screen(&window, [200, 240]);
    point_and_press(&mut window, at);
    window.step();
    assert_eq!(window.state().selection.pixel, Some([200, 240]));
    let is_explained = |window: &Window| window.state().selection.explanation().is_some();
    wait_until(&mut window, "it is explained", is_explained);
    assert!(running(&window) && !old.is_cancelled());
    let line = root_line_of(&scene, [200, 240], 0);
    window.run_steps(2);
    assert!(window.query_all_by_label(&line).next().is_some());

    let ctx = window.ctx.clone();
    let small = gallery::find("ch03/single-sphere");
    let small = small.or_else(|| gallery::scenes().next()).expect("a scene");
    set(&mut window, |it| it.session.open(&ctx, Source::Gallery(small)));
    assert!(old.is_cancelled());
    assert_eq!(window.state().session.rendering.source.name(), small.name);
}
