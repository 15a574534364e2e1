//! How a program was asked, to write the command that asks it again.

use text::shell;

/// The words of a command that asked a program, as far as they matter when it is asked again.
#[derive(Clone, Debug, Default)]
pub struct Invocation<'a> {
    /// What was selected: chapters, names, `--only` and its pattern; nothing is everything.
    pub selection: Vec<String>,
    /// Options that hold for any selection and seed, with their values.
    pub options: Vec<String>,
    /// The number of cases, if it is not the default.
    pub cases: Option<usize>,
    /// Whether the seed was one that nobody had seen.
    pub is_fresh: bool,
    /// The program and its arguments.
    pub program: &'a [String],
}

impl Invocation<'_> {
    /// The program as it is written in a shell.
    pub fn program(&self) -> String {
        shell::line(self.program.iter().map(String::as_str))
    }

    /// The command that asks only this, again with this seed.
    pub fn of_one(&self, command: &str, selected: &str, seed: u64) -> String {
        let seed = ["--seed".to_owned(), seed.to_string()];
        self.line(command, &[selected.to_owned()], self.cases, &seed)
    }

    /// The command that asks the same again.
    pub fn again(&self, command: &str, seed: u64) -> String {
        self.line(command, &self.selection, self.cases, &["--seed".to_owned(), seed.to_string()])
    }

    /// The command that asks the same with a seed that nobody has seen, or, if this was one, with ten times the cases, of
    /// which so many are the default and so many the most.
    pub fn with_fresh_seed(&self, command: &str, default: usize, most: usize) -> String {
        let cases = match self.is_fresh {
            true => Some(self.cases.unwrap_or(default).saturating_mul(10).min(most)),
            false => self.cases,
        };
        self.line(command, &self.selection, cases, &["--fresh".to_owned()])
    }

    fn line(
        &self,
        command: &str,
        selection: &[String],
        cases: Option<usize>,
        seed: &[String],
    ) -> String {
        let cases = cases.map(|cases| ["--cases".to_owned(), cases.to_string()]);
        let cases = cases.iter().flatten();
        let words = selection.iter().chain(&self.options).chain(seed).chain(cases);
        let words = shell::line(words.map(String::as_str));
        format!("groundtruth {command} {words} -- {}", self.program())
    }
}
