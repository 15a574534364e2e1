//! Which rays of a tree are drawn in space.

use eframe::egui::{DragValue, RichText, Slider, Ui};
use explain::RecordedRay;
use text::brief::percent;

use crate::explanation::tree::{KINDS, OF_BLOCKED, kind};
use crate::picture::display::ink;
use crate::space::paint::numbered;

/// The share of its sample below which a ray is not drawn at first.
const MIN_SHARE: f64 = 0.005;

/// The rays that are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Filter {
    /// Camera, reflected, transmitted, unblocked and blocked shadow rays.
    kinds: [bool; 5],
    /// The largest depth.
    max_depth: u32,
    /// The least share of the sample.
    min_share: f64,
    /// Whether normals are drawn at hits.
    pub normals: bool,
}

impl Default for Filter {
    fn default() -> Self {
        Self { min_share: MIN_SHARE, ..Self::ALL }
    }
}

impl Filter {
    /// All rays.
    pub const ALL: Self =
        Self { kinds: [true; 5], max_depth: u32::MAX, min_share: 0.0, normals: true };

    /// The numbers of the rays of a tree that are drawn, ascending, and how many more have a smaller share. The path to the
    /// selected ray is drawn in any case, and so are blocked rays to lights: each shows why a light adds nothing.
    pub fn drawn(&self, root: &RecordedRay, selected: usize) -> (Vec<usize>, usize) {
        let (rays, path) = (root.rays(), root.path_to(selected));
        let (mut drawn, mut small) = (Vec::new(), 0);
        for ray in &rays {
            let sender = ray.parent.and_then(|parent| numbered(&rays, parent));
            let is_blocked =
                kind(ray) == OF_BLOCKED && sender.is_some_and(|it| it.share >= self.min_share);
            let is_large = ray.share >= self.min_share || is_blocked;
            let is_asked = self.kinds[kind(ray)] && ray.depth <= self.max_depth;
            if path.iter().any(|on_path| on_path.number == ray.number) || is_asked && is_large {
                drawn.push(ray.number);
            } else if is_asked {
                small += 1;
            }
        }
        (drawn, small)
    }

    /// Shows the filter for a tree.
    pub fn show(&mut self, ui: &mut Ui, root: &RecordedRay) {
        let deepest = root.rays().iter().map(|ray| ray.depth).max().unwrap_or(0);
        for (is_drawn, (name, color)) in self.kinds.iter_mut().zip(KINDS) {
            ui.checkbox(is_drawn, RichText::new(name).color(ink(ui.visuals(), color)));
        }
        ui.checkbox(&mut self.normals, "normals at hits");
        ui.separator();
        let mut depth = self.max_depth.min(deepest);
        ui.horizontal(|ui| {
            let label = ui.label("depth at most");
            let field = DragValue::new(&mut depth).range(0..=deepest);
            if ui.add(field).labelled_by(label.id).changed() {
                self.max_depth = depth;
            }
        });
        ui.horizontal(|ui| {
            let label = ui.label("share at least");
            let share = Slider::new(&mut self.min_share, 0.0..=0.5).logarithmic(true);
            let share = share.smallest_positive(1e-4).custom_formatter(|share, _| percent(share));
            ui.add(share).labelled_by(label.id);
        });
        ui.separator();
        if ui.button("All rays").clicked() {
            *self = Self::ALL;
        }
    }
}
