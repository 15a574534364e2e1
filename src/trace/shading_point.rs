//! Shading points: a hit and the direction to the viewer.

use crate::lights::LightContext;
use crate::lobes::{NormalKind, Normals};
use crate::math::{Frame, Normal, Vector};
use crate::world::Hit;

/// A hit to be shaded: the normals of a two-sided surface are turned to the viewer.
#[derive(Debug)]
pub struct ShadingPoint<'a> {
    /// The hit.
    pub hit: &'a Hit<'a>,
    /// Unit, towards the viewer.
    pub wo: Vector,
    /// The cosine between `wo` and the true normal; negative if the viewer is on the inner side.
    pub cos_o: f64,
    /// The normals.
    pub normals: Normals,
}

impl<'a> ShadingPoint<'a> {
    /// The point of a hit that a viewer in the unit direction `wo` sees.
    pub fn new(hit: &'a Hit<'a>, wo: Vector) -> Self {
        let turned = hit.material.two_sided && !hit.front;
        let cos_o = hit.surface.normal.dot(wo);
        let turn = |n: Normal| if turned { -n } else { n };
        let normals =
            Normals { shading: turn(hit.shading_normal()), geometry: turn(hit.surface.normal) };
        Self { hit, wo, cos_o: if turned { -cos_o } else { cos_o }, normals }
    }

    /// The data that lights need of it.
    pub fn light_context(&self) -> LightContext {
        LightContext { point: self.hit.surface.point, normal: self.normals.shading }
    }

    /// Whether a direction leads to the side of the true surface that the normal points to.
    pub(super) fn is_outward(&self, direction: Vector) -> bool {
        self.normals.geometry.dot(direction) > 0.0
    }

    /// The local frame of a lobe.
    pub fn frame(&self, kind: NormalKind) -> Frame {
        Frame::around(self.normals.of(kind))
    }
}
