//! The details of one ray.

use eframe::egui::{CollapsingHeader, Grid, Label, RichText, Ui};
use explain::{Optics, RecordedHit, RecordedRay, RecordedTexture, lines, quoted, unblocked};
use groundtruth::printable::name;
use groundtruth::rgb::Rgb;
use groundtruth::textures::Texel;
use groundtruth::trace::{Outcome, RayKind};
use text::brief::{brief, percent, short};
use text::digits::{exact, exact_color, shortened};

use crate::explanation::tree::kind_color;
use crate::picture::display::ink;

/// The field of a light that adds nothing.
pub const UNLIT: &str = "adds nothing";

/// What value, name, ray and factors of a term are.
const TERM_HINTS: [&str; 4] = [
    "What the term adds to the radiance of this ray",
    "The BRDF or BTDF that scatters the light (a lobe of the material), and the light it is from",
    "The ray along which the light arrives",
    "The product that is the term",
];

/// Shows the line of a ray.
pub fn head(ui: &mut Ui, ray: &RecordedRay) {
    ui.label(RichText::new(ray.line()).color(ink(ui.visuals(), kind_color(ray))).strong());
}

/// Shows all fields of a ray and of its hit. Returns the number of another ray if it was clicked, and notes the one that
/// is pointed at.
pub fn show(ui: &mut Ui, ray: &RecordedRay, hovered: &mut Option<usize>) -> Option<usize> {
    let mut clicked = None;
    if !(ray.terms.is_empty() && ray.unlit.is_empty()) {
        ui.add_space(4.0);
        clicked = terms(ui, ray, hovered);
    }
    formulas(ui, ray);
    if let Some(zeros) = &ray.black {
        ui.add_space(4.0);
        ui.label(format!("black: {zeros}"));
    }
    ui.add_space(6.0);
    ui.strong("its numbers").on_hover_text("With four digits; Copy has all of them");
    // why lights add nothing stands above
    let mut fields = fields(ray);
    fields.retain(|(name, _)| *name != UNLIT);
    table(ui, "ray", fields);
    ui.add_space(8.0);
    clicked
}

/// The names and numbers of a ray, as text to be copied.
pub fn text(ray: &RecordedRay) -> String {
    let line = |(name, value): (&str, String)| format!("{name}\t{value}\n");
    ray.line() + "\n" + &fields(ray).into_iter().map(line).collect::<String>()
}

/// The fields of two rays, one beside the other; those that only one has are empty for the other.
pub fn rows(this: &RecordedRay, other: &RecordedRay) -> Vec<(&'static str, [String; 2])> {
    let mut others = fields(other);
    let mut rows = Vec::new();
    for (name, value) in fields(this) {
        let at = others.iter().position(|(field, _)| *field == name);
        let theirs = at.map_or(String::new(), |at| others.remove(at).1);
        rows.push((name, [value, theirs]));
    }
    rows.extend(others.into_iter().map(|(name, value)| (name, [String::new(), value])));
    rows
}

/// The names and values of a ray's fields, without its terms.
fn fields(ray: &RecordedRay) -> Vec<(&'static str, String)> {
    let kind = match &ray.kind {
        RayKind::Camera => format!("camera, depth {}", ray.depth),
        RayKind::Reflected => format!("reflected, depth {}", ray.depth),
        RayKind::Transmitted => format!("transmitted, depth {}", ray.depth),
        RayKind::Shadow { .. } => format!("shadow, to light {}", quoted(&ray.light)),
    };
    let outcome = match &ray.outcome {
        Outcome::Hit => "hit".to_owned(),
        Outcome::Background => "background".to_owned(),
        Outcome::TooDeep => "too deep".to_owned(),
        Outcome::Unblocked { boundaries } => unblocked(*boundaries),
        Outcome::OverBudget => "beyond the limit on the number of rays".to_owned(),
        Outcome::Blocked { .. } => format!("blocked by {}", quoted(&ray.blocked_by)),
    };
    let mut fields = vec![
        ("kind", kind),
        ("outcome", outcome),
        ("origin", exact(ray.ray.origin.into())),
        ("direction", exact(ray.ray.direction.into())),
    ];
    fields.extend(ray.hit.iter().flat_map(hit_fields));
    fields.extend([
        ("weight", exact_color(ray.weight)),
        ("transmittance", exact_color(ray.transmittance)),
        ("radiance", exact_color(ray.radiance)),
        ("contributes", exact_color(ray.contribution)),
        ("share of the sample", percent(ray.share)),
    ]);
    if !ray.unlit.is_empty() {
        fields.push((UNLIT, lines(&ray.unlit).join("; ")));
    }
    fields.extend(ray.black.iter().map(|zeros| ("black", zeros.clone())));
    fields
}

