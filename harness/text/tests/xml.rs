//! Text in XML.

use text::xml::*;

/// Whether the specification lets a document hold the number of a character. Oracle of the laws: the table of
/// section 2.2, as numbers.
fn may_stand(c: char) -> bool {
    let n = u32::from(c);
    [9, 10, 13].contains(&n)
        || [(0x20, 0xd7ff), (0xe000, 0xfffd), (0x1_0000, 0x10_ffff)]
            .iter()
            .any(|(first, last)| (*first..=*last).contains(&n))
}

/// All characters of the planes in which any is special, and the last one.
fn characters() -> impl Iterator<Item = char> {
    ('\0'..='\u{1ffff}').chain('\u{e0000}'..='\u{e0fff}').chain(['\u{10ffff}'])
}

/// The value that a reader finds in an attribute: references put back, by section 3.3.3.
fn read(value: &str) -> String {
    let references = [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&#10;", "\n"),
        ("&#9;", "\t"),
        ("&amp;", "&"),
    ];
    references.iter().fold(value.to_owned(), |text, (from, to)| text.replace(from, to))
}

/// Law: of every character there is, an attribute is well formed, and reads as the character or its number. Oracle:
/// the rules of the specification, read apart from the writer.
#[test]
fn every_character_can_stand_in_an_attribute() {
    for c in characters() {
        let written = attribute(&c.to_string());
        assert!(written.chars().all(may_stand) && !written.contains(['<', '"', '\n', '\t']));
        let number = format!("\\u{{{:x}}}", u32::from(c));
        let found = read(&written);
        assert!(found == c.to_string() || found == number, "{c:?}: {written}");
    }
    assert_eq!(attribute("a&amp;\u{fffe}"), "a&amp;amp;\\u{fffe}");
}

/// Law: a comment ends where it ends, whatever is in it: no two hyphens inside, none before the end, every character
/// allowed. Oracle: section 2.5, over every character and runs of hyphens.
#[test]
fn a_comment_ends_at_its_end_only() {
    let single = characters().map(|c| c.to_string());
    let runs = ["-", "--", "---", "a --- b", "a-->b", "-->", "--!>", "->", "- -", "-\u{0}-"];
    for text in single.chain(runs.map(str::to_owned)) {
        let written = comment(&text);
        let inner = written.strip_prefix("<!--").and_then(|it| it.strip_suffix("-->"));
        let inner = inner.expect("its ends");
        assert!(!inner.contains("--") && !inner.ends_with('-'), "{text:?}: {written}");
        assert!(written.chars().all(may_stand), "{text:?}");
    }
}
