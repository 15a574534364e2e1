//! The HTML page.

use report::PAGES;

use super::REPORT;
use testkit::markup::fault;

/// Law: the page is well-formed XML. Oracle: tags, attributes and entities, checked one by one.
#[test]
fn the_page_is_well_formed() {
    assert_eq!(fault(&REPORT.html), None);
}

/// Law: the page is self-contained: no script, no other file, nothing from the network.
#[test]
fn the_page_needs_nothing_beside_it() {
    let html = &REPORT.html;
    for outside in ["<script", "<link", "<iframe", "@import", "url("] {
        assert!(!html.contains(outside), "{outside}");
    }
    // pictures are inside it
    for source in html.split("src=").skip(1) {
        assert!(source.starts_with("\"data:image/png;base64,"), "{}", &source[..40]);
    }
    let targets = html.split("href=\"").skip(1);
    let mut count = 0;
    for target in targets.filter_map(|rest| rest.split_once('"').map(|(target, _)| target)) {
        count += 1;
        let place = target.strip_prefix('#').expect("links stay on the page");
        assert!(html.contains(&format!("id=\"{place}\"")), "{target}");
    }
    assert_eq!(count, PAGES.len());
}

/// Law: each page states its question, recommends a choice, and has a diagram and a table.
#[test]
fn every_page_says_what_to_pick() {
    for page in PAGES {
        let start = format!("<section id=\"{}\">", page.name);
        let (_, rest) = REPORT.html.split_once(&start).expect("its section is there");
        let (section, _) = rest.split_once("</section>").expect("it ends");
        let question = format!("<p class=\"question\">{}</p>", page.question);
        for part in [page.title, &question, "What to pick.", "<svg", "<table>"] {
            assert!(section.contains(part), "{}: {part}", page.name);
        }
        let text = section.split("</style>").last().unwrap_or_default();
        assert!(!text.contains("NaN") && !text.contains(">inf"), "{}", page.name);
    }
}
