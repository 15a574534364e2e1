//! The notation of the files of families: what it means, and what is said of mistakes in it.

use conform::cases::read;
use conform::ours;
use serde_json::{Value, json};

/// The first 200 cases of a family of samples that is written like this.
fn drawn(fields: &str) -> Vec<Value> {
    let head = "[everything]\n['samples.it']\nabout = 'it'\nchapter = 'ch05'\njudge = 'mean'\n";
    let entries = read(&format!("{head}{fields}")).expect("entries");
    (0..200).map(|i| entries[0].case(1, i).expect("a case")["samples"].take()).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Law: ranges, boxes and `±` give rounded numbers from end to end, with `fine` all digits. Oracle: the ends.
#[test]
fn ranges_are_drawn_from_end_to_end() {
    for (text, low, high) in [
        ("2..4", 2.0, 4.0),
        ("-4..0.5", -4.0, 0.5),
        ("1 ± 0.5", 0.5, 1.5),
        ("fine 0..1", 0.0, 1.0),
        ("-1..-0.5 | 0.5..1", -1.0, 1.0),
    ] {
        let numbers: Vec<f64> = drawn(&format!("samples = '{text}'")).iter().map(number).collect();
        let part = |end: f64| numbers.iter().any(|x| (x - end).abs() < 0.1 * (high - low));
        let is_rounded = |x: &f64| (1024.0 * x).fract() == 0.0;
        assert!(numbers.iter().all(|x| (low..=high).contains(x)) && part(low) && part(high));
        assert_eq!(numbers.iter().all(is_rounded), !text.starts_with("fine"), "{text}");
    }
    for point in drawn("samples = '[1, 2, 3]..[2, 4, 6] | [1, 2, 3] ± [0, 0, 0]'") {
        for (i, low) in [1.0, 2.0, 3.0].into_iter().enumerate() {
            assert!((low..=2.0 * low).contains(&number(&point[i])), "{point}");
        }
    }
}

/// Law: `?` draws anew, `$` once for a case; what is calculated of whole numbers is whole; choices, functions and lists are
/// drawn inside each other. Oracle: the rules, for values that are known.
#[test]
fn names_sums_choices_and_lists_mean_what_is_written() {
    let fields = "n = 'below 3'\nside = '2..4'\n\
        samples = { same = ['$side', '$side'], other = ['side?', 'side?'], rest = '1 - $side * 2', whole = '$n * $n + 1',\
        half = '[2, 4] * 0.5 - [1, 0.25]', list = { repeat = '$n', of = 'x | y' }, one = { any = [7, { z = 'below 1' }] },\
        hit = 'shadow([1, 1, 0], [1, 2, 0])', in = '$at.here', back = '-$side' }\nat = { here = true }";
    for case in drawn(fields) {
        let (side, n) = (number(&case["same"][0]), case["list"].as_array().expect("a list").len());
        assert_eq!(case["same"], json!([side, side]));
        assert_eq!(number(&case["rest"]), 1.0 - 2.0 * side);
        assert_eq!(number(&case["back"]), -side);
        assert_eq!(case["whole"], json!(n * n + 1));
        assert_eq!(case["half"], json!([0.0, 1.75]));
        assert!(case["one"] == json!(7) || case["one"] == json!({"z": 0}), "{case}");
        assert_eq!(case["hit"], json!([1.0, 0.0, 0.0]));
        assert_eq!(case["in"], json!(true));
    }
    let is_other = |case: &Value| case["other"][0] != case["other"][1];
    assert!(drawn(fields).iter().filter(|case| is_other(case)).count() > 190);
}

/// Law: lights, materials and objects are joined with those of the entry that a family is in, and are lists with names; one
/// entry is a family for each item of `each`. Oracle: the rules.
#[test]
fn entries_begin_with_others() {
    let text = "[everything]\n[room]\nabout = 'scenes/{kind}'\nchapter = 'ch14'\njudge = 'mean'\n\
        radiance = { of = ['$materials', '$objects', '$lights'] }\nlights.sky = { ambient = {} }\n\
        materials = { stone = '$kind', glass = 'old' }\nobjects.floor = ['stone', 'plane']\n\
        ['radiance.{kind}.it']\nin = 'room'\neach = [{ kind = 'a' }, { kind = 'b' }]\n\
        materials.glass = { recipe = 'new', two_sided = true }\n";
    let entries = read(text).expect("entries");
    let names: Vec<&str> = entries.iter().map(|entry| &*entry.name).collect();
    assert_eq!(names, ["radiance.a.it", "radiance.b.it"]);
    let of = json!([
        [{"name": "stone", "recipe": "b"}, {"name": "glass", "recipe": "new", "two_sided": true}],
        [{"name": "floor", "material": "stone", "shape": "plane"}],
        [{"name": "sky", "source": {"ambient": {}}}],
    ]);
    assert_eq!(entries[1].case(1, 0), Ok(json!({"radiance": {"of": of}})));
}

/// Law: a mistake in an entry is named with its place. Oracle: the words.
#[test]
fn mistakes_in_entries_are_named() {
    const FAMILY: &str =
        "[everything]\ncolor = '0..1'\n['samples.it']\nabout = 'it'\nchapter = 'ch05'\n";
    for (fields, problem) in [
        ("judge = 'nobody'", "samples.it: no judge is called `nobody`"),
        ("samples = 1", "samples.it: no `judge`"),
        ("judge = 'mean'\nsampels = 1", "samples.it: nothing uses `sampels`"),
        ("judge = 'mean'\nin = 'rooms'", "samples.it: no entry is called `rooms`"),
        ("judge = 'mean'\nin = 'samples.it'", "samples.it: `samples.it` is in itself"),
        (
            "judge = 'mean'\nsamples = { c = 'colr?' }",
            "samples.it: samples: `colr?`: nothing is called `colr`; did you mean `color`?",
        ),
        (
            "judge = 'mean'\nsamples = '[1, 2]..[1, 2, 3]'",
            "samples.it: samples: `[1, 2]..[1, 2, 3]`: [1,2] and [1,2,3] do not go together",
        ),
        (
            "judge = 'mean'\nsamples = 'shadow(1)'",
            "samples.it: samples: `shadow(1)`: `shadow` does not take [1]",
        ),
        ("judge = 'mean'\nsamples = 'below x'", "samples.it: samples: `below x`: no whole number"),
        (
            "judge = 'mean'\nsamples = '$color.red'",
            "samples.it: samples: `$color.red`: `color` has no field `red`",
        ),
    ] {
        let case = read(&format!("{FAMILY}{fields}")).and_then(|entries| entries[0].case(1, 0));
        assert_eq!(case, Err(problem.to_owned()));
    }
}

/// Law: whatever the files draw is a question that can be answered. Oracle: the probe has an answer.
#[test]
fn what_the_files_draw_can_be_answered() {
    for family in conform::cases::families() {
        for case in (family.cases)(5, 40) {
            let answer = ours(&case);
            assert!(answer.is_ok(), "{}: {answer:?} to {case}", family.name);
        }
    }
}
