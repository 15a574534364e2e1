//! `groundtruth goldens`: check, review, accept.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use clap::{Args, Subcommand};
use golden::compare;
use golden::review;
use golden::{self, GoldenFinding, GoldenSettings, GoldenStatus, Goldens as Folder, Proposal};
use groundtruth::similar;
use text::brief::count;

use super::list::is_in;
use super::part::PartOf;
use super::scene::{samples, size};
use super::{Exit, Outcome, output, print, progress};

#[derive(Args)]
pub struct Goldens {
    #[command(subcommand)]
    command: Command,
    /// The folder with manifest.toml. In another one than goldens, the gallery's scenes may be without goldens
    #[arg(long, value_name = "DIR", default_value = review::DEFAULT_FOLDER, global = true)]
    folder: PathBuf,
}

#[derive(Subcommand)]
enum Command {
    /// Render every golden and compare; exit status 0 if all are the same
    Check {
        /// Goldens to check, such as ch24/hall-of-mirrors or spheres.toml, or chapters, such as ch24; all if left out
        names: Vec<String>,
        /// Check only every N-th of them, from K on, such as 0/8, so that N machines share the work; K is from 0 to
        /// N − 1
        #[arg(long, value_name = "K/N", value_parser = PartOf::parse)]
        part: Option<PartOf>,
    },
    /// Write one HTML page: of each golden that differs the expected and the actual picture, side by side, to flip
    /// and to swipe, their difference, its regions, and what was changed in its scene file
    Review {
        /// Goldens to show, or chapters, such as ch24; those that differ if left out
        names: Vec<String>,
        /// Show all
        #[arg(long, conflicts_with = "names")]
        all: bool,
        /// The page to write
        #[arg(short, long, value_name = "FILE", default_value = "review.html")]
        output: PathBuf,
    },
    /// Accept the current pictures as goldens, with a reason
    Accept(Accept),
    /// Remove goldens: from the manifest, and their pictures. Their scenes stay
    Remove {
        /// Goldens, such as ch24/hall-of-mirrors or spheres.toml.normals, or chapters, such as ch24
        #[arg(required = true)]
        names: Vec<String>,
    },
}

#[derive(Args)]
struct Accept {
    /// Goldens, such as ch24/hall-of-mirrors, or scene files, such as spheres.toml; with .normals or .hits for another
    /// view of a scene
    #[arg(required_unless_present = "all_drifted")]
    names: Vec<String>,
    /// Accept every golden that differs by rounding only
    #[arg(long, conflicts_with = "names")]
    all_drifted: bool,
    /// What the pictures were checked against; stored in the manifest
    #[arg(long, value_name = "REASON")]
    because: String,
    /// Width and height in pixels; if left out, those of the old golden, or 96 pixels wide
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Samples per pixel; if left out, those of the old golden, or at most 4
    #[arg(long, value_name = "N", value_parser = samples())]
    samples: Option<u32>,
    /// What to look for; if left out, the text of the old golden, or the description of the scene
    #[arg(long, value_name = "TEXT")]
    shows: Option<String>,
}

impl Goldens {
    pub fn run(&self) -> Outcome {
        let folder = &self.folder;
        match &self.command {
            Command::Check { names, part } => check(folder, names, part.unwrap_or_default()),
            Command::Review { names, all, output } => review(folder, names, *all, output),
            Command::Accept(accept) => accept.run(folder),
            Command::Remove { names } => remove(folder, names),
        }
    }
}

fn open(folder: &Path) -> Result<Folder, Box<dyn Error>> {
    let goldens = Folder::open(folder)?;
    if goldens.was_finished() {
        eprintln!("note: finished an earlier `goldens accept` that was stopped on its way");
    }
    Ok(goldens)
}

/// The findings for a part of these names and chapters; of all goldens if there are none.
fn findings(
    goldens: &Folder,
    names: &[String],
    part: PartOf,
) -> Result<Vec<GoldenFinding>, Box<dyn Error>> {
    let names = wanted(goldens, names, part)?;
    names.iter().map(|name| Ok(goldens.check(name)?)).collect()
}

/// The goldens of a part of these names and chapters, each once, in the manifest's order; all if there are none.
fn wanted(goldens: &Folder, names: &[String], part: PartOf) -> Result<Vec<String>, Box<dyn Error>> {
    let mut known = goldens.names();
    if names.is_empty() && goldens.folder() != Path::new(review::DEFAULT_FOLDER) {
        known.retain(|name| goldens.find(name).is_some());
    }
    let is_meant = |name: &str, known: &str| golden::leaf(name) == known || is_in(known, name);
    let is_unknown = |name: &&String| !known.iter().any(|known| is_meant(name, known));
    if let Some(name) = names.iter().find(is_unknown) {
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        let hint = similar::did_you_mean(name, &known);
        return Err(format!("no golden `{name}`: neither in the manifest nor a scene of the gallery (`groundtruth list`){hint}").into());
    }
    known.retain(|known| names.is_empty() || names.iter().any(|name| is_meant(name, known)));
    Ok(part.of_list(known.into_iter()).collect())
}

