//! The file that a teacher writes: parts, what is asked for each, and their points.

use std::ops::Range;
use std::path::{Path, PathBuf};

use groundtruth::invalid::plain_words;
use groundtruth::printable;
use groundtruth::scene::STANDARD_INPUT;
use serde::Deserialize;
use toml::Spanned;

use crate::family::Family;
use crate::suite;

/// A table to start from.
pub const TEMPLATE: &str = include_str!("../../../../examples/grade/table.toml");
/// Its seed, as it is written there.
pub const TEMPLATE_SEED: &str = "48151623";

/// Smaller seeds are found by trying them: a student who knows one question would soon know them all.
const LEAST_SEED: i64 = 1_000_000;
/// TOML has no larger integers.
const MOST_SEED: i64 = i64::MAX;
/// With fewer, a family may have none that can be judged.
const LEAST_CASES: i64 = 4;
/// A program is asked this many questions of each of some hundred families.
const MOST_CASES: i64 = 10_000;
const CASES: i64 = 48;
/// More digits than a column of points can show.
const MOST_POINTS: f64 = 1e6;

/// An assignment.
pub struct Table {
    /// What students read above their points.
    pub title: String,
    /// Of the questions.
    pub seed: u64,
    /// Cases of each family.
    pub cases: usize,
    /// In the order of the file.
    pub parts: Vec<TablePart>,
    /// What all parts ask, in the order of the suite.
    pub families: Vec<Family>,
}

/// A part of an assignment.
pub struct TablePart {
    /// What students read.
    pub name: String,
    /// At most so many.
    pub points: f64,
    /// The names of its families; at least one.
    pub families: Vec<String>,
}

/// Why a table cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// It cannot be read.
    #[error("{}: cannot be read: {source}", shown(path))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// Something in it is not as it has to be.
    #[error("{}:{line}: {problem}", shown(path))]
    Invalid {
        /// The file.
        path: PathBuf,
        /// From 1.
        line: usize,
        /// The part and field, what was found, and what to write.
        problem: String,
    },
}

