//! The camera of the space view: the buttons, keys and drags that move it, and what it looks through.

use eframe::egui::{Key, PointerButton, Response, Ui, Vec2};
use explain::RecordedRay;
use groundtruth::math::Vector;
use groundtruth::world::World;
use space::{Orbit, Segment};

use crate::picture::view::{keep_arrows, zoomed};

/// The turn of the camera, in degrees for a point of the screen.
const TURN: f32 = 0.4;
/// The turn of the camera by an arrow key, in degrees.
const STEP: f64 = 5.0;
/// The first camera without a tree, turned away from the scene's: yaw and pitch in degrees.
const ASIDE: [f64; 2] = [35.0, 18.0];
/// A place of the camera.
#[derive(Clone, Copy)]
enum Look {
    From(Vector),
    AsCamera,
    AtRays,
    AtScene,
    AlongRay,
}

/// The places of the camera: each with its button, its key, and what it does.
const LOOKS: [(&str, Key, Look, &str); 7] = [
    ("Front", Key::Num1, Look::From(Vector::Z), "The scene from there (1)"),
    ("Side", Key::Num2, Look::From(Vector::X), "The scene from there (2)"),
    ("Top", Key::Num3, Look::From(Vector::Y), "The scene from there (3)"),
    ("Camera", Key::C, Look::AsCamera, "As the scene's camera sees it (C)"),
    ("Fit rays", Key::F, Look::AtRays, FIT),
    ("Fit scene", Key::A, Look::AtScene, "All objects, from this side, none looked through (A)"),
    ("Along ray", Key::R, Look::AlongRay, "Look along the selected ray (R)"),
];
const FIT: &str =
    "What the rays of at least 1 % meet, across their plane, through what hides them (F)";

/// What the camera looks at.
pub struct Seen<'a> {
    /// The scene.
    pub world: &'a World,
    /// The camera's ray of the tree whose rays are drawn.
    pub root: Option<&'a RecordedRay>,
    /// The number of the selected ray.
    pub selected: usize,
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
    /// Whether there were rays to look at.
    has_seen_rays: bool,
}

impl Camera {
    /// Looks at the scene, and at the rays once there are some, unless it did already.
    pub fn start(&mut self, scene: &Seen<'_>) {
        if self.orbit.is_none() || (!self.has_seen_rays && scene.root.is_some()) {
            self.face(scene);
        }
        self.has_seen_rays |= scene.root.is_some();
    }

    /// Shows whether an object is looked through. Returns whether that was changed.
    pub fn fade(&mut self, ui: &mut Ui, object: u32, text: String) -> bool {
        let mut is_faded = self.faded.contains(&object);
        let is_changed = ui.checkbox(&mut is_faded, text).changed();
        if is_changed {
            self.faded.retain(|faded| *faded != object);
            self.faded.extend(is_faded.then_some(object));
        }
        is_changed
    }

    /// Shows the buttons.
    pub fn buttons(&mut self, ui: &mut Ui, scene: &Seen<'_>) {
        for (text, _, look, hint) in LOOKS {
            if let Look::AtRays = look {
                ui.separator();
            }
            if ui.small_button(text).on_hover_text(hint).clicked() {
                self.look(look, scene);
            }
        }
    }

    fn look(&mut self, look: Look, scene: &Seen<'_>) {
        let Some(orbit) = &mut self.orbit else { return };
        match look {
            Look::From(side) => {
                let Orbit { yaw, pitch, .. } = Orbit::from_side((orbit.target, 1.0), side);
                (orbit.yaw, orbit.pitch) = (yaw, pitch);
            }
            Look::AsCamera => *orbit = as_camera(scene.world),
            Look::AtRays => self.face(scene),
            Look::AtScene => {
                *orbit = Orbit::around(space::of_scene(scene.world), orbit.yaw, orbit.pitch);
                self.faded.clear();
            }
            Look::AlongRay => {
                let is_selected = |piece: &&Segment| piece.ray == scene.selected;
                if let Some(Segment { from, to, .. }) = scene.segments.iter().find(is_selected) {
                    let along = Orbit::from_side((*to, 1.0), *from - *to);
                    *orbit = Orbit { distance: from.distance(*to), ..along };
                }
            }
        }
    }

    /// Looks at the rays across the plane of the hit that says most, through what hides them; without a tree at the scene.
    fn face(&mut self, scene: &Seen<'_>) {
        let world = scene.world;
        let Some(root) = scene.root else {
            self.orbit = Some(first_view(world));
            return;
        };
        let orbit = space::orbit_of(world, root);
        self.faded = space::hiding(world, root, &orbit);
        self.orbit = Some(orbit);
    }

    /// Moves the camera as mouse and keys ask for.
    pub fn follow(&mut self, ui: &Ui, response: &Response, scene: &Seen<'_>) {
        if response.clicked() || response.dragged() {
            response.request_focus();
        }
        keep_arrows(ui, response.id);
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
            let distance = orbit.distance / f64::from(zoomed(ui, 0.003));
            orbit.distance = distance.clamp(f64::MIN_POSITIVE, f64::MAX);
        }
        if !response.has_focus() {
            return;
        }
        let presses = |key| ui.input(|input| input.num_presses(key)) as f64;
        let across = presses(Key::ArrowRight) - presses(Key::ArrowLeft);
        let up = presses(Key::ArrowUp) - presses(Key::ArrowDown);
        orbit.turn(STEP * across, STEP * up);
        let nearer = presses(Key::Plus) + presses(Key::Equals) - presses(Key::Minus);
        orbit.distance *= 1.0 - 0.1 * nearer.clamp(-5.0, 5.0);
        for (_, key, look, _) in LOOKS {
            if ui.input(|input| input.key_pressed(key)) {
                self.look(look, scene);
            }
        }
    }
}

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
