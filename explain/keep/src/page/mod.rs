//! Why a pixel has its colour, as one HTML file without network or script.

mod picture;
mod samples;
mod style;
mod tree;

use explain::{PixelExplanation, RecordedRay, SourceExplanation};
use groundtruth::rgb::Rgb;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use space::{Section, hiding, orbit_of, svg_of_rays};
use text::brief::{count, percent};
use text::digits::three;
use text::document::*;
use text::html::{LINES, escaped, page};

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
        let title = format!("Why pixel ({x}, {y}) of {} has its colour", self.name);
        let sample = self.explanation.samples.first();
        let root = sample.and_then(|sample| sample.ray.as_ref());
        let section = root.and_then(|root| self.section(root));
        let drawn = |(_, section): &(usize, Section)| {
            figure(Node::Drawing(section.drawing.svg()), &section.drawing.title)
        };
        let two = group("two").with(self.picture()).with_all(section.as_ref().map(drawn));
        let rays = root.map_or(0, RecordedRay::count);
        let body = several()
            .with(paragraph(&self.scene.about).class("about"))
            .with(heading(1, &title))
            .with(two)
            .with_all(root.map(|root| self.space(root)))
            .with(self.sum())
            .with_all(sample.map(|_| self.samples(section.map(|(ray, _)| ray))))
            .with(heading(2, "The same in a terminal"))
            .with(paragraph(code(self.command)));
        page(&escaped(&title), &[LINES, style::STYLE, &style::linked(rays)], &body.html())
    }

    /// The section that is shown, and the number of its ray.
    fn section(&self, root: &RecordedRay) -> Option<(usize, Section)> {
        let of = |ray: usize| Some((ray, Section::of(self.world, root, ray)?));
        self.ray.and_then(of).or_else(|| Section::first(root).and_then(of))
    }

    /// The picture with a ring around the pixel, and the pixel's colour.
    fn picture(&self) -> Element {
        let SmallPicture { film, samples, of_samples } = self.picture;
        let [width, height] = self.world.picture_size();
        let [x, y] = self.explanation.pixel;
        let [cx, cy] = [f64::from(x) + 0.5, f64::from(y) + 0.5];
        let r = 0.03 * f64::from(width.max(height)).max(30.0);
        let ring = |(color, part): (&str, f64)| {
            element("circle")
                .attribute("cx", cx)
                .attribute("cy", cy)
                .attribute("r", format!("{r:.2}"))
                .attribute("fill", "none")
                .attribute("stroke", color)
                .attribute("stroke-width", format!("{:.2}", part * r))
        };
        let rings = element("svg")
            .attribute("viewBox", format!("0 0 {width} {height}"))
            .attribute("preserveAspectRatio", "none")
            .with_all([("#000000", 0.4), ("#ffdd00", 0.2)].map(ring));
        let fewer = match samples < of_samples {
            true => format!(" The picture is of {samples} of {of_samples} samples a pixel."),
            false => String::new(),
        };
        let radiance = self.explanation.radiance;
        let caption = several()
            .with(format!("Pixel ({x}, {y}): "))
            .with(self.color(radiance))
            .with(format!(" radiance {}.{fewer}", three(radiance.to_array())));
        let image = image(film, &self.scene.image.tone(), "the picture");
        figure(group("picture").with(image).with(rings), caption)
    }

    /// A square of this colour.
    fn color(&self, radiance: Rgb) -> Element {
        let [r, g, b] = self.scene.image.tone().to_bytes(radiance);
        element("span").class("color").attribute("style", format!("background:rgb({r},{g},{b})"))
    }

    /// The square, and the numbers.
    fn value(&self, radiance: Rgb) -> Element {
        several().with(self.color(radiance)).with(format!(" {}", three(radiance.to_array())))
    }

    fn space(&self, root: &RecordedRay) -> Element {
        let orbit = orbit_of(self.world, root);
        let faded = hiding(self.world, root, &orbit);
        let svg = svg_of_rays(self.world, root, &orbit, &faded);
        let title = heading(2, "The rays in space");
        figure(
            several().with(title).with(Node::Drawing(svg)),
            "Faint: hidden behind a surface. The numbers are those of the rays in the tree.",
        )
        .class("space")
    }

    /// What each light and each lobe adds to the pixel.
    fn sum(&self) -> Element {
        let count = count(self.explanation.samples_per_pixel as usize, "sample");
        let error = self.explanation.statistics.standard_error;
        let error = error.map(|error| format!(" Standard error: {}.", three(error.to_array())));
        let mean = format!("The pixel is the mean of {count}.");
        let lists = self.explanation.sources.lists().into_iter();
        let lists = lists.filter(|(_, sources)| !sources.is_empty()).map(|(words, sources)| {
            several().with(paragraph(format!("{words}:"))).with(self.table(sources))
        });
        several()
            .with(heading(2, "The sum"))
            .with(paragraph(mean).with_all(error))
            .with_all(self.explanation.notes.iter().map(paragraph))
            .with_all(lists)
    }

    fn table(&self, sources: &[SourceExplanation]) -> Element {
        let whole = self.explanation.radiance.average();
        let share = |source: &&SourceExplanation| match whole > 0.0 {
            true => percent(source.mean.average() / whole),
            false => String::new(),
        };
        let table = table(sources)
            .column("", |source| source.source.name())
            .column("", |source| self.value(source.mean))
            .column("", share);
        group("numbers").with(table.element())
    }
}
