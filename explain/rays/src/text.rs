//! The verdict as text: one sentence, the laws in three lists, the tree with marks.

use std::fmt::{self, Write as _};

use groundtruth::printable::{self, name};
use groundtruth::rgb::Rgb;
use text::brief::{brief, count};

use crate::laws::{LAWS, LawReport, RayLaw};
use crate::traced::Traced;
use crate::verdict::{Outcome, PixelVerdict, RayVerdict};

/// The most rays of a tree that are printed.
const MAX_PRINTED: usize = 200;
/// The most findings of a law that are printed.
const EXAMPLES: usize = 3;

impl RayVerdict {
    /// One sentence: which ray breaks which law, why, and how many others do.
    pub fn sentence(&self) -> String {
        let Some((law, asked, finding)) = self.first() else { return self.held() };
        let ray = self.traced.name(finding.ray);
        let from = self.traced.parent(finding.ray).and_then(|parent| parent.object.as_ref());
        let from = from.map_or(String::new(), |object| format!(", from \"{}\"", name(object)));
        let roots = asked.roots().count();
        let others = match roots {
            1 => String::new(),
            _ => format!("; {} of {} do so", roots, count(asked.rays, "ray")),
        };
        let cause = law.cause(asked.roots()).map_or(String::new(), |cause| format!(": {cause}"));
        let names: Vec<String> = self.mistakes.iter().map(|it| format!("\"{}\"", it[0])).collect();
        let is_ours = law.needs.contains(&"a scene") && !names.is_empty();
        let known = match is_ours {
            true => format!(", as with the known mistake {}", names.join(" or ")),
            false => String::new(),
        };
        format!("{ray}{from} {}{cause}{others}{known}", finding.words)
    }

    fn held(&self) -> String {
        let (held, rays) = (self.of_outcome(Outcome::Held).count(), self.traced.log.rays.len());
        let (s, of_rays) = (if rays == 1 { "s" } else { "" }, count(rays, "ray"));
        match held {
            0 => {
                format!("{of_rays} can be held to no law: the log lacks the fields that they need")
            }
            _ => {
                format!("{of_rays} break{s} none of the {} that could be asked", count(held, "law"))
            }
        }
    }

    /// All of it.
    pub fn text(&self) -> String {
        let mut text = String::new();
        self.write(&mut text).expect("a string takes everything");
        text
    }

    fn write(&self, f: &mut String) -> fmt::Result {
        writeln!(f, "{}", printable::text(&self.sentence()))?;
        self.remarks().iter().try_for_each(|line| writeln!(f, "{}", printable::text(line)))?;
        for outcome in Outcome::ALL {
            let mut laws = self.of_outcome(outcome).peekable();
            if laws.peek().is_some() {
                writeln!(f, "\n{}", outcome.name())?;
            }
            laws.try_for_each(|(law, asked)| self.write_law(f, law, asked))?;
        }
        self.write_tree(f)
    }

    /// A line for each pixel, and the worst.
    pub fn pixels_text(&self) -> String {
        let line = |it: &PixelVerdict| {
            let pixel = it.pixel.map_or("all".to_owned(), |[x, y]| format!("({x}, {y})"));
            let found = it.first.map_or("breaks no law".to_owned(), |(law, ray)| {
                let (findings, ray) = (count(it.findings, "finding"), self.traced.name(ray));
                format!("{findings}, first by {ray} ({})", law.name)
            });
            printable::text(&format!("pixel {pixel}: {}, {found}", count(it.rays, "ray"))) + "\n"
        };
        let pixels = self.pixels();
        let worst = pixels.iter().rev().max_by_key(|it| it.findings).filter(|it| it.findings > 0);
        let lines = pixels.iter().map(line).collect::<String>();
        let worst = worst.map_or(String::new(), |it| format!("worst: {}", line(it)));
        format!("{}\n{lines}{worst}", printable::text(&self.sentence()))
    }

    /// What was taken from the log, guessed or left out, a sentence each.
    pub fn remarks(&self) -> Vec<String> {
        let Traced { log, guessed, conventions, .. } = &self.traced;
        let conventions = conventions.sentences();
        let mistakes = self.mistakes.iter().take(EXAMPLES).map(|[name, words]| {
            format!("a program with the known mistake \"{name}\" sends the same rays: {words}")
        });
        let mut said: Vec<String> = mistakes.collect();
        if !conventions.is_empty() {
            said.push(format!("taken from the log: {}", conventions.join("; ")));
        }
        if *guessed > 0 {
            let rays = count(*guessed, "ray");
            said.push(format!("the senders of {rays} were found by where they start"));
        }
        let damaged = log.damaged.iter().take(EXAMPLES);
        said.extend(damaged.map(|it| format!("left out: line {}: {}", it.line, it.problem)));
        let more = (log.damaged.len() + log.more_damaged).saturating_sub(EXAMPLES);
        if more > 0 {
            said.push(format!("left out: {}", count(more, "further damaged line")));
        }
        said
    }

