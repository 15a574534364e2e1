//! How exact the laws are: their tolerances times a factor.

use std::path::Path;
use std::process::Command;

use anyhow::Result;
use regex::{Captures, Regex};

/// Multiplies the tolerances that stand in the laws of a tree, and counts them.
///
/// They are known by their form: constants of at most ten thousand roundings, what a distance is compared with, and the last
/// number of `near` and `close`. Levels of significance stay.
///
/// # Errors
/// What git and the file system say.
pub fn multiply(tree: &Path, factor: f64) -> Result<usize> {
    let listed =
        Command::new("git").args(["ls-files", "*tests/*.rs"]).current_dir(tree).output()?;
    let mut all = 0;
    for file in String::from_utf8(listed.stdout)?.lines().map(|file| tree.join(file)) {
        let (text, count) = multiplied(&std::fs::read_to_string(&file)?, factor)?;
        all += count;
        if count > 0 {
            std::fs::write(&file, text)?;
        }
    }
    Ok(all)
}

fn multiplied(text: &str, factor: f64) -> Result<(String, usize)> {
    const SMALL: &str = r"[0-9._]+e-[0-9]+";
    /// Small constants that are no tolerances.
    const OTHERS: [&str; 5] = ["LEVEL", "SIGNIFICANCE", "SIZE", "SLOPE", "STEP"];
    let forms = [
        format!(r"(<=? )({SMALL})\b()"),
        format!(r#"(\b(?:near|near_all|close)!?\([^;{{}}]*?, )({SMALL})(\)|,\s*")"#),
        r"(const [A-Z_]{2,}: f64 = )([^;]*(?:e-[0-9]+|\bU\b|EPSILON)[^;]*)()".to_owned(),
    ];
    let mut text = text.to_owned();
    let mut count = 0;
    for form in forms {
        let multiply = |it: &Captures<'_>| {
            if OTHERS.iter().any(|name| it[1].starts_with(&format!("const {name}"))) {
                return it[0].to_owned();
            }
            count += 1;
            format!("{}{factor:?} * ({}){}", &it[1], &it[2], &it[3])
        };
        text = Regex::new(&form)?.replace_all(&text, multiply).into_owned();
    }
    Ok((text, count))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Law: tolerances are multiplied, and no other numbers. Oracle: lines written by hand.
    #[test]
    fn tolerances_are_known_by_their_form() {
        for (before, after) in [
            ("assert!(off < 1e-9, \"{off}\");", "assert!(off < 10.0 * (1e-9), \"{off}\");"),
            ("near!(a.b(c), 2e-3, 1e-12);", "near!(a.b(c), 2e-3, 10.0 * (1e-12));"),
            ("const CLOSE: f64 = 8.0 * U;", "const CLOSE: f64 = 10.0 * (8.0 * U);"),
            ("const LEVEL: f64 = 1e-6;", "const LEVEL: f64 = 1e-6;"),
            ("const WIDTH: f64 = 0.5;", "const WIDTH: f64 = 0.5;"),
            ("let h = 1e-6;", "let h = 1e-6;"),
        ] {
            let (found, _) = multiplied(before, 10.0).expect("the forms are valid");
            assert_eq!(found, after, "{before}");
        }
    }
}
