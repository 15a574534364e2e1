//! What a program is asked, counted: windows, restarts, and the cost of a program that hangs, dies or writes other lines.
#![cfg(unix)]

use ask::{Fault, Limits, Program, Reply, Stop, Subject};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

use serde_json::{Value, json};

/// A shell script that writes what it hears into a file, and `start` whenever it starts.
struct Script {
    program: Program,
    log: PathBuf,
    _folder: tempfile::TempDir,
}

/// `n` is the question, `id` its id; `answer` prints its answer.
const HEAD: &str = r#"
echo start >> "$0"
answer() { printf '{"id":%s,"answer":%s}\n' "$id" "$n"; }
each() {
  while IFS= read -r line; do
    id=${line#*:}; id=${id%%,*}; n=${line##*:}; n=${n%%\}*}
    echo "$n" >> "$0"
    "$1"
  done
}
"#;

impl Script {
    /// `one` is the body of a function that is called for each question.
    fn new(before: &str, one: &str, answer: u64, start: u64) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let log = folder.path().join("log");
        let text = format!("{HEAD}\none() {{ {one}\n}}\n{before}\neach one\n");
        let limits =
            Limits { answer: Duration::from_millis(answer), start: Duration::from_millis(start) };
        let command = ["sh", "-c", &text, &log.to_string_lossy()].map(str::to_owned).to_vec();
        Self { program: Program::new(command, limits, Arc::default()), log, _folder: folder }
    }

    /// What it heard, in order.
    fn heard(&self) -> Vec<String> {
        std::fs::read_to_string(&self.log).unwrap_or_default().lines().map(str::to_owned).collect()
    }
}

/// Questions with these numbers.
fn questions(numbers: impl IntoIterator<Item = u64>) -> Vec<Value> {
    numbers.into_iter().map(|n| json!({"number": n})).collect()
}

fn answered(n: u64) -> Reply {
    Ok(json!(n))
}

/// The kinds of replies, as letters: answered, hung, died, garbled, not asked.
fn kinds(replies: &[Reply]) -> String {
    let kind = |reply: &Reply| match reply {
        Ok(_) => 'a',
        Err(Stop::Fault(Fault::Hung(_))) => 'h',
        Err(Stop::Fault(Fault::Died(_))) => 'd',
        Err(Stop::Fault(Fault::Garbled(_))) => 'g',
        Err(Stop::NotAsked) => '-',
        _ => '?',
    };
    replies.iter().map(kind).collect()
}

fn texts(heard: &[&str]) -> Vec<String> {
    heard.iter().map(|it| (*it).to_owned()).collect()
}

/// Law: at most 64 questions are under way; of a program that answers nothing the three first are asked again alone, each after
/// a start, and no other (docs/conform.md). Oracle: what the program heard.
#[test]
fn a_silent_program_hears_64_questions_and_three_again() {
    let mut script = Script::new("", ":", 300, 1500);
    let replies = script.program.ask(&questions(0..130));
    assert_eq!(
        kinds(&replies),
        "hhh".to_owned() + &"-".repeat(127),
        "what became of 130 questions"
    );
    let mut expected = texts(&["start"]);
    expected.extend((0..64).map(|n: u64| n.to_string()));
    expected.extend(texts(&["start", "0", "start", "1", "start", "2"]));
    assert_eq!(script.heard(), expected, "what a silent program heard");
}

/// Law: a right program hears each question once, from one start on, and the 65th only after all 64 before it are answered.
/// Oracle: a program that answers its questions only when it has all of a window.
#[test]
fn the_next_window_comes_when_all_are_answered() {
    let one = r#"
      kept="$kept
$(answer)"; count=$((count + 1))
      case $count in 64 | 128 | 130) printf '%s\n' "$kept"; kept= ;; esac"#;
    let mut script = Script::new("", one, 5000, 5000);
    let replies = script.program.ask(&questions(0..130));
    let expected: Vec<Reply> = (0..130).map(answered).collect();
    assert_eq!(replies, expected, "the replies to 130 questions in windows of 64");
    let mut expected = texts(&["start"]);
    expected.extend((0..130).map(|n: u64| n.to_string()));
    assert_eq!(script.heard(), expected, "what it heard");
}

/// Law: of a window with one guilty question, each other one is answered, the open ones are asked again alone, after a
/// question that was answered before, and nothing else is asked twice. Oracle: which question is guilty, and how.
#[test]
fn one_guilty_question_costs_two_starts() {
    for (way, kind) in [(":", "h"), ("exit 3", "d"), ("echo hello", "g")] {
        let one = format!("case $n in 4) {way} ;; *) answer ;; esac");
        let mut script = Script::new("", &one, 500, 5000);
        let first = script.program.ask(&questions([100]));
        assert_eq!(kinds(&first), "a", "the first question");
        let replies = script.program.ask(&questions(1..8));
        assert_eq!(kinds(&replies), format!("aaa{kind}aaa"), "questions 1 to 7, guilty: 4 ({way})");
        let heard = script.heard();
        let starts: Vec<&[String]> = heard.split(|it| it == "start").skip(1).collect();
        // after the guilty one the window may have been heard, or not
        assert!(starts[0].starts_with(&texts(&["100", "1", "2", "3", "4"])), "{heard:?}");
        // a program that only hangs has answered the others by then
        let again = [&["100", "4"][..], &["100", "5", "6", "7"]].map(texts);
        let again = if kind == "h" { &again[..1] } else { &again };
        assert_eq!(starts[1..], *again, "what was asked after the fault ({way})");
    }
}

