//! The numbers of a scene, which can be dragged: those of its fields that are real numbers, or lists of them.

use eframe::egui::{CollapsingHeader, DragValue, Label, TextEdit, Ui};
use groundtruth::scene::Scene;

use crate::scene::fields::{self, Change};

/// The most fields that are shown at once; words find the others.
const MAX_SHOWN: usize = 40;
/// The part of a number by which it changes for a point of the screen, and the least of which it is a part.
const SPEED: f64 = 0.005;
const LEAST: f64 = 0.2;

/// Fields, each with its numbers.
type Fields = Vec<(Change, Vec<f64>)>;

/// The fields of a scene, and the words by which they are looked for.
#[derive(Default)]
pub struct Numbers {
    typed: String,
    /// The fields with numbers, by the rendering that they are of.
    fields: Option<(u64, Fields)>,
    problem: Option<String>,
}

/// The real numbers of a value as it stands in a scene file; `None` if it is anything else.
fn numbers(value: &str) -> Option<Vec<f64>> {
    let list = value.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    let parts = list.unwrap_or(value).split(',').map(str::trim);
    // a count has no point
    parts.map(|part| part.contains('.').then(|| part.parse().ok())?).collect()
}

/// Numbers as they stand in a scene file.
fn written(numbers: &[f64]) -> String {
    match numbers {
        [number] => format!("{number:?}"),
        all => format!("{all:?}"),
    }
}

/// A scene of a file that was read again, with every number that was changed in the window since it was read before.
pub fn with_changes(before: &Scene, wanted: &Scene, mut now: Scene) -> Scene {
    let known = fields::all(before);
    let is_changed = |field: &Change| {
        let old = known.iter().find(|old| old.path == field.path);
        // the size of pixels follows that of the picture
        let is_own = !field.path.starts_with("image.") && numbers(&field.value).is_some();
        is_own && old.is_some_and(|old| old.value != field.value)
    };
    for change in fields::all(wanted).iter().filter(|field| is_changed(field)) {
        // one that the new file has no place for is dropped
        now = change.applied(&now).unwrap_or(now);
    }
    now
}

impl Numbers {
    /// Shows those whose paths have the typed words, folded at first; `scene` is that of a rendering. Returns whether
    /// `wanted` was changed.
    pub fn show(&mut self, ui: &mut Ui, (of, scene): (u64, &Scene), wanted: &mut Scene) -> bool {
        let open = CollapsingHeader::new("Numbers").show(ui, |ui| {
            if self.fields.as_ref().is_none_or(|(known, _)| *known != of) {
                let all = fields::all(scene).into_iter();
                let real = all.filter_map(|field| Some((numbers(&field.value)?, field)));
                self.fields = Some((of, real.map(|(numbers, field)| (field, numbers)).collect()));
            }
            let field = TextEdit::singleline(&mut self.typed).hint_text("words of a path");
            ui.add(field.desired_width(f32::INFINITY));
            let changed = self.list(ui);
            if let Some(problem) = &self.problem {
                ui.colored_label(ui.visuals().error_fg_color, problem);
            }
            changed
        });
        let Some(change) = open.body_returned.flatten() else { return false };
        let applied = change.applied(wanted);
        let is_changed = applied.is_ok();
        self.problem = applied.map(|scene| *wanted = scene).err();
        is_changed
    }

    fn list(&self, ui: &mut Ui) -> Option<Change> {
        let fields = self.fields.iter().flat_map(|(_, fields)| fields);
        let mut found = fields.filter(|(field, _)| fields::has_words(&field.path, &self.typed));
        let mut changed = None;
        for (field, numbers) in found.by_ref().take(MAX_SHOWN) {
            ui.add(Label::new(&field.path).truncate());
            ui.horizontal_wrapped(|ui| {
                for at in 0..numbers.len() {
                    let mut numbers = numbers.clone();
                    let speed = SPEED * numbers[at].abs().max(LEAST);
                    let number = DragValue::new(&mut numbers[at]).speed(speed).max_decimals(6);
                    let number = ui.push_id((&field.path, at), |ui| ui.add(number)).inner;
                    if number.on_hover_text("Drag it, or click and type").changed() {
                        changed = Some(Change { value: written(&numbers), ..field.clone() });
                    }
                }
            });
        }
        if let more @ 1.. = found.count() {
            ui.weak(format!("and {more} more"));
        }
        changed
    }
}
