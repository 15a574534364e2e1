//! A log whose rays know who sent them, and how exact its numbers are.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use groundtruth::math::{Point, Vector};
use groundtruth::rgb::Rgb;
use groundtruth::world::{PlacedObject, World};
use rayon::prelude::*;

use crate::conventions::Conventions;
use crate::laws::{Step, distance_to_truth};
use crate::log::{Id, Log, Purpose, Ray};
use crate::precision::{add_ends, fixed, forget_marks, rounding};

/// Roundings that a quantity of a log may have gone through.
const STEPS: f64 = 32.0;
/// The rays that show how far hits are off.
const LOOKED_AT: usize = 2000;
/// The part of a camera ray's usual length below which a program may look for no hits.
const LEAST: f64 = 1e-3;
/// How far away in the log the sender of a ray without `parent` is looked for.
const LOOKED_AROUND: usize = 256;
/// The longest way up that is looked at for each ray: a log of one chain would take its length squared.
const LONGEST_WAY: usize = 1000;

/// A log, with what follows from all of its lines together.
#[derive(Debug)]
pub struct Traced {
    /// The log.
    pub log: Log,
    /// The sender of each ray, by its index.
    pub parents: Vec<Option<usize>>,
    /// The rays that each ray sent, by their indices, in the order of the log.
    pub children: Vec<Vec<usize>>,
    /// The rays whose place in the tree is not known, and why.
    pub orphans: Vec<(usize, Orphan)>,
    /// The number of rays whose sender was found by where they start.
    pub guessed: usize,
    /// The relative error of a number of the log.
    pub rounding: f64,
    /// The absolute error, if its numbers have a fixed number of decimals.
    pub fixed: f64,
    /// The largest coordinate of the surface of each object that has an end.
    pub sizes: HashMap<Arc<str>, f64>,
    /// The median length of the rays that hit something: what is far below it is small in this scene.
    pub scale: f64,
    /// What the program means by its numbers.
    pub conventions: Conventions,
    /// The objects of the log, or the scene that it names.
    pub world: Option<Arc<World>>,
    /// How far hits are off the true surfaces, if nearly all are by more than rounding: the threshold of a sphere tracer.
    pub hits_are_off: f64,
    /// A length that is small beside those of camera rays.
    pub small: f64,
    /// The least `t` of a ray that another sent, up to [`Self::small`]: nearer hits may not be looked for. 0 if none was sent.
    pub least_t: f64,
    /// The rays that leave a known point.
    pub(crate) steps: Vec<Step>,
    /// The lamps that rays are aimed at, and the objects of the world, each with its place.
    pub(crate) places: [HashMap<Arc<str>, u32>; 2],
}

/// Why the place of a ray in the tree is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orphan {
    /// Its parent is no ray of its sample.
    Parentless,
    /// A ray before it in its sample has the same name.
    Twin,
    /// It is sent by a ray that it sent itself.
    InCircle,
}

impl Traced {
    /// Finds senders, precision and conventions.
    pub fn of(mut log: Log, world: Option<Arc<World>>) -> Self {
        let placing = log.head.placing;
        placing.apply(&mut log);
        forget_marks(&mut log);
        add_ends(&mut log);
        let rounding = rounding(&log);
        // rays that bounce within an object say nothing of the scene's size
        let seen = scale(&log, |ray| ray.is(&Purpose::Camera));
        let scale = scale(&log, |ray| !ray.is_shadow()).unwrap_or(1.0);
        let (fixed, sizes) = (fixed(&log), sizes(world.as_deref()));
        let lamps = places(log.rays.iter().filter_map(|ray| ray.light.as_ref()));
        let objects = world.iter().flat_map(|world| world.names.objects.iter().cloned().zip(0..));
        let places = [lamps, objects.collect()];
        let mut traced = Self {
            log,
            parents: Vec::new(),
            children: Vec::new(),
            orphans: Vec::new(),
            guessed: 0,
            rounding,
            fixed,
            sizes,
            scale,
            conventions: Conventions::default(),
            world,
            hits_are_off: 0.0,
            small: LEAST * seen.unwrap_or(scale),
            least_t: 0.0,
            steps: Vec::new(),
            places,
        };
        traced.link(false);
        traced.conventions = Conventions::of_lengths(&traced);
        let is_open = |ray: &Ray| ray.parent.is_none() && !ray.is(&Purpose::Camera);
        if traced.log.rays.iter().any(is_open) {
            traced.link(true);
        }
        if Conventions::are_weights_from_camera(&traced) {
            traced.make_weights_local();
        }
        let weight_from_camera = traced.conventions.weight_from_camera;
        traced.conventions = Conventions { weight_from_camera, ..Conventions::of_tree(&traced) };
        traced.hits_are_off = hits_are_off(&traced);
        traced.least_t = least_t(&traced);
        let all = (0..traced.log.rays.len()).into_par_iter();
        traced.steps = all.filter_map(|index| Step::of(&traced, index)).collect();
        traced
    }

