use super::LawReport;
use crate::log::Ray;
use crate::traced::Traced;
use groundtruth::rgb::Rgb;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    for (index, ray) in traced.rays() {
        let bad = first_bad(ray);
        asked.count(index, bad.is_none(), || {
            let (field, what) = bad.unwrap_or(("", "is not a number"));
            let parent = traced.parent(index);
            let is_inherited = parent.is_some_and(|parent| first_bad(parent).is_some());
            let is_direction = field == "direction" && !is_inherited;
            let is_transmitted = ray.is(&crate::log::Purpose::Transmitted);
            let causes = [
                ("zero-pdf", ray.factors.pdf == Some(0.0)),
                ("zero-vector", field == "normal" || is_direction && !is_transmitted),
                ("negative-root", is_direction && is_transmitted),
                ("inherited-from-sender", is_inherited),
            ];
            (format!("has a {field} that {what}"), causes)
        });
    }
}

/// The first field with a number that cannot be, and what is wrong with it.
fn first_bad(ray: &Ray) -> Option<(&'static str, &'static str)> {
    let triple = |name, v: [f64; 3]| (name, Some(v), false);
    let factors = &ray.factors;
    let color =
        |name, color: Option<Rgb>, is_positive| (name, color.map(Rgb::to_array), is_positive);
    let number = |name, x: Option<f64>, is_positive| (name, x.map(|x| [x; 3]), is_positive);
    [
        triple("origin", ray.origin.to_array()),
        triple("direction", ray.direction.to_array()),
        // of a ray that hit nothing, t and point are often infinite
        ("point", ray.point.filter(|_| ray.t.is_none_or(f64::is_finite)).map(Into::into), false),
        ("normal", ray.normal.map(Into::into), false),
        ("shading normal", ray.shading_normal.map(Into::into), false),
        number("pdf", factors.pdf, true),
        number("pdf per area", factors.pdf_area, true),
        number("probability of being chosen", factors.choice, true),
        number("MIS weight", factors.mis, true),
        color("BRDF", factors.f, true),
        color("weight", factors.weight, true),
        color("throughput", factors.throughput, true),
        color("emitted light", ray.emitted, true),
        color("direct light", ray.direct, true),
        color("radiance", ray.radiance, true),
    ]
    .into_iter()
    .find_map(|(name, numbers, is_positive)| {
        let numbers = numbers?;
        if numbers.iter().any(|x| x.is_nan()) {
            return Some((name, "is not a number (NaN)"));
        }
        // the density of a mirror may be written down as infinite
        if numbers.iter().any(|x| x.is_infinite()) && !name.starts_with("pdf") {
            return Some((name, "is infinite"));
        }
        (is_positive && numbers.iter().any(|x| *x < 0.0)).then_some((name, "is negative"))
    })
}
