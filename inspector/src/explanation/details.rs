//! The details of one ray.

use eframe::egui::{Grid, RichText, Ui};
use groundtruth::explain::{
    RecordedHit, RecordedRay, UnlitLight, brief, lines, percent, quoted, short, unblocked,
};
use groundtruth::printable::name;
use groundtruth::rgb::Rgb;
use groundtruth::textures::Texel;
use groundtruth::trace::{Optics, Outcome, RayKind, RecordedTexture};
use text::digits::shortened;

use crate::explanation::tree::{ink, kind_color};

/// The columns of the terms, with what they are.
const TERM_TITLES: [(&str, &str); 4] = [
    ("radiance", "What the term adds to the radiance of this ray"),
    (
        "BRDF, light",
        "The BRDF or BTDF that scatters the light (a lobe of the material), and the light it is from",
    ),
    ("ray", "The ray along which the light arrives"),
    ("factors", "The product that is the term"),
];

/// Numbers with all their digits.
pub fn exact(numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers;
    format!("({x:?}, {y:?}, {z:?})")
}

/// Shows the line of a ray.
pub fn head(ui: &mut Ui, ray: &RecordedRay) {
    ui.label(RichText::new(ray.line()).color(ink(ui, kind_color(ray))).strong());
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
    table(ui, "ray", fields(ray));
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
    let color = |color: Rgb| exact(color.to_array());
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
    let mut fields = vec![("kind", kind), ("outcome", outcome)];
    fields.push(("origin", exact(ray.ray.origin.into())));
    fields.push(("direction", exact(ray.ray.direction.into())));
    if let Some(hit) = &ray.hit {
        fields.extend(hit_fields(hit));
    }
    fields.push(("weight", color(ray.weight)));
    fields.push(("transmittance", color(ray.transmittance)));
    fields.push(("radiance", color(ray.radiance)));
    fields.push(("contributes", color(ray.contribution)));
    fields.push(("share of the sample", percent(ray.share)));
    fields.extend(lines(&ray.unlit).into_iter().map(|line| ("adds nothing", line)));
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
    fields.extend(hit.optics.as_ref().map_or(Vec::new(), optics_fields));
    if hit.is_switched_off {
        fields.push(("shines", "no: its area light is switched off".to_owned()));
    }
    fields
}

fn texture_text(texture: &RecordedTexture) -> String {
    let color = format!("{} {}", texture.field, exact(texture.color.to_array()));
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
    if let Some(angle) = optics.critical_angle {
        fields.push(("critical angle", format!("{angle:?}°")));
    }
    let refraction = match optics.angle_of_refraction {
        Some(angle) => format!("{angle:?}°"),
        None => "none: total internal reflection".to_owned(),
    };
    fields.push(("angle of refraction", refraction));
    fields.push(("R, reflected", exact(optics.reflected.to_array())));
    fields.push(("T, transmitted", exact(optics.transmitted.to_array())));
    fields
}

fn table(ui: &mut Ui, id: &str, rows: Vec<(&'static str, String)>) {
    let grid = Grid::new(id).num_columns(2).striped(true).min_row_height(16.0);
    grid.spacing([10.0, 1.0]).show(ui, |ui| {
        for (name, value) in rows {
            ui.label(name);
            ui.label(RichText::new(shortened(&value)).monospace().size(11.5));
            ui.end_row();
        }
    });
}

/// Shows the sum that is the ray's radiance. Returns the number of a term's ray if it was clicked.
fn terms(ui: &mut Ui, ray: &RecordedRay, hovered: &mut Option<usize>) -> Option<usize> {
    ui.strong(match ray.transmittance == Rgb::WHITE {
        true => "radiance = the sum of these terms",
        false => "radiance = the sum of these terms × what the medium lets through",
    });
    let mut clicked = None;
    let grid = Grid::new("terms").num_columns(4).striped(true).min_row_height(16.0);
    grid.spacing([14.0, 1.0]).show(ui, |ui| {
        for (title, hint) in TERM_TITLES {
            ui.weak(title).on_hover_text(hint);
        }
        ui.end_row();
        for term in &ray.terms {
            ui.label(RichText::new(short(term.value)).monospace().size(11.5));
            ui.label(term.name());
            match term.ray {
                Some(number) => {
                    let link = ui.link(format!("ray {number}"));
                    if link.clicked() {
                        clicked = Some(number);
                    }
                    if link.hovered() {
                        *hovered = Some(number);
                    }
                }
                None => drop(ui.weak("no ray")),
            }
            ui.label(RichText::new(term.factors()).monospace().size(11.5));
            ui.end_row();
        }
        for UnlitLight { light, reason } in &ray.unlit {
            ui.label(RichText::new("0").monospace().size(11.5));
            ui.label(format!("light \"{}\"", name(light)));
            ui.weak("");
            ui.label(reason.to_string());
            ui.end_row();
        }
    });
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
