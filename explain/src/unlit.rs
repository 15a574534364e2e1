//! The lights that add nothing at a hit, and why a ray brings no light at all.

use std::fmt;
use std::sync::Arc;

use groundtruth::printable::name;
use groundtruth::rgb::Rgb;
use groundtruth::trace::{Outcome, TermSource};
use serde::Serialize;
use text::brief::brief;

use super::Explaining;
use super::tree::{RecordedHit, RecordedRay, RecordedTerm};

/// A light that adds nothing at a hit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UnlitLight {
    /// Its name.
    pub light: Arc<str>,
    /// The reason.
    #[serde(flatten)]
    pub reason: Unlit,
}

/// The reason why a light adds nothing at a hit: the first factor of its light that is 0. Cosines
/// are those of unit directions from the hit, angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "reason", rename_all = "snake_case")]
pub enum Unlit {
    /// It has `enabled = false`.
    SwitchedOff,
    /// The tracer never counts such lights; a note of the explanation says why.
    LeftOut,
    /// The tracer samples no lights: it counts where a path hits it.
    NotSampled,
    /// The tracer samples lights at the first hit only.
    FirstHitOnly,
    /// The edge from the hit to the light would exceed the largest depth.
    TooDeep,
    /// The material reflects no ambient light.
    NoAmbientReflectance,
    /// The viewer is behind the surface, which is one-sided.
    ViewerBehind {
        /// Between the true normal and the direction to the viewer.
        cos_o: f64,
    },
    /// The material has no lobes.
    NoLobes,
    /// The material has only lobes of a single direction or of traced rays, which samples of lights
    /// do not meet.
    TracedLobesOnly,
    /// The light is behind the surface.
    BehindSurface {
        /// Between the shading normal and the direction to the light.
        cos_i: f64,
    },
    /// The light is in front of the shading normal's plane, but behind the true surface: the shadow
    /// terminator of smooth meshes and of bumps.
    BehindTrueSurface {
        /// Between the true normal and the direction to the light.
        cos_i: f64,
        /// Between the shading normal and the direction to the light.
        cos_shading: f64,
        /// How far away the hit's own mesh is in the way, in mean edges of the triangle there.
        #[serde(skip_serializing_if = "Option::is_none")]
        edges: Option<f64>,
    },
    /// The lobes scatter nothing from the light's direction to the viewer.
    OutsideLobes {
        /// Between the shading normal and the direction to the light.
        cos_i: f64,
    },
    /// The light sends nothing: its radiance is 0.
    Dark,
    /// The hit is outside the cone of a spot light.
    OutsideCone {
        /// Between the axis and the direction to the hit.
        angle: f64,
        /// From this angle on the light is dark.
        outer: f64,
    },
    /// The hit is behind the lamp, which is one-sided.
    BehindLamp {
        /// Between the lamp's normal and the direction to the hit.
        cos_lamp: f64,
    },
    /// The hit is at the light, or so near that its radiance would be infinite.
    AtLight {
        /// From the hit to the light.
        distance: f64,
    },
    /// The drawn point is on the far side of the lamp, or is seen edge-on.
    HiddenPoint,
    /// The drawn numbers give no direction to the light.
    NoDirection,
    /// An object is in between.
    Blocked {
        /// Its name.
        blocked_by: Arc<str>,
        /// If it is the hit's own mesh: how far away, in mean edges of the triangle there.
        #[serde(skip_serializing_if = "Option::is_none")]
        edges: Option<f64>,
    },
    /// The medium transmits nothing.
    Absorbed,
    /// The surface reflects none of the colours that arrive.
    OtherColors,
    /// The contribution is smaller than the smallest number of a picture.
    TooWeak,
}

/// Lines such as `lights "sun", "lamp": switched off`: lights with equal reasons share one.
pub fn lines(unlit: &[UnlitLight]) -> Vec<String> {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for UnlitLight { light, reason } in unlit {
        let (reason, light) = (reason.to_string(), format!("\"{}\"", name(light)));
        match groups.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, lights)) => lights.push(light),
            None => groups.push((reason, vec![light])),
        }
    }
    let line = |(reason, lights): (String, Vec<String>)| {
        let s = if lights.len() == 1 { "" } else { "s" };
        format!("light{s} {}: {reason}", lights.join(", "))
    };
    groups.into_iter().map(line).collect()
}

fn own_mesh(edges: Option<f64>) -> String {
    let away = |edges| format!("; its own mesh is in the way, {} of an edge away", brief(edges));
    edges.map_or(String::new(), away)
}

