//! Guarantees for input lines: one answer per line, exact numbers, and the `id` in the reply.

mod python;

use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;

use conform::probe;
use serde_json::{Value, json};
use testkit::properties::*;

use crate::kit::{Folder, root, text_of};
use testkit::cases::laws;
use testkit::same_text::{Printed, hold};

fn served(input: &[u8]) -> (String, bool) {
    let mut output = Vec::new();
    let all_answered = probe::serve(input, &mut output).expect("memory can be written");
    (String::from_utf8(output).expect("answers are UTF-8"), all_answered)
}

/// Law: every example of the document has the answer that the document shows, up to rounding, and each question has examples. Oracle:
/// the program, and the names of the questions.
#[test]
fn the_examples_of_the_document_are_true() {
    // the questions name files from the root of the repository
    let document = text_of("docs/probe.md");
    let asked = "cd $ROOT; sed -n 's/^→ //p' docs/probe.md | groundtruth probe";
    let answers = Folder::new().run(asked).stdout;
    let (mut lines, mut answers) = (document.lines(), answers.lines());
    let mut true_lines = String::new();
    while let Some(line) = lines.next() {
        true_lines += &format!("{line}\n");
        let Some(question) = line.strip_prefix("→ ") else { continue };
        assert!(
            lines.next().is_some_and(|next| next.starts_with("← ")),
            "{question} has an answer"
        );
        true_lines += &format!("← {}\n", answers.next().expect("as many as questions"));
    }
    for name in probe::QUESTIONS {
        assert!(document.contains(&format!("\n→ {{\"{name}\": ")), "`{name}` has no example");
    }
    hold(&root().join("docs/probe.md"), &true_lines, Printed::Exactly);
}

/// Law: bytes that are no text get the number of their line, counted with blank ones, and the byte in it, from
/// 1. Oracle: where the test put them.
#[test]
fn bytes_that_are_no_text_get_line_and_byte() {
    let (text, all) =
        served(b"{\"fresnel\": {\"cos_i\": 1, \"eta\": 1.5}}\n\n{\"id\": \"\xe9\"}\n");
    let last = text.lines().last().expect("two replies");
    assert_eq!(last, r#"{"error":"line 3, byte 9: 0xe9 is not UTF-8; JSON is UTF-8 text"}"#);
    assert!(!all);
}

fn any_finite() -> impl Strategy<Value = f64> {
    let bits = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite());
    prop_oneof![8 => bits, 1 => -1e3..1e3_f64, 1 => prop_oneof![Just(0.0), Just(-0.0)]]
}

