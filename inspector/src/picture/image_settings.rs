//! The settings of the picture: size, samples, depth and seed, as numbers to type or drag.

use eframe::egui::{ComboBox, DragValue, Grid, Response, TextEdit, Ui, emath::Numeric};
use groundtruth::scene::{Intersect, Scene, Tracer};
use groundtruth::world::{MAX_DEPTH, MAX_SAMPLES};

/// The seed as typed: text, because a number field would round large seeds.
#[derive(Debug, Default)]
pub struct ImageSettings {
    seed: String,
}

impl ImageSettings {
    /// Shows the numbers; returns whether one was changed.
    pub fn show(&mut self, ui: &mut Ui, scene: &mut Scene, seed: &mut u64) -> bool {
        let grid = Grid::new("image").num_columns(2).spacing([6.0, 3.0]);
        grid.show(ui, |ui| {
            let resized = size(ui, scene);
            let sampled = number(ui, "Samples", &mut scene.image.samples, 1..=MAX_SAMPLES)
                .on_hover_text("Samples per pixel; some samplers round up")
                .changed();
            ui.end_row();
            let traced = tracer(ui, scene);
            resized | sampled | traced | intersections(ui, scene) | self.seed(ui, seed)
        })
        .inner
    }

    fn seed(&mut self, ui: &mut Ui, seed: &mut u64) -> bool {
        let label = ui.label("Seed");
        let typed = self.seed.trim().parse::<u64>();
        let mut field = TextEdit::singleline(&mut self.seed).desired_width(f32::INFINITY);
        if typed.is_err() {
            field = field.text_color(ui.visuals().error_fg_color);
        }
        let field = ui.add(field).labelled_by(label.id);
        let hint = format!("The seed of all random choices: a whole number from 0 to {}", u64::MAX);
        let field = field.on_hover_text(hint);
        ui.end_row();
        let mut changed = false;
        if let (true, Ok(typed)) = (field.lost_focus(), typed) {
            changed = typed != *seed;
            *seed = typed;
        }
        if !field.has_focus() {
            self.seed = seed.to_string();
        }
        changed
    }
}

/// Shows width and height; the view stays the same.
fn size(ui: &mut Ui, scene: &mut Scene) -> bool {
    let [mut width, mut height] = [scene.image.width, scene.image.height];
    let mut changed = false;
    for (name, side) in [("Width", &mut width), ("Height", &mut height)] {
        // the library refuses what is too large, with the number that was typed
        changed |= number(ui, name, side, 1..=u32::MAX).changed();
        ui.end_row();
    }
    if changed {
        scene.image.resize(width, height);
    }
    changed
}

/// Shows the tracer, and how deep it follows rays.
fn tracer(ui: &mut Ui, scene: &mut Scene) -> bool {
    let all = Tracer::ALL.map(|tracer| (tracer.name(), tracer));
    let chosen = list(ui, "Tracer", scene.tracer.name(), &all, "How light is traced");
    let mut changed = chosen.is_some();
    if let Some(other) = chosen {
        scene.tracer = scene.tracer.replaced_by(other);
    }
    match scene.tracer.max_depth() {
        Some(max_depth) => {
            let hint = "The largest number of reflections and transmissions in a row";
            changed |=
                number(ui, "Max depth", max_depth, 0..=MAX_DEPTH).on_hover_text(hint).changed();
        }
        None => {
            ui.label("Max depth");
            let hint = "This tracer casts no reflected or transmitted rays";
            ui.weak("none").on_hover_text(hint);
        }
    }
    ui.end_row();
    changed
}

/// Shows how all objects are intersected.
fn intersections(ui: &mut Ui, scene: &mut Scene) -> bool {
    let all = Intersect::ALL.map(|routines| (routines.name(), routines));
    let name = scene.intersections().map_or("mixed", Intersect::name);
    let hint = "The library's own routines, or the book's formulas with a constant epsilon";
    let chosen = list(ui, "Routines", name, &all, hint);
    chosen.into_iter().for_each(|other| scene.set_intersections(other));
    chosen.is_some()
}

/// Shows a list of names. Returns what was chosen in place of the present one.
fn list<T: Copy>(
    ui: &mut Ui,
    title: &str,
    present: &str,
    all: &[(&str, T)],
    hint: &str,
) -> Option<T> {
    let (label, mut chosen) = (ui.label(title), None);
    // what is visible of its column in a narrow window
    let width = (ui.clip_rect().right() - ui.cursor().left() - 4.0).clamp(44.0, 100.0);
    let combo = ComboBox::from_id_salt(title).selected_text(present).width(width).truncate();
    let combo = combo.show_ui(ui, |ui| {
        for &(name, other) in all {
            if ui.selectable_label(name == present, name).clicked() && name != present {
                chosen = Some(other);
            }
        }
    });
    combo.response.labelled_by(label.id).on_hover_text(hint);
    ui.end_row();
    chosen
}

/// Shows a number field that takes effect when typing ends.
fn number<N: Numeric>(
    ui: &mut Ui,
    name: &str,
    value: &mut N,
    range: std::ops::RangeInclusive<N>,
) -> Response {
    let label = ui.label(name);
    let field = DragValue::new(value).range(range).update_while_editing(false);
    ui.add(field).labelled_by(label.id)
}
