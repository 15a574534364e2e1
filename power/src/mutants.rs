//! The mutants that cargo-mutants lists, as changes behind the switch: it would build anew for each of them.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use anyhow::{Context, Result};
use serde::Deserialize;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use xxhash_rust::xxh3::xxh3_64_with_seed;

use crate::change::{Change, How};

/// A mutant as `cargo mutants --list --json` prints it.
#[derive(Clone, Debug, Deserialize)]
pub struct Mutant {
    name: String,
    package: String,
    file: String,
    span: Span,
    replacement: String,
    genre: String,
}

#[derive(Clone, Copy, Debug, Deserialize)]
struct Span {
    start: Position,
    end: Position,
}

/// Both from 1.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
struct Position {
    line: usize,
    column: usize,
}

/// A sample of `count` mutants, each folder of each package with its share of all.
///
/// # Errors
/// A list that cannot be read; a file that cannot be parsed.
pub fn sample(root: &Path, list: &Path, count: usize, seed: u64) -> Result<(Vec<Change>, usize)> {
    let text = std::fs::read_to_string(list).with_context(|| format!("{}", list.display()))?;
    let all: Vec<Mutant> = serde_json::from_str(&text)?;
    let mut strata: BTreeMap<(String, String), Vec<Mutant>> = BTreeMap::new();
    for mutant in all {
        let folder = Path::new(&mutant.file).parent().unwrap_or(Path::new(""));
        strata
            .entry((mutant.package.clone(), folder.display().to_string()))
            .or_default()
            .push(mutant);
    }
    let total: usize = strata.values().map(Vec::len).sum();
    // one walk along all strata in equal steps, which gives each its share and small ones their chance
    let mut ordered: Vec<Mutant> = Vec::with_capacity(total);
    for stratum in strata.values_mut() {
        stratum.sort_by_key(|it| xxh3_64_with_seed(it.name.as_bytes(), seed));
        ordered.append(stratum);
    }
    let step = total as f64 / count as f64;
    let offset = (xxh3_64_with_seed(b"first", seed) % 1000) as f64 / 1000.0;
    let chosen = (0..count).map(|k| ordered[((k as f64 + offset) * step) as usize].clone());
    let changes: Result<Vec<Option<Change>>> = chosen.map(|mutant| change(root, &mutant)).collect();
    Ok((changes?.into_iter().flatten().collect(), total))
}

/// The change of a mutant; none if it is of a kind that cannot stand behind a switch (a field of a struct left out).
fn change(root: &Path, mutant: &Mutant) -> Result<Option<Change>> {
    let text =
        std::fs::read_to_string(root.join(&mutant.file)).with_context(|| mutant.file.clone())?;
    let file = syn::parse_file(&text).with_context(|| mutant.file.clone())?;
    let target = byte(&text, mutant.span.start)..byte(&text, mutant.span.end);
    let mut finder =
        Finder { text: &text, target, replacement: clean(&mutant.replacement), found: None };
    match mutant.genre.as_str() {
        "FnValue" => {
            finder.found = Some((
                finder.target.start + body(&text, &finder.target),
                How::Return(finder.replacement.clone()),
            ))
            .map(|(at, how)| (at..at, how))
        }
        "MatchArmGuard" => {
            finder.found =
                Some((finder.target.clone(), How::Expression(finder.replacement.clone())));
        }
        _ => finder.visit_file(&file),
    }
    let Some((span, how)) = finder.found else { return Ok(None) };
    Ok(Some(Change { name: mutant.name.clone(), file: mutant.file.clone(), span, how }))
}

/// The tool's own remark beside a replacement.
fn clean(replacement: &str) -> String {
    replacement.split("/*").next().unwrap_or("").trim().to_owned()
}

/// The first byte within the braces of a body, from the begin of its span.
fn body(text: &str, span: &Range<usize>) -> usize {
    usize::from(text[span.clone()].starts_with('{'))
}

fn byte(text: &str, position: Position) -> usize {
    let line: usize = text.split_inclusive('\n').take(position.line - 1).map(str::len).sum();
    let column = text[line..].char_indices().nth(position.column - 1).map_or(0, |(at, _)| at);
    line + column
}

/// Looks for the expression whose operator, or the arm, is at the target.
struct Finder<'a> {
    text: &'a str,
    target: Range<usize>,
    replacement: String,
    found: Option<(Range<usize>, How)>,
}

impl Finder<'_> {
    fn is_at(&self, span: proc_macro2::Span) -> bool {
        span.byte_range().start == self.target.start
    }
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_expr_binary(&mut self, it: &'ast syn::ExprBinary) {
        if self.is_at(it.op.span()) {
            let left = &self.text[it.left.span().byte_range()];
            let right = &self.text[it.right.span().byte_range()];
            let theirs = format!("{left} {} {right}", self.replacement);
            self.found = Some((it.span().byte_range(), How::Expression(theirs)));
        }
        visit::visit_expr_binary(self, it);
    }

    fn visit_expr_unary(&mut self, it: &'ast syn::ExprUnary) {
        if self.is_at(it.op.span()) {
            let theirs = self.text[it.expr.span().byte_range()].to_owned();
            self.found = Some((it.span().byte_range(), How::Expression(theirs)));
        }
        visit::visit_expr_unary(self, it);
    }

    fn visit_arm(&mut self, it: &'ast syn::Arm) {
        if self.is_at(it.span()) && self.target.end >= it.body.span().byte_range().end {
            let end = it.pat.span().byte_range().end;
            // a guard that is there is joined with "and"
            self.found = Some(match &it.guard {
                None => (end..end, How::NoArm),
                Some((_, guard)) => {
                    (guard.span().byte_range(), How::Expression("false".to_owned()))
                }
            });
        }
        visit::visit_arm(self, it);
    }
}