fn shown(path: &Path) -> String {
    printable::text(&path.display().to_string())
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    title: String,
    seed: Option<Spanned<i64>>,
    cases: Option<Spanned<i64>>,
    #[serde(default)]
    part: Vec<FilePart>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FilePart {
    name: Spanned<String>,
    ask: Spanned<Vec<Spanned<String>>>,
    points: Spanned<f64>,
}

/// Where a problem is, and what it is.
type Problem = (Range<usize>, String);

impl Table {
    /// Reads a table from a file or, if its path is `-`, from the standard input.
    ///
    /// # Errors
    /// An error with file, line, field and what to write.
    pub fn read(path: &Path) -> Result<Self, TableError> {
        let unreadable = |source| TableError::Unreadable { path: path.to_owned(), source };
        let text = match path == Path::new(STANDARD_INPUT) {
            true => std::io::read_to_string(std::io::stdin().lock()),
            false => std::fs::read_to_string(path),
        };
        Self::parse(&text.map_err(unreadable)?, path)
    }

    fn parse(text: &str, path: &Path) -> Result<Self, TableError> {
        let of_toml =
            |error: toml::de::Error| (error.span().unwrap_or(0..0), plain_words(error.message()));
        let built = toml::from_str::<File>(text).map_err(of_toml).and_then(File::build);
        built.map_err(|(span, problem)| {
            let before = &text.as_bytes()[..span.start.min(text.len())];
            let line = 1 + before.iter().filter(|byte| **byte == b'\n').count();
            TableError::Invalid { path: path.to_owned(), line, problem: printable::text(&problem) }
        })
    }

    /// The sum of the points of all parts.
    pub fn points(&self) -> f64 {
        self.parts.iter().map(|part| part.points).sum()
    }
}

impl File {
    fn build(self) -> Result<Table, Problem> {
        let seed = self.seed.ok_or_else(|| {
            let problem = "`seed` is missing: write `seed = ` and a whole number of about ten digits that students \
                           do not see; `grade --init` prints a table with one";
            (0..0, problem.to_owned())
        })?;
        let seed = whole("seed", &seed, LEAST_SEED..=MOST_SEED, "smaller ones are soon guessed")?;
        let cases = match &self.cases {
            Some(cases) => {
                whole("cases", cases, LEAST_CASES..=MOST_CASES, "fewer say little, more take long")?
            }
            None => CASES,
        };
        if self.part.is_empty() {
            let problem = "there is no `[[part]]`: write one, with `name`, `ask` and `points`";
            return Err((0..0, problem.to_owned()));
        }
        let all: Vec<Family> = suite::all();
        let mut parts: Vec<TablePart> = Vec::new();
        for part in &self.part {
            parts.push(part.build(&all, &parts)?);
        }
        let is_asked =
            |family: &Family| parts.iter().any(|part| part.families.contains(&family.name));
        let families = all.into_iter().filter(is_asked).collect();
        let title = match self.title.is_empty() {
            true => "Points".to_owned(),
            false => printable::text(&self.title),
        };
        // both are within their ranges, which are not negative
        Ok(Table { title, seed: seed as u64, cases: cases as usize, parts, families })
    }
}

/// A number in its range.
fn whole(
    field: &str,
    found: &Spanned<i64>,
    range: std::ops::RangeInclusive<i64>,
    why: &str,
) -> Result<i64, Problem> {
    let number = *found.get_ref();
    match range.contains(&number) {
        true => Ok(number),
        false => {
            let (least, most) = (range.start(), range.end());
            let problem = format!(
                "`{field}` is {number}; write a whole number from {least} to {most}: {why}"
            );
            Err((found.span(), problem))
        }
    }
}

impl FilePart {
    fn build(&self, all: &[Family], before: &[TablePart]) -> Result<TablePart, Problem> {
        let name = printable::name(self.name.get_ref().trim());
        let of_name = |problem: &str| Err((self.name.span(), problem.to_owned()));
        if name.is_empty() {
            return of_name("`name` is empty; write what students read, as `name = \"Spheres\"`");
        }
        if before.iter().any(|part| part.name == name) {
            return of_name(&format!("two parts are called `{name}`; give each a name of its own"));
        }
        let points = *self.points.get_ref();
        if !(points > 0.0 && points <= MOST_POINTS) {
            let problem =
                format!("part `{name}`: `points` is {points}; write a number above 0, as 10");
            return Err((self.points.span(), problem));
        }
        if self.ask.get_ref().is_empty() {
            let problem = format!(
                "part `{name}`: `ask` is empty; write what `groundtruth conform` takes, as `ask = [\"ch19\"]`"
            );
            return Err((self.ask.span(), problem));
        }
        let mut families = Vec::new();
        for word in self.ask.get_ref() {
            let found = selected(word.get_ref(), all);
            let found = found
                .map_err(|problem| (word.span(), format!("part `{name}`: `ask`: {problem}")))?;
            families.extend(
                found.into_iter().filter(|family| !families.contains(family)).collect::<Vec<_>>(),
            );
        }
        for other in before {
            if let Some(twice) = families.iter().find(|name| other.families.contains(name)) {
                let problem = format!(
                    "part `{name}` asks {twice}, which part `{}` asks already: it would count twice; use longer \
                     words, as `intersect.sphere` for `ch03`",
                    other.name
                );
                return Err((self.ask.span(), problem));
            }
        }
        Ok(TablePart { name, points, families })
    }
}

/// The families that a word selects and that single precision can answer.
fn selected(word: &str, all: &[Family]) -> Result<Vec<String>, String> {
    let of_word = || all.iter().filter(|family| family.is_selected_by(word));
    if of_word().next().is_none() {
        return Err(suite::unknown(&printable::name(word), all));
    }
    let found: Vec<String> =
        of_word().filter(|family| family.ordinary).map(|family| family.name.clone()).collect();
    match found.is_empty() {
        true => Err(format!(
            "`{word}` asks only what double precision can answer, and this is not graded; write a shorter word"
        )),
        false => Ok(found),
    }
}
