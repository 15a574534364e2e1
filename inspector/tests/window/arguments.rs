//! The parts of the command line that need no window.

use std::path::Path;
use std::process::Command;

use clap::Parser;
use eframe::egui::Context;
use groundtruth::film::{self, Film, Tone};
use groundtruth::render;
use groundtruth::scene::{Scene, Tracer};
use groundtruth::world::World;
use inspector::explanation::copying;
use inspector::picture::worker::Rendering;
use inspector::scene::source::{Built, Source};
use inspector::splits::Mode;
use inspector::window::arguments::Arguments;

use crate::support::small;

/// Law: what cannot be opened is reported on standard error, with status 2 and without a window: scenes, arguments that do not fit,
/// pictures that cannot be compared, logs without a ray. Oracle: the messages, of scenes the library's.
#[test]
fn what_cannot_be_opened_is_reported_before_a_window_opens() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (text, odd) = (folder.path().join("text.png"), folder.path().join("odd.exr"));
    std::fs::write(&text, "no picture").expect("writable");
    film::write(&Film::new(40, 30), &Tone::PLAIN, &odd).expect("writable");
    let [text, odd] = [&text, &odd].map(|path| path.to_str().expect("UTF-8"));
    let missing = "no-such-folder/scene.toml";
    let error = scenefile::read(missing.as_ref()).expect_err("it is not there");
    let small = "ch03/three-objects --size 12x10 --samples 4 --pixel";
    for (arguments, words) in [
        (missing, &*format!("error: {error}\n")),
        ("ch99/nothing", &format!("error: {}\n", gallery::unknown("ch99/nothing"))),
        ("--size 12", "a size is written as 300x200"),
        ("--size 0x3", "a size is written as 300x200"),
        ("--samples 99999", "found 99999, but 1 to 65536 fit"),
        ("--seed x", "invalid digit found in string"),
        ("--sample 0", "--pixel <X,Y>"),
        ("--pixel left", "write column and row as 200,150"),
        (&format!("{small} 12,9"), "error: pixel (12, 9) is outside the picture of 12x10\n"),
        (
            &format!("{small} 11,9 --sample 4"),
            "error: no sample 4: the pixel has 4, numbered from 0\n",
        ),
        ("-", "error: -: the window reads a scene file again"),
        ("--compare missing.png", "missing.png"),
        (&format!("--compare {text}"), "text.png"),
        (&format!("--compare {odd} --size 40x30"), "cannot be used with"),
        ("--encoding linear", "--compare <FILE>"),
        (&format!("--rays {text}"), "no ray"),
        (&format!("--compare {odd} --encoding cie"), "srgb, linear or gamma=2.2"),
        (
            &format!("ch12/three-spheres --compare {odd}"),
            "a picture of 40 columns is no stereo pair",
        ),
    ] {
        let program = env!("CARGO_BIN_EXE_inspector");
        let output = Command::new(program).args(arguments.split(' ')).output();
        let output = output.expect("the program starts");
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {error}");
        let is_told = if words.starts_with("error: ") {
            error.starts_with(words)
        } else {
            error.contains(words)
        };
        assert!(is_told, "{arguments}: {error}");
    }
}

/// Law: a link to the page asks for what the same words ask on the command line, in any order, and fails with its message.
/// Oracle: the command line.
#[test]
fn a_link_is_a_command_line() {
    let link = "ch28/glass-sphere&view=both&pixel=282,244&size=300x300&sample=3&&samples=4";
    let words = "inspector --size 300x300 --samples 4 --pixel 282,244 --sample 3 --view both ch28/glass-sphere";
    let same = |link: &str, words: &str| {
        let [of_link, typed] = [
            Arguments::of_link(link),
            Arguments::try_parse_from(words.split(' ')).map_err(|error| error.to_string()),
        ];
        let [of_link, typed] = [of_link, typed].map(|it| it.map(|it| format!("{it:?}")));
        assert_eq!(of_link, typed, "{link}");
    };
    same(link, words);
    same("ch14/page-one", "inspector ch14/page-one");
    for empty in ["", "&", "&&"] {
        same(empty, "inspector");
    }
    for (link, words) in [
        ("ch14/page-one&sample=3", "inspector --sample=3 -- ch14/page-one"),
        ("ch14/page-one&pixel=3", "inspector --pixel=3 -- ch14/page-one"),
        ("ch14/page-one&speed=3", "inspector --speed=3 -- ch14/page-one"),
        ("ch14/page-one&view", "inspector --view -- ch14/page-one"),
    ] {
        same(link, words);
        assert!(Arguments::of_link(link).is_err(), "{link}");
    }
    // a name that begins with a dash is no option
    assert_eq!(Arguments::of_link("-h").expect("a name").scene.as_deref(), Some("-h"));
}

