//! Rays, hits and terms as text.

use std::fmt::{self, Write as _};
use std::sync::Arc;

use groundtruth::lobes::Lobe;
use groundtruth::printable::name;
use groundtruth::rgb::Rgb;
use groundtruth::textures::Texel;
use groundtruth::trace::{Outcome, RayKind, TermSource};
use text::brief::{brief, count, short};

use super::optics::Optics;
use super::tree::{RecordedHit, RecordedRay, RecordedTerm, RecordedTexture};
use super::unlit;

/// The name of a light or an object, if there is one, in quotes.
pub fn quoted(known: &Option<Arc<str>>) -> String {
    known.as_ref().map_or(String::new(), |known| format!("\"{}\"", name(known)))
}

/// What became of a shadow ray that reached its light.
pub fn unblocked(boundaries: u32) -> String {
    match boundaries {
        0 => "unblocked".to_owned(),
        n => format!("straight through {}", count(n as usize, "transparent surface")),
    }
}

impl RecordedRay {
    /// One line that a person can read: `3  from 1, depth 2  reflected  t 12.3  hits "red sphere"`.
    /// The camera's ray has no parent.
    pub fn line(&self) -> String {
        let kind = match &self.kind {
            RayKind::Camera => "camera".to_owned(),
            RayKind::Reflected => "reflected".to_owned(),
            RayKind::Transmitted => "transmitted".to_owned(),
            RayKind::Shadow { .. } => format!("shadow ray to {}", quoted(&self.light)),
        };
        let hit = || {
            let hit = self.hit.as_ref()?;
            Some(format!("t {}  hits \"{}\"", brief(hit.t), name(&hit.object)))
        };
        let outcome = match &self.outcome {
            Outcome::Hit => hit().unwrap_or_default(),
            Outcome::Background => "hits nothing".to_owned(),
            Outcome::TooDeep => "beyond the largest depth: black".to_owned(),
            Outcome::Unblocked { boundaries } => unblocked(*boundaries),
            Outcome::OverBudget => "beyond the limit on the number of rays: black".to_owned(),
            Outcome::Blocked { .. } => format!("blocked by {}", quoted(&self.blocked_by)),
        };
        let parent = self
            .parent
            .map_or(String::new(), |parent| format!("  from {parent}, depth {}", self.depth));
        format!("{}{parent}  {kind}  {outcome}", self.number)
    }

    /// Its numbers and terms, a line each; with `formulas`, that of each term in a line below it.
    pub fn details(&self, formulas: bool) -> Vec<String> {
        let (origin, direction) = (self.ray.origin.to_array(), self.ray.direction.to_array());
        let mut lines = vec![format!("from {origin:?} towards {direction:?}")];
        if let Some(hit) = &self.hit {
            lines.extend(hit.lines());
        }
        if !self.is_shadow() {
            let (weight, radiance) = (short(self.weight), short(self.radiance));
            lines.push(format!("weight {weight}  radiance {radiance}"));
        }
        // of a shadow ray only what is lost: its light stands in the term that it belongs to
        let terms = self.terms.iter().filter(|term| {
            !self.is_shadow() || term.weight != Rgb::WHITE || self.transmittance != Rgb::WHITE
        });
        for term in terms {
            lines.push(format!("  {}", term.line()));
            lines.extend(formulas.then(|| format!("    {}", self.formula(term))));
        }
        lines.extend(unlit::lines(&self.unlit).iter().map(|line| format!("  + 0  {line}")));
        if self.transmittance != Rgb::WHITE {
            lines.push(format!("  × {}  through the medium", short(self.transmittance)));
        }
        lines.extend(self.black.iter().map(|zeros| format!("black: {zeros}")));
        lines
    }
}

impl RecordedHit {
    fn lines(&self) -> Vec<String> {
        let side = if self.front { "front" } else { "back" };
        let mut lines = Vec::new();
        if !self.path.is_empty() {
            lines.push(self.path.to_string());
        }
        let (point, material) = (self.point.to_array(), name(&self.material));
        lines.push(format!("at {point:?}, {side}, material \"{material}\""));
        let (normal, angle) = (self.normal.to_array(), brief(self.angle_of_incidence));
        lines.push(format!("normal {normal:?}, angle of incidence {angle}°"));
        if self.shading_normal != self.normal {
            lines.push(format!("shading normal {:?}", self.shading_normal.to_array()));
        }
        lines.extend(self.textures.iter().map(RecordedTexture::to_string));
        lines.extend(self.optics.as_ref().map(Optics::to_string));
        if self.is_switched_off {
            lines.push("does not shine: its area light is switched off".to_owned());
        }
        lines
    }
}

/// `texture of cd: (0.2, 0.4, 0.1), texel (12, 5) at u 0.1, v 0.22`: column and row, from the
/// bottom left.
impl fmt::Display for RecordedTexture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "texture of {}: {}", self.field, short(self.color))?;
        if let Some(Texel { uv: [u, v], column, row }) = self.texel {
            write!(f, ", texel ({column}, {row}) at u {}, v {}", brief(u), brief(v))?;
        }
        Ok(())
    }
}

