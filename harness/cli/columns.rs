//! Text for a terminal of some columns: long lines are broken at spaces, and go on a little further in.

/// The least columns that are left of a line that is indented far.
const LEAST: usize = 40;
/// How much further in a broken line goes on.
const FURTHER: usize = 4;

/// The text with no line of more characters than `columns`, where a line has a space to break it at.
pub fn wrapped(text: &str, columns: usize) -> String {
    text.split_inclusive('\n').map(|line| wrapped_line(line, columns)).collect()
}

fn wrapped_line(line: &str, columns: usize) -> String {
    let words = line.trim_start_matches(' ');
    let indent = (line.len() - words.len()).min(columns.saturating_sub(LEAST));
    let mut text = " ".repeat(indent);
    let mut used = indent;
    // two spaces between the parts of a line are kept, unless it is broken there
    for (index, word) in words.trim_end().split(' ').enumerate() {
        let length = word.chars().count();
        if index > 0 && used + 1 + length > columns && !word.is_empty() {
            text.truncate(text.trim_end().len());
            text += &format!("\n{}", " ".repeat(indent + FURTHER));
            used = indent + FURTHER;
        } else if index > 0 {
            text.push(' ');
            used += 1;
        }
        text += word;
        used += length;
    }
    text.truncate(text.trim_end().len());
    text + &line[line.trim_end().len()..]
}
