use std::collections::BTreeMap;
use std::sync::Arc;

use super::LawReport;
use super::geometry::quoted;
use super::surface::Surface;
use crate::log::Purpose;
use crate::traced::{Traced, median};
use groundtruth::math::{Point, Vector};
use text::digits::short;

/// Fewer rays show no density.
const FEW: usize = 8;
/// The part of a lamp's size within which points are the same.
const SAME_POINT: f64 = 1e-3;
/// How near densities have to be; and the part of them.
const NEAR: f64 = 2e-3;
const MOST: f64 = 0.9;

/// How a program draws points of a lamp.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    surface: Surface,
    model: usize,
    /// The density that is logged over that of the model.
    factor: f64,
    /// The probability that this lamp is chosen.
    pub choice: f64,
}

impl Drawn {
    /// The density with which the program draws this direction to the lamp.
    pub fn density(&self, from: Point, direction: Vector, far: f64) -> f64 {
        self.factor * self.surface.densities(from, direction, far).0[self.model]
    }
}

/// A shadow ray with a density: its index, where from and to, how far, its density.
type Sample = (usize, Point, Vector, f64, f64);

fn samples(traced: &Traced) -> BTreeMap<Arc<str>, Vec<Sample>> {
    let mut lamps: BTreeMap<_, Vec<Sample>> = BTreeMap::new();
    for (index, ray) in traced.rays().filter(|it| it.1.is(&Purpose::Shadow)) {
        let (Some(way), Some(light)) = (traced.way_to_lamp(ray), &ray.light) else { continue };
        let (Some(pdf), Some(direction)) = (ray.factors.pdf, ray.direction.unit()) else {
            continue;
        };
        let is_told = way.is_finite() && pdf.is_finite() && pdf > 0.0;
        if is_told && !traced.conventions.shadow_from_lamp {
            let sample = (index, ray.origin, direction, way.length(), pdf);
            lamps.entry(Arc::clone(light)).or_default().push(sample);
        }
    }
    lamps.retain(|_, samples| samples.len() >= FEW);
    lamps
}

fn surface(traced: &Traced, lamp: &Arc<str>) -> Option<Surface> {
    let line = traced.log.lamps.iter().find(|line| line.name == *lamp);
    let object = line.and_then(|line| line.fields.get("object")?.as_str()).unwrap_or(lamp);
    Surface::of_line(traced, object).or_else(|| Surface::of_hits(traced, &object.into()))
}

/// The factor that all densities have beside a model, if they have one.
fn factor(samples: &[Sample], model: impl Fn(&Sample) -> f64) -> Option<f64> {
    let ratios: Vec<f64> = samples.iter().map(|it| it.4 / model(it)).collect();
    let middle = median(ratios.clone())?;
    let alike = ratios.iter().filter(|ratio| (**ratio - middle).abs() <= NEAR * middle).count();
    (alike as f64 >= MOST * samples.len() as f64).then_some(middle)
}

fn drawn_one(traced: &Traced, lamp: &Arc<str>, samples: &[Sample]) -> Option<Drawn> {
    let surface = surface(traced, lamp)?;
    let choices = samples.iter().filter_map(|it| traced.ray(it.0).factors.choice).collect();
    let choice = median(choices).unwrap_or(1.0);
    (0..3).find_map(|model| {
        let factor = factor(samples, |it| surface.densities(it.1, it.2, it.3).0[model])?;
        Some(Drawn { surface, model, factor, choice })
    })
}

