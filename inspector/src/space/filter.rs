//! Which rays of a tree are drawn in space.

use eframe::egui::{DragValue, RichText, Slider, Ui};
use groundtruth::explain::{RecordedRay, percent};
use groundtruth::trace::{Outcome, RayKind, TermSource};

use crate::explanation::tree::{KINDS, ink};

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
        let (max_depth, min_share) = (u32::MAX, 0.0);
        Self { kinds: [true; 5], max_depth, min_share, light: None, lobe: None, normals: true }
    }
}

/// The place of a ray's kind in the filter.
fn kind(ray: &RecordedRay) -> usize {
    match ray.kind {
        RayKind::Camera => 0,
        RayKind::Reflected => 1,
        RayKind::Transmitted => 2,
        RayKind::Shadow { .. } if matches!(ray.outcome, Outcome::Blocked { .. }) => 4,
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
    /// The numbers of the rays of a tree that are drawn, ascending.
    pub fn drawn(&self, root: &RecordedRay) -> Vec<usize> {
        let mut drawn = Vec::new();
        self.add(None, root, &mut drawn);
        drawn
    }

    fn add(&self, parent: Option<&RecordedRay>, ray: &RecordedRay, drawn: &mut Vec<usize>) {
        let lights = self.light.as_deref().zip(ray.light.as_deref());
        let of_light = lights.is_none_or(|(wanted, light)| wanted == light);
        let lobes = self.lobe.zip(lobe(parent, ray));
        let of_lobe = lobes.is_none_or(|(wanted, lobe)| wanted == lobe);
        let is_large = ray.share >= self.min_share && ray.depth <= self.max_depth;
        if self.kinds[kind(ray)] && is_large && of_light && of_lobe {
            drawn.push(ray.number);
        }
        for child in &ray.children {
            self.add(Some(ray), child, drawn);
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
            *self = Self::default();
        }
    }
}
