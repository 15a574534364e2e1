//! Formulas of numbers, points and colours: `+ - * / ^`, brackets, names of values, and the functions of
//! [`closed_forms`](super::closed_forms), all for each coordinate by itself.

use toml::{Table, Value};

use super::closed_forms;
use crate::prelude::*;

/// The value of a formula.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Three coordinates or channels; those of a number are equal.
    pub coordinates: [f64; 3],
    is_number: bool,
}

impl Quantity {
    fn number(value: f64) -> Self {
        Self { coordinates: [value; 3], is_number: true }
    }

    fn with(self, other: Self, combined: impl Fn(f64, f64) -> f64) -> Self {
        let [a, b] = [self.coordinates, other.coordinates];
        let coordinates = std::array::from_fn(|i| combined(a[i], b[i]));
        Self { coordinates, is_number: self.is_number && other.is_number }
    }
}

/// The value of a formula in which these names may stand.
pub fn evaluate(text: &str, names: &Table) -> Quantity {
    let mut formula = Formula { rest: text, names };
    let value = formula.sum();
    let rest = formula.rest.trim();
    assert!(rest.is_empty(), "`{text}` is no formula: what is `{rest}`?");
    value
}

/// The value with its formulas replaced by what they mean. One that is a name alone may mean anything.
pub fn filled(value: &Value, names: &Table) -> Value {
    match value {
        Value::String(text) => match text.strip_prefix("= ") {
            None => value.clone(),
            Some(name) if names.contains_key(name) => filled(&names[name], names),
            Some(formula) => {
                let Quantity { coordinates, is_number } = evaluate(formula, names);
                let all = coordinates.map(written);
                if is_number { all[0].clone() } else { Value::Array(all.to_vec()) }
            }
        },
        Value::Array(all) => Value::Array(all.iter().map(|it| filled(it, names)).collect()),
        Value::Table(fields) => {
            let field = |(key, value): (&String, &Value)| (key.clone(), filled(value, names));
            Value::Table(fields.iter().map(field).collect())
        }
        other => other.clone(),
    }
}

/// A number as scene files have it: without a point where it counts.
fn written(number: f64) -> Value {
    let whole = number as i64;
    if whole as f64 == number { Value::Integer(whole) } else { Value::Float(number) }
}

struct Formula<'a> {
    rest: &'a str,
    names: &'a Table,
}

impl<'a> Formula<'a> {
    fn takes(&mut self, sign: char) -> bool {
        let rest = self.rest.trim_start().strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn sum(&mut self) -> Quantity {
        let mut value = self.product();
        loop {
            value = match () {
                () if self.takes('+') => value.with(self.product(), |a, b| a + b),
                () if self.takes('-') => value.with(self.product(), |a, b| a - b),
                () => return value,
            };
        }
    }

    fn product(&mut self) -> Quantity {
        let mut value = self.factor();
        loop {
            value = match () {
                () if self.takes('*') => value.with(self.factor(), |a, b| a * b),
                () if self.takes('/') => value.with(self.factor(), |a, b| a / b),
                () => return value,
            };
        }
    }

    fn factor(&mut self) -> Quantity {
        if self.takes('-') {
            return Quantity::number(0.0).with(self.factor(), |zero, b| zero - b);
        }
        let base = self.atom();
        if self.takes('^') { base.with(self.factor(), power) } else { base }
    }

    fn atom(&mut self) -> Quantity {
        if self.takes('(') {
            let value = self.sum();
            assert!(self.takes(')'), "`)` is missing before `{}`", self.rest);
            return value;
        }
        let word = self.word();
        if let Ok(number) = word.parse() {
            return Quantity::number(number);
        }
        if self.takes('(') {
            return self.called(word);
        }
        if word == "pi" {
            return Quantity::number(PI);
        }
        let value = self.names.get(word).unwrap_or_else(|| panic!("nothing is named `{word}`"));
        self.quantity(value)
    }

    fn word(&mut self) -> &'a str {
        let rest = self.rest.trim_start();
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_' && c != '.');
        let (word, rest) = rest.split_at(end.unwrap_or(rest.len()));
        self.rest = rest;
        word
    }

    fn called(&mut self, function: &str) -> Quantity {
        let mut all = vec![self.sum()];
        while self.takes(',') {
            all.push(self.sum());
        }
        assert!(self.takes(')'), "`)` is missing before `{}`", self.rest);
        let coordinates = std::array::from_fn(|i| {
            let arguments: Vec<f64> = all.iter().map(|it| it.coordinates[i]).collect();
            closed_forms::call(function, &arguments)
        });
        Quantity { coordinates, is_number: all.iter().all(|it| it.is_number) }
    }

    fn quantity(&self, value: &Value) -> Quantity {
        match value {
            Value::Integer(number) => Quantity::number(*number as f64),
            Value::Float(number) => Quantity::number(*number),
            Value::String(text) if text.starts_with("= ") => evaluate(&text[2..], self.names),
            Value::Array(all) if all.len() == 3 => {
                let coordinates = std::array::from_fn(|i| self.quantity(&all[i]).coordinates[i]);
                Quantity { coordinates, is_number: false }
            }
            other => panic!("{other} is no number, point or colour"),
        }
    }
}

/// Law: formulas have the usual order of operations, powers of negative and fractional exponents, and each coordinate by itself.
/// Oracle: numbers worked out by hand.
#[test]
fn formulas_mean_what_they_say() {
    let names: Table =
        toml::from_str("a = 3\nv = [1, '= a - 1', 0.5]\nw = '= 2 * v'").expect("TOML");
    for (text, expected) in [
        ("1 + 2 * 3 - 8 / 4 / 2", [6.0; 3]),
        ("-2 ^ 2 + (1 - 4) * -a", [5.0; 3]),
        ("4 ^ -0.5 + sqrt(a ^ 2 + 16)", [5.5; 3]),
        ("w - v * a", [-1.0, -2.0, -0.5]),
    ] {
        assert_eq!(evaluate(text, &names).coordinates, expected, "{text}");
    }
    let shape: Table =
        toml::from_str("it = { at = '= w', r = '= a / 2', name = 'a' }").expect("TOML");
    let expected: Table =
        toml::from_str("it = { at = [2, 4, 1], r = 1.5, name = 'a' }").expect("TOML");
    assert_eq!(filled(&Value::Table(shape), &names), Value::Table(expected));
}
