//! The test function sin(x² y²), which needs no object, and what sampling makes of it.

use groundtruth::background::{Background, Pattern, Sinusoid};

use crate::prelude::*;

/// The side of the book's square: figure 4.2 shows `[0, 10.83]²`.
const SIDE: f64 = 10.83;

fn pattern(unit: f64) -> Background {
    Background::Pattern(Pattern::Sinusoid(Sinusoid { unit }))
}

/// The square in n × n pixels.
fn scene(n: u32) -> Scene {
    let center = Point::new(0.5 * SIDE, 0.5 * SIDE, 0.0);
    let eye = center + 100.0 * Vector::Z;
    let image = Image { pixel_size: SIDE / f64::from(n), ..Image::new(n, n) };
    let view = Viewpoint::new(eye, center, Orthographic { zoom: 1.0 });
    Scene { background: pattern(1.0), ..Scene::new("", image, view) }
}

fn value(x: f64, y: f64) -> f64 {
    0.5 * (1.0 + sin(x * x * y * y))
}

/// Law: with one sample a pixel is `(1 + sin(x² y²))/2` at its centre. Oracle: the formula at the book's `s
/// (c + ½)`, rows counted from the bottom.
/// Book: fig. 4.2, aliasing of sin(x² y²).
#[test]
fn a_pixel_is_the_function_at_its_centre() {
    let scene = scene(128);
    let film = render::render(&built(&scene));
    let s = SIDE / 128.0;
    for [column, row] in pixels(128, 128) {
        let (x, y) = (s * (f64::from(column) + 0.5), s * (f64::from(127 - row) + 0.5));
        // x and y are off by some u of 11, the phase by 4 x³ times that
        let error = (film.get([column, row]).r - value(x, y)).abs();
        assert!(error < 1e-10, "{column} {row}: {error:e}");
    }
}

/// Law: the function needs no object, and costs one ray a sample.
/// Book: fig. 4.2, aliasing of sin(x² y²).
#[test]
fn it_needs_one_ray_and_no_object() {
    let world = built(&scene(8));
    assert_eq!(world.objects().len(), 0);
    let mut counts = RayCounts::default();
    render::sample(&world, [3, 4], 0, &mut counts);
    assert_eq!(counts, RayCounts { camera: 1, ..RayCounts::default() });
}

/// Law: waves along x are shown correctly only where the phase changes by less than π from pixel to pixel, `x
/// y² < π/2s` (74.26 for 512 pixels). Oracle: sign changes of `f − ½` along a row, counted in the picture and
/// in the formula on a grid 64 times as fine; beyond the bound waves are lost.
/// Book: fig. 4.2, aliasing of sin(x² y²).
#[test]
fn waves_are_lost_beyond_the_nyquist_bound() {
    let n = 512;
    let s = SIDE / f64::from(n);
    let bound = PI / (2.0 * s);
    assert!((bound - 74.26).abs() < 0.005, "{bound}");
    let film = render::render(&built(&scene(n)));
    let row = 200;
    let y = s * (f64::from(n - 1 - row) + 0.5);
    let limit = bound / (y * y);
    let changes = |values: Vec<f64>| {
        values.windows(2).filter(|pair| (pair[0] > 0.5) != (pair[1] > 0.5)).count()
    };
    let last = (limit / s) as u32; // the first column beyond
    let shown =
        |from: u32, to: u32| changes((from..to).map(|column| film.get([column, row]).r).collect());
    let true_waves = |from: u32, to: u32| {
        let fine = 64 * from..64 * to - 63;
        changes(fine.map(|i| value(s * (f64::from(i) / 64.0 + 0.5), y)).collect())
    };
    assert!((40..470).contains(&last), "{last}");
    assert_eq!(shown(0, last), true_waves(0, last));
    let (few, many) = (shown(last, n), true_waves(last, n));
    assert!(few < many, "{few} of {many} waves beyond the bound");
}

