//! A reader of the few statements of pbrt-v4 that are written, apart from the writer: it keeps the graphics state as pbrt
//! does.

use std::collections::BTreeMap;
use std::path::Path;

use groundtruth::math::Vector;
use groundtruth::scene::Scene;
use harness::export::{Unsayable, pbrt};

/// A 4 × 4 matrix, by its rows, that stands before column vectors.
pub type Matrix = [[f64; 4]; 4];

const IDENTITY: Matrix =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// The parameters of a statement, by their names without types.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parameters {
    numbers: BTreeMap<String, Vec<f64>>,
    words: BTreeMap<String, String>,
}

impl Parameters {
    pub fn all(&self, name: &str) -> &[f64] {
        self.numbers.get(name).unwrap_or_else(|| panic!("no numbers `{name}` in {self:?}"))
    }

    pub fn number(&self, name: &str) -> f64 {
        let [number] = self.all(name)[..] else { panic!("`{name}` is not one number") };
        number
    }

    pub fn number_or(&self, name: &str, default: f64) -> f64 {
        if self.numbers.contains_key(name) { self.number(name) } else { default }
    }

    pub fn vector(&self, name: &str) -> Vector {
        let [x, y, z] = self.all(name)[..] else { panic!("`{name}` is not three numbers") };
        Vector::new(x, y, z)
    }

    pub fn word(&self, name: &str) -> &str {
        self.words.get(name).unwrap_or_else(|| panic!("no word `{name}` in {self:?}"))
    }

    pub fn has(&self, name: &str) -> bool {
        self.numbers.contains_key(name) || self.words.contains_key(name)
    }
}

/// A statement with a kind, as `Camera "perspective"`, and the transformation at it.
#[derive(Clone, Debug, Default)]
pub struct Statement {
    pub kind: String,
    pub parameters: Parameters,
    pub transform: Matrix,
}

/// A shape and the graphics state around it.
#[derive(Clone, Debug)]
pub struct Shape {
    pub shape: Statement,
    pub material: Parameters,
    pub area_light: Option<Parameters>,
    pub is_reversed: bool,
}

/// What a scene became.
#[derive(Debug, Default)]
pub struct Read {
    pub options: BTreeMap<String, String>,
    /// What stands before `WorldBegin`, by its word.
    pub settings: BTreeMap<String, Statement>,
    pub lights: Vec<Statement>,
    pub shapes: Vec<Shape>,
    /// The textures by their names.
    pub textures: BTreeMap<String, Statement>,
}

impl Read {
    pub fn setting(&self, word: &str) -> &Parameters {
        &self.settings[word].parameters
    }
}

/// What a scene becomes.
pub fn read(scene: &Scene) -> Read {
    parsed(&written(scene).unwrap_or_else(|all| panic!("{all:?}")))
}

/// The text of a scene, or why it cannot be said.
pub fn written(scene: &Scene) -> Result<String, Vec<Unsayable>> {
    pbrt::write("scene", scene, Path::new(""))
}

/// A point, moved by a matrix.
pub fn moved(matrix: &Matrix, p: Vector) -> Vector {
    let at = [p.x(), p.y(), p.z(), 1.0];
    let row = |i: usize| (0..4).map(|j| matrix[i][j] * at[j]).sum();
    Vector::new(row(0), row(1), row(2))
}

/// The three columns of a matrix that are images of the axes.
pub fn axes(matrix: &Matrix) -> [Vector; 3] {
    [0, 1, 2].map(|j| Vector::new(matrix[0][j], matrix[1][j], matrix[2][j]))
}

/// The words of a line, quoted ones without their quotes, with what is quoted.
fn tokens(text: &str) -> Vec<(String, bool)> {
    let mut tokens = Vec::new();
    for line in text.lines().map(|line| line.split('#').next().unwrap_or("")) {
        for (index, part) in line.split('"').enumerate() {
            match index % 2 {
                1 => tokens.push((part.to_owned(), true)),
                _ => tokens.extend(part.split_whitespace().map(|word| (word.to_owned(), false))),
            }
        }
    }
    tokens
}

