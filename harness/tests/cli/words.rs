//! Long renderings are announced, and lines broken to fit.

#[path = "../../cli/announce.rs"]
#[allow(dead_code)] // the commands use the rest of it
mod announce;
#[path = "../../cli/columns.rs"]
#[allow(dead_code)] // the commands use the rest of it
mod columns;

use self::announce::words;
use self::columns::wrapped;

/// Law: renderings of at least 5 s are announced; below 90 s in seconds, below 90 min in minutes, else in hours,
/// rounded; and how often, if that is more than once. Oracle: the rounding, for times on both sides of each border.
#[test]
fn announced_times_are_rounded_in_their_unit() {
    for (seconds, expected) in [
        (0.0, None),
        (4.999, None),
        (5.0, Some("5 s")),
        (5.6, Some("6 s")),
        (89.4, Some("89 s")),
        (90.0, Some("2 min")),
        (89.9, Some("90 s")),
        (149.0, Some("2 min")),
        (151.0, Some("3 min")),
        (5399.0, Some("90 min")),
        (5400.0, Some("2 h")),
        (9001.0, Some("3 h")),
        (36_000.0, Some("10 h")),
    ] {
        for pictures in [1, 2, 16] {
            let found = words("a/b", pictures, [3, 4], seconds);
            let times = if pictures == 1 { String::new() } else { format!("{pictures} times ") };
            let expected = expected.map(|it| {
                format!("a/b is rendered {times}at the size of the picture, 3 × 4: about {it}")
            });
            assert_eq!(found, expected, "the note for {seconds} s and {pictures} pictures");
        }
    }
}

/// Law: a line is broken only where the next word would not fit, and goes on four spaces further in; a line that just
/// fits is left as it is. Oracle: the lengths of lines and words; all widths from 50 to 70 for texts of words of one to
/// nine letters.
#[test]
fn lines_are_broken_only_where_they_must() {
    let mut text = "  ".to_owned();
    for index in 0..60 {
        text += &"abcdefghi"[..1 + (index * 7 + index / 9) % 9];
        text.push(' ');
    }
    let text = text.trim_end().to_owned() + "\n";
    for columns in 50..70 {
        let broken = wrapped(&text, columns);
        let lines: Vec<&str> = broken.lines().collect();
        assert!(lines.len() > 3, "lines of {columns} columns: {}", lines.len());
        for (at, pair) in lines.windows(2).enumerate() {
            let [line, next] = [pair[0], pair[1]];
            let indent = next.len() - next.trim_start().len();
            assert_eq!(indent, 6, "the indent of line {} of {columns} columns", at + 1);
            let word = next.split_whitespace().next().expect("a word");
            let with_it = line.chars().count() + 1 + word.chars().count();
            assert!(with_it > columns, "`{word}` fits into `{line}` of {columns} columns");
            assert!(line.chars().count() <= columns, "`{line}` has more than {columns} columns");
        }
    }
    for length in [58, 59, 60] {
        let line = format!("{} end", "x".repeat(length - 4));
        assert_eq!(wrapped(&line, 60), line, "a line of {length} columns in 60");
    }
    let line = format!("{} end", "x".repeat(57));
    assert_eq!(wrapped(&line, 60), format!("{}\n    end", "x".repeat(57)), "a line of 61 in 60");
}
