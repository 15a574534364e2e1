//! The numbers of the tables, recomputed from the data beside them.

use report::words::{DASH, bytes, capital, count, time};
use serde_json::Value;
use text::digits::rough;

use super::{REPORT, list, number, text};

/// The table with this caption: the headings of its columns, and the cells of its rows, without marks and tags.
pub fn table(caption: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let start = format!("<caption>{caption}</caption>");
    let found = REPORT.html.split_once(&start).unwrap_or_else(|| panic!("no table `{caption}`"));
    let (table, _) = found.1.split_once("</table>").expect("it ends");
    let cells = |row: &str| -> Vec<String> {
        let cells = row.replace("</td>", "\n").replace("</th>", "\n");
        let plain = |cell: &str| {
            let mut text = String::new();
            let mut is_tag = false;
            for letter in cell.chars() {
                match letter {
                    '<' => is_tag = true,
                    '>' => is_tag = false,
                    _ if !is_tag => text.push(letter),
                    _ => {}
                }
            }
            text.replace('‡', "").trim().to_owned()
        };
        cells.lines().map(plain).collect()
    };
    let (head, body) = table.split_once("<tbody>").expect("a body");
    let rows = |part: &str| -> Vec<Vec<String>> {
        let rows = part.split("<tr>").skip(1);
        rows.filter_map(|row| Some(cells(row.split_once("</tr>")?.0))).collect()
    };
    (rows(head).pop().expect("headings"), rows(body))
}

/// A number as tables show it: `0.031`, `1.2e7`, `−0.51`; with a unit of time or memory in its unit.
fn read(text: &str) -> Option<f64> {
    let text = text.replace('−', "-").replace('\u{202f}', "");
    let (text, unit) = text.split_once(' ').unwrap_or((&text, ""));
    let unit = match unit {
        "ms" => 1e-3,
        "µs" => 1e-6,
        "ns" => 1e-9,
        "kB" => 1e3,
        "MB" => 1e6,
        "GB" => 1e9,
        _ => 1.0,
    };
    Some(text.parse::<f64>().ok()? * unit)
}

/// Whether a cell shows a number to two digits, or a dash for none.
fn shows(cell: &str, expected: Option<f64>, what: &str) {
    match (expected, read(cell)) {
        (None, found) => assert!(found.is_none() && cell == DASH, "{what}: `{cell}`, not a dash"),
        (Some(expected), Some(found)) => {
            let off = (found - expected).abs();
            assert!(off <= 0.051 * expected.abs(), "{what}: `{cell}`, not {expected}");
        }
        (Some(expected), None) => panic!("{what}: `{cell}`, not {expected}"),
    }
}

/// Law: a number is printed to two digits, times and sizes in a unit in which they are at least 1. Oracle: what is
/// printed, read back; numbers on both sides of each unit.
#[test]
fn numbers_are_printed_to_two_digits() {
    for exponent in -12..13 {
        for digits in [1.0, 1.04, 1.06, 2.5, 4.44, 9.4, 9.6, 9.949, 9.96, 9.9999] {
            let x = digits * format!("1e{exponent}").parse::<f64>().expect("a number");
            shows(&rough(x), Some(x), &format!("{x}"));
            shows(&rough(-x), Some(-x), &format!("{}", -x));
            let printed = time(x);
            shows(&printed, Some(x), &format!("{x} seconds"));
            let unit = printed.split(' ').nth(1).expect("a unit");
            let expected = match x {
                x if x >= 1.0 => "s",
                x if x >= 1e-3 => "ms",
                x if x >= 1e-6 => "µs",
                _ => "ns",
            };
            assert_eq!(unit, expected, "the unit of {x} seconds");
            if x >= 1.0 {
                let printed = bytes(x);
                shows(&printed, Some(x), &format!("{x} bytes"));
            }
        }
    }
    for (n, expected) in
        [(0, "0"), (9999, "9999"), (10_000, "10 000"), (123_456_789, "123 456 789")]
    {
        let found = count(n).replace('\u{202f}', " ");
        assert_eq!(found, expected, "the count {n}");
    }
}

/// The slope of a straight line by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    covariance / points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>()
}

fn log(x: f64) -> f64 {
    groundtruth::math::ln(x)
}

