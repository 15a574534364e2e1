//! The few functions of POV-Ray's user-defined functions that are written.

/// The value of a function at a point.
pub fn value(text: &str, at: [f64; 3]) -> f64 {
    let mut parser = Parser { rest: text, at };
    let value = parser.sum();
    assert_eq!(parser.rest, "", "all of {text} is read");
    value
}

struct Parser<'a> {
    rest: &'a str,
    at: [f64; 3],
}

impl Parser<'_> {
    fn takes(&mut self, mark: &str) -> bool {
        let after = self.rest.strip_prefix(mark);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }

    fn sum(&mut self) -> f64 {
        let mut sum = self.product();
        loop {
            if self.takes("+") {
                sum += self.product();
            } else if self.takes("-") {
                sum -= self.product();
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut product = self.atom();
        loop {
            if self.takes("*") {
                product *= self.atom();
            } else if self.takes("/") {
                product /= self.atom();
            } else {
                return product;
            }
        }
    }

    fn atom(&mut self) -> f64 {
        if self.takes("-") {
            return -self.atom();
        }
        for name in ["floor", "abs", "mod", "min", "select"] {
            if self.takes(name) {
                let values = self.arguments();
                return match name {
                    "floor" => groundtruth::math::floor(values[0]),
                    "abs" => values[0].abs(),
                    "mod" => values[0] % values[1],
                    "min" => values.into_iter().fold(f64::INFINITY, f64::min),
                    _ if values[0] < 0.0 => values[1],
                    _ => values[2],
                };
            }
        }
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            if self.takes(name) {
                return self.at[axis];
            }
        }
        if self.rest.starts_with('(') {
            return self.arguments()[0];
        }
        let is_number = |c: char| c.is_ascii_digit() || c == '.';
        let end = self.rest.find(|c| !is_number(c)).unwrap_or(self.rest.len());
        let (number, after) = self.rest.split_at(end);
        self.rest = after;
        number.parse().expect("a number")
    }

    fn arguments(&mut self) -> Vec<f64> {
        assert!(self.takes("("));
        let mut values = vec![self.sum()];
        while self.takes(",") {
            values.push(self.sum());
        }
        assert!(self.takes(")"));
        values
    }
}
