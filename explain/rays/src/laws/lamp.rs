use std::collections::BTreeMap;
use std::sync::Arc;

use super::LawReport;
use super::geometry::{leaving, quoted};
use crate::log::Named;
use crate::traced::{Traced, median, size};
use groundtruth::math::{Point, Vector, atan2, to_degrees};
use serde_json::Value;
use text::digits::short;

/// The part of a lamp's shadow rays that have to meet for it to be a point; of those that name no lamp nearly all, to be of one.
const MEET: f64 = 0.6;
const MEET_UNNAMED: f64 = 0.98;
/// The part of the way by which a shadow ray may end before its lamp, or behind it.
const BEFORE: f64 = 2e-2;
/// Fewer rays of a lamp without a place say nothing of where it is.
const FEW: usize = 3;

/// A shadow ray as a line.
struct Line {
    index: usize,
    from: Point,
    towards: Vector,
    /// How far the lamp is, as its `end` says.
    far: Option<f64>,
    eye: Point,
    slack: f64,
    tolerance: f64,
}

pub fn check(traced: &Traced, asked: &mut LawReport) {
    let mut lamps: BTreeMap<Option<&Arc<str>>, Vec<Line>> = BTreeMap::new();
    for it in leaving(traced).filter(|it| it.ray.is(&crate::log::Purpose::Shadow)) {
        let turned = traced.conventions.shadow_from_lamp;
        let far = traced.way_to_lamp(it.ray);
        let way = far.unwrap_or(Vector::ZERO);
        let line = Line {
            index: it.index,
            from: if turned { it.ray.origin + way } else { it.ray.origin },
            towards: if turned { -it.leaving } else { it.leaving },
            far: far.map(Vector::length).filter(|far| far.is_finite()),
            eye: it.parent.origin,
            // many aim from the hit point and start a little off it
            slack: it.slack(traced)
                + if turned { 0.0 } else { (it.ray.origin - it.end).length() }
                + traced.slack(size(way)),
            tolerance: traced.tolerance(),
        };
        lamps.entry(it.ray.light.as_ref()).or_default().push(line);
    }
    for (name, lines) in lamps {
        let named = traced.log.lamps.iter().find(|lamp| Some(&lamp.name) == name);
        let target = match named {
            Some(lamp) => target(lamp).map(|target| turned(target, &lines, asked)),
            None => {
                let most = if name.is_some() { MEET } else { MEET_UNNAMED };
                let point = meeting_point(&lines, most).map(Target::Found);
                point.or_else(|| common_direction(&lines, most))
            }
        };
        if name.is_none() && target.is_none() && lines.len() >= FEW {
            asked.notes.push("shadow rays without `light` are not of one lamp: it names which lamp each is aimed at".to_owned());
        }
        if target.is_some_and(|target| is_soft(&lines, target)) {
            asked.notes.push("the directions to a lamp scatter about that of its line: a soft sun, which is not judged".to_owned());
            continue;
        }
        if let Some(target) = target {
            lines.iter().for_each(|line| check_line(line, target, name, asked));
        }
    }
}

/// Where a lamp is.
#[derive(Clone, Copy)]
enum Target {
    Place(Point),
    /// The same, worked out from the rays themselves.
    Found(Point),
    /// A unit vector to a lamp in infinity.
    Direction(Vector),
}

/// The target; of a lamp in infinity to the other side, if all rays go there: then its line has the way of the light.
fn turned(target: Target, lines: &[Line], asked: &mut LawReport) -> Target {
    match target {
        Target::Direction(direction)
            if lines.len() >= FEW && lines.iter().all(|line| line.towards.dot(direction) < 0.0) =>
        {
            asked.notes.push(
                "`directional` is taken for the way that the light goes, as all rays go against it"
                    .to_owned(),
            );
            Target::Direction(-direction)
        }
        target => target,
    }
}

/// Whether the directions to a lamp in infinity scatter by a degree or so about its own.
fn is_soft(lines: &[Line], target: Target) -> bool {
    let Target::Direction(direction) = target else { return false };
    let off: Vec<Vector> = lines.iter().map(|line| line.towards - direction).collect();
    let is_near = off.iter().all(|off| off.length() < SOFT);
    let differ = |pair: &&[Vector]| (pair[0] - pair[1]).length() > 1e-2 * pair[0].length();
    is_near && 2 * off.windows(2).filter(differ).count() > off.len()
}

/// The radius of a soft sun, as a sine.
const SOFT: f64 = 3e-2;

