//! The verdict as one HTML file, for a class or a forum.

use std::collections::HashMap;

use groundtruth::printable::text as printable;
use space::{Section, hiding, orbit_of, svg_of_rays};
use text::brief::count;
use text::document::{
    Element, Node, element, figure, group, heading, list, paragraph, several, span, table,
};
use text::html::{CARD, LINES, escaped, page};

use crate::laws::{BrokenRay, LawReport, RayLaw};
use crate::recorded::Recorded;
use crate::scene::empty_world;
use crate::verdict::{Outcome, RayVerdict};

/// The most rays of the tree on a page.
const MAX_SHOWN: usize = 2000;
/// The most findings of a law on a page.
const MAX_FINDINGS: usize = 3;

const STYLE: &str = include_str!("page.css");

impl RayVerdict {
    /// The page; `name` is what the log is called.
    pub fn page(&self, name: &str) -> String {
        let root = self.shown_root();
        let title = escaped(&printable(&format!("The rays of {name}")));
        let body = several()
            .with(heading(1, printable(&self.sentence())))
            .with_all(self.remarks().iter().map(|line| paragraph(printable(line))))
            .with(self.drawings(root))
            .with(heading(2, "The rays"))
            .with(group("tree").with(self.tree(root)))
            .with(self.laws());
        page(&title, &[LINES, CARD, STYLE], &body.html())
    }

    fn laws(&self) -> Element {
        let titles = [
            (Outcome::Broken, "Broken"),
            (Outcome::Held, "Held"),
            (Outcome::NotAsked, "Not asked"),
        ];
        several().with_all(titles.map(|(outcome, title)| {
            let laws: Vec<_> = self.of_outcome(outcome).collect();
            if laws.is_empty() {
                return several();
            }
            let told = |(law, asked): &(&'static RayLaw, &LawReport)| match outcome {
                Outcome::Broken => self.findings(law, asked),
                Outcome::Held => several().with(count(asked.rays, "ray")),
                Outcome::NotAsked => {
                    several().with(format!("needs {}", self.missing(law).join(", ")))
                }
            };
            let table = table(laws)
                .column("law", |(law, _)| law.name)
                .column("", |(law, _)| law.says)
                .column("", told);
            several().with(heading(2, title)).with(group("wide").with(table.element()))
        }))
    }

    fn findings(&self, law: &RayLaw, asked: &LawReport) -> Element {
        let broken = asked.findings.len();
        let line = |finding: &BrokenRay| {
            printable(&format!("{} {}", self.traced.name(finding.ray), finding.words))
        };
        let more = broken.saturating_sub(MAX_FINDINGS);
        several()
            .with(format!("{broken} of {}", count(asked.rays, "ray")))
            .with_all(law.cause(asked.roots()).map(paragraph))
            .with(list(asked.findings.iter().take(MAX_FINDINGS).map(line)))
            .with_all((more > 0).then(|| paragraph(format!("… and {}", count(more, "more ray")))))
    }

    /// The rays in space, and the section of the first ray that breaks a law.
    fn drawings(&self, root: usize) -> Element {
        let recorded = Recorded::of(&self.traced, root);
        let empty = empty_world();
        let world = self.traced.world.as_deref().unwrap_or(&empty);
        let orbit = orbit_of(world, &recorded.root);
        let faded = hiding(world, &recorded.root, &orbit);
        let svg = svg_of_rays(world, &recorded.root, &orbit, &faded);
        let section = self.first().and_then(|(_, _, finding)| {
            // the plane of the hit that it leaves shows both rays and the normal
            let is_shadow = self.traced.ray(finding.ray).is_shadow();
            let sender = self.traced.parents[finding.ray].filter(|_| !is_shadow);
            let number = recorded.number(sender.unwrap_or(finding.ray))?;
            let mut section = Section::of(world, &recorded.root, number)?;
            let indices: HashMap<usize, usize> = recorded.by_number().collect();
            section.expect(|number| self.expected(*indices.get(&number)?));
            Some(section)
        });
        let drawn = |it: Section| figure(Node::Drawing(it.drawing.svg()), it.drawing.title);
        let numbers = match recorded.numbers {
            Some(_) => "The numbers are those of the log.",
            None => "The numbers count the rays from 0, in the order of the tree below.",
        };
        several()
            .with(heading(2, "In space"))
            .with(figure(Node::Drawing(svg), numbers))
            .with_all(section.map(drawn))
    }

    fn tree(&self, root: usize) -> Element {
        let mut left = MAX_SHOWN;
        self.branch(root, &mut left)
    }

    fn branch(&self, ray: usize, left: &mut usize) -> Element {
        if *left == 0 {
            return several();
        }
        *left -= 1;
        let told = |(law, finding): (&RayLaw, &BrokenRay)| {
            paragraph(format!("✗ {}: {}", law.name, finding.words))
        };
        let broken: Vec<Element> = self.of_ray(ray).map(told).collect();
        let summary = element("summary");
        let summary = if broken.is_empty() { summary } else { summary.class("broken") };
        let children = &self.traced.children[ray];
        let children: Vec<Element> = children.iter().map(|&it| self.branch(it, left)).collect();
        let cut = (*left == 0).then(|| span("quiet", "further rays are left out"));
        element("details")
            .attribute("open", "")
            .with(summary.with(printable(&self.line(ray))))
            .with_all(broken)
            .with_all(children)
            .with_all(cut)
    }
}
