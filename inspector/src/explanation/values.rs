//! The values that a log has of a pixel, a program's own among them: plotted over the samples, and sorted.

use std::collections::{BTreeMap, HashSet};

use eframe::egui::{Align2, Color32, ComboBox, FontId, Pos2, Rect, Sense, Stroke, Ui, pos2, vec2};
use rays::{Logged, LoggedValue, RayPlace};
use text::brief::brief;

use crate::explanation::asked::Question;
use crate::picture::display::{ground, ink};

/// The height of the plot and of a line of the list, in points of the screen.
const HEIGHT: f32 = 130.0;
const LINE: f32 = 18.0;
/// The room for the numbers beside and below the plot.
const LEFT: f32 = 64.0;
const BELOW: f32 = 14.0;
/// Points that are nearer to each other cover each other.
const APART: f32 = 4.0;
/// The farthest click from a point that selects its ray.
const REACH: f32 = 12.0;

/// The values of a pixel by their names.
type Values = BTreeMap<(bool, String), Vec<LoggedValue>>;

/// The value that is shown.
#[derive(Default)]
pub struct ValuesView {
    name: (bool, String),
    /// All values of a pixel, as they were looked up last.
    found: Option<(Question, Values)>,
}

impl ValuesView {
    /// Shows the values of a pixel by name. Returns where the ray stands that was clicked.
    pub fn show(&mut self, ui: &mut Ui, log: &Logged, question: Question) -> Option<RayPlace> {
        let found = self.found.take_if(|(of, _)| *of == question);
        let (_, all) =
            self.found.insert(found.unwrap_or_else(|| (question, log.values(question.pixel))));
        if !all.contains_key(&self.name) {
            self.name = all.keys().next()?.clone();
        }
        ui.horizontal(|ui| {
            let label = ui.label("Value");
            let list = ComboBox::from_id_salt("value").selected_text(&self.name.1);
            let list = list.show_ui(ui, |ui| {
                for name in all.keys() {
                    ui.selectable_value(&mut self.name, name.clone(), &*name.1);
                }
            });
            list.response.labelled_by(label.id);
            ui.weak("of each ray that has it, over the samples");
        });
        let values = all.get(&self.name)?;
        let mut clicked = plot(ui, values, log.trees_of(question.pixel));
        let mut sorted: Vec<&LoggedValue> = values.iter().collect();
        let order = |a: &&LoggedValue, b: &&LoggedValue| {
            b.value.total_cmp(&a.value).then(a.ray.cmp(&b.ray))
        };
        if sorted.len() > MAX_LISTED {
            sorted.select_nth_unstable_by(MAX_LISTED, order);
            sorted.truncate(MAX_LISTED);
        }
        sorted.sort_by(order);
        ui.spacing_mut().interact_size.y = LINE;
        for value in sorted {
            let name = log.verdict.traced.name(value.ray);
            let line = format!("{}  sample {}, {name}", brief(value.value), value.sample);
            if ui.link(line).clicked() {
                clicked = Some(value.ray);
            }
        }
        clicked.map(|ray| log.place(ray))
    }
}

/// The most values that are listed.
const MAX_LISTED: usize = 300;

/// Draws each value over its sample. Returns the ray of the point that was clicked.
fn plot(ui: &mut Ui, values: &[LoggedValue], samples: u32) -> Option<usize> {
    let (whole, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::click());
    let area = Rect::from_min_max(whole.min + vec2(LEFT, 4.0), whole.max - vec2(6.0, BELOW));
    let finite = || values.iter().map(|it| it.value).filter(|value| value.is_finite());
    let (low, high) = (finite().fold(f64::MAX, f64::min), finite().fold(f64::MIN, f64::max));
    let painter = ui.painter_at(whole);
    painter.rect_filled(area, 2.0, ground(ui.visuals()));
    let last = f64::from(samples.max(2) - 1);
    let on_screen = |it: &LoggedValue| -> Pos2 {
        let part = if high > low { (it.value - low) / (high - low) } else { 0.5 };
        let x = area.left() + 4.0 + (area.width() - 8.0) * (f64::from(it.sample) / last) as f32;
        pos2(x, area.bottom() - 4.0 - (area.height() - 8.0) * part as f32)
    };
    let shown = || values.iter().filter(|it| it.value.is_finite());
    // of points that cover each other only one is drawn
    let mut drawn = HashSet::new();
    for at in shown().map(on_screen) {
        if drawn.insert([at.x, at.y].map(|it| (it / APART) as i32)) {
            let edge = Stroke::new(0.7, ground(ui.visuals()));
            painter.circle(at, 2.5, ink(ui.visuals(), Color32::from_rgb(120, 180, 255)), edge);
        }
    }
    let font = FontId::proportional(11.0);
    let grey = ui.visuals().weak_text_color();
    for (y, value) in [(area.top() + 6.0, high), (area.bottom() - 6.0, low)] {
        let at = pos2(area.left() - 4.0, y);
        painter.text(at, Align2::RIGHT_CENTER, brief(value), font.clone(), grey);
    }
    let ends =
        [(area.left(), Align2::LEFT_BOTTOM, 0), (area.right(), Align2::RIGHT_BOTTOM, samples - 1)];
    for (x, align, sample) in ends {
        let text = format!("sample {sample}");
        painter.text(pos2(x, whole.bottom()), align, text, font.clone(), grey);
    }
    let at = response.hover_pos()?;
    let distance = |it: &&LoggedValue| on_screen(it).distance(at);
    let nearest = shown().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let nearest = nearest.filter(|it| distance(it) <= REACH)?;
    let ring = Stroke::new(2.0, ui.visuals().strong_text_color());
    painter.circle_stroke(on_screen(nearest), 5.0, ring);
    response.clicked().then_some(nearest.ray)
}
