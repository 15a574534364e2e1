//! The card as one HTML page.

use std::fmt::Write;

use super::text::{conventions, failed};
use super::{Card, Row, Status};
use pictures::html::{self, escaped};

/// The page for a program with this command line.
pub fn page(card: &Card, command: &str) -> String {
    let title = format!("conform: {}", escaped(command));
    let mut html = format!(
        "<h1>{title}</h1>\n<p>Profile {}, seed {}{}.</p>\n",
        card.profile.name(),
        card.seed,
        if card.is_whole { "" } else { "; interrupted" },
    );
    let is_shown = |row: &&Row| row.is_failed() || row.ours > 0;
    let failures: Vec<&Row> = card.rows.iter().filter(is_shown).collect();
    html.push_str("<h2>Families</h2>\n");
    for (chapter, rows) in card.chapters() {
        let _ = writeln!(html, "<h3>{chapter}</h3>");
        table(&mut html, &rows);
    }
    html.push_str("<h2>Failures</h2>\n");
    if failures.is_empty() {
        html.push_str("<p>None.</p>\n");
    }
    for row in failures {
        let name = escaped(&row.name);
        let _ =
            writeln!(html, "<h3 id=\"{name}\">{name}</h3>\n<pre>{}</pre>", escaped(&failed(row)));
        if let Some(failure) = &row.failure {
            let asked: Vec<String> =
                failure.asked.iter().map(|(question, _)| question.to_string()).collect();
            let lines = escaped(&asked.join("\n"));
            let _ =
                writeln!(html, "<p>For <code>groundtruth probe</code>:</p>\n<pre>{lines}</pre>");
        }
    }
    let by_the_book: String = card.rows.iter().map(conventions).collect();
    if !by_the_book.is_empty() {
        let lines = escaped(&by_the_book);
        let _ = writeln!(html, "<h2>Conventions of the book</h2>\n<pre>{lines}</pre>");
    }
    html::page(&title, &[html::LINES, html::NUMBERS, html::CARD], &html)
}

fn table(html: &mut String, rows: &[&Row]) {
    html.push_str("<table>\n<tr><th>family</th>");
    for status in Status::ALL {
        let _ = write!(html, "<th>{}</th>", status.name());
    }
    html.push_str("<th>largest error, u·cond</th></tr>\n");
    for row in rows {
        let (name, class) = (escaped(&row.name), if row.is_failed() { "failed" } else { "" });
        let shown = match row.is_failed() {
            true => format!("<a href=\"#{name}\">{name}</a>"),
            false => name,
        };
        let _ = write!(html, "<tr class=\"{class}\"><td>{shown}</td>");
        for status in Status::ALL {
            let count = row.count(status);
            let class = if count == 0 { "quiet" } else { "" };
            let _ = write!(html, "<td class=\"{class}\">{count}</td>");
        }
        let _ = writeln!(html, "<td>{:.2}</td></tr>", row.worst);
    }
    html.push_str("</table>\n");
}
