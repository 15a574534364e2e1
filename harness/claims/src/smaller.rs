//! The smallest case in which a law is broken.
//!
//! A fixed list of changes of a case: a parameter is set to numbers that are read at a glance (0, 1, 2, ½, the ends of its
//! range, fewer decimals), a viewer to the normal, to directions of few decimals, to the azimuth 0. A change is kept if
//! the same law is broken, by at least a quarter of the first error and, where a mistake was recognised, by the same one:
//! else a gross mistake turns into something that looks like rounding.

use ask::{Draw, Stop, Subject, simpler, smallest, weight};
use groundtruth::math::hash;
use serde_json::Value;

use crate::asked::Counted;
use crate::description::{Description, Kind, Values};
use crate::laws::{Breach, Finding, Law};
use crate::run::{Broken, LawStatus, SubjectRow};
use crate::setting::{Case, Setting};

/// Cases that are tried for one finding.
const MOST_CASES: usize = 60;
/// After so many questions for one finding no other case is tried; a law of integrals needs up to 420 for a case.
const MOST_QUESTIONS: usize = 300;
/// The share of the first error that has to stay.
const SHARE: f64 = 0.25;
/// A law of chance is taken for broken in a smaller case if its numbers are less probable than this: chance picks a case
/// in which it holds for less than one finding of ten thousand.
const CHANCE: f64 = 1e-6;

/// Makes the cases of all broken laws of a row smaller, the first law's first: those below it often follow, and are tried
/// with its case.
///
/// # Errors
/// The run was interrupted.
pub fn row(
    subject: &mut dyn Subject,
    description: &Description,
    seed: u64,
    row: &mut SubjectRow,
) -> Result<(), Stop> {
    let mut found: Vec<Setting> = Vec::new();
    for (law, status) in Law::of(row.kind).iter().zip(&mut row.laws) {
        let LawStatus::Broken(broken) = status else { continue };
        let mut search = Search {
            subject: &mut Counted { subject, asked: 0 },
            description,
            law,
            seed,
            first: broken.breach.clone(),
            tried: Vec::new(),
        };
        *broken = search.run(broken.clone(), &found)?;
        found.push(broken.setting.clone());
    }
    Ok(())
}

/// The search for a smaller case of one finding.
struct Search<'a, 'b> {
    subject: &'a mut Counted<'b>,
    description: &'a Description,
    law: &'static Law,
    seed: u64,
    /// What was found first.
    first: Breach,
    /// Settings that need not be asked again.
    tried: Vec<Setting>,
}

impl Search<'_, '_> {
    fn run(&mut self, mut best: Broken, known: &[Setting]) -> Result<Broken, Stop> {
        let description = self.description;
        let parts = 0..parts(description);
        // all parts at once: if that is kept, nothing is left to be asked
        let simplest = parts.clone().fold(best.setting.clone(), |setting, part| {
            let first = changed(description, &setting, part).into_iter().next();
            first.unwrap_or(setting)
        });
        for setting in known.iter().chain([&simplest]) {
            if cost(description, setting) < cost(description, &best.setting) {
                best = self.kept(setting.clone())?.unwrap_or(best);
            }
        }
        let mut stopped = None;
        let simpler = |best: &Broken| {
            parts.clone().flat_map(|part| changed(description, &best.setting, part)).collect()
        };
        let kept = |_: &Broken, setting| self.kept(setting).map_err(|it| stopped = Some(it)).ok();
        let best = smallest(best, simpler, kept);
        stopped.map_or(Ok(best), Err)
    }

    /// This setting if the law is broken in it, too.
    fn kept(&mut self, setting: Setting) -> Result<Option<Broken>, Stop> {
        let is_spent = self.tried.len() >= MOST_CASES || self.subject.asked >= MOST_QUESTIONS;
        if is_spent || self.tried.contains(&setting) {
            return Ok(None);
        }
        self.tried.push(setting.clone());
        // the same numbers for each setting
        let draw = Draw::new(hash(&[self.seed]));
        let mut case = Case::new(self.subject, self.description, &setting, draw);
        let breach = match self.law.check(&mut case, 1) {
            Ok(Finding::Broken(breach)) => breach,
            Ok(Finding::Chance(p, breach)) if p <= CHANCE => breach,
            Err(Stop::NotAsked) => return Err(Stop::NotAsked),
            // a program that hangs or dies is not asked on
            Err(Stop::Fault(_)) => {
                self.subject.asked = MOST_QUESTIONS;
                return Ok(None);
            }
            _ => return Ok(None),
        };
        let is_alike = self.first.mistake.is_none() || breach.mistake == self.first.mistake;
        let is_kept = is_alike && breach.error >= SHARE * self.first.error;
        Ok(is_kept.then_some(Broken { setting, breach }))
    }
}

