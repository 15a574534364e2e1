//! The context in which a shape is built: materials, files, shapes built before, and limits.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::Arc;

use super::{Kind, Shape, textbook};
use crate::accel;
use crate::invalid::{Invalid, MAX_NESTING};
use crate::kinds::Resources;
use crate::math::Transform;
use formats::meshes::MeshData;
use formats::printable::{self, listed};

/// More triangles in one scene would take gigabytes, up to 300 bytes each while trees are built.
const MAX_TRIANGLES: u64 = 1 << 22;
/// More parts of compounds in one scene would, too.
const MAX_PARTS: u64 = 1 << 22;

/// The files of the scene, the shapes built so far, and the limits. Equal meshes, and instances of
/// one mesh file, are built once and shared.
#[derive(Debug, Default)]
pub struct Context {
    resources: Resources,
    accel: accel::Method,
    /// The epsilon of the book's routines, where these are asked for.
    textbook: Option<f64>,
    shared: HashMap<String, Arc<dyn Shape>>,
    materials: Materials,
    budget: PrimitiveBudget,
    nesting: Nesting,
}

/// The materials that objects and parts may name, and those that were given to something.
#[derive(Debug)]
struct Materials {
    known: BTreeMap<String, PartMaterial>,
    /// Whether parts without a material of their own cast shadows.
    inherited: bool,
    used: Vec<PartMaterial>,
    /// How many times a material that casts shadows was given to something.
    casting: u64,
}

impl Default for Materials {
    fn default() -> Self {
        Self { known: BTreeMap::new(), inherited: true, used: Vec::new(), casting: 0 }
    }
}

/// The numbers of triangles and parts built so far.
#[derive(Debug, Default)]
struct PrimitiveBudget {
    triangles: u64,
    parts: u64,
}

/// The shapes around the one that is being built.
#[derive(Debug)]
struct Nesting {
    depth: usize,
    /// The product of the maps of the instances around it.
    around: Transform,
}

impl Default for Nesting {
    fn default() -> Self {
        Self { depth: 0, around: Transform::IDENTITY }
    }
}

/// The material of a part of a compound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartMaterial {
    /// Its index in the scene.
    pub index: u32,
    /// Whether it blocks light.
    pub casts_shadows: bool,
}

impl Context {
    /// Meshes and compounds use `accel` unless they name their own.
    pub fn new(resources: Resources, accel: accel::Method) -> Self {
        Self { resources, accel, ..Self::default() }
    }

    /// Objects and parts of compounds may name these materials.
    #[must_use]
    pub fn with_materials(self, known: BTreeMap<String, PartMaterial>) -> Self {
        Self { materials: Materials { known, ..Materials::default() }, ..self }
    }

    /// What is built next is hit as the book does, with this epsilon; `None` for the library's own
    /// routines.
    pub fn set_textbook(&mut self, epsilon: Option<f64>) {
        self.textbook = epsilon;
    }

    /// The epsilon of the book's routines, where what is built is hit as the book does.
    pub(super) fn textbook(&self) -> Option<f64> {
        self.textbook
    }

    /// What was ignored or clamped in the files read so far, in sentences for the user.
    pub fn notes(&self) -> &[String] {
        self.resources.notes()
    }

    /// The material of this name.
    ///
    /// # Errors
    /// [`Invalid`] lists the names there are.
    pub fn material(&self, name: &str) -> Result<PartMaterial, Invalid> {
        self.materials.known.get(name).copied().ok_or_else(|| {
            let known = listed(self.materials.known.keys());
            let name = printable::name(name);
            Invalid::field("material", format!("no material `{name}`; defined are: {known}"))
        })
    }

    /// Builds an object of a material, and returns the materials of it and of its parts.
    ///
    /// # Errors
    /// As the shape's own data.
    pub fn object(
        &mut self,
        shape: &Kind,
        material: PartMaterial,
    ) -> Result<(Arc<dyn Shape>, Vec<PartMaterial>), Invalid> {
        self.materials.used.clear();
        let mut shape = self.within(Some(material), |context| shape.build(context))?;
        if let Some(epsilon) = self.textbook {
            shape = textbook::object(shape, epsilon);
        }
        Ok((shape, std::mem::take(&mut self.materials.used)))
    }

