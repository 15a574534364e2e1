//! Which rays of a tree are drawn in space.

use eframe::egui::{DragValue, RichText, Slider, Ui};
use groundtruth::explain::{RecordedRay, percent};
use groundtruth::trace::{Outcome, RayKind, TermSource};

use crate::explanation::tree::KINDS;
use crate::picture::display::ink;

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
    /// The light of shadow rays; all if `None`.
    light: Option<String>,
    /// The lobe that sent a ray; all if `None`.
    lobe: Option<&'static str>,
    /// Whether normals are drawn at hits.
    pub normals: bool,
}

impl Default for Filter {
    fn default() -> Self {
        Self { min_share: MIN_SHARE, ..Self::ALL }
    }
}

/// The place of blocked shadow rays in the filter.
const BLOCKED: usize = 4;

/// The place of a ray's kind in the filter.
fn kind(ray: &RecordedRay) -> usize {
    match ray.kind {
        RayKind::Camera => 0,
        RayKind::Reflected => 1,
        RayKind::Transmitted => 2,
        RayKind::Shadow { .. } if matches!(ray.outcome, Outcome::Blocked { .. }) => BLOCKED,
        RayKind::Shadow { .. } => 3,
    }
}

/// The lobe of the ray before it that sent a ray.
fn lobe(parent: Option<&RecordedRay>, ray: &RecordedRay) -> Option<&'static str> {
    let term = parent?.terms.iter().find(|term| term.ray == Some(ray.number))?;
    match &term.source {
        TermSource::Traced { lobe, .. } => Some(lobe.name()),
        _ => None,
    }
}

/// The choices for a tree: its depth, its lights and its lobes.
struct Choices {
    depth: u32,
    lights: Vec<String>,
    lobes: Vec<&'static str>,
}

impl Choices {
    fn of(root: &RecordedRay) -> Self {
        let mut choices = Self { depth: 0, lights: Vec::new(), lobes: Vec::new() };
        choices.add(None, root);
        choices
    }

    fn add(&mut self, parent: Option<&RecordedRay>, ray: &RecordedRay) {
        self.depth = self.depth.max(ray.depth);
        if let Some(light) = &ray.light
            && !self.lights.iter().any(|known| **known == **light)
        {
            self.lights.push(light.to_string());
        }
        if let Some(lobe) = lobe(parent, ray)
            && !self.lobes.contains(&lobe)
        {
            self.lobes.push(lobe);
        }
        for child in &ray.children {
            self.add(Some(ray), child);
        }
    }
}

impl Filter {
    /// All rays.
    pub const ALL: Self = Self {
        kinds: [true; 5],
        max_depth: u32::MAX,
        min_share: 0.0,
        light: None,
        lobe: None,
        normals: true,
    };

    /// The numbers of the rays of a tree that are drawn, ascending, and how many more have a smaller share. The path to the
    /// selected ray is drawn in any case, and so are blocked rays to lights: each shows why a light adds nothing.
    pub fn drawn(&self, root: &RecordedRay, selected: usize) -> (Vec<usize>, usize) {
        let (mut drawn, mut small) = (Vec::new(), 0);
        let path: Vec<usize> = root.path_to(selected).iter().map(|ray| ray.number).collect();
        self.add(None, root, &path, &mut drawn, &mut small);
        (drawn, small)
    }

    fn add(
        &self,
        parent: Option<&RecordedRay>,
        ray: &RecordedRay,
        path: &[usize],
        drawn: &mut Vec<usize>,
        small: &mut usize,
    ) {
        let lights = self.light.as_deref().zip(ray.light.as_deref());
        let of_light = lights.is_none_or(|(wanted, light)| wanted == light);
        let lobes = self.lobe.zip(lobe(parent, ray));
        let of_lobe = lobes.is_none_or(|(wanted, lobe)| wanted == lobe);
        let is_blocked =
            kind(ray) == BLOCKED && parent.is_some_and(|it| it.share >= self.min_share);
        let is_large = ray.share >= self.min_share || is_blocked;
        let is_asked = self.kinds[kind(ray)] && of_light && of_lobe && ray.depth <= self.max_depth;
        if path.contains(&ray.number) || is_asked && is_large {
            drawn.push(ray.number);
        } else if is_asked {
            *small += 1;
        }
        for child in &ray.children {
            self.add(Some(ray), child, path, drawn, small);
        }
    }

    /// Shows the filter for a tree.
    pub fn show(&mut self, ui: &mut Ui, root: &RecordedRay) {
        let choices = Choices::of(root);
        for (is_drawn, (name, color)) in self.kinds.iter_mut().zip(KINDS) {
            ui.checkbox(is_drawn, RichText::new(name).color(ink(ui, color)));
        }
        ui.checkbox(&mut self.normals, "normals at hits");
        ui.separator();
        let mut depth = self.max_depth.min(choices.depth);
        ui.horizontal(|ui| {
            let label = ui.label("depth at most");
            let field = DragValue::new(&mut depth).range(0..=choices.depth);
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
        ui.radio_value(&mut self.light, None, "shadow rays to all lights");
        for light in choices.lights {
            let name = format!("to \"{}\" only", groundtruth::printable::name(&light));
            ui.radio_value(&mut self.light, Some(light), name);
        }
        ui.separator();
        ui.radio_value(&mut self.lobe, None, "rays of all lobes");
        for lobe in choices.lobes {
            ui.radio_value(&mut self.lobe, Some(lobe), format!("of {lobe} only"));
        }
        ui.separator();
        if ui.button("All rays").clicked() {
            *self = Self::ALL;
        }
    }
}