fn check_line(line: &Line, target: Target, name: Option<&Arc<str>>, asked: &mut LawReport) {
    let to = match target {
        Target::Place(place) | Target::Found(place) => place - line.from,
        Target::Direction(direction) => direction,
    };
    let slack = match target {
        Target::Place(_) => 4.0 * line.slack,
        // lines that are nearly parallel meet nowhere exactly
        Target::Found(_) => 1e3 * line.slack,
        Target::Direction(_) => 8.0 * line.tolerance,
    };
    let miss = line.towards.cross(to).length();
    let far = line.far.filter(|_| !matches!(target, Target::Direction(_)));
    // many end a little before the lamp
    let is_at_lamp = far.is_none_or(|far| (far / to.length() - 1.0).abs() <= BEFORE);
    let passes = miss <= slack && to.dot(line.towards) >= 0.0;
    let holds = passes && is_at_lamp;
    asked.count(line.index, holds, || {
        let near = slack / to.length().max(slack);
        let is =
            |v: Vector| !passes && v.unit().is_some_and(|v| (v - line.towards).length() <= near);
        let [at_place, from_eye] = match target {
            Target::Place(place) | Target::Found(place) => {
                [place.to_vector(), place - line.eye].map(is)
            }
            Target::Direction(_) => [false; 2],
        };
        let causes = [
            ("wrong-end", is(-to)),
            ("position-as-direction", at_place),
            ("from-camera", from_eye),
            ("distance-in-other-units", passes),
        ];
        let lamp = quoted(name, "its lamp");
        let angle = to_degrees(atan2(miss, to.dot(line.towards)));
        let words = match far.filter(|_| passes) {
            Some(far) => {
                let [far, to] = [far, to.length()].map(short);
                format!("ends {far} from its start, where {lamp} is {to} away")
            }
            None => format!("goes {}° past {lamp}", short(angle)),
        };
        (words, causes)
    });
}

/// Where the lamp's line says that it is.
fn target(lamp: &Named) -> Option<Target> {
    let triple = |value: &Value| serde_json::from_value::<[f64; 3]>(value.clone()).ok();
    if let Some(place) = lamp.fields.get("point").and_then(triple) {
        return Some(Target::Place(Point::from(place)));
    }
    let directional = lamp.fields.get("directional")?;
    let numbers = triple(directional.get("direction").unwrap_or(directional))?;
    Vector::from(numbers).unit().map(Target::Direction)
}

/// The direction that this part of the lines has, if they have one.
fn common_direction(lines: &[Line], most: f64) -> Option<Target> {
    let middle = |axis: usize| median(lines.iter().map(|line| line.towards.along(axis)).collect());
    let direction = Vector::new(middle(0)?, middle(1)?, middle(2)?).unit()?;
    let is_along = |line: &&Line| line.towards.cross(direction).length() <= line.tolerance;
    let along = lines.iter().filter(is_along).count();
    let is_common = lines.len() >= FEW && along as f64 >= most * lines.len() as f64;
    is_common.then_some(Target::Direction(direction))
}

/// The point that this part of the lines passes, if they do: the median of where pairs of them are nearest.
fn meeting_point(lines: &[Line], most: f64) -> Option<Point> {
    if lines.len() < FEW {
        return None;
    }
    let mut points = Vec::new();
    for (place, a) in lines.iter().enumerate().take(64) {
        let b = &lines[(place + lines.len() / 2).max(place + 1) % lines.len()];
        points.extend(nearest(a, b));
    }
    let middle = |axis: usize| median(points.iter().map(|p: &Point| p.along(axis)).collect());
    let place = Point::new(middle(0)?, middle(1)?, middle(2)?);
    let passes = |line: &&Line| {
        let to = place - line.from;
        line.towards.cross(to).length() <= 64.0 * line.slack + 1e-4 * to.length()
    };
    let enough = |count: usize| count as f64 >= most * lines.len() as f64;
    let ahead = |line: &&Line| (place - line.from).dot(line.towards) > 0.0;
    let meeting = lines.iter().filter(passes).filter(ahead).count();
    // rays that leave one lamp meet behind; but those of one point to a large lamp meet there
    let apart = lines.iter().map(|line| line.from.distance(lines[0].from)).fold(0.0, f64::max);
    let behind = |line: &&Line| !ahead(line) && line.from.distance(place) > 0.1 * apart;
    let leaving = lines.iter().filter(passes).filter(behind).count();
    let is_spread = apart > 0.1 * lines[0].from.distance(place);
    (enough(meeting) || is_spread && enough(leaving)).then_some(place)
}

/// The middle of where two lines are nearest; `None` if they are nearly parallel.
fn nearest(a: &Line, b: &Line) -> Option<Point> {
    let (across, between) = (a.towards.cross(b.towards), b.from - a.from);
    let square = across.length_squared();
    (square > 1e-6).then(|| {
        let along_a = between.cross(b.towards).dot(across) / square;
        let along_b = between.cross(a.towards).dot(across) / square;
        let [p, q] = [a.from + along_a * a.towards, b.from + along_b * b.towards];
        p + 0.5 * (q - p)
    })
}
