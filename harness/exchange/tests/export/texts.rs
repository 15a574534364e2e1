//! The numbers in exported texts; the words around them are held by the goldens.

use exchange::export::Target;
use groundtruth::math::Vector;
use groundtruth::scene::Scene;

/// The statements of a text for POV-Ray, or the lines of one for Mitsuba, which has an element on each.
pub struct Parts(Vec<String>);

impl Parts {
    pub fn of(target: Target, scene: &Scene) -> Self {
        let exported = target.write("scene", "scene", scene, "".as_ref());
        let text = exported.unwrap_or_else(|all| panic!("{all:?}")).text;
        let mut parts = vec![String::new()];
        for line in text.lines().filter(|line| !line.starts_with("//")) {
            let last = parts.last_mut().expect("one");
            *last += &format!(" {}", line.trim());
            if last.matches('{').count() == last.matches('}').count() {
                parts.push(String::new());
            }
        }
        Self(parts)
    }

    pub fn pov(scene: &Scene) -> Self {
        Self::of(Target::Pov, scene)
    }

    pub fn mitsuba(scene: &Scene) -> Self {
        Self::of(Target::Mitsuba, scene)
    }

    /// The parts that begin so.
    pub fn all(&self, head: &str) -> Vec<&str> {
        self.0
            .iter()
            .filter_map(|it| it.strip_prefix(' ')?.starts_with(head).then_some(&**it))
            .collect()
    }

    pub fn one(&self, head: &str) -> &str {
        let [only] = self.all(head)[..] else { panic!("one `{head}` in {:?}", self.0) };
        only
    }
}

/// The numbers that follow each word of this name in a statement, up to the next word.
pub fn each(statement: &str, word: &str) -> Vec<Vec<f64>> {
    let number = |text: &str| match text.strip_suffix("/pi") {
        Some(text) => text.parse().ok().map(|it: f64| it / std::f64::consts::PI),
        None => text.parse().ok(),
    };
    let numbers = |text: &str| {
        let marks = |c: char| c.is_whitespace() || "<>,*{[]=;".contains(c);
        let pieces = text.split(marks).filter(|it| !it.is_empty() && *it != "exposure");
        pieces.map_while(number).collect()
    };
    statement.split(&format!(" {word} ")).skip(1).map(numbers).collect()
}

/// Those of the first.
pub fn numbers(statement: &str, word: &str) -> Vec<f64> {
    each(statement, word).into_iter().next().unwrap_or_else(|| panic!("no `{word}` in {statement}"))
}

/// The numbers of the first child of this name in an element: its value, its coordinates, or its matrix.
pub fn values(element: &str, name: &str) -> Vec<f64> {
    let after = element.split_once(&format!("name=\"{name}\""));
    let (_, after) = after.unwrap_or_else(|| panic!("no `{name}` in {element}"));
    let child = after.split("/>").next().unwrap_or("");
    let quoted = child.split('"').skip(1).step_by(2);
    quoted.flat_map(str::split_whitespace).map(|it| it.parse().expect("a number")).collect()
}

pub fn three(numbers: Vec<f64>) -> [f64; 3] {
    numbers.try_into().expect("three numbers")
}

pub fn vector_of(numbers: &[f64]) -> Vector {
    Vector::new(numbers[0], numbers[1], numbers[2])
}

/// The image of `(x, y, z, w)` under a matrix: columns are vectors, as Mitsuba's documentation multiplies.
pub fn image(matrix: &[f64], [x, y, z, w]: [f64; 4]) -> [f64; 3] {
    [0, 4, 8].map(|i| matrix[i] * x + matrix[i + 1] * y + matrix[i + 2] * z + matrix[i + 3] * w)
}
