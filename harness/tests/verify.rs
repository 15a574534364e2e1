//! The command `verify`: its exit statuses and its errors.

#[path = "../judge/tests/verdict/pictures.rs"]
mod films_of_scenes;

use std::path::Path;
use std::process::{Command, Output};

use groundtruth::film::{self, Film, Tone};

use self::films_of_scenes::{films, scene, world};
use crate::same_text::{Printed, hold};

const SCENE: &str = "ch18/rectangle";

fn run(arguments: &[&str]) -> Output {
    let command = Command::new(env!("CARGO_BIN_EXE_groundtruth")).args(arguments).output();
    command.expect("the program runs")
}

/// The exit status, and what was printed.
fn verify(arguments: &[&str]) -> (i32, String) {
    let output = run(&[&["verify"], arguments].concat());
    let printed = [output.stdout, output.stderr].concat();
    (output.status.code().expect("a status"), String::from_utf8(printed).expect("UTF-8"))
}

fn picture(samples: u32, seed: u64) -> Film {
    films(&mut world(&scene(SCENE, [32, 32], samples), 1), std::iter::once(seed)).remove(0)
}

fn written(film: &Film, folder: &Path, name: &str) -> String {
    let file = folder.join(name);
    film::write(film, &Tone::PLAIN, &file).expect("written");
    file.to_str().expect("UTF-8").to_owned()
}

/// Law: the exit status is 0 for a correct picture, 1 for a wrong one, 2 for one that cannot be judged. Oracle: which
/// picture it is.
#[test]
fn every_exit_status() {
    let folder = tempfile::tempdir().expect("a folder");
    let correct = written(&picture(16, 501), folder.path(), "correct.pfm");
    let few = ["--their-samples", "16", "--level", "0.05"];
    // at a level at which few other seeds would have a correct picture called wrong
    let (status, text) = verify(&[SCENE, &correct, "--their-samples", "16", "--level", "0.005"]);
    assert_eq!(status, 0, "{text}");
    for part in [
        "assumed: radiance",
        "mean: ",
        "noise: ",
        "agrees: ",
        "would have been seen",
        "cannot show",
    ] {
        assert!(text.contains(part), "no {part:?} in {text}");
    }
    let mut film = picture(16, 501);
    for x in 0..32 {
        film.set([x, 20], 2.0 * film.get([x, 20]));
    }
    let different = written(&film, folder.path(), "different.pfm");
    let (status, text) = verify(&[&[SCENE, &*different], &few[..]].concat());
    assert_eq!(status, 1, "{text}");
    for part in ["differs: ", "where:", "groundtruth explain ch18/rectangle", "--size 32x32"] {
        assert!(text.contains(part), "no {part:?} in {text}");
    }
    let margin = [SCENE, &*different, "--margin", "50%"];
    assert_eq!(verify(&[&margin[..], &few[..]].concat()).0, 0);
    let (status, json) = verify(&[&[SCENE, &*different, "--json"], &few[..]].concat());
    assert_eq!(status, 1);
    // what is told meanwhile follows
    let mut values = serde_json::Deserializer::from_str(&json).into_iter::<serde_json::Value>();
    let json = values.next().expect("a value").expect("JSON");
    assert_eq!(json["decision"], "differs");
    let (status, text) = verify(&["--scenes", "ch28"]);
    assert_eq!(status, 0);
    assert!(text.contains("schlick"), "{text}");
}

/// Law: bad input is refused with status 2, and the error says what to do. Oracle: what is wrong with it.
#[test]
fn bad_input_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let correct = written(&picture(1, 500), folder.path(), "correct.pfm");
    let mut film = picture(1, 500);
    film.set([3, 4], groundtruth::rgb::Rgb::new(f64::NAN, 0.0, 0.0));
    let not_finite = written(&film, folder.path(), "nan.pfm");
    let wide = written(&Film::new(32, 20), folder.path(), "wide.pfm");
    let transparent = folder.path().join("alpha.png");
    let mut pixels = image::RgbaImage::from_pixel(32, 32, image::Rgba([9, 9, 9, 255]));
    pixels.put_pixel(2, 5, image::Rgba([9, 9, 9, 100]));
    pixels.save(&transparent).expect("written");
    let transparent = transparent.to_str().expect("UTF-8");
    let bad: [(&[&str], &str); 10] = [
        (&[SCENE, &not_finite], "pixel 3, 4 is [NaN"),
        (&[SCENE, &wide], "32 × 20 pixels"),
        (&[SCENE, &correct, &wide], "all pictures must have one size"),
        (&[SCENE, &correct, "--their-samples", "0"], "--their-samples"),
        (&[SCENE, &correct, "--size", "32x32"], "leave it out"),
        (&[SCENE, transparent], "alpha"),
        (&[SCENE, &correct, "--seed", "18446744073709551615"], "--seed: ours have"),
        (&["ch18/rectangel", &correct], "ch18/rectangle"),
        (&["ch11/stereo-pair-that-is-none", &correct], "ch11"),
        (&["--scenes", "glass"], "ch28"),
    ];
    for (arguments, expected) in bad {
        let (status, text) = verify(arguments);
        assert_eq!(status, 2, "{arguments:?}: {text}");
        assert!(text.contains(expected), "{arguments:?}: no {expected:?} in {text}");
    }
}

