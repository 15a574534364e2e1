//! Points, counted from a table by hand; and the borders of what a table may say.

use std::collections::BTreeSet;
use std::sync::Arc;

use conform::family::Family;
use conform::grade::{Grade, Table, results, with_row};
use conform::{Reply, Subject, ours};
use serde_json::{Value, json};

/// A table of these parts, in hundredths of points, asked with four cases.
fn table(parts: &[(&str, u64)]) -> Table {
    let part = |(word, hundredths): &(&str, u64)| {
        let points = *hundredths as f64 / 100.0;
        format!("[[part]]\nname = {word:?}\nask = [{word:?}]\npoints = {points}\n")
    };
    let parts: String = parts.iter().map(part).collect();
    read(&format!("seed = 4815162342\ncases = 4\n{parts}")).expect("valid")
}

fn read(text: &str) -> Result<Table, String> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("table.toml");
    std::fs::write(&path, text).expect("it is written");
    Table::read(&path).map_err(|error| error.to_string())
}

/// Answers as we do, but not one of the cases of some families.
struct Failing(BTreeSet<String>);

impl Failing {
    /// Fails the case of this number of each of these families.
    fn at(table: &Table, families: &BTreeSet<&str>, case: usize) -> Self {
        let is_bad = |family: &&Family| families.contains(&*family.name);
        let one = |family: &Family| (family.cases)(table.seed, 4)[case].to_string();
        Self(table.families.iter().filter(is_bad).map(one).collect())
    }
}

impl Subject for Failing {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| match self.0.contains(&question.to_string()) {
            true => Reply::Answer(json!("wrong")),
            false => ours(question).map_or_else(Reply::Refused, Reply::Answer),
        };
        questions.iter().map(reply).collect()
    }
}

/// Points as students read them: two decimals, and none of a whole number.
fn shown(hundredths: u64) -> String {
    match (hundredths / 100, hundredths % 100) {
        (whole, 0) => whole.to_string(),
        (whole, rest) => format!("{whole}.{rest:02}"),
    }
}

/// Law: a family counts if all of its answers are right; a part gives its points times the share of its families that count, in
/// hundredths, rounded down; the total is the sum; and the text, the table of a class, Gradescope's file and the teacher's JSON
/// say the same (docs/grade.md). Oracle: whole numbers of hundredths, for each number of families with one wrong answer,
/// which is the first, the second or the last of them.
#[test]
fn points_are_those_counted_by_hand() {
    let parts = [("fresnel", 1000), ("map", 29), ("transform", 733), ("mapping", 10_001)];
    let table = table(&parts);
    let of = |word: &str| -> Vec<&str> {
        let part = table.parts.iter().find(|part| part.name == word).expect("a part");
        part.families.iter().map(String::as_str).collect()
    };
    let most = parts.iter().map(|(word, _)| of(word).len()).max().expect("four parts");
    assert!(most >= 4, "the largest part has {most} families");
    for bad in 0..=most {
        let families: BTreeSet<&str> =
            parts.iter().flat_map(|(word, _)| of(word).into_iter().take(bad)).collect();
        let case = [0, 1, 3][bad % 3];
        let mut subject = Failing::at(&table, &families, case);
        let grade = Grade::of(&mut subject, &table, Arc::default(), &mut |_| {});
        let expected = parts.map(|(word, points)| {
            let (all, wrong) = (of(word).len() as u64, bad.min(of(word).len()) as u64);
            points * (all - wrong) / all
        });
        let found = grade.parts.iter().map(|part| (part.points * 100.0).round() as u64);
        let found: Vec<u64> = found.collect();
        assert_eq!(found, expected, "hundredths of points, {bad} families of each part wrong");
        let failed: Vec<usize> = grade.parts.iter().map(|part| part.failed()).collect();
        let expected_failed = parts.map(|(word, _)| bad.min(of(word).len()));
        assert_eq!(failed, expected_failed, "failed families of each part");
        let total: u64 = expected.iter().sum();
        assert_eq!(grade.points(), total as f64 / 100.0, "the total");
        assert_eq!((grade.most(), table.points()), (117.63, 117.63), "the most");
        assert_eq!(grade.is_full(), bad == 0, "full points with {bad} families wrong");
        said(&grade, &expected, &parts, failed.iter().sum());
    }
}

