//! The HTML page.

use report::PAGES;

use super::REPORT;

/// The first thing wrong with a text as XML: a tag that is not closed, or closed out of order, an
/// attribute without quotes, a stray `<` or `&`.
fn fault(html: &str) -> Option<String> {
    let body = html.strip_prefix("<!DOCTYPE html>")?;
    let mut open: Vec<&str> = Vec::new();
    let mut rest = body;
    while let Some((text, tagged)) = rest.split_once('<') {
        let entity = |after: &str| after.split_once(';').is_some_and(|(name, _)| name.len() < 8);
        if text.split('&').skip(1).any(|after| !entity(after)) {
            return Some(format!("a stray & in {text:?}"));
        }
        let Some((tag, after)) = tagged.split_once('>') else {
            return Some(format!("a stray < in {:?}", &tagged[..tagged.len().min(40)]));
        };
        rest = after;
        let name = tag.split([' ', '\n']).next().unwrap_or_default();
        if let Some(closed) = tag.strip_prefix('/') {
            let last = open.pop();
            if last != Some(closed) {
                return Some(format!("</{closed}> closes {last:?}"));
            }
        } else {
            if !tag.matches('"').count().is_multiple_of(2)
                || tag.matches('=').count() != quoted(tag)
            {
                return Some(format!("attributes of <{tag}>"));
            }
            if !tag.ends_with('/') {
                open.push(name);
            }
        }
    }
    open.pop().map(|name| format!("<{name}> is not closed"))
}

/// The number of attributes with a quoted value, plus the number of `=` inside such values.
fn quoted(tag: &str) -> usize {
    let inside: usize = tag.split('"').skip(1).step_by(2).map(|v| v.matches('=').count()).sum();
    tag.matches('"').count() / 2 + inside
}

#[test]
fn the_page_is_well_formed() {
    assert_eq!(fault(&REPORT.html), None);
}

/// Law: the checker finds each fault. Oracle: faults by hand.
#[test]
fn faults_are_found() {
    let good = "<!DOCTYPE html><p class=\"a\">1 &lt; 2<br/><img src=\"a==\"/></p>";
    assert_eq!(fault(good), None);
    for bad in ["<p>", "<b><p></b></p>", "<p class=a></p>", "<p>a & b</p>", "</p>", "<p>1 < 2</p>"]
    {
        assert!(fault(&format!("<!DOCTYPE html>{bad}")).is_some(), "{bad}");
    }
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
