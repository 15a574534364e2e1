//! From texture coordinates to texels.

use groundtruth::images::{Drawn, Picture};
use groundtruth::kinds::Resources;
use groundtruth::math::floor;
use groundtruth::textures::{Filtering, Image, Kind, Mapping, Rule, Wrap};
use testkit::properties::*;

use super::{by_uv, image_file, linear, texel_by_uv};
use crate::prelude::*;

/// Texels are stored in single precision, and interpolated three times.
const SINGLE: f64 = 4.0 * f32::EPSILON as f64;

const SIZE: [u32; 2] = [5, 4];

/// An image whose texels encode their index: red the column, green the row.
fn numbered() -> tempfile::NamedTempFile {
    image_file(SIZE, |column, row| [column as u16, row as u16, 0])
}

/// The column and row of a texel of [`numbered`].
fn texel_of(color: Rgb) -> [u32; 2] {
    [color.r, color.g].map(|c| (65535.0 * c).round() as u32)
}

/// An image of random colours.
fn random_colors() -> (tempfile::NamedTempFile, impl Fn(u32, u32) -> Rgb) {
    let color = |column: u32, row: u32| {
        let mut random = Pcg32::new(u64::from(100 * row + column), 7);
        [0; 3].map(|_| random.below(65536) as u16)
    };
    let exact = move |column, row| Rgb::from(color(column, row).map(|c| f64::from(c) / 65535.0));
    (image_file(SIZE, color), exact)
}

fn filtered(file: &tempfile::NamedTempFile, filtering: Filtering, rule: Rule) -> Image {
    Image { filtering, rule, ..linear(file, None) }
}

/// Law: by the even rule each texel covers 1/n of the image, and rows count from the bottom. Oracle: the
/// borders k/n, from both sides.
/// Book: from texture coordinates to texels.
#[test]
fn each_texel_covers_an_equal_part_by_the_even_rule() {
    let file = numbered();
    let color = by_uv(&filtered(&file, Filtering::Nearest, Rule::Even));
    let inside = |k: u32, n: u32, fraction: f64| (f64::from(k) + fraction) / f64::from(n);
    for column in 0..SIZE[0] {
        for row in 0..SIZE[1] {
            for fraction in [1e-9, 0.5, 1.0 - 1e-9] {
                let uv = [inside(column, SIZE[0], fraction), inside(row, SIZE[1], fraction)];
                assert_eq!(texel_of(color(uv)), [column, row], "at {uv:?}");
            }
        }
    }
    assert_eq!(texel_of(color([1.0, 1.0])), [4, 3], "the top right corner");
    assert_eq!(texel_of(color([0.0, 0.0])), [0, 0], "the bottom left corner");
}

/// Law: by the book's rule a texel covers 1/(n − 1), and the last column and row are reached at 1 only.
/// Oracle: `trunc((n − 1) u)` by counting over 400 equal steps: 100 each for the first four of five.
/// Book: from texture coordinates to texels.
#[test]
fn the_books_rule_reaches_the_last_texel_at_1_only() {
    let file = numbered();
    let color = by_uv(&filtered(&file, Filtering::Nearest, Rule::Book));
    let mut counts = [0; 5];
    for step in 0..400 {
        let u = (f64::from(step) + 0.5) / 400.0;
        counts[texel_of(color([u, 0.0]))[0] as usize] += 1;
    }
    assert_eq!(counts, [100, 100, 100, 100, 0]);
    assert_eq!(texel_of(color([1.0, 1.0])), [4, 3]);
    let below = 1.0 - f64::EPSILON / 2.0;
    assert_eq!(texel_of(color([below, below])), [3, 2]);
}

/// The interpolated value as a sum of tent functions over all texels: `Σ Λ(x − i) Λ(y − j) c`. x and y count
/// from the centre of the first texel, and `beyond` extends the image past its borders.
fn by_tents(
    [x, y]: [f64; 2],
    color: &impl Fn(u32, u32) -> Rgb,
    beyond: impl Fn(i32, i32) -> u32,
) -> Rgb {
    let tent = |x: f64| (1.0 - x.abs()).max(0.0);
    let [width, height] = SIZE.map(|n| n as i32);
    let mut sum = Rgb::BLACK;
    for j in -1..=height {
        for i in -1..=width {
            let weight = tent(x - f64::from(i)) * tent(y - f64::from(j));
            sum += weight * color(beyond(i, width), beyond(j, height));
        }
    }
    sum
}

