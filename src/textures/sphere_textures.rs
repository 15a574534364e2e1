//! A texture for each checker of a sphere (Suffern, ch. 30).

use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cells::{self, BuiltLines};
use super::{Chooser, Color, Lines, Paint, Specification, SphereCells, Texture, TexturePoint};
use crate::invalid::Invalid;
use crate::kinds::Resources;

/// The checkers of `sphere_checker`, each with a colour or texture of its own.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereTextures {
    /// The number of checkers around the y axis, from the +z axis towards +x; at least 1.
    #[serde(default = "cells::twenty")]
    pub num_horizontal: u32,
    /// The number of checkers from the north pole (on the +y axis) to the south pole; at least 1.
    #[serde(default = "cells::ten")]
    pub num_vertical: u32,
    /// The textures: row by row from the north pole, each row from the +z axis. If there are fewer
    /// textures than checkers, they repeat.
    pub textures: Vec<Paint>,
    /// Lines along the borders; none if left out.
    #[serde(default)]
    pub lines: Lines,
}

#[derive(Debug)]
struct SphereTexturesTexture {
    cells: SphereCells,
    textures: Vec<Color>,
    lines: BuiltLines,
}

impl Specification for SphereTextures {
    fn build(&self, resources: &mut Resources) -> Result<Arc<dyn Texture>, Invalid> {
        let cells = SphereCells::new(self.num_horizontal, self.num_vertical)?;
        cells.check_list("textures", self.textures.len())?;
        let textures = Paint::build_list(&self.textures, "textures", resources)?;
        Ok(Arc::new(SphereTexturesTexture { cells, textures, lines: self.lines.build(resources)? }))
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
