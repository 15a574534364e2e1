//! Normals of bumped surfaces.

use super::Hit;
use crate::math::Normal;

impl Hit<'_> {
    /// The normal for shading: the surface's normal turned by the material's bump. A turned normal
    /// is on the side of the true normal.
    pub fn shading_normal(&self) -> Normal {
        let Some(bump) = &self.material.bump else { return self.surface.shading };
        let space = self.object.shape.texture_space(&self.candidate);
        let turned = Normal::new(space.inverse().covector(self.surface.shading))
            .and_then(|local| Normal::new(bump.perturbed(&self.texture_point(), local)))
            .and_then(|local| Normal::new(space.covector(local)));
        raised(turned.unwrap_or(self.surface.shading), self.surface.normal)
    }
}

/// The normal itself; if it is below the true surface or almost, it is turned to just above it.
fn raised(n: Normal, geometry: Normal) -> Normal {
    /// The least cosine between the two normals: below it, only grazing light could reach the
    /// surface.
    const MIN: f64 = 1.0 / 64.0;
    let cosine = n.dot(geometry);
    if cosine >= MIN {
        return n;
    }
    Normal::new(n + (MIN - cosine) * geometry).unwrap_or(geometry)
}
