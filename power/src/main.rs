//! How many mistakes the tests find: planted ones of `power/planted`, and a sample of cargo-mutants' list.
//!
//! All changes stand in one scratch copy behind a switch, so that it is built once. Each test is run once with nothing on,
//! and notes which changes it reaches; then each change is on for the tests that reach it, laws first, until one fails.

mod change;
mod matrix;
mod mutants;
mod planted;
mod run;
mod score;
mod scratch;
mod tolerance;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use clap::{Args, Parser, Subcommand};
use rayon::prelude::*;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::change::Change;
use crate::run::{End, Test};
use crate::score::{Kind, Row};

/// How many mistakes the tests find.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    what: What,
    /// Where the scratch copies are.
    #[arg(long, default_value = "target/power", global = true)]
    folder: PathBuf,
}

#[derive(Subcommand)]
enum What {
    /// Plants each mistake and decoy of the repository, and says what finds it.
    Run(Asking),
    /// Runs every test on each change that it reaches, and writes what each finds: alone, with others, or nothing.
    Matrix(Asking),
    /// Runs the laws that found something once more, with other tolerances: which still find it, and which fail with
    /// nothing planted.
    Again {
        /// The tolerances of the laws are multiplied by this.
        #[arg(long)]
        tolerance: f64,
        #[command(flatten)]
        mutants: Sample,
    },
    /// Multiplies the tolerances of the laws in this working copy: which laws then fail? `git restore .` undoes it, and
    /// `git clean -f tests` what properties noted.
    Tolerances {
        /// They are multiplied by this.
        times: f64,
    },
    /// Reads the tables of planted mistakes, and says which do not fit the source.
    Check,
    /// The tables of all that was found so far.
    Score,
}

/// Which changes are asked of which tests.
#[derive(Args)]
struct Asking {
    /// Only this part, as 2/8: the second of eight.
    #[arg(default_value = "1/1")]
    part: String,
    /// Only those whose name, or file, holds this text.
    #[arg(long, default_value = "")]
    only: String,
    /// A change is given up when the tests that it passed take this many seconds together, without the change.
    #[arg(long, default_value_t = f64::INFINITY)]
    budget: f64,
    /// Test programs that are left out, as `report,window`: each of their tests takes long alone.
    #[arg(long, value_delimiter = ',')]
    without: Vec<String>,
    #[command(flatten)]
    mutants: Sample,
}

