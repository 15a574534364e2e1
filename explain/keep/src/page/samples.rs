//! The samples of a pixel: the trees of those that are explained, and the values of all.

use explain::SampleExplanation;
use groundtruth::rgb::Rgb;
use text::brief::count;
use text::digits::three;
use text::document::*;

use super::PixelPage;
use super::tree::{MAX_RAYS, Tree};

/// The most samples whose values are listed.
const LISTED: usize = 1024;

impl PixelPage<'_> {
    /// The trees of the explained samples, folded if there are several, or the tree of one and the values of all; the
    /// section of the ray `shown` of the first stands elsewhere.
    pub(super) fn samples(&self, shown: Option<usize>) -> Element {
        let (of, samples) = (self.explanation.samples_per_pixel, &self.explanation.samples);
        let mut left = MAX_RAYS;
        match &samples[..] {
            [] => several(),
            [only] if of == 1 => several()
                .with(heading(2, "The tree of its rays"))
                .with(self.tree(only, shown, &mut left)),
            [only] => {
                let index = only.index;
                let about = format!(
                    "This page shows sample {index} of {of} (they count from 0), here, in section and in space: \
                     radiance {}.",
                    three(only.radiance.to_array())
                );
                several()
                    .with(heading(2, format!("The tree of sample {index}")))
                    .with(paragraph(about))
                    .with(self.tree(only, shown, &mut left))
                    .with(self.values(index))
            }
            [first, ..] => {
                let title = format!("The trees of its {}", count(samples.len(), "sample"));
                let about = format!("Section and space show sample {}.", first.index);
                let mut all = several().with(heading(2, title)).with(paragraph(about));
                for (number, sample) in samples.iter().enumerate() {
                    let is_first = number == 0;
                    let tree = self.tree(sample, shown.filter(|_| is_first), &mut left);
                    let summary = several()
                        .with(format!("Sample {}: ", sample.index))
                        .with(self.color(sample.radiance))
                        .with(format!(" radiance {}", three(sample.radiance.to_array())));
                    let one = folded(summary, tree).class("sample");
                    all = all.with(if is_first { one.attribute("open", "") } else { one });
                }
                all
            }
        }
    }

    /// The tree of a sample. That of the first explained one is linked with the drawings.
    fn tree(&self, sample: &SampleExplanation, shown: Option<usize>, left: &mut usize) -> Element {
        let is_drawn = self.explanation.samples.first().is_some_and(|it| it.index == sample.index);
        let tree = match &sample.ray {
            Some(root) if *left == 0 => {
                let rays = count(root.count(), "ray");
                paragraph(format!(
                    "{rays}, too many for a page: --sample {} shows them.",
                    sample.index
                ))
            }
            Some(root) if is_drawn => Tree::new(self.world, root, left).drawn(shown).element(),
            Some(root) => Tree::new(self.world, root, left).element(),
            None => paragraph("The camera sees nothing there: no ray."),
        };
        const MORE: &str = "The tree has more rays; a smaller max_depth makes a smaller one.";
        several().with(tree).with_all((!sample.complete).then(|| paragraph(MORE)))
    }

    /// The values of all samples, folded; the one that is shown is marked.
    fn values(&self, shown: u32) -> Element {
        let radiances = &self.explanation.radiances;
        let mark = |(index, _): &(u32, &Rgb)| if *index == shown { "shown" } else { "" };
        let table = table((0..).zip(radiances).take(LISTED))
            .column("", |(index, _)| index.to_string())
            .column("", |(_, radiance)| self.value(**radiance))
            .column("", mark);
        let more = radiances.len().saturating_sub(LISTED);
        let content = several()
            .with(paragraph("--sample I shows another one, --all the trees of all."))
            .with(group("numbers").with(table.element()))
            .with_all((more > 0).then(|| paragraph(format!("And {more} more."))));
        folded(format!("The radiances of all {} samples", radiances.len()), content)
    }
}
