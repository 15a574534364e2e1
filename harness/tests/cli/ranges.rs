//! Numbers on the command line: the ends of their ranges, numbers beyond them, and numbers that are printed.

use std::path::Path;

use super::announced::announce::words;
use super::columns_of_text::columns::wrapped;
use super::{GROUNDTRUTH, run_in};

/// Law: of each number with a range the least and the largest are taken, and one less and one more are refused with
/// status 2, before anything is done (README, `--help`). Oracle: the ranges by hand.
#[test]
fn the_ends_of_ranges_are_taken_and_no_more() {
    let folder = tempfile::tempdir().expect("a folder");
    let small = &["--size", "4x3"][..];
    let scene = "ch03/single-sphere";
    let probe = ["--", GROUNDTRUTH, "probe"];
    let explain = |more: &[&'static str]| [&["explain", scene, "0,0"], small, more].concat();
    let render = |more: &[&'static str]| [&["render", scene, "-o", "a.png"], small, more].concat();
    let conform = |cases: &'static str| {
        [&["conform", "fresnel.cosine", "--cases", cases][..], &probe].concat()
    };
    let all: Vec<(Vec<&str>, bool)> = vec![
        (explain(&["--sample", "0"]), true),
        (explain(&["--samples", "1", "--sample", "1"]), false),
        (explain(&["--samples", "4", "--sample", "3"]), true),
        (explain(&["--samples", "4", "--sample", "4"]), false),
        (explain(&["--min-share", "0"]), true),
        (explain(&["--min-share", "100"]), true),
        (explain(&["--min-share", "100.5"]), false),
        (explain(&["--min-share", "-1"]), false),
        (explain(&["--min-share", "nan"]), false),
        (explain(&["--columns", "60"]), true),
        (explain(&["--columns", "59"]), false),
        (explain(&["--columns", "1000"]), true),
        (explain(&["--columns", "1001"]), false),
        ([&["explain", scene, "3,2"], small].concat(), true),
        ([&["explain", scene, "4,2"], small].concat(), false),
        ([&["explain", scene, "3,3"], small].concat(), false),
        // 2^25 pixels, of which one is explained
        (vec!["explain", scene, "8191,4095", "--size", "8192x4096"], true),
        (vec!["explain", scene, "0,0", "--size", "1x33554433"], false),
        (vec!["explain", scene, "0,0", "--size", "0x3"], false),
        (render(&["--samples", "0"]), false),
        (render(&["--samples", "1"]), true),
        (render(&["--threads", "0"]), false),
        (render(&["--threads", "1"]), true),
        (render(&["--threads", "1025"]), false),
        (render(&["--tracer", "whitted", "--max-depth", "0"]), true),
        (render(&["--crop", "0,0,4x3"]), true),
        (render(&["--crop", "3,2,1x1"]), true),
        (render(&["--crop", "1,0,4x3"]), false),
        (render(&["--crop", "0,1,4x3"]), false),
        (render(&["--crop", "3,2,0x1"]), false),
        (render(&["--seed", "18446744073709551615"]), true),
        (render(&["--seed", "18446744073709551616"]), false),
        (render(&["--seed", "-1"]), false),
        (conform("1"), true),
        (conform("4294967296"), false),
        (vec!["exercise", "ch28", "-o", "x", "--count", "0"], false),
        (vec!["exercise", "ch28", "-o", "x", "--count", "101"], false),
        (vec!["exercise", "ch28", "-o", "x", "--width", "15"], false),
        (vec!["exercise", "ch28", "-o", "x", "--width", "2001"], false),
        (vec!["report", "-o", "r", "--samples", "3"], false),
        (vec!["report", "-o", "r", "--samples", "65537"], false),
        (vec!["report", "-o", "r", "--cases", "0"], false),
        (vec!["report", "-o", "r", "--objects", "99"], false),
        ([&["laws", "--cases", "0"][..], &probe].concat(), false),
        ([&["laws", "--cases", "10001"][..], &probe].concat(), false),
        ([&["conform", "fresnel", "--timeout", "0"][..], &probe].concat(), false),
        ([&["conform", "fresnel", "--timeout", "-1"][..], &probe].concat(), false),
    ];
    for (arguments, is_taken) in all {
        let run = run_in(folder.path(), &arguments);
        let expected = if is_taken { Some(0) } else { Some(2) };
        assert_eq!(run.status, expected, "the status of {arguments:?}: {}", run.stderr);
        assert!(is_taken || run.stderr.starts_with("error"), "{arguments:?}: {}", run.stderr);
    }
}

/// Law: renderings of at least 5 s are announced; below 90 s in seconds, below 90 min in minutes, else in hours,
/// rounded; and how often, if that is more than once. Oracle: the rounding, for times on both sides of each border.
#[test]
fn announced_times_are_rounded_in_their_unit() {
    for (seconds, expected) in [
        (0.0, None),
        (4.999, None),
        (5.0, Some("5 s")),
        (5.6, Some("6 s")),
        (89.4, Some("89 s")),
        (90.0, Some("2 min")),
        (89.9, Some("90 s")),
        (149.0, Some("2 min")),
        (151.0, Some("3 min")),
        (5399.0, Some("90 min")),
        (5400.0, Some("2 h")),
        (9001.0, Some("3 h")),
        (36_000.0, Some("10 h")),
    ] {
        for pictures in [1, 2, 16] {
            let found = words("a/b", pictures, [3, 4], seconds);
            let times = if pictures == 1 { String::new() } else { format!("{pictures} times ") };
            let expected = expected.map(|it| {
                format!("a/b is rendered {times}at the size of the picture, 3 × 4: about {it}")
            });
            assert_eq!(found, expected, "the note for {seconds} s and {pictures} pictures");
        }
    }
}

/// Law: a line is broken only where the next word would not fit, and goes on four spaces further in; a line that just
/// fits is left as it is. Oracle: the lengths of lines and words; all widths from 50 to 70 for texts of words of one to
/// nine letters.
#[test]
fn lines_are_broken_only_where_they_must() {
    let mut text = "  ".to_owned();
    for index in 0..60 {
        text += &"abcdefghi"[..1 + (index * 7 + index / 9) % 9];
        text.push(' ');
    }
    let text = text.trim_end().to_owned() + "\n";
    for columns in 50..70 {
        let broken = wrapped(&text, columns);
        let lines: Vec<&str> = broken.lines().collect();
        assert!(lines.len() > 3, "lines of {columns} columns: {}", lines.len());
        for (at, pair) in lines.windows(2).enumerate() {
            let [line, next] = [pair[0], pair[1]];
            let indent = next.len() - next.trim_start().len();
            assert_eq!(indent, 6, "the indent of line {} of {columns} columns", at + 1);
            let word = next.split_whitespace().next().expect("a word");
            let with_it = line.chars().count() + 1 + word.chars().count();
            assert!(with_it > columns, "`{word}` fits into `{line}` of {columns} columns");
            assert!(line.chars().count() <= columns, "`{line}` has more than {columns} columns");
        }
    }
    for length in [58, 59, 60] {
        let line = format!("{} end", "x".repeat(length - 4));
        assert_eq!(wrapped(&line, 60), line, "a line of {length} columns in 60");
    }
    let line = format!("{} end", "x".repeat(57));
    assert_eq!(wrapped(&line, 60), format!("{}\n    end", "x".repeat(57)), "a line of 61 in 60");
}

/// Law: `bounds` prints the box around all objects with an end. Oracle: the least and largest coordinates of three spheres, on
/// different axes and sides of the origin.
#[test]
fn the_box_of_all_is_around_the_boxes_of_each() {
    let folder = tempfile::tempdir().expect("a folder");
    let ball = |name: &str, [x, y, z]: [f64; 3], r: f64| {
        format!(
            "[[objects]]\nname = \"{name}\"\nmaterial = \"m\"\n\
             shape.sphere = {{ center = [{x}, {y}, {z}], radius = {r} }}\n"
        )
    };
    let text =
        "[image]\nwidth = 8\nheight = 6\n[camera]\neye = [0, 0, 50]\nlens.orthographic = {}\n\
                [[materials]]\nname = \"m\"\nrecipe.matte.cd = 1\n"
            .to_owned()
            + &ball("a", [5.0, 0.0, 0.0], 1.0)
            + &ball("b", [0.0, -7.0, 1.0], 2.0)
            + &ball("c", [-1.0, 0.0, 9.0], 0.5);
    std::fs::write(folder.path().join("a.toml"), text).expect("written");
    let run = run_in(folder.path(), &["bounds", "a.toml"]);
    for line in [
        "#   \"a\": from [4.0, -1.0, -1.0] to [6.0, 1.0, 1.0]",
        "#   \"b\": from [-2.0, -9.0, -1.0] to [2.0, -5.0, 3.0]",
        "#   \"c\": from [-1.5, -0.5, 8.5] to [-0.5, 0.5, 9.5]",
        "# all that end: from [-2.0, -9.0, -1.0] to [6.0, 1.0, 9.5]",
        "look_at = [2.0, -4.0, 4.25]",
    ] {
        assert!(run.stdout.lines().any(|found| found == line), "no line {line} in\n{}", run.stdout);
    }
}

/// Law: a list names each scene once, in the order of the book, as text and as JSON. Oracle: each other, and the
/// chapters' numbers.
#[test]
fn a_list_is_in_the_order_of_the_book() {
    let here = Path::new(".");
    let text = run_in(here, &["list"]).stdout;
    let names: Vec<&str> = text.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let json: serde_json::Value =
        serde_json::from_str(&run_in(here, &["list", "--json"]).stdout).expect("JSON");
    let of_json: Vec<&str> =
        json.as_array().expect("a list").iter().filter_map(|it| it["name"].as_str()).collect();
    assert_eq!(of_json, names, "names as JSON and as text");
    let chapters: Vec<u32> = names
        .iter()
        .filter_map(|name| name.strip_prefix("ch")?.split('/').next()?.parse().ok())
        .collect();
    assert_eq!(chapters.len(), names.len(), "scenes with a chapter");
    assert!(chapters.is_sorted(), "the chapters in their order: {chapters:?}");
    let mut unique = names.clone();
    unique.sort_unstable();
    unique.dedup();
    assert_eq!(unique.len(), names.len(), "different names");
}

/// Law: `goldens check` counts what is not the same, of all, and proposes to accept each that is not drift. Oracle: its
/// own lines, in a folder where one golden of three is damaged and one has no scene.
#[test]
fn a_check_counts_its_lines() {
    let folder = tempfile::tempdir().expect("a folder");
    let goldens = "mine";
    let scene = |radius: f64| {
        format!(
            "[image]\nwidth = 8\nheight = 6\n[camera]\neye = [0, 0, 5]\nlens.orthographic = {{}}\n\
             [[materials]]\nname = \"m\"\nrecipe.emissive.ls = 1\n[[objects]]\nname = \"a\"\n\
             material = \"m\"\nshape.sphere = {{ center = [0, 0, 0], radius = {radius} }}\n"
        )
    };
    for name in ["a.toml", "b.toml", "c.toml"] {
        std::fs::write(folder.path().join(name), scene(1.0)).expect("written");
        let accept =
            ["goldens", "accept", name, "--because", "seen", "--size", "8x6", "--folder", goldens];
        let run = run_in(folder.path(), &accept);
        assert_eq!(run.status, Some(0), "{}", run.stderr);
    }
    let check = || run_in(folder.path(), &["goldens", "check", "--folder", goldens]);
    let run = check();
    let expected = (Some(0), true);
    let found = (run.status, run.stdout.ends_with("checked 3, all the same\n"));
    assert_eq!(found, expected, "status and end of\n{}", run.stdout);
    std::fs::write(folder.path().join("b.toml"), scene(2.0)).expect("written");
    std::fs::remove_file(folder.path().join("mine/c.toml.exr")).expect("it is there");
    let run = check();
    assert_eq!(run.status, Some(1), "{}", run.stdout);
    let lines: Vec<&str> = run.stdout.lines().collect();
    let same = lines.iter().filter(|line| line.starts_with("same")).count();
    assert_eq!(same, 1, "goldens that are the same in\n{}", run.stdout);
    assert!(lines.contains(&"2 of 3 are not the same"), "the count in\n{}", run.stdout);
    let accepts = lines.iter().filter(|line| line.starts_with("to accept: ")).count();
    assert_eq!(accepts, 2, "commands to accept in\n{}", run.stdout);
    let changed = lines.iter().find(|line| line.starts_with("changed")).expect("b is changed");
    // radius 1 and 2 of 8 × 6 pixels of side 1: centres at ½ and 3/2; within 1 there are 4, within 2 there are 12
    let expected = "changed   b.toml: 8 of 48 pixels differ, the most by 1.0e0 at ";
    assert!(changed.starts_with(expected), "{changed}, not {expected}");
}

/// The shares of all rays of a tree as JSON, by their numbers.
fn shares(ray: &serde_json::Value, all: &mut Vec<f64>) {
    all.push(ray["share"].as_f64().expect("a share"));
    ray["children"].as_array().into_iter().flatten().for_each(|child| shares(child, all));
}

/// Law: `explain --min-share P` shows each ray whose share is at least P percent, and counts the others, so that all
/// rays are shown or counted; at 0 all are shown. Oracle: the shares as JSON.
#[test]
fn rays_of_a_share_are_shown_and_the_others_counted() {
    let here = Path::new(".");
    let pixel = ["explain", "ch28/glass-sphere", "300,250"];
    let json = run_in(here, &[&pixel[..], &["--json"]].concat()).stdout;
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let mut all = Vec::new();
    shares(&json["samples"][0]["ray"], &mut all);
    assert!(all.len() > 10, "rays of the tree: {}", all.len());
    for percent in ["0", "1", "5", "60", "99"] {
        let text = run_in(here, &[&pixel[..], &["--min-share", percent]].concat()).stdout;
        let heads = text.lines().filter_map(|line| {
            let (share, rest) = line.split_once(" %  ")?;
            // `< 0.1 %`
            let share = share.trim().trim_start_matches("< ");
            share.parse::<f64>().ok().map(|share| (share, rest.trim_start()))
        });
        let (mut shown, mut counted) = (Vec::new(), 0);
        for (share, rest) in heads {
            let number = rest.split_whitespace().next().and_then(|word| word.parse::<usize>().ok());
            let number = number.expect("a number of a ray, or of rays");
            if rest.contains(" more ray") {
                counted += number;
            } else {
                // two digits, but no more than one behind the point
                let off = (share - 100.0 * all[number]).abs();
                assert!(
                    off <= 0.051 * share + 0.1,
                    "ray {number}: {share} %, not {}",
                    100.0 * all[number]
                );
                shown.push(number);
            }
        }
        assert_eq!(
            shown.len() + counted,
            all.len(),
            "rays shown and counted at {percent} %:\n{text}"
        );
        let least: f64 = percent.parse().expect("a number");
        let expected = (0..all.len()).filter(|ray| 100.0 * all[*ray] >= least);
        let missing: Vec<usize> = expected.filter(|ray| !shown.contains(ray)).collect();
        assert_eq!(missing, [0_usize; 0], "rays of at least {percent} % that are not shown");
        assert_eq!(counted == 0, percent == "0", "whether all are shown at {percent} %");
    }
}
