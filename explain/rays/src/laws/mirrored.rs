use std::collections::HashMap;

use super::LawReport;
use super::geometry::{Leaving, angle_between, is_near, leaving, mirrored};
use crate::log::Purpose;
use crate::traced::Traced;
use groundtruth::math::{Vector, to_degrees};
use text::digits::short;

/// So many rays of an object show whether they scatter about the mirrored direction.
const ENOUGH: usize = 8;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let rays =
        || leaving(traced).filter(|it| it.ray.is(&Purpose::Reflected) && it.normal().is_some());
    let within = |it: &Leaving<'_>| 2.0 * traced.tolerance() + it.off_unit();
    let about = |it: &Leaving<'_>, n: Option<Vector>| {
        n.and_then(Vector::unit)
            .is_some_and(|n| is_near(it.leaving, mirrored(it.arriving, n), within(it)))
    };
    // which of two normals nearly all are mirrored about
    let by_shading = rays().filter(|it| about(it, it.parent.shading_normal)).count();
    let by_normal = rays().filter(|it| about(it, it.parent.normal)).count();
    let shades = by_shading > by_normal;
    let expected = |it: &Leaving<'_>| {
        let n =
            if shades { it.parent.shading_normal.or(it.parent.normal) } else { it.parent.normal };
        mirrored(it.arriving, n.and_then(Vector::unit).unwrap_or(Vector::ZERO))
    };
    // a wrong formula stays in the plane of the ray and the normal; what scatters leaves it
    let mut planes: HashMap<_, [usize; 2]> = HashMap::new();
    for it in rays() {
        let [all, outside] = planes.entry(it.parent.object.as_ref()).or_default();
        let expected = expected(&it);
        let off = it.leaving.dot(expected.cross(it.arriving));
        let is_off = !is_near(it.leaving, expected, within(&it));
        (*all, *outside) = (*all + 1, *outside + usize::from(is_off && off.abs() > within(&it)));
    }
    let scatters = |it: &Leaving<'_>| {
        let [all, outside] = planes[&it.parent.object.as_ref()];
        all >= ENOUGH && 2 * outside > all
    };
    for it in rays() {
        let expected = expected(&it);
        let causes = causes(&it, within(&it), shades);
        let holds = is_near(it.leaving, expected, within(&it));
        if !holds && causes.iter().all(|it| !it.1) && scatters(&it) {
            if asked.notes.is_empty() {
                asked.notes.push("some reflected rays scatter about the mirrored direction; write `glossy` as their kind".to_owned());
            }
            continue;
        }
        asked.count(it.index, holds, || {
            let angle = short(to_degrees(angle_between(expected, it.leaving)));
            (format!("leaves {angle}° from the mirrored direction"), causes)
        });
        asked.expect(it.index, expected.unit());
    }
}

fn causes(it: &Leaving<'_>, tolerance: f64, shades: bool) -> [(&'static str, bool); 7] {
    let is = |v: Vector| v.unit().is_some_and(|v| is_near(it.leaving, v, tolerance));
    let about =
        |n: Option<Vector>| n.and_then(Vector::unit).is_some_and(|n| is(mirrored(it.arriving, n)));
    let (d, n) = (it.arriving, it.parent.normal.unwrap_or(Vector::ZERO));
    let unit = n.unit().unwrap_or(Vector::ZERO);
    [
        ("about-shading-normal", !shades && about(it.parent.shading_normal)),
        ("about-true-normal", shades && about(it.parent.normal)),
        ("sign-of-viewer", is(-mirrored(d, unit))),
        ("factor-2-missing", is(d - d.dot(unit) * unit)),
        ("normal-not-unit", is(mirrored(d, n))),
        ("straight-on", is(d)),
        ("added-not-subtracted", is(d + 2.0 * d.dot(unit) * unit)),
    ]
}
