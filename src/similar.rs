//! Names that are similar to a mistyped one.

/// `; did you mean …?` with similar names; empty if there are none.
pub fn did_you_mean(name: &str, known: &[&str]) -> String {
    let similar = similar_names(name, known);
    let quoted: Vec<String> = similar.iter().map(|known| format!("`{known}`")).collect();
    match &quoted[..] {
        [] => String::new(),
        [one] => format!("; did you mean {one}?"),
        [first @ .., last] => format!("; did you mean {} or {last}?", first.join(", ")),
    }
}

/// The names that begin with `name` (or whose part after a chapter does); if there are none, those
/// with the smallest edit distance to it, if that is at most a third of its length; if there are
/// none, those that contain it. Capital letters are as good as small ones.
fn similar_names<'a>(name: &str, known: &[&'a str]) -> Vec<&'a str> {
    /// Shorter texts are part of too many names.
    const MIN_LENGTH: usize = 3;
    const MAX_SUGGESTIONS: usize = 8;
    let name = name.to_lowercase();
    // as it is, and after the chapter
    let forms = |known: &str| {
        let known = known.to_lowercase();
        let after_chapter = known.split_once('/').map(|(_, rest)| rest.to_owned());
        std::iter::once(known).chain(after_chapter)
    };
    let distance = |known: &str| {
        forms(known).map(|form| edit_distance(&name, &form)).min().unwrap_or(usize::MAX)
    };
    let least = known.iter().map(|known| distance(known)).min().unwrap_or(usize::MAX);
    let is_long = name.len() >= MIN_LENGTH;
    let begins = |known: &str| is_long && forms(known).any(|form| form.starts_with(&name));
    let is_near = |known: &str| least <= name.len() / 3 && distance(known) == least;
    let contains = |known: &str| is_long && known.to_lowercase().contains(&name);
    let ways: [&dyn Fn(&str) -> bool; 3] = [&begins, &is_near, &contains];
    let found = |way: &dyn Fn(&str) -> bool| -> Vec<&'a str> {
        known.iter().copied().filter(|known| way(known)).take(MAX_SUGGESTIONS).collect()
    };
    ways.into_iter().map(found).find(|found| !found.is_empty()).unwrap_or_default()
}

/// The number of bytes that must be inserted, deleted, changed or exchanged with the next one to
/// turn `a` into `b` (the restricted distance of Damerau 1964).
fn edit_distance(a: &str, b: &str) -> usize {
    let (a, b) = (&a.as_bytes()[..a.len().min(100)], b.as_bytes());
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let least = change.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            let is_exchange = i > 1 && j > 1 && a[i - 2..i] == [b[j - 1], b[j - 2]];
            row.push(if is_exchange { least.min(rows[i - 2][j - 2] + 1) } else { least });
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}