#[derive(Clone, Default)]
struct State {
    transform: Matrix,
    material: Parameters,
    area_light: Option<Parameters>,
    is_reversed: bool,
}

struct Reader {
    tokens: std::iter::Peekable<std::vec::IntoIter<(String, bool)>>,
}

impl Reader {
    fn word(&mut self) -> String {
        self.tokens.next().expect("a word").0
    }

    /// The words between brackets.
    fn bracketed(&mut self) -> Vec<String> {
        assert_eq!(self.word(), "[");
        let mut words = Vec::new();
        loop {
            match self.word() {
                end if end == "]" => return words,
                word => words.push(word),
            }
        }
    }

    fn numbers(&mut self) -> Vec<f64> {
        self.bracketed().iter().map(|word| word.parse().expect("a number")).collect()
    }

    /// `"type name" [ values ]`, as often as they follow.
    fn parameters(&mut self) -> Parameters {
        let mut parameters = Parameters::default();
        while self.tokens.peek().is_some_and(|(_, is_quoted)| *is_quoted) {
            let declared = self.word();
            let (kind, name) = declared.split_once(' ').expect("a type and a name");
            let values = self.bracketed();
            if ["string", "texture", "bool"].contains(&kind) {
                parameters.words.insert(name.to_owned(), values.concat());
            } else {
                let numbers = values.iter().map(|word| word.parse().expect("a number")).collect();
                parameters.numbers.insert(name.to_owned(), numbers);
            }
        }
        parameters
    }
}

pub fn parsed(text: &str) -> Read {
    let mut reader = Reader { tokens: tokens(text).into_iter().peekable() };
    let mut read = Read::default();
    let mut named = BTreeMap::new();
    let mut state = State { transform: IDENTITY, ..State::default() };
    let mut stack = Vec::new();
    let mut is_world = false;
    while reader.tokens.peek().is_some() {
        let word = reader.word();
        match word.as_str() {
            "Option" => {
                let name = reader.word();
                read.options.insert(name, reader.word());
            }
            "WorldBegin" => {
                is_world = true;
                state = State { transform: IDENTITY, ..State::default() };
            }
            "AttributeBegin" => stack.push(state.clone()),
            "AttributeEnd" => state = stack.pop().expect("it was begun"),
            "ReverseOrientation" => state.is_reversed = !state.is_reversed,
            // column by column
            "Transform" => {
                let columns = reader.numbers();
                state.transform =
                    std::array::from_fn(|i| std::array::from_fn(|j| columns[4 * j + i]));
            }
            "MakeNamedMaterial" => {
                let name = reader.word();
                named.insert(name, reader.parameters());
            }
            "NamedMaterial" => state.material = named[&reader.word()].clone(),
            "Material" => {
                assert_eq!(reader.word(), "diffuse");
                state.material = reader.parameters();
            }
            "AreaLightSource" => {
                assert_eq!(reader.word(), "diffuse");
                state.area_light = Some(reader.parameters());
            }
            "Texture" => {
                let (name, kind) = (reader.word(), reader.word());
                assert_eq!(kind, "spectrum");
                let (kind, parameters) = (reader.word(), reader.parameters());
                let texture = Statement { kind, parameters, transform: state.transform };
                assert!(read.textures.insert(name, texture).is_none(), "a name is used once");
            }
            _ => {
                let (kind, parameters) = (reader.word(), reader.parameters());
                let statement = Statement { kind, parameters, transform: state.transform };
                match word.as_str() {
                    "LightSource" => read.lights.push(statement),
                    "Shape" => {
                        let State { material, area_light, is_reversed, .. } = state.clone();
                        read.shapes.push(Shape {
                            shape: statement,
                            material,
                            area_light,
                            is_reversed,
                        });
                    }
                    _ => {
                        assert!(!is_world, "{word} stands before WorldBegin");
                        assert!(
                            read.settings.insert(word.clone(), statement).is_none(),
                            "two of {word}"
                        );
                    }
                }
            }
        }
    }
    read
}
