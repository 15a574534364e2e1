//! `groundtruth verify`: its exit statuses and its errors.

use groundtruth::rgb::Rgb;

use crate::kit::{Folder, Run, repaint, root, text_of};
use testkit::same_text::{Printed, hold};

const SCENE: &str = "ch18/rectangle";

/// A folder with a correct picture of the scene, which has noise.
fn correct() -> Folder {
    let folder = Folder::new();
    render(&folder, "correct.pfm", "--samples 16 --seed 501");
    folder
}

fn render(folder: &Folder, name: &str, options: &str) {
    folder.good(&format!("groundtruth render {SCENE} --size 32x32 {options} -o {name}"));
}

fn verify(folder: &Folder, line: &str) -> Run {
    folder.run(&format!("groundtruth verify {line}"))
}

/// Law: the exit status is 0 for a correct picture, 1 for a wrong one, 2 for one that cannot be judged. Oracle: which
/// picture it is.
#[test]
fn every_exit_status() {
    let folder = &Folder::new();
    folder.good(
        "groundtruth render ch18/rectangle --size 16x16 --samples 16 --seed 501 -o correct.pfm",
    );
    repaint(folder, "correct.pfm", "different.pfm", &|index, color| {
        if index / 16 == 10 { 2.0 * color } else { color }
    });
    let agrees = ["assumed: radiance", "mean: ", "noise: ", "agrees: "];
    // at a level at which few other seeds would have a correct picture called wrong
    verify(folder, &format!("{SCENE} correct.pfm --their-samples 16 --level 0.005"))
        .expect(0, &agrees)
        .expect(0, &["would have been seen", "cannot show"]);
    let wrong = format!("{SCENE} different.pfm --their-samples 16 --level 0.05");
    let words = ["differs: ", "where:", "groundtruth explain ch18/rectangle", "--size 16x16"];
    verify(folder, &wrong).expect(1, &words);
    verify(folder, &format!("{wrong} --margin 99%")).expect(0, &[]);
    let json = verify(folder, &format!("{wrong} --json")).expect(1, &[]).json();
    assert_eq!(json["decision"], "differs");
    verify(folder, "--scenes ch28").expect(0, &["schlick"]);
}

/// Law: bad input is refused with status 2, and the error says what to do. Oracle: what is wrong with it.
#[test]
fn bad_input_is_refused() {
    let folder = &correct();
    repaint(folder, "correct.pfm", "nan.pfm", &|index, color| {
        if index == 4 * 32 + 3 { Rgb::new(f64::NAN, 0.0, 0.0) } else { color }
    });
    folder.good("groundtruth render ch14/set --size 32x20 -o wide.pfm");
    let mut pixels = image::RgbaImage::from_pixel(32, 32, image::Rgba([9, 9, 9, 255]));
    pixels.put_pixel(2, 5, image::Rgba([9, 9, 9, 100]));
    pixels.save(folder.path().join("alpha.png")).expect("written");
    for (line, words) in [
        ("ch18/rectangle nan.pfm", "pixel 3, 4 is [NaN"),
        ("ch18/rectangle wide.pfm", "32 × 20 pixels"),
        ("ch18/rectangle correct.pfm wide.pfm", "all pictures must have one size"),
        ("ch18/rectangle correct.pfm --their-samples 0", "--their-samples"),
        ("ch18/rectangle correct.pfm --size 32x32", "leave it out"),
        ("ch18/rectangle alpha.png", "alpha"),
        ("ch18/rectangle correct.pfm --seed 18446744073709551615", "--seed: ours have"),
        ("ch18/rectangel correct.pfm", "ch18/rectangle"),
        ("ch11/stereo-pair-that-is-none correct.pfm", "ch11"),
        ("--scenes glass", "ch28"),
    ] {
        verify(folder, line).expect(2, &[words]);
    }
}

/// Law: with `--reference` the mean of its replicas is what pictures are held against, and no replica of ours is in
/// it; one of another scene, size, number of samples, or for integers, or a damaged one, is refused with status 2.
/// Oracle: a picture that is a replica of the reference, and none of ours then; what is wrong.
#[test]
fn a_reference_is_held_against() {
    let folder = &correct();
    for (name, scene) in [
        ("usual", "ch18/rectangle --size 32x32 --samples 16"),
        ("samples", "ch18/rectangle --size 32x32 --samples 25"),
        ("size", "ch18/rectangle --size 40x40 --samples 16"),
        ("scene", "ch18/disk --size 32x32 --samples 16"),
    ] {
        folder.good(&format!("groundtruth render {scene} --replicas 6 --seed 500 -o {name}.sums"));
    }
    render(folder, "other.pfm", "--samples 16 --seed 502");
    image::RgbImage::new(32, 32).save(folder.path().join("black.png")).expect("written");
    let usual = format!("{SCENE} correct.pfm --their-samples 16 --level 0.005 --seed 500");
    verify(folder, &usual).expect(0, &["--seed 501, bit for bit"]);
    let of_usual = "the mean of 6 others of ours\n";
    verify(folder, &format!("{usual} --reference usual.sums")).expect(0, &[of_usual]);
    for (reference, words) in [
        ("samples.sums", "samples a replica (25"),
        ("size.sums", "size (40x40, not 32x32)"),
        ("scene.sums", "another scene"),
        ("correct.pfm", "no file of sums"),
    ] {
        verify(folder, &format!("{usual} --reference {reference}")).expect(2, &[words]);
    }
    for (pictures, words) in
        [("black.png", "leave it out, or write EXR"), ("correct.pfm other.pfm", "for one picture")]
    {
        let line = format!("{SCENE} {pictures} --their-samples 16 --reference usual.sums");
        verify(folder, &line).expect(2, &[words]);
    }
}