/// A sample of mutants.
#[derive(Args)]
struct Sample {
    /// Mutants too, drawn from this list, which `cargo mutants --list --json` printed.
    #[arg(long)]
    mutants: Option<PathBuf>,
    /// How many mutants are drawn.
    #[arg(long, default_value_t = 400)]
    of: usize,
    /// Another seed draws other mutants.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// What is asked of a change.
struct Asked {
    change: Change,
    kind: Kind,
    law: Option<String>,
}

/// What the first runs of all tests said, kept for the other parts.
#[derive(Serialize, Deserialize)]
struct Known {
    /// The commit and the changes.
    of: String,
    refused: BTreeSet<usize>,
    tests: Vec<Test>,
}

fn main() -> Result<()> {
    let arguments = Arguments::parse();
    let root = std::env::current_dir()?;
    ensure!(root.join("power/planted").is_dir(), "run this in the root of the repository");
    let folder = root.join(&arguments.folder);
    match arguments.what {
        What::Run(asking) => {
            let asked = asked(&root, &asking.mutants)?;
            let known = known(&root, &folder, &asked, &asking.without)?;
            measure(&root, &folder, &asked, &known, &asking)
        }
        What::Matrix(asking) => {
            let asked = asked(&root, &asking.mutants)?;
            let known = known(&root, &folder, &asked, &asking.without)?;
            fill_matrix(&folder, &asked, &known, &asking)
        }
        What::Again { tolerance, mutants } => {
            again(&root, &folder, &asked(&root, &mutants)?, tolerance)
        }
        What::Tolerances { times } => {
            ensure_committed(&root)?;
            println!("{} tolerances times {times}", tolerance::multiply(&root, times)?);
            Ok(())
        }
        What::Check => {
            let all = planted::read(&root.join("power/planted"))?;
            let wrong = all
                .iter()
                .filter_map(|it| it.check(&root).err())
                .map(|it| eprintln!("{it:#}"))
                .count();
            let decoys = all.iter().filter(|it| it.law.is_none()).count();
            ensure!(wrong == 0, "{wrong} of {} do not fit", all.len());
            println!("{} mistakes and {decoys} decoys fit the source", all.len() - decoys);
            Ok(())
        }
        What::Score => {
            print!("{}", score::tables(&rows(&folder)?));
            Ok(())
        }
    }
}

/// The planted mistakes, the decoys, and a sample of the mutants.
fn asked(root: &Path, sample: &Sample) -> Result<Vec<Asked>> {
    let mut asked = Vec::new();
    for it in planted::read(&root.join("power/planted"))? {
        let kind = if it.law.is_some() { Kind::Planted } else { Kind::Decoy };
        asked.push(Asked { change: it.change(root)?, kind, law: it.law });
    }
    if let Some(list) = &sample.mutants {
        let of = sample.of;
        let (changes, total) = mutants::sample(root, list, of, sample.seed)?;
        let count = changes.len();
        eprintln!("of {of} mutants drawn from {total}, {count} can stand behind a switch");
        let mutant = |change| Asked { change, kind: Kind::Mutant, law: None };
        asked.extend(changes.into_iter().map(mutant));
    }
    Ok(asked)
}

/// What each law that found a change finds with other tolerances, in a scratch copy of its own.
fn again(root: &Path, folder: &Path, asked: &[Asked], tolerance: f64) -> Result<()> {
    let tree = folder.join("tree");
    scratch::clone(root, &tree)?;
    let places = tolerance::multiply(&tree, tolerance)?;
    let changes: Vec<Change> = asked.iter().map(|it| it.change.clone()).collect();
    let programs = scratch::build(&tree, &changes)?.programs;
    let numbered = changes.iter().zip(1..);
    let numbers: BTreeMap<&str, usize> = numbered.map(|(it, number)| (&*it.name, number)).collect();
    let rows = rows(folder)?;
    let found: Vec<(&str, usize)> = rows
        .iter()
        .filter_map(|row| Some((row.law.as_deref()?, *numbers.get(row.name.as_str())?)))
        .collect();
    let laws: BTreeSet<&str> = found.iter().map(|(law, _)| *law).collect();
    let runs = |law: &str, number: usize| -> Result<bool> {
        Ok(Test::named(&programs, law)?.with(number)? == End::Passed)
    };
    let passing: BTreeSet<&str> = laws
        .par_iter()
        .map(|law| Ok(runs(law, 0)?.then_some(*law)))
        .collect::<Result<Vec<Option<&str>>>>()?
        .into_iter()
        .flatten()
        .collect();
    let asked: Vec<(&str, usize)> =
        found.into_iter().filter(|(law, _)| passing.contains(law)).collect();
    let missed = asked
        .par_iter()
        .map(|(law, number)| Ok(runs(law, *number)?.then_some((*law, *number))))
        .collect::<Result<Vec<Option<(&str, usize)>>>>()?;
    let missed: Vec<(&str, usize)> = missed.into_iter().flatten().collect();
    println!("{places} tolerances times {tolerance}");
    println!("{} of {} laws fail with nothing planted:", laws.len() - passing.len(), laws.len());
    laws.difference(&passing).for_each(|law| println!("- {law}"));
    println!("of {} changes the others miss {}:", asked.len(), missed.len());
    for (law, number) in &missed {
        println!("- {}: {law}", changes[number - 1].name);
    }
    Ok(())
}

/// Asks for each change of the part, writes a file a change, and prints the table of all that are there.
fn measure(
    root: &Path,
    folder: &Path,
    asked: &[Asked],
    known: &Known,
    asking: &Asking,
) -> Result<()> {
    let texts = std::fs::read_to_string(root.join("power/texts"))?;
    let texts: Vec<&str> =
        texts.lines().filter(|it| !it.starts_with('#') && !it.is_empty()).collect();
    for_each(&folder.join("found"), asked, known, asking, |index| {
        let row = ask(&asked[index], index, &known.tests, &texts, asking.budget)?;
        let by = row.law.as_ref().or(row.text.as_ref()).map_or("nothing", String::as_str);
        println!("{}: {by}", row.name);
        Ok(row)
    })?;
    print!("\n{}", score::tables(&rows(folder)?));
    Ok(())
}

/// Runs all tests on each change of the part, writes a file a change, and the table of all that are there.
fn fill_matrix(folder: &Path, asked: &[Asked], known: &Known, asking: &Asking) -> Result<()> {
    for_each(&folder.join("kills"), asked, known, asking, |index| {
        let name = &asked[index].change.name;
        let kills = matrix::kills(name, index + 1, &known.tests, asking.budget)?;
        println!("{name}: {} tests, {} not tried", kills.by.len(), kills.left);
        Ok(kills)
    })?;
    let table = folder.join("matrix.csv");
    std::fs::write(&table, matrix::table(&read(&folder.join("kills"))?, &known.tests))?;
    println!("\n{}", table.display());
    Ok(())
}

/// What `ask` says of each change of the part, in a file each in `folder`; those that are there are not asked again.
fn for_each<T: Serialize>(
    folder: &Path,
    asked: &[Asked],
    known: &Known,
    asking: &Asking,
    ask: impl Fn(usize) -> Result<T> + Sync,
) -> Result<()> {
    let Asking { part, only, .. } = asking;
    let (k, n) = part.split_once('/').with_context(|| format!("{part} is no part, as 2/8"))?;
    let (k, n): (usize, usize) = (k.parse()?, n.parse()?);
    ensure!(1 <= k && k <= n, "{part} is no part: the first number is from 1 to the second");
    std::fs::create_dir_all(folder)?;
    let is_of = |change: &Change| change.name.contains(only) || change.file.contains(only);
    let chosen: Vec<usize> = (0..asked.len())
        .filter(|index| is_of(&asked[*index].change) && !known.refused.contains(index))
        .collect();
    let chosen: Vec<usize> = chosen.into_iter().skip(k - 1).step_by(n).collect();
    chosen.par_iter().try_for_each(|&index| -> Result<()> {
        let file = folder.join(format!("{index}.json"));
        if file.exists() {
            return Ok(());
        }
        std::fs::write(&file, serde_json::to_vec_pretty(&ask(index)?)?)?;
        Ok(())
    })
}

fn git(root: &Path, arguments: &[&str]) -> Result<std::process::Output> {
    Ok(std::process::Command::new("git").args(arguments).current_dir(root).output()?)
}

fn ensure_committed(root: &Path) -> Result<()> {
    ensure!(
        git(root, &["diff", "--quiet", "HEAD"])?.status.success(),
        "some files are not as in the last commit, which is what is tried: commit them first"
    );
    Ok(())
}

/// The scratch copy and its tests, made anew when the commit or the changes are others.
fn known(root: &Path, folder: &Path, asked: &[Asked], without: &[String]) -> Result<Known> {
    ensure_committed(root)?;
    let head = git(root, &["rev-parse", "HEAD"])?;
    let changes: Vec<Change> = asked.iter().map(|it| it.change.clone()).collect();
    let of = format!(
        "{} {:x}",
        String::from_utf8_lossy(&head.stdout).trim(),
        xxhash_rust::xxh3::xxh3_64(format!("{changes:?} {without:?}").as_bytes())
    );
    let file = folder.join("known.json");
    if let Ok(text) = std::fs::read(&file) {
        let known: Known = serde_json::from_slice(&text)?;
        if known.of == of {
            return Ok(known);
        }
    }
    std::fs::create_dir_all(folder)?;
    let tree = folder.join("tree");
    scratch::clone(root, &tree)?;
    let mut built = scratch::build(&tree, &changes)?;
    built.programs.retain(|program| !without.contains(&program.name));
    let tests = run::reach(&built.programs, &folder.join("reached"))?;
    let known = Known { of, refused: built.refused, tests };
    for before in ["found", "kills"].map(|it| folder.join(it)) {
        if before.exists() {
            std::fs::remove_dir_all(&before)?;
        }
    }
    std::fs::write(&file, serde_json::to_vec(&known)?)?;
    Ok(known)
}

/// Runs the tests that reach a change: the expected law, then those that are named after its file, then the other laws, quick
/// ones first, then goldens and texts.
fn ask(asked: &Asked, index: usize, tests: &[Test], texts: &[&str], budget: f64) -> Result<Row> {
    let number = index + 1;
    let mut reaching: Vec<&Test> = tests.iter().filter(|it| it.reached.contains(&number)).collect();
    let is_text = |test: &Test| texts.iter().any(|it| test.name.contains(it));
    let is_expected =
        |test: &Test| asked.law.as_ref().is_some_and(|law| test.name.starts_with(law.as_str()));
    let own = asked.change.file.trim_end_matches(".rs").trim_end_matches("/mod");
    let own = own.rsplit('/').next().unwrap_or("");
    reaching.sort_by(|a, b| {
        let key = |it: &Test| (is_text(it), !is_expected(it), !it.name.contains(own));
        key(a).cmp(&key(b)).then(a.seconds.total_cmp(&b.seconds))
    });
    let mut row = Row {
        name: asked.change.name.clone(),
        package: score::package(&asked.change.file),
        kind: asked.kind,
        reached: reaching.len(),
        law: None,
        expected: asked.law.as_ref().map(|_| false),
        text: None,
        message: None,
        given_up: false,
    };
    let mut seconds = 0.0;
    for test in reaching {
        seconds += test.seconds;
        if seconds > budget {
            row.given_up = true;
            break;
        }
        let End::Failed(message) = test.with(number)? else { continue };
        if is_text(test) {
            row.text = Some(test.name.clone());
        } else {
            row.expected = row.expected.map(|_| is_expected(test));
            row.law = Some(test.name.clone());
        }
        row.message = Some(message);
        break;
    }
    Ok(row)
}

fn rows(folder: &Path) -> Result<Vec<Row>> {
    read(&folder.join("found"))
}

/// The files of a folder, in order.
fn read<T: DeserializeOwned>(folder: &Path) -> Result<Vec<T>> {
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder)?.map(|it| Ok(it?.path())).collect::<Result<_>>()?;
    files.sort();
    files.iter().map(|file| Ok(serde_json::from_slice(&std::fs::read(file)?)?)).collect()
}