proptest! {
    #![proptest_config(laws())]

    /// Law: a number keeps every bit when it is read and printed. Oracle: the printing and parsing of the
    /// standard library; the test splits the answer itself.
    #[test]
    fn numbers_come_back_bit_for_bit(x in any_finite(), y in any_finite(), z in any_finite()) {
        // the id is any number, light at most as bright as a scene may say
        let color = [x, y, z].map(|x| x.abs().min(1e30));
        let light = format!(
            r#"{{"ambient": {{"color": [{:e}, {:?}, {:e}]}}}}"#,
            color[0], color[1], color[2]
        );
        let line = format!(r#"{{"id": {x:?}, "light": {{"light": {light}, "from": [0, 0, 0]}}}}"#);
        let answer = probe::answer(&line);
        let id = answer.strip_prefix(r#"{"id":"#).and_then(|rest| rest.split_once(','));
        let (id, rest) = id.expect("the id comes first");
        prop_assert_eq!(id.parse::<f64>().expect("a number").to_bits(), x.to_bits());
        let list = rest.split(['[', ']']).nth(1).expect("a list");
        let back: Vec<u64> =
            list.split(',').map(|n| n.parse::<f64>().expect("a number").to_bits()).collect();
        prop_assert_eq!(back, color.map(f64::to_bits).to_vec());
    }

    /// Law: whatever the bytes, there are as many replies as lines that are not blank. Each is JSON with an
    /// answer or an error, and the status tells whether all are answers.
    #[test]
    fn every_line_gets_one_line_back(
        pieces in prop::collection::vec(prop_oneof![
            any::<Vec<u8>>(),
            Just(b"\n".to_vec()),
            Just(b" \t\r\n".to_vec()),
            Just(b"{\"fresnel\": {\"cos_i\": 1, \"eta\": 1.5}}\n".to_vec()),
            Just(b"{\"intersect\": {\"shape\": {\"instance\":".to_vec()),
        ], 0..20)
    ) {
        let input = pieces.concat();
        let blank = |line: &[u8]| line.iter().all(u8::is_ascii_whitespace);
        let asked = input.split(|&byte| byte == b'\n').filter(|line| !blank(line)).count();
        let (output, all_answered) = served(&input);
        prop_assert_eq!(output.lines().count(), asked);
        let mut errors = 0;
        for line in output.lines() {
            let reply: Value = serde_json::from_str(line).expect("JSON");
            let keys: Vec<&str> =
                reply.as_object().expect("an object").keys().map(String::as_str).collect();
            prop_assert!(keys == ["answer"] || keys == ["error"]);
            errors += usize::from(keys == ["error"]);
        }
        prop_assert_eq!(all_answered, errors == 0);
    }

    /// Law: any JSON `id` comes back unchanged, with an answer and with an error.
    #[test]
    fn ids_are_returned_unchanged(text in any::<String>(), n in any::<i64>(), deep in 0_usize..20) {
        let mut id = json!({"text": text, "n": n, "none": null});
        for _ in 0..deep {
            id = json!([id]);
        }
        for question in
            [json!({"cos_i": 1, "eta": 1}), json!({"cos_i": 2, "eta": 1}), json!({"co": 1})]
        {
            let line = json!({"id": id, "fresnel": question}).to_string();
            let reply: Value = serde_json::from_str(&probe::answer(&line)).expect("JSON");
            prop_assert_eq!(&reply["id"], &id);
        }
    }
}

/// Law: a line that is too long gets one error, and the next line gets its answer.
#[test]
fn a_long_line_is_refused_and_the_next_one_answered() {
    let error = r#"{"error":"the line is longer than 1048576 bytes; put large things into files"}"#;
    let good = r#"{"fresnel": {"cos_i": 1, "eta": 1}}"#;
    let answer =
        r#"{"answer":{"reflected":0.0,"transmitted":1.0,"r_s":0.0,"r_p":0.0,"t_s":1.0,"t_p":1.0}}"#;
    for extra in [1, 2, 3, 1000, 3 << 20] {
        let long = "x".repeat(probe::LONGEST_LINE + extra);
        let (output, _) = served(format!("{long}\n{good}\n").as_bytes());
        assert_eq!(output, format!("{error}\n{answer}\n"), "{extra} bytes too long");
    }
    let padded = format!("{good}{}", " ".repeat(probe::LONGEST_LINE - good.len()));
    assert_eq!(served(padded.as_bytes()).0, format!("{answer}\n"), "just as long as fits");
}

/// Law: an answer can be read before the next question is asked.
#[test]
fn each_answer_is_written_at_once() {
    let mut command = Folder::new().command("groundtruth probe");
    let command = command.current_dir(root()).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.spawn().expect("it starts");
    let mut stdin = child.stdin.take().expect("piped");
    let mut stdout = BufReader::new(child.stdout.take().expect("piped"));
    for id in 0..3 {
        writeln!(stdin, r#"{{"id": {id}, "fresnel": {{"cos_i": 1, "eta": 1}}}}"#)
            .expect("it reads");
        let mut answer = String::new();
        stdout.read_line(&mut answer).expect("it answers");
        assert!(answer.starts_with(&format!(r#"{{"id":{id},"#)), "{answer}");
    }
    drop(stdin);
    assert!(child.wait().expect("it ends").success());
}