impl fmt::Display for Unlit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Self::SwitchedOff => "switched off",
            Self::LeftOut => "left out by the tracer",
            Self::NotSampled => "not sampled by the tracer; it counts where a path hits it",
            Self::FirstHitOnly => "sampled at the first hit only",
            Self::TooDeep => "beyond the largest depth",
            Self::NoAmbientReflectance => "the ambient reflectance is 0",
            Self::ViewerBehind { cos_o } => {
                let cos_o = brief(*cos_o);
                return write!(f, "the viewer is behind the one-sided surface, cos θ_o = {cos_o}");
            }
            Self::NoLobes => "the material scatters nothing",
            Self::TracedLobesOnly => "the material scatters light of traced rays only",
            Self::BehindSurface { cos_i } => {
                let side = if *cos_i < 0.0 { "behind" } else { "in the plane of" };
                return write!(f, "{side} the surface, cos θ = {}", brief(*cos_i));
            }
            Self::BehindTrueSurface { cos_i, cos_shading, edges } => {
                let [lit, dark] = [cos_shading, cos_i].map(|cosine| brief(*cosine));
                let lit = format!("shading normal lit, cos θ = {lit}, true normal dark, {dark}");
                return write!(f, "behind the true surface: {lit}{}", own_mesh(*edges));
            }
            Self::OutsideLobes { cos_i } => {
                return write!(f, "no lobe scatters it to the viewer, cos θ = {}", brief(*cos_i));
            }
            Self::Dark => "its radiance is 0",
            Self::OutsideCone { angle, outer } => {
                let (angle, outer) = (brief(*angle), brief(*outer));
                return write!(f, "outside its cone: {angle}° from the axis, dark from {outer}°");
            }
            Self::BehindLamp { cos_lamp } => {
                return write!(f, "behind the one-sided lamp, cos θ' = {}", brief(*cos_lamp));
            }
            Self::AtLight { distance } => {
                return write!(f, "too near the light, distance {}", brief(*distance));
            }
            Self::HiddenPoint => "the drawn point is on the far side of the lamp, or seen edge-on",
            Self::NoDirection => "the drawn numbers give no direction",
            Self::Blocked { blocked_by, edges } => {
                return write!(f, "blocked by \"{}\"{}", name(blocked_by), own_mesh(*edges));
            }
            Self::Absorbed => "absorbed by the medium",
            Self::OtherColors => "the surface reflects none of its colours",
            Self::TooWeak => "smaller than the smallest number of a picture",
        };
        f.write_str(text)
    }
}

impl Explaining<'_> {
    /// One sentence about a ray, not a shadow ray, that brings no light: the first factor of each
    /// of its terms that is 0.
    pub(super) fn black(&self, ray: &RecordedRay) -> Option<String> {
        if !ray.radiance.is_black() || ray.is_shadow() {
            return None;
        }
        let terms: Rgb = ray.terms.iter().map(|term| term.value).sum();
        Some(match &ray.outcome {
            Outcome::Blocked { .. } | Outcome::Unblocked { .. } => return None,
            Outcome::TooDeep => "it is beyond the largest depth, and not cast".to_owned(),
            Outcome::OverBudget => "the limit on the number of rays was reached".to_owned(),
            Outcome::Hit | Outcome::Background if !terms.is_black() => {
                "the medium transmits nothing over its length".to_owned()
            }
            Outcome::Background if ray.terms.iter().all(|term| term.arriving.is_black()) => {
                "the background is black there".to_owned()
            }
            Outcome::Background => SAMPLED_BEFORE.replace("{}", "the background"),
            Outcome::Hit => {
                let emission = ray.hit.as_ref().and_then(|hit| no_emission(ray, hit));
                let mut zeros: Vec<String> = emission.into_iter().collect();
                if self.scene.lights.is_empty() {
                    zeros.push("the scene has no lights".to_owned());
                }
                zeros.extend(lines(&ray.unlit));
                zeros.extend(no_traced_light(ray));
                zeros.join("; ")
            }
        })
    }
}

/// What global_trace says of a lamp or sky that a path meets.
const SAMPLED_BEFORE: &str = "{} counts 0 here: it was sampled at the hit before";

/// Why a material that shines adds nothing.
fn no_emission(ray: &RecordedRay, hit: &RecordedHit) -> Option<String> {
    if !hit.is_emissive {
        return None;
    }
    let is_met = ray.terms.iter().any(|it| matches!(it.source, TermSource::Emission { .. }));
    Some(match () {
        () if hit.is_switched_off => "its area light is switched off".to_owned(),
        () if is_met => SAMPLED_BEFORE.replace("{}", "the lamp"),
        () if hit.cos_o <= 0.0 => {
            let cos_o = brief(hit.cos_o);
            format!("it shines on its front only, and the viewer is behind, cos θ_o = {cos_o}")
        }
        () => "its emission is 0 there".to_owned(),
    })
}

/// The rays that a hit sent and that bring nothing.
fn no_traced_light(ray: &RecordedRay) -> Option<String> {
    let is_traced = |it: &&RecordedTerm| matches!(it.source, TermSource::Traced { .. });
    let traced = ray.terms.iter().filter(is_traced).filter_map(|it| it.ray);
    let numbers: Vec<String> = traced.map(|number| number.to_string()).collect();
    match numbers.len() {
        0 => None,
        1 => Some(format!("ray {} brings 0", numbers[0])),
        _ => Some(format!("rays {} bring 0", numbers.join(", "))),
    }
}