/// How the points of each lamp are drawn, as far as it is understood.
pub fn drawn(traced: &Traced) -> BTreeMap<Arc<str>, Drawn> {
    let one = |(lamp, samples): (Arc<str>, Vec<Sample>)| {
        let drawn = drawn_one(traced, &lamp, &samples)?;
        Some((lamp, drawn))
    };
    samples(traced).into_iter().filter_map(one).collect()
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let lamps = samples(traced);
    let is_part = |factor: f64| {
        (1..=lamps.len().max(1)).any(|count| (factor * count as f64 - 1.0).abs() <= 2.0 * NEAR)
    };
    for (lamp, samples) in &lamps {
        let Some(surface) = surface(traced, lamp) else { continue };
        let drawn = drawn_one(traced, lamp, samples);
        let wrong = [0, 1].map(|at| {
            drawn.is_none()
                && factor(samples, |it| surface.densities(it.1, it.2, it.3).1[at]).is_some()
        });
        let has_area = !matches!(surface, Surface::Flat { area: None, .. });
        let is_scaled = drawn.is_some_and(|drawn| has_area && !is_part(drawn.factor));
        let is_point = is_one_point(surface, samples);
        if drawn.is_none() && !wrong.contains(&true) && !is_point {
            continue;
        }
        let dark = dark_sides(traced, lamp, surface);
        let is_dark = |towards: Vector| match surface {
            Surface::Flat { normal, .. } => dark[usize::from(towards.dot(normal) > 0.0)],
            Surface::Ball { .. } => false,
        };
        for &(index, from, direction, far, pdf) in samples {
            let is_lit = traced.ray(index).radiance.is_some_and(|light| light.max() > 0.0);
            let is_behind = is_lit && is_dark(direction);
            let holds = !(wrong.contains(&true) || is_scaled || is_behind || is_point);
            asked.count(index, holds, || {
                let should =
                    surface.densities(from, direction, far).0[drawn.map_or(0, |it| it.model)];
                let (lamp, pdf, should) = (quoted(Some(lamp), ""), short(pdf), short(should));
                let words = match (is_behind, has_area) {
                    _ if is_point => {
                        format!("goes to the one point of {lamp} that all go to, though it has a density")
                    }
                    (true, _) => {
                        format!("brings light from the side of {lamp} that is dark to rays that hit it")
                    }
                    (_, true) => {
                        format!("has the density {pdf}, where a point of {lamp} has {should}")
                    }
                    _ => {
                        format!("has the density {pdf}, which does not depend on {lamp} as a density does")
                    }
                };
                let causes = [
                    ("per-area", wrong[0]),
                    ("cosine-at-lamp-missing", wrong[1]),
                    ("one-point", is_point),
                    ("constant-factor", is_scaled),
                    ("one-side-without-sign", is_behind),
                ];
                (words, causes)
            });
        }
    }
    never_drawn(traced, &lamps, asked);
}

/// Whether all samples of a lamp go to the same point of it: that of a ball to its centre.
fn is_one_point(surface: Surface, samples: &[Sample]) -> bool {
    let end = |&(_, from, direction, far, _): &Sample| from + far * direction;
    let (point, size) = match surface {
        Surface::Ball { center, radius } => (center, radius),
        Surface::Flat { area, .. } => (end(&samples[0]), area.map_or(0.0, f64::sqrt)),
    };
    let passes = |it: &Sample| it.2.cross(point - it.1).length() <= SAME_POINT * size;
    samples.iter().all(passes)
}

/// The sides of a flat lamp, against its normal and along it, on which rays hit it and are never lit.
fn dark_sides(traced: &Traced, lamp: &Arc<str>, surface: Surface) -> [bool; 2] {
    let Surface::Flat { normal, .. } = surface else { return [false; 2] };
    let (mut hits, mut lit) = ([false; 2], [false; 2]);
    for ray in traced.log.rays.iter().filter(|ray| ray.object.as_ref() == Some(lamp)) {
        let side = usize::from(ray.direction.dot(normal) > 0.0);
        hits[side] |= !ray.is_shadow();
        lit[side] |= !ray.is_shadow() && ray.emitted.is_some_and(|light| light.max() > 0.0);
    }
    [hits[0] && !lit[0], hits[1] && !lit[1]]
}

/// A lamp that is hit by chance, and that no shadow ray goes to, though the others are chosen with probabilities that leave it one.
fn never_drawn(traced: &Traced, lamps: &BTreeMap<Arc<str>, Vec<Sample>>, asked: &mut LawReport) {
    let choice = |samples: &Vec<Sample>| {
        median(samples.iter().filter_map(|it| traced.ray(it.0).factors.choice).collect())
    };
    let sum: Option<f64> = lamps.values().map(choice).sum();
    let is_enough = lamps.values().map(Vec::len).sum::<usize>() >= 100;
    let (Some(sum), Some(first)) =
        (sum.filter(|sum| is_enough && *sum < 0.99), lamps.values().next())
    else {
        return;
    };
    let mut hits: BTreeMap<&Arc<str>, usize> = BTreeMap::new();
    for ray in traced.log.rays.iter().filter(|ray| ray.factors.pdf.is_some() && !ray.is_shadow()) {
        let is_lit = ray.emitted.is_some_and(|light| light.max() > 0.0);
        let object = ray.object.as_ref().filter(|name| is_lit && !lamps.contains_key(*name));
        if let Some(name) = object {
            *hits.entry(name).or_default() += 1;
        }
    }
    if let Some((lamp, _)) = hits.into_iter().find(|(_, count)| *count >= 3) {
        let words = format!(
            "is one of those that go to lamps chosen with the probability {} together: none goes to {}, which shines on rays that hit it",
            short(sum),
            quoted(Some(lamp), "")
        );
        asked.count(first[0].0, false, || (words, [("never-drawn", true)]));
    }
}