/// The forms of a grade say these hundredths of points.
fn said(grade: &Grade, points: &[u64; 4], parts: &[(&str, u64); 4], failed: usize) {
    let total = shown(points.iter().sum());
    let text = grade.text();
    let lines =
        parts.iter().zip(points).map(|((word, most), got)| (*word, shown(*got), shown(*most)));
    for (name, got, most) in lines.chain([("total", total.clone(), shown(11_763))]) {
        let line = text.lines().find(|line| line.starts_with(name)).expect("a line of each part");
        let found: Vec<&str> = line.split_whitespace().skip(1).collect();
        assert_eq!(found, [&*got, "of", &*most], "points of {name} in\n{text}");
    }
    let class = with_row("", "Ada", grade).expect("a new table");
    let each = points.map(shown).join(",");
    let row = class.lines().nth(1).expect("a line of the student");
    assert_eq!(row, format!("Ada,{total},{each},{failed},0,"), "the row of the class");
    let results = results(grade);
    let tests = results["tests"].as_array().expect("tests");
    for ((test, got), (word, most)) in tests.iter().zip(points).zip(parts) {
        let found = (test["score"].as_f64(), test["max_score"].as_f64(), test["status"].as_str());
        let status = if got == most { "passed" } else { "failed" };
        let expected = (Some(*got as f64 / 100.0), Some(*most as f64 / 100.0), Some(status));
        assert_eq!(found, expected, "score, most and status of {word}");
    }
    assert_eq!(results["score"].as_f64(), Some(grade.points()), "the score of all");
    let json = grade.json();
    let worths = |part: &Value| -> f64 {
        let families = part["families"].as_array().expect("families").iter();
        families.filter_map(|it| it["worth"].as_f64()).sum()
    };
    for (part, of) in json["parts"].as_array().expect("parts").iter().zip(&grade.parts) {
        let count = part["families"].as_array().map_or(0, Vec::len) as f64;
        let expected = count - of.failed() as f64;
        assert_eq!(worths(part), expected, "families of {} that count", of.name);
    }
}

/// Law: what is not answered to its end counts nothing: unsupported, refused, silent after the first answer. Oracle: 0 of 10.
#[test]
fn what_is_not_answered_counts_nothing() {
    struct After(usize, Reply);
    impl Subject for After {
        fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
            let mut one = |question: &Value| {
                self.0 = self.0.saturating_sub(1);
                if self.0 > 0 {
                    Reply::Answer(ours(question).expect("an answer"))
                } else {
                    self.1.clone()
                }
            };
            questions.iter().map(&mut one).collect()
        }
    }
    let table = table(&[("fresnel.cosine", 1000)]);
    let fault = || Reply::Fault(conform::Fault::Died("a crash".to_owned()));
    // an easy question and four cases
    for (answered, reply, expected) in [
        (5, Reply::Refused("no".to_owned()), 10.0),
        (4, Reply::Refused("no".to_owned()), 0.0),
        (4, Reply::Unsupported("no".to_owned()), 0.0),
        (4, fault(), 0.0),
        (1, fault(), 0.0),
        (2, Reply::NotAsked, 0.0),
    ] {
        let mut subject = After(answered + 1, reply.clone());
        let grade = Grade::of(&mut subject, &table, Arc::default(), &mut |_| {});
        assert_eq!(grade.points(), expected, "points with {answered} answers, then {reply:?}");
    }
}

/// Law: the seed of a table is at least 1,000,000, its cases are 4 to 10,000 and 48 if left out, the points of a part above 0
/// and at most a million. Oracle: the numbers on both sides of each border.
#[test]
fn a_table_has_the_borders_that_it_says() {
    let text = |seed: &str, cases: &str, points: &str| {
        format!(
            "seed = {seed}\n{cases}\n[[part]]\nname = \"A\"\nask = [\"fresnel\"]\npoints = {points}\n"
        )
    };
    for (seed, fits) in
        [("999999", false), ("1000000", true), ("9223372036854775807", true), ("-1000000", false)]
    {
        let found = read(&text(seed, "", "1"));
        assert_eq!(found.is_ok(), fits, "seed = {seed}: {:?}", found.err());
    }
    for (cases, fits) in [(3, false), (4, true), (10_000, true), (10_001, false)] {
        let found = read(&text("1000000", &format!("cases = {cases}"), "1"));
        assert_eq!(found.as_ref().map(|table| table.cases).ok(), fits.then_some(cases), "cases");
    }
    let table = read(&text("1000000", "", "1")).expect("valid");
    assert_eq!((table.cases, table.seed), (48, 1_000_000), "cases and seed");
    for (points, fits) in [
        ("0", false),
        ("-0.01", false),
        ("0.01", true),
        ("1e6", true),
        ("1000000.01", false),
        ("inf", false),
    ] {
        let found = read(&text("1000000", "", points));
        assert_eq!(found.is_ok(), fits, "points = {points}: {:?}", found.err());
    }
}

