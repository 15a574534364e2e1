//! The questions of the probe, and the laws of functions of Python.

use ::ask::{Invocation, Reply, Stop, Subject};
use claims::ClaimsOptions;
use conform::probe;
use pyo3::prelude::*;
use serde_json::Value;
use text::told::Told;

use crate::scene::wrong;

/// The probe's answer to a line (docs/probe.md).
#[pyfunction]
pub fn ask(py: Python<'_>, line: &str) -> String {
    py.detach(|| probe::answer(line))
}

/// A function of Python that answers questions: JSON in, JSON out.
struct Answers {
    function: Py<PyAny>,
    /// What it raised, to be raised again.
    raised: Option<PyErr>,
}

impl Subject for Answers {
    fn ask(&mut self, questions: &[Value]) -> Vec<Reply> {
        let reply = |question: &Value| {
            if self.raised.is_some() {
                return Err(Stop::NotAsked);
            }
            let answered = Python::attach(|py| {
                py.check_signals()?;
                self.function.call1(py, (question.to_string(),))?.extract::<String>(py)
            });
            match answered {
                Ok(text) => {
                    serde_json::from_str(&text).map_err(|error| Stop::Refused(error.to_string()))
                }
                Err(error) => {
                    self.raised = Some(error);
                    Err(Stop::NotAsked)
                }
            }
        };
        questions.iter().map(reply).collect()
    }
}

/// Holds what a function answers to the laws of `groundtruth laws`: whether all hold, as text, as a page and as JSON.
#[pyfunction]
pub fn laws(
    py: Python<'_>,
    function: Py<PyAny>,
    cases: usize,
    seed: u64,
) -> PyResult<(bool, String, String, String)> {
    let mut subject = Answers { function, raised: None };
    let card = py.detach(|| {
        let listed = claims::listed(&mut subject)?;
        let options = ClaimsOptions { cases: cases.clamp(1, claims::MOST_CASES), seed };
        Ok(claims::run(&mut subject, &listed, options, &mut |_| {}))
    });
    if let Some(raised) = subject.raised {
        return Err(raised);
    }
    let card = card.map_err(|stop: Stop| wrong(stop.text()))?;
    let next = format!("laws(…, seed={})", seed.wrapping_add(1));
    let told = Told { next, ..claims::told(&card, &Invocation::default()) };
    let page = claims::page(&card, &told, "functions of Python");
    let json = told.json(&card.json()).map_err(wrong)?;
    Ok((card.is_judged() && !card.is_failed(), told.text(), page, json))
}
