//! The statistic: ranks are fair, sums are sums, terms are parts of the picture.

use groundtruth::film::{self, Film, OutOfGamut, Tone};
use groundtruth::math::Pcg32;
use judge::verdict::{
    Area, Areas, Bright, DifferenceKind, Evaluation, Evidence, Map, Mean, Pool, PoolContext,
    Quantiser, Ranking, Stored, Strictness, TermFactor, TermFilm, factors, terms,
};
use pictures::compare::{Picture, Transfer};
use statistics::chi_square;

use super::pictures::{films, scene, world};
use super::shared::FLOATS;

/// Pictures of 9 × 7 pixels whose values are cubes of normal numbers of other sizes: skewed nowhere, heavy-tailed.
fn noise(random: &mut Pcg32) -> Vec<f32> {
    let normal = |random: &mut Pcg32| (0..12).map(|_| random.uniform()).sum::<f64>() - 6.0;
    (0..9 * 7 * 3)
        .map(|at| {
            let size = 1.0 + f64::from(at % 5);
            let x = normal(random);
            (10.0 + size * x * x * x) as f32
        })
        .collect()
}

/// Law: of exchangeable pictures the last is as likely to be the farthest out, or the second, third or fourth, as any
/// other, held against the mean of the others or that of pictures outside the pool. (Pictures that are nowhere far out
/// may share a rank.) Oracle: the uniform distribution, χ² at level 1e-3, of two tests.
#[test]
fn each_rank_is_as_likely() {
    for outside in [0, 5] {
        let counts = ranks(outside);
        let p = chi_square::goodness_of_fit(&counts, &[125.0, 125.0, 125.0, 125.0, 500.0]);
        assert!(p > 0.5e-3, "{outside} outside, {counts:?}: p = {p}");
    }
}

/// How often the last of 8 pictures is as far out as 0, 1, 2, 3 or more others, in 1,000 pools that are held against
/// the mean of this many others.
fn ranks(outside: u32) -> [u64; 5] {
    const PICTURES: usize = 8;
    let areas = Areas::tiles([9, 7]);
    let random = &mut Pcg32::new(11, 5);
    let mut counts = [0_u64; 5];
    for _ in 0..1000 {
        let pictures = (0..PICTURES).map(|_| noise(random)).collect();
        let mut mean = vec![0.0; 9 * 7 * 3];
        for _ in 0..outside {
            let values = mean.iter_mut().zip(noise(random));
            values.for_each(|(sum, value)| *sum += f64::from(value) / f64::from(outside));
        }
        let mean = (outside > 0).then(|| Mean { values: mean, pictures: f64::from(outside) });
        let pool = Pool::new([9, 7], FLOATS, pictures).against_mean(mean);
        counts[Ranking::of(&pool, &areas, 0).as_far_as(PICTURES - 1).min(4)] += 1;
    }
    counts
}

/// Law: a picture with little noise is farther out from the mean of many pictures than from that of few, as the
/// variance of the difference is less: that of its own noise and of the mean's. Oracle: the closed form, within a fifth.
#[test]
fn the_mean_of_many_shows_more() {
    const REPLICAS: f64 = 8.0;
    const OUTSIDE: f64 = 200.0;
    const NOISE: f64 = 0.1;
    let areas = Areas::tiles([32, 32]);
    let random = &mut Pcg32::new(12, 5);
    let mut normal = |mean: f64, deviation: f64| -> Vec<f64> {
        let unit = |_| (0..12).map(|_| random.uniform()).sum::<f64>() - 6.0;
        (0..3 * 32 * 32).map(unit).map(|x| mean + deviation * x).collect()
    };
    let single = |values: Vec<f64>| values.into_iter().map(|x| x as f32).collect::<Vec<f32>>();
    let mut pictures: Vec<Vec<f32>> = (0..8).map(|_| single(normal(10.0, 1.0))).collect();
    pictures.push(single(normal(10.5, NOISE)));
    let mean = Mean { values: normal(10.0, 1.0 / OUTSIDE.sqrt()), pictures: OUTSIDE };
    let whole = |pool: &Pool| {
        Map::of(pool, &areas, 8, NOISE).largest(&areas, &[DifferenceKind::Tiles(5)])[0]
    };
    let pool = Pool::new([32, 32], FLOATS, pictures);
    let few = whole(&pool);
    let many = whole(&pool.against_mean(Some(mean)));
    let own = NOISE * NOISE;
    let expected = ((own + 1.0 / REPLICAS) / (own + 1.0 / OUTSIDE)).sqrt();
    assert!((many / few / expected - 1.0).abs() < 0.2, "{many} and {few}, not {expected} times");
}