    /// Divides weights that are products from the camera by those of the senders; a throughput keeps the product.
    fn make_weights_local(&mut self) {
        let weights: Vec<_> = self.log.rays.iter().map(|ray| ray.factors.weight).collect();
        self.conventions.weight_from_camera = true;
        for (index, &product) in weights.iter().enumerate() {
            let before = self.parents[index].map_or(Some(Rgb::WHITE), |parent| {
                let is_root = self.parents[parent].is_none();
                weights[parent].or(is_root.then_some(Rgb::WHITE))
            });
            let factors = &mut self.log.rays[index].factors;
            factors.weight = product.zip(before).map(|(product, before)| {
                let [p, b] = [product, before].map(Rgb::to_array);
                Rgb::from([0, 1, 2].map(|at| if b[at] == 0.0 { 0.0 } else { p[at] / b[at] }))
            });
            factors.throughput = factors.throughput.or(product);
        }
    }

    /// The ray and those that sent it, up to the camera's or a thousand.
    pub fn way_up(&self, index: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(index), |&at| self.parents[at]).take(LONGEST_WAY)
    }

    /// The ray that no other sent, from which this one comes.
    pub fn root(&self, index: usize) -> usize {
        std::iter::successors(Some(index), |&at| self.parents[at]).last().unwrap_or(index)
    }

    /// The world of the scene that the head names, with its lamps, materials and camera.
    pub fn scene_world(&self) -> Option<&World> {
        self.world.as_deref().filter(|_| self.log.head.scene.is_some())
    }

    /// The rays with their indices.
    pub fn rays(&self) -> impl Iterator<Item = (usize, &Ray)> {
        self.log.rays.iter().enumerate()
    }

    /// The ray of this index.
    pub fn ray(&self, index: usize) -> &Ray {
        &self.log.rays[index]
    }

    /// The ray that sent it.
    pub fn parent(&self, index: usize) -> Option<&Ray> {
        self.parents[index].map(|parent| self.ray(parent))
    }

    /// Rays with their senders: both indices.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> {
        self.parents.iter().enumerate().filter_map(|(index, parent)| Some((index, (*parent)?)))
    }

    /// Where a ray ended: its `point`, or where its `t` leads by the program's convention.
    pub fn end_point(&self, index: usize) -> Option<Point> {
        let ray = self.ray(index);
        ray.point.or_else(|| Some(self.along(ray, ray.t?)))
    }

    /// The point at `t` along a ray.
    pub fn along(&self, ray: &Ray, t: f64) -> Point {
        let length = if self.conventions.t_is_length { ray.direction.length() } else { 1.0 };
        ray.origin + (t / length) * ray.direction
    }

    /// The largest error of a position that is worked out from points of this size.
    pub fn slack(&self, sizes: f64) -> f64 {
        STEPS * (self.rounding * sizes + self.fixed)
    }

    /// The error of a point at the end of a ray that its direction has from a fixed number of decimals.
    pub fn slack_along(&self, ray: &Ray) -> f64 {
        STEPS * self.fixed * ray.t.filter(|t| t.is_finite()).unwrap_or(0.0).abs()
    }

    /// The same relative to 1.
    pub fn tolerance(&self) -> f64 {
        STEPS * self.rounding + 4.0 * self.fixed
    }

    /// The way from the origin of a shadow ray to the end that it gives for the lamp.
    pub fn way_to_lamp(&self, ray: &Ray) -> Option<Vector> {
        Some(self.along(ray, ray.end?) - ray.origin)
    }

    /// The largest coordinate that a program computes with for this object.
    pub fn object_size(&self, object: Option<&Arc<str>>) -> f64 {
        object.and_then(|name| self.sizes.get(name)).copied().unwrap_or(0.0)
    }

    /// What people call the ray: its own name, or its line.
    pub fn name(&self, index: usize) -> String {
        let ray = self.ray(index);
        let kind = ray.kind.as_ref().map_or(String::new(), |kind| format!(" ({kind})"));
        match &ray.id {
            Some(id) => format!("ray {id}{kind}"),
            None => format!("the ray of line {}{kind}", ray.line),
        }
    }

    /// Finds the senders; those that are not named only if `guesses`, which needs to know how long rays are.
    fn link(&mut self, guesses: bool) {
        let found: Vec<Senders> =
            self.samples().par_iter().map(|rays| self.senders(rays, guesses)).collect();
        let count = self.log.rays.len();
        (self.parents, self.children) = (vec![None; count], vec![Vec::new(); count]);
        (self.orphans, self.guessed) = (Vec::new(), 0);
        for of_sample in found {
            self.guessed += of_sample.guessed;
            self.orphans.extend(of_sample.orphans);
            for (ray, parent) in of_sample.parents {
                self.parents[ray] = Some(parent);
                self.children[parent].push(ray);
            }
        }
    }

    /// The rays of each sample, in the order of the log.
    fn samples(&self) -> Vec<Vec<usize>> {
        let (mut samples, mut places) = (Vec::<Vec<usize>>::new(), HashMap::new());
        let mut last = (None, 0);
        for (index, ray) in self.log.rays.iter().enumerate() {
            let key = (ray.pixel, ray.sample);
            // most rays follow another one of their sample
            if last.0 != Some(key) {
                last = (Some(key), *places.entry(key).or_insert(samples.len()));
                samples.resize(samples.len().max(last.1 + 1), Vec::new());
            }
            samples[last.1].push(index);
        }
        samples
    }

    fn senders(&self, rays: &[usize], guesses: bool) -> Senders {
        let mut found = Senders::default();
        let mut names: Vec<(&Id, usize)> =
            rays.iter().filter_map(|&it| Some((self.ray(it).id.as_ref()?, it))).collect();
        names.sort();
        let twins = names.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        found.orphans.extend(twins.map(|pair| (pair[1].1, Orphan::Twin)));
        let named = |id: &Id| {
            let after = names.partition_point(|(name, _)| *name <= id);
            names[..after].last().filter(|(name, _)| *name == id).map(|(_, ray)| *ray)
        };
        for (place, &index) in rays.iter().enumerate() {
            let ray = self.ray(index);
            let parent = match &ray.parent {
                Some(id) => named(id),
                None if ray.is(&Purpose::Camera) || !guesses => None,
                None => self.guess(index, rays, place),
            };
            found.guessed += usize::from(parent.is_some() && ray.parent.is_none());
            found.parents.extend(parent.map(|parent| (index, parent)));
            let is_lost = parent.is_none() && ray.parent.is_some();
            found.orphans.extend(is_lost.then_some((index, Orphan::Parentless)));
        }
        found.break_cycles();
        found
    }

    /// The ray that ended where this one starts: before it in the log, or else after it, as a recursion writes that notes a ray
    /// when it is finished.
    fn guess(&self, index: usize, rays: &[usize], place: usize) -> Option<usize> {
        let start = self.ray(index).origin;
        let distance = |&other: &usize| {
            let end = (!self.ray(other).is_shadow()).then(|| self.end_point(other)).flatten()?;
            Some((other, end.distance(start))).filter(|&(_, far)| far <= 1e-3 * self.scale)
        };
        let before = rays[place.saturating_sub(LOOKED_AROUND)..place].iter().rev();
        let after = rays[place + 1..rays.len().min(place + 1 + LOOKED_AROUND)].iter();
        // of equally near ones the nearest in the log
        let nearest =
            |(a, far): (usize, f64), b: (usize, f64)| if b.1 < far { b } else { (a, far) };
        let [before, after] = [
            before.filter_map(distance).reduce(nearest),
            after.filter_map(distance).reduce(nearest),
        ];
        // a recursion that notes a ray when it is finished has the camera's ray last
        let is_last = rays.last().is_some_and(|&last| self.ray(last).is(&Purpose::Camera));
        let found = if is_last { after.or(before) } else { before.or(after) };
        found.map(|(other, _)| other)
    }
}

