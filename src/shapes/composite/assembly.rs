//! Shapes made of parts: compounds, and the solids that are compounds of parts that their kinds
//! name.
//!
//! A ray hits the nearest hit of all parts, if it meets the box around them (Suffern, ch. 19).
//! Which of all nested shapes it is on is one number, [`Candidate::leaf`]: the leaves of the first
//! part are counted first, then those of the second. So a candidate stays as small as that of a
//! sphere, however deep the role (a hundred instances eight levels deep are 10¹⁶ leaves), and of
//! equal hits the first object wins.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::accel::{Accel, Method};
use crate::invalid::{Invalid, Key};
use crate::math::{Aabb, Ray, Span};
use crate::shapes::{Candidate, Context, Kind, Role, Shape, Surface, Within};
use formats::printable;

/// Up to this many parts are tried one after the other unless the scene says how.
const FEW: usize = 8;

/// A part as a scene describes it.
pub struct PartData<'a> {
    /// Its name; empty if it has none.
    pub name: &'a str,
    /// The name of its material; that of the whole if `None`.
    pub material: Option<&'a str>,
    /// Its shape.
    pub shape: &'a Kind,
}

/// The materials of a solid's parts, by the names that its kind gives them.
pub type Materials = BTreeMap<String, String>;

/// Builds a solid of parts that its kind names; `materials` is its field of that name. Rays find
/// the parts by `accel`, if it is given.
pub fn solid(
    parts: &[(&'static str, Kind)],
    materials: &Materials,
    accel: Option<Method>,
    context: &mut Context,
) -> Result<Arc<dyn Shape>, Invalid> {
    let names: BTreeSet<&str> = parts.iter().map(|(name, _)| *name).collect();
    if let Some(unknown) = materials.keys().find(|name| !names.contains(name.as_str())) {
        let known = Vec::from_iter(names).join(", ");
        let problem = format!("no part `{}`; there are: {known}", printable::name(unknown));
        return Err(Invalid::field("materials", problem));
    }
    for (part, name) in materials {
        // an error names the entry of `materials`, not the part
        let checked = context.material(name).map_err(|e| Invalid::field(part, e.problem));
        checked.map_err(|e| e.inside("materials"))?;
    }
    let parts = parts.iter().map(|(name, shape)| {
        let material = materials.get(*name).map(String::as_str);
        PartData { name, material, shape }
    });
    Ok(Arc::new(Assembly::build("parts", parts, accel, context)?))
}

/// Parts that are hit as one shape.
#[derive(Debug)]
pub struct Assembly {
    parts: Vec<Named>,
    /// The number of each part's first leaf, and of all leaves.
    leaves: Vec<u64>,
    accel: Accel,
    bounds: Aabb,
}

#[derive(Debug)]
struct Named {
    name: Box<str>,
    shape: Arc<dyn Shape>,
    material: Option<u32>,
    /// Whether it, or any part of it, casts shadows.
    casts_shadows: bool,
}

impl Assembly {
    /// Builds the parts; errors name `field`, the field of the scene that lists them.
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
            let (name, material) = (part.name.into(), material.map(|m| m.index));
            built.push(Named { name, shape, material, casts_shadows });
        }
        Self::of(built, accel, context).map_err(|e| e.inside(field))
    }

    fn of(parts: Vec<Named>, accel: Option<Method>, context: &Context) -> Result<Self, Invalid> {
        let mut leaves = vec![0_u64];
        for part in &parts {
            let so_far = leaves[leaves.len() - 1];
            let next = so_far.checked_add(part.shape.leaves()).ok_or_else(|| {
                Invalid::new("more than 2⁶⁴ shapes are nested here; leave out a level")
            })?;
            leaves.push(next);
        }
        let bounds: Vec<Aabb> = parts.iter().map(|part| part.shape.bounds()).collect();
        // the book tries the parts of a compound in turn
        let in_turn = parts.len() <= FEW || context.textbook().is_some();
        let usual = if in_turn { Method::List } else { context.accel() };
        Ok(Self {
            bounds: bounds.iter().fold(Aabb::EMPTY, |all, &part| all.union(part)),
            accel: Accel::build(accel.unwrap_or(usual), &bounds),
            parts,
            leaves,
        })
    }
}

impl Assembly {
    /// The index of the part that is hit, and the hit in the coordinates of the part.
    fn part(&self, at: &Candidate) -> (usize, Candidate) {
        let index = self.leaves.partition_point(|&first| first <= at.leaf) - 1;
        (index, Candidate { leaf: at.leaf - self.leaves[index], ..*at })
    }
}

impl Shape for Assembly {
    fn hit(&self, ray: &Ray, span: Span) -> Option<Candidate> {
        if !self.bounds.may_meet(ray, span.min) {
            return None;
        }
        let (index, at) = self.accel.nearest(ray, span, &mut (), |index, span| {
            self.parts[index as usize].shape.hit(ray, span)
        })?;
        Some(Candidate { leaf: self.leaves[index as usize] + at.leaf, ..at })
    }

    fn shadow_hit(&self, ray: &Ray, span: Span) -> Option<f64> {
        if !self.bounds.may_meet(ray, span.min) {
            return None;
        }
        let blocked = |index: u32| {
            let part = &self.parts[index as usize];
            if part.casts_shadows { part.shape.shadow_hit(ray, span) } else { None }
        };
        self.accel.any(ray, span, &mut (), blocked).map(|(_, t)| t)
    }

    fn surface(&self, ray: &Ray, at: &Candidate) -> Surface {
        let (index, within) = self.part(at);
        let part = &self.parts[index];
        let surface = part.shape.surface(ray, &within);
        Surface { material: surface.material.or(part.material), ..surface }
    }

    fn within(&self, at: &Candidate) -> Within<'_> {
        let (index, within) = self.part(at);
        let Named { name, shape, .. } = &self.parts[index];
        Within::Nested(&**shape, within, Role::Part(index as u32, name))
    }

    fn material_without_uv(&self, own: u32, needs_uv: &dyn Fn(u32) -> bool) -> Option<u32> {
        self.parts
            .iter()
            .find_map(|part| part.shape.material_without_uv(part.material.unwrap_or(own), needs_uv))
    }

    fn roots(&self, ray: &Ray, span: Span) -> Vec<Candidate> {
        let mut roots = Vec::new();
        for (part, first) in self.parts.iter().zip(&self.leaves) {
            let within = part.shape.roots(ray, span);
            roots.extend(within.into_iter().map(|at| Candidate { leaf: first + at.leaf, ..at }));
        }
        roots.sort_by(|a, b| a.t.total_cmp(&b.t)); // stable: ties stay in the order of leaves
        roots
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn leaves(&self) -> u64 {
        self.leaves[self.parts.len()]
    }
}
