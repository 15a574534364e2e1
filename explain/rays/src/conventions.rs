//! What a program means by its numbers: what nearly all of its rays do. It is found, and said; nobody is asked.

use groundtruth::math::Vector;

use crate::laws::is_near_color as is_near;
use crate::log::{Factors, Purpose};
use crate::traced::{Traced, median, size};
use groundtruth::rgb::Rgb;

/// The part of the rays that has to do the same for it to be the program's habit.
const NEARLY_ALL: f64 = 0.8;

/// The rays that show what a program's habits are.
const ENOUGH: usize = 1 << 15;
/// The part of the normals that may face away though the program turns them.
const FEW_AWAY: f64 = 2e-3;

/// The habits of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conventions {
    /// Whether `t` is a length, though directions are no unit vectors.
    pub t_is_length: bool,
    /// Where the normals point.
    pub normals: Normals,
    /// Whether a shadow ray runs from the lamp to the point.
    pub shadow_from_lamp: bool,
    /// Whether `eta` is the index in front over the one behind.
    pub eta_is_front_over_behind: bool,
    /// Whether `throughput` leaves out the ray's own weight.
    pub throughput_before: bool,
    /// Whether the log's `weight` was the product from the camera; [`Traced`] has made it the ray's own.
    pub weight_from_camera: bool,
    /// How far from the surface rays start (the median), and along what, in words.
    pub offset: Option<(f64, &'static str)>,
}

/// Where normals point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Normals {
    /// Nothing is known of them.
    #[default]
    Unknown,
    /// To the side that the ray came from.
    ToViewer,
    /// To the outside of the object, wherever the ray came from.
    Outward,
}

/// Whether nearly all of the answers are yes; `None` without any.
fn nearly_all(answers: impl Iterator<Item = bool>) -> Option<bool> {
    let (mut yes, mut all) = (0_usize, 0_usize);
    answers.for_each(|answer| (yes, all) = (yes + usize::from(answer), all + 1));
    (all > 0).then_some(yes as f64 >= NEARLY_ALL * all as f64)
}

