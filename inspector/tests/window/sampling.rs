//! The samples of the selected pixel: points linked to rays, and another sampler.

use eframe::egui::Pos2;
use egui_kittest::kittest::Queryable;
use groundtruth::cameras::{Stereo, Viewing};
use groundtruth::lights::AmbientOccluder;
use groundtruth::render;
use groundtruth::samplers::{Jittered, Kind, PathKey, Purpose, Regular};
use groundtruth::scene::{Light, Scene};
use groundtruth::trace::RayKind;

use crate::support::*;

/// The small glass sphere with 16 jittered samples.
fn sixteen() -> Scene {
    let mut scene = small_glass_sphere();
    scene.image.samples = 16;
    scene.image.sampler = Some(Jittered {}.into());
    scene
}

/// A window on a scene, a pixel selected and its samples shown.
fn samples_of(scene: Scene, pixel: [u32; 2]) -> Window {
    // so wide that the plots have their largest side
    let mut window = open_sized(scene, [1500.0, 800.0]);
    click(&mut window, pixel);
    push(&mut window, "The samples");
    window
}

fn point(window: &Window, plot: usize, sample: usize) -> Pos2 {
    window.state().panel.samples.on_screen(plot, sample).expect("it is drawn")
}

/// Law: a click on a point of the square selects its sample and shows the sample's tree; the chosen point
/// is highlighted. Oracle: the library's explanation of the sample, and the pixels of the window.
#[test]
fn a_click_on_a_point_shows_its_ray() {
    let mut window = samples_of(sixteen(), ON_GLASS);
    for (plot, sample) in [(0, 5), (0, 11), (0, 0)] {
        let at = point(&window, plot, sample);
        click_at(&mut window, at);
        assert_eq!(window.state().selection.sample, sample as u32);
        let line = root_line_of(&sixteen(), ON_GLASS, sample as u32);
        assert!(window.query_all_by_label(&line).next().is_some(), "{line}");
        hover(&mut window, Pos2::new(5.0, 5.0));
        let at = point(&window, plot, sample);
        let [r, g, b] = color_at(&mut window, at);
        assert!(r > 200 && b < 120, "sample {sample} is ({r}, {g}, {b})");
    }
}

/// Law: while a point is under the mouse, its sample's tree is shown with the ray of the point lit, the camera's for the pixel
/// and the shadow ray for the light; the chosen sample comes back after it; a row of the tree that is pointed at lights the
/// point. Oracle: the library's explanation of the sample, and the pixels of the window.
#[test]
fn a_point_and_its_ray_are_lit_together() {
    let mut scene = sixteen();
    scene.lights.push(Light::new("occluder", AmbientOccluder::default()));
    let light = built(&scene).lights.last().expect("one is there").index;
    // the ground, which is lit by the occluder; glass is not
    let pixel = [24, 46];
    let mut window = samples_of(scene.clone(), pixel);
    let to_light = |sample: u32| {
        let root = ray_of(&scene, pixel, sample);
        let is_it = |ray: &&explain::RecordedRay| matches!(ray.kind, RayKind::Shadow { light: it } if it == light);
        root.children.iter().find(is_it).map(|ray| ray.number)
    };
    for (plot, sample) in [(0, 5), (2, 7)] {
        let at = point(&window, plot, sample);
        hover(&mut window, at);
        let line = root_line_of(&scene, pixel, sample as u32);
        assert!(window.query_all_by_label(&line).next().is_some(), "{line}");
        assert!(window.query_by_label(&format!("Sample {sample}")).is_some());
        let ray = if plot == 0 { Some(0) } else { to_light(sample as u32) };
        assert!(ray.is_some());
        assert_eq!(window.state().selection.tree.lit, ray, "plot {plot}");
        assert_eq!(window.state().selection.sample, 0, "it is not chosen");
    }
    hover(&mut window, Pos2::new(5.0, 5.0));
    assert!(window.query_by_label("Sample 0").is_some());
    let ring = |window: &mut Window, plot| {
        let at = point(window, plot, 0) + eframe::egui::vec2(0.0, 7.9);
        color_at(window, at)
    };
    let before = ring(&mut window, 0);
    let line = root_line_of(&scene, pixel, 0);
    let row = window.query_all_by_label(&line).next().expect("a row");
    let row = row.rect().center();
    hover(&mut window, row);
    assert_eq!(window.state().selection.tree.lit, Some(0));
    let after = ring(&mut window, 0);
    assert!(after[2] > before[2] + 60, "{after:?} before {before:?}");
}

/// Asserts that the points of a plot lie relative to its first point as `expected` says: x to the right,
/// y up, with `unit` points of the screen for a distance of 1.
fn assert_drawn_as(window: &Window, plot: usize, unit: f64, expected: &[[f64; 2]]) {
    let first = point(window, plot, 0);
    for (i, [x, y]) in expected.iter().enumerate() {
        let at = point(window, plot, i) - first;
        let [right, up] = [x - expected[0][0], y - expected[0][1]].map(|along| unit * along);
        let off = (f64::from(at.x) - right).abs().max((f64::from(at.y) + up).abs());
        assert!(off < 0.5, "sample {i} of plot {plot} is {off} off");
    }
}

