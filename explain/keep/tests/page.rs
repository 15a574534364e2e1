//! The page of a pixel: one file, well formed, with all rays and nothing from elsewhere.

use std::path::Path;

use explain::PixelExplanation;
use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::world::World;
use keep::{PixelPage, SmallPicture};
use text::digits::shortened;

use testkit::markup::fault;

fn page_of(
    name: &str,
    (scene, world): (&Scene, &World),
    pixel: [u32; 2],
    only: Option<u32>,
) -> (PixelExplanation, String) {
    let explanation = explain::pixel(scene, world, pixel, only).unwrap();
    let picture = SmallPicture::of(&Film::new(40, 30), 1);
    let page = PixelPage {
        name,
        scene,
        world,
        explanation: &explanation,
        picture: &picture,
        ray: None,
        command: "groundtruth explain <&>",
    };
    let html = page.html();
    (explanation, html)
}

fn of_gallery(name: &str, pixel: [u32; 2]) -> (PixelExplanation, String) {
    let scene = (gallery::find(name).expect("a scene of the gallery").build)();
    let world = World::build(&scene).unwrap();
    page_of(name, (&scene, &world), pixel, Some(0))
}

/// Law: tags close, there is no script and nothing from elsewhere, every ray has its line, and numbers have four digits at
/// most. Oracle: the file's text, and the explanation.
#[test]
fn a_page_is_one_file_with_every_ray() {
    for (name, pixel) in [
        ("ch28/glass-sphere", [200, 150]),
        ("ch24/floor-mirror", [100, 150]),
        ("ch16/shadows", [200, 150]),
    ] {
        let (explanation, html) = of_gallery(name, pixel);
        assert_eq!(fault(&html), None);
        for part in ["src=\"", "href=\""] {
            let from_elsewhere =
                html.split(part).skip(1).find(|rest| !rest.starts_with("data:image/png;base64,"));
            assert_eq!(from_elsewhere, None, "{name}");
        }
        assert!(!html.contains("<script") && !html.contains("<link") && !html.contains("@import"));
        let rest = html.replace("http://www.w3.org/2000/svg", "");
        assert!(!rest.contains("://") && !rest.contains("url("), "{name}: an address");
        let root = explanation.samples[0].ray.as_ref().unwrap();
        for ray in root.rays() {
            let line = format!("<summary data-ray=\"{}\">", ray.number);
            assert_eq!(html.matches(&line).count(), 1, "{name}: ray {}", ray.number);
            for term in ray.terms.iter().filter(|_| !ray.is_shadow()) {
                let formula = shortened(&ray.formula(term).to_string());
                let line = format!("<li class=\"formula\">{formula}</li>");
                assert!(html.contains(&line), "{name}: {line}");
            }
        }
        let lines = html.replace(" class=\"formula\"", "");
        let lines = lines.split("<li>").skip(1).map(|rest| rest.split("</li>").next().unwrap());
        let long: Vec<&str> = lines.filter(|line| shortened(line) != **line).collect();
        assert!(long.is_empty(), "{name}: more than four digits: {long:?}");
        assert!(html.contains("<code>groundtruth explain &lt;&amp;&gt;</code>"));
        assert!(html.contains("size: A4") && html.contains("color-scheme: light"));
    }
}

/// Law: a small picture has each n-th pixel of the whole one, and its sides are at most 480. Oracle: the whole picture.
#[test]
fn a_small_picture_has_each_nth_pixel() {
    let mut scene = (gallery::find("ch16/no-shadows").unwrap().build)();
    scene.image.resize(500, 334);
    scene.image.samples = 1;
    let world = World::build(&scene).unwrap();
    let small = SmallPicture::rendered(&world);
    assert_eq!([small.film.width(), small.film.height()], [250, 167]);
    for at in [[0, 0], [100, 80], [249, 166], [33, 120]] {
        assert_eq!(small.film.get(at), render::pixel(&world, at.map(|it| 2 * it)));
    }
}

/// A page without its pictures, and with the beginnings of long lines.
fn shortened_page(html: &str) -> String {
    let line = |line: &str| match line.char_indices().nth(400) {
        Some((end, _)) => format!("{} …", &line[..end]),
        None => line.to_owned(),
    };
    let lines = html.lines().filter(|line| !line.contains(";base64,"));
    lines.map(line).collect::<Vec<_>>().join("\n")
}

/// Law: tags close, and no text of a scene is markup. Golden: the pages of a mirror with a ball in it, of all samples, of one and of a
/// pixel without a hit: trees, folded but for the first, the values of samples, the parts of lights and lobes, bars.
#[test]
fn pages_read_as_before() {
    let text = r#"
        about = "<script>alert('about')</script>"
        image = { width = 5, height = 5, samples = 4 }
        camera = { eye = [0, 0, 10], lens.orthographic = {} }
        tracer.whitted = { max_depth = 2 }
        [[lights]]
        name = "\"><script>lamp</script>"
        source.point = { location = [0, 3, 8], ls = 1 }
        [[lights]]
        name = "sun"
        source.directional = { direction = [1, 1, 1], ls = 1 }
        [[materials]]
        name = "<b>"
        recipe.reflective = { phong = { kd = 0.5, cd = 1, ks = 0.2, exponent = 3 }, kr = 0.5 }
        [[objects]]
        name = "<script>ball</script>&"
        material = "<b>"
        shape.sphere = { center = [0, 0, 0], radius = 1.5 }
    "#;
    let (scene, world) = scenefile::from_toml(text, Path::new("here.toml")).unwrap();
    let mut pages = String::new();
    for (pixel, only) in [([2, 2], None), ([2, 1], Some(2)), ([0, 0], Some(0))] {
        let (_, html) = page_of("</title><script>", (&scene, &world), pixel, only);
        assert_eq!(fault(&html), None);
        assert!(!html.contains("<script") && !html.contains("<b>\""));
        let (_, body) = html.split_once("<body").expect("a body");
        pages += &format!("== {pixel:?}, {only:?}\n{}\n", shortened_page(body));
    }
    insta::assert_snapshot!(pages);
}
