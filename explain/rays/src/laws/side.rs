use super::geometry::leaving;
use super::{LawReport, RayLaw};
use crate::log::Purpose;
use crate::traced::Traced;
use text::digits::short;

pub const LAW: RayLaw = RayLaw {
    name: "right-side",
    says: "scattered rays leave to the viewer's side of a surface, transmitted ones to the other",
    needs: &["kind", "normal of its parent"],
    causes: &[
        "it leaves about the normal, which points away from the viewer: the normal is not turned to the viewer",
        "it leaves about the shading normal, below the true surface",
        "directions are drawn over the whole sphere",
    ],
    check,
};

fn check(traced: &Traced, asked: &mut LawReport) {
    // whether directions below and above are as frequent: drawn over the whole sphere
    let sides: Vec<bool> = leaving(traced)
        .filter(|it| it.ray.is(&Purpose::Diffuse))
        .filter_map(|it| Some(it.facing()?.dot(it.leaving) < 0.0))
        .collect();
    let below = sides.iter().filter(|below| **below).count();
    let is_sphere = sides.len() >= 20 && (2 * below).abs_diff(sides.len()) < sides.len() / 2;
    for it in leaving(traced) {
        let should_pass = match it.ray.kind {
            Some(Purpose::Diffuse | Purpose::Glossy) => false,
            Some(Purpose::Transmitted) => true,
            _ => continue,
        };
        let (Some(facing), Some(normal)) = (it.facing(), it.normal()) else { continue };
        let cos = facing.dot(it.leaving);
        // along the surface the side is a matter of rounding
        let holds =
            if should_pass { cos <= traced.tolerance() } else { cos >= -traced.tolerance() };
        asked.count(it.index, holds, || {
            let about =
                |n: Option<groundtruth::math::Vector>| n.is_some_and(|n| n.dot(it.leaving) > 0.0);
            let is_turned_away = normal.dot(it.arriving) > 0.0;
            let causes = [
                !should_pass && is_turned_away,
                !should_pass
                    && !is_turned_away
                    && it.parent.shading_normal.is_some()
                    && about(it.parent.shading_normal),
                !should_pass && is_sphere,
            ];
            let side = if should_pass { "stays on the viewer's side of" } else { "goes below" };
            (format!("{side} the surface that it leaves, at a cosine of {}", short(cos)), causes)
        });
    }
}