/// Law: the plot shows the draws of the selected pixel, also after another pixel is selected; in a stereo
/// pair, those of the pixel in the eye's image. Oracle: the positions of the samples on the film; of 16
/// jittered samples, one lies in each of 4 × 4 cells.
#[test]
fn the_square_shows_the_strata() {
    let mut pair = sixteen();
    let separation = 3.0;
    pair.camera.stereo = Some(Stereo { viewing: Viewing::Parallel, gap: 4, separation });
    let of_the_right_eye = [pair.image.width + 4 + ON_GLASS[0], ON_GLASS[1]];
    for (scene, pixels) in [(sixteen(), [ON_GLASS, [30, 8]]), (pair, [ON_GLASS, of_the_right_eye])]
    {
        let world = built(&scene);
        let mut window = samples_of(scene, pixels[0]);
        for pixel in pixels {
            click(&mut window, pixel);
            let samples: Vec<_> =
                (0..16).map(|i| render::camera_sample(&world, pixel, i).expect("no gap")).collect();
            let positions: Vec<_> = samples.iter().map(|sample| sample.film).collect();
            let size = world.image.pixel_size;
            // the square's side, 156 points
            assert_drawn_as(&window, 0, 156.0 / size, &positions);
            let corner = render::film_point(&world.image, samples[0].pixel, [0.0, 0.0]);
            let cell = |[x, y]: &[f64; 2]| {
                [x - corner[0], y - corner[1]].map(|along| (4.0 * along / size).floor() as i64)
            };
            let cells: std::collections::BTreeSet<_> = positions.iter().map(cell).collect();
            assert_eq!(cells.len(), 16);
        }
    }
}

/// Law: the picture follows a new sampler and a new count, and equals the library's rendering; if a count is
/// not a square, the window says that it is rounded up.
#[test]
fn the_picture_follows_sampler_and_count() {
    let mut window = samples_of(sixteen(), ON_GLASS);
    push(&mut window, "Sampler");
    push(&mut window, "regular");
    let image = &window.state().session.rendering.scene.image;
    assert!(matches!(image.sampler, Some(Kind::Regular(_))), "{:?}", image.sampler);
    let mut scene = sixteen();
    scene.image.sampler = Some(Regular {}.into());
    assert_eq!(film(&window).pixels(), rendered(&scene).pixels());
    assert_eq!(window.state().selection.pixel, Some(ON_GLASS));

    type_number(&mut window, "Samples", "5");
    scene.image.samples = 5;
    assert_eq!(window.state().session.rendering.scene.image.samples, 5);
    assert_eq!(film(&window).pixels(), rendered(&scene).pixels());
    assert!(window.query_by_label("rounded up to 9").is_some());
}

/// Law: a camera without a lens uses no lens samples; with a lens, each sample is shown on the disk where
/// its ray begins. Oracle: the library's samples.
#[test]
fn the_lens_is_shown_where_there_is_one() {
    let window = samples_of(sixteen(), ON_GLASS);
    assert_eq!(window.state().panel.samples.on_screen(1, 0), None);
    let scene = small("ch10/near-focus", [40, 30], 9);
    let world = built(&scene);
    let window = samples_of(scene, [20, 15]);
    let position = |i| render::camera_sample(&world, [20, 15], i).and_then(|sample| sample.lens);
    let positions: Vec<_> = (0..9).map(|i| position(i).expect("it has a lens")).collect();
    // the disk's radius, 78 points
    assert_drawn_as(&window, 1, 78.0, &positions);
}

/// Law: point lights need no random numbers, so their plot is empty; for a light that is sampled, the plot
/// shows the pair of numbers of each sample as a point of the square. Oracle: the library's draws.
#[test]
fn the_light_is_shown_where_one_is_sampled() {
    let window = samples_of(sixteen(), ON_GLASS);
    assert!(window.query_by_label("light").is_some());
    assert_eq!(window.state().panel.samples.on_screen(2, 0), None);

    let mut scene = sixteen();
    scene.lights.push(Light::new("occluder", AmbientOccluder::default()));
    let world = built(&scene);
    let window = samples_of(scene, ON_GLASS);
    let (path, light) = (PathKey::CAMERA, world.lights.last().expect("one is there").index);
    let purpose = Purpose::Light { path, light, pair: 0 };
    let draws = |i| world.draws(ON_GLASS, i).draw(purpose).map(|u| 2.0 * u - 1.0);
    let positions: Vec<_> = (0..16).map(draws).collect();
    assert_drawn_as(&window, 2, 78.0, &positions);
}
