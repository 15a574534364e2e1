//! Descriptions of scenes: whole, without words that the scene does not use, and true.

mod formulas;
mod random;
mod truth;
mod whole;

use std::path::Path;

use exchange::describe;
use groundtruth::scene::Scene;
use groundtruth::world::World;

/// A scene, built, and its description.
struct Described {
    world: World,
    text: String,
}

fn described(name: &str, scene: &Scene) -> Described {
    let world = World::build(scene).unwrap_or_else(|e| panic!("{name}: {e}"));
    let text = describe::describe(name, scene, &world, Path::new(""));
    Described { world, text: text.unwrap_or_else(|e| panic!("{name}: {e}")) }
}

/// The lines of a section.
fn section<'a>(text: &'a str, title: &str) -> Vec<&'a str> {
    let is_rule = |line: &str| !line.is_empty() && line.chars().all(|c| c == '=');
    let lines: Vec<&str> = text.lines().collect();
    let is_title = |at: usize| lines.get(at + 1).is_some_and(|below| is_rule(below));
    let start = (0..lines.len()).find(|&at| lines[at] == title && is_title(at));
    let Some(start) = start else { return Vec::new() };
    let end = (start + 1..lines.len()).find(|&at| is_title(at)).unwrap_or(lines.len());
    lines[start + 2..end].to_vec()
}

/// The numbers of a text, in its order. Digits that belong to a name, as in `DVec3`, are not numbers.
fn numbers(text: &str) -> Vec<f64> {
    let belongs = |c: char| c.is_alphanumeric() || "_.+-".contains(c);
    let words = text.split(|c: char| !belongs(c));
    let words = words.map(|word| word.trim_end_matches('.'));
    words.filter_map(|word| word.parse().ok()).filter(|number: &f64| number.is_finite()).collect()
}
