//! The samples of a pixel: the trees of those that are explained, and the values of all.

use std::fmt::Write;

use groundtruth::explain::{SampleExplanation, count};
use pictures::digits::three;

use super::PixelPage;
use super::tree::{MAX_RAYS, Tree};

/// The most samples whose values are listed.
const LISTED: usize = 1024;

impl PixelPage<'_> {
    /// The trees of the explained samples, folded if there are several, or the tree of one and the values of all; the
    /// section of the ray `shown` of the first stands elsewhere.
    pub(super) fn samples(&self, shown: Option<usize>) -> String {
        let (of, samples) = (self.explanation.samples_per_pixel, &self.explanation.samples);
        let mut left = MAX_RAYS;
        match &samples[..] {
            [] => String::new(),
            [only] if of == 1 => {
                format!("<h2>The tree of its rays</h2>\n{}", self.tree(only, shown, &mut left))
            }
            [only] => {
                let tree = self.tree(only, shown, &mut left);
                format!(
                    "<h2>The tree of sample {}</h2>\n<p>This page shows sample {} of {of} (they count from 0), here, in \
                     section and in space: radiance {}.</p>\n{tree}{}",
                    only.index,
                    only.index,
                    three(only.radiance.to_array()),
                    self.values(only.index)
                )
            }
            [first, ..] => {
                let mut html = format!(
                    "<h2>The trees of its {}</h2>\n<p>Section and space show sample {}.</p>\n",
                    count(samples.len(), "sample"),
                    first.index
                );
                for (number, sample) in samples.iter().enumerate() {
                    let is_first = number == 0;
                    let tree = self.tree(sample, shown.filter(|_| is_first), &mut left);
                    let _ = write!(
                        html,
                        "<details class=\"sample\"{}><summary>Sample {}: {} radiance {}</summary>\n{tree}</details>\n",
                        if is_first { " open" } else { "" },
                        sample.index,
                        self.color(sample.radiance),
                        three(sample.radiance.to_array())
                    );
                }
                html
            }
        }
    }

    /// The tree of a sample. That of the first explained one is linked with the drawings.
    fn tree(&self, sample: &SampleExplanation, shown: Option<usize>, left: &mut usize) -> String {
        let is_drawn = self.explanation.samples.first().is_some_and(|it| it.index == sample.index);
        let mut html = match &sample.ray {
            Some(root) if *left == 0 => {
                let rays = count(root.count(), "ray");
                format!(
                    "<p>{rays}, too many for a page: --sample {} shows them.</p>\n",
                    sample.index
                )
            }
            Some(root) if is_drawn => Tree::new(self.world, root, left).drawn(shown).html(),
            Some(root) => Tree::new(self.world, root, left).html(),
            None => "<p>The camera sees nothing there: no ray.</p>\n".to_owned(),
        };
        if !sample.complete {
            html += "<p>The tree has more rays; a smaller max_depth makes a smaller one.</p>\n";
        }
        html
    }

    /// The values of all samples, folded; the one that is shown is marked.
    fn values(&self, shown: u32) -> String {
        let radiances = &self.explanation.radiances;
        let mut html = format!(
            "<details><summary>The radiances of all {} samples</summary>\n<p>--sample I shows another one, --all the \
             trees of all.</p>\n<table class=\"numbers\">\n",
            radiances.len()
        );
        for (index, radiance) in (0..).zip(radiances).take(LISTED) {
            let mark = if index == shown { "shown" } else { "" };
            let _ = writeln!(
                html,
                "<tr><td>{index}</td><td>{} {}</td><td>{mark}</td></tr>",
                self.color(*radiance),
                three(radiance.to_array())
            );
        }
        html += "</table>\n";
        if radiances.len() > LISTED {
            let _ = writeln!(html, "<p>And {} more.</p>", radiances.len() - LISTED);
        }
        html + "</details>\n"
    }
}
