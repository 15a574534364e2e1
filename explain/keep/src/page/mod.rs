//! Why a pixel has its colour, as one HTML file without network or script.

mod picture;
mod samples;
mod style;
mod tree;

use std::fmt::Write;

use groundtruth::explain::{PixelExplanation, RecordedRay, SourceExplanation, count, percent};
use groundtruth::film::data_uri;
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use pictures::digits::three;
use pictures::html::{LINES, escaped, page};
use space::{Section, hiding, orbit_of, svg_of_rays};

pub use picture::SmallPicture;

/// What is on a page.
#[derive(Clone, Copy, Debug)]
pub struct PixelPage<'a> {
    /// What the scene is called.
    pub name: &'a str,
    /// The scene.
    pub scene: &'a Scene,
    /// Its world.
    pub world: &'a World,
    /// The pixel explained. Each explained sample has its tree; section and space are of the first.
    pub explanation: &'a PixelExplanation,
    /// The picture, in which the pixel is marked.
    pub picture: &'a SmallPicture,
    /// The ray whose section is shown; if it is `None` or has no section, the one that [`Section::first`] finds.
    pub ray: Option<usize>,
    /// The command that explains the pixel.
    pub command: &'a str,
}

impl PixelPage<'_> {
    /// The page.
    pub fn html(&self) -> String {
        let [x, y] = self.explanation.pixel;
        let title = escaped(&format!("Why pixel ({x}, {y}) of {} has its colour", self.name));
        let about = escaped(&self.scene.about);
        let mut body = format!("<p class=\"about\">{about}</p>\n<h1>{title}</h1>\n");
        let sample = self.explanation.samples.first();
        let root = sample.and_then(|sample| sample.ray.as_ref());
        let section = root.and_then(|root| self.section(root));
        body += "<div class=\"two\">\n";
        body += &self.picture();
        if let Some((_, section)) = &section {
            let (title, drawing) = (escaped(&section.drawing.title), section.drawing.svg());
            let _ =
                write!(body, "<figure>\n{drawing}<figcaption>{title}</figcaption>\n</figure>\n");
        }
        body += "</div>\n";
        if let Some(root) = root {
            body += &self.space(root);
        }
        body += &self.sum();
        let mut rays = 0;
        if let Some(sample) = sample {
            body += &self.samples(section.map(|(ray, _)| ray));
            rays = sample.ray.as_ref().map_or(0, RecordedRay::count);
        }
        let command = escaped(self.command);
        let _ = write!(body, "<h2>The same in a terminal</h2>\n<p><code>{command}</code></p>\n");
        page(&title, &[LINES, style::STYLE, &style::linked(rays)], &body)
    }

    /// The section that is shown, and the number of its ray.
    fn section(&self, root: &RecordedRay) -> Option<(usize, Section)> {
        let of = |ray: usize| Some((ray, Section::of(self.world, root, ray)?));
        self.ray.and_then(of).or_else(|| Section::first(root).and_then(of))
    }

    /// The picture with a ring around the pixel, and the pixel's colour.
    fn picture(&self) -> String {
        let SmallPicture { film, samples, of_samples } = self.picture;
        let data = data_uri(film, &self.scene.image.tone());
        let [width, height] = self.world.picture_size();
        let [x, y] = self.explanation.pixel;
        let [cx, cy] = [f64::from(x) + 0.5, f64::from(y) + 0.5];
        let r = 0.03 * f64::from(width.max(height)).max(30.0);
        let ring = |color: &str, part: f64| {
            format!(
                "<circle cx=\"{cx}\" cy=\"{cy}\" r=\"{r:.2}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{:.2}\"/>",
                part * r
            )
        };
        let rings = ring("#000000", 0.4) + &ring("#ffdd00", 0.2);
        let fewer = match samples < of_samples {
            true => format!(" The picture is of {samples} of {of_samples} samples a pixel."),
            false => String::new(),
        };
        let radiance = self.explanation.radiance;
        format!(
            "<figure>\n<div class=\"picture\"><img alt=\"the picture\" src=\"{data}\"/><svg viewBox=\"0 0 {width} \
             {height}\" preserveAspectRatio=\"none\">{rings}</svg></div>\n<figcaption>Pixel ({x}, {y}): {} radiance \
             {}.{fewer}</figcaption>\n</figure>\n",
            self.color(radiance),
            three(radiance.to_array())
        )
    }

    /// A square of this colour.
    fn color(&self, radiance: Rgb) -> String {
        let [r, g, b] = self.scene.image.tone().to_bytes(radiance);
        format!("<span class=\"color\" style=\"background:rgb({r},{g},{b})\"></span>")
    }

    fn space(&self, root: &RecordedRay) -> String {
        let orbit = orbit_of(self.world, root);
        let faded = hiding(self.world, root, &orbit);
        let svg = svg_of_rays(self.world, root, &orbit, &faded);
        format!(
            "<figure class=\"space\">\n<h2>The rays in space</h2>\n{svg}<figcaption>Faint: hidden behind a surface. The \
             numbers are those of the rays in the tree.</figcaption>\n</figure>\n"
        )
    }

    /// What each light and each lobe adds to the pixel.
    fn sum(&self) -> String {
        let count = count(self.explanation.samples_per_pixel as usize, "sample");
        let mut html = format!("<h2>The sum</h2>\n<p>The pixel is the mean of {count}.");
        if let Some(error) = self.explanation.statistics.standard_error {
            let _ = write!(html, " Standard error: {}.", three(error.to_array()));
        }
        html += "</p>\n";
        for note in &self.explanation.notes {
            let _ = writeln!(html, "<p>{}</p>", escaped(note));
        }
        for (words, sources) in self.explanation.sources.lists() {
            if sources.is_empty() {
                continue;
            }
            let _ = write!(html, "<p>{}:</p>\n<table class=\"numbers\">\n", escaped(words));
            sources.iter().for_each(|source| self.add_source(&mut html, source));
            html += "</table>\n";
        }
        html
    }

    fn add_source(&self, html: &mut String, source: &SourceExplanation) {
        let whole = self.explanation.radiance.average();
        let share = match whole > 0.0 {
            true => escaped(&percent(source.mean.average() / whole)),
            false => String::new(),
        };
        let _ = writeln!(
            html,
            "<tr><td>{}</td><td>{} {}</td><td>{share}</td></tr>",
            escaped(&source.source.name()),
            self.color(source.mean),
            three(source.mean.to_array())
        );
    }
}
