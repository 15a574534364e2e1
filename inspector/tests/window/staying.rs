//! What is preserved: the selection while files change, existing files, and settings.

use std::collections::HashMap;
use std::path::Path;
use std::time::Duration;

use clap::Parser;
use eframe::egui::{Context, Key, Modifiers, accesskit::Role, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use groundtruth::world::World;
use inspector::app::Inspector;
use inspector::scene::source::Source;
use inspector::window::arguments::Arguments;
use inspector::window::stored_settings::StoredSettings;
use inspector::window::style::{Ground, growth};

use crate::support::*;

/// Waits until a changed file is read, and until it is shown.
fn followed(window: &mut Window, is_so: impl Fn(&Window) -> bool) {
    wait_until(window, "the file is followed", is_so);
    settle(window);
}

/// Law: a scene file that is changed on the disk is read again automatically; the selected pixel and the
/// changes made in the window stay. Oracle: the library's rendering of the new file with those changes.
#[test]
fn a_changed_file_is_read_again_and_the_selection_stays() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    let mut scene = small_glass_sphere();
    write(&path, &scene);
    let mut window = window_on(&path);
    click(&mut window, ON_GLASS);
    window.get_by_label("high lamp").click();
    type_number(&mut window, "Samples", "9");
    set(&mut window, |it| {
        it.session.wanted = eta("1.2").applied(&it.session.wanted).expect("a field");
        it.session.rebuild(&Context::default());
    });

    scene.about = "told anew".to_owned();
    scene.background = groundtruth::rgb::Rgb::new(0.1, 0.2, 0.3).into();
    write(&path, &scene);
    followed(&mut window, |window| window.state().session.rendering.scene.about == "told anew");
    assert_eq!(window.state().selection.pixel, Some(ON_GLASS));
    scene.image.samples = 9;
    scene.lights.iter_mut().filter(|l| l.name == "high lamp").for_each(|l| l.enabled = false);
    let scene = eta("1.2").applied(&scene).expect("a field");
    assert_eq!(film(&window).pixels(), rendered(&scene).pixels());
    assert_eq!(window.state().message, None);
}

/// Law: if the file becomes invalid, the picture stays, marked as that of before, and the library's error is shown; once the
/// file is repaired, it is read again, and error and mark disappear.
#[test]
fn a_broken_file_keeps_the_picture_until_it_is_mended() {
    const MARK: &str = "the picture of before: the scene file has an error";
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    let mut scene = small_glass_sphere();
    write(&path, &scene);
    let mut window = window_on(&path);
    let before = film(&window);
    assert!(window.query_by_label(MARK).is_none());
    std::fs::write(&path, "about = \n").expect("writable");
    let error = scenefile::read(&path).expect_err("it is broken").to_string();
    followed(&mut window, |window| window.state().message.is_some());
    assert_eq!(window.state().message, Some((error, true)));
    assert_eq!(film(&window), before);
    push_button(&mut window, "×");
    assert!(window.query_by_label(MARK).is_some(), "the message is gone, the mark stays");
    scene.about = "mended".to_owned();
    write(&path, &scene);
    followed(&mut window, |window| window.state().session.rendering.scene.about == "mended");
    assert_eq!(window.state().message, None);
    assert!(window.query_by_label(MARK).is_none());
}

/// Law: a broken file of the command line is shown with its error and without a picture; mended, it is opened as the
/// arguments say, and their pixel is explained. Files that are good, or that do not exist, are none. Oracle: the
/// library's error, and its rendering with the same settings.
#[test]
fn a_broken_file_of_the_command_line_is_waited_for() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("mine.toml");
    let file = path.to_str().expect("UTF-8");
    let line = ["inspector", file, "--size", "30x20", "--samples", "9", "--seed", "5"];
    let line = [&line[..], &["--pixel", "12,9", "--sample", "3"]].concat();
    let arguments = Arguments::parse_from(line);
    assert!(arguments.broken(None).is_none(), "there is no such file");
    std::fs::write(&path, "image = { width = 3 }\n").expect("writable");
    let broken = arguments.broken(None).expect("it is broken");
    let mut window =
        window_of(Inspector::waiting_for(&Context::default(), broken), [1280.0, 800.0]);
    settle(&mut window);
    let error = scenefile::read(&path).expect_err("it is broken").to_string();
    assert!(window.query_by_label(&error).is_some());
    assert!(window.query_by_label("picture").is_none());

    let mut scene = small_glass_sphere();
    write(&path, &scene);
    followed(&mut window, |window| window.query_by_label("picture").is_some());
    assert_eq!(window.state().message, None);
    scene.image.resize(30, 20);
    scene.image.samples = 9;
    let world = World::build_seeded(&scene, folder.path(), 5).expect("the scene is valid");
    let film = film(&window);
    assert_eq!(film.pixels(), groundtruth::render::render(&world).pixels());
    assert!(window.query_by_label("Pixel (12, 9)").is_some());
    assert_eq!(window.state().selection.sample, 3);
    assert!(arguments.broken(None).is_none(), "it is good");

    // from now on changes in the window count
    type_number(&mut window, "Samples", "16");
    scene.about = "changed again".to_owned();
    write(&path, &scene);
    followed(&mut window, |window| window.state().session.rendering.scene.about == "changed again");
    assert_eq!(window.state().session.rendering.scene.image.samples, 16);
}

