//! The chapters as pages of the book: which of its statements are held, in its order, and by which law.
//!
//! A law that holds a statement of the book says where it stands: `/// Book: 24.2, the reflected direction.`, or in the tables of
//! tests/laws `book = "24.2, the reflected direction"`. The table at the head of the chapter and that of docs/book.md are written from these lines, by scripts/renew-texts.sh. Places are in the order of
//! the head, which is moved by hand; a new place comes last.

use std::fmt::Write as _;
use std::iter;
use std::path::{Path, PathBuf};

use crate::kit::{root, text_of};
use crate::structure::rust_files;
use testkit::same_text::{self, Printed};

const HEAD: &str = "//! | of the book | what is held | by the law |\n//! | --- | --- | --- |\n";
const MARK: &str = "<!-- written from the heads of tests/chapters -->\n";

/// A law that holds a statement of the book.
struct Held {
    /// Where in the book: a section or figure and its subject.
    place: String,
    /// The first sentence of the law.
    statement: String,
    /// The path within the chapter.
    law: String,
    file: PathBuf,
}

/// A chapter: its number, the file that heads it, what it holds of the book, in the book's order, and how many laws of which
/// module hold something else.
struct Chapter {
    number: usize,
    head: PathBuf,
    held: Vec<Held>,
    beyond: Vec<(String, usize)>,
}

impl Chapter {
    fn read(number: usize) -> Self {
        let folder = root().join("tests/chapters");
        let name = format!("ch{number:02}");
        let inside = folder.join(&name);
        let files = [folder.join(format!("{name}.rs")), inside.join("mod.rs")];
        let head = files.into_iter().find(|it| it.exists()).expect("each chapter has a head");
        let mut files = vec![head.clone()];
        if inside.is_dir() {
            files.extend(rust_files(&inside).into_iter().filter(|it| *it != head));
        }
        let (mut held, mut beyond) = (Vec::new(), Vec::new());
        for file in &files {
            let (of_the_book, others) = laws_of(file, &head);
            held.extend(of_the_book);
            let module = file.file_stem().filter(|_| *file != head);
            let module = module.map_or("this file".to_owned(), |it| format!("`{}`", it.display()));
            beyond.extend((others > 0).then_some((module, others)));
        }
        let table = root().join("tests/laws").join(&name).with_extension("toml");
        if table.exists() {
            let (of_the_book, others) = laws_of_light(&table);
            held.extend(of_the_book);
            beyond.extend((others > 0).then_some((format!("`tests/laws/{name}.toml`"), others)));
        }
        let listed = listed(&text(&head));
        let place = |it: &Held| listed.iter().position(|(place, _)| *place == it.place);
        let row = |it: &Held| listed.iter().position(|(_, law)| *law == it.law);
        let new: Vec<String> = held.iter().map(|it| it.place.clone()).collect();
        let after = |it: &Held| new.iter().position(|place| *place == it.place);
        held.sort_by_key(|it| {
            let last = usize::MAX;
            (place(it).unwrap_or(last), after(it), row(it).unwrap_or(last))
        });
        Self { number, head, held, beyond }
    }

    /// Each law, behind its place if that is another than before.
    fn rows(&self) -> impl Iterator<Item = (&str, &Held)> {
        self.held.chunk_by(|a, b| a.place == b.place).flat_map(|group| {
            let place = iter::once(group[0].place.as_str()).chain(iter::repeat(""));
            place.zip(group)
        })
    }

    /// The head of the chapter, with its table as it should be.
    fn head_should_say(&self) -> String {
        let says = text(&self.head);
        let mut table = HEAD.to_owned();
        for (place, it) in self.rows() {
            let _ = writeln!(table, "//! | {place} | {} | `{}` |", it.statement, it.law);
        }
        if !self.beyond.is_empty() {
            let _ = writeln!(table, "//!\n//! {}", self.rest());
        }
        let Some(start) = says.find(HEAD) else {
            let end =
                says.lines().take_while(|line| line.starts_with("//!")).map(|it| it.len() + 1);
            let end = end.sum();
            return format!("{}//!\n{table}{}", &says[..end], &says[end..]);
        };
        let rows = says[start..].lines().take_while(|line| line.starts_with("//! |"));
        let mut end = start + rows.map(|it| it.len() + 1).sum::<usize>();
        if let Some(rest) = says[end..].strip_prefix("//!\n//! Beyond the book: ") {
            end = says.len() - rest.len() + rest.find('\n').expect("the line ends") + 1;
        }
        format!("{}{table}{}", &says[..start], &says[end..])
    }

    /// What else its laws hold, counted.
    fn rest(&self) -> String {
        let of = |(module, count): &(String, usize)| format!("{count} in {module}");
        let all: Vec<String> = self.beyond.iter().map(of).collect();
        format!("Beyond the book: {}.", all.join(", "))
    }

