//! The lobes of a hit in the world's directions: what light from a direction leaves towards the
//! viewer, and where light is to be looked for.

use super::{Branch, Lobe, Lobes, MAX_LOBES, NormalKind, mirrored};
use crate::math::{Frame, Normal, Vector};
use crate::rgb::Rgb;
use arrayvec::ArrayVec;

/// The lobes of a surface, as a viewer in the direction `wo` sees them.
#[derive(Clone, Debug)]
pub struct Bsdf<'a> {
    lobes: &'a Lobes,
    normals: Normals,
    /// Unit, towards the viewer.
    wo: Vector,
    /// About the shading normal.
    frame: Frame,
    /// See [`Bsdf::lobe_probabilities`].
    lobe_probabilities: ArrayVec<f64, MAX_LOBES>,
}

/// The two normals of a hit; those of a two-sided surface are turned to the viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normals {
    /// The interpolated one of a smooth mesh.
    pub shading: Normal,
    /// Perpendicular to the true surface.
    pub geometry: Normal,
}

impl Normals {
    /// The normal that a lobe is about.
    pub fn of(&self, kind: NormalKind) -> Normal {
        match kind {
            NormalKind::Shading => self.shading,
            NormalKind::Geometry => self.geometry,
        }
    }
}

/// The lobes that take samples of lights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LobeSet {
    /// Those for which Whitted's tracer follows no ray: diffuse reflection and highlights.
    DirectOnly,
    /// All whose density is no delta distribution.
    NonDelta,
}

impl LobeSet {
    fn contains(self, lobe: &Lobe) -> bool {
        match self {
            Self::DirectOnly => lobe.is_lit(),
            Self::NonDelta => !lobe.is_specular(),
        }
    }
}

/// What a lobe makes of light from a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lit<'a> {
    /// The lobe.
    pub lobe: &'a Lobe,
    /// Its value, per steradian; not black.
    pub f: Rgb,
    /// The cosine of the light's angle to the normal; positive.
    pub cos_i: f64,
}

/// A direction in which light is to be looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfSample {
    /// Unit.
    pub direction: Vector,
    /// What the light from there counts.
    pub weight: Rgb,
    /// Per steradian; `None` for a single direction.
    pub pdf: Option<f64>,
    /// For a direction to the other side of the surface, the index of refraction there over the one
    /// on this side: the weight has a factor `1/η²`.
    pub refracted: Option<f64>,
}

impl<'a> Bsdf<'a> {
    /// The lobes of a surface with these normals, seen from the unit direction `wo`.
    pub fn new(lobes: &'a Lobes, normals: Normals, wo: Vector) -> Self {
        let (frame, lobe_probabilities) = (Frame::around(normals.shading), ArrayVec::new());
        Self { lobes, normals, wo, frame, lobe_probabilities }
    }

    /// For a path, which takes one of the lobes: sets [`Bsdf::lobe_probabilities`].
    pub fn weigh_lobes(&mut self) {
        for (lobe, kind) in self.lobes {
            let viewer = self.viewer(lobe, &self.frame_of(lobe, *kind));
            self.lobe_probabilities.push(lobe.selection_weight(viewer));
        }
        let sum: f64 = self.lobe_probabilities.iter().sum();
        if sum > 0.0 {
            self.lobe_probabilities.iter_mut().for_each(|weight| *weight /= sum);
        }
    }

