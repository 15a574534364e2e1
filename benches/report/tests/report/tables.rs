//! The numbers of the tables, recomputed from the data beside them.

use std::collections::BTreeSet;

use report::words::{DASH, capital};
use serde_json::Value;

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

/// What a column shows of the value that a row is drawn from.
type Shown<'a> = &'a dyn Fn(&Value) -> Option<f64>;

/// The field at the end of this path, `levels/-1` for the last of a list.
fn field(value: &Value, path: &str) -> Option<f64> {
    let step = |value: &'_ Value, name: &str| match (value, name) {
        (Value::Array(items), "-1") => items.last().cloned(),
        (Value::Array(items), index) => items.get(index.parse::<usize>().ok()?).cloned(),
        (value, name) => value.get(name).cloned(),
    };
    path.split('/').try_fold(value.clone(), |value, name| step(&value, name))?.as_f64()
}

/// Columns of counts, which have all digits.
const COUNTS: [&str; 6] = ["hits", "misses", "lost", "wrong", "objects", "rays timed"];

/// Holds the table with this caption to the values of its rows: the first cell is their name, and the columns that begin
/// with these headings (of several, the n-th) show these numbers. How many cells were held.
fn held(
    caption: &str,
    values: &[&Value],
    name: &dyn Fn(&Value) -> String,
    columns: &[(&str, usize, Shown<'_>)],
) -> usize {
    let (heads, rows) = table(caption);
    let found: Vec<&String> = rows.iter().map(|row| &row[0]).collect();
    let expected: Vec<String> = values.iter().map(|value| name(value)).collect();
    assert_eq!(found, expected.iter().collect::<Vec<_>>(), "rows of {caption}");
    for (head, nth, shown) in columns {
        let mut places = (0..heads.len()).filter(|at| heads[*at].starts_with(head));
        let at = places.nth(*nth).unwrap_or_else(|| panic!("no column {head} in {caption}"));
        for (row, value) in rows.iter().zip(values) {
            let what = format!("{head} of {} in {caption}", row[0]);
            match COUNTS.contains(head) {
                true => assert_eq!(read(&row[at]), shown(value), "{what}"),
                false => shows(&row[at], shown(value), &what),
            }
        }
    }
    columns.len() * rows.len()
}

/// Law: each cell of a number of each table shows that of the data: errors, slopes, times, efficiencies, counts. Oracle: the data
/// beside it.
#[test]
fn tables_show_the_numbers_of_the_data() {
    let pages = &REPORT.json["pages"];
    let by = |path: &'static str| move |value: &Value| field(value, path);
    let mut cells = 0;
    for data in list(&pages["samplers"]["integrands"]) {
        let error = |samples: f64| {
            move |sampler: &Value| {
                let errors = list(&sampler["errors"]).iter();
                errors.clone().find(|it| number(&it["samples"]) == samples)?["rms"].as_f64()
            }
        };
        let seconds = |it: &Value| {
            Some(it["samples_for_one_percent"].as_f64()? * number(&it["sample_seconds"]))
        };
        let caption = format!("{}: error and cost", capital(text(&data["name"])));
        cells += held(
            &caption,
            &list(&data["samplers"]).iter().collect::<Vec<_>>(),
            &|it| text(&it["sampler"]).to_owned(),
            &[
                ("error, 16", 0, &error(16.0)),
                ("256", 0, &error(256.0)),
                ("4096", 0, &error(4096.0)),
                ("seconds for 1 %", 0, &seconds),
            ],
        );
    }
    for (page, ending, path, by_samples) in [
        ("light", "error, time and bias", "relative_rmse", 100.0),
        ("textures", "error and time", "rmse", 1.0),
    ] {
        for scene in list(&pages[page]["scenes"]) {
            let per_sample = |it: &Value| {
                Some(field(it, "levels/-1/picture_seconds")? / field(it, "levels/-1/samples")?)
            };
            let error = |samples: f64| {
                move |choice: &Value| {
                    let mut levels = list(&choice["levels"]).iter();
                    let level = levels.find(|it| number(&it["samples"]) == samples)?;
                    Some(by_samples * field(level, path)?)
                }
            };
            let efficiency = by("levels/-1/efficiency");
            let (one, some, many) = (error(1.0), error(16.0), error(256.0));
            let mut columns: Vec<(&str, usize, Shown<'_>)> = vec![
                ("1", 0, &one),
                ("16", 0, &some),
                ("256", 0, &many),
                ("time per sample", 0, &per_sample),
            ];
            if page == "light" {
                columns.push(("efficiency", 0, &efficiency));
            }
            let caption = format!("{}: {ending}", capital(text(&scene["scene"])));
            // the page of textures has two choices without names in its data
            let name = |it: &Value| {
                text(&it[if page == "light" { "choice" } else { "filtering" }]).to_owned()
            };
            let choices: Vec<&Value> = list(&scene["choices"]).iter().collect();
            cells += held(&caption, &choices, &name, &columns);
        }
    }
    for kind in list(&pages["intersections"]["kinds"]) {
        for routine in list(&kind["families"]).iter().flat_map(|it| [&it["ours"], &it["textbook"]])
        {
            let quantiles = ["median", "p999", "worst"].map(|field| routine[field].as_f64());
            assert!(quantiles.windows(2).all(|it| it[0] <= it[1]), "{kind}: {quantiles:?}");
        }
        let misses = |it: &Value| Some(number(&it["judged"]) - number(&it["hits"]));
        cells += held(
            &words(text(&kind["kind"])),
            &list(&kind["families"]).iter().collect::<Vec<_>>(),
            &|it| words(text(&it["family"])),
            &[
                ("hits", 0, &by("hits")),
                ("misses", 0, &misses),
                ("median", 0, &by("ours/median")),
                ("99.9", 0, &by("ours/p999")),
                ("worst", 0, &by("ours/worst")),
                ("lost", 0, &by("ours/lost")),
                ("wrong", 0, &by("ours/wrong")),
                ("median", 1, &by("textbook/median")),
                ("99.9", 1, &by("textbook/p999")),
                ("worst", 1, &by("textbook/worst")),
                ("lost", 1, &by("textbook/lost")),
                ("wrong", 1, &by("textbook/wrong")),
            ],
        );
    }
    for stage in list(&pages["acceleration"]["stages"]) {
        let runs = list(&stage["runs"]);
        // of the two sizes for each factor of ten, the table has the first
        let sizes: BTreeSet<u64> = runs.iter().filter_map(|run| run["objects"].as_u64()).collect();
        let sizes: BTreeSet<u64> = sizes.into_iter().step_by(2).collect();
        let is_shown = |run: &&Value| run["objects"].as_u64().is_some_and(|n| sizes.contains(&n));
        let mut names: Vec<&str> = Vec::new();
        for name in runs.iter().map(|run| text(&run["structure"])) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let of = |name: &&str| {
            runs.iter().filter(is_shown).filter(|run| run["structure"] == *name).collect::<Vec<_>>()
        };
        cells += held(
            &format!("{}, by number of objects", capital(text(&stage["stage"]))),
            &names.iter().flat_map(of).collect::<Vec<_>>(),
            &|it| text(&it["structure"]).to_owned(),
            &[
                ("objects", 0, &by("objects")),
                ("build", 0, &by("build_seconds")),
                ("memory", 0, &by("memory_bytes")),
                ("picture", 0, &by("picture_seconds")),
                ("tests per ray", 0, &by("tests_per_ray")),
                ("nodes or cells", 0, &by("steps_per_ray")),
                ("rays timed", 0, &by("timed_rays")),
            ],
        );
    }
    assert!(cells > 1000, "cells: {cells}");
}

/// Law: slopes are those of straight lines through the logarithms of the errors, for samplers from 16 samples on, inside
/// their intervals. Oracle: least squares here.
#[test]
fn slopes_are_those_of_the_errors() {
    let pages = &REPORT.json["pages"];
    let samplers = list(&pages["samplers"]["integrands"]).iter();
    let samplers =
        samplers.flat_map(|it| list(&it["samplers"])).map(|it| (it, "errors", "rms", 16.0));
    let scenes = list(&pages["textures"]["scenes"]).iter();
    let choices = scenes.flat_map(|it| list(&it["choices"])).map(|it| (it, "levels", "rmse", 1.0));
    let mut seen = 0;
    for (choice, levels, error, from) in samplers.chain(choices) {
        let points: Option<Vec<(f64, f64)>> = list(&choice[levels])
            .iter()
            .filter(|it| number(&it["samples"]) >= from)
            .map(|it| Some((log(number(&it["samples"])), log(it[error].as_f64()?))))
            .collect();
        let Some(points) = points.filter(|points| points.iter().all(|it| it.1.is_finite())) else {
            continue;
        };
        let expected = slope(&points);
        let [found, low, high] = [0, 1, 2].map(|i| number(&choice["slope"][i]));
        assert!((found - expected).abs() < 1e-9, "{choice}: {found}, not {expected}");
        assert!(low <= expected && expected <= high, "{choice}: {low} … {high}");
        seen += 1;
    }
    assert!(seen > 50, "slopes: {seen}");
}

/// Law: the samples for 1 % are where a straight line between the logarithms around it crosses it for the last time. Oracle:
/// interpolation here.
#[test]
fn samples_for_one_percent_are_interpolated() {
    let integrands = list(&REPORT.json["pages"]["samplers"]["integrands"]).iter();
    let mut reached = 0;
    for sampler in integrands.flat_map(|it| list(&it["samplers"])) {
        let pair = |it: &Value| (number(&it["samples"]), number(&it["rms"]));
        let errors: Vec<(f64, f64)> = list(&sampler["errors"]).iter().map(pair).collect();
        let expected = match errors.iter().rposition(|it| it.1 > 0.01) {
            None => Some(errors[0].0),
            Some(at) if at + 1 == errors.len() => None,
            Some(at) if errors[at + 1].1 == 0.0 => Some(errors[at + 1].0),
            Some(at) => {
                let [(a, x), (b, y)] =
                    [errors[at], errors[at + 1]].map(|it| (log(it.0), log(it.1)));
                Some(groundtruth::math::exp(a + (b - a) * (x - log(0.01)) / (x - y)))
            }
        };
        match (sampler["samples_for_one_percent"].as_f64(), expected) {
            (Some(found), Some(expected)) => {
                assert!((found / expected - 1.0).abs() < 1e-9, "{sampler}: not {expected}");
                reached += 1;
            }
            (found, expected) => assert_eq!(found, expected, "{sampler}"),
        }
    }
    assert!(reached > 10, "samplers that reach 1 %: {reached}");
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
