//! The samples of the selected pixel: points linked to rays, another sampler, and its fairness.

use eframe::egui::Pos2;
use egui_kittest::kittest::Queryable;
use groundtruth::gallery;
use groundtruth::render;
use groundtruth::samplers::{Jittered, Kind, Regular};
use groundtruth::scene::Scene;

use crate::support::*;

const ON_GLASS: [u32; 2] = [17, 19];

/// The small glass sphere with 16 jittered samples.
fn sixteen() -> Scene {
    let mut scene = small_glass_sphere();
    scene.image.samples = 16;
    scene.image.sampler = Some(Jittered {}.into());
    scene
}

/// A window on a scene, a pixel selected and its samples shown.
fn samples_of(scene: Scene, pixel: [u32; 2]) -> Window {
    let mut window = open(scene);
    settle(&mut window);
    click(&mut window, pixel);
    window.get_by_label("The samples").click();
    settle(&mut window);
    window
}

fn point(window: &Window, plot: usize, sample: usize) -> Pos2 {
    window.state().selection.samples.on_screen(plot, sample).expect("it is drawn")
}

fn click_at(window: &mut Window, at: Pos2) {
    window.hover_at(at);
    window.drag_at(at);
    window.drop_at(at);
    settle(window);
}

/// Law: a click on a point of the square or of the hemisphere selects its sample, and the tree is that
/// sample's; the chosen point is lit up in both plots. Oracle: the library's explanation of the
/// sample, and the picture of the window.
#[test]
fn a_click_on_a_point_shows_its_ray() {
    let mut window = samples_of(sixteen(), ON_GLASS);
    for (plot, sample) in [(0, 5), (2, 11), (0, 0)] {
        let at = point(&window, plot, sample);
        click_at(&mut window, at);
        assert_eq!(window.state().selection.sample, sample as u32);
        let line = root_line_of(&sixteen(), ON_GLASS, sample as u32);
        assert!(window.query_all_by_label(&line).next().is_some(), "{line}");
        window.hover_at(Pos2::new(5.0, 5.0));
        window.run_steps(3);
        let image = window.render().expect("drawn");
        for plot in [0, 2] {
            let at = point(&window, plot, sample);
            let [r, g, b, _] = image.get_pixel(at.x as u32, at.y as u32).0;
            assert!(r > 200 && b < 120, "sample {sample} of plot {plot} is ({r}, {g}, {b})");
        }
    }
}

/// Law: the points are the draws of the pixel: those of 16 jittered samples lie one in each of 4 × 4
/// cells of the square as it is drawn. Oracle: counting on the screen.
#[test]
fn the_square_shows_the_strata() {
    let window = samples_of(sixteen(), ON_GLASS);
    let points: Vec<Pos2> = (0..16).map(|i| point(&window, 0, i)).collect();
    let world = built(&sixteen());
    // the square's scale from two points whose film places are known
    let film = |i: u32| render::camera_sample(&world, ON_GLASS, i).expect("no gap").film;
    let scale = f64::from(points[1].x - points[0].x) / (film(1)[0] - film(0)[0]);
    let side = scale * world.image.pixel_size;
    let mut cells = std::collections::BTreeSet::new();
    for (i, at) in points.iter().enumerate() {
        // y on the screen goes down
        let place = film(i as u32);
        let expected = points[0].x as f64 + scale * (place[0] - film(0)[0]);
        assert!((f64::from(at.x) - expected).abs() < 0.5, "sample {i}");
        let expected = points[0].y as f64 - scale * (place[1] - film(0)[1]);
        assert!((f64::from(at.y) - expected).abs() < 0.5, "sample {i}");
        let corner = render::film_place(&world.image, ON_GLASS, [0.0, 0.0]);
        let cell = |axis: usize| {
            (4.0 * (place[axis] - corner[axis]) / world.image.pixel_size).floor() as i64
        };
        cells.insert((cell(0), cell(1)));
    }
    assert_eq!(cells.len(), 16);
    assert!((100.0..170.0).contains(&side), "{side}");
}

/// Law: another sampler and another count are followed by the picture, which is then what the library
/// renders; a count that is no square is said to be rounded up.
#[test]
fn the_picture_follows_sampler_and_count() {
    let mut window = samples_of(sixteen(), ON_GLASS);
    window.get_by_label("Sampler").click();
    settle(&mut window);
    window.get_by_label("regular").click();
    settle(&mut window);
    let image = &window.state().rendering.scene.image;
    assert!(matches!(image.sampler, Some(Kind::Regular(_))), "{:?}", image.sampler);
    let mut scene = sixteen();
    scene.image.sampler = Some(Regular {}.into());
    let rendered =
        |window: &Window| window.state().rendering.canvas.look(|film| film.pixels().to_vec());
    assert_eq!(rendered(&window), render::render(&built(&scene)).pixels());
    assert_eq!(window.state().selection.pixel, Some(ON_GLASS));

    type_number(&mut window, "Samples", "5");
    scene.image.samples = 5;
    assert_eq!(window.state().rendering.scene.image.samples, 5);
    assert_eq!(rendered(&window), render::render(&built(&scene)).pixels());
    assert!(window.query_by_label("rounded up to 9").is_some());
}

/// Law: the verdict is χ²'s: jittered draws are fair, those of a fixed grid are not.
#[test]
fn the_verdict_tells_a_fair_sampler_from_a_fixed_one() {
    for (sampler, words) in [(Kind::from(Jittered {}), "; fair"), (Regular {}.into(), "; not fair")]
    {
        let mut scene = sixteen();
        scene.image.sampler = Some(sampler);
        let window = samples_of(scene, ON_GLASS);
        let verdict = text_with(&window, "χ² of ");
        assert!(verdict.contains(words), "{verdict}");
    }
}

/// Law: a camera without a lens uses no lens samples; with one, each is drawn on the disk.
#[test]
fn the_lens_is_shown_where_there_is_one() {
    let window = samples_of(sixteen(), ON_GLASS);
    assert_eq!(window.state().selection.samples.on_screen(1, 0), None);
    let mut scene = (gallery::find("ch10/near-focus").expect("in the gallery").build)();
    scene.image.resize(40, 30);
    scene.image.samples = 9;
    let window = samples_of(scene, [20, 15]);
    assert!((0..9).all(|i| window.state().selection.samples.on_screen(1, i).is_some()));
}
