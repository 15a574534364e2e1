//! Errors: one line about the cause, status 2, and no file.

use super::{files_in, run_in};

/// Arguments, and the first line of the error.
const ERRORS: &[(&[&str], &str)] = &[
    (
        &["explain", "ch16/shadows", "1,1", "-o", "a.png"],
        "error: a.png: the name ends with .html (a page), .obj (the rays as lines), .svg (the rays over the scene) or \
         .json (all numbers)",
    ),
    (
        &["explain", "ch16/shadows", "1,1", "--test", "-o", "a.html"],
        "error: a.html: with --test, the name ends with .rs (a test) or .toml (a scene file)",
    ),
    (
        &["explain", "ch16/shadows", "1,1", "-o", "a.html", "--ray", "7"],
        "error: no ray 7: the sample has 1, numbered from 0",
    ),
    (
        &["explain", "ch16/shadows", "1,1", "-o", "a.svg", "--all"],
        "error: --all: the file shows one sample; choose it with --sample",
    ),
    (
        &["explain", "ch16/shadows", "900,1", "--test"],
        "error: no such pixel or sample: the picture is 300x200, with 16 samples a pixel",
    ),
    (
        &["render", "ch28/glass-spere", "-o", "a.png"],
        "error: no scene `ch28/glass-spere`: neither a gallery name (`groundtruth list` shows them) \
         nor a file; did you mean `ch28/glass-sphere`?",
    ),
    (
        &["render", "nothing", "-o", "a.png"],
        "error: no scene `nothing`: neither a gallery name (`groundtruth list` shows them) nor a file",
    ),
    (
        &["render", "no.toml", "-o", "a.png"],
        "error: no scene `no.toml`: neither a gallery name (`groundtruth list` shows them) nor a file",
    ),
    (
        &["goldens", "accept", "none.toml", "--because", "seen"],
        "error: none.toml: cannot be read: No such file or directory (os error 2)",
    ),
    (
        &["verify", "a.png", "ch28/glass-sphere"],
        "error: ch28/glass-sphere is a scene, not a picture; did you mean `groundtruth verify ch28/glass-sphere a.png`?",
    ),
    (
        &["verify", "ch28/glass-sphere", "ch03/single-sphere"],
        "error: ch03/single-sphere is a scene, not a picture; did you mean `groundtruth compare ch28/glass-sphere \
         ch03/single-sphere`?",
    ),
    (
        &["compare", "no.toml", "a.png"],
        "error: no scene `no.toml`: neither a gallery name (`groundtruth list` shows them) nor a file",
    ),
    (
        &["goldens", "remove", "ch03/single-spheres", "--folder", "no"],
        "error: no/manifest.toml: there is none; run this where the folder `goldens` is, or name a folder by --folder DIR",
    ),
    (
        &["compare", "-", "-"],
        "error: -: the standard input is one file; name another in place of one -",
    ),
    (
        &["verify", "-", "-"],
        "error: -: the standard input is one file; name another in place of one -",
    ),
    (
        &["conform", "-o", "-", "--junit", "-", "--", "true"],
        "error: -: the standard output is one file; name another in place of one -",
    ),
    (&["render", ".", "-o", "a.png"], "error: .: cannot be read: Is a directory (os error 21)"),
    (
        &["render", "ch03/single-sphere", "-o", "a.jpg"],
        "error: a.jpg: unknown picture format; end the name with .png, .ppm, .exr or .pfm",
    ),
    (
        &["render", "ch03/single-sphere", "-o", "."],
        "error: .: unknown picture format; end the name with .png, .ppm, .exr or .pfm",
    ),
    (
        &["render", "ch03/single-sphere", "-o", "no/a.png"],
        "error: no/a.png: cannot be written: there is no folder `no`; make it first",
    ),
    (
        &["render", "ch03/single-sphere", "--size", "0x0", "-o", "a.png"],
        "error: invalid value '0x0' for '--size <WxH>': a size is written as 300x200",
    ),
    (
        &["render", "ch03/single-sphere", "--size", "300", "-o", "a.png"],
        "error: invalid value '300' for '--size <WxH>': a size is written as 300x200",
    ),
    (
        &["render", "ch03/single-sphere", "--size", "9999999999x2", "-o", "a.png"],
        "error: invalid value '9999999999x2' for '--size <WxH>': 9999999999 × 2 pixels are too \
         many; at most 33554432 fit",
    ),
    (
        &["render", "ch03/single-sphere", "--samples", "0", "-o", "a.png"],
        "error: invalid value '0' for '--samples <N>': write a whole number from 1 to 65536",
    ),
    (
        &["render", "ch03/single-sphere", "--samples", "many", "-o", "a.png"],
        "error: invalid value 'many' for '--samples <N>': write a whole number from 1 to 65536",
    ),
    (
        &[
            "render",
            "ch03/single-sphere",
            "--size",
            "200x200",
            "--crop",
            "190,0,20x10",
            "-o",
            "a.png",
        ],
        "error: --crop 190,0,20x10 reaches beyond the picture of 200x200",
    ),
    (
        &["render", "ch03/single-sphere", "--crop", "1,1", "-o", "a.png"],
        "error: invalid value '1,1' for '--crop <X,Y,WxH>': a crop is written as X,Y,WxH, such as 100,50,64x48",
    ),
    (
        &[
            "render",
            "ch03/single-sphere",
            "--size",
            "200x200",
            "--crop",
            "4294967295,0,2x2",
            "-o",
            "a.png",
        ],
        "error: --crop 4294967295,0,2x2 reaches beyond the picture of 200x200",
    ),
    (
        &["render", "ch03/single-sphere"],
        "error: the following required arguments were not provided:",
    ),
    (
        &["explain", "ch03/single-sphere", "200", "0", "--size", "200x200"],
        "error: pixel (200, 0) is outside the picture of 200x200",
    ),
    (
        &["explain", "ch28/glass-sphere", "0", "0", "--sample", "16"],
        "error: no sample 16: the pixel has 16, numbered from 0",
    ),
    (
        &["explain", "ch03/single-sphere", "-1", "0"],
        "error: `-1 0` is no pixel; write column and row as 200,150",
    ),
    (
        &["explain", "ch03/single-sphere", "200"],
        "error: `200` is no pixel; write column and row as 200,150",
    ),
    (
        &["render", "ch03/single-sphere", "--samples", "-4", "-o", "a.png"],
        "error: invalid value '-4' for '--samples <N>': write a whole number from 1 to 65536",
    ),
    (
        &["render", "ch03/single-sphere", "--samples", "1e3", "-o", "a.png"],
        "error: invalid value '1e3' for '--samples <N>': write 1000",
    ),
    (
        &["render", "ch03/single-sphere", "--seed", "-1", "-o", "a.png"],
        "error: invalid value '-1' for '--seed <N>': write a whole number that is at least 0",
    ),
    (
        &["render", "ch03/single-sphere", "--tracer", "Whitted", "-o", "a.png"],
        "error: invalid value 'Whitted' for '--tracer <NAME>': there are: ray_cast, whitted, path_trace, \
         global_trace, path; did you mean `whitted`?",
    ),
    (
        &["goldens", "check"],
        "error: goldens/manifest.toml: there is none; run this where the folder `goldens` is, or name a folder by \
         --folder DIR",
    ),
    (
        &["export", "ch03/single-spheres"],
        "error: no scene `ch03/single-spheres`: neither a gallery name (`groundtruth list` shows \
         them) nor a file; did you mean `ch03/single-sphere`?",
    ),
    (
        &["describe", "ch03/single-spheres"],
        "error: no scene `ch03/single-spheres`: neither a gallery name (`groundtruth list` shows \
         them) nor a file; did you mean `ch03/single-sphere`?",
    ),
    (
        &["describe", "ch28/glass-sphere.toml"],
        "error: no scene `ch28/glass-sphere.toml`: neither a gallery name (`groundtruth list` shows them) nor a file; \
         did you mean `ch28/glass-sphere`?",
    ),
    (
        &["describe", "ch03/single-sphere", "--seed", "7"],
        "error: the seed changes only the noise of a picture, not the scene; leave out --seed",
    ),
    (
        &["goldens", "accept", "ch03/single-sphere", "--because", "x", "--samples", "0"],
        "error: invalid value '0' for '--samples <N>': write a whole number from 1 to 65536",
    ),
    (
        &["render", "ch14/set", "-o", "a.png", "--max-depth", "3"],
        "error: --max-depth: found 3, but the tracer ray_cast follows no rays; these do: whitted, path_trace, global_trace, path",
    ),
    (
        &["explain", "ch14/set", "1", "1", "--tracer", "paths"],
        "error: invalid value 'paths' for '--tracer <NAME>': there are: ray_cast, whitted, path_trace, global_trace, path; did you mean `path`?",
    ),
    (
        &["explain", "ch14/set", "1", "1", "--max-depth", "129"],
        "error: invalid value '129' for '--max-depth <N>': write a whole number from 0 to 128",
    ),
    (
        &["render", "ch12/fisheye", "-o", "a.png", "--size", "5792x5792"],
        "error: --size 5792x5792: 11589 × 5792 pixels of both images and the gap are too many; at \
         most 33554432 fit",
    ),
    (
        &["render", "glass-sphere", "-o", "a.png"],
        "error: no scene `glass-sphere`: neither a gallery name (`groundtruth list` shows them) nor \
         a file; did you mean `ch28/glass-sphere`?",
    ),
    (
        &["render", "ch10/near", "-o", "a.png"],
        "error: no scene `ch10/near`: neither a gallery name (`groundtruth list` shows them) nor a \
         file; did you mean `ch10/near-focus`?",
    ),
    (
        &["list", "ch99"],
        "error: no scenes of a chapter `ch99`; the chapters are: ch03, ch04, ch05, ch06, ch08, ch09, \
         ch10, ch11, ch12, ch14, ch15, ch16, ch17, ch18, ch19, ch20, ch21, ch22, ch23, ch24, ch25, ch26, \
         ch27, ch28, ch29, ch30, ch31",
    ),
    (
        &["mistakes", "glass-sphere"],
        "error: no scene of the gallery (`groundtruth list`) and no mistake (`groundtruth mistakes`) is called \
         `glass-sphere`; did you mean `ch28/glass-sphere`?",
    ),
    (
        &["mistakes", "ch07"],
        "error: no known mistakes of chapter 7; `groundtruth mistakes` lists all",
    ),
    (
        &["export", "ch03/single-sphere", "-o", "no/a.toml"],
        "error: no/a.toml: cannot be written: there is no folder `no`; make it first",
    ),
    (&["export", "ch03/single-sphere", "-o", "."], "error: .: cannot be written: it is a folder"),
    (&["rendr"], "error: unrecognized subcommand 'rendr'"),
];

/// Law: the status is 2, the error is one line about the cause, and no file is left.
#[test]
fn errors_have_status_2_and_leave_no_file() {
    for (arguments, error) in ERRORS {
        let folder = tempfile::tempdir().expect("a folder");
        let run = run_in(folder.path(), arguments);
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.stderr);
        assert_eq!(run.stdout, "", "{arguments:?}");
        let first = run.stderr.lines().next();
        assert_eq!(first, Some(*error), "{arguments:?}");
        assert_eq!(files_in(folder.path()), [""; 0], "{arguments:?}");
    }
}

/// Law: a picture cannot replace a folder.
#[test]
fn a_path_that_cannot_be_written_is_left_as_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("a.png")).expect("a folder");
    let run = run_in(folder.path(), &["render", "ch03/single-sphere", "-o", "a.png"]);
    assert_eq!(run.status, Some(2));
    assert_eq!(run.stderr, "error: a.png: cannot be written: it is a folder\n");
    assert_eq!(files_in(folder.path()), ["a.png"]);
    assert_eq!(files_in(&folder.path().join("a.png")), [""; 0]);
}