    /// Builds the shape of a part of this material, and returns whether anything in it casts
    /// shadows. A shape without a material of its own inherits that of the part, and a part that of
    /// the shape around it.
    pub(super) fn part(
        &mut self,
        shape: &Kind,
        material: Option<PartMaterial>,
    ) -> Result<(Arc<dyn Shape>, bool), Invalid> {
        let before = self.materials.casting;
        let built = self.nested(|context| context.within(material, |c| shape.build(c)))?;
        let as_around = material.is_none() && self.materials.inherited;
        Ok((built, as_around || self.materials.casting > before))
    }

    /// Builds a shape inside a part of this material.
    pub(super) fn within<T>(
        &mut self,
        material: Option<PartMaterial>,
        build: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let outer = self.materials.inherited;
        if let Some(material) = material {
            self.materials.inherited = material.casts_shadows;
            self.materials.casting += u64::from(material.casts_shadows);
            if !self.materials.used.contains(&material) {
                self.materials.used.push(material);
            }
        }
        let built = build(self);
        self.materials.inherited = outer;
        built
    }

    /// Adds so many parts to those built so far, if the scene may have as many.
    pub(super) fn take_parts(&mut self, count: u64) -> Result<(), Invalid> {
        self.budget.parts = self.budget.parts.saturating_add(count);
        if self.budget.parts > MAX_PARTS {
            return Err(Invalid::new(format!(
                "{} parts so far are too many; at most {MAX_PARTS} fit",
                self.budget.parts
            )));
        }
        Ok(())
    }

    /// The acceleration of a mesh that names none.
    pub fn accel(&self) -> accel::Method {
        self.accel
    }

    /// The contents of a mesh file, read once.
    pub(super) fn mesh(&mut self, file: &Path) -> Result<Arc<MeshData>, Invalid> {
        self.resources.mesh(file)
    }

    /// Adds so many triangles to those built so far, if the scene may have as many.
    pub(super) fn add_triangles(&mut self, count: u64) -> Result<(), Invalid> {
        self.budget.triangles += count;
        if self.budget.triangles > MAX_TRIANGLES {
            return Err(Invalid::new(format!(
                "{count} triangles, with the meshes before it {}, are too many; \
                 at most {MAX_TRIANGLES} fit",
                self.budget.triangles
            )));
        }
        Ok(())
    }

    /// The shape built from equal data before, or a new one. Data are equal if they print
    /// the same: numbers print every digit.
    pub(super) fn shared<T: std::fmt::Debug>(
        &mut self,
        data: &T,
        build: impl FnOnce(&mut Self) -> Result<Arc<dyn Shape>, Invalid>,
    ) -> Result<Arc<dyn Shape>, Invalid> {
        let key = format!("{:?} {data:?}", self.textbook);
        if let Some(known) = self.shared.get(&key) {
            return Ok(Arc::clone(known));
        }
        let built = build(self)?;
        self.shared.insert(key, Arc::clone(&built));
        Ok(built)
    }

    /// Builds the shape of an instance, unless it is nested too deep, or its map is singular
    /// together with those around it.
    pub(super) fn transformed<T>(
        &mut self,
        transform: &Transform,
        build: impl FnOnce(&mut Self) -> Result<T, Invalid>,
    ) -> Result<T, Invalid> {
        let around = self.nesting.around;
        self.nesting.around = around.checked_after(transform).map_err(|singular| {
            let problem = format!("with the instances around it, {singular}");
            Invalid::field("transform", problem)
        })?;
        let built = self.nested(build).map_err(|e| e.inside("of"));
        self.nesting.around = around;
        built
    }

    /// Builds a nested shape, unless it is nested too deep.
    pub(super) fn nested<T>(
        &mut self,
        build: impl FnOnce(&mut Self) -> Result<T, Invalid>,
    ) -> Result<T, Invalid> {
        if self.nesting.depth == MAX_NESTING {
            return Err(Invalid::new(format!(
                "more than {MAX_NESTING} shapes are nested in one another; leave out a level, or combine transforms"
            )));
        }
        self.nesting.depth += 1;
        let built = build(self);
        self.nesting.depth -= 1;
        built
    }
}