/// Law: with `--reference` the mean of its replicas is what pictures are held against, and no replica of ours is in
/// it; one of another scene, size, number of samples, or for integers, or a damaged one, is refused with status 2.
/// Oracle: a picture that is a replica of the reference, and none of ours then; what is wrong.
#[test]
fn a_reference_is_held_against() {
    let folder = tempfile::tempdir().expect("a folder");
    let sums = |name: &str, settings: &str| {
        let file = folder.path().join(name).to_str().expect("UTF-8").to_owned();
        let line = format!("render {settings} --replicas 6 --seed 500 -o");
        let arguments: Vec<&str> = line.split(' ').chain([&*file]).collect();
        assert!(run(&arguments).status.success());
        file
    };
    let usual = sums("usual.sums", "ch18/rectangle --size 32x32 --samples 16");
    let theirs = written(&picture(16, 501), folder.path(), "theirs.pfm");
    let few = [SCENE, &theirs, "--their-samples", "16", "--level", "0.005", "--seed", "500"];
    let (status, text) = verify(&few);
    assert!(status == 0 && text.contains("--seed 501, bit for bit"), "{text}");
    let with = |file: &str| verify(&[&few[..], &["--reference", file]].concat());
    let (status, text) = with(&usual);
    assert_eq!(status, 0, "{text}");
    assert!(text.contains("the mean of 6 others of ours\n"), "{text}");
    let other = written(&picture(16, 502), folder.path(), "other.pfm");
    let display = folder.path().join("theirs.png");
    image::RgbImage::new(32, 32).save(&display).expect("written");
    let display = display.to_str().expect("UTF-8");
    for (file, expected) in [
        (sums("samples.sums", "ch18/rectangle --size 32x32 --samples 25"), "samples a replica (25"),
        (sums("size.sums", "ch18/rectangle --size 40x40 --samples 16"), "size (40x40, not 32x32)"),
        (sums("scene.sums", "ch18/disk --size 32x32 --samples 16"), "another scene"),
        (theirs.clone(), "no file of sums"),
    ] {
        let (status, text) = with(&file);
        assert_eq!(status, 2, "{text}");
        assert!(text.contains(expected), "no {expected:?} in {text}");
    }
    for (pictures, expected) in
        [(vec![display], "leave it out, or write EXR"), (vec![&theirs, &*other], "for one picture")]
    {
        let (status, text) = verify(
            &[&[SCENE], &pictures[..], &["--their-samples", "16", "--reference", &usual]].concat(),
        );
        assert_eq!(status, 2, "{text}");
        assert!(text.contains(expected), "no {expected:?} in {text}");
    }
}

/// Law: docs/verify.md shows what its commands print. Oracle: the program.
#[test]
fn the_document_shows_what_is_printed() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/verify.md");
    let document = std::fs::read_to_string(&file).expect("it is there");
    let (mut true_text, mut count) = (document.clone(), 0);
    for block in document.split("```console\n$ groundtruth ").skip(1) {
        let (block, _) = block.split_once("```").expect("it ends");
        let (command, shown) = block.split_once('\n').expect("a command");
        let output = Command::new(env!("CARGO_BIN_EXE_groundtruth"))
            .args(command.split(' '))
            .current_dir(&folder)
            .output();
        let printed = String::from_utf8(output.expect("it runs").stdout).expect("UTF-8");
        let [old, new] =
            [shown, &printed].map(|text| format!("$ groundtruth {command}\n{text}```"));
        true_text = true_text.replacen(&old, &new, 1);
        count += 1;
    }
    assert_eq!(count, 4, "two pictures, each rendered and judged");
    hold(&file, &true_text, Printed::Rounded);
}

/// Law: files with the same values are no pictures of two seeds: both are named, with status 2. Oracle: copies, one of them
/// in another format.
#[test]
fn equal_files_are_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let film = picture(4, 501);
    let [first, other] = [&film, &picture(4, 502)].map(|film| film.clone());
    let files = [(&first, "a.pfm"), (&other, "b.pfm"), (&first, "c.pfm")]
        .map(|(film, name)| written(film, folder.path(), name));
    let (status, text) = verify(&[SCENE, &files[0], &files[1], &files[2]]);
    assert_eq!(status, 2, "{text}");
    assert!(text.contains("a.pfm") && text.contains("c.pfm") && !text.contains("b.pfm"), "{text}");
}

