use super::{LawReport, RayLaw};
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::printable::name;
use text::digits::short;

pub const LAW: RayLaw = RayLaw {
    name: "not-behind-the-lamp",
    says: "what blocks a shadow ray is between the point and the lamp",
    needs: &["kind", "t", "end"],
    causes: &[
        "the distance of the hit is compared with nothing: any hit blocks",
        "distance and t are compared in different units: the direction is no unit vector",
        "what is behind the point blocks: t is negative",
    ],
    check,
};

fn check(traced: &Traced, asked: &mut LawReport) {
    for (index, ray) in traced.log.rays.iter().enumerate() {
        let (true, Some(t), Some(end)) = (ray.is(&Purpose::Shadow), ray.t, ray.end) else {
            continue;
        };
        if !(t.is_finite() && end.is_finite()) {
            continue;
        }
        // a ray that went on to the lamp brings its light: then nothing blocked
        let is_lit = ray.radiance.is_some_and(|light| light.max() > 0.0);
        let is_lamp = ray.object.is_some() && ray.object == ray.light;
        let slack = traced.tolerance() * end.abs()
            + traced.slack(ray.origin.to_vector().max_abs()) / ray.direction.length();
        let holds = is_lit || is_lamp || (t <= end + slack && t >= -slack);
        asked.count(index, holds, || {
            let length = ray.direction.length();
            let is_scaled = (length - 1.0).abs() > 1e-3 && (t * length <= end || t <= end * length);
            let what = ray
                .object
                .as_ref()
                .map_or("something".to_owned(), |object| format!("\"{}\"", name(object)));
            let words = match t < 0.0 {
                true => format!("is blocked by {what} behind its own start, at t {}", short(t)),
                false => format!(
                    "is blocked by {what} at t {}, behind its lamp at {}",
                    short(t),
                    short(end)
                ),
            };
            (words, [t >= 0.0 && !is_scaled, t >= 0.0 && is_scaled, t < 0.0])
        });
    }
}
