//! A change of the source: what is written instead of what, and a scratch copy that holds all changes, each behind one switch.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;

use anyhow::{Context, Result, ensure};

/// One change of one file.
#[derive(Clone, Debug)]
pub struct Change {
    /// A name that no other change has.
    pub name: String,
    /// The file, from the root of the repository.
    pub file: String,
    /// The bytes of the expression that is replaced; empty where a statement or a condition is put in.
    pub span: Range<usize>,
    /// What stands there while the switch is on.
    pub how: How,
}

/// What is done at the place of a change.
#[derive(Clone, Debug)]
pub enum How {
    /// The expression is another one.
    Expression(String),
    /// The function returns at once what is said here.
    Return(String),
    /// The arm of a `match` is never taken.
    NoArm,
}

impl How {
    /// The text with the switch, of the text `ours` that is there now.
    fn behind_switch(&self, number: usize, ours: &str) -> String {
        match self {
            Self::Expression(theirs) if ours.ends_with([';', '}']) => {
                format!("if planted::on({number}) {{ {theirs} }} else {{ {ours} }}")
            }
            Self::Expression(theirs) => {
                format!("(if planted::on({number}) {{ {theirs} }} else {{ {ours} }})")
            }
            Self::Return(value) => format!("if planted::on({number}) {{ return {value}; }} {ours}"),
            Self::NoArm => format!(" if !planted::on({number}) {ours}"),
        }
    }
}

impl Change {
    /// The text of the file with this change alone, behind a switch.
    pub fn switched(&self, text: &str) -> String {
        let ours = &text[self.span.clone()];
        format!(
            "{}{}{}",
            &text[..self.span.start],
            self.how.behind_switch(1, ours),
            &text[self.span.end..]
        )
    }
}

/// Where the changes of a file are in its text with switches: bytes, and the number of the change.
pub type Places = Vec<(Range<usize>, usize)>;

/// The changes that cross one before them in the list: one switch cannot stand in half of another.
pub fn crossing(changes: &[Change]) -> BTreeSet<usize> {
    let crosses = |a: &Change, b: &Change| {
        let (a_first, b_first) = (a.span.start < b.span.start, a.span.start > b.span.start);
        a.file == b.file
            && ((a_first && b.span.start < a.span.end && a.span.end < b.span.end)
                || (b_first && a.span.start < b.span.end && b.span.end < a.span.end))
    };
    let mut crossing = BTreeSet::new();
    for (index, change) in changes.iter().enumerate() {
        let mut before = changes[..index].iter().enumerate();
        if before.any(|(k, it)| !crossing.contains(&k) && crosses(it, change)) {
            crossing.insert(index);
        }
    }
    crossing
}

/// Writes the changes into the tree at `root`: number `k` of the list is on when the variable PLANTED is k + 1.
///
/// # Errors
/// A file that cannot be read or written; two changes of which neither holds the other.
pub fn write(
    root: &Path,
    changes: &[Change],
    left_out: &BTreeSet<usize>,
) -> Result<BTreeMap<String, Places>> {
    let mut files: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (index, change) in changes.iter().enumerate() {
        if !left_out.contains(&index) {
            files.entry(&change.file).or_default().push(index);
        }
    }
    let mut places = BTreeMap::new();
    for (file, mut numbers) in files {
        let path = root.join(file);
        let text = std::fs::read_to_string(&path).with_context(|| format!("{}", path.display()))?;
        // outer changes first
        numbers.sort_by_key(|&k| (changes[k].span.start, std::cmp::Reverse(changes[k].span.end)));
        let mut written = Written { text: &text, changes, out: String::new(), places: Vec::new() };
        written.range(0..text.len(), &numbers)?;
        std::fs::write(&path, &written.out)?;
        places.insert(file.to_owned(), written.places);
    }
    Ok(places)
}

struct Written<'a> {
    text: &'a str,
    changes: &'a [Change],
    out: String,
    places: Places,
}

impl Written<'_> {
    /// Writes the bytes of a range with the changes in it, outer ones first.
    fn range(&mut self, range: Range<usize>, mut numbers: &[usize]) -> Result<()> {
        let mut at = range.start;
        while let [first, rest @ ..] = numbers {
            let change = &self.changes[*first];
            ensure!(
                change.span.start >= at && change.span.end <= range.end,
                "{}: {} overlaps another change",
                change.file,
                change.name
            );
            self.out.push_str(&self.text[at..change.span.start]);
            let begin = self.out.len();
            // what is inside is written first, because it stands in the branch that is ours
            let inside = rest
                .iter()
                .take_while(|&&k| {
                    self.changes[k].span.end <= change.span.end
                        && self.changes[k].span.start < change.span.end
                })
                .count();
            let mut inner = Written {
                text: self.text,
                changes: self.changes,
                out: String::new(),
                places: Vec::new(),
            };
            inner.range(change.span.clone(), &rest[..inside])?;
            let whole = change.how.behind_switch(*first + 1, &inner.out);
            let shift = begin + whole.rfind(&inner.out).unwrap_or(0);
            self.out.push_str(&whole);
            self.places.push((begin..self.out.len(), *first));
            self.places.extend(
                inner
                    .places
                    .into_iter()
                    .map(|(range, k)| (range.start + shift..range.end + shift, k)),
            );
            at = change.span.end;
            numbers = &rest[inside..];
        }
        self.out.push_str(&self.text[at..range.end]);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(span: Range<usize>, how: How) -> Change {
        Change { name: format!("{span:?}"), file: "a.rs".to_owned(), span, how }
    }

    fn written(text: &str, changes: &[Change]) -> (String, Places) {
        let folder =
            std::env::temp_dir().join(format!("power-{}-{}", std::process::id(), text.len()));
        std::fs::create_dir_all(&folder).expect("a folder");
        std::fs::write(folder.join("a.rs"), text).expect("a file");
        let mut places = write(&folder, changes, &BTreeSet::new()).expect("none crosses another");
        let text = std::fs::read_to_string(folder.join("a.rs")).expect("the file");
        std::fs::remove_dir_all(&folder).expect("removed");
        (text, places.remove("a.rs").unwrap_or_default())
    }

    /// Law: with the switch off the text means what it did, a change within another stands in the branch that is ours,
    /// and each place is that of its own switch. Oracle: written by hand.
    #[test]
    fn changes_stand_behind_switches() {
        let text = "fn f() { a + b * c }";
        let expression = |theirs: &str| How::Expression(theirs.to_owned());
        let changes = [
            change(13..18, expression("b / c")),
            change(9..18, expression("0")),
            change(8..8, How::Return("1".to_owned())),
        ];
        let (out, places) = written(text, &changes);
        let inner = "(if planted::on(1) { b / c } else { b * c })";
        let outer = format!("(if planted::on(2) {{ 0 }} else {{ a + {inner} }})");
        assert_eq!(out, format!("fn f() {{if planted::on(3) {{ return 1; }}  {outer} }}"));
        for (range, number) in places {
            let begin = format!("if planted::on({})", number + 1);
            let found = out[range].trim_start_matches('(');
            assert!(
                found.starts_with(&begin),
                "at the place of {number}: {found}, expected {begin}"
            );
        }
    }

    /// Law: changes that cross one another are not both kept; nested and separate ones are. Oracle: by hand.
    #[test]
    fn crossing_changes_are_left_out() {
        let how = || How::NoArm;
        let changes =
            [change(2..8, how()), change(4..10, how()), change(3..5, how()), change(8..12, how())];
        assert_eq!(crossing(&changes), BTreeSet::from([1]));
    }
}