/// What is found of the rays of one sample.
#[derive(Default)]
struct Senders {
    /// Rays with the rays that sent them, in the order of the log.
    parents: Vec<(usize, usize)>,
    orphans: Vec<(usize, Orphan)>,
    guessed: usize,
}

impl Senders {
    /// Cuts circles of senders, so that all that walks the tree ends.
    fn break_cycles(&mut self) {
        if self.parents.iter().all(|(ray, parent)| parent < ray) {
            return;
        }
        let mut up: HashMap<usize, usize> = self.parents.iter().copied().collect();
        let mut known_to_end = HashSet::new();
        for &(start, _) in &self.parents {
            let mut way = HashSet::new();
            let mut at = start;
            while !known_to_end.contains(&at) && way.insert(at) {
                let Some(parent) = up.get(&at) else { break };
                at = *parent;
            }
            if !known_to_end.contains(&at) && up.contains_key(&at) {
                self.orphans.push((at, Orphan::InCircle));
                up.remove(&at);
            }
            known_to_end.extend(way);
        }
        self.parents.retain(|(ray, _)| up.contains_key(ray));
    }
}

/// How far nearly all hits are from the true surfaces, if it is more than rounding and less than a picture shows.
fn hits_are_off(traced: &Traced) -> f64 {
    let step = traced.log.rays.len().div_ceil(LOOKED_AT);
    let off =
        (0..traced.log.rays.len()).step_by(step).filter_map(|it| distance_to_truth(traced, it));
    let mut off: Vec<[f64; 2]> = off.collect();
    let beyond = off.iter().filter(|[off, rounding]| off > rounding).count();
    off.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let most = off.get(off.len() * 98 / 100).map_or(0.0, |it| it[0]);
    let is_habit = off.len() >= 8 && 2 * beyond >= off.len() && most <= 1e-3 * traced.scale;
    if is_habit { 2.0 * most } else { 0.0 }
}

