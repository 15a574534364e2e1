//! `laws`.

use ask::Stop;
use std::error::Error;

use claims::{ClaimsCard, ClaimsOptions, Description, SubjectRow};
use clap::Args;
use groundtruth::printable;

use super::numbers::whole;
use super::program::{CardArguments, Written, unanswered};
use super::scene::option;
use super::{Exit, Outcome, print, progress};

#[derive(Args)]
pub struct Laws {
    /// Only those whose names match, as 'ggx*'; all that the program lists, if left out
    only: Option<glob::Pattern>,
    /// Cases of each lobe, light or map
    #[arg(long, value_name = "N", default_value_t = claims::CASES, value_parser = whole::<usize>(1..=claims::MOST_CASES as u64))]
    cases: usize,
    /// Ask for the lobes of a specification instead of those that the program lists; docs/laws.md names them
    #[arg(long, value_name = "NAME", value_parser = ["openpbr"])]
    pack: Option<String>,
    /// Print a program to start from: name your lobes, and fill in two functions
    #[arg(long, value_name = "LANGUAGE", value_enum, exclusive = true)]
    init: Option<ask::Language>,
    #[command(flatten)]
    card: CardArguments,
}

impl Laws {
    pub fn run(self) -> Outcome {
        if let Some(language) = self.init {
            return print(&language.with_lobe());
        }
        self.card.check_files(None)?;
        let mut program = self.card.program(progress::interrupt_flag()?);
        let listed = match self.pack {
            Some(_) => Ok(claims::openpbr()),
            None => claims::listed(&mut program),
        };
        let lobes = match listed {
            Ok(lobes) => self.chosen(lobes)?,
            Err(Stop::NotAsked) => return progress::nothing_written(),
            Err(stop) => return unanswered(stop.text(), &program.log()),
        };
        let options = ClaimsOptions { cases: self.cases, seed: self.card.seed() };
        let style = "{bar:30} {pos} of {len}  {wide_msg}";
        let bar = progress::bar(lobes.len() as u64, style);
        let card = claims::run(&mut program, &lobes, options, &mut |name| {
            bar.inc(1);
            bar.set_message(printable::name(name));
        });
        bar.finish_and_clear();
        drop(program);
        let selection = self.only.iter().map(ToString::to_string).collect();
        let pack = option("--pack", self.pack.as_ref());
        let cases = (self.cases != claims::CASES).then_some(self.cases);
        let told = claims::told(&card, &self.card.invocation(selection, pack, cases));
        self.card.write(&Written {
            told: &told,
            json: card.json(),
            page: &|command| claims::page(&card, &told, command),
            junit: &|command| claims::junit(&card, command),
            more: None,
        })?;
        Ok(exit(&card))
    }

    fn chosen(&self, mut lobes: Vec<Description>) -> Result<Vec<Description>, Box<dyn Error>> {
        let names = printable::listed(lobes.iter().map(|lobe| &lobe.name));
        lobes.retain(|lobe| self.only.as_ref().is_none_or(|only| only.matches(&lobe.name)));
        match lobes.is_empty() {
            true => Err(format!("nothing matches; listed are {names}").into()),
            false => Ok(lobes),
        }
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
