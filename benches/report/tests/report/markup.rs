//! Words, cells and figures of pages, without a report.

use groundtruth::film::Film;
use groundtruth::rgb::Rgb;
use report::words::*;

/// Law: words are listed with commas and one `and`; what is as good is said in brackets, if there is any; a disturbed time
/// has a mark; counts of five digits and more have a narrow space before each three; the units of times and sizes are those in which they are at least 1. Oracle: written by hand.
#[test]
fn parts_hold_what_they_were_given() {
    let words: Vec<String> = ["a", "b", "c", "d"].map(str::to_owned).to_vec();
    let expected = ["none", "a", "a and b", "a, b and c", "a, b, c and d"];
    for (count, expected) in expected.into_iter().enumerate() {
        assert_eq!(listed(&words[..count]), expected, "{count} words");
        let as_good =
            if count > 0 { format!(" (or {expected}, about as good)") } else { String::new() };
        assert_eq!(or_as_good(&words[..count]), as_good, "{count} words as good");
    }
    let flags = [false, true].map(|disturbed| flagged("3 s".to_owned(), disturbed).plain());
    assert_eq!(flags, ["3 s", "3 s ‡"]);
    let capitals = ["", "a", "ärger im Wald", "X y"].map(capital);
    assert_eq!(capitals, ["", "A", "Ärger im Wald", "X y"]);
    assert_eq!([rough_or_dash(None), rough_or_dash(Some(0.25))], [DASH, "0.25"]);
    assert_eq!(with_minus("-1-2"), "−1−2", "minus signs");
    let counts = [0, 9999, 10_000, 1_234_567_890].map(|n| count(n).replace('\u{202f}', " "));
    assert_eq!(counts, ["0", "9999", "10 000", "1 234 567 890"]);
    let units = [time(3.5e-8), time(0.00123), time(2e-12), bytes(1.5e6), bytes(0.5)];
    assert_eq!(units, ["35 ns", "1.2 ms", "0.002 ns", "1.5 MB", "0.5 B"]);
}

/// Law: a picture is a figure with the film as it is displayed: twice the exposure is another picture, and that of half the
/// light the same. Oracle: two films.
#[test]
fn a_film_is_shown_with_its_exposure() {
    let shown = |value: f64, exposure: f64| {
        let mut it = Film::new(2, 1);
        it.set([0, 0], Rgb::grey(value));
        film(&it, exposure, "it", "below".to_owned()).html()
    };
    let one = shown(0.25, 1.0);
    assert!(one.contains("<figcaption>below</figcaption>"), "{one}");
    assert_eq!(shown(0.125, 2.0), one, "half the light at twice the exposure");
    assert_ne!(shown(0.25, 2.0), one, "twice the exposure");
}
