//! `laws`.

use std::error::Error;
use std::path::{Path, PathBuf};

use claims::{ClaimsCard, ClaimsOptions, Description, SubjectRow, Trouble};
use clap::Args;
use conform::Invocation;
use groundtruth::printable;
use pictures::told::Told;

use super::numbers::whole;
use super::program::{ProgramArguments, fresh_seed, no_answer};
use super::{Exit, Outcome, interrupt, output, print, progress};

#[derive(Args)]
pub struct Laws {
    /// Only those whose names match, as 'ggx*'; all that the program lists, if left out
    only: Option<glob::Pattern>,
    /// Of the cases
    #[arg(long, default_value_t = 1, value_parser = whole::<u64>(0..=u64::MAX))]
    seed: u64,
    /// A seed that nobody has seen; the card prints it
    #[arg(long, conflicts_with = "seed")]
    fresh: bool,
    /// Cases of each lobe, light or map
    #[arg(long, value_name = "N", default_value_t = claims::CASES, value_parser = whole::<usize>(1..=claims::MOST_CASES as u64))]
    cases: usize,
    /// Write the results for continuous integration (JUnit's XML)
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write the card as a page; - is the standard output, here and for the other file
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Print a program to start from: name your lobes, and fill in two functions
    #[arg(long, value_name = "LANGUAGE", value_enum, exclusive = true)]
    init: Option<claims::Language>,
    #[command(flatten)]
    program: ProgramArguments,
}

impl Laws {
    pub fn run(self) -> Outcome {
        if let Some(language) = self.init {
            return print(&language.template());
        }
        output::once(self.files(), "output")?;
        self.files().try_for_each(output::writable)?;
        let mut program = self.program.program(interrupt::flag()?);
        let lobes = match claims::listed(&mut program) {
            Ok(lobes) => self.chosen(lobes)?,
            Err(Trouble::Interrupted) => {
                eprintln!("interrupted; nothing was written");
                return Ok(Exit::Interrupted);
            }
            Err(Trouble::Unsupported(why) | Trouble::Refused(why) | Trouble::Fault(why)) => {
                let text = no_answer(&why, &program.log());
                text.lines().for_each(|line| eprintln!("{}", printable::text(line)));
                return Ok(Exit::Unanswered);
            }
        };
        let seed = if self.fresh { fresh_seed() } else { self.seed };
        let options = ClaimsOptions { cases: self.cases, seed };
        let style = "{bar:30} {pos} of {len}  {wide_msg}";
        let bar = progress::bar(lobes.len() as u64, style);
        let card = claims::run(&mut program, &lobes, options, &mut |name| {
            bar.inc(1);
            bar.set_message(printable::name(name));
        });
        bar.finish_and_clear();
        drop(program);
        let told = claims::told(&card, &self.invocation());
        self.write(&card, &told)?;
        self.say(&if self.json { told.json(&card.json())? } else { told.text() })?;
        Ok(exit(&card))
    }

    /// What was typed, to be asked again.
    fn invocation(&self) -> Invocation<'_> {
        Invocation {
            selection: self.only.iter().map(ToString::to_string).collect(),
            options: self.program.limits(),
            cases: (self.cases != claims::CASES).then_some(self.cases),
            is_fresh: self.fresh,
            program: self.program.words(),
        }
    }

    fn chosen(&self, mut lobes: Vec<Description>) -> Result<Vec<Description>, Box<dyn Error>> {
        let names = printable::listed(lobes.iter().map(|lobe| &lobe.name));
        lobes.retain(|lobe| self.only.as_ref().is_none_or(|only| only.matches(&lobe.name)));
        match lobes.is_empty() {
            true => Err(format!("nothing matches; the program lists {names}").into()),
            false => Ok(lobes),
        }
    }

    /// The files that are written.
    fn files(&self) -> impl Iterator<Item = &Path> {
        [&self.output, &self.junit].into_iter().flatten().map(PathBuf::as_path)
    }

    /// Prints what is said; to the standard error if a file goes to the standard output.
    fn say(&self, text: &str) -> Outcome {
        output::say(text, self.files().find(|file| output::is_standard(file)))
    }

    fn write(&self, card: &ClaimsCard, told: &Told) -> Result<(), Box<dyn Error>> {
        let command = self.program.command();
        if let Some(file) = &self.output {
            output::write(file, claims::page(card, told, &command).as_bytes())?;
        }
        if let Some(file) = &self.junit {
            output::write(file, claims::junit(card, &command).as_bytes())?;
        }
        Ok(())
    }
}

fn exit(card: &ClaimsCard) -> Exit {
    if !card.is_whole {
        return Exit::Interrupted;
    }
    if card.is_failed() {
        return Exit::No;
    }
    match !card.is_judged() || card.rows.iter().all(SubjectRow::is_unsupported) {
        true => Exit::Unanswered,
        false => Exit::Yes,
    }
}
