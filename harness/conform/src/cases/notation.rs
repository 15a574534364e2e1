//! The notation of files of families, which `scenes/notation.toml` explains: from an entry to one of its cases.

use ask::Draw;
use std::collections::BTreeMap;

use serde_json::{Value, json};
use toml::Table;

use super::functions::function;
use crate::questions::round;
use groundtruth::similar::did_you_mean;

/// A value, or what is wrong with its text.
type Drawn = Result<Value, String>;

/// A case that is being drawn.
pub struct Drawing<'a> {
    /// What has a name.
    entry: &'a Table,
    draw: Draw,
    /// What is the same in the whole case.
    once: BTreeMap<&'a str, Value>,
}

impl<'a> Drawing<'a> {
    /// Of the entry, with these random numbers.
    pub fn new(entry: &'a Table, draw: Draw) -> Self {
        Self { entry, draw, once: BTreeMap::new() }
    }

    /// What has this name, drawn anew.
    ///
    /// # Errors
    /// Says which text is wrong, and why.
    pub fn anew(&mut self, name: &str) -> Drawn {
        match self.entry.get(name) {
            Some(value) => self.value(value).map_err(|problem| format!("{name}: {problem}")),
            None => self.call(name, &[]),
        }
    }

    /// What has this name, drawn once for the case.
    fn once(&mut self, name: &str) -> Drawn {
        let Some((name, _)) = self.entry.get_key_value(name) else { return self.anew(name) };
        if let Some(value) = self.once.get(&**name) {
            return Ok(value.clone());
        }
        let value = self.anew(name)?;
        self.once.insert(name, value.clone());
        Ok(value)
    }

    fn call(&mut self, name: &str, arguments: &[Value]) -> Drawn {
        let Some(function) = function(name) else {
            let known: Vec<&str> = self.entry.keys().map(String::as_str).collect();
            return Err(format!("nothing is called `{name}`{}", did_you_mean(name, &known)));
        };
        let problem = || format!("`{name}` does not take {}", json!(arguments));
        function(&mut self.draw, arguments).ok_or_else(problem)
    }

    fn value(&mut self, of: &toml::Value) -> Drawn {
        match of {
            toml::Value::String(text) => {
                self.text(text, round).map_err(|problem| format!("`{text}`: {problem}"))
            }
            toml::Value::Array(items) => items.iter().map(|item| self.value(item)).collect(),
            toml::Value::Table(fields) => self.table(fields),
            plain => Ok(json!(plain)),
        }
    }

    fn table(&mut self, fields: &Table) -> Drawn {
        if let Some(toml::Value::Array(choices)) = fields.get("any") {
            let choice = self.draw.below(choices.len());
            return self.value(&choices[choice]);
        }
        if let (Some(count), Some(item)) = (fields.get("repeat"), fields.get("of")) {
            let count = self.value(count)?.as_u64().ok_or("`repeat` is no whole number")?;
            return (0..count).map(|_| self.value(item)).collect();
        }
        let field = |(name, value)| Ok((String::clone(name), self.value(value)?));
        fields.iter().map(field).collect()
    }

    /// What a text stands for. Numbers that are drawn, sums and products are rounded.
    fn text(&mut self, text: &str, round: fn(f64) -> f64) -> Drawn {
        if let Some(all_digits) = text.strip_prefix("fine ") {
            return self.text(all_digits, |x| x);
        }
        let choices = split(text, " | ");
        if choices.len() > 1 {
            let choice = self.draw.below(choices.len());
            return self.text(choices[choice], round);
        }
        let Some((left, sign, right)) = last_sign(text) else { return self.atom(text, round) };
        let (left, right) = (self.text(left, round)?, self.text(right, round)?);
        match sign {
            '+' => calculated(&left, &right, &|a, b| round(a + b)),
            '-' => calculated(&left, &right, &|a, b| round(a - b)),
            '*' => calculated(&left, &right, &|a, b| round(a * b)),
            _ => paired(&left, &right, &mut |middle, half| {
                let (middle, half) = (middle.as_f64()?, half.as_f64()?);
                Some(json!(round(self.draw.between(middle - half, middle + half))))
            }),
        }
    }

