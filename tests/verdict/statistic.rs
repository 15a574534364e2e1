//! The statistic: ranks are fair, sums are sums, terms are parts of the picture.

use groundtruth::film::{self, Film, OutOfGamut, Tone};
use groundtruth::math::Pcg32;
use harness::compare::{Picture, Transfer};
use harness::verdict::{
    Area, Areas, Bright, Evidence, Judged, Pool, Ranking, Stored, Strictness, factors, terms,
};
use harness::verify::chi_square;

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
/// other. (Pictures that are nowhere far out may share a rank.) Oracle: the uniform distribution, χ² at level 1e-3.
#[test]
fn each_rank_is_as_likely() {
    const PICTURES: usize = 8;
    let areas = Areas::tiles([9, 7]);
    let random = &mut Pcg32::new(11, 5);
    let mut counts = [0_u64; 5];
    for _ in 0..1000 {
        let pictures = (0..PICTURES).map(|_| noise(random)).collect();
        let pool = Pool::new([9, 7], FLOATS, pictures);
        counts[Ranking::of(&pool, &areas, 0).as_far_as(PICTURES - 1).min(4)] += 1;
    }
    let p = chi_square::goodness_of_fit(&counts, &[125.0, 125.0, 125.0, 125.0, 500.0]);
    assert!(p > 1e-3, "{counts:?}: p = {p}");
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
        let read = Picture::read(&file, transfer).expect("a picture");
        let bright = Bright::Mapped(out_of_gamut);
        let stored = Stored::Integers { step: 1.0 / 255.0, transfer, truncated: false, bright };
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
        if groundtruth::gallery::find(name).is_none() {
            continue;
        }
        let mut world = world(&scene(name, [16, 16], 4), 1);
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
                let of_terms = sum(&mut terms.iter().map(|(_, film)| film));
                let of_ours = sum(&mut ours.iter()).map(|value| 0.5 * value);
                for (a, b) in of_terms.into_iter().zip(of_ours) {
                    assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{name}: {a}, not {b}");
                }
            }
        }
    }
}

/// Law: a picture that holds other multiples of some terms has these as its factors, within four standard deviations, and
/// their errors are small. Oracle: the multiples that were made.
#[test]
fn factors_of_terms_are_found() {
    let mut world = world(&scene("ch18/rectangle", [48, 48], 16), 1);
    let areas = Areas::of(&world);
    let known: Vec<Vec<f32>> =
        films(&mut world, 1..17).iter().map(|it| FLOATS.values(it)).collect();
    let made = |name: &str| if name.contains(" on ") { std::f64::consts::FRAC_1_PI } else { 1.0 };
    let mut theirs = vec![0.0_f32; 3 * 48 * 48];
    for (name, film) in terms(&mut world, 300..301) {
        for (sum, value) in theirs.iter_mut().zip(FLOATS.values(&film)) {
            *sum += value * made(&name) as f32;
        }
    }
    let mut known = known;
    let strictness = Strictness { level: 0.05, first: 16 };
    let judged = Judged::of(&theirs, (&areas, FLOATS), strictness, &mut known, |_| None);
    let evidence = Evidence::of(&judged.expect("enough"), &areas, &theirs);
    let factors = factors(&terms(&mut world, 1..5), &evidence).expect("factors explain it");
    for factor in &factors {
        let expected = made(&factor.terms[0]);
        let apart = (factor.factor - expected).abs();
        assert!(apart <= (4.0 * factor.error).max(0.01), "{factor:?}, not {expected}");
    }
    let direct = factors.iter().find(|factor| factor.terms[0].contains(" on ")).expect("a term");
    assert_eq!(direct.meaning(), Some("1/π"), "{direct:?}");
    assert_eq!(factors.iter().filter(|factor| factor.is_off()).count(), 1, "{factors:?}");
}
