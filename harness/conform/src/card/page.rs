//! The card as one HTML page.

use super::text::{conventions, failed, failures, order, rest};
use super::{Card, Row, Status};
use text::digits::short;
use text::document::*;
use text::html;
use text::told::Told;

/// The titles of the kinds of failures, in their order.
const TITLES: [&str; 4] = [
    "Named mistakes",
    "Wrong, without a name",
    "Wrong, but fair in single precision",
    "Refused, without an answer, or not judged",
];

/// The page for a program with this command line, of which this is told.
pub fn page(card: &Card, told: &Told, command: &str) -> String {
    let (about, failures) = (format!("conform -- {command}"), failures(card));
    let interrupted = if card.is_whole { "" } else { "; interrupted" };
    let profile = format!("Profile {}, seed {}{interrupted}.", card.profile.name(), card.seed);
    let of_kind = |(kind, title): (usize, &str)| {
        let rows = || failures.iter().filter(|row| order(row) == kind);
        let title = rows().next().map(|_| heading(2, title));
        several().with_all(title).with_all(rows().map(|row| failure(row)))
    };
    let by_the_book: String = card.rows.iter().map(conventions).collect();
    let by_the_book = (!by_the_book.is_empty())
        .then(|| several().with(heading(2, "Conventions of the book")).with(lines(by_the_book)));
    let body = several()
        .with(paragraph(profile))
        .with_all(TITLES.into_iter().enumerate().map(of_kind))
        .with_all(by_the_book)
        .with(tables(card))
        .with_all(rest(card).lines().map(paragraph));
    // the page has the details in its own order
    let told = Told { details: String::new(), ..told.clone() };
    told.page(&about, &[html::LINES, html::NUMBERS, html::CARD], &body.html())
}

/// What failed in a family, and its questions for a program of ours.
fn failure(row: &Row) -> Element {
    let title = heading(3, &row.name).attribute("id", &row.name);
    let asked = row.failure.iter().map(|failure| {
        let asked: Vec<String> =
            failure.asked.iter().map(|(question, _)| question.to_string()).collect();
        several()
            .with(paragraph("For ").with(code("groundtruth probe")).with(":"))
            .with(lines(asked.join("\n")))
    });
    several().with(title).with(lines(failed(row))).with_all(asked)
}

/// The families of each chapter that answered something, failures first; only statuses that there are.
fn tables(card: &Card) -> Element {
    const WORDS: &str = "The error of the worst right answer is in u·cond: the rounding error that double precision cannot \
         avoid in this question. · is nothing, or nothing measured.";
    let is_there = |status: &Status| *status != Status::Unsupported && card.count(*status) > 0;
    let columns: Vec<Status> = Status::ALL.into_iter().filter(is_there).collect();
    if columns.is_empty() {
        return several();
    }
    let chapter = |(chapter, rows): (&str, Vec<&Row>)| {
        let has_counts = |row: &&Row| columns.iter().any(|status| row.count(*status) > 0);
        let mut rows: Vec<&Row> = rows.into_iter().filter(has_counts).collect();
        rows.sort_by_key(|row| if row.is_failed() { order(row) } else { TITLES.len() });
        match rows.is_empty() {
            true => several(),
            false => several().with(heading(3, chapter)).with(families(rows, &columns)),
        }
    };
    several()
        .with(heading(2, "Families"))
        .with(paragraph(WORDS))
        .with_all(card.chapters().into_iter().map(|(name, rows)| chapter((name, rows))))
}

fn families(rows: Vec<&Row>, columns: &[Status]) -> Element {
    let or_nothing = |text: Option<String>| match text {
        None => Node::from(span("quiet", "·")),
        Some(text) => text.into(),
    };
    let mut table = table(rows).column("family", |row| match row.is_failed() {
        true => element("a").attribute("href", format!("#{}", row.name)).with(&row.name),
        false => several().with(&row.name),
    });
    for status in columns {
        table = table.column(status.name(), |row| {
            or_nothing(Some(row.count(*status)).filter(|it| *it > 0).map(|it| it.to_string()))
        });
    }
    table
        .column("worst right answer, u·cond", |row| {
            or_nothing(Some(row.worst).filter(|it| *it != 0.0).map(short))
        })
        .classes(|row| if row.is_failed() { "failed" } else { "" })
        .element()
}
