//! A hit and the direction it is seen from.

use crate::lobes::About;
use crate::math::{Frame, Normal, Vector};
use crate::world::Hit;

/// A hit as it is shaded: the normals of a two-sided surface are turned to the viewer.
#[derive(Debug)]
pub struct ShadingPoint<'a> {
    /// What was hit.
    pub hit: &'a Hit<'a>,
    /// Unit, towards the viewer.
    pub wo: Vector,
    /// The cosine between `wo` and the true normal; negative if the viewer is on the inner side.
    pub cos_o: f64,
    turned: bool,
}

impl<'a> ShadingPoint<'a> {
    pub(super) fn new(hit: &'a Hit<'a>, wo: Vector) -> Self {
        let turned = hit.material.two_sided && !hit.front;
        let cos_o = hit.surface.normal.dot(wo);
        Self { hit, wo, turned, cos_o: if turned { -cos_o } else { cos_o } }
    }

    /// The normal that a lobe is about.
    pub fn normal(&self, about: About) -> Normal {
        let n = match about {
            About::Shading => self.hit.surface.shading,
            About::Geometry => self.hit.surface.normal,
        };
        if self.turned { -n } else { n }
    }

    /// The local frame of a lobe: its z axis is [`ShadingPoint::normal`].
    pub fn frame(&self, about: About) -> Frame {
        Frame::around(self.normal(about))
    }
}
