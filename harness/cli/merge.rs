//! `groundtruth merge`.

use std::error::Error;
use std::hash::{BuildHasher, RandomState};
use std::path::{Path, PathBuf};

use clap::Args;
use groundtruth::film::{self, Film, Format, Provenance, Tone};
use indicatif::ProgressBar;
use pictures::shell::quoted;
use pictures::sums::{self, Contradiction, MergeError, Plan, Seeds, Sums, SumsFile};
use pictures::told::{NEXT, Told};

use super::scene::SceneArguments;
use super::{Exit, Outcome, output, progress, replicas};

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
    /// Render this share of the rows of each part again here, such as 1%, and compare the bits
    #[arg(long, value_name = "P", value_parser = share)]
    audit: Option<f64>,
    /// The scene, if it has another name here than where it was rendered
    #[arg(long, value_name = "SCENE")]
    scene: Option<String>,
}

fn share(text: &str) -> Result<f64, String> {
    let number = text.strip_suffix('%').map_or_else(
        || text.parse().ok(),
        |percent| percent.parse::<f64>().ok().map(|percent| percent / 100.0),
    );
    number
        .filter(|share| *share > 0.0 && *share <= 1.0)
        .ok_or_else(|| "write a share above 0 and up to 1, such as 0.01 or 1%".to_owned())
}

fn linear_format(name: &str) -> Result<Format, String> {
    let format = output::format_named(name).ok().filter(|format| !format.is_for_display());
    format.ok_or_else(|| "write exr or pfm: a mean is linear radiance".to_owned())
}

impl Merge {
    pub fn run(&self) -> Outcome {
        let files = || self.standard_error.iter().chain([&self.output]).map(PathBuf::as_path);
        output::once(files(), "output")?;
        output::check_distinct(files(), self.files.iter().map(PathBuf::as_path))?;
        for file in files() {
            if !is_sums(file) {
                self.format_of(file)?;
            }
            output::writable(file)?;
        }
        let parts: Vec<SumsFile> =
            self.files.iter().map(|file| SumsFile::open(file)).collect::<Result<_, _>>()?;
        let plan = match Plan::new(parts.clone()) {
            Ok(plan) => plan,
            Err(error) => return self.refused(&parts, error),
        };
        let bar = bar(self.files.len() as u64, "files");
        let sums = plan.sums(|| bar.inc(1));
        bar.finish_and_clear();
        let sums = match sums {
            Ok(sums) => sums,
            Err(error) => return self.refused_after_audit(&parts, &plan, error),
        };
        let mut audited = None;
        if let Some(share) = self.audit {
            match self.audit(&plan, share)? {
                Ok(rows) => audited = Some(rows),
                Err(error) => return self.refused(&parts, error),
            }
        }
        self.report(&plan, &sums, audited)?;
        self.write(&sums)?;
        Ok(if plan.missing.is_empty() { Exit::Yes } else { Exit::No })
    }

    /// Prints what is there, what is missing, and of how many rows an audit found the same bits.
    fn report(&self, plan: &Plan, sums: &Sums, audited: Option<[usize; 2]>) -> Outcome {
        for [part, other] in &plan.twice {
            let (part, other) = (part.path().display(), other.path().display());
            eprintln!("note: {part} has the same sums as {other}, and is left out");
        }
        for [part, other] in &plan.inside {
            let (part, other) = (part.path().display(), other.path().display());
            eprintln!("note: {part} is left out: {other} has all its seeds, and more");
        }
        if let Some(first) = sums.not_finite().first() {
            let (count, [x, y]) = (sums.not_finite().len(), first.pixel(sums.header().size[0]));
            let seed = first.seed;
            eprintln!(
                "note: {count} values are NaN or infinite, the first at pixel {x}, {y} with --seed {seed}"
            );
        }
        let told = self.told(plan, sums, audited);
        let to_output =
            self.standard_error.iter().chain([&self.output]).find(|it| output::is_standard(it));
        output::say(&told.text(), to_output.map(PathBuf::as_path))
    }

