//! A window that exists only in memory: small scenes, and the actions of a user.

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use eframe::egui::{
    Context, Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Theme,
    TouchPhase, accesskit::Role, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use explain::RecordedRay;
use groundtruth::film::{self, Film, Tone};
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::{DEFAULT_SEED, World};
use inspector::app::Inspector;
use inspector::comparison::theirs::Theirs;
use inspector::scene::fields::Change;
use inspector::scene::source::{Built, Loaded, Source};
use inspector::start::Start;
use inspector::window::arguments::Arguments;
use inspector::window::style::set_style;

use crate::renderer::Software;

pub type Window = Harness<'static, Inspector>;

/// Far more than anything here takes, also on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);
/// A pixel of the small glass sphere in which both spheres are seen.
pub const ON_GLASS: [u32; 2] = [17, 19];
pub const ETA: &str = "materials.glass sphere.recipe.dielectric.inside.eta";

/// Glass of another index of refraction.
pub fn eta(value: &str) -> Change {
    Change { path: ETA.to_owned(), value: value.to_owned() }
}

/// A scene of the gallery in so many pixels and samples.
pub fn small(name: &str, [width, height]: [u32; 2], samples: u32) -> Scene {
    let mut scene = (gallery::find(name).expect("in the gallery").build)();
    scene.image.resize(width, height);
    scene.image.samples = samples;
    scene
}

/// The glass sphere in few pixels of few samples.
pub fn small_glass_sphere() -> Scene {
    small("ch28/glass-sphere", [48, 48], 4)
}

pub fn built(scene: &Scene) -> World {
    World::build(scene).expect("the scene is valid")
}

pub fn rendered(scene: &Scene) -> Film {
    render::render(&built(scene))
}

/// A window on a changed scene of the gallery, rendered.
pub fn open(scene: Scene) -> Window {
    open_sized(scene, [1280.0, 800.0])
}

/// The same in this size.
pub fn open_sized(scene: Scene, size: [f32; 2]) -> Window {
    let mut window = begin(scene, size);
    settle(&mut window);
    window
}

/// The same, of which nothing is rendered yet.
pub fn begin(scene: Scene, size: [f32; 2]) -> Window {
    let entry = gallery::find("ch28/glass-sphere").expect("in the gallery");
    let source = (Source::Gallery(entry), Arc::new(scene.clone()));
    let built = Built::of(source, scene, DEFAULT_SEED).expect("the scene is valid");
    window(built.into(), size)
}

/// A window of this size on a loaded scene.
pub fn window(loaded: Loaded, size: [f32; 2]) -> Window {
    window_of(Inspector::new(&Context::default(), loaded), size)
}

/// A window of this size.
pub fn window_of(inspector: Inspector, size: [f32; 2]) -> Window {
    Harness::builder()
        .with_size(size)
        .with_theme(Theme::Dark)
        .with_context_setup(set_style)
        .renderer(Software::default())
        .build_ui_state(|ui, inspector: &mut Inspector| inspector.show(ui), inspector)
}

/// The window that the command line opens.
pub fn started(arguments: &Arguments) -> Window {
    let start = Start::read(arguments).expect("valid");
    let inspector = start.inspector(&Context::default(), None, arguments);
    let mut window = window_of(inspector, [1280.0, 800.0]);
    settle(&mut window);
    window
}

/// A window on the small glass sphere, rendered.
pub fn glass_window() -> Window {
    open(small_glass_sphere())
}

/// The same, with a pixel explained.
pub fn glass_window_at(pixel: [u32; 2]) -> Window {
    let mut window = glass_window();
    click(&mut window, pixel);
    window
}

/// Draws frames until all background work is finished.
pub fn settle(window: &mut Window) {
    // the work starts in the next frame
    window.run_steps(3);
    wait_until(window, "it is finished", |window| !window.state().is_busy());
    window.run_steps(3);
}

/// Draws frames until this is so.
pub fn wait_until(window: &mut Window, what: &str, is_so: impl Fn(&Window) -> bool) {
    let start = Instant::now();
    while !is_so(window) {
        assert!(start.elapsed() < PATIENCE, "long since not so: {what}");
        std::thread::sleep(Duration::from_millis(2));
        window.step();
    }
}

/// Our picture so far.
pub fn film(window: &Window) -> Film {
    window.state().session.rendering.canvas.film()
}

/// The picture that is held against ours.
pub fn theirs(window: &Window) -> &Theirs {
    window.state().others.shown().expect("there is one")
}

/// Chooses an entry of the list of this name.
pub fn choose(window: &mut Window, list: &str, entry: &str) {
    window.get_by_role_and_label(Role::ComboBox, list).click();
    window.run_steps(4);
    push_button(window, entry);
}

/// A window on a scene file.
pub fn window_on(path: &Path) -> Window {
    let loaded = Source::File(path.to_owned()).load().expect("the scene is valid");
    let mut window = window(loaded, [1280.0, 800.0]);
    settle(&mut window);
    window
}

/// Writes a scene file.
pub fn write(path: &Path, scene: &Scene) {
    let text = scenefile::to_toml(scene).expect("plain data");
    std::fs::write(path, text).expect("writable");
}

/// A picture as the program reads it from a file of this name.
pub fn read(folder: &Path, film: &Film, name: &str) -> Theirs {
    let path = folder.join(name);
    film::write(film, &Tone::PLAIN, &path).expect("written");
    Theirs::read(&path, None).expect("it is a picture")
}

/// The middle of a pixel on the screen.
pub fn on_screen(window: &Window, pixel: [u32; 2]) -> Pos2 {
    let inspector = window.state();
    inspector.picture.placement(inspector.session.rendering.size()).rect(pixel).center()
}

/// The colour of the screen in the middle of a pixel.
pub fn shown(window: &mut Window, pixel: [u32; 2]) -> [u8; 3] {
    let at = on_screen(window, pixel);
    color_at(window, at)
}

/// The colour of the screen there.
pub fn color_at(window: &mut Window, at: Pos2) -> [u8; 3] {
    let [r, g, b, _] = window.render().expect("drawn").get_pixel(at.x as u32, at.y as u32).0;
    [r, g, b]
}

/// Clicks a pixel and waits for its explanation.
pub fn click(window: &mut Window, pixel: [u32; 2]) {
    let at = on_screen(window, pixel);
    click_at(window, at);
}

/// Clicks there and waits for what follows.
pub fn click_at(window: &mut Window, at: Pos2) {
    point_and_press(window, at);
    settle(window);
}

pub fn point_and_press(window: &mut Window, at: Pos2) {
    window.hover_at(at);
    window.drag_at(at);
    window.drop_at(at);
}

/// Drags from one place to another and waits for what follows.
pub fn drag(window: &mut Window, from: Pos2, to: Pos2) {
    window.hover_at(from);
    window.drag_at(from);
    window.hover_at(to);
    window.drop_at(to);
    settle(window);
}

/// Turns the wheel there, away from the user, until all has moved.
pub fn turn_wheel(window: &mut Window, at: Pos2) {
    window.hover_at(at);
    window.event(Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, 200.0),
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    window.run_steps(30);
}

/// Points there, until what is pointed at is lit.
pub fn hover(window: &mut Window, at: Pos2) {
    window.hover_at(at);
    window.run_steps(4);
}

/// Presses a key and waits for what follows.
pub fn press(window: &mut Window, key: Key) {
    press_with(window, Modifiers::NONE, key);
}

/// The same with Ctrl, Alt or Shift.
pub fn press_with(window: &mut Window, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    settle(window);
}

/// Clicks what has this label and waits for what follows.
pub fn push(window: &mut Window, label: &str) {
    window.get_by_label(label).click();
    settle(window);
}

/// The same with a button.
pub fn push_button(window: &mut Window, label: &str) {
    window.get_by_role_and_label(Role::Button, label).click();
    settle(window);
}

/// Two clicks in one frame: each event of its own would take one, too slow for a double click.
pub fn double_click(window: &mut Window, pos: Pos2) {
    window.hover_at(pos);
    window.step();
    let click = |pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    window.input_mut().events.extend([true, false, true, false].map(click));
    window.run_steps(3);
}

/// Changes the window from outside and waits for what follows.
pub fn set<T>(window: &mut Window, change: impl FnOnce(&mut Inspector) -> T) {
    change(window.state_mut());
    settle(window);
}

/// Types into the field of this name, and Enter.
pub fn type_into(window: &mut Window, field: &str, text: &str) {
    type_as(window, Role::TextInput, field, text);
}

/// Types into the number of this name, and Enter.
pub fn type_number(window: &mut Window, field: &str, text: &str) {
    type_as(window, Role::SpinButton, field, text);
}

fn type_as(window: &mut Window, role: Role, field: &str, text: &str) {
    let at = window.get_by_role_and_label(role, field).rect().center();
    point_and_press(window, at);
    window.step();
    window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.step();
    // a number turns into a text while it is typed
    type_text(window, text);
    press(window, Key::Enter);
}

/// Types into the field that has the keys, over what is selected there.
pub fn type_text(window: &mut Window, text: &str) {
    window.get_all_by(|node| node.is_focused()).next().expect("it has the keys").type_text(text);
    window.run_steps(3);
}

/// The text of the one label that contains this.
pub fn text_with(window: &Window, part: &str) -> String {
    text_of(&window.get_by_label_contains(part).accesskit_node())
}

/// The text of a node.
pub fn text_of(node: &egui_kittest::kittest::AccessKitNode<'_>) -> String {
    node.label().or_else(|| node.value()).unwrap_or_default()
}

/// The line of the camera's ray of sample 0, from the library.
pub fn root_line(scene: &Scene, pixel: [u32; 2]) -> String {
    root_line_of(scene, pixel, 0)
}

/// The line of the camera's ray of a sample, from the library.
pub fn root_line_of(scene: &Scene, pixel: [u32; 2], sample: u32) -> String {
    ray_of(scene, pixel, sample).line()
}

/// The tree of a sample, from the library.
pub fn ray_of(scene: &Scene, pixel: [u32; 2], sample: u32) -> RecordedRay {
    let explained = explain::sample(scene, &built(scene), pixel, sample);
    explained.ray.expect("the camera sees all its film")
}
