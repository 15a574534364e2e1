//! `grade`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use clap::Args;
use conform::grade::{self, Grade as Points, TEMPLATE, TEMPLATE_SEED, Table};
use groundtruth::printable;

use super::claim::Claim;
use super::program::{ProgramArguments, fresh_seed, no_answer};
use super::{Exit, Outcome, interrupt, output, print, progress};

/// How long others may take to write their lines into the table of the class: each takes some milliseconds.
const PATIENCE: Duration = Duration::from_secs(30);

#[derive(Args)]
pub struct Grade {
    /// The assignment, a TOML file: parts, what is asked for each, and points
    #[arg(required_unless_present = "init")]
    table: Option<PathBuf>,
    /// Write the points for Gradescope; - is the standard output
    #[arg(long, value_name = "FILE")]
    results: Option<PathBuf>,
    /// Write the student's line into the table of the class (CSV), in the place of an earlier one
    #[arg(long, value_name = "FILE", requires = "student")]
    class: Option<PathBuf>,
    /// The student's name in that table
    #[arg(long, value_name = "NAME", value_parser = named)]
    student: Option<String>,
    /// Print JSON for the teacher, with seed, questions, answers and names of mistakes
    #[arg(long)]
    json: bool,
    /// Print a table to start from, with a seed of its own
    #[arg(long, exclusive = true)]
    init: bool,
    #[command(flatten)]
    program: ProgramArguments,
}

fn named(name: &str) -> Result<String, String> {
    match name.trim() {
        "" => Err("write a name".to_owned()),
        name => Ok(name.to_owned()),
    }
}

impl Grade {
    pub fn run(self) -> Outcome {
        let Some(table) = self.table.as_deref().filter(|_| !self.init) else {
            return print(&TEMPLATE.replacen(TEMPLATE_SEED, &fresh_seed().to_string(), 1));
        };
        output::check_distinct(self.files(), [table])?;
        self.files().try_for_each(output::writable)?;
        let table = Table::read(table)?;
        let interrupted = interrupt::flag()?;
        let mut program = self.program.program(Arc::clone(&interrupted));
        let style = "{bar:30} {pos} of {len} families  {wide_msg}";
        let bar = progress::bar(table.families.len() as u64, style);
        let grade = Points::of(&mut program, &table, interrupted, &mut |row| {
            bar.inc(1);
            bar.set_message(row.name.clone());
        });
        bar.finish_and_clear();
        let log = program.log();
        drop(program);
        if let Err(error) = &grade.card {
            let text = no_answer(&error.to_string(), &log);
            text.lines().for_each(|line| eprintln!("{}", printable::text(line)));
        }
        let exit = exit(&grade);
        // points of half of the questions are no points
        if !matches!(exit, Exit::Interrupted) {
            self.write(&grade)?;
        }
        output::say(
            &match self.json {
                true => serde_json::to_string_pretty(&grade.json())? + "\n",
                false => grade.text(),
            },
            self.files().find(|file| output::is_standard(file)),
        )?;
        Ok(exit)
    }

    /// The files that are written.
    fn files(&self) -> impl Iterator<Item = &Path> {
        [&self.results, &self.class].into_iter().flatten().map(PathBuf::as_path)
    }

    fn write(&self, grade: &Points) -> Result<(), Box<dyn Error>> {
        if let Some(file) = &self.results {
            let text = serde_json::to_string_pretty(&grade::results(grade))? + "\n";
            output::write(file, text.as_bytes())?;
        }
        if let (Some(file), Some(student)) = (&self.class, &self.student) {
            let _claim = Claim::within(file, PATIENCE)?;
            let text = match std::fs::read_to_string(file) {
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
                text => text.map_err(|e| format!("{}: cannot be read: {e}", file.display()))?,
            };
            let text = grade::with_row(&text, student, grade);
            let text = text.map_err(|e| format!("{}: {e}", file.display()))?;
            output::write(file, text.as_bytes())?;
        }
        Ok(())
    }
}

fn exit(grade: &Points) -> Exit {
    match &grade.card {
        Err(_) => Exit::Unanswered,
        Ok(card) if !card.is_whole => Exit::Interrupted,
        Ok(_) if grade.is_not_judged() => Exit::Unanswered,
        Ok(_) if grade.is_full() => Exit::Yes,
        Ok(_) => Exit::No,
    }
}