/// Law: a program that dies after some answers is asked the open questions again, and three deaths end the rest.
/// Oracle: a program that answers two questions of each start.
#[test]
fn three_deaths_are_the_most() {
    let one = "count=$((count + 1)); case $count in 3) exit 1 ;; *) answer ;; esac";
    let mut script = Script::new("", one, 2000, 5000);
    let replies = script.program.ask(&questions(0..12));
    assert_eq!(kinds(&replies), "aaaadadad---", "what became of 12 questions");
    let heard = script.heard();
    let starts: Vec<&[String]> = heard.split(|it| it == "start").skip(1).collect();
    let again = [&["2", "3", "4"], &["2", "5", "6"], &["2", "7", "8"]].map(|it| texts(it));
    assert_eq!(starts[1..], again, "what each start but the first heard");
}

/// Law: a start that takes longer than an answer may is no fault, at first and after a fault. Oracle: a program that sleeps
/// before it reads, as long as two answers may take; which questions it hangs at.
#[test]
fn a_slow_start_is_not_taken_for_a_slow_answer() {
    let one = "case $n in 2) : ;; *) answer ;; esac";
    let mut script = Script::new("sleep 1", one, 500, 20_000);
    assert_eq!(kinds(&script.program.ask(&questions([7]))), "a", "the first question");
    assert_eq!(kinds(&script.program.ask(&questions(1..4))), "aha", "1 to 3, guilty: 2");
    let expected = ["start", "7", "1", "2", "3", "start", "7", "2"].map(str::to_owned);
    assert_eq!(script.heard(), expected, "what it heard");
}

/// Law: an id that was not asked or was answered before is garbled, and says which of both. Oracle: ids by hand; the first
/// question has the id 1.
#[test]
fn ids_that_are_not_under_way_are_garbled() {
    for (said, words) in [
        ("1", "the question with id 1 was answered twice"),
        ("0", "the question with id 0 was never asked"),
        ("3", "the question with id 3 was never asked"),
        ("99", "the question with id 99 was never asked"),
    ] {
        let one = format!(r#"case $n in 6) id={said} ;; esac; answer"#);
        let mut script = Script::new("", &one, 2000, 5000);
        assert_eq!(script.program.ask(&questions([5])), [answered(5)], "the first question");
        let replies = script.program.ask(&questions([6]));
        let expected = Err(Stop::Fault(Fault::Garbled(words.to_owned())));
        assert_eq!(replies, [expected], "the reply with id {said}");
    }
    // in one window, the question that was answered twice is the guilty one, and the others are asked again
    let mut script = Script::new("", "answer; case $n in 2) answer ;; esac", 2000, 5000);
    let kinds = kinds(&script.program.ask(&questions([1, 2, 3])));
    assert_eq!(kinds, "aga", "1 to 3, of which 2 is answered twice");
}

/// Law: a line of 1 MiB is read, one of a byte more is garbled (docs/conform.md). Oracle: the length of the line.
#[test]
fn a_line_of_a_mebibyte_is_the_longest() {
    // {"id":1,"answer":"…"}
    for (bytes, kind) in [((1 << 20) - 1, "a"), (1 << 20, "a"), ((1 << 20) + 1, "g")] {
        let letters = bytes - r#"{"id":1,"answer":""}"#.len();
        let one = format!(
            r#"printf '{{"id":1,"answer":"'; head -c {letters} /dev/zero | tr '\0' x; printf '"}}\n'"#
        );
        let mut script = Script::new("", &one, 5000, 5000);
        let replies = script.program.ask(&questions([1]));
        assert_eq!(kinds(&replies), kind, "a line of {bytes} bytes");
    }
}

/// Law: the first 64 KiB of the standard error are kept. Oracle: how much is written.
#[test]
fn the_beginning_of_the_standard_error_is_kept() {
    for (bytes, kept) in [(65_535, 65_535), (65_536, 65_536), (65_537, 65_536), (200_000, 65_536)] {
        let before = format!("(printf begin; head -c {} /dev/zero | tr '\\0' x) >&2", bytes - 5);
        let mut script = Script::new(&before, "answer", 5000, 5000);
        assert_eq!(script.program.ask(&questions([1])), [answered(1)], "beside {bytes} bytes");
        // another thread reads it
        let begun = std::time::Instant::now();
        while script.program.log().len() < kept && begun.elapsed() < Duration::from_secs(10) {
            std::thread::sleep(Duration::from_millis(5));
        }
        let log = script.program.log();
        assert!(log.starts_with("begin"), "the log begins with {:?}", &log[..5.min(log.len())]);
        assert_eq!(log.len(), kept, "bytes kept of {bytes}");
    }
}

/// Law: an interrupted program is not asked, and its questions are no faults. Oracle: the flag.
#[test]
fn an_interruption_is_no_fault() {
    let limits = Limits { answer: Duration::from_secs(5), start: Duration::from_secs(5) };
    let command = ["sh", "-c", "sleep 100"].map(str::to_owned).to_vec();
    let mut program = Program::new(command, limits, Arc::new(AtomicBool::new(true)));
    assert_eq!(kinds(&program.ask(&questions(0..70))), "-".repeat(70), "70 questions");
}

/// Law: a program that cannot be started has died of each question, three times; the rest is not asked. Oracle: there is no
/// such file.
#[test]
fn what_cannot_be_started_has_died() {
    let limits = Limits { answer: Duration::from_secs(5), start: Duration::from_secs(5) };
    let nowhere = Path::new("/no/such/program").display().to_string();
    let mut program = Program::new(vec![nowhere], limits, Arc::default());
    assert_eq!(kinds(&program.ask(&questions(0..5))), "ddd--", "5 questions");
}
