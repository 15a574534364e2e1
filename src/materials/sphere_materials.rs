//! A material for each checker of a sphere (Suffern, ch. 30).

use std::sync::Arc;

use super::{Kind, Made, Material, Response, Specification, TexturedField, made, within};
use crate::invalid::Invalid;
use crate::kinds::Resources;
use crate::textures::{SphereCells, TexturePoint};

/// A material for each of the checkers of a sphere, which are those of the texture
/// `sphere_checker`: about the origin of its own coordinates, of any radius. Transparent materials
/// are refused: the media on both sides belong to the whole surface. Emissive ones are refused,
/// too: a lamp has one emission.
#[kind]
pub struct SphereMaterials {
    /// How many checkers there are around the y axis, from the +z axis towards +x; at least 1.
    #[default(20)]
    pub num_horizontal: u32,
    /// How many there are from the north pole, on the y axis, to the south pole; at least 1.
    #[default(10)]
    pub num_vertical: u32,
    /// The materials: row by row from the north pole, in each row from the +z axis on. If there are
    /// fewer than checkers, they begin again.
    pub materials: Vec<Kind>,
}

#[derive(Debug)]
struct SphereMaterialsMaterial {
    cells: SphereCells,
    materials: Vec<Arc<dyn Material>>,
}

impl Specification for SphereMaterials {
    const FORMULA: &'static str = "at each point what the material of that checker does.";

    fn make(&self, resources: &mut Resources) -> Made {
        let cells = SphereCells::new(self.num_horizontal, self.num_vertical)?;
        cells.check_list("materials", self.materials.len())?;
        let material = |(i, kind): (usize, &Kind)| {
            let built = kind.build(resources).and_then(of_a_checker);
            built.map_err(|e| e.inside(i).inside("materials"))
        };
        let materials =
            self.materials.iter().enumerate().map(material).collect::<Result<_, _>>()?;
        made(SphereMaterialsMaterial { cells, materials })
    }
}

/// Refuses what belongs to a whole surface.
fn of_a_checker(material: Arc<dyn Material>) -> Result<Arc<dyn Material>, Invalid> {
    if material.transmits() {
        let problem = "a transparent material cannot be that of one checker: the media on both \
                       sides belong to the whole surface";
        return Err(Invalid::new(problem));
    }
    if material.emission().is_some() {
        let problem = "an emissive material cannot be that of one checker: a lamp has one \
                       emission; use `emissive` for the whole, with a `sphere_textures` as its `ce`";
        return Err(Invalid::new(problem));
    }
    Ok(material)
}

impl SphereMaterialsMaterial {
    /// The place in the list of the material of a point.
    fn turn(&self, at: &TexturePoint<'_>) -> usize {
        (self.cells.index(at.local) % self.materials.len() as u64) as usize
    }
}

impl Material for SphereMaterialsMaterial {
    fn respond(&self, at: &TexturePoint<'_>, cos_o: f64, response: &mut Response) {
        self.materials[self.turn(at)].respond(at, cos_o, response);
    }

    fn needs_rays(&self) -> bool {
        self.materials.iter().any(|material| material.needs_rays())
    }

    fn textures(&self, at: &TexturePoint<'_>) -> Vec<TexturedField<'_>> {
        let turn = self.turn(at);
        within(&format!("materials[{turn}]"), &*self.materials[turn], at).collect()
    }
}
