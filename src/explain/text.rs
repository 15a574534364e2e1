//! An explanation as text.

use std::fmt::{self, Write as _};

use super::{
    HitExplanation, Outline, PixelExplanation, RayExplanation, Row, SampleExplanation, Source,
    SourceExplanation, Sources, TermExplanation, unlit,
};
use crate::lobes::Lobe;
use crate::printable::{self, name};
use crate::rgb::Rgb;
use crate::textures::Texel;
use crate::trace::{Optics, Outcome, RayKind, RecordedTexture, TermSource};

/// A colour as `(0.12, 0.03, 0.03)`, a grey as `0.5`, shortened for people.
pub fn short(color: Rgb) -> String {
    let [r, g, b] = color.to_array().map(brief);
    if color == Rgb::grey(color.r) { r } else { format!("({r}, {g}, {b})") }
}

/// Three significant digits, or so.
pub fn brief(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        a if (1e-3..1e4).contains(&a) => format!("{}", (x * 1e3).round() / 1e3),
        _ => format!("{x:.2e}"),
    }
}

/// `83 %`, `0.4 %`.
pub fn percent(share: f64) -> String {
    match 100.0 * share {
        0.0 => "0 %".to_owned(),
        p if p.abs() < 0.05 => "< 0.1 %".to_owned(),
        p if p.abs() < 9.95 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

/// What became of a shadow ray that reached its light.
pub fn unblocked(boundaries: u32) -> String {
    match boundaries {
        0 => "unblocked".to_owned(),
        n => format!("straight through {}", count(n as usize, "transparent surface")),
    }
}

/// `1 ray`, `2 rays`.
pub fn count(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

impl RayExplanation {
    /// One line that a person can read: `3  from 1, depth 2  reflected  t 12.3  hits "red sphere"`. The camera's
    /// ray has no parent.
    pub fn line(&self) -> String {
        let kind = match &self.kind {
            RayKind::Camera => "camera".to_owned(),
            RayKind::Reflected => "reflected".to_owned(),
            RayKind::Transmitted => "transmitted".to_owned(),
            RayKind::Shadow { light } => format!("shadow ray to \"{}\"", name(light)),
        };
        let outcome = match &self.outcome {
            Outcome::Hit { hit } => format!("t {}  hits \"{}\"", brief(hit.t), name(&hit.object)),
            Outcome::Background => "hits nothing".to_owned(),
            Outcome::TooDeep => "beyond the largest depth: black".to_owned(),
            Outcome::Unblocked { boundaries } => unblocked(*boundaries),
            Outcome::Blocked { blocked_by } => format!("blocked by \"{}\"", name(blocked_by)),
        };
        let parent = self
            .parent
            .map_or(String::new(), |parent| format!("  from {parent}, depth {}", self.depth));
        format!("{}{parent}  {kind}  {outcome}", self.number)
    }

    /// Its numbers and terms, a line each.
    fn details(&self) -> Vec<String> {
        let mut lines = vec![format!("from {:?} towards {:?}", self.origin, self.direction)];
        if let Some(hit) = self.outcome.hit() {
            lines.extend(hit.lines());
        }
        let is_shadow = matches!(self.kind, RayKind::Shadow { .. });
        if !is_shadow {
            let (weight, radiance) = (short(self.weight), short(self.radiance));
            lines.push(format!("weight {weight}  radiance {radiance}"));
        }
        // of a shadow ray only what is lost: its light stands in the term that it belongs to
        let terms = self.terms.iter().filter(|term| {
            !is_shadow || term.weight != Rgb::WHITE || self.transmittance != Rgb::WHITE
        });
        lines.extend(terms.map(|term| format!("  {}", term.line())));
        lines.extend(unlit::lines(&self.unlit).iter().map(|line| format!("  + 0  {line}")));
        if self.transmittance != Rgb::WHITE {
            lines.push(format!("  × {}  through the medium", short(self.transmittance)));
        }
        lines.extend(self.black.iter().map(|zeros| format!("black: {zeros}")));
        lines
    }
}

impl HitExplanation {
    fn lines(&self) -> Vec<String> {
        let side = if self.front { "front" } else { "back" };
        let mut lines = Vec::new();
        if !self.path.is_empty() {
            lines.push(self.path.to_string());
        }
        lines.extend([
            format!("at {:?}, {side}, material \"{}\"", self.point, name(&self.material)),
            format!(
                "normal {:?}, angle of incidence {}°",
                self.normal,
                brief(self.angle_of_incidence)
            ),
        ]);
        if self.shading_normal != self.normal {
            lines.push(format!("shading normal {:?}", self.shading_normal));
        }
        lines.extend(self.textures.iter().map(RecordedTexture::to_string));
        lines.extend(self.optics.as_ref().map(Optics::to_string));
        if self.is_switched_off {
            lines.push("does not shine: its area light is switched off".to_owned());
        }
        lines
    }
}

/// `texture of cd: (0.2, 0.4, 0.1), texel (12, 5) at u 0.1, v 0.22`: column and row, from the bottom left.
impl fmt::Display for RecordedTexture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "texture of {}: {}", self.field, short(self.color))?;
        if let Some(Texel { uv: [u, v], column, row }) = self.texel {
            write!(f, ", texel ({column}, {row}) at u {}, v {}", brief(u), brief(v))?;
        }
        Ok(())
    }
}

