//! The digits with which the numbers of a log are printed.

/// What is seen of the digits of many numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digits {
    /// The most significant digits of a number.
    pub significant: usize,
    /// Numbers with a decimal point.
    with_point: usize,
    /// The fewest and the most decimals of those.
    decimals: [usize; 2],
    /// Whether a number has an exponent.
    has_exponent: bool,
}

/// Fewer numbers may have the same number of decimals by accident.
const ENOUGH: usize = 20;

impl Digits {
    /// The number of decimals that all numbers have, if they have: so `%f` and `toFixed` print them.
    pub fn fixed(&self) -> Option<usize> {
        let [fewest, most] = self.decimals;
        let is_fixed = fewest == most && self.with_point >= ENOUGH && !self.has_exponent;
        // fifteen decimals and more are all digits of a double number below 1
        (is_fixed && (3..15).contains(&most)).then_some(most)
    }

    /// Adds the numbers of a line.
    pub fn add(&mut self, line: &[u8]) {
        let mut in_text = false;
        let mut rest = line;
        while let Some((&byte, after)) = rest.split_first() {
            in_text ^= byte == b'"';
            if in_text || !byte.is_ascii_digit() {
                rest = after;
                continue;
            }
            let is_of_number = |byte: &u8| byte.is_ascii_digit() || b".eE+-".contains(byte);
            let length = rest.iter().position(|byte| !is_of_number(byte)).unwrap_or(rest.len());
            self.add_number(&rest[..length]);
            rest = &rest[length..];
        }
    }

    fn add_number(&mut self, number: &[u8]) {
        let exponent = number.iter().position(|byte| b"eE".contains(byte));
        self.has_exponent |= exponent.is_some();
        let mantissa = &number[..exponent.unwrap_or(number.len())];
        let digits = mantissa.iter().filter(|byte| byte.is_ascii_digit());
        self.significant = self.significant.max(digits.skip_while(|byte| **byte == b'0').count());
        if let Some(point) = mantissa.iter().position(|byte| *byte == b'.') {
            let decimals = mantissa.len() - point - 1;
            let [fewest, most] = self.decimals;
            self.decimals = if self.with_point == 0 {
                [decimals; 2]
            } else {
                [fewest.min(decimals), most.max(decimals)]
            };
            self.with_point += 1;
        }
    }
}