/// Law: the link that is copied opens the same scene, as it is changed in the window, at the same sample and view; a scene
/// that a link cannot say has none. Oracle: the scenes as text; the bits of the sample.
#[test]
fn a_copied_link_opens_the_same_sample() {
    let ctx = Context::default();
    let entry = gallery::find("ch28/glass-sphere").expect("in the gallery");
    let rendering = |change: &dyn Fn(&mut Scene), seed: u64| {
        let read = (entry.build)();
        let mut scene = read.clone();
        scene.image.resize(60, 60);
        change(&mut scene);
        let built = Built::of((Source::Gallery(entry), read.into()), scene, seed);
        Rendering::start(&ctx, built.expect("a valid scene"), 0)
    };
    let set = |name: &str, depth: u32| {
        let tracer: Tracer = name.parse().expect("a tracer");
        move |scene: &mut Scene| {
            scene.tracer.change(Some(tracer), Some(depth)).expect("it has a depth");
        }
    };
    let (whitted, path) = (set("whitted", 3), set("path", 7));
    let changes: [&dyn Fn(&mut Scene); 5] =
        [&|_| {}, &|scene| scene.image.samples = 9, &whitted, &path, &|scene| {
            scene.image.resize(31, 33);
        }];
    for (k, change) in changes.into_iter().enumerate() {
        for (seed, sample, view) in
            [(1, 0, Mode::Picture), (77, 1, Mode::Both), (1, 2, Mode::Space)]
        {
            let rendering = rendering(change, seed);
            let link = copying::link(&rendering, [12, 21], sample, view).expect("it has a link");
            let opened = Arguments::of_link(&link).expect(&link);
            let loaded = opened.load(None).expect(&link);
            let texts = [&loaded.built.scene, &rendering.scene]
                .map(|scene| scenefile::to_toml(scene).expect("plain data"));
            assert_eq!(texts[0], texts[1], "{link}");
            assert_eq!((opened.pixel, opened.view), (Some([12, 21]), view), "{link}");
            let said = opened.sample.unwrap_or(0);
            assert_eq!(said, sample, "{link}");
            let of = |world: &World| render::sample(world, [12, 21], said, &mut ());
            assert_eq!(of(&loaded.built.world), of(&rendering.world), "{link}");
            let parts = link.split('&').count();
            // the name and the pixel; what else differs
            let others =
                [seed != 1, sample > 0, view != Mode::Picture].iter().filter(|it| **it).count();
            let own = [1, 2, 3, 3, 1][k];
            assert_eq!(parts, 2 + others + own, "{link}");
        }
    }
    let dark = rendering(&|scene| scene.lights[0].enabled = false, 1);
    assert_eq!(copying::link(&dark, [12, 21], 0, Mode::Picture), None);
    let source = (Source::File("a.toml".into()), std::sync::Arc::new((entry.build)()));
    let file = Built::of(source, (entry.build)(), 1).expect("a scene");
    let file = Rendering::start(&ctx, file, 0);
    assert_eq!(copying::link(&file, [12, 21], 0, Mode::Picture), None);
}

/// Law: without a screen, one line says what helps, with status 2; a scene file with an error, for which a window would
/// open, is reported before it. Oracle: the script that is named.
#[cfg(target_os = "linux")]
#[test]
fn without_a_screen_one_line_says_what_helps() {
    let script = "scripts/headless.sh";
    assert!(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(script).exists());
    let folder = tempfile::tempdir().expect("a temporary folder");
    let broken = folder.path().join("broken.toml");
    std::fs::write(&broken, "image = { width = 3 }\n").expect("writable");
    let error = scenefile::read(&broken).expect_err("it is broken").to_string();
    let broken = broken.to_str().expect("UTF-8");
    for (scene, before) in
        [("ch03/single-sphere", String::new()), (broken, format!("error: {error}\n"))]
    {
        let mut program = Command::new(env!("CARGO_BIN_EXE_inspector"));
        for display in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            program.env_remove(display);
        }
        let output = program.arg(scene).output().expect("the program starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        let last = said.strip_prefix(&before).expect("the scene's error comes first");
        assert_eq!(last.lines().count(), 1, "{last}");
        assert!(last.starts_with("error: no screen for the window"), "{last}");
        assert!(last.contains(script), "{last}");
    }
}

/// Law: size, samples, seed, pixel and sample are those of the arguments. Oracle: the library's
/// rendering with the same settings.
#[test]
fn the_arguments_are_followed() {
    let line =
        "inspector ch28/glass-sphere --size 40x30 --samples 9 --seed 7 --pixel 17,12 --sample 5";
    let arguments = Arguments::parse_from(line.split(' '));
    let loaded = arguments.load(None).expect("they fit");
    let scene = small("ch28/glass-sphere", [40, 30], 9);
    let world = World::build_seeded(&scene, Path::new(""), 7).expect("the scene is valid");
    assert_eq!(loaded.built.world.picture_size(), [40, 30]);
    let expected = render::render(&world);
    assert_eq!(render::render(&*loaded.built.world).pixels(), expected.pixels());
    let usual = World::build(&scene).expect("the scene is valid");
    assert_ne!(expected.pixels(), render::render(&usual).pixels(), "the seed must count");
    assert_eq!((arguments.pixel, arguments.sample), (Some([17, 12]), Some(5)));
}

/// Law: our picture gets the size of theirs, also as a stereo pair. Oracle: the size of the file.
#[test]
fn our_picture_has_the_size_of_theirs() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("theirs.pfm");
    film::write(&Film::new(45, 30), &Tone::PLAIN, &path).expect("writable");
    for scene in ["ch28/glass-sphere", "ch12/three-spheres"] {
        let path = path.to_str().expect("UTF-8");
        let arguments = Arguments::parse_from(["inspector", scene, "--compare", path]);
        let theirs = arguments.theirs().expect("a picture");
        let loaded = arguments.load(theirs.first()).expect("it fits");
        assert_eq!(loaded.built.world.picture_size(), [45, 30], "{scene}");
    }
}