    /// What is told of a sum.
    fn told(&self, plan: &Plan, sums: &Sums, audited: Option<[usize; 2]>) -> Told {
        let (done, missing) = (sums.header().seeds.count(), plan.missing.count());
        let mut verdict = match missing {
            0 => format!("whole: {done} of {done} replicas"),
            _ => format!("not whole: {done} of {} replicas", done + missing),
        };
        if let Some([rows, all]) = audited {
            verdict += &format!("; {rows} of {all} rows were rendered again, with the same bits");
        }
        let mut header = sums.header().clone();
        if header.arguments.is_empty() {
            header.arguments = plan.used[0].header().arguments.clone();
        }
        self.rename(&mut header.arguments);
        let mut commands: Vec<String> =
            plan.missing.ranges().map(|range| header.command(range)).collect();
        let mut details = String::new();
        if missing > 0 {
            details = format!("missing: {}; render and merge them as well\n", plan.missing);
            let next = commands.remove(0);
            commands.iter().for_each(|command| details += &format!("  {command}\n"));
            return Told { verdict, details, next };
        }
        Told { verdict, details, next: self.next(&header.arguments, audited.is_some()) }
    }

    /// The next step: an audit, else the mean of the sums, or its picture beside one picture of the scene.
    fn next(&self, arguments: &[String], is_audited: bool) -> String {
        let name = |path: &Path| quoted(&path.display().to_string());
        let output = name(&self.output);
        match (arguments.first(), is_sums(&self.output)) {
            _ if !is_audited => self.with_audit("1%"),
            (_, true) => {
                format!("groundtruth merge {output} -o mean.exr --standard-error error.exr")
            }
            (Some(scene), false) => {
                format!("groundtruth compare {} {output} -o compare.html", quoted(scene))
            }
            (None, false) => format!("groundtruth scene {output}"),
        }
    }

    /// This command, with an audit of this share.
    fn with_audit(&self, share: &str) -> String {
        let name = |path: &Path| quoted(&path.display().to_string());
        let files: Vec<String> = self.files.iter().map(|file| name(file)).collect();
        let scene = self.scene.as_ref().map(|it| format!(" --scene {}", quoted(it)));
        let format = self.format.and_then(|format| {
            let named = Format::ALL.into_iter().find(|(known, _)| *known == format)?;
            Some(format!(" --format {}", named.1))
        });
        let error =
            self.standard_error.as_ref().map(|it| format!(" --standard-error {}", name(it)));
        let options = [format, error, scene].into_iter().flatten().collect::<String>();
        let (files, output) = (files.join(" "), name(&self.output));
        format!("groundtruth merge {files} -o {output}{options} --audit {share}")
    }

    /// Puts the name of the scene on this machine into the arguments.
    fn rename(&self, arguments: &mut Vec<String>) {
        match (&self.scene, arguments.first_mut()) {
            (Some(scene), Some(first)) => first.clone_from(scene),
            (Some(scene), None) => arguments.push(scene.clone()),
            (None, _) => {}
        }
    }

    /// With --audit, also two parts that contradict each other are audited, to tell which is wrong.
    fn refused_after_audit(&self, parts: &[SumsFile], plan: &Plan, error: MergeError) -> Outcome {
        if let (Some(share), MergeError::Contradiction(_)) = (self.audit, &error)
            && let Err(found) = self.audit(plan, share)?
        {
            eprintln!("error: {error}");
            return self.refused(parts, found);
        }
        self.refused(parts, error)
    }

    /// The exit status of parts that cannot be added; of those that contradict each other it prints the next step.
    fn refused(&self, parts: &[SumsFile], error: MergeError) -> Outcome {
        let MergeError::Contradiction(found) = error else { return Err(error.into()) };
        eprintln!("error: {found}");
        let next = match &found {
            Contradiction::Differs { .. } => Some(self.with_audit("100%")),
            Contradiction::Overlap { both, common } => self.rendered_anew(parts, &both[0], common),
            Contradiction::Audit { path, .. } => self.rendered_anew(parts, path, &Seeds::default()),
            // kinds of contradictions that are not known here
            _ => None,
        };
        if let Some(next) = next {
            eprintln!("{NEXT}{next}");
        }
        Ok(Exit::No)
    }