/// `from η 1 into η 1.5: relative η 1.5, refracted at 27.4° (radiance × 1/η² = 0.444),`
/// `R 0.05, T 0.95`.
impl fmt::Display for Optics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(media) = self.media {
            let [front, behind] = media.map(|medium| {
                let (eta, sigma) = (brief(medium.eta), medium.absorption);
                let clear = sigma.is_black();
                if clear { format!("η {eta}") } else { format!("η {eta}, σ {}", short(sigma)) }
            });
            write!(f, "from {front} into {behind}: ")?;
        }
        write!(f, "relative η {}, ", brief(self.eta))?;
        if let Some(angle) = self.critical_angle {
            write!(f, "critical angle {}°, ", brief(angle))?;
        }
        match self.angle_of_refraction {
            Some(angle) => {
                write!(f, "refracted at {}°", brief(angle))?;
                if self.scales_radiance {
                    // the same light fills a smaller cone of directions in the denser medium (ch. 27)
                    write!(f, " (radiance × 1/η² = {})", brief(1.0 / (self.eta * self.eta)))?;
                }
                f.write_str(", ")?;
            }
            None => f.write_str("total internal reflection, ")?,
        }
        write!(f, "R {}, T {}", short(self.reflected), short(self.transmitted))
    }
}

impl RecordedTerm {
    /// One line: `+ 0.02  emission: MIS 0.01 × light 2`.
    pub fn line(&self) -> String {
        format!("+ {}  {}: {}", short(self.value), self.name(), self.factors())
    }

    /// The weight of the ray that brings its light, and how the ray was drawn:
    /// `weight 0.6, pdf 0.2 /sr, Lambertian` for a lobe's ray, `pdf 24 /sr, MIS 0.9` for a light's;
    /// empty if nothing was drawn.
    pub fn sampling(&self) -> String {
        match &self.source {
            TermSource::Traced { lobe, pdf, lobe_probability, survival } => {
                let mut parts = drawn(*pdf, *lobe_probability, *survival);
                parts.insert(0, format!("weight {}", short(self.weight)));
                parts.push(lobe.name().to_owned());
                parts.join(", ")
            }
            TermSource::Direct { pdf: Some(pdf), mis, .. } => {
                let mis = mis.map_or(String::new(), |mis| format!(", MIS {}", brief(mis)));
                format!("pdf {} /sr{mis}", brief(*pdf))
            }
            TermSource::Direct { pdf: None, .. }
            | TermSource::Background { .. }
            | TermSource::Emission { .. }
            | TermSource::Ambient { .. }
            | TermSource::Light { .. } => String::new(),
        }
    }

    /// Where it comes from: `Lambertian, light "lamp"`.
    pub fn name(&self) -> String {
        match &self.source {
            TermSource::Background { .. } => "background".to_owned(),
            TermSource::Emission { .. } => "emission".to_owned(),
            TermSource::Ambient { .. } => format!("ambient, light {}", quoted(&self.light)),
            TermSource::Direct { lobe, .. } => {
                format!("{}, light {}", lobe.name(), quoted(&self.light))
            }
            TermSource::Traced { lobe, .. } => lobe.name().to_owned(),
            TermSource::Light { .. } => format!("light {}", quoted(&self.light)),
        }
    }

    /// Its factors: `(0.8, 0.4, 0.1) / π × cos θ 0.5 × 2 along ray 3`.
    pub fn factors(&self) -> String {
        let mut text = match &self.source {
            TermSource::Direct { lobe, f, cos_i, pdf, mis, .. } => {
                let mut text = value_of(lobe, *f);
                let _ = write!(text, " × cos θ {}", brief(*cos_i));
                if let Some(pdf) = pdf {
                    let _ = write!(text, " / pdf {}", brief(*pdf));
                }
                if let Some(mis) = mis {
                    let _ = write!(text, " × MIS {}", brief(*mis));
                }
                text
            }
            TermSource::Ambient { .. } => format!("reflectance {}", short(self.weight)),
            TermSource::Background { mis: Some(mis) } | TermSource::Emission { mis: Some(mis) } => {
                format!("MIS {}", brief(*mis))
            }
            TermSource::Traced { pdf, lobe_probability, survival, .. } => {
                let drawn = drawn(*pdf, *lobe_probability, *survival).join(", ");
                let drawn = if drawn.is_empty() { drawn } else { format!(" ({drawn})") };
                format!("weight {}{drawn}", short(self.weight))
            }
            TermSource::Background { mis: None }
            | TermSource::Emission { mis: None }
            | TermSource::Light { .. } => format!("weight {}", short(self.weight)),
        };
        let arriving = short(self.arriving);
        let _ = match self.ray {
            Some(ray) => write!(text, " × {arriving} along ray {ray}"),
            None => write!(text, " × light {arriving}"),
        };
        text
    }
}

/// How the direction of a lobe was drawn; probabilities of 1 are left out.
fn drawn(pdf: Option<f64>, lobe_probability: f64, survival: f64) -> Vec<String> {
    let mut parts: Vec<String> = pdf.iter().map(|pdf| format!("pdf {} /sr", brief(*pdf))).collect();
    for (name, probability) in [("chance", lobe_probability), ("survival", survival)] {
        if probability != 1.0 {
            parts.push(format!("{name} {}", brief(probability)));
        }
    }
    parts
}

/// The value of a lobe, `f`, in the terms of its formula.
fn value_of(lobe: &Lobe, f: Rgb) -> String {
    match lobe {
        Lobe::Lambertian(lobe) => format!("reflectance {} / π", short(lobe.reflectance)),
        Lobe::GlossySpecular(lobe) => {
            let (reflectance, exponent) = (short(lobe.reflectance), brief(lobe.exponent));
            format!("f {} (reflectance {reflectance}, exponent {exponent})", short(f))
        }
        _ => format!("f {}", short(f)),
    }
}
