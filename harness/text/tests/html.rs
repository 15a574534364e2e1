//! Text in pages.

use groundtruth::printable;
use text::html::*;

/// Law: of every character of the planes in which any is special, no markup is left, none that is obeyed, and what is shown is the character or
/// its number. Oracle: the references that HTML defines, put back.
#[test]
fn every_character_is_shown_and_none_is_obeyed() {
    let references = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&amp;", "&")];
    for c in ('\0'..='\u{1ffff}').chain('\u{e0000}'..='\u{e0fff}').chain(['\u{10ffff}']) {
        let html = escaped(&c.to_string());
        assert!(!html.contains(['<', '>', '"']), "{c:?}: {html}");
        assert!(!html.chars().any(|c| !"\n\t".contains(c) && printable::is_obeyed(c)));
        let put_back = references.iter().fold(html, |text, (from, to)| text.replace(from, to));
        let number = format!("\\u{{{:x}}}", u32::from(c));
        assert!(put_back == c.to_string() || put_back == number, "{c:?}: {put_back}");
    }
}