/// Law: the rows of a class are sorted by name, one for each, the last that was written, whatever the order of writing.
/// Oracle: a sorted map of names.
#[test]
fn a_class_is_sorted_whatever_the_order() {
    let table = table(&[("fresnel.cosine", 1000)]);
    let grades = [0, 1].map(|bad| {
        let families: BTreeSet<&str> = ["fresnel.cosine"].into_iter().take(bad).collect();
        let mut subject = Failing::at(&table, &families, 0);
        Grade::of(&mut subject, &table, Arc::default(), &mut |_| {})
    });
    let names = ["Zoe", "Ada", "Bob \"B\"", "Ann, the first", "Ada", "Zoe"];
    let mut text = String::new();
    let mut expected = std::collections::BTreeMap::new();
    for (index, name) in names.iter().enumerate() {
        text = with_row(&text, name, &grades[index % 2]).expect("the same table");
        let quoted = match name.contains([',', '"']) {
            true => format!("\"{}\"", name.replace('"', "\"\"")),
            false => (*name).to_owned(),
        };
        let [points, failed] = [["10", "0"], ["0", "1"]][index % 2];
        expected.insert(quoted.clone(), format!("{quoted},{points},{points},{failed},0,"));
        let found: Vec<&str> = text.lines().skip(1).collect();
        let expected: Vec<&String> = expected.values().collect();
        assert_eq!(found, expected, "the rows after {} students", index + 1);
    }
}

/// Law: a hint says how many answers of how many were wrong, refused, late, missing, unreadable or not supported, each
/// by its own number, and how many were not asked after that. Oracle: replies that are drawn, and counted here.
#[test]
fn hints_count_each_kind_of_reply() {
    use conform::Fault;
    type Kind = (&'static str, fn() -> Reply);
    let kinds: [Kind; 6] = [
        ("answers are wrong", || Reply::Answer(json!("wrong"))),
        ("times your program answered that there is an error", || Reply::Refused("no".to_owned())),
        ("questions were not supported", || Reply::Unsupported("no".to_owned())),
        ("times there was no answer in time", || Reply::Fault(Fault::Hung("late".to_owned()))),
        ("times your program ended", || Reply::Fault(Fault::Died("a crash".to_owned()))),
        ("lines were no answer", || Reply::Fault(Fault::Garbled("a line".to_owned()))),
    ];
    struct Replies<F>(usize, F);
    impl<F: FnMut(usize, &Value) -> Reply> Subject for Replies<F> {
        fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
            let mut one = |question: &Value| {
                self.0 += 1;
                (self.1)(self.0, question)
            };
            questions.iter().map(&mut one).collect()
        }
    }
    let text = "seed = 4815162342\ncases = 12\n[[part]]\nname = \"A\"\nask = [\"fresnel.cosine\"]\npoints = 10\n";
    let table = read(text).expect("valid");
    for index in 0..40 {
        let mut draw = exact::Draw::case(77, index);
        let mut faults = 0;
        // the first question is the easy one, the second and third are the first round
        let plan: Vec<Option<usize>> = (0..13)
            .map(|at| {
                let kind = draw.below(9);
                let is_fault = (3..6).contains(&kind);
                faults += usize::from(is_fault);
                (at > 0 && kind < 6 && !(is_fault && faults > 2)).then_some(kind)
            })
            .collect();
        let mut subject = Replies(0, |at: usize, question: &Value| match plan[at - 1] {
            Some(kind) => kinds[kind].1(),
            None => Reply::Answer(ours(question).expect("an answer")),
        });
        let grade = Grade::of(&mut subject, &table, Arc::default(), &mut |_| {});
        let text = grade.text();
        for (kind, (words, _)) in kinds.iter().enumerate() {
            let count = plan.iter().filter(|it| **it == Some(kind)).count();
            let said = format!("{count} of 12 {words}");
            assert_eq!(text.contains(&said), count > 0, "whether `{said}` is in {text}");
            assert!(count > 0 || !text.contains(words), "`{words}`, but there is none: {text}");
        }
        assert!(!text.contains("not asked"), "all cases were asked: {text}");
    }
}
