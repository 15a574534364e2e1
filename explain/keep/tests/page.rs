//! The page of a pixel: one file, well formed, with all rays and nothing from elsewhere.

use std::path::Path;

use groundtruth::explain::{self, PixelExplanation};
use groundtruth::film::Film;
use groundtruth::render;
use groundtruth::scene::Scene;
use groundtruth::trace::RayKind;
use groundtruth::world::{self, World};
use keep::{PixelPage, SmallPicture};
use text::digits::shortened;

use testkit::markup::fault;

fn page(
    name: &str,
    (scene, world): (&Scene, &World),
    pixel: [u32; 2],
) -> (PixelExplanation, String) {
    page_of(name, (scene, world), pixel, Some(0))
}

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
    page(name, (&scene, &world), pixel)
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
            let is_shadow = matches!(ray.kind, RayKind::Shadow { .. });
            for term in ray.terms.iter().filter(|_| !is_shadow) {
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

/// Law: the page of glass says Snell's law with its numbers. By hand: ray 0 enters glass of index 1.5.
#[test]
fn the_page_of_glass_says_snells_law() {
    let (explanation, html) = of_gallery("ch28/glass-sphere", [200, 150]);
    let hit = explanation.samples[0].ray.as_ref().unwrap().hit.as_ref().unwrap();
    let angle = text::digits::short(hit.angle_of_incidence);
    assert!(
        html.contains("n₁ sin θ₁ = n₂ sin θ₂:<") && html.contains(&format!(">1 × sin {angle}° = "))
    );
}

/// Law: no text of a scene is markup. Oracle: the file's text.
#[test]
fn names_of_a_scene_are_escaped() {
    let text = r#"
        about = "<script>alert('about')</script>"
        image = { width = 5, height = 5 }
        camera = { eye = [0, 0, 10], lens.orthographic = {} }
        [[lights]]
        name = "\"><script>lamp</script>"
        source.point = { location = [0, 3, 8], ls = 1 }
        [[materials]]
        name = "<b>"
        recipe.matte = { kd = 1, cd = [1, 1, 1] }
        [[objects]]
        name = "<script>ball</script>&"
        material = "<b>"
        shape.sphere = { center = [0, 0, 0], radius = 1 }
    "#;
    let (scene, world) = world::from_toml(text, Path::new("here.toml")).unwrap();
    let (_, html) = page("</title><script>", (&scene, &world), [2, 2]);
    assert_eq!(fault(&html), None);
    assert!(!html.contains("<script") && !html.contains("<b>\""));
    assert!(html.contains("&lt;script&gt;ball&lt;/script&gt;&amp;"));
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

/// Law: a pixel that no ray sees has a page as well. Oracle: well-formed text.
#[test]
fn a_pixel_without_a_hit_has_a_page() {
    let (_, html) = of_gallery("ch03/single-sphere", [0, 0]);
    assert_eq!(fault(&html), None);
    assert!(html.contains("hits nothing"));
}

/// A pixel of glass of several samples, on its page: one sample, or all.
fn of_samples(only: Option<u32>) -> (PixelExplanation, String) {
    let mut scene = (gallery::find("ch28/glass-sphere").expect("a scene of the gallery").build)();
    scene.image.samples = 4;
    let world = World::build(&scene).unwrap();
    page_of("glass", (&scene, &world), [200, 150], only)
}

/// Law: a page of one sample of several says which, and lists the value of each. Oracle: the explanation of all samples.
#[test]
fn a_page_of_one_sample_says_which_and_lists_the_values_of_all() {
    let (all, _) = of_samples(None);
    assert!(all.samples.len() >= 4, "samples: found {}, expected 4 or more", all.samples.len());
    let (_, html) = of_samples(Some(2));
    assert_eq!(fault(&html), None);
    let said = format!("This page shows sample 2 of {}", all.samples.len());
    assert!(html.contains(&said), "no `{said}` on the page");
    for sample in &all.samples {
        let value = text::digits::three(sample.radiance.to_array());
        let mark = if sample.index == 2 { "shown" } else { "" };
        let start = format!("<tr><th>{}</th>", sample.index);
        let end = format!(" {value}</td><td>{mark}</td></tr>");
        let row = html.lines().find(|line| line.contains(&start));
        let is_it = row.is_some_and(|row| row.ends_with(&end));
        assert!(is_it, "the row of sample {}: {row:?}, not …{end}", sample.index);
    }
    assert_eq!(html.matches("<div class=\"tree\">").count(), 1, "trees on the page");
}

/// Law: a page of all samples has the tree of each, folded but for the first, with all of its rays, as long as they fit;
/// drawings belong to the first alone. Oracle: the explanation.
#[test]
fn a_page_of_all_samples_has_the_tree_of_each() {
    let (all, html) = of_samples(None);
    assert_eq!(fault(&html), None);
    assert!(html.contains("Section and space show sample 0."), "which sample is drawn");
    let parts: Vec<&str> = html.split("<details class=\"sample\"").skip(1).collect();
    assert_eq!(parts.len(), all.samples.len(), "samples on the page");
    for (part, sample) in parts.iter().zip(&all.samples) {
        let is_first = sample.index == 0;
        let of = format!("sample {}", sample.index);
        assert_eq!(part.starts_with(" open"), is_first, "whether {of} is unfolded");
        let value = text::digits::three(sample.radiance.to_array());
        assert!(part.contains(&format!("Sample {}: ", sample.index)), "the head of {of}");
        let head = format!(" radiance {value}</summary>");
        assert!(part.contains(&head), "no `{head}` at {of}");
        let root = sample.ray.as_ref().expect("it hits the glass");
        for ray in root.rays() {
            let line = shortened(&ray.line()).replace("  ", " · ");
            assert!(part.contains(&text::html::escaped(&line)), "no `{line}` at {of}");
        }
        let is_linked = part.contains("<summary data-ray=");
        assert_eq!(is_linked, is_first, "whether {of} is linked with the drawings");
    }
}

/// Law: the page lists each light and each lobe with its part of the pixel, and beside each ray stands a bar as long as its
/// part of the sample. Oracle: parts divided here, in a pixel of several lights and lobes, and one of several rays.
#[test]
fn parts_are_those_of_the_pixel_and_of_the_sample() {
    for (name, pixel) in [("ch15/set", [200, 180]), ("ch28/glass-sphere", [282, 244])] {
        let (explanation, html) = of_gallery(name, pixel);
        let whole = explanation.radiance.average();
        assert!(whole > 0.0, "{name}: the pixel's radiance: found {whole}, expected more than 0");
        let mut listed = 0;
        for source in explanation.sources.lists().into_iter().flat_map(|(_, sources)| sources) {
            let name = source.source.name().replace('"', "&quot;");
            let rows = html.lines().filter(|line| line.contains(&format!("<tr><th>{name}</th>")));
            let shares: Vec<f64> = rows
                .filter_map(|row| {
                    let (_, share) = row.strip_suffix(" %</td></tr>")?.rsplit_once('>')?;
                    share.trim_start_matches("&lt; ").parse().ok()
                })
                .collect();
            let expected = 100.0 * source.mean.average() / whole;
            // above a tenth whole numbers are printed
            let is_listed = shares.iter().any(|share| (share - expected).abs() <= 0.51);
            assert!(is_listed, "{name}: found the percentages {shares:?}, expected {expected}");
            listed += 1;
        }
        assert!(listed >= 2, "{name}: sources: found {listed}, expected 2 or more");
        let root = explanation.samples[0].ray.as_ref().expect("a ray");
        for ray in root.rays() {
            let (_, row) = html
                .split_once(&format!(
                    "data-ray=\"{}\"><span class=\"share\" style=\"--part:",
                    ray.number
                ))
                .unwrap_or_else(|| panic!("ray {} has no bar", ray.number));
            let found: f64 =
                row.split('%').next().and_then(|it| it.parse().ok()).expect("a percentage");
            let expected = 100.0 * ray.share;
            assert!(
                (found - expected).abs() <= 0.051,
                "the bar of ray {}: found {found}, expected {expected}",
                ray.number
            );
        }
    }
}