/// `from η 1 into η 1.5: relative η 1.5, refracted at 27.4° (radiance × 1/η² = 0.444), R 0.05, T 0.95`.
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
                // the same light fills a smaller cone of directions in the denser medium (ch. 27)
                let factor = brief(1.0 / (self.eta * self.eta));
                write!(f, "refracted at {}° (radiance × 1/η² = {factor}), ", brief(angle))?;
            }
            None => f.write_str("total internal reflection, ")?,
        }
        write!(f, "R {}, T {}", short(self.reflected), short(self.transmitted))
    }
}

impl TermExplanation {
    /// One line: `+ 0.02  emission: MIS 0.01 × light 2`.
    pub fn line(&self) -> String {
        format!("+ {}  {}: {}", short(self.value), self.name(), self.factors())
    }

    /// The weight of the ray that brings its light, and how the ray was drawn: `weight 0.6, pdf 0.2 /sr,
    /// Lambertian` for a lobe's ray, `pdf 24 /sr, MIS 0.9` for a light's; empty if nothing was drawn.
    pub fn sampling(&self) -> String {
        match &self.source {
            TermSource::Traced { lobe, pdf, chance, survival } => {
                let mut parts = drawn(*pdf, *chance, *survival);
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
            TermSource::Ambient { light, .. } => format!("ambient, light \"{}\"", name(light)),
            TermSource::Direct { light, lobe, .. } => {
                format!("{}, light \"{}\"", lobe.name(), name(light))
            }
            TermSource::Traced { lobe, .. } => lobe.name().to_owned(),
            TermSource::Light { light } => format!("light \"{}\"", name(light)),
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
            TermSource::Traced { pdf, chance, survival, .. } => {
                let drawn = drawn(*pdf, *chance, *survival).join(", ");
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

/// How the direction of a lobe was drawn; chances of 1 are left out.
fn drawn(pdf: Option<f64>, chance: f64, survival: f64) -> Vec<String> {
    let mut parts: Vec<String> = pdf.iter().map(|pdf| format!("pdf {} /sr", brief(*pdf))).collect();
    for (name, probability) in [("chance", chance), ("survival", survival)] {
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
        Lobe::GlossyReflection(_)
        | Lobe::PerfectSpecular(_)
        | Lobe::PerfectTransmitter(_)
        | Lobe::FresnelReflector(_)
        | Lobe::FresnelTransmitter(_) => format!("f {}", short(f)),
    }
}

impl PixelExplanation {
    /// The explanation as text; rays that add less than `min_share` of their sample are folded. With
    /// `largest` only the path that carries most light is shown.
    pub fn text(&self, min_share: f64, largest: bool) -> String {
        let mut text = String::new();
        self.write(&mut text, min_share, largest).expect("a string takes everything");
        text
    }

    fn write(&self, f: &mut String, min_share: f64, largest: bool) -> fmt::Result {
        let [x, y] = self.pixel;
        let samples = self.samples.len();
        writeln!(f, "pixel ({x}, {y}), {samples} of {} samples", self.samples_per_pixel)?;
        self.notes.iter().try_for_each(|note| writeln!(f, "{}", printable::text(note)))?;
        for sample in &self.samples {
            writeln!(f)?;
            sample.write(f, min_share, largest)?;
        }
        writeln!(f)?;
        let mut samples: Vec<_> = self.samples.iter().collect();
        samples.sort_by(|a, b| b.radiance.average().total_cmp(&a.radiance.average()));
        for sample in samples {
            writeln!(f, "sample {:>4}: {:?}", sample.index, sample.radiance.to_array())?;
        }
        let exposure = match self.exposure_time {
            1.0 => String::new(),
            time => format!(", exposure time {time}"),
        };
        let count = self.samples_per_pixel;
        if let Some(error) = self.statistics.standard_error {
            let [least, greatest] = [self.statistics.least, self.statistics.greatest]
                .map(|index| format!("{} (sample {index})", short(self.radiances[index as usize])));
            let error = short(error);
            writeln!(f, "samples: least {least}, greatest {greatest}, standard error {error}")?;
        }
        for (words, sources) in self.sources.lists() {
            writeln!(f)?;
            writeln!(f, "{words}")?;
            table(sources).iter().try_for_each(|line| writeln!(f, "  {line}"))?;
        }
        writeln!(f)?;
        let radiance = self.radiance.to_array();
        writeln!(f, "the pixel is the mean of {count}{exposure}: {radiance:?}")
    }
}

impl Source<String> {
    /// `light "lamp"`.
    pub fn name(&self) -> String {
        match self {
            Self::Emission => "emission, seen directly".to_owned(),
            Self::Background => "background, seen directly".to_owned(),
            Self::Light { light } => format!("light \"{}\"", name(light)),
            Self::Lobe { lobe } => (*lobe).to_owned(),
        }
    }
}

impl Sources {
    /// The two ways to divide the pixel's light, each with its description.
    pub fn lists(&self) -> [(&'static str, &[SourceExplanation]); 2] {
        let by_entry = "the pixel by where light enters: a light's samples at all hits; what a lobe's rays meet";
        let by_first_hit =
            "the pixel by its first hit: a light's samples there; all light along a lobe's rays";
        [(by_entry, &self.by_entry), (by_first_hit, &self.by_first_hit)]
    }
}

/// A list of sources as lines of a table, the titles first.
pub fn table(sources: &[SourceExplanation]) -> Vec<String> {
    let row = |row: &SourceExplanation| {
        let deviation = row.standard_deviation.map_or("one sample".to_owned(), short);
        [row.source.name(), short(row.mean), deviation]
    };
    let titles = ["source", "mean", "standard deviation"].map(str::to_owned);
    let rows: Vec<[String; 3]> = std::iter::once(titles).chain(sources.iter().map(row)).collect();
    let width = |column: usize| {
        rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
    };
    let (names, means) = (width(0), width(1));
    rows.iter()
        .map(|[name, mean, deviation]| format!("{name:names$}  {mean:means$}  {deviation}"))
        .collect()
}

impl SampleExplanation {
    fn write(&self, f: &mut String, min_share: f64, largest: bool) -> fmt::Result {
        let index = self.index;
        let Some([px, py]) = self.film else {
            return writeln!(f, "sample {index}: between the two images, no ray");
        };
        write!(f, "sample {index} at ({}, {}) on the view plane", brief(px), brief(py))?;
        if let Some([lx, ly]) = self.lens {
            write!(f, ", ({}, {}) on the lens", brief(lx), brief(ly))?;
        }
        if self.weight != 1.0 {
            write!(f, ", counts {} by the filter", brief(self.weight))?;
        }
        writeln!(f)?;
        match &self.ray {
            None => writeln!(f, "no ray: the camera sees nothing there")?,
            Some(root) if largest => write_rows(f, &path_of_the_light(root))?,
            Some(root) => write_rows(f, &Outline::folding_below(min_share).rows(root))?,
        }
        if !self.complete {
            writeln!(
                f,
                "(cut off: the tree has more rays; a smaller max_depth makes a smaller one)"
            )?;
        }
        Ok(())
    }
}

/// The rays along which most of the light comes, as a chain.
fn path_of_the_light(root: &RayExplanation) -> Vec<Row<'_>> {
    let path = std::iter::successors(Some(root), |ray| ray.largest_child());
    path.map(|ray| Row::Ray { ray, term: None, indent: 0 }).collect()
}

/// The share of each ray at the left, its line, and its details below.
fn write_rows(f: &mut String, rows: &[Row<'_>]) -> fmt::Result {
    for row in rows {
        match row {
            Row::Ray { ray, indent, .. } => {
                let pad = "    ".repeat(*indent);
                let (share, contribution) = (percent(ray.share), short(ray.contribution));
                writeln!(f, "{share:>7}  {pad}{}  contributes {contribution}", ray.line())?;
                for line in ray.details() {
                    writeln!(f, "         {pad}      {line}")?;
                }
            }
            // among the ray's details
            Row::Local { .. } => {}
            Row::Folded { parent, indent, rays, share } => {
                let pad = "    ".repeat(*indent);
                let rays = count(*rays, "more ray");
                writeln!(
                    f,
                    "{:>7}  {pad}{rays} from {parent} (--min-share 0 shows all)",
                    percent(*share)
                )?;
            }
        }
    }
    Ok(())
}
