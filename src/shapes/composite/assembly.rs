//! Shapes made of shapes, built: what a compound, a beveled box and a lattice have in common.
//!
//! A hit remembers which of all nested shapes it is on as one number, [`Candidate::leaf`]: those of
//! the first part come first, then those of the second. So it stays as small as for a sphere,
//! however deep the nesting (a hundred instances eight levels deep are 10¹⁶ leaves), and the order
//! of leaves is the order of objects that settles ties.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::accel::{Accel, Method, Primitives};
use crate::invalid::{Invalid, Key};
use crate::math::{Aabb, Ray, Span, Transform, Vector};
use crate::shapes::{Candidate, Context, Facet, Kind, Level, PartPath, Shape, Surface};

/// Up to this many parts are tried one after the other unless the scene says how.
const FEW: usize = 8;

/// A part as a scene describes it.
pub struct PartData<'a> {
    /// What people call it; empty if they do not.
    pub name: &'a str,
    /// The name of its material; that of the whole if `None`.
    pub material: Option<&'a str>,
    /// Its form.
    pub shape: &'a Kind,
}

/// The materials of a solid's parts, by the names that its kind gives them.
pub type Materials = BTreeMap<String, String>;

/// Builds a solid of parts that its kind names; `materials` is its field of that name.
pub fn solid(
    parts: &[(&'static str, Kind)],
    materials: &Materials,
    context: &mut Context,
) -> Result<Arc<dyn Shape>, Invalid> {
    smooth_solid(parts, materials, None, 0.0, context)
}

/// The same, searched in this way, of parts that touch without an angle: a ray that leaves one of
/// them at a seam must not meet the other, so no bound of a hit's error is below `least_error`.
pub fn smooth_solid(
    parts: &[(&'static str, Kind)],
    materials: &Materials,
    accel: Option<Method>,
    least_error: f64,
    context: &mut Context,
) -> Result<Arc<dyn Shape>, Invalid> {
    let names: BTreeSet<&str> = parts.iter().map(|(name, _)| *name).collect();
    if let Some(unknown) = materials.keys().find(|name| !names.contains(name.as_str())) {
        let known = Vec::from_iter(names).join(", ");
        let problem = format!("no part `{unknown}`; there are: {known}");
        return Err(Invalid::field("materials", problem));
    }
    for (part, name) in materials {
        // under the name that its user wrote, not that of the part it is for
        let checked = context.material(name).map_err(|e| Invalid::field(part, e.problem));
        checked.map_err(|e| e.inside("materials"))?;
    }
    let parts = parts.iter().map(|(name, shape)| {
        let material = materials.get(*name).map(String::as_str);
        PartData { name, material, shape }
    });
    // walls and disks are hit inside their own boxes only
    let assembly = Assembly::build("parts", parts, accel, context)?.in_turn_if_few(accel);
    Ok(Arc::new(Assembly { least_error, ..assembly }))
}

/// Parts that are hit as one shape.
#[derive(Debug)]
pub struct Assembly {
    parts: Vec<Part>,
    /// The number of each part's first leaf, and of all leaves.
    leaves: Vec<u64>,
    /// All parts are tried in turn if `None`.
    accel: Option<Accel>,
    bounds: Aabb,
    /// A hit's error is at least this.
    least_error: f64,
}

#[derive(Debug)]
struct Part {
    name: Box<str>,
    shape: Arc<dyn Shape>,
    bounds: Aabb,
    material: Option<u32>,
    /// Whether it, or anything in it, does.
    casts_shadows: bool,
}

impl Assembly {
    /// Builds the parts; errors name `field`, where they stand in the scene.
    pub fn build<'a>(
        field: &str,
        parts: impl IntoIterator<Item = PartData<'a>>,
        accel: Option<Method>,
        context: &mut Context,
    ) -> Result<Self, Invalid> {
        let mut built = Vec::new();
        for (index, part) in parts.into_iter().enumerate() {
            let name = Some(part.name).filter(|name| !name.is_empty()).map(str::to_owned);
            let here = |e: Invalid| e.inside(Key::Item(index, name.clone())).inside(field);
            context.take_parts(1).map_err(&here)?;
            let material =
                part.material.map(|name| context.material(name)).transpose().map_err(&here)?;
            let (shape, casts_shadows) =
                context.part(part.shape, material).map_err(|e| here(e.inside("shape")))?;
            let (bounds, material) = (shape.bounds(), material.map(|m| m.place));
            let name = part.name.into();
            built.push(Part { name, shape, bounds, material, casts_shadows });
        }
        let built = Self::of(built, accel, context).map_err(|e| e.inside(field))?;
        // as the book's compound
        let by_the_book = context.textbook().is_some() && accel.is_none();
        Ok(if by_the_book { built.in_turn() } else { built })
    }

    fn of(parts: Vec<Part>, accel: Option<Method>, context: &Context) -> Result<Self, Invalid> {
        let mut leaves = vec![0_u64];
        for part in &parts {
            let so_far = leaves[leaves.len() - 1];
            let next = so_far.checked_add(part.shape.leaves()).ok_or_else(|| {
                Invalid::new("more than 2⁶⁴ shapes are nested here; leave out a level")
            })?;
            leaves.push(next);
        }
        let bounds: Vec<Aabb> = parts.iter().map(|part| part.bounds).collect();
        let few = if parts.len() <= FEW { Method::List } else { context.accel() };
        Ok(Self {
            bounds: bounds.iter().fold(Aabb::EMPTY, |all, &part| all.union(part)),
            accel: Some(Accel::build(accel.unwrap_or(few), &bounds)),
            parts,
            leaves,
            least_error: 0.0,
        })
    }
}

impl Assembly {
    /// Without a structure if the parts are few and the scene does not say how they are searched. A list
    /// finds the same, but asks of every hit whether it counts by its part's box; so this is for parts
    /// that are hit inside their own boxes only.
    pub fn in_turn_if_few(self, accel: Option<Method>) -> Self {
        if accel.is_none() && self.parts.len() <= FEW { self.in_turn() } else { self }
    }

    /// Without a structure.
    fn in_turn(self) -> Self {
        Self { accel: None, ..self }
    }

    /// The first hit as the structure finds it.
    #[inline(never)] // nor the next: most rays pass the box by, and need not make room for this
    fn nearest_by(&self, accel: &Accel, ray: &Ray, span: Span) -> Option<Candidate> {
        let (index, at) = accel.nearest(&Seen { parts: &self.parts, ray }, ray, span)?;
        Some(Candidate { leaf: self.leaves[index as usize] + at.leaf, ..at })
    }

    /// The first hit of all parts in turn.
    #[inline(never)]
    fn nearest_in_turn(&self, ray: &Ray, mut span: Span) -> Option<Candidate> {
        let mut nearest = None;
        for (part, first) in self.parts.iter().zip(&self.leaves) {
            if let Some(at) = part.shape.hit(ray, span) {
                nearest = Some(Candidate { leaf: first + at.leaf, ..at });
                span.max = at.t; // not `through` it: of equal hits the first wins
            }
        }
        nearest
    }

    /// The index of the part that is hit, and the hit as the part sees it.
    fn within(&self, at: &Candidate) -> (usize, Candidate) {
        let index = self.leaves.partition_point(|&first| first <= at.leaf) - 1;
        (index, Candidate { leaf: at.leaf - self.leaves[index], ..*at })
    }

    /// Whether two hits in a row are one: where parts of a smooth solid reach over a seam a ray meets
    /// both, in planes that rounding cannot tell apart, from the same side. Between two true hits it
    /// goes in and out.
    fn is_repeated(&self, ray: &Ray, first: &Candidate, again: &Candidate) -> bool {
        if first.leaf == again.leaf {
            return false;
        }
        let [before, after] = [first, again].map(|at| {
            let normal = self.surface(ray, at).normal;
            normal.dot(ray.direction)
        });
        let apart = (again.t - first.t) * before.abs().min(after.abs());
        before * after > 0.0 && apart <= 2.0 * self.least_error
    }
}

/// The parts as one ray sees them.
struct Seen<'a> {
    parts: &'a [Part],
    ray: &'a Ray,
}

impl Primitives for Seen<'_> {
    fn hit(&self, index: u32, span: Span) -> Option<Candidate> {
        self.parts[index as usize].shape.hit(self.ray, span)
    }

    fn shadow_hit(&self, index: u32, span: Span) -> Option<Candidate> {
        let part = &self.parts[index as usize];
        if !part.casts_shadows {
            return None;
        }
        part.shape.shadow_hit(self.ray, span).map(Candidate::at)
    }

    fn bounds(&self, index: u32) -> Aabb {
        self.parts[index as usize].bounds
    }
}

impl Shape for Assembly {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        if !self.bounds.may_meet(ray, span.min) {
            return None;
        }
        match &self.accel {
            Some(accel) => self.nearest_by(accel, ray, span),
            None => self.nearest_in_turn(ray, span),
        }
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        if !self.bounds.may_meet(ray, span.min) {
            return None;
        }
        let seen = Seen { parts: &self.parts, ray };
        if let Some(accel) = &self.accel {
            return accel.any(&seen, ray, span).map(|(_, at)| at.t);
        }
        (0..self.parts.len() as u32).find_map(|i| seen.shadow_hit(i, span)).map(|at| at.t)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let (index, within) = self.within(at);
        let part = &self.parts[index];
        let surface = part.shape.surface(ray, &within);
        let error = surface.error.max(self.least_error);
        Surface { error, material: surface.material.or(part.material), ..surface }
    }

    fn uv(&self, at: &Candidate) -> Option<[f64; 2]> {
        let (index, within) = self.within(at);
        self.parts[index].shape.uv(&within)
    }

    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        self.parts
            .iter()
            .find_map(|part| part.shape.material_without_uv(part.material.unwrap_or(own), needs_uv))
    }

    fn facet(&self, at: &Candidate) -> Option<Facet> {
        let (index, within) = self.within(at);
        self.parts[index].shape.facet(&within)
    }

    fn beside(&self, at: &Candidate, by: Vector) -> Candidate {
        let (index, within) = self.within(at);
        let moved = self.parts[index].shape.beside(&within, by);
        Candidate { leaf: at.leaf, ..moved }
    }

    fn texture_space(&self, at: &Candidate) -> Transform {
        let (index, within) = self.within(at);
        self.parts[index].shape.texture_space(&within)
    }

    fn path(&self, at: &Candidate) -> PartPath {
        let (index, within) = self.within(at);
        let Part { name, shape, .. } = &self.parts[index];
        shape.path(&within).inside(Level::Part { index: index as u32, name: name.to_string() })
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let mut roots = Vec::new();
        // what `hit` does not count is no root
        if !self.bounds.may_meet(ray, span.min) {
            return roots;
        }
        for (part, first) in self.parts.iter().zip(&self.leaves) {
            let mut within = part.shape.roots(ray, span);
            if let Some(accel) = &self.accel {
                let counts = accel.counting(&part.bounds, ray);
                within.retain(|at| counts.as_ref().is_some_and(|counts| counts(at.t)));
            }
            roots.extend(within.into_iter().map(|at| Candidate { leaf: first + at.leaf, ..at }));
        }
        roots.sort_by(|a, b| a.t.total_cmp(&b.t)); // stable: ties stay in the order of leaves
        if self.least_error > 0.0 {
            roots.dedup_by(|again, first| self.is_repeated(ray, first, again));
        }
        roots
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn leaves(&self) -> u64 {
        self.leaves[self.parts.len()]
    }
}
