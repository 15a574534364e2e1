//! A program that is run for each selected pixel, and whose rays are shown.

use std::fs;
use std::path::Path;
use std::time::Duration;

use clap::Parser;
use eframe::egui::Key;
use egui_kittest::kittest::Queryable;
use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use inspector::action::Shows;
use inspector::explanation::selection::Tab;
use inspector::window::arguments::Arguments;

use crate::support::*;

/// A ray without a pixel.
const RAY: &str = r#"{"origin": [0, 0, 5], "direction": [0, 0, -1], "radiance": 1}"#;

/// A window on a scene of ours, for whose pixels a script of `sh` is run in this folder.
fn window_with(folder: &Path, words: &str, script: &str) -> Window {
    window_sized(folder, ["--size", "48x48"], (words, script))
}

/// The same, with what gives it its size.
fn window_sized(folder: &Path, size: [&str; 2], (words, script): (&str, &str)) -> Window {
    fs::write(folder.join("my tracer.sh"), script).expect("written");
    let command = format!("sh 'my tracer.sh' {words}");
    let scene = ["inspector", "ch28/glass-sphere", "--samples", "1"];
    let words = [&scene[..], &size, &["--pixel", "1,1", "--rays-from", &command]].concat();
    let mut arguments = Arguments::parse_from(words);
    let command = arguments.rays_from.as_mut().expect("there is one");
    (command.folder, command.limit) = (folder.to_owned(), Duration::from_millis(1500));
    started(&arguments)
}

fn radiance(window: &Window) -> Option<Rgb> {
    window.state().selection.explanation().map(|answer| answer.radiance)
}

/// Law: a click runs the program for its pixel, which its words and `RAYS` say; the words are divided as by a shell. Its rays are
/// those of the pixel, also if they name none; the tab stays; T shows ours. A second click runs it again. Oracle: what the program was given, and
/// a radiance made of it.
#[test]
fn a_click_runs_the_program() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = format!(
        "echo \"$1 $2 $RAYS\" >> runs\necho '{}'\n",
        RAY.replace(": 1}", ": '${RAYS%,*}'}")
    );
    let mut window = window_with(folder.path(), "--pixel {x}/{y}", &script);
    set(&mut window, |it| it.selection.tab = Tab::Checks);
    for pixel @ [x, _] in [[12, 8], [30, 20], [30, 20]] {
        click(&mut window, pixel);
        assert_eq!(window.state().selection.pixel, Some(pixel));
        assert_eq!(radiance(&window), Some(Rgb::grey(f64::from(x))));
        assert!(window.state().message.is_none(), "{:?}", window.state().message);
        assert!(window.query_by_label_contains("Not asked").is_some(), "the tab stays");
    }
    let runs = fs::read_to_string(folder.path().join("runs")).expect("it ran");
    let expected = ["1/1 1,1", "12/8 12,8", "30/20 30,20", "30/20 30,20"];
    assert_eq!(runs.lines().collect::<Vec<_>>(), expected.map(|words| format!("--pixel {words}")));
    let command = theirs(&window).program.as_ref().and_then(|it| it.log_command());
    let pasted =
        "RAYS=30,20 sh 'my tracer.sh' --pixel 30/20 > rays.jsonl; groundtruth rays rays.jsonl";
    assert_eq!(command, Some(pasted));

    press(&mut window, Key::T);
    assert_eq!(theirs(&window).shows, Shows::Ours);
    assert!(radiance(&window).is_some_and(|it| it != Rgb::grey(30.0)));
    click(&mut window, [5, 7]);
    assert_eq!(theirs(&window).shows, Shows::Ours, "what is shown stays");
}

/// Law: a program that prints no log may write `rays.jsonl`; one that is left from an earlier run is not read. Oracle: a program that
/// writes it for one pixel only.
#[test]
fn a_new_file_of_rays_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = format!("echo rendering\n[ $RAYS = 5,7 ] && echo '{RAY}' > rays.jsonl\ntrue\n");
    let mut window = window_with(folder.path(), "", &script);
    click(&mut window, [5, 7]);
    assert_eq!(radiance(&window), Some(Rgb::grey(1.0)));
    click(&mut window, [6, 7]);
    let message = window.state().message.clone().expect("an error");
    assert!(message.1 && message.0.contains("no new rays.jsonl"), "{message:?}");
}

