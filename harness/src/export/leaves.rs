//! Objects taken apart into leaves: shapes that other renderers have, each under one map.

use groundtruth::math::Transform;
use groundtruth::scene::Scene;
use groundtruth::shapes::{Instance, Kind, transform_of};

use super::parts::{Part, parts};
use super::{Unsayable, item, kinds};

/// A shape that is no compound, no instance and no solid of named parts.
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
    /// In the order of the objects and their parts.
    pub all: Vec<Leaf>,
    /// Names of materials that are none, and maps without an inverse.
    pub unsayable: Vec<Unsayable>,
}

impl<'a> Leaves<'a> {
    /// Of the objects that are part of the scene.
    pub fn of(scene: &'a Scene) -> Self {
        let mut leaves = Self { scene, all: Vec::new(), unsayable: Vec::new() };
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
        self.unsayable.push(Unsayable { path: path.to_owned(), problem });
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
            Kind::Instance(instance) => self.instance(instance, at),
            Kind::Compound(_)
            | Kind::SolidCylinder(_)
            | Kind::SolidCone(_)
            | Kind::ThickRing(_) => {
                parts(kind).into_iter().flatten().for_each(|part| self.part(&part, at));
            }
            _ => {
                let Setting { path, map, texture, material, object, casts_shadows, .. } =
                    at.clone();
                let shape = kind.clone();
                let leaf = Leaf { shape, path, map, texture, material, object, casts_shadows };
                self.all.push(leaf);
            }
        }
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
    fn part(&mut self, Part { name, material, shape }: &Part, at: &Setting) {
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
