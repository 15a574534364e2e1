//! Numbers and text in the page.

use report::html::*;

#[test]
fn numbers_are_short() {
    let cases = [
        (0.0, "0"),
        (4.21, "4.2"),
        (35.4, "35"),
        (349.6, "350"),
        (0.0312, "0.031"),
        (1.23e7, "1.2·10⁷"),
        (9.96, "10"),
        (99.6, "100"),
        (4.4e-9, "4.4·10⁻⁹"),
    ];
    for (x, text) in cases {
        assert_eq!(short(x), text);
    }
    assert_eq!(time(3.5e-8), "35 ns");
    assert_eq!(time(0.00123), "1.2 ms");
    assert_eq!(bytes(1.5e6), "1.5 MB");
    assert_eq!(count(1000), "1000");
    assert_eq!(count(1_031_623), "1\u{202f}031\u{202f}623");
}
