use super::LawReport;
use crate::placing::Placing;
use crate::traced::Traced;
use groundtruth::math::{Ray, Span};

/// The rays that are compared with the objects.
const LOOKED_AT: usize = 400;
/// Fewer say nothing.
const FEW: usize = 8;

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let Some(world) = &traced.world else { return };
    let hits = traced.rays().filter(|(_, ray)| {
        let is_told = ray.t.is_some_and(|t| t.is_finite() && t > 1e-3 * traced.scale);
        is_told && !ray.is_shadow() && ray.origin.is_finite() && ray.direction.unit().is_some()
    });
    let hits: Vec<_> = hits.collect();
    let some: Vec<_> = hits.iter().step_by(hits.len().div_ceil(LOOKED_AT).max(1)).collect();
    if some.len() < FEW {
        return;
    }
    let agree = |placing: &Placing| {
        let agrees = |(_, ray): &&&(usize, &crate::log::Ray)| {
            let along = if traced.conventions.t_is_length { ray.direction.length() } else { 1.0 };
            let t = ray.t.unwrap_or(0.0) / along * placing.scale;
            let line = Ray::new(placing.point(ray.origin), placing.vector(ray.direction));
            let span = Span { min: 0.5 * t, max: f64::INFINITY };
            world.hit(&line, span).is_some_and(|hit| (hit.t - t).abs() <= 1e-3 * t)
        };
        some.iter().filter(agrees).count()
    };
    asked.is_of_all = true;
    let (enough, as_it_is) = (9 * some.len() / 10, agree(&Placing::default()));
    let mut others = Placing::others().filter(|_| 2 * as_it_is < some.len());
    let other = others.find(|placing| agree(placing) >= enough);
    asked.rays += some.len() - 1;
    asked.count(some[0].0, other.is_none(), || {
        let placing = other.expect("it breaks the law");
        let causes = [
            ("mirrored-axis", placing.is_mirrored() && placing.scale == 1.0),
            ("exchanged-axes", !placing.is_mirrored() && placing.scale == 1.0),
            ("unit-of-length", placing.scale != 1.0),
        ];
        let words = format!(
            "is one of those that miss the objects of the log, and hit them after {placing}"
        );
        (words, causes)
    });
}
