//! The selected ray in two pictures, number by number.

use eframe::egui::{Grid, RichText, Ui};
use groundtruth::explain::RecordedRay;
use pictures::digits::shortened;

use crate::explanation::details;

/// The ray of another tree in the place of a ray: the child with the same index of the ray with the same index …
pub fn counterpart<'a>(
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

/// The lines of the first rays, from the camera on, that do not have the same end in two trees.
pub fn first_parting<'a>(
    this: &'a RecordedRay,
    other: &'a RecordedRay,
) -> Option<[&'a RecordedRay; 2]> {
    let end = |ray: &RecordedRay| {
        let hit = ray.hit.as_ref().map(|hit| (hit.object.clone(), hit.front));
        (ray.kind, hit, ray.blocked_by.clone(), ray.children.len())
    };
    if end(this) != end(other) {
        return Some([this, other]);
    }
    let pairs = this.children.iter().zip(&other.children);
    pairs.map(|(this, other)| first_parting(this, other)).find(Option::is_some).flatten()
}

/// Shows the numbers of a ray of the tree that is shown and of its counterpart. `of` says whether that tree is ours, and the
/// name of the other picture.
pub fn show(
    ui: &mut Ui,
    [this, other]: [&RecordedRay; 2],
    number: usize,
    (is_ours, name): (bool, &str),
) {
    let in_order = |[a, b]: [&RecordedRay; 2]| {
        if is_ours { [a.line(), b.line()] } else { [b.line(), a.line()] }
    };
    match first_parting(this, other) {
        None => drop(ui.weak("Both trees have the same rays: only their numbers differ.")),
        Some(rays) => {
            let [ours, theirs] = in_order(rays);
            ui.strong("The trees part first at these rays:");
            ui.label(format!("ours: {ours}"));
            ui.label(format!("{name}: {theirs}"));
        }
    }
    ui.add_space(4.0);
    let selected = this.path_to(number).last().copied().unwrap_or(this);
    let Some(counterpart) = counterpart(this, selected.number, other) else {
        ui.label("The other tree has no ray in the place of the selected one.");
        return;
    };
    let rows = details::rows(selected, counterpart);
    let grid = Grid::new("beside").num_columns(3).striped(true).min_row_height(16.0);
    grid.spacing([10.0, 1.0]).show(ui, |ui| {
        ui.label("");
        ui.strong("ours");
        ui.strong(name);
        ui.end_row();
        for (field, values) in rows {
            let [this, other] = values;
            let differs = this != other;
            let in_order = if is_ours { [this, other] } else { [other, this] };
            ui.label(field);
            for value in in_order {
                let text = RichText::new(shortened(&value)).monospace().size(11.5);
                ui.label(if differs { text.strong() } else { text.weak() }).on_hover_text(value);
            }
            ui.end_row();
        }
    });
}