fn check(folder: &Path, names: &[String], part: PartOf) -> Outcome {
    let findings = findings(&open(folder)?, names, part)?;
    let text: String = findings.iter().map(line).collect();
    print(&text)?;
    let bad: Vec<&GoldenFinding> =
        findings.iter().filter(|f| f.status != GoldenStatus::Same).collect();
    if bad.is_empty() {
        print(&format!("checked {}, all the same\n", findings.len()))?;
        return Ok(Exit::Yes);
    }
    let folder = review::folder_option(folder);
    let mut advice = format!("{} of {} are not the same\n", bad.len(), findings.len());
    advice += &format!("to look:   groundtruth goldens review -o review.html{folder}\n");
    for finding in bad.iter().filter(|f| f.status != GoldenStatus::Drift) {
        let to = if finding.status == GoldenStatus::NoScene { "remove" } else { "accept" };
        advice += &format!("to {to}: {}\n", review::accept_command(finding));
    }
    if bad.iter().any(|f| f.status == GoldenStatus::Drift) {
        let command = "groundtruth goldens accept --all-drifted --because \"…\"";
        advice += &format!("to accept: {command}{folder}\n");
    }
    print(&advice)?;
    Ok(Exit::No)
}

/// `changed   ch24/hall-of-mirrors: 312 of 6144 pixels differ, the most by 1.2e-1 at (40, 12)`.
fn line(finding: &GoldenFinding) -> String {
    let why = match (&finding.status, &finding.expected, &finding.got) {
        (GoldenStatus::Same, ..) => String::new(),
        (GoldenStatus::Missing, ..) if finding.golden.is_none() => {
            ": the scene has no golden".to_owned()
        }
        (GoldenStatus::Missing, ..) => ": its .exr file is not there".to_owned(),
        (GoldenStatus::Mismatch, ..) => {
            ": its .exr file is not the one that the manifest's digest names".to_owned()
        }
        (GoldenStatus::NoScene, ..) => match finding.scene_file() {
            Some(file) => format!(": its scene file {} cannot be read", file.display()),
            None => ": the gallery has no such scene".to_owned(),
        },
        (_, Some(a), Some(b)) if a.width() == b.width() && a.height() == b.height() => {
            let differences = compare::differences(a, b);
            let (count, pixels) = (differences.len(), a.pixels().len());
            differences.first().map_or(String::new(), |worst| {
                let ([x, y], size) = (worst.pixel, worst.size);
                format!(": {count} of {pixels} pixels differ, the most by {size:.1e} at ({x}, {y})")
            })
        }
        _ => ": the size differs".to_owned(),
    };
    format!("{:9} {}{why}\n", review::words(&finding.status), finding.name)
}

fn review(folder: &Path, names: &[String], all: bool, page: &Path) -> Outcome {
    let mut findings = findings(&open(folder)?, names, PartOf::default())?;
    if names.is_empty() && !all {
        findings.retain(|finding| finding.status != GoldenStatus::Same);
    }
    let mut told = review::told(&findings, folder);
    output::write(page, review::page(&findings, &told).as_bytes())?;
    told.details += &format!("{}: shows {}\n", output::name(page), findings.len());
    output::say(&told.text(), Some(page))
}

impl Accept {
    fn run(&self, folder: &Path) -> Outcome {
        let mut goldens =
            if Folder::is_none(folder) { Folder::none(folder) } else { open(folder)? };
        // an interrupt stops the command while pictures are rendered, but not while they are
        // written
        let interrupted = progress::interrupt_flag()?;

        let settings =
            GoldenSettings { size: self.size, samples: self.samples, shows: self.shows.clone() };
        let names = if self.all_drifted { drifted(&goldens)? } else { self.names.clone() };
        let mut proposals = Vec::new();
        for name in &names {
            proposals.push(goldens.propose(name, &self.because, &settings)?);
            if interrupted.load(Ordering::Relaxed) {
                eprintln!("interrupted; nothing was accepted");
                return Ok(Exit::Interrupted);
            }
        }
        let line = |Proposal { golden, .. }: &Proposal| {
            let [width, height] = golden.size;
            let samples = count(golden.samples as usize, "sample");
            format!("accepted  {}: {width} × {height} pixels, {samples} a pixel\n", golden.name())
        };
        let text: String = proposals.iter().map(line).collect();
        goldens.accept(proposals)?;
        print(&text)?;
        print_kept(&goldens)
    }
}

fn remove(folder: &Path, names: &[String]) -> Outcome {
    let mut goldens = open(folder)?;
    let mut names = wanted(&goldens, names, PartOf::default())?;
    names.retain(|name| goldens.find(name).is_some());
    goldens.remove(&names)?;
    let text: String = names.iter().map(|name| format!("removed   {name}\n")).collect();
    print(&text)?;
    print_kept(&goldens)
}

fn print_kept(goldens: &Folder) -> Outcome {
    let kept = count(goldens.all().len(), "golden");
    print(&format!("{}: {kept}\n", goldens.folder().display()))
}

/// The goldens that differ by rounding only.
fn drifted(goldens: &Folder) -> Result<Vec<String>, Box<dyn Error>> {
    let findings = findings(goldens, &[], PartOf::default())?;
    let drifted = findings.into_iter().filter(|finding| finding.status == GoldenStatus::Drift);
    Ok(drifted.map(|finding| finding.name).collect())
}
