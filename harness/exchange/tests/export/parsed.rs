//! A reader of the few words of POV-Ray's language that are written, apart from the writer.

use std::collections::BTreeMap;

use exchange::export::pov;
use groundtruth::scene::Scene;

/// A word, a number or a mark.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    Word(String),
    Number(f64),
    Mark(char),
}

/// A statement: its word, the vectors and numbers that follow in order, its modifiers with theirs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statement {
    /// The vectors and numbers before the first modifier, each number as a vector of one.
    pub values: Vec<Vec<f64>>,
    /// Its modifiers in order, and their values.
    pub words: Vec<(String, Vec<Vec<f64>>)>,
}

impl Statement {
    /// The values of the first modifier of this name.
    pub fn of(&self, word: &str) -> Vec<Vec<f64>> {
        let found = self.words.iter().find(|(name, _)| name == word);
        found.unwrap_or_else(|| panic!("no `{word}` in {self:?}")).1.clone()
    }

    /// The one vector of a modifier.
    pub fn vector(&self, word: &str) -> Vec<f64> {
        self.of(word).first().unwrap_or_else(|| panic!("`{word}` has no vector")).clone()
    }

    /// The one number of a modifier.
    pub fn number(&self, word: &str) -> f64 {
        self.vector(word)[0]
    }

    pub fn has(&self, word: &str) -> bool {
        self.words.iter().any(|(name, _)| name == word)
    }
}

/// What a scene became, by the word of each statement; textures by their names.
#[derive(Debug, Default)]
pub struct Parsed {
    pub statements: Vec<(String, Statement)>,
    pub textures: BTreeMap<String, Statement>,
    pub exposure: f64,
}

impl Parsed {
    /// The statements of this word.
    pub fn all(&self, word: &str) -> Vec<&Statement> {
        self.statements.iter().filter(|(name, _)| name == word).map(|(_, it)| it).collect()
    }

    pub fn one(&self, word: &str) -> &Statement {
        let all = self.all(word);
        assert_eq!(all.len(), 1, "statements `{word}`");
        all[0]
    }
}

/// What a scene becomes.
pub fn said(scene: &Scene) -> Parsed {
    parsed(&pov::write("scene", scene, "".as_ref()).unwrap_or_else(|all| panic!("{all:?}")))
}

fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or(""));
    for line in lines.filter(|line| !line.starts_with("#version")) {
        let mut rest = line.trim_start();
        while let Some(first) = rest.chars().next() {
            let is_number = first.is_ascii_digit() || first == '-';
            let is_in = |c: char| match is_number {
                true => c.is_ascii_digit() || ".e-+".contains(c),
                false => c.is_alphanumeric() || "_#".contains(c),
            };
            let length = rest.find(|c| !is_in(c)).unwrap_or(rest.len()).max(1);
            let (token, after) = rest.split_at(length);
            tokens.push(match token.parse() {
                Ok(number) => Token::Number(number),
                Err(_) if is_in(first) => Token::Word(token.to_owned()),
                Err(_) => Token::Mark(first),
            });
            rest = after.trim_start();
        }
    }
    tokens
}

/// The text without the bodies of functions, which have a reader of their own.
fn without_functions(text: &str) -> String {
    let mut parts = text.split("function {");
    let first = parts.next().unwrap_or("").to_owned();
    parts.fold(first, |so_far, part| so_far + part.split_once('}').expect("its end").1)
}

fn parsed(text: &str) -> Parsed {
    let mut parsed = Parsed::default();
    let tokens = tokens(&without_functions(text));
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            Token::Word(word) if word == "#declare" => {
                let Token::Word(name) = &tokens[at + 1] else { panic!("a name is missing") };
                if let Token::Number(exposure) = tokens[at + 3] {
                    parsed.exposure = exposure;
                    at += 5; // #declare exposure = 1 ;
                } else {
                    let (texture, end) = statement(&tokens, at + 4);
                    parsed.textures.insert(name.clone(), texture);
                    at = end;
                }
            }
            Token::Word(word) => {
                let (statement, end) = statement(&tokens, at + 1);
                parsed.statements.push((word.clone(), statement));
                at = end;
            }
            other => panic!("{other:?} stands where a statement begins"),
        }
    }
    parsed
}

/// The statement whose brace is at this token, with all braces in it flattened; and the index after it.
fn statement(tokens: &[Token], open: usize) -> (Statement, usize) {
    assert_eq!(tokens[open], Token::Mark('{'));
    let (mut statement, mut depth, mut at) = (Statement::default(), 0, open);
    let (mut in_vector, mut factor) = (false, 1.0);
    loop {
        match &tokens[at] {
            Token::Mark('{') => depth += 1,
            Token::Mark('}') => depth -= 1,
            Token::Mark('<') => {
                in_vector = true;
                values(&mut statement).push(Vec::new());
            }
            Token::Mark('>') => in_vector = false,
            Token::Mark(',' | '*' | '[' | ']') => {}
            Token::Mark('/') => factor = std::f64::consts::PI,
            Token::Number(number) if in_vector => {
                values(&mut statement).last_mut().expect("a vector").push(*number);
            }
            Token::Number(number) => values(&mut statement).push(vec![*number]),
            Token::Word(word) if word == "pi" => {
                let last = values(&mut statement).last_mut().expect("a number");
                last[0] /= factor;
            }
            // what each source is multiplied by; the law of exposure counts them
            Token::Word(word) => statement.words.push((word.clone(), Vec::new())),
            other => panic!("{other:?} in a statement"),
        }
        at += 1;
        if depth == 0 {
            return (fold_exposure(statement), at);
        }
    }
}

fn values(statement: &mut Statement) -> &mut Vec<Vec<f64>> {
    match statement.words.last_mut() {
        Some((_, values)) => values,
        None => &mut statement.values,
    }
}

/// `rgb exposure*<…>` and `emission exposure*1` as the word before with the values, and the word `exposed`.
fn fold_exposure(statement: Statement) -> Statement {
    let mut folded = Statement { values: statement.values, words: Vec::new() };
    for (word, values) in statement.words {
        match word.as_str() {
            "exposure" => {
                folded.words.last_mut().expect("a word before it").1 = values;
                folded.words.push(("exposed".to_owned(), Vec::new()));
            }
            _ => folded.words.push((word, values)),
        }
    }
    folded
}
