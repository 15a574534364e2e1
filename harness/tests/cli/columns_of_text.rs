//! Lines broken to fit.

#[path = "../../cli/columns.rs"]
#[allow(dead_code)] // the commands use the rest of it
pub mod columns;

use self::columns::wrapped;

/// Law: no line is longer than asked, unless it is one word; the words are the same, in their order. Oracle: the
/// words of the text.
#[test]
fn broken_lines_fit_and_keep_their_words() {
    let text = "  100 %  0  camera\n      at [0.1, 0.2], front, material \"a b\"\n\n".repeat(3)
        + &" ".repeat(90)
        + "deep inside, and a word_that_is_longer_than_the_line_that_it_stands_in\nend";
    for columns in [20, 41, 60, 100] {
        let broken = wrapped(&text, columns);
        for line in broken.lines() {
            let fits = line.chars().count() <= columns;
            assert!(fits || line.split_whitespace().count() == 1, "{columns}: {line}");
        }
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(words(&broken), words(&text));
    }
    let short = "a  b\n  c\n";
    assert_eq!(wrapped(short, 100), short);
}
