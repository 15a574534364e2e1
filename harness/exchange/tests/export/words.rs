//! Whole scenes as each target says them, and what it refuses: goldens of words, written anew by
//! `scripts/renew-texts.sh`. Laws about the numbers in them are in the other files.

use std::collections::HashSet;

use exchange::export::{AnyKind, Target};
use groundtruth::scene::Scene;

use super::kinds::{self, combined};
use super::said::cases;

/// Of a longer run of lines that begin with the same words, or with a number, a golden has the first few: of meshes.
const LONGEST: usize = 20;
const FEW: usize = 4;
/// How a line begins that says what is refused.
const REFUSED: &str = "refused";

/// Everything that a target writes of a scene, or the lines of what it refuses.
fn written(target: Target, scene: &Scene) -> Result<String, String> {
    let exported = target
        .write("scene", "scene", scene, "".as_ref())
        .map_err(|all| all.iter().map(|it| format!("{REFUSED}: {it}\n")).collect::<String>())?;
    let file = |(name, bytes)| format!("{name}:\n{}", String::from_utf8(bytes).expect("text"));
    let files: String = exported.files.into_iter().map(file).collect();
    Ok(exported.text + &files)
}

/// A golden of several texts: of each the lines that none before it has, with their long runs shortened.
#[derive(Default)]
struct Golden {
    text: String,
    seen: HashSet<String>,
}

impl Golden {
    fn add(&mut self, name: &str, text: &str) {
        let words = |line: &&str| {
            let words: Vec<&str> = line.split_whitespace().take(2).collect();
            let is_number = words.first().is_some_and(|it| it.parse::<f64>().is_ok());
            if is_number { "number".to_owned() } else { words.join(" ") }
        };
        let is_new = |it: &&str| self.seen.insert((*it).to_owned()) || it.starts_with(REFUSED);
        let new: Vec<&str> = text.lines().filter(is_new).collect();
        let above = text.lines().count() - new.len();
        self.text += &format!("\n== {name} ({above} lines stand above)\n");
        for run in new.chunk_by(|a, b| words(a) == words(b)) {
            let count = run.len();
            self.text += &match count > LONGEST {
                true => format!("{}\n({count} lines)\n", run[..FEW].join("\n")),
                false => run.join("\n") + "\n",
            };
        }
    }
}

/// Golden: of each kind that a target can say the specimens with the shortest texts, in one scene for each list; of
/// cameras, in one for each.
#[test]
fn kinds_read_as_before() {
    let text = |target, all: &[AnyKind]| written(target, &combined(target, all));
    for target in Target::ALL {
        let mut golden = Golden::default();
        for (list, kinds) in kinds::lists() {
            let is_camera = list == "camera";
            let shortest = |kind: Vec<AnyKind>| {
                let length = |it| Some((text(target, std::slice::from_ref(&it)).ok()?.len(), it));
                let mut all: Vec<_> = kind.into_iter().filter_map(length).collect();
                all.sort_by_key(|(length, _)| *length);
                all.into_iter().take(if is_camera { 1 } else { 2 }).map(|(_, it)| it)
            };
            let specimens: Vec<AnyKind> = kinds.into_iter().flat_map(shortest).collect();
            for all in specimens.chunks(if is_camera { 1 } else { specimens.len() }) {
                golden.add(list, &text(target, all).expect("as each alone"));
            }
        }
        insta::assert_snapshot!(format!("kinds_{target:?}"), golden.text);
    }
}

/// Golden: what each target writes of each case, or refuses, with its place, all at once.
#[test]
fn cases_read_as_before() {
    for target in Target::ALL {
        let mut golden = Golden::default();
        for case in cases(include_str!("words.toml")) {
            let (Ok(text) | Err(text)) = written(target, &case.left());
            golden.add(&case.filled("{says}"), &text);
        }
        insta::assert_snapshot!(format!("cases_{target:?}"), golden.text);
    }
}
