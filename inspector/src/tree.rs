//! The tree of rays: one line for each, coloured by what it is for.

use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::{Button, Color32, RichText, Sense, Stroke, StrokeKind, Ui, vec2};
use groundtruth::explain::RayExplanation;
use groundtruth::film::Tone;

use crate::picture;

/// Larger trees begin with their deeper branches closed.
const OPEN_RAYS: usize = 200;

/// The colour of a ray's line.
pub fn kind_color(ray: &RayExplanation) -> Color32 {
    match (ray.kind, ray.outcome) {
        ("camera", _) => Color32::from_rgb(235, 235, 235),
        ("reflected", _) => Color32::from_rgb(255, 160, 90),
        ("transmitted", _) => Color32::from_rgb(90, 205, 255),
        (_, "blocked") => Color32::from_rgb(165, 150, 185),
        _ => Color32::from_rgb(250, 225, 100),
    }
}

/// What the colours mean.
pub fn legend(ui: &mut Ui) {
    ui.horizontal_wrapped(|ui| {
        ui.weak("Rays:");
        for (name, color) in [
            ("camera", Color32::from_rgb(235, 235, 235)),
            ("reflected", Color32::from_rgb(255, 160, 90)),
            ("transmitted", Color32::from_rgb(90, 205, 255)),
            ("shadow, unblocked", Color32::from_rgb(250, 225, 100)),
            ("shadow, blocked", Color32::from_rgb(165, 150, 185)),
        ] {
            ui.label(RichText::new(name).color(color));
        }
    });
}

/// The ray at the end of a path of children.
pub fn find<'a>(root: &'a RayExplanation, path: &[usize]) -> Option<&'a RayExplanation> {
    path.iter().try_fold(root, |ray, &child| ray.children.get(child))
}

/// Rays in a tree.
pub fn count(ray: &RayExplanation) -> usize {
    1 + ray.children.iter().map(count).sum::<usize>()
}

/// Shows the tree; a click on a line puts its path into `selected`.
pub fn show(ui: &mut Ui, root: &RayExplanation, tone: &Tone, selected: &mut Vec<usize>) {
    ui.spacing_mut().item_spacing.y = 1.0;
    ui.spacing_mut().interact_size.y = 17.0;
    ui.spacing_mut().button_padding.x = 3.0;
    let all_open = count(root) <= OPEN_RAYS;
    branch(ui, root, &mut Vec::new(), &mut Look { tone, selected, all_open });
}

struct Look<'a> {
    tone: &'a Tone,
    selected: &'a mut Vec<usize>,
    all_open: bool,
}

fn branch(ui: &mut Ui, ray: &RayExplanation, path: &mut Vec<usize>, look: &mut Look<'_>) {
    if ray.children.is_empty() {
        ui.horizontal(|ui| {
            // as wide as the button that opens and closes
            ui.add_space(ui.spacing().indent + ui.spacing().item_spacing.x - 8.0);
            line(ui, ray, path, look);
        });
        return;
    }
    let id = ui.make_persistent_id(("ray", path.as_slice()));
    let open = look.all_open || path.len() < 3;
    CollapsingState::load_with_default_open(ui.ctx(), id, open)
        .show_header(ui, |ui| line(ui, ray, path, look))
        .body(|ui| {
            for (index, child) in ray.children.iter().enumerate() {
                path.push(index);
                branch(ui, child, path, look);
                path.pop();
            }
        });
}

fn line(ui: &mut Ui, ray: &RayExplanation, path: &[usize], look: &mut Look<'_>) {
    swatch(ui, picture::color(look.tone, ray.contribution));
    let chosen = look.selected.as_slice() == path;
    let text = RichText::new(ray.line()).color(kind_color(ray));
    if ui.add(Button::selectable(chosen, text)).clicked() {
        *look.selected = path.to_vec();
    }
}

/// A small square of a colour.
pub fn swatch(ui: &mut Ui, color: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(12.0, 12.0), Sense::hover());
    ui.painter().rect_filled(rect, 2.0, color);
    let edge = Stroke::new(1.0, Color32::from_gray(110));
    ui.painter().rect_stroke(rect, 2.0, edge, StrokeKind::Inside);
}
