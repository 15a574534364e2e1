//! The camera of the space view: the buttons, keys and drags that move it, and what it looks through.

use eframe::egui::{EventFilter, Key, PointerButton, Response, Ui, Vec2};
use groundtruth::math::{Point, Vector};
use groundtruth::world::World;
use space::{Orbit, Segment};

use crate::space::view::Traced;

/// The turn of the camera, in degrees for a point of the screen.
const TURN: f32 = 0.4;
/// The turn of the camera by an arrow key, in degrees.
const STEP: f64 = 5.0;
/// The first camera without a tree, turned away from the scene's: yaw and pitch in degrees.
const ASIDE: [f64; 2] = [35.0, 18.0];
/// What the button does.
const FIT: &str = "What the rays meet, across their plane, through what hides them (F)";

/// What the camera looks at.
pub struct Seen<'a> {
    /// The scene.
    pub world: &'a World,
    /// The tree whose rays are drawn.
    pub traced: Option<&'a Traced<'a>>,
    /// The pieces of its rays.
    pub segments: &'a [Segment],
}

/// The camera, and what it looks through.
#[derive(Default)]
pub struct Camera {
    /// Where it is, once there was something to look at.
    pub orbit: Option<Orbit>,
    /// The indices of the objects that are looked through.
    pub faded: Vec<u32>,
}

impl Camera {
    /// Looks at the scene, unless it does already.
    pub fn start(&mut self, scene: &Seen<'_>) {
        if self.orbit.is_none() {
            self.face(scene);
        }
    }

    /// Looks through an object from now on, or no longer.
    pub fn toggle(&mut self, object: u32) {
        match self.faded.iter().position(|&faded| faded == object) {
            Some(at) => drop(self.faded.remove(at)),
            None => self.faded.push(object),
        }
    }

    /// Shows the buttons.
    pub fn buttons(&mut self, ui: &mut Ui, scene: &Seen<'_>) {
        for (text, side, key) in SIDES {
            let hint = format!("The scene from there ({key})");
            if ui.small_button(text).on_hover_text(hint).clicked() {
                self.look_from(side);
            }
        }
        let camera = ui.small_button("Camera");
        if camera.on_hover_text("As the scene's camera sees it (C)").clicked() {
            self.orbit = Some(as_camera(scene.world));
        }
        ui.separator();
        if ui.small_button("Fit rays").on_hover_text(FIT).clicked() {
            self.face(scene);
        }
        if ui.small_button("Fit scene").on_hover_text("(A)").clicked() {
            self.fit(space::of_scene(scene.world));
        }
        let along = ui.small_button("Along ray");
        if along.on_hover_text("Look along the selected ray (R)").clicked() {
            self.look_along(scene);
        }
    }

    /// Looks at the rays across the plane of the hit that says most, through what hides them; without a tree at the scene.
    fn face(&mut self, scene: &Seen<'_>) {
        let world = scene.world;
        let Some(traced) = scene.traced else {
            self.orbit = Some(first_view(world));
            return;
        };
        let orbit = space::orbit_of(world, traced.root);
        self.faded = space::hiding(world, traced.root, &orbit);
        self.orbit = Some(orbit);
    }

    fn look_from(&mut self, side: Vector) {
        if let Some(orbit) = &mut self.orbit {
            let Orbit { yaw, pitch, .. } = Orbit::from_side((orbit.target, 1.0), side);
            (orbit.yaw, orbit.pitch) = (yaw, pitch);
        }
    }

    fn fit(&mut self, ball: (Point, f64)) {
        if let Some(orbit) = &mut self.orbit {
            *orbit = Orbit::around(ball, orbit.yaw, orbit.pitch);
        }
    }

    /// Looks along the selected ray, from its origin.
    fn look_along(&mut self, scene: &Seen<'_>) {
        let Seen { traced, segments, .. } = scene;
        let piece = traced.and_then(|it| segments.iter().find(|piece| piece.ray == it.selected));
        if let Some(Segment { from, to, .. }) = piece {
            let orbit = Orbit::from_side((*to, 1.0), *from - *to);
            self.orbit = Some(Orbit { distance: from.distance(*to), ..orbit });
        }
    }

    /// Moves the camera as mouse and keys ask for.
    pub fn follow(&mut self, ui: &Ui, response: &Response, scene: &Seen<'_>) {
        if response.clicked() || response.dragged() {
            response.request_focus();
        }
        let keys =
            EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, keys));
        let Some(orbit) = &mut self.orbit else { return };
        let Vec2 { x, y } = response.drag_delta();
        let pans = ui.input(|input| input.modifiers.shift);
        if response.dragged_by(PointerButton::Primary) && !pans {
            orbit.turn(f64::from(-TURN * x), f64::from(TURN * y));
        } else if response.dragged() {
            let side = response.rect.width().min(response.rect.height());
            orbit.pan(f64::from(-x / side), f64::from(y / side));
        }
        if response.hovered() {
            let (wheel, pinch) =
                ui.input(|input| (input.smooth_scroll_delta.y, input.zoom_delta()));
            let distance = orbit.distance / f64::from((wheel * 0.003).exp() * pinch);
            orbit.distance = distance.clamp(f64::MIN_POSITIVE, f64::MAX);
        }
        if response.has_focus() {
            self.press(ui, scene);
        }
    }

    fn press(&mut self, ui: &Ui, scene: &Seen<'_>) {
        let presses = |key| ui.input(|input| input.num_presses(key)) as f64;
        if let Some(orbit) = &mut self.orbit {
            let across = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
            let up = presses(Key::ArrowUp) - presses(Key::ArrowDown);
            orbit.turn(STEP * across, STEP * up);
            let nearer = presses(Key::Plus) + presses(Key::Equals) - presses(Key::Minus);
            orbit.distance *= 1.0 - 0.1 * nearer.clamp(-5.0, 5.0);
        }
        let is_pressed = |key| ui.input(|input| input.key_pressed(key));
        for ((_, side, _), key) in SIDES.into_iter().zip([Key::Num1, Key::Num2, Key::Num3]) {
            if is_pressed(key) {
                self.look_from(side);
            }
        }
        if is_pressed(Key::C) {
            self.orbit = Some(as_camera(scene.world));
        }
        if is_pressed(Key::F) {
            self.face(scene);
        }
        if is_pressed(Key::A) {
            self.fit(space::of_scene(scene.world));
        }
        if is_pressed(Key::R) {
            self.look_along(scene);
        }
    }
}

/// The sides from which the scene is looked at, with their keys.
const SIDES: [(&str, Vector, &str); 3] =
    [("Front", Vector::Z, "1"), ("Side", Vector::X, "2"), ("Top", Vector::Y, "3")];

/// Sees the scene from aside of its camera.
fn first_view(world: &World) -> Orbit {
    let mut orbit = Orbit::from_side(space::of_scene(world), world.view.frame().w);
    let [yaw, pitch] = ASIDE;
    orbit.turn(yaw, if orbit.pitch + pitch > 80.0 { -pitch } else { pitch });
    orbit
}

/// Sees what the scene's camera sees, if that is upright and looks straight.
fn as_camera(world: &World) -> Orbit {
    let (center, radius) = space::of_scene(world);
    let eye = world.view.eyes()[0].position();
    let back = world.view.frame().w;
    let distance = (eye - center).dot(back);
    let distance = if distance > 0.0 { distance } else { radius };
    Orbit { distance, ..Orbit::from_side((eye - distance * back, radius), back) }
}