    /// The chapter in docs/book.md.
    fn page(&self) -> String {
        let says = text(&self.head);
        let title = says.lines().next().and_then(|line| line.split_once(": ")).expect("a title").1;
        let mut page =
            format!("\n### Chapter {}: {}\n\n", self.number, title.trim_end_matches('.'));
        page += "| of the book | what is held | by the law |\n| --- | --- | --- |\n";
        for (place, it) in self.rows() {
            let file = it.file.strip_prefix(root()).expect("of the repository").display();
            let name = it.law.rsplit("::").next().unwrap_or_default();
            let _ = writeln!(page, "| {place} | {} | [`{name}`](../{file}) |", it.statement);
        }
        if !self.beyond.is_empty() {
            let _ = writeln!(page, "\n{}", self.rest());
        }
        page
    }
}

fn text(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()))
}

/// Place and law of each row of the table of a head.
fn listed(head: &str) -> Vec<(String, String)> {
    let rows = head.lines().filter_map(|line| line.strip_prefix("//! | ")?.strip_suffix("` |"));
    let cells = rows.filter_map(|row| Some((row.split_once(" | ")?.0, row.rsplit_once('`')?.1)));
    let with_place = cells.scan("", |last, (place, law)| {
        *last = if place.is_empty() { *last } else { place };
        Some((last.to_string(), law.to_owned()))
    });
    with_place.collect()
}

/// The laws of a file that name their place in the book, and how many others there are.
fn laws_of(file: &Path, head: &Path) -> (Vec<Held>, usize) {
    let module = if file == head { None } else { file.file_stem().map(|it| it.to_string_lossy()) };
    let (mut held, mut others, mut doc, mut is_test) = (Vec::new(), 0, String::new(), false);
    for line in text(file).lines().map(str::trim) {
        if let Some(more) = line.strip_prefix("///") {
            doc += more;
            continue;
        }
        if let Some(rest) = line.strip_prefix("fn ") {
            let name = rest.split(['(', '<']).next().unwrap_or_default();
            let law = module.iter().fold(name.to_owned(), |law, module| format!("{module}::{law}"));
            if let Some((says, place)) = doc.split_once(" Book: ") {
                let place = place.trim_end_matches('.').to_owned();
                let statement = first_sentence(says);
                assert!(!statement.is_empty(), "{}: {law} says no law", file.display());
                held.push(Held { place, statement, law, file: file.to_owned() });
            } else {
                others += usize::from(is_test && !name.starts_with('$'));
            }
        }
        is_test |= line == "#[test]";
        if !line.starts_with("#[") {
            doc.clear();
            is_test = false;
        }
    }
    (held, others)
}

/// As [`laws_of`], of the laws whose scenes are files.
fn laws_of_light(table: &Path) -> (Vec<Held>, usize) {
    let data: toml::Table = text(table).parse().unwrap_or_else(|e| panic!("{e}"));
    let laws = data["law"].as_table().expect("a table of laws");
    let held: Vec<Held> = laws
        .iter()
        .filter_map(|(law, it)| {
            let [place, says] = ["book", "says"].map(|field| it.get(field)?.as_str());
            let says: Vec<&str> = says?.split_whitespace().collect();
            let statement = first_sentence(&format!("Law: {}", says.join(" ")));
            let (place, law) = (place?.to_owned(), law.to_owned());
            Some(Held { place, statement, law, file: table.to_owned() })
        })
        .collect();
    let others = laws.len() - held.len();
    (held, others)
}

/// What follows on `Law:`, to the end of its first sentence, as a cell of a table.
fn first_sentence(doc: &str) -> String {
    let law = doc.split_once("Law: ").map_or("", |(_, law)| law);
    let law = law.split("Oracle").next().unwrap_or_default().trim();
    let sentence = law.split_once(". ").map_or(law, |(first, _)| first);
    sentence.trim_end_matches('.').replace('|', "\\|")
}

fn chapters() -> Vec<Chapter> {
    (1..=31).map(Chapter::read).collect()
}

/// Law: each chapter begins with a table of what it holds of the book, and docs/book.md has all of them.
#[test]
fn the_document_of_each_chapter_is_its_laws() {
    let (chapters, map) = (chapters(), text_of("docs/book.md"));
    for chapter in &chapters {
        same_text::hold(&chapter.head, &chapter.head_should_say(), Printed::Exactly);
    }
    let (before, _) = map.split_once(MARK).expect("docs/book.md has the mark");
    let pages: String = chapters.iter().map(Chapter::page).collect();
    let map = root().join("docs/book.md");
    same_text::hold(&map, &format!("{before}{MARK}{pages}"), Printed::Exactly);
}

/// Law: numbers of sections rise along the table of a chapter, and are of that chapter. Oracle: their digits.
#[test]
fn places_of_the_book_are_in_its_order() {
    for chapter in chapters() {
        let number = |place: &str| -> Option<(usize, usize)> {
            let (of, section) = place.split([',', ' ']).next()?.split_once('.')?;
            Some((of.parse().ok()?, section.split('.').next()?.parse().ok()?))
        };
        let numbers: Vec<(usize, usize)> =
            chapter.held.iter().filter_map(|it| number(&it.place)).collect();
        let of = chapter.number;
        assert!(numbers.iter().all(|it| it.0 == of), "chapter {of} has {numbers:?}");
        assert!(numbers.is_sorted(), "chapter {of} has its sections in the order {numbers:?}");
    }
}