/// Law: the picture that is compared is the one under the program's rays. Oracle: a picture of one white pixel.
#[test]
fn its_picture_is_under_its_rays() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut film = Film::new(48, 48);
    film.set([3, 3], Rgb::WHITE);
    read(folder.path(), &film, "mine.png");
    let picture = folder.path().join("mine.png").display().to_string();
    let script = format!("echo '{}'", RAY.replace(": 1}", ": 0.5}"));
    let mut window = window_sized(folder.path(), ["--compare", &picture], ("", &script));
    click(&mut window, [5, 7]);
    assert_eq!(radiance(&window), Some(Rgb::grey(0.5)));
    let of_picture = [[3, 3], [5, 7]].map(|pixel| theirs(&window).pixels.radiance(pixel));
    assert_eq!(of_picture, [Some(Rgb::WHITE), Some(Rgb::BLACK)]);
}

/// Law: a program that fails is told with its command, how it ended, and its messages, and ours is explained; rays that it wrote
/// before are shown all the same. Oracle: scripts.
#[test]
fn a_program_that_fails_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    for (script, told) in [
        ("echo no such scene >&2; exit 3", ["exit status: 3", "\n  no such scene"]),
        ("true", ["wrote no log to its standard output", "no new rays.jsonl"]),
        ("echo '{\"origin\": [0, 0, 0]}'", ["no ray", "no `direction`"]),
        (&format!("echo '{}'", RAY.replace("{", "{\"pixel\": [3, 4], ")), ["pixel (3, 4)", "not"]),
        ("echo busy >&2; sleep 20 & sleep 20", ["ended after 1.5 s", "\n  busy"]),
        (&format!("echo '{RAY}'; exit 9"), ["it failed", "exit status: 9"]),
    ] {
        let mut window = window_with(folder.path(), "", script);
        click(&mut window, [5, 7]);
        let (message, is_error) = window.state().message.clone().expect("an error");
        let expected = ["RAYS=5,7 sh 'my tracer.sh'", told[0], told[1]];
        assert!(is_error && expected.iter().all(|it| message.contains(it)), "{message}");
        let is_theirs = window.state().others.shown().is_some();
        assert_eq!(is_theirs, script.contains("exit 9"), "{script}");
        assert!(radiance(&window).is_some());
    }
}

/// Law: a newer click ends the run under way, with what that has started, and so does the end of the window. Oracle: a program
/// whose child writes a file a second later.
#[test]
fn a_run_is_ended_by_the_next() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = format!(
        "if [ $RAYS = 5,7 ]; then touch begun; (sleep 1; touch late) & wait; fi\necho '{RAY}'\n"
    );
    let mut window = window_with(folder.path(), "", &script);
    let begin = |window: &mut Window| {
        let at = on_screen(window, [5, 7]);
        point_and_press(window, at);
        let begun = folder.path().join("begun");
        wait_until(window, "it runs", |_| begun.exists());
        fs::remove_file(&begun).expect("removed");
    };
    begin(&mut window);
    click(&mut window, [6, 7]);
    assert_eq!(radiance(&window), Some(Rgb::grey(1.0)));
    begin(&mut window);
    drop(window);
    std::thread::sleep(Duration::from_millis(1300));
    assert!(!folder.path().join("late").exists(), "it lives on");
}

/// Law: only the command line names a program: a link that does is refused, and so is a command without a word or with an open
/// quotation mark. Oracle: the messages.
#[test]
fn no_link_runs_a_program() {
    let link = Arguments::of_link("ch28/glass-sphere&rays-from=./mine").err();
    assert!(link.is_some_and(|problem| problem.contains("a link runs no program")));
    for line in ["", " ", "./mine 'a", "# nothing"] {
        let parsed = Arguments::try_parse_from(["inspector", "--rays-from", line]);
        let problem = parsed.expect_err("refused").to_string();
        assert!(problem.contains("no program, or a quotation mark"), "{line}: {problem}");
    }
}
