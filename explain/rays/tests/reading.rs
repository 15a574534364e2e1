use rays::{LogError, Precision, Purpose, Traced, read};

fn one(line: &str) -> rays::Ray {
    let log = read(line.as_bytes()).expect("a log");
    log.rays.into_iter().next().expect("a ray")
}

/// Law: short names and words of others are read as the long ones. Oracle: the same line with long names.
#[test]
fn short_names_are_read() {
    let short = one(
        r#"{"o": [1, 2, 3], "d": [0, 0, 1], "n": [0, 1, 0], "obj": "a", "w": 0.5, "L": [1, 2, 3], "tmax": 4, "kind": "refracted"}"#,
    );
    let long = one(
        r#"{"origin": [1, 2, 3], "direction": [0, 0, 1], "normal": [0, 1, 0], "object": "a", "weight": 0.5, "radiance": [1, 2, 3], "end": 4, "kind": "transmitted"}"#,
    );
    assert_eq!(format!("{short:?}"), format!("{long:?}"));
    assert_eq!(short.kind, Some(Purpose::Transmitted));
}

/// Law: numbers that are none are read in all spellings, and in lists as `null`. Oracle: their meaning.
#[test]
fn numbers_that_are_none_are_read() {
    for word in ["NaN", "nan", "-nan", "-nan(ind)", "\"nan\""] {
        let ray = one(&format!(r#"{{"origin": [1, 2, 3], "direction": [0, 0, 1], "t": {word}}}"#));
        assert!(ray.t.is_some_and(f64::is_nan), "{word}");
    }
    for word in ["inf", "Infinity", "1e999", "\"inf\""] {
        let ray = one(&format!(r#"{{"origin": [1, 2, 3], "direction": [0, 0, 1], "t": {word}}}"#));
        assert_eq!(ray.t, Some(f64::INFINITY), "{word}");
    }
    let ray = one(r#"{"origin": [1, 2, 3], "direction": [0, 0, 1], "normal": [null, 0, 1]}"#);
    assert!(ray.normal.is_some_and(|normal| normal.x().is_nan()));
}

/// Law: fields of a person's own are kept. Oracle: their values.
#[test]
fn own_fields_are_kept() {
    let ray = one(
        r#"{"origin": [1, 2, 3], "direction": [0, 0, 1], "values": {"roughness": 0.2}, "bounces": 3}"#,
    );
    assert_eq!(ray.others["roughness"], 0.2);
    assert_eq!(ray.others["bounces"], 3);
}

/// Law: a damaged line is named and left out, and the others are read; so is one that is cut off. Oracle: the line numbers.
#[test]
fn damaged_lines_are_named() {
    let good = r#"{"origin": [1, 2, 3], "direction": [0, 0, 1]}"#;
    let text = format!(
        "{good}\nrubbish\n{{\"origin\": [1, 2]}}\n\n{{\"direction\": [0, 0, 1]}}\n{good}\n{{\"origin\": [1,"
    );
    let log = read(text.as_bytes()).expect("a log");
    assert_eq!(log.rays.len(), 2);
    let lines: Vec<usize> = log.damaged.iter().map(|it| it.line).collect();
    assert_eq!(lines, [2, 3, 5, 7]);
}

/// Law: what is no log is refused in a sentence. Oracle: its words.
#[test]
fn what_is_no_log_is_refused() {
    let refused = |text: &str, words: &str| {
        let error = read(text.as_bytes()).expect_err("no log").to_string();
        assert!(error.contains(words), "{error}");
    };
    refused("", "no ray");
    refused("hello\n", "line 1");
    refused("{\"rays\": 2}\n", "version of the format");
    let head = "{\"rays\": 1}\n";
    refused(&format!("{head}{head}"), "second head");
    refused("{\"rays\": 1, \"precision\": \"half\"}\n", "single or double");
    assert!(matches!(read("".as_bytes()), Err(LogError::NoRay(None))));
}

/// Law: a line longer than a mebibyte is named and passed over, whatever stands in it, and is one line, even if it is read in
/// several blocks. Oracle: the rays beside it, and the number of the damaged line after it.
#[test]
fn a_long_line_is_passed_over() {
    let good = "{\"origin\": [1, 2, 3], \"direction\": [0, 0, 1]}\n";
    for length in [3 << 20, 70 << 20] {
        let text = format!("{good}\"{}\"\n{good}rubbish\n", "x".repeat(length));
        let log = read(text.as_bytes()).expect("a log");
        assert_eq!(log.rays.iter().map(|ray| ray.line).collect::<Vec<_>>(), [1, 3]);
        assert_eq!(log.damaged.iter().map(|it| it.line).collect::<Vec<_>>(), [2, 4]);
        assert!(log.damaged[0].problem.contains("1 MiB"));
    }
}

/// Law: the precision of a program is found by its numbers, or taken from the head. Oracle: the rounding of the type.
#[test]
fn precision_is_found() {
    let rounding = |text: &str| Traced::of(read(text.as_bytes()).expect("a log"), None).rounding;
    let third = 1.0_f64 / 3.0;
    let line = |x: f64| format!("{{\"origin\": [{x:.17e}, 0, 0], \"direction\": [0, 0, 1]}}\n");
    assert!(rounding(&line(third)) < 1e-15);
    assert!(
        (rounding(&line(f64::from(third as f32))) - groundtruth::math::power_of_two(-24)).abs()
            < 1e-9
    );
    assert!(
        rounding(&format!("{{\"rays\": 1, \"precision\": \"single\"}}\n{}", line(third))) > 5e-8
    );
    // six digits are all that many programs print
    assert!(rounding("{\"origin\": [0.333333, 0, 0], \"direction\": [0, 0, 1]}\n") > 4e-6);
    assert_eq!(read(line(third).as_bytes()).expect("a log").head.precision, None::<Precision>);
}

/// Law: without `parent` the sender is the ray that ended there; with it, the order of lines does not matter. Oracle: the tree
/// that was meant.
#[test]
fn senders_are_found() {
    let lines = [
        r#"{"kind": "camera", "origin": [0, 2, 0], "direction": [0, -1, 0], "t": 2}"#,
        r#"{"kind": "diffuse", "origin": [0, 0, 0], "direction": [1, 0, 0], "t": 3}"#,
        r#"{"kind": "diffuse", "origin": [3, 0, 0], "direction": [0, 1, 0]}"#,
    ];
    let guessed = Traced::of(read(lines.join("\n").as_bytes()).expect("a log"), None);
    assert_eq!(guessed.parents, [None, Some(0), Some(1)]);
    assert_eq!(guessed.guessed, 2);
    let named = [
        "{\"ray\": 2, \"parent\": \"a\", \"origin\": [0, 0, 0], \"direction\": [1, 0, 0]}",
        "{\"ray\": \"a\", \"origin\": [0, 2, 0], \"direction\": [0, -1, 0], \"t\": 2}",
    ];
    let named = Traced::of(read(named.join("\n").as_bytes()).expect("a log"), None);
    assert_eq!(named.parents, [Some(1), None]);
}

/// Law: what would only turn laws off is refused: a lamp whose place is none is left out by its line, axes and scales that are none
/// end the reading; the mark of UTF-8 at the beginning of a file is none of its first line. Oracle: the same line, right.
#[test]
fn what_would_turn_laws_off_is_refused() {
    const RAY: &str = r#"{"origin": [0, 0, 0], "direction": [0, 0, 1]}"#;
    let log = |line: &str| read(format!("{line}\n{RAY}\n").as_bytes());
    for lamp in [r#"{"lamp": 5, "object": 1}"#, r#"{"lamp": "l", "point": [0, 5]}"#] {
        let log = log(lamp).expect("a ray");
        assert_eq!((log.lamps.len(), log.damaged.len()), (0, 1), "{lamp}");
    }
    for lamp in [r#"{"lamp": "l", "object": "ball"}"#, r#"{"lamp": 5, "directional": [0, 1, 0]}"#] {
        assert_eq!(log(lamp).expect("a ray").lamps.len(), 1, "{lamp}");
    }
    let axes = [r#""axes": ["x", "x", "y"]"#, r#""axes": 5"#];
    let sizes = [r#""size": [0, 0]"#, r#""size": [4, 0]"#, r#""size": [1e9, 1e9]"#, r#""size": 5"#];
    for head in axes.iter().chain(&sizes).chain(&[r#""scale": 0"#, r#""scale": -1"#]) {
        let refused = log(&format!("{{\"rays\": 1, {head}}}")).expect_err("refused").to_string();
        assert!(refused.starts_with(&format!("line 1: `{}", &head[1..5])), "{refused}");
    }
    let head = r#"{"rays": 1, "axes": ["x", "-z", "y"], "scale": 0.01}"#;
    for begin in ["", "\u{feff}"] {
        assert_eq!(
            log(&format!("{begin}{head}")).expect("a log").head.version,
            Some(1),
            "{begin:?}"
        );
    }
}
