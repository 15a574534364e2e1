//! From radiance to the screen and to files.

use groundtruth::film::{OutOfGamut, Tone, write};
use testkit::properties::*;

use crate::prelude::*;

fn radiance(largest: f64) -> impl Strategy<Value = Rgb> {
    let channel = move || prop_oneof![4 => 0.0..largest, 1 => Just(0.0), 1 => Just(1.0)];
    [channel(), channel(), channel()].prop_map(Rgb::from)
}

/// Law: the colour (2, 1, 0) is shown as (1, ½, 0); where colours out of gamut are marked, one with a channel
/// above 1 is shown red; ½ at gamma 2.2 is 0.7297.
/// Book: showing a colour: the range, gamma, bytes.
#[test]
fn the_books_examples_are_shown_as_in_the_book() {
    let clamp = Tone { out_of_gamut: OutOfGamut::ClampToColor, ..Tone::PLAIN };
    assert_eq!(Tone::PLAIN.map(Rgb::new(2.0, 1.0, 0.0)), Rgb::new(1.0, 0.5, 0.0));
    assert_eq!(clamp.map(Rgb::new(0.0, 0.5, 1.0 + 1e-12)), Rgb::new(1.0, 0.0, 0.0));
    assert_eq!(clamp.map(Rgb::new(0.0, 0.5, 1.0)), Rgb::new(0.0, 0.5, 1.0));
    let shown = Tone { gamma: 2.2, ..Tone::PLAIN }.map(Rgb::grey(0.5));
    assert!((shown.g - 0.7297).abs() < 5e-5, "{shown:?}");
    assert_eq!(
        Tone { gamma: 2.0, ..Tone::PLAIN }.map(Rgb::new(0.25, 0.0, 1.0)),
        Rgb::new(0.5, 0.0, 1.0)
    );
}

proptest! {
    #![proptest_config(laws())]

    /// Law: max-to-one keeps the hue: the shares of the channels. Oracle: cross products of channels.
    /// Book: showing a colour: the range, gamma, bytes.
    #[test]
    fn max_to_one_keeps_the_hue(color in radiance(50.0)) {
        let shown = Tone::PLAIN.map(color);
        at_most!(shown.max(), 1.0);
        let (a, b) = (color.to_array(), shown.to_array());
        for i in 0..3 {
            let j = (i + 1) % 3;
            near!(a[i] * b[j], a[j] * b[i], 4.0 * U * color.max());
        }
        if color.max() <= 1.0 {
            prop_assert_eq!(shown, color);
        } else {
            prop_assert_eq!(shown.max(), 1.0);
        }
    }

    /// Law: gamma is applied last, after the out-of-gamut rule; raising to γ undoes it: `(x^(1/γ))^γ = x`.
    /// Book: showing a colour: the range, gamma, bytes.
    #[test]
    fn gamma_comes_last(color in radiance(5.0), gamma in 0.5..4.0_f64, exposure in 0.1..10.0_f64) {
        let tone = Tone { exposure, gamma, ..Tone::PLAIN };
        let (shown, linear) = (tone.map(color), Tone::PLAIN.map(exposure * color));
        for (s, l) in shown.to_array().into_iter().zip(linear.to_array()) {
            prop_assert!((power(s, gamma) - l).abs() < 1e-14, "{s} {l}");
        }
    }

    /// Law: a channel becomes the nearest of 256 bytes, where the book truncates: 254.9 would be 254. Oracle:
    /// no byte is nearer.
    /// Book: showing a colour: the range, gamma, bytes.
    #[test]
    fn bytes_are_the_nearest(color in radiance(1.0)) {
        for (byte, c) in Tone::PLAIN.to_bytes(color).into_iter().zip(color.to_array()) {
            prop_assert!((f64::from(byte) - 255.0 * c).abs() <= 0.5, "{byte} for {c}");
        }
    }

    /// Law: colours add, multiply and divide channel by channel; `powc` to a whole power is the product, and
    /// `average` the channels' mean.
    /// Book: colours: the operations of RGBColor.
    #[test]
    fn colours_calculate_by_channels(a in radiance(3.0), b in radiance(3.0), k in 0.1..9.0_f64) {
        prop_assert_eq!(a.powc(2.0), a * a);
        prop_assert_eq!((a + b).g, a.g + b.g);
        prop_assert_eq!((a * b).b, a.b * b.b);
        prop_assert_eq!((k * a).r, k * a.r);
        prop_assert_eq!((a / k).r, a.r / k);
        prop_assert_eq!(a.average(), (a.r + a.g + a.b) / 3.0);
        prop_assert_eq!(a.max(), a.r.max(a.g.max(a.b)));
    }
}

/// Law: PNG has the bytes that are shown, the top left pixel first. Oracle: another reader, and `255 x^(1/γ)` rounded
/// by hand; 2 becomes 1 first, and takes the other channels along.
#[test]
fn png_has_the_shown_bytes_from_the_top_left() {
    let by_hand: [(f64, [[u8; 3]; 4]); 3] = [
        (2.2, [[11, 31, 90], [123, 136, 186], [217, 243, 255], [255, 186, 0]]),
        (2.0, [[8, 26, 81], [114, 128, 180], [213, 242, 255], [255, 180, 0]]),
        (0.5, [[0, 0, 3], [10, 16, 64], [125, 207, 255], [255, 64, 0]]),
    ];
    let colors =
        [[0.001, 0.01, 0.1], [0.2, 0.25, 0.5], [0.7, 0.9, 1.0], [2.0, 1.0, 0.0]].map(Rgb::from);
    let mut film = Film::new(2, 2);
    pixels(2, 2).zip(colors).for_each(|(at, color)| film.set(at, color));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("picture.PNG");
    for (gamma, expected) in by_hand {
        write(&film, &Tone { gamma, ..Tone::PLAIN }, &path).expect("it can be written");
        let read = image::open(&path).expect("it can be read").to_rgb8();
        assert_eq!(read.dimensions(), (2, 2));
        for ([x, y], bytes) in pixels(2, 2).zip(expected) {
            assert_eq!(read.get_pixel(x, y).0, bytes, "gamma {gamma} at ({x}, {y})");
        }
    }
}
