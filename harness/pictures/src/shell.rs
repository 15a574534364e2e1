//! Commands to be pasted into a shell: the only place that quotes their arguments.

use groundtruth::printable;

/// An argument as every POSIX shell reads it, without a character that a terminal obeys except the end of a line.
///
/// A control character or a direction mark becomes `"$(printf '\033')"`, the bytes of its UTF-8 in octal. The end of a
/// line stays as it is between quotes: `$(…)` would drop it at the end.
pub fn quoted(argument: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-+=:,@%".contains(c);
    // a leading = names a program in zsh
    if !argument.is_empty() && !argument.starts_with('=') && argument.chars().all(is_plain) {
        return argument.to_owned();
    }
    let mut text = String::from("'");
    for c in argument.chars() {
        match c {
            '\'' => text += "'\\''",
            '\n' => text.push(c),
            c if printable::is_obeyed(c) => {
                let octal: String =
                    c.to_string().bytes().map(|byte| format!("\\{byte:03o}")).collect();
                text += &format!("'\"$(printf '{octal}')\"'");
            }
            c => text.push(c),
        }
    }
    text + "'"
}

#[cfg(all(test, unix))]
mod tests {
    use std::process::Command;

    use super::*;

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
}