    /// The command that renders the seeds of a part again, without some: the first range of them.
    fn rendered_anew(&self, parts: &[SumsFile], path: &Path, without: &Seeds) -> Option<String> {
        let part = parts.iter().find(|part| part.path() == path)?;
        let mut header = part.header().clone();
        self.rename(&mut header.arguments);
        let range = part.header().seeds.without(without).ranges().next()?;
        Some(header.command(range))
    }

    /// Renders a share of the rows of each part again, those that come twice included.
    /// The number of rows that have the same bits, and of all rows.
    fn audit(
        &self,
        plan: &Plan,
        share: f64,
    ) -> Result<Result<[usize; 2], MergeError>, Box<dyn Error>> {
        let parts = plan.used.iter().chain(plan.twice.iter().map(|[part, _]| part));
        let replicas = parts.clone().map(|part| part.header().seeds.count()).sum();
        let bar = bar(replicas, "replicas audited");
        let mut audited = [0, 0];
        for part in parts {
            let mut arguments = part.header().arguments.clone();
            self.rename(&mut arguments);
            if arguments.is_empty() {
                let problem =
                    "its parts were rendered by several commands: name the scene with --scene";
                return Err(format!("{}: {problem}", part.path().display()).into());
            }
            let scene = SceneArguments::of_arguments(&arguments)?;
            let (header, mut world) = replicas::open(&scene)?;
            if let Some(difference) = part.header().difference(&header) {
                let path = part.path().display();
                return Err(format!(
                    "{path}: cannot be audited: is of {difference}; name its scene with --scene"
                )
                .into());
            }
            let rows = random_rows(header.size[1], share);
            if let Err(error) = sums::audit(part, &mut world, &rows, || bar.inc(1)) {
                bar.finish_and_clear();
                return Ok(Err(error));
            }
            let (count, all, path) = (rows.len(), header.size[1], part.path().display());
            audited = [audited[0] + count, audited[1] + all as usize];
            bar.println(format!("{path}: {count} of {all} rows rendered again: the same bits"));
        }
        bar.finish_and_clear();
        Ok(Ok(audited))
    }

    fn write(&self, sums: &Sums) -> Result<(), Box<dyn Error>> {
        let made = sums.header().provenance();
        if let Some(file) = &self.standard_error {
            let film =
                sums.standard_error().ok_or("--standard-error needs at least two replicas")?;
            let made = Provenance { part: Some("standard error".to_owned()), ..made.clone() };
            self.write_picture(&film, &made, file)?;
        }
        match is_sums(&self.output) {
            true => Ok(sums.write(&self.output)?),
            false => self.write_picture(&sums.mean(), &made, &self.output),
        }
    }

    fn write_picture(
        &self,
        film: &Film,
        made: &Provenance,
        file: &Path,
    ) -> Result<(), Box<dyn Error>> {
        // the tone is not used: both formats keep linear radiance
        output::write(file, &film::encode(film, &Tone::PLAIN, self.format_of(file)?, made)?)
    }

    /// The format of a picture.
    fn format_of(&self, file: &Path) -> Result<Format, String> {
        let named = Format::of(file).ok().filter(|format| !format.is_for_display());
        self.format.or(named).ok_or_else(|| match output::is_standard(file) {
            true => "-o -: say which format is written to the standard output: --format exr or pfm"
                .to_owned(),
            false => format!("{}: end the name with .exr or .pfm", file.display()),
        })
    }
}

fn is_sums(file: &Path) -> bool {
    file.extension().is_some_and(|end| end == "sums")
}

/// Some rows of a picture, ascending: a share of them, at least one.
fn random_rows(height: u32, share: f64) -> Vec<u32> {
    let random = RandomState::new();
    let mut rows: Vec<u32> = (0..height).collect();
    rows.sort_by_cached_key(|row| random.hash_one(row));
    rows.truncate(((share * f64::from(height)).round() as usize).max(1));
    rows.sort_unstable();
    rows
}

fn bar(count: u64, what: &str) -> ProgressBar {
    let style = format!("{{bar:40}} {{pos}} of {{len}} {what}  {{elapsed}} elapsed, {{eta}} to go");
    progress::bar(count, &style)
}