/// Law: tiles have the sums of their pixels, and objects of theirs. Oracle: brute force.
#[test]
fn sums_over_areas_are_sums() {
    for size @ [width, height] in [[9, 7], [16, 16], [1, 5], [33, 2]] {
        let areas = Areas::tiles(size);
        let random = &mut Pcg32::new(2, 5);
        let values: Vec<f64> = (0..width * height).map(|_| random.uniform()).collect();
        let mut sums = values.clone();
        for level in 0..areas.levels() {
            if level > 0 {
                sums = areas.coarser(&sums, level);
            }
            for (index, sum) in sums.iter().enumerate() {
                let area = areas.tile(level, index);
                let Area::Tile { corner: [x, y], side } = area else { panic!("a tile") };
                let is_inside = |at: &usize| {
                    let (column, row) = (at % width, at / width);
                    (x..x + side).contains(&column) && (y..y + side).contains(&row)
                };
                let pixels: Vec<usize> = (0..width * height).filter(is_inside).collect();
                assert_eq!(areas.pixels(area), pixels);
                let expected: f64 = pixels.iter().map(|pixel| values[*pixel]).sum();
                assert!((sum - expected).abs() < 1e-12, "{area:?}: {sum}, not {expected}");
            }
        }
        assert_eq!(sums.len(), 1, "the last tile is the whole picture");
    }
}

/// Law: our values are stored as a file stores them. Oracle: the bytes of the file that `film::write` writes.
#[test]
fn values_are_stored_as_files_store_them() {
    let film = films(&mut world(&scene("ch26/cornell-box", [20, 20], 4), 1), 1..2).remove(0);
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("film.png");
    for (gamma, out_of_gamut) in [(2.2, OutOfGamut::MaxToOne), (1.0, OutOfGamut::ClampToColor)] {
        film::write(&film, &Tone { exposure: 1.0, gamma, out_of_gamut }, &file).expect("written");
        let transfer = Transfer::Gamma(gamma);
        let read = Picture::read(&file, Some(transfer)).expect("a picture");
        let bright = Bright::Mapped(out_of_gamut);
        let stored =
            Stored::Integers { step: 1.0 / 255.0, transfer, quantiser: Quantiser::Rounded, bright };
        let expected: Vec<f32> =
            read.values.as_flattened().iter().map(|value| stored.read(*value)).collect();
        assert_eq!(stored.values(&film), expected);
        std::fs::remove_file(&file).expect("removed");
    }
}

/// Law: the sum of all terms is the picture. Oracle: the renderer.
#[test]
fn terms_add_up_to_the_picture() {
    for name in [
        "ch18/rectangle",
        "ch26/cornell-box",
        "ch28/three-filters",
        "ch25/glossy-hall",
        "ch12/thin-lens",
    ] {
        if gallery::find(name).is_none() {
            continue;
        }
        let mut scene = scene(name, [16, 16], 4);
        scene.camera.exposure_time = 0.75;
        let mut world = world(&scene, 1);
        let ours = films(&mut world, 7..9);
        let terms = terms(&mut world, 7..9);
        assert!(!terms.is_empty());
        for y in 0..16 {
            for x in 0..16 {
                let sum = |films: &mut dyn Iterator<Item = &Film>| {
                    films.fold([0.0; 3], |sum, film| {
                        let color = film.get([x, y]).to_array();
                        [0, 1, 2].map(|channel| sum[channel] + color[channel])
                    })
                };
                let of_terms = sum(&mut terms.iter().map(|term| &term.film));
                let of_ours = sum(&mut ours.iter()).map(|value| 0.5 * value);
                for (a, b) in of_terms.into_iter().zip(of_ours) {
                    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{name}: {a}, not {b}");
                }
            }
        }
    }
}

/// Law: the same pictures in another unit of radiance are the same evidence: weights are those of its square. Oracle: powers
/// of two, by which all numbers are multiplied without rounding.
#[test]
fn weights_have_the_unit_of_radiance() {
    for name in ["ch03/three-objects", "ch18/rectangle"] {
        let mut world = world(&scene(name, [24, 24], 4), 1);
        let areas = Areas::of(&world);
        let films = films(&mut world, 1..11);
        let weights = |unit: f32| {
            let in_unit = |film: &Film| -> Vec<f32> {
                FLOATS.values(film).into_iter().map(|value| unit * value).collect()
            };
            let mut known: Vec<Vec<f32>> = films[..9].iter().map(in_unit).collect();
            let mut theirs = in_unit(&films[9]);
            theirs[..600].iter_mut().for_each(|value| *value *= 1.25);
            let subject = PoolContext { areas: &areas, stored: FLOATS, reference: None };
            let strictness = Strictness { level: 0.05, first: 9 };
            let judged = Evaluation::of(&theirs, subject, strictness, &mut known, |_| None);
            evidence(&judged.expect("enough"), &areas, &theirs).weights()
        };
        let (whole, small) = (weights(1.0), weights(1.0 / 4096.0));
        assert!(whole.iter().any(|weight| *weight > 0.0), "{name}: nothing has a weight");
        for (index, (a, b)) in whole.iter().zip(&small).enumerate() {
            let b = b / (4096.0 * 4096.0);
            assert!((a - b).abs() <= 1e-9 * a, "{name}, tile {index}: found {b}, expected {a}");
        }
    }
}