fn assert_close(found: Rgb, expected: Rgb, what: &str) {
    let apart = (found + -1.0 * expected).map(f64::abs).max();
    assert!(apart <= SINGLE, "{what}: {found:?}, expected {expected:?}: {apart:e} apart");
}

/// The texel of an endless image, by the even rule.
fn endless(wrap: Wrap, i: i32, n: i32) -> i32 {
    match wrap {
        Wrap::Repeat => i.rem_euclid(n),
        Wrap::Clamp => i.clamp(0, n - 1),
        Wrap::Mirror => i.rem_euclid(2 * n).min(2 * n - 1 - i.rem_euclid(2 * n)),
    }
}

/// Law: each direction of an image has a wrap of its own: with any of the nine pairs, and nearest or bilinear,
/// a look-up reads an image that goes on for ever in both directions, each by its own rule; an explanation
/// names the texel around the point. Oracle: that endless image, whose texels are found by whole numbers:
/// `i mod n`, the nearest of the border, or `i mod 2n` counted back; tents over the texels around the point.
#[test]
fn all_nine_pairs_of_wraps_go_on_in_their_directions() {
    let (file, exact) = random_colors();
    let ([width, height], counts) = (SIZE.map(f64::from), SIZE.map(|n| n as i32));
    let wraps = [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror];
    for pair in wraps.into_iter().flat_map(|a| wraps.map(|b| [a, b])) {
        let index =
            |at: [i32; 2]| [0, 1].map(|axis| endless(pair[axis], at[axis], counts[axis]) as u32);
        let texel = |i: i32, j: i32| {
            let [column, row] = index([i, j]);
            exact(column, row)
        };
        let [nearest, bilinear] = [Filtering::Nearest, Filtering::Bilinear].map(|filtering| {
            let [wrap_u, wrap_v] = pair.map(Some);
            Image { wrap_u, wrap_v, ..filtered(&file, filtering, Rule::Even) }
        });
        let colors = [&nearest, &bilinear].map(by_uv);
        let texels = [&nearest, &bilinear].map(texel_by_uv);
        let mut random = Pcg32::new(29, 10);
        for _ in 0..500 {
            let [u, v] = [0; 2].map(|_| 7.0 * random.uniform() - 3.0);
            let what = format!("{pair:?} at ({u}, {v})");
            let [i, j] = [width * u, height * v].map(|x| floor(x) as i32);
            assert_close(colors[0]([u, v]), texel(i, j), &format!("nearest, {what}"));
            let [x, y] = [width * u - 0.5, height * v - 0.5];
            let tent = |x: f64, i: i32| (1.0 - (x - f64::from(i)).abs()).max(0.0);
            let around = |x: f64| [0, 1].map(|step| floor(x) as i32 + step);
            let parts = around(y).into_iter().flat_map(|j| around(x).map(|i| (i, j)));
            let sum = parts.map(|(i, j)| tent(x, i) * tent(y, j) * texel(i, j)).sum::<Rgb>();
            assert_close(colors[1]([u, v]), sum, &format!("bilinear, {what}"));
            for of in &texels {
                assert_eq!(of([u, v]), index([i, j]), "the texel named: {what}");
            }
        }
    }
}

