//! The card as one HTML page.

use std::fmt::Write;

use super::text::{conventions, failed, failures, order, rest};
use super::{Card, Row, Status};
use pictures::digits::short;
use pictures::html::{self, escaped};
use pictures::told::Told;

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
    let mut html = format!(
        "<p>Profile {}, seed {}{}.</p>\n",
        card.profile.name(),
        card.seed,
        if card.is_whole { "" } else { "; interrupted" },
    );
    for (kind, title) in TITLES.into_iter().enumerate() {
        let rows: Vec<&&Row> = failures.iter().filter(|row| order(row) == kind).collect();
        if !rows.is_empty() {
            let _ = writeln!(html, "<h2>{title}</h2>");
        }
        rows.into_iter().for_each(|row| failure(&mut html, row));
    }
    let by_the_book: String = card.rows.iter().map(conventions).collect();
    if !by_the_book.is_empty() {
        let lines = escaped(&by_the_book);
        let _ = writeln!(html, "<h2>Conventions of the book</h2>\n<pre>{lines}</pre>");
    }
    html += &tables(card);
    for line in rest(card).lines() {
        let _ = writeln!(html, "<p>{}</p>", escaped(line));
    }
    // the page has the details in its own order
    let told = Told { details: String::new(), ..told.clone() };
    told.page(&about, &[html::LINES, html::NUMBERS, html::CARD], &html)
}

/// What failed in a family, and its questions for a program of ours.
fn failure(html: &mut String, row: &Row) {
    let name = escaped(&row.name);
    let _ = writeln!(html, "<h3 id=\"{name}\">{name}</h3>\n<pre>{}</pre>", escaped(&failed(row)));
    if let Some(failure) = &row.failure {
        let asked: Vec<String> =
            failure.asked.iter().map(|(question, _)| question.to_string()).collect();
        let lines = escaped(&asked.join("\n"));
        let _ = writeln!(html, "<p>For <code>groundtruth probe</code>:</p>\n<pre>{lines}</pre>");
    }
}

/// The families of each chapter that answered something, failures first; only statuses that there are.
fn tables(card: &Card) -> String {
    let is_there = |status: &Status| *status != Status::Unsupported && card.count(*status) > 0;
    let columns: Vec<Status> = Status::ALL.into_iter().filter(is_there).collect();
    if columns.is_empty() {
        return String::new();
    }
    let mut html = "<h2>Families</h2>\n<p>The error of the worst right answer is in u·cond: the rounding error that \
                    double precision cannot avoid in this question. · is nothing, or nothing measured.</p>\n"
        .to_owned();
    for (chapter, rows) in card.chapters() {
        let has_counts = |row: &&&Row| columns.iter().any(|status| row.count(*status) > 0);
        let mut rows: Vec<&&Row> = rows.iter().filter(has_counts).collect();
        rows.sort_by_key(|row| if row.is_failed() { order(row) } else { TITLES.len() });
        if !rows.is_empty() {
            let _ = writeln!(html, "<h3>{chapter}</h3>");
            table(&mut html, &rows, &columns);
        }
    }
    html
}

fn table(html: &mut String, rows: &[&&Row], columns: &[Status]) {
    html.push_str("<div class=\"wide\"><table>\n<tr><th>family</th>");
    for status in columns {
        let _ = write!(html, "<th>{}</th>", status.name());
    }
    html.push_str("<th>worst right answer, u·cond</th></tr>\n");
    for row in rows {
        let (name, class) = (escaped(&row.name), if row.is_failed() { "failed" } else { "" });
        let shown = match row.is_failed() {
            true => format!("<a href=\"#{name}\">{name}</a>"),
            false => name,
        };
        let _ = write!(html, "<tr class=\"{class}\"><td>{shown}</td>");
        for status in columns {
            let _ = match row.count(*status) {
                0 => write!(html, "<td class=\"quiet\">·</td>"),
                count => write!(html, "<td>{count}</td>"),
            };
        }
        let _ = match row.worst {
            0.0 => writeln!(html, "<td class=\"quiet\">·</td></tr>"),
            worst => writeln!(html, "<td>{}</td></tr>", short(worst)),
        };
    }
    html.push_str("</table></div>\n");
}
