//! Where a difference is, if it is in one object or in the objects of one material alone.

use std::collections::BTreeMap;

use groundtruth::scene::{Material, Scene};
use serde::Serialize;
use serde_json::Value;

use super::evidence::{Evidence, finite};

/// The object to which a difference is confined, or the objects of one material.
#[derive(Clone, Debug, Serialize)]
pub struct Place {
    /// The objects, by their names.
    pub objects: Vec<String>,
    /// The name of their material; `None` for the background.
    pub material: Option<String>,
    /// What the material is, in words.
    pub about: String,
    /// The part of the squared difference that is there, weighted by the noise.
    pub share: f64,
}

/// A difference is in one place if at least this part of its squares is.
const MOST: f64 = 0.9;

/// And only there if at least this part is: what is left may be noise.
pub(super) const ALL: f64 = 0.98;

/// Other objects have at least this part of the pixels: else that says nothing.
const OTHERS: f64 = 0.05;

/// A part of an object within a tile: sums of a channel over its pixels.
#[derive(Clone, Copy, Default)]
struct Part {
    theirs: f64,
    ours: f64,
    variance: f64,
    noise: f64,
}

impl Part {
    /// The weighted square of the difference, less that of noise.
    fn square(&self) -> f64 {
        let difference = self.theirs - self.ours;
        let square = difference * difference - self.noise;
        if self.variance > 0.0 { square / self.variance } else { 0.0 }
    }
}

impl Place {
    /// Where a difference from our pictures of a scene is; `None` if it is in several places.
    pub fn of(evidence: &Evidence<'_>, scene: &Scene) -> Option<Self> {
        let areas = evidence.areas;
        let parts = parts(evidence);
        let square = |part: &[Part; 3]| part.iter().map(Part::square).sum::<f64>();
        let squares: Vec<f64> = parts.iter().map(|its| its.iter().map(square).sum()).collect();
        let whole: f64 = squares.iter().map(|it| it.max(0.0)).sum();
        let material_of = |object: usize| {
            let name = &*areas.objects[object].0;
            scene.objects.iter().find(|it| it.name == name).map(|it| it.material.clone())
        };
        let total = areas.object_of.len() as f64;
        let is_it = |objects: &[usize]| {
            let pixels: u32 = objects.iter().map(|object| areas.objects[*object].1).sum();
            let its: f64 = objects.iter().map(|object| squares[*object]).sum();
            whole > 0.0 && its >= MOST * whole && 1.0 - f64::from(pixels) / total >= OTHERS
        };
        let mut of_material: BTreeMap<Option<String>, Vec<usize>> = BTreeMap::new();
        for object in 0..squares.len() {
            of_material.entry(material_of(object)).or_default().push(object);
        }
        let single = (0..squares.len()).map(|object| vec![object]);
        let objects = single.chain(of_material.into_values()).find(|objects| is_it(objects))?;
        let material = material_of(objects[0]);
        let material = scene.materials.iter().find(|it| Some(&it.name) == material.as_ref());
        let share = objects.iter().map(|object| squares[*object]).sum::<f64>() / whole;
        Some(Self {
            objects: objects.iter().map(|it| areas.objects[*it].0.to_string()).collect(),
            material: material.map(|it| it.name.clone()),
            about: material.map(about).unwrap_or_default(),
            share: share.min(1.0),
        })
    }
}

/// For each object, its parts over tiles.
fn parts(evidence: &Evidence<'_>) -> Vec<Vec<[Part; 3]>> {
    let (areas, side) = (evidence.areas, evidence.side());
    let [width, across] = [areas.size[0], areas.size[0].div_ceil(side)];
    let mut parts: Vec<BTreeMap<usize, [Part; 3]>> = vec![BTreeMap::new(); areas.objects.len()];
    for (pixel, object) in areas.object_of.iter().enumerate() {
        let tile = pixel / width / side * across + pixel % width / side;
        let part = parts[*object as usize].entry(tile).or_default();
        for (channel, part) in part.iter_mut().enumerate() {
            let at = 3 * pixel + channel;
            if evidence.theirs[at].is_finite() {
                part.theirs += evidence.theirs[at];
                part.ours += finite(evidence.mean[at]);
                part.variance += evidence.variances[at];
                part.noise += evidence.noise[at];
            }
        }
    }
    parts.into_iter().map(|its| its.into_values().collect()).collect()
}

/// A material in words: its kind, and which fields have textures.
fn about(material: &Material) -> String {
    let Ok(Value::Object(recipe)) = serde_json::to_value(&material.recipe) else {
        return String::new();
    };
    let Some((kind, fields)) = recipe.into_iter().next() else { return String::new() };
    let mut words = vec![kind];
    collect(&fields, &mut words);
    let bump = if material.bump.is_some() { ", with bumps" } else { "" };
    words.join(", ") + bump
}

/// Adds fields that are textures: tables of one key, the texture's kind.
fn collect(fields: &Value, words: &mut Vec<String>) {
    let Value::Object(fields) = fields else { return };
    for (field, value) in fields {
        let only = value.as_object().filter(|table| table.len() == 1);
        match only.and_then(|table| table.iter().next()) {
            Some((kind, Value::Object(_))) => words.push(format!("{field} is the texture {kind}")),
            _ => collect(value, words),
        }
    }
}