fn least_t(traced: &Traced) -> f64 {
    let sent = traced.pairs().map(|(index, _)| traced.ray(index)).filter(|ray| !ray.is_shadow());
    let least = sent.filter_map(|ray| ray.t).filter(|t| *t > 0.0).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least.min(traced.small) } else { 0.0 }
}

fn sizes(world: Option<&World>) -> HashMap<Arc<str>, f64> {
    let size_of = |object: &PlacedObject| {
        let bounds = object.shape.bounds();
        bounds.is_bounded().then(|| (Arc::clone(&object.name), bounds.largest_coordinate()))
    };
    world.map_or(HashMap::new(), |world| world.objects().iter().filter_map(size_of).collect())
}

/// The median of the lengths of such rays: a single far point does not change it.
fn scale(log: &Log, counts: impl Fn(&Ray) -> bool) -> Option<f64> {
    let rays = log.rays.iter().filter(|ray| counts(ray));
    let lengths = rays.filter_map(|ray| Some(ray.end_point()?.distance(ray.origin)));
    median(lengths.filter(|length| length.is_finite() && *length > 0.0).collect())
}

/// The middle one; of an even number the lower of the two.
pub fn median(mut numbers: Vec<f64>) -> Option<f64> {
    let middle = numbers.len().checked_sub(1)? / 2;
    Some(*numbers.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// The largest coordinate.
pub fn size(vector: impl Into<[f64; 3]>) -> f64 {
    Vector::from(vector.into()).max_abs()
}

/// Names in the order in which they come, with their places.
fn places<'a>(all: impl Iterator<Item = &'a Arc<str>>) -> HashMap<Arc<str>, u32> {
    let mut places = HashMap::new();
    for name in all {
        let next = places.len() as u32;
        places.entry(Arc::clone(name)).or_insert(next);
    }
    places
}
