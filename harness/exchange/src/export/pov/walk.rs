//! The glass around each ray of our picture.
//!
//! Our glass says the media on both sides of each surface. POV-Ray's bodies have an interior each, and the index on the
//! other side is found from those that the ray has entered and not left. Both give the same for closed bodies that stand
//! alone in air. So each ray of our picture is followed, and whatever would differ is refused.

use std::collections::BTreeMap;

use groundtruth::lobes::Lobes;
use groundtruth::math::{Aabb, Ray};
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayKind, Recorder, ShadingPoint, Term};

/// All surfaces of one material, by its index: POV-Ray has one interior for them.
pub(super) type Body = usize;

/// What differs there, in words.
const CAMERA: &str = "the camera is in its bounding box, where POV-Ray may take it to be inside";
const NOT_ALONE: &str = "in or against other glass, or seen from inside: only closed bodies apart from each other in air can \
                         be said, because POV-Ray takes the index on the other side from the body around it";
const SCALED: &str = "seen inside glass, where only ours multiplies radiance by 1/η²; --without scaling leaves that out";

/// Follows the rays of our picture.
#[derive(Default)]
pub(super) struct Walk {
    /// The bounding boxes of the shapes of each body.
    boxes: Vec<(Body, Aabb)>,
    /// Whether refraction multiplies radiance by 1/η².
    scales_radiance: bool,
    /// The pixel that is rendered.
    pub pixel: [u32; 2],
    /// What differs, and where it was seen first.
    pub differences: BTreeMap<(Body, &'static str), [u32; 2]>,
    /// The rays that are being followed.
    rays: Vec<Edge>,
}

/// The bodies on both sides of the surface that a ray meets; `None` is air.
struct Edge {
    within: Option<Body>,
    beyond: Option<Body>,
}

impl Walk {
    pub(super) fn new(boxes: Vec<(Body, Aabb)>, scales_radiance: bool) -> Self {
        Self { boxes, scales_radiance, ..Self::default() }
    }

    fn differs(&mut self, body: Body, how: &'static str) {
        self.differences.entry((body, how)).or_insert(self.pixel);
    }

    /// The end of a ray at something that is no glass, or at the background.
    fn ends(&mut self) {
        if let Some(Edge { within: Some(body), .. }) = self.rays.last()
            && self.scales_radiance
        {
            self.differs(*body, SCALED);
        }
    }
}

impl Recorder for Walk {
    fn enter(&mut self, kind: RayKind, ray: &Ray, _: u32, _: Rgb) {
        let within = match (kind, self.rays.last()) {
            (RayKind::Transmitted, Some(before)) => before.beyond,
            (_, Some(before)) => before.within,
            (_, None) => None,
        };
        if kind == RayKind::Camera {
            for (body, _) in self.boxes.iter().filter(|(_, it)| it.contains(ray.origin)) {
                self.differences.entry((*body, CAMERA)).or_insert(self.pixel);
            }
        }
        self.rays.push(Edge { within, beyond: within });
    }

    fn hit(&mut self, point: &ShadingPoint<'_>, _: &Lobes) {
        let body = point.hit.material.index as usize;
        if !self.boxes.iter().any(|(glass, _)| *glass == body) {
            return self.ends();
        }
        let Some(ray) = self.rays.last_mut() else { return };
        let is_entered = point.cos_o > 0.0;
        let expected = if is_entered { None } else { Some(body) };
        ray.beyond = if is_entered { Some(body) } else { None };
        if ray.within != expected {
            self.differs(body, NOT_ALONE);
        }
    }

    fn term(&mut self, _: Term) {}

    fn leave(&mut self, outcome: Outcome, _: Rgb, _: Rgb) {
        if outcome == Outcome::Background {
            self.ends();
        }
        self.rays.pop();
    }
}
