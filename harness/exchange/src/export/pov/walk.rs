//! The bodies of glass around each ray of our picture, as POV-Ray lists them.
//!
//! Our glass says the media on both sides of each surface. POV-Ray's bodies have an interior each, and the index on the
//! other side is found from the list of those that the ray has entered and not left: the last of them is around it. All
//! absorb. So each ray of our picture is followed with such a list, and whatever would differ is refused.

use std::collections::BTreeMap;

use groundtruth::lobes::{Lobe, Lobes, NormalKind};
use groundtruth::math::{Aabb, Ray};
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, RayKind, Recorder, ShadingPoint, Term};

/// Ratios of indices are equal if they differ by no more than rounding.
const ROUNDING: f64 = 1e-12;

/// All surfaces of one material, by its index: POV-Ray has one interior for them.
pub(super) type Body = usize;

/// What differs there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Difference {
    /// The camera may be inside.
    Camera,
    /// The ratio of the indices on both sides.
    Index,
    /// Fresnel's reflection where the ray leaves a body for the one around it.
    Nested,
    /// The absorption.
    Absorption,
    /// The 1/η² of radiance that does not return into the medium of the camera.
    Scaling,
}

impl Difference {
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Camera => {
                "the camera is in its bounding box, where POV-Ray may take it to be inside"
            }
            Self::Index => {
                "POV-Ray takes the index on the other side from the body around it, here its material says another"
            }
            Self::Nested => "POV-Ray reflects nothing where light leaves glass for glass around it",
            Self::Absorption => {
                "POV-Ray adds up the absorption of all glass around a ray, ours says another; --without absorption leaves it out"
            }
            Self::Scaling => {
                "seen inside glass, where only ours multiplies radiance by 1/η²; --without scaling leaves that out"
            }
        }
    }
}

/// Where a difference was seen first.
pub(super) type Differences = BTreeMap<(Body, Difference), [u32; 2]>;

/// Follows the rays of our picture.
pub(super) struct Walk {
    /// The bounding boxes of the shapes of each body.
    boxes: Vec<(Body, Aabb)>,
    /// Whether refraction multiplies radiance by 1/η².
    scales_radiance: bool,
    /// The pixel that is rendered.
    pub pixel: [u32; 2],
    /// The index of each body that was met.
    pub indices: BTreeMap<Body, f64>,
    /// The absorption inside each of them.
    absorptions: BTreeMap<Body, Rgb>,
    pub differences: Differences,
    rays: Vec<Edge>,
}

/// A ray that is being followed.
struct Edge {
    /// The bodies that it is in, in the order in which they were entered.
    within: Vec<Body>,
    /// The absorption of our medium.
    absorption: Rgb,
    /// What scattered rays are in, reflected and refracted.
    scattered: Option<[(Vec<Body>, Rgb); 2]>,
}

impl Walk {
    pub(super) fn new(boxes: Vec<(Body, Aabb)>, scales_radiance: bool) -> Self {
        Self {
            boxes,
            scales_radiance,
            pixel: [0; 2],
            indices: BTreeMap::new(),
            absorptions: BTreeMap::new(),
            differences: BTreeMap::new(),
            rays: Vec::new(),
        }
    }

    fn differs(&mut self, body: Body, how: Difference) {
        self.differences.entry((body, how)).or_insert(self.pixel);
    }

    /// The index of the last of these bodies; of the air if there is none.
    fn index(&self, within: &[Body]) -> f64 {
        within.last().and_then(|body| self.indices.get(body)).copied().unwrap_or(1.0)
    }

    /// The absorption of all of these bodies.
    fn absorption(&self, within: &[Body]) -> Rgb {
        within.iter().filter_map(|body| self.absorptions.get(body)).copied().sum()
    }

