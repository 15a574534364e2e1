//! What the laws of rays found in a log: the tab *Checks*, and what is said of one ray.

use eframe::egui::{CollapsingHeader, Grid, Painter, RichText, Stroke, StrokeKind, Ui};
use groundtruth::printable;
use rays::{LawReport, Logged, Outcome, RayLaw, RayPlace};
use text::brief::count;
use text::digits::shortened;

use crate::explanation::tree::{BROKEN, LOCAL};
use crate::picture::view::Placement;

/// The side of the frame around a pixel whose rays are in a log, in points of the screen, and the most of them.
const MARK: f32 = 7.0;
const MAX_MARKED: usize = 4000;
/// The most rays of a law that are listed.
const MAX_LISTED: usize = 200;

/// Shows the sentence and the laws. Returns where the ray stands that was clicked.
pub fn show(ui: &mut Ui, log: &Logged) -> Option<RayPlace> {
    let verdict = &log.verdict;
    let mut clicked = None;
    let sentence = RichText::new(printable::text(&verdict.sentence())).strong();
    ui.label(if verdict.is_broken() {
        sentence.color(ui.visuals().error_fg_color)
    } else {
        sentence
    });
    for remark in verdict.remarks() {
        ui.weak(printable::text(&remark));
    }
    let lists = [
        (Outcome::Broken, "Broken"),
        (Outcome::Held, "Held"),
        (Outcome::NotAsked, "Not asked: each needs further fields of the log"),
    ];
    for (outcome, title) in lists {
        let laws: Vec<_> = verdict.of_outcome(outcome).collect();
        if laws.is_empty() {
            continue;
        }
        ui.add_space(6.0);
        ui.strong(title);
        for (law, asked) in laws {
            match outcome {
                Outcome::Broken => clicked = broken(ui, log, law, asked).or(clicked),
                Outcome::Held => {
                    let rays = count(asked.rays, "ray");
                    ui.label(format!("{}: {}", law.name, rays)).on_hover_text(law.says);
                }
                Outcome::NotAsked => {
                    let needs = verdict.missing(law).join(", ");
                    ui.weak(format!("{}: needs {needs}", law.name)).on_hover_text(law.says);
                }
            }
        }
    }
    clicked
}

/// Shows a broken law with the rays that break it.
fn broken(ui: &mut Ui, log: &Logged, law: &RayLaw, asked: &LawReport) -> Option<RayPlace> {
    let title = format!("× {}: {} of {}", law.name, asked.findings.len(), count(asked.rays, "ray"));
    let title = RichText::new(title).color(ui.visuals().error_fg_color);
    let header = CollapsingHeader::new(title).id_salt(law.name).default_open(true);
    let mut clicked = None;
    header.show(ui, |ui| {
        ui.label(law.says);
        if let Some(cause) = law.cause(asked.roots()) {
            ui.strong(cause);
        }
        for note in &asked.notes {
            ui.weak(printable::text(note));
        }
        for finding in asked.findings.iter().take(MAX_LISTED) {
            let traced = &log.verdict.traced;
            let at = traced.ray(finding.ray);
            let sample =
                if at.sample > 0 { format!("sample {}, ", at.sample) } else { String::new() };
            let pixel = at.pixel.map_or(String::new(), |[x, y]| format!("({x}, {y}), "));
            let line = format!("{pixel}{sample}{}", traced.name(finding.ray));
            ui.horizontal_wrapped(|ui| {
                if ui.link(printable::text(&line)).clicked() {
                    clicked = Some(log.place(finding.ray));
                }
                ui.label(printable::text(&finding.words));
            });
        }
        let more = asked.findings.len().saturating_sub(MAX_LISTED);
        if more > 0 {
            ui.weak(format!("… and {}", count(more, "more ray")));
        }
    });
    clicked
}

/// Shows what the laws found of a ray of this index in the log, and all that its line says.
pub fn ray(ui: &mut Ui, log: &Logged, index: usize) {
    let verdict = &log.verdict;
    for (law, finding) in verdict.of_ray(index) {
        let text = format!("× {}", printable::text(&finding.words));
        ui.label(RichText::new(text).strong().color(ui.visuals().error_fg_color));
        ui.label(format!("{}: {}", law.name, law.says));
        let cause = verdict.report(law).and_then(|asked| law.cause(asked.roots()));
        cause.into_iter().for_each(|cause| drop(ui.label(cause)));
        if let Some(from) = finding.follows.filter(|&from| from != index) {
            ui.weak(format!("follows from {}", printable::text(&verdict.traced.name(from))));
        }
    }
    ui.add_space(4.0);
    let line = verdict.traced.ray(index).line;
    ui.strong(format!("line {line} of the log"));
    let grid = Grid::new("line").num_columns(2).striped(true).min_row_height(16.0);
    grid.spacing([10.0, 1.0]).show(ui, |ui| {
        for (name, value) in verdict.traced.ray(index).fields() {
            ui.label(name);
            let short = RichText::new(shortened(&value)).monospace().size(11.5);
            ui.label(short).on_hover_text(value);
            ui.end_row();
        }
    });
}

/// Frames the pixels whose rays are in the log, those with a broken law in the colour of errors over the others.
pub fn mark_pixels(painter: &Painter, placement: &Placement, log: &Logged) {
    if log.pixels().count() > MAX_MARKED {
        return;
    }
    for (wanted, color) in [(false, LOCAL), (true, BROKEN)] {
        for (pixel, _) in log.pixels().filter(|(_, is_broken)| *is_broken == wanted) {
            let area = placement.rect(pixel);
            let grown = area.expand((0.5 * (MARK - area.width())).max(1.0));
            painter.rect_stroke(grown, 0.0, Stroke::new(1.5, color), StrokeKind::Outside);
        }
    }
}
