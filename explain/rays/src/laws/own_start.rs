use super::LawReport;
use super::geometry::{leaving, quoted};
use crate::log::Purpose;
use crate::precision::SINGLE;
use crate::traced::Traced;
use text::digits::short;

/// Roundings within which a ray meets the surface that it starts on by accident.
const ROUNDINGS: f64 = 4096.0;
/// The part of a usual ray's length that is no rounding, however far from the origin the scene is.
const FAR: f64 = 1e-2;
/// The part of a usual ray's length that is too near for anything else.
const NEAR: f64 = 1e-6;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    for it in leaving(traced) {
        let (Some(facing), Some(kind)) = (it.facing(), &it.ray.kind) else { continue };
        let cos = facing.dot(it.leaving);
        let leaves = if *kind == Purpose::Transmitted { -cos } else { cos };
        // a lamp behind the surface is rightly hidden by it
        let starts_at_lamp = it.ray.is_shadow() && traced.conventions.shadow_from_lamp;
        if leaves <= 1e-3 || *kind == Purpose::Camera || starts_at_lamp {
            continue;
        }
        let end = it.ray.t.map(|t| (traced.along(it.ray, t) - it.ray.origin).length());
        let (near, moved) = (end.unwrap_or(f64::INFINITY), (it.ray.origin - it.end).length());
        // what a program computes with, not the fewer digits that it may print: a small t has all of its own
        let rounding = traced.rounding.min(SINGLE)
            * (it.end.to_vector().max_abs() + it.ray.origin.to_vector().max_abs());
        let is_same = match (&it.ray.object, &it.parent.object) {
            (Some(hit), Some(left)) => hit == left,
            _ => true,
        };
        let limit = (ROUNDINGS * rounding)
            .min(FAR * traced.scale)
            .max(NEAR * traced.scale)
            .max(4.0 * moved / leaves.max(0.1));
        let holds = !(is_same && near <= limit);
        asked.count(it.index, holds, || {
            let to_wrong_side =
                (it.ray.origin - it.end).dot(facing) * cos < 0.0 && moved > it.slack(traced);
            let what = quoted(it.ray.object.as_ref(), "something");
            let verb = if it.ray.is_shadow() { "is blocked by" } else { "hits" };
            let own = if it.ray.object.is_some() && is_same { " itself" } else { "" };
            let words = format!("{verb} {what}{own} {} away from its start", short(near));
            (words, [("no-offset", !to_wrong_side), ("offset-to-wrong-side", to_wrong_side)])
        });
    }
}