    /// The lobes, in the order in which the material listed them.
    pub fn lobes(&self) -> &'a Lobes {
        self.lobes
    }

    /// Whether any of these lobes may take light from a light's sample.
    pub fn is_lit(&self, set: LobeSet) -> bool {
        self.is_outward(self.wo) && self.lobes.iter().any(|(lobe, _)| set.contains(lobe))
    }

    /// With which probability a path takes each lobe: all 0 if nothing is scattered, none if it
    /// does not choose ([`Bsdf::weigh_lobes`]).
    pub fn lobe_probabilities(&self) -> &[f64] {
        &self.lobe_probabilities
    }

    /// The density with which a path goes on in a direction, per steradian, whatever lobe it takes;
    /// that of a single direction is left out.
    pub fn pdf(&self, wi: Vector) -> f64 {
        if !(self.is_outward(self.wo) && self.is_outward(wi)) {
            return 0.0;
        }
        let density = |((lobe, kind), probability): (&(Lobe, NormalKind), &f64)| {
            let frame = self.frame_of(lobe, *kind);
            probability * lobe.pdf(self.viewer(lobe, &frame), frame.to_local(wi))
        };
        self.lobes.iter().zip(&self.lobe_probabilities).map(density).sum()
    }

    /// Whether a direction leads to the side of the true surface that the normal points to.
    pub fn is_outward(&self, direction: Vector) -> bool {
        self.normals.geometry.dot(direction) > 0.0
    }

    /// The frame of a lobe. Where an interpolated normal faces away from the viewer or sends the
    /// mirror direction to the other side of the true surface, a mirror and its blurred form are
    /// about the true normal: without this, smooth mirrors would have black outlines.
    fn frame_of(&self, lobe: &Lobe, kind: NormalKind) -> Frame {
        let is_mirrored = matches!(lobe.branch(), Branch::Mirror | Branch::Gloss);
        let falls_behind = || {
            let wo = self.frame.to_local(self.wo);
            let mirrored = self.frame.to_world(mirrored(wo));
            [wo.z() > 0.0, self.is_outward(mirrored)] != [self.is_outward(self.wo); 2]
        };
        match kind {
            NormalKind::Shading if !(is_mirrored && falls_behind()) => self.frame,
            NormalKind::Shading | NormalKind::Geometry => Frame::around(self.normals.geometry),
        }
    }

    /// The direction to the viewer for which a lobe draws directions, in its frame. Where an
    /// interpolated normal faces away from a viewer above the true surface, it is the one as far
    /// above that normal's horizon as the viewer is below it: lobes draw nothing for a viewer
    /// below.
    fn viewer(&self, lobe: &Lobe, frame: &Frame) -> Vector {
        let wo = frame.to_local(self.wo);
        match !lobe.is_specular() && self.is_outward(self.wo) {
            true => Vector::new(wo.x(), wo.y(), wo.z().abs()),
            false => wo,
        }
    }

    /// What each of these lobes makes of light from the unit direction `wi`; those that make
    /// nothing of it are left out.
    ///
    /// A viewer below the true surface gets nothing. One above it does, also where an interpolated
    /// normal faces away, near the outline of a smooth mesh: the book's formulas do not ask on
    /// which side of that normal the viewer is.
    pub fn lit(&self, set: LobeSet, wi: Vector) -> ArrayVec<Lit<'a>, MAX_LOBES> {
        let mut lit = ArrayVec::new();
        if !self.is_outward(self.wo) {
            return lit;
        }
        for (lobe, kind) in self.lobes.iter().filter(|(lobe, _)| set.contains(lobe)) {
            let frame = self.frame_of(lobe, *kind);
            let [wo, wi] = [self.wo, wi].map(|w| frame.to_local(w));
            let cos_i = wi.z();
            if cos_i <= 0.0 {
                continue; // the light is behind the surface
            }
            let f = lobe.formula(wo, wi);
            if !f.is_black() {
                lit.push(Lit { lobe, f, cos_i });
            }
        }
        lit
    }

    /// A direction drawn by one of the lobes; `None` where it scatters nothing.
    pub fn sample(&self, lobe: &Lobe, kind: NormalKind, u: [f64; 2]) -> Option<BsdfSample> {
        if !lobe.is_specular() && !self.is_outward(self.wo) {
            return None;
        }
        let frame = self.frame_of(lobe, kind);
        let wo = self.viewer(lobe, &frame);
        let mut sample = lobe.sample(wo, u)?;
        let true_wo = frame.to_local(self.wo);
        if let Some(pdf) = sample.pdf.filter(|_| wo != true_wo) {
            sample.weight = (sample.wi.z() / pdf) * lobe.formula(true_wo, sample.wi);
        }
        let transmits = sample.wi.z() * wo.z() < 0.0;
        let direction = frame.to_world(sample.wi);
        let stays = self.is_outward(direction) == self.is_outward(self.wo);
        if stays == transmits {
            return None; // an interpolated normal sent it to the wrong side of the true surface
        }
        // an index of refraction so far from 1 that the direction overflows has no direction
        let direction = direction.unit()?;
        let refracted = transmits.then(|| lobe.relative_eta(wo).unwrap_or(1.0));
        Some(BsdfSample { direction, weight: sample.weight, pdf: sample.pdf, refracted })
    }
}
