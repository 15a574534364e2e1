//! `conform`.

use ask::Invocation;
use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;

use clap::{Args, ValueEnum};
use conform::{self, Card, KnownFailures, Options, Profile, Row, card, family::Family};

use super::numbers::whole;
use super::program::{CardArguments, Written, unanswered};
use super::scene::option;
use super::{Exit, Outcome, print, progress};

#[derive(Args)]
pub struct Conform {
    /// What to ask: chapters (ch19), things (shapes/torus), questions (intersect), or other beginnings of things
    /// and of families' names that end before /, . or _ (intersect.torus, light.area for light.area.sphere.area);
    /// everything, if left out
    what: Vec<String>,
    /// How exact answers have to be
    #[arg(long, value_enum, default_value_t = Exact::Careful)]
    profile: Exact,
    /// Cases in each family
    #[arg(long, value_name = "N", default_value_t = conform::CASES, value_parser = whole::<usize>(0..=conform::MOST_CASES as u64))]
    cases: usize,
    /// Only families whose names match, as "intersect.*.grazing"
    #[arg(long, value_name = "GLOB")]
    only: Option<glob::Pattern>,
    /// A file of families that may fail, one a line; one that does not fail is a failure, too
    #[arg(long, value_name = "FILE", conflicts_with = "write_known")]
    known: Option<PathBuf>,
    /// Write such a file of all that failed
    #[arg(long, value_name = "FILE")]
    write_known: Option<PathBuf>,
    /// Print an adapter to fill in, whose every question is a function that returns "unsupported"
    #[arg(long, value_name = "LANGUAGE", value_enum, exclusive = true)]
    init: Option<ask::Language>,
    #[command(flatten)]
    card: CardArguments,
}

/// The profiles by name.
#[derive(Clone, Copy, ValueEnum)]
enum Exact {
    /// Double precision: errors of at most 100 u·cond, hard cases too
    Careful,
    /// Single precision and a constant ε: errors of at most 1e-4, ordinary cases only
    Book,
}

impl Conform {
    pub fn run(self) -> Outcome {
        if let Some(language) = self.init {
            return print(language.adapter());
        }
        let families = self.families()?;
        self.card.check_files(self.write_known.as_deref())?;
        let known = self.known.as_deref().map(KnownFailures::read).transpose()?;
        let interrupted = progress::interrupt_flag()?;
        let profile = match self.profile {
            Exact::Careful => Profile::Careful,
            Exact::Book => Profile::Book,
        };
        let options = Options {
            profile,
            seed: self.card.seed(),
            cases: self.cases,
            shrink: true,
            interrupted: Arc::clone(&interrupted),
        };
        let mut program = self.card.program(interrupted);
        let style = "{bar:30} {pos} of {len} families  {wide_msg}";
        let bar = progress::bar(families.len() as u64, style);
        let card = conform::run(&mut program, &families, &options, &mut |row| {
            bar.inc(1);
            bar.set_message(row.name.clone());
        });
        bar.finish_and_clear();
        let log = program.log();
        drop(program);
        let card = match card {
            Ok(card) => card,
            Err(error) => return unanswered(&error.to_string(), &log),
        };
        let told = card::told(&card, &self.invocation());
        let known_now = || conform::KnownFailures::of(&card).to_string();
        self.card.write(&Written {
            told: &told,
            json: card.json(),
            page: &|command| card::page(&card, &told, command),
            junit: &|command| card::junit(&card, command),
            more: self.write_known.as_deref().map(|file| (file, known_now())),
        })?;
        Ok(exit(&card, known.as_ref()))
    }

    /// What was typed, to be asked again.
    fn invocation(&self) -> Invocation<'_> {
        let book = matches!(self.profile, Exact::Book).then_some("book");
        let known = self.known.as_ref().map(|file| file.display());
        let options = [option("--profile", book), option("--known", known)].concat();
        let selection = [self.what.clone(), option("--only", self.only.as_ref())].concat();
        let cases = (self.cases != conform::CASES).then_some(self.cases);
        self.card.invocation(selection, options, cases)
    }

    /// The families that the arguments select; at least one.
    fn families(&self) -> Result<Vec<Family>, Box<dyn Error>> {
        let mut families = conform::suite::all();
        let is_known = |word: &str| families.iter().any(|family| family.is_selected_by(word));
        if let Some(word) = self.what.iter().find(|word| !is_known(word)) {
            return Err(conform::suite::unknown(word, &families).into());
        }
        families.retain(|family| {
            let named =
                self.what.is_empty() || self.what.iter().any(|word| family.is_selected_by(word));
            named && self.only.as_ref().is_none_or(|only| only.matches(&family.name))
        });
        if families.is_empty() {
            let word = self.only.as_ref().map_or("", |only| only.as_str()).trim_matches('*');
            let hint = conform::suite::similar(word.trim_matches('.'), &conform::suite::all());
            let problem = "no family matches --only";
            return Err(format!("{problem}{hint} (the names are those on the card)").into());
        }
        Ok(families)
    }
}

fn exit(card: &Card, known: Option<&KnownFailures>) -> Exit {
    if !card.is_whole {
        return Exit::Interrupted;
    }
    if card.is_not_judged() || card.rows.iter().all(Row::is_unsupported) {
        return Exit::Unanswered;
    }
    let is_failed = known.map_or(card.is_failed(), |known| is_new(known, card));
    if is_failed { Exit::No } else { Exit::Yes }
}

/// Prints how a card differs from the failures that are known; whether it does.
fn is_new(known: &KnownFailures, card: &Card) -> bool {
    let (new, passed) = known.compare(card);
    new.iter().for_each(|name| eprintln!("not known to fail: {name}"));
    passed.iter().for_each(|name| eprintln!("known to fail, but does not: {name}"));
    !new.is_empty() || !passed.is_empty()
}
