//! The explanation of a pixel as text.

use std::fmt::{self, Write as _};

use groundtruth::printable::{self, name};
use text::brief::{brief, count, percent, short};

use super::{
    Outline, PixelExplanation, RecordedRay, Row, SampleExplanation, Source, SourceExplanation,
    Sources,
};

/// What of the trees is shown.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Rays that add a smaller part of their sample are folded.
    pub min_share: f64,
    /// Whether only the path that carries most light is shown.
    pub largest: bool,
    /// Whether each term has its formula, in the book's letters and with its numbers.
    pub formulas: bool,
}

impl PixelExplanation {
    /// The explanation as text; rays that add less than `min_share` of their sample are folded.
    /// With `largest` only the path that carries most light is shown.
    pub fn text(&self, min_share: f64, largest: bool) -> String {
        self.shown(Shown { min_share, largest, formulas: false })
    }

    /// This much of the explanation as text.
    pub fn shown(&self, shown: Shown) -> String {
        let mut text = String::new();
        self.write(&mut text, shown).expect("a string takes everything");
        text
    }

    fn write(&self, f: &mut String, shown: Shown) -> fmt::Result {
        let [x, y] = self.pixel;
        let samples = self.samples.len();
        writeln!(f, "pixel ({x}, {y}), {samples} of {} samples", self.samples_per_pixel)?;
        self.notes.iter().try_for_each(|note| writeln!(f, "{}", printable::text(note)))?;
        for sample in &self.samples {
            writeln!(f)?;
            sample.write(f, shown)?;
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
            writeln!(f, "\n{words}")?;
            table(sources).iter().try_for_each(|line| writeln!(f, "  {line}"))?;
        }
        let radiance = self.radiance.to_array();
        writeln!(f, "\nthe pixel is the mean of {count}{exposure}: {radiance:?}")
    }
}

impl Source {
    /// `light "lamp"`.
    pub fn name(&self) -> String {
        match self {
            Self::Emission => "emission, seen directly".to_owned(),
            Self::Background => "background, seen directly".to_owned(),
            Self::Light { light, .. } => format!("light \"{}\"", name(light)),
            Self::Lobe { lobe } => (*lobe).to_owned(),
        }
    }
}

impl Sources {
    /// The two ways to divide the pixel's light, each with its description.
    pub fn lists(&self) -> [(&'static str, &[SourceExplanation]); 2] {
        let by_entry = "the pixel by source: direct light of each light, at all hits; emission and background that rays of each BRDF (lobe) hit";
        let by_first_hit = "the pixel at its first hit: direct light of each light there; all light that arrives along rays of each BRDF (lobe)";
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
    fn write(&self, f: &mut String, shown: Shown) -> fmt::Result {
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
            Some(root) => {
                let rows = match shown.largest {
                    true => path_of_the_light(root),
                    false => Outline::folding_below(shown.min_share).rows(root),
                };
                write_rows(f, &rows, shown.formulas)?;
            }
        }
        const CUT: &str =
            "(cut off: the tree has more rays; a smaller max_depth makes a smaller one)";
        if self.complete { Ok(()) } else { writeln!(f, "{CUT}") }
    }
}

/// The rays along which most of the light comes, as a chain.
fn path_of_the_light(root: &RecordedRay) -> Vec<Row<'_>> {
    let path = std::iter::successors(Some(root), |ray| ray.largest_child());
    path.map(|ray| Row::Ray { ray, term: None, indent: 0 }).collect()
}

/// The share of each ray at the left, its line, and its details below.
fn write_rows(f: &mut String, rows: &[Row<'_>], formulas: bool) -> fmt::Result {
    for row in rows {
        match row {
            Row::Ray { ray, indent, .. } => {
                let pad = "    ".repeat(*indent);
                let (share, contribution) = (percent(ray.share), short(ray.contribution));
                writeln!(f, "{share:>7}  {pad}{}  contributes {contribution}", ray.line())?;
                for line in ray.details(formulas) {
                    writeln!(f, "         {pad}      {line}")?;
                }
            }
            // among the ray's details
            Row::Local { .. } => {}
            Row::Folded { parent, indent, rays, share } => {
                let pad = "    ".repeat(*indent);
                let (share, rays) = (percent(*share), count(*rays, "more ray"));
                writeln!(f, "{share:>7}  {pad}{rays} from {parent} (--min-share 0 shows all)")?;
            }
        }
    }
    Ok(())
}
