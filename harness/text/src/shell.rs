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

/// A command line: each word quoted where it has to be.
pub fn line<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    words.into_iter().map(quoted).collect::<Vec<_>>().join(" ")
}
