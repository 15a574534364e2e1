//! The selected ray in two pictures, number by number.

use eframe::egui::{Grid, Label, RichText, Ui};
use explain::RecordedRay;
use groundtruth::trace::RayKind;
use text::digits::shortened;

use crate::explanation::asked::Question;
use crate::explanation::details;

/// The ray of another tree in the place of a ray: the child with the same index of the ray with the same index …
fn counterpart<'a>(
    root: &RecordedRay,
    number: usize,
    other: &'a RecordedRay,
) -> Option<&'a RecordedRay> {
    let path = root.path_to(number);
    let mut found = other;
    for pair in path.windows(2) {
        let is_next = |child: &RecordedRay| child.number == pair[1].number;
        let index = pair[0].children.iter().position(is_next)?;
        found = found.children.get(index)?;
    }
    Some(found)
}

/// The rays, one of each tree in the same place, at which the trees part: the first ones from the camera on that do not have
/// the same end. Of several the pair with the largest share of the light in one of the trees.
pub fn parting<'a>(this: &'a RecordedRay, other: &'a RecordedRay) -> Option<[&'a RecordedRay; 2]> {
    if end(this) != end(other) {
        return Some([this, other]);
    }
    let pairs = this.children.iter().zip(&other.children);
    let partings = pairs.filter_map(|(this, other)| parting(this, other));
    let share = |[this, other]: &[&RecordedRay; 2]| this.share.max(other.share);
    partings.max_by(|a, b| share(a).total_cmp(&share(b)))
}

/// What must be equal of a ray for its tree not to part there.
fn end(ray: &RecordedRay) -> (RayKind, Option<(&str, bool)>, Option<&str>, usize) {
    let hit = ray.hit.as_ref().map(|hit| (&*hit.object, hit.front));
    (ray.kind, hit, ray.blocked_by.as_deref(), ray.children.len())
}

/// The fields of a ray that sum up what comes after it.
const SUMS: [&str; 3] = ["radiance", "contributes", "share of the sample"];

/// The first ray, from the camera on, whose own numbers differ from those of the ray in its place.
fn first_differing(this: &RecordedRay, other: &RecordedRay) -> Option<usize> {
    let is_other = |(name, [a, b]): &(&str, [String; 2])| !SUMS.contains(name) && a != b;
    if details::rows(this, other).iter().any(is_other) {
        return Some(this.number);
    }
    let mut pairs = this.children.iter().zip(&other.children);
    pairs.find_map(|(this, other)| first_differing(this, other))
}

/// Of two trees the number of the first ray of this one whose own numbers differ, and of the rays at which they part.
#[derive(Default)]
pub struct Beside {
    compared: Option<([Question; 2], Option<usize>, Parted)>,
}

type Parted = Option<[usize; 2]>;

/// The width of the column of names, in points of the screen.
const NAMES: f32 = 108.0;
const GAP: f32 = 8.0;

impl Beside {
    /// Shows the numbers of a ray of the tree that is shown and of its counterpart. The last argument says whether that tree
    /// stands at the left, and the names of both. Returns the number of a ray that is clicked.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        [this, other]: [(Question, &RecordedRay); 2],
        number: usize,
        (is_left, names): (bool, [&str; 2]),
    ) -> Option<usize> {
        let of = [this.0, other.0];
        let (this, other) = (this.1, other.1);
        let selected = this.path_to(number).last().copied().unwrap_or(this);
        match counterpart(this, selected.number, other) {
            Some(counterpart) => numbers(ui, [selected, counterpart], (is_left, names)),
            None => {
                ui.label(selected.line());
                ui.label("The other tree has no ray in the place of the selected one.");
            }
        }
        ui.add_space(6.0);
        if self.compared.is_none_or(|(compared, ..)| compared != of) {
            let rays = parting(this, other).map(|rays| rays.map(|ray| ray.number));
            self.compared = Some((of, first_differing(this, other), rays));
        }
        let (_, first, parted) = self.compared?;
        let clicked = match (of[0].pixel == of[1].pixel, first, parted) {
            (true, None, _) => {
                ui.weak("No ray has other numbers of its own.");
                return None;
            }
            (true, Some(first), _) => link(ui, first, "is the first whose own numbers differ"),
            // the numbers of two pixels differ from the camera on
            (false, _, None) => {
                ui.weak("All rays end alike.");
                return None;
            }
            (false, _, Some([here, _])) => link(ui, here, "is the first that ends elsewhere"),
        };
        let Some([here, there]) = parted else { return clicked };
        ui.strong("the first rays that end elsewhere, of several those with the most light:");
        let lines = [(this, here), (other, there)].map(|(root, number)| {
            root.path_to(number).last().map_or(String::new(), |ray| ray.line())
        });
        for at in if is_left { [0, 1] } else { [1, 0] } {
            ui.label(format!("{}: {}", names[at], lines[at]));
        }
        clicked
    }
}

/// Shows what is said of a ray, as a link to it. Returns its number if it was clicked.
fn link(ui: &mut Ui, ray: usize, said: &str) -> Option<usize> {
    ui.link(format!("ray {ray} {said}")).clicked().then_some(ray)
}

/// Shows the fields that differ in two columns, ours first, and names the others.
fn numbers(ui: &mut Ui, [this, other]: [&RecordedRay; 2], (is_left, names): (bool, [&str; 2])) {
    let (differing, equal): (Vec<_>, Vec<_>) =
        details::rows(this, other).into_iter().partition(|(_, [this, other])| this != other);
    // both in view, whatever their texts are
    let room = ui.clip_rect().width().min(ui.available_width());
    let column = (0.5 * (room - NAMES - 3.0 * GAP)).max(60.0);
    let cell = |ui: &mut Ui, text: RichText, hint: &str| {
        ui.add(Label::new(text).wrap()).on_hover_text(hint);
    };
    let grid = Grid::new("beside").num_columns(3).striped(true).min_row_height(16.0);
    grid.min_col_width(0.0).max_col_width(column).spacing([GAP, 1.0]).show(ui, |ui| {
        ui.strong(format!("ray {}", this.number));
        let order = if is_left { [0, 1] } else { [1, 0] };
        for at in order {
            cell(ui, RichText::new(names[at]).strong(), names[at]);
        }
        ui.end_row();
        for (field, values) in &differing {
            ui.label(*field);
            for value in order.map(|at| &values[at]) {
                cell(ui, RichText::new(shortened(value)).monospace().size(11.5), value);
            }
            ui.end_row();
        }
    });
    let is_new = |field: &&str| !differing.iter().any(|(other, _)| other == field);
    let mut equal: Vec<&str> = equal.iter().map(|(field, _)| *field).filter(is_new).collect();
    equal.dedup();
    if !equal.is_empty() {
        ui.weak(format!("equal: {}", equal.join(", ")));
    }
}
