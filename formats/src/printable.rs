//! Text of others in messages: names from scene files, and messages that quote them.
//!
//! A terminal obeys control characters and direction marks. Every message shows a name by [`name`], and a
//! whole text of foreign origin by [`text`].

/// The most characters of a name in a message.
pub const LONGEST_NAME: usize = 64;
/// How many of them stand before the `…` of a longer name.
const START: usize = 44;
/// The most characters of a whole message.
pub const LONGEST_TEXT: usize = 1200;

/// A name for a message: control characters and direction marks as `\u{1b}`, the middle of a long one as `…`.
pub fn name(name: &str) -> String {
    shortened(name, LONGEST_NAME, START)
}

/// The first of these names, for the end of a sentence.
pub fn listed(names: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    /// The most names in a message.
    const SHOWN: usize = 12;
    let mut names = names.into_iter();
    let shown: Vec<String> = names.by_ref().take(SHOWN).map(|it| name(it.as_ref())).collect();
    let more = if names.next().is_some() { ", …" } else { "" };
    shown.join(", ") + more
}

/// A text of one line for a message: the same, but much longer.
pub fn text(text: &str) -> String {
    shortened(text, LONGEST_TEXT, LONGEST_TEXT / 2)
}

/// The same character, or what stands for it.
fn escaped(c: char) -> String {
    if is_obeyed(c) { c.escape_unicode().to_string() } else { c.to_string() }
}

/// Whether a terminal or a text field may obey the character instead of showing it.
pub fn is_obeyed(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}'
            | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
            | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

/// The escaped text; of one of more than `most` characters its first `start` and its last ones.
fn shortened(text: &str, most: usize, start: usize) -> String {
    let whole = || text.chars().map(escaped);
    // no more is escaped of a text of megabytes than is needed
    let length: usize = whole().take(most + 1).map(|it| it.chars().count()).sum();
    if length <= most && text.chars().nth(most).is_none() {
        return whole().collect();
    }
    let up_to = |limit: usize, pieces: &mut dyn Iterator<Item = String>| {
        let mut used = 0;
        let fits = pieces.take_while(|piece| {
            used += piece.chars().count();
            used <= limit
        });
        fits.collect::<Vec<String>>()
    };
    let first = up_to(start, &mut whole());
    let mut last = up_to(most - start - 1, &mut text.chars().rev().map(escaped));
    last.reverse();
    format!("{}…{}", first.concat(), last.concat())
}