/// Law: of each sampler the table has the errors at 16, 256 and 4096 samples, the slope from 16 samples on, the samples
/// for 1 %, by a straight line between the logarithms around it, and this number of samples times the time of one.
/// Oracle: the errors beside it, by least squares and interpolation here.
#[test]
fn samplers_have_the_numbers_of_their_errors() {
    let mut reached = 0;
    for data in list(&REPORT.json["pages"]["samplers"]["integrands"]) {
        let name = text(&data["name"]);
        let (_, rows) = table(&format!("{}: error and cost", capital(name)));
        for (row, sampler) in rows.iter().zip(list(&data["samplers"])) {
            assert_eq!(row[0], text(&sampler["sampler"]), "the sampler of a row of {name}");
            let what = |column: &str| format!("{column} of {} for {name}", row[0]);
            let errors: Vec<(f64, f64)> = list(&sampler["errors"])
                .iter()
                .map(|it| (number(&it["samples"]), number(&it["rms"])))
                .collect();
            for (column, samples) in [(1, 16.0), (2, 256.0), (3, 4096.0)] {
                let error = errors.iter().find(|it| it.0 == samples).map(|it| it.1);
                shows(&row[column], error, &what(&format!("the error at {samples}")));
            }
            let far: Vec<(f64, f64)> =
                errors.iter().filter(|it| it.0 >= 16.0).map(|it| (log(it.0), log(it.1))).collect();
            if far.iter().all(|it| it.1.is_finite()) {
                let expected = slope(&far);
                let found = read(&row[4]).expect("a slope");
                // two decimals are shown; the data has every digit, but for the order of sums
                assert!(
                    (found - expected).abs() < 0.006,
                    "{}: {found}, not {expected}",
                    what("the slope")
                );
                let [of_json, low, high] = [0, 1, 2].map(|i| number(&sampler["slope"][i]));
                assert!(
                    (of_json - expected).abs() < 1e-9,
                    "{}: {of_json}, not {expected}",
                    what("the slope")
                );
                assert!(
                    low <= expected && expected <= high,
                    "{}: {low} … {high}",
                    what("the interval")
                );
            }
            // the last crossing of 1 %
            let last = errors.iter().rposition(|it| it.1 > 0.01);
            let expected = match last {
                None => Some(errors[0].0),
                Some(at) if at + 1 == errors.len() => None,
                Some(at) if errors[at + 1].1 == 0.0 => Some(errors[at + 1].0),
                Some(at) => {
                    let [(a, x), (b, y)] =
                        [errors[at], errors[at + 1]].map(|it| (log(it.0), log(it.1)));
                    Some(groundtruth::math::exp(a + (b - a) * (x - log(0.01)) / (x - y)))
                }
            };
            let found = sampler["samples_for_one_percent"].as_f64();
            let is_near = match (found, expected) {
                (Some(a), Some(b)) => (a / b - 1.0).abs() < 1e-9,
                (a, b) => a == b,
            };
            assert!(is_near, "{}: {found:?}, not {expected:?}", what("samples for 1 %"));
            let seconds = expected.map(|n| n * number(&sampler["sample_seconds"]));
            shows(&row[6], seconds, &what("seconds for 1 %"));
            reached += usize::from(expected.is_some());
        }
    }
    assert!(reached > 10, "samplers that reach 1 %: {reached}");
}

/// Law: for each choice the tables of light and textures have the errors, the time of a sample (that of a picture with the most
/// samples, over their number) and the efficiency with the most samples; the data has the slopes by least squares. Oracle: the
/// levels beside it.
#[test]
fn choices_have_the_numbers_of_their_levels() {
    let mut cells = 0;
    for (page, ending) in [("light", "error, time and bias"), ("textures", "error and time")] {
        for scene in list(&REPORT.json["pages"][page]["scenes"]) {
            let name = text(&scene["scene"]);
            let (heads, rows) = table(&format!("{}: {ending}", capital(name)));
            for (row, choice) in rows.iter().zip(list(&scene["choices"])) {
                // the page of textures has two choices without names in its data
                let is_it = choice["choice"].as_str().is_none_or(|it| it == row[0]);
                assert!(
                    is_it,
                    "the choice of a row of {name}: {}, not {}",
                    row[0], choice["choice"]
                );
                let levels = list(&choice["levels"]);
                let last = levels.last().expect("a level");
                for (head, cell) in heads.iter().zip(row).skip(1) {
                    let what = format!("{head} of {} in {name}", row[0]);
                    if let Ok(samples) = head.parse::<u64>() {
                        let level = levels.iter().find(|it| it["samples"] == samples);
                        // the page of textures has errors, that of light relative ones in percent
                        let (field, by) =
                            if page == "light" { ("relative_rmse", 100.0) } else { ("rmse", 1.0) };
                        let error = level.and_then(|it| it[field].as_f64());
                        shows(cell, error.map(|error| by * error), &what);
                    } else if head.starts_with("time per sample") {
                        let seconds = number(&last["picture_seconds"]) / number(&last["samples"]);
                        shows(cell, Some(seconds), &what);
                    } else if head.starts_with("efficiency") {
                        shows(cell, last["efficiency"].as_f64(), &what);
                    } else {
                        continue;
                    }
                    cells += 1;
                }
                let errors: Option<Vec<(f64, f64)>> = levels
                    .iter()
                    .map(|it| Some((log(number(&it["samples"])), log(it["rmse"].as_f64()?))))
                    .collect();
                if let (Some(errors), Some(found)) = (errors, choice["slope"][0].as_f64()) {
                    let expected = slope(&errors);
                    let what = format!("the slope of {} in {name}", row[0]);
                    assert!((found - expected).abs() < 1e-9, "{what}: {found}, not {expected}");
                }
            }
        }
    }
    assert!(cells > 60, "cells that were recomputed: {cells}");
}