proptest! {
    #![proptest_config(laws())]

    /// Law: bilinear look-up is the sum of tents around the centres of the texels, by either rule and at
    /// every border; therefore it is exact at centres, reproduces affine images and stays between its
    /// neighbours. Oracle: that sum over all texels.
    /// Book: fig. 29.19, bilinear interpolation.
    #[test]
    fn bilinear_look_up_is_a_sum_of_tents((u, v) in (0.0..=1.0_f64, 0.0..=1.0_f64)) {
        let (file, exact) = random_colors();
        let [width, height] = SIZE.map(f64::from);
        let even = [width * u - 0.5, height * v - 0.5];
        let book = [(width - 1.0) * u, (height - 1.0) * v];
        let clamped = |i: i32, n: i32| i.clamp(0, n - 1) as u32;
        for (rule, at) in [(Rule::Even, even), (Rule::Book, book)] {
            let image = filtered(&file, Filtering::Bilinear, rule);
            let (wrap_u, wrap_v) = (Some(Wrap::Clamp), Some(Wrap::Clamp));
            let color = by_uv(&Image { wrap_u, wrap_v, ..image });
            let what = format!("{rule:?} at ({u}, {v})");
            assert_close(color([u, v]), by_tents(at, &exact, clamped), &what);
        }
        let color = by_uv(&filtered(&file, Filtering::Bilinear, Rule::Even));
        let repeated = by_tents(even, &exact, |i, n| i.rem_euclid(n) as u32);
        assert_close(color([u, v]), repeated, &format!("repeated, at ({u}, {v})"));
    }

    /// Law: whatever the coordinates are, some texel is found. Oracle: the range of the image's colours.
    #[test]
    fn every_coordinate_has_a_texel(uv in prop::array::uniform2(prop_oneof![
        -1e18..1e18_f64,
        Just(f64::MAX),
        Just(-f64::MAX),
        Just(1.0),
        Just(-f64::MIN_POSITIVE),
        Just(2.0),
    ])) {
        let file = numbered();
        for filtering in [Filtering::Nearest, Filtering::Bilinear] {
            for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror] {
                let image = filtered(&file, filtering, Rule::Even);
                let color = by_uv(&Image { wrap_u: Some(wrap), wrap_v: Some(wrap), ..image })(uv);
                let [column, row] = [color.r, color.g].map(|c| 65535.0 * c);
                let is_there = (0.0..4.1).contains(&column) && (0.0..3.1).contains(&row);
                prop_assert!(
                    is_there,
                    "{wrap:?}, {filtering:?} at {uv:?}: column {column}, row {row}"
                );
            }
        }
    }
}

/// Law: where nothing is said, an image goes on as its mapping's table says: round about where it has a seam, and
/// its border elsewhere; by the surface's own coordinates it is repeated. Oracle: the same image with these wraps
/// said, at points near its four borders, where a bilinear look-up reads across them.
#[test]
fn what_is_not_said_of_a_wrap_is_that_of_the_mapping() {
    let (file, _) = random_colors();
    let (around, ends) = (Wrap::Repeat, Wrap::Clamp);
    for (mapping, wraps) in [
        (None, [around, around]),
        (Some(Mapping::Cylindrical), [around, ends]),
        (Some(Mapping::Spherical), [around, ends]),
        (Some(Mapping::Hemispherical), [around, ends]),
        (Some(Mapping::Square), [ends, ends]),
        (Some(Mapping::LightProbe), [ends, ends]),
        (Some(Mapping::Panoramic), [ends, ends]),
    ] {
        let filtered = filtered(&file, Filtering::Bilinear, Rule::Even);
        let unsaid = Image { mapping, wrap_u: None, wrap_v: None, ..filtered };
        let [wrap_u, wrap_v] = wraps.map(Some);
        let said = Image { wrap_u, wrap_v, ..unsaid.clone() };
        let [unsaid, said] = [unsaid, said].map(|image| super::texture(&image));
        let mut random = Pcg32::new(29, 11);
        for _ in 0..2_000 {
            let mut near = |least: f64, most: f64| least + (most - least) * random.uniform();
            // beside the poles, the horizon, the seam, the corners of a square
            let mut c = || if near(0.0, 1.0) < 0.5 { near(-0.1, 0.1) } else { near(-1.0, 1.0) };
            let point = Point::new(c(), c(), c());
            let surface = Surface::new(point, 0.0, Normal::Y);
            let at = TexturePoint::with_uv(&surface, [near(-0.2, 1.2), near(-0.2, 1.2)]);
            let (found, expected) = (unsaid.color(&at), said.color(&at));
            assert_eq!(
                found, expected,
                "{mapping:?} at {point:?}: the colour without a wrap, and with {wraps:?}"
            );
        }
    }
}

/// Law: images that are drawn have at most 2^26 texels together; one more is refused before it is drawn. Oracle: the sum.
#[test]
fn drawn_images_together_are_not_too_large() {
    let mut resources = Resources::default();
    let mut build = |width, height| {
        let drawn = Drawn { picture: Picture::Country, width, height };
        Kind::from(Image::of_drawn(drawn, None)).build(&mut resources).map(|_| ())
    };
    assert_eq!(build(1, 1).map_err(|it| it.to_string()), Ok(()), "an image of one texel");
    let error = build(1 << 13, 1 << 13).expect_err("one texel too many").to_string();
    let expected = "67108865 texels, with the images before it, are too many; at most 67108864 fit";
    assert!(error.contains(expected), "found {error:?}, expected {expected:?}");
}