/// Law: where the phase changes by a multiple of 2π from pixel to pixel along both axes, the picture shows a
/// centre that is not there: neighbours hardly differ, though the function runs through a whole wave between
/// them. Oracle: `2x³ s = 2π` on the diagonal.
/// Book: fig. 4.2, aliasing of sin(x² y²).
#[test]
fn false_centres_appear_where_whole_waves_fit_between_pixels() {
    let n = 512;
    let s = SIDE / f64::from(n);
    let center = libm::cbrt(PI / s);
    let at = (center / s - 0.5).round() as u32;
    let film = render::render(&built(&scene(n)));
    let grey = |dx: i32, dy: i32| {
        let [x, y] = [at.wrapping_add_signed(dx), (n - 1 - at).wrapping_add_signed(dy)];
        film.get([x, y]).r
    };
    // the pixel is within ½ of the true point, where the phase step differs from 2π by 3·2π·½s/x;
    // the second difference of the phase is s² y²
    let allowed = 0.5 * (1.5 * TAU * s / center + s * s * center * center) + 1e-6;
    assert!(allowed < 0.03, "{allowed}");
    for (dx, dy) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
        let step = (grey(dx, dy) - grey(0, 0)).abs();
        assert!(step < allowed, "{dx} {dy}: {step} of {allowed}");
    }
    let x = s * (f64::from(at) + 0.5);
    let between = (0..64).map(|i| value(x + s * f64::from(i) / 64.0, x));
    let (low, high) = between.fold((1.0_f64, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
    assert!(high - low > 0.99, "{low} to {high}");
}

/// Law: jittered pixels are nearer to the truth than random ones with equally many samples, where the phase
/// changes by less than π across a cell. Oracle: 64 × 64 regular samples of each pixel by the formula; random
/// samples of a linear phase of up to 4π have errors many times larger.
/// Book: antialiasing fine detail.
#[test]
fn jittered_pixels_are_nearer_to_the_truth_than_random_ones() {
    let n = 64;
    let s = SIDE / f64::from(n);
    let coordinate = |i: u32, k: f64| s * (f64::from(i) + k);
    let mean = |[column, row]: [u32; 2]| {
        let cell = |k: u32| (f64::from(k) + 0.5) / 64.0;
        let cells = (0..64).flat_map(|i| (0..64).map(move |j| (i, j)));
        let at = |(i, j)| value(coordinate(column, cell(i)), coordinate(n - 1 - row, cell(j)));
        cells.map(at).sum::<f64>() / 4096.0
    };
    let smooth = |[column, row]: &[u32; 2]| {
        let (x, y) = (coordinate(*column, 1.0), coordinate(n - 1 - row, 1.0));
        2.0 * x * y * x.max(y) * s / 4.0 < PI
    };
    let seen: Vec<[u32; 2]> = pixels(n, n).filter(smooth).collect();
    assert!(seen.len() > 500, "{}", seen.len());
    let error = |sampler: groundtruth::samplers::Kind| {
        let mut scene = scene(n);
        scene.image.samples = 16;
        scene.image.sampler = Some(sampler);
        let film = render::render(&built(&scene));
        let off = |&at: &[u32; 2]| film.get(at).r - mean(at);
        seen.iter().map(|at| off(at) * off(at)).sum::<f64>() / seen.len() as f64
    };
    let (random, jittered) = (error(Random {}.into()), error(Jittered {}.into()));
    assert!(jittered < 0.3 * random, "{jittered} {random}");
}

/// Law: the mean of the function over the whole square is a little over ½. Oracle: quadrature of the formula
/// on 2048 × 2048 points; `∬ sin(x² y²)` is 0.0267 of the area.
/// Book: fig. 4.2, aliasing of sin(x² y²).
#[test]
fn the_mean_is_a_little_over_a_half() {
    let mut scene = scene(64);
    scene.image.samples = 64;
    let film = render::render(&built(&scene));
    let mean = pixels(64, 64).map(|at| film.get(at).r).sum::<f64>() / 4096.0;
    let quadrature = {
        let n = 2048;
        let h = SIDE / f64::from(n);
        let middle = |i: u32| h * (f64::from(i) + 0.5);
        let rows = (0..n).map(|i| (0..n).map(|j| value(middle(i), middle(j))).sum::<f64>());
        rows.sum::<f64>() / f64::from(n) / f64::from(n)
    };
    // 262 144 stratified samples of variance at most 1/8 each: σ < 7e-4
    assert!((mean - quadrature).abs() < 3.5e-3, "{mean} {quadrature}");
    assert!((0.5..0.53).contains(&mean), "{mean}");
}

/// Law: any ray that hits nothing sees the plane z = 0: through a pinhole the pattern is in
/// perspective, and rays away from the plane are black. Oracle: similar triangles.
#[test]
fn a_pinhole_sees_the_pattern_in_perspective() {
    let eye = Point::new(1.0, 2.0, 10.0);
    let lens = Pinhole { distance: 5.0, zoom: 1.0 };
    let view = Viewpoint::new(eye, Point::new(1.0, 2.0, 0.0), lens);
    let image = Image { pixel_size: 0.25, ..Image::new(9, 7) };
    let mut scene = Scene { background: pattern(1.0), ..Scene::new("", image, view) };
    let film = render::render(&built(&scene));
    for at in pixels(9, 7) {
        let [x, y] = render::film_point(&scene.image, at, [0.5, 0.5]);
        let error = (film.get(at).r - value(1.0 + 2.0 * x, 2.0 + 2.0 * y)).abs();
        assert!(error < 1e-12, "{at:?}: {error:e}");
    }
    scene.camera.look_at = Point::new(1.0, 2.0, 20.0);
    let film = render::render(&built(&scene));
    assert_eq!(film.pixels(), [Rgb::BLACK; 63]);
}
