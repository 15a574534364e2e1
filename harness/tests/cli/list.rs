//! `groundtruth list`.

use std::path::Path;

use super::run_in;

/// Law: a number names a chapter, another word is in the name or the description of each scene; words that no scene has
/// are named. Oracle: the whole list.
#[test]
fn list_finds_words_of_names_and_descriptions() {
    let list = |words: &[&str]| run_in(Path::new("."), &[&["list"], words].concat()).stdout;
    let words = |text: &str| -> Vec<String> {
        text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
    };
    let whole = words(&list(&[]));
    let expected = |fits: &dyn Fn(&str) -> bool| {
        let lines: Vec<String> = whole.iter().filter(|line| fits(line)).cloned().collect();
        assert!(!lines.is_empty());
        lines
    };
    for (arguments, fits) in [
        (&["28"][..], &(|line: &str| line.starts_with("ch28/")) as &dyn Fn(&str) -> bool),
        (&["FRESNEL"], &|line| line.to_lowercase().contains("fresnel")),
        (&["26.12"], &|line| line.contains("figure 26.12")),
        (&["ch26", "noisy"], &|line| line.starts_with("ch26/") && line.contains("noisy")),
    ] {
        assert_eq!(words(&list(arguments)), expected(fits), "{arguments:?}");
    }
    let run = run_in(Path::new("."), &["list", "fresnel", "unheard-of"]);
    assert_eq!(run.status, Some(2));
    let error = "error: no scene has `fresnel unheard-of` in its name and description\n";
    assert_eq!(run.stderr, error);
}
