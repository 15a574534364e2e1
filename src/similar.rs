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

/// The names that begin with `name` (or whose part after a chapter does); if there are none, those with the
/// smallest edit distance to it, if that is at most a third of its length; if there are none, those that contain
/// it. Capital letters are as good as small ones.
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

/// The number of bytes that must be inserted, deleted or changed to turn `a` into `b` (Levenshtein
/// 1965).
fn edit_distance(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, byte) in a.bytes().take(100).enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, other) in b.bytes().enumerate() {
            let change = diagonal + usize::from(byte != other);
            diagonal = row[j + 1];
            row[j + 1] = change.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Law: beginnings come before similar names, and these before names that contain the mistyped one. Oracle: names,
    /// by hand.
    #[test]
    fn the_likeliest_names_are_suggested() {
        let known =
            ["matte", "sphere_materials", "ch10/near-focus", "ch10/fear", "bvh", "textbook"];
        for (name, hint) in [
            ("mate", "; did you mean `matte`?"),
            ("MATTE", "; did you mean `matte`?"),
            ("materials", "; did you mean `sphere_materials`?"),
            ("near", "; did you mean `ch10/near-focus`?"),
            ("ch10/near", "; did you mean `ch10/near-focus`?"),
            ("BVH", "; did you mean `bvh`?"),
            ("book", "; did you mean `textbook`?"),
            ("e", ""),
            ("halton", ""),
        ] {
            assert_eq!(did_you_mean(name, &known), hint, "{name}");
        }
    }
}