/// Law: docs/verify.md shows what its commands print. Oracle: the program.
#[test]
fn the_document_shows_what_is_printed() {
    let folder = Folder::new();
    let document = text_of("docs/verify.md");
    let (mut true_text, mut count) = (document.clone(), 0);
    for block in document.split("```console\n$ ").skip(1) {
        let (block, _) = block.split_once("```").expect("it ends");
        let (command, shown) = block.split_once('\n').expect("a command");
        let printed = folder.run(command).stdout;
        let [old, new] = [shown, &printed].map(|text| format!("$ {command}\n{text}```"));
        true_text = true_text.replacen(&old, &new, 1);
        count += 1;
    }
    assert_eq!(count, 4, "two pictures, each rendered and judged");
    hold(&root().join("docs/verify.md"), &true_text, Printed::Rounded);
}

/// Law: files with the same values are no pictures of two seeds: both are named, with status 2. Oracle: copies.
#[test]
fn equal_files_are_named() {
    let folder = &correct();
    render(folder, "b.pfm", "--samples 16 --seed 502");
    folder.good("cp correct.pfm c.pfm");
    let told = verify(folder, &format!("{SCENE} correct.pfm b.pfm c.pfm"));
    let told = told.expect(2, &["correct.pfm", "c.pfm"]).stderr;
    assert!(!told.contains("b.pfm"), "{told}");
}

/// Law: the arguments that a verdict names make ours alike, so that a correct picture agrees. Oracle: the sampler of the
/// picture.
#[test]
fn the_named_sampler_makes_ours_alike() {
    let folder = &Folder::new();
    folder.good("groundtruth export ch14/set --size 24x16 --samples 4 -o set.toml");
    let regular =
        folder.text("set.toml").replacen("[image]\n", "[image]\nsampler.regular = {}\n", 1);
    folder.write("regular.toml", regular);
    folder.good("groundtruth render regular.toml --seed 1 -o regular.pfm");
    let given = "ch14/set regular.pfm --their-samples 4";
    let named = "`--their-sampler regular` makes ours alike; it agrees";
    verify(folder, given).expect(1, &[named]);
    verify(folder, &format!("{given} --their-sampler regular")).expect(0, &[]);
    verify(folder, &format!("{given} --their-sampler even")).expect(2, &["regular", "n_rooks"]);
}

/// Law: the command that `compare` prints last is run by a shell as it stands, whatever the picture is called, and runs
/// nothing else. Oracle: `sh`, and what the name would make if it were run.
#[test]
#[cfg(unix)]
fn a_printed_command_can_be_pasted() {
    let folder = correct();
    let name = "a 'b' $(touch gone) `touch gone`; touch gone &.pfm";
    std::fs::rename(folder.path().join("correct.pfm"), folder.path().join(name)).expect("named");
    let text = folder.run("groundtruth compare ch18/rectangle *.pfm").stdout;
    let last = text.lines().last().expect("lines");
    let (_, line) = last.split_once("groundtruth verify").expect("the command");
    verify(&folder, &format!("{line} --samples 16 --replicas 3")).expect(0, &[]);
    assert_eq!(folder.names(), [name], "{line} made another file");
}

/// Law: a margin has the exit status of its answer: 0 within it, 1 beyond it, 2 if noise is too large to tell; it counts in
/// place of the verdict. Oracle: a picture 2 % brighter without noise, and a correct one with noise.
#[test]
fn a_margin_has_three_statuses() {
    let folder = &correct();
    folder.good("groundtruth render ch14/set --size 24x16 --samples 1 --seed 1 -o still.pfm");
    repaint(folder, "still.pfm", "brighter.pfm", &|_, color| 1.02 * color);
    for (margin, expected) in [("2.1%", 0), ("1.9%", 1), ("0.021", 0), ("0.019", 1), ("99%", 0)] {
        let line = format!("ch14/set brighter.pfm --their-samples 1 --margin {margin}");
        verify(folder, &line).expect(expected, &[]);
    }
    let noisy = format!("{SCENE} correct.pfm --their-samples 16 --margin 0.0001");
    verify(folder, &noisy).expect(2, &["cannot tell"]);
}