/// Law: a mesh file that a scene names is watched as well.
#[test]
fn a_changed_mesh_file_is_read_again() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let [scene, mesh] = ["knot.toml", "knot.ply"].map(|file| {
        std::fs::copy(scenes.join(file), folder.path().join(file)).expect("copied");
        folder.path().join(file)
    });
    let loaded = Source::File(scene).load().expect("the scene is valid");
    let mut watch = loaded.watch.expect("it was read from files");
    assert!(!watch.changed());
    let mut text = std::fs::read(&mesh).expect("readable");
    text.push(b'\n');
    std::fs::write(&mesh, text).expect("writable");
    std::thread::sleep(inspector::scene::watch::INTERVAL + Duration::from_millis(50));
    assert!(watch.changed());
}

/// Law: before a pixel is selected, one with many rays is explained, which leaves the message of an error, and a click chooses
/// another. Oracle: the pixel in the corner sees the background alone.
#[test]
fn a_pixel_is_proposed() {
    let mut window = glass_window();
    let inspector = window.state_mut();
    inspector.selection.propose(&Context::default(), &inspector.session.rendering);
    set(&mut window, |it| it.message = Some(("an error of a link".to_owned(), true)));
    text_with(&window, "an error of a link");
    let proposed = window.state().selection.pixel.expect("a pixel is explained");
    let rays = ray_of(&small_glass_sphere(), proposed, 0).count();
    assert!(rays >= ray_of(&small_glass_sphere(), ON_GLASS, 0).count(), "{rays} at {proposed:?}");
    text_with(&window, "to begin with");
    click(&mut window, ON_GLASS);
    assert_eq!(window.state().selection.pixel, Some(ON_GLASS));
    assert!(window.query_by_label_contains("to begin with").is_none());
}

/// Law: a pixel of the command line is explained, and the next scene that is opened proposes one of its own.
#[test]
fn a_later_scene_proposes_its_pixel() {
    let line = ["inspector", "--size", "48x48", "--samples", "4", "--pixel", "17,19"];
    let arguments = Arguments::parse_from(line);
    let mut window = started(&arguments);
    assert_eq!(window.state().selection.pixel, Some(ON_GLASS));
    assert!(!window.state().selection.is_proposed);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("another.toml");
    write(&path, &small("ch24/hall-of-mirrors", [30, 20], 1));
    type_into(&mut window, "File", &path.display().to_string());
    assert!(window.state().selection.is_proposed);
    text_with(&window, "to begin with");
}

/// Law: B changes the ground of the panels from dark to light and back, and it is stored. Oracle: the brightness of a
/// panel.
#[test]
fn the_ground_can_be_light() {
    let mut window = glass_window();
    let ground = |window: &mut Window| {
        let at = window.get_by_label("Lights").rect().right_center();
        color_at(window, at + vec2(20.0, 0.0))[0]
    };
    let dark = ground(&mut window);
    press(&mut window, Key::B);
    let light = ground(&mut window);
    assert!(dark < 60 && light > 200, "{dark}, {light}");
    assert_eq!(window.state().settings.ground, Ground::Light);
    press(&mut window, Key::B);
    assert_eq!(ground(&mut window), dark);
}