    /// The list of the refracted ray, and whether POV-Ray's ratio of the indices on both sides is ours, `eta`. The index of a
    /// body that is entered for the first time is chosen so.
    fn cross(&mut self, body: Body, within: &[Body], eta: f64) -> (Vec<Body>, bool) {
        let mut beyond = within.to_vec();
        let ratio = match within.iter().position(|it| *it == body) {
            None => {
                let around = self.index(within);
                beyond.push(body);
                *self.indices.entry(body).or_insert(eta * around) / around
            }
            Some(place) => {
                beyond.remove(place);
                match place + 1 == within.len() {
                    true => self.index(&beyond) / self.index(within),
                    false => 1.0,
                }
            }
        };
        (beyond, (ratio - eta).abs() <= ROUNDING * eta)
    }

    /// The end of a ray at something that is no glass, or at the background.
    fn ends(&mut self) {
        let Some(Edge { within, absorption, .. }) = self.rays.last() else { return };
        let Some(&body) = within.last() else { return };
        let (is_scaled, is_clear) = (self.index(within) != 1.0, absorption.is_black());
        if self.scales_radiance && is_scaled {
            self.differs(body, Difference::Scaling);
        }
        // its shadow rays are absorbed, too
        if !is_clear {
            self.differs(body, Difference::Absorption);
        }
    }
}

impl Recorder for Walk {
    fn enter(&mut self, kind: RayKind, ray: &Ray, _: u32, _: Rgb) {
        let (within, absorption) = match (kind, self.rays.last()) {
            (RayKind::Reflected, Some(Edge { scattered: Some([beyond, _]), .. }))
            | (RayKind::Transmitted, Some(Edge { scattered: Some([_, beyond]), .. })) => {
                beyond.clone()
            }
            (_, Some(before)) => (before.within.clone(), before.absorption),
            (_, None) => (Vec::new(), Rgb::BLACK),
        };
        if kind == RayKind::Camera {
            for (body, _) in self.boxes.iter().filter(|(_, it)| it.contains(ray.origin)) {
                self.differences.entry((*body, Difference::Camera)).or_insert(self.pixel);
            }
        }
        self.rays.push(Edge { within, absorption, scattered: None });
    }

    fn outcome(&mut self, outcome: Outcome) {
        if outcome == Outcome::Background {
            self.ends();
        }
    }

    fn surface(&mut self, point: &ShadingPoint<'_>, lobes: &Lobes) {
        let wo = point.frame(NormalKind::Geometry).to_local(point.wo);
        let Some(eta) = lobes.iter().find_map(|(lobe, _)| lobe.relative_eta(wo)) else {
            return self.ends();
        };
        let Some(ray) = self.rays.last() else { return };
        let (within, absorption) = (ray.within.clone(), ray.absorption);
        let material = point.hit.material;
        let body = material.index as usize;
        let (beyond, is_same) = self.cross(body, &within, eta);
        if !is_same {
            self.differs(body, Difference::Index);
        }
        let is_fresnel = lobes.iter().any(|(lobe, _)| matches!(lobe, Lobe::FresnelReflector(_)));
        if is_fresnel && within.len() > 1 && within.contains(&body) {
            self.differs(body, Difference::Nested);
        }
        let boundary = material.recipe.boundary();
        let inside = boundary.map_or(Rgb::BLACK, |it| it.inside.absorption);
        self.absorptions.insert(body, inside);
        let [front, behind] = match boundary {
            None => [absorption; 2],
            Some(it) if point.cos_o > 0.0 => [it.outside.absorption, inside],
            Some(it) => [inside, it.outside.absorption],
        };
        let are_theirs = front == absorption
            && front == self.absorption(&within)
            && behind == self.absorption(&beyond);
        if !are_theirs {
            self.differs(body, Difference::Absorption);
        }
        let scattered = Some([(within, front), (beyond, behind)]);
        if let Some(ray) = self.rays.last_mut() {
            ray.scattered = scattered;
        }
    }

    fn term(&mut self, _: Term) {}

    fn leave(&mut self, _: Rgb, _: Rgb) {
        self.rays.pop();
    }
}