fn hit_fields(hit: &RecordedHit) -> Vec<(&'static str, String)> {
    let same = hit.shading_normal == hit.normal;
    let shading = if same { "the normal".to_owned() } else { exact(hit.shading_normal.into()) };
    let mut fields =
        vec![("hits", format!("\"{}\", material \"{}\"", name(&hit.object), name(&hit.material)))];
    if !hit.path.is_empty() {
        fields.push(("part", hit.path.to_string()));
    }
    fields.extend([
        ("side", if hit.front { "front" } else { "back" }.to_owned()),
        ("t", format!("{:?}", hit.t)),
        ("point", exact(hit.point.into())),
        ("error at most", format!("{:?}", hit.error)),
        ("normal", exact(hit.normal.into())),
        ("shading normal", shading),
        ("angle of incidence", format!("{:?}°", hit.angle_of_incidence)),
    ]);
    fields.extend(hit.textures.iter().map(|texture| ("texture", texture_text(texture))));
    fields.extend(hit.optics.iter().flat_map(optics_fields));
    if hit.is_switched_off {
        fields.push(("shines", "no: its area light is switched off".to_owned()));
    }
    fields
}

fn texture_text(texture: &RecordedTexture) -> String {
    let color = format!("{} {}", texture.field, exact_color(texture.color));
    match texture.texel {
        Some(Texel { uv: [u, v], column, row }) => {
            format!("{color}, texel ({column}, {row}) at u {u:?}, v {v:?}")
        }
        None => color,
    }
}

fn optics_fields(optics: &Optics) -> Vec<(&'static str, String)> {
    let mut fields = Vec::new();
    if let Some([front, behind]) = optics.media {
        for (name, medium) in [("medium in front", front), ("medium behind", behind)] {
            let (eta, sigma) = (brief(medium.eta), short(medium.absorption));
            fields.push((name, format!("η {eta}, absorption {sigma}")));
        }
    }
    fields.push(("relative η", format!("{:?}", optics.eta)));
    let degrees = |angle: f64| format!("{angle:?}°");
    fields.extend(optics.critical_angle.map(|angle| ("critical angle", degrees(angle))));
    let none = "none: total internal reflection".to_owned();
    fields.extend([
        ("angle of refraction", optics.angle_of_refraction.map_or(none, degrees)),
        ("R, reflected", exact_color(optics.reflected)),
        ("T, transmitted", exact_color(optics.transmitted)),
    ]);
    fields
}

fn table(ui: &mut Ui, id: &str, rows: Vec<(&'static str, String)>) {
    let grid = Grid::new(id).num_columns(2).striped(true).min_row_height(16.0);
    grid.spacing([10.0, 1.0]).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(name);
            ui.add(Label::new(RichText::new(shortened(&value)).monospace().size(11.5)).wrap());
            ui.end_row();
        }
    });
}

/// Shows the sum that is the ray's radiance, and why lights add nothing to it. Returns the number of a term's ray if it was
/// clicked.
fn terms(ui: &mut Ui, ray: &RecordedRay, hovered: &mut Option<usize>) -> Option<usize> {
    if !ray.terms.is_empty() {
        ui.strong(match ray.transmittance == Rgb::WHITE {
            true => "radiance = the sum of these terms",
            false => "radiance = the sum of these terms × what the medium lets through",
        });
    }
    let mut clicked = None;
    let small = |text: String| Label::new(RichText::new(text).monospace().size(11.5));
    let [of_value, of_name, of_ray, of_factors] = TERM_HINTS;
    for term in &ray.terms {
        ui.horizontal_wrapped(|ui| {
            ui.add(small(format!("+ {}", short(term.value)))).on_hover_text(of_value);
            ui.label(term.name()).on_hover_text(of_name);
            match term.ray {
                Some(number) => {
                    let link = ui.link(format!("ray {number}")).on_hover_text(of_ray);
                    clicked = clicked.or(link.clicked().then_some(number));
                    *hovered = hovered.or(link.hovered().then_some(number));
                }
                None => drop(ui.weak("no ray")),
            }
            ui.add(small(term.factors())).on_hover_text(of_factors);
        });
    }
    let reasons = |ui: &mut Ui| lines(&ray.unlit).into_iter().for_each(|it| drop(ui.label(it)));
    match ray.unlit.len() {
        0 => {}
        1 => drop(ui.label(format!("0 from {}", lines(&ray.unlit).concat()))),
        many => {
            let name = format!("{many} lights add nothing");
            CollapsingHeader::new(name).id_salt("unlit").show(ui, reasons);
        }
    }
    clicked
}

/// Shows the formula of each term that is not 0 in the book's letters, with this hit's numbers.
fn formulas(ui: &mut Ui, ray: &RecordedRay) {
    let shown: Vec<_> = ray.terms.iter().filter(|term| !term.value.is_black()).collect();
    if shown.is_empty() {
        return;
    }
    ui.add_space(4.0);
    ui.strong("in the book's letters");
    for term in shown {
        let formula = ray.formula(term);
        let text = format!("{} = {}", formula.symbols(), formula.numbers());
        ui.label(RichText::new(shortened(&text)).monospace().size(11.5)).on_hover_text(text);
        ui.weak(format!("{}: {}, {}", term.name(), formula.place, formula.source));
    }
}
