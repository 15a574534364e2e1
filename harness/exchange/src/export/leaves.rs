//! Objects taken apart into leaves: shapes that other renderers have, each under one map.

use groundtruth::math::Transform;
use groundtruth::scene::Scene;
use groundtruth::shapes::{Instance, Kind, transform_of};

use super::parts::{self, SolidPart, parts};
use super::{Target, Unsupported, item, kinds};

/// More shapes are refused: their text would be of many megabytes.
pub const MOST_SHAPES: u64 = 200_000;

/// A shape that is not taken apart.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// The shape.
    pub shape: Kind,
    /// Its place in the scene.
    pub path: String,
    /// From its coordinates to the world's.
    pub map: Transform,
    /// From the coordinates in which its texture is looked up to the world's.
    pub texture: Transform,
    /// The index of its material.
    pub material: usize,
    /// The index of its object.
    pub object: usize,
    /// How many shapes of its object are before it.
    pub number: u64,
    /// Whether its object casts shadows; its material may not.
    pub casts_shadows: bool,
}

/// Where a shape stands, and what it is made of.
#[derive(Clone)]
struct Setting {
    path: String,
    map: Transform,
    texture: Transform,
    /// Whether an instance around it keeps its texture where it is: then instances in it do not move it.
    is_still: bool,
    material: usize,
    object: usize,
    casts_shadows: bool,
}

/// The objects of a scene taken apart.
#[derive(Debug)]
pub struct Leaves<'a> {
    scene: &'a Scene,
    /// What it has no word for is taken apart.
    target: Target,
    /// How many shapes of the object are in `all` already.
    number: u64,
    /// In the order of the objects and their parts.
    pub all: Vec<Leaf>,
    /// Names of materials that are none, and maps without an inverse.
    pub unsupported: Vec<Unsupported>,
}

impl<'a> Leaves<'a> {
    /// Of the objects that are part of the scene, for a renderer.
    pub fn of(scene: &'a Scene, target: Target) -> Self {
        let mut leaves =
            Self { scene, target, number: 0, all: Vec::new(), unsupported: Vec::new() };
        for (index, object) in scene.objects.iter().enumerate().filter(|(_, it)| it.enabled) {
            let path = item("objects", index, &object.name);
            let Some(material) = leaves.material(&path, &object.material) else { continue };
            let (map, texture) = (Transform::IDENTITY, Transform::IDENTITY);
            let at = Setting {
                path: format!("{path}: shape"),
                map,
                texture,
                is_still: false,
                material,
                object: index,
                casts_shadows: object.casts_shadows,
            };
            leaves.number = 0;
            leaves.shape(&object.shape, &at);
        }
        leaves
    }

    /// The indices of their materials, each once, in the order of their first use.
    pub fn materials(&self) -> Vec<usize> {
        let mut used = Vec::new();
        for leaf in &self.all {
            if !used.contains(&leaf.material) {
                used.push(leaf.material);
            }
        }
        used
    }

    fn refuse(&mut self, path: &str, problem: String) {
        self.unsupported.push(Unsupported { path: path.to_owned(), problem });
    }

    /// The index of a material.
    fn material(&mut self, path: &str, name: &str) -> Option<usize> {
        let index = self.scene.materials.iter().position(|material| material.name == name);
        if index.is_none() {
            self.refuse(path, format!("no material \"{name}\""));
        }
        index
    }

    fn shape(&mut self, kind: &Kind, at: &Setting) {
        let at = &Setting { path: format!("{}.{}", at.path, kinds::tag(kind)), ..at.clone() };
        match kind {
            _ if (self.target.language().apart)(kind).is_none() => self.leaf(kind, at),
            Kind::Instance(instance) => self.instance(instance, at),
            _ if parts::leaves(kind) > MOST_SHAPES => {
                let count = parts::leaves(kind);
                self.refuse(&at.path, format!("{count} shapes, and {MOST_SHAPES} are the most"));
            }
            kind => match parts(kind) {
                Some(parts) => self.parts(parts, at),
                None => self.leaf(kind, at),
            },
        }
    }

    fn leaf(&mut self, kind: &Kind, at: &Setting) {
        let Setting { path, map, texture, material, object, casts_shadows, .. } = at.clone();
        let (shape, number) = (kind.clone(), self.number);
        self.all.push(Leaf { shape, path, map, texture, material, object, number, casts_shadows });
        self.number += 1;
    }

    fn parts(&mut self, parts: Vec<SolidPart>, at: &Setting) {
        parts.iter().for_each(|part| self.part(part, at));
    }

    fn instance(&mut self, instance: &Instance, at: &Setting) {
        match transform_of("transform", &instance.transform) {
            Ok(map) => {
                let moves = instance.transform_texture && !at.is_still;
                let texture = if moves { at.texture.after(&map) } else { at.texture };
                let (path, map) = (format!("{}.of", at.path), at.map.after(&map));
                let at = Setting { path, map, texture, is_still: !moves, ..at.clone() };
                self.shape(&instance.of, &at);
            }
            Err(problem) => self.refuse(&at.path, problem.to_string()),
        }
    }

    /// A part, of a material of its own if it has one.
    fn part(&mut self, SolidPart { name, material, shape }: &SolidPart, at: &Setting) {
        let path = format!("{}.{name}", at.path);
        let material = match material {
            None => Some(at.material),
            Some(name) => self.material(&path, name),
        };
        if let Some(material) = material {
            self.shape(shape, &Setting { path, material, ..at.clone() });
        }
    }
}
