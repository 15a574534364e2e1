//! `groundtruth merge`.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Args;
use groundtruth::film::{self, Film, Format, Provenance, Tone};
use pictures::sums::{self, MergeError, Merged, Sums};
use text::shell::quoted;
use text::told::Told;

use super::{Exit, Outcome, output, progress};

#[derive(Args)]
pub struct Merge {
    /// The parts: files of sums, in any order
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// The mean of the replicas: .exr or .pfm; or all sums: .sums, which `merge` reads again. - is the standard
    /// output, with --format
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// The standard error of the mean of each channel: .exr or .pfm
    #[arg(long, value_name = "FILE")]
    standard_error: Option<PathBuf>,
    /// The format of the pictures, exr or pfm, whatever the names of the files are
    #[arg(long, value_name = "FORMAT", value_parser = linear_format)]
    format: Option<Format>,
}

fn linear_format(name: &str) -> Result<Format, String> {
    let format = output::format_named(name).ok().filter(|format| !format.is_for_display());
    format.ok_or_else(|| "write exr or pfm: a mean is linear radiance".to_owned())
}

impl Merge {
    pub fn run(&self) -> Outcome {
        output::once(self.outputs(), "output")?;
        output::check_distinct(self.outputs(), &self.files)?;
        for file in self.outputs() {
            if !is_sums(file) {
                self.format_of(file)?;
            }
            output::writable(file)?;
        }
        let style = "{bar:40} {pos} of {len} files  {elapsed} elapsed, {eta} to go";
        let bar = progress::bar(self.files.len() as u64, style);
        let merged = sums::merged(&self.files, || bar.inc(1));
        bar.finish_and_clear();
        let merged = match merged {
            Ok(merged) => merged,
            Err(MergeError::Contradiction(found)) => {
                eprintln!("error: {found}");
                return Ok(Exit::No);
            }
            Err(error) => return Err(error.into()),
        };
        self.report(&merged)?;
        self.write(&merged.sums)?;
        Ok(if merged.missing().is_empty() { Exit::Yes } else { Exit::No })
    }

    fn outputs(&self) -> impl Iterator<Item = &Path> {
        self.standard_error.iter().chain([&self.output]).map(PathBuf::as_path)
    }

    /// Prints what is there, and what is missing.
    fn report(&self, merged: &Merged) -> Outcome {
        for [part, other] in &merged.twice {
            let (part, other) = (part.display(), other.display());
            eprintln!("note: {part} has the same sums as {other}, and is left out");
        }
        let mut wrong = merged.sums.not_finite();
        if let Some([x, y]) = wrong.next() {
            let (count, what) = (1 + wrong.count(), "values that are NaN or infinite");
            eprintln!("note: {count} pixels have {what}, the first at {x}, {y}");
        }
        let to_output = self.outputs().find(|it| output::is_standard(it));
        output::say(&self.told(merged).text(), to_output)
    }

    fn told(&self, merged: &Merged) -> Told {
        let (header, missing) = (merged.sums.header(), merged.missing());
        let done = header.seeds.count();
        if missing.is_empty() {
            let verdict = format!("whole: {done} of {done} replicas");
            return Told { verdict, details: String::new(), next: self.next(&header.arguments) };
        }
        let mut header = header.clone();
        if header.arguments.is_empty() {
            header.arguments.clone_from(&merged.used[0].1.arguments);
        }
        let verdict = format!("not whole: {done} of {} replicas", done + missing.count());
        let mut details = format!("missing: {missing}; render and merge them as well\n");
        let mut commands = missing.ranges().map(|range| header.command(range));
        let next = commands.next().expect("something is missing");
        commands.for_each(|command| details += &format!("  {command}\n"));
        Told { verdict, details, next }
    }

    /// The next step: the mean of the sums, or its picture beside one picture of the scene.
    fn next(&self, arguments: &[String]) -> String {
        let output = quoted(&self.output.display().to_string());
        let scene = arguments.first().map_or("SCENE".to_owned(), |scene| quoted(scene));
        match is_sums(&self.output) {
            true => format!("groundtruth merge {output} -o mean.exr --standard-error error.exr"),
            false => format!("groundtruth compare {scene} {output} -o compare.html"),
        }
    }

    fn write(&self, sums: &Sums) -> Result<(), Box<dyn Error>> {
        let made = sums.header().provenance();
        if let Some(file) = &self.standard_error {
            let film =
                sums.standard_error().ok_or("--standard-error needs at least two replicas")?;
            let made = Provenance { part: Some("standard error".to_owned()), ..made.clone() };
            self.write_to(file, &film, &made)?;
        }
        match is_sums(&self.output) {
            true => Ok(sums.write(&self.output)?),
            false => self.write_to(&self.output, &sums.mean(), &made),
        }
    }

    fn write_to(&self, file: &Path, film: &Film, made: &Provenance) -> Result<(), Box<dyn Error>> {
        // the tone is not used: both formats keep linear radiance
        output::write(file, &film::encode(film, &Tone::PLAIN, self.format_of(file)?, made)?)
    }

    fn format_of(&self, file: &Path) -> Result<Format, String> {
        let named = Format::of(file).ok().filter(|format| !format.is_for_display());
        self.format.or(named).ok_or_else(|| match output::is_standard(file) {
            true => output::no_format("exr or pfm"),
            false => format!("{}: end the name with .exr or .pfm", file.display()),
        })
    }
}

fn is_sums(file: &Path) -> bool {
    file.extension().is_some_and(|end| end == "sums")
}