/// The factors of a picture that is made of the terms of a scene, each this many times; `made` is of the term.
fn factors_of(
    name: &str,
    [side, samples]: [u32; 2],
    made: impl Fn(&TermFilm) -> f64,
) -> Vec<TermFactor> {
    let mut world = world(&scene(name, [side; 2], samples), 1);
    let areas = Areas::of(&world);
    let mut known: Vec<Vec<f32>> =
        films(&mut world, 1..17).iter().map(|it| FLOATS.values(it)).collect();
    let mut theirs = vec![0.0_f32; 3 * (side * side) as usize];
    for term in terms(&mut world, 300..301) {
        for (sum, value) in theirs.iter_mut().zip(FLOATS.values(&term.film)) {
            *sum += value * made(&term) as f32;
        }
    }
    let strictness = Strictness { level: 0.05, first: 16 };
    let subject = PoolContext { areas: &areas, stored: FLOATS, reference: None };
    let judged = Evaluation::of(&theirs, subject, strictness, &mut known, |_| None);
    let evidence = evidence(&judged.expect("enough"), &areas, &theirs);
    factors(&terms(&mut world, 1..5), &evidence).expect("factors explain it").factors
}

/// Law: a picture that holds 1/π of the light of a lamp has this as its factor, within four standard deviations, and no
/// other is off. Oracle: the multiples that were made.
#[test]
fn factors_of_terms_are_found() {
    let made = |name: &str| if name.contains(" on ") { std::f64::consts::FRAC_1_PI } else { 1.0 };
    let factors = factors_of("ch18/rectangle", [48, 16], |term| made(&term.name));
    for factor in &factors {
        let expected = made(&factor.terms[0]);
        let apart = (factor.factor - expected).abs();
        assert!(apart <= (4.0 * factor.error).max(0.01), "{factor:?}, not {expected}");
    }
    let direct = factors.iter().find(|factor| factor.terms[0].contains(" on ")).expect("a term");
    assert_eq!(direct.meaning(), Some("1/π"), "{direct:?}");
    assert_eq!(factors.iter().filter(|factor| factor.is_off()).count(), 1, "{factors:?}");
}

/// Law: a lamp that is gone is left out, whatever its light meets, and that is all that is said. Oracle: the lamp.
#[test]
fn a_lamp_that_is_gone_is_left_out() {
    const NAME: &str = "ch15/page-one";
    let gone = scene(NAME, [48; 2], 4).lights[1].name.clone();
    let source = format!("light of {gone}");
    let made = |term: &TermFilm| if term.source == source { 0.0 } else { 1.0 };
    let factors = factors_of(NAME, [48, 4], made);
    assert_eq!(factors.len(), 1, "{factors:?}");
    assert!(factors[0].terms[0].starts_with(&source), "{factors:?}");
    assert_eq!(factors[0].meaning(), Some("left out"), "{factors:?}");
}

/// Law: where a program traces no ray deeper than 1, light at greater depths is named as left out, and no other is off.
/// Oracle: the depths that were left out.
#[test]
fn depths_that_are_left_out_are_named() {
    let made = |term: &TermFilm| if term.depth > 1 { 0.0 } else { 1.0 };
    let factors = factors_of("ch24/hall-of-mirrors", [80, 16], made);
    let off: Vec<&TermFactor> = factors.iter().filter(|factor| factor.is_off()).collect();
    let names: Vec<&str> = off.iter().map(|factor| &*factor.terms[0]).collect();
    assert_eq!(names, ["light at depth 2", "light at depth 3 or more"], "{factors:?}");
    assert!(off.iter().all(|factor| factor.meaning() == Some("left out")), "{off:?}");
}

/// The evidence of a judgement.
fn evidence<'a>(judged: &Evaluation, areas: &'a Areas, theirs: &[f32]) -> Evidence<'a> {
    let noise = judged.ranking.noise[judged.pool.count() - 1];
    Evidence::of(&judged.pool, noise, areas, theirs)
}
