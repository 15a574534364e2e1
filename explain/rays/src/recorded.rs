//! A sample of a log as the record that an explanation is made of: what draws, sections and plots does not know whose ray
//! it is.

use std::collections::HashMap;
use std::sync::Arc;

use explain::{RecordedHit, RecordedRay};
use groundtruth::math::{Normal, Ray, Vector, atan2, to_degrees};
use groundtruth::rgb::Rgb;
use groundtruth::shapes::PartPath;
use groundtruth::trace::{Outcome, RayKind};

use crate::log::{Id, Purpose};
use crate::traced::Traced;

/// A tree of records, and the index in the log of each of its rays by their numbers.
#[derive(Clone, Debug)]
pub struct Recorded {
    /// The camera's ray.
    pub root: RecordedRay,
    /// The rays' indices in the log, in the order of the tree.
    pub indices: Vec<usize>,
    /// Their numbers in the log, if it counts them in this order; else they are counted from 0.
    pub numbers: Option<Vec<usize>>,
}

/// The most rays of a tree: deeper or larger ones are cut.
const MAX_RAYS: usize = 1 << 17;
/// The deepest ray: drawings walk the tree by recursion.
const MAX_DEPTH: usize = 512;

impl Recorded {
    /// The ray of this index with all after it.
    pub fn of(traced: &Traced, index: usize) -> Self {
        let whole = traced.ray(index).radiance.map_or(0.0, Rgb::average);
        let mut builder = Builder { traced, whole, indices: Vec::new() };
        let root = builder.ray(index, None, 0, Rgb::WHITE);
        let mut recorded = Self { root, indices: builder.indices, numbers: None };
        recorded.numbers = recorded.own_numbers(traced);
        if let Some(numbers) = &recorded.numbers {
            renumber(&mut recorded.root, numbers);
        }
        recorded
    }

    /// The rays' own names, if they are numbers in the order of the tree.
    fn own_numbers(&self, traced: &Traced) -> Option<Vec<usize>> {
        let number = |index: &usize| match traced.ray(*index).id {
            Some(Id::Number(number)) => usize::try_from(number).ok(),
            _ => None,
        };
        let numbers: Vec<usize> = self.indices.iter().map(number).collect::<Option<_>>()?;
        numbers.is_sorted_by(|a, b| a < b).then_some(numbers)
    }

    /// The number of the ray that has this index in the log.
    pub fn number(&self, index: usize) -> Option<usize> {
        self.by_number().find(|(_, it)| *it == index).map(|(number, _)| number)
    }

    /// The number of each ray, and its index in the log.
    pub fn by_number(&self) -> impl Iterator<Item = (usize, usize)> {
        let number = |place: usize| self.numbers.as_ref().map_or(place, |numbers| numbers[place]);
        self.indices.iter().enumerate().map(move |(place, index)| (number(place), *index))
    }
}

/// Gives each ray, now counted from 0, its number.
fn renumber(ray: &mut RecordedRay, numbers: &[usize]) {
    ray.number = numbers[ray.number];
    ray.parent = ray.parent.map(|parent| numbers[parent]);
    ray.children.iter_mut().for_each(|child| renumber(child, numbers));
}

struct Builder<'a> {
    traced: &'a Traced,
    /// What the root brings.
    whole: f64,
    indices: Vec<usize>,
}

impl Builder<'_> {
    fn ray(
        &mut self,
        index: usize,
        parent: Option<usize>,
        depth: u32,
        throughput: Rgb,
    ) -> RecordedRay {
        let number = self.indices.len();
        self.indices.push(index);
        let ray = self.traced.ray(index);
        let place = |places: &HashMap<Arc<str>, u32>, name: &Option<Arc<str>>| {
            name.as_ref().and_then(|name| places.get(name)).copied().unwrap_or(u32::MAX)
        };
        let [lights, objects] = &self.traced.places;
        let light = place(lights, &ray.light);
        let kind = match ray.kind {
            Some(Purpose::Shadow | Purpose::Occlusion) => RayKind::Shadow { light },
            Some(Purpose::Transmitted) => RayKind::Transmitted,
            _ if parent.is_none() => RayKind::Camera,
            _ => RayKind::Reflected,
        };
        let hit = self.hit(index);
        let blocked_by = place(objects, &ray.object);
        let outcome = match (ray.is_shadow(), &hit) {
            (true, Some(_)) => Outcome::Blocked { blocked_by },
            (true, None) => Outcome::Unblocked { boundaries: 0 },
            (false, Some(_)) => Outcome::Hit,
            (false, None) => Outcome::Background,
        };
        let weight = ray.factors.weight.unwrap_or(Rgb::WHITE);
        let throughput = throughput * weight;
        let radiance = ray.radiance.unwrap_or(Rgb::BLACK);
        let contribution = throughput * radiance;
        let share = (contribution.average() / self.whole).clamp(0.0, 1.0);
        // the way to a lamp with a place is the direction itself, as in our own records
        let length = ray.end.filter(|_| ray.is_shadow()).unwrap_or(1.0);
        let mut record = RecordedRay {
            number,
            parent,
            kind,
            light: ray.light.clone(),
            depth,
            ray: Ray::new(ray.origin, length * ray.direction),
            weight,
            outcome,
            hit,
            blocked_by: ray.object.clone().filter(|_| ray.is_shadow()),
            terms: Vec::new(),
            unlit: Vec::new(),
            black: None,
            transmittance: Rgb::WHITE,
            radiance,
            contribution,
            own_contribution: throughput
                * (ray.emitted.unwrap_or(Rgb::BLACK) + ray.direct.unwrap_or(Rgb::BLACK)),
            share: if self.whole > 0.0 { share } else { 0.0 },
            children: Vec::new(),
        };
        for &child in &self.traced.children[index] {
            if self.indices.len() < MAX_RAYS && (depth as usize) < MAX_DEPTH {
                record.children.push(self.ray(child, Some(number), depth + 1, throughput));
            }
        }
        record
    }

    fn hit(&self, index: usize) -> Option<RecordedHit> {
        let ray = self.traced.ray(index);
        let point = self.traced.end_point(index).filter(|point| point.is_finite())?;
        let back = || Normal::new(-ray.direction);
        let normal = ray.normal.and_then(Normal::new).or_else(back)?;
        let along = Vector::from(normal).dot(ray.direction);
        let across = Vector::from(normal).cross(ray.direction).length();
        Some(RecordedHit {
            object: ray.object.clone().unwrap_or_else(|| "?".into()),
            material: "".into(),
            path: PartPath::default(),
            t: ray.t.unwrap_or_else(|| (point - ray.origin).length() / ray.direction.length()),
            point,
            error: 0.0,
            normal,
            shading_normal: ray.shading_normal.and_then(Normal::new).unwrap_or(normal),
            front: ray.front.unwrap_or(along <= 0.0),
            angle_of_incidence: to_degrees(atan2(across, along.abs())),
            cos_o: -along / ray.direction.length(),
            optics: None,
            textures: Vec::new(),
            is_emissive: false,
            is_switched_off: false,
        })
    }
}
