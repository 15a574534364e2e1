//! Commands that are pasted into a shell.

use std::process::Command;

use groundtruth::printable;
use text::shell::*;

/// 240 names of pieces that a shell may take for something else.
fn names() -> Vec<String> {
    const PIECES: [&str; 24] = [
        "a b",
        "'",
        "\"",
        "$(echo x)",
        "`echo x`",
        "\n",
        "-rf",
        "é",
        "\u{1b}[2J",
        "\u{202e}",
        "\\",
        "$HOME",
        "~",
        "*",
        "?",
        "[a]",
        ";",
        "&",
        "|",
        "#",
        "!1",
        "=ls",
        "\t\r",
        "{a,b}",
    ];
    let pairs = PIECES.iter().enumerate().flat_map(|(index, first)| {
        (0..10).map(move |step| format!("{first}{}", PIECES[(index + 7 * step) % PIECES.len()]))
    });
    pairs.collect()
}

/// Law: a shell reads each of 240 hostile names as it is, alone and in a list, and nothing of them is run; what is
/// printed has no character that a terminal obeys except ends of lines. Oracle: `sh`, whose arguments `printf`
/// repeats.
#[test]
fn a_shell_reads_each_name_as_it_is() {
    let names = names();
    assert_eq!(names.len(), 240);
    let words: Vec<String> = names.iter().map(|name| quoted(name)).collect();
    let said = words.concat();
    assert!(!said.chars().any(|c| c != '\n' && printable::is_obeyed(c)));
    let command = format!("printf '%s\\0' {} ''", words.join(" "));
    let run = Command::new("sh").args(["-c", &command]).output().expect("it starts");
    assert!(run.stderr.is_empty(), "{}", String::from_utf8_lossy(&run.stderr));
    let read = String::from_utf8(run.stdout).expect("UTF-8");
    let read: Vec<&str> = read.split('\0').collect();
    assert_eq!(read[..240], names);
    assert_eq!(read[240..], ["", ""]);
    assert_eq!(quoted(""), "''");
}
