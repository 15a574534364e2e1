//! Every error message of the probe: `errors.txt` has questions (`→`) and their errors (`←`), of which `…` ends a beginning.

use conform::probe;

#[test]
fn errors_say_where_what_and_what_would_fit() {
    let mut lines = include_str!("errors.txt").lines();
    let mut count = 0;
    while let Some(line) = lines.next() {
        let Some(question) = line.strip_prefix('→').map(str::trim_start) else { continue };
        let error = lines.next().and_then(|it| it.strip_prefix("← ")).expect("an error");
        let reply: serde_json::Value =
            serde_json::from_str(&probe::answer(question)).expect("answers are JSON");
        match (error.strip_suffix('…'), reply["error"].as_str()) {
            (Some(start), Some(found)) => assert!(found.starts_with(start), "{question}: {found}"),
            _ => assert_eq!(reply["error"], error, "{question}"),
        }
        count += 1;
    }
    assert!(count > 100, "{count} questions");
}
