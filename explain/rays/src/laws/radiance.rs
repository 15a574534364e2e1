use super::LawReport;
use super::weight::{is_finite, is_near};
use crate::log::Ray;
use crate::traced::Traced;
use groundtruth::rgb::Rgb;
use text::digits::three;

/// What arrives at a hit: its parts.
struct Parts {
    emitted: Rgb,
    direct: Rgb,
    children: Vec<(Rgb, Rgb)>,
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let tolerance = 8.0 * traced.tolerance();
    let has_shadow_rays = direct_has_shadow_rays(traced, tolerance);
    for (index, ray) in traced.rays() {
        let Some(radiance) = ray.radiance.filter(|it| is_finite(*it)) else { continue };
        if ray.is_shadow() {
            continue;
        }
        let Some(parts) = parts(traced, index, has_shadow_rays) else { continue };
        let local = parts.emitted + parts.direct;
        let brought: Rgb = parts.each().sum();
        let expected = local + brought;
        if !is_finite(expected) {
            continue;
        }
        // what is emitted may stand with its MIS weight or without it
        let mis = ray.factors.mis.unwrap_or(1.0);
        let split = expected - (1.0 - mis) * parts.emitted;
        let fits = |it| is_near(radiance, it, tolerance) || is_within(radiance, it, traced);
        let holds = [expected, split].into_iter().any(fits);
        asked.count(index, holds, || {
            let is = |color: Rgb| is_near(radiance, color, tolerance);
            let lit = || parts.each().filter(|child| child.max() > 0.0);
            let unweighted = || {
                parts.children.iter().map(|(weight, light)| expected - *weight * *light + *light)
            };
            let most = radiance.max();
            let count = parts.children.len().max(1) as f64;
            let causes = [
                ("child-left-out", lit().any(|child| is(expected - child))),
                ("child-twice", lit().any(|child| is(expected + child))),
                ("divided-by-children", count > 1.0 && is(local + brought / count)),
                ("it-is-clamped", most < expected.max() && is(expected.map(|x| x.min(most)))),
                ("emitted-left-out", parts.emitted.max() > 0.0 && is(expected - parts.emitted)),
                ("direct-left-out", parts.direct.max() > 0.0 && is(expected - parts.direct)),
                ("emitted-twice", parts.emitted.max() > 0.0 && is(expected + parts.emitted)),
                ("child-weight-left-out", unweighted().any(is)),
            ];
            let [is, should] = [radiance, expected].map(|it| three(it.to_array()));
            (format!("brings {is}, where its parts give {should}"), causes)
        });
    }
}

/// So many rays show it.
const ENOUGH: usize = 1 << 14;

/// Whether `direct` holds the light of the shadow rays, or only what is added beside them, as ambient light: what fits more
/// rays.
fn direct_has_shadow_rays(traced: &Traced, tolerance: f64) -> bool {
    let fits = |has: bool| {
        let of = |(index, ray): (usize, &Ray)| {
            let (radiance, parts) = (ray.radiance?, parts(traced, index, has)?);
            let sum = parts.emitted + parts.direct + parts.each().sum();
            Some(is_near(radiance, sum, tolerance))
        };
        let rays = traced.rays().filter(|(_, ray)| ray.direct.is_some());
        rays.take(ENOUGH).filter_map(of).filter(|fits| *fits).count()
    };
    fits(true) >= fits(false)
}

/// The parts of a ray's radiance, if the log has them all.
fn parts(traced: &Traced, index: usize, direct_has_shadow_rays: bool) -> Option<Parts> {
    let ray = traced.ray(index);
    let children = &traced.children[index];
    let leaves_out = ray.direct.is_some() && direct_has_shadow_rays;
    let children = children.iter().map(|&child| traced.ray(child));
    let counted = children.filter(|child| !(leaves_out && child.is_shadow()));
    let children: Vec<(Rgb, Rgb)> =
        counted.map(|child| child.factors.weight.zip(child.radiance)).collect::<Option<_>>()?;
    // without any part there is nothing to add up: it may be a background, or a lamp that was not written down
    let is_told = ray.direct.is_some() || ray.emitted.is_some() || !children.is_empty();
    let [emitted, direct] = [ray.emitted, ray.direct].map(|light| light.unwrap_or(Rgb::BLACK));
    is_told.then_some(Parts { emitted, direct, children })
}

impl Parts {
    /// What each child brings.
    fn each(&self) -> impl Iterator<Item = Rgb> {
        self.children.iter().map(|(weight, light)| *weight * *light)
    }
}

/// Whether two colours are the same but for the decimals with which they are printed.
fn is_within(a: Rgb, b: Rgb, traced: &Traced) -> bool {
    (a - b).to_array().iter().all(|x| x.abs() <= traced.slack(0.0))
}
