//! `groundtruth verify --before … --after …`: two sets of pictures, and no scene.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use judge::sets::{self, SetsDecision, SetsVerdict};
use judge::verdict::{self, Answer};
use pictures::compare::{Picture, Transfer};
use text::shell;
use text::told::Told;

use super::verify::Verify;
use super::{Exit, Outcome, output, progress};

impl Verify {
    /// Judges the pictures before and after.
    pub(super) fn sets(&self) -> Outcome {
        let inputs = || self.before.iter().chain(&self.after);
        output::once(inputs().chain(&self.regions), "input")?;
        output::check_distinct(&self.output, inputs().chain(&self.regions))?;
        self.output.as_deref().map_or(Ok(()), output::writable)?;
        let interrupted = progress::interrupt_flag()?;
        let bar = progress::bar(inputs().count() as u64, "{bar:30} {pos} of {len} pictures read");
        let [before, after] = [&self.before, &self.after].map(|files| {
            self.read(files, &|| {
                bar.inc(1);
                interrupted.load(Ordering::Relaxed)
            })
        });
        bar.finish_and_clear();
        let (Some(before), Some(after)) = (before?, after?) else {
            return progress::nothing_written();
        };
        check_size((&before[0], &self.before[0]), (&after, &self.after))?;
        let are_fixed = is_fixed(&before) && is_fixed(&after);
        if !are_fixed {
            let why = "the pictures of a set have other seeds";
            check_seeds(&before, &self.before, why)?;
            check_seeds(&after, &self.after, why)?;
        }
        let linear = |file: &PathBuf| Picture::read(file, Some(Transfer::Linear));
        let regions = self.regions.as_ref().map(linear).transpose()?;
        let sets = sets::Sets::new([before, after], regions.as_ref()).map_err(|problem| {
            let file = self.regions.as_deref().map_or(String::new(), output::name);
            format!("{file}: {problem}")
        })?;
        let bar = progress::bar(0, "{spinner} {human_pos} divisions tried, {elapsed} elapsed");
        let watch = sets::Watch { tried: &|| bar.inc(1), interrupted: &interrupted };
        let verdict = SetsVerdict::of(sets, self.level, watch);
        bar.finish_and_clear();
        let Some(mut verdict) = verdict else { return progress::nothing_written() };
        if let Some(margin) = self.margin {
            verdict.hold_to(margin);
        }
        let (details, next) = (verdict.details(), self.next_of_sets(&verdict));
        let told = Told { verdict: verdict.sentence(), details, next };
        let page = || sets::page(&verdict, &told);
        output::tell(&told, &verdict, self.json, (self.output.as_deref(), &page))?;
        Ok(exit(&verdict))
    }

    /// The pictures of a set, all of one size; `None` if it is interrupted, which `is_last` says after each.
    fn read(
        &self,
        files: &[PathBuf],
        is_last: &dyn Fn() -> bool,
    ) -> Result<Option<Vec<Picture>>, Box<dyn Error>> {
        let mut pictures = Vec::new();
        for file in files {
            let picture = Picture::read(file, self.encoding)?;
            let name = output::name(file);
            // of many files, only the first is spoken of
            if *file == self.before[0] {
                picture.notes.iter().for_each(|note| eprintln!("note: {name}: {note}"));
            }
            if let Some(problem) = verdict::refusal_of_alpha(&picture) {
                return Err(format!("{name}: {problem}").into());
            }
            pictures.push(picture);
            if is_last() {
                return Ok(None);
            }
        }
        check_size((&pictures[0], &files[0]), (&pictures, files))?;
        Ok(Some(pictures))
    }

    /// The next step: where one picture before differs from one after; of sets that agree, how close their means are.
    fn next_of_sets(&self, verdict: &SetsVerdict) -> String {
        let all = |files: &[PathBuf]| {
            let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
            shell::line(names.iter().map(String::as_str))
        };
        let curve = Transfer::option(self.encoding);
        match (verdict.decision, self.margin) {
            (SetsDecision::Agree, None) => format!(
                "groundtruth verify --before {} --after {}{curve} --margin 1%",
                all(&self.before),
                all(&self.after)
            ),
            _ => {
                let [before, after] = [&self.before[..1], &self.after[..1]].map(all);
                format!("groundtruth compare {before} {after}{curve} -o compare.html")
            }
        }
    }
}

/// Whether all pictures have the same values.
fn is_fixed(pictures: &[Picture]) -> bool {
    pictures.iter().all(|picture| picture.values == pictures[0].values)
}

/// Fails if two pictures with noise have the same values, and says why they may not.
pub fn check_seeds(pictures: &[Picture], files: &[PathBuf], why: &str) -> Result<(), String> {
    for (later, picture) in pictures.iter().enumerate() {
        if let Some(equal) = pictures[..later].iter().position(|it| it.values == picture.values) {
            let [file, other] = [later, equal].map(|at| output::name(&files[at]));
            return Err(format!(
                "{file} has the same values as {other}; {why}: leave one out, or render it with another seed"
            ));
        }
    }
    Ok(())
}

/// Fails if a picture has another size than the first.
pub fn check_size(
    (first, name): (&Picture, &Path),
    (pictures, files): (&[Picture], &[PathBuf]),
) -> Result<(), String> {
    let mut all = pictures.iter().zip(files);
    let Some((other, file)) = all.find(|(picture, _)| picture.size != first.size) else {
        return Ok(());
    };
    let [[w, h], [width, height]] = [first.size, other.size];
    let [file, name] = [file, name].map(output::name);
    Err(format!(
        "{file} has {width} × {height} pixels, {name} has {w} × {h}; all pictures must have one size"
    ))
}

/// The exit status of a verdict; by the margin, if there is one.
fn exit(verdict: &SetsVerdict) -> Exit {
    match (verdict.margin, verdict.decision) {
        (Some((_, Answer::Agrees)), _) | (None, SetsDecision::Agree) => Exit::Yes,
        (Some((_, Answer::DiffersByMore)), _) | (None, SetsDecision::Differ) => Exit::No,
        (Some((_, Answer::CannotTell)), _) | (None, SetsDecision::CannotTell) => Exit::Unanswered,
    }
}
