//! A texture for each checker of a sphere (Suffern, ch. 30).

use super::cells::BuiltLines;
use super::{Chooser, Color, Lines, Made, Paint, Specification, SphereCells, TexturePoint, made};
use crate::kinds::Resources;

/// The checkers of `sphere_checker`, each with a colour or texture of its own.
#[kind]
pub struct SphereTextures {
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    #[default(20)]
    pub num_horizontal: u32,
    /// The number of checkers from the north pole (on the +y axis) to the south pole; at least 1.
    #[default(10)]
    pub num_vertical: u32,
    /// The textures: row by row from the north pole, each row from the +z axis. If there are fewer
    /// textures than checkers, they repeat.
    pub textures: Vec<Paint>,
    /// Lines along the borders; none if left out.
    #[default]
    pub lines: Lines,
}

#[derive(Debug)]
struct SphereTexturesTexture {
    cells: SphereCells,
    textures: Vec<Color>,
    lines: BuiltLines,
}

impl Specification for SphereTextures {
    fn make(&self, resources: &mut Resources) -> Made {
        let cells = SphereCells::new(self.num_horizontal, self.num_vertical)?;
        cells.check_list("textures", self.textures.len())?;
        let textures = Paint::build_list(&self.textures, "textures", resources)?;
        made(SphereTexturesTexture { cells, textures, lines: self.lines.build(resources)? })
    }
}

impl Chooser for SphereTexturesTexture {
    fn chosen(&self, at: &TexturePoint<'_>) -> &Color {
        self.lines.on(self.cells.cell(at.local)).unwrap_or_else(|| {
            let index = self.cells.index(at.local) % self.textures.len() as u64;
            &self.textures[index as usize]
        })
    }
}