/// How many parts of a setting can be changed: parameters, and the viewer, or the coordinates of a point.
fn parts(description: &Description) -> usize {
    let seen = match description.kind {
        Kind::Lobe => 1,
        Kind::Light => 3,
        Kind::Map => 0,
    };
    description.parameters.len() + seen
}

/// The setting with one part simpler, the simplest first.
fn changed(description: &Description, setting: &Setting, part: usize) -> Vec<Setting> {
    if let Some((name, values)) = description.parameters.iter().nth(part) {
        let with = |value: Value| {
            let mut changed = setting.clone();
            changed.parameters[name] = value;
            changed
        };
        return values.simpler(&setting.parameters[name]).into_iter().map(with).collect();
    }
    let Some(seen) = setting.seen else { return Vec::new() };
    let with = |seen: [f64; 3]| Setting { seen: Some(seen), ..setting.clone() };
    match description.points {
        Some([low, high]) if description.kind == Kind::Light => {
            let axis = part - description.parameters.len();
            let with = |x: f64| {
                let mut point = seen;
                point[axis] = x;
                with(point)
            };
            simpler_within(low[axis], high[axis], seen[axis]).into_iter().map(with).collect()
        }
        _ => simpler_viewers(seen).into_iter().map(with).collect(),
    }
}

/// How much there is to read in a setting.
fn cost(description: &Description, setting: &Setting) -> u32 {
    let of = |(name, values): (&String, &Values)| values.cost(&setting.parameters[name]);
    let seen = match (description.kind, setting.seen) {
        (Kind::Lobe, Some(wo)) => viewer_cost(wo),
        (Kind::Light, Some(point)) => point.iter().map(|x| weight(*x)).sum(),
        _ => 0,
    };
    description.parameters.iter().map(of).sum::<u32>() + seen
}

impl Values {
    /// Values that are simpler than this one, the simplest first.
    fn simpler(&self, value: &Value) -> Vec<Value> {
        match self {
            Self::Number(_) => Vec::new(),
            Self::Range([low, high]) => {
                let simple = value.as_f64().map(|x| simpler_within(*low, *high, x));
                simple.unwrap_or_default().into_iter().map(Value::from).collect()
            }
            Self::Choices { one_of } => {
                one_of.iter().take_while(|other| *other != value).cloned().collect()
            }
        }
    }

    fn cost(&self, value: &Value) -> u32 {
        match self {
            Self::Number(_) => 0,
            Self::Range(_) => value.as_f64().map_or(0, weight),
            Self::Choices { one_of } => {
                one_of.iter().take_while(|other| *other != value).count() as u32
            }
        }
    }
}

/// Numbers between two ends that are simpler than this one, the simplest first.
fn simpler_within(low: f64, high: f64, x: f64) -> Vec<f64> {
    let typed = [0.0, 1.0, 2.0, 0.5, 1.5, 0.1, low, high].into_iter();
    let is_fit = |y: &f64| (low..=high).contains(y) && weight(*y) < weight(x);
    let mut all: Vec<f64> = typed.chain(simpler(x)).filter(is_fit).collect();
    all.sort_by_key(|y| weight(*y));
    all
}

/// Directions to viewers that are simple, the simplest first: each has few decimals, the last is at 45°.
const VIEWERS: [[f64; 3]; 4] = [
    [0.0, 0.0, 1.0],
    [0.6, 0.0, 0.8],
    [0.8, 0.0, 0.6],
    [std::f64::consts::FRAC_1_SQRT_2, 0.0, std::f64::consts::FRAC_1_SQRT_2],
];

/// Its rank among [`VIEWERS`], those at the azimuth 0, and all; above the surface before below.
fn viewer_cost([x, y, z]: [f64; 3]) -> u32 {
    let at_zero = VIEWERS.len() + usize::from(y != 0.0 || x < 0.0);
    let is_it = |viewer: &[f64; 3]| *viewer == [x, y, z.abs()];
    let rank = VIEWERS.iter().position(is_it).unwrap_or(at_zero);
    2 * rank as u32 + u32::from(z < 0.0)
}

/// Viewers that are simpler than this one, the simplest first; below the surface only if this one is.
fn simpler_viewers(wo: [f64; 3]) -> Vec<[f64; 3]> {
    let [x, y, z] = wo;
    let at_zero = [(x * x + y * y).sqrt(), 0.0, z.abs()];
    let above = VIEWERS.into_iter().chain([at_zero, [x, y, z.abs()]]);
    let sides = |[x, y, up]: [f64; 3]| [[x, y, up], [x, y, up.copysign(z)]];
    let is_simpler = |viewer: &[f64; 3]| viewer_cost(*viewer) < viewer_cost(wo);
    let mut all: Vec<[f64; 3]> = above.flat_map(sides).filter(is_simpler).collect();
    all.sort_by_key(|viewer| viewer_cost(*viewer));
    all
}