/// Law: of each family of a shape the table has hits, misses (what was judged and no hit), the medians and worst errors of both
/// routines, and their failures. Oracle: the data beside it; shapes whose families are of one kind.
#[test]
fn shapes_have_the_numbers_of_their_families() {
    let mut rows_seen = 0;
    for kind in list(&REPORT.json["pages"]["intersections"]["kinds"]) {
        let families = list(&kind["families"]);
        let names: Vec<String> = families.iter().map(|it| words(text(&it["family"]))).collect();
        let caption = words(text(&kind["kind"]));
        let (heads, rows) = table(&caption);
        let found: Vec<&String> = rows.iter().map(|row| &row[0]).collect();
        assert_eq!(found, names.iter().collect::<Vec<_>>(), "families of {caption}");
        let ours = heads.iter().position(|head| head == "median").expect("a median");
        let book = heads.iter().rposition(|head| head == "median").expect("a median");
        for (row, family) in rows.iter().zip(families) {
            let what = |column: &str| format!("{column} of {} for {caption}", row[0]);
            let (hits, judged) = (number(&family["hits"]), number(&family["judged"]));
            shows_whole(&row[1], hits, &what("hits"));
            shows_whole(&row[2], judged - hits, &what("misses"));
            for (at, routine) in [(ours, &family["ours"]), (book, &family["textbook"])] {
                for (offset, field) in ["median", "p999", "worst"].into_iter().enumerate() {
                    let error = routine[field].as_f64();
                    let cell = &row[at + offset];
                    if error.is_some() || cell == DASH {
                        shows(cell, error, &what(field));
                    }
                }
                for (offset, field) in [(3, "lost"), (4, "wrong")] {
                    let expected = number(&routine[field]);
                    let found = read(&row[at + offset]).unwrap_or(0.0);
                    assert_eq!(found, expected, "{}", what(field));
                }
                let quantiles = ["median", "p999", "worst"].map(|field| routine[field].as_f64());
                let is_sorted = quantiles.windows(2).all(|it| it[0] <= it[1]);
                assert!(is_sorted, "{}: {quantiles:?}", what("median, 99.9 % and worst"));
            }
            rows_seen += 1;
        }
    }
    assert!(rows_seen > 60, "families seen: {rows_seen}");
}

/// `FarOrigin` as `far origin`; boxes have another name in code.
fn words(name: &str) -> String {
    if name == "Cuboid" {
        return "box".to_owned();
    }
    let mut words = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(letter.to_lowercase());
    }
    words
}

fn shows_whole(cell: &str, expected: f64, what: &str) {
    assert_eq!(read(cell), Some(expected), "{what}");
}

/// Law: each row of acceleration has the numbers of its run. Oracle: the data beside it.
#[test]
fn structures_have_the_numbers_of_their_runs() {
    let mut seen = 0;
    for stage in list(&REPORT.json["pages"]["acceleration"]["stages"]) {
        let caption = format!("{}, by number of objects", capital(text(&stage["stage"])));
        let (heads, rows) = table(&caption);
        // of the two sizes for each factor of ten, the table has the first
        let mut sizes: Vec<u64> =
            list(&stage["runs"]).iter().filter_map(|run| run["objects"].as_u64()).collect();
        sizes.sort_unstable();
        sizes.dedup();
        let sizes: Vec<u64> = sizes.into_iter().step_by(2).collect();
        let is_shown = |run: &&Value| run["objects"].as_u64().is_some_and(|n| sizes.contains(&n));
        let runs: Vec<&Value> = list(&stage["runs"]).iter().filter(is_shown).collect();
        assert_eq!(rows.len(), runs.len(), "rows of {caption}");
        for row in &rows {
            let objects =
                row[1].replace('\u{202f}', "").parse::<u64>().expect("a number of objects");
            let is_it =
                |run: &&&Value| run["structure"] == row[0].as_str() && run["objects"] == objects;
            let run = runs.iter().find(is_it).unwrap_or_else(|| panic!("no run of {row:?}"));
            for (head, field) in [
                ("objects", "objects"),
                ("build", "build_seconds"),
                ("memory", "memory_bytes"),
                ("picture", "picture_seconds"),
                ("tests per ray", "tests_per_ray"),
                ("nodes or cells per ray", "steps_per_ray"),
                ("rays timed", "timed_rays"),
            ] {
                let at = heads.iter().position(|it| it == head).expect("a column");
                let what = format!("{head} of {} in {caption}", row[0]);
                shows(&row[at], run[field].as_f64(), &what);
                seen += 1;
            }
        }
    }
    assert!(seen > 60, "cells seen: {seen}");
}