/// Law: text has its usual size up to the usual window, grows with the square root beyond it, and at most twofold. Closed
/// form.
#[test]
fn text_grows_with_the_window() {
    for (size, factor) in [
        ([900.0, 600.0], 1.0),
        ([1400.0, 900.0], 1.0),
        ([2800.0, 3600.0], 2.0_f32.sqrt()),
        ([5600.0, 1800.0], 2.0_f32.sqrt()),
        ([28000.0, 18000.0], 2.0),
    ] {
        assert!((growth(size) - factor).abs() < 1e-6, "{size:?}");
    }
}

/// Law: a picture does not replace a file unless that is confirmed: Esc leaves it, Enter replaces it.
#[test]
fn a_file_is_replaced_only_if_that_is_confirmed() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("mine.png");
    std::fs::write(&path, "not a picture").expect("writable");
    let bytes = || std::fs::read(&path).expect("readable");
    let mut window = glass_window();
    type_into(&mut window, "Picture", &path.display().to_string());
    let question = format!("{} exists. Replace it?", path.display());
    assert!(window.query_by_label(&question).is_some());
    assert_eq!(bytes(), b"not a picture");
    press(&mut window, Key::Escape);
    assert!(window.query_by_label(&question).is_none());
    assert_eq!(bytes(), b"not a picture");

    push(&mut window, "Save");
    press(&mut window, Key::Enter);
    assert!(window.query_by_label(&question).is_none());
    assert!(bytes().starts_with(b"\x89PNG"));
}

/// Law: an error message disappears with the next valid action.
#[test]
fn an_error_goes_with_the_next_valid_click() {
    let mut window = glass_window();
    type_into(&mut window, "Pixel", "left");
    assert!(window.state().message.is_some());
    click(&mut window, ON_GLASS);
    assert_eq!(window.state().message, None);
    type_into(&mut window, "Pixel", "999, 3");
    assert!(window.state().message.is_some());
    push(&mut window, "high lamp");
    assert_eq!(window.state().message, None);
}

/// Law: Ctrl-O moves the focus to the file field, Ctrl-S saves under the typed name, `?` and F1 show and
/// hide the list of keys; in a field, `?` is typed as text.
#[test]
fn the_keys_do_what_their_list_says() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("saved.png");
    let mut window = glass_window();
    window.state_mut().fields.save = path.display().to_string();
    press_with(&mut window, Modifiers::COMMAND, Key::S);
    assert!(path.exists());
    let shown = |window: &Window| window.query_by_label("save the picture").is_some();
    for key in [Key::Questionmark, Key::F1] {
        assert!(!shown(&window));
        window.key_press(key);
        window.run_steps(3);
        assert!(shown(&window), "{key:?}");
        window.key_press(key);
        window.run_steps(3);
    }
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run_steps(2);
    let field = window.get_by_role_and_label(Role::TextInput, "File");
    assert!(field.accesskit_node().is_focused());
    window.key_press(Key::Questionmark);
    window.run_steps(3);
    assert!(!shown(&window));
}

/// Settings in memory, as the program keeps them in a file.
#[derive(Default)]
struct Memory(HashMap<String, String>);

impl eframe::Storage for Memory {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

/// Law: stored settings are read back. Settings that cannot be read give the defaults, and splits that leave
/// a part no room are corrected.
#[test]
fn settings_are_kept_and_broken_ones_do_no_harm() {
    let usual = StoredSettings::default();
    let mut memory = Memory::default();
    assert_eq!(StoredSettings::read(Some(&memory)), usual);
    let stored = StoredSettings { ground: Ground::Light, ..usual.clone() };
    stored.write(&mut memory);
    assert_eq!(StoredSettings::read(Some(&memory)), stored);
    let (name, text) = memory.0.iter().next().map(|(n, t)| (n.clone(), t.clone())).expect("stored");
    for broken in ["", "(((", "(splits:(scene:NaN,explanation:7.0))", "(splits:(scene:9e9))"] {
        memory.0.insert(name.clone(), broken.to_owned());
        assert_eq!(StoredSettings::read(Some(&memory)).ground, usual.ground, "{broken}");
        let fitting = StoredSettings::read(Some(&memory)).splits;
        assert_eq!(fitting, fitting.fitting(), "{broken}");
    }
    // a field that a later version adds is no error
    memory.0.insert(name, text.replacen('(', "(later: 3, ", 1));
    assert_eq!(StoredSettings::read(Some(&memory)), stored);
}
