//! Everything that is known of one ray.

use eframe::egui::{Grid, RichText, Ui};
use groundtruth::explain::{RayExplanation, short};
use groundtruth::rgb::Rgb;

use crate::tree::kind_color;

/// Numbers with every digit they have.
pub fn exact(numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers;
    format!("({x:?}, {y:?}, {z:?})")
}

/// Shows all fields of a ray and of what it hit.
pub fn show(ui: &mut Ui, ray: &RayExplanation) {
    ui.label(RichText::new(ray.line()).color(kind_color(ray)).strong());
    if !ray.terms.is_empty() {
        ui.add_space(4.0);
        terms(ui, ray);
    }
    ui.add_space(6.0);
    ui.strong("all its numbers");
    let grid = Grid::new("ray").num_columns(2).striped(true).min_row_height(16.0);
    grid.spacing([10.0, 1.0]).show(ui, |ui| fields(ui, ray));
}

fn fields(ui: &mut Ui, ray: &RayExplanation) {
    let color = |color: Rgb| exact(color.to_array());
    row(
        ui,
        "kind",
        match &ray.light {
            Some(light) => format!("{}, to light \"{light}\"", ray.kind),
            None => format!("{}, depth {}", ray.kind, ray.depth),
        },
    );
    row(
        ui,
        "outcome",
        match &ray.blocked_by {
            Some(object) => format!("{} by \"{object}\"", ray.outcome),
            None => ray.outcome.to_owned(),
        },
    );
    row(ui, "origin", exact(ray.origin));
    row(ui, "direction", exact(ray.direction));
    if let Some(hit) = &ray.hit {
        row(ui, "hits", format!("\"{}\", material \"{}\"", hit.object, hit.material));
        row(ui, "side", if hit.front { "front" } else { "back" }.to_owned());
        row(ui, "t", format!("{:?}", hit.t));
        row(ui, "point", exact(hit.point));
        row(ui, "error at most", format!("{:?}", hit.error));
        row(ui, "normal", exact(hit.normal));
        let same = hit.shading_normal == hit.normal;
        let shading = if same { "the normal".to_owned() } else { exact(hit.shading_normal) };
        row(ui, "shading normal", shading);
    }
    row(ui, "weight", color(ray.weight));
    row(ui, "transmittance", color(ray.transmittance));
    row(ui, "radiance", color(ray.radiance));
    row(ui, "contributes", color(ray.contribution));
}

fn row(ui: &mut Ui, name: &str, value: String) {
    ui.label(name);
    ui.label(RichText::new(value).monospace().size(11.5));
    ui.end_row();
}

/// The sum that is the ray's radiance.
fn terms(ui: &mut Ui, ray: &RayExplanation) {
    ui.strong("radiance = transmittance × the sum of these terms");
    let grid = Grid::new("terms").num_columns(4).striped(true).min_row_height(16.0);
    grid.spacing([14.0, 1.0]).show(ui, |ui| {
        for title in ["", "of", "adds", "weight"] {
            ui.weak(title);
        }
        ui.end_row();
        for term in &ray.terms {
            ui.label(&term.what);
            ui.label(match term.child {
                Some(child) => format!("ray {}", child + 1),
                None => "the light here".to_owned(),
            });
            for color in [term.value, term.weight] {
                ui.label(RichText::new(short(color)).monospace().size(11.5));
            }
            ui.end_row();
        }
    });
}