/// Rays with their senders: all, or so many of them that a habit shows, drawn by a hash of their places.
fn some_pairs(traced: &Traced) -> impl Iterator<Item = (usize, usize)> {
    let part = (traced.log.rays.len() / ENOUGH).max(1) as u64;
    let hash = |at: usize| (at as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
    let is_drawn = move |at: usize| hash(at).is_multiple_of(part);
    traced.pairs().filter(move |(index, _)| is_drawn(*index))
}

impl Conventions {
    /// Those that say how long a ray is.
    pub fn of_lengths(traced: &Traced) -> Self {
        let rays = &traced.log.rays;
        let is_unit = |v: Vector| (v.length() - 1.0).abs() <= traced.tolerance().max(1e-3);
        let told = (0..rays.len()).filter(|&index| !is_unit(rays[index].direction));
        let as_length = told.filter_map(|index| {
            let ray = &rays[index];
            // where it ended, by itself or by a ray that starts there
            let child = || Some(rays[*traced.children[index].first()?].origin);
            let (t, point) = (ray.t?, ray.point.or_else(child)?);
            let at = |step: f64| (ray.origin + step * ray.direction).distance(point);
            Some(at(t / ray.direction.length()) < at(t))
        });
        Self { t_is_length: nearly_all(as_length).unwrap_or(false), ..Self::default() }
    }

    /// Whether `weight` is the product of all factors from the camera, not only that of the ray in its sender.
    pub fn are_weights_from_camera(traced: &Traced) -> bool {
        let answers = some_pairs(traced).filter_map(|(index, parent)| {
            let Factors { weight, f, cos, pdf, choice, .. } = &traced.ray(index).factors;
            let part = cos.unwrap_or(1.0) / (pdf.unwrap_or(1.0) * choice.unwrap_or(1.0));
            let (weight, own) = ((*weight)?, part * (*f)?);
            let product = traced.ray(parent).factors.weight? * own;
            (!is_near(own, product, 1e-2)).then(|| is_near(weight, product, 1e-3))
        });
        nearly_all(answers) == Some(true)
    }

    /// All of them, of a log whose lengths are known.
    pub fn of_tree(traced: &Traced) -> Self {
        Self {
            normals: normals(traced),
            shadow_from_lamp: shadow_from_lamp(traced),
            eta_is_front_over_behind: nearly_all(ratios(traced)) == Some(true),
            throughput_before: is_before(traced),
            offset: offset(traced),
            ..traced.conventions.clone()
        }
    }

    /// A sentence for each that a reader has to know.
    pub fn sentences(&self) -> Vec<String> {
        let mut said = Vec::new();
        let mut say = |is_so: bool, words: &str| said.extend(is_so.then(|| words.to_owned()));
        say(self.t_is_length, "`t` is a length: directions are no unit vectors");
        say(self.normals == Normals::ToViewer, "normals face the viewer");
        say(self.normals == Normals::Outward, "normals face outward, whatever side is seen");
        say(self.shadow_from_lamp, "shadow rays run from the lamp to the point");
        say(self.eta_is_front_over_behind, "`eta` is the index in front over the one behind");
        say(self.weight_from_camera, "`weight` is the product from the camera");
        say(self.throughput_before, "`throughput` leaves out the ray's own weight");
        let offset = self.offset.map(|(length, along)| {
            format!("rays start {} off the surface, {along}", text::digits::short(length))
        });
        said.extend(offset);
        said
    }
}

fn normals(traced: &Traced) -> Normals {
    let hits = traced.log.rays.iter().filter(|ray| !ray.is_shadow());
    let facing = hits.filter_map(|ray| Some(ray.normal?.dot(ray.direction) <= 0.0));
    let [away, toward] = facing.fold([0_u32; 2], |mut counts, faces| {
        counts[usize::from(faces)] += 1;
        counts
    });
    match (away, toward) {
        (0, 0) => Normals::Unknown,
        // most rays come from outside: normals that are not turned face away for those alone that are inside
        _ if f64::from(away) <= FEW_AWAY * f64::from(toward) => Normals::ToViewer,
        _ => Normals::Outward,
    }
}

fn shadow_from_lamp(traced: &Traced) -> bool {
    let answers = some_pairs(traced).filter_map(|(index, parent)| {
        let (ray, end) = (traced.ray(index), traced.end_point(parent)?);
        let far = traced.along(ray, ray.end.or(ray.t)?);
        ray.is_shadow().then(|| far.distance(end) < ray.origin.distance(end))
    });
    nearly_all(answers) == Some(true)
}

/// For each refraction, whether its `eta` is the sine behind over the sine in front.
fn ratios(traced: &Traced) -> impl Iterator<Item = bool> {
    some_pairs(traced).filter_map(|(index, parent)| {
        let (ray, from) = (traced.ray(index), traced.ray(parent));
        let (eta, normal) = (ray.factors.eta?, from.normal?);
        let sine = |v: Vector| Some(v.unit()?.cross(normal.unit()?).length());
        let (front, behind) = (sine(from.direction)?, sine(ray.direction)?);
        let is_told = ray.is(&Purpose::Transmitted) && front > 1e-2 && (eta - 1.0).abs() > 1e-2;
        is_told.then(|| (behind / front - eta).abs() < (front / behind - eta).abs())
    })
}

/// Whether the throughput of rays is that of their parent times the parent's weight.
fn is_before(traced: &Traced) -> bool {
    let near = |a: Rgb, b: Rgb| is_near(a, b, 1e-4);
    let answers = some_pairs(traced).filter_map(|(index, parent)| {
        let (ray, from) = (&traced.ray(index).factors, &traced.ray(parent).factors);
        let (own, before) = (ray.throughput?, from.throughput?);
        let after = before * ray.weight?;
        let without = before * from.weight?;
        (!near(after, without)).then(|| near(own, without))
    });
    nearly_all(answers).unwrap_or(false)
}

/// How far rays start from the point that their parent hit.
fn offset(traced: &Traced) -> Option<(f64, &'static str)> {
    let (mut along_normal, mut along_ray) = (Vec::new(), Vec::new());
    let mut lengths = Vec::new();
    for (index, parent) in some_pairs(traced) {
        let (ray, from) = (traced.ray(index), traced.ray(parent));
        let Some(end) = traced.end_point(parent) else { continue };
        let moved = ray.origin - end;
        let length = moved.length();
        if length <= 8.0 * traced.slack(size(ray.origin) + size(end))
            || length > 1e-1 * traced.scale
        {
            continue;
        }
        lengths.push(length);
        let parallel = |v: Vector| v.unit().map(|v| v.cross(moved).length() <= 0.1 * length);
        along_normal.extend(from.normal.and_then(parallel));
        along_ray.extend(parallel(ray.direction));
    }
    let enough = 2 * lengths.len() >= some_pairs(traced).count();
    let length = median(lengths).filter(|_| enough)?;
    let is = |answers: Vec<bool>| nearly_all(answers.into_iter()) == Some(true);
    let along = match (is(along_normal), is(along_ray)) {
        (true, _) => "along the normal",
        (false, true) => "along the new ray",
        (false, false) => "neither along the normal nor along the new ray",
    };
    Some((length, along))
}
