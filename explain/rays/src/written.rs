//! Our own explanation of a pixel as a log, so that whoever has never seen one opens one of ours first.

use groundtruth::explain::{PixelExplanation, RecordedRay, RecordedTerm};
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
    let cast = ray
        .children
        .iter()
        .filter(|child| !matches!(child.outcome, Outcome::TooDeep | Outcome::OverBudget));
    rays.extend(cast.flat_map(|child| with_senders(child, Some(ray))));
    rays
}

fn fields(ray: &RecordedRay, sender: Option<&RecordedRay>) -> Map<String, Value> {
    let term =
        sender.and_then(|sender| sender.terms.iter().find(|term| term.ray == Some(ray.number)));
    let mut line = Map::new();
    let mut put = |name: &str, value: Value| drop(line.insert(name.to_owned(), value));
    put("ray", json!(ray.number));
    if let Some(sender) = sender {
        put("parent", json!(sender.number));
    }
    put("kind", json!(kind(ray, term)));
    put("origin", json!(ray.ray.origin.to_array()));
    put("direction", json!(ray.ray.direction.to_array()));
    if let Some(light) = &ray.light {
        put("light", json!(light));
        // the way to a point lamp is the direction itself
        if (ray.ray.direction.length() - 1.0).abs() > 1e-9 {
            put("end", json!(1));
        }
    }
    if let Outcome::Blocked { .. } = ray.outcome {
        put("object", json!(ray.blocked_by));
    }
    if let Some(hit) = &ray.hit {
        put("t", json!(hit.t));
        put("point", json!(hit.point.to_array()));
        put("object", json!(hit.object));
        put("normal", json!(Vector::from(hit.normal).to_array()));
        if hit.shading_normal != hit.normal {
            put("shading_normal", json!(Vector::from(hit.shading_normal).to_array()));
        }
        put("front", json!(hit.front));
    }
    if let Some(sender) = sender {
        let weights =
            sender.terms.iter().filter(|term| term.ray == Some(ray.number)).map(|term| term.weight);
        put("weight", json!((weights.sum::<Rgb>() * ray.transmittance).to_array()));
    }
    if let (RayKind::Transmitted, Some([front, behind])) = (ray.kind, media(sender)) {
        put("eta_from", json!(front));
        put("eta_to", json!(behind));
    }
    factors(&mut line, term);
    if !matches!(ray.kind, RayKind::Shadow { .. }) {
        add_light(&mut line, ray);
    } else {
        line.insert("radiance".to_owned(), json!(sum(ray, |_| true).to_array()));
    }
    line
}

/// The indices of refraction on both sides of the surface that a ray met, its own side first.
fn media(sender: Option<&RecordedRay>) -> Option<[f64; 2]> {
    let optics = sender?.hit.as_ref()?.optics.as_ref()?;
    optics.media.map(|media| media.map(|medium| medium.eta))
}

/// What is emitted, what is added without a ray, and what leaves the surface in all.
fn add_light(line: &mut Map<String, Value>, ray: &RecordedRay) {
    let is_emitted = |term: &RecordedTerm| {
        matches!(term.source, TermSource::Emission { .. } | TermSource::Background { .. })
    };
    let emitted = sum(ray, |term| term.ray.is_none() && is_emitted(term));
    let local = sum(ray, |term| term.ray.is_none() && !is_emitted(term));
    let lit = ray.children.iter().filter(|child| matches!(child.kind, RayKind::Shadow { .. }));
    let by_ray =
        lit.flat_map(|child| ray.terms.iter().filter(move |term| term.ray == Some(child.number)));
    let direct: Rgb = local + by_ray.map(|term| term.value).sum();
    for (name, color) in
        [("emitted", emitted), ("direct", direct), ("radiance", sum(ray, |_| true))]
    {
        line.insert(name.to_owned(), json!(color.to_array()));
    }
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

fn factors(line: &mut Map<String, Value>, term: Option<&RecordedTerm>) {
    let mut put = |name: &str, value: Option<Value>| {
        drop(value.map(|value| line.insert(name.to_owned(), value)))
    };
    match term.map(|term| &term.source) {
        Some(TermSource::Traced { pdf, lobe_probability, survival, .. }) => {
            put("pdf", pdf.map(|pdf| json!(pdf)));
            let choice = lobe_probability * survival;
            put("choice", (choice != 1.0).then(|| json!(choice)));
        }
        Some(TermSource::Direct { f, cos_i, pdf, mis, .. }) => {
            // one ray may serve several lobes: then the factors are those of the first, and only the weight is of all
            put("cos", Some(json!(cos_i)));
            put("pdf", pdf.map(|pdf| json!(pdf)));
            put("mis", mis.map(|mis| json!(mis)));
            put("values", Some(json!({"f_of_first_lobe": f.to_array()})));
        }
        _ => {}
    }
}