    fn atom(&mut self, text: &str, round: fn(f64) -> f64) -> Drawn {
        if let [low, high] = split(text, "..")[..] {
            let (low, high) = (self.atom(low, round)?, self.atom(high, round)?);
            return paired(&low, &high, &mut |low, high| {
                Some(json!(round(self.draw.between(low.as_f64()?, high.as_f64()?))))
            });
        }
        if let Some(count) = text.strip_prefix("below ") {
            let count = self.atom(count, round)?.as_u64().ok_or("no whole number")?;
            return Ok(json!(self.draw.below(count as usize)));
        }
        if let Some(name) = text.strip_suffix('?') {
            return self.anew(name);
        }
        if let Some(name) = text.strip_prefix("-$") {
            return calculated(&json!(-1), &self.once(name)?, &|a, b| a * b);
        }
        if let Some(path) = text.strip_prefix('$') {
            let (name, fields) = path.split_once('.').unwrap_or((path, ""));
            let mut fields = fields.split('.').filter(|field| !field.is_empty());
            return fields.try_fold(self.once(name)?, |value, field| {
                let inside = value.get(field).cloned();
                inside.ok_or_else(|| format!("`{name}` has no field `{field}`"))
            });
        }
        let listed = text.strip_suffix(']').and_then(|text| text.strip_prefix('['));
        let called = text.strip_suffix(')').and_then(|text| text.split_once('('));
        let items = listed.or(called.map(|(_, items)| items)).unwrap_or_default();
        let mut item = |item: &&str| self.text(item.trim(), round);
        match (listed, called) {
            (None, None) => Ok(serde_json::from_str(text).unwrap_or_else(|_| json!(text))),
            (_, None) => split(items, ",").iter().map(item).collect(),
            (_, Some((name, _))) => {
                let arguments =
                    split(items, ",").iter().map(&mut item).collect::<Result<Vec<_>, _>>()?;
                self.call(name, &arguments)
            }
        }
    }
}

/// The text between separators that are in no brackets.
fn split<'t>(text: &'t str, separator: &str) -> Vec<&'t str> {
    let (mut parts, mut begin, mut depth) = (Vec::new(), 0, 0);
    for (at, c) in text.char_indices() {
        match c {
            '[' | '(' => depth += 1,
            ']' | ')' => depth -= 1,
            _ if depth == 0 && at >= begin && text[at..].starts_with(separator) => {
                parts.push(&text[begin..at]);
                begin = at + separator.len();
            }
            _ => {}
        }
    }
    parts.push(&text[begin..]);
    parts
}

/// What is before and after the sign that counts last: the last of sums, else the last of products.
fn last_sign(text: &str) -> Option<(&str, char, &str)> {
    let after = |sign: char| {
        let right = *split(text, &format!(" {sign} ")).last()?;
        let end = text.len().checked_sub(right.len() + sign.len_utf8() + 2)?;
        Some((&text[..end], sign, right))
    };
    let sums = ['+', '-', '±'].into_iter().filter_map(after);
    sums.max_by_key(|(left, ..)| left.len()).or_else(|| after('*'))
}

/// The results for two numbers, for the numbers of two lists in pairs, or for a number and each one of a list.
fn paired(a: &Value, b: &Value, of: &mut dyn FnMut(&Value, &Value) -> Option<Value>) -> Drawn {
    match (a, b) {
        (Value::Array(all), Value::Array(others)) if all.len() == others.len() => {
            all.iter().zip(others).map(|(a, b)| paired(a, b, of)).collect()
        }
        (Value::Array(all), Value::Number(_)) => all.iter().map(|a| paired(a, b, of)).collect(),
        (Value::Number(_), Value::Array(all)) => all.iter().map(|b| paired(a, b, of)).collect(),
        _ => of(a, b).ok_or_else(|| format!("{a} and {b} do not go together")),
    }
}

/// Sums and products; those of whole numbers are whole.
fn calculated(a: &Value, b: &Value, of: &dyn Fn(f64, f64) -> f64) -> Drawn {
    paired(a, b, &mut |a, b| {
        let result = of(a.as_f64()?, b.as_f64()?);
        Some(if a.is_i64() && b.is_i64() { json!(result as i64) } else { json!(result) })
    })
}
