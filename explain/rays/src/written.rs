//! Our own explanation of a pixel as a log, so that whoever has never seen one opens one of ours first.

use explain::{PixelExplanation, RecordedRay, RecordedTerm};
use groundtruth::lobes::Lobe;
use groundtruth::math::Vector;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayKind, TermSource};
use serde_json::{Map, Value, json};

/// The rays of the explained samples as a log: what the command line calls the scene, the size of its picture, and the program's
/// mistake, if it has one.
///
/// A medium's transmittance stands in the weight of the ray that passes it: `radiance` is what leaves the surface.
pub fn log_of(
    explanation: &PixelExplanation,
    (scene, size): (&str, [u32; 2]),
    mistake: Option<&str>,
) -> String {
    let program = mistake.map_or(String::new(), |mistake| format!(" with the mistake {mistake}"));
    let program = format!("groundtruth{program}");
    let head = json!({
        "rays": 1, "program": program, "precision": "double", "scene": scene, "size": size,
    });
    let mut text = format!("{head}\n");
    for sample in &explanation.samples {
        let rays = sample.ray.iter().flat_map(|root| with_senders(root, None));
        for (ray, sender) in rays {
            let mut line = fields(ray, sender);
            line.insert("pixel".to_owned(), json!(explanation.pixel));
            line.insert("sample".to_owned(), json!(sample.index));
            text += &format!("{}\n", Value::Object(line));
        }
    }
    text
}

/// A ray and all after it, each with the ray that sent it.
fn with_senders<'a>(
    ray: &'a RecordedRay,
    sender: Option<&'a RecordedRay>,
) -> Vec<(&'a RecordedRay, Option<&'a RecordedRay>)> {
    let mut rays = vec![(ray, sender)];
    // a ray beyond the largest depth is never cast
    let cast = ray.children.iter().filter(|child| child.is_cast());
    rays.extend(cast.flat_map(|child| with_senders(child, Some(ray))));
    rays
}

fn fields(ray: &RecordedRay, sender: Option<&RecordedRay>) -> Map<String, Value> {
    let terms = || sender.into_iter().flat_map(|it| terms_of(it, ray));
    // the way to a point lamp is the direction itself
    let is_way = ray.light.is_some() && (ray.ray.direction.length() - 1.0).abs() > 1e-9;
    let hit = ray.hit.as_ref();
    let shading = hit.filter(|hit| hit.shading_normal != hit.normal);
    let media = media(sender).filter(|_| ray.kind == RayKind::Transmitted);
    let blocked_by = ray.blocked_by.as_ref();
    let is_blocked = matches!(ray.outcome, Outcome::Blocked { .. });
    let line = json!({
        "ray": ray.number,
        "parent": sender.map(|sender| sender.number),
        "kind": kind(ray, terms().next()),
        "origin": ray.ray.origin.to_array(),
        "direction": ray.ray.direction.to_array(),
        "light": ray.light,
        "end": is_way.then_some(1),
        "t": hit.map(|hit| hit.t),
        "point": hit.map(|hit| hit.point.to_array()),
        "object": hit.map(|hit| &hit.object).or(blocked_by.filter(|_| is_blocked)),
        "normal": hit.map(|hit| Vector::from(hit.normal).to_array()),
        "shading_normal": shading.map(|hit| Vector::from(hit.shading_normal).to_array()),
        "front": hit.map(|hit| hit.front),
        "weight": sender.map(|sender| weight(sender, ray).to_array()),
        "eta_from": media.map(|media| media[0]),
        "eta_to": media.map(|media| media[1]),
    });
    let parts = [line, factors(terms().next()), light(ray)];
    let fields = parts.into_iter().filter_map(|part| match part {
        Value::Object(fields) => Some(fields),
        _ => None,
    });
    fields.flatten().filter(|(_, value)| !value.is_null()).collect()
}

/// The terms of a ray whose light comes along one that it sent.
pub fn terms_of<'a>(
    sender: &'a RecordedRay,
    ray: &RecordedRay,
) -> impl Iterator<Item = &'a RecordedTerm> {
    let number = ray.number;
    sender.terms.iter().filter(move |term| term.ray == Some(number))
}

/// What the light that leaves a ray's hit is multiplied by in its sender.
pub fn weight(sender: &RecordedRay, ray: &RecordedRay) -> Rgb {
    terms_of(sender, ray).map(|term| term.weight).sum::<Rgb>() * ray.transmittance
}

/// The light that leaves the hit of a ray towards its origin.
pub fn leaving(ray: &RecordedRay) -> Rgb {
    sum(ray, |_| true)
}

/// The indices of refraction on both sides of the surface that a ray met, its own side first.
pub fn media(sender: Option<&RecordedRay>) -> Option<[f64; 2]> {
    let optics = sender?.hit.as_ref()?.optics.as_ref()?;
    optics.media.map(|media| media.map(|medium| medium.eta))
}

/// What is emitted, what is added without a ray, and what leaves the surface in all.
fn light(ray: &RecordedRay) -> Value {
    let radiance = leaving(ray).to_array();
    if ray.is_shadow() {
        return json!({"radiance": radiance});
    }
    let is_emitted = |term: &RecordedTerm| {
        matches!(term.source, TermSource::Emission { .. } | TermSource::Background { .. })
    };
    let emitted = sum(ray, |term| term.ray.is_none() && is_emitted(term));
    let local = sum(ray, |term| term.ray.is_none() && !is_emitted(term));
    let lit = ray.children.iter().filter(|child| child.is_shadow());
    let by_ray =
        lit.flat_map(|child| ray.terms.iter().filter(move |term| term.ray == Some(child.number)));
    let direct: Rgb = local + by_ray.map(|term| term.value).sum();
    json!({"emitted": emitted.to_array(), "direct": direct.to_array(), "radiance": radiance})
}

fn sum(ray: &RecordedRay, is_counted: impl Fn(&RecordedTerm) -> bool) -> Rgb {
    ray.terms.iter().filter(|term| is_counted(term)).map(|term| term.value).sum()
}

fn kind(ray: &RecordedRay, term: Option<&RecordedTerm>) -> &'static str {
    let lobe = term.and_then(|term| match &term.source {
        TermSource::Traced { lobe, .. } => Some(lobe),
        _ => None,
    });
    match (ray.kind, lobe) {
        (RayKind::Camera, _) => "camera",
        (RayKind::Shadow { .. }, _) => "shadow",
        (RayKind::Transmitted, _) => "transmitted",
        (RayKind::Reflected, Some(Lobe::Lambertian(_))) => "diffuse",
        (RayKind::Reflected, Some(Lobe::GlossySpecular(_) | Lobe::GlossyReflection(_))) => "glossy",
        (RayKind::Reflected, _) => "reflected",
    }
}

fn factors(term: Option<&RecordedTerm>) -> Value {
    match term.map(|term| &term.source) {
        Some(TermSource::Traced { pdf, lobe_probability, survival, .. }) => {
            let choice = lobe_probability * survival;
            json!({"pdf": pdf, "choice": (choice != 1.0).then_some(choice)})
        }
        // one ray may serve several lobes: then the factors are those of the first, and only the weight is of all
        Some(TermSource::Direct { f, cos_i, pdf, mis, .. }) => {
            let f = f.to_array();
            json!({"cos": cos_i, "pdf": pdf, "mis": mis, "values": {"f_of_first_lobe": f}})
        }
        _ => Value::Null,
    }
}