    fn write_law(&self, f: &mut String, law: &RayLaw, asked: &LawReport) -> fmt::Result {
        let (RayLaw { name, says, .. }, rays) = (law, count(asked.rays, "ray"));
        match asked.outcome() {
            Outcome::NotAsked => {
                writeln!(f, "  {name:<20} needs {}", self.missing(law).join(", "))?
            }
            Outcome::Held => writeln!(f, "  {name:<20} {says} ({rays})")?,
            Outcome::Broken => {
                let broken = asked.findings.len();
                writeln!(f, "  {name:<20} {says}: {broken} of {rays}")?;
                let cause = law.cause(asked.roots());
                cause.into_iter().try_for_each(|cause| writeln!(f, "    {cause}"))?;
                for finding in asked.findings.iter().take(EXAMPLES) {
                    let ray = self.traced.name(finding.ray);
                    let follows = finding.follows.filter(|&from| from != finding.ray);
                    let follows = follows.map_or(String::new(), |from| {
                        format!(" (follows from {})", self.traced.name(from))
                    });
                    let line = format!("{ray} {}{follows}", finding.words);
                    writeln!(f, "    {}", printable::text(&line))?;
                }
                if broken > EXAMPLES {
                    writeln!(f, "    … and {}", count(broken - EXAMPLES, "more ray"))?;
                }
            }
        }
        asked.notes.iter().try_for_each(|note| writeln!(f, "    {note}"))
    }

    /// The tree of the sample in which the first broken ray is, or of the first sample.
    fn write_tree(&self, f: &mut String) -> fmt::Result {
        let root = self.shown_root();
        writeln!(f)?;
        if let Some([x, y]) = self.traced.ray(root).pixel {
            writeln!(f, "pixel ({x}, {y}), sample {}", self.traced.ray(root).sample)?;
        }
        let mut open = vec![(root, 0)];
        let mut printed = 0;
        while let Some((ray, depth)) = open.pop() {
            if printed == MAX_PRINTED {
                let left = open.len() + 1;
                return writeln!(f, "… {left} further rays of this sample are not printed");
            }
            printed += 1;
            let indent = "    ".repeat(depth.min(20));
            let mark = if self.of_ray(ray).next().is_some() { "✗" } else { " " };
            writeln!(f, "{mark} {indent}{}", printable::text(&self.line(ray)))?;
            for (law, finding) in self.of_ray(ray) {
                writeln!(f, "  {indent}  ✗ {}: {}", law.name, finding.words)?;
            }
            open.extend(self.traced.children[ray].iter().rev().map(|&child| (child, depth + 1)));
        }
        Ok(())
    }

    /// The first ray of the sample in which the first broken ray is, or of the first sample.
    pub fn shown_root(&self) -> usize {
        self.traced.root(self.first().map_or(0, |(_, _, finding)| finding.ray))
    }

    /// One line of a ray that a person can read: `3 (reflected)  t 12.3  hits "red sphere"  weight 0.9  brings 0.2`.
    pub fn line(&self, index: usize) -> String {
        let ray = self.traced.ray(index);
        let mut parts = vec![self.traced.name(index)];
        let object = ray.object.as_ref().map(|object| format!("\"{}\"", name(object)));
        let light = ray.light.as_ref().map(|light| format!("to \"{}\"", name(light)));
        parts.extend(light);
        parts.push(match (ray.is_shadow(), ray.t.or(ray.point.map(|_| f64::NAN)), object) {
            (true, None, None) => "unblocked".to_owned(),
            (true, _, Some(object)) => format!("blocked by {object}"),
            (true, Some(_), None) => "blocked".to_owned(),
            (false, None, None) => "hits nothing".to_owned(),
            (false, _, Some(object)) => format!("hits {object}"),
            (false, Some(_), None) => "hits".to_owned(),
        });
        parts.extend(ray.t.map(|t| format!("t {}", brief(t))));
        let color = |word: &str, color: Option<Rgb>| {
            color.map(|color| format!("{word} {}", text::brief::short(color)))
        };
        parts.extend(color("weight", ray.factors.weight));
        parts.extend(color("brings", ray.radiance));
        parts.join("  ")
    }
}

/// The laws, with what each needs and its usual causes.
pub fn laws_text() -> String {
    let mut text = String::new();
    for law in LAWS.iter() {
        let _ = writeln!(text, "{}: {}", law.name, law.says);
        if !law.needs.is_empty() {
            let _ = writeln!(text, "    needs {}", law.needs.join(", "));
        }
        for (_, cause) in &law.causes {
            let _ = writeln!(text, "    cause: {cause}");
        }
    }
    text
}