/// Law: the arguments that a verdict names make ours alike, so that a correct picture agrees. Oracle: the sampler of the
/// picture.
#[test]
fn the_named_sampler_makes_ours_alike() {
    let folder = tempfile::tempdir().expect("a folder");
    let regular = groundtruth::samplers::Regular {}.into();
    let regular = films_of_scenes::with_sampler(scene("ch14/set", [24, 16], 4), regular);
    let film = films(&mut world(&regular, 1), std::iter::once(1)).remove(0);
    let file = written(&film, folder.path(), "regular.pfm");
    let given = ["ch14/set", &*file, "--their-samples", "4"];
    let (status, text) = verify(&given);
    assert_eq!(status, 1, "{text}");
    assert!(text.contains("`--their-sampler regular` makes ours alike; it agrees"), "{text}");
    let (status, text) = verify(&[&given[..], &["--their-sampler", "regular"]].concat());
    assert_eq!(status, 0, "{text}");
    let (status, text) = verify(&[&given[..], &["--their-sampler", "even"]].concat());
    assert_eq!(status, 2);
    assert!(text.contains("regular") && text.contains("n_rooks"), "{text}");
}

/// Law: the command that `compare` prints last is run by a shell as it stands, whatever the picture is called, and runs
/// nothing else. Oracle: `sh`, and what the name would make if it were run.
#[test]
#[cfg(unix)]
fn a_printed_command_can_be_pasted() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = "a 'b' $(touch gone) `touch gone`; touch gone &.pfm";
    written(&picture(4, 2), folder.path(), name);
    let program = env!("CARGO_BIN_EXE_groundtruth");
    let here = |mut command: Command| command.current_dir(folder.path()).output().expect("it runs");
    let mut compare = Command::new(program);
    compare.args(["compare", SCENE, name]);
    let text = String::from_utf8(here(compare).stdout).expect("UTF-8");
    let last = text.lines().last().expect("lines");
    let (_, line) = last.split_once("groundtruth verify").expect("the command");
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("\"$0\" verify{line} --samples 4 --replicas 3"), program]);
    let run = here(shell);
    assert_eq!(run.status.code(), Some(0), "{line}: {}", String::from_utf8_lossy(&run.stderr));
    let files = std::fs::read_dir(folder.path()).expect("it is a folder").count();
    assert_eq!(files, 1, "{line} made another file");
}

/// Law: a margin has the exit status of its answer: 0 within it, 1 beyond it, 2 if noise is too large to tell; it counts in
/// place of the verdict. Oracle: a picture 2 % brighter without noise, and a correct one with noise.
#[test]
fn a_margin_has_three_statuses() {
    let folder = tempfile::tempdir().expect("a folder");
    let still = "ch14/set";
    let film = films(&mut world(&scene(still, [24, 16], 1), 1), std::iter::once(1)).remove(0);
    let mut brighter = film.clone();
    for at in (0..16).flat_map(|y| (0..24).map(move |x| [x, y])) {
        brighter.set(at, 1.02 * film.get(at));
    }
    let brighter = written(&brighter, folder.path(), "brighter.pfm");
    let samples = ["--their-samples", "1"];
    for (margin, expected) in [("2.1%", 0), ("1.9%", 1), ("0.021", 0), ("0.019", 1), ("99%", 0)] {
        let (status, text) =
            verify(&[&[still, &*brighter, "--margin", margin], &samples[..]].concat());
        assert_eq!(status, expected, "--margin {margin}: {text}");
    }
    let noisy = written(&picture(16, 501), folder.path(), "noisy.pfm");
    let (status, text) = verify(&[SCENE, &noisy, "--their-samples", "16", "--margin", "0.0001"]);
    assert_eq!(status, 2, "--margin 0.0001 of a picture with noise: {text}");
    assert!(text.contains("cannot tell"), "{text}");
}

/// Law: levels, margins and numbers of replicas are taken in their ranges, and refused one step outside. Oracle: the ranges
/// that `--help` says.
#[test]
fn numbers_are_taken_in_their_ranges() {
    let folder = tempfile::tempdir().expect("a folder");
    let still = "ch14/set";
    let film = films(&mut world(&scene(still, [6, 4], 1), 1), std::iter::once(1)).remove(0);
    let file = written(&film, folder.path(), "same.pfm");
    for (option, value, is_taken) in [
        ("--level", "0.0001", true),
        ("--level", "0.000099", false),
        ("--level", "0.2", true),
        ("--level", "0.21", false),
        ("--level", "nan", false),
        ("--margin", "0.0001%", true),
        ("--margin", "0", false),
        ("--margin", "0%", false),
        ("--margin", "99.9%", true),
        ("--margin", "100%", false),
        ("--margin", "1", false),
        ("--margin", "-1%", false),
        ("--replicas", "3", true),
        ("--replicas", "2", false),
        ("--replicas", "3.5", false),
    ] {
        let (status, text) =
            verify(&[still, &*file, "--their-samples", "1", &format!("{option}={value}")]);
        assert_eq!(status, if is_taken { 0 } else { 2 }, "{option} {value}: {text}");
    }
}
